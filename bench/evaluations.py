#!/usr/bin/env python3
"""Evaluations a second of one search in two planners, task by task.

    bench/evaluations.py SUITE --peer 'DOWNWARD/builds/release/bin/downward --search {search} < {sas}'
        [--plan build/bin/plan] [--search 'eager_greedy([ff()],max_time=5)'] [--out evaluations.csv]
        [--only SUBSTRING]

SUITE has a task a line: NAME DOMAIN PROBLEM, paths relative to it. The peer's command is a shell command that prints
"Evaluated N state(s)" and "Search time: S" (processor seconds); {sas} is a file that `plan ground` writes, {domain}
and {problem} are there too. A rate is evaluated states by processor seconds of the search; for `plan`, that is the
search's wall time in the share that the whole process had of a processor. Both planners run on their own, one after
the other, until they find a plan or max_time is over; runs below half a second are not counted. Bytes a state are
what the peak memory of the process is above that of a run with max_time=0.01, by states registered in the longer run.
Prints a row a task and the geometric means of the ratios.
"""
import argparse
import csv
import json
import os
import re
import shlex
import subprocess
import tempfile
import typing

from suite import mean, tasks


class Run(typing.NamedTuple):
    evaluated: int = 0
    seconds: float = 0.0  # of processor time, the search alone
    states: int = 0       # registered
    memory: int = 0       # peak, bytes

    def rate(self):
        return self.evaluated / self.seconds


def measure_plan(plan, search, domain, problem, folder):
    report = os.path.join(folder, "report.json")
    subprocess.run([plan, domain, problem, "--search", search, "--json", report, "--quiet"],
                   stdout=subprocess.DEVNULL, check=False)
    with open(report) as file:
        values = json.load(file)
    share = min(1.0, values["processor_seconds"] / values["seconds"])
    counts = values["search"]
    return Run(counts["evaluated"], counts["seconds"] * share, counts["registered_states"], values["peak_memory"])


def measure_peer(command, folder):
    """The same, from what the command prints."""
    output = subprocess.run(command, shell=True, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                            text=True, check=False).stdout

    def last(pattern):
        found = re.findall(pattern, output)
        return float(found[-1]) if found else 0.0

    return Run(int(last(r"Evaluated (\d+) state")), last(r"Search time: ([\d.e-]+)"),
               int(last(r"Number of registered states: (\d+)")), int(last(r"Peak memory: (\d+) KB") * 1024))


def bytes_a_state(run, start):
    """None where the search does not dominate the process's memory."""
    grown = run.memory - start.memory
    return grown / run.states if run.states > 100_000 and grown > run.memory / 2 else None


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("suite")
    parser.add_argument("--peer", required=True)
    parser.add_argument("--plan", default="build/bin/plan")
    parser.add_argument("--search", default="eager_greedy([ff()],max_time=5)")
    parser.add_argument("--only", default="")
    parser.add_argument("--out")
    args = parser.parse_args()
    plan = os.path.abspath(args.plan)
    rows = []
    for name, domain, problem in tasks(args.suite):
        if args.only not in name:
            continue
        with tempfile.TemporaryDirectory() as folder:
            sas = os.path.join(folder, "task.sas")
            subprocess.run([plan, "ground", domain, problem, "--sas", sas, "--quiet"],
                           stdout=subprocess.DEVNULL, check=True)
            short = re.sub(r"max_time=[\d.]+", "max_time=0.01", args.search)

            def run_peer(search):
                words = {"search": search, "sas": sas, "domain": domain, "problem": problem}
                return measure_peer(args.peer.format(**{key: shlex.quote(word) for key, word in words.items()}),
                                    folder)

            ours, start = [measure_plan(plan, search, domain, problem, folder) for search in (args.search, short)]
            peer, peer_start = [run_peer(search) for search in (args.search, short)]
        if min(ours.seconds, peer.seconds) < 0.5:
            print(f"{name:45} too short: ours {ours.seconds:.2f} s, peer {peer.seconds:.2f} s", flush=True)
            continue
        ratio = ours.rate() / peer.rate()
        sizes = bytes_a_state(ours, start), bytes_a_state(peer, peer_start)
        rows.append((name, ours.evaluated, ours.seconds, peer.evaluated, peer.seconds, ratio, *sizes))
        text = f"   bytes a state {sizes[0]:.0f} / {sizes[1]:.0f}" if all(sizes) else ""
        print(f"{name:45} ours {ours.rate():9.0f}/s   peer {peer.rate():9.0f}/s   ratio {ratio:6.2f}{text}",
              flush=True)
    if args.out:
        with open(args.out, "w", newline="") as file:
            writer = csv.writer(file)
            writer.writerow("task ours_evaluated ours_cpu_s peer_evaluated peer_cpu_s ratio ours_bytes peer_bytes".split())
            writer.writerows(rows)
    ratios = [row[5] for row in rows]
    if ratios:
        print(f"{len(rows)} tasks: {mean(ratios):.2f} times as many evaluations a second, geometric mean "
              f"(least {min(ratios):.2f}, most {max(ratios):.2f})")
    sizes = [row[6] / row[7] for row in rows if row[6] and row[7]]
    if sizes:
        print(f"{len(sizes)} tasks of more than 100,000 states: {mean(sizes):.2f} times the bytes a state")


main()
