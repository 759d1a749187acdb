#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The includes keep to the layers (tools/check_includes.py), and the check finds each kind of breach. The argument is the source root."""
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
    sys.exit("the tree breaks its layers, see above")

HEAD = "// SPDX-License-Identifier: Apache-2.0\n"
# file, its text, a part of the message that must come
BREACHES = [
    ("src/bake/a.cpp", HEAD + '#include "render/relighter.h"\n', "a.cpp:2: \"render/relighter.h\": bake does not stand on render"),
    ("src/render/b.cpp", HEAD + '#include "bake/frame.h"\n', "render does not stand on bake"),
    ("src/base/c.cpp", HEAD + '#include "app/session.h"\n', "base does not stand on app"),
    ("src/dmx/d.cpp", HEAD + '#include "image/image.h"\n', "dmx does not stand on image"),
    ("src/scene/e.cpp", HEAD + "#include <vulkan/vulkan.h>\n", "<vulkan/vulkan.h>: only"),
    ("src/app/f.cpp", HEAD + "#include <sys/socket.h>\n", "sockets belong to dmx"),
    ("src/app/g.cpp", HEAD + "#include <unistd.h>\n", "<unistd.h>: unknown, or a header of the system"),
    ("src/gpu/h.cpp", HEAD + '#include "shared/beam.h"\n', "h.cpp:2: \"shared/beam.h\": only"),
    ("src/scene/i.cpp", HEAD + '#include "show.h"\n', "includes start at src/"),
    ("src/nowhere/j.cpp", HEAD, "nowhere is not a library"),
    ("src/base/k.h", HEAD, "no #pragma once"),
    ("tests/base/l.cpp", "\n", "no licence line"),
    ("src/base/m.cpp", HEAD + "\n" * 600, "601 lines"),
    ("src/scene/p.cpp", HEAD + "class Twin {\n};\nnamespace {\nstruct Twin {};\n} // namespace\nstruct Twin;\n", "p.cpp:2: Twin: another type of this name stands at src/scene/aa.h:3"),
    ("src/app/r.cpp", HEAD + 'std::printf("%s", name);\n', "r.cpp:2: what reaches a terminal goes through"),
    ("src/scene/q.cpp", HEAD + "const auto all = nlohmann::json::parse(text);\n", "q.cpp:2: JSON is read by base/json.h"),
    ("shaders/shared/n.h", HEAD + '#pragma once\n#include "scene/show.h"\n', "shared does not stand on scene"),
]
with tempfile.TemporaryDirectory() as folder:
    tree = Path(folder)
    shutil.copy(root / "CMakeLists.txt", tree)
    (tree / "src/scene").mkdir(parents=True)
    (tree / "src/scene/aa.h").write_text(HEAD + "#pragma once\nstruct Twin {\n};\n", encoding="utf-8")
    for file, text, _ in BREACHES:
        (tree / file).parent.mkdir(parents=True, exist_ok=True)
        (tree / file).write_text(text, encoding="utf-8")
    found = subprocess.run([sys.executable, check, tree], capture_output=True, text=True)
missed = [f"{file}: {message}" for file, _, message in BREACHES if message not in found.stdout]
if found.returncode != 1 or missed or found.stdout.count("\n") != len(BREACHES) + 1:
    sys.exit(f"exit {found.returncode}, not found: {missed}\n{found.stdout}")
print(f"{len(BREACHES)} kinds of breach are found")
