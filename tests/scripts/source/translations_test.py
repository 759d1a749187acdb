#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The window in its languages is whole: every text of src/ui goes through translated() or said(), every catalogue has all of them and no
other, finished, with the same places to fill in, and every pattern of sentence_list.cpp and part_list.cpp is still said somewhere in src.
Usage: translations_test.py SOURCE_ROOT [BUILD_FOLDER]"""
import re
import sys
import unittest
import xml.etree.ElementTree as ET
from pathlib import Path

ROOT = Path(sys.argv[1]).resolve()
CATALOGUES = sorted((ROOT / "assets/translations").glob("*.ts"))
LITERAL = r'"(?:[^"\\\n]|\\.)*"'
TEXT = re.compile(rf"{LITERAL}(?:\s*{LITERAL})*")
PLACE = re.compile(r"%[1-9n]|\\[1-9]|<[^>]+>")

# Files of src/ui without a text for people.
NO_TEXTS = {
    "window/state_json.cpp": "keys of JSON, for scripts",
    "language/sentence_list.cpp": "patterns, all of them QT_TRANSLATE_NOOP",
    "language/part_list.cpp": "patterns, all of them QT_TRANSLATE_NOOP",
    "language/language.cpp": "names of files",
    "window/open_window.cpp": "is said on the command line, before there is a window",
    "actions/script.cpp": "words of scripts and sockets",
    "model/drafts.cpp": "the first line of a file",
    "model/gel_book.cpp": "Lee's names of its filters, which are called so everywhere",
    "widgets/theme.cpp": "style sheets",
}
# Literals that look like a text and are none.
NO_TEXT = {
    "names": {"AgX", "ACES", "DMX", "Ghostlight", "[*] - Ghostlight", "Fusion", "Qt %2", "slurm"},
    "units, the same in all languages": {"%1 s", "%1 m", "EV %1", "EV ", "%1 Hz", "%1 ms", "%1 cd", "%1 %", "cd/m²", " cd/m²", " lx", " Hz", " K", " ms", " m/s", " m"},
    "columns that are coordinates": {"X m", "Y m", "Z m", "XYZ", "xyz"},
    "given to what is new in a file, whose texts stay": {"Look %1", "Cue ", "Camera ", "Fixture", "My show"},
    "words of attributes in GDTF": {"Color", "Colour"},
    "parts of an error that stand before it": {"' is no ", " and "},
    "words of scripts and of this program's commands": {"cue ", "tone ", "palette ", "fan ", " up", " down", "between", " slurm", "gel ", "motion machine", "motion commanded", "mover-address "},
    "options of this program's commands": {"--pdf", "--focus", "--plan"},
    "marks of HTML": {"&lt;", "&gt;", "&quot;", "&amp;", "<section ", 'id="', "<table"},
    "sheets of paper, called so everywhere": {"Letter", "Tabloid", "Arch D", "ArchD"},
    "languages by their own names": {"English", "Deutsch"},
}
EXCEPTIONS = set().union(*NO_TEXT.values())
# What stands before a literal that nobody reads.
BEFORE = re.compile(
    r"(setObjectName|[vV]alue|setValue|contains|QRegularExpression|setStyleSheet|findExecutable|\bdock|\bitem|toString|startsWith|endsWith|"
    r"beginReadArray|beginWriteArray|fromStdString|starts_with|find_first_of|find_last_not_of|create|save|&out,|QString\(name\)\.replace|kForm)\($|"
    r"(==|!=|\bcase) ?$|(case Role::\w+|default): return$|language\(\)\)\.toString\(found->when,$|(choose|run|Q_PROPERTY)\((QString\()?$|\badd\(\*?menu,$|&out,$|words\[0\],$")
HTML = re.compile(r"^(\s*</?\w+[^>]*>)+(Ghostlight |Qt )?$|^<tr>.*%2.*</tr>$|^<td .*%2.*</td>$|^<p style=.*%2</p>$|^Q\w+(:\w+)? \{|^color: %1$")
ARGUMENT = re.compile(r"#?[A-Z][A-Z0-9_-]*|WxH|mvr|[a-z][a-z-]*|[0-9]+")


def source_files():
    return sorted((ROOT / "src/ui").rglob("*.cpp"))


def without_comments(text):
    """The same length, with comments, characters and raw strings blank."""
    pattern = re.compile(rf"//[^\n]*|R\"(\w*)\(.*?\)\1\"|(?<!\w)'(?:[^'\\\n]|\\.)+'|{LITERAL}", re.S)
    return pattern.sub(lambda m: m[0] if m[0][0] == '"' else re.sub(r"[^\n]", " ", m[0]), text)


def value_of(literal):
    joined = "".join(one[1:-1] for one in re.findall(LITERAL, literal))
    escapes = {"n": "\n", "\\": "\\", '"': '"', "t": "\t", "'": "'"}
    joined = re.sub(r"\\u([0-9a-fA-F]{4})", lambda m: chr(int(m[1], 16)), joined)
    return re.sub(r"\\(.)", lambda m: escapes.get(m[1], m[0]), joined)


def literals(text):
    """(place, text, what stands before it, the same without words in quotes)"""
    text = re.sub(r"^\s*#[^\n]*", lambda m: " " * len(m[0]), without_comments(text), flags=re.M)
    code = re.sub(LITERAL, lambda m: '"' + " " * (len(m[0]) - 2) + '"', text)
    for found in TEXT.finditer(text):
        before = re.sub(r"\s+", " ", text[max(0, found.start() - 400):found.start()]).rstrip()
        statement = re.sub(r"\s+", "", code[max(0, found.start() - 400):found.start()].split(";")[-1])
        yield found.start(), value_of(found[0]), re.sub(r"([({]) ", r"\1", before), statement


def is_of_script(text):
    """A line of a script, or what an action takes: "NAME|NUMBER up|down", "[on|off]", "look-recall "."""
    first = text.split(" ")[0]
    if re.fullmatch(r"(@?[a-z0-9-]+ )+@?[a-z0-9-]+", text) and " - " in text:
        return True  # names of actions, as menus list them
    if re.fullmatch(r"(panel|cue|look|palette|align|browsers|fps|resolution|camera|open|import|save|quit|substitute|bake|exposure|export)(-[\w%]+)?", first):
        return bool(re.fullmatch(r"[a-z-]+(%1|( (%\d\S*|\"+|on|off|over|anyway|first|last|))*)", text))
    words = [word for word in re.split(r"[ |\[\]:/.]+", text) if word]
    return all(ARGUMENT.fullmatch(word) for word in words) and (bool(re.search(r"[|\[]", text)) or text.upper() == text or text.endswith(".mvr"))


def is_key(text):
    return bool(re.fullmatch(r"((Ctrl|Shift|Alt)\+)*([A-Z0-9?+=.,-]|F\d+|%1|Space|Home|Esc|Delete|PgUp|PgDown|Left|Right|Up|Down)(; .*)?", text))


def is_text(file, text, before, statement):
    """Whether a literal is read by people and does not go through a catalogue."""
    if re.search(r'(translated|QT_TRANSLATE_NOOP)\($|(translated|QT_TRANSLATE_NOOP)\("[^"]*",$', before):
        return False
    if not re.search(r"[A-Za-z]{2}", re.sub(r"%\w", "", text)) or re.fullmatch(r"[a-z0-9_.:#/*-]*", text) or text in EXCEPTIONS:
        return False
    if BEFORE.search(before) or HTML.search(text):
        return False
    if re.search(r"(Error\{|complain\(\{|number_of\(|vector_of\(|log_error\(|\.what=|\.advice=)", statement) or re.search(r"std::string|return\{$", statement[-60:]):
        return False  # a sentence: test_errors looks at it
    # Menus and keys, in tables of actions and in lists of menus.
    if re.search(r'add\(\{|kMenus|menu : |actions\.add|"[\w-]*",? ?(\+ ?name)?,$|\? "" :$', before[-300:]) and (text in MENUS or is_key(text)):
        return False
    return not (file.startswith(("actions/", "window/", "panels/", "panel_parts/", "picture/", "model/")) and (is_of_script(text) or is_key(text)))


MENUS = {"Show", "Edit", "View", "Camera", "Play", "Quality", "Panels", "Help"}


def used_texts():
    """(context, text) of all translated() and QT_TRANSLATE_NOOP() with literals, and whether it counts."""
    form = re.compile(rf"(?:translated|QT_TRANSLATE_NOOP)\(\s*({LITERAL})\s*,\s*((?:{LITERAL}\s*)+)(,?)")
    for file in source_files():
        for found in form.finditer(without_comments(file.read_text(encoding="utf-8"))):
            yield value_of(found[1]), value_of(found[2]), found[3] == ","


def messages(catalogue):
    for context in ET.parse(catalogue).getroot().iter("context"):
        for message in context.iter("message"):
            yield context.find("name").text, message.find("source").text, message


class Translations(unittest.TestCase):
    def test_all_texts_are_translated(self):
        found = []
        for file in source_files():
            name = str(file.relative_to(ROOT / "src/ui"))
            if name in NO_TEXTS:
                continue
            source = file.read_text(encoding="utf-8")
            found += [f"src/ui/{name}:{source.count(chr(10), 0, place) + 1}: {text!r}" for place, text, before, code in literals(source) if is_text(name, text, before, code)]
        self.assertEqual("\n".join(found), "", "texts that go through no catalogue: translated(\"Context\", \"text\")")

    def test_the_search_finds(self):
        sample = 'box->setText("Open it"); label->setText(QString("%1 left").arg(2)); menu.addAction("Go"); actions.choose("cue-go"); // "no"\n'
        self.assertEqual([text for _, text, before, code in literals(sample) if is_text("panels/x.cpp", text, before, code)], ["Open it", "%1 left", "Go"])
        self.assertFalse(any(is_text("panels/x.cpp", *one[1:]) for one in literals('f(translated("A", "Open it"));')))

    def test_catalogues_have_all_of_them(self):
        used = {(context, text) for context, text, _ in used_texts()}
        counted = {(context, text) for context, text, counts in used_texts() if counts}
        self.assertGreater(len(used), 1000)
        for catalogue in CATALOGUES:
            wanted = counted if catalogue.stem.endswith("_en") else used
            there = {(context, text) for context, text, _ in messages(catalogue)}
            self.assertEqual(sorted(wanted - there), [], f"{catalogue.name} lacks them: ./dev translate")
            self.assertEqual(sorted(there - wanted), [], f"{catalogue.name} has them, src/ui not: ./dev translate")

    def test_catalogues_are_finished(self):
        self.assertGreaterEqual({file.stem for file in CATALOGUES}, {"ghostlight_en", "ghostlight_de"})
        for catalogue in CATALOGUES:
            for context, text, message in messages(catalogue):
                with self.subTest(catalogue=catalogue.name, context=context, text=text):
                    translation = message.find("translation")
                    self.assertIsNone(translation.get("type"), "unfinished or obsolete")
                    forms = [one.text or "" for one in translation.iter("numerusform")] or [translation.text or ""]
                    self.assertEqual(len(forms) > 1, message.get("numerus") == "yes")
                    for form in forms:
                        self.check_form(text, form, message.get("numerus") == "yes")

    def check_form(self, text, form, counts):
        self.assertTrue(form.strip())
        places = lambda words: sorted(one for one in PLACE.findall(words) if not (counts and one == "%n"))
        self.assertEqual(places(form), places(text), form)
        self.assertEqual(form[0].isspace(), text[0].isspace() and text != " deg", form)
        self.assertEqual(form[-1].isspace(), text[-1].isspace(), form)
        self.assertEqual(form.count("&"), text.count("&"), form)
        self.assertEqual(form.count("\n"), text.count("\n"), form)
        self.assertEqual(form.endswith("..."), text.endswith("..."), form)
        self.assertEqual(re.findall(r"\(\*[^)]*\)", form), re.findall(r"\(\*[^)]*\)", text), "filters of files")

    def test_errors_are_sentences(self):
        """What src/ui itself answers to scripts is shown in the window, too: each part of it stands in a pattern."""
        patterns = [text for context, text, _ in used_texts() if context == "Sentence"]
        found = []
        for file in source_files():
            name = str(file.relative_to(ROOT / "src/ui"))
            source = file.read_text(encoding="utf-8")
            for place, text, _, code in literals(source) if name not in NO_TEXTS else []:
                is_said = re.search(r"Error\{[^}]*$|complain\(\{[^}]*$|(number_of|vector_of)\([^)]*$", code)
                if is_said and re.search(r"[a-z]{2} |[a-z]{4}", text) and not any(text.strip() in pattern for pattern in patterns):
                    found.append(f"src/ui/{name}:{source.count(chr(10), 0, place) + 1}: {text!r}")
        self.assertEqual("\n".join(found), "", "errors that are in no pattern of src/ui/language/sentence_list.cpp")

    def test_sentences_are_said(self):
        """What rooms without Qt say is known by its fixed parts; one that no literal has any more is never met."""
        said = []
        for file in (ROOT / "src").rglob("*.cpp"):
            if "ui/language" not in str(file):
                said += [text for _, text, *_ in literals(file.read_text(encoding="utf-8"))]
        for file in (ROOT / "src").rglob("*.h"):
            said += [text for _, text, *_ in literals(file.read_text(encoding="utf-8"))]
        everything = "\n".join(said)
        for context, pattern, _ in used_texts():
            if context != "Sentence":
                continue
            # Parts of a sentence may stand in several literals; words that none has are wrong.
            missing = [word for part in re.split(r"%[1-9]", pattern) for word in re.findall(r"[\w'-]+(?: [\w'-]+)?", part) if len(word) > 3 and word not in everything]
            self.assertLess(len(missing), max(3, len(pattern.split()) // 3), f"nobody says {pattern!r}: {missing}")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
