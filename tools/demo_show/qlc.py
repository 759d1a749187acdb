# SPDX-License-Identifier: Apache-2.0
"""Writes QLC+ 4.12 workspaces: scenes, chasers, sequences, EFX, and one Show that places them on tracks in time."""
from xml.sax.saxutils import quoteattr

TICK_MS = 20  # of QLC+'s master timer


class Workspace:
    def __init__(self, universes):
        self.universes = universes  # [(name, inner XML of the output patch)]
        self.fixtures = []
        self.functions = []
        self.tracks = {}  # name -> [(function id, start ms, duration ms)]
        self.bound = {}  # channels of a sequence -> id of its scene

    def fixture(self, name, maker, model, mode, universe, address, channels, forced_ltp=()):
        number = len(self.fixtures)
        ltp = ' <ForcedLTP>%s</ForcedLTP>\n' % ','.join(map(str, forced_ltp)) if forced_ltp else ''
        self.fixtures.append(
            ' <Fixture>\n  <Manufacturer>%s</Manufacturer>\n  <Model>%s</Model>\n  <Mode>%s</Mode>\n  <ID>%d</ID>\n'
            '  <Name>%s</Name>\n  <Universe>%d</Universe>\n  <Address>%d</Address>\n  <Channels>%d</Channels>\n%s </Fixture>\n'
            % (maker, model, mode, number, name, universe - 1, address - 1, channels, ltp))
        return number

    def _function(self, kind, name, body, extra=''):
        number = len(self.functions)
        self.functions.append(' <Function ID="%d" Type="%s" Name=%s%s>\n%s </Function>\n'
                              % (number, kind, quoteattr(name), extra, body))
        return number

    @staticmethod
    def _speed(fade_in_s=0.0, fade_out_s=0.0, duration_s=0.0):
        return '  <Speed FadeIn="%d" FadeOut="%d" Duration="%d"/>\n' % (
            round(fade_in_s * 1000), round(fade_out_s * 1000), round(duration_s * 1000))

    def scene(self, name, values, fade_in_s=0.0, fade_out_s=0.0):
        """values: {fixture id: {channel: level}}"""
        body = self._speed(fade_in_s, fade_out_s)
        for fixture, channels in sorted(values.items()):
            pairs = ','.join('%d,%d' % pair for pair in sorted(channels.items()))
            body += '  <FixtureVal ID="%d">%s</FixtureVal>\n' % (fixture, pairs)
        return self._function('Scene', name, body)

    def chaser(self, name, steps, fade_in_s, hold_s, fade_out_s, order='Loop'):
        body = self._speed(fade_in_s, fade_out_s, hold_s)
        body += '  <Direction>Forward</Direction>\n  <RunOrder>%s</RunOrder>\n' % order
        body += '  <SpeedModes FadeIn="Common" FadeOut="Common" Duration="Common"/>\n'
        for number, function in enumerate(steps):
            body += '  <Step Number="%d" FadeIn="0" Hold="0" FadeOut="0">%d</Step>\n' % (number, function)
        return self._function('Chaser', name, body)

    def sequence(self, name, steps, step_s):
        """steps: [{fixture: {channel: level}}], the same channels in each; no fades, so 16-bit pairs stay together."""
        key = tuple((fixture, tuple(sorted(channels))) for fixture, channels in sorted(steps[0].items()))
        if key not in self.bound:
            self.bound[key] = self.scene('channels of ' + name, {f: {c: 0 for c in channels} for f, channels in key})
        body = self._speed()
        body += '  <Direction>Forward</Direction>\n  <RunOrder>SingleShot</RunOrder>\n'
        body += '  <SpeedModes FadeIn="Common" FadeOut="Common" Duration="PerStep"/>\n'
        for number, step in enumerate(steps):
            text = ':'.join('%d:%s' % (fixture, ','.join('%d,%d' % pair for pair in sorted(channels.items())))
                            for fixture, channels in sorted(step.items()))
            count = sum(len(channels) for channels in step.values())
            body += '  <Step Number="%d" FadeIn="0" Hold="%d" FadeOut="0" Values="%d">%s</Step>\n' % (
                number, round(step_s * 1000), count, text)
        return self._function('Sequence', name, body, ' BoundScene="%d"' % self.bound[key])

    def efx(self, name, fixtures, algorithm, duration_s, pan, tilt, backward=False):
        """fixtures: [(id, start offset deg)]; pan, tilt: (centre, half width) in coarse DMX steps."""
        body = ''
        for fixture, offset in fixtures:
            body += ('  <Fixture>\n   <ID>%d</ID>\n   <Head>0</Head>\n   <Mode>0</Mode>\n   <Direction>%s</Direction>\n'
                     '   <StartOffset>%d</StartOffset>\n  </Fixture>\n'
                     % (fixture, 'Backward' if backward else 'Forward', offset % 360))
        body += '  <PropagationMode>Parallel</PropagationMode>\n' + self._speed(duration_s=duration_s)
        body += ('  <Direction>Forward</Direction>\n  <RunOrder>Loop</RunOrder>\n  <Algorithm>%s</Algorithm>\n'
                 '  <Width>%d</Width>\n  <Height>%d</Height>\n  <Rotation>0</Rotation>\n  <StartOffset>0</StartOffset>\n'
                 '  <IsRelative>0</IsRelative>\n' % (algorithm, pan[1], tilt[1]))
        for axis, centre, frequency, phase in (('X', pan[0], 2, 90), ('Y', tilt[0], 3, 0)):
            body += ('  <Axis Name="%s">\n   <Offset>%d</Offset>\n   <Frequency>%d</Frequency>\n   <Phase>%d</Phase>\n'
                     '  </Axis>\n' % (axis, centre, frequency, phase))
        return self._function('EFX', name, body)

    def place(self, track, function, start_s, duration_s):
        ms = [round(t * 1000 / TICK_MS) * TICK_MS for t in (start_s, duration_s)]
        self.tracks.setdefault(track, []).append((function, ms[0], ms[1]))

    def text(self, show_name, author):
        body = '  <TimeDivision Type="Time" BPM="120"/>\n'
        for number, (name, places) in enumerate(self.tracks.items()):
            body += '  <Track ID="%d" Name=%s isMute="0">\n' % (number, quoteattr(name))
            for function, start, duration in places:
                body += '   <ShowFunction ID="%d" StartTime="%d" Duration="%d" Color="#556b80"/>\n' % (function, start, duration)
            body += '  </Track>\n'
        show = self._function('Show', show_name, body)
        outputs = ''.join('  <Universe Name=%s ID="%d">\n   %s\n  </Universe>\n' % (quoteattr(name), i, output)
                          for i, (name, output) in enumerate(self.universes))
        return ('<?xml version="1.0" encoding="UTF-8"?>\n<!DOCTYPE Workspace>\n'
                '<Workspace xmlns="http://www.qlcplus.org/Workspace" CurrentWindow="VirtualConsole">\n'
                '<Creator>\n <Name>Q Light Controller Plus</Name>\n <Version>4.12.6</Version>\n <Author>%s</Author>\n</Creator>\n'
                '<Engine Autostart="%d">\n <InputOutputMap>\n%s </InputOutputMap>\n%s%s</Engine>\n</Workspace>\n'
                % (author, show, outputs, ''.join(self.fixtures), ''.join(self.functions)))
