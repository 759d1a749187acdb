#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What the documents say is there: every link leads somewhere, every path exists, every table of measurements has its day, and every command
line has a command and options that the program knows. Usage: docs_test.py SOURCE_ROOT [BUILD_FOLDER]; without the latter command lines are not looked at."""
import os
import re
import shlex
import subprocess
import sys
from pathlib import Path

ROOT = Path(sys.argv[1]).resolve()
PROGRAM = Path(sys.argv[2]).resolve() / "ghostlight" if len(sys.argv) > 2 else None
# Folders whose paths are named in prose. What a program makes (build, .ghost, demo-out) is not there before.
TOPS = "src|tests|tools|shaders|docs|cmake|assets|packaging"
LINK = re.compile(r"\]\(([^)\s]+)\)")
PATH = re.compile(rf"`((?:{TOPS})/[\w./*<>{{}},-]+)`")
DATE = re.compile(r"(?:January|February|March|April|May|June|July|August|September|October|November|December) \d+|\d{4}-\d\d-\d\d")
wrong = []


def documents():
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z", "--", "*.md"], capture_output=True, text=True)
    names = listed.stdout.split("\0")[:-1] if listed.returncode == 0 else []
    return [ROOT / name for name in names] or sorted([*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md"), *(ROOT / "tests").rglob("*.md")])


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


def check_dates(file, text):
    """A table of figures says when they were measured, or the whole document does at its beginning."""
    if DATE.search(text.partition("\n## ")[0]):
        return
    for section in re.split(r"^(?=#{1,3} )", text, flags=re.M):
        head, _, body = section.partition("\n")
        figures = re.search(r"^\|.*\|[ *<>]*\d[\d.,]*", body, re.M)
        if figures and not DATE.search(body):
            wrong.append(f"{file.relative_to(ROOT)}: {head}: figures without the day that they were measured (*Figures of November 21.*)")


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


def check_commands(file, text, known):
    """Command lines of the blocks of code; returns how many."""
    count = 0
    for block in re.finditer(r"^```(?:sh|bash|console)?\n(.*?)^```|^(?:    .*\n)+", text, re.M | re.S):
        first = text.count("\n", 0, block.start()) + 1
        for number, line in enumerate(block[0].splitlines()):
            found = re.match(r"\s*(?:\$ )?(?:sudo )?(?:build/release/)?ghostlight ([a-z].*)", line)
            if not found:
                continue
            try:
                words = shlex.split(re.split(r"\s[|>&]|;", found[1])[0], comments=True)
            except ValueError:
                continue
            name = " ".join(words[:2]) if " ".join(words[:2]) in known else words[0]
            place = f"{file.relative_to(ROOT)}:{first + number}"
            count += 1
            if name not in known:
                wrong.append(f"{place}: ghostlight {words[0]}: no such command")
                continue
            for word in words:
                option = re.match(r"(--?[a-zA-Z][\w-]*)", word)
                if option and option[1] not in known[name] | {"--help", "-h"} and not (len(word) > 2 and word[:2] in known[name] and word[1] != "-"):
                    wrong.append(f"{place}: ghostlight {name} {option[1]}: no such option")
    return count


def main():
    known = commands() if PROGRAM else {}
    lines = 0
    files = documents()
    for file in files:
        if not file.exists():
            continue
        text = file.read_text(encoding="utf-8")
        if file.name != "CHANGELOG.md":
            check_links(file, text)
        if file.parent.name == "measurements":
            check_dates(file, text)
        if PROGRAM:
            lines += check_commands(file, text, known)
    print("\n".join([*wrong, f"{len(files)} documents, {lines} command lines, {len(wrong)} wrong"]))
    return 1 if wrong or len(files) < 40 or (PROGRAM and lines < 50) else 0


if __name__ == "__main__":
    sys.exit(main())
