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
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "lib"))
import needs  # noqa: E402

SOURCE = pathlib.Path(sys.argv[1]).resolve()
GHOSTLIGHT = str(pathlib.Path(sys.argv[2]).resolve() / "ghostlight")
DESK, VIS = f"gl_d{os.getpid()}", f"gl_v{os.getpid()}"
HEADS = 400
PLUGINS = ("dummy e131 espnet ftdidmx gpio karate kinet milinst nanoleaf opendmx openpixelcontrol osc pathport renard sandnet shownet spi "
           "stageprofi uartdmx usbdmx usbserial").split()


def ip(*words):
    subprocess.run(["ip", *words], check=True, capture_output=True, text=True, timeout=20)


def inside(namespace, *words):
    return ["ip", "netns", "exec", namespace, *map(str, words)]


def desk(*words, limit_s=120):
    done = subprocess.run(inside(DESK, *words), capture_output=True, text=True, timeout=limit_s)
    return done.stdout + done.stderr


def wait(what, condition, limit_s=90):
    end = time.monotonic() + limit_s
    while time.monotonic() < end:
        found = condition()
        if found:
            print("ok:", what)
            return found
        time.sleep(0.5)
    raise AssertionError(what)


def write_show(work):
    """400 heads on one universe; that they share addresses does not matter here."""
    toml = '[show]\nname = "rdm"\n[[camera]]\nposition_m = [0, -12, 3]\ntarget_m = [0, 2, 2]\n'
    for i in range(HEADS):
        toml += (f'[[fixture]]\nname = "Head {i + 1}"\ngdtf = "{SOURCE}/assets/fixtures/Vari-Lite@VL2500_Spot.gdtf"\n'
                 f"universe = 2\naddress = {1 + i % 490}\nposition_m = [{i % 20}, {i // 20}, 6]\n")
    show = work / "show"
    show.mkdir()
    (show / "show.toml").write_text(toml)
    return show


def drive(work):
    show = write_show(work)
    log = (work / "monitor.txt").open("w")
    monitor = subprocess.Popen(inside(VIS, GHOSTLIGHT, "monitor", "--show", show, "--rdm", "--interface", "net0", "--every", "0.5"), stdout=log,
                               stderr=subprocess.STDOUT)
    conf = work / "ola"
    conf.mkdir()
    for plugin in PLUGINS:
        (conf / f"ola-{plugin}.conf").write_text("enabled = false\n")
    (conf / "ola-artnet.conf").write_text("always_broadcast = false\nenabled = true\nip = 10.93.0.1\nlong_name = test\nnet = 0\noutput_ports = 4\n"
                                          "short_name = test\nsubnet = 0\nuse_limited_broadcast = false\nuse_loopback = false\n")
    user = "olad" if subprocess.run(["id", "olad"], capture_output=True).returncode == 0 else "nobody"
    work.chmod(0o755)
    subprocess.run(["chown", "-R", user, conf], check=True)
    olad = subprocess.Popen(inside(DESK, "setpriv", f"--reuid={user}", "--regid=nogroup", "--clear-groups", "olad", "--no-http",
                                   "--no-register-with-dns-sd", "-l", "2", "-c", conf), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        wait("olad runs", lambda: "ArtNet" in desk("ola_dev_info"))
        device = re.search(r"Device (\d+): ArtNet|Device (\d+)[^\n]*ArtNet", desk("ola_dev_info"))
        number = next(one for one in device.groups() if one)
        desk("ola_patch", "-d", number, "-p", "0", "-u", "1")  # OLA's universe 1 is Port-Address 1, our universe 2

        def discovered():
            text = desk("ola_rdm_discover", "-u", "1", "--full")
            found = sorted(set(re.findall(r"7ff0:[0-9a-f]{8}", text)))
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
        assert re.search(r"DMX Address: \d+|\d+", get("dmx_start_address"))
        assert "Standard 22 channels" in get("dmx_personality_description", "1"), get("dmx_personality_description", "1")
        assert "Pan position" in get("sensor_definition", "0"), get("sensor_definition", "0")
        assert "Number: 0" in get("sensor_value", "0") or "Present" in get("sensor_value", "0"), get("sensor_value", "0")
        assert "Dimmer" in get("slot_description", "0"), get("slot_description", "0")
        assert "slot" in get("slot_info").lower(), get("slot_info")  # comes in parts
        supported = get("supported_parameters")
        assert "dmx_personality" in supported.lower() or "e0" in supported.lower(), supported
        print("ok: device info, personality, sensors, slots")
        refused = desk("ola_rdm_set", "-u", "1", "--uid", one, "dmx_start_address", "100")
        assert "rotect" in refused, refused
        print("ok: an address may not be set here:", refused.strip())
        desk("ola_rdm_set", "-u", "1", "--uid", one, "identify_device", "1")
        wait("identify is on and said", lambda: "identify on" in (work / "monitor.txt").read_text())
        assert "true" in get("identify_device").lower() or "on" in get("identify_device").lower(), get("identify_device")
    finally:
        for process in (olad, monitor):
            process.kill()
            process.wait()
        print((work / "monitor.txt").read_text()[:300])


def main():
    if os.geteuid() != 0:
        needs.skip("needs root for network namespaces")
    needs.packages("ola", "iproute2", "util-linux")
    if not os.access(GHOSTLIGHT, os.X_OK):
        needs.skip(f"{GHOSTLIGHT} is not built")
    made = []
    try:
        try:
            for namespace in (DESK, VIS):
                ip("netns", "add", namespace)
                made.append(namespace)
                ip("-n", namespace, "link", "set", "lo", "up")
            ip("-n", DESK, "link", "add", "net0", "type", "veth", "peer", "name", "net0", "netns", VIS)
            for namespace, address in ((DESK, "10.93.0.1"), (VIS, "10.93.0.2")):
                ip("-n", namespace, "addr", "add", f"{address}/24", "brd", "+", "dev", "net0")
                ip("-n", namespace, "link", "set", "net0", "up")
        except subprocess.CalledProcessError as error:
            needs.skip(f"no network namespaces here: {error}")
        with tempfile.TemporaryDirectory() as folder:
            drive(pathlib.Path(folder))
    finally:
        for namespace in made:
            subprocess.run(["ip", "netns", "del", namespace], capture_output=True)


if __name__ == "__main__":
    main()
