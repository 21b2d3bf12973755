#!/usr/bin/env python3
"""`plan belief` against a peer on the same contingent problems, hidden state by hidden state, processor time.

    bench/belief.py LIST [--plan build/bin/plan] [--peer 'COMMAND with {domain} {problem} {hidden}'] [--no-ours]
        [--states 4] [--seconds 60] [--memory 8192] [--out belief.csv] [--only REGEX] [--group REGEX]

LIST has a problem a line: NAME DOMAIN PROBLEM [HIDDEN], paths relative to it. The hidden states are the `(:hidden ...)`
sections of the file HIDDEN or else of the problem; of each problem N are taken, evenly spread (of m the states
i * m / N). Each runs in a process of its own that is given the problem without such sections and a file with just the
one, and ends after --seconds of processor time, its children's included.

The peer's command runs in an empty folder and has {seconds} too; it prints what K-replanner prints: "A (plan-size)
P (planner-calls) S (planner-search-time)" with A = -1 where it failed, and says where an action "isn't applicable at
hidden state" or the "hidden state isn't" a goal. For K-replanner:

    --peer 'k-replanner --planner-path FOLDER_OF_FF --max-time {seconds} --no-print-plan {domain} {problem} {hidden}'

Prints a row a problem and planner: states solved, means over these of actions, plans and processor seconds, states in
which it was wrong (an action that the hidden state does not allow, or a goal believed but not true). Then the share of
states solved and, over the states that both solved, geometric means of the ratios of processor time and of actions:
for all problems, for those whose name has --group, and for those over a second with the peer.
"""
import argparse
import contextlib
import csv
import json
import os
import pathlib
import re
import resource
import shlex
import signal
import subprocess
import sys
import tempfile
import threading
import typing

from suite import mean


class Run(typing.NamedTuple):
    status: str = "error"
    success: bool = False  # the goal holds in the hidden state, within the limits
    wrong: bool = False    # an illegal action, or a goal believed that does not hold
    actions: int = 0
    plans: int = 0
    seconds: float = 0.0   # of processor time, the whole process
    search: float = 0.0    # of these the planner's own searches, where it says so


class Problem(typing.NamedTuple):
    name: str
    domain: str
    problem: str
    hidden: str


def problems(path, only):
    base = pathlib.Path(path).resolve().parent
    for number, line in enumerate(open(path), 1):
        words = line.split("#")[0].split()
        if not words:
            continue
        if len(words) not in (3, 4):
            sys.exit(f"{path}:{number}: NAME DOMAIN PROBLEM [HIDDEN] is expected")
        if re.search(only, words[0]):
            files = [str(base / word) for word in words[1:]]
            yield Problem(words[0], files[0], files[1], files[-1])


def without_comments(path):
    return re.sub(r";[^\n]*", "", open(path, encoding="latin-1").read())


def hidden_sections(text):
    """(start, end) of every `(:hidden ...)`."""
    sections = []
    for match in re.finditer(r"\(\s*:hidden\b", text, re.IGNORECASE):
        depth = 0
        for brace in re.finditer(r"[()]", text[match.start():]):
            depth += 1 if brace.group() == "(" else -1
            if depth == 0:
                sections.append((match.start(), match.start() + brace.end()))
                break
    return sections


def cut(text, sections):
    for start, end in reversed(sections):
        text = text[:start] + text[end:]
    return text


def spread(items, count):
    count = min(count, len(items))
    return [(i * len(items) // count, items[i * len(items) // count]) for i in range(count)]


def session_seconds(session):
    """Processor time of the live processes of a session and of the children that these waited for."""
    ticks = 0
    for entry in pathlib.Path("/proc").glob("[0-9]*/stat"):
        with contextlib.suppress(OSError):  # it has ended
            fields = entry.read_text(errors="replace").rpartition(")")[2].split()
            if int(fields[3]) == session:
                ticks += sum(map(int, fields[11:15]))
    return ticks / os.sysconf("SC_CLK_TCK")


def execute(command, folder, seconds, memory_mb):
    """(exit code, processor seconds, output); the whole session is ended when its processor time is spent."""
    def limit():
        resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))
        resource.setrlimit(resource.RLIMIT_AS, (memory_mb << 20, memory_mb << 20))

    with tempfile.TemporaryFile() as output:
        process = subprocess.Popen(command, cwd=folder, preexec_fn=limit, start_new_session=True,
                                   stdin=subprocess.DEVNULL, stdout=output, stderr=subprocess.STDOUT)
        ended = threading.Event()
        spent = [0.0]

        def end_session():
            with contextlib.suppress(ProcessLookupError):
                os.killpg(process.pid, signal.SIGKILL)

        def guard():
            while not ended.wait(0.5):
                spent[0] = max(spent[0], session_seconds(process.pid))
                if spent[0] > seconds:
                    return end_session()

        watcher = threading.Thread(target=guard)
        watcher.start()
        try:
            _, status, usage = os.wait4(process.pid, 0)
        finally:  # also where this script is interrupted
            end_session()
            ended.set()
            watcher.join()
        process.returncode = os.waitstatus_to_exitcode(status)
        output.seek(0)
        text = output.read().decode(errors="replace")
    return process.returncode, max(spent[0], usage.ru_utime + usage.ru_stime), text


def run_plan(plan, domain, problem, hidden, folder, options):
    report = os.path.join(folder, "report.json")
    command = [plan, "belief", domain, problem, "--world", hidden, "--json", report, "--quiet",
               "--time-limit", str(options.seconds)]
    code, seconds, _ = execute(command, folder, options.seconds, options.memory)
    try:
        with open(report) as file:
            values = json.load(file)
    except (OSError, ValueError):
        return Run(status="out of time" if seconds >= options.seconds else f"exit code {code}", seconds=seconds)
    if len(values.get("runs", [])) != 1:
        return Run(status=values.get("status", "error"), seconds=seconds)
    run = values["runs"][0]
    false_success = run.get("false_success", False)
    return Run("false success" if false_success else run["status"],
               run["success"] and code == 0 and seconds <= options.seconds,
               false_success or run["status"] == "illegal", run["actions"], run["plans"], seconds,
               run["search_seconds"])


def run_peer(command, domain, problem, hidden, folder, options):
    words = [word.format(domain=domain, problem=problem, hidden=hidden, seconds=options.seconds)
             for word in shlex.split(command)]
    code, seconds, output = execute(words, folder, options.seconds, options.memory)

    def last(pattern):
        found = re.findall(pattern, output)
        return float(found[-1]) if found else None

    actions = last(r"(-?\d+) \(plan-size\)")
    wrong = re.search(r"isn't applicable at hidden state|hidden state isn't", output) is not None
    success = actions is not None and actions >= 0 and not wrong and code == 0 and seconds <= options.seconds
    if success:
        status = "reached"
    elif seconds >= options.seconds or "reached time limit" in output:
        status = "out of time"
    elif actions is None:
        status = f"exit code {code}"
    else:
        status = "illegal or false" if wrong else "no solution" if "no solution" in output else "failed"
    return Run(status, success, wrong, int(max(actions or 0, 0)), int(last(r"(\d+) \(planner-calls\)") or 0), seconds,
               last(r"([\d.e+-]+) \(planner-search-time\)") or 0.0)


def run_problem(item, planners, options):
    """Per state {planner: Run}, in the order of `planners`."""
    text = without_comments(item.problem)
    own = hidden_sections(text)
    source = text if item.hidden == item.problem else without_comments(item.hidden)
    states = [source[start:end] for start, end in hidden_sections(source)]
    name = re.search(r"\(\s*problem\s+([^\s()]+)", text, re.IGNORECASE)
    results = []
    for number, state in spread(states, options.states):
        runs = {}
        for planner, run in planners.items():
            with tempfile.TemporaryDirectory() as folder:
                inputs, work = os.path.join(folder, "in"), os.path.join(folder, "work")
                os.mkdir(inputs)
                os.mkdir(work)
                problem, hidden = os.path.join(inputs, "problem.pddl"), os.path.join(inputs, "hidden.pddl")
                with open(hidden, "w", encoding="latin-1") as file:
                    file.write(f"(define (problem {name.group(1) if name else 'hidden'})\n    {state}\n)\n")
                if own:
                    with open(problem, "w", encoding="latin-1") as file:
                        file.write(cut(text, own))
                runs[planner] = run(item.domain, problem if own else item.problem, hidden, work)
        results.append((number, runs))
    return results


def average(values):
    values = list(values)
    return sum(values) / len(values) if values else float("nan")


def row(name, planner, runs):
    good = [run for run in runs if run.success]
    failures = sorted({run.status for run in runs if not run.success})
    return (f"{name:28} {planner:5} {len(good):4} of {len(runs):<4} {average(r.actions for r in good):8.1f} "
            f"{average(r.plans for r in good):7.1f} {average(r.seconds for r in good):9.3f} "
            f"{sum(r.wrong for r in runs):5}  {', '.join(failures)}")


def summarize(label, states, planners):
    if not states:
        return
    for planner in planners:
        runs = [runs[planner] for runs in states]
        solved = sum(run.success for run in runs)
        print(f"{label}: {planner} solved {solved} of {len(runs)} states ({100 * solved / len(runs):.1f} %), "
              f"wrong in {sum(run.wrong for run in runs)}")
    both = [runs for runs in states if len(runs) == 2 and all(run.success for run in runs.values())]
    if both:
        ratios = [runs["peer"].seconds / max(runs["ours"].seconds, 1e-3) for runs in both]
        actions = [max(runs["ours"].actions, 1) / max(runs["peer"].actions, 1) for runs in both]
        print(f"{label}: both solved {len(both)}; ours is {mean(ratios):.1f} times faster (least {min(ratios):.2f}), "
              f"with {mean(actions):.3f} of the actions (most {max(actions):.2f}), geometric means")


def main():
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("list")
    parser.add_argument("--plan", default="build/bin/plan")
    parser.add_argument("--peer", help="the command; without it only ours runs")
    parser.add_argument("--no-ours", action="store_true", help="run only the peer")
    parser.add_argument("--states", type=int, default=4, help="hidden states a problem, at most")
    parser.add_argument("--seconds", type=int, default=60, help="of processor time a hidden state")
    parser.add_argument("--memory", type=int, default=8192, help="MiB of each process")
    parser.add_argument("--only", default="", metavar="REGEX", help="only problems whose name has it")
    parser.add_argument("--group", metavar="REGEX", help="totals of the problems whose name has it, too")
    parser.add_argument("--out", help="a CSV file: a row a problem, state and planner")
    options = parser.parse_args()
    if options.no_ours and not options.peer:
        parser.error("--no-ours needs --peer")
    if options.states < 1 or options.seconds < 1:
        parser.error("--states and --seconds need at least 1")
    planners = {}
    if not options.no_ours:
        plan = os.path.abspath(options.plan)
        planners["ours"] = lambda *files: run_plan(plan, *files, options)
    if options.peer:
        planners["peer"] = lambda *files: run_peer(options.peer, *files, options)

    print(f"{'problem':28} {'':5} {'solved':12} {'actions':>8} {'plans':>7} {'cpu s':>9} {'wrong':>5}  failures")
    everything = []
    with contextlib.ExitStack() as stack:
        writer = None
        if options.out:
            file = stack.enter_context(open(options.out, "w", newline="", buffering=1))
            writer = csv.writer(file)
            writer.writerow("problem state planner status success wrong actions plans cpu_s search_s".split())
        for item in problems(options.list, options.only):
            results = run_problem(item, planners, options)
            if not results:
                print(f"{item.name:28} no hidden state in {item.hidden}")
                continue
            for planner in planners:
                print(row(item.name, planner, [runs[planner] for _, runs in results]), flush=True)
            for number, runs in results:
                everything.append((item.name, runs))
                for planner, run in runs.items():
                    if writer:
                        writer.writerow([item.name, number, planner, run.status, int(run.success), int(run.wrong),
                                         run.actions, run.plans, f"{run.seconds:.4f}", f"{run.search:.4f}"])

    summarize("all", [runs for _, runs in everything], planners)
    if options.group:
        summarize(options.group, [runs for name, runs in everything if re.search(options.group, name)], planners)
    if "peer" in planners and "ours" in planners:
        summarize("peer over 1 s", [runs for _, runs in everything if runs["peer"].seconds > 1], planners)


main()
