# SPDX-License-Identifier: Apache-2.0
# What desks play in tests: washes 1 to 3 of the demo on the cyclorama, red, then blue. tools/demo_show must be in sys.path.
from rig import CYAN, DIFFUSER, DIM, MAGENTA, NAMES, RIG, YELLOW, pan_tilt_deg, pan_tilt_dmx


def red_and_blue():
    looks = []
    for cyan, yellow, magenta in ((0, 255, 255), (255, 0, 215)):
        levels = [0] * 512
        for wash in (5, 6, 7):
            x, _, _, address = RIG[NAMES[wash]]
            values = {DIM: 255, CYAN: cyan, YELLOW: yellow, MAGENTA: magenta, DIFFUSER: 200}
            values.update(pan_tilt_dmx(*pan_tilt_deg(wash, (x, 9.6, 3.6))))
            for channel, level in values.items():
                levels[address - 1 + channel] = level
        looks.append(levels)
    return looks
