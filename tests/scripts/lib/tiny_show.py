# SPDX-License-Identifier: Apache-2.0
"""The least show that is baked, drawn and cut into tasks: a floor, one lamp, one small camera and two seconds of a desk."""
import shutil

PAR = "Ghostlight@LED_Par.gdtf"
SHOW = f"""[show]
name = "Tiny"
stage = "stage.obj"
recording = "desk.show"
[shadows]
map_size = 64
[[camera]]
name = "house"
position_m = [0, -8, 2]
target_m = [0, 0, 1]
size = [32, 16]
[[fixture]]
name = "Par"
gdtf = "{PAR}"
universe = 1
address = 1
position_m = [0, 0, 5]
"""


def tiny_show(source, folder):
    folder.mkdir()
    (folder / "stage.obj").write_text("v -3 -3 0\nv 3 -3 0\nv 3 3 0\nv -3 3 0\nf 1 2 3 4\n")
    (folder / "desk.show").write_text("OLA Show\n1 255,255,255,255\n40\n1 0,0,0,0\n2000\n")
    (folder / "show.toml").write_text(SHOW)
    shutil.copy2(source / "assets/fixtures" / PAR, folder)
    return folder
