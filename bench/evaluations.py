#!/usr/bin/env python3
"""Evaluations a second of one search in two planners, task by task.

    bench/evaluations.py SUITE --peer 'DOWNWARD/builds/release/bin/downward --search {search} < {sas}'
        [--plan build/bin/plan] [--search 'eager_greedy([ff()],max_time=5)'] [--out evaluations.csv]
        [--only SUBSTRING]

SUITE has a task a line: NAME DOMAIN PROBLEM, paths relative to it. The peer's command is a shell command that prints
"Evaluated N state(s)" and "Search time: S" (processor seconds); {sas} is a file that `plan ground` writes, {domain}
and {problem} are there too. A rate is evaluated states by processor seconds of the search; for `plan`, that is the
search's wall time in the share that the whole process had of a processor. Both planners run on their own, one after
the other, until they find a plan or max_time is over; runs below half a second are not counted. Prints a row a task
and the geometric mean of the ratios.
"""
import argparse
import csv
import json
import math
import os
import pathlib
import re
import shlex
import subprocess
import tempfile


def tasks(suite):
    for line in open(suite):
        words = line.split("#")[0].split()
        if len(words) == 3:
            base = pathlib.Path(suite).resolve().parent
            yield words[0], str(base / words[1]), str(base / words[2])


def measure_plan(plan, search, domain, problem, folder):
    """(evaluated states, processor seconds of the search)."""
    report = os.path.join(folder, "report.json")
    subprocess.run([plan, domain, problem, "--search", search, "--json", report, "--quiet"],
                   stdout=subprocess.DEVNULL, check=False)
    with open(report) as file:
        values = json.load(file)
    share = min(1.0, values["processor_seconds"] / values["seconds"])
    return values["search"]["evaluated"], values["search"]["seconds"] * share


def measure_peer(command, folder):
    """The same, from what the command prints."""
    output = subprocess.run(command, shell=True, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
                            text=True, check=False).stdout
    evaluated = re.findall(r"Evaluated (\d+) state", output)
    seconds = re.findall(r"Search time: ([\d.e-]+)", output)
    return (int(evaluated[-1]), float(seconds[-1])) if evaluated and seconds else (0, 0.0)


def mean(values):
    return math.exp(sum(map(math.log, values)) / len(values)) if values else float("nan")


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
            ours = measure_plan(plan, args.search, domain, problem, folder)
            words = {"search": args.search, "sas": sas, "domain": domain, "problem": problem}
            peer = measure_peer(args.peer.format(**{key: shlex.quote(word) for key, word in words.items()}), folder)
        if min(ours[1], peer[1]) < 0.5:
            print(f"{name:45} too short: ours {ours[1]:.2f} s, peer {peer[1]:.2f} s", flush=True)
            continue
        rates = ours[0] / ours[1], peer[0] / peer[1]
        rows.append((name, *ours, *peer, rates[0] / rates[1]))
        print(f"{name:45} ours {rates[0]:9.0f}/s   peer {rates[1]:9.0f}/s   ratio {rates[0] / rates[1]:6.2f}",
              flush=True)
    if args.out:
        with open(args.out, "w", newline="") as file:
            writer = csv.writer(file)
            writer.writerow("task ours_evaluated ours_cpu_s peer_evaluated peer_cpu_s ratio".split())
            writer.writerows(rows)
    ratios = [row[-1] for row in rows]
    if ratios:
        print(f"{len(rows)} tasks: {mean(ratios):.2f} times as many evaluations a second, geometric mean "
              f"(least {min(ratios):.2f}, most {max(ratios):.2f})")


main()
