#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Holds the rooms of src/ to the links of src/CMakeLists.txt, and draws them.

A room is a folder with a library of its own. It may include its own headers and those of the rooms that its line LINKS, all of which
stand above it in that file; a link that nothing needs is an error, too. Headers in ROOM/private are for the room and its tests, sources in
ROOM/system are those that differ from system to system. Other people's headers and those of the operating system belong to the rooms or files of the tables below; a header in no table is an error. Long
files, full folders and files without a licence line or include guard are reported as well.

Usage: check_includes.py [SOURCE_ROOT] [--draw]. --draw writes docs/design/rooms.svg and rooms.md; without it, one that is older than
src/CMakeLists.txt is an error. Exit 0: all hold; 1: each breach is printed as file:line: message.
"""
import re
import sys
from pathlib import Path

import rooms_picture

# Libraries: what the include starts with, and the rooms it may stand in ("ui" is all of ui/...).
LIBRARIES = {
    "seccomp.h": {"base"},
    "vulkan/": {"gpu", "render"},
    "embree3/": {"rays"},
    "embree4/": {"rays"},
    "tbb/": {"reference", "bake", "render/geometry", "render/haze", "render/pixels"},
    "immintrin.h": {"render/pixels"},
    "cpuid.h": {"render/pixels"},
    "qrencode.h": {"web"},
    "zip.h": {"archives", "mvr"},
    "xxhash.h": {"bake"},
    "zlib.h": {"archives", "disk"},
    "zstd.h": {"dmx/record"},
    "pugixml.hpp": {"json_xml_toml", "fixture_files", "mvr"},
    "assimp/": {"stage"},
    "meshoptimizer.h": {"render/geometry"},
    "toml++/": {"json_xml_toml", "show_file"},
    "nlohmann/": {"json_xml_toml", "fixture_files/ofl", "stage", "passes", "diagnose", "book", "xchange", "web", "live/session", "farm", "bench", "cli"},
    "OpenEXR/": {"image"},
    "Imath": {"image"},
    "png.h": {"image"},
    "turbojpeg.h": {"image"},
    "cairo-pdf.h": {"print"},
    "pango/": {"print"},
    "libav": {"video"},
    "libswresample/": {"video"},
    "libswscale/": {"video"},
    "alsa/": {"sound"},
    "ltc.h": {"sound"},
    "CLI/": {"cli", "farm", "bench/program"},
    "glm/": None,  # vectors, everywhere
}
QT = re.compile(r"Q[A-Z]")
SOCKETS = ("arpa/", "ifaddrs.h", "net/", "netdb.h", "netinet/", "sys/epoll.h", "sys/socket.h", "winsock2.h", "ws2tcpip.h", "mswsock.h", "iphlpapi.h")
# Operating system and processor: the only files that a port to another system has to look at.
PLATFORM_FILES = {
    "src/archives/system/open_zip_windows.cpp": "a zip file that others may replace",
    "src/disk/system/files_posix.cpp": "whole files",
    "src/disk/system/files_windows.cpp": "whole files, locks, put into place without replacing",
    "src/disk/system/links_windows.cpp": "links and junctions",
    "src/disk/system/own_folder_posix.cpp": "folders without following links",
    "src/disk/system/own_folder_windows.cpp": "folders without following links",
    "src/disk/system/disk_sync_linux.cpp": "fsync, fdatasync, flock, put into place without replacing",
    "src/disk/system/disk_sync_mac.cpp": "F_FULLFSYNC, flock, put into place without replacing",
    "src/disk/system/user_folders_posix.cpp": "may this user write there",
    "src/disk/system/user_folders_windows.cpp": "may this user write there, known folders",
    "src/disk/system/own_program_mac.cpp": "the file that runs",
    "src/disk/system/own_program_windows.cpp": "the file that runs",
    "src/show_folder/system/hold_posix.cpp": "file locks",
    "src/show_folder/system/hold_windows.cpp": "file locks",
    "src/base/system/helper_process_linux.cpp": "another process, a pair of sockets to it, its limits",
    "src/base/system/helper_process_mac.cpp": "another process, a pair of sockets to it, its limits",
    "src/base/system/helper_process_windows.cpp": "another process, a pipe to it, its job",
    "src/base/system/child_posix.cpp": "other programs",
    "src/base/system/child_windows.cpp": "other programs",
    "src/base/private/start_windows.h": "CreateProcess",
    "src/base/system/start_windows.cpp": "CreateProcess",
    "src/base/system/text_windows.cpp": "UTF-16, texts of errors",
    "src/base/system/memory_linux.cpp": "mallopt",
    "src/base/system/memory_mac.cpp": "what Mach says of memory",
    "src/base/system/memory_windows.cpp": "what Windows says of memory",
    "src/base/system/give_way_linux.cpp": "priority of a thread",
    "src/base/system/give_way_mac.cpp": "priority of a thread",
    "src/base/system/give_way_windows.cpp": "priority of a thread",
    "src/base/system/terminal_posix.cpp": "is standard error a terminal",
    "src/base/system/terminal_windows.cpp": "is standard error a terminal",
    "src/net/system/socket_linux.cpp": "sockets",
    "src/net/system/socket_mac.cpp": "sockets",
    "src/net/system/socket_windows.cpp": "sockets",
    "src/net/system/interfaces_windows.cpp": "network interfaces",
    "src/net/parse_address.cpp": "inet_pton",
    "src/net/system/port_users_windows.cpp": "whose a UDP port is",
    "src/net/private/winsock.h": "sockets",
    "src/net/system/tcp_linux.cpp": "TCP",
    "src/net/system/tcp_mac.cpp": "TCP",
    "src/net/system/tcp_windows.cpp": "TCP",
    "src/net/system/serial_posix.cpp": "serial ports, MIDI ports",
    "src/net/system/serial_windows.cpp": "serial ports",
    "src/video/camera_linux.cpp": "video devices",
    "src/rays/tracer.cpp": "SSE mode of Embree",
    "src/bench/bench_offline.cpp": "memory and start of another process",
}
# Headers of shaders/ that C++ reads too, and the headers made from shaders.
SHADER_HEADERS = {
    "shared": {"shared", "show", "show_file", "stage", "bounce", "photometry", "beam_groups", "passes", "light", "plots", "show_folder", "diagnose", "rays", "reference",
               "bake", "render", "live", "ui", "cli", "bench"},
    "shaders": {"render"},
}
MAX_LINES = 600
MAX_FILES = 40  # of a folder of sources
LONG_FILE_REASON = f"over {MAX_LINES} lines"  # a longer file says why in its first ten lines, with these words

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^">]+)[">]')
TYPE = re.compile(r"(?:struct|class|enum class) (\w+)(?: final)?(?:$| \{| : )")  # defined at the outside of a file, not declared


def read_rooms(cmake):
    """Room -> (the rooms that its line links, what the comment above says of it), in the order of src/CMakeLists.txt."""
    rooms = {}
    for purpose, name, rest in re.findall(r"^# (.*)\nghost_room\(([\w/]+)([^)]*)\)", cmake, re.M):
        links = re.search(r"LINKS((?: |\s)[^)]*?)(?=PUBLIC|PRIVATE|$)", rest, re.S)
        links = links[1].split() if links else []
        for link in links:
            if link not in rooms:
                sys.exit(f"src/CMakeLists.txt: {name} links {link}, which does not stand above it")
        rooms[name] = (links, purpose)
    return rooms


def room_of(path):
    """The room of a file of src/, or of the tests that mirror it."""
    folder = path.parent.as_posix().split("/", 1)
    return (folder[1] if len(folder) > 1 else "").removesuffix("/private").removesuffix("/system")


def is_in(room, rooms):
    return any(room == other or room.startswith(other + "/") for other in rooms)


def check_quoted(root, room, include, rooms, used):
    """Message, or None when this room may include that header of ours."""
    target = include.split("/")[0] if "/" in include else None
    if target is None or ".." in include:
        return f'"{include}": includes start at src/ ("room/file.h")'
    if target in SHADER_HEADERS:
        allowed = SHADER_HEADERS[target]
        return None if is_in(room, allowed) else f'"{include}": only {", ".join(sorted(allowed))} may'
    other = room_of(Path("src") / include)
    if not (root / "src" / include).is_file() or other not in rooms:
        return f'"{include}": there is no such header'
    if other == room:
        return None
    used.add(other)
    if "/private/" in include:
        return f'"{include}": is for {other} alone'
    if other not in rooms.get(room, ([], ""))[0]:
        return f'"{include}": {room} does not link {other} (src/CMakeLists.txt)'
    return None


def check_angled(room, file, include):
    """Message, or None when this file may include that header of somebody else's."""
    for start, rooms in LIBRARIES.items():
        if include.startswith(start):
            return None if rooms is None or is_in(room, rooms) else f"<{include}>: only {', '.join(sorted(rooms))} may"
    if QT.match(include):
        return None if is_in(room, {"ui"}) else f"<{include}>: Qt belongs to ui"
    if include.startswith(SOCKETS) and room != "net" and file not in PLATFORM_FILES:
        return f"<{include}>: sockets belong to net"
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


def check_links(root, file, lines, room, rooms, used):
    """Breaches of the includes of a file of this room, as (line, message). used: gets the rooms that it needs."""
    for number, line in enumerate(lines, 1):
        found = INCLUDE.match(line)
        if not found:
            continue
        angled, include = found[1] == "<", found[2]
        message = check_angled(room, file, include) if angled else check_quoted(root, room, include, rooms, used)
        if message:
            yield number, message


def check_entrances(file, lines):
    """Breaches of the one entrance for JSON, which has its limits, and of the one exit to a terminal, as (line, message)."""
    for number, line in enumerate(lines, 1):
        if not file.startswith("src/base/") and re.search(r"std::(printf|puts|fputs|cout|cerr)\b|fprintf\(std", line):
            yield number, "what reaches a terminal goes through base/print.h or base/log.h"
        if file != "src/json_xml_toml/json.cpp" and re.search(r"json::(sax_)?parse\(", line, re.I):
            yield number, "JSON is read by json_xml_toml/json.h, which has limits"


def check_types(file, lines, types):
    """Breaches of one name for two types of a namespace, which no linker sees and which crash; as (line, message). types: of all files so far."""
    hidden, space = False, ""
    for number, line in enumerate(lines, 1):
        if line in ("namespace {", "} // namespace"):
            hidden = line == "namespace {"
        elif named := re.match(r"namespace (ghost[\w:]*) \{", line):
            space = named[1]
        found = None if hidden else TYPE.match(line)
        if not found:
            continue
        other = types.setdefault((space, found[1]), f"{file}:{number}")
        if other != f"{file}:{number}":
            yield number, f"{found[1]}: another type of this name stands at {other}"


def check_folders(root):
    """Folders with more files than anybody reads, as (file, line, message)."""
    for top in ("src", "tests", "tools", "shaders"):
        for folder in [root / top, *(path for path in (root / top).rglob("*") if path.is_dir())]:
            count = sum(1 for path in folder.iterdir() if path.is_file())
            if count > MAX_FILES:
                yield folder.relative_to(root).as_posix(), 1, f"{count} files, at most {MAX_FILES}"


def main():
    words = [word for word in sys.argv[1:] if word != "--draw"]
    root = Path(words[0] if words else Path(__file__).parent.parent)
    cmake = (root / "src/CMakeLists.txt").read_text(encoding="utf-8")
    rooms = read_rooms(cmake)
    picture = rooms_picture.draw(rooms)
    drawn = {root / "docs/design/rooms.svg": picture, root / "docs/design/rooms.md": rooms_picture.table(rooms)}
    if "--draw" in sys.argv:
        for file, text in drawn.items():
            file.parent.mkdir(exist_ok=True)
            file.write_text(text, encoding="utf-8")
    files = 0
    found = list(check_folders(root))
    for file, text in drawn.items():
        if not file.is_file() or file.read_text(encoding="utf-8") != text:
            found.append((file.relative_to(root).as_posix(), 1, "is not what src/CMakeLists.txt says: tools/check_includes.py --draw"))
    types, used = {}, {name: set() for name in rooms}
    for path in sorted(path for top in ("src", "shaders", "tests", "tools") for path in (root / top).rglob("*")):
        if path.suffix not in (".h", ".cpp", ".comp", ".glsl", ".py", ".sh"):
            continue
        files += 1
        file = path.relative_to(root).as_posix()
        top, room = file.split("/")[0], room_of(path.relative_to(root))
        lines = path.read_text(encoding="utf-8").splitlines()
        breaches = list(check_form(path, lines))
        if top == "src" and room == "":
            room = "cli"  # main.cpp
        elif top == "src" and room not in rooms:
            breaches.append((1, f"{room or top} is no room of src/CMakeLists.txt"))
        if top == "src":
            breaches += check_types(file, lines, types)
            breaches += check_entrances(file, lines)
        if (top == "src" and room in rooms) or room == "shared":
            breaches += check_links(root, file, lines, room, rooms, used.get(room, set()))
        found += [(file, number, message) for number, message in breaches]
    for name, (links, _) in rooms.items():
        found += [("src/CMakeLists.txt", 1, f"{name} links {link}, and needs nothing of it") for link in links if link not in used[name]]
    for file, number, message in found:
        print(f"{file}:{number}: {message}")
    print(f"{files} files, {len(rooms)} rooms, {len(found)} breaches")
    return 1 if found or not files else 0


if __name__ == "__main__":
    sys.exit(main())
