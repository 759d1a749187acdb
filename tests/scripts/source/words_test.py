#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""None of the words that docs/reference/glossary.md lists as no more is used, and what limits or describes one thing stands in one place: no
two files of src/ define a constant of the same name and value. The argument is the source root."""
import re
import sys
from collections import defaultdict
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "lib"))
import source_files  # noqa: E402  (the folder is known only now)

ROOT = Path(sys.argv[1]).resolve()
GLOSSARY = "docs/reference/glossary.md"
SOURCES = (".cpp", ".h", ".comp", ".glsl", ".py", ".sh", ".md", ".js", ".ts", ".txt", ".cmake")
TYPE = r"\b(?:struct|class|enum class|using) "
# Same name and number, but not the same thing: each is of its own file, and may be another one tomorrow.
OF_THEIR_OWN = {
    "kAlign", "kAround_m", "kBesideLamp_m", "kBlock", "kCalm_s", "kChannels", "kExplainEvery_s", "kFewImages", "kGap_m",
    "kHalves", "kHeaderBytes", "kKeyDigits", "kLate", "kListed", "kLongestStep_s", "kLookEvery", "kMargin", "kMaxAllChannels", "kMaxBreaks",
    "kMaxFileBytes", "kMaxLayers", "kMaxModes", "kMaxName", "kMaxSlots", "kMaxText", "kMost", "kMostNameBytes", "kNearest_m",
    "kOut", "kPi", "kReadsPerTurn", "kReceiveBufferBytes", "kSlots", "kSteps", "kTexelBytes", "kTickEvery", "kTypical_m",
    "kVersion",
}
wrong = []


def files():
    return [name for name in source_files.listed(ROOT) if name.endswith(SOURCES)]


def check_words(names):
    rows = re.findall(r"^\| `(\w+)` \| .*? \| (yes|) ?\|$", (ROOT / GLOSSARY).read_text(encoding="utf-8"), re.M)
    for name in names:
        if name in (GLOSSARY, "CHANGELOG.md"):
            continue
        text = (ROOT / name).read_text(encoding="utf-8")
        for word, is_daily in rows:
            if found := re.search((TYPE if is_daily else r"\b") + word + r"\b", text):
                wrong.append(f"{name}:{text.count(chr(10), 0, found.start()) + 1}: {word}: see {GLOSSARY}")
    return len(rows)


def check_constants(names):
    places = defaultdict(set)
    for name in names:
        if name.startswith("src/") and name.endswith((".cpp", ".h")):
            for constant, value in re.findall(r"\bconstexpr\s[\w:<>\s]+?\b(k[A-Z]\w*)\s*=\s*([^;]*?);", (ROOT / name).read_text(encoding="utf-8")):
                places[constant, re.sub(r"\s", "", value)].add(name)
    for (constant, value), where in sorted(places.items()):
        if len(where) > 1 and constant not in OF_THEIR_OWN:
            wrong.append(f"{constant} = {value} stands in {', '.join(sorted(where))}")
    for constant in sorted(OF_THEIR_OWN - {constant for (constant, _), where in places.items() if len(where) > 1}):
        wrong.append(f"{constant} stands in one place, or has several values: it need not be listed in {Path(__file__).name}")
    return len(places)


def main():
    names = files()
    words, constants = check_words(names), check_constants(names)
    print("\n".join([*wrong, f"{len(names)} files, {words} words that are no more, {constants} constants, {len(wrong)} wrong"]))
    return 1 if wrong or words < 10 or constants < 500 else 0


if __name__ == "__main__":
    sys.exit(main())
