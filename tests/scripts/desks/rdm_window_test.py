#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""OLA as an RDM controller of the window: it finds nothing while RDM is off, reads while it may, and what it sets is an edit of the
show, undone like any other; the body of a fixture that identifies itself flashes in the picture. (Debian packages ola, xvfb, xdotool.)
Arguments: source folder, build folder[, folder for pictures]. Exit 77: skipped."""
import os
import pathlib
import re
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "lib"))
import needs  # noqa: E402

needs.packages("ola", "iproute2", "util-linux")
import window as driver  # noqa: E402
import numpy  # noqa: E402
from ola import discover, known, namespaces, olad, wait  # noqa: E402
from PIL import Image  # noqa: E402

FIXTURES = driver.SOURCE / "assets/fixtures"
SIZE = 80, 45
SHOW = f"""# What the designer wrote stays.
[show]
name = "RDM"
stage = "{driver.SOURCE}/assets/optics/stage.glb"
[[camera]]
name = "front"
position_m = [0, -4, 3]
target_m = [0, 2, 3]
fov_y_deg = 50
ev100 = 8

[[fixture]] # the one on the left
name = "Head 1"
gdtf = "{FIXTURES}/Vari-Lite@VL2500_Spot.gdtf"
universe = 2
address = 1 # as the desk has it
position_m = [-1, 1, 3.4]

[[fixture]]
name = "Head 2"
gdtf = "{FIXTURES}/Vari-Lite@VL2500_Spot.gdtf"
universe = 2
address = 31
position_m = [1, 1, 3.4]

[[fixture]]
name = "Par"
gdtf = "{FIXTURES}/Ghostlight@LED_Par.gdtf"
mode = "RGB"
universe = 2
address = 61
position_m = [0, 1, 3.4]
"""


def pictures(window, count, every_s):
    """As they are meanwhile: nothing rests while a body flashes."""
    shots = []
    for number in range(count):
        file = driver.WORK / f"flash{number}.png"
        file.unlink(missing_ok=True)
        window.do(f'save-picture "{file}"')
        end = time.monotonic() + 30
        while not file.exists() and time.monotonic() < end:
            time.sleep(0.05)
        # While things move pictures are drawn with fewer pixels: edges are elsewhere by one, which means of blocks do not show.
        shots.append(numpy.asarray(Image.open(file).convert("L").resize(SIZE, Image.Resampling.BOX)).astype(float))
        time.sleep(every_s)
    return shots


def flashes(window, desk, uid):
    def differs():
        """Where pictures differ, as shares of the width; nothing: nowhere."""
        shots = pictures(window, 8, 0.2)
        if driver.PICTURES:
            Image.fromarray(max(shots, key=numpy.mean).astype("uint8")).resize((640, 360)).save(driver.PICTURES / "rdm-brightest.png")
        spread = numpy.max(shots, axis=0) - numpy.min(shots, axis=0)
        columns = numpy.nonzero((spread > 60).any(axis=0))[0]
        return (columns[0] / spread.shape[1], columns[-1] / spread.shape[1]) if len(columns) else None

    wait("nothing flashes", lambda: not differs())
    desk("ola_rdm_set", "-u", "1", "--uid", uid, "identify_device", "1")
    window.until(lambda state: state["rdm"]["identify"] == ["Head 1"])
    first, last = wait("the body of the head that identifies itself flashes", differs)
    assert first > 0.1 and last < 0.5, (first, last)  # the one on the left, and no other
    if driver.PICTURES:
        (driver.PICTURES / "rdm-brightest.png").rename(driver.PICTURES / "rdm-identify.png")
    desk("ola_rdm_set", "-u", "1", "--uid", uid, "identify_device", "0")
    window.until(lambda state: state["rdm"]["identify"] == [])
    wait("and no more", lambda: not differs())


def drive(window, desk, show):
    get = lambda uid, *words: desk("ola_rdm_get", "-u", "1", "--uid", uid, *words)
    set_to = lambda uid, *words: desk("ola_rdm_set", "-u", "1", "--uid", uid, *words)
    window.until_picture()
    assert discover(desk) == [], "off by default"
    print("ok: off, nobody is found")
    window.do("panel-network on", "rdm read")
    uids = wait("OLA finds three fixtures", lambda: found if len(found := discover(desk)) == 3 else None)
    of = {re.search(r"Head \d|Par", get(uid, "device_label")).group(0): uid for uid in uids}
    state = window.until(lambda state: state["rdm"]["found"] == 3 and state["rdm"]["messages"] >= 3)
    assert state["rdm"]["access"] == "read", state["rdm"]
    assert "rotect" in set_to(of["Head 1"], "dmx_start_address", "100")
    print("ok: read alone: an address may not be set")
    flashes(window, desk, of["Head 1"])

    window.do("rdm edit")
    window.until(lambda state: state["rdm"]["access"] == "edit")
    set_to(of["Head 1"], "dmx_start_address", "100")
    assert "100" in get(of["Head 1"], "dmx_start_address")
    state = window.until(lambda state: state["patch"]["Head 1"]["address"] == 100)
    assert "RDM" in state["undo"], state["undo"]
    set_to(of["Par"], "dmx_personality", "3")
    window.until(lambda state: state["patch"]["Par"]["mode"] == 2)
    assert "Dimmer RGB" in get(of["Par"], "dmx_personality_description", "3")
    assert "Footprint: 4" in get(of["Par"], "device_info"), get(of["Par"], "device_info")
    set_to(of["Head 2"], "device_label", "FOH left")
    window.until(lambda state: "FOH left" in state["patch"])
    assert "FOH left" in get(of["Head 2"], "device_label"), "it is who it was, under another name"
    assert discover(desk) == uids
    for name in ("Head 1", "a/b"):  # taken, and no name of a file
        assert "ange" in set_to(of["Par"], "device_label", name), name
    assert "ange" in set_to(of["Par"], "dmx_start_address", "511"), "it would end beyond 512"
    print("ok: address, mode and name are edits of the show")
    if driver.PICTURES:
        window.do(f'screenshot "{driver.PICTURES / "rdm-edit.png"}"')
    window.do("save")
    text = (show / "show.toml").read_text()
    assert text == (SHOW.replace("address = 1 #", "address = 100 #").replace('"Head 2"', '"FOH left"')
                    .replace('mode = "RGB"', 'mode = "Dimmer RGB"')), text
    print("ok: the file has them, and every comment")
    for _ in range(3):
        window.do("undo")
    state = window.until(lambda state: state["patch"].get("Head 1", {}).get("address") == 1 and state["patch"]["Par"]["mode"] == 0)
    assert "Head 2" in state["patch"], "three steps"
    wait("undone, the desk reads what was", lambda: re.search(r"\b1\b", get(of["Head 1"], "dmx_start_address").split("ddress")[-1]) and
         "Head 2" in get(of["Head 2"], "device_label"))
    window.do("rdm off")
    window.until(lambda state: state["rdm"]["access"] == "off")
    print("ok: off again")
    wait("the desk heard it without asking", lambda: not known(desk), 10)


def main():
    if os.geteuid() != 0:
        needs.skip("needs root for network namespaces")
    if not os.access(driver.PROGRAM, os.X_OK):
        needs.skip(f"{driver.PROGRAM} is not built")
    with namespaces() as (desk_space, our_space), driver.begin() as work:
        show = work / "show"
        show.mkdir()
        (show / "show.toml").write_text(SHOW)
        with olad(desk_space, work) as desk:
            window = driver.Window("--interface", "net0", "--size", "1200x800", show=show, before=["ip", "netns", "exec", our_space])
            try:
                drive(window, desk, show)
            except AssertionError:
                print(window.text()[-3000:])
                raise
            finally:
                window.process.kill()
                window.process.wait()


if __name__ == "__main__":
    main()
