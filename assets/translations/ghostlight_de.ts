<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de">
<context>
    <name>Action</name>
    <message>
        <source>Aim at the middle of the picture</source>
        <translation>Auf die Bildmitte richten</translation>
    </message>
    <message>
        <source>Add a hazer</source>
        <translation>Hazer hinzufügen</translation>
    </message>
    <message>
        <source>Camera %1</source>
        <translation>Kamera %1</translation>
    </message>
    <message>
        <source>Look at the selection</source>
        <translation>Auswahl ansehen</translation>
    </message>
    <message>
        <source>Look at the whole rig</source>
        <translation>Ganzes Rig ansehen</translation>
    </message>
    <message>
        <source>Expose brighter</source>
        <translation>Heller belichten</translation>
    </message>
    <message>
        <source>Expose darker</source>
        <translation>Dunkler belichten</translation>
    </message>
    <message>
        <source>Automatic exposure</source>
        <translation>Automatische Belichtung</translation>
    </message>
    <message>
        <source>Baked pictures where they are fresh</source>
        <translation>Vorberechnete Bilder, wo sie aktuell sind</translation>
    </message>
    <message>
        <source>Select all fixtures</source>
        <translation>Alle Geräte auswählen</translation>
    </message>
    <message>
        <source>Select nothing</source>
        <translation>Nichts auswählen</translation>
    </message>
    <message>
        <source>Go: the next cue</source>
        <translation>Go: der nächste Cue</translation>
    </message>
    <message>
        <source>Back: the cue before</source>
        <translation>Zurück: der vorige Cue</translation>
    </message>
    <message>
        <source>Cues follow the recording</source>
        <translation>Cues folgen der Aufzeichnung</translation>
    </message>
    <message>
        <source>Cancel what runs in the background</source>
        <translation>Aufgaben im Hintergrund abbrechen</translation>
    </message>
    <message>
        <source>Hold what the desk asks of the selected fixtures</source>
        <translation>Halten, was das Pult von den ausgewählten Geräten verlangt</translation>
    </message>
    <message>
        <source>Hang under the nearest truss</source>
        <translation>Unter die nächste Traverse hängen</translation>
    </message>
    <message>
        <source>Next look</source>
        <translation>Nächster Look</translation>
    </message>
    <message>
        <source>Look before</source>
        <translation>Voriger Look</translation>
    </message>
    <message>
        <source>Solo: the selected fixtures alone shine</source>
        <translation>Solo: nur die ausgewählten Geräte leuchten</translation>
    </message>
    <message>
        <source>Move by 0.1 m to the left</source>
        <translation>Um 0.1 m nach links</translation>
    </message>
    <message>
        <source>Move by 0.1 m to the right</source>
        <translation>Um 0.1 m nach rechts</translation>
    </message>
    <message>
        <source>Move by 0.1 m up-stage</source>
        <translation>Um 0.1 m nach hinten</translation>
    </message>
    <message>
        <source>Move by 0.1 m down-stage</source>
        <translation>Um 0.1 m nach vorn</translation>
    </message>
    <message>
        <source>Align %1 with the first</source>
        <translation>%1 am ersten ausrichten</translation>
    </message>
    <message>
        <source>Spread evenly</source>
        <translation>Gleichmäßig verteilen</translation>
    </message>
    <message>
        <source>Duplicate</source>
        <translation>Duplizieren</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Unpatch</source>
        <translation>Patch aufheben</translation>
    </message>
    <message>
        <source>Add a fixture...</source>
        <translation>Gerät hinzufügen ...</translation>
    </message>
    <message>
        <source>Keep this camera</source>
        <translation>Diese Kamera behalten</translation>
    </message>
    <message>
        <source>Choose the stage...</source>
        <translation>Bühne wählen ...</translation>
    </message>
    <message>
        <source>Add a model...</source>
        <translation>Modell hinzufügen ...</translation>
    </message>
    <message>
        <source>Save the show</source>
        <translation>Show sichern</translation>
    </message>
    <message>
        <source>Save a copy of the show file...</source>
        <translation>Kopie der Showdatei sichern ...</translation>
    </message>
    <message>
        <source>Take what the show file says now</source>
        <translation>Stand der Showdatei übernehmen</translation>
    </message>
    <message>
        <source>Take changes that were not saved</source>
        <translation>Nicht gesicherte Änderungen übernehmen</translation>
    </message>
    <message>
        <source>Drop changes that were not saved</source>
        <translation>Nicht gesicherte Änderungen verwerfen</translation>
    </message>
    <message>
        <source>Take the show over from another window</source>
        <translation>Show von einem anderen Fenster übernehmen</translation>
    </message>
    <message>
        <source>Record what the desk sends</source>
        <translation>Aufzeichnen, was das Pult sendet</translation>
    </message>
    <message>
        <source>Play what was recorded last</source>
        <translation>Letzte Aufzeichnung abspielen</translation>
    </message>
    <message>
        <source>Play a recording...</source>
        <translation>Aufzeichnung abspielen ...</translation>
    </message>
    <message>
        <source>Play the show&apos;s own recording</source>
        <translation>Aufzeichnung der Show abspielen</translation>
    </message>
    <message>
        <source>Play or pause the recording</source>
        <translation>Aufzeichnung abspielen oder anhalten</translation>
    </message>
    <message>
        <source>Freeze: time stands still</source>
        <translation>Einfrieren: Die Zeit steht still</translation>
    </message>
    <message>
        <source>Back to the start</source>
        <translation>Zurück zum Anfang</translation>
    </message>
    <message>
        <source>A desk as soon as one is heard</source>
        <translation>Ein Pult, sobald eines zu hören ist</translation>
    </message>
    <message>
        <source>What a desk sends</source>
        <translation>Was ein Pult sendet</translation>
    </message>
    <message>
        <source>The recording of the show</source>
        <translation>Die Aufzeichnung der Show</translation>
    </message>
    <message>
        <source>%1 pictures a second</source>
        <translation>%1 Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>As fine as the rate allows, full when at rest</source>
        <translation>So fein, wie die Bildrate erlaubt; in Ruhe voll</translation>
    </message>
    <message>
        <source>%1 % of the pixels</source>
        <translation>%1 % der Pixel</translation>
    </message>
    <message>
        <source>Give the selected fixtures back</source>
        <translation>Ausgewählte Geräte freigeben</translation>
    </message>
    <message>
        <source>Give back everything set by hand</source>
        <translation>Alles von Hand Gesetzte freigeben</translation>
    </message>
    <message>
        <source>About Ghostlight</source>
        <translation>Über Ghostlight</translation>
    </message>
    <message>
        <source>New show...</source>
        <translation>Neue Show ...</translation>
    </message>
    <message>
        <source>Import a plot...</source>
        <translation>Plan importieren ...</translation>
    </message>
    <message>
        <source>Save as...</source>
        <translation>Sichern unter ...</translation>
    </message>
    <message>
        <source>Documentation</source>
        <translation>Dokumentation</translation>
    </message>
    <message>
        <source>The next tone curve</source>
        <translation>Nächste Tonwertkurve</translation>
    </message>
    <message>
        <source>Tone curve: AgX, like film</source>
        <translation>Tonwertkurve: AgX, wie Film</translation>
    </message>
    <message>
        <source>Tone curve: ACES, more contrast</source>
        <translation>Tonwertkurve: ACES, mehr Kontrast</translation>
    </message>
    <message>
        <source>Tone curve: none, clipped</source>
        <translation>Tonwertkurve: keine, abgeschnitten</translation>
    </message>
    <message>
        <source>Select all of this type</source>
        <translation>Alle dieses Typs auswählen</translation>
    </message>
    <message>
        <source>Wipe between what is seen now and what comes</source>
        <translation>Wischblende zwischen jetzt und dem, was kommt</translation>
    </message>
    <message>
        <source>False colours: lux on surfaces</source>
        <translation>Falschfarben: Lux auf Flächen</translation>
    </message>
    <message>
        <source>False colours: cd/m²</source>
        <translation>Falschfarben: cd/m²</translation>
    </message>
    <message>
        <source>Probe: cd/m² and lux under the mouse</source>
        <translation>Sonde: cd/m² und Lux unter der Maus</translation>
    </message>
    <message>
        <source>Substitute fixture files</source>
        <translation>Gerätedateien ersetzen</translation>
    </message>
    <message>
        <source>Save what the plot has as text...</source>
        <translation>Planbericht als Text sichern ...</translation>
    </message>
    <message>
        <source>What this plot has</source>
        <translation>Was dieser Plan enthält</translation>
    </message>
    <message>
        <source>In browsers...</source>
        <translation>In Browsern ...</translation>
    </message>
    <message>
        <source>Strip of the cameras&apos; pictures</source>
        <translation>Streifen der Kamerabilder</translation>
    </message>
    <message>
        <source>Open a show...</source>
        <translation>Show öffnen ...</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>Demo öffnen</translation>
    </message>
    <message>
        <source>Take the received plot</source>
        <translation>Empfangenen Plan übernehmen</translation>
    </message>
    <message>
        <source>Save the picture...</source>
        <translation>Bild sichern ...</translation>
    </message>
    <message>
        <source>Save a picture of the window...</source>
        <translation>Bild des Fensters sichern ...</translation>
    </message>
    <message>
        <source>Quit</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Find a fixture</source>
        <translation>Gerät suchen</translation>
    </message>
    <message>
        <source>Keys</source>
        <translation>Tasten</translation>
    </message>
    <message>
        <source>Full screen, the picture alone</source>
        <translation>Vollbild, nur das Bild</translation>
    </message>
    <message>
        <source>The picture on a second display</source>
        <translation>Das Bild auf einem zweiten Bildschirm</translation>
    </message>
    <message>
        <source>The picture in a second window</source>
        <translation>Das Bild in einem zweiten Fenster</translation>
    </message>
    <message>
        <source>Black-out</source>
        <translation>Blackout</translation>
    </message>
    <message>
        <source>Work light: see the stage where nothing shines</source>
        <translation>Arbeitslicht: Bühne sehen, wo nichts leuchtet</translation>
    </message>
    <message>
        <source>Where levels come from, exposure, what hands hold</source>
        <translation>Quelle der Werte, Belichtung, von Hand Gesetztes</translation>
    </message>
    <message>
        <source>Frame time and latency</source>
        <translation>Bildzeit und Latenz</translation>
    </message>
    <message>
        <source>Names of fixtures</source>
        <translation>Namen der Geräte</translation>
    </message>
    <message>
        <source>Addresses of fixtures</source>
        <translation>Adressen der Geräte</translation>
    </message>
    <message>
        <source>Where fixtures point</source>
        <translation>Wohin Geräte zeigen</translation>
    </message>
    <message>
        <source>Frame of the camera</source>
        <translation>Bildausschnitt der Kamera</translation>
    </message>
    <message>
        <source>Marks of the selection</source>
        <translation>Markierungen der Auswahl</translation>
    </message>
    <message>
        <source>The desktop&apos;s language</source>
        <translation>Sprache des Systems</translation>
    </message>
    <message>
        <source>Fly the chosen truss on two hoists</source>
        <translation>Gewählte Traverse an zwei Züge hängen</translation>
    </message>
    <message>
        <source>Drive its mover on: 0.1 m up, 5 degrees</source>
        <translation>Bewegtes Teil weiterfahren: 0.1 m hoch, 5 Grad</translation>
    </message>
    <message>
        <source>Drive its mover back: 0.1 m down, 5 degrees</source>
        <translation>Bewegtes Teil zurückfahren: 0.1 m runter, 5 Grad</translation>
    </message>
    <message>
        <source>Heads and movers go as machines do</source>
        <translation>Geräte und bewegte Teile fahren so träge wie Maschinen</translation>
    </message>
    <message>
        <source>Paperwork...</source>
        <translation>Unterlagen ...</translation>
    </message>
    <message>
        <source>Cue book...</source>
        <translation>Cue-Buch ...</translation>
    </message>
    <message>
        <source>Movers: their ways, end stops and where they go</source>
        <translation>Bewegte Teile: Wege, Endanschläge und wohin sie fahren</translation>
    </message>
    <message>
        <source>Aim here</source>
        <translation>Hierhin ausrichten</translation>
    </message>
    <message>
        <source>Explain why it shines or not</source>
        <translation>Erklären, warum es leuchtet oder nicht</translation>
    </message>
    <message>
        <source>Hide what is here</source>
        <translation>Ausblenden, was hier ist</translation>
    </message>
    <message>
        <source>Put torn-off panels back</source>
        <translation>Abgelöste Fenster zurücksetzen</translation>
    </message>
    <message>
        <source>Name this camera</source>
        <translation>Diese Kamera benennen</translation>
    </message>
    <message>
        <source>Remove this camera</source>
        <translation>Diese Kamera entfernen</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Wiederholen: %1</translation>
    </message>
</context>
<context>
    <name>Air</name>
    <message>
        <source>Place m</source>
        <translation>Ort m</translation>
    </message>
    <message>
        <source>X Y Z of the nozzle</source>
        <translation>X Y Z der Düse</translation>
    </message>
    <message>
        <source>Blows to</source>
        <translation>Bläst nach</translation>
    </message>
    <message>
        <source>X Y Z; any length: 0 0 1 is up</source>
        <translation>X Y Z; beliebige Länge: 0 0 1 ist oben</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Density 1 m before the nozzle, as a multiple of the room&apos;s</source>
        <translation>Dichte 1 m vor der Düse, als Vielfaches der des Raums</translation>
    </message>
    <message>
        <source>Spread°</source>
        <translation>Winkel°</translation>
    </message>
    <message>
        <source>Full angle of the plume</source>
        <translation>Voller Winkel der Fahne</translation>
    </message>
    <message>
        <source>Reach m</source>
        <translation>Weite m</translation>
    </message>
    <message>
        <source>From here on it is as thin as the room</source>
        <translation>Von hier an so dünn wie der Raum</translation>
    </message>
    <message>
        <source>The air as the show has it: saved with it. Smoke by hand is in Scene.</source>
        <translation>Die Luft der Show: wird mit ihr gesichert. Nebel von Hand steht unter Szene.</translation>
    </message>
    <message>
        <source>Haze</source>
        <translation>Dunst</translation>
    </message>
    <message>
        <source>Clouds</source>
        <translation>Schwaden</translation>
    </message>
    <message>
        <source>0: the same everywhere; 1: from nothing to twice as thick</source>
        <translation>0: überall gleich; 1: von nichts bis doppelt so dicht</translation>
    </message>
    <message>
        <source>Cloud size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Wind</translation>
    </message>
    <message>
        <source>Clouds drift with it, along the floor</source>
        <translation>Schwaden ziehen mit ihm über den Boden</translation>
    </message>
    <message>
        <source>Wind towards</source>
        <translation>Wind nach</translation>
    </message>
    <message>
        <source>0: to the right as the house sees it, 90: up-stage, -90: into the house</source>
        <translation>0: nach rechts vom Saal aus, 90: nach hinten, -90: in den Saal</translation>
    </message>
    <message>
        <source>Hazers</source>
        <translation>Hazer</translation>
    </message>
    <message>
        <source>Add a hazer</source>
        <translation>Hazer hinzufügen</translation>
    </message>
    <message>
        <source>On the floor below what is looked at</source>
        <translation>Auf dem Boden unter dem, was man ansieht</translation>
    </message>
    <message>
        <source>Remove the hazer</source>
        <translation>Hazer entfernen</translation>
    </message>
    <message>
        <source>%1, %2 per metre</source>
        <translation>%1, %2 je Meter</translation>
    </message>
    <message>
        <source>%1 per metre</source>
        <translation>%1 je Meter</translation>
    </message>
</context>
<context>
    <name>Bounced light</name>
    <message>
        <source>%1:%2 min</source>
        <translation>%1:%2 min</translation>
    </message>
    <message>
        <source>no light bounces</source>
        <translation>kein indirektes Licht</translation>
    </message>
    <message>
        <source>links are being made, %1 %</source>
        <translation>Verbindungen entstehen, %1 %</translation>
    </message>
    <message>
        <source>its links were cancelled: no light bounces</source>
        <translation>Verbindungen abgebrochen: kein indirektes Licht</translation>
    </message>
    <message>
        <source>it cannot be made, Messages say why: no light bounces</source>
        <translation>nicht möglich, unter Meldungen steht, warum: kein indirektes Licht</translation>
    </message>
    <message>
        <source>solved in %1 beside the picture, drawn in %2 of it</source>
        <translation>gelöst in %1 neben dem Bild, gezeichnet in %2 davon</translation>
    </message>
    <message>
        <source>is being solved</source>
        <translation>wird gelöst</translation>
    </message>
    <message>
        <source>%1, by --bounce of the command line: %2</source>
        <translation>%1, durch --bounce der Kommandozeile: %2</translation>
    </message>
    <message>
        <source>Bounced light</source>
        <translation>Indirektlicht</translation>
    </message>
    <message>
        <source>Light that surfaces and haze send on. The finer, the longer its links take to make, once for a stage, and each change of light to solve.</source>
        <translation>Licht, das Flächen und Dunst weitergeben. Je feiner, desto länger dauern seine Verbindungen, einmal für eine Bühne, und das Lösen jeder Lichtänderung.</translation>
    </message>
    <message>
        <source>Links of bounced light</source>
        <translation>Verbindungen des indirekten Lichts</translation>
    </message>
    <message>
        <source>Make them</source>
        <translation>Herstellen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
</context>
<context>
    <name>Browsers</name>
    <message>
        <source>The address as a QR code</source>
        <translation>Die Adresse als QR-Code</translation>
    </message>
    <message>
        <source>Phones, tablets and laptops see the picture as it is drawn, and why a lamp is dark.</source>
        <translation>Telefone, Tablets und Laptops sehen das Bild, wie es entsteht, und warum ein Gerät dunkel ist.</translation>
    </message>
    <message>
        <source>Network in which browsers may look on</source>
        <translation>Netzwerk, in dem Browser zusehen dürfen</translation>
    </message>
    <message>
        <source>port </source>
        <translation>Port </translation>
    </message>
    <message>
        <source>TCP port</source>
        <translation>TCP-Port</translation>
    </message>
    <message>
        <source>Address with its secret</source>
        <translation>Adresse mit ihrem Geheimnis</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>The address, to be sent to whom you let in</source>
        <translation>Die Adresse, zum Senden an alle, die zusehen dürfen</translation>
    </message>
    <message>
        <source>Allow control</source>
        <translation>Bedienung erlauben</translation>
    </message>
    <message>
        <source>An address of its own: who has it recalls looks, cues and cameras. A recalled look can be undone here. Off: whoever has it only looks on.</source>
        <translation>Eine eigene Adresse: Wer sie hat, ruft Looks, Cues und Kameras ab. Ein abgerufener Look ist hier widerrufbar. Aus: Wer sie hat, sieht nur zu.</translation>
    </message>
    <message>
        <source>Show the address with control</source>
        <translation>Adresse mit Bedienung anzeigen</translation>
    </message>
    <message>
        <source>Plain HTTP: who listens to that network sees picture and secret.</source>
        <translation>Einfaches HTTP: Wer in diesem Netzwerk mithört, sieht Bild und Geheimnis.</translation>
    </message>
    <message>
        <source>New token</source>
        <translation>Neues Token</translation>
    </message>
    <message>
        <source>Who looks on stays; nobody else comes in with the address that was</source>
        <translation>Wer zusieht, bleibt; mit der bisherigen Adresse kommt niemand mehr hinein</translation>
    </message>
    <message>
        <source>Send all away</source>
        <translation>Alle trennen</translation>
    </message>
    <message>
        <source>All lines end, and no address that was lets anybody in</source>
        <translation>Alle Verbindungen enden, und keine bisherige Adresse lässt jemanden hinein</translation>
    </message>
    <message>
        <source>End it</source>
        <translation>Beenden</translation>
    </message>
    <message>
        <source>Let browsers look on</source>
        <translation>Browser zusehen lassen</translation>
    </message>
    <message>
        <source>With control</source>
        <translation>Mit Bedienung</translation>
    </message>
    <message>
        <source>To look on</source>
        <translation>Zum Zusehen</translation>
    </message>
    <message>
        <source>Or &lt;b&gt;%1&lt;/b&gt; and the digits &lt;b&gt;%2 %3&lt;/b&gt;, for %4</source>
        <translation>Oder &lt;b&gt;%1&lt;/b&gt; und die Ziffern &lt;b&gt;%2 %3&lt;/b&gt;, noch %4</translation>
    </message>
    <message>
        <source>Nobody looks on.</source>
        <translation>Niemand sieht zu.</translation>
    </message>
    <message>
        <source>%1, %2, %3 pictures a second, may control</source>
        <translation>%1, %2, %3 Bilder pro Sekunde, darf bedienen</translation>
    </message>
    <message>
        <source>%1, %2, %3 pictures a second</source>
        <translation>%1, %2, %3 Bilder pro Sekunde</translation>
    </message>
    <message numerus="yes">
        <source>%n look(s) on:</source>
        <translation>
            <numerusform>Eine Person sieht zu:</numerusform>
            <numerusform>%n Personen sehen zu:</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>By hand</name>
    <message numerus="yes">
        <source>%n fixture(s)</source>
        <translation>
            <numerusform>%n Gerät</numerusform>
            <numerusform>%n Geräte</numerusform>
        </translation>
    </message>
    <message>
        <source>scene</source>
        <translation>Szene</translation>
    </message>
    <message numerus="yes">
        <source>%n object(s)</source>
        <translation>
            <numerusform>%n Objekt</numerusform>
            <numerusform>%n Objekte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n material(s)</source>
        <translation>
            <numerusform>%n Material</numerusform>
            <numerusform>%n Materialien</numerusform>
        </translation>
    </message>
    <message>
        <source>solo</source>
        <translation>Solo</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>Abtastungen</translation>
    </message>
    <message numerus="yes">
        <source>%n mover(s)</source>
        <translation>
            <numerusform>%n bewegtes Teil</numerusform>
            <numerusform>%n bewegte Teile</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Chips</name>
    <message>
        <source>LIVE DESK</source>
        <translation>PULT LIVE</translation>
    </message>
    <message>
        <source>REC %1</source>
        <translation>AUFZ. %1</translation>
    </message>
    <message>
        <source>NO DESK YET</source>
        <translation>NOCH KEIN PULT</translation>
    </message>
    <message>
        <source>BLACK-OUT</source>
        <translation>BLACKOUT</translation>
    </message>
    <message>
        <source>FROZEN</source>
        <translation>EINGEFROREN</translation>
    </message>
    <message>
        <source>RECORDING %1</source>
        <translation>NIMMT AUF %1</translation>
    </message>
    <message>
        <source>WORK LIGHT</source>
        <translation>ARBEITSLICHT</translation>
    </message>
    <message>
        <source>MASTER %1 %</source>
        <translation>MASTER %1 %</translation>
    </message>
    <message>
        <source>MASTER %1 % (remote)</source>
        <translation>MASTER %1 % (Fernsteuerung)</translation>
    </message>
    <message>
        <source>HAZE x %1 (remote)</source>
        <translation>NEBEL x %1 (Fernsteuerung)</translation>
    </message>
    <message>
        <source>TONE %1 (remote)</source>
        <translation>TONKURVE %1 (Fernsteuerung)</translation>
    </message>
    <message>
        <source>BLACK-OUT (remote)</source>
        <translation>BLACKOUT (Fernsteuerung)</translation>
    </message>
    <message>
        <source>%1 (remote)</source>
        <translation>%1 (Fernsteuerung)</translation>
    </message>
    <message>
        <source>by hand: %1</source>
        <translation>von Hand: %1</translation>
    </message>
    <message>
        <source>bounced light: %1</source>
        <translation>indirektes Licht: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n light(s) throw no shadows yet</source>
        <translation>
            <numerusform>%n Licht wirft noch keinen Schatten</numerusform>
            <numerusform>%n Lichter werfen noch keine Schatten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>LIVE DESK, %n universe(s) silent</source>
        <translation>
            <numerusform>PULT LIVE, %n Universum stumm</numerusform>
            <numerusform>PULT LIVE, %n Universen stumm</numerusform>
        </translation>
    </message>
    <message>
        <source>DESK SILENT %1 s</source>
        <translation>PULT STUMM %1 s</translation>
    </message>
    <message numerus="yes">
        <source>%n head(s) that nobody asks left dark</source>
        <translation>
            <numerusform>%n Gerät, das niemand ansteuert, bleibt dunkel</numerusform>
            <numerusform>%n Geräte, die niemand ansteuert, bleiben dunkel</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Colour</name>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Warm white</source>
        <translation>Warmweiß</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Amber</source>
        <translation>Amber</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Gelb</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Cyan</source>
        <translation>Cyan</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>Lavender</source>
        <translation>Lavendel</translation>
    </message>
    <message>
        <source>Magenta</source>
        <translation>Magenta</translation>
    </message>
    <message>
        <source>Hue and saturation</source>
        <translation>Farbton und Sättigung</translation>
    </message>
    <message>
        <source>Hue across, saturation down; arrow keys move it</source>
        <translation>Farbton waagerecht, Sättigung senkrecht; Pfeiltasten bewegen</translation>
    </message>
    <message>
        <source>Gel</source>
        <translation>Folie</translation>
    </message>
    <message>
        <source>Lee&apos;s conversions before a lamp of 3200 K; its colours as they look on a screen</source>
        <translation>Konversionsfolien von Lee vor einer Lampe mit 3200 K; Farbfolien, wie sie auf dem Bildschirm aussehen</translation>
    </message>
    <message>
        <source>Gel ...</source>
        <translation>Folie ...</translation>
    </message>
</context>
<context>
    <name>Cues</name>
    <message>
        <source>Cues</source>
        <translation>Cues</translation>
    </message>
    <message>
        <source>Cue</source>
        <translation>Cue</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>Look</translation>
    </message>
    <message>
        <source>Fade s</source>
        <translation>Zeit s</translation>
    </message>
    <message>
        <source>Follow s</source>
        <translation>Folge s</translation>
    </message>
    <message>
        <source>At s</source>
        <translation>Bei s</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Flight s</source>
        <translation>Fahrt s</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>Notizen</translation>
    </message>
    <message>
        <source>Double click or F2: change what stands there. Fade: empty is that of the look. Follow: the next cue goes by itself that long after this one.</source>
        <translation>Doppelklick oder F2: ändern, was dort steht. Zeit: leer ist die des Looks. Folge: Der nächste Cue kommt so lange nach diesem von selbst.</translation>
    </message>
    <message>
        <source>Go</source>
        <translation>Go</translation>
    </message>
    <message>
        <source>The next cue (Ctrl+G)</source>
        <translation>Der nächste Cue (Strg+G)</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>The cue before (Ctrl+Shift+G)</source>
        <translation>Der vorige Cue (Strg+Umschalt+G)</translation>
    </message>
    <message>
        <source>Go to this</source>
        <translation>Zu diesem</translation>
    </message>
    <message>
        <source>The chosen cue</source>
        <translation>Der gewählte Cue</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>A cue of the look that was recalled or stored last, or of this moment of the recording</source>
        <translation>Ein Cue mit dem zuletzt abgerufenen oder gespeicherten Look oder diesem Moment der Aufzeichnung</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Can be undone</source>
        <translation>Lässt sich rückgängig machen</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Earlier in the list</source>
        <translation>Früher in der Liste</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Runter</translation>
    </message>
    <message>
        <source>Later in the list</source>
        <translation>Später in der Liste</translation>
    </message>
    <message>
        <source>Follow the recording</source>
        <translation>Der Aufzeichnung folgen</translation>
    </message>
    <message>
        <source>A cue with a second is called when the recording, or its time code, comes by</source>
        <translation>Ein Cue mit einer Sekunde kommt, wenn die Aufzeichnung oder ihr Timecode dort ist</translation>
    </message>
    <message>
        <source>No cues yet. Store looks, recall one and add it here.</source>
        <translation>Noch keine Cues. Looks speichern, einen abrufen und hier hinzufügen.</translation>
    </message>
    <message>
        <source>This was the last cue.</source>
        <translation>Das war der letzte Cue.</translation>
    </message>
    <message>
        <source>Next: %1</source>
        <translation>Nächster: %1</translation>
    </message>
    <message>
        <source>Next: %1, in %2 s</source>
        <translation>Nächster: %1, in %2 s</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Seite</translation>
    </message>
</context>
<context>
    <name>Dark</name>
    <message>
        <source>BLACK-OUT: nothing shines until it ends (B)</source>
        <translation>BLACK-OUT: nichts leuchtet, bis es endet (B)</translation>
    </message>
    <message>
        <source>BLACK-OUT of a remote control: nothing shines</source>
        <translation>BLACK-OUT einer Fernsteuerung: nichts leuchtet</translation>
    </message>
    <message>
        <source>The master is at 0 %: nothing shines</source>
        <translation>Der Master steht auf 0 %: nichts leuchtet</translation>
    </message>
    <message>
        <source>The master of a remote control is at 0 %: nothing shines</source>
        <translation>Der Master einer Fernsteuerung steht auf 0 %: nichts leuchtet</translation>
    </message>
    <message>
        <source>Others are solo: this one is dark until they are not</source>
        <translation>Andere sind solo: dieser bleibt so lange dunkel</translation>
    </message>
</context>
<context>
    <name>Export</name>
    <message>
        <source>This machine</source>
        <translation>Dieser Rechner</translation>
    </message>
    <message>
        <source>A farm (Slurm)</source>
        <translation>Eine Farm (Slurm)</translation>
    </message>
    <message>
        <source>A farm cuts it into tasks for many machines, which must see the show under the same path. Its partition: SBATCH_PARTITION in the environment. Cancel stops following it only.</source>
        <translation>Eine Farm teilt es in Aufgaben für viele Rechner, die die Show unter demselben Pfad sehen müssen. Ihre Partition: SBATCH_PARTITION in der Umgebung. Abbrechen beendet nur das Mitverfolgen.</translation>
    </message>
    <message>
        <source>Bake</source>
        <translation>Vorberechnen</translation>
    </message>
    <message>
        <source>The final picture of a fixed camera, lit live. What is finished stays if it is cancelled.</source>
        <translation>Das endgültige Bild einer festen Kamera, live beleuchtet. Was fertig ist, bleibt beim Abbrechen.</translation>
    </message>
    <message>
        <source>Camera to bake</source>
        <translation>Kamera zum Vorberechnen</translation>
    </message>
    <message>
        <source>Samples per pixel</source>
        <translation>Abtastungen je Pixel</translation>
    </message>
    <message>
        <source>Bounces of indirect light</source>
        <translation>Reflexionen des indirekten Lichts</translation>
    </message>
    <message>
        <source>Who bakes</source>
        <translation>Wer vorberechnet</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Abtastungen</translation>
    </message>
    <message>
        <source>Bounces</source>
        <translation>Reflexionen</translation>
    </message>
    <message>
        <source>By</source>
        <translation>Durch</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>As the window sees it: drawn live. A camera of the show: from its passes.</source>
        <translation>Wie im Fenster: live gezeichnet. Eine Kamera der Show: aus dem Vorberechneten.</translation>
    </message>
    <message>
        <source>Camera of pictures</source>
        <translation>Kamera der Bilder</translation>
    </message>
    <message>
        <source>Size of pictures</source>
        <translation>Größe der Bilder</translation>
    </message>
    <message>
        <source>Begin of the film</source>
        <translation>Beginn des Films</translation>
    </message>
    <message>
        <source>End of the film</source>
        <translation>Ende des Films</translation>
    </message>
    <message>
        <source>Pictures a second</source>
        <translation>Bilder pro Sekunde</translation>
    </message>
    <message>
        <source>Still...</source>
        <translation>Einzelbild ...</translation>
    </message>
    <message>
        <source>Film...</source>
        <translation>Film ...</translation>
    </message>
    <message>
        <source>Contact sheet...</source>
        <translation>Kontaktbogen ...</translation>
    </message>
    <message>
        <source>All looks from all cameras; without looks, the cues</source>
        <translation>Alle Looks aus allen Kameras; ohne Looks die Cues</translation>
    </message>
    <message>
        <source>Save a still</source>
        <translation>Einzelbild sichern</translation>
    </message>
    <message>
        <source>Save a film</source>
        <translation>Film sichern</translation>
    </message>
    <message>
        <source>Save a contact sheet</source>
        <translation>Kontaktbogen sichern</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Film</source>
        <translation>Film</translation>
    </message>
    <message>
        <source>Its rate</source>
        <translation>Bildrate</translation>
    </message>
    <message>
        <source>Who draws films</source>
        <translation>Wer Filme zeichnet</translation>
    </message>
    <message>
        <source> a second</source>
        <translation> pro Sekunde</translation>
    </message>
    <message>
        <source>All cameras</source>
        <translation>Alle Kameras</translation>
    </message>
    <message>
        <source>As the window sees it</source>
        <translation>Wie im Fenster</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>to</source>
        <translation>bis</translation>
    </message>
</context>
<context>
    <name>Fan</name>
    <message>
        <source>First to last</source>
        <translation>Erstes bis letztes</translation>
    </message>
    <message>
        <source>Symmetric</source>
        <translation>Symmetrisch</translation>
    </message>
    <message>
        <source>From the centre</source>
        <translation>Aus der Mitte</translation>
    </message>
    <message>
        <source>As selected</source>
        <translation>Wie ausgewählt</translation>
    </message>
    <message>
        <source>As listed</source>
        <translation>Wie gelistet</translation>
    </message>
    <message>
        <source>Left to right</source>
        <translation>Links nach rechts</translation>
    </message>
    <message>
        <source>First</source>
        <translation>Erstes</translation>
    </message>
    <message>
        <source>Last</source>
        <translation>Letztes</translation>
    </message>
    <message>
        <source>Ends</source>
        <translation>Enden</translation>
    </message>
    <message>
        <source>Middle</source>
        <translation>Mitte</translation>
    </message>
    <message>
        <source>Ends by</source>
        <translation>Enden um</translation>
    </message>
    <message>
        <source>All as first</source>
        <translation>Wie das erste</translation>
    </message>
    <message>
        <source>All get the value of the first one that was selected</source>
        <translation>Alle erhalten den Wert des zuerst ausgewählten</translation>
    </message>
    <message>
        <source>All as last</source>
        <translation>Wie das letzte</translation>
    </message>
    <message>
        <source>All get the value of the last one that was selected</source>
        <translation>Alle erhalten den Wert des zuletzt ausgewählten</translation>
    </message>
    <message>
        <source>Between them</source>
        <translation>Dazwischen</translation>
    </message>
    <message>
        <source>Evenly from what the first has to what the last has</source>
        <translation>Gleichmäßig von dem, was das erste hat, bis zu dem, was das letzte hat</translation>
    </message>
    <message>
        <source>Fan and align</source>
        <translation>Fächern, angleichen</translation>
    </message>
    <message>
        <source>Spreads a value over the selected heads, or gives them that of one</source>
        <translation>Verteilt einen Wert über die ausgewählten Geräte oder gibt ihnen den von einem</translation>
    </message>
    <message>
        <source>What is spread</source>
        <translation>Was gefächert wird</translation>
    </message>
    <message>
        <source>How it is spread</source>
        <translation>Wie gefächert wird</translation>
    </message>
    <message>
        <source>Order of the heads</source>
        <translation>Reihenfolge der Geräte</translation>
    </message>
</context>
<context>
    <name>Figures</name>
    <message>
        <source>at rest, drawn in %1 ms</source>
        <translation>in Ruhe, gezeichnet in %1 ms</translation>
    </message>
    <message>
        <source>%1 ms a frame, %2 pictures/s</source>
        <translation>%1 ms pro Bild, %2 Bilder/s</translation>
    </message>
    <message>
        <source>%1 ms a frame</source>
        <translation>%1 ms pro Bild</translation>
    </message>
    <message>
        <source>%1 while it moves</source>
        <translation>%1 in Bewegung</translation>
    </message>
    <message>
        <source>tone curve %1</source>
        <translation>Tonwertkurve %1</translation>
    </message>
    <message>
        <source>packet to window %1 ms (half within %2, 99 % within %3)</source>
        <translation>Paket bis Fenster %1 ms (Hälfte in %2, 99 % in %3)</translation>
    </message>
    <message>
        <source>the window itself %1 ms a picture (99 % within %2)</source>
        <translation>das Fenster selbst %1 ms pro Bild (99 % in %2)</translation>
    </message>
    <message>
        <source>packet to window: frozen, what a desk sends waits</source>
        <translation>Paket bis Fenster: eingefroren, was ein Pult sendet, wartet</translation>
    </message>
</context>
<context>
    <name>Files</name>
    <message>
        <source>Models (*.glb *.gltf *.obj *.3ds);;All files (*)</source>
        <translation>Modelle (*.glb *.gltf *.obj *.3ds);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Add a fixture</source>
        <translation>Gerät hinzufügen</translation>
    </message>
    <message>
        <source>Fixtures (*.gdtf *.qxf *.json);;All files (*)</source>
        <translation>Geräte (*.gdtf *.qxf *.json);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>A model becomes the stage of the show</source>
        <translation>Ein Modell wird zur Bühne der Show</translation>
    </message>
    <message>
        <source>A model that stands on the stage</source>
        <translation>Ein Modell, das auf der Bühne steht</translation>
    </message>
    <message>
        <source>Save a copy of the show file</source>
        <translation>Kopie der Showdatei sichern</translation>
    </message>
    <message>
        <source>Show files (*.toml)</source>
        <translation>Showdateien (*.toml)</translation>
    </message>
    <message>
        <source>Play a recording</source>
        <translation>Aufzeichnung abspielen</translation>
    </message>
    <message>
        <source>Recordings (*.ghostdmx *.show *.pcap *.pcapng);;All files (*)</source>
        <translation>Aufzeichnungen (*.ghostdmx *.show *.pcap *.pcapng);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>A new show: its folder</source>
        <translation>Neue Show: ihr Ordner</translation>
    </message>
    <message>
        <source>Folders (*)</source>
        <translation>Ordner (*)</translation>
    </message>
    <message>
        <source>A plot becomes a show</source>
        <translation>Ein Plan wird zur Show</translation>
    </message>
    <message>
        <source>Plots (*.mvr)</source>
        <translation>Pläne (*.mvr)</translation>
    </message>
    <message>
        <source>Save the show under another name beside it</source>
        <translation>Show unter anderem Namen daneben sichern</translation>
    </message>
    <message>
        <source>Pictures (*.png *.exr)</source>
        <translation>Bilder (*.png *.exr)</translation>
    </message>
    <message>
        <source>Films (*.mp4)</source>
        <translation>Filme (*.mp4)</translation>
    </message>
    <message>
        <source>Pictures (*.png)</source>
        <translation>Bilder (*.png)</translation>
    </message>
    <message>
        <source>What the plot has, as text</source>
        <translation>Was der Plan enthält, als Text</translation>
    </message>
    <message>
        <source>Text (*.txt)</source>
        <translation>Text (*.txt)</translation>
    </message>
    <message>
        <source>Open a show</source>
        <translation>Show öffnen</translation>
    </message>
    <message>
        <source>Shows (show.toml *.mvr);;All files (*)</source>
        <translation>Shows (show.toml *.mvr);;Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Save the picture</source>
        <translation>Bild sichern</translation>
    </message>
    <message>
        <source>Save a picture of the window</source>
        <translation>Bild des Fensters sichern</translation>
    </message>
</context>
<context>
    <name>Fixtures</name>
    <message>
        <source>Type: %1</source>
        <translation>Typ: %1</translation>
    </message>
    <message>
        <source>Layer: %1</source>
        <translation>Ebene: %1</translation>
    </message>
    <message>
        <source>Under: %1</source>
        <translation>Unter: %1</translation>
    </message>
    <message>
        <source>none</source>
        <translation>keine</translation>
    </message>
    <message>
        <source>file cannot be read</source>
        <translation>Datei nicht lesbar</translation>
    </message>
    <message>
        <source>Another fixture reads a channel of this one.</source>
        <translation>Ein anderes Gerät liest einen Kanal von diesem.</translation>
    </message>
    <message>
        <source>Set by hand; R gives it back.</source>
        <translation>Von Hand gesetzt; R gibt frei.</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Patch</source>
        <translation>Patch</translation>
    </message>
    <message>
        <source>Light</source>
        <translation>Licht</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehung</translation>
    </message>
    <message>
        <source>Search</source>
        <translation>Suchen</translation>
    </message>
    <message>
        <source>In names, addresses, types and modes</source>
        <translation>In Namen, Adressen, Typen und Modi</translation>
    </message>
    <message>
        <source>Search fixtures</source>
        <translation>Geräte suchen</translation>
    </message>
    <message>
        <source>Group of fixtures</source>
        <translation>Gruppe von Geräten</translation>
    </message>
    <message>
        <source>One type, layer or truss alone; Enter in the search selects what is listed</source>
        <translation>Nur ein Typ, eine Ebene oder eine Traverse; Eingabe in der Suche wählt aus, was gelistet ist</translation>
    </message>
    <message>
        <source>Dark</source>
        <translation>Dunkel</translation>
    </message>
    <message>
        <source>Only fixtures that do not shine, by reasons</source>
        <translation>Nur Geräte, die nicht leuchten, nach Gründen</translation>
    </message>
    <message>
        <source>Fixtures</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>All fixtures</source>
        <translation>Alle Geräte</translation>
    </message>
    <message>
        <source>Asking why ...</source>
        <translation>Gründe folgen ...</translation>
    </message>
    <message>
        <source>%1, %2 selected</source>
        <translation>%1, %2 ausgewählt</translation>
    </message>
    <message numerus="yes">
        <source>%n fixture(s)</source>
        <translation>
            <numerusform>%n Gerät</numerusform>
            <numerusform>%n Geräte</numerusform>
        </translation>
    </message>
    <message>
        <source>file is being read</source>
        <translation>Datei wird gelesen</translation>
    </message>
    <message>
        <source>None is dark</source>
        <translation>Keiner ist dunkel</translation>
    </message>
    <message>
        <source>Dark: %1</source>
        <translation>Dunkel: %1</translation>
    </message>
    <message>
        <source>Its file cannot be read: %1</source>
        <translation>Seine Datei kann nicht gelesen werden: %1</translation>
    </message>
</context>
<context>
    <name>Jobs</name>
    <message>
        <source>, %1 left</source>
        <translation>, noch %1</translation>
    </message>
    <message>
        <source>%1 on the farm</source>
        <translation>%1 auf der Farm</translation>
    </message>
    <message>
        <source>Bake all cameras</source>
        <translation>Alle Kameras vorberechnen</translation>
    </message>
    <message>
        <source>Bake %1</source>
        <translation>%1 vorberechnen</translation>
    </message>
    <message>
        <source>Film %1</source>
        <translation>Film %1</translation>
    </message>
    <message>
        <source>Still %1</source>
        <translation>Einzelbild %1</translation>
    </message>
    <message>
        <source>Contact sheet %1</source>
        <translation>Kontaktbogen %1</translation>
    </message>
    <message>
        <source>import %1</source>
        <translation>%1 importieren</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>runs</source>
        <translation>läuft</translation>
    </message>
    <message>
        <source>done</source>
        <translation>fertig</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>fehlgeschlagen</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>abgebrochen</translation>
    </message>
    <message>
        <source>stopping</source>
        <translation>hält an</translation>
    </message>
    <message>
        <source>begins</source>
        <translation>beginnt</translation>
    </message>
    <message>
        <source>Cue book %1</source>
        <translation>Cue-Buch %1</translation>
    </message>
    <message>
        <source>Paperwork %1</source>
        <translation>Unterlagen %1</translation>
    </message>
    <message>
        <source>The show lacks something: %1</source>
        <translation>Der Show fehlt etwas: %1</translation>
    </message>
</context>
<context>
    <name>Keys</name>
    <message>
        <source>drag</source>
        <translation>Ziehen</translation>
    </message>
    <message>
        <source>around what is looked at</source>
        <translation>um das, was man ansieht</translation>
    </message>
    <message>
        <source>right drag</source>
        <translation>rechts ziehen</translation>
    </message>
    <message>
        <source>look around</source>
        <translation>umsehen</translation>
    </message>
    <message>
        <source>middle drag, Shift+drag</source>
        <translation>Mitte ziehen, Umschalt+Ziehen</translation>
    </message>
    <message>
        <source>sideways</source>
        <translation>seitwärts</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>Rad</translation>
    </message>
    <message>
        <source>nearer, farther</source>
        <translation>näher, ferner</translation>
    </message>
    <message>
        <source>W A S D, arrows</source>
        <translation>W A S D, Pfeile</translation>
    </message>
    <message>
        <source>fly; Q, E or page keys: down, up; Shift: faster</source>
        <translation>fliegen; Q, E oder Bildtasten: ab, auf; Umschalt: schneller</translation>
    </message>
    <message>
        <source>click, Ctrl+click</source>
        <translation>Klick, Strg+Klick</translation>
    </message>
    <message>
        <source>select a fixture, one more</source>
        <translation>ein Gerät auswählen, eines mehr</translation>
    </message>
    <message>
        <source>Ctrl+drag</source>
        <translation>Strg+Ziehen</translation>
    </message>
    <message>
        <source>select all in a box</source>
        <translation>alle in einem Rahmen auswählen</translation>
    </message>
    <message>
        <source>double click</source>
        <translation>Doppelklick</translation>
    </message>
    <message>
        <source>go to a fixture; choose a set piece, which its cross moves</source>
        <translation>zu einem Gerät gehen; ein Bühnenteil wählen, das sein Kreuz bewegt</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>Tasten und Maus</translation>
    </message>
    <message>
        <source>In the picture</source>
        <translation>Im Bild</translation>
    </message>
    <message>
        <source>Shift+click</source>
        <translation>Umschalt+Klick</translation>
    </message>
    <message>
        <source>the selected heads point at what is there</source>
        <translation>die ausgewählten Köpfe zeigen dorthin</translation>
    </message>
    <message>
        <source>drag of a selected lamp</source>
        <translation>eine ausgewählte Lampe ziehen</translation>
    </message>
    <message>
        <source>the selected fixtures move along their truss; Shift: up and down</source>
        <translation>die ausgewählten Geräte wandern an ihrer Traverse entlang; Umschalt: auf und ab</translation>
    </message>
    <message>
        <source>right click</source>
        <translation>Rechtsklick</translation>
    </message>
    <message>
        <source>what can be done there</source>
        <translation>was sich dort tun lässt</translation>
    </message>
</context>
<context>
    <name>Looks</name>
    <message>
        <source>Looks</source>
        <translation>Looks</translation>
    </message>
    <message>
        <source>Double click or Enter: recall. F2: another name.</source>
        <translation>Doppelklick oder Eingabe: abrufen. F2: anderer Name.</translation>
    </message>
    <message>
        <source>Recall</source>
        <translation>Abrufen</translation>
    </message>
    <message>
        <source>Fades to it</source>
        <translation>Blendet dorthin über</translation>
    </message>
    <message>
        <source>Store programmer</source>
        <translation>Prog. speichern</translation>
    </message>
    <message>
        <source>As a new look</source>
        <translation>Als neuer Look</translation>
    </message>
    <message>
        <source>Store what is seen</source>
        <translation>Bild speichern</translation>
    </message>
    <message>
        <source>Of the selected fixtures, or of all: whoever asked for it</source>
        <translation>Von den ausgewählten Geräten oder von allen: woher es auch kommt</translation>
    </message>
    <message>
        <source>Update</source>
        <translation>Aktualisieren</translation>
    </message>
    <message>
        <source>Puts what hands set in its place</source>
        <translation>Setzt an seine Stelle, was von Hand gesetzt ist</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Can be undone</source>
        <translation>Lässt sich rückgängig machen</translation>
    </message>
    <message>
        <source> s fade</source>
        <translation> s Zeit</translation>
    </message>
    <message>
        <source>Seconds of the crossfade</source>
        <translation>Sekunden der Überblendung</translation>
    </message>
    <message>
        <source>Solo</source>
        <translation>Solo</translation>
    </message>
    <message>
        <source>The selected fixtures alone shine</source>
        <translation>Nur die ausgewählten Geräte leuchten</translation>
    </message>
    <message>
        <source>Gel</source>
        <translation>Folie</translation>
    </message>
    <message>
        <source>A filter in front of the selected fixtures, on top of all else</source>
        <translation>Ein Filter vor den ausgewählten Geräten, zusätzlich zu allem</translation>
    </message>
    <message>
        <source>Lamp</source>
        <translation>Lampe</translation>
    </message>
    <message>
        <source>Another lamp: how many times as much light</source>
        <translation>Eine andere Lampe: wievielmal so viel Licht</translation>
    </message>
    <message>
        <source>Its white</source>
        <translation>Ihr Weiß</translation>
    </message>
    <message>
        <source>Add as a cue</source>
        <translation>Als Cue hinzufügen</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Update with what hands set</source>
        <translation>Mit Handwerten aktualisieren</translation>
    </message>
    <message>
        <source>What if: select fixtures to try another gel or lamp</source>
        <translation>Was wäre wenn: Geräte auswählen, um andere Folien oder Lampen zu probieren</translation>
    </message>
    <message numerus="yes">
        <source>%n fixture(s), %1 s</source>
        <translation>
            <numerusform>%n Gerät, %1 s</numerusform>
            <numerusform>%n Geräte, %1 s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Solo: %n shine(s)</source>
        <translation>
            <numerusform>Solo: %n leuchtet</numerusform>
            <numerusform>Solo: %n leuchten</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>What if %n fixture(s) had</source>
        <translation>
            <numerusform>Was, wenn dieses Gerät hätte</numerusform>
            <numerusform>Was, wenn %n Geräte hätten</numerusform>
        </translation>
    </message>
    <message>
        <source>Nothing is set by hand: set something in Programmer or Scene, or take Store what is seen</source>
        <translation>Nichts ist von Hand gesetzt: unter Programmer oder Szene etwas setzen, oder Bild speichern nehmen</translation>
    </message>
</context>
<context>
    <name>Menu</name>
    <message>
        <source>Show</source>
        <translation>Show</translation>
    </message>
    <message>
        <source>Edit</source>
        <translation>Bearbeiten</translation>
    </message>
    <message>
        <source>View</source>
        <translation>Ansicht</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Play</source>
        <translation>Abspielen</translation>
    </message>
    <message>
        <source>Quality</source>
        <translation>Qualität</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Fenster</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>Hilfe</translation>
    </message>
    <message>
        <source>Open recent</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
</context>
<context>
    <name>Messages</name>
    <message>
        <source>What</source>
        <translation>Was</translation>
    </message>
    <message>
        <source>Where</source>
        <translation>Wo</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>Was zu tun ist</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Double click or Enter: the fixtures that it is about, else the file.</source>
        <translation>Doppelklick oder Eingabe: die Geräte, um die es geht, sonst die Datei.</translation>
    </message>
    <message>
        <source>%1 (%2 times)</source>
        <translation>%1 (%2-mal)</translation>
    </message>
    <message>
        <source>Nothing is wrong with this show.</source>
        <translation>An dieser Show ist nichts falsch.</translation>
    </message>
</context>
<context>
    <name>Movers</name>
    <message>
        <source>Movers</source>
        <translation>Bewegte Teile</translation>
    </message>
    <message>
        <source>Of its way from %1 to %2%3; as the machine, within its speed</source>
        <translation>Von seinem Weg von %1 bis %2%3; wie die Maschine, mit ihrer Geschwindigkeit</translation>
    </message>
    <message>
        <source>As machines go</source>
        <translation>Wie die Maschinen fahren</translation>
    </message>
    <message>
        <source>Within speed and acceleration of each; else at once where they are asked to be</source>
        <translation>Mit Geschwindigkeit und Beschleunigung jeder Maschine; sonst sofort dort, wo sie sein sollen</translation>
    </message>
    <message>
        <source>no address</source>
        <translation>keine Adresse</translation>
    </message>
    <message>
        <source>Address of %1</source>
        <translation>Adresse von %1</translation>
    </message>
    <message>
        <source>Universe.address of its first axis, 16 bits each; the others follow. Return sets it.</source>
        <translation>Universum.Adresse der ersten Achse, je 16 Bit; die anderen folgen. Eingabe setzt sie.</translation>
    </message>
    <message>
        <source>%1 %2° of %3 to %4</source>
        <translation>%1 %2° von %3 bis %4</translation>
    </message>
    <message>
        <source>%1 %2 m of %3 to %4</source>
        <translation>%1 %2 m von %3 bis %4</translation>
    </message>
</context>
<context>
    <name>Network</name>
    <message>
        <source>Nothing of universe %1 has come</source>
        <translation>Von Universum %1 kam nichts</translation>
    </message>
    <message>
        <source>Nothing has come from the network yet.</source>
        <translation>Aus dem Netzwerk kam noch nichts.</translation>
    </message>
    <message>
        <source>Sources</source>
        <translation>Quellen</translation>
    </message>
    <message>
        <source>Universe</source>
        <translation>Universum</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Is</source>
        <translation>Ist</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>Priorität</translation>
    </message>
    <message>
        <source>Rate</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Jitter</source>
        <translation>Jitter</translation>
    </message>
    <message>
        <source>Missed</source>
        <translation>Verlust</translation>
    </message>
    <message>
        <source>From</source>
        <translation>Von</translation>
    </message>
    <message>
        <source>Protocol</source>
        <translation>Protokoll</translation>
    </message>
    <message>
        <source>Patched</source>
        <translation>Gepatcht</translation>
    </message>
    <message>
        <source>sACN %1, Art-Net %2 packets</source>
        <translation>sACN %1, Art-Net %2 Pakete</translation>
    </message>
    <message>
        <source>, %1 not understood</source>
        <translation>, %1 nicht verstanden</translation>
    </message>
    <message>
        <source>, %1 lost on the way</source>
        <translation>, %1 unterwegs verloren</translation>
    </message>
    <message>
        <source>, %1 lost in this machine</source>
        <translation>, %1 in diesem Rechner verloren</translation>
    </message>
    <message>
        <source>, %1 of a desk in preview (blind)</source>
        <translation>, %1 von einem Pult in Vorschau (blind)</translation>
    </message>
    <message>
        <source>; packet to picture %1 ms (median), %2 (99 %), %3 at most</source>
        <translation>; Paket bis Bild %1 ms (Median), %2 (99 %), höchstens %3</translation>
    </message>
    <message>
        <source>yes</source>
        <translation>ja</translation>
    </message>
    <message>
        <source>no</source>
        <translation>nein</translation>
    </message>
    <message>
        <source>Universe %1</source>
        <translation>Universum %1</translation>
    </message>
    <message>
        <source>What is wrong</source>
        <translation>Was nicht stimmt</translation>
    </message>
</context>
<context>
    <name>Notice</name>
    <message>
        <source>Looks stay as the file has them until this is mended: %1</source>
        <translation>Looks bleiben, wie die Datei sie hat, bis das behoben ist: %1</translation>
    </message>
    <message>
        <source>Looks were changed by another program, which is not undone: %1</source>
        <translation>Looks wurden von einem anderen Programm geändert, das wird nicht rückgängig gemacht: %1</translation>
    </message>
    <message>
        <source>Remote control: %1</source>
        <translation>Fernsteuerung: %1</translation>
    </message>
    <message>
        <source>Another window has this show open: %1. Here it is read only.</source>
        <translation>Ein anderes Fenster hat diese Show offen: %1. Hier ist sie schreibgeschützt.</translation>
    </message>
    <message>
        <source>What was not saved here is kept in %1.</source>
        <translation>Was hier nicht gesichert war, liegt in %1.</translation>
    </message>
    <message>
        <source>What is not saved here can be saved as a copy.</source>
        <translation>Was hier nicht gesichert ist, lässt sich als Kopie sichern.</translation>
    </message>
    <message>
        <source>Another window took this show over: %1. Here it is read only.</source>
        <translation>Ein anderes Fenster hat diese Show übernommen: %1. Hier ist sie schreibgeschützt.</translation>
    </message>
    <message>
        <source>Changes of %1 were not saved.</source>
        <translation>Änderungen vom %1 wurden nicht gesichert.</translation>
    </message>
    <message>
        <source>The show file was changed since; taking them drops what was changed there.</source>
        <translation>Die Showdatei wurde seitdem geändert; sie zu übernehmen verwirft, was dort geändert wurde.</translation>
    </message>
    <message>
        <source>Changes that are not saved cannot be kept: %1</source>
        <translation>Nicht gesicherte Änderungen lassen sich nicht aufheben: %1</translation>
    </message>
    <message>
        <source>Another program changed the show file, and there are changes here that are not saved.</source>
        <translation>Ein anderes Programm hat die Showdatei geändert, und hier gibt es nicht gesicherte Änderungen.</translation>
    </message>
    <message>
        <source>Another program changed the show file, and it cannot be taken: %1</source>
        <translation>Ein anderes Programm hat die Showdatei geändert, und sie lässt sich nicht übernehmen: %1</translation>
    </message>
    <message>
        <source>The show file is gone: deleted, renamed, or its disk was taken out. What is open here stays as it is.</source>
        <translation>Die Showdatei ist weg: gelöscht, umbenannt, oder ihr Datenträger wurde entfernt. Was hier offen ist, bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>The show folder is gone: deleted, renamed, or its disk was taken out. What is open here stays as it is.</source>
        <translation>Der Showordner ist weg: gelöscht, umbenannt, oder sein Datenträger wurde entfernt. Was hier offen ist, bleibt, wie es ist.</translation>
    </message>
    <message>
        <source>The show is not saved: %1</source>
        <translation>Die Show ist nicht gesichert: %1</translation>
    </message>
    <message>
        <source>The displays changed: what was out of sight is here now</source>
        <translation>Die Bildschirme haben sich geändert: Was außer Sicht war, ist jetzt hier</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Notice</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Take them</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Drop them</source>
        <translation>Verwerfen</translation>
    </message>
    <message>
        <source>Take what the file says</source>
        <translation>Stand der Datei übernehmen</translation>
    </message>
    <message>
        <source>Save mine over it</source>
        <translation>Eigenen Stand darüber sichern</translation>
    </message>
    <message>
        <source>Save it there again</source>
        <translation>Dort wieder sichern</translation>
    </message>
    <message>
        <source>Save a copy elsewhere...</source>
        <translation>Kopie anderswo sichern ...</translation>
    </message>
    <message>
        <source>Take it over</source>
        <translation>Übernehmen</translation>
    </message>
    <message>
        <source>Try again</source>
        <translation>Noch einmal versuchen</translation>
    </message>
    <message>
        <source>Close and lose them</source>
        <translation>Schließen und verlieren</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Open the file</source>
        <translation>Datei öffnen</translation>
    </message>
    <message>
        <source>What was open stays open.</source>
        <translation>Was offen war, bleibt offen.</translation>
    </message>
    <message>
        <source>Not opened: %1.</source>
        <translation>Nicht geöffnet: %1.</translation>
    </message>
    <message>
        <source>Opened, but: %1</source>
        <translation>Geöffnet, aber: %1</translation>
    </message>
    <message>
        <source>Opened, but: %1 (and %2 more)</source>
        <translation>Geöffnet, aber: %1 (und %2 weitere)</translation>
    </message>
    <message>
        <source>Since this edit: %1</source>
        <translation>Seit dieser Änderung: %1</translation>
    </message>
    <message>
        <source>Since this edit: %1 (and %2 more)</source>
        <translation>Seit dieser Änderung: %1 (und %2 weitere)</translation>
    </message>
    <message>
        <source>All messages</source>
        <translation>Alle Meldungen</translation>
    </message>
    <message>
        <source>Ghostlight, the picture</source>
        <translation>Ghostlight, das Bild</translation>
    </message>
    <message>
        <source>The picture is on %1</source>
        <translation>Das Bild ist auf %1</translation>
    </message>
    <message>
        <source>a window of its own</source>
        <translation>einem eigenen Fenster</translation>
    </message>
    <message>
        <source>%1, which is unplugged</source>
        <translation>%1, zurzeit nicht angeschlossen</translation>
    </message>
    <message>
        <source>The display %1 is gone; the picture comes back with it</source>
        <translation>Der Bildschirm %1 ist weg; das Bild kommt mit ihm zurück</translation>
    </message>
    <message>
        <source>Press ? for all keys. A desk that sends sACN or Art-Net takes over by itself.</source>
        <translation>? zeigt alle Tasten. Ein Pult, das sACN oder Art-Net sendet, übernimmt von selbst.</translation>
    </message>
    <message>
        <source>Press ? for all keys.</source>
        <translation>? zeigt alle Tasten.</translation>
    </message>
    <message>
        <source>%1 sent a plot (%2): Show, Take the received plot, Ctrl+T</source>
        <translation>%1 hat einen Plan gesendet (%2): Show, Empfangenen Plan übernehmen, Strg+T</translation>
    </message>
    <message>
        <source>The picture is saved</source>
        <translation>Das Bild ist gesichert</translation>
    </message>
    <message>
        <source>Recorded %1 s to %2: Play, Play what was recorded last</source>
        <translation>%1 s aufgezeichnet nach %2: Abspielen, Letzte Aufzeichnung abspielen</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>Gesichert: %1</translation>
    </message>
    <message>
        <source>By hand now: %1. R gives back what is selected, Shift+R all</source>
        <translation>Jetzt von Hand: %1. R gibt die Auswahl frei, Umschalt+R alles</translation>
    </message>
    <message>
        <source>Listening for a desk: nothing has come yet</source>
        <translation>Wartet auf ein Pult: noch kam nichts</translation>
    </message>
    <message>
        <source>No input: started with --no-desk</source>
        <translation>Keine Eingabe: mit --no-desk gestartet</translation>
    </message>
    <message>
        <source>No recording: the show has none; a desk is not taken (Play menu)</source>
        <translation>Keine Aufzeichnung: die Show hat keine; ein Pult wird nicht genommen (Menü Abspielen)</translation>
    </message>
    <message>
        <source>No recording; a desk that sends sACN or Art-Net takes over by itself</source>
        <translation>Keine Aufzeichnung; ein Pult, das sACN oder Art-Net sendet, übernimmt von selbst</translation>
    </message>
    <message>
        <source>No recording, and no desk: started with --no-desk</source>
        <translation>Keine Aufzeichnung und kein Pult: mit --no-desk gestartet</translation>
    </message>
    <message>
        <source>Recording, %1 of %2 s</source>
        <translation>Aufzeichnung, %1 von %2 s</translation>
    </message>
    <message>
        <source>RECORDING, %1 s</source>
        <translation>AUFNAHME, %1 s</translation>
    </message>
    <message>
        <source>Not closed, for changes are not saved and cannot be kept: %1</source>
        <translation>Nicht geschlossen, denn Änderungen sind nicht gesichert und lassen sich nicht aufheben: %1</translation>
    </message>
    <message numerus="yes">
        <source>%n head(s) have no optics in their files: what is seen of their light is assumed.</source>
        <translation>
            <numerusform>%n Gerät hat keine Optik in seiner Datei: Was von seinem Licht zu sehen ist, ist angenommen.</numerusform>
            <numerusform>%n Geräte haben keine Optik in ihren Dateien: Was von ihrem Licht zu sehen ist, ist angenommen.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>A desk: %n universe(s)</source>
        <translation>
            <numerusform>Ein Pult: %n Universum</numerusform>
            <numerusform>Ein Pult: %n Universen</numerusform>
        </translation>
    </message>
    <message>
        <source>From the next start on: %1</source>
        <translation>Ab dem nächsten Start: %1</translation>
    </message>
    <message>
        <source>A plot that is opened as it is cannot be edited. A show that is made of it can, and its changes outlive the designer&apos;s next version.</source>
        <translation>Ein direkt geöffneter Plan lässt sich nicht bearbeiten. Eine Show, die daraus gemacht wird, schon, und ihre Änderungen überdauern die nächste Fassung des Plans.</translation>
    </message>
    <message>
        <source>Make a show of it</source>
        <translation>Eine Show daraus machen</translation>
    </message>
    <message numerus="yes">
        <source>%n head(s) have no optics and stay dark until another file stands in.</source>
        <translation>
            <numerusform>%n Gerät hat keine Optik und bleibt dunkel, bis eine andere Datei einspringt.</numerusform>
            <numerusform>%n Geräte haben keine Optik und bleiben dunkel, bis eine andere Datei einspringt.</numerusform>
        </translation>
    </message>
    <message>
        <source>Other files for them...</source>
        <translation>Andere Dateien dafür ...</translation>
    </message>
    <message>
        <source>%1, of which %2 have no optics and stay dark</source>
        <translation>%1, davon %2 ohne Optik, die dunkel bleiben</translation>
    </message>
    <message>
        <source>Looks keep the old names of fixtures: %1</source>
        <translation>Looks behalten die alten Namen der Geräte: %1</translation>
    </message>
    <message numerus="yes">
        <source>A desk that is silent: %n universe(s)</source>
        <translation>
            <numerusform>Ein Pult, das schweigt: %n Universum</numerusform>
            <numerusform>Ein Pult, das schweigt: %n Universen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n of them silent</source>
        <translation>
            <numerusform>, davon %n stumm</numerusform>
            <numerusform>, davon %n stumm</numerusform>
        </translation>
    </message>
    <message>
        <source>The camera sees nothing of the stage; Home frames it.</source>
        <translation>Die Kamera sieht nichts von der Bühne; Pos1 zeigt sie.</translation>
    </message>
    <message>
        <source>The camera is behind &apos;%1&apos; and sees nothing of the stage; Home frames it.</source>
        <translation>Die Kamera steht hinter &apos;%1&apos; und sieht nichts von der Bühne; Pos1 zeigt sie.</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pos1</translation>
    </message>
    <message>
        <source>Name of camera &apos;%1&apos;</source>
        <translation>Name der Kamera &apos;%1&apos;</translation>
    </message>
    <message>
        <source>Name...</source>
        <translation>Name...</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Not done: %1</source>
        <translation>Nicht getan: %1</translation>
    </message>
    <message>
        <source>Opened, but this is ignored: %1 (and %2 more)</source>
        <translation>Geöffnet, doch dies wird übergangen: %1 (und %2 weitere)</translation>
    </message>
    <message>
        <source>Opened, but this is ignored: %1</source>
        <translation>Geöffnet, doch dies wird übergangen: %1</translation>
    </message>
    <message>
        <source>Not in the show any more, with what hands held of it: %1</source>
        <translation>Nicht mehr in der Show, samt dem, was von Hand gesetzt war: %1</translation>
    </message>
</context>
<context>
    <name>Palettes</name>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Beam</source>
        <translation>Strahl</translation>
    </message>
    <message>
        <source>Gobo</source>
        <translation>Gobo</translation>
    </message>
    <message>
        <source>All heads: %1</source>
        <translation>Alle Geräte: %1</translation>
    </message>
    <message>
        <source>Palettes: %1</source>
        <translation>Paletten: %1</translation>
    </message>
    <message>
        <source>Store palette</source>
        <translation>Palette speichern</translation>
    </message>
    <message>
        <source>What hands set of it for the selected fixtures, as a new palette of the show</source>
        <translation>Was davon für die ausgewählten Geräte von Hand gesetzt ist, als neue Palette der Show</translation>
    </message>
    <message>
        <source>Palettes</source>
        <translation>Paletten</translation>
    </message>
    <message>
        <source>A click gives it to the selected fixtures. F2: another name.</source>
        <translation>Ein Klick gibt sie den ausgewählten Geräten. F2: anderer Name.</translation>
    </message>
    <message>
        <source>Give it to the selected fixtures</source>
        <translation>Den ausgewählten Geräten geben</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Update with what hands set</source>
        <translation>Mit Handwerten aktualisieren</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message numerus="yes">
        <source>%n head(s), each its own</source>
        <translation>
            <numerusform>%n Gerät, eigene Werte</numerusform>
            <numerusform>%n Geräte, jedes mit eigenen Werten</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Panel</name>
    <message>
        <source>Transport</source>
        <translation>Transport</translation>
    </message>
    <message>
        <source>Fixtures</source>
        <translation>Geräte</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Programmer</source>
        <translation>Programmer</translation>
    </message>
    <message>
        <source>Scene</source>
        <translation>Szene</translation>
    </message>
    <message>
        <source>Network</source>
        <translation>Netzwerk</translation>
    </message>
    <message>
        <source>Messages</source>
        <translation>Meldungen</translation>
    </message>
    <message>
        <source>Looks</source>
        <translation>Looks</translation>
    </message>
    <message>
        <source>Export</source>
        <translation>Export</translation>
    </message>
    <message>
        <source>Air</source>
        <translation>Luft</translation>
    </message>
    <message>
        <source>Cues</source>
        <translation>Cues</translation>
    </message>
    <message>
        <source>Plot</source>
        <translation>Plan</translation>
    </message>
    <message>
        <source>In browsers</source>
        <translation>In Browsern</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>Panels</source>
        <translation>Fenster</translation>
    </message>
</context>
<context>
    <name>Parameter</name>
    <message>
        <source>Shutter</source>
        <translation>Shutter</translation>
    </message>
    <message>
        <source>Beam</source>
        <translation>Strahl</translation>
    </message>
    <message>
        <source>Gobo</source>
        <translation>Gobo</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Blades</source>
        <translation>Blendenschieber</translation>
    </message>
    <message>
        <source>Laser</source>
        <translation>Laser</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Machine</source>
        <translation>Maschine</translation>
    </message>
    <message>
        <source>Gobo wheel \1</source>
        <translation>Goborad \1</translation>
    </message>
    <message>
        <source>Gobo \1 turn</source>
        <translation>Gobo \1 Drehung</translation>
    </message>
    <message>
        <source>Prism \1</source>
        <translation>Prisma \1</translation>
    </message>
    <message>
        <source>Prism \1 turn</source>
        <translation>Prisma \1 Drehung</translation>
    </message>
    <message>
        <source>Colour wheel \1</source>
        <translation>Farbrad \1</translation>
    </message>
    <message>
        <source>Cyan</source>
        <translation>Cyan</translation>
    </message>
    <message>
        <source>Magenta</source>
        <translation>Magenta</translation>
    </message>
    <message>
        <source>Yellow</source>
        <translation>Gelb</translation>
    </message>
    <message>
        <source>Red</source>
        <translation>Rot</translation>
    </message>
    <message>
        <source>Green</source>
        <translation>Grün</translation>
    </message>
    <message>
        <source>Blue</source>
        <translation>Blau</translation>
    </message>
    <message>
        <source>White</source>
        <translation>Weiß</translation>
    </message>
    <message>
        <source>Warm white</source>
        <translation>Warmweiß</translation>
    </message>
    <message>
        <source>Cold white</source>
        <translation>Kaltweiß</translation>
    </message>
    <message>
        <source>Amber</source>
        <translation>Amber</translation>
    </message>
    <message>
        <source>Lime</source>
        <translation>Lime</translation>
    </message>
    <message>
        <source>UV</source>
        <translation>UV</translation>
    </message>
    <message>
        <source>CTO</source>
        <translation>CTO</translation>
    </message>
    <message>
        <source>White (CCT)</source>
        <translation>Weiß (CCT)</translation>
    </message>
    <message>
        <source>Frost \1</source>
        <translation>Frost \1</translation>
    </message>
    <message>
        <source>Focus</source>
        <translation>Fokus</translation>
    </message>
    <message>
        <source>Animation wheel</source>
        <translation>Animation</translation>
    </message>
    <message>
        <source>pan</source>
        <translation>Pan</translation>
    </message>
    <message>
        <source>tilt</source>
        <translation>Tilt</translation>
    </message>
    <message>
        <source>zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>a colour</source>
        <translation>eine Farbe</translation>
    </message>
    <message>
        <source>gobo %1</source>
        <translation>Gobo %1</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Offen</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>%1 to %2</source>
        <translation>%1 bis %2</translation>
    </message>
    <message>
        <source>Gobo wheel \1 spins</source>
        <translation>Goborad \1 dreht</translation>
    </message>
    <message>
        <source>Gobo wheel \1 turn</source>
        <translation>Goborad \1 Stellung</translation>
    </message>
    <message>
        <source>Gobo wheel \1 at random</source>
        <translation>Goborad \1 zufällig</translation>
    </message>
    <message>
        <source>Gobo \1, turning</source>
        <translation>Gobo \1, drehend</translation>
    </message>
    <message>
        <source>Gobo \1, shaking</source>
        <translation>Gobo \1, wackelnd</translation>
    </message>
    <message>
        <source>Colour wheel \1 spins</source>
        <translation>Farbrad \1 dreht</translation>
    </message>
    <message>
        <source>Colour wheel \1 turn</source>
        <translation>Farbrad \1 Stellung</translation>
    </message>
    <message>
        <source>Colour wheel \1 at random</source>
        <translation>Farbrad \1 zufällig</translation>
    </message>
    <message>
        <source>Animation wheel turn</source>
        <translation>Effektrad Stellung</translation>
    </message>
    <message>
        <source>No function</source>
        <translation>Ohne Funktion</translation>
    </message>
    <message>
        <source>a gobo</source>
        <translation>ein Gobo</translation>
    </message>
</context>
<context>
    <name>Picture</name>
    <message>
        <source>%1 up</source>
        <translation>%1 nach oben</translation>
    </message>
    <message>
        <source>%1 down</source>
        <translation>%1 nach unten</translation>
    </message>
    <message>
        <source>%1 along %2</source>
        <translation>%1 entlang %2</translation>
    </message>
    <message>
        <source>Cameras</source>
        <translation>Kameras</translation>
    </message>
    <message>
        <source>%1 lx, of which %2 bounced</source>
        <translation>%1 lx, davon %2 indirekt</translation>
    </message>
    <message>
        <source>%1, %2 m away</source>
        <translation>%1, %2 m entfernt</translation>
    </message>
    <message>
        <source>no surface</source>
        <translation>keine Fläche</translation>
    </message>
    <message>
        <source>no address</source>
        <translation>keine Adresse</translation>
    </message>
    <message>
        <source>no type</source>
        <translation>kein Typ</translation>
    </message>
    <message>
        <source>dark</source>
        <translation>dunkel</translation>
    </message>
    <message>
        <source>Picture of the stage</source>
        <translation>Bild der Bühne</translation>
    </message>
    <message>
        <source>No show is open</source>
        <translation>Keine Show ist offen</translation>
    </message>
    <message>
        <source>before</source>
        <translation>vorher</translation>
    </message>
    <message>
        <source>now</source>
        <translation>jetzt</translation>
    </message>
    <message>
        <source>The first picture is being drawn</source>
        <translation>Das erste Bild wird gezeichnet</translation>
    </message>
    <message>
        <source>A click goes there. F2: another name. The pictures are made while nothing moves.</source>
        <translation>Ein Klick geht dorthin. F2: anderer Name. Die Bilder entstehen, während sich nichts bewegt.</translation>
    </message>
    <message>
        <source>Go to this</source>
        <translation>Zu dieser</translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
</context>
<context>
    <name>Plot</name>
    <message>
        <source>Take what seems the same</source>
        <translation>Übernehmen, was gleich scheint</translation>
    </message>
    <message>
        <source>Select these</source>
        <translation>Diese auswählen</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Save as text...</source>
        <translation>Als Text sichern ...</translation>
    </message>
    <message>
        <source>What the plot has</source>
        <translation>Was der Plan enthält</translation>
    </message>
    <message>
        <source>Double click or Enter: the fixtures that it is about are selected.</source>
        <translation>Doppelklick oder Eingabe: Die Geräte, um die es geht, werden ausgewählt.</translation>
    </message>
    <message>
        <source>For each file the one whose name says that it is the same fixture</source>
        <translation>Für jede Datei die, deren Name sagt, dass es dasselbe Gerät ist</translation>
    </message>
    <message>
        <source>The fixtures that the chosen line is about, ringed in the picture</source>
        <translation>Die Geräte, um die es in der gewählten Zeile geht, im Bild eingekreist</translation>
    </message>
    <message>
        <source>All of it as text, for a mail</source>
        <translation>Alles als Text, für eine E-Mail</translation>
    </message>
    <message>
        <source>Stands in for %1</source>
        <translation>Ersatz für %1</translation>
    </message>
    <message>
        <source>%1, mode &apos;%2&apos;</source>
        <translation>%1, Modus &apos;%2&apos;</translation>
    </message>
    <message>
        <source>Choose a file...</source>
        <translation>Datei wählen ...</translation>
    </message>
    <message>
        <source>Take</source>
        <translation>Nehmen</translation>
    </message>
    <message>
        <source>Take it for %1</source>
        <translation>Nehmen für %1</translation>
    </message>
    <message>
        <source>A fixture that stands in</source>
        <translation>Ein Gerät als Ersatz</translation>
    </message>
    <message>
        <source>To do: %1</source>
        <translation>Zu tun: %1</translation>
    </message>
    <message>
        <source>What a plot has is listed here.</source>
        <translation>Hier steht, was ein Plan enthält.</translation>
    </message>
    <message>
        <source>%1: %2 missing, %3 guessed</source>
        <translation>%1: %2 fehlen, %3 geraten</translation>
    </message>
    <message>
        <source>%1 with a light that is assumed</source>
        <translation>%1 mit angenommenem Licht</translation>
    </message>
    <message>
        <source>%1 without light</source>
        <translation>%1 ohne Licht</translation>
    </message>
    <message>
        <source>%1 without light, %2 with one that is assumed</source>
        <translation>%1 ohne Licht, %2 mit angenommenem</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Fehlt</translation>
    </message>
    <message>
        <source>Guessed or repaired</source>
        <translation>Geraten oder repariert</translation>
    </message>
    <message>
        <source>Found</source>
        <translation>Gefunden</translation>
    </message>
    <message>
        <source>Odd, but nothing is lost</source>
        <translation>Seltsam, aber nichts ging verloren</translation>
    </message>
    <message>
        <source>Take what seems the same (%1)</source>
        <translation>Übernehmen, was gleich scheint (%1)</translation>
    </message>
    <message numerus="yes">
        <source>%n head(s)</source>
        <translation>
            <numerusform>%n Gerät</numerusform>
            <numerusform>%n Geräte</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n file(s) more</source>
        <translation>
            <numerusform>und %n weitere Datei</numerusform>
            <numerusform>und %n weitere Dateien</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Print</name>
    <message>
        <source>Paperwork</source>
        <translation>Unterlagen</translation>
    </message>
    <message>
        <source>Cue book</source>
        <translation>Cue-Buch</translation>
    </message>
    <message>
        <source>Folder to make</source>
        <translation>Ordner, der entsteht</translation>
    </message>
    <message>
        <source>Choose...</source>
        <translation>Wählen ...</translation>
    </message>
    <message>
        <source>Choose the folder</source>
        <translation>Ordner wählen</translation>
    </message>
    <message>
        <source>A folder to make</source>
        <translation>Ein Ordner, der entsteht</translation>
    </message>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>All tables as PDF</source>
        <translation>Alle Tabellen als PDF</translation>
    </message>
    <message>
        <source>As PDF</source>
        <translation>Als PDF</translation>
    </message>
    <message>
        <source>Page</source>
        <translation>Papier</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Make</source>
        <translation>Erstellen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Open in the browser</source>
        <translation>Im Browser öffnen</translation>
    </message>
    <message>
        <source>Open the folder</source>
        <translation>Ordner öffnen</translation>
    </message>
    <message>
        <source>Plan and section</source>
        <translation>Grundriss und Schnitt</translation>
    </message>
    <message>
        <source>Focus charts</source>
        <translation>Einleuchtplan</translation>
    </message>
    <message>
        <source>Scale</source>
        <translation>Maßstab</translation>
    </message>
    <message>
        <source>Largest that fits</source>
        <translation>Größter, der passt</translation>
    </message>
    <message>
        <source>Sheet of the plan</source>
        <translation>Blatt des Grundrisses</translation>
    </message>
    <message>
        <source>As the page asks</source>
        <translation>Wie das Papier</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>Sprache</translation>
    </message>
    <message>
        <source>Units</source>
        <translation>Einheiten</translation>
    </message>
    <message>
        <source>Metres, kilograms</source>
        <translation>Meter, Kilogramm</translation>
    </message>
    <message>
        <source>Feet, pounds</source>
        <translation>Fuß, Pfund</translation>
    </message>
    <message>
        <source>Sheet</source>
        <translation>Blatt</translation>
    </message>
    <message>
        <source>Entries</source>
        <translation>Einträge</translation>
    </message>
    <message>
        <source>Cues, else looks</source>
        <translation>Cues, sonst Looks</translation>
    </message>
    <message>
        <source>Cues</source>
        <translation>Cues</translation>
    </message>
    <message>
        <source>Looks</source>
        <translation>Looks</translation>
    </message>
    <message>
        <source>Where the recording rests</source>
        <translation>Wo die Aufzeichnung ruht</translation>
    </message>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>Size of pictures</source>
        <translation>Größe der Bilder</translation>
    </message>
    <message>
        <source>An older show, plot or book to compare with</source>
        <translation>Ältere Show, älterer Plan oder älteres Cue-Buch zum Vergleich</translation>
    </message>
    <message>
        <source>an older show, plot or book</source>
        <translation>ältere Show, Plan, Buch</translation>
    </message>
    <message>
        <source>Pictures</source>
        <translation>Bilder</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>Vergleichen mit</translation>
    </message>
    <message>
        <source>Pictures of the book</source>
        <translation>Bilder des Cue-Buchs</translation>
    </message>
    <message>
        <source>Table to look at</source>
        <translation>Tabelle zur Ansicht</translation>
    </message>
    <message>
        <source>Preview of the table</source>
        <translation>Vorschau der Tabelle</translation>
    </message>
    <message>
        <source>Where the cues put the picture</source>
        <translation>Wohin die Cues das Bild legen</translation>
    </message>
    <message>
        <source>Layout</source>
        <translation>Anordnung</translation>
    </message>
    <message>
        <source>Four on a page, with what changes</source>
        <translation>Vier je Seite, mit Änderungen</translation>
    </message>
    <message>
        <source>Marks in a CSV file</source>
        <translation>Marken in einer CSV-Datei</translation>
    </message>
    <message>
        <source>Marks</source>
        <translation>Marken</translation>
    </message>
    <message>
        <source>File of the marks</source>
        <translation>Datei der Marken</translation>
    </message>
    <message>
        <source>time, number, name, note</source>
        <translation>Zeit, Nummer, Name, Notiz</translation>
    </message>
    <message>
        <source>Choose the file of the marks</source>
        <translation>Datei der Marken wählen</translation>
    </message>
    <message>
        <source>The book is larger than what is shown here: open it in the browser.</source>
        <translation>Das Buch ist größer als das, was hier gezeigt wird: im Browser öffnen.</translation>
    </message>
    <message>
        <source>The book cannot be read: %1</source>
        <translation>Das Buch ist nicht lesbar: %1</translation>
    </message>
    <message>
        <source>Here are the first %1 rows; all are in the folder.</source>
        <translation>Hier stehen die ersten %1 Zeilen; alle sind im Ordner.</translation>
    </message>
    <message>
        <source>Here are the first %1 of %2 entries; all are in the folder.</source>
        <translation>Hier stehen die ersten %1 von %2 Einträgen; alle sind im Ordner.</translation>
    </message>
    <message>
        <source>What is left empty, and why</source>
        <translation>Was leer bleibt, und warum</translation>
    </message>
    <message>
        <source>Remarks</source>
        <translation>Anmerkungen</translation>
    </message>
    <message numerus="yes">
        <source>, with %n remark(s)</source>
        <translation>
            <numerusform>, mit %n Anmerkung</numerusform>
            <numerusform>, mit %n Anmerkungen</numerusform>
        </translation>
    </message>
    <message>
        <source>Say in which folder it is to lie.</source>
        <translation>Bitte den Ordner nennen, in dem es liegen soll.</translation>
    </message>
    <message>
        <source>Twelve on a page</source>
        <translation>Zwölf je Seite</translation>
    </message>
    <message>
        <source>Where the section is cut</source>
        <translation>Wo der Schnitt liegt</translation>
    </message>
    <message>
        <source>x in metres; empty: not cut</source>
        <translation>x in m; leer: kein Schnitt</translation>
    </message>
    <message>
        <source>Date in the title block</source>
        <translation>Datum im Schriftfeld</translation>
    </message>
    <message>
        <source>printed as it is</source>
        <translation>so gedruckt</translation>
    </message>
    <message>
        <source>Moment of the focus charts</source>
        <translation>Moment des Einleuchtplans</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>Schnitt</translation>
    </message>
    <message>
        <source>Date</source>
        <translation>Datum</translation>
    </message>
    <message>
        <source>Moment</source>
        <translation>Moment</translation>
    </message>
    <message>
        <source>Nothing is sent</source>
        <translation>Nichts wird gesendet</translation>
    </message>
    <message>
        <source>Cue %1</source>
        <translation>Cue %1</translation>
    </message>
    <message>
        <source>Look %1</source>
        <translation>Look %1</translation>
    </message>
    <message>
        <source>What is made is shown here.</source>
        <translation>Hier ist zu sehen, was gemacht wird.</translation>
    </message>
</context>
<context>
    <name>Programmer</name>
    <message>
        <source>Intensity</source>
        <translation>Intensität</translation>
    </message>
    <message>
        <source>Zoom</source>
        <translation>Zoom</translation>
    </message>
    <message>
        <source>Pan</source>
        <translation>Pan</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>Tilt</translation>
    </message>
    <message>
        <source>Gobo</source>
        <translation>Gobo</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Hold (H)</source>
        <translation>Halten (H)</translation>
    </message>
    <message>
        <source>What the desk asks of the selected fixtures stays, whatever it sends then</source>
        <translation>Was das Pult von den ausgewählten Geräten verlangt, bleibt, was immer es dann sendet</translation>
    </message>
    <message>
        <source>As the desk says</source>
        <translation>Wie das Pult es sagt</translation>
    </message>
    <message>
        <source>Select fixtures to light the scene by hand, with or without a desk.</source>
        <translation>Geräte auswählen, um die Szene von Hand zu beleuchten, mit oder ohne Pult.</translation>
    </message>
    <message>
        <source>Give back (R)</source>
        <translation>Freigeben (R)</translation>
    </message>
    <message>
        <source>What is set by hand of the selected fixtures</source>
        <translation>Was von den ausgewählten Geräten von Hand gesetzt ist</translation>
    </message>
    <message>
        <source>Give all back (Shift+R)</source>
        <translation>Alles freigeben (Umschalt+R)</translation>
    </message>
    <message>
        <source>All that is set by hand, whatever is selected: fixtures, scene, objects</source>
        <translation>Alles von Hand Gesetzte, was immer ausgewählt ist: Geräte, Szene, Objekte</translation>
    </message>
</context>
<context>
    <name>QAbstractFileIconProvider</name>
    <message>
        <source>Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>File</source>
        <translation>Datei</translation>
    </message>
    <message>
        <source>%1 File</source>
        <translation>%1-Datei</translation>
    </message>
</context>
<context>
    <name>QAbstractSpinBox</name>
    <message>
        <source>&amp;Select All</source>
        <translation>&amp;Alles auswählen</translation>
    </message>
    <message>
        <source>&amp;Step up</source>
        <translation>&amp;Höher</translation>
    </message>
    <message>
        <source>Step &amp;down</source>
        <translation>&amp;Niedriger</translation>
    </message>
</context>
<context>
    <name>QDockWidget</name>
    <message>
        <source>Float</source>
        <translation>Abreißen</translation>
    </message>
    <message>
        <source>Undocks and re-attaches the dock widget</source>
        <translation>Reißt das Fenster ab oder setzt es wieder ein</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Closes the dock widget</source>
        <translation>Schließt das Fenster</translation>
    </message>
</context>
<context>
    <name>QFileDialog</name>
    <message>
        <source>Look in:</source>
        <translation>Suchen in:</translation>
    </message>
    <message>
        <source>&amp;File name:</source>
        <translation>&amp;Dateiname:</translation>
    </message>
    <message>
        <source>File &amp;name:</source>
        <translation>Datei&amp;name:</translation>
    </message>
    <message>
        <source>File Folder</source>
        <translation>Ordner</translation>
    </message>
    <message>
        <source>Directory:</source>
        <translation>Ordner:</translation>
    </message>
    <message>
        <source>Files of type:</source>
        <translation>Dateityp:</translation>
    </message>
    <message>
        <source>&amp;Open</source>
        <translation>&amp;Öffnen</translation>
    </message>
    <message>
        <source>&amp;Save</source>
        <translation>&amp;Speichern</translation>
    </message>
    <message>
        <source>&amp;Choose</source>
        <translation>&amp;Wählen</translation>
    </message>
    <message>
        <source>&amp;Rename</source>
        <translation>&amp;Umbenennen</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>&amp;Löschen</translation>
    </message>
    <message>
        <source>&amp;New Folder</source>
        <translation>&amp;Neuer Ordner</translation>
    </message>
    <message>
        <source>New Folder</source>
        <translation>Neuer Ordner</translation>
    </message>
    <message>
        <source>Show &amp;hidden files</source>
        <translation>&amp;Verborgene Dateien zeigen</translation>
    </message>
    <message>
        <source>My Computer</source>
        <translation>Mein Computer</translation>
    </message>
    <message>
        <source>Recent Places</source>
        <translation>Zuletzt besucht</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Go back</source>
        <translation>Zurück</translation>
    </message>
    <message>
        <source>Alt+Left</source>
        <translation>Alt+Left</translation>
    </message>
    <message>
        <source>Forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Go forward</source>
        <translation>Vor</translation>
    </message>
    <message>
        <source>Parent Directory</source>
        <translation>Übergeordneter Ordner</translation>
    </message>
    <message>
        <source>Go to the parent directory</source>
        <translation>Zum übergeordneten Ordner</translation>
    </message>
    <message>
        <source>Create New Folder</source>
        <translation>Neuer Ordner</translation>
    </message>
    <message>
        <source>Create a New Folder</source>
        <translation>Neuen Ordner anlegen</translation>
    </message>
    <message>
        <source>List View</source>
        <translation>Liste</translation>
    </message>
    <message>
        <source>Change to list view mode</source>
        <translation>Als Liste zeigen</translation>
    </message>
    <message>
        <source>Detail View</source>
        <translation>Details</translation>
    </message>
    <message>
        <source>Change to detail view mode</source>
        <translation>Mit Details zeigen</translation>
    </message>
    <message>
        <source>%1 already exists.
Do you want to replace it?</source>
        <translation>%1 gibt es schon.
Ersetzen?</translation>
    </message>
    <message>
        <source>%1
File not found.
Please verify the correct file name was given.</source>
        <translation>%1
Datei nicht gefunden.
Bitte den Dateinamen prüfen.</translation>
    </message>
    <message>
        <source>%1
Directory not found.
Please verify the correct directory name was given.</source>
        <translation>%1
Ordner nicht gefunden.
Bitte den Namen des Ordners prüfen.</translation>
    </message>
</context>
<context>
    <name>QFileSystemModel</name>
    <message>
        <source>Computer</source>
        <translation>Computer</translation>
    </message>
    <message>
        <source>My Computer</source>
        <translation>Mein Computer</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>Größe</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>Typ</translation>
    </message>
    <message>
        <source>Date Modified</source>
        <translation>Geändert</translation>
    </message>
</context>
<context>
    <name>QLineEdit</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Alles auswählen</translation>
    </message>
</context>
<context>
    <name>QPlatformTheme</name>
    <message>
        <source>OK</source>
        <translation>OK</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Open</source>
        <translation>Öffnen</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>Speichern</translation>
    </message>
    <message>
        <source>&amp;Yes</source>
        <translation>&amp;Ja</translation>
    </message>
    <message>
        <source>&amp;No</source>
        <translation>&amp;Nein</translation>
    </message>
</context>
<context>
    <name>QShortcut</name>
    <message>
        <source>Ctrl</source>
        <translation>Strg</translation>
    </message>
    <message>
        <source>Shift</source>
        <translation>Umschalt</translation>
    </message>
    <message>
        <source>Alt</source>
        <translation>Alt</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>Leertaste</translation>
    </message>
    <message>
        <source>Esc</source>
        <translation>Esc</translation>
    </message>
    <message>
        <source>Del</source>
        <translation>Entf</translation>
    </message>
    <message>
        <source>Home</source>
        <translation>Pos1</translation>
    </message>
    <message>
        <source>PgUp</source>
        <translation>Bild auf</translation>
    </message>
    <message>
        <source>PgDown</source>
        <translation>Bild ab</translation>
    </message>
    <message>
        <source>Left</source>
        <translation>Links</translation>
    </message>
    <message>
        <source>Right</source>
        <translation>Rechts</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Down</source>
        <translation>Runter</translation>
    </message>
</context>
<context>
    <name>QWidgetTextControl</name>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Cu&amp;t</source>
        <translation>&amp;Ausschneiden</translation>
    </message>
    <message>
        <source>&amp;Copy</source>
        <translation>&amp;Kopieren</translation>
    </message>
    <message>
        <source>&amp;Paste</source>
        <translation>&amp;Einfügen</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>Löschen</translation>
    </message>
    <message>
        <source>Select All</source>
        <translation>Alles auswählen</translation>
    </message>
</context>
<context>
    <name>RDM</name>
    <message>
        <source>identifies itself</source>
        <translation>zeigt sich</translation>
    </message>
    <message>
        <source>is spoken to</source>
        <translation>wird angesprochen</translation>
    </message>
    <message>
        <source>is found</source>
        <translation>ist gefunden</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>, %1 not understood</source>
        <translation>, %1 nicht verstanden</translation>
    </message>
    <message>
        <source>, %1 refused</source>
        <translation>, %1 abgelehnt</translation>
    </message>
    <message>
        <source>%1 more</source>
        <translation>%1 weitere</translation>
    </message>
    <message numerus="yes">
        <source>; %1 identify themselves</source>
        <translation>
            <numerusform>; %1 zeigt sich</numerusform>
            <numerusform>; %1 zeigen sich</numerusform>
        </translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>desks find and read</source>
        <translation>Pulte finden und lesen</translation>
    </message>
    <message>
        <source>desks also set address, mode and name</source>
        <translation>Pulte setzen auch Adresse, Modus und Namen</translation>
    </message>
    <message>
        <source>Whether desks find the fixtures by RDM over Art-Net. What a desk sets is an edit of the show, which can be undone.</source>
        <translation>Ob Pulte die Geräte per RDM über Art-Net finden. Was ein Pult setzt, ist eine Änderung der Show und lässt sich rückgängig machen.</translation>
    </message>
    <message>
        <source>Fixtures as RDM devices</source>
        <translation>Geräte als RDM-Geräte</translation>
    </message>
    <message>
        <source>Fixture</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Is</source>
        <translation>Ist</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 fixtures were found by a desk, %n message(s)</source>
        <translation>
            <numerusform>%1 von %2 Geräten hat ein Pult gefunden, %n Nachricht</numerusform>
            <numerusform>%1 von %2 Geräten hat ein Pult gefunden, %n Nachrichten</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Scene</name>
    <message>
        <source>Smoke</source>
        <translation>Nebel</translation>
    </message>
    <message>
        <source>Even light</source>
        <translation>Grundlicht</translation>
    </message>
    <message>
        <source>Its colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Of the even light</source>
        <translation>Des Grundlichts</translation>
    </message>
    <message>
        <source>Constant</source>
        <translation>Konstant</translation>
    </message>
    <message>
        <source>Linear</source>
        <translation>Linear</translation>
    </message>
    <message>
        <source>Quadratic</source>
        <translation>Quadratisch</translation>
    </message>
    <message>
        <source>Light falls with 1 / (constant + linear d + quadratic d²); 0, 0, 1 is physics.</source>
        <translation>Licht fällt mit 1 / (konstant + linear d + quadratisch d²); 0, 0, 1 ist Physik.</translation>
    </message>
    <message>
        <source>Samples</source>
        <translation>Abtastung</translation>
    </message>
    <message>
        <source>Of the haze, along a ray through one beam. Fewer are faster.</source>
        <translation>Des Dunstes, entlang einem Sehstrahl durch einen Lichtstrahl. Weniger sind schneller.</translation>
    </message>
    <message>
        <source>Shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>Haze, wind and hazers of the show...</source>
        <translation>Dunst, Wind und Hazer ...</translation>
    </message>
    <message>
        <source>Hang the selected fixtures under it</source>
        <translation>Auswahl darunter hängen</translation>
    </message>
    <message>
        <source>Evenly along the truss or pipe that is chosen, with all its pieces; one alone where it is nearest</source>
        <translation>Gleichmäßig entlang der gewählten Traverse oder Stange mit allen ihren Teilen; eines allein an der nächsten Stelle</translation>
    </message>
    <message>
        <source>Specular</source>
        <translation>Glanz</translation>
    </message>
    <message>
        <source>Shininess</source>
        <translation>Schärfe</translation>
    </message>
    <message>
        <source>Search objects and materials</source>
        <translation>Objekte und Materialien suchen</translation>
    </message>
    <message>
        <source>Objects of the stage</source>
        <translation>Objekte der Bühne</translation>
    </message>
    <message>
        <source>Object</source>
        <translation>Objekt</translation>
    </message>
    <message>
        <source>Material</source>
        <translation>Material</translation>
    </message>
    <message>
        <source>Fly it on two hoists</source>
        <translation>An zwei Züge hängen</translation>
    </message>
    <message>
        <source>The truss with all its pieces and the fixtures under it; Movers above then drive it</source>
        <translation>Die Traverse mit allen ihren Teilen und den Geräten darunter; gefahren wird sie dann oben unter Bewegte Teile</translation>
    </message>
</context>
<context>
    <name>Sentence</name>
    <message>
        <source>no show is open</source>
        <translation>keine Show ist offen</translation>
    </message>
    <message>
        <source>lit: %1</source>
        <translation>leuchtet: %1</translation>
    </message>
    <message>
        <source>dark because %1</source>
        <translation>dunkel, weil: %1</translation>
    </message>
    <message>
        <source>nearly dark (%1 of its light) because %2</source>
        <translation>fast dunkel (%1 seines Lichts), weil: %2</translation>
    </message>
    <message>
        <source>not seen because %1</source>
        <translation>nicht zu sehen, weil: %1</translation>
    </message>
    <message>
        <source>%1 of %2 beams, the brightest &apos;%3&apos;: %4</source>
        <translation>%1 von %2 Strahlen, der hellste &apos;%3&apos;: %4</translation>
    </message>
    <message>
        <source>%1 of %2 lm, %3, it glows and throws no beam</source>
        <translation>%1 von %2 lm, %3, es glimmt und wirft keinen Strahl</translation>
    </message>
    <message>
        <source>%1 of %2 lm, %3, what it hits is not known (no stage)</source>
        <translation>%1 von %2 lm, %3, was er trifft, ist nicht bekannt (keine Bühne)</translation>
    </message>
    <message>
        <source>%1 of %2 lm, %3, hits &apos;%4&apos; at %5 m with %6 lx</source>
        <translation>%1 von %2 lm, %3, trifft &apos;%4&apos; in %5 m mit %6 lx</translation>
    </message>
    <message>
        <source>%1 of %2 lm, %3, its middle hits nothing, its edge &apos;%4&apos;</source>
        <translation>%1 von %2 lm, %3, die Mitte trifft nichts, der Rand &apos;%4&apos;</translation>
    </message>
    <message>
        <source>%1 of %2 lm, %3, hits nothing: it leaves the stage %4</source>
        <translation>%1 von %2 lm, %3, trifft nichts: verlässt die Bühne %4</translation>
    </message>
    <message>
        <source>beam %1 deg, cut to %2 x %3 deg</source>
        <translation>Strahl %1°, beschnitten auf %2 x %3°</translation>
    </message>
    <message>
        <source>beam %1 deg</source>
        <translation>Strahl %1°</translation>
    </message>
    <message>
        <source>picture %1 x %2 deg</source>
        <translation>Bild %1 x %2°</translation>
    </message>
    <message>
        <source>level</source>
        <translation>waagerecht</translation>
    </message>
    <message>
        <source>%1 degrees upwards</source>
        <translation>%1 Grad nach oben</translation>
    </message>
    <message>
        <source>%1 degrees downwards</source>
        <translation>%1 Grad nach unten</translation>
    </message>
    <message>
        <source>mode &apos;%1&apos; has no Beam geometry: nothing in it can shine</source>
        <translation>der Modus &apos;%1&apos; hat keine Beam-Geometrie: nichts darin kann leuchten</translation>
    </message>
    <message>
        <source>it gives %1 lm, less than 1 % of the brightest fixture (%2 lm)</source>
        <translation>es gibt %1 lm, weniger als 1 % des hellsten Geräts (%2 lm)</translation>
    </message>
    <message>
        <source>%1 of %2 lm, %3, what it hits is not known (nobody says its place)</source>
        <translation>%1 von %2 lm, %3, was es trifft, ist nicht bekannt (niemand nennt seinen Ort)</translation>
    </message>
    <message>
        <source>%1 of %2 lm, %3, what it hits is not known (nobody says how it is turned)</source>
        <translation>%1 von %2 lm, %3, was es trifft, ist nicht bekannt (niemand sagt, wie es gedreht ist)</translation>
    </message>
    <message>
        <source>no mode of its type is chosen: give it one (Mode in the list of fixtures, or mode = in the show file); what follows is of mode &apos;%1&apos;; %2</source>
        <translation>kein Modus seines Typs ist gewählt: gib ihm einen (Modus in der Geräteliste, oder in der Show-Datei); was folgt, ist von Modus &apos;%1&apos;; %2</translation>
    </message>
    <message>
        <source>no mode of its type is chosen: give it one (Mode in the list of fixtures, or mode = in the show file); what follows is of mode &apos;%1&apos;</source>
        <translation>kein Modus seines Typs ist gewählt: gib ihm einen (Modus in der Geräteliste, oder in der Show-Datei); was folgt, ist von Modus &apos;%1&apos;</translation>
    </message>
    <message>
        <source>nobody says a place that can be used: where its beam comes from and what it hits is not known</source>
        <translation>niemand nennt einen brauchbaren Ort: woher sein Strahl kommt und was er trifft, ist nicht bekannt</translation>
    </message>
    <message>
        <source>nobody says how it is turned: where its beam goes and what it hits is not known</source>
        <translation>niemand sagt, wie es gedreht ist: wohin sein Strahl geht und was er trifft, ist nicht bekannt</translation>
    </message>
    <message>
        <source>its address cannot be read: without an address its channels keep their defaults, and %1</source>
        <translation>seine Adresse ist nicht lesbar: ohne Adresse behalten seine Kanäle ihre Grundwerte, und %1</translation>
    </message>
    <message>
        <source>its address cannot be read: without an address its channels keep their defaults</source>
        <translation>seine Adresse ist nicht lesbar: ohne Adresse behalten seine Kanäle ihre Grundwerte</translation>
    </message>
    <message>
        <source>its address cannot be read (break %1): without an address its channels keep their defaults, and %2</source>
        <translation>seine Adresse ist nicht lesbar (Break %1): ohne Adresse behalten seine Kanäle ihre Grundwerte, und %2</translation>
    </message>
    <message>
        <source>its address cannot be read (break %1): without an address its channels keep their defaults</source>
        <translation>seine Adresse ist nicht lesbar (Break %1): ohne Adresse behalten seine Kanäle ihre Grundwerte</translation>
    </message>
    <message>
        <source>no mode of their type is chosen</source>
        <translation>kein Modus ihres Typs ist gewählt</translation>
    </message>
    <message>
        <source>nobody says where they hang, or how they are turned</source>
        <translation>niemand sagt, wo sie hängen oder wie sie gedreht sind</translation>
    </message>
    <message>
        <source>their address cannot be read</source>
        <translation>ihre Adresse ist nicht lesbar</translation>
    </message>
    <message>
        <source>its mode is not in the file: %1</source>
        <translation>sein Modus fehlt in der Datei: %1</translation>
    </message>
    <message>
        <source>the show names no fixture file for it (gdtf = ...)</source>
        <translation>die Show nennt keine Gerätedatei dafür (gdtf = ...)</translation>
    </message>
    <message>
        <source>its fixture file %1 is missing or cannot be read: %2</source>
        <translation>seine Gerätedatei %1 fehlt oder ist nicht lesbar: %2</translation>
    </message>
    <message>
        <source>its fixture file %1 is missing or cannot be read</source>
        <translation>seine Gerätedatei %1 fehlt oder ist nicht lesbar</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has the same address and does the same</source>
        <translation>&apos;%1&apos; hat dieselbe Adresse und tut dasselbe</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, another kind of fixture, has the same address %2</source>
        <translation>&apos;%1&apos;, ein anderer Gerätetyp, hat dieselbe Adresse %2</translation>
    </message>
    <message>
        <source>it (%1 channels from %2) and &apos;%3&apos; (%4 channels from %5) read common channels: a mode of the wrong length, or a wrong address; %6</source>
        <translation>es (%1 Kanäle ab %2) und &apos;%3&apos; (%4 Kanäle ab %5) lesen gemeinsame Kanäle: ein Modus falscher Länge oder eine falsche Adresse; %6</translation>
    </message>
    <message>
        <source>it (%1 channels from %2) and &apos;%3&apos; (%4 channels from %5) read common channels: a mode of the wrong length, or a wrong address</source>
        <translation>es (%1 Kanäle ab %2) und &apos;%3&apos; (%4 Kanäle ab %5) lesen gemeinsame Kanäle: ein Modus falscher Länge oder eine falsche Adresse</translation>
    </message>
    <message>
        <source>it is not patched: without an address its channels keep their defaults, and %1</source>
        <translation>es ist nicht gepatcht: ohne Adresse behalten seine Kanäle ihre Grundwerte, und %1</translation>
    </message>
    <message>
        <source>it is not patched: without an address its channels keep their defaults</source>
        <translation>es ist nicht gepatcht: ohne Adresse behalten seine Kanäle ihre Grundwerte</translation>
    </message>
    <message>
        <source>it is not patched (break %1): without an address its channels keep their defaults, and %2</source>
        <translation>es ist nicht gepatcht (Break %1): ohne Adresse behalten seine Kanäle ihre Grundwerte, und %2</translation>
    </message>
    <message>
        <source>it is not patched (break %1): without an address its channels keep their defaults</source>
        <translation>es ist nicht gepatcht (Break %1): ohne Adresse behalten seine Kanäle ihre Grundwerte</translation>
    </message>
    <message>
        <source>there is no DMX: the show has no recording and no desk is listened to; all channels keep their defaults, and %1</source>
        <translation>es gibt kein DMX: Die Show hat keine Aufzeichnung, und auf kein Pult wird gehört; alle Kanäle behalten ihre Grundwerte, und %1</translation>
    </message>
    <message>
        <source>there is no DMX: the show has no recording and no desk is listened to; all channels keep their defaults</source>
        <translation>es gibt kein DMX: Die Show hat keine Aufzeichnung, und auf kein Pult wird gehört; alle Kanäle behalten ihre Grundwerte</translation>
    </message>
    <message>
        <source>%1; its channels keep their defaults, and %2</source>
        <translation>%1; seine Kanäle behalten ihre Grundwerte, und %2</translation>
    </message>
    <message>
        <source>%1; its channels keep their defaults</source>
        <translation>%1; seine Kanäle behalten ihre Grundwerte</translation>
    </message>
    <message>
        <source>universe %1 begins in the recording at %2 s, this is %3 s</source>
        <translation>Universum %1 beginnt in der Aufzeichnung bei %2 s, jetzt sind es %3 s</translation>
    </message>
    <message>
        <source>universe %1 is not in the recording, which has %2</source>
        <translation>Universum %1 ist nicht in der Aufzeichnung; sie hat %2</translation>
    </message>
    <message>
        <source>universe %1 never arrived in %2 s; what arrives is %3</source>
        <translation>Universum %1 kam in %2 s nie an; an kommt %3</translation>
    </message>
    <message>
        <source>universe %1 never arrived in %2 s, nor did any packet</source>
        <translation>Universum %1 kam in %2 s nie an, und auch sonst kein Paket</translation>
    </message>
    <message>
        <source>universe %1 never arrived in %2 s: %3</source>
        <translation>Universum %1 kam in %2 s nie an: %3</translation>
    </message>
    <message>
        <source>universe %1 never arrived in %2 s</source>
        <translation>Universum %1 kam in %2 s nie an</translation>
    </message>
    <message>
        <source>universe %1 is lost: its last packet came %2 s ago and its last look is held, and %3</source>
        <translation>Universum %1 ist verloren: Sein letztes Paket kam vor %2 s, das letzte Bild wird gehalten, und %3</translation>
    </message>
    <message>
        <source>universe %1 is lost: its last packet came %2 s ago and its last look is held</source>
        <translation>Universum %1 ist verloren: Sein letztes Paket kam vor %2 s, das letzte Bild wird gehalten</translation>
    </message>
    <message>
        <source>the dimmer on %1 of function %2, that is %3; so is %4</source>
        <translation>der Dimmer auf %1 mit Funktion %2, das ist %3; ebenso %4</translation>
    </message>
    <message>
        <source>the dimmer on %1 of function %2, that is %3; so are %4</source>
        <translation>der Dimmer auf %1 mit Funktion %2, das ist %3; ebenso %4</translation>
    </message>
    <message>
        <source>the dimmer on %1 of function %2, that is %3</source>
        <translation>der Dimmer auf %1 mit Funktion %2, das ist %3</translation>
    </message>
    <message>
        <source>the dimmer (%1) is still on its way: it gives %2, asked is %3</source>
        <translation>der Dimmer (%1) ist noch unterwegs: er gibt %2, verlangt ist %3</translation>
    </message>
    <message>
        <source>all dimmers together (%1) give %2</source>
        <translation>alle Dimmer zusammen (%1) geben %2</translation>
    </message>
    <message>
        <source>its dimmer is %1: it has no DMX channel, the desk works it into %2</source>
        <translation>sein Dimmer ist %1: Er hat keinen DMX-Kanal, das Pult rechnet ihn in %2 ein</translation>
    </message>
    <message>
        <source>the shutter is closed</source>
        <translation>der Shutter ist zu</translation>
    </message>
    <message>
        <source>the shutter function %1 is active on %2, value %3</source>
        <translation>die Shutter-Funktion %1 ist aktiv auf %2, Wert %3</translation>
    </message>
    <message>
        <source>the shutter function %1 is active on %2, default %3</source>
        <translation>die Shutter-Funktion %1 ist aktiv auf %2, Grundwert %3</translation>
    </message>
    <message>
        <source>its strobe is between two flashes at this moment: function %1 on %2, value %3, flashes %4 times a second</source>
        <translation>sein Strobe ist gerade zwischen zwei Blitzen: Funktion %1 auf %2, Wert %3, blitzt %4-mal pro Sekunde</translation>
    </message>
    <message>
        <source>its strobe is between two flashes at this moment</source>
        <translation>sein Strobe ist gerade zwischen zwei Blitzen</translation>
    </message>
    <message>
        <source>%1 let only %2 of the light through</source>
        <translation>%1 lassen nur %2 des Lichts durch</translation>
    </message>
    <message>
        <source>%1 lets only %2 of the light through</source>
        <translation>%1 lässt nur %2 des Lichts durch</translation>
    </message>
    <message>
        <source>the framing blades (%1) let only %2 of what the iris leaves through</source>
        <translation>die Blenden (%1) lassen nur %2 von dem durch, was die Iris übrig lässt</translation>
    </message>
    <message>
        <source>the framing blades (%1) let only %2 of the light through</source>
        <translation>die Blenden (%1) lassen nur %2 des Lichts durch</translation>
    </message>
    <message>
        <source>the animation wheel lets only %1 of the light through (%2)</source>
        <translation>das Animationsrad lässt nur %1 des Lichts durch (%2)</translation>
    </message>
    <message>
        <source>the animation wheel</source>
        <translation>das Animationsrad</translation>
    </message>
    <message>
        <source>gobo wheel &apos;%1&apos; stands at &apos;%2&apos; and lets only %3 of the light through (%4)</source>
        <translation>das Goborad &apos;%1&apos; steht auf &apos;%2&apos; und lässt nur %3 des Lichts durch (%4)</translation>
    </message>
    <message>
        <source>gobo wheel &apos;%1&apos; stands at &apos;%2&apos; and lets only %3 of the light through</source>
        <translation>das Goborad &apos;%1&apos; steht auf &apos;%2&apos; und lässt nur %3 des Lichts durch</translation>
    </message>
    <message>
        <source>gobo wheel &apos;%1&apos; stands between &apos;%2&apos; and &apos;%3&apos; and lets only %4 of the light through (%5)</source>
        <translation>das Goborad &apos;%1&apos; steht zwischen &apos;%2&apos; und &apos;%3&apos; und lässt nur %4 des Lichts durch (%5)</translation>
    </message>
    <message>
        <source>its file gives the lamp 0 lumens</source>
        <translation>seine Datei gibt der Lampe 0 Lumen</translation>
    </message>
    <message>
        <source>the lamp is told to go off: function %1 on %2, value %3 (in the picture it burns)</source>
        <translation>die Lampe soll ausgehen: Funktion %1 auf %2, Wert %3 (im Bild brennt sie)</translation>
    </message>
    <message>
        <source>the lamp is told to go off: function %1 on %2, value %3</source>
        <translation>die Lampe soll ausgehen: Funktion %1 auf %2, Wert %3</translation>
    </message>
    <message>
        <source>its lamp gives %1: it is off, or was struck less than a minute ago</source>
        <translation>seine Lampe gibt %1: Sie ist aus oder wurde vor weniger als einer Minute gezündet</translation>
    </message>
    <message>
        <source>the iris is closed to %1 of the beam&apos;s width: %2</source>
        <translation>die Iris ist auf %1 der Strahlbreite geschlossen: %2</translation>
    </message>
    <message>
        <source>the iris is closed to %1 of the beam&apos;s width</source>
        <translation>die Iris ist auf %1 der Strahlbreite geschlossen</translation>
    </message>
    <message>
        <source>the picture that it projects is black at this moment: of white it has %1</source>
        <translation>das projizierte Bild ist gerade schwarz: von Weiß hat es %1</translation>
    </message>
    <message>
        <source>all its colours are at 0: an LED needs colour as well as its dimmer (%1)</source>
        <translation>alle seine Farben stehen auf 0: Eine LED braucht außer dem Dimmer auch Farbe (%1)</translation>
    </message>
    <message>
        <source>its colour is at 0: an LED needs colour as well as its dimmer (%1)</source>
        <translation>seine Farbe steht auf 0: Eine LED braucht außer dem Dimmer auch Farbe (%1)</translation>
    </message>
    <message>
        <source>its lens is inside of &apos;%1&apos; and lights only that, from within</source>
        <translation>seine Linse ist in &apos;%1&apos; und beleuchtet nur das, von innen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is right before its lens (%2 cm) and stops the light</source>
        <translation>&apos;%1&apos; ist direkt vor seiner Linse (%2 cm) und hält das Licht auf</translation>
    </message>
    <message>
        <source>it points %1 and away from everything; only its beam in the haze is seen</source>
        <translation>es zeigt %1 und von allem weg; nur sein Strahl im Dunst ist zu sehen</translation>
    </message>
    <message>
        <source>it points %1 and away from everything; there is no haze to show its beam</source>
        <translation>es zeigt %1 und von allem weg; kein Dunst zeigt seinen Strahl</translation>
    </message>
    <message>
        <source>%1 leaves %2 of %3 lm</source>
        <translation>%1 lassen %2 von %3 lm</translation>
    </message>
    <message>
        <source>channel %1</source>
        <translation>Kanal %1</translation>
    </message>
    <message>
        <source>the virtual channel &apos;%1&apos;</source>
        <translation>der virtuelle Kanal &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the other channels</source>
        <translation>die anderen Kanäle</translation>
    </message>
    <message>
        <source>slot %1 &apos;%2&apos; of &apos;%3&apos;</source>
        <translation>Platz %1 &apos;%2&apos; von &apos;%3&apos;</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nichts</translation>
    </message>
    <message>
        <source>universe %1</source>
        <translation>Universum %1</translation>
    </message>
    <message>
        <source>universes %1</source>
        <translation>Universen %1</translation>
    </message>
    <message>
        <source>their fixture file is missing or cannot be read</source>
        <translation>Gerätedatei fehlt oder ist nicht lesbar</translation>
    </message>
    <message>
        <source>another fixture has their address</source>
        <translation>ein anderes Gerät hat ihre Adresse</translation>
    </message>
    <message>
        <source>another fixture begins inside of them</source>
        <translation>ein anderes Gerät beginnt in ihrem Bereich</translation>
    </message>
    <message>
        <source>several things together dim them</source>
        <translation>mehreres zusammen dimmt sie</translation>
    </message>
    <message>
        <source>their file has no Beam geometry</source>
        <translation>ihre Datei hat keine Beam-Geometrie</translation>
    </message>
    <message>
        <source>they are faint next to the brightest fixture</source>
        <translation>schwach neben dem hellsten Gerät</translation>
    </message>
    <message>
        <source>their mode is not in the fixture file</source>
        <translation>ihr Modus fehlt in der Gerätedatei</translation>
    </message>
    <message>
        <source>their dimmer is at 0</source>
        <translation>Dimmer auf 0</translation>
    </message>
    <message>
        <source>their dimmer is nearly at 0</source>
        <translation>Dimmer fast auf 0</translation>
    </message>
    <message>
        <source>their dimmer is still on its way</source>
        <translation>Dimmer noch unterwegs</translation>
    </message>
    <message>
        <source>their dimmer is virtual</source>
        <translation>Dimmer virtuell</translation>
    </message>
    <message>
        <source>their shutter is closed</source>
        <translation>Shutter zu</translation>
    </message>
    <message>
        <source>their strobe is between two flashes</source>
        <translation>Strobe zwischen zwei Blitzen</translation>
    </message>
    <message>
        <source>their colours let next to nothing through</source>
        <translation>Farben lassen fast nichts durch</translation>
    </message>
    <message>
        <source>their framing blades let next to nothing through</source>
        <translation>Blenden lassen fast nichts durch</translation>
    </message>
    <message>
        <source>their animation wheel lets next to nothing through</source>
        <translation>Animationsrad lässt fast nichts durch</translation>
    </message>
    <message>
        <source>their gobo lets next to nothing through</source>
        <translation>Gobo lässt fast nichts durch</translation>
    </message>
    <message>
        <source>their zoom gives no beam</source>
        <translation>Zoom ergibt keinen Strahl</translation>
    </message>
    <message>
        <source>their lamp has 0 lumens</source>
        <translation>Lampe mit 0 Lumen</translation>
    </message>
    <message>
        <source>their lamp is off</source>
        <translation>Lampe aus</translation>
    </message>
    <message>
        <source>their iris is closed</source>
        <translation>Iris zu</translation>
    </message>
    <message>
        <source>their picture is black</source>
        <translation>Bild schwarz</translation>
    </message>
    <message>
        <source>their colours are all at 0</source>
        <translation>alle Farben auf 0</translation>
    </message>
    <message>
        <source>they are inside of an object</source>
        <translation>in einem Objekt</translation>
    </message>
    <message>
        <source>an object is right before their lens</source>
        <translation>ein Objekt direkt vor der Linse</translation>
    </message>
    <message>
        <source>they point away from everything</source>
        <translation>zeigen von allem weg</translation>
    </message>
    <message>
        <source>they are not patched</source>
        <translation>nicht gepatcht</translation>
    </message>
    <message>
        <source>there is no DMX</source>
        <translation>kein DMX</translation>
    </message>
    <message>
        <source>their universe %1 never arrived</source>
        <translation>ihr Universum %1 kam nie an</translation>
    </message>
    <message>
        <source>their universe %1 is lost</source>
        <translation>ihr Universum %1 ist verloren</translation>
    </message>
    <message>
        <source>nobody holds their channels</source>
        <translation>niemand hält ihre Kanäle</translation>
    </message>
    <message>
        <source>a source of higher priority overrides another</source>
        <translation>eine Quelle höherer Priorität verdrängt eine andere</translation>
    </message>
    <message>
        <source>two sources of equal priority send different things</source>
        <translation>zwei Quellen gleicher Priorität senden Verschiedenes</translation>
    </message>
    <message>
        <source>the interface %1 is down or gone: nothing is heard until it is back</source>
        <translation>die Schnittstelle %1 ist aus oder weg: bis sie zurück ist, ist nichts zu hören</translation>
    </message>
    <message>
        <source>no network interface is up: only a desk on this machine, by unicast to 127.0.0.1, can be heard</source>
        <translation>keine Netzwerkschnittstelle ist aktiv: nur ein Pult auf diesem Rechner, per Unicast an 127.0.0.1, ist zu hören</translation>
    </message>
    <message>
        <source>%1 has no cable, or what is at its other end is off</source>
        <translation>%1 hat kein Kabel, oder die Gegenseite ist aus</translation>
    </message>
    <message>
        <source>nothing arrives: is the desk&apos;s output on, is it in this network, and is no firewall on UDP %1 in the way? We listen on %2</source>
        <translation>nichts kommt an: Ist die Ausgabe des Pults an, ist es in diesem Netzwerk, und ist keine Firewall auf UDP %1 im Weg? Gehört wird auf %2</translation>
    </message>
    <message>
        <source>no levels arrive, though %1: is the desk&apos;s output on, is it in this network, and is no firewall on UDP %2 in the way? We listen on %3</source>
        <translation>keine Werte kommen an, obwohl %1: Ist die Ausgabe des Pults an, ist es in diesem Netzwerk, und ist keine Firewall auf UDP %2 im Weg? Gehört wird auf %3</translation>
    </message>
    <message>
        <source>no levels arrive, though %1: is the desk&apos;s output on, is it in this network, does it send to a universe of ours? We listen on %2</source>
        <translation>keine Werte kommen an, obwohl %1: Ist die Ausgabe des Pults an, ist es in diesem Netzwerk, sendet es an ein Universum von uns? Gehört wird auf %2</translation>
    </message>
    <message>
        <source>packets arrive, and none of them can be read as levels: %1. If they are the desk&apos;s, it has to be mended; if not: is its output on, and is it in this network? We listen on %2</source>
        <translation>Pakete kommen an, aber keines ist als Werte lesbar: %1. Kommen sie vom Pult, liegt der Fehler dort; wenn nicht: Ist seine Ausgabe an, und ist es in diesem Netzwerk? Gehört wird auf %2</translation>
    </message>
    <message>
        <source>the port %1 of %2 is taken by %3, too: of two programs only the one started last gets a desk&apos;s unicast. Close the other one, or start again with --interface and an address of this machine</source>
        <translation>den Port %1 von %2 hat auch %3: Von zwei Programmen bekommt nur das zuletzt gestartete den Unicast eines Pults. Das andere schließen oder mit --interface und einer Adresse dieses Rechners neu starten</translation>
    </message>
    <message>
        <source>%1 runs on this machine: if it is the desk, its multicast does not come back here (QLC+ switches that off): have it send unicast to 127.0.0.1</source>
        <translation>%1 läuft auf diesem Rechner: Wenn es das Pult ist, kommt sein Multicast hier nicht zurück (QLC+ schaltet das ab): dort Unicast an 127.0.0.1 einstellen</translation>
    </message>
    <message>
        <source>%1 sends %2, but it comes in on %3, and we listen on %4 only: start with --interface %5, or without --interface</source>
        <translation>%1 sendet %2, aber es kommt auf %3 an, und gehört wird nur auf %4: mit --interface %5 starten oder ohne --interface</translation>
    </message>
    <message>
        <source>%1 announces %2, and none of it arrives here: either it sends them by unicast to other addresses than ours (its output page says so), or a switch holds this multicast back (IGMP snooping without a querier): unicast to %3 gets past both; or it announces what it does not send (its output is off)</source>
        <translation>%1 meldet %2, und nichts davon kommt hier an: entweder sendet es per Unicast an andere Adressen als unsere (seine Ausgangsseite sagt es), oder ein Switch hält dieses Multicast zurück (IGMP-Snooping ohne Querier): Unicast an %3 kommt an beidem vorbei; oder es meldet, was es nicht sendet (sein Ausgang ist aus)</translation>
    </message>
    <message>
        <source>off by one? %1 comes for %2, fixtures are on %3: %4</source>
        <translation>um eins verschoben? %1 kommt für %2, Geräte liegen auf %3: %4</translation>
    </message>
    <message>
        <source>off by one? %1 is announced for %2 by %3, fixtures are on %4: %5</source>
        <translation>um eins verschoben? %1 ist für %2 von %3 gemeldet, Geräte liegen auf %4: %5</translation>
    </message>
    <message>
        <source>--artnet-offset %1 brings them together</source>
        <translation>--artnet-offset %1 bringt sie zusammen</translation>
    </message>
    <message>
        <source>move the desk&apos;s output or the show&apos;s patch by one</source>
        <translation>die Ausgabe des Pults oder den Patch der Show um eins verschieben</translation>
    </message>
    <message>
        <source>%1. If that is another system&apos;s (another hall, somebody&apos;s list), this show&apos;s desk is silent or does not get here: its output, the network, a firewall on UDP 5568 and 6454</source>
        <translation>%1. Wenn das einer anderen Anlage gehört (andere Halle, jemandes Liste), schweigt das Pult dieser Show oder kommt nicht an: sein Ausgang, das Netz, eine Firewall auf UDP 5568 und 6454</translation>
    </message>
    <message>
        <source>packets for %1 arrive (%2), nothing is patched there; the show wants %3</source>
        <translation>Pakete für %1 kommen an (%2), dort ist nichts gepatcht; die Show will %3</translation>
    </message>
    <message>
        <source>packets for %1 arrive (%2), nothing is patched there</source>
        <translation>Pakete für %1 kommen an (%2), dort ist nichts gepatcht</translation>
    </message>
    <message>
        <source>%1 fixtures on %2 (&apos;%3&apos;, ...), no levels arrive there</source>
        <translation>%1 Geräte auf %2 (&apos;%3&apos;, ...), dort kommen keine Werte an</translation>
    </message>
    <message>
        <source>%1 fixture on %2 (&apos;%3&apos;), no levels arrive there</source>
        <translation>%1 Gerät auf %2 (&apos;%3&apos;), dort kommen keine Werte an</translation>
    </message>
    <message>
        <source>%1; packets arrive that cannot be read (%2)</source>
        <translation>%1; es kommen Pakete an, die nicht zu lesen sind (%2)</translation>
    </message>
    <message>
        <source>nothing comes for %1 any more, since %2: black (--on-loss). Packets arrive that cannot be read (%3): if they are its desk&apos;s, that has to be mended</source>
        <translation>für %1 kommt seit %2 nichts mehr: schwarz (--on-loss). Es kommen Pakete an, die nicht zu lesen sind (%3): sind es die seines Pults, muss das in Ordnung gebracht werden</translation>
    </message>
    <message>
        <source>nothing comes for %1 any more, since %2: the last look is held. Packets arrive that cannot be read (%3): if they are its desk&apos;s, that has to be mended</source>
        <translation>für %1 kommt seit %2 nichts mehr: das letzte Bild wird gehalten. Es kommen Pakete an, die nicht zu lesen sind (%3): sind es die seines Pults, muss das in Ordnung gebracht werden</translation>
    </message>
    <message>
        <source>most packets of %1 on %2 come after a gap in their numbers: it counts several universes in one row, or as many get lost on the way</source>
        <translation>die meisten Pakete von %1 auf %2 kommen nach einer Lücke in ihren Nummern: es zählt mehrere Universen in einer Reihe, oder so viele gehen unterwegs verloren</translation>
    </message>
    <message>
        <source>packets of %1 on %2 come in another order than they were sent (two paths, Wi-Fi): %3 of %4 a second are late and dropped</source>
        <translation>Pakete von %1 auf %2 kommen in anderer Reihenfolge, als sie gesendet wurden (zwei Wege, WLAN): %3 von %4 in der Sekunde sind verspätet und werden verworfen</translation>
    </message>
    <message>
        <source>%1. By %2 only programs of this machine are heard (--interface)</source>
        <translation>%1. Über %2 sind nur Programme dieses Rechners zu hören (--interface)</translation>
    </message>
    <message>
        <source>%1. Somebody asks who wants Art-Net (ArtPoll) and is answered: where that is the desk, a firewall of its machine on UDP 6454 may keep our answer from it, or it has no output for our universes</source>
        <translation>%1. Jemand fragt, wer Art-Net will (ArtPoll), und bekommt Antwort: Ist es das Pult, so hält vielleicht eine Firewall seines Rechners auf UDP 6454 unsere Antwort von ihm fern, oder es hat keinen Ausgang für unsere Universen</translation>
    </message>
    <message>
        <source>%1 comes from more than one source of equal priority, %2, and they differ on up to %3: %4. %5 is silent, and counts until %6 have gone by</source>
        <translation>%1 kommt von mehr als einer Quelle gleicher Priorität, %2, und sie unterscheiden sich um bis zu %3: %4. %5 schweigt und zählt, bis %6 vergangen sind</translation>
    </message>
    <message>
        <source>%1 come from more than one source of equal priority, %2, and they differ on up to %3: %4. %5 is silent, and counts until %6 have gone by</source>
        <translation>%1 kommen von mehr als einer Quelle gleicher Priorität, %2, und sie unterscheiden sich um bis zu %3: %4. %5 schweigt und zählt, bis %6 vergangen sind</translation>
    </message>
    <message>
        <source>%1. Art-Net is not listened for (--protocols)</source>
        <translation>%1. Auf Art-Net wird nicht gehört (--protocols)</translation>
    </message>
    <message>
        <source>%1. sACN is not listened for (--protocols)</source>
        <translation>%1. Auf sACN wird nicht gehört (--protocols)</translation>
    </message>
    <message>
        <source>%1. Somebody asks who wants Art-Net (ArtPoll) and gets no answer (--no-poll-reply): OLA and some desks send to those alone that answer</source>
        <translation>%1. Jemand fragt, wer Art-Net will (ArtPoll), und bekommt keine Antwort (--no-poll-reply): OLA und manche Pulte senden nur an die, die antworten</translation>
    </message>
    <message>
        <source>%1. Somebody asks who wants Art-Net (ArtPoll) and gets no answer, for it asks from another network, too often or with too many others: OLA and some desks send to those alone that answer</source>
        <translation>%1. Jemand fragt, wer Art-Net will (ArtPoll), und bekommt keine Antwort, denn er fragt aus einem anderen Netz, zu oft oder mit zu vielen anderen: OLA und manche Pulte senden nur an die, die antworten</translation>
    </message>
    <message>
        <source>nothing comes for %1 any more, since %2: black (--on-loss). Its desk has stopped, sends elsewhere now (another universe or machine) or less often than every 2.5 s (sACN) or 10 s (Art-Net), or something on the way lets nothing through any more: a cable, a firewall, or a switch that prunes multicast after minutes (IGMP snooping without a querier)</source>
        <translation>nichts kommt mehr für %1, seit %2: schwarz (--on-loss). Das Pult hat aufgehört, sendet jetzt woandershin (anderes Universum, anderer Rechner) oder seltener als alle 2,5 s (sACN) oder 10 s (Art-Net), oder etwas unterwegs lässt nichts mehr durch: ein Kabel, eine Firewall oder ein Switch, der Multicast nach Minuten abschneidet (IGMP-Snooping ohne Querier)</translation>
    </message>
    <message>
        <source>nothing comes for %1 any more, since %2: black (--on-loss). %3 is heard all the while, with %4: its output was switched off or goes elsewhere, or something holds back these packets alone, a firewall or a switch that prunes multicast (IGMP snooping without a querier)</source>
        <translation>nichts kommt mehr für %1, seit %2: schwarz (--on-loss). %3 ist die ganze Zeit zu hören, mit %4: die Ausgabe wurde abgeschaltet oder geht woandershin, oder etwas hält nur diese Pakete zurück, eine Firewall oder ein Switch, der Multicast abschneidet (IGMP-Snooping ohne Querier)</translation>
    </message>
    <message>
        <source>nothing comes for %1 any more, since %2: black (--on-loss). %3 and others are heard all the while, with %4: its output was switched off or goes elsewhere, or something holds back these packets alone, a firewall or a switch that prunes multicast (IGMP snooping without a querier)</source>
        <translation>nichts kommt mehr für %1, seit %2: schwarz (--on-loss). %3 und andere sind die ganze Zeit zu hören, mit %4: die Ausgabe wurde abgeschaltet oder geht woandershin, oder etwas hält nur diese Pakete zurück, eine Firewall oder ein Switch, der Multicast abschneidet (IGMP-Snooping ohne Querier)</translation>
    </message>
    <message>
        <source>nothing comes for %1 any more, since %2: the last look is held. Its desk has stopped, sends elsewhere now (another universe or machine) or less often than every 2.5 s (sACN) or 10 s (Art-Net), or something on the way lets nothing through any more: a cable, a firewall, or a switch that prunes multicast after minutes (IGMP snooping without a querier)</source>
        <translation>nichts kommt mehr für %1, seit %2: das letzte Bild wird gehalten. Das Pult hat aufgehört, sendet jetzt woandershin (anderes Universum, anderer Rechner) oder seltener als alle 2,5 s (sACN) oder 10 s (Art-Net), oder etwas unterwegs lässt nichts mehr durch: ein Kabel, eine Firewall oder ein Switch, der Multicast nach Minuten abschneidet (IGMP-Snooping ohne Querier)</translation>
    </message>
    <message>
        <source>nothing comes for %1 any more, since %2: the last look is held. %3 is heard all the while, with %4: its output was switched off or goes elsewhere, or something holds back these packets alone, a firewall or a switch that prunes multicast (IGMP snooping without a querier)</source>
        <translation>nichts kommt mehr für %1, seit %2: das letzte Bild wird gehalten. %3 ist die ganze Zeit zu hören, mit %4: die Ausgabe wurde abgeschaltet oder geht woandershin, oder etwas hält nur diese Pakete zurück, eine Firewall oder ein Switch, der Multicast abschneidet (IGMP-Snooping ohne Querier)</translation>
    </message>
    <message>
        <source>nothing comes for %1 any more, since %2: the last look is held. %3 and others are heard all the while, with %4: its output was switched off or goes elsewhere, or something holds back these packets alone, a firewall or a switch that prunes multicast (IGMP snooping without a querier)</source>
        <translation>nichts kommt mehr für %1, seit %2: das letzte Bild wird gehalten. %3 und andere sind die ganze Zeit zu hören, mit %4: die Ausgabe wurde abgeschaltet oder geht woandershin, oder etwas hält nur diese Pakete zurück, eine Firewall oder ein Switch, der Multicast abschneidet (IGMP-Snooping ohne Querier)</translation>
    </message>
    <message>
        <source>%1 is one source too many on %2 and ignored: %3</source>
        <translation>%1 ist eine Quelle zu viel auf %2 und bleibt unbeachtet: %3</translation>
    </message>
    <message>
        <source>%1 are too many sources on %2 and ignored: %3</source>
        <translation>%1 sind zu viele Quellen auf %2 und bleiben unbeachtet: %3</translation>
    </message>
    <message>
        <source>Art-Net merges two</source>
        <translation>Art-Net mischt zwei</translation>
    </message>
    <message>
        <source>%1 are merged, those of the highest priority and of these the longest known</source>
        <translation>%1 werden gemischt, die höchster Priorität und davon die am längsten bekannten</translation>
    </message>
    <message>
        <source>%1 is not shown on %2: %3 has a higher priority</source>
        <translation>%1 wird auf %2 nicht gezeigt: %3 hat eine höhere Priorität</translation>
    </message>
    <message>
        <source>%1 sends priorities per address above 200 on %2 for %3: there is none above 200 (E1.31), and it does not hold these channels</source>
        <translation>%1 sendet auf %2 Prioritäten je Adresse über 200 für %3: über 200 gibt es keine (E1.31), und diese Kanäle hält es nicht</translation>
    </message>
    <message>
        <source>%1 sends %2 on %3 and priorities per address for %4 alone: it gives the others up, and fixtures are patched there</source>
        <translation>%1 sendet %2 auf %3 und Prioritäten je Adresse nur für %4: die anderen gibt es ab, und dort sind Geräte gepatcht</translation>
    </message>
    <message>
        <source>%1 levels</source>
        <translation>%1 Werte</translation>
    </message>
    <message>
        <source>%1 level</source>
        <translation>%1 Wert</translation>
    </message>
    <message>
        <source>%1 comes from more than one source of equal priority, %2, and they differ on up to %3: %4. Switch one off, or give one that is a backup a lower priority</source>
        <translation>%1 kommt von mehr als einer Quelle gleicher Priorität, %2, und sie unterscheiden sich um bis zu %3: %4. Eine abschalten oder der Reserve eine niedrigere Priorität geben</translation>
    </message>
    <message>
        <source>%1 come from more than one source of equal priority, %2, and they differ on up to %3: %4. Switch one off, or give one that is a backup a lower priority</source>
        <translation>%1 kommen von mehr als einer Quelle gleicher Priorität, %2, und sie unterscheiden sich um bis zu %3: %4. Eine abschalten oder der Reserve eine niedrigere Priorität geben</translation>
    </message>
    <message>
        <source>whoever changed a channel last has it (LTP, --artnet-merge)</source>
        <translation>wer einen Kanal zuletzt änderte, hat ihn (LTP, --artnet-merge)</translation>
    </message>
    <message>
        <source>of each channel the higher level shows (HTP)</source>
        <translation>von jedem Kanal gilt der höhere Wert (HTP)</translation>
    </message>
    <message>
        <source>%1. %2 names more than one Physical (input): it has several, or it changes what it names, and each counts as a source</source>
        <translation>%1. %2 nennt mehr als ein Physical (Eingang): es hat mehrere, oder es wechselt, was es nennt, und jedes zählt als Quelle</translation>
    </message>
    <message>
        <source>%1. %2 sends by sACN and by Art-Net: if that is one desk, one of them will do</source>
        <translation>%1. %2 sendet mit sACN und mit Art-Net: wenn das ein Pult ist, genügt eines davon</translation>
    </message>
    <message>
        <source>%1 channels</source>
        <translation>%1 Kanäle</translation>
    </message>
    <message>
        <source>%1 channel</source>
        <translation>%1 Kanal</translation>
    </message>
    <message>
        <source>%1 marks some of %2 as preview (blind), which is not shown: leave blind on the desk, or start with --show-preview</source>
        <translation>%1 kennzeichnet einen Teil von %2 als Vorschau (blind), die nicht gezeigt wird: am Pult Blind verlassen oder mit --show-preview starten</translation>
    </message>
    <message>
        <source>%1 marks %2 as preview (blind), which is not shown: leave blind on the desk, or start with --show-preview</source>
        <translation>%1 kennzeichnet %2 als Vorschau (blind), die nicht gezeigt wird: am Pult Blind verlassen oder mit --show-preview starten</translation>
    </message>
    <message>
        <source>more universes arrive than the %1 that are shown at once; those of the show and of --universes are always among them</source>
        <translation>mehr Universen kommen an als die %1, die zugleich gezeigt werden; die der Show und von --universes sind immer dabei</translation>
    </message>
    <message>
        <source>%1 sends Art-Net from another network than ours (%2), by a router or because the addresses do not fit: without a router its unicast and our answers do not arrive, and this machine needs an address in its network</source>
        <translation>%1 sendet Art-Net aus einem anderen Netz als unserem (%2), über einen Router oder weil die Adressen nicht passen: ohne Router kommen sein Unicast und unsere Antworten nicht an, und dieser Rechner braucht eine Adresse in seinem Netz</translation>
    </message>
    <message>
        <source>%1 comes from more than one source of equal priority, %2, and they differ on up to %3: %4. %5 has all dimmers at 0, and raises up to %6 of lamps that others light: a closed shutter or a colour among these would take the light away. If they are not meant to share, switch one off, or give one that is a backup a lower priority</source>
        <translation>%1 kommt von mehr als einer Quelle gleicher Priorität, %2, und sie unterscheiden sich um bis zu %3: %4. %5 hat alle Dimmer auf 0 und hebt bis zu %6 von Lampen an, die andere leuchten lassen: ein geschlossener Shutter oder eine Farbe darunter nähme das Licht weg. Wenn sie sich das nicht teilen sollen, eine abschalten oder der Reserve eine niedrigere Priorität geben</translation>
    </message>
    <message>
        <source>%1 come from more than one source of equal priority, %2, and they differ on up to %3: %4. %5 has all dimmers at 0, and raises up to %6 of lamps that others light: a closed shutter or a colour among these would take the light away. If they are not meant to share, switch one off, or give one that is a backup a lower priority</source>
        <translation>%1 kommen von mehr als einer Quelle gleicher Priorität, %2, und sie unterscheiden sich um bis zu %3: %4. %5 hat alle Dimmer auf 0 und hebt bis zu %6 von Lampen an, die andere leuchten lassen: ein geschlossener Shutter oder eine Farbe darunter nähme das Licht weg. Wenn sie sich das nicht teilen sollen, eine abschalten oder der Reserve eine niedrigere Priorität geben</translation>
    </message>
    <message>
        <source>%1; &apos;%2&apos; begins on %3 and runs past channel 512, where desks end a universe: is its address right?</source>
        <translation>%1; &apos;%2&apos; beginnt auf %3 und läuft über Kanal 512 hinaus, wo Pulte ein Universum beenden: stimmt seine Adresse?</translation>
    </message>
    <message>
        <source>in the numbers of the last seconds %1 packets are missing: lost by a cable, a switch, Wi-Fi or a firewall that lets only some through, or left out by a sender that skips numbers</source>
        <translation>in den Nummern der letzten Sekunden fehlen %1 Pakete: verloren durch ein Kabel, einen Switch, WLAN oder eine Firewall, die nur einige durchlässt, oder ausgelassen von einem Sender, der Nummern überspringt</translation>
    </message>
    <message>
        <source>in the numbers of the last seconds %1 packet is missing: lost by a cable, a switch, Wi-Fi or a firewall that lets only some through, or left out by a sender that skips numbers</source>
        <translation>in den Nummern der letzten Sekunden fehlt %1 Paket: verloren durch ein Kabel, einen Switch, WLAN oder eine Firewall, die nur einige durchlässt, oder ausgelassen von einem Sender, der Nummern überspringt</translation>
    </message>
    <message>
        <source>two Art-Net time codes run, of %1 and %2: the one that came first is followed until it is silent</source>
        <translation>zwei Art-Net-Timecodes laufen, von %1 und %2: dem, der zuerst kam, wird gefolgt, bis er schweigt</translation>
    </message>
    <message>
        <source>no levels</source>
        <translation>keine Werte</translation>
    </message>
    <message>
        <source>behind preview</source>
        <translation>hinter Vorschau</translation>
    </message>
    <message>
        <source>lower priority</source>
        <translation>niedrigere Priorität</translation>
    </message>
    <message>
        <source>holds no slot</source>
        <translation>hält keinen Kanal</translation>
    </message>
    <message>
        <source>in part</source>
        <translation>teilweise</translation>
    </message>
    <message>
        <source>merged</source>
        <translation>gemischt</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>gilt</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>silent</source>
        <translation>still</translation>
    </message>
    <message>
        <source>Fixture files that are missing</source>
        <translation>Gerätedateien, die fehlen</translation>
    </message>
    <message>
        <source>Fixture files that cannot be read</source>
        <translation>Gerätedateien, die nicht lesbar sind</translation>
    </message>
    <message>
        <source>Fixture files without a DMX mode</source>
        <translation>Gerätedateien ohne DMX-Modus</translation>
    </message>
    <message>
        <source>Modes that the fixture file does not have</source>
        <translation>Modi, die die Gerätedatei nicht hat</translation>
    </message>
    <message>
        <source>Fixture files that say nothing of their light</source>
        <translation>Gerätedateien, die nichts über ihr Licht sagen</translation>
    </message>
    <message>
        <source>Fixture files taken by a name that is nearly the same</source>
        <translation>Gerätedateien, die nach fast gleichem Namen genommen wurden</translation>
    </message>
    <message>
        <source>Files that are missing</source>
        <translation>Dateien, die fehlen</translation>
    </message>
    <message>
        <source>Pictures and models that are missing</source>
        <translation>Bilder und Modelle, die fehlen</translation>
    </message>
    <message>
        <source>Films and pictures that cannot be read</source>
        <translation>Filme und Bilder, die nicht lesbar sind</translation>
    </message>
    <message>
        <source>Names that lead nowhere</source>
        <translation>Namen, die nirgends hinführen</translation>
    </message>
    <message>
        <source>Fixtures that share channels</source>
        <translation>Geräte mit gemeinsamen Kanälen</translation>
    </message>
    <message>
        <source>Fixtures without an address</source>
        <translation>Geräte ohne Adresse</translation>
    </message>
    <message>
        <source>Fixtures that run past channel 512</source>
        <translation>Geräte, die über Kanal 512 hinausgehen</translation>
    </message>
    <message>
        <source>Parts of fixtures without an address</source>
        <translation>Teile von Geräten ohne Adresse</translation>
    </message>
    <message>
        <source>Addresses that cannot be</source>
        <translation>Adressen, die es nicht gibt</translation>
    </message>
    <message>
        <source>Addresses that fit another mode</source>
        <translation>Adressen, die zu einem anderen Modus passen</translation>
    </message>
    <message>
        <source>Fixtures with the very same address</source>
        <translation>Geräte mit genau derselben Adresse</translation>
    </message>
    <message>
        <source>Names that are given twice</source>
        <translation>Namen, die doppelt vergeben sind</translation>
    </message>
    <message>
        <source>Fixture numbers that are given twice</source>
        <translation>Gerätenummern, die doppelt vergeben sind</translation>
    </message>
    <message>
        <source>Identities that are given twice</source>
        <translation>Kennungen, die doppelt vergeben sind</translation>
    </message>
    <message>
        <source>Names that lead out of the file</source>
        <translation>Namen, die aus der Datei hinausführen</translation>
    </message>
    <message>
        <source>Values that a file leaves out</source>
        <translation>Werte, die eine Datei auslässt</translation>
    </message>
    <message>
        <source>Things in the file that mean nothing to us</source>
        <translation>Inhalte der Datei, die hier nichts bedeuten</translation>
    </message>
    <message>
        <source>Things in the file that no picture needs</source>
        <translation>Inhalte der Datei, die kein Bild braucht</translation>
    </message>
    <message>
        <source>Other</source>
        <translation>Anderes</translation>
    </message>
    <message>
        <source>is not in the plot</source>
        <translation>ist nicht im Plan</translation>
    </message>
    <message>
        <source>cannot be read</source>
        <translation>ist nicht lesbar</translation>
    </message>
    <message>
        <source>gives no light</source>
        <translation>gibt kein Licht</translation>
    </message>
    <message>
        <source>says nothing of its light: a beam is assumed</source>
        <translation>sagt nichts über sein Licht: ein Strahl ist angenommen</translation>
    </message>
    <message>
        <source>%1 fixtures of %2 types, patched in %3 universes</source>
        <translation>%1 Geräte von %2 Typen, gepatcht in %3 Universen</translation>
    </message>
    <message>
        <source>%1 fixtures of %2 types, patched in %3 universe</source>
        <translation>%1 Geräte von %2 Typen, gepatcht in %3 Universum</translation>
    </message>
    <message>
        <source>%1 fixtures of %2 type, patched in %3 universes</source>
        <translation>%1 Geräte von %2 Typ, gepatcht in %3 Universen</translation>
    </message>
    <message>
        <source>%1 fixtures of %2 type, patched in %3 universe</source>
        <translation>%1 Geräte von %2 Typ, gepatcht in %3 Universum</translation>
    </message>
    <message>
        <source>%1 fixture of %2 type, patched in %3 universe</source>
        <translation>%1 Gerät von %2 Typ, gepatcht in %3 Universum</translation>
    </message>
    <message>
        <source>%1 of no type</source>
        <translation>%1 ohne Typ</translation>
    </message>
    <message>
        <source>no scenery: heads hang in empty space</source>
        <translation>keine Kulisse: Geräte hängen im leeren Raum</translation>
    </message>
    <message>
        <source>%1 pieces of scenery in %2 layers</source>
        <translation>%1 Kulissenteile in %2 Ebenen</translation>
    </message>
    <message>
        <source>%1 pieces of scenery in %2 layer</source>
        <translation>%1 Kulissenteile in %2 Ebene</translation>
    </message>
    <message>
        <source>%1 piece of scenery in %2 layer</source>
        <translation>%1 Kulissenteil in %2 Ebene</translation>
    </message>
    <message>
        <source>%1 cameras</source>
        <translation>%1 Kameras</translation>
    </message>
    <message>
        <source>%1 camera</source>
        <translation>%1 Kamera</translation>
    </message>
    <message>
        <source>export the file again</source>
        <translation>die Datei neu exportieren</translation>
    </message>
    <message>
        <source>keep one of them, or give them names of their own</source>
        <translation>eine davon behalten oder eigene Namen geben</translation>
    </message>
    <message>
        <source>put the file there, or correct its name</source>
        <translation>die Datei dorthin legen oder ihren Namen berichtigen</translation>
    </message>
    <message>
        <source>see that this is the fixture that was meant</source>
        <translation>prüfen, ob dies das gemeinte Gerät ist</translation>
    </message>
    <message>
        <source>put the file into the archive or beside the plot, or name another one in [[substitute]] of the show file</source>
        <translation>die Datei ins Archiv oder neben den Plan legen oder eine andere unter [[substitute]] der Showdatei nennen</translation>
    </message>
    <message>
        <source>give the fixture a type in the program that drew the plot</source>
        <translation>dem Gerät im Programm, das den Plan zeichnete, einen Typ geben</translation>
    </message>
    <message>
        <source>get the file again from its maker</source>
        <translation>die Datei neu vom Hersteller holen</translation>
    </message>
    <message>
        <source>fine for machines; for a lamp get a newer file from its maker</source>
        <translation>in Ordnung für Maschinen; für ein Lichtgerät eine neuere Datei vom Hersteller holen</translation>
    </message>
    <message>
        <source>get a newer file from its maker</source>
        <translation>eine neuere Datei vom Hersteller holen</translation>
    </message>
    <message>
        <source>choose a mode that the file has, in the plot or in the show file</source>
        <translation>einen Modus wählen, den die Datei hat, im Plan oder in der Showdatei</translation>
    </message>
    <message>
        <source>get the file again, or make one of it that FFmpeg plays</source>
        <translation>die Datei neu holen oder eine daraus machen, die FFmpeg abspielt</translation>
    </message>
    <message>
        <source>get the file again, with its models; a plain shape stands in</source>
        <translation>die Datei mit ihren Modellen neu holen; ein einfacher Körper steht dafür</translation>
    </message>
    <message>
        <source>export the model again, with its textures</source>
        <translation>das Modell mit seinen Texturen neu exportieren</translation>
    </message>
    <message>
        <source>get the file again, with its pictures; the gobo is open until then</source>
        <translation>die Datei mit ihren Bildern neu holen; bis dahin ist das Gobo offen</translation>
    </message>
    <message>
        <source>export the plot again, with its gobo pictures</source>
        <translation>den Plan mit seinen Gobobildern neu exportieren</translation>
    </message>
    <message>
        <source>get the file again; a plain shape stands in</source>
        <translation>die Datei neu holen; ein einfacher Körper steht dafür</translation>
    </message>
    <message>
        <source>get the file again</source>
        <translation>die Datei neu holen</translation>
    </message>
    <message>
        <source>export the plot again, with its models</source>
        <translation>den Plan mit seinen Modellen neu exportieren</translation>
    </message>
    <message>
        <source>export the plot again, with its media</source>
        <translation>den Plan mit seinen Medien neu exportieren</translation>
    </message>
    <message>
        <source>nothing is drawn by it; export again if grouping by it matters</source>
        <translation>nichts wird danach gezeichnet; neu exportieren, wenn die Gruppierung wichtig ist</translation>
    </message>
    <message>
        <source>export the plot again, with its symbols</source>
        <translation>den Plan mit seinen Symbolen neu exportieren</translation>
    </message>
    <message>
        <source>get a newer file from its maker, or see that the range is right</source>
        <translation>eine neuere Datei vom Hersteller holen oder prüfen, ob der Bereich stimmt</translation>
    </message>
    <message>
        <source>patch them in the plot, or with address in [[fixture]] or [[change]] of the show file</source>
        <translation>im Plan patchen oder mit address in [[fixture]] oder [[change]] der Showdatei</translation>
    </message>
    <message>
        <source>give it an address in that range</source>
        <translation>eine Adresse in diesem Bereich geben</translation>
    </message>
    <message>
        <source>move them to addresses where they fit</source>
        <translation>auf Adressen verschieben, wo sie passen</translation>
    </message>
    <message>
        <source>give each break an address, if the desk drives it</source>
        <translation>jedem Break eine Adresse geben, wenn das Pult ihn steuert</translation>
    </message>
    <message>
        <source>fine where a multipatch is meant</source>
        <translation>in Ordnung, wo ein Multipatch gemeint ist</translation>
    </message>
    <message>
        <source>give one of them other addresses, or the mode with fewer channels</source>
        <translation>einem davon andere Adressen geben oder den Modus mit weniger Kanälen</translation>
    </message>
    <message>
        <source>name another file of this fixture in [[substitute]] of the show file, or get a newer one</source>
        <translation>eine andere Datei dieses Geräts unter [[substitute]] der Showdatei nennen oder eine neuere holen</translation>
    </message>
    <message>
        <source>fine where it is no lamp; else name another file of it in [[substitute]] of the show file</source>
        <translation>in Ordnung, wo es kein Lichtgerät ist; sonst eine andere Datei unter [[substitute]] der Showdatei nennen</translation>
    </message>
    <message>
        <source>give each fixture a number of its own, or mark them as multipatch</source>
        <translation>jedem Gerät eine eigene Nummer geben oder als Multipatch kennzeichnen</translation>
    </message>
    <message>
        <source>export the plot again; each object needs a UUID of its own</source>
        <translation>den Plan neu exportieren; jedes Objekt braucht eine eigene UUID</translation>
    </message>
    <message>
        <source>%1 fixtures have no address, all channels keep their defaults: %2</source>
        <translation>%1 Geräte haben keine Adresse, alle Kanäle behalten ihre Grundwerte: %2</translation>
    </message>
    <message>
        <source>%1 fixture has no address, all channels keep their defaults: %2</source>
        <translation>%1 Gerät hat keine Adresse, alle Kanäle behalten ihre Grundwerte: %2</translation>
    </message>
    <message>
        <source>%1 fixtures of one type share address %2 and will do the same: %3</source>
        <translation>%1 Geräte eines Typs teilen die Adresse %2 und tun dasselbe: %3</translation>
    </message>
    <message>
        <source>%1 fixtures of %2 give no light, as the mode has no beam: %3</source>
        <translation>%1 Geräte von %2 geben kein Licht, denn der Modus hat keinen Strahl: %3</translation>
    </message>
    <message>
        <source>%1 fixture of %2 gives no light, as the mode has no beam: %3</source>
        <translation>%1 Gerät von %2 gibt kein Licht, denn der Modus hat keinen Strahl: %3</translation>
    </message>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos; share channels %3 to %4 of universe %5, expected channels of their own</source>
        <translation>&apos;%1&apos; und &apos;%2&apos; teilen die Kanäle %3 bis %4 von Universum %5, erwartet sind eigene Kanäle</translation>
    </message>
    <message>
        <source>note</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>Not opened: %1</source>
        <translation>Nicht geöffnet: %1</translation>
    </message>
    <message>
        <source>mend the file and open it again</source>
        <translation>die Datei in Ordnung bringen und neu öffnen</translation>
    </message>
    <message>
        <source>opening %1</source>
        <translation>%1 wird geöffnet</translation>
    </message>
    <message>
        <source>taking over %1</source>
        <translation>%1 wird übernommen</translation>
    </message>
    <message>
        <source>taking the changes of %1</source>
        <translation>Änderungen von %1 werden übernommen</translation>
    </message>
    <message>
        <source>drawing anew on the graphics device</source>
        <translation>Bild entsteht neu auf dem Grafikgerät</translation>
    </message>
    <message>
        <source>baked: %1, %2 passes</source>
        <translation>vorberechnet: %1, %2 Lichter</translation>
    </message>
    <message>
        <source>live: %1, because %2</source>
        <translation>live: %1, denn %2</translation>
    </message>
    <message>
        <source>live: a free camera</source>
        <translation>live: freie Kamera</translation>
    </message>
    <message>
        <source>the show has changes that are not saved</source>
        <translation>die Show hat nicht gesicherte Änderungen</translation>
    </message>
    <message>
        <source>its passes are being read</source>
        <translation>das Vorberechnete wird gelesen</translation>
    </message>
    <message>
        <source>off</source>
        <translation>aus</translation>
    </message>
    <message>
        <source>room</source>
        <translation>Raum</translation>
    </message>
    <message>
        <source>normal</source>
        <translation>normal</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>fein</translation>
    </message>
    <message>
        <source>haze</source>
        <translation>Dunst</translation>
    </message>
    <message>
        <source>fog</source>
        <translation>Nebel</translation>
    </message>
    <message>
        <source>it is not baked</source>
        <translation>sie ist nicht vorberechnet</translation>
    </message>
    <message>
        <source>its passes are not whole: bake it again</source>
        <translation>das Vorberechnete ist unvollständig: neu vorberechnen</translation>
    </message>
    <message>
        <source>baking</source>
        <translation>rechnet vor</translation>
    </message>
    <message>
        <source>baking: %1</source>
        <translation>rechnet vor: %1</translation>
    </message>
    <message>
        <source>importing</source>
        <translation>importiert</translation>
    </message>
    <message>
        <source>contact sheet</source>
        <translation>Kontaktbogen</translation>
    </message>
    <message>
        <source>contact sheet: %1</source>
        <translation>Kontaktbogen: %1</translation>
    </message>
    <message>
        <source>rendering</source>
        <translation>zeichnet</translation>
    </message>
    <message>
        <source>rendering: %1</source>
        <translation>zeichnet: %1</translation>
    </message>
    <message>
        <source>no fixture is selected</source>
        <translation>kein Gerät ist ausgewählt</translation>
    </message>
    <message>
        <source>no fixture is selected; Shift+R gives everything back</source>
        <translation>kein Gerät ist ausgewählt; Umschalt+R gibt alles frei</translation>
    </message>
    <message>
        <source>nothing of the selected fixtures is set by hand; Shift+R gives everything back</source>
        <translation>von den ausgewählten Geräten ist nichts von Hand gesetzt; Umschalt+R gibt alles frei</translation>
    </message>
    <message>
        <source>nothing that is selected turns both ways</source>
        <translation>nichts Ausgewähltes dreht in beide Richtungen</translation>
    </message>
    <message>
        <source>there is no picture yet</source>
        <translation>noch gibt es kein Bild</translation>
    </message>
    <message>
        <source>there is nothing but air to aim at</source>
        <translation>dort ist nichts als Luft</translation>
    </message>
    <message>
        <source>%1 head does not reach that far, and turned as far as possible</source>
        <translation>%1 Gerät reicht nicht so weit und drehte, so weit es geht</translation>
    </message>
    <message>
        <source>%1 heads do not reach that far, and turned as far as possible</source>
        <translation>%1 Geräte reichen nicht so weit und drehten, so weit es geht</translation>
    </message>
    <message>
        <source>%1 of them do not reach that far, and turned as far as possible</source>
        <translation>%1 davon reichen nicht so weit und drehten, so weit es geht</translation>
    </message>
    <message>
        <source>there is no action &apos;%1&apos;, did you mean &apos;%2&apos;?</source>
        <translation>es gibt keine Aktion &apos;%1&apos;, gemeint &apos;%2&apos;?</translation>
    </message>
    <message>
        <source>there is no action &apos;%1&apos;</source>
        <translation>es gibt keine Aktion &apos;%1&apos;</translation>
    </message>
    <message>
        <source>takes no arguments, so what is &apos;%1&apos;?</source>
        <translation>nimmt nichts entgegen, was also ist &apos;%1&apos;?</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is a word too many: it takes %2</source>
        <translation>&apos;%1&apos; ist ein Wort zu viel: es nimmt %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither on nor off</source>
        <translation>&apos;%1&apos; ist weder on noch off</translation>
    </message>
    <message>
        <source>it needs the name of a file</source>
        <translation>es braucht den Namen einer Datei</translation>
    </message>
    <message>
        <source>a quote &quot; without its end</source>
        <translation>ein Anführungszeichen &quot; ohne Ende</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no %2 from %3 to %4</source>
        <translation>&apos;%1&apos; ist nicht: %2 von %3 bis %4</translation>
    </message>
    <message>
        <source>it needs a %1 from %2 to %3</source>
        <translation>es braucht: %1 von %2 bis %3</translation>
    </message>
    <message>
        <source>number</source>
        <translation>Zahl</translation>
    </message>
    <message>
        <source>degrees</source>
        <translation>Grad</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>Meter</translation>
    </message>
    <message>
        <source>metres a second</source>
        <translation>Meter pro Sekunde</translation>
    </message>
    <message>
        <source>direction</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>place in metres</source>
        <translation>Ort in Metern</translation>
    </message>
    <message>
        <source>spread in metres</source>
        <translation>Verteilung in Metern</translation>
    </message>
    <message>
        <source>share</source>
        <translation>Anteil</translation>
    </message>
    <message>
        <source>share of the picture</source>
        <translation>Anteil des Bildes</translation>
    </message>
    <message>
        <source>share of the width, on or off</source>
        <translation>Anteil der Breite, on oder off</translation>
    </message>
    <message>
        <source>share of the pixels in percent, 0 for automatic,</source>
        <translation>Anteil der Pixel in Prozent, 0 für automatisch,</translation>
    </message>
    <message>
        <source>extinction per metre</source>
        <translation>Extinktion je Meter</translation>
    </message>
    <message>
        <source>unevenness</source>
        <translation>Ungleichmäßigkeit</translation>
    </message>
    <message>
        <source>factor</source>
        <translation>Faktor</translation>
    </message>
    <message>
        <source>field of view</source>
        <translation>Bildwinkel</translation>
    </message>
    <message>
        <source>number of seconds</source>
        <translation>Zahl von Sekunden</translation>
    </message>
    <message>
        <source>number of degrees</source>
        <translation>Zahl von Grad</translation>
    </message>
    <message>
        <source>number of kelvin</source>
        <translation>Zahl von Kelvin</translation>
    </message>
    <message>
        <source>number of lux</source>
        <translation>Zahl von Lux</translation>
    </message>
    <message>
        <source>number of samples</source>
        <translation>Zahl von Abtastungen</translation>
    </message>
    <message>
        <source>number of samples per pixel</source>
        <translation>Zahl von Abtastungen je Pixel</translation>
    </message>
    <message>
        <source>number of bounces</source>
        <translation>Zahl von Reflexionen</translation>
    </message>
    <message>
        <source>number of pictures a second</source>
        <translation>Zahl von Bildern pro Sekunde</translation>
    </message>
    <message>
        <source>first second</source>
        <translation>erste Sekunde</translation>
    </message>
    <message>
        <source>last second</source>
        <translation>letzte Sekunde</translation>
    </message>
    <message>
        <source>slot, 0 is open,</source>
        <translation>Platz, 0 ist offen,</translation>
    </message>
    <message>
        <source>value</source>
        <translation>Wert</translation>
    </message>
    <message>
        <source>least value</source>
        <translation>kleinster Wert</translation>
    </message>
    <message>
        <source>largest value</source>
        <translation>größter Wert</translation>
    </message>
    <message>
        <source>pixel from the left</source>
        <translation>Pixel von links</translation>
    </message>
    <message>
        <source>pixel from the top</source>
        <translation>Pixel von oben</translation>
    </message>
    <message>
        <source>number of seconds, &apos;opened&apos;, &apos;picture&apos;, &apos;settled&apos;, &apos;saved&apos; or &apos;jobs&apos;</source>
        <translation>Zahl von Sekunden, &apos;opened&apos;, &apos;picture&apos;, &apos;settled&apos;, &apos;saved&apos; oder &apos;jobs&apos;</translation>
    </message>
    <message>
        <source>there is no hazer &apos;%1&apos;; the show has %2</source>
        <translation>es gibt keinen Hazer &apos;%1&apos;; die Show hat %2</translation>
    </message>
    <message>
        <source>hazer %1: expected %2 number, not %3</source>
        <translation>Hazer %1: erwartet %2 Zahl, nicht %3</translation>
    </message>
    <message>
        <source>hazer %1: expected %2 numbers, not %3</source>
        <translation>Hazer %1: erwartet %2 Zahlen, nicht %3</translation>
    </message>
    <message>
        <source>hazer: expected place, direction, rate, spread or reach, not &apos;%1&apos;</source>
        <translation>Hazer: erwartet place, direction, rate, spread oder reach, nicht &apos;%1&apos;</translation>
    </message>
    <message>
        <source>0 0 0 has no length, expected where the haze is blown, like 0 0 1</source>
        <translation>0 0 0 hat keine Länge, erwartet ist, wohin der Dunst bläst, wie 0 0 1</translation>
    </message>
    <message>
        <source>the show has %1 cameras, no number %2</source>
        <translation>die Show hat %1 Kameras, keine mit Nummer %2</translation>
    </message>
    <message>
        <source>the camera stands at what it looks at</source>
        <translation>die Kamera steht auf dem, was sie ansieht</translation>
    </message>
    <message>
        <source>the show has no fixtures</source>
        <translation>die Show hat keine Geräte</translation>
    </message>
    <message>
        <source>has neither show.toml nor book.json: to compare with is a show, a plot or a book</source>
        <translation>hat weder show.toml noch book.json: verglichen wird mit einer Show, einem Plan oder einem Buch</translation>
    </message>
    <message>
        <source>no further fixture is called &apos;%1&apos;</source>
        <translation>kein weiteres Gerät heißt &apos;%1&apos;</translation>
    </message>
    <message>
        <source>no fixture is called &apos;%1&apos;</source>
        <translation>kein Gerät heißt &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the show has no cue: add one</source>
        <translation>die Show hat keinen Cue: einen hinzufügen</translation>
    </message>
    <message>
        <source>this was the last cue</source>
        <translation>das war der letzte Cue</translation>
    </message>
    <message>
        <source>this is the first cue</source>
        <translation>das ist der erste Cue</translation>
    </message>
    <message>
        <source>this is the last cue</source>
        <translation>das ist der letzte Cue</translation>
    </message>
    <message>
        <source>there is no cue number %1</source>
        <translation>es gibt keinen Cue Nummer %1</translation>
    </message>
    <message>
        <source>another cue is called &apos;%1&apos;</source>
        <translation>ein anderer Cue heißt &apos;%1&apos;</translation>
    </message>
    <message>
        <source>a cue needs a name</source>
        <translation>ein Cue braucht einen Namen</translation>
    </message>
    <message>
        <source>a cue needs a look, a camera or a place in the recording</source>
        <translation>ein Cue braucht einen Look, eine Kamera oder eine Stelle der Aufzeichnung</translation>
    </message>
    <message>
        <source>there is no cue &apos;%1&apos;, did you mean &apos;%2&apos;?</source>
        <translation>es gibt keinen Cue &apos;%1&apos;, gemeint &apos;%2&apos;?</translation>
    </message>
    <message>
        <source>there is no cue &apos;%1&apos;</source>
        <translation>es gibt keinen Cue &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither up nor down</source>
        <translation>&apos;%1&apos; ist weder up noch down</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no size like 1920x1080, 16 to 8192 each way</source>
        <translation>&apos;%1&apos; ist keine Größe wie 1920x1080, 16 bis 8192 je Richtung</translation>
    </message>
    <message>
        <source>nothing runs in the background</source>
        <translation>im Hintergrund läuft nichts</translation>
    </message>
    <message>
        <source>the name must end in .%1</source>
        <translation>der Name muss auf .%1 enden</translation>
    </message>
    <message>
        <source>no such folder</source>
        <translation>kein solcher Ordner</translation>
    </message>
    <message>
        <source>no such file</source>
        <translation>keine solche Datei</translation>
    </message>
    <message>
        <source>no such file or folder</source>
        <translation>keine solche Datei und kein solcher Ordner</translation>
    </message>
    <message>
        <source>save the show first (Ctrl+S): what runs in the background reads its file</source>
        <translation>zuerst die Show sichern (Strg+S): Was im Hintergrund läuft, liest ihre Datei</translation>
    </message>
    <message>
        <source>a film shows the recording of the show, and it has none</source>
        <translation>ein Film zeigt die Aufzeichnung der Show, und sie hat keine</translation>
    </message>
    <message>
        <source>the film must end after it begins</source>
        <translation>der Film muss nach seinem Beginn enden</translation>
    </message>
    <message>
        <source>nothing lights the picture: the show has no recording and nothing is set by hand; &apos;save-picture&apos; saves what a desk does now</source>
        <translation>nichts beleuchtet das Bild: Die Show hat keine Aufzeichnung, und nichts ist von Hand gesetzt; &apos;save-picture&apos; sichert, was ein Pult jetzt tut</translation>
    </message>
    <message>
        <source>no selected fixture has &apos;%1&apos;, did you mean &apos;%2&apos;?</source>
        <translation>kein ausgewähltes Gerät hat &apos;%1&apos;, gemeint &apos;%2&apos;?</translation>
    </message>
    <message>
        <source>no selected fixture has &apos;%1&apos;</source>
        <translation>kein ausgewähltes Gerät hat &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is dark or turns its wheel, and nobody set its %2 by hand</source>
        <translation>&apos;%1&apos; ist dunkel oder dreht sein Rad, und niemand hat von Hand gesetzt: %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no colour like #ff8000</source>
        <translation>&apos;%1&apos; ist keine Farbe wie #ff8000</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is none of %2</source>
        <translation>&apos;%1&apos; ist keines von %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither first nor last</source>
        <translation>&apos;%1&apos; ist weder first noch last</translation>
    </message>
    <message>
        <source>colours go from one to the other (line or symmetric), not to both sides of one</source>
        <translation>Farben gehen von einer zur anderen (line oder symmetric), nicht zu beiden Seiten einer</translation>
    </message>
    <message>
        <source>nothing of &apos;%1&apos; is set by hand; name what all shall have, or hold it first</source>
        <translation>von &apos;%1&apos; ist nichts von Hand gesetzt; nennen, was alle haben sollen, oder es zuerst halten</translation>
    </message>
    <message>
        <source>everything of the selected fixtures is the hand&apos;s already</source>
        <translation>alles der ausgewählten Geräte ist schon in der Hand</translation>
    </message>
    <message>
        <source>does not lie like a truss or a pipe, so nothing hangs under it</source>
        <translation>liegt nicht wie eine Traverse oder ein Rohr, also hängt nichts darunter</translation>
    </message>
    <message>
        <source>there is no object &apos;%1&apos;</source>
        <translation>es gibt kein Objekt &apos;%1&apos;</translation>
    </message>
    <message>
        <source>the stage has no truss or pipe to hang them under</source>
        <translation>die Bühne hat keine Traverse und kein Rohr zum Hängen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no truss or pipe that lies</source>
        <translation>&apos;%1&apos; ist keine liegende Traverse und kein Rohr</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither off nor a colour like #ff8000</source>
        <translation>&apos;%1&apos; ist weder off noch eine Farbe wie #ff8000</translation>
    </message>
    <message>
        <source>no object of the stage is chosen: double click one, or choose it in Scene</source>
        <translation>kein Objekt der Bühne ist gewählt: eines doppelklicken oder unter Szene wählen</translation>
    </message>
    <message>
        <source>the stage has no object &apos;%1&apos;, did you mean &apos;%2&apos;?</source>
        <translation>die Bühne hat kein Objekt &apos;%1&apos;, gemeint &apos;%2&apos;?</translation>
    </message>
    <message>
        <source>the stage has no object &apos;%1&apos;</source>
        <translation>die Bühne hat kein Objekt &apos;%1&apos;</translation>
    </message>
    <message>
        <source>there is no such object</source>
        <translation>es gibt kein solches Objekt</translation>
    </message>
    <message>
        <source>%1 objects are called &apos;%2&apos;, and a show knows them by name: in the model give each its own</source>
        <translation>%1 Objekte heißen &apos;%2&apos;, und eine Show kennt sie nach Namen: im Modell jedem einen eigenen geben</translation>
    </message>
    <message>
        <source>nothing of %1 is set by hand for the selected fixtures; &apos;hold&apos; takes what the desk asks for</source>
        <translation>für die ausgewählten Geräte ist davon nichts von Hand gesetzt: %1; &apos;hold&apos; nimmt, was das Pult verlangt</translation>
    </message>
    <message>
        <source>no selected fixture has anything of the palette &apos;%1&apos;</source>
        <translation>kein ausgewähltes Gerät hat etwas von der Palette &apos;%1&apos;</translation>
    </message>
    <message>
        <source>another palette is called &apos;%1&apos;</source>
        <translation>eine andere Palette heißt &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no address like 2.101 (universe 1 to 63999, channel 1 to 512), nor &apos;none&apos;</source>
        <translation>&apos;%1&apos; ist keine Adresse wie 2.101 (Universum 1 bis 63999, Kanal 1 bis 512) und nicht &apos;none&apos;</translation>
    </message>
    <message>
        <source>align: expected x, y or z</source>
        <translation>align: erwartet x, y oder z</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no name: 1 to 100 bytes, no leading dot, none of /\:*?&quot;&lt;&gt;|</source>
        <translation>&apos;%1&apos; ist kein Name: 1 bis 100 Bytes, kein Punkt am Anfang, keines von /\:*?&quot;&lt;&gt;|</translation>
    </message>
    <message>
        <source>another fixture is called &apos;%1&apos;</source>
        <translation>ein anderes Gerät heißt &apos;%1&apos;</translation>
    </message>
    <message>
        <source>has no fixture file that can be read</source>
        <translation>hat keine lesbare Gerätedatei</translation>
    </message>
    <message>
        <source>hangs on a track, which says where it is</source>
        <translation>hängt an einer Bahn, die sagt, wo es ist</translation>
    </message>
    <message>
        <source>three fixtures or more can be spread evenly</source>
        <translation>gleichmäßig verteilen lassen sich drei Geräte oder mehr</translation>
    </message>
    <message>
        <source>is of the plot, which only its own program can add to</source>
        <translation>gehört zum Plan, den nur sein eigenes Programm ergänzt</translation>
    </message>
    <message>
        <source>another file of this name lies beside the show already; rename the new one, or put it there yourself and the show takes it</source>
        <translation>eine andere Datei dieses Namens liegt schon neben der Show; die neue umbenennen oder selbst dorthin legen, dann nimmt die Show sie</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is no name of a camera: it names a folder</source>
        <translation>&apos;%1&apos; ist kein Name für eine Kamera: er benennt einen Ordner</translation>
    </message>
    <message>
        <source>another camera is called &apos;%1&apos;</source>
        <translation>eine andere Kamera heißt &apos;%1&apos;</translation>
    </message>
    <message>
        <source>is no model, expected .glb, .gltf, .obj or .3ds</source>
        <translation>ist kein Modell, erwartet .glb, .gltf, .obj oder .3ds</translation>
    </message>
    <message>
        <source>the show has a plot; &apos;ghostlight import&apos; into its folder merges a newer one</source>
        <translation>die Show hat einen Plan; &apos;ghostlight import&apos; in ihren Ordner führt einen neueren zusammen</translation>
    </message>
    <message>
        <source>is no plot, expected .mvr</source>
        <translation>ist kein Plan, erwartet .mvr</translation>
    </message>
    <message>
        <source>has no DMX mode</source>
        <translation>hat keinen DMX-Modus</translation>
    </message>
    <message>
        <source>a recording runs; &apos;record off&apos; ends it</source>
        <translation>eine Aufzeichnung läuft; &apos;record off&apos; beendet sie</translation>
    </message>
    <message>
        <source>nothing was recorded in this window</source>
        <translation>in diesem Fenster wurde nichts aufgezeichnet</translation>
    </message>
    <message>
        <source>it must end after it begins</source>
        <translation>es muss nach seinem Beginn enden</translation>
    </message>
    <message>
        <source>the show has no mover &apos;%1&apos;, did you mean &apos;%2&apos;?</source>
        <translation>die Show hat kein bewegtes Teil &apos;%1&apos;, gemeint &apos;%2&apos;?</translation>
    </message>
    <message>
        <source>the show has no mover &apos;%1&apos;</source>
        <translation>die Show hat kein bewegtes Teil &apos;%1&apos;</translation>
    </message>
    <message>
        <source>mover &apos;%1&apos; has %2 axes, expected a number for each, or off</source>
        <translation>das bewegte Teil &apos;%1&apos; hat %2 Achsen, erwartet eine Zahl für jede oder off</translation>
    </message>
    <message>
        <source>one of the factors must be above 0</source>
        <translation>einer der Faktoren muss über 0 liegen</translation>
    </message>
    <message>
        <source>there is no material &apos;%1&apos;</source>
        <translation>es gibt kein Material &apos;%1&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is none of specular, roughness, shininess</source>
        <translation>&apos;%1&apos; ist keines von specular, roughness, shininess</translation>
    </message>
    <message>
        <source>the show is not open: %1</source>
        <translation>die Show ist nicht offen: %1</translation>
    </message>
    <message>
        <source>no show is being opened</source>
        <translation>keine Show wird geöffnet</translation>
    </message>
    <message>
        <source>a quarter of an hour went by without it</source>
        <translation>eine Viertelstunde verging ohne</translation>
    </message>
    <message>
        <source>is there already; a new show needs a name of its own</source>
        <translation>gibt es schon; eine neue Show braucht einen eigenen Namen</translation>
    </message>
    <message>
        <source>is there already: another name, or over it (in a script: save-as FILE over)</source>
        <translation>gibt es schon: ein anderer Name, oder darüber (in einem Skript: save-as FILE over)</translation>
    </message>
    <message>
        <source>cannot be made: %1</source>
        <translation>lässt sich nicht anlegen: %1</translation>
    </message>
    <message>
        <source>what a show names lies beside it, so under another name it stays in %1; a copy of the file alone: Save a copy of the show file</source>
        <translation>was eine Show nennt, liegt neben ihr, also bleibt sie unter anderem Namen in %1; eine Kopie nur der Datei: Kopie der Showdatei sichern</translation>
    </message>
    <message>
        <source>is no .mvr, as Vectorworks, Capture, grandMA3 and Production Assist export it</source>
        <translation>ist keine .mvr, wie Vectorworks, Capture, grandMA3 und Production Assist sie exportieren</translation>
    </message>
    <message>
        <source>the guide is not installed beside this program</source>
        <translation>die Anleitung ist nicht neben diesem Programm installiert</translation>
    </message>
    <message>
        <source>no program was found that opens it</source>
        <translation>kein Programm gefunden, das es öffnet</translation>
    </message>
    <message>
        <source>what is not saved can be kept nowhere</source>
        <translation>was nicht gesichert ist, lässt sich nirgends aufheben</translation>
    </message>
    <message>
        <source>looks cannot be stored before this is mended, for that would lose it: %1</source>
        <translation>Looks lassen sich erst speichern, wenn das behoben ist, sonst ginge es verloren: %1</translation>
    </message>
    <message>
        <source>was changed by another program and is read again; once more, please</source>
        <translation>wurde von einem anderen Programm geändert und neu gelesen; bitte noch einmal</translation>
    </message>
    <message>
        <source>there are %1 looks; remove one first</source>
        <translation>es gibt %1 Looks; zuerst einen entfernen</translation>
    </message>
    <message>
        <source>there is no look yet: store one</source>
        <translation>noch gibt es keinen Look: einen speichern</translation>
    </message>
    <message>
        <source>another look is called &apos;%1&apos;</source>
        <translation>ein anderer Look heißt &apos;%1&apos;</translation>
    </message>
    <message>
        <source>there is no look &apos;%1&apos;, did you mean &apos;%2&apos;?</source>
        <translation>es gibt keinen Look &apos;%1&apos;, gemeint &apos;%2&apos;?</translation>
    </message>
    <message>
        <source>there is no look &apos;%1&apos;</source>
        <translation>es gibt keinen Look &apos;%1&apos;</translation>
    </message>
    <message>
        <source>there is no palette &apos;%1&apos;, did you mean &apos;%2&apos;?</source>
        <translation>es gibt keine Palette &apos;%1&apos;, gemeint &apos;%2&apos;?</translation>
    </message>
    <message>
        <source>there is no palette &apos;%1&apos;</source>
        <translation>es gibt keine Palette &apos;%1&apos;</translation>
    </message>
    <message>
        <source>is open in another window: %1; close it there, or take it over (in a script: take-over)</source>
        <translation>ist in einem anderen Fenster offen: %1; dort schließen oder übernehmen (im Skript: take-over)</translation>
    </message>
    <message>
        <source>changes of an earlier time wait: take them or drop them first (Edit menu)</source>
        <translation>frühere Änderungen warten: zuerst übernehmen oder verwerfen (Menü Bearbeiten)</translation>
    </message>
    <message>
        <source>another window has the show, and what is not saved here is kept nowhere</source>
        <translation>ein anderes Fenster hat die Show, und was hier nicht gesichert ist, wird nirgends aufgehoben</translation>
    </message>
    <message>
        <source>%1: nobody can say whether another program changed it; save yours over it (in a script: save over), or save a copy</source>
        <translation>%1: niemand kann sagen, ob ein anderes Programm sie geändert hat; den eigenen Stand darüber sichern (im Skript: save over) oder eine Kopie sichern</translation>
    </message>
    <message>
        <source>was changed by another program since it was read here: take what the file says, or save yours over it (in a script: reload, save over)</source>
        <translation>wurde von einem anderen Programm geändert, seit sie hier gelesen wurde: Stand der Datei übernehmen oder den eigenen darüber sichern (im Skript: reload, save over)</translation>
    </message>
    <message>
        <source>is the show file itself, which &apos;save&apos; writes</source>
        <translation>ist die Showdatei selbst, die &apos;save&apos; schreibt</translation>
    </message>
    <message>
        <source>there are no changes of an earlier time</source>
        <translation>es gibt keine früheren Änderungen</translation>
    </message>
    <message>
        <source>no other window has this show open</source>
        <translation>kein anderes Fenster hat diese Show offen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is none of lux, luminance and off</source>
        <translation>&apos;%1&apos; ist keines von lux, luminance und off</translation>
    </message>
    <message>
        <source>the largest value must be at least half as large again as the least</source>
        <translation>der größte Wert muss mindestens anderthalbmal so groß sein wie der kleinste</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is none of on, off and a place X Y</source>
        <translation>&apos;%1&apos; ist nicht on, off oder ein Ort X Y</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is none of on, off and auto</source>
        <translation>&apos;%1&apos; ist nicht on, off oder auto</translation>
    </message>
    <message>
        <source>another show was opened: no fixture file is substituted</source>
        <translation>eine andere Show wurde geöffnet: keine Gerätedatei wird ersetzt</translation>
    </message>
    <message>
        <source>the plot was not imported: no fixture file is substituted</source>
        <translation>der Plan wurde nicht importiert: keine Gerätedatei wird ersetzt</translation>
    </message>
    <message>
        <source>no show is open, or it is still being looked through</source>
        <translation>keine Show ist offen, oder sie wird noch durchgesehen</translation>
    </message>
    <message>
        <source>the page of the plot has no fixtures of a file, a kind or a title called so</source>
        <translation>der Planbericht hat keine Geräte einer Datei, einer Art oder eines Titels dieses Namens</translation>
    </message>
    <message>
        <source>it needs the file to stand in, too</source>
        <translation>es braucht auch die Ersatzdatei</translation>
    </message>
    <message>
        <source>there is no fixture file that seems to be the same</source>
        <translation>keine Gerätedatei scheint dieselbe zu sein</translation>
    </message>
    <message>
        <source>there is one display only; View has &apos;The picture in a second window&apos; (in a script: second-display window)</source>
        <translation>es gibt nur einen Bildschirm; unter Ansicht: &apos;Das Bild in einem zweiten Fenster&apos; (im Skript: second-display window)</translation>
    </message>
    <message>
        <source>there is no display &apos;%1&apos;; there are %2</source>
        <translation>es gibt keinen Bildschirm &apos;%1&apos;; es gibt %2</translation>
    </message>
    <message>
        <source>there is no folder &apos;demo&apos; beside this program (assets/demo, or share/ghostlight/demo)</source>
        <translation>es gibt keinen Ordner &apos;demo&apos; neben diesem Programm (assets/demo oder share/ghostlight/demo)</translation>
    </message>
    <message>
        <source>no plot came from the network (MVR-xchange)</source>
        <translation>aus dem Netzwerk kam kein Plan (MVR-xchange)</translation>
    </message>
    <message>
        <source>the picture cannot be written</source>
        <translation>das Bild lässt sich nicht schreiben</translation>
    </message>
    <message>
        <source>changes are saved nowhere: save a copy elsewhere, or close and lose them (in a script: quit anyway)</source>
        <translation>Änderungen sind nirgends gesichert: anderswo eine Kopie sichern oder schließen und sie verlieren (im Skript: quit anyway)</translation>
    </message>
    <message>
        <source>there is nothing to undo</source>
        <translation>nichts rückgängig zu machen</translation>
    </message>
    <message>
        <source>there is nothing to redo</source>
        <translation>nichts zu wiederholen</translation>
    </message>
    <message>
        <source>this window keeps nothing: it was started with --forget</source>
        <translation>dieses Fenster behält nichts: Es wurde mit --forget gestartet</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, expected off, or a port like 8010 or 0.0.0.0:8010</source>
        <translation>&apos;%1&apos;, erwartet off oder ein Port wie 8010 oder 0.0.0.0:8010</translation>
    </message>
    <message>
        <source>nothing listens to browsers: View, In browsers...</source>
        <translation>nichts hört auf Browser: Ansicht, In Browsern ...</translation>
    </message>
    <message>
        <source>bounced light is &apos;%1&apos;, expected %2</source>
        <translation>indirektes Licht ist &apos;%1&apos;, erwartet %2</translation>
    </message>
    <message>
        <source>haze is &apos;%1&apos;, expected one of %2</source>
        <translation>Dunst ist &apos;%1&apos;, erwartet eines von %2</translation>
    </message>
    <message>
        <source>it needs the name of a folder</source>
        <translation>es braucht den Namen eines Ordners</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is none of 8, 16 and 24 bits</source>
        <translation>&apos;%1&apos; ist nicht 8, 16 oder 24 Bit</translation>
    </message>
    <message>
        <source>does not lie like a truss or a pipe, so no hoists hold it</source>
        <translation>liegt nicht wie eine Traverse oder ein Rohr, also hängt es an keinen Zügen</translation>
    </message>
    <message>
        <source>goes with mover &apos;%1&apos; already</source>
        <translation>fährt schon mit dem bewegten Teil &apos;%1&apos;</translation>
    </message>
    <message>
        <source>is the name of another mover</source>
        <translation>so heißt schon ein anderes bewegtes Teil</translation>
    </message>
    <message>
        <source>nothing that a mover carries is selected: click a lamp on it, or double click it</source>
        <translation>nichts ist ausgewählt, was ein bewegtes Teil trägt: ein Gerät darauf anklicken oder das Teil doppelklicken</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither commanded nor machine</source>
        <translation>&apos;%1&apos; ist weder commanded noch machine</translation>
    </message>
    <message>
        <source>there is no such fixture any more</source>
        <translation>dieses Gerät gibt es nicht mehr</translation>
    </message>
    <message>
        <source>the fixture has no such mode any more</source>
        <translation>diesen Modus hat das Gerät nicht mehr</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, expected off, read or edit</source>
        <translation>&apos;%1&apos;, erwartet off, read oder edit</translation>
    </message>
    <message>
        <source>&apos;%1&apos; would end at channel %2 of its universe, expected at most 512</source>
        <translation>&apos;%1&apos; würde auf Kanal %2 seines Universums enden, erwartet höchstens 512</translation>
    </message>
    <message>
        <source>has no [[mover]] &apos;%1&apos;</source>
        <translation>hat kein [[mover]] &apos;%1&apos;</translation>
    </message>
    <message>
        <source>has an axis of &apos;%1&apos; that cannot be read; mend it there first</source>
        <translation>hat eine Achse von &apos;%1&apos;, die nicht lesbar ist; zuerst dort richten</translation>
    </message>
    <message>
        <source>has an axis of &apos;%1&apos; that is no table</source>
        <translation>hat eine Achse von &apos;%1&apos;, die keine Tabelle ist</translation>
    </message>
    <message>
        <source>this machine alone</source>
        <translation>nur dieser Rechner</translation>
    </message>
    <message>
        <source>%1. Art-Net that a desk broadcasts to %2 (one in %3 with the mask 255.0.0.0) does not arrive at our address and mask, which take %4 and 255.255.255.255: give both machines one network and one mask</source>
        <translation>%1. Art-Net, das ein Pult an %2 sendet (eines in %3 mit der Maske 255.0.0.0), kommt bei unserer Adresse und Maske nicht an, die %4 und 255.255.255.255 annehmen: beiden Rechnern ein Netz und eine Maske geben</translation>
    </message>
    <message>
        <source>baked pictures are turned off</source>
        <translation>vorberechnete Bilder sind ausgeschaltet</translation>
    </message>
    <message>
        <source>light bounces</source>
        <translation>indirektes Licht ist an</translation>
    </message>
    <message>
        <source>the work light is on</source>
        <translation>das Arbeitslicht ist an</translation>
    </message>
    <message>
        <source>a share of the pixels is asked for</source>
        <translation>ein Anteil der Pixel ist gewünscht</translation>
    </message>
    <message>
        <source>lux are measured on surfaces</source>
        <translation>auf Flächen werden Lux gemessen</translation>
    </message>
    <message>
        <source>objects are hidden or shown by hand</source>
        <translation>Objekte sind von Hand aus- oder eingeblendet</translation>
    </message>
    <message>
        <source>surfaces are set by hand</source>
        <translation>Oberflächen sind von Hand gesetzt</translation>
    </message>
    <message>
        <source>air, even light or shadows are set by hand</source>
        <translation>Luft, Grundlicht oder Schatten sind von Hand gesetzt</translation>
    </message>
    <message>
        <source>a remote control sets the haze</source>
        <translation>eine Fernsteuerung stellt den Nebel</translation>
    </message>
    <message>
        <source>a mover is not where the model has it</source>
        <translation>ein bewegtes Teil ist nicht, wo das Modell es hat</translation>
    </message>
    <message>
        <source>a fixture identifies itself</source>
        <translation>ein Gerät gibt sich zu erkennen</translation>
    </message>
    <message>
        <source>trackers may move what is on stage</source>
        <translation>Tracker können bewegen, was auf der Bühne steht</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is none of name, number, look, at, camera, flight, fade, follow, page and notes</source>
        <translation>&apos;%1&apos; ist keines von name, number, look, at, camera, flight, fade, follow, page und notes</translation>
    </message>
    <message>
        <source>universe %1 comes with %2, and %3 of the fixture lie past these (is it patched on the desk?), and %4</source>
        <translation>Universum %1 bringt %2, und %3 des Geräts liegen dahinter (ist es am Pult gepatcht?), und %4</translation>
    </message>
    <message>
        <source>universe %1 comes with %2, and %3 of the fixture lie past these (is it patched on the desk?)</source>
        <translation>Universum %1 bringt %2, und %3 des Geräts liegen dahinter (ist es am Pult gepatcht?)</translation>
    </message>
    <message>
        <source>their universe %1 comes with fewer channels</source>
        <translation>ihr Universum %1 kommt mit weniger Kanälen</translation>
    </message>
    <message>
        <source>two senders have one identity (CID) on %1: %2 and one at %3 that sends other packets. The first is shown, the second is dropped. One is a copy of the other (a cloned disk, a copied set-up): give it a CID of its own</source>
        <translation>zwei Sender haben auf %1 eine Identität (CID): %2 und einer auf %3, der andere Pakete sendet. Der erste wird gezeigt, der zweite verworfen. Einer ist eine Kopie des anderen (eine geklonte Platte, eine kopierte Einrichtung): ihm eine eigene CID geben</translation>
    </message>
    <message>
        <source>%1 does not count its packets up on %2: %3 of %4 a second are dropped as late or twice, for their sequence number stands still or counts down. The look follows in jumps until this sender is mended</source>
        <translation>%1 zählt seine Pakete auf %2 nicht hoch: %3 von %4 in der Sekunde werden als verspätet oder doppelt verworfen, denn ihre laufende Nummer steht oder zählt abwärts. Das Bild folgt in Sprüngen, bis dieser Sender in Ordnung ist</translation>
    </message>
    <message>
        <source>%1 comes with %2, and %3 (%4) is patched past these: not patched on the desk?</source>
        <translation>%1 bringt %2, und %3 (%4) ist dahinter gepatcht: am Pult nicht gepatcht?</translation>
    </message>
    <message>
        <source>%1 comes with %2, and %3 (%4) are patched past these: not patched on the desk?</source>
        <translation>%1 bringt %2, und %3 (%4) sind dahinter gepatcht: am Pult nicht gepatcht?</translation>
    </message>
    <message>
        <source>%1. %2 has a cable and no IPv4 address (no DHCP server answers, perhaps): for Art-Net, and for sACN by IPv4, it needs one in the desk&apos;s network</source>
        <translation>%1. %2 hat ein Kabel und keine IPv4-Adresse (vielleicht antwortet kein DHCP-Server): für Art-Net, und für sACN über IPv4, braucht sie eine im Netz des Pults</translation>
    </message>
    <message>
        <source>%1. %2 gave itself %3, as a machine does that no DHCP server answers: for Art-Net the desk has to be in 169.254.x.x, too</source>
        <translation>%1. %2 hat sich selbst %3 gegeben, wie ein Rechner es tut, dem kein DHCP-Server antwortet: für Art-Net muss auch das Pult in 169.254.x.x sein</translation>
    </message>
    <message>
        <source>a second attribute named &apos;%1&apos;, links mean the first</source>
        <translation>ein zweites Attribut namens &apos;%1&apos;; Verweise meinen das erste</translation>
    </message>
    <message>
        <source>the picture %1 is not in the archive</source>
        <translation>das Bild %1 ist nicht im Archiv</translation>
    </message>
    <message>
        <source>the texture &apos;%1&apos; is not in the archive</source>
        <translation>die Textur &apos;%1&apos; ist nicht im Archiv</translation>
    </message>
    <message>
        <source>mesh &apos;%1&apos; is not in the archive</source>
        <translation>das Modell &apos;%1&apos; ist nicht im Archiv</translation>
    </message>
    <message>
        <source>gobo &apos;%1&apos; is not in the archive</source>
        <translation>das Gobo &apos;%1&apos; ist nicht im Archiv</translation>
    </message>
    <message>
        <source>no Beam or Laser geometry in mode &apos;%1&apos;: it gives no light</source>
        <translation>keine Beam- oder Laser-Geometrie im Modus &apos;%1&apos;: Er gibt kein Licht</translation>
    </message>
    <message>
        <source>objects with edges of more than two triangles, of which none is inside or outside; they are drawn as they are: %1</source>
        <translation>Objekte mit Kanten an mehr als zwei Dreiecken, die weder innen noch außen haben; sie werden gezeichnet, wie sie sind: %1</translation>
    </message>
    <message>
        <source>objects with triangles that have no area; those are not seen: %1</source>
        <translation>Objekte mit Dreiecken ohne Fläche; diese sind nicht zu sehen: %1</translation>
    </message>
    <message>
        <source>objects are mirrored (negative scale), and so are the pictures on them: %1</source>
        <translation>Objekte sind gespiegelt (negativer Maßstab) und mit ihnen die Bilder darauf: %1</translation>
    </message>
    <message>
        <source>objects of more than a million triangles, which take long to draw and to trace: %1</source>
        <translation>Objekte mit mehr als einer Million Dreiecken, die lange zu zeichnen und zu verfolgen sind: %1</translation>
    </message>
    <message>
        <source>objects without normals get smooth ones: %1</source>
        <translation>Objekte ohne Normalen bekommen glatte: %1</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1 (and so in %2 more files)</source>
        <translation>%1 (ebenso in %2 weiteren Dateien)</translation>
    </message>
    <message>
        <source>not used, as neither picture nor motion needs it: %1</source>
        <translation>nicht gebraucht, weder für das Bild noch für Bewegung: %1</translation>
    </message>
    <message>
        <source>%1 values of %2</source>
        <translation>%1 Werte von %2</translation>
    </message>
    <message>
        <source>%1 (%2 fixtures need it)</source>
        <translation>%1 (%2 Geräte brauchen sie)</translation>
    </message>
    <message>
        <source>%1 (%2 fixture needs it)</source>
        <translation>%1 (%2 Gerät braucht sie)</translation>
    </message>
    <message>
        <source>fixture file &apos;%1&apos; is not in the archive</source>
        <translation>die Gerätedatei &apos;%1&apos; ist nicht im Archiv</translation>
    </message>
    <message>
        <source>fixture file &apos;%1&apos; is not in the archive, did you mean &apos;%2&apos;?</source>
        <translation>die Gerätedatei &apos;%1&apos; ist nicht im Archiv, gemeint &apos;%2&apos;?</translation>
    </message>
    <message>
        <source>element %1 means nothing to MVR 1.6 in %2; kept for the export</source>
        <translation>das Element %1 bedeutet in MVR 1.6 unter %2 nichts; für den Export behalten</translation>
    </message>
    <message>
        <source>%1 is &apos;%2&apos;, expected a number from %3 to %4, taking %5</source>
        <translation>%1 ist &apos;%2&apos;, erwartet eine Zahl von %3 bis %4, genommen %5</translation>
    </message>
    <message>
        <source>no mesh &apos;%1&apos; (.glb or .3ds) in models/, taking the primitive</source>
        <translation>kein Modell &apos;%1&apos; (.glb oder .3ds) in models/, genommen ist die einfache Form</translation>
    </message>
    <message>
        <source>%1 fixtures share their name with others and are called &apos;%2&apos; and so on: %3</source>
        <translation>%1 Geräte haben ihren Namen mit anderen gemeinsam und heißen &apos;%2&apos; und so weiter: %3</translation>
    </message>
    <message>
        <source>%1 has no physical range, taking %2 to %3 degrees</source>
        <translation>%1 hat keinen physikalischen Bereich, genommen sind %2 bis %3 Grad</translation>
    </message>
    <message>
        <source>Zoom has no physical range: the beam keeps its %1 degrees</source>
        <translation>Zoom hat keinen physikalischen Bereich: Der Strahl behält seine %1 Grad</translation>
    </message>
    <message>
        <source>an animation wheel whose sets are named as a way into the beam moves in; the names are believed (%1 functions)</source>
        <translation>ein Animationsrad, dessen Sets nach einem Weg in den Strahl heißen, fährt ein; den Namen wird geglaubt (%1 Funktionen)</translation>
    </message>
    <message>
        <source>the focus is named far at its low end, which is near here; the names are believed (%1 functions)</source>
        <translation>der Fokus heißt an seinem unteren Ende fern, das hier nah ist; den Namen wird geglaubt (%1 Funktionen)</translation>
    </message>
    <message>
        <source>a colour temperature whose sets are named in kelvin and state no value; the names are believed (%1 functions)</source>
        <translation>eine Farbtemperatur, deren Sets nach Kelvin heißen und keinen Wert nennen; den Namen wird geglaubt (%1 Funktionen)</translation>
    </message>
    <message>
        <source>a frost whose sets are named in per cent and state no value; the names are believed, and what pulses is drawn half in (%1 functions)</source>
        <translation>ein Frost, dessen Sets nach Prozenten heißen und keinen Wert nennen; den Namen wird geglaubt, und was pulsiert, ist halb eingefahren gezeichnet (%1 Funktionen)</translation>
    </message>
    <message>
        <source>a rotation has a speed where its name says that there is none; the names are believed (%1 functions)</source>
        <translation>eine Drehung hat eine Geschwindigkeit, wo ihr Name sagt, dass keine ist; den Namen wird geglaubt (%1 Funktionen)</translation>
    </message>
    <message>
        <source>the rate of a pulsing iris falls where its name says that it gets faster; taken for the seconds of a pulse (%1 functions)</source>
        <translation>die Rate einer pulsierenden Iris fällt, wo ihr Name sagt, dass sie schneller wird; genommen als Sekunden eines Pulses (%1 Funktionen)</translation>
    </message>
    <message>
        <source>a prism without facets; drawn as %1, by its name or as most are</source>
        <translation>ein Prisma ohne Facetten; gezeichnet mit %1, nach seinem Namen oder wie die meisten</translation>
    </message>
    <message>
        <source>there is no Symdef &apos;%1&apos;; nothing is drawn</source>
        <translation>es gibt kein Symdef &apos;%1&apos;; nichts wird gezeichnet</translation>
    </message>
    <message>
        <source>text &apos;%1&apos; is taken as a Source of type File</source>
        <translation>der Text &apos;%1&apos; gilt als Source vom Typ File</translation>
    </message>
    <message>
        <source>expected %1, found &apos;%2&apos;; taken as %3</source>
        <translation>erwartet %1, gefunden &apos;%2&apos;; genommen %3</translation>
    </message>
    <message>
        <source>the matrix flattens what it places (its determinant is 0)</source>
        <translation>die Matrix drückt flach, was sie platziert (ihre Determinante ist 0)</translation>
    </message>
    <message>
        <source>channels &apos;%1&apos; and &apos;%2&apos; both use byte %3 of break %4</source>
        <translation>die Kanäle &apos;%1&apos; und &apos;%2&apos; benutzen beide Byte %3 von Break %4</translation>
    </message>
    <message>
        <source>Symdef without a ChildList; its geometries are read all the same</source>
        <translation>Symdef ohne ChildList; seine Geometrien werden trotzdem gelesen</translation>
    </message>
    <message>
        <source>the %1 that %2 names does not exist</source>
        <translation>ein Objekt %1, das %2 nennt, gibt es nicht</translation>
    </message>
    <message>
        <source>these objects are in no Layer; they are put in one without a name</source>
        <translation>diese Objekte sind in keinem Layer; sie kommen in einen ohne Namen</translation>
    </message>
    <message>
        <source>mode &apos;%1&apos; takes no DMX: all its channels are virtual</source>
        <translation>der Modus &apos;%1&apos; nimmt kein DMX: Alle seine Kanäle sind virtuell</translation>
    </message>
    <message>
        <source>the channel&apos;s geometry &apos;%1&apos; is not in this mode&apos;s tree</source>
        <translation>die Geometrie &apos;%1&apos; des Kanals ist nicht im Baum dieses Modus</translation>
    </message>
    <message>
        <source>GDTFSpec &apos;%1&apos;: taken is &apos;%2&apos;</source>
        <translation>GDTFSpec &apos;%1&apos;: genommen ist &apos;%2&apos;</translation>
    </message>
    <message>
        <source>%1 fixture of %2 type, patched in %3 universes</source>
        <translation>%1 Gerät von %2 Typ, gepatcht in %3 Universen</translation>
    </message>
    <message>
        <source>%1 deg</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>%1; %2: packets without a single level</source>
        <translation>%1; %2: Pakete ohne einen einzigen Wert</translation>
    </message>
    <message>
        <source>%1; %2: only priorities per address (start code 0xDD), no levels</source>
        <translation>%1; %2: nur Prioritäten je Adresse (Startcode 0xDD), keine Werte</translation>
    </message>
    <message>
        <source>%1 comes from more than one source of equal priority, %2, and they differ on up to %3: %4. %5 sends 0 alone: if that is a black-out, the others hide it</source>
        <translation>%1 kommt von mehr als einer Quelle gleicher Priorität, %2, und sie unterscheiden sich um bis zu %3: %4. %5 sendet nur 0: wenn das ein Blackout ist, verdecken ihn die anderen</translation>
    </message>
    <message>
        <source>%1 comes from more than one source of equal priority, %2, and they differ on up to %3: %4. %5 has all dimmers at 0: if that is a black-out, the others hide it</source>
        <translation>%1 kommt von mehr als einer Quelle gleicher Priorität, %2, und sie unterscheiden sich um bis zu %3: %4. %5 hat alle Dimmer auf 0: wenn das ein Blackout ist, verdecken ihn die anderen</translation>
    </message>
    <message>
        <source>%1 come from more than one source of equal priority, %2, and they differ on up to %3: %4. %5 sends 0 alone: if that is a black-out, the others hide it</source>
        <translation>%1 kommen von mehr als einer Quelle gleicher Priorität, %2, und sie unterscheiden sich um bis zu %3: %4. %5 sendet nur 0: wenn das ein Blackout ist, verdecken ihn die anderen</translation>
    </message>
    <message>
        <source>%1 come from more than one source of equal priority, %2, and they differ on up to %3: %4. %5 has all dimmers at 0: if that is a black-out, the others hide it</source>
        <translation>%1 kommen von mehr als einer Quelle gleicher Priorität, %2, und sie unterscheiden sich um bis zu %3: %4. %5 hat alle Dimmer auf 0: wenn das ein Blackout ist, verdecken ihn die anderen</translation>
    </message>
    <message>
        <source>packets of %1 on %2 come in two rows of numbers, or one of them without any, with different levels: two programs send there as one, or one that gives two packets one number (a base and an effect). Now the look of this shows, now of that. Of two, close one, or give it an identity of its own (sACN: a CID, Art-Net: an address)</source>
        <translation>die Pakete von %1 auf %2 kommen in zwei Zahlenreihen, oder eine davon ohne Nummern, mit verschiedenen Werten: zwei Programme senden dort als eines, oder eines, das zwei Paketen eine Nummer gibt (Grundstand und Effekt). Gezeigt wird bald der Stand des einen, bald der des anderen. Von zweien eines schließen oder ihm eine eigene Identität geben (sACN: eine CID, Art-Net: eine Adresse)</translation>
    </message>
    <message>
        <source>the packets of %1 on %2 come by turns from the ports %3 and %4 with different levels: two programs send there as one, or one by two sockets. Now the look of this shows, now of that. Of two, close one, or give it an identity of its own (sACN: a CID, Art-Net: an address)</source>
        <translation>die Pakete von %1 auf %2 kommen abwechselnd von den Ports %3 und %4 mit verschiedenen Werten: zwei Programme senden dort als eines, oder eines über zwei Sockets. Gezeigt wird bald der Stand des einen, bald der des anderen. Von zweien eines schließen oder ihm eine eigene Identität geben (sACN: eine CID, Art-Net: eine Adresse)</translation>
    </message>
    <message>
        <source>%1 channels (%2 in some packets)</source>
        <translation>%1 Kanäle (%2 in manchen Paketen)</translation>
    </message>
    <message>
        <source>%1 channel (%2 in some packets)</source>
        <translation>%1 Kanal (%2 in manchen Paketen)</translation>
    </message>
    <message>
        <source>%1. A desk on this very machine has to send unicast to 127.0.0.1: multicast of QLC+ does not come back here</source>
        <translation>%1. Ein Pult auf ebendiesem Rechner muss Unicast an 127.0.0.1 senden: Multicast von QLC+ kommt hier nicht zurück</translation>
    </message>
    <message>
        <source>%1 other packets did (%2)</source>
        <translation>%1 andere Pakete ankommen (%2)</translation>
    </message>
    <message>
        <source>%1 other packet did (%2)</source>
        <translation>%1 anderes Paket ankommt (%2)</translation>
    </message>
    <message>
        <source>%1 on universe %2</source>
        <translation>%1 auf Universum %2</translation>
    </message>
    <message>
        <source>%1 fixtures</source>
        <translation>%1 Geräte</translation>
    </message>
    <message>
        <source>%1 fixture</source>
        <translation>%1 Gerät</translation>
    </message>
    <message>
        <source>universe %1 is lost: its last packet came %2 s ago and it went black (--on-loss), and %3</source>
        <translation>Universum %1 ist verloren: Sein letztes Paket kam vor %2 s, und es wurde schwarz (--on-loss), und %3</translation>
    </message>
    <message>
        <source>universe %1 is lost: its last packet came %2 s ago and it went black (--on-loss)</source>
        <translation>Universum %1 ist verloren: Sein letztes Paket kam vor %2 s, und es wurde schwarz (--on-loss)</translation>
    </message>
    <message>
        <source>nothing comes for %1 any more, since %2: the last look is held. Packets still come, without levels</source>
        <translation>für %1 kommt seit %2 nichts mehr: das letzte Bild wird gehalten. Es kommen noch Pakete, ohne Werte</translation>
    </message>
    <message>
        <source>nothing comes for %1 any more, since %2: the last look is held. Its desk said that it ends this stream: its output was switched off, or its program closed</source>
        <translation>seit %2 kommt nichts mehr für %1: das letzte Bild wird gehalten. Sein Pult hat gesagt, dass es diesen Strom beendet: sein Ausgang wurde abgeschaltet oder sein Programm beendet</translation>
    </message>
    <message>
        <source>nothing comes for %1 any more, since %2: black (--on-loss). Its desk said that it ends this stream: its output was switched off, or its program closed</source>
        <translation>seit %2 kommt nichts mehr für %1: schwarz (--on-loss). Sein Pult hat gesagt, dass es diesen Strom beendet: sein Ausgang wurde abgeschaltet oder sein Programm beendet</translation>
    </message>
    <message>
        <source>nothing comes for %1 any more, since %2: black (--on-loss). Packets still come, without levels</source>
        <translation>für %1 kommt seit %2 nichts mehr: schwarz (--on-loss). Es kommen noch Pakete, ohne Werte</translation>
    </message>
    <message>
        <source>%1 declares more levels on %2 than its packets hold, or than 512; those that come are used</source>
        <translation>%1 kündigt auf %2 mehr Werte an, als seine Pakete enthalten, oder als 512; die vorhandenen gelten</translation>
    </message>
    <message>
        <source>packets for %1 arrive (%2), nothing is patched there; the show wants %3; %4 is %5 with its two bytes exchanged: the sender writes universe numbers in the wrong order of bytes</source>
        <translation>Pakete für %1 kommen an (%2), dort ist nichts gepatcht; die Show will %3; %4 ist %5 mit vertauschten Bytes: der Sender schreibt Nummern von Universen in der falschen Reihenfolge der Bytes</translation>
    </message>
    <message>
        <source>nothing comes for %1 any more, since %2: the last look is held. %3: cable pulled %4 ago, which may be why</source>
        <translation>seit %2 kommt nichts mehr für %1: das letzte Bild wird gehalten. %3: vor %4 wurde das Kabel gezogen, was der Grund sein kann</translation>
    </message>
    <message>
        <source>nothing comes for %1 any more, since %2: black (--on-loss). %3: cable pulled %4 ago, which may be why</source>
        <translation>seit %2 kommt nichts mehr für %1: schwarz (--on-loss). %3: vor %4 wurde das Kabel gezogen, was der Grund sein kann</translation>
    </message>
    <message>
        <source>nothing comes for %1 any more, since %2: the last look is held. %3: gone %4 ago, which may be why</source>
        <translation>seit %2 kommt nichts mehr für %1: das letzte Bild wird gehalten. %3: seit %4 fort, was der Grund sein kann</translation>
    </message>
    <message>
        <source>nothing comes for %1 any more, since %2: black (--on-loss). %3: gone %4 ago, which may be why</source>
        <translation>seit %2 kommt nichts mehr für %1: schwarz (--on-loss). %3: seit %4 fort, was der Grund sein kann</translation>
    </message>
    <message>
        <source>%1 is not shown on %2: %3 has a higher priority, and sends 0 alone</source>
        <translation>%1 wird auf %2 nicht gezeigt: %3 hat eine höhere Priorität und sendet nur 0</translation>
    </message>
    <message>
        <source>%1 is not shown on %2: %3 has a higher priority, and has all dimmers at 0</source>
        <translation>%1 wird auf %2 nicht gezeigt: %3 hat eine höhere Priorität und alle Dimmer auf 0</translation>
    </message>
    <message>
        <source>%1 gives %2 of %3 on universe %4 away (priority per address 0), and nobody else sends them: their levels are not used. Are they patched on the desk?</source>
        <translation>%1 gibt %2 von %3 auf Universum %4 ab (Priorität 0 je Adresse), und niemand sonst sendet sie: ihre Werte gelten nicht. Sind sie auf dem Pult gepatcht?</translation>
    </message>
    <message>
        <source>%1 patched channels</source>
        <translation>%1 gepatchten Kanälen</translation>
    </message>
    <message>
        <source>%1 patched channel</source>
        <translation>%1 gepatchten Kanal</translation>
    </message>
    <message>
        <source>levels of %1 on %2 wait for a synchronisation packet that does not come, or seldom; after %3 at most they show without</source>
        <translation>Werte von %1 auf %2 warten auf ein Synchronisationspaket, das nicht oder selten kommt; nach höchstens %3 gelten sie ohne</translation>
    </message>
    <message>
        <source>%1 sends %2 to the multicast group of another universe; the levels are used as those of %3</source>
        <translation>%1 sendet %2 an die Multicast-Gruppe eines anderen Universums; die Werte gelten als die von %3</translation>
    </message>
    <message>
        <source>%1. The reverse path filter of this machine dropped %2 in the last seconds, of senders that it would not answer by the card that they came by: if they are the desk&apos;s, give that card an address in the desk&apos;s network (or, as root: sysctl -w net.ipv4.conf.all.rp_filter=2, and the same for the card)</source>
        <translation>%1. Der Rückwegfilter (rp_filter) dieses Rechners hat in den letzten Sekunden %2 verworfen, von Sendern, denen er nicht über die Karte antworten würde, über die sie kamen: sind es die des Pults, dieser Karte eine Adresse im Netz des Pults geben (oder, als root: sysctl -w net.ipv4.conf.all.rp_filter=2, und dasselbe für die Karte)</translation>
    </message>
    <message>
        <source>%1 packets</source>
        <translation>%1 Pakete</translation>
    </message>
    <message>
        <source>%1 packet</source>
        <translation>%1 Paket</translation>
    </message>
    <message>
        <source>%1 overrides %2, which would light it: on %3 it sends %4 instead of %5</source>
        <translation>%1 geht %2 vor, das es leuchten ließe: auf %3 sendet es %4 statt %5</translation>
    </message>
    <message>
        <source>%1 overrides %2: on %3 it sends %4 instead of %5</source>
        <translation>%1 geht %2 vor: auf %3 sendet es %4 statt %5</translation>
    </message>
    <message>
        <source>%1 and %2 have the same say: on %3 they send %4 and %5, and %6 shows, for it changed last (LTP); the first alone would light it</source>
        <translation>%1 und %2 haben gleich viel zu sagen: auf %3 senden sie %4 und %5, und %6 gilt, denn es hat sich zuletzt geändert (LTP); das erste allein ließe es leuchten</translation>
    </message>
    <message>
        <source>%1 and %2 have the same say: on %3 they send %4 and %5, and %6 shows, for it changed last (LTP)</source>
        <translation>%1 und %2 haben gleich viel zu sagen: auf %3 senden sie %4 und %5, und %6 gilt, denn es hat sich zuletzt geändert (LTP)</translation>
    </message>
    <message>
        <source>%1 and %2 have the same say: on %3 they send %4 and %5, and %6 shows; the first alone would light it</source>
        <translation>%1 und %2 haben gleich viel zu sagen: auf %3 senden sie %4 und %5, und %6 gilt; das erste allein ließe es leuchten</translation>
    </message>
    <message>
        <source>%1 and %2 have the same say: on %3 they send %4 and %5, and %6 shows</source>
        <translation>%1 und %2 haben gleich viel zu sagen: auf %3 senden sie %4 und %5, und %6 gilt</translation>
    </message>
    <message>
        <source>%1, priority none for this address) sends %2 on %3 but its list of priorities per address ends before that channel; nobody holds it</source>
        <translation>%1, für diese Adresse ohne Priorität) sendet %2 auf %3, aber seine Liste der Prioritäten je Adresse endet vor diesem Kanal; niemand hält ihn</translation>
    </message>
    <message>
        <source>%1, priority none for this address) sends %2 on %3 but its priority per address there is 0, or above 200, which is none; nobody holds it</source>
        <translation>%1, für diese Adresse ohne Priorität) sendet %2 auf %3, aber seine Priorität je Adresse ist dort 0 oder über 200, was keine ist; niemand hält ihn</translation>
    </message>
    <message>
        <source>%1, priority none for this address) sends %2 on %3 but says by its priority per address that the channel is not its own; nobody holds it</source>
        <translation>%1, für diese Adresse ohne Priorität) sendet %2 auf %3, sagt aber durch seine Priorität je Adresse, dass der Kanal nicht sein eigener ist; niemand hält ihn</translation>
    </message>
    <message>
        <source>%1, priority none for this address)</source>
        <translation>%1, für diese Adresse ohne Priorität)</translation>
    </message>
    <message>
        <source>%1, priority %2 for this address)</source>
        <translation>%1, für diese Adresse Priorität %2)</translation>
    </message>
    <message>
        <source>%1, priority %2)</source>
        <translation>%1, Priorität %2)</translation>
    </message>
    <message>
        <source>%1 is shown only in part on %2: %3 has a higher priority, and sends 0 alone</source>
        <translation>%1 wird auf %2 nur zum Teil gezeigt: %3 hat eine höhere Priorität und sendet nur 0</translation>
    </message>
    <message>
        <source>%1 is shown only in part on %2: %3 has a higher priority, and has all dimmers at 0</source>
        <translation>%1 wird auf %2 nur zum Teil gezeigt: %3 hat eine höhere Priorität und alle Dimmer auf 0</translation>
    </message>
    <message>
        <source>%1 come from more than one source of equal priority, %2, and they have up to %3 up at different times: %4. If both play these lamps, all is well; if one is a backup, it is out of step: give it a lower priority</source>
        <translation>%1 kommen von mehr als einer Quelle gleicher Priorität, %2, und sie haben bis zu %3 zu verschiedenen Zeiten oben: %4. Spielen beide diese Lampen, ist alles gut; ist eine ein Backup, so läuft es nicht im Takt: ihm eine niedrigere Priorität geben</translation>
    </message>
    <message>
        <source>%1 comes from more than one source of equal priority, %2, and they differ on up to %3: %4. None of these is now above 0 at two of them, so they may be meant to share</source>
        <translation>%1 kommt von mehr als einer Quelle gleicher Priorität, %2, und sie unterscheiden sich um bis zu %3: %4. Keiner davon ist jetzt bei zweien über 0, sie teilen ihn sich vielleicht mit Absicht</translation>
    </message>
    <message>
        <source>%1 come from more than one source of equal priority, %2, and they differ on up to %3: %4. None of these is now above 0 at two of them, so they may be meant to share</source>
        <translation>%1 kommen von mehr als einer Quelle gleicher Priorität, %2, und sie unterscheiden sich um bis zu %3: %4. Keiner davon ist jetzt bei zweien über 0, sie teilen sie sich vielleicht mit Absicht</translation>
    </message>
    <message>
        <source>packets for %1 arrive (%2), nothing is patched there; the show wants %3; %4 is %5 with its two bytes exchanged: if that is meant, the sender writes them in the wrong order</source>
        <translation>Pakete für %1 kommen an (%2), dort ist nichts gepatcht; die Show will %3; %4 ist %5 mit vertauschten Bytes: ist das gemeint, schreibt der Sender sie in der falschen Reihenfolge</translation>
    </message>
    <message>
        <source>%1 comes from more than one source of equal priority, %2, and they have up to %3 up at different times: %4. If both play these lamps, all is well; if one is a backup, it is out of step: give it a lower priority</source>
        <translation>%1 kommt von mehr als einer Quelle gleicher Priorität, %2, und sie haben bis zu %3 zu verschiedenen Zeiten oben: %4. Spielen beide diese Lampen, ist alles gut; ist eine ein Backup, so läuft es nicht im Takt: ihm eine niedrigere Priorität geben</translation>
    </message>
    <message>
        <source>%1. To tell them apart: where &apos;%2&apos; shows packets to an address of ours, to its broadcast or to the group of a universe of ours (239.255.0.1, ff18::.. for 1), a firewall or the reverse path filter of this machine drops them, or their sender has an address of ours; to another broadcast, the masks differ; to another group, it is another universe; where it shows none at all, they do not get here: a cable, another VLAN, a switch that holds multicast back (IGMP snooping without a querier), a desk that sends to other addresses alone (unicast), or one that is silent</source>
        <translation>%1. So unterscheidet man sie: wo &apos;%2&apos; Pakete an eine Adresse von uns, an deren Broadcast oder an die Gruppe eines Universums von uns zeigt (239.255.0.1, ff18::.. für 1), verwirft sie eine Firewall oder der Rückwegfilter (rp_filter) dieses Rechners, oder ihr Sender hat eine Adresse von uns; an einen anderen Broadcast, dann sind die Masken verschieden; an eine andere Gruppe, dann ist es ein anderes Universum; wo es gar keine zeigt, kommen sie nicht bis hierher: ein Kabel, ein anderes VLAN, ein Switch, der Multicast zurückhält (IGMP-Snooping ohne Querier), ein Pult, das nur an andere Adressen sendet (Unicast), oder eines, das schweigt</translation>
    </message>
    <message>
        <source>there is no DMX: %1 and no desk is listened to; all channels keep their defaults, and %2</source>
        <translation>es gibt kein DMX: %1, und auf kein Pult wird gehört; alle Kanäle behalten ihre Grundwerte, und %2</translation>
    </message>
    <message>
        <source>there is no DMX: %1 and no desk is listened to; all channels keep their defaults</source>
        <translation>es gibt kein DMX: %1, und auf kein Pult wird gehört; alle Kanäle behalten ihre Grundwerte</translation>
    </message>
    <message>
        <source>universe %1 is not in the recording, which has %2 and %3 more</source>
        <translation>Universum %1 ist nicht in der Aufzeichnung; sie hat %2 und %3 weitere</translation>
    </message>
    <message>
        <source>universe %1 is not in the recording, which has %2 and %3</source>
        <translation>Universum %1 ist nicht in der Aufzeichnung; sie hat %2 und %3</translation>
    </message>
    <message>
        <source>universe %1 never arrived in %2 s; what arrives is %3 and %4 more</source>
        <translation>Universum %1 kam in %2 s nie an; an kommen %3 und %4 weitere</translation>
    </message>
    <message>
        <source>universe %1 never arrived in %2 s; what arrives is %3 and %4</source>
        <translation>Universum %1 kam in %2 s nie an; an kommen %3 und %4</translation>
    </message>
    <message>
        <source>the dimmer on %1 of function %2, that is %3; its coarse byte is at 0 and its fine one at %4: a fader at its foot, or a desk that sends the fine byte first (16-bit order)</source>
        <translation>der Dimmer auf %1 mit Funktion %2, das ist %3; sein grobes Byte steht auf 0 und sein feines auf %4: ein Fader ganz unten oder ein Pult, das das feine Byte zuerst sendet (16-Bit-Reihenfolge)</translation>
    </message>
    <message>
        <source>gobo wheel &apos;%1&apos; stands between &apos;%2&apos; and &apos;%3&apos; and lets only %4 of the light through</source>
        <translation>das Goborad &apos;%1&apos; steht zwischen &apos;%2&apos; und &apos;%3&apos; und lässt nur %4 des Lichts durch</translation>
    </message>
    <message>
        <source>the zoom on %1, which the file calls %2: no angle of a lamp; drawn is a field of %3 deg</source>
        <translation>der Zoom auf %1, was die Datei %2 nennt: kein Winkel einer Lampe; gezeichnet wird ein Feld von %3°</translation>
    </message>
    <message>
        <source>the file gives its beam %1 deg: no angle of a lamp; drawn is a field of %2 deg</source>
        <translation>die Datei gibt seinem Strahl %1°: kein Winkel einer Lampe; gezeichnet wird ein Feld von %2°</translation>
    </message>
    <message>
        <source>its mode is not in the file: &apos;%1&apos; has no mode &apos;%2&apos;, did you mean &apos;%3&apos;? (modes: %4); it gets &apos;%5&apos;, whose channels mean other things; %6</source>
        <translation>sein Modus fehlt in der Datei: &apos;%1&apos; hat keinen Modus &apos;%2&apos;, vielleicht &apos;%3&apos;? (Modi: %4); es bekommt &apos;%5&apos;, dessen Kanäle anderes bedeuten; %6</translation>
    </message>
    <message>
        <source>its mode is not in the file: &apos;%1&apos; has no mode &apos;%2&apos;, did you mean &apos;%3&apos;? (modes: %4); it gets &apos;%5&apos;, whose channels mean other things</source>
        <translation>sein Modus fehlt in der Datei: &apos;%1&apos; hat keinen Modus &apos;%2&apos;, vielleicht &apos;%3&apos;? (Modi: %4); es bekommt &apos;%5&apos;, dessen Kanäle anderes bedeuten</translation>
    </message>
    <message>
        <source>its mode is not in the file: &apos;%1&apos; has no mode &apos;%2&apos; (modes: %3); it gets &apos;%4&apos;, whose channels mean other things; %5</source>
        <translation>sein Modus fehlt in der Datei: &apos;%1&apos; hat keinen Modus &apos;%2&apos; (Modi: %3); es bekommt &apos;%4&apos;, dessen Kanäle anderes bedeuten; %5</translation>
    </message>
    <message>
        <source>its mode is not in the file: &apos;%1&apos; has no mode &apos;%2&apos; (modes: %3); it gets &apos;%4&apos;, whose channels mean other things</source>
        <translation>sein Modus fehlt in der Datei: &apos;%1&apos; hat keinen Modus &apos;%2&apos; (Modi: %3); es bekommt &apos;%4&apos;, dessen Kanäle anderes bedeuten</translation>
    </message>
    <message>
        <source>%1. Art-Net that a desk broadcasts to 2.255.255.255 and 10.255.255.255 (one in 2.x.x.x or 10.x.x.x with the mask 255.0.0.0) does not arrive at our address and mask, which take %4 and 255.255.255.255: give both machines one network and one mask</source>
        <translation>%1. Art-Net, das ein Pult an 2.255.255.255 und 10.255.255.255 sendet (eines in 2.x.x.x oder 10.x.x.x mit der Maske 255.0.0.0), kommt bei unserer Adresse und Maske nicht an, die %4 und 255.255.255.255 annehmen: beiden Rechnern ein Netz und eine Maske geben</translation>
    </message>
    <message>
        <source>%1. Art-Net that a desk broadcasts to 2.255.255.255 and 10.255.255.255 (one in 2.x.x.x or 10.x.x.x with the mask 255.0.0.0) does not arrive at our address and mask: give both machines one network and one mask</source>
        <translation>%1. Art-Net, das ein Pult an 2.255.255.255 und 10.255.255.255 sendet (eines in 2.x.x.x oder 10.x.x.x mit der Maske 255.0.0.0), kommt bei unserer Adresse und Maske nicht an: beiden Rechnern ein Netz und eine Maske geben</translation>
    </message>
    <message>
        <source>%1. Art-Net that a desk broadcasts to %2 (one in %3 with the mask 255.0.0.0) does not arrive at our address and mask: give both machines one network and one mask</source>
        <translation>%1. Art-Net, das ein Pult an %2 sendet (eines in %3 mit der Maske 255.0.0.0), kommt bei unserer Adresse und Maske nicht an: beiden Rechnern ein Netz und eine Maske geben</translation>
    </message>
    <message>
        <source>nothing arrives: is the desk&apos;s output on, is it in this network, and is no firewall on UDP %1 and %2 in the way? We listen on %3</source>
        <translation>nichts kommt an: Ist die Ausgabe des Pults an, ist es in diesem Netzwerk, und ist keine Firewall auf UDP %1 und %2 im Weg? Gehört wird auf %3</translation>
    </message>
    <message>
        <source>nothing arrives: is the desk&apos;s output on, is it in this network, does it send to a universe of ours? We listen on %1</source>
        <translation>nichts kommt an: Ist die Ausgabe des Pults an, ist es in diesem Netzwerk, sendet es an ein Universum von uns? Gehört wird auf %1</translation>
    </message>
    <message>
        <source>no levels arrive, though %1: is the desk&apos;s output on, is it in this network, and is no firewall on UDP %2 and %3 in the way? We listen on %4</source>
        <translation>keine Werte kommen an, obwohl %1: Ist die Ausgabe des Pults an, ist es in diesem Netzwerk, und ist keine Firewall auf UDP %2 und %3 im Weg? Gehört wird auf %4</translation>
    </message>
    <message>
        <source>%1, also for %2 universes around</source>
        <translation>%1, dazu nach %2 Universen ringsum</translation>
    </message>
    <message>
        <source>%1, also for %2 universe around</source>
        <translation>%1, dazu nach %2 Universum ringsum</translation>
    </message>
    <message>
        <source>%1. With --artnet-offset %2 the first Port-Addresses have no universe</source>
        <translation>%1. Mit --artnet-offset %2 haben die ersten Port-Adressen kein Universum</translation>
    </message>
    <message>
        <source>%1. sACN has universes 1 to 63999: a desk that counts from 0 has to count from 1</source>
        <translation>%1. sACN hat die Universen 1 bis 63999: Ein Pult, das ab 0 zählt, muss ab 1 zählen</translation>
    </message>
    <message>
        <source>%1 fixtures on %2 (&apos;%3&apos;, ...), no levels arrive there (in Art-Net: Port-Address %4)</source>
        <translation>%1 Geräte auf %2 (&apos;%3&apos;, ...), dort kommen keine Werte an (in Art-Net: Port-Adresse %4)</translation>
    </message>
    <message>
        <source>%1 fixture on %2 (&apos;%3&apos;), no levels arrive there (in Art-Net: Port-Address %4)</source>
        <translation>%1 Gerät auf %2 (&apos;%3&apos;), dort kommen keine Werte an (in Art-Net: Port-Adresse %4)</translation>
    </message>
    <message>
        <source>off by one? %1 comes for %2 (from Port-Address %3 on), fixtures are on %4: %5</source>
        <translation>um eins verschoben? %1 kommt für %2 (ab Port-Adresse %3), Geräte liegen auf %4: %5</translation>
    </message>
    <message>
        <source>off by one? %1 is announced for %2 (from Port-Address %3 on) by %4, fixtures are on %5: %6</source>
        <translation>um eins verschoben? %1 ist für %2 (ab Port-Adresse %3) von %4 gemeldet, Geräte liegen auf %5: %6</translation>
    </message>
    <message>
        <source>%1; in Art-Net that is Net:Sub-Net:Universe %2, the show wants %3: the same numbers in another order</source>
        <translation>%1; in Art-Net ist das Net:Sub-Net:Universe %2, die Show will %3: dieselben Zahlen in anderer Reihenfolge</translation>
    </message>
    <message>
        <source>%1, nothing is patched there; the show wants %2</source>
        <translation>%1, dort ist nichts gepatcht; die Show will %2</translation>
    </message>
    <message>
        <source>%1, nothing is patched there</source>
        <translation>%1, dort ist nichts gepatcht</translation>
    </message>
    <message>
        <source>this machine dropped %1 in the last seconds: it is too busy, the sockets&apos; buffers are too small (as root: sysctl -w net.core.rmem_max=4194304), or somebody&apos;s packets have wrong checksums</source>
        <translation>dieser Rechner hat in den letzten Sekunden %1 verworfen: er ist überlastet, die Puffer der Sockets sind zu klein (als root: sysctl -w net.core.rmem_max=4194304), oder jemandes Pakete haben falsche Prüfsummen</translation>
    </message>
    <message>
        <source>the port is taken by %1, which does not share it; close it and try again</source>
        <translation>den Port hat %1 und teilt ihn nicht; dort schließen und neu versuchen</translation>
    </message>
    <message>
        <source>cannot listen: %1</source>
        <translation>Hören geht nicht: %1</translation>
    </message>
    <message>
        <source>%1 on universe %2 and others</source>
        <translation>%1 auf Universum %2 und andere</translation>
    </message>
    <message>
        <source>without levels</source>
        <translation>ohne Werte</translation>
    </message>
    <message>
        <source>%1, no cable), %2</source>
        <translation>%1, kein Kabel), %2</translation>
    </message>
    <message>
        <source>%1, no cable)</source>
        <translation>%1, kein Kabel)</translation>
    </message>
    <message>
        <source>no network but this machine&apos;s own</source>
        <translation>kein Netz außer dem eigenen dieses Rechners</translation>
    </message>
    <message>
        <source>%1; %2 announces %3</source>
        <translation>%1; %2 meldet %3</translation>
    </message>
    <message>
        <source>%1 announces %2</source>
        <translation>%1 meldet %2</translation>
    </message>
    <message>
        <source>%1, which --universes can name</source>
        <translation>%1, zu nennen mit --universes</translation>
    </message>
    <message>
        <source>a program of another user</source>
        <translation>ein Programm eines anderen Benutzers</translation>
    </message>
    <message>
        <source>a program (pid %1)</source>
        <translation>ein Programm (pid %1)</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>ein anderes Programm</translation>
    </message>
    <message>
        <source>%1) and others</source>
        <translation>%1) und andere</translation>
    </message>
    <message>
        <source>%1) and &apos;%2&apos; (%3)</source>
        <translation>%1) und &apos;%2&apos; (%3)</translation>
    </message>
    <message>
        <source>%1) and %2 (Art-Net)</source>
        <translation>%1) und %2 (Art-Net)</translation>
    </message>
    <message>
        <source>%1) and %2 (sACN)</source>
        <translation>%1) und %2 (sACN)</translation>
    </message>
    <message>
        <source>%1) and %2 (USB)</source>
        <translation>%1) und %2 (USB)</translation>
    </message>
    <message>
        <source>%1) and %2 more</source>
        <translation>%1) und %2 weitere</translation>
    </message>
    <message>
        <source>%1 (priority %2)</source>
        <translation>%1 (Priorität %2)</translation>
    </message>
    <message>
        <source>%1 (priority %2 at most, one for each address)</source>
        <translation>%1 (Priorität höchstens %2, eine je Adresse)</translation>
    </message>
    <message>
        <source>%1 with %2 slots at %3</source>
        <translation>%1 mit %2 Kanälen bei %3</translation>
    </message>
    <message>
        <source>%1 with %2 slot at %3</source>
        <translation>%1 mit %2 Kanal bei %3</translation>
    </message>
    <message>
        <source>%1 Hz and %2 with %3 slots at %4</source>
        <translation>%1 Hz und %2 mit %3 Kanälen bei %4</translation>
    </message>
    <message>
        <source>%1 Hz and %2 with %3 slot at %4</source>
        <translation>%1 Hz und %2 mit %3 Kanal bei %4</translation>
    </message>
    <message>
        <source>%1 Hz, %2 with %3 slots at %4</source>
        <translation>%1 Hz, %2 mit %3 Kanälen bei %4</translation>
    </message>
    <message>
        <source>%1 Hz, %2 with %3 slot at %4</source>
        <translation>%1 Hz, %2 mit %3 Kanal bei %4</translation>
    </message>
    <message>
        <source>%1 Hz and %2 more</source>
        <translation>%1 Hz und %2 weitere</translation>
    </message>
    <message>
        <source>Art-Net merges two; there %1 and %2 have the places of Art-Net, and one that is silent for %3 makes room</source>
        <translation>Art-Net mischt zwei; dort haben %1 und %2 die Plätze von Art-Net, und eines, das %3 still ist, macht Platz</translation>
    </message>
    <message>
        <source>%1 (silent for %2)</source>
        <translation>%1 (still seit %2)</translation>
    </message>
    <message>
        <source>%1, channel %2</source>
        <translation>%1, Kanal %2</translation>
    </message>
    <message>
        <source>%1 and channel %2</source>
        <translation>%1 und Kanal %2</translation>
    </message>
    <message>
        <source>channel %1 and %2 more</source>
        <translation>Kanal %1 und %2 weitere</translation>
    </message>
    <message>
        <source>%1 of break %2</source>
        <translation>%1 von Break %2</translation>
    </message>
    <message>
        <source>%1 is at its default %2</source>
        <translation>%1 steht auf dem Grundwert %2</translation>
    </message>
    <message>
        <source>%1 is at %2</source>
        <translation>%1 steht auf %2</translation>
    </message>
    <message>
        <source>channel %1, value %2</source>
        <translation>Kanal %1, Wert %2</translation>
    </message>
    <message>
        <source>%1 on channel %2</source>
        <translation>%1 auf Kanal %2</translation>
    </message>
    <message>
        <source>%1 on channel %2, value %3</source>
        <translation>%1 auf Kanal %2, Wert %3</translation>
    </message>
    <message>
        <source>the show has no recording</source>
        <translation>die Show hat keine Aufzeichnung</translation>
    </message>
    <message>
        <source>its recording %1 is missing</source>
        <translation>ihre Aufzeichnung %1 fehlt</translation>
    </message>
    <message>
        <source>cyan %1</source>
        <translation>Cyan %1</translation>
    </message>
    <message>
        <source>magenta %1</source>
        <translation>Magenta %1</translation>
    </message>
    <message>
        <source>yellow %1</source>
        <translation>Gelb %1</translation>
    </message>
    <message>
        <source>%1, magenta %2</source>
        <translation>%1, Magenta %2</translation>
    </message>
    <message>
        <source>%1 and magenta %2</source>
        <translation>%1 und Magenta %2</translation>
    </message>
    <message>
        <source>%1, yellow %2</source>
        <translation>%1, Gelb %2</translation>
    </message>
    <message>
        <source>%1 and yellow %2</source>
        <translation>%1 und Gelb %2</translation>
    </message>
    <message>
        <source>&apos;%1&apos; of &apos;%2&apos;</source>
        <translation>&apos;%1&apos; von &apos;%2&apos;</translation>
    </message>
    <message>
        <source>&apos;%1&apos; and &apos;%2&apos; of &apos;%3&apos;</source>
        <translation>&apos;%1&apos; und &apos;%2&apos; von &apos;%3&apos;</translation>
    </message>
    <message>
        <source>%1, &apos;%2&apos; of &apos;%3&apos;</source>
        <translation>%1, &apos;%2&apos; von &apos;%3&apos;</translation>
    </message>
    <message>
        <source>%1, &apos;%2&apos; and &apos;%3&apos; of &apos;%4&apos;</source>
        <translation>%1, &apos;%2&apos; und &apos;%3&apos; von &apos;%4&apos;</translation>
    </message>
    <message>
        <source>%1 and &apos;%2&apos; of &apos;%3&apos;</source>
        <translation>%1 und &apos;%2&apos; von &apos;%3&apos;</translation>
    </message>
    <message>
        <source>%1 and &apos;%2&apos; and &apos;%3&apos; of &apos;%4&apos;</source>
        <translation>%1 und &apos;%2&apos; und &apos;%3&apos; von &apos;%4&apos;</translation>
    </message>
    <message>
        <source>the colour</source>
        <translation>die Farbe</translation>
    </message>
    <message>
        <source>%1 in on channel %2</source>
        <translation>%1 eingeschoben auf Kanal %2</translation>
    </message>
    <message>
        <source>top %1</source>
        <translation>oben %1</translation>
    </message>
    <message>
        <source>right %1</source>
        <translation>rechts %1</translation>
    </message>
    <message>
        <source>bottom %1</source>
        <translation>unten %1</translation>
    </message>
    <message>
        <source>left %1</source>
        <translation>links %1</translation>
    </message>
    <message>
        <source>%1, right %2</source>
        <translation>%1, rechts %2</translation>
    </message>
    <message>
        <source>%1, bottom %2</source>
        <translation>%1, unten %2</translation>
    </message>
    <message>
        <source>%1, left %2</source>
        <translation>%1, links %2</translation>
    </message>
    <message>
        <source>what it gives</source>
        <translation>was es gibt</translation>
    </message>
    <message>
        <source>no such file %1, did you mean &apos;%2&apos;?</source>
        <translation>die Datei %1 gibt es nicht, vielleicht &apos;%2&apos;?</translation>
    </message>
    <message>
        <source>no such file %1.</source>
        <translation>die Datei %1 gibt es nicht.</translation>
    </message>
    <message>
        <source>%1 is not a plain file.</source>
        <translation>%1 ist keine gewöhnliche Datei.</translation>
    </message>
    <message>
        <source>cannot look for %1: %2.</source>
        <translation>%1 kann nicht gesucht werden: %2.</translation>
    </message>
    <message>
        <source>%1: has no DMX mode</source>
        <translation>%1: hat keinen DMX-Modus</translation>
    </message>
    <message>
        <source>&apos;%1&apos;, another kind of fixture, has the same address %2; %3</source>
        <translation>&apos;%1&apos;, ein anderer Gerätetyp, hat dieselbe Adresse %2; %3</translation>
    </message>
    <message>
        <source>%1 fixtures on %2 (&apos;%3&apos;, ...), no levels arrive there (in Art-Net: Port-Address %4); packets arrive that cannot be read (%5)</source>
        <translation>%1 Geräte auf %2 (&apos;%3&apos;, ...), dort kommen keine Werte an (in Art-Net: Port-Adresse %4); es kommen Pakete an, die nicht zu lesen sind (%5)</translation>
    </message>
    <message>
        <source>%1 fixture on %2 (&apos;%3&apos;), no levels arrive there (in Art-Net: Port-Address %4); packets arrive that cannot be read (%5)</source>
        <translation>%1 Gerät auf %2 (&apos;%3&apos;), dort kommen keine Werte an (in Art-Net: Port-Adresse %4); es kommen Pakete an, die nicht zu lesen sind (%5)</translation>
    </message>
    <message>
        <source>the dimmer on %1 of function %2, that is %3; its coarse byte is at 0 and its fine one at %4: a fader at its foot, or a desk that sends the fine byte first (16-bit order); so is %5</source>
        <translation>der Dimmer auf %1 mit Funktion %2, das ist %3; sein grobes Byte steht auf 0 und sein feines auf %4: ein Fader ganz unten oder ein Pult, das das feine Byte zuerst sendet (16-Bit-Reihenfolge); ebenso %5</translation>
    </message>
    <message>
        <source>the dimmer on %1 of function %2, that is %3; its coarse byte is at 0 and its fine one at %4: a fader at its foot, or a desk that sends the fine byte first (16-bit order); so are %5</source>
        <translation>der Dimmer auf %1 mit Funktion %2, das ist %3; sein grobes Byte steht auf 0 und sein feines auf %4: ein Fader ganz unten oder ein Pult, das das feine Byte zuerst sendet (16-Bit-Reihenfolge); ebenso %5</translation>
    </message>
    <message>
        <source>%1; %2: packets without a single level, also for %3 universes around</source>
        <translation>%1; %2: Pakete ohne einen einzigen Wert, dazu nach %3 Universen ringsum</translation>
    </message>
    <message>
        <source>%1; %2: packets without a single level, also for %3 universe around</source>
        <translation>%1; %2: Pakete ohne einen einzigen Wert, dazu nach %3 Universum ringsum</translation>
    </message>
    <message>
        <source>%1; %2: only priorities per address (start code 0xDD), no levels, also for %3 universes around</source>
        <translation>%1; %2: nur Prioritäten je Adresse (Startcode 0xDD), keine Werte, dazu nach %3 Universen ringsum</translation>
    </message>
    <message>
        <source>%1; %2: only priorities per address (start code 0xDD), no levels, also for %3 universe around</source>
        <translation>%1; %2: nur Prioritäten je Adresse (Startcode 0xDD), keine Werte, dazu nach %3 Universum ringsum</translation>
    </message>
    <message>
        <source>%1 slot at %2</source>
        <translation>%1 Kanal bei %2</translation>
    </message>
    <message>
        <source>%1 Hz, %2 with %3</source>
        <translation>%1 Hz, %2 mit %3</translation>
    </message>
    <message>
        <source>%1 beams, the brightest &apos;%2&apos;: %3 of %4</source>
        <translation>%1 Strahlen, der hellste &apos;%2&apos;: %3 von %4</translation>
    </message>
    <message>
        <source>lamp %1</source>
        <translation>Lampe %1</translation>
    </message>
    <message>
        <source>%1 x lamp %2</source>
        <translation>%1 × Lampe %2</translation>
    </message>
    <message>
        <source>dimmer %1</source>
        <translation>Dimmer %1</translation>
    </message>
    <message>
        <source>%1 x dimmer %2</source>
        <translation>%1 × Dimmer %2</translation>
    </message>
    <message>
        <source>master %1</source>
        <translation>Master %1</translation>
    </message>
    <message>
        <source>%1 x master %2</source>
        <translation>%1 × Master %2</translation>
    </message>
    <message>
        <source>shutter %1</source>
        <translation>Shutter %1</translation>
    </message>
    <message>
        <source>%1 x shutter %2</source>
        <translation>%1 × Shutter %2</translation>
    </message>
    <message>
        <source>strobe %1</source>
        <translation>Strobe %1</translation>
    </message>
    <message>
        <source>%1 x strobe %2</source>
        <translation>%1 × Strobe %2</translation>
    </message>
    <message>
        <source>mixed colour %1</source>
        <translation>gemischte Farbe %1</translation>
    </message>
    <message>
        <source>%1 x mixed colour %2</source>
        <translation>%1 × gemischte Farbe %2</translation>
    </message>
    <message>
        <source>emitters %1</source>
        <translation>Emitter %1</translation>
    </message>
    <message>
        <source>%1 x emitters %2</source>
        <translation>%1 × Emitter %2</translation>
    </message>
    <message>
        <source>colour correction %1</source>
        <translation>Farbkorrektur %1</translation>
    </message>
    <message>
        <source>%1 x colour correction %2</source>
        <translation>%1 × Farbkorrektur %2</translation>
    </message>
    <message>
        <source>colour %1</source>
        <translation>Farbe %1</translation>
    </message>
    <message>
        <source>%1 x colour %2</source>
        <translation>%1 × Farbe %2</translation>
    </message>
    <message>
        <source>picture %1</source>
        <translation>Bild %1</translation>
    </message>
    <message>
        <source>%1 x picture %2</source>
        <translation>%1 × Bild %2</translation>
    </message>
    <message>
        <source>animation wheel %1</source>
        <translation>Animationsrad %1</translation>
    </message>
    <message>
        <source>%1 x animation wheel %2</source>
        <translation>%1 × Animationsrad %2</translation>
    </message>
    <message>
        <source>gobo %1</source>
        <translation>Gobo %1</translation>
    </message>
    <message>
        <source>%1 x gobo %2</source>
        <translation>%1 × Gobo %2</translation>
    </message>
    <message>
        <source>iris %1</source>
        <translation>Iris %1</translation>
    </message>
    <message>
        <source>%1 x iris %2</source>
        <translation>%1 × Iris %2</translation>
    </message>
    <message>
        <source>blades %1</source>
        <translation>Blenden %1</translation>
    </message>
    <message>
        <source>%1 x blades %2</source>
        <translation>%1 × Blenden %2</translation>
    </message>
    <message>
        <source>other optics %1</source>
        <translation>übrige Optik %1</translation>
    </message>
    <message>
        <source>%1 x other optics %2</source>
        <translation>%1 × übrige Optik %2</translation>
    </message>
    <message>
        <source>of each channel the higher level shows (HTP; Art-Net has no priorities, sACN has)</source>
        <translation>von jedem Kanal gilt der höhere Wert (HTP; Art-Net hat keine Prioritäten, sACN hat welche)</translation>
    </message>
    <message>
        <source>either nothing is sent for %1 or it does not get here, or all of them are one off: then %2</source>
        <translation>entweder wird für %1 nichts gesendet, oder es kommt nicht an, oder alle sind um eins verschoben: dann %2</translation>
    </message>
    <message>
        <source>%1; in Art-Net that is Net:Sub-Net:Universe %2, the show wants %3: another Net</source>
        <translation>%1; in Art-Net ist das Net:Sub-Net:Universe %2, die Show will %3: ein anderes Net</translation>
    </message>
    <message>
        <source>%1; in Art-Net that is Net:Sub-Net:Universe %2, the show wants %3: another Sub-Net</source>
        <translation>%1; in Art-Net ist das Net:Sub-Net:Universe %2, die Show will %3: ein anderes Sub-Net</translation>
    </message>
    <message>
        <source>it is told to reset itself: function %1 on %2, value %3 (in the picture it does not)</source>
        <translation>es soll sich zurücksetzen (Reset): Funktion %1 auf %2, Wert %3 (im Bild tut es das nicht)</translation>
    </message>
    <message>
        <source>they are told to reset themselves</source>
        <translation>sie sollen sich zurücksetzen (Reset)</translation>
    </message>
    <message>
        <source>[[cue]] names look &apos;%1&apos;, which the show does not have, did you mean &apos;%2&apos;?</source>
        <translation>[[cue]] nennt den Look &apos;%1&apos;, den die Show nicht hat; gemeint ist &apos;%2&apos;?</translation>
    </message>
    <message>
        <source>[[cue]] names look &apos;%1&apos;, which the show does not have</source>
        <translation>[[cue]] nennt den Look &apos;%1&apos;, den die Show nicht hat</translation>
    </message>
    <message>
        <source>[[cue]] names camera &apos;%1&apos;, which the show does not have, did you mean &apos;%2&apos;?</source>
        <translation>[[cue]] nennt die Kamera &apos;%1&apos;, die die Show nicht hat; gemeint ist &apos;%2&apos;?</translation>
    </message>
    <message>
        <source>[[cue]] names camera &apos;%1&apos;, which the show does not have</source>
        <translation>[[cue]] nennt die Kamera &apos;%1&apos;, die die Show nicht hat</translation>
    </message>
    <message>
        <source>is there and is no cue book that Ghostlight made (which .ghostlight in it would tell), with &apos;%1&apos; in it: it is not replaced</source>
        <translation>ist da und ist kein Cue-Buch von Ghostlight (was .ghostlight darin sagen würde), mit &apos;%1&apos; darin: es wird nicht ersetzt</translation>
    </message>
    <message>
        <source>is there and is no paperwork that Ghostlight made (which .ghostlight in it would tell), with &apos;%1&apos; in it: it is not replaced</source>
        <translation>ist da und sind keine Unterlagen von Ghostlight (was .ghostlight darin sagen würde), mit &apos;%1&apos; darin: sie werden nicht ersetzt</translation>
    </message>
    <message>
        <source>has &apos;%1&apos;, which Ghostlight did not make: it is not replaced before that is elsewhere</source>
        <translation>hat &apos;%1&apos;, was nicht von Ghostlight ist: es wird nicht ersetzt, bevor das woanders ist</translation>
    </message>
    <message>
        <source>has &apos;%1&apos;, which somebody changed: it is not replaced before that is elsewhere</source>
        <translation>hat &apos;%1&apos;, was jemand geändert hat: es wird nicht ersetzt, bevor das woanders ist</translation>
    </message>
    <message>
        <source>a plot that is opened as it is cannot be edited; make a show of it first (in a script: import-plot)</source>
        <translation>ein direkt geöffneter Plan lässt sich nicht bearbeiten; erst eine Show daraus machen (in einem Skript: import-plot)</translation>
    </message>
    <message>
        <source>there is nothing but air to hide</source>
        <translation>dort ist nichts als Luft, die sich nicht ausblenden lässt</translation>
    </message>
    <message>
        <source>this is a fixture; Remove takes it away</source>
        <translation>das ist ein Gerät; Entfernen nimmt es weg</translation>
    </message>
    <message>
        <source>no channel of its file dims it: hands alone light it</source>
        <translation>kein Kanal seiner Datei dimmt es: es leuchtet nur von Hand</translation>
    </message>
    <message>
        <source>stand-in optics of 10000 lm and 25 degrees: its file says nothing of its own</source>
        <translation>Ersatzoptik von 10000 lm und 25 Grad: Seine Datei sagt nichts über die eigene</translation>
    </message>
    <message>
        <source>hands alone light them: no channel of their file dims them</source>
        <translation>nur von Hand zu leuchten: kein Kanal ihrer Datei dimmt sie</translation>
    </message>
    <message>
        <source>their optics are a stand-in</source>
        <translation>Ersatzoptik</translation>
    </message>
    <message>
        <source>says nothing of its light: hands alone light a stand-in</source>
        <translation>sagt nichts über sein Licht: ein Ersatz leuchtet nur von Hand</translation>
    </message>
    <message>
        <source>no Beam or Laser geometry in mode &apos;%1&apos;: taking one of 10000 lm and 25 degrees at &apos;%2&apos;, which hands alone light, as its channels have numbers for names</source>
        <translation>keine Geometrie Beam oder Laser im Modus &apos;%1&apos;: genommen wird eine von 10000 lm und 25 Grad an &apos;%2&apos;, die nur von Hand leuchtet, denn seine Kanäle haben Nummern statt Namen</translation>
    </message>
    <message>
        <source>%1 fixtures are left out, more than 10 km from most of the plot: no picture holds both: %2</source>
        <translation>%1 Geräte sind weggelassen, mehr als 10 km vom größten Teil des Plans: Kein Bild fasst beides: %2</translation>
    </message>
    <message>
        <source>%1 fixture is left out, more than 10 km from most of the plot: no picture holds both: %2</source>
        <translation>%1 Gerät ist weggelassen, mehr als 10 km vom größten Teil des Plans: Kein Bild fasst beides: %2</translation>
    </message>
    <message>
        <source>objects more than 10 km from most of the plot are left out: %1</source>
        <translation>Objekte mehr als 10 km vom größten Teil des Plans sind weggelassen: %1</translation>
    </message>
    <message>
        <source>is no show: a folder with a show.toml, a show.toml, or a plot (.mvr) can be opened</source>
        <translation>ist keine Show: Zu öffnen sind ein Ordner mit einer show.toml, eine show.toml oder ein Plan (.mvr)</translation>
    </message>
    <message>
        <source>%1 fixtures of %2 have stand-in optics, which hands alone light, as the mode has no beam: %3</source>
        <translation>%1 Geräte von %2 haben eine Ersatzoptik, die nur von Hand leuchtet, denn der Modus hat keinen Strahl: %3</translation>
    </message>
    <message>
        <source>%1 fixture of %2 has stand-in optics, which hands alone light, as the mode has no beam: %3</source>
        <translation>%1 Gerät von %2 hat eine Ersatzoptik, die nur von Hand leuchtet, denn der Modus hat keinen Strahl: %3</translation>
    </message>
    <message>
        <source>has no room beside what hangs there for %1 more; take fewer, or hang them elsewhere</source>
        <translation>hat neben dem, was dort hängt, keinen Platz für %1 mehr; weniger nehmen, oder sie woanders aufhängen</translation>
    </message>
    <message>
        <source>another plot is being imported: take it when that is done</source>
        <translation>ein anderer Plan wird importiert: noch einmal, wenn das fertig ist</translation>
    </message>
    <message>
        <source>the show that was made of the plot cannot be opened: no fixture file is substituted</source>
        <translation>die Show, die aus dem Plan wurde, lässt sich nicht öffnen: keine Gerätedatei wird ersetzt</translation>
    </message>
    <message>
        <source>its passes have %1 pixels, and the window shows it with %2</source>
        <translation>das Vorberechnete hat %1 Pixel, und das Fenster zeigt es mit %2</translation>
    </message>
    <message>
        <source>its passes need %1 MB on the device, which has not got them</source>
        <translation>das Vorberechnete braucht %1 MB auf dem Grafikgerät, die es nicht hat</translation>
    </message>
    <message>
        <source>its passes are of an earlier version of Ghostlight: bake it again, once</source>
        <translation>das Vorberechnete ist von einer früheren Version von Ghostlight: einmal neu vorberechnen</translation>
    </message>
    <message>
        <source>files of the show changed since its bake: bake it again</source>
        <translation>Dateien der Show sind seither geändert: neu vorberechnen</translation>
    </message>
    <message>
        <source>%1; run `ghostlight bake` again</source>
        <translation>%1; noch einmal `ghostlight bake` aufrufen</translation>
    </message>
    <message>
        <source>belongs to another bake than manifest.json says</source>
        <translation>gehört nicht zu dem, was manifest.json nennt</translation>
    </message>
    <message>
        <source>has version %1, this program reads up to %2</source>
        <translation>ist Version %1, dieses Programm liest bis %2</translation>
    </message>
    <message>
        <source>is %1 x %2 pixels, expected %3 x %4</source>
        <translation>hat %1 x %2 Pixel, erwartet: %3 x %4</translation>
    </message>
    <message>
        <source>has no channel %1, expected R, G, B</source>
        <translation>hat keinen Kanal %1, erwartet: R, G, B</translation>
    </message>
    <message>
        <source>has no channel %1, expected R G B = x y z in metres and A</source>
        <translation>hat keinen Kanal %1, erwartet: R G B = x y z in Metern und A</translation>
    </message>
    <message>
        <source>fragment %1 is not a finite number</source>
        <translation>Fragment %1 ist keine endliche Zahl</translation>
    </message>
    <message>
        <source>fragment %1 belongs to no pixel or is out of order</source>
        <translation>Fragment %1 gehört zu keinem Pixel oder steht nicht an seinem Platz</translation>
    </message>
    <message>
        <source>has no &apos;position&apos;, expected the name of the position picture</source>
        <translation>hat kein &apos;position&apos;, erwartet: Name des Bildes der Orte</translation>
    </message>
    <message>
        <source>has no [camera] with matrix_world and fov_y_deg</source>
        <translation>hat kein [camera] mit matrix_world und fov_y_deg</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is neither a size like 1920x1080, 16 to 8192 each way, nor a camera of the show</source>
        <translation>&apos;%1&apos; ist weder eine Größe wie 1920x1080, 16 bis 8192 je Richtung, noch eine Kamera der Show</translation>
    </message>
    <message>
        <source>camera &apos;%1&apos; is made from where the fixtures hang, for the show has none of its own; keep one first (Ctrl+K)</source>
        <translation>Kamera &apos;%1&apos; ist aus den Plätzen der Geräte gemacht, denn die Show hat keine eigene; behalte zuerst eine (Strg+K)</translation>
    </message>
    <message>
        <source>has no camera number %1</source>
        <translation>hat keine Kamera Nummer %1</translation>
    </message>
    <message>
        <source>has a [[camera]] that cannot be read (Messages say which); mend it there first</source>
        <translation>hat eine [[camera]], die nicht gelesen werden kann (Meldungen sagen, welche); zuerst dort beheben</translation>
    </message>
    <message>
        <source>the picture stands at no camera of the show: go to one, or keep this one (Ctrl+K)</source>
        <translation>das Bild steht bei keiner Kamera der Show: zu einer gehen, oder diese behalten (Strg+K)</translation>
    </message>
    <message>
        <source>camera &apos;%1&apos; is the last one of the show; keep another one first (Ctrl+K)</source>
        <translation>Kamera &apos;%1&apos; ist die letzte der Show; behalte zuerst eine andere (Strg+K)</translation>
    </message>
    <message>
        <source>camera &apos;%1&apos; cannot be removed: cue &apos;%2&apos; goes to it; give that cue another camera first</source>
        <translation>Kamera &apos;%1&apos; kann nicht entfernt werden: Cue &apos;%2&apos; geht zu ihr; gib ihm zuerst eine andere Kamera</translation>
    </message>
    <message>
        <source>camera &apos;%1&apos; cannot be removed: a tracker moves it</source>
        <translation>Kamera &apos;%1&apos; kann nicht entfernt werden: ein Tracker bewegt sie</translation>
    </message>
    <message>
        <source>look &apos;%1&apos; cannot be removed: cue &apos;%2&apos; recalls it; give that cue another look first</source>
        <translation>Look &apos;%1&apos; kann nicht entfernt werden: Cue &apos;%2&apos; ruft ihn ab; gib ihm zuerst einen anderen Look</translation>
    </message>
    <message>
        <source>camera &apos;%1&apos; cannot be removed: mover &apos;%2&apos; carries it</source>
        <translation>Kamera &apos;%1&apos; kann nicht entfernt werden: Mover &apos;%2&apos; trägt sie</translation>
    </message>
    <message>
        <source>it needs a camera and its new name</source>
        <translation>es braucht eine Kamera und ihren neuen Namen</translation>
    </message>
    <message>
        <source>Could not determine tag type</source>
        <translation>Art des Tags nicht zu erkennen</translation>
    </message>
    <message>
        <source>Error parsing comment</source>
        <translation>Fehler in einem Kommentar</translation>
    </message>
    <message>
        <source>Error parsing CDATA section</source>
        <translation>Fehler in einem CDATA-Abschnitt</translation>
    </message>
    <message>
        <source>Error parsing document type declaration</source>
        <translation>Fehler in der Dokumenttyp-Deklaration</translation>
    </message>
    <message>
        <source>Error parsing PCDATA section</source>
        <translation>Fehler in einem Textabschnitt</translation>
    </message>
    <message>
        <source>Error parsing start element tag</source>
        <translation>Fehler in einem Start-Tag</translation>
    </message>
    <message>
        <source>Error parsing element attribute</source>
        <translation>Fehler in einem Attribut</translation>
    </message>
    <message>
        <source>Error parsing end element tag</source>
        <translation>Fehler in einem End-Tag</translation>
    </message>
    <message>
        <source>Start-end tags mismatch</source>
        <translation>End-Tag passt nicht zum Start-Tag</translation>
    </message>
    <message>
        <source>No document element found</source>
        <translation>kein Wurzelelement gefunden</translation>
    </message>
    <message>
        <source>nobody asks for it, no desk, no recording and no hand: it is left dark while the work light is on (by its file alone it would give %1 of its light)</source>
        <translation>niemand steuert es an, kein Pult, keine Aufzeichnung und keine Hand: solange das Arbeitslicht an ist, bleibt es dunkel (nach seiner Datei allein gäbe es %1 seines Lichts)</translation>
    </message>
    <message>
        <source>nobody asks for them while the work light is on</source>
        <translation>niemand steuert sie an, solange das Arbeitslicht an ist</translation>
    </message>
    <message>
        <source>the XML is not well formed: %1, in or behind %2 of that file inside of the plot, which is a zip</source>
        <translation>das XML ist nicht wohlgeformt: %1, in oder hinter %2 dieser Datei im Plot, der ein Zip ist</translation>
    </message>
    <message>
        <source>the XML is not well formed: %1, in that file inside of the plot, which is a zip</source>
        <translation>das XML ist nicht wohlgeformt: %1, in dieser Datei im Plot, der ein Zip ist</translation>
    </message>
    <message>
        <source>the XML is not well formed: %1</source>
        <translation>das XML ist nicht wohlgeformt: %1</translation>
    </message>
    <message>
        <source>nothing is set by hand; &apos;Store what is seen&apos; in Looks stores what a desk or recording does</source>
        <translation>nichts ist von Hand gesetzt; &apos;Bild speichern&apos; unter Looks speichert, was Pult oder Aufzeichnung tun</translation>
    </message>
    <message>
        <source>would be %1 bytes, and no more than %2 are read again: nothing is changed; a palette of fewer fixtures needs less</source>
        <translation>hätte %1 Bytes, und nicht mehr als %2 werden wieder gelesen: nichts ist geändert; eine Palette von weniger Geräten braucht weniger</translation>
    </message>
    <message>
        <source>the pictures of its %1 lights need %2 MB of memory, and %3 are free: fewer lights or a smaller picture need less</source>
        <translation>die Bilder seiner %1 Lichter brauchen %2 MB Speicher, und %3 sind frei: weniger Lichter oder ein kleineres Bild brauchen weniger</translation>
    </message>
    <message>
        <source>its passes need pictures of %1 x %2 in %3 layers, and this device has them up to %4 a side and %5 layers</source>
        <translation>das Vorberechnete braucht Bilder von %1 x %2 in %3 Lagen, und dieses Gerät hat sie bis %4 je Seite und %5 Lagen</translation>
    </message>
    <message>
        <source>it needs pictures of %1 x %2 in %3 layers, and this device has them up to %4 a side and %5 layers; no light bounces. Lamps and objects far from all others make the room so large</source>
        <translation>es braucht Bilder von %1 x %2 in %3 Lagen, und dieses Gerät hat sie bis %4 je Seite und %5 Lagen; kein indirektes Licht. Lampen und Objekte weit weg von allen anderen machen den Raum so groß</translation>
    </message>
    <message>
        <source>%1 has more patterns with * and ? than can be compared with so many and so long names (500 million letters): this one and those after it match nothing; write names out, or shorter patterns</source>
        <translation>%1 hat mehr Muster mit * und ?, als mit so vielen und so langen Namen verglichen werden können (500 Millionen Buchstaben): dieses und die danach treffen auf nichts zu; Namen ausschreiben oder kürzere Muster</translation>
    </message>
    <message>
        <source>%1 mesh files are left out: the others need all of the %2 GiB that the meshes of a plot may have</source>
        <translation>%1 Netzdateien sind weggelassen: die anderen brauchen alle %2 GiB, die die Netze eines Plans haben dürfen</translation>
    </message>
    <message>
        <source>%1 mesh file is left out: the others need all of the %2 GiB that the meshes of a plot may have</source>
        <translation>%1 Netzdatei ist weggelassen: die anderen brauchen alle %2 GiB, die die Netze eines Plans haben dürfen</translation>
    </message>
    <message>
        <source>its gobos stay open, and perhaps those of other files: with it the pictures of all fixture files need more than %1 GiB</source>
        <translation>seine Gobos bleiben offen, und vielleicht die anderer Dateien: mit ihm brauchen die Bilder aller Gerätedateien mehr als %1 GiB</translation>
    </message>
    <message>
        <source>is empty: there is no show in it</source>
        <translation>ist leer: darin steht keine Show</translation>
    </message>
    <message>
        <source>another show was opened meanwhile; it is left as it is</source>
        <translation>inzwischen wurde eine andere Show geöffnet; sie bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>another show was opened meanwhile; its own recording plays</source>
        <translation>inzwischen wurde eine andere Show geöffnet; ihre eigene Aufzeichnung läuft</translation>
    </message>
    <message>
        <source>the window was closed before it was done</source>
        <translation>das Fenster wurde geschlossen, bevor es fertig war</translation>
    </message>
    <message>
        <source>the show is being opened under its new name, which takes a moment: nothing is changed</source>
        <translation>wird unter dem neuen Namen geöffnet, das dauert einen Moment: nichts wird geändert</translation>
    </message>
    <message>
        <source>its intensity is at %1</source>
        <translation>seine Intensität steht auf %1</translation>
    </message>
    <message>
        <source>their intensity is at 0</source>
        <translation>ihre Intensität steht auf 0</translation>
    </message>
    <message>
        <source>hands have it so: %1</source>
        <translation>von Hand: %1</translation>
    </message>
    <message>
        <source>hands have them so: %1</source>
        <translation>von Hand: %1</translation>
    </message>
    <message>
        <source>shown by the graphics device in %1 ms, by the window it took %2 ms</source>
        <translation>vom Grafikgerät in %1 ms gezeigt, vom Fenster dauerte es %2 ms</translation>
    </message>
    <message>
        <source>shown by the window in %1 ms, by the graphics device it took %2 ms</source>
        <translation>vom Fenster in %1 ms gezeigt, vom Grafikgerät dauerte es %2 ms</translation>
    </message>
    <message>
        <source>shown by the graphics device, as it was asked for</source>
        <translation>vom Grafikgerät gezeigt, wie verlangt</translation>
    </message>
    <message>
        <source>shown by the window: the graphics device has no displays</source>
        <translation>vom Fenster gezeigt: das Grafikgerät kennt keine Bildschirme</translation>
    </message>
    <message>
        <source>shown by the window: the display lost its surface too often</source>
        <translation>vom Fenster gezeigt: der Bildschirm verlor seine Fläche zu oft</translation>
    </message>
    <message>
        <source>shown by the window: the display&apos;s surface says nothing of itself</source>
        <translation>vom Fenster gezeigt: die Fläche des Bildschirms sagt nichts über sich</translation>
    </message>
    <message>
        <source>shown by the window: the graphics device does not reach this display</source>
        <translation>vom Fenster gezeigt: das Grafikgerät erreicht diesen Bildschirm nicht</translation>
    </message>
    <message>
        <source>shown by the window: the display has no format that is known here</source>
        <translation>vom Fenster gezeigt: der Bildschirm hat kein Format, das hier bekannt ist</translation>
    </message>
    <message>
        <source>shown by the window: nothing can be copied to the display&apos;s pictures</source>
        <translation>vom Fenster gezeigt: in die Bilder des Bildschirms lässt sich nichts kopieren</translation>
    </message>
</context>
<context>
    <name>Transport</name>
    <message>
        <source>Input</source>
        <translation>Eingang</translation>
    </message>
    <message>
        <source>Desk, else recording</source>
        <translation>Pult, sonst Aufzeichnung</translation>
    </message>
    <message>
        <source>Desk</source>
        <translation>Pult</translation>
    </message>
    <message>
        <source>Recording</source>
        <translation>Aufzeichnung</translation>
    </message>
    <message>
        <source>Master</source>
        <translation>Master</translation>
    </message>
    <message>
        <source>Master: all light</source>
        <translation>Master: alles Licht</translation>
    </message>
    <message>
        <source>Black-out</source>
        <translation>Blackout</translation>
    </message>
    <message>
        <source>desk</source>
        <translation>Pult</translation>
    </message>
    <message>
        <source>no recording</source>
        <translation>keine Aufzeichnung</translation>
    </message>
    <message>
        <source>The recording: how much changes when, and where it is played</source>
        <translation>Die Aufzeichnung: wie viel sich wann ändert und wo sie gerade ist</translation>
    </message>
    <message>
        <source>Click: go there. Shift+drag: play this part again and again, Shift+click: the whole.</source>
        <translation>Klick: dorthin. Umschalt+Ziehen: diesen Teil immer wieder, Umschalt+Klick: das Ganze.</translation>
    </message>
</context>
<context>
    <name>Undo</name>
    <message>
        <source>Haze</source>
        <translation>Dunst</translation>
    </message>
    <message>
        <source>Clouds</source>
        <translation>Schwaden</translation>
    </message>
    <message>
        <source>Size of the clouds</source>
        <translation>Größe der Schwaden</translation>
    </message>
    <message>
        <source>Wind</source>
        <translation>Wind</translation>
    </message>
    <message>
        <source>Hazer</source>
        <translation>Hazer</translation>
    </message>
    <message>
        <source>Add a hazer</source>
        <translation>Hazer hinzufügen</translation>
    </message>
    <message>
        <source>Remove a hazer</source>
        <translation>Hazer entfernen</translation>
    </message>
    <message>
        <source>Bounced light</source>
        <translation>Indirektes Licht</translation>
    </message>
    <message>
        <source>fan %1</source>
        <translation>fächern: %1</translation>
    </message>
    <message>
        <source>align %1</source>
        <translation>angleichen: %1</translation>
    </message>
    <message>
        <source>solo</source>
        <translation>Solo</translation>
    </message>
    <message>
        <source>end of solo</source>
        <translation>Ende von Solo</translation>
    </message>
    <message>
        <source>palette %1</source>
        <translation>Palette %1</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Name</source>
        <translation>Name</translation>
    </message>
    <message>
        <source>Mode</source>
        <translation>Modus</translation>
    </message>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>Bewegen</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>Drehen</translation>
    </message>
    <message>
        <source>give everything back</source>
        <translation>alles freigeben</translation>
    </message>
    <message>
        <source>even light</source>
        <translation>Grundlicht</translation>
    </message>
    <message>
        <source>show object</source>
        <translation>Objekt zeigen</translation>
    </message>
    <message>
        <source>hide object</source>
        <translation>Objekt ausblenden</translation>
    </message>
    <message>
        <source>release %1</source>
        <translation>freigeben: %1</translation>
    </message>
    <message>
        <source>drive %1</source>
        <translation>fahren: %1</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>Abtastungen</translation>
    </message>
    <message>
        <source>release samples</source>
        <translation>Abtastungen freigeben</translation>
    </message>
    <message>
        <source>looks from the file</source>
        <translation>Looks aus der Datei</translation>
    </message>
    <message>
        <source>look %1</source>
        <translation>Look %1</translation>
    </message>
    <message>
        <source>seconds of a look</source>
        <translation>Sekunden eines Looks</translation>
    </message>
    <message>
        <source>Reload</source>
        <translation>Neu laden</translation>
    </message>
    <message>
        <source>Take changes</source>
        <translation>Änderungen übernehmen</translation>
    </message>
    <message>
        <source>gel</source>
        <translation>Folie</translation>
    </message>
    <message>
        <source>lamp</source>
        <translation>Lampe</translation>
    </message>
    <message>
        <source>white of the lamp</source>
        <translation>Weiß der Lampe</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>colour of the even light</source>
        <translation>Farbe des Grundlichts</translation>
    </message>
    <message>
        <source>release the colour of the even light</source>
        <translation>Farbe des Grundlichts freigeben</translation>
    </message>
    <message>
        <source>release attenuation</source>
        <translation>Abfall freigeben</translation>
    </message>
    <message>
        <source>attenuation</source>
        <translation>Abfall</translation>
    </message>
    <message>
        <source>shadows</source>
        <translation>Schatten</translation>
    </message>
    <message>
        <source>smoke</source>
        <translation>Nebel</translation>
    </message>
    <message numerus="yes">
        <source>show %n object(s)</source>
        <translation>
            <numerusform>Objekt zeigen</numerusform>
            <numerusform>%n Objekte zeigen</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>hide %n object(s)</source>
        <translation>
            <numerusform>Objekt ausblenden</numerusform>
            <numerusform>%n Objekte ausblenden</numerusform>
        </translation>
    </message>
    <message>
        <source> of %1 by RDM</source>
        <translation> von %1 per RDM</translation>
    </message>
    <message>
        <source>aim</source>
        <translation>ausrichten</translation>
    </message>
    <message>
        <source>hold</source>
        <translation>halten</translation>
    </message>
    <message>
        <source>gobo</source>
        <translation>Gobo</translation>
    </message>
    <message>
        <source>give back</source>
        <translation>freigeben</translation>
    </message>
    <message>
        <source>Cue &apos;%1&apos; added</source>
        <translation>Cue &apos;%1&apos; hinzugefügt</translation>
    </message>
    <message>
        <source>Address of &apos;%1&apos; set</source>
        <translation>Adresse von &apos;%1&apos; gesetzt</translation>
    </message>
    <message>
        <source>Hung under &apos;%1&apos;</source>
        <translation>Unter &apos;%1&apos; gehängt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; flies on hoists</source>
        <translation>&apos;%1&apos; hängt an Zügen</translation>
    </message>
    <message>
        <source>&apos;%1&apos; moved</source>
        <translation>&apos;%1&apos; bewegt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; hidden</source>
        <translation>&apos;%1&apos; ausgeblendet</translation>
    </message>
    <message>
        <source>Palette &apos;%1&apos; removed</source>
        <translation>Palette &apos;%1&apos; entfernt</translation>
    </message>
    <message numerus="yes">
        <source>%n fixture(s) unpatched</source>
        <translation>
            <numerusform>%n Gerät ohne Adresse</numerusform>
            <numerusform>%n Geräte ohne Adresse</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n fixture(s) spread evenly</source>
        <translation>
            <numerusform>%n Gerät gleichmäßig verteilt</numerusform>
            <numerusform>%n Geräte gleichmäßig verteilt</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n fixture(s) duplicated</source>
        <translation>
            <numerusform>%n Gerät dupliziert</numerusform>
            <numerusform>%n Geräte dupliziert</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n fixture(s) removed</source>
        <translation>
            <numerusform>%n Gerät entfernt</numerusform>
            <numerusform>%n Geräte entfernt</numerusform>
        </translation>
    </message>
    <message>
        <source>Camera &apos;%1&apos; kept</source>
        <translation>Kamera &apos;%1&apos; behalten</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is the stage</source>
        <translation>&apos;%1&apos; ist die Bühne</translation>
    </message>
    <message>
        <source>Model &apos;%1&apos; added</source>
        <translation>Modell &apos;%1&apos; hinzugefügt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; is the plot</source>
        <translation>&apos;%1&apos; ist der Plan</translation>
    </message>
    <message>
        <source>&apos;%1&apos; added</source>
        <translation>&apos;%1&apos; hinzugefügt</translation>
    </message>
    <message>
        <source>&apos;%1&apos; substituted</source>
        <translation>&apos;%1&apos; ersetzt</translation>
    </message>
    <message numerus="yes">
        <source>%n fixture file(s) substituted</source>
        <translation>
            <numerusform>%n Gerätedatei ersetzt</numerusform>
            <numerusform>%n Gerätedateien ersetzt</numerusform>
        </translation>
    </message>
    <message>
        <source>Cue &apos;%1&apos; changed</source>
        <translation>Cue &apos;%1&apos; geändert</translation>
    </message>
    <message>
        <source>Cue &apos;%1&apos; moved</source>
        <translation>Cue &apos;%1&apos; verschoben</translation>
    </message>
    <message>
        <source>Cue &apos;%1&apos; removed</source>
        <translation>Cue &apos;%1&apos; entfernt</translation>
    </message>
    <message>
        <source>Palette &apos;%1&apos; renamed &apos;%2&apos;</source>
        <translation>Palette &apos;%1&apos; in &apos;%2&apos; umbenannt</translation>
    </message>
    <message>
        <source>%1 of &apos;%2&apos;</source>
        <translation>%1 von &apos;%2&apos;</translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n fixture(s)</source>
        <translation>
            <numerusform>%1 von %n Gerät</numerusform>
            <numerusform>%1 von %n Geräten</numerusform>
        </translation>
    </message>
    <message>
        <source>Rename</source>
        <translation>Umbenennung</translation>
    </message>
    <message>
        <source>Camera &apos;%1&apos; renamed &apos;%2&apos;</source>
        <translation>Kamera &apos;%1&apos; in &apos;%2&apos; umbenannt</translation>
    </message>
    <message>
        <source>Camera &apos;%1&apos; removed</source>
        <translation>Kamera &apos;%1&apos; entfernt</translation>
    </message>
    <message>
        <source>Look &apos;%1&apos; stored</source>
        <translation>Look &apos;%1&apos; gespeichert</translation>
    </message>
    <message>
        <source>Look &apos;%1&apos; renamed &apos;%2&apos;</source>
        <translation>Look &apos;%1&apos; in &apos;%2&apos; umbenannt</translation>
    </message>
    <message>
        <source>Look &apos;%1&apos; removed</source>
        <translation>Look &apos;%1&apos; entfernt</translation>
    </message>
    <message>
        <source>Palette &apos;%1&apos; stored: %2</source>
        <translation>Palette &apos;%1&apos; gespeichert: %2</translation>
    </message>
    <message>
        <source>Palette &apos;%1&apos; stored for any head: %2</source>
        <translation>Palette &apos;%1&apos; für alle Köpfe gespeichert: %2</translation>
    </message>
</context>
<context>
    <name>Value</name>
    <message>
        <source>Unfolds the colours</source>
        <translation>Klappt die Farben auf</translation>
    </message>
    <message>
        <source>Give it back to the show and the desk</source>
        <translation>Der Show und dem Pult zurückgeben</translation>
    </message>
    <message>
        <source>Give back %1</source>
        <translation>%1 zurückgeben</translation>
    </message>
    <message>
        <source>mixed</source>
        <translation>gemischt</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>%1: what it can be</source>
        <translation>%1: was es sein kann</translation>
    </message>
</context>
<context>
    <name>Values</name>
    <message>
        <source>open</source>
        <translation>offen</translation>
    </message>
    <message>
        <source>slot %1</source>
        <translation>Platz %1</translation>
    </message>
    <message>
        <source>colour</source>
        <translation>Farbe</translation>
    </message>
    <message>
        <source>Address</source>
        <translation>Adresse</translation>
    </message>
    <message>
        <source>Attribute</source>
        <translation>Attribut</translation>
    </message>
    <message>
        <source>Means</source>
        <translation>Bedeutet</translation>
    </message>
    <message>
        <source>By hand</source>
        <translation>Von Hand</translation>
    </message>
    <message>
        <source>Channels</source>
        <translation>Kanäle</translation>
    </message>
    <message>
        <source>No fixture is selected</source>
        <translation>Kein Gerät ausgewählt</translation>
    </message>
    <message>
        <source>Click a lamp in the picture or a row of the list.</source>
        <translation>Ein Gerät im Bild oder eine Zeile der Liste anklicken.</translation>
    </message>
    <message>
        <source>%1 and %2 more</source>
        <translation>%1 und %2 weitere</translation>
    </message>
    <message>
        <source>It is being looked at ...</source>
        <translation>Wird untersucht ...</translation>
    </message>
    <message>
        <source>The way from the packet to the light</source>
        <translation>Der Weg vom Paket zum Licht</translation>
    </message>
</context>
<context>
    <name>View bar</name>
    <message>
        <source>Camera</source>
        <translation>Kamera</translation>
    </message>
    <message>
        <source>The cameras of the show: 1 to 9; Ctrl+K keeps this one</source>
        <translation>Die Kameras der Show: 1 bis 9; Strg+K behält diese</translation>
    </message>
    <message>
        <source>free camera</source>
        <translation>freie Kamera</translation>
    </message>
    <message>
        <source>Exposure</source>
        <translation>Belichtung</translation>
    </message>
    <message>
        <source>Exposure: + and - by half a stop; a smaller number is brighter</source>
        <translation>Belichtung: + und - um eine halbe Blende; eine kleinere Zahl ist heller</translation>
    </message>
    <message>
        <source>Auto</source>
        <translation>Auto</translation>
    </message>
    <message>
        <source>Tone curve</source>
        <translation>Tonwertkurve</translation>
    </message>
    <message>
        <source>Tone curve (T)</source>
        <translation>Tonwertkurve (T)</translation>
    </message>
    <message>
        <source>no curve</source>
        <translation>keine Kurve</translation>
    </message>
    <message>
        <source>Strip</source>
        <translation>Streifen</translation>
    </message>
    <message>
        <source>Work light</source>
        <translation>Arbeitslicht</translation>
    </message>
</context>
<context>
    <name>Welcome</name>
    <message>
        <source>Opened last</source>
        <translation>Zuletzt geöffnet</translation>
    </message>
    <message>
        <source>Open a show...</source>
        <translation>Show öffnen ...</translation>
    </message>
    <message>
        <source>A folder with show.toml</source>
        <translation>Ein Ordner mit show.toml</translation>
    </message>
    <message>
        <source>Open the demo</source>
        <translation>Demo öffnen</translation>
    </message>
    <message>
        <source>Ten moving heads, with a recording</source>
        <translation>Zehn Movinglights, mit Aufzeichnung</translation>
    </message>
    <message>
        <source>Import a plot...</source>
        <translation>Plan importieren ...</translation>
    </message>
    <message>
        <source>MVR of Vectorworks, Capture, grandMA3 ...</source>
        <translation>MVR von Vectorworks, Capture, grandMA3 ...</translation>
    </message>
    <message>
        <source>Shows that were opened last</source>
        <translation>Zuletzt geöffnete Shows</translation>
    </message>
    <message>
        <source>Drop a show or an .mvr anywhere here; a model or a fixture once a show is open. A desk that sends sACN or Art-Net is heard then, too.</source>
        <translation>Eine Show oder eine .mvr irgendwo hierher ziehen; ein Modell oder ein Gerät, sobald eine Show offen ist. Dann wird auch ein Pult gehört, das sACN oder Art-Net sendet.</translation>
    </message>
</context>
<context>
    <name>Window</name>
    <message>
        <source>nothing yet</source>
        <translation>noch nichts</translation>
    </message>
    <message>
        <source>See your light show before the truck is unloaded.</source>
        <translation>Die Lichtshow sehen, bevor der Truck entladen ist.</translation>
    </message>
    <message>
        <source>Drawn on: %1</source>
        <translation>Gezeichnet auf: %1</translation>
    </message>
    <message>
        <source>Apache License 2.0. VARI*LITE and VL2500 are marks of their owners, who have no part in this.</source>
        <translation>Apache-Lizenz 2.0. VARI*LITE und VL2500 sind Marken ihrer Eigentümer, die hieran nicht beteiligt sind.</translation>
    </message>
    <message>
        <source>&apos;%1&apos; has changes that are not saved.</source>
        <translation>&apos;%1&apos; hat Änderungen, die nicht gesichert sind.</translation>
    </message>
    <message>
        <source>Closed without saving they are kept, and offered when the show is opened again.</source>
        <translation>Ohne Sichern geschlossen, bleiben sie erhalten und werden beim nächsten Öffnen der Show angeboten.</translation>
    </message>
    <message>
        <source>Save and close</source>
        <translation>Sichern und schließen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>Abbrechen</translation>
    </message>
    <message numerus="yes">
        <source>%n job(s) of Export end with the window; a bake keeps what is finished.</source>
        <translation>
            <numerusform>%n Auftrag des Exports endet mit dem Fenster; vom Vorberechnen bleibt, was fertig ist.</numerusform>
            <numerusform>%n Aufträge des Exports enden mit dem Fenster; vom Vorberechnen bleibt, was fertig ist.</numerusform>
        </translation>
    </message>
    <message>
        <source>(read only)</source>
        <translation>(schreibgeschützt)</translation>
    </message>
</context>
</TS>
