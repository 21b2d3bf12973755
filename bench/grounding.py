#!/usr/bin/env python3
"""Grounding against a peer's translator on the same tasks, one after the other, processor time.

    bench/grounding.py SUITE --peer 'python3 DOWNWARD/builds/release/bin/translate/translate.py {domain} {problem}'
        [--plan build/bin/plan] [--seconds 60] [--memory 8192] [--out grounding.csv] [--only SUBSTRING]

SUITE has a task a line: NAME DOMAIN PROBLEM, paths relative to it. Prints a row a task and, for the tasks where the
peer needs more than a second, the geometric mean of the ratios.
"""
import argparse
import csv
import os
import resource
import shlex
import signal
import subprocess
import tempfile
import threading

from suite import mean, tasks


def run(command, seconds, memory_mb):
    """(exit code, processor seconds, peak MiB)."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
        resource.setrlimit(resource.RLIMIT_AS, (memory_mb << 20, memory_mb << 20))

    with tempfile.TemporaryDirectory() as folder:
        process = subprocess.Popen(command, cwd=folder, preexec_fn=limit, stdin=subprocess.DEVNULL,
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        guard = threading.Timer(3 * seconds, process.send_signal, [signal.SIGKILL])
        guard.start()
        _, status, usage = os.wait4(process.pid, 0)
        guard.cancel()
        process.returncode = os.waitstatus_to_exitcode(status)
    return process.returncode, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("suite")
    parser.add_argument("--peer", required=True)
    parser.add_argument("--plan", default="build/bin/plan")
    parser.add_argument("--seconds", type=int, default=60)
    parser.add_argument("--memory", type=int, default=8192)
    parser.add_argument("--only", default="")
    parser.add_argument("--out")
    args = parser.parse_args()
    plan = os.path.abspath(args.plan)
    rows = []
    for name, domain, problem in tasks(args.suite):
        if args.only not in name:
            continue
        ours = run([plan, "ground", domain, problem, "--quiet"], args.seconds, args.memory)
        peer = run([part.format(domain=domain, problem=problem) for part in shlex.split(args.peer)],
                   args.seconds, args.memory)
        rows.append((name, *ours, *peer))
        print(f"{name:45} ours {ours[0]:3} {ours[1]:8.3f} s {ours[2]:7.0f} MiB   "
              f"peer {peer[0]:3} {peer[1]:8.3f} s {peer[2]:7.0f} MiB", flush=True)
    if args.out:
        with open(args.out, "w", newline="") as file:
            writer = csv.writer(file)
            writer.writerow("task ours_exit ours_cpu_s ours_mib peer_exit peer_cpu_s peer_mib".split())
            writer.writerows(rows)
    both = [row for row in rows if row[1] == 0 and row[4] == 0]
    slow = [row for row in both if row[5] > 1]
    print(f"ground: ours {sum(row[1] == 0 for row in rows)}, peer {sum(row[4] == 0 for row in rows)} of {len(rows)}")
    for label, chosen in (("all", both), ("peer over 1 s", slow)):
        ratios = [row[5] / max(row[2], 1e-3) for row in chosen]
        memory = [row[6] / row[3] for row in chosen]
        if chosen:
            print(f"{label}: {len(chosen)} tasks, {mean(ratios):.1f} times faster (least {min(ratios):.1f}), "
                  f"memory 1/{mean(memory):.1f} (least 1/{min(memory):.1f}), geometric means")


main()
