#!/usr/bin/env python3
"""The tasks of domains/belief in sampled worlds: success, SPL, steps, plans, processor time.

    bench/belief_tasks.py [--plan build/bin/plan] [--seeds 200] [--noise 0,0.05,0.1,0.2] [--policies plan,random,...]
        [--beliefs bayes,sticky] [--max-steps 40] [--only REGEX] [--all] [--optimum] [--out FILE.csv]

A row for each problem, policy, belief and probability of a wrong reading:

    success       the goal was believed, and holds in the world: per cent of the worlds, with Wilson's 95 % interval
    false         the goal was believed, and does not hold
    SPL_info      mean of S * l / max(p, l); l: what the best contingent policy spends in the world (--optimum; "-"
                  where it is too hard to compute)
    SPL_omni      the same with l: the optimal plan of one who knows the world
    p/l           steps by those of the best policy, over the worlds with success: 1 for every policy that is as good,
                  while SPL_info is less than 1 for one that is as good on the average but not world by world
    steps, plans  means; the steps over the worlds with success in brackets
    cpu ms        processor time a world, means

The first worlds are drawn from the initial uncertainty, the same for every row of a problem. Without --all only the
four tasks of Zhao's thesis (2025, chapter 8), and the one with cups of the same colour, in all their variants.
Beliefs other than the first run only with noise, and only with the policy "plan".
"""
import argparse
import csv
import json
import math
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
THESIS = "cup-pick-place|drawer-cleaning|drawer-inspection|sort-weight|sort-weight-display|cup-removal|same-colour"


def problems(options):
    for domain in sorted((ROOT / "domains" / "belief").glob("*/domain.pddl")):
        task = domain.parent.name
        if not options.all and not re.fullmatch(THESIS, task):
            continue
        for problem in sorted((ROOT / "problems" / "belief" / task).glob("*.pddl")):
            name = f"{task}/{problem.stem}"
            if re.search(options.only, name):
                yield name, str(domain), str(problem)


def wilson(successes, count):
    z = 1.959963984540054
    p, middle = successes / count, (successes / count + z * z / (2 * count)) / (1 + z * z / count)
    half = z / (1 + z * z / count) * math.sqrt(p * (1 - p) / count + z * z / (4 * count * count))
    return max(middle - half, 0.0), min(middle + half, 1.0)


def average(values):
    values = list(values)
    return sum(values) / len(values) if values else math.nan


def length(run):
    return run.get("length", run["actions"])


def spl(runs, best):
    """None unless every run has the length `best`."""
    if any(run.get(best) is None for run in runs):
        return None
    return average(run["success"] * (run[best] / max(length(run), run[best]) if max(length(run), run[best]) else 1)
                   for run in runs)


def length_ratio(runs):
    if any(run.get("policy_cost") is None for run in runs):
        return None
    good = [run for run in runs if run["success"]]
    best = sum(run["policy_cost"] for run in good)
    return sum(map(length, good)) / best if best else None


def execute(domain, problem, noise, policy, belief, options):
    """The report's runs; the message of the command if it failed."""
    with tempfile.TemporaryDirectory() as folder:
        report = pathlib.Path(folder) / "report.json"
        command = [options.plan, "belief", domain, problem, "--seeds", str(options.seeds), "--noise", str(noise),
                   "--max-steps", str(options.max_steps), "--seed", str(options.seed), "--json", str(report),
                   "--quiet"]
        if options.failures:
            command += ["--failures", str(options.failures)]
        if options.risk:
            command += ["--risk", str(options.risk)]
        if policy != "plan":
            command += ["--policy", policy]
        if belief:
            command += ["--belief", belief]
        if options.optimum:
            command += ["--optimum"]
        result = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        if result.returncode not in (0, 12):
            return None, (result.stderr.strip().splitlines() or [f"exit code {result.returncode}"])[0]
        return json.loads(report.read_text())["runs"], ""


def row(runs):
    count = len(runs)
    successes, wrong = sum(r["success"] for r in runs), sum(r["false_success"] for r in runs)
    low, high = wilson(successes, count)
    return {
        "worlds": count, "success": successes / count, "success_low": low, "success_high": high,
        "false_success": wrong / count, "spl_info": spl(runs, "policy_cost"), "spl_omni": spl(runs, "omniscient_cost"),
        "length_ratio": length_ratio(runs),
        "steps": average(map(length, runs)), "steps_of_successes": average(length(r) for r in runs if r["success"]),
        "plans": average(r["plans"] for r in runs), "cpu_ms": 1e3 * average(r["processor_seconds"] for r in runs),
        "statuses": " ".join(sorted({r["status"].replace(" ", "-") for r in runs if not r["success"]})),
    }


def show(name, policy, belief, noise, values):
    def number(value, format_spec):
        return "-" if value is None or math.isnan(value) else format(value, format_spec)
    label = policy + (f" {belief}" if belief else "")
    interval = f"[{100 * values['success_low']:.1f}, {100 * values['success_high']:.1f}]"
    print(f"{name:40} {label:14} {noise:5} {100 * values['success']:6.1f} {interval:14} "
          f"{100 * values['false_success']:6.1f} {number(values['spl_info'], '8.3f'):>8} "
          f"{number(values['spl_omni'], '8.3f'):>8} {number(values['length_ratio'], '6.3f'):>6} {values['steps']:7.2f} "
          f"({number(values['steps_of_successes'], '.2f'):>6}) {values['plans']:6.2f} {values['cpu_ms']:8.3f}  "
          f"{values['statuses']}", flush=True)


def summarize(label, rows):
    successes = [100 * r["success"] for r in rows]
    text = (f"{label} mean success {average(successes):6.1f} %, least {min(successes):6.1f} %, "
            f"most false {100 * max(r['false_success'] for r in rows):5.1f} %")
    for name, column, worst in (("SPL_info", "spl_info", min), ("p/l", "length_ratio", max)):
        values = [r[column] for r in rows if r[column] is not None]
        if values:
            text += f", {name} mean {average(values):.3f}, worst {worst(values):.3f}"
    print(text)


def combinations(options):
    """(noise, policy, belief): the first belief everywhere, others where there is noise and a plan. Policies that
    do not weigh readings are sticky."""
    beliefs = [belief for belief in options.beliefs.split(",") if belief] or [""]
    for noise in options.noise.split(","):
        for policy in options.policies.split(","):
            if policy not in ("plan", "best"):
                yield noise, policy, "sticky" if beliefs[0] else ""
                continue
            for belief in beliefs:
                if belief == beliefs[0] or (float(noise) > 0 and policy == "plan"):
                    yield noise, policy, belief


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--plan", default=str(ROOT / "build/bin/plan"))
    parser.add_argument("--seeds", type=int, default=200, help="worlds of each problem")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--noise", default="0,0.05,0.1,0.2", help="probabilities of a wrong reading")
    parser.add_argument("--policies", default="plan,random,random-any,sense-first")
    parser.add_argument("--beliefs", default="bayes,sticky", help="'' leaves the choice to the command")
    parser.add_argument("--failures", type=float, default=0, help="probability that an action fails")
    parser.add_argument("--risk", type=float, default=0, help="what unlikely outcomes cost in plans")
    parser.add_argument("--max-steps", type=int, default=40)
    parser.add_argument("--only", default="", metavar="REGEX", help="only problems whose name has it")
    parser.add_argument("--all", action="store_true", help="the contingent classics, too")
    parser.add_argument("--optimum", action="store_true", help="compute best policies, for SPL")
    parser.add_argument("--out", help="a CSV file")
    options = parser.parse_args()
    if options.seeds < 1:
        parser.error("--seeds needs at least 1")

    print(f"{'problem':40} {'policy':14} {'noise':>5} {'succ %':>6} {'95 %':14} {'false%':>6} {'SPL_info':>8} "
          f"{'SPL_omni':>8} {'p/l':>6} {'steps':>7} {'(succ.)':>8} {'plans':>6} {'cpu ms':>8}  failures")
    rows, errors = [], 0
    for name, domain, problem in problems(options):
        for noise, policy, belief in combinations(options):
            runs, error = execute(domain, problem, noise, policy, belief, options)
            if not runs:
                print(f"{name:40} {policy:14} {noise:>5} {error or 'no runs'}", flush=True)
                errors += 1
                continue
            values = row(runs)
            show(name, policy, belief, noise, values)
            rows.append({"problem": name, "policy": policy, "belief": belief, "noise": noise, **values})
    print()
    for noise, policy, belief in combinations(options):
        same = [r for r in rows if (r["noise"], r["policy"], r["belief"]) == (noise, policy, belief)]
        if same:
            summarize(f"noise {noise:>5} {policy + ' ' + belief:20}", same)
    if options.out and rows:
        with open(options.out, "w", newline="") as file:
            writer = csv.DictWriter(file, rows[0].keys())
            writer.writeheader()
            writer.writerows(rows)
    sys.exit(1 if errors else 0)


main()
