"""The peer in Python: scipy.odr (ODRPACK) on the readings that alidade_speed wrote.

peer_scipy.py FOLDER     times W1, W3 and W4, and prints one JSON document: name -> seconds, circle
peer_scipy.py --once     nothing but the imports and one fit, to be timed as a process
"""

import json
import statistics
import sys
import time

import numpy as np
from scipy import odr

DISTANCE = 2405.0
SIGMA = np.radians(2 / 3600)
POINTS = 17


def plane(readings):
    a, e = readings
    return DISTANCE * np.tan(a), DISTANCE * np.tan(e) / np.cos(a)


def condition(circle, readings):
    x, y = plane(readings)
    return (x - circle[0]) ** 2 + (y - circle[1]) ** 2 - circle[2] ** 2


def per_circle(circle, readings):
    x, y = plane(readings)
    return -2 * np.vstack([x - circle[0], y - circle[1], np.full_like(x, circle[2])])


def per_reading(circle, readings):
    a, e = readings
    x, y = plane(readings)
    x_a, y_a = DISTANCE / np.cos(a) ** 2, y * np.tan(a)
    y_e = DISTANCE / np.cos(e) ** 2 / np.cos(a)
    return 2 * np.vstack([(x - circle[0]) * x_a + (y - circle[1]) * y_a, (y - circle[1]) * y_e])


MODEL = odr.Model(condition, fjacb=per_circle, fjacd=per_reading, implicit=True)


def fit(readings):
    """An implicit fit with errors in both circles, from Kåsa's circle; with covariance."""
    x, y = plane(readings)
    kasa = np.linalg.lstsq(np.column_stack([2 * x, 2 * y, np.ones_like(x)]), x * x + y * y, rcond=None)[0]
    start = [kasa[0], kasa[1], np.sqrt(kasa[2] + kasa[0] ** 2 + kasa[1] ** 2)]
    job = odr.ODR(odr.Data(readings, 1, wd=1 / SIGMA**2), MODEL, beta0=start)
    job.set_job(fit_type=1, deriv=2)
    return job.run().beta


def timed(work, repetitions):
    seconds = []
    for _ in range(repetitions):
        begin = time.perf_counter()
        circle = work()
        seconds.append(time.perf_counter() - begin)
    return {"seconds": statistics.median(seconds), "circle": list(circle)}


def main():
    if sys.argv[1] == "--once":
        phi = np.radians(np.linspace(30, 150, POINTS))
        x, y = 400 * np.cos(phi), 400 * np.sin(phi)
        fit(np.vstack([np.arctan2(x, DISTANCE), np.arctan2(y, np.hypot(x, DISTANCE))]) + 1e-6 * np.sin(7 * phi))
        return
    short = np.fromfile(f"{sys.argv[1]}/short-arcs").reshape(2, -1, POINTS)
    long = np.fromfile(f"{sys.argv[1]}/long-arc").reshape(2, -1)
    arcs = 500
    many = timed(lambda: np.mean([fit(short[:, i]) for i in range(arcs)], axis=0), 1)
    many["seconds"] /= arcs
    million = timed(lambda: fit(long), 1)
    million["seconds"] /= long.shape[1]
    print(json.dumps({"W1": timed(lambda: fit(short[:, 0]), 200), "W3": many, "W4": million}))


if __name__ == "__main__":
    main()
