#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The rooms keep to their links (tools/check_includes.py), and the check finds each kind of breach. The argument is the source root."""
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

root = Path(sys.argv[1])
check = root / "tools/check_includes.py"

held = subprocess.run([sys.executable, check, root], capture_output=True, text=True)
print(held.stdout, end="")
if held.returncode:
    sys.exit("the tree breaks its rooms, see above")

HEAD = "// SPDX-License-Identifier: Apache-2.0\n"
# file, its text, a part of the message that must come
BREACHES = [
    ("src/bake/a.cpp", HEAD + '#include "render/relight/relighter.h"\n', 'a.cpp:2: "render/relight/relighter.h": bake does not link render/relight'),
    ("src/render/relight/b.cpp", HEAD + '#include "bake/bake_show.h"\n', "render/relight does not link bake"),
    ("src/base/c.cpp", HEAD + '#include "live/session/session.h"\n', "base does not link live/session"),
    ("src/dmx/wire/d.cpp", HEAD + '#include "image/image.h"\n', "dmx/wire does not link image"),
    ("src/stage/e.cpp", HEAD + "#include <vulkan/vulkan.h>\n", "<vulkan/vulkan.h>: only"),
    ("src/cli/f.cpp", HEAD + "#include <sys/socket.h>\n", "sockets belong to net"),
    ("src/cli/g.cpp", HEAD + "#include <unistd.h>\n", "<unistd.h>: unknown, or a header of the system"),
    ("src/gpu/h.cpp", HEAD + '#include "shared/beam.h"\n', 'h.cpp:2: "shared/beam.h": only'),
    ("src/stage/i.cpp", HEAD + '#include "show.h"\n', "includes start at src/"),
    ("src/nowhere/j.cpp", HEAD, "nowhere is no room"),
    ("src/base/k.h", HEAD, "no #pragma once"),
    ("tests/base/l.cpp", "\n", "no licence line"),
    ("src/base/m.cpp", HEAD + "\n" * 600, "601 lines"),
    ("src/show_file/p.cpp", HEAD + "namespace ghost::scene {\nclass Twin {\n};\nnamespace {\nstruct Twin {};\n} // namespace\nstruct Twin;\n",
     "src/stage/aa.h:4: Twin: another type of this name stands at src/show_file/p.cpp:3"),
    ("src/cli/r.cpp", HEAD + 'std::printf("%s", name);\n', "r.cpp:2: what reaches a terminal goes through"),
    ("src/stage/q.cpp", HEAD + "const auto all = nlohmann::json::parse(text);\n", "q.cpp:2: JSON is read by json_xml_toml/json.h"),
    ("src/show_folder/s.cpp", HEAD + '#include "stage/private/t.h"\n', 's.cpp:2: "stage/private/t.h": is for stage alone'),
    ("src/show_folder/u.cpp", HEAD + '#include "show/none.h"\n', "there is no such header"),
    ("shaders/shared/n.h", HEAD + '#pragma once\n#include "show/show.h"\n', "shared does not link show"),
    ("tools/40.py", HEAD, "tools:1: 41 files, at most 40"),
    ("docs/design/rooms.svg", "<svg/>", "rooms.svg:1: is not what src/CMakeLists.txt says"),
    ("docs/design/rooms.md", "", "rooms.md:1: is not what src/CMakeLists.txt says"),
]
with tempfile.TemporaryDirectory() as folder:
    tree = Path(folder)
    shutil.copytree(root / "src", tree / "src")
    (tree / "src/stage/aa.h").write_text(HEAD + "#pragma once\nnamespace ghost::scene {\nstruct Twin {\n};\n}\n", encoding="utf-8")
    (tree / "src/stage/private").mkdir(exist_ok=True)
    (tree / "src/stage/private/t.h").write_text(HEAD + "#pragma once\n", encoding="utf-8")
    for k in range(40):
        (tree / "tools").mkdir(exist_ok=True)
        (tree / f"tools/{k}.py").write_text(HEAD, encoding="utf-8")
    for file, text, _ in BREACHES:
        (tree / file).parent.mkdir(parents=True, exist_ok=True)
        (tree / file).write_text(text, encoding="utf-8")
    found = subprocess.run([sys.executable, check, tree], capture_output=True, text=True)
    cmake = tree / "src/CMakeLists.txt"
    cmake.write_text(cmake.read_text(encoding="utf-8").replace("ghost_room(net LINKS base", "ghost_room(net LINKS base disk"), encoding="utf-8")
    idle = subprocess.run([sys.executable, check, tree], capture_output=True, text=True)
missed = [f"{file}: {message}" for file, _, message in BREACHES if message not in found.stdout]
if found.returncode != 1 or missed or found.stdout.count("\n") != len(BREACHES) + 1:
    sys.exit(f"exit {found.returncode}, not found: {missed}\n{found.stdout}")
if "net links disk, and needs nothing of it" not in idle.stdout:
    sys.exit(f"an idle link is not found\n{idle.stdout}")
print(f"{len(BREACHES) + 1} kinds of breach are found")
