#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""trim.py IN OUT SECONDS: cuts an OLA show file of one universe to start with its first frame that is not all zero."""
import sys

source, target, seconds = sys.argv[1], sys.argv[2], float(sys.argv[3])
lines = open(source, encoding='ascii').read().splitlines()
assert lines.pop(0) == 'OLA Show'
t, frames = 0, []
for line in lines:
    if ' ' in line:
        frames.append((t, line))
    else:
        t += int(line)
while frames and set(frames[0][1].split(' ')[1].split(',')) == {'0'}:
    frames.pop(0)
start = frames[0][0]
end = start + round(seconds * 1000)
if t < end:
    sys.exit('%s is %.1f s short' % (source, (end - t) / 1000))
frames = [(time, line) for time, line in frames if time < end]
with open(target, 'w', encoding='ascii') as out:
    out.write('OLA Show\n')
    for (time, line), after in zip(frames, [f[0] for f in frames[1:]] + [end]):
        out.write('%s\n%d\n' % (line, after - time))
print('%d frames, %.1f s' % (len(frames), seconds))
