#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Fuzzes every target until each had its seconds of processor time: in rounds of a minute, one target on each core, the one with the
least so far first. Interrupted (Ctrl+C), it goes on the next time: what was done is in FOLDER/done.json, and a target that was built anew
begins anew. What it found lies in FOLDER/<target>-*. Prints a table; exit code 1 where anything was found.
Usage: fuzz.py FOLDER SECONDS [TARGET...]; FOLDER holds fuzz_<target>, seeds/<target> and, afterwards, corpus_<target>."""
import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
ROUND_S = 60
# Longest input in bytes: archives and models need room, packets have an end of their own.
LONGEST = {**dict.fromkeys(["gdtf", "mvr", "model", "gltf_pack", "picture", "exr"], 1_000_000),
           **dict.fromkeys(["artnet", "sacn", "merge", "xchange", "capture", "ghostdmx", "model_wire"], 65_536),
           **dict.fromkeys(["mdns", "osc", "psn", "midi", "usb_pro"], 4096)}
LONGEST_OF_OTHERS = 200_000
SLOWEST_S = 10  # an input
INTERRUPTED = 72  # libFuzzer's exit code
FAULTS = ("crash-", "leak-", "timeout-", "oom-", "slow-unit-")


def targets():
    return sorted(path.stem.removesuffix("_fuzz") for path in (ROOT / "tests/fuzz").glob("*_fuzz.cpp"))


def found(folder, target):
    return sorted(path.name for path in folder.glob(f"{target}-*") if path.name.removeprefix(f"{target}-").startswith(FAULTS))


def run(folder, target, seconds, corpus, seeds, slowest_s=SLOWEST_S):
    """One run. Returns what it did: seconds of processor time, executions, edges, the exit code and what it said."""
    words = ROOT / f"tests/fuzz/{target}.dict"
    command = [folder / f"fuzz_{target}", f"-max_total_time={seconds}", f"-max_len={LONGEST.get(target, LONGEST_OF_OTHERS)}", f"-timeout={slowest_s}",
               "-print_final_stats=1", f"-artifact_prefix={folder}/{target}-", *([f"-dict={words}"] if words.exists() else []), corpus, seeds]
    log = folder / f"{target}.log"
    with open(log, "wb") as out:
        child = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out, stderr=out)
        _, status, used = os.wait4(child.pid, 0)
    child.returncode = os.waitstatus_to_exitcode(status)
    said = log.read_text(encoding="utf-8", errors="replace")
    executions, edges = re.search(r"number_of_executed_units: (\d+)", said), re.findall(r"\bcov: (\d+)", said)
    return {"seconds": used.ru_utime + used.ru_stime, "executions": int(executions[1]) if executions else 0, "edges": int(edges[-1]) if edges else 0,
            "code": child.returncode, "said": said}


class Fuzzing:
    def __init__(self, folder, seconds, names):
        self.folder, self.seconds, self.names = folder, seconds, names
        self.file = folder / "done.json"
        self.done = json.loads(self.file.read_text(encoding="utf-8")) if self.file.exists() else {}
        self.running, self.lock, self.begun, self.first_share, self.stops = set(), threading.Lock(), time.monotonic(), None, False
        for name in names:
            built = (folder / f"fuzz_{name}").stat().st_mtime
            if self.done.get(name, {}).get("built") != built:
                self.done[name] = {"built": built, "seconds": 0.0, "executions": 0, "edges": 0}

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
            corpus = self.folder / f"corpus_{name}"
            corpus.mkdir(exist_ok=True)
            (self.folder / "seeds" / name).mkdir(parents=True, exist_ok=True)
            left_s = max(1, round(self.seconds - self.done[name]["seconds"]))
            did = run(self.folder, name, min(ROUND_S, left_s), corpus, self.folder / "seeds" / name)
            with self.lock:
                self.running.discard(name)
                self.add(name, did)

    def add(self, name, did):
        one = self.done[name]
        one["seconds"] += did["seconds"]
        one["executions"] += did["executions"]
        one["edges"] = max(one["edges"], did["edges"])
        part = self.file.with_suffix(".part")
        part.write_text(json.dumps(self.done, indent=1), encoding="utf-8")
        part.replace(self.file)
        if did["code"] not in (0, INTERRUPTED):
            print(f"\n{name}: exit code {did['code']}\n{did['said'][-3000:]}", flush=True)
            if not found(self.folder, name):  # it ended without a word of libFuzzer's
                (self.folder / f"{name}-crash-without-input").write_text(did["said"][-100000:], encoding="utf-8")
        share = sum(min(self.done[each]["seconds"], self.seconds) for each in self.names) / (self.seconds * len(self.names))
        passed_s = time.monotonic() - self.begun
        if self.first_share is None:
            self.first_share = share
        left = passed_s * (1 - share) / (share - self.first_share) if share > self.first_share else None
        bar = "#" * int(24 * share)
        print(f"fuzz {100 * share:3.0f} % [{bar:24}]{f' {int(left // 60)}:{int(left % 60):02} left' if left else ''}  {name}", flush=True)

    def table(self):
        print("\n| target | processor, s | executions | edges | found |\n|---|---|---|---|---|")
        for name in self.names:
            one, faults = self.done[name], found(self.folder, name)
            print(f"| {name} | {one['seconds']:.0f} | {one['executions']:,} | {one['edges']:,} | {', '.join(faults) or 'nothing'} |")


def main():
    folder, seconds = pathlib.Path(sys.argv[1]).resolve(), float(sys.argv[2])
    unknown = sorted(set(sys.argv[3:]) - set(targets()))
    if unknown:
        print(f"no fuzz target: {', '.join(unknown)}; there are {', '.join(targets())}", file=sys.stderr)
        return 2
    fuzzing = Fuzzing(folder, seconds, sys.argv[3:] or targets())
    cores = len(os.sched_getaffinity(0))
    with concurrent.futures.ThreadPoolExecutor(cores) as pool:
        working = [pool.submit(fuzzing.work) for _ in range(cores)]
        try:
            concurrent.futures.wait(working)
        except KeyboardInterrupt:
            fuzzing.stops = True  # the fuzzers heard it themselves, and end
            concurrent.futures.wait(working)
        for one in working:
            one.result()
    fuzzing.table()
    return 130 if fuzzing.stops else 1 if any(found(folder, name) for name in fuzzing.names) else 0


if __name__ == "__main__":
    sys.exit(main())
