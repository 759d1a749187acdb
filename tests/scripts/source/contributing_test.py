#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The table of CONTRIBUTING.md, "you changed X, update Y": each row says what holds it, that is there, and what can be looked at here is so.
Usage: contributing_test.py SOURCE_ROOT [BUILD_FOLDER]; without the latter commands and options are not looked at."""
import json
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(sys.argv[1]).resolve()
PROGRAM = Path(sys.argv[2]).resolve() / "ghostlight" if len(sys.argv) > 2 else None
BY_EYE = "by eye"
# In cmake/dependencies.cmake -> package of Debian (./dev), of vcpkg (None: not on those systems), what is included (None: nothing of src/ is).
LIBRARIES = {
    "Threads": (None, None, None),
    "PkgConfig": ("pkg-config", "pkgconf", None),
    "glm": ("libglm-dev", "glm", "glm/"),
    "pugixml": ("libpugixml-dev", "pugixml", "pugixml.hpp"),
    "assimp": ("libassimp-dev", "assimp", "assimp/"),
    "tomlplusplus": ("libtomlplusplus-dev", "tomlplusplus", "toml++/"),
    "Vulkan": ("libvulkan-dev", "vulkan", "vulkan/"),
    "embree": ("libembree-dev", "embree3", "embree3/"),
    "TBB": ("libtbb-dev", "tbb", "tbb/"),
    "meshoptimizer": ("libmeshoptimizer-dev", "meshoptimizer", "meshoptimizer.h"),
    "GTest": ("libgtest-dev", "gtest", None),
    "Qt6": ("qt6-base-dev", "qtbase", None),
    "LRELEASE": ("qt6-l10n-tools", "qttools", None),
    "OPENEXR": ("libopenexr-dev", "openexr", "OpenEXR/"),
    "PNG": ("libpng-dev", "libpng", "png.h"),
    "TURBOJPEG": ("libturbojpeg0-dev", "libjpeg-turbo", "turbojpeg.h"),
    "PANGOCAIRO": ("libpango1.0-dev", "pango", "pango/"),
    "LIBZIP": ("libzip-dev", "libzip", "zip.h"),
    "SECCOMP": ("libseccomp-dev", None, "seccomp.h"),
    "XXHASH": ("libxxhash-dev", "xxhash", "xxhash.h"),
    "QRENCODE": ("libqrencode-dev", "libqrencode", "qrencode.h"),
    "ZSTD": ("libzstd-dev", "zstd", "zstd.h"),
    "ZLIB": ("zlib1g-dev", "zlib", "zlib.h"),
    "FFMPEG": ("libavcodec-dev", "ffmpeg", "libav"),
    "ALSA": ("libasound2-dev", None, "alsa/"),
    "LTC": ("libltc-dev", None, "ltc.h"),
    "GLSLC": ("glslc", "shaderc", None),
    "CLI11_INCLUDE": ("libcli11-dev", "cli11", "CLI/"),
    "NLOHMANN_INCLUDE": ("nlohmann-json3-dev", "nlohmann-json", "nlohmann/"),
}
IN_NO_BUFFER = {"Focus"}  # structs that a function returns and nothing stores
wrong = []


def text_of(name):
    return (ROOT / name).read_text(encoding="utf-8")


def check_rows():
    """Three columns, of which the last has tests that there are, or says that nobody but an eye can tell."""
    table = text_of("CONTRIBUTING.md").partition("## You changed X")[2]
    rows = [[cell.strip() for cell in line.strip("| ").split(" | ")] for line in table.splitlines() if line.startswith("| ")][1:]
    rooms = set(re.findall(r"^ghost_test\((\S+)", text_of("tests/CMakeLists.txt"), re.M))
    for row in rows:
        if len(row) != 3:
            wrong.append(f"CONTRIBUTING.md: {row[0]}: expected three columns: what changed, what to update, what holds it")
            continue
        names = re.findall(r"`([\w/.]+)`", row[2])
        if not names and not row[2].startswith(BY_EYE):
            wrong.append(f"CONTRIBUTING.md: {row[0]}: names no test, and is not {BY_EYE}")
        for name in names:
            is_script = any((ROOT / "tests/scripts").rglob(name)) if name.endswith((".py", ".sh")) else False
            if not is_script and name not in rooms and not (ROOT / name).is_file():
                wrong.append(f"CONTRIBUTING.md: {row[0]}: there is no test {name}")
    return len(rows)


def check_libraries():
    asked = text_of("cmake/dependencies.cmake")
    found = re.findall(r"^\s*find_package\((\w+)|^pkg_check_modules\((\w+)|^find_(?:program|path)\((\w+)", asked, re.M)
    vcpkg = {one if isinstance(one, str) else one["name"] for one in json.loads(text_of("vcpkg.json"))["dependencies"]}
    debian = re.search(r"^packages='(.*?)'$", text_of("dev"), re.M | re.S)[1]
    held = text_of("tools/check_includes.py").partition("\nLIBRARIES = {")[2].partition("\n}")[0]
    names = {name for names in found for name in names if name}
    for name in sorted(names - LIBRARIES.keys()):
        wrong.append(f"cmake/dependencies.cmake: {name} is not in the list of {Path(__file__).name}")
    for name in sorted(LIBRARIES.keys() & names):
        package, port, header = LIBRARIES[name]
        if package and not re.search(rf"[ |]{re.escape(package)}[ |]", debian):
            wrong.append(f"dev: has no package {package}, which {name} of cmake/dependencies.cmake needs")
        if port and port not in vcpkg:
            wrong.append(f"vcpkg.json: has no {port}, which {name} of cmake/dependencies.cmake needs")
        if header and f'"{header}":' not in held:
            wrong.append(f"tools/check_includes.py: LIBRARIES has no {header}, which {name} of cmake/dependencies.cmake brings")
    return len(names)


def check_tests_of_rooms():
    """A folder of tests that no line builds would never run."""
    lines = set(re.findall(r"^ghost_test\((\S+)", text_of("tests/CMakeLists.txt"), re.M))
    folders = {file.parent.relative_to(ROOT / "tests").as_posix() for file in (ROOT / "tests").rglob("*_test.cpp")}
    rooms = set(re.findall(r"^ghost_room\(([\w/]+)", text_of("src/CMakeLists.txt"), re.M))
    for folder in sorted(folders - lines):
        wrong.append(f"tests/CMakeLists.txt: no ghost_test({folder} ..)")
    for folder in sorted(lines - rooms):
        wrong.append(f"tests/CMakeLists.txt: ghost_test({folder} ..) mirrors no room of src/CMakeLists.txt")
    return len(folders)


def check_keys():
    """Keys that are read of show.toml stand in docs/reference/show-file.md."""
    page = text_of("docs/reference/show-file.md")
    keys = {}
    for folder in ("src/show_file", "src/show"):
        for file in sorted((ROOT / folder).glob("*.cpp")):
            for key in re.findall(r'\breader\.\w+\(\s*"([a-z0-9_]+[a-z0-9])"', file.read_text(encoding="utf-8")):
                keys.setdefault(key, file.relative_to(ROOT))
    for key, file in sorted(keys.items()):
        if not re.search(rf"(?<!\w){key}(?!\w)", page):
            wrong.append(f"{file}: reads '{key}', which docs/reference/show-file.md does not know")
    return len(keys)


def check_shared_structs():
    """What C++ and shaders share has its size asserted. Structs with containers are C++'s alone."""
    count = 0
    for file in sorted((ROOT / "shaders/shared").glob("*.h")):
        text = file.read_text(encoding="utf-8")
        for name, body in re.findall(r"^struct (\w+) \{(.*?)^\};", text, re.M | re.S):
            if "std::" in body or name in IN_NO_BUFFER:
                continue
            count += 1
            if f"SHARED_SIZE({name}," not in text:
                wrong.append(f"{file.relative_to(ROOT)}: {name} has no SHARED_SIZE")
    return count


def check_options():
    """Every command and option stands in a document."""
    pages = "".join(file.read_text(encoding="utf-8") for file in [*(ROOT / "docs").rglob("*.md"), *ROOT.glob("*.md")]
                    if file.name != "CHANGELOG.md")
    count = 0

    def look(words):
        nonlocal count
        said = subprocess.run([PROGRAM, *words, "--help"], capture_output=True, text=True, timeout=60).stdout
        if words and not re.search(rf"(?:ghostlight |`){' '.join(words)}\b", pages):
            wrong.append(f"docs: no page knows 'ghostlight {' '.join(words)}'")
        for option in sorted(set(re.findall(r"(?<![\w-])(--[a-z][\w-]*)", said.partition("Options:")[2])) - {"--help"}):
            count += 1
            if not re.search(re.escape(option) + r"(?![\w-])", pages):
                wrong.append(f"docs: no page knows {option} of 'ghostlight {' '.join(words)}'")
        for name in re.findall(r"^  ([a-z][a-z-]*) ", said.partition("Subcommands:")[2], re.M):
            look([*words, name])

    look([])
    return count


def main():
    counts = {"rows": check_rows(), "libraries": check_libraries(), "folders of tests": check_tests_of_rooms(), "keys of show.toml": check_keys(),
              "structs of shaders": check_shared_structs(), "options": check_options() if PROGRAM else None}
    print("\n".join([*wrong, ", ".join(f"{count} {what}" for what, count in counts.items() if count is not None) + f", {len(wrong)} wrong"]))
    least = {"rows": 20, "libraries": 25, "folders of tests": 50, "keys of show.toml": 100, "structs of shaders": 10, "options": 100}
    few = [what for what, count in counts.items() if count is not None and count < least[what]]
    return f"found too few of: {', '.join(few)}" if few else 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
