#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""OLA as an RDM controller over Art-Net of `ghostlight monitor --rdm`: it discovers 400 virtual heads, reads the label of each, and
gets and sets what it may, in network namespaces. (Debian package ola.) Arguments: source folder, build folder. Exit 77: skipped."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "lib"))
import needs  # noqa: E402
from ola import discover, inside, namespaces, olad, wait  # noqa: E402

SOURCE = pathlib.Path(sys.argv[1]).resolve()
GHOSTLIGHT = str(pathlib.Path(sys.argv[2]).resolve() / "ghostlight")
HEADS = 400


def address(head):
    return 1 + head % 490


def write_show(work):
    """400 heads on one universe; that they share addresses does not matter here."""
    toml = '[show]\nname = "rdm"\n[[camera]]\nposition_m = [0, -12, 3]\ntarget_m = [0, 2, 2]\n'
    for i in range(HEADS):
        toml += (f'[[fixture]]\nname = "Head {i + 1}"\ngdtf = "{SOURCE}/assets/fixtures/Vari-Lite@VL2500_Spot.gdtf"\n'
                 f"universe = 2\naddress = {address(i)}\nposition_m = [{i % 20}, {i // 20}, 6]\n")
    show = work / "show"
    show.mkdir()
    (show / "show.toml").write_text(toml)
    return show


def drive(desk, log):
    def discovered():
        found = discover(desk)
        return found if len(found) == HEADS else None

    uids = wait(f"OLA discovers {HEADS} virtual heads", discovered)
    labels = set()
    for uid in uids:
        labels |= set(re.findall(r"Head \d+", desk("ola_rdm_get", "-u", "1", "--uid", uid, "device_label")))
    assert labels == {f"Head {i + 1}" for i in range(HEADS)}, len(labels)
    print(f"ok: and reads {len(labels)} different labels")
    one = uids[0]
    get = lambda *words: desk("ola_rdm_get", "-u", "1", "--uid", one, *words)
    info = get("device_info")
    assert "DMX Footprint: 22" in info and "Sensor Count: 2" in info, info
    assert "Vari-Lite" in get("manufacturer_label"), get("manufacturer_label")
    assert "VL2500 Spot" in get("device_model_description")
    number = int(re.fullmatch(r"Head (\d+)\n", get("device_label")).group(1))
    assert get("dmx_start_address") == f"DMX Address: {address(number - 1)}\n", (number, get("dmx_start_address"))
    assert "Standard 22 channels" in get("dmx_personality_description", "1"), get("dmx_personality_description", "1")
    assert "Pan position" in get("sensor_definition", "0"), get("sensor_definition", "0")
    assert re.fullmatch(r"Sensor Number: 0\n(?:(?:Present Value|Lowest|Highest|Recorded): -?\d+\n){4}", get("sensor_value", "0")), get("sensor_value", "0")
    assert "Dimmer" in get("slot_description", "0"), get("slot_description", "0")
    slots = get("slot_info").splitlines()
    assert len(slots) == 22 and slots[2] == "Slot offset 2: Secondary, fine control for slot 1", slots
    supported = get("supported_parameters")
    assert "0x00e0 (dmx_personality)" in supported, supported
    print("ok: device info, personality, sensors, slots")
    refused = desk("ola_rdm_set", "-u", "1", "--uid", one, "dmx_start_address", "100")
    assert "rotect" in refused, refused
    print("ok: an address may not be set here:", refused.strip())
    desk("ola_rdm_set", "-u", "1", "--uid", one, "identify_device", "1")
    wait("identify is on and said", lambda: "identify on" in log.read_text())
    assert get("identify_device") == "Identify State: true\n", get("identify_device")


def main():
    if os.geteuid() != 0:
        needs.skip("needs root for network namespaces")
    needs.packages("ola", "iproute2", "util-linux")
    if not os.access(GHOSTLIGHT, os.X_OK):
        needs.skip(f"{GHOSTLIGHT} is not built")
    with namespaces() as (desk_space, our_space), tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        log = work / "monitor.txt"
        with log.open("w") as file:
            monitor = subprocess.Popen(inside(our_space, GHOSTLIGHT, "monitor", "--show", write_show(work), "--rdm", "--interface", "net0", "--every", "0.5"),
                                       stdout=file, stderr=subprocess.STDOUT)
        try:
            with olad(desk_space, work) as desk:
                drive(desk, log)
        finally:
            monitor.kill()
            monitor.wait()
            print(log.read_text()[:300])


if __name__ == "__main__":
    main()
