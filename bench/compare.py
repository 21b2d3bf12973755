#!/usr/bin/env python3
"""Compare planners that ran over the same suite.

    bench/compare.py OURS.csv PEER.csv [--limit 300] [--names praxis lama-first]

The files have a row a task with the columns task, status, cpu_s, peak_mb and cost; the first is compared with the
second. Prints Markdown: coverage, IPC agile score (1 up to one second, then 1 - log(t) / log(limit); processor time),
IPC quality score (cost of the best plan in either file / cost), geometric mean of the processor times and median of
the peak memory on tasks that both solved, who alone solved what, and the tasks where the first did worst.
"""
import argparse
import csv
import math
import statistics


def read(path):
    with open(path) as file:
        return {row["task"]: row for row in csv.DictReader(file)}


def solved(row):
    return row is not None and row["status"] == "solved"


def agile(row, limit):
    if not solved(row):
        return 0.0
    seconds = float(row["cpu_s"])
    return 1.0 if seconds <= 1 else max(0.0, 1 - math.log(seconds) / math.log(limit))


def quality(row, best):
    if not solved(row):
        return 0.0
    cost = float(row["cost"])
    return 1.0 if cost <= best else best / cost


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs=2, metavar="CSV")
    parser.add_argument("--limit", type=float, default=300, help="seconds at which the agile score is 0")
    parser.add_argument("--names", nargs=2, default=["ours", "peer"])
    parser.add_argument("--worst", type=int, default=5, help="how many of the worst tasks to print")
    options = parser.parse_args()
    ours, peer = map(read, options.files)
    tasks = [task for task in ours if task in peer]
    both = [task for task in tasks if solved(ours[task]) and solved(peer[task])]

    def total(score):
        return [sum(score(rows[task], task) for task in tasks) for rows in (ours, peer)]

    best = {
        task: min((float(rows[task]["cost"]) for rows in (ours, peer) if solved(rows[task])), default=0)
        for task in tasks
    }
    coverage = [sum(solved(rows[task]) for task in tasks) for rows in (ours, peer)]
    agile_scores = total(lambda row, _: agile(row, options.limit))
    quality_scores = total(lambda row, task: quality(row, best[task]))

    def ratio(task, column):
        floor = {"cpu_s": 0.001, "peak_mb": 1}[column]
        return max(float(ours[task][column]), floor) / max(float(peer[task][column]), floor)

    print(f"| {len(tasks)} tasks | {options.names[0]} | {options.names[1]} |\n| --- | --- | --- |")
    print(f"| solved | {coverage[0]} | {coverage[1]} |")
    print(f"| agile score | {agile_scores[0]:.1f} | {agile_scores[1]:.1f} |")
    print(f"| quality score | {quality_scores[0]:.1f} | {quality_scores[1]:.1f} |")
    if both:
        times = statistics.geometric_mean(ratio(task, "cpu_s") for task in both)
        memory = statistics.median(ratio(task, "peak_mb") for task in both)
        print(f"\nOn the {len(both)} tasks that both solved: processor time {times:.3f} (geometric mean), "
              f"peak memory {memory:.2f} (median).")
    for name, rows, others in ((options.names[0], ours, peer), (options.names[1], peer, ours)):
        alone = [f"{task} ({float(rows[task]['cpu_s']):.1f} s)"
                 for task in tasks if solved(rows[task]) and not solved(others[task])]
        print(f"\nOnly {name} solved {len(alone)}: {', '.join(alone)}")
    if both:
        print(f"\n| worst by processor time | {options.names[0]} | {options.names[1]} | ratio |\n| --- | --- | --- | --- |")
        for task in sorted(both, key=lambda task: -ratio(task, "cpu_s"))[:options.worst]:
            print(f"| {task} | {float(ours[task]['cpu_s']):.2f} s | {float(peer[task]['cpu_s']):.2f} s "
                  f"| {ratio(task, 'cpu_s'):.2f} |")


if __name__ == "__main__":
    main()
