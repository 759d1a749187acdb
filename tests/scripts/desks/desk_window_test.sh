#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# The window as a designer uses it: QLC+ (Debian package qlcplus) as the lighting desk, headless, in a network namespace of its own,
# sends sACN by multicast; the window stands in another, on a screen of its own (Xvfb), under a real mouse and keyboard (xdotool).
# What is done and checked is in lib/desk_window.py. Arguments: source folder, build folder [, folder for pictures].
set -u
. "$1/tests/scripts/lib/desk.sh"
needs python3-pil python3-numpy
desk_test "qlcplus, iproute2, xvfb, xdotool" qlcplus ip Xvfb xdotool

# Washes 1 to 3 on the cyclorama, four seconds red, four seconds blue.
/usr/bin/python3 -B - "$source_dir/tools/demo_show" "$source_dir/tests/scripts/lib" "$work/test.qxw" <<'P' || fail "workspace"
import sys
sys.path[:0] = sys.argv[1:3]
from desk_looks import red_and_blue
looks = red_and_blue()
x = ('<?xml version="1.0" encoding="UTF-8"?>\n<!DOCTYPE Workspace>\n<Workspace xmlns="http://www.qlcplus.org/Workspace" '
     'CurrentWindow="VirtualConsole">\n<Creator><Name>Q Light Controller Plus</Name><Version>4.12.6</Version>'
     '<Author>test</Author></Creator>\n<Engine Autostart="2">\n<InputOutputMap>\n<Universe Name="U1" ID="0">'
     '<Output Plugin="E1.31" UID="127.1.0.1" Line="1"><PluginParameters multicast="1" universe="1"/></Output></Universe>\n'
     '</InputOutputMap>\n<Fixture><Manufacturer>Generic</Manufacturer><Model>Generic</Model><Mode>Generic</Mode><ID>0</ID>'
     '<Name>All</Name><Universe>0</Universe><Address>0</Address><Channels>512</Channels></Fixture>\n')
for k, name in enumerate(('Red', 'Blue')):
    x += ('<Function ID="%d" Type="Scene" Name="%s"><Speed FadeIn="0" FadeOut="0" Duration="0"/><FixtureVal ID="0">%s</FixtureVal>'
          '</Function>\n' % (k, name, ','.join('%d,%d' % pair for pair in enumerate(looks[k]))))
x += ('<Function ID="2" Type="Chaser" Name="C"><Speed FadeIn="0" FadeOut="0" Duration="4000"/><Direction>Forward</Direction>'
      '<RunOrder>Loop</RunOrder><SpeedModes FadeIn="Common" FadeOut="Common" Duration="Common"/>'
      '<Step Number="0" FadeIn="0" Hold="0" FadeOut="0">0</Step><Step Number="1" FadeIn="0" Hold="0" FadeOut="0">1</Step>'
      '</Function>\n</Engine>\n</Workspace>\n')
open(sys.argv[3], 'w').write(x)
P
desk_qlc "$work/test.qxw"
ip netns exec $VIS /usr/bin/python3 -B "$source_dir/tests/scripts/lib/desk_window.py" "$@" || { tail -5 "$work/qlcplus.log"; fail "the window"; }
