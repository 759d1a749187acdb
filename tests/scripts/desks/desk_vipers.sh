#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# A QLC+ show of 16 Martin MAC Viper AirFX (../shared), programmed with QLC+'s own definition of that fixture, drives the GDTF
# file of another author over sACN: pan, tilt and colour must be what QLC+ meant. Arguments: source folder, build folder.
set -u
. "$1/tests/scripts/lib/desk.sh"
shared=$source_dir/../shared
[ -f "$shared/control/qlc/movers.qxw" ] || skip "no ../shared beside the checkout"
desk_test "qlcplus, iproute2" qlcplus ip

mkdir "$work/show"
cp "$shared/fixtures/gdtf/bauke_Martin_Professional@MAC_Viper_AirFX.gdtf" "$work/show/viper.gdtf"
/usr/bin/python3 - "$shared/control/qlc/movers.qxw" "$work" <<'P' || fail "workspace"
import re, sys
text = open(sys.argv[1]).read()
outputs = iter(('<Output Plugin="E1.31" UID="127.1.0.1" Line="1"><PluginParameters multicast="1" universe="%d"/></Output>' % n for n in (1, 2)))
text = re.sub(r'<Output .*?</Output>', lambda match: next(outputs), text, flags=re.S)
open(sys.argv[2] + '/movers.qxw', 'w').write(text)
place = re.compile(r'<Fixture>\s*<Manufacturer>Martin.*?<Mode>(.*?)</Mode>.*?<Name>(.*?)</Name>.*?<Universe>(\d+)</Universe>.*?<Address>(\d+)</Address>', re.S)
show = ('[show]\nname = "Vipers"\nambient_lux = 1\nmotion = "commanded"\n[[camera]]\nname = "house"\nposition_m = [0, -16, 4]\n'
        'target_m = [0, 2, 4]\nfov_y_deg = 40\nsize = [640, 360]\n')
for k, (mode, name, universe, address) in enumerate(place.findall(text)):
    show += ('[[fixture]]\nname = "%s"\ngdtf = "viper.gdtf"\nmode = "%s"\nuniverse = %d\naddress = %d\nposition_m = [%d, %d, 7]\n'
             % (name, mode, int(universe) + 1, int(address) + 1, -7 + 2 * (k % 8), 4 - 3 * (k // 8)))
open(sys.argv[2] + '/show/show.toml', 'w').write(show)
P
desk_qlc_record "$work/movers.qxw" "$work/movers.show" 8
[ -z "${KEEP:-}" ] || cp -r "$work" "$KEEP"
/usr/bin/python3 - "$ghostlight" "$work" <<'P' || fail "what the fixtures do"
import json, subprocess, sys
ghostlight, work = sys.argv[1:]
colours, pans, tilts, ways = set(), set(), set(), set()
for at in (3.0, 4.1, 5.3, 6.2, 7.4):
    run = subprocess.run([ghostlight, 'explain', work + '/show', '--all', '--json', '--replay', work + '/movers.show', '--at', str(at)],
                         capture_output=True, text=True)
    assert run.returncode in (0, 1), run.stderr  # 1: the show has no stage
    told = json.loads(run.stdout)
    assert len(told['fixtures']) == 16, told.keys()
    for fixture in told['fixtures']:
        raw = {}
        for channel in fixture['channels']:
            raw.setdefault(channel['attribute'], channel)
        # QLC+'s definition of this fixture: pan 540, tilt 268 degrees, centre at the middle of the 16 bits.
        for axis, span, seen in (('Pan', 540, pans), ('Tilt', 268, tilts)):
            channel = raw[axis]
            meant = (channel['raw'] / 65535 - 0.5) * span
            way = 1 if abs(channel['physical'] - meant) < 0.005 * span else -1  # QLC+ does not say which way round
            assert abs(channel['physical'] - way * meant) < 0.005 * span, (fixture['fixture'], axis, channel, meant)
            if abs(meant) > 0.02 * span:
                ways.add((axis, way))
            seen.add(round(channel['physical'] / 5))
        cmy = tuple(round(raw['ColorSub_' + letter]['raw'] / 255, 1) for letter in 'CMY')
        decoded = tuple(round(raw['ColorSub_' + letter]['physical'], 1) for letter in 'CMY')
        assert all(abs(a - b) <= 0.1 for a, b in zip(cmy, decoded)), (fixture['fixture'], cmy, decoded)
        colours.add(cmy)
        assert fixture['state'] == 'lit', (fixture['fixture'], fixture['verdict'])
print('16 fixtures at 5 moments: %d pans and %d tilts (steps of 5 degrees), colours %s' % (len(pans), len(tilts), sorted(colours)))
assert len(ways) == 2, ways
assert len(pans) >= 8 and len(tilts) >= 5, 'the circle is not seen'
assert any(c[0] > 0.9 and c[1] < 0.1 for c in colours) and any(c[1] > 0.9 and c[0] < 0.1 for c in colours), 'cyan and magenta'
P
echo "pan, tilt and colour are what QLC+ meant"
