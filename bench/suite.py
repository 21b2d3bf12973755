"""What the scripts of this folder share."""
import math
import pathlib


def tasks(suite):
    """(name, domain, problem) of each line of a suite; paths are relative to it."""
    for line in open(suite):
        words = line.split("#")[0].split()
        if len(words) == 3:
            base = pathlib.Path(suite).resolve().parent
            yield words[0], str(base / words[1]), str(base / words[2])


def mean(values):
    """Geometric."""
    return math.exp(sum(map(math.log, values)) / len(values)) if values else float("nan")
