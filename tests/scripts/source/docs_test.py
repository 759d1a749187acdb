#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What the documents say is there: every link leads somewhere, every path exists, every figure that was measured has its day or the test that
holds it, every script and preset that is named is there and knows the options, and every command line of the program is run, in an empty
folder: it has a command, options and values that the program takes. Usage: docs_test.py SOURCE_ROOT [BUILD_FOLDER]; without the latter command
lines of the program are not run."""
import concurrent.futures
import os
import re
import shlex
import subprocess
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "lib"))
import source_files  # noqa: E402  (the folder is known only now)

ROOT = Path(sys.argv[1]).resolve()
PROGRAM = Path(sys.argv[2]).resolve() / "ghostlight" if len(sys.argv) > 2 else None
# Folders whose paths are named in prose. What a program makes (build, .ghost, demo-out) is not there before.
TOPS = "src|tests|tools|shaders|docs|cmake|assets|packaging"
LINK = re.compile(r"\]\(([^)\s]+)\)")
PATH = re.compile(rf"`((?:{TOPS})/[\w./*<>{{}},-]+)`")
DATE = re.compile(r"(?:January|February|March|April|May|June|July|August|September|October|November|December) \d+|\d{4}-\d\d-\d\d")
# What somebody measured, outside of docs/measurements, where whole tables are looked at.
MEASURED = re.compile(r"\d ?dB\b|\d m?s of (?:processor|CPU)\b|seconds of processor time in|\bbusy (?:machine of|cores?)\b|"
                      r"^Measured(?:: | on | with )|^## Measured|peak memory", re.M)
HELD = re.compile(r"`test_\w+`|`tests/[\w/.]+`|\(tests/[\w/.]+\)|\]\((?:\.\./)?(?:docs/)?measurements/")
# Documents that grow from day to day; ./dev format wraps them, too.
NOT_YET_WRAPPED = {"CHANGELOG.md", "docs/measurements/gpu.md", "docs/measurements/house.md", "docs/measurements/performance.md",
                   "docs/reference/mistakes.md", "docs/reference/network.md"}
# These would meet the network or devices of this machine, or keep all of its cores busy: of them the values are looked at.
OUTWARD = {"bench", "capture", "monitor", "play", "record", "serve", "xchange"}
WAITS_S = 3  # for a command line that does not end by itself: it was taken
wrong = []


def documents():
    return [ROOT / name for name in source_files.listed(ROOT) if name.endswith(".md")]


def anchors(file):
    """GitHub's anchors of the headings of a document."""
    heads = re.findall(r"^#+ (.*)$", file.read_text(encoding="utf-8"), re.M)
    return {re.sub(r"[^\w\- ]", "", head.strip().lower()).replace(" ", "-") for head in heads}


def is_there(path):
    """A path of the source: as it is, as a pattern, or with a <word> for any."""
    if re.search(r"[*<{]", path):
        return any(ROOT.glob(re.sub(r"<[^>]*>|\{[^}]*\}", "*", path)))
    return (ROOT / path).exists()


def check_links(file, text):
    for number, line in enumerate(text.splitlines(), 1):
        for target in LINK.findall(line):
            if re.match(r"[a-z]+:", target):
                continue
            name, _, anchor = target.partition("#")
            other = (file.parent / name) if name else file
            if not other.exists():
                wrong.append(f"{file.relative_to(ROOT)}:{number}: {target}: no such file")
            elif anchor and other.suffix == ".md" and anchor not in anchors(other):
                wrong.append(f"{file.relative_to(ROOT)}:{number}: {target}: no such heading")
        for path in PATH.findall(line):
            if not is_there(path.rstrip(".,")) and not path.startswith("docs/images"):
                wrong.append(f"{file.relative_to(ROOT)}:{number}: `{path}`: no such file")


def check_named_files(files):
    """Files of src/ that documents name by their room, and files that comments of the sources name by their folder."""
    there = [file for top in TOPS.split("|") for file in (ROOT / top).rglob("*") if file.is_file()]
    known = {"/" + file.relative_to(ROOT).as_posix() for file in there}
    rooms = "|".join(sorted(folder.name for folder in (ROOT / "src").iterdir() if folder.is_dir()))
    sources = [file for file in there if file.suffix in (".h", ".cpp", ".comp", ".glsl")]
    count = 0
    for file, before, pattern in [
            *((file, "", rf"`((?:{rooms})/[\w./-]+\.(?:h|cpp))`") for file in files if file.name != "CHANGELOG.md" and file.exists()),
            *((file, "// ", r"(?<![\w/.])((?:[\w-]+/)+[\w-]+\.(?:h|cpp|comp|glsl|md|py))\b") for file in sources)]:
        for number, line in enumerate(file.read_text(encoding="utf-8").splitlines(), 1):
            for name in re.findall(pattern, line.partition(before)[2] if before else line):
                count += 1
                if not any(path.endswith("/" + name) for path in known):
                    wrong.append(f"{file.relative_to(ROOT)}:{number}: {name}: no such file")
    return count


def check_index(files):
    """Every page of docs/ stands in docs/index.md."""
    index = (ROOT / "docs/index.md").read_text(encoding="utf-8")
    for file in files:
        name = file.relative_to(ROOT).as_posix().removeprefix("docs/")
        if file.is_relative_to(ROOT / "docs") and name != "index.md" and f"({name})" not in index:
            wrong.append(f"docs/index.md: does not name {name}")


def check_dates(file, text):
    """A table of figures says when they were measured, or the whole document does at its beginning."""
    if DATE.search(text.partition("\n## ")[0]):
        return
    for section in re.split(r"^(?=#{1,3} )", text, flags=re.M):
        head, _, body = section.partition("\n")
        figures = re.search(r"^\|.*\|[ *<>]*\d[\d.,]*", body, re.M)
        if figures and not DATE.search(body):
            wrong.append(f"{file.relative_to(ROOT)}: {head}: figures without the day that they were measured (*Figures of November 21.*)")


def check_measured(file, text):
    """A paragraph with a figure names the test that holds it, or the figure's day stands in its section or at the document's beginning."""
    if DATE.search(text.partition("\n## ")[0]):
        return
    for section in re.split(r"^(?=#{1,3} )", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S), flags=re.M):
        if DATE.search(section):
            continue
        for paragraph in section.split("\n\n"):
            found = MEASURED.search(paragraph)
            if found and not HELD.search(paragraph):
                wrong.append(f"{file.relative_to(ROOT)}: {section.partition(chr(10))[0]}: '{found[0]}' without the day that it was measured "
                             "or the test that holds it")


def check_columns(files):
    """Prose has at most 120 columns."""
    names = [str(file) for file in files if file.exists() and file.relative_to(ROOT).as_posix() not in NOT_YET_WRAPPED]
    said = subprocess.run([sys.executable, ROOT / "tools/wrap_docs.py", "--check", *names], capture_output=True, text=True)
    wrong.extend(said.stdout.splitlines() if said.returncode in (0, 1) else [said.stderr])


def check_scripts(file, text):
    """What is said in backticks or in a block of code of ./dev, of tools and of CMake's presets."""
    actions = set(re.findall(r"^\./dev (\w+)", (ROOT / "dev").read_text(encoding="utf-8"), re.M))
    presets = set(re.findall(r'"name": "(\w+)"', (ROOT / "CMakePresets.json").read_text(encoding="utf-8")))
    place = file.relative_to(ROOT)
    for action in re.findall(r"(?:^\s*|`)\./dev ([a-z]+)", text, re.M):
        if action not in actions | {"help"}:
            wrong.append(f"{place}: ./dev {action}: no such action")
    for preset in re.findall(r"--preset (\w+)", text):
        if preset not in presets:
            wrong.append(f"{place}: --preset {preset}: no such preset")
    for name, words in re.findall(r"(?:^\s*|`)(?:/usr/bin/python3 )?(tools/[\w/]+\.(?:py|sh))((?: [^`\n]*)?)", text, re.M):
        source = (ROOT / name).read_text(encoding="utf-8") if (ROOT / name).is_file() else ""
        if not source:
            wrong.append(f"{place}: {name}: no such file")
        for option in re.findall(r"(?<=\s)--[a-z][\w-]*", words):
            if option not in source:
                wrong.append(f"{place}: {name} {option}: no such option")


def commands():
    """Command -> its options, as the program tells them."""
    top = subprocess.run([PROGRAM, "--help"], capture_output=True, text=True, timeout=60).stdout
    known = {}
    todo = [[name] for name in re.findall(r"^  ([a-z][a-z-]*) ", top.split("Subcommands:")[1], re.M)]
    while todo:
        words = todo.pop()
        said = subprocess.run([PROGRAM, *words, "--help"], capture_output=True, text=True, timeout=60).stdout
        known[" ".join(words)] = set(re.findall(r"(?<![\w-])(--?[a-zA-Z][\w-]*)", said))
        if "Subcommands:" in said:
            todo += [[*words, name] for name in re.findall(r"^  ([a-z][a-z-]*) ", said.split("Subcommands:")[1], re.M)]
    return known


def lines_of(text):
    """Command lines of the program: those of blocks of code, and what stands in backticks. Number of the line, the words, whether in prose."""
    for block in re.finditer(r"^```(?:sh|bash|console)?\n(.*?)^```|^(?:    .*\n)+", text, re.M | re.S):
        first = text.count("\n", 0, block.start()) + 1
        for number, line in enumerate(block[0].splitlines()):
            if found := re.match(r"\s*(?:\$ )?(?:sudo )?(?:build/release/)?ghostlight ([a-z].*)", line):
                yield first + number, found[1], False
    for found in re.finditer(r"`(?:build/release/)?ghostlight ([a-z][^`\n]*)`", text):
        yield text.count("\n", 0, found.start()) + 1, found[1], True


def check_commands(file, text, known):
    """Its command lines by the options that the program knows. Those that are whole, to be run: place, words, whether in prose."""
    whole = []
    for number, line, is_prose in lines_of(text):
        try:
            words = shlex.split(re.split(r"\s[|>&]|;", line)[0], comments=True)
        except ValueError:
            continue
        name = " ".join(words[:2]) if " ".join(words[:2]) in known else words[0]
        place = f"{file.relative_to(ROOT)}:{number}"
        if name not in known:
            wrong.append(f"{place}: ghostlight {words[0]}: no such command")
            continue
        for word in words:
            option = re.match(r"(--?[a-zA-Z][\w-]*)", word)
            if option and option[1] not in known[name] | {"--help", "-h"} and not (len(word) > 2 and word[:2] in known[name] and word[1] != "-"):
                wrong.append(f"{place}: ghostlight {name} {option[1]}: no such option")
        if not any(re.search(r"\.\.\.|\.\.$|[\[\]|<>*…]", word) for word in words):
            whole.append((place, words, is_prose))
    return whole


def run(line):
    """In an empty folder, so that it ends at the first file that is missing; nothing where the program takes the words. What ends by a
    signal is wrong."""
    place, words, is_prose = line
    with tempfile.TemporaryDirectory() as folder:
        home = {name: folder for name in ("HOME", "TMPDIR", "XDG_STATE_HOME", "XDG_CACHE_HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME")}
        only_parsed = ["--help"] if words[0] in OUTWARD else []
        try:
            done = subprocess.run([PROGRAM, *words, *only_parsed], cwd=folder, env={**os.environ, **home, "QT_QPA_PLATFORM": "offscreen"}, timeout=WAITS_S,
                                  stdin=subprocess.DEVNULL, capture_output=True, text=True, errors="replace")
        except subprocess.TimeoutExpired:
            return None
    said = done.stderr.strip()
    # Prose names a command by what matters there. A word in capitals stands for one of several.
    is_meant = (re.search(r"does not exist: ", said) or (is_prose and re.search(r" is required$", said, re.M)) or
                any(word.isupper() and f": {word} not in" in said for word in words))
    is_taken = done.returncode >= 0 and done.returncode != 2
    return None if is_taken or is_meant else f"{place}: ghostlight {shlex.join(words)}: {done.returncode}: {said}"


def main():
    known = commands() if PROGRAM else {}
    lines = []
    files = documents()
    check_columns(files)
    check_index(files)
    named = check_named_files(files)
    for file in files:
        if not file.exists():
            continue
        text = file.read_text(encoding="utf-8")
        if file.name != "CHANGELOG.md":
            check_links(file, text)
            check_scripts(file, text)
        if file.parent.name == "measurements":
            check_dates(file, text)
        elif file.name != "CHANGELOG.md":
            check_measured(file, text)
        if PROGRAM and file.name != "CHANGELOG.md":
            lines += check_commands(file, text, known)
    with concurrent.futures.ThreadPoolExecutor() as some:
        wrong.extend(fault for fault in some.map(run, lines) if fault)
    print("\n".join([*wrong, f"{len(files)} documents, {len(lines)} command lines, {named} files named by their rooms, {len(wrong)} wrong"]))
    return 1 if wrong or len(files) < 40 or named < 50 or (PROGRAM and len(lines) < 100) else 0


if __name__ == "__main__":
    sys.exit(main())
