#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Holds the folders of src/ to the layers of CMakeLists.txt.

The layers are read from CMakeLists.txt: a folder sees its own headers and those of the folders that its library links, directly
or through them. Other people's headers and those of the operating system belong to folders or files of the tables below; a
header in no table is an error. Long files and files without a licence line or include guard are reported too.

Usage: check_includes.py [SOURCE_ROOT]. Exit 0: all hold; 1: each breach is printed as file:line: message.
"""
import re
import sys
from pathlib import Path

# Libraries: what the include starts with, and the folders it may stand in.
LIBRARIES = {
    "seccomp.h": {"base"},
    "vulkan/": {"gpu", "render"},
    "embree3/": {"bake"},
    "embree4/": {"bake"},
    "tbb/": {"bake"},
    "zip.h": {"fixture", "scene"},
    "zlib.h": {"dmx"},
    "zstd.h": {"dmx"},
    "pugixml.hpp": {"fixture", "scene"},
    "assimp/": {"scene"},
    "meshoptimizer.h": {"render"},
    "toml++/": {"scene"},
    "nlohmann/": {"base", "fixture", "scene", "bake", "app"},
    "OpenEXR/": {"image"},
    "Imath": {"image"},
    "stb/": {"image"},
    "libav": {"video"},
    "libswscale/": {"video"},
    "CLI/": {"app"},
    "glm/": {"image", "fixture", "scene", "bake", "render", "ui", "app", "shared"},
}
QT = re.compile(r"Q[A-Z]")
SOCKETS = ("arpa/", "ifaddrs.h", "net/", "netdb.h", "netinet/", "sys/epoll.h", "sys/socket.h")
# Operating system and processor: the only files that a port to another system has to look at.
PLATFORM_FILES = {
    "src/base/files.cpp": "fsync",
    "src/base/own_folder.cpp": "folders without following links",
    "src/base/hold.cpp": "file locks, name of the host",
    "src/base/user_file.cpp": "put into place without replacing",
    "src/base/helper_process.cpp": "another process, a pair of sockets to it, its limits",
    "src/base/disk_sync.cpp": "fdatasync, flock",
    "src/base/child.cpp": "other programs",
    "src/base/user_cache.cpp": "may this user write there",
    "src/base/memory.cpp": "mallopt",
    "src/base/progress.cpp": "is standard error a terminal",
    "src/dmx/socket_linux.cpp": "sockets",
    "src/dmx/tcp_linux.cpp": "TCP",
    "src/dmx/serial_linux.cpp": "serial ports, MIDI ports",
    "src/video/camera_linux.cpp": "video devices",
    "src/bake/tracer.cpp": "SSE mode of Embree",
    "src/app/bench_offline.cpp": "memory and start of another process",
    "src/app/bench_window.cpp": "start of another process",
}
# Headers of shaders/ that C++ reads too, and the headers made from shaders.
SHADER_HEADERS = {"shared": {"shared", "scene", "bake", "render", "ui", "app"}, "shaders": {"render"}}
MAX_LINES = 600
LONG_FILE_REASON = f"over {MAX_LINES} lines"  # a longer file says why in its first ten lines, with these words

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
TYPE = re.compile(r"(?:struct|class|enum class) (\w+)(?: final)?(?:$| \{| : )")  # defined at the outside of a file, not declared


def read_layers(cmake):
    """Folder -> the folders it may include, from the ghost_library lines and the libraries of ghost_app."""
    text = re.sub(r"#.*", "", cmake)
    libraries = re.findall(r"^ghost_library\((\w+)([^)]*)\)", text, re.M)
    libraries += re.findall(r"target_link_libraries\(ghost_(app)([^)]*)\)", text)
    names = {name for name, _ in libraries}
    layers = {}
    for name, links in libraries:
        layers[name] = {name}
        for link in names & set(re.findall(r"ghost_(\w+)", links)):
            if link not in layers:
                sys.exit(f"CMakeLists.txt: {name} links {link}, which does not stand above it")
            layers[name] |= layers[link]
    return layers


def check_quoted(folder, include, visible, layers):
    """Message, or None when this folder may include that header of ours."""
    target = include.split("/")[0] if "/" in include else None
    if target is None or ".." in include:
        return f'"{include}": includes start at src/ ("folder/file.h")'
    if target in SHADER_HEADERS:
        allowed = SHADER_HEADERS[target]
        return None if folder in allowed else f'"{include}": only {", ".join(sorted(allowed))} may'
    if target not in layers:
        return f'"{include}": there is no folder {target}'
    if target not in visible:
        return f'"{include}": {folder} does not stand on {target} (CMakeLists.txt)'
    return None


def check_angled(folder, file, include):
    """Message, or None when this file may include that header of somebody else's."""
    for start, folders in LIBRARIES.items():
        if include.startswith(start):
            return None if folder in folders else f"<{include}>: only {', '.join(sorted(folders))} may"
    if QT.match(include):
        return None if folder == "ui" else f"<{include}>: Qt belongs to ui"
    if include.startswith(SOCKETS) and folder != "dmx" and file not in PLATFORM_FILES:
        return f"<{include}>: sockets belong to dmx"
    if "." not in include and "/" not in include:
        return None  # the C++ library
    if file not in PLATFORM_FILES:
        return f"<{include}>: unknown, or a header of the system outside of the files in tools/check_includes.py"
    return None


def check_form(path, lines):
    """Breaches that concern the whole file, as (line, message)."""
    head = "\n".join(lines[:10])
    if "SPDX-License-Identifier: Apache-2.0" not in head:
        yield 1, "no licence line (SPDX-License-Identifier: Apache-2.0)"
    if path.suffix == ".h" and "#pragma once" not in head and "#ifndef" not in head:
        yield 1, "no #pragma once"
    if len(lines) > MAX_LINES and LONG_FILE_REASON not in head:
        yield MAX_LINES, f'{len(lines)} lines: split it, or say at the top why it is "{LONG_FILE_REASON}"'


def check_layers(file, lines, folder, visible, layers):
    """Breaches of the includes of a file of this folder, as (line, message)."""
    for number, line in enumerate(lines, 1):
        found = INCLUDE.match(line)
        if not found:
            continue
        angled, include = found[1] == "<", found[2]
        message = check_angled(folder, file, include) if angled else check_quoted(folder, include, visible, layers)
        if message:
            yield number, message


def check_entrances(file, lines):
    """Breaches of the one entrance for JSON, which has its limits, and of the one exit to a terminal, as (line, message)."""
    for number, line in enumerate(lines, 1):
        if not file.startswith("src/base/") and re.search(r"std::(printf|puts|fputs|cout|cerr)\b|fprintf\(std", line):
            yield number, "what reaches a terminal goes through base/print.h or base/log.h"
        if file != "src/base/json.cpp" and re.search(r"json::(sax_)?parse\(", line, re.I):
            yield number, "JSON is read by base/json.h, which has limits"


def check_types(file, lines, folder, types):
    """Breaches of one name for two types of a namespace, which no linker sees and which crash; as (line, message). types: of all files so far."""
    hidden = False
    for number, line in enumerate(lines, 1):
        if line in ("namespace {", "} // namespace"):
            hidden = line == "namespace {"
        found = None if hidden else TYPE.match(line)
        if not found:
            continue
        other = types.setdefault((folder, found[1]), f"{file}:{number}")
        if other != f"{file}:{number}":
            yield number, f"{found[1]}: another type of this name stands at {other}"


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent)
    layers = read_layers((root / "CMakeLists.txt").read_text(encoding="utf-8"))
    files = breaches = 0
    types = {}
    for path in sorted(path for top in ("src", "shaders", "tests", "tools") for path in (root / top).rglob("*")):
        if path.suffix not in (".h", ".cpp", ".comp", ".glsl", ".py", ".sh"):
            continue
        files += 1
        file = path.relative_to(root).as_posix()
        top, folder = file.split("/")[0], path.parent.name
        lines = path.read_text(encoding="utf-8").splitlines()
        found = list(check_form(path, lines))
        if top == "src" and folder not in layers:
            found.append((1, f"{folder or top} is not a library of CMakeLists.txt"))
        if top == "src":
            found += check_types(file, lines, folder, types)
            found += check_entrances(file, lines)
        if (top == "src" and folder in layers) or folder == "shared":
            found += check_layers(file, lines, folder, layers.get(folder, {folder}), layers)
        for number, message in found:
            print(f"{file}:{number}: {message}")
        breaches += len(found)
    print(f"{files} files, {len(layers)} layers, {breaches} breaches")
    return 1 if breaches or not files else 0


if __name__ == "__main__":
    sys.exit(main())
