#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The demo show as a QLC+ 4.12 workspace: make_workspace.py OUT.qxw. 120 beats a minute, a bar is two seconds, 48 bars.

A designer's reading: one spot in the dark (bars 0-3), blue night with leaves (4-7), magenta groove with fans (8-11), amber
chorus with iris and zoom pulses (12-15), gobo columns (16-19), build with split colours, strobe hit, blackout (20-23),
ballyhoo (24-29), breakdown (30-33), rise (34-37), finale (38-44), last spot (45-47)."""
import sys

from qlc import Workspace
from rig import *

BAR = 2.0
BEAT = 0.5
STEP_S = 0.04

SINGER, GUITAR, BASS, DRUMS, CHOIR, KEYS = ((0.2, 2.2, 2.5), (-2.7, 2.6, 2.4), (2.7, 2.6, 2.4), (0.0, 6.0, 2.6),
                                            (-4.2, 5.6, 2.4), (3.6, 5.6, 2.4))
COLOURS = {  # cyan, yellow, magenta
    'white': (0, 0, 0), 'deep blue': (255, 0, 215), 'blue': (255, 0, 140), 'cyan': (255, 20, 0), 'magenta': (0, 0, 255),
    'amber': (0, 225, 95), 'red': (0, 255, 255), 'green': (255, 255, 0), 'lavender': (110, 0, 120), 'warm': (0, 80, 30),
    'rose': (0, 60, 150),
}
WHEEL = {name: 18 * i for i, name in enumerate(('open', 'red', 'blue', 'yellow', 'light blue', 'pink', 'green', 'magenta',
                                                'lavender', 'amber', 'orange', 'uv'))}
FIXED = {name: 18 * i for i, name in enumerate(('open', 'pebbles', 'dust', 'circles', 'night sky', 'leaves', 'bars', 'wave',
                                                'blocks', 'tribal', 'liquid', 'rays'))}
ROTATE = {'open': 128, 'vortex': 146, 'window': 169, 'rings': 191, 'foliage': 214, 'caustics': 236}

w = Workspace([('Stage', '<Output Plugin="E1.31" UID="127.1.0.1" Line="1"><PluginParameters multicast="1" universe="1" '
                         'transmitMode="Full"/></Output>')])
for name, (_, _, _, address) in RIG.items():
    spot = name.startswith('Spot')
    w.fixture(name, 'Vari-Lite', 'VL2500 ' + name.split()[0], 'Standard 22 channels' if spot else 'Normal Mode', 1, address,
              22 if spot else 15, (CYAN, YELLOW, MAGENTA))

angles = {f: (0.0, 0.0) for f in range(10)}  # where each fixture points at the end of what is programmed so far


def each(fixtures, values):
    """The same values for several fixtures, or one set for each."""
    return {f: dict(values[i] if isinstance(values, list) else values) for i, f in enumerate(fixtures)}


def set_at(t, name, values, fade_s=0.0, track='Beam'):
    w.place(track, w.scene(name, values, fade_s), t, max(fade_s, 0.1) + 0.1)


def colour(t, name, fixtures, fade_s=0.0):
    c, y, m = COLOURS[name]
    set_at(t, name, each(fixtures, {CYAN: c, YELLOW: y, MAGENTA: m}), fade_s, 'Colour')


def light(t, until, name, fixtures, level, fade_in_s=0.0, fade_out_s=0.0):
    """Intensity from t until then; the fade out comes after. Overlapping ones merge highest first, as desks do."""
    w.place('Intensity', w.scene(name, each(fixtures, {DIM: round(level * 255)}), fade_in_s, fade_out_s), t, until - t)


def look(t, name, aims):
    """Heads jump there; for the dark, or with the motors' own speed as the move. aims: {fixture: target}"""
    values = {}
    for f, target in aims.items():
        angles[f] = pan_tilt_deg(f, target, angles[f])
        values[f] = pan_tilt_dmx(*angles[f])
    set_at(t, name, values, 0.0, 'Position')


def move(t, duration_s, name, aims, ease=True):
    """Heads travel there in even steps of both 16-bit angles. aims: {fixture: target}"""
    for f, target in aims.items():
        start, angles[f] = angles[f], pan_tilt_deg(f, target, angles[f])
        steps = []
        count = round(duration_s / STEP_S)
        for i in range(1, count + 1):
            k = i / count
            k = k * k * (3 - 2 * k) if ease else k
            steps.append({f: pan_tilt_dmx(*(a + (b - a) * k for a, b in zip(start, angles[f])))})
        # QLC+ plays the sequences of one bound scene only per track, so each fixture has its own.
        w.place('Moves of ' + NAMES[f], w.sequence('%s, %s' % (name, NAMES[f]), steps, STEP_S), t, duration_s + 0.1)


def pulses(t, count, name, fixtures, channel, high, low, beat_s=BEAT):
    """A level that jumps up on the beat and falls back."""
    up = w.scene(name + ' up', each(fixtures, {channel: high}))
    down = w.scene(name + ' down', each(fixtures, {channel: low}), 0.8 * beat_s)
    for i in range(count):
        w.place('Beam', up, t + i * beat_s, 0.06)
        w.place('Beam', down, t + i * beat_s + 0.08, beat_s - 0.1)


def fan(y, z, width):
    """Three beams from the back truss; the middle one stays low, under the eyes of the house."""
    return {0: (-width, y, z), 1: (0.0, y, min(z, 0.5)), 2: (width, y, z)}


# -- bars 0-3: dark; one slow spot finds the singer, its iris opens
set_at(0.0, 'Home', {**each(SPOTS, {EDGE: edge_dmx(6), SPOT_STROBE: 0, ZOOM: 60, GOBO: 0, ROTATING: 0, IRIS: 255, COLOR: 0,
                                   **rotation_dmx(0)}),
                     **each(WASHES, {DIFFUSER: 200, WASH_STROBE: 0, COLOR: 0})})
look(0.0, 'Dark aims', {0: (-6.5, -4, 1.6), 1: (0, -2.5, 1.4), 2: (6.5, -4, 1.6), 3: GUITAR, 4: (2.8, 1.0, 1.2),
                        5: (-4.2, 9.6, 3.6), 6: (0, 9.6, 3.8), 7: (4.2, 9.6, 3.6), 8: (-2.8, 3, 1.2), 9: (2.8, 3, 1.2)})
set_at(0.2, 'Small iris', {4: {IRIS: 70, ZOOM: 20}})
colour(0.0, 'warm', [4])
light(1.0, 8.0, 'One spot', [4], 0.85, 4.0, 2.0)
move(3.0, 4.0, 'Find the singer', {4: SINGER})
set_at(6.0, 'Iris opens', {4: {IRIS: 190}}, 2.0)

# -- bars 4-7: night. Blue washes on the cyclorama, leaves turning on the floor
colour(7.0, 'deep blue', WASHES)
light(8.0, 24.0, 'Night', WASHES, 0.75, 3.0, 1.0)
light(8.0, 15.3, 'Singer stays', [4], 0.7, 0.5, 0.5)
set_at(9.0, 'Leaves', each((0, 2, 3), {GOBO: FIXED['leaves'], ROTATING: ROTATE['foliage'], ZOOM: 110, EDGE: edge_dmx(6),
                                      **rotation_dmx(-0.05)}))
colour(9.0, 'cyan', (0, 2, 3))
look(9.0, 'Leaves on the floor', {0: (-3.0, 4.0, 1.2), 2: (3.0, 4.0, 1.2), 3: (0.0, 4.0, 1.2)})
light(10.0, 15.3, 'Leaves', (0, 2, 3), 1.0, 2.0, 0.5)
move(12.0, 3.4, 'Leaves drift', {0: (-1.0, 2.0, 1.2), 2: (1.0, 2.0, 1.2), 3: (-2.0, 6.0, 1.2)})

# -- bars 8-11: magenta groove. Fans out of the back truss, washes answer on the beat
colour(15.9, 'magenta', SPOTS)
set_at(15.9, 'Open beams', each(SPOTS, {GOBO: 0, ROTATING: 0, ZOOM: 10, IRIS: 255, EDGE: edge_dmx(10), **rotation_dmx(0)}))
look(15.9, 'Fan closed', {**fan(-3.0, 0.5, 0.8), 3: GUITAR, 4: BASS})
light(16.0, 24.0, 'Fan', (0, 1, 2), 1.0, 0.2, 0.3)
light(16.0, 24.0, 'Two players', (3, 4), 0.6, 1.0, 0.5)
move(16.5, 3.0, 'Fan out', fan(-6.0, 3.5, 9.0))
move(20.0, 1.5, 'Fan down', fan(0.5, 1.2, 3.0))
move(21.8, 2.0, 'Fan crosses', {0: (7.0, -5.0, 1.0), 1: (0.0, -4.0, 0.5), 2: (-7.0, -5.0, 1.0)})
beat = [w.scene('Blue third', {**each((5, 7), dict(zip((CYAN, YELLOW, MAGENTA), COLOURS['magenta']))),
                               **each((6, 8, 9), dict(zip((CYAN, YELLOW, MAGENTA), COLOURS['blue'])))}),
        w.scene('Magenta third', {**each((5, 7), dict(zip((CYAN, YELLOW, MAGENTA), COLOURS['blue']))),
                                  **each((6, 8, 9), dict(zip((CYAN, YELLOW, MAGENTA), COLOURS['magenta'])))})]
w.place('Colour', w.chaser('Blue and magenta', beat, 0.12, BEAT, 0.0), 16.2, 7.6)

# -- bars 12-15: amber chorus, everybody in light; iris and zoom breathe with the beat
colour(24.0, 'amber', WASHES, 0.3)
colour(24.0, 'warm', SPOTS, 0.3)
set_at(24.0, 'Wash down', each((8, 9), {DIFFUSER: 255}))
look(24.0, 'Players', {0: CHOIR, 1: DRUMS, 2: KEYS, 3: GUITAR, 4: SINGER})
light(24.0, 32.0, 'Chorus washes', WASHES, 1.0, 0.2, 0.5)
light(24.0, 32.0, 'Chorus spots', SPOTS, 0.9, 0.2, 0.5)
pulses(24.5, 7, 'Iris', (0, 1, 2), IRIS, 255, 60)
pulses(28.0, 7, 'Zoom', (3, 4), ZOOM, 255, 20)
pulses(28.0, 7, 'Iris again', (0, 1, 2), IRIS, 40, 230)
set_at(26.0, 'Amber wheel', each((0, 2), {COLOR: WHEEL['amber']}))
set_at(30.0, 'Split amber and orange', each((0, 1, 2), {COLOR: WHEEL['amber'] + 9}))

# -- bars 16-19: columns of gobos, both wheels, turning against each other
colour(31.8, 'cyan', SPOTS)
colour(32.0, 'blue', WASHES, 1.0)
set_at(32.0, 'Vortex and rings', {f: {COLOR: 0, IRIS: 255, ZOOM: 120, GOBO: 0, EDGE: edge_dmx(5),
                                     ROTATING: ROTATE[('vortex', 'rings', 'vortex', 'window', 'window')[f]],
                                     **rotation_dmx((0.25, -0.25, 0.25, -0.15, 0.15)[f])} for f in SPOTS})
look(32.0, 'Columns', {0: (-5.2, 7.4, 1.2), 1: (0.0, 7.0, 1.2), 2: (5.2, 7.4, 1.2), 3: (-4.0, 2.0, 1.2), 4: (4.0, 2.0, 1.2)})
light(32.0, 40.0, 'Columns', SPOTS, 1.0, 0.3, 0.3)
light(32.0, 40.0, 'Columns, blue', WASHES, 0.35, 1.0, 0.5)
move(33.0, 3.0, 'Columns lean out', {0: (-5.5, 1.0, 1.2), 1: (0.0, 1.5, 1.2), 2: (5.5, 1.0, 1.2), 3: (-1.5, 5.0, 1.2), 4: (1.5, 5.0, 1.2)})
set_at(36.0, 'Both wheels', {f: {GOBO: FIXED[('tribal', 'rays', 'tribal', 'pebbles', 'pebbles')[f]],
                                **rotation_dmx((-0.4, 0.4, -0.4, 0.3, -0.3)[f])} for f in SPOTS})
colour(36.0, 'lavender', (0, 2), 0.5)
move(36.5, 3.0, 'Columns to the house', {0: (-3.0, -4.0, 2.5), 1: (0.0, -5.0, 2.5), 2: (3.0, -4.0, 2.5), 3: (-4.0, 7.0, 1.2),
                                        4: (4.0, 7.0, 1.2)})

# -- bars 20-23: build. Split colours, narrow beams one after the other, strobe hit, then nothing
set_at(40.0, 'Build beams', {f: {GOBO: 0, ROTATING: 0, ZOOM: 0, IRIS: 150, EDGE: edge_dmx(9), COLOR: WHEEL['red'] + 9,
                                **rotation_dmx(0)} for f in SPOTS})
colour(40.0, 'white', SPOTS)
colour(40.0, 'red', WASHES, 0.2)
look(40.0, 'Build aims', {0: (-2.0, -5, 0.5), 1: (0, -5, 0.5), 2: (2, -5, 0.5), 3: (-5.0, 8, 2), 4: (5.0, 8, 2)})
ones = [w.scene('One %d' % (f + 1), {f: {DIM: 255}}, 0.0, 0.15) for f in (0, 1, 2, 4, 3)]
w.place('Intensity', w.chaser('Round', ones, 0.0, 0.25, 0.15), 40.0, 2.5)
w.place('Intensity', w.chaser('Round, faster', ones, 0.0, 0.12, 0.1), 42.5, 1.5)
light(40.0, 44.0, 'Red rises', WASHES, 0.7, 4.0, 0.0)
set_at(42.0, 'Split yellow and light blue', each(SPOTS, {COLOR: WHEEL['yellow'] + 9}))
set_at(43.9, 'Strobe on', {**each(SPOTS, {SPOT_STROBE: 200, IRIS: 255, ZOOM: 60, COLOR: 0}), **each(WASHES, {WASH_STROBE: 220})})
look(43.9, 'Strobe aims', {0: (-5.0, 1.5, 1.2), 1: (0.0, 0.5, 1.2), 2: (5.0, 1.5, 1.2), 3: (-3.0, 9.4, 4.0), 4: (3.0, 9.4, 4.0)})
colour(43.9, 'white', range(10))
light(44.0, 46.0, 'Strobe hit', range(10), 1.0, 0.0, 0.0)
set_at(46.4, 'Strobe off', {**each(SPOTS, {SPOT_STROBE: 0}), **each(WASHES, {WASH_STROBE: 0})})
# 46-48: blackout

# -- bars 24-29: ballyhoo
set_at(46.6, 'Ballyhoo beams', {f: {ZOOM: 0, IRIS: 200, GOBO: 0, ROTATING: 0, EDGE: edge_dmx(10),
                                   COLOR: WHEEL[('magenta', 'yellow', 'light blue', 'green', 'pink')[f]]} for f in SPOTS})
colour(46.6, 'rose', WASHES)
light(48.0, 60.0, 'Ballyhoo', SPOTS, 1.0)
w.place('Position', w.efx('Ballyhoo, back', [(0, 0), (1, 120), (2, 240)], 'Circle', 3.0, (127, 26), (80, 24)), 47.5, 6.5)
w.place('Position', w.efx('Ballyhoo, front', [(3, 0), (4, 180)], 'Eight', 4.0, (127, 30), (160, 30)), 47.5, 6.5)
w.place('Position', w.efx('Ballyhoo, turned', [(0, 0), (1, 90), (2, 180)], 'Eight', 4.0, (127, 30), (82, 24), True), 54.1, 5.8)
w.place('Position', w.efx('Ballyhoo, front turned', [(3, 0), (4, 180)], 'Circle', 3.0, (127, 30), (158, 34), True), 54.1, 5.8)
for bar, names in ((26, ('red', 'open', 'blue', 'amber', 'magenta')), (28, ('green', 'magenta', 'orange', 'light blue', 'yellow'))):
    set_at(bar * BAR, 'Colours of bar %d' % bar, {f: {COLOR: WHEEL[names[f]]} for f in SPOTS})
bump = [w.scene('Outer washes', each((5, 7), {DIM: 255})), w.scene('Inner washes', each((6, 8, 9), {DIM: 255}))]
w.place('Intensity', w.chaser('Bumps', bump, 0.02, BEAT, 0.35), 48.0, 12.0)
for t, name in ((48.0, 'rose'), (52.0, 'cyan'), (56.0, 'amber')):
    colour(t, name, WASHES, 0.2)
set_at(55.0, 'Wheel spins', each((1,), {COLOR: 250}))
set_at(59.5, 'Wheel stops', each((1,), {COLOR: WHEEL['open']}))

# -- bars 30-33: breakdown. Two colours, slow fingers, a window that turns
colour(60.0, 'deep blue', WASHES, 1.5)
colour(60.0, 'lavender', SPOTS, 0.2)
set_at(60.0, 'Fingers', {**each((0, 1, 2), {IRIS: 60, ZOOM: 0, COLOR: 0, EDGE: edge_dmx(10)}),
                         **each((3, 4), {IRIS: 255, ZOOM: 160, COLOR: 0, ROTATING: ROTATE['caustics'], GOBO: FIXED['dust'],
                                         EDGE: edge_dmx(7), **rotation_dmx(0.08)})})
angles.update({f: (0.0, -50.0) for f in (0, 1, 2)})
angles.update({f: (0.0, 40.0) for f in (3, 4)})
look(60.1, 'Fingers gathered', {**fan(-2.0, 2.0, 0.5), 3: (-1.5, 7.5, 2.5), 4: (1.5, 7.5, 2.5)})
light(60.0, 68.0, 'Breakdown blue', WASHES, 0.4, 2.0, 1.0)
light(60.5, 68.0, 'Fingers', (0, 1, 2), 1.0, 1.5, 0.5)
light(60.5, 68.0, 'Water', (3, 4), 0.8, 2.0, 0.5)
move(61.0, 6.5, 'Fingers spread', fan(-3.0, 4.0, 8.0))

# -- bars 34-37: rise. From the floor into the house, rolls that get faster
colour(68.0, 'blue', WASHES, 0.5)
colour(68.0, 'white', SPOTS, 0.2)
set_at(68.0, 'Rise beams', {**each(SPOTS, {IRIS: 255, ZOOM: 20, GOBO: 0, ROTATING: 0, EDGE: edge_dmx(9), COLOR: WHEEL['light blue'] + 9})})
look(68.0, 'On the floor', {0: (-5.2, 6.0, 1.2), 1: (0.0, 6.0, 1.2), 2: (5.2, 6.0, 1.2), 3: (-4.6, 2.0, 1.2), 4: (4.6, 2.0, 1.2)})
light(68.0, 76.0, 'Rise', SPOTS, 0.9, 0.4, 0.0)
light(68.0, 76.0, 'Rise, washes', WASHES, 0.6, 6.0, 0.0)
move(68.6, 6.6, 'Rise', {0: (-9.0, -6.0, 4.0), 1: (0.0, -7.0, 0.5), 2: (9.0, -6.0, 4.0), 3: (-5.5, 9.4, 5.0), 4: (5.5, 9.4, 5.0)})
for t, name in ((70.0, 'pink'), (72.0, 'magenta'), (73.0, 'amber'), (74.0, 'red'), (74.5, 'orange'), (75.0, 'yellow')):
    set_at(t, 'Split ' + name, each(SPOTS, {COLOR: WHEEL[name] + 9}))
flash = [w.scene('Flash', each(WASHES, {DIM: 255}), 0.0, 0.1), w.scene('No flash', each(WASHES, {DIM: 0}))]
for t, beat_s, until in ((70.0, 0.5, 72.0), (72.0, 0.25, 74.0), (74.0, 0.12, 76.0)):
    w.place('Intensity', w.chaser('Roll %.2f s' % beat_s, flash, 0.0, beat_s / 2, 0.0), t, until - t)

# -- bars 38-44: finale
colour(76.0, 'warm', WASHES)
set_at(76.0, 'Finale beams', {f: {COLOR: WHEEL[('pink', 'open', 'pink', 'amber', 'amber')[f]], ZOOM: 60, IRIS: 255,
                                 ROTATING: ROTATE[('rings', 'vortex', 'rings', 'open', 'open')[f]], EDGE: edge_dmx(10),
                                 **rotation_dmx((0.6, -0.6, 0.6, 0.0, 0.0)[f])} for f in SPOTS})
light(76.0, 90.0, 'Finale', range(10), 1.0, 0.0, 0.0)
w.place('Position', w.efx('Finale, back', [(0, 0), (1, 180), (2, 0)], 'Eight', 4.0, (127, 34), (82, 26)), 76.0, 8.0)
w.place('Position', w.efx('Finale, front', [(3, 0), (4, 180)], 'Circle', 4.0, (127, 26), (156, 30)), 76.0, 8.0)
for t, name in ((78.0, 'magenta'), (80.0, 'amber'), (82.0, 'cyan'), (84.0, 'rose'), (86.0, 'amber'), (88.0, 'warm')):
    colour(t, name, WASHES, 0.15)
set_at(80.0, 'Finale, both wheels', each((0, 1, 2), {GOBO: FIXED['rays'], ROTATING: ROTATE['vortex'], ZOOM: 30, **rotation_dmx(-0.7)}))
set_at(84.0, 'Finale, open', each((0, 1, 2), {GOBO: 0, ROTATING: 0, COLOR: 0, ZOOM: 0}))
angles.update({f: (0.0, -50.0) for f in (0, 1, 2)})
angles.update({f: (0.0, 40.0) for f in (3, 4)})
look(84.2, 'Great fan', {**fan(-5.0, 4.0, 11.0), 3: GUITAR, 4: BASS})
move(85.0, 3.0, 'Great fan closes', {**fan(-3.0, 0.5, 0.5), 3: SINGER, 4: SINGER})
set_at(88.0, 'Accent', {**each(SPOTS, {SPOT_STROBE: 240}), **each(WASHES, {WASH_STROBE: 240})})
set_at(89.0, 'Accent over', {**each(SPOTS, {SPOT_STROBE: 0, IRIS: 255, ZOOM: 80}), **each(WASHES, {WASH_STROBE: 0})})
colour(89.0, 'warm', range(10))
look(89.0, 'All on the band', {0: CHOIR, 1: DRUMS, 2: KEYS, 3: SINGER, 4: SINGER})

# -- bars 45-47: the band goes dark, one spot is left and closes
light(89.9, 91.0, 'Last chord', range(10), 1.0, 0.0, 2.5)
light(90.0, 94.0, 'Left alone', [4], 0.9, 0.0, 1.2)
set_at(91.5, 'Iris closes', {4: {IRIS: 0, ZOOM: 0}}, 2.5)
w.place('Beam', w.scene('End', each(SPOTS, {SPOT_STROBE: 0})), 95.4, 0.6)

if __name__ == '__main__':
    with open(sys.argv[1], 'w', encoding='utf-8') as out:
        out.write(w.text('Ghostlight demo', 'Ghostlight'))
