<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>Action</name>
    <message>
        <source>Aim at the middle of the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a hazer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the selection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the whole rig</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expose brighter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expose darker</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Automatic exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Baked pictures where they are fresh</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select all fixtures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go: the next cue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back: the cue before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cues follow the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel what runs in the background</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold what the desk asks of the selected fixtures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hang under the nearest truss</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solo: the selected fixtures alone shine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move by 0.1 m to the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move by 0.1 m to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move by 0.1 m up-stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move by 0.1 m down-stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Align %1 with the first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spread evenly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unpatch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a fixture...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep this camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the stage...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a model...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a copy of the show file...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take what the show file says now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take changes that were not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop changes that were not saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the show over from another window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Record what the desk sends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play what was recorded last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play a recording...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play the show&apos;s own recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play or pause the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Freeze: time stands still</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back to the start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A desk as soon as one is heard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What a desk sends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording of the show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 pictures a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As fine as the rate allows, full when at rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 % of the pixels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release selected fixtures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release everything set by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About Ghostlight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;h3&gt;Ghostlight </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;/p&gt;&lt;p&gt;Qt </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New show...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import a plot...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Documentation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The next tone curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tone curve: AgX, like film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tone curve: ACES, more contrast</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tone curve: none, clipped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select all of this type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wipe between what is seen now and what comes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>False colours: lux on surfaces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>False colours: cd/m²</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Probe: cd/m² and lux under the mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Substitute fixture files</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save what the plot has as text...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What this plot has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In browsers...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strip of the cameras&apos; pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a show...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the received plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the picture...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a picture of the window...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find a fixture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full screen, the picture alone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture on a second display</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture in a second window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Black-out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Work light: see the stage where nothing shines</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where levels come from, exposure, what hands hold</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame time and latency</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Names of fixtures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Addresses of fixtures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where fixtures point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frame of the camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Marks of the selection</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Air</name>
    <message>
        <source>Place m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X Y Z of the nozzle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blows to</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>X Y Z; any length: 0 0 1 is up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Density 1 m before the nozzle, as a multiple of the room&apos;s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spread°</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Full angle of the plume</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reach m</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From here on it is as thin as the room</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The air as the show has it: saved with it. Smoke by hand is in Scene.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Haze</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clouds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0: the same everywhere; 1: from nothing to twice as thick</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cloud size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clouds drift with it, along the floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wind towards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>0: to the right as the house sees it, 90: up-stage, -90: into the house</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hazers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a hazer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On the floor below what is looked at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the hazer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 per metre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 per metre</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Bounced light</name>
    <message>
        <source>%1:%2 min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no light bounces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>links are being made, %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>its links were cancelled: no light bounces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it cannot be made, Messages say why: no light bounces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>solved in %1 beside the picture, drawn in %2 of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>is being solved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, by --bounce of the command line: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bounced light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light that surfaces and haze send on. The finer, the longer its links take to make, once for a stage, and each change of light to solve.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Links of bounced light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Browsers</name>
    <message>
        <source>The address as a QR code</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Phones, tablets and laptops see the picture as it is drawn, and why a lamp is dark.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Network in which browsers may look on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>port </source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>TCP port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address with its secret</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The address, to be sent to whom you let in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Allow control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>An address of its own: who has it recalls looks, cues and cameras. A recalled look can be undone here. Off: whoever has it only looks on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the address with control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plain HTTP: who listens to that network sees picture and secret.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New token</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who looks on stays; nobody else comes in with the address that was</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Send all away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All lines end, and no address that was lets anybody in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let browsers look on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>With control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To look on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Or &lt;b&gt;%1&lt;/b&gt; and the digits &lt;b&gt;%2 %3&lt;/b&gt;, for %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nobody looks on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2, %3 pictures a second, may control</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2, %3 pictures a second</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>By hand</name>
    <message numerus="yes">
        <source>%n fixture(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n object(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n material(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>solo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>%n mover(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Chips</name>
    <message>
        <source>LIVE DESK</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>REC %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>NO DESK YET</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>BLACK-OUT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>FROZEN</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RECORDING %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>WORK LIGHT</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MASTER %1 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>by hand: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>bounced light: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Colour</name>
    <message>
        <source>White</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warm white</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Red</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amber</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Green</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cyan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lavender</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magenta</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hue and saturation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hue across, saturation down; arrow keys move it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lee&apos;s conversions before a lamp of 3200 K; its colours as they look on a screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gel ...</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Cues</name>
    <message>
        <source>Cues</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fade s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Flight s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double click or F2: change what stands there. Fade: empty is that of the look. Follow: the next cue goes by itself that long after this one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The next cue (Ctrl+G)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cue before (Ctrl+Shift+G)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to this</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen cue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A cue of the look that was recalled or stored last, or of this moment of the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Can be undone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Earlier in the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Later in the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Follow the recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A cue with a second is called when the recording, or its time code, comes by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No cues yet. Store looks, recall one and add it here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This was the last cue.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Next: %1, in %2 s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message>
        <source>This machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A farm (Slurm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A farm cuts it into tasks for many machines, which must see the show under the same path. Its partition: SBATCH_PARTITION in the environment. Cancel stops following it only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The final picture of a fixed camera, lit live. What is finished stays if it is cancelled.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera to bake</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples per pixel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bounces of indirect light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who bakes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bounces</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the window sees it: drawn live. A camera of the show: from its passes.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera of pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of pictures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Begin of the film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End of the film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Still...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Film...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contact sheet...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All looks from all cameras; without looks, the cues</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a still</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a contact sheet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Film</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Who draws films</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> a second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All cameras</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the window sees it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Fan</name>
    <message>
        <source>First to last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From the centre</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As listed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left to right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Middle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ends by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All as first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All get the value of the first one that was selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All as last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All get the value of the last one that was selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Between them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evenly from what the first has to what the last has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fan and align</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spreads a value over the selected heads, or gives them that of one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is spread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How it is spread</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Order of the heads</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Figures</name>
    <message>
        <source>at rest, drawn in %1 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms a frame, %2 pictures/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ms a frame</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 while it moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tone curve %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>packet to window %1 ms (half within %2, 99 % within %3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the window itself %1 ms a picture (99 % within %2)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Files</name>
    <message>
        <source>Models (*.glb *.gltf *.obj *.3ds);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a fixture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fixtures (*.gdtf *.qxf *.json);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A model becomes the stage of the show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A model that stands on the stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a copy of the show file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show files (*.toml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play a recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recordings (*.ghostdmx *.show *.pcap *.pcapng);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A new show: its folder</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Folders (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A plot becomes a show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plots (*.mvr)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the show under another name beside it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (*.png *.exr)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Films (*.mp4)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the plot has, as text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows (show.toml *.mvr);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a picture of the window</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Fixtures</name>
    <message>
        <source>Type: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Layer: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Under: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>file cannot be read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another fixture reads a channel of this one.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Set by hand; R releases it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Patch</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In names, addresses, types and modes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search fixtures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Group of fixtures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>One type, layer or truss alone; Enter in the search selects what is listed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only fixtures that do not shine, by reasons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fixtures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All fixtures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Asking why ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All %1 that are dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 selected</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Jobs</name>
    <message>
        <source>, %1 left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 on the farm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bake all cameras</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bake %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Film %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Still %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Contact sheet %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>import %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>runs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>done</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopping</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>begins</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Keys</name>
    <message>
        <source>drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>around what is looked at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>right drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>look around</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>middle drag, Shift+drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sideways</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>nearer, farther</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>W A S D, arrows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fly; Q, E or page keys: down, up; Shift: faster</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>click, Ctrl+click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select a fixture, one more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ctrl+drag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>select all in a box</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>double click</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>go to a fixture; choose a set piece, which its cross moves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In the picture</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Looks</name>
    <message>
        <source>Looks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double click or Enter: recall. F2: another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fades to it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Store what hands set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As a new look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Store what is seen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the selected fixtures, or of all: whoever asked for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Puts what hands set in its place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Can be undone</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s fade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seconds of the crossfade</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The selected fixtures alone shine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A filter in front of the selected fixtures, on top of all else</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another lamp: how many times as much light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its white</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add as a cue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update with what hands set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What if: select fixtures to try another gel or lamp</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Menu</name>
    <message>
        <source>Show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Play</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quality</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Language</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>What</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Where</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What to do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double click or Enter: the fixtures that it is about, else the file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2 times)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing is wrong with this show.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Movers</name>
    <message>
        <source>Movers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of its way from %1 to %2%3; as the machine, within its speed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Network</name>
    <message>
        <source>Nothing of universe %1 has come</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing has come from the network yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sources</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Universe</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Priority</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>From</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Patched</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>sACN %1, Art-Net %2 packets</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 not understood</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 lost on the way</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 lost in this machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>, %1 of a desk in preview (blind)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>; packet to picture %1 ms (median), %2 (99 %), %3 at most</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>yes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Universe %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Notice</name>
    <message>
        <source>Looks stay as the file has them until this is mended: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looks were changed by another program, which is not undone: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remote control: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another window has this show open: %1. Here it is read only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was not saved here is kept in %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is not saved here can be saved as a copy.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another window took this show over: %1. Here it is read only.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes of %1 were not saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The show file was changed since; taking them drops what was changed there.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Changes that are not saved cannot be kept: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program changed the show file, and there are changes here that are not saved.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Another program changed the show file, and it cannot be taken: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The show file is gone: deleted, renamed, or its disk was taken out. What is open here stays as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The show folder is gone: deleted, renamed, or its disk was taken out. What is open here stays as it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The show is not saved: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The displays changed: what was out of sight is here now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take what the file says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save mine over it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save it there again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save a copy elsewhere...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take it over</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Try again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close and lose them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What this plot has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What was open stays open.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not opened: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Since this edit: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Since this edit: %1 (and %2 more)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ghostlight, the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture is on %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a window of its own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, which is unplugged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The display %1 is gone; the picture comes back with it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press ? for all keys. A desk that sends sACN or Art-Net takes over by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press ? for all keys.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 sent a plot (%2): Show, Take the received plot, Ctrl+T</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The picture is saved</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recorded %1 s to %2: Play, Play what was recorded last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By hand now: %1. R gives back what is selected, Shift+R all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Listening for a desk: nothing has come yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No input: started with --no-desk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No recording: the show has none; a desk is not taken (Play menu)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No recording; a desk that sends sACN or Art-Net takes over by itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No recording, and no desk: started with --no-desk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording, %1 of %2 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RECORDING, %1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not closed, for changes are not saved and cannot be kept: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Palettes</name>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gobo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All heads: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Palettes: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Store palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What hands set of it for the selected fixtures, as a new palette of the show</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Palettes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click gives it to the selected fixtures. F2: another name.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give it to the selected fixtures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Update with what hands set</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Panel</name>
    <message>
        <source>Transport</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fixtures</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Programmer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Scene</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Network</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Looks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Air</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cues</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In browsers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Parameter</name>
    <message>
        <source>Shutter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Beam</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gobo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blades</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Laser</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Machine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gobo wheel \1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gobo \1 turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Prism \1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Prism \1 turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour wheel \1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cyan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Magenta</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Red</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Green</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Blue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>White</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warm white</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cold white</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Amber</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Lime</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>CTO</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>White (CCT)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Frost \1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Focus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Animation wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>pan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tilt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>zoom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gobo %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Picture</name>
    <message>
        <source>%1 up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 down</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 along %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A click goes there. The pictures are made while nothing moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 lx, of which %2 bounced</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 m away</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no surface</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Picture of the stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No show is open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>now</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Plot</name>
    <message>
        <source>Take what seems the same</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select these</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save as text...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the plot has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double click or Enter: the fixtures that it is about are selected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For each file the one whose name says that it is the same fixture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The fixtures that the chosen line is about, ringed in the picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All of it as text, for a mail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stands in for %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, mode &apos;%2&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose a file...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take it for %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A fixture that stands in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>To do: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What a plot has is listed here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 missing, %3 guessed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 with a light that is assumed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 without light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 without light, %2 with one that is assumed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Guessed or repaired</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Odd, but nothing is lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take what seems the same (%1)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Programmer</name>
    <message>
        <source>Intensity</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Pan</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Gobo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold (H)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the desk asks of the selected fixtures stays, whatever it sends then</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give all back (R)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the desk says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Select fixtures to light the scene by hand, with or without a desk.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Scene</name>
    <message>
        <source>Smoke</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Even light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the even light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Constant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Linear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Quadratic</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Light falls with 1 / (constant + linear d + quadratic d²); 0, 0, 1 is physics.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the haze, along a ray through one beam. Fewer are faster.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Haze, wind and hazers of the show...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hang the selected fixtures under it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Evenly along the truss or pipe that is chosen, with all its pieces; one alone where it is nearest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Specular</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shininess</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Search objects and materials</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Objects of the stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Material</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Sentence</name>
    <message>
        <source>no show is open</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Transport</name>
    <message>
        <source>Input</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Desk, else recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Desk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Master</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Master: all light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Black-out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>desk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The recording: how much changes when, and where it is played</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click: go there. Shift+drag: play this part again and again, Shift+click: the whole.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Undo</name>
    <message>
        <source>Haze</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clouds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Size of the clouds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wind</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hazer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a hazer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove a hazer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Bounced light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add cue &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move cue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove cue</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>fan %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>align %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hang under &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>solo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>end of solo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Store palette &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>palette %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename palette</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove palette &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mode</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distribute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep camera &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a model</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>release everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>even light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>show object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>hide object</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>release %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>drive %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>release samples</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>looks from the file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>store look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>look %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>rename look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>seconds of a look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>remove look</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reload</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take changes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>gel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>lamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>white of the lamp</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colour of the even light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>release the colour of the even light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>release attenuation</source>
        <translation type="unfinished"></translation>
    </message>
    <message numerus="yes">
        <source>show %n object(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>hide %n object(s)</source>
        <translation type="unfinished">
            <numerusform></numerusform>
            <numerusform></numerusform>
        </translation>
    </message>
    <message>
        <source>Substitute &apos;%1&apos;</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Value</name>
    <message>
        <source> deg</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unfolds the colours</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give it back to the show and the desk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give back %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mixed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: what it can be</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Values</name>
    <message>
        <source>open</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>slot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>colour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Attribute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Means</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>By hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Channels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No fixture is selected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Click a lamp in the picture or a row of the list.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is being looked at ...</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>View bar</name>
    <message>
        <source>Camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The cameras of the show: 1 to 9; Ctrl+K keeps this one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>free camera</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exposure: + and - by half a stop; a smaller number is brighter</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Auto</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tone curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tone curve (T)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Strip</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Work light</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Welcome</name>
    <message>
        <source>Opened last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open a show...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A folder with show.toml</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ten moving heads, with a recording</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import a plot...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>MVR of Vectorworks, Capture, grandMA3 ...</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shows that were opened last</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drop a show, an .mvr or a model anywhere here. A desk that sends sACN or Art-Net is heard as soon as a show is open.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>Window</name>
    <message>
        <source>nothing yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>See your light show before the truck is unloaded.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawn on: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Apache License 2.0. VARI*LITE and VL2500 are marks of their owners, who have no part in this.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
