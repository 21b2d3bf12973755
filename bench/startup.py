#!/usr/bin/env python3
"""The whole process on a tiny task: median wall and processor milliseconds.

    bench/startup.py DOMAIN PROBLEM [--plan build/bin/plan] [--runs 200] [--peer 'COMMAND {domain} {problem}']

The runs of both commands alternate, so that noise hits both alike.
"""
import argparse
import os
import shlex
import statistics
import time


def run(command):
    """(wall milliseconds, processor milliseconds) of one process; fails if it does."""
    devnull = os.open(os.devnull, os.O_RDWR)
    actions = [(os.POSIX_SPAWN_DUP2, devnull, fd) for fd in (0, 1, 2)]
    start = time.perf_counter()
    pid = os.posix_spawnp(command[0], command, os.environ, file_actions=actions)
    _, status, usage = os.wait4(pid, 0)
    wall = time.perf_counter() - start
    os.close(devnull)
    if status != 0:
        raise SystemExit(f"{' '.join(command)} failed: {os.waitstatus_to_exitcode(status)}")
    return wall * 1e3, (usage.ru_utime + usage.ru_stime) * 1e3


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("domain")
    parser.add_argument("problem")
    parser.add_argument("--plan", default="build/bin/plan")
    parser.add_argument("--runs", type=int, default=200)
    parser.add_argument("--peer")
    args = parser.parse_args()
    commands = {"plan": [args.plan, args.domain, args.problem]}
    if args.peer:
        commands["peer"] = [part.format(domain=args.domain, problem=args.problem) for part in shlex.split(args.peer)]
    samples = {name: [] for name in commands}
    for _ in range(args.runs):
        for name, command in commands.items():
            samples[name].append(run(command))
    for name, rows in samples.items():
        wall, processor = zip(*rows)
        print(f"{name}: wall {statistics.median(wall):.2f} ms (fastest {min(wall):.2f}), "
              f"processor {statistics.median(processor):.2f} ms (least {min(processor):.2f}), {len(rows)} runs")


main()
