"""Prints the table of speeds: table.py BENCHMARK.json SCIPY.json PROGRAM SESSION PEER.

Times are medians. A ratio is a peer's time over that of alidade, from the same run on the same readings. An
answer is compared with alidade's own, the greatest difference of x, y and R (W2: of the intersection) in mm. Of W5
the peer is scipy's least_squares, one fit for each effect, and the answer by how much χ² falls with each.
"""

import json
import statistics
import subprocess
import sys
import time

UNITS = {"ns": 1e-9, "us": 1e-6, "ms": 1e-3, "s": 1.0}
AGREEMENT = 1e-6  # mm
CERES_THERE = 39e-6  # seconds for W1, on the machine the aims are from
FALL = "fall by "  # of χ²
FALLS_AGREE = 1e-2  # one is of the linear model at the fit, the other of a fit; both are of the size of 1
ROWS = [  # workload, its name in words, seconds aimed at, ours, peers
    ("W1 one arc, 17 points", 0.5e-6, "W1/alidade", ["W1/scipy", "W1/Ceres", "W1/TinySolver"]),
    ("W1 the same through fitArc", None, "W1/alidade fitArc", ["W1/scipy", "W1/Ceres", "W1/TinySolver"]),
    ("W2 two arcs, Δd, U, residuals", 2e-6, "W2/alidade", [None, "W2/Ceres", None]),
    ("W2 the same through fitSession", 15e-6, "W2/alidade fitSession", [None, "W2/Ceres", None]),
    ("W3 100 000 arcs, each, 1 thread", 0.15e-6, "W3/alidade/1/real_time", ["W3/scipy", "W3/Ceres", "W3/TinySolver"]),
    ("W3 the same, 2 threads", 0.15e-6 / 1.9, "W3/alidade/2/real_time", ["W3/scipy", "W3/Ceres", "W3/TinySolver"]),
    ("W4 10⁶ points, each", 5e-9, "W4/alidade", ["W4/scipy", "W4/Ceres", None]),
    ("W5 catalogue on 34 points", 0.03e-3, "W5/alidade", ["W5/scipy", None, None]),
    ("W5 with the derivatives", None, "W5/alidade with derivatives", ["W5/scipy", None, None]),
    ("W6 general fit, 136 rows", 0.2e-3, "W6/alidade", [None, None, None]),
    ("W6 the same through fitSession", 80e-6, "W6/alidade fitSession", [None, None, None]),
    ("W7 diagnosis, 136 rows", 2e-3, "W7/alidade", [None, None, None]),
    ("W7 of two causes", None, "W7/alidade two causes", [None, None, None]),
    ("W11 10⁶ draws of Table I", 0.5, "W11/alidade/real_time", [None, None, None]),
    ("W11 of two-faces, with effects", 3, "W11/alidade two faces/real_time", [None, None, None]),
    ("W8 alidade-cli fit, process", 10e-3, "W8/alidade", ["W8/scipy", None, None]),
]


def benchmarks(path):
    """Median seconds and answers by name."""
    with open(path, encoding="utf-8") as file:
        runs = json.load(file)["benchmarks"]
    found = {}
    for run in runs:
        if run.get("error_occurred") or run.get("aggregate_name") != "median":
            continue
        name = run["run_name"].replace("/iterations:1", "")
        answer = [run[key] for key in ("x", "y", "R", "intersection") if key in run]
        found[name] = (run["real_time"] * UNITS[run["time_unit"]] / run.get("each", 1), answer)
    return found


def falls_of(path):
    """By how much χ² falls with each effect, as alidade has it."""
    with open(path, encoding="utf-8") as file:
        runs = json.load(file)["benchmarks"]
    own = next((run for run in runs if run["run_name"] == "W5/alidade"), {})
    return {key: value for key, value in own.items() if key.startswith(FALL)}


def process(*command, repetitions):
    seconds = []
    for _ in range(repetitions):
        begin = time.perf_counter()
        subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
        seconds.append(time.perf_counter() - begin)
    return statistics.median(seconds), []


def words(seconds):
    for unit in ("s", "ms", "us"):
        if seconds >= UNITS[unit]:
            return f"{seconds / UNITS[unit]:.3g} {unit.replace('us', 'µs')}"
    return f"{seconds / 1e-9:.3g} ns"


def cell(found, peer, ours):
    if peer not in found:
        return "-"
    return f"{words(found[peer][0])} (× {found[peer][0] / found[ours][0]:.3g})"


def disagreements(found):
    """The answers beside alidade's."""
    for name, (_, answer) in sorted(found.items()):
        workload = name.split("/")[0]
        own = found.get(f"{workload}/alidade") or found.get(f"{workload}/alidade/1/real_time")
        if not own or own[1] is answer or not answer or not own[1]:
            continue
        apart = max(abs(one - other) for one, other in zip(answer, own[1]))
        yield name, apart, apart <= AGREEMENT


def main():
    timings, scipy, program, session, peer = sys.argv[1:]
    found, falls = benchmarks(timings), {}
    with open(scipy, encoding="utf-8") as file:
        for workload, result in json.load(file).items():
            found[f"{workload}/scipy"] = result["seconds"], result.get("circle", [])
            falls |= result.get("falls", {})
    found["W8/alidade"] = process(program, "fit", session, repetitions=30)
    found["W8/scipy"] = process(sys.executable, peer, "--once", repetitions=5)

    print("| workload | alidade | aim | scipy | Ceres + covariance | Ceres TinySolver |\n|---|---|---|---|---|---|")
    for name, aim, ours, peers in ROWS:
        if ours in found:
            cells = [words(found[ours][0]), f"≤ {words(aim)}" if aim else "-"]
            print("|", " | ".join([name] + cells + [cell(found, peer, ours) for peer in peers]), "|")
    if "W1/Ceres" in found:
        print(f"\nWhere the aims were set Ceres took {words(CERES_THERE)} for W1; here it takes {words(found['W1/Ceres'][0])}.")
    print("\nGreatest difference from alidade's answer (x, y, R or Δd), mm; beyond 1e-6 only where a peer stops early:")
    for name, apart, agrees in disagreements(found):
        print(f"  {name:<26} {apart:.1e}{'' if agrees else '   beyond 1e-6'}")
    own_falls = falls_of(timings)
    if own_falls:
        print("\nBy how much χ² falls with each effect on its own, alidade and scipy's least_squares:")
    for name in sorted(own_falls.keys() & falls.keys()):
        apart = abs(own_falls[name] - falls[name])
        words_apart = "" if apart <= FALLS_AGREE else f"   beyond {FALLS_AGREE}"
        print(f"  {name.removeprefix(FALL):<32} {own_falls[name]:8.4f} {falls[name]:8.4f}{words_apart}")


if __name__ == "__main__":
    main()
