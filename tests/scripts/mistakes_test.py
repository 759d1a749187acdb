#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The table of mistakes (lib/mistakes.py, lib/desk_mistakes.py): each is made, in network namespaces of its own, with a desk of a few
lines, OLA or QLC+; `monitor` and `explain` must name it, in the same words, and name nothing where all is well. Of those of ALIKE the
window (lib/alike.py) and the commands without --json must say the same; with --write of all, but for what passes while somebody looks
and what keeps the program from starting. Rows whose desk is not installed are skipped by name and counted. Arguments: source folder,
build folder; then, if wanted, --write FILE for the table and the confusion matrix (docs/reference/mistakes.md), or names of rows.
Exit 77: skipped, with the reason."""
import concurrent.futures
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time

SOURCE = pathlib.Path(sys.argv[1]).resolve()
GHOSTLIGHT = str(pathlib.Path(sys.argv[2]).resolve() / "ghostlight")
sys.path.insert(0, str(SOURCE / "tests/scripts/lib"))
import needs  # noqa: E402  (the folder is known only now)
import alike  # noqa: E402
import real_desks  # noqa: E402
from desk_mistakes import DESK_MISTAKES, DESK_WELL  # noqa: E402
from mistakes import MISTAKES, STANDARD, WELL, sacn  # noqa: E402
from two_machines import TwoMachines  # noqa: E402

LANES = 10
ALIKE = {"cable", "output_off", "wrong_interface", "igmp", "sacn_one_off", "artnet_one_off", "sacn_elsewhere", "blind", "low_priority", "two_desks",
         "same_address", "dimmer", "shutter", "lamp_off", "parked", "overridden", "ola_artnet_one_off", "qlc_and_ola", "qlc_not_started",
         "sACN multicast", "QLC+, sACN multicast"}
COMPARES_ALL = "--write" in sys.argv
# What is true beside a finding, and red, too: a universe that comes elsewhere does not come here, channels that a desk gives away are its own.
BESIDE = {"lost": {"not_patched"}, "not_patched": {"not_received", "nothing_arrives"}, "off_by_one": {"nothing_arrives", "not_received", "not_patched"}, "port_shared": {"nothing_arrives"},
          "same_host": {"nothing_arrives", "port_shared"}, "explain:overridden": {"bad_priorities"}}
LIMIT_S = 120  # for a sentence to come, on a machine that does other things, too
WELL_S = 9  # in which nothing may be said; silence is told after 5
OTHER = """
import socket, sys, time
s = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
s.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, int(sys.argv[2]))
s.bind(("0.0.0.0", int(sys.argv[1])))
print("bound", flush=True)
time.sleep(600)
"""
LAMP = '[[fixture]]\nname = "{}"\ngdtf = "{}"\nuniverse = {}\naddress = {}\nposition_m = [0, 4, 6]\n'


class Stage(TwoMachines):
    """The show of a mistake, its senders, and what looks on."""

    def __init__(self, folder, number, setup):
        super().__init__(folder, number, {**STANDARD, **setup})
        if self.setup["firewall"] and shutil.which("nft"):
            self.drop_at_firewall()
        self.write_show()

    def drop_at_firewall(self):
        self.command(self.vis, "nft", "add table ip f; add chain ip f c { type filter hook input priority 0; }; "
                     "add rule ip f c udp dport { 5568, 6454 } drop")

    def write_show(self):
        self.show = self.folder / "show"
        self.show.mkdir()
        (self.show / "stage.obj").write_text("v -9 -9 0\nv 9 -9 0\nv 9 9 0\nv -9 9 0\nf 1 2 3 4\n")
        toml = '[show]\nname = "mistake"\nstage = "stage.obj"\n[[camera]]\nposition_m = [0, -12, 3]\ntarget_m = [0, 2, 2]\n'
        frames = self.setup["show"]
        if frames:
            toml = toml.replace("[[camera]]", 'recording = "a.show"\n[[camera]]', 1)
            row = lambda values: ",".join(str(values.get(i + 1, 0)) for i in range(512))
            (self.show / "a.show").write_text("OLA Show\n" + "".join(f"{universe} {row(values)}\n500\n" for universe, values in frames))
        for name, universe, address, *kind in self.setup["fixtures"]:
            gdtf = SOURCE / "assets/fixtures" / (self.setup["gdtf"] or f"Vari-Lite@VL2500_{kind[0] if kind else 'Spot'}.gdtf")
            toml += LAMP.format(name, gdtf, universe, address)
        (self.show / "show.toml").write_text(toml + self.setup["toml"])

    def send(self):
        real_desks.start(self)
        senders = self.setup["send"]
        senders = [sacn()] if senders is None else senders
        if self.setup["firewall"] and not shutil.which("nft"):
            senders = []  # on our side of it the same
        later = self.setup["firewall_after_s"]
        if later and not shutil.which("nft"):
            senders = [{**one, "stops_s": later} for one in senders]  # on our side of it the same
        if not senders:
            return
        for name in self.setup["vis_sysctl"]:
            self.command(self.vis, "sysctl", "-qw", "net.ipv4.conf." + name)
        desk = self.start(self.desk, sys.executable, SOURCE / "tests/scripts/lib/mistaken_desk.py", json.dumps(senders), "10.93.0.1",
                          stdout=subprocess.PIPE)
        assert desk.stdout.readline() == "sending\n"
        if later and shutil.which("nft"):
            time.sleep(later)
            self.drop_at_firewall()
        if self.setup["desk_later"]:
            after_s, commands = self.setup["desk_later"]
            time.sleep(after_s)
            for words in commands:
                self.command(self.desk, "ip", *words.split())

    def share_port(self):
        if self.setup["other"]:
            port, shares = self.setup["other"]
            other = self.start(self.vis, sys.executable, "-c", OTHER, port, int(shares), stdout=subprocess.PIPE)
            assert other.stdout.readline() == "bound\n"

    def monitor(self):
        self.log, self.errors = self.folder / "monitor.jsonl", self.folder / "monitor.txt"
        self.running = self.start(self.vis, GHOSTLIGHT, "monitor", "--show", self.show, "--json", "--every", "0.4", *self.setup["options"],
                                  stdout=self.log.open("w"), stderr=self.errors.open("w"))

    def reports(self):
        return [json.loads(line) for line in self.log.read_text().split("\n")[:-1]]

    def wait_for_levels(self):
        """Desks that are programs take their time, and OLA asks every 10 s who wants its Art-Net."""
        end = time.monotonic() + LIMIT_S
        while not any(report["sources"] for report in self.reports()):
            assert time.monotonic() < end, "the desk sends nothing"
            time.sleep(0.3)

    def explain_words(self):
        live = ["--live-input", "--for", 1.5, *self.setup["options"]]
        return [GHOSTLIGHT, "explain", self.show, "Spot", "--quiet", *(live if self.setup["show"] is None else ["--at", self.setup["at_s"]])]

    def begin_explain(self, *more):
        return self.start(self.vis, *self.explain_words(), *more, stdout=subprocess.PIPE, stderr=subprocess.PIPE)

    def explain(self):
        said, errors = self.begin_explain("--json").communicate(timeout=LIMIT_S)
        assert said, errors
        return json.loads(said)


def problems(report):
    return [sentence["trouble"] for sentence in report["diagnosis"] if sentence["problem"]]


def wanting(text, words):
    return [word for word in words if word not in text]


def is_compared(name, setup, wanted=""):
    return name in ALIKE or (
        COMPARES_ALL and not setup.get("once") and setup.get("in_window", True) and wanted != "error:")


class Outcome:
    def __init__(self, name, what, wanted):
        self.name, self.what, self.wanted, self.compared = name, what, wanted, False
        self.named, self.also, self.text, self.faults = "", [], "", []


def by_error(stage, outcome, words):
    stage.monitor()
    stage.running.wait(LIMIT_S)
    outcome.text = stage.errors.read_text().strip()
    outcome.named = "error:" if stage.running.returncode not in (0, -9) else "no error"
    outcome.faults = wanting(outcome.text, words)


def by_explain(stage, outcome, words):
    live = stage.setup["show"] is None
    if live:
        stage.monitor()
        stage.send()
        stage.wait_for_levels()
    facts = stage.explain()
    outcome.named, outcome.text = "explain:" + facts["cause"], facts["verdict"]
    outcome.faults = wanting(outcome.text, words)
    if not live:
        return
    time.sleep(max(0.0, 6.5 - 0.4 * len(stage.reports())))
    outcome.also = problems(stage.reports()[-1])


def by_monitor(stage, outcome, words):
    stage.monitor()
    stage.send()
    end, first, found, report = time.monotonic() + LIMIT_S, None, None, None
    while not found and time.monotonic() < end:
        time.sleep(0.2)
        assert stage.running.poll() is None, stage.errors.read_text()
        for report in stage.reports()[-1:]:
            found = next((s for s in report["diagnosis"] if s["trouble"] == outcome.wanted), None)
        if found and first is None:
            first = time.monotonic()
        if found and wanting(found["text"], words) and time.monotonic() < first + stage.setup["patience_s"]:
            found = None
    if not found:
        outcome.named = ", ".join(problems(report)) if report else "nothing"
        outcome.text = "; ".join(sentence["text"] for sentence in report["diagnosis"]) if report else ""
        return
    outcome.named, outcome.text = outcome.wanted, found["text"]
    outcome.also = [trouble for trouble in problems(report) if trouble != outcome.wanted]
    outcome.faults = wanting(outcome.text, words)
    time.sleep(1)
    later = stage.reports()[-1]
    if outcome.wanted not in {sentence["trouble"] for sentence in later["diagnosis"]}:
        outcome.faults.append(f"a second later it is not said: {problems(later)}")
    outcome.also += [trouble for trouble in problems(later) if trouble not in (outcome.wanted, *outcome.also)]
    if stage.setup["once"]:
        return
    facts = stage.explain()
    same = [sentence for sentence in facts["input"]["diagnosis"] if sentence["trouble"] == outcome.wanted]
    said = same[0]["text"] if same else ""
    missing = wanting(said, words)
    outcome.faults += [f"explain says: {word}" for word in missing]
    if missing:
        outcome.text += "\n   explain: " + json.dumps(facts["input"])[:4000]
    if facts["cause"] == "never_received":
        outcome.faults += [f"explain's verdict says: {word}" for word in wanting(facts["verdict"], words)]


def make(number, name, what, setup, wanted, words):
    outcome = Outcome(name, what, wanted)
    with tempfile.TemporaryDirectory() as folder:
        stage = None
        try:
            stage = Stage(folder, number, setup)
            stage.share_port()
            how = by_error if wanted == "error:" else by_explain if wanted.startswith("explain:") else by_monitor
            how(stage, outcome, words)
            if is_compared(name, setup, wanted) and not outcome.faults and outcome.named == wanted:
                outcome.compared = True
                outcome.faults += alike.faults(stage, GHOSTLIGHT, outcome.text, wanted.startswith("explain:"))
        except (AssertionError, OSError, subprocess.SubprocessError, json.JSONDecodeError, KeyError) as error:
            outcome.faults.append(f"{type(error).__name__}: {error}")
        finally:
            if stage:
                stage.end()
    outcome.faults += [f"{also} is said, too" for also in outcome.also if also not in BESIDE.get(wanted, ())]
    good = outcome.named == wanted and not outcome.faults
    print(f"{'ok' if good else 'FAILED'}: {name}: {outcome.named}" + (f" (also {', '.join(outcome.also)})" if outcome.also else ""), flush=True)
    if not good:
        print(f"   wanted {wanted}, wanting {outcome.faults}\n   {outcome.text}", flush=True)
    return outcome


def be_well(number, name, setup):
    """All that is said to be wrong meanwhile."""
    with tempfile.TemporaryDirectory() as folder:
        stage = Stage(folder, number, setup)
        try:
            stage.monitor()
            stage.send()
            before = 0
            if stage.setup["ola"] or stage.setup["qlc"]:
                stage.wait_for_levels()
                before = len(stage.reports()) + 3  # of which QLC+ begins with a second in the dark
            end = time.monotonic() + LIMIT_S
            while len(stage.reports()) < before + WELL_S / 0.4 and time.monotonic() < end:
                time.sleep(0.3)
            said = sorted({trouble for report in stage.reports()[before:] for trouble in problems(report)})
            facts = stage.explain()
            if facts["cause"] != "none":
                said.append("explain:" + facts["cause"])
            if is_compared(name, setup):
                said += alike.faults(stage, GHOSTLIGHT, facts["verdict"], True)
        finally:
            stage.end()
    print(f"{'FAILED' if said else 'ok'}: all is well: {name}: {said or 'nothing said'}", flush=True)
    return said


def write(path, outcomes, well):
    true = sum(o.named == o.wanted and not o.faults for o in outcomes)
    lines = ["# Mistakes, and what is said of them", "",
             "Written by `tests/scripts/mistakes_test.py SOURCE BUILD --write docs/reference/mistakes.md` from what `monitor` and `explain` said; the same sentences",
             "stand in the window and in the JSON of both. Each mistake was made in network namespaces of its own, with a desk that sends real packets:",
             "one of a few lines, or OLA or QLC+ where the row begins with its name.", "",
             f"**{true} of {len(outcomes)} named truly. Of {len(well)} set-ups where all is well, {sum(not said for _, said in well)} without a word in red.**", "",
             "## The table", "", "Window: there, and in what the commands print without `--json`, the same sentence was read. Not compared is what passes while somebody looks, what",
             "keeps the program from starting, and a show without a recording, for which the window listens to the network.", "",
             "| what was done wrong | named | window | in words |", "|---|---|---|---|"]
    for o in outcomes:
        words = o.text.split("\n")[-1].replace("|", "\\|").replace(f"{SOURCE}/", "")
        lines.append(f"| {o.what} | `{o.named}`{'' if o.named == o.wanted else ' (wrong)'} | {'yes' if o.compared else ''} | {words} |")
    lines += ["", "## Confusion matrix", "", "Each finding, how many mistakes it is the right one of, how many of these it named, and what else was said beside it.", "",
              "| finding | mistakes | named | missed | said of another mistake instead | said beside the right one |", "|---|---|---|---|---|---|"]
    for finding in sorted({o.wanted for o in outcomes}):
        mine = [o for o in outcomes if o.wanted == finding]
        named = sum(o.named == finding for o in mine)
        wrong = sum(o.named == finding and o.wanted != finding for o in outcomes)
        beside = sorted({f"`{also}`" for o in mine for also in o.also})
        lines.append(f"| `{finding}` | {len(mine)} | {named} | {len(mine) - named} | {wrong} | {', '.join(beside) or 'nothing'} |")
    lines += ["", "## All is well", "", "| set-up | said to be wrong |", "|---|---|"]
    lines += [f"| {name} | {', '.join(said) or 'nothing'} |" for name, said in well]
    pathlib.Path(path).write_text("\n".join(lines) + "\n")


def can_be_staged(name, setup):
    reason = real_desks.missing(setup)
    if reason:
        print(f"left out: {name}\nskipped: a row of mistakes_test: {reason}")  # the last words are the same, and are counted
    return not reason


def main():
    if not os.access(GHOSTLIGHT, os.X_OK):
        needs.skip(f"{GHOSTLIGHT} is not built")
    if os.geteuid() != 0:
        needs.skip("needs root for network namespaces")
    needs.packages("iproute2")
    try:
        with tempfile.TemporaryDirectory() as folder:
            Stage(folder, "try", {}).end()
    except subprocess.SubprocessError as error:
        needs.skip(f"no network namespaces or veth here: {error}")
    if not shutil.which("nft"):
        print("nftables is not installed: the firewall is staged as a desk that sends nothing")
    more = sys.argv[3:]
    path = more[more.index("--write") + 1] if "--write" in more else None
    names = [] if path else more
    wanted = [row for row in MISTAKES + DESK_MISTAKES if not names or row[0] in names]
    rows = [row for row in wanted if can_be_staged(row[0], row[2])]
    all_well = [row for row in WELL + DESK_WELL if (not names or row[0] in names) and can_be_staged(*row)]
    with concurrent.futures.ThreadPoolExecutor(LANES) as pool:
        outcomes = list(pool.map(lambda entry: make(entry[0], *entry[1]), enumerate(rows)))
        well = list(zip([name for name, _ in all_well], pool.map(lambda entry: be_well(f"w{entry[0]}", *entry[1]), enumerate(all_well))))
    true = sum(o.named == o.wanted and not o.faults for o in outcomes)
    print(f"{true} of {len(outcomes)} mistakes named truly; {sum(bool(said) for _, said in well)} of {len(well)} set-ups that are well called wrong")
    if path:
        assert len(rows) == len(wanted), "a table needs all of its rows"
        write(path, outcomes, well)
    sys.exit(0 if true == len(outcomes) and not any(said for _, said in well) else 1)


if __name__ == "__main__":
    main()
