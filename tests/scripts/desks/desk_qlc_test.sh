#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# QLC+ (Debian package qlcplus) as the lighting desk, headless, in a network namespace of its own, drives our receiver in
# another: Art-Net by broadcast and sACN by multicast. Every slot of every recorded look is compared. Arguments: source folder,
# build folder.
set -u
. "$1/tests/scripts/lib/desk.sh"
desk_test "qlcplus, iproute2" qlcplus ip

# Two universes of 512 slots, two looks that change every half second.
/usr/bin/python3 - "$work/test.qxw" "$work/looks.txt" <<'P'
import sys
looks = [[(7 * i + 13 * k + 1) % 256 for i in range(512)] for k in range(4)]  # A and B of universe 1, A and B of 2
outputs = ('<Output Plugin="ArtNet" UID="127.1.0.1" Line="1"/>',
           '<Output Plugin="E1.31" UID="127.1.0.1" Line="1"><PluginParameters multicast="1" universe="2"/></Output>')
x = ('<?xml version="1.0" encoding="UTF-8"?>\n<!DOCTYPE Workspace>\n<Workspace xmlns="http://www.qlcplus.org/Workspace" '
     'CurrentWindow="VirtualConsole">\n<Creator><Name>Q Light Controller Plus</Name><Version>4.12.6</Version>'
     '<Author>test</Author></Creator>\n<Engine Autostart="2">\n<InputOutputMap>\n')
for i, output in enumerate(outputs):
    x += '<Universe Name="U%d" ID="%d">%s</Universe>\n' % (i + 1, i, output)
x += '</InputOutputMap>\n'
for i in range(2):
    x += ('<Fixture><Manufacturer>Generic</Manufacturer><Model>Generic</Model><Mode>Generic</Mode><ID>%d</ID><Name>D%d</Name>'
          '<Universe>%d</Universe><Address>0</Address><Channels>512</Channels></Fixture>\n' % (i, i, i))
for k, name in enumerate('AB'):
    x += '<Function ID="%d" Type="Scene" Name="%s"><Speed FadeIn="0" FadeOut="0" Duration="0"/>' % (k, name)
    for i in range(2):
        x += '<FixtureVal ID="%d">%s</FixtureVal>' % (i, ','.join('%d,%d' % pair for pair in enumerate(looks[2 * i + k])))
    x += '</Function>\n'
x += ('<Function ID="2" Type="Chaser" Name="C"><Speed FadeIn="0" FadeOut="0" Duration="500"/><Direction>Forward</Direction>'
      '<RunOrder>Loop</RunOrder><SpeedModes FadeIn="Common" FadeOut="Common" Duration="Common"/>'
      '<Step Number="0" FadeIn="0" Hold="0" FadeOut="0">0</Step><Step Number="1" FadeIn="0" Hold="0" FadeOut="0">1</Step>'
      '</Function>\n</Engine>\n</Workspace>\n')
open(sys.argv[1], 'w').write(x)
open(sys.argv[2], 'w').write('\n'.join(','.join(map(str, look)) for look in looks))
P
desk_qlc_record "$work/test.qxw" "$work/out.show" 6
cat "$work/summary.json"
/usr/bin/python3 - "$work" <<'P' || fail "recorded looks"
import json, statistics, sys
looks = [tuple(map(int, l.split(','))) for l in open(sys.argv[1] + '/looks.txt')]
lines = open(sys.argv[1] + '/out.show').read().splitlines()[1:]
summary = json.load(open(sys.argv[1] + '/summary.json'))
assert summary['missed'] == 0 and summary['kernel_overflow'] == 0, summary
t, changes, dark = 0, {1: [], 2: []}, {1: 0, 2: 0}
for line in lines:
    if ' ' not in line:
        t += int(line)
        continue
    number, text = line.split(' ')
    number = int(number)
    levels = tuple(map(int, text.split(',')))
    levels += (0,) * (512 - len(levels))
    if not any(levels):
        dark[number] += 1  # before the chaser starts
        continue
    expected = looks[2 * (number - 1):2 * number]
    assert levels in expected, 'universe %d at %d ms: %s' % (number, t, levels[:16])
    changes[number].append((t, expected.index(levels)))
for number in (1, 2):
    steps = changes[number]
    assert dark[number] <= 1, dark
    assert len(steps) >= 8, steps
    assert all(a[1] != b[1] for a, b in zip(steps, steps[1:])), steps  # A and B in turn, each written once
    gaps = [b[0] - a[0] for a, b in zip(steps, steps[1:])]
    # The first look began before it was recorded; on a busy machine QLC+ itself is late with some.
    median = statistics.median(gaps[1:])
    assert 450 <= median <= 560, gaps
    print('ok: universe %d, %d looks of 512 slots, steps of %d to %d ms, median %d'
          % (number, len(steps), min(gaps), max(gaps), median))
P
