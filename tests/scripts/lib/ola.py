# SPDX-License-Identifier: Apache-2.0
"""OLA (Debian package ola) as an RDM controller over Art-Net, in a network namespace beside one of ours: with namespaces() as (DESK, VIS),
olad(DESK, folder) as desk: desk("ola_rdm_get", ...). OLA's universe 1 is Port-Address 1, our universe 2."""
import contextlib
import os
import pathlib
import re
import subprocess
import time

import needs

PLUGINS = ("artnet dummy e131 espnet ftdidmx gpio karate kinet milinst nanoleaf opendmx openpixelcontrol osc pathport renard sandnet shownet spi "
           "stageprofi uartdmx usbdmx usbserial").split()

SETTINGS = {
    "artnet": {"always_broadcast": "false", "long_name": "test", "net": 0, "short_name": "test", "subnet": 0, "use_limited_broadcast": "false",
               "use_loopback": "false"},
    "e131": {"cid": "00010203-0405-0607-0809-0a0b0c0d0e0f", "draft_discovery": "false", "dscp": 0, "ignore_preview": "true", "input_ports": 4,
             "prepend_hostname": "false", "revision": "0.46"},
}


def ip(*words):
    subprocess.run(["ip", *words], check=True, capture_output=True, text=True, timeout=20)


def inside(namespace, *words):
    return ["ip", "netns", "exec", namespace, *map(str, words)]


def wait(what, condition, limit_s=90):
    end = time.monotonic() + limit_s
    while time.monotonic() < end:
        found = condition()
        if found:
            print("ok:", what, flush=True)
            return found
        time.sleep(0.3)
    raise AssertionError(what)


@contextlib.contextmanager
def namespaces():
    """A desk at 10.93.0.1 and we at 10.93.0.2, by net0; skips where there are none."""
    names = f"gl_d{os.getpid()}", f"gl_v{os.getpid()}"
    made = []
    try:
        try:
            for name in names:
                ip("netns", "add", name)
                made.append(name)
                ip("-n", name, "link", "set", "lo", "up")
            ip("-n", names[0], "link", "add", "net0", "type", "veth", "peer", "name", "net0", "netns", names[1])
            for name, address in zip(names, ("10.93.0.1", "10.93.0.2")):
                ip("-n", name, "addr", "add", f"{address}/24", "brd", "+", "dev", "net0")
                ip("-n", name, "link", "set", "net0", "up")
        except subprocess.CalledProcessError as error:
            needs.skip(f"no network namespaces here: {error}")
        yield names
    finally:
        for name in made:
            subprocess.run(["ip", "netns", "del", name], capture_output=True)


def daemon_of(folder, plugin, **settings):
    """The words that run it with this plugin alone, at 10.93.0.1 unless told otherwise."""
    conf = pathlib.Path(folder) / "ola"
    conf.mkdir()
    for other in PLUGINS:
        (conf / f"ola-{other}.conf").write_text("enabled = false\n")
    lines = {"enabled": "true", "ip": "10.93.0.1", "output_ports": 4, **SETTINGS[plugin], **settings}
    (conf / f"ola-{plugin}.conf").write_text("".join(f"{name} = {value}\n" for name, value in sorted(lines.items())))
    user = "olad" if subprocess.run(["id", "olad"], capture_output=True).returncode == 0 else "nobody"
    pathlib.Path(folder).chmod(0o755)
    subprocess.run(["chown", "-R", user, conf], check=True)
    return ["setpriv", f"--reuid={user}", "--regid=nogroup", "--clear-groups", "olad", "--no-http", "--no-register-with-dns-sd", "-l", "2", "-c", conf]


@contextlib.contextmanager
def olad(namespace, folder):
    """Runs it, its output at our universe 2; yields what runs a command beside it and returns what that said."""
    words = daemon_of(folder, "artnet")

    def desk(*words, limit_s=120):
        done = subprocess.run(inside(namespace, *words), capture_output=True, text=True, timeout=limit_s)
        return done.stdout + done.stderr

    daemon = subprocess.Popen(inside(namespace, *words), stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    try:
        wait("olad runs", lambda: "ArtNet" in desk("ola_dev_info"))
        number = re.search(r"Device (\d+)[^\n]*ArtNet", desk("ola_dev_info")).group(1)
        desk("ola_patch", "-d", number, "-p", "0", "-u", "1")
        yield desk
    finally:
        daemon.kill()
        daemon.wait()


def known(desk, *words):
    """Whom OLA knows, without asking."""
    return sorted(set(re.findall(r"7ff0:[0-9a-f]{8}", desk("ola_rdm_discover", "-u", "1", *words))))


def discover(desk):
    return known(desk, "--full")
