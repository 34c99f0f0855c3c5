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


def branch(circle, a):
    """The point of the upper half of the circle that is sighted at a: x, y, and x and y from the centre."""
    x = DISTANCE * np.tan(a)
    across = x - circle[0]
    up = np.sqrt(np.maximum(circle[2] ** 2 - across**2, 1e-9))
    return x, circle[1] + up, across, up


def elevation(circle, a):
    x, y, _, _ = branch(circle, a)
    return np.arctan(y / np.hypot(x, DISTANCE))


def slopes(circle, a):
    """Of the elevation, by x at a given y and by y; and the point."""
    x, y, across, up = branch(circle, a)
    ground = np.hypot(x, DISTANCE)
    slant = ground**2 + y**2
    return -y * x / (ground * slant), ground / slant, across, up, x


def per_circle(circle, a):
    _, by_y, across, up, _ = slopes(circle, a)
    return by_y * np.vstack([across / up, np.ones_like(a), circle[2] / up])


def per_reading(circle, a):
    by_x, by_y, across, up, x = slopes(circle, a)
    return (by_x - by_y * across / up) * (DISTANCE + x * x / DISTANCE)


MODEL = odr.Model(elevation, fjacb=per_circle, fjacd=per_reading)


def fit(readings):
    """Errors in both circles; e as a function of a, from Kåsa's circle; with covariance."""
    a, e = readings
    x, y = DISTANCE * np.tan(a), DISTANCE * np.tan(e) / np.cos(a)
    kasa = np.linalg.lstsq(np.column_stack([2 * x, 2 * y, np.ones_like(x)]), x * x + y * y, rcond=None)[0]
    start = [kasa[0], kasa[1], np.sqrt(kasa[2] + kasa[0] ** 2 + kasa[1] ** 2)]
    job = odr.ODR(odr.Data(a, e, wd=1 / SIGMA**2, we=1 / SIGMA**2), MODEL, beta0=start)
    job.set_job(fit_type=0, deriv=3)  # derivatives given and not checked again
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
