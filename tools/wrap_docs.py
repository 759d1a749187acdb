#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Wraps paragraphs and points of lists whose lines are longer than 120 columns; tables, code, headings, and paragraphs that fit stay as they are.
No line ends inside of `code` or of a link's target.

Usage: wrap_docs.py [--check] FILE...; --check changes nothing, and exits 1 where there is something to wrap.
"""
import re
import sys
from pathlib import Path

MOST = 120
MARK = re.compile(r"(?P<indent> *)(?P<mark>(?:[-*+]|\d+\.) +)?")
# A paragraph ends before these, and they stay as they are.
APART = re.compile(r"\s*(\||#|!\[|>|<|```|---|\[\^|$)|    \S")
WORD = re.compile(r"(?:`[^`]*`|[^\s`])+")


def wrapped(paragraph):
    """The lines of one paragraph or point, anew."""
    found = MARK.match(paragraph[0])
    first = found[0]
    rest = " " * len(first)
    lines, line = [], first
    for word in WORD.findall(" ".join([paragraph[0][len(first):], *(text.strip() for text in paragraph[1:])])):
        # What would begin a list or a heading at the beginning of a line stays behind the word before it.
        is_mark = re.fullmatch(r"[-*+#>|]+|\d+\.", word)
        if line.strip() and line not in (first, rest) and len(line) + 1 + len(word) > MOST and not is_mark:
            lines.append(line)
            line = rest + word
        else:
            line += ("" if line in (first, rest) else " ") + word
    return [*lines, line]


def wrap(text):
    out, paragraph, is_code = [], [], False

    def close():
        if any(len(line) > MOST for line in paragraph):
            out.extend(wrapped(paragraph))
        else:
            out.extend(paragraph)
        paragraph.clear()

    for line in text.split("\n"):
        if line.lstrip().startswith("```"):
            close()
            is_code = not is_code
            out.append(line)
        elif is_code or (APART.match(line) and not (paragraph and re.match(r"    \S", line))):
            close()
            out.append(line)
        else:
            if MARK.match(line)["mark"]:
                close()
            paragraph.append(line)
            if line.endswith(("  ", "\\")):  # a line that ends here on purpose
                close()
    close()
    return "\n".join(out)


def main():
    is_check = "--check" in sys.argv
    status = 0
    for name in sys.argv[1:]:
        if name.startswith("--"):
            continue
        before = Path(name).read_text(encoding="utf-8")
        after = wrap(before)
        if after == before:
            continue
        status = 1
        if is_check:
            print(f"{name}: has lines of prose longer than {MOST} columns; ./dev format wraps them")
        else:
            Path(name).write_text(after, encoding="utf-8")
    return status if is_check else 0


if __name__ == "__main__":
    sys.exit(main())
