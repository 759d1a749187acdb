<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>Browsers</name>
    <message numerus="yes">
        <source>%n look(s) on:</source>
        <translation>
            <numerusform>One looks on:</numerusform>
            <numerusform>%n look on:</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>By hand</name>
    <message numerus="yes">
        <source>%n fixture(s)</source>
        <translation>
            <numerusform>%n fixture</numerusform>
            <numerusform>%n fixtures</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n object(s)</source>
        <translation>
            <numerusform>%n object</numerusform>
            <numerusform>%n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n material(s)</source>
        <translation>
            <numerusform>%n material</numerusform>
            <numerusform>%n materials</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n mover(s)</source>
        <translation>
            <numerusform>%n mover</numerusform>
            <numerusform>%n movers</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Chips</name>
    <message numerus="yes">
        <source>%n light(s) throw no shadows yet</source>
        <translation>
            <numerusform>%n light throws no shadows yet</numerusform>
            <numerusform>%n lights throw no shadows yet</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>LIVE DESK, %n universe(s) silent</source>
        <translation>
            <numerusform>LIVE DESK, %n universe silent</numerusform>
            <numerusform>LIVE DESK, %n universes silent</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n head(s) that nobody asks left dark</source>
        <translation>
            <numerusform>%n head that nobody asks left dark</numerusform>
            <numerusform>%n heads that nobody asks left dark</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Fixtures</name>
    <message numerus="yes">
        <source>%n fixture(s)</source>
        <translation>
            <numerusform>%n fixture</numerusform>
            <numerusform>%n fixtures</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Looks</name>
    <message numerus="yes">
        <source>%n fixture(s), %1 s</source>
        <translation>
            <numerusform>%n fixture, %1 s</numerusform>
            <numerusform>%n fixtures, %1 s</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>Solo: %n shine(s)</source>
        <translation>
            <numerusform>Solo: %n shines</numerusform>
            <numerusform>Solo: %n shine</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>What if %n fixture(s) had</source>
        <translation>
            <numerusform>What if this fixture had</numerusform>
            <numerusform>What if %n fixtures had</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Notice</name>
    <message numerus="yes">
        <source>%n head(s) have no optics in their files: what is seen of their light is assumed.</source>
        <translation>
            <numerusform>%n head has no optics in its file: what is seen of their light is assumed.</numerusform>
            <numerusform>%n heads have no optics in their files: what is seen of their light is assumed.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>A desk: %n universe(s)</source>
        <translation>
            <numerusform>A desk: %n universe</numerusform>
            <numerusform>A desk: %n universes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n head(s) have no optics and stay dark until another file stands in.</source>
        <translation>
            <numerusform>%n head has no optics and stays dark until another file stands in.</numerusform>
            <numerusform>%n heads have no optics and stay dark until another file stands in.</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>A desk that is silent: %n universe(s)</source>
        <translation>
            <numerusform>A desk that is silent: %n universe</numerusform>
            <numerusform>A desk that is silent: %n universes</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>, %n of them silent</source>
        <translation>
            <numerusform>, %n of them silent</numerusform>
            <numerusform>, %n of them silent</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Palettes</name>
    <message numerus="yes">
        <source>%n head(s), each its own</source>
        <translation>
            <numerusform>%n head, its own</numerusform>
            <numerusform>%n heads, each its own</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Plot</name>
    <message numerus="yes">
        <source>%n head(s)</source>
        <translation>
            <numerusform>%n head</numerusform>
            <numerusform>%n heads</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>and %n file(s) more</source>
        <translation>
            <numerusform>and %n file more</numerusform>
            <numerusform>and %n files more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Print</name>
    <message numerus="yes">
        <source>, with %n remark(s)</source>
        <translation>
            <numerusform>, with %n remark</numerusform>
            <numerusform>, with %n remarks</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>RDM</name>
    <message numerus="yes">
        <source>; %1 identify themselves</source>
        <translation>
            <numerusform>; %1 identifies itself</numerusform>
            <numerusform>; %1 identify themselves</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %2 fixtures were found by a desk, %n message(s)</source>
        <translation>
            <numerusform>%1 of %2 fixtures were found by a desk, %n message</numerusform>
            <numerusform>%1 of %2 fixtures were found by a desk, %n messages</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Undo</name>
    <message numerus="yes">
        <source>show %n object(s)</source>
        <translation>
            <numerusform>show object</numerusform>
            <numerusform>show %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>hide %n object(s)</source>
        <translation>
            <numerusform>hide object</numerusform>
            <numerusform>hide %n objects</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n fixture(s) unpatched</source>
        <translation>
            <numerusform>%n fixture unpatched</numerusform>
            <numerusform>%n fixtures unpatched</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n fixture(s) spread evenly</source>
        <translation>
            <numerusform>%n fixture spread evenly</numerusform>
            <numerusform>%n fixtures spread evenly</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n fixture(s) duplicated</source>
        <translation>
            <numerusform>%n fixture duplicated</numerusform>
            <numerusform>%n fixtures duplicated</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n fixture(s) removed</source>
        <translation>
            <numerusform>%n fixture removed</numerusform>
            <numerusform>%n fixtures removed</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n fixture file(s) substituted</source>
        <translation>
            <numerusform>%n fixture file substituted</numerusform>
            <numerusform>%n fixture files substituted</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%1 of %n fixture(s)</source>
        <translation>
            <numerusform>%1 of %n fixture</numerusform>
            <numerusform>%1 of %n fixtures</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>Window</name>
    <message numerus="yes">
        <source>%n job(s) of Export end with the window; a bake keeps what is finished.</source>
        <translation>
            <numerusform>%n job of Export ends with the window; a bake keeps what is finished.</numerusform>
            <numerusform>%n jobs of Export end with the window; a bake keeps what is finished.</numerusform>
        </translation>
    </message>
</context>
</TS>
