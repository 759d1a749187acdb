#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Fuzzes every target until each had its seconds of processor time: in rounds of five minutes, one target on each core
(or JOBS at a time), the one with the least so far first. Interrupted (Ctrl+C), it goes on the next time: what was done is in FOLDER/done.json, and a target that was built anew
begins anew, with the corpus that it had. What it found lies in FOLDER/<target>-*, and so does an input that takes above SLOW_S; a target
rests until that is taken away. Prints a table, which lies in FOLDER/table.md; exit code 1 where anything was found.
Usage: fuzz.py [--jobs JOBS] FOLDER SECONDS [TARGET...]; FOLDER holds fuzz_<target>, seeds/<target> and, afterwards, corpus_<target>."""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
ROUND_S = 300
# Longest input in bytes: archives and models need room, packets have an end of their own.
LONGEST = {**dict.fromkeys(["gdtf", "mvr", "plot_show", "model", "gltf_pack", "picture", "exr", "film"], 1_000_000),
           **dict.fromkeys(["artnet", "sacn", "merge", "xchange", "xchange_peers", "capture", "gzip", "ghostdmx", "model_wire", "baked"], 65_536),
           **dict.fromkeys(["bounce", "toml_edit"], 20_000),
           **dict.fromkeys(["mdns", "osc", "psn", "midi", "usb_pro"], 4096)}
LONGEST_OF_OTHERS = 200_000
DICTIONARIES = {"toml_edit": "show", "plot_show": "mvr", "gltf_pack": "model", "xchange_peers": "xchange", "http": "web", "websocket": "web"}
SLOW_S = 2  # of processor time, an input by itself: what takes longer is a fault
PATIENCE_S = 120  # by the clock: the machine may be busy with other work
INTERRUPTED, TIMED_OUT = 72, 70  # libFuzzer's exit codes
FAULTS = ("crash-", "leak-", "timeout-", "oom-", "slow-unit-")
FIGURES = {"executions": r"number_of_executed_units: (\d+)", "edges": r"\bcov: (\d+)", "features": r"\bft: (\d+)", "kept": r"\bcorp: (\d+)"}


def targets():
    return sorted(path.stem.removesuffix("_fuzz") for path in (ROOT / "tests/fuzz").rglob("*_fuzz.cpp"))


def found(folder, target):
    return sorted(path.name for path in folder.glob(f"{target}-*") if path.name.removeprefix(f"{target}-").startswith(FAULTS))


def call(command, log):
    """Returns exit code, seconds of processor time and most memory in MiB."""
    with open(log, "wb") as out:
        child = subprocess.Popen([str(word) for word in command], stdin=subprocess.DEVNULL, stdout=out, stderr=out)
        _, status, used = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    return child.returncode, used.ru_utime + used.ru_stime, used.ru_maxrss // 1024


def settle_slow(folder, target):
    """What was slow by the clock counts only if it is by the processor, alone."""
    for name in found(folder, target):
        if not name.removeprefix(f"{target}-").startswith(("timeout-", "slow-unit-")):
            continue
        code, seconds, _ = call([folder / f"fuzz_{target}", "-timeout=1200", folder / name], folder / f"{target}.slow.log")
        if code == 0 and seconds < SLOW_S:
            (folder / name).unlink()


def run(folder, target, seconds, *inputs):
    """One run with folders of inputs, of which the first gets what is new. Returns the figures, the exit code and what was said."""
    words = sorted((ROOT / "tests/fuzz").rglob(f"{DICTIONARIES.get(target, target)}.dict"))
    log = folder / f"{target}.log"
    code, used_s, peak_mb = call(
        [folder / f"fuzz_{target}", f"-max_total_time={seconds}", f"-max_len={LONGEST.get(target, LONGEST_OF_OTHERS)}", f"-timeout={PATIENCE_S}",
         f"-report_slow_units={SLOW_S}", "-print_final_stats=1", f"-artifact_prefix={folder}/{target}-", *[f"-dict={file}" for file in words],
         *inputs], log)
    settle_slow(folder, target)
    if code == TIMED_OUT and not found(folder, target):
        code = 0
    said = log.read_text(encoding="utf-8", errors="replace")
    figures = {key: int((re.findall(pattern, said) or [0])[-1]) for key, pattern in FIGURES.items()}
    return {**figures, "seconds": used_s, "peak_mb": peak_mb, "code": code, "said": said}


def minimise(folder, target):
    """Of corpus and seeds, those inputs without which something would not be reached."""
    corpus, small, old, seeds = (folder / name for name in (f"corpus_{target}", f"corpus_{target}.small", f"corpus_{target}.old", f"seeds/{target}"))
    for place in (corpus, seeds):
        place.mkdir(parents=True, exist_ok=True)
    for left_over in (small, old):
        shutil.rmtree(left_over, ignore_errors=True)
    small.mkdir()
    code, _, _ = call([folder / f"fuzz_{target}", "-merge=1", f"-max_len={LONGEST.get(target, LONGEST_OF_OTHERS)}", f"-timeout={PATIENCE_S}",
                       f"-artifact_prefix={folder}/{target}-", small, corpus, seeds], folder / f"{target}.merge.log")
    settle_slow(folder, target)
    if code != 0:  # interrupted: all of them, then
        shutil.copytree(seeds, corpus, dirs_exist_ok=True)
        return
    corpus.rename(old)
    small.rename(corpus)
    shutil.rmtree(old)


class Fuzzing:
    def __init__(self, folder, seconds, names):
        self.folder, self.seconds, self.names = folder, seconds, names
        self.file = folder / "done.json"
        self.done = json.loads(self.file.read_text(encoding="utf-8")) if self.file.exists() else {}
        self.running, self.lock, self.begun, self.first_share, self.stops = set(), threading.Lock(), time.monotonic(), None, False
        for name in names:
            built = (folder / f"fuzz_{name}").stat().st_mtime
            if self.done.get(name, {}).get("built") != built:
                self.done[name] = {"built": built, "seconds": 0.0, "peak_mb": 0, **dict.fromkeys(FIGURES, 0)}

    def next(self):
        left = [name for name in self.names if name not in self.running and not found(self.folder, name) and self.done[name]["seconds"] < self.seconds]
        return min(left, key=lambda name: self.done[name]["seconds"], default=None)

    def work(self):
        while not self.stops:
            with self.lock:
                name = self.next()
                if name is None:
                    return
                self.running.add(name)
            if self.done[name]["seconds"] == 0:
                minimise(self.folder, name)
            left_s = max(1, round(self.seconds - self.done[name]["seconds"]))
            did = run(self.folder, name, min(ROUND_S, left_s), self.folder / f"corpus_{name}")
            if self.done[name]["seconds"] + did["seconds"] >= self.seconds and not self.stops:
                minimise(self.folder, name)
            with self.lock:
                self.running.discard(name)
                self.add(name, did)

    def add(self, name, did):
        one = self.done[name]
        for key in ("seconds", "executions"):
            one[key] += did[key]
        for key in ("edges", "features", "peak_mb"):
            one[key] = max(one[key], did[key])
        one["kept"] = sum(1 for _ in (self.folder / f"corpus_{name}").iterdir())
        if did["code"] not in (0, INTERRUPTED):
            print(f"\n{name}: exit code {did['code']}\n{did['said'][-3000:]}", flush=True)
            if not found(self.folder, name):  # it ended without a word of libFuzzer's
                (self.folder / f"{name}-crash-without-input").write_text(did["said"][-100000:], encoding="utf-8")
        for file, text in ((self.file, json.dumps(self.done, indent=1)), (self.folder / "table.md", self.table())):
            part = file.with_suffix(".part")
            part.write_text(text, encoding="utf-8")
            part.replace(file)
        share = sum(min(self.done[each]["seconds"], self.seconds) for each in self.names) / (self.seconds * len(self.names))
        passed_s = time.monotonic() - self.begun
        if self.first_share is None:
            self.first_share = share
        left = passed_s * (1 - share) / (share - self.first_share) if share > self.first_share else None
        bar = "#" * int(24 * share)
        print(f"fuzz {100 * share:3.0f} % [{bar:24}]{f' {int(left // 60)}:{int(left % 60):02} left' if left else ''}  {name}", flush=True)

    def table(self):
        text = "| target | processor, s | executions | a second | edges | features | inputs kept | peak, MiB | found |\n|" + "---|" * 9 + "\n"
        for name in self.names:
            one = self.done[name]
            rate = one["executions"] / one["seconds"] if one["seconds"] else 0
            text += (f"| {name} | {one['seconds']:.0f} | {one['executions']:,} | {rate:,.0f} | {one['edges']:,} | {one['features']:,} | {one['kept']:,} | "
                     f"{one['peak_mb']:,} | {', '.join(found(self.folder, name)) or 'nothing'} |\n")
        return text


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("folder", type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("seconds", type=float)
    parser.add_argument("target", nargs="*", default=[])
    asked = parser.parse_args()
    unknown = sorted(set(asked.target) - set(targets()))
    if unknown:
        print(f"no fuzz target: {', '.join(unknown)}; there are {', '.join(targets())}", file=sys.stderr)
        return 2
    fuzzing = Fuzzing(asked.folder, asked.seconds, asked.target or targets())
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        working = [pool.submit(fuzzing.work) for _ in range(asked.jobs)]
        try:
            concurrent.futures.wait(working)
        except KeyboardInterrupt:
            fuzzing.stops = True  # the fuzzers heard it themselves, and end
            concurrent.futures.wait(working)
        for one in working:
            one.result()
    print("\n" + fuzzing.table(), end="")
    return 130 if fuzzing.stops else 1 if any(found(asked.folder, name) for name in fuzzing.names) else 0


if __name__ == "__main__":
    sys.exit(main())
