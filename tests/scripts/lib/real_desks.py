# SPDX-License-Identifier: Apache-2.0
"""OLA and QLC+ (Debian packages ola, qlcplus) as desks of mistakes_test.py, each from the settings of a row: ola(), qlc() make them,
start() runs what a Stage's set-up has and returns when it sends. Levels: {address from 1: value}."""
import pathlib
import subprocess
import sys
import time

import needs
from mistakes import OPEN
from ola import daemon_of, inside

PACKAGES = {"ola": ("ola", "util-linux"), "qlc": ("qlcplus",)}
LIMIT_S = 90  # for a desk to come up


def ola(plugin, universe=1, levels=None, patched=True, priority=100, on="desk", **settings):
    """universe: OLA's number; settings: of the plugin's file."""
    return {"ola": {"plugin": plugin, "universe": universe, "levels": OPEN if levels is None else levels, "patched": patched, "priority": priority,
                    "on": on, "settings": settings}}


def qlc(plugin, levels=None, card="10.93.0.1", plays=True, on="desk", **parameters):
    """plugin: E1.31 or ArtNet; parameters: of its output; no plugin: QLC+'s universe has none."""
    return {"qlc": {"plugin": plugin, "levels": OPEN if levels is None else levels, "card": card, "plays": plays, "on": on, "parameters": parameters}}


def missing(setup):
    """Why this set-up cannot be staged here, or nothing."""
    names = [name for desk, packages in PACKAGES.items() if setup.get(desk) for name in packages if not needs.is_there(name)]
    return f"{' and '.join(names)} {'is' if len(names) == 1 else 'are'} not installed" if names else ""


def namespace_of(stage, spec):
    return stage.desk if spec["on"] == "desk" else stage.vis


def start_ola(stage, spec):
    namespace = namespace_of(stage, spec)
    quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
    stage.start(namespace, *daemon_of(stage.folder, spec["plugin"], **spec["settings"]), **quiet)
    end = time.monotonic() + LIMIT_S
    device = ""
    while not device:
        assert time.monotonic() < end, "olad did not come up"
        time.sleep(0.2)
        said = subprocess.run(inside(namespace, "ola_dev_info"), capture_output=True, text=True, timeout=LIMIT_S).stdout
        found = [line for line in said.splitlines() if line.startswith("Device ")]
        device = found[0].split()[1].rstrip(":") if found else ""
    port = ["-d", device, "-p", 0]
    if spec["patched"]:
        stage.command(namespace, "ola_patch", *map(str, port), "-u", str(spec["universe"]))
    row = ",".join(str(spec["levels"].get(address, 0)) for address in range(1, 513))
    client = f"while echo {row}; do sleep 0.1; done | ola_streaming_client -u {spec['universe']} --priority {spec['priority']}"
    stage.start(namespace, "sh", "-c", client, **quiet)


def start_qlc(stage, spec):
    sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[3] / "tools/demo_show"))
    from qlc import Workspace  # noqa: E402  (the folder is known only now)
    words = " ".join(f'{name}="{value}"' for name, value in spec["parameters"].items())
    line = 0 if spec["card"].startswith("127.") else 1
    output = f'<Output Plugin="{spec["plugin"]}" UID="{spec["card"]}" Line="{line}"><PluginParameters {words}/></Output>' if spec["plugin"] else ""
    desk = Workspace([("U1", output)])
    lamp = desk.fixture("All", "Generic", "Generic", "Generic", 1, 1, 512)
    scene = desk.scene("Look", {lamp: {address - 1: value for address, value in spec["levels"].items()}})
    if spec["plays"]:
        desk.place("Track", scene, 0, 3600)
    (stage.folder / "desk.qxw").write_text(desk.text("Show", "test"))
    stage.start(namespace_of(stage, spec), "env", f"HOME={stage.folder}", f"XDG_RUNTIME_DIR={stage.folder}", "QT_QPA_PLATFORM=offscreen", "qlcplus", "--nowm", "--nogui",
                "--open", stage.folder / "desk.qxw", "--operate", stdout=(stage.folder / "qlcplus.txt").open("w"), stderr=subprocess.STDOUT)


def start(stage):
    for name, run in (("ola", start_ola), ("qlc", start_qlc)):
        if stage.setup[name]:
            run(stage, stage.setup[name])
