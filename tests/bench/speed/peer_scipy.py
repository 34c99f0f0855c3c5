"""The peer in Python: scipy.odr (ODRPACK), for W5 least_squares, on the readings that alidade_speed wrote.

peer_scipy.py FOLDER     times W1, W3, W4 and W5, and prints one JSON document: name -> seconds, circle; of W5 by how
                         much χ² falls with each effect
peer_scipy.py --once     nothing but the imports and one fit, to be timed as a process
"""

import json
import statistics
import sys
import time

import numpy as np
from scipy import odr, optimize

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


# W5: each effect is fitted along with both arcs, its numbers in arcseconds or mm. The formulas are those of textbooks,
# to first order; s = ±phi, `side` is 1 at 0° and -1 at 180°, t runs from 0 to 1 over the session.
ARCSECOND = np.radians(1 / 3600)
ON_TARGET = {  # what is added to radius, height and depth of the target, by the numbers p
    "plane_offset": (1, lambda p, s, side: (0, 0, side * p[0])),
    "arc_ellipticity": (2, lambda p, s, side: (p[0] * np.cos(2 * s) + p[1] * np.sin(2 * s), 0, 0)),
    "arc_lobing": (2, lambda p, s, side: (p[0] * np.cos(3 * s) + p[1] * np.sin(3 * s), 0, 0)),
    "gravity_sag": (1, lambda p, s, side: (0, -p[0] * np.sin(s), 0)),
    "plane_warp": (2, lambda p, s, side: (0, 0, side * (p[0] * np.cos(2 * s) + p[1] * np.sin(2 * s)))),
}
ON_READINGS = {  # what is added to a and e, in arcseconds
    "collimation": (1, lambda p, a, e, t: (p[0] * (1 / np.cos(e) - 1), 0)),
    "trunnion_tilt": (1, lambda p, a, e, t: (p[0] * np.tan(e), 0)),
    "horizontal_circle_eccentricity": (2, lambda p, a, e, t: (p[0] * np.sin(a) + p[1] * (np.cos(a) - 1), 0)),
    "vertical_circle_eccentricity": (2, lambda p, a, e, t: (0, p[0] * np.sin(e) + p[1] * (np.cos(e) - 1))),
    "horizontal_drift": (1, lambda p, a, e, t: (p[0] * (t - 0.5), 0)),
    "vertical_drift": (1, lambda p, a, e, t: (0, p[0] * (t - 0.5))),
}


def misfits(unknowns, readings, effect):
    """Of both arcs: unknowns x, y, R of each, the arc angles in degrees, the numbers of the effect."""
    a, e = readings
    count = a.size
    circles = unknowns[:6].reshape(2, 3).repeat(count // 2, axis=0)
    phi, numbers = np.radians(unknowns[6 : 6 + count]), unknowns[6 + count :]
    side = np.repeat([1, -1], count // 2)
    radius, height, depth = ON_TARGET[effect][1](numbers, side * phi, side) if effect in ON_TARGET else (0, 0, 0)
    x = circles[:, 0] + (circles[:, 2] + radius) * np.cos(phi)
    y = circles[:, 1] + (circles[:, 2] + radius) * np.sin(phi) + height
    far = DISTANCE - depth
    seen_a, seen_e = np.arctan2(x, far), np.arctan2(y, np.hypot(x, far))
    more_a, more_e = 0, 0
    if effect in ON_READINGS:
        more_a, more_e = ON_READINGS[effect][1](numbers, seen_a, seen_e, np.linspace(0, 1, count))
    return np.concatenate([a - seen_a - more_a * ARCSECOND, e - seen_e - more_e * ARCSECOND]) / SIGMA


def slopes_of_misfits(unknowns, readings, effect):
    """By differences; what belongs to different arcs or points is moved at once."""
    count = readings.shape[1]
    step, point = 1e-5, np.tile(np.arange(count), 2)
    arc, first = point // (count // 2), misfits(unknowns, readings, effect)
    columns = np.zeros((2 * count, unknowns.size))
    rows = np.arange(2 * count)

    def slope(moved):
        shifted = unknowns.copy()
        shifted[moved] += step
        return (misfits(shifted, readings, effect) - first) / step

    for kind in range(3):
        columns[rows, 3 * arc + kind] = slope([kind, 3 + kind])
    columns[rows, 6 + point] = slope(np.arange(6, 6 + count))
    for number in range(6 + count, unknowns.size):
        columns[:, number] = slope(number)
    return columns


def least_chi_square(readings, start, effect=None):
    count = {**ON_TARGET, **ON_READINGS}[effect][0] if effect else 0
    found = optimize.least_squares(
        misfits,
        np.append(start, np.zeros(count)),
        jac=slopes_of_misfits,
        args=(readings, effect),
        method="lm",
        x_scale="jac",
        xtol=1e-10,
    )
    return 2 * found.cost, found.x


def effects_of_catalogue(readings):
    """Seconds for as many effects as the catalogue has, 17, and the falls of χ²."""
    a, e = readings
    circles = [fit(readings[:, :POINTS]), fit(readings[:, POINTS:])]
    x, y = DISTANCE * np.tan(a), DISTANCE * np.tan(e) / np.cos(a)
    angles = [
        np.degrees(np.arctan2(y[part] - circle[1], x[part] - circle[0]))
        for part, circle in zip((slice(POINTS), slice(POINTS, None)), circles)
    ]
    before, start = least_chi_square(readings, np.concatenate([*circles, *angles]))
    names = [*ON_TARGET, *ON_READINGS]
    begin = time.perf_counter()
    falls = {f"fall by {name}": before - least_chi_square(readings, start, name)[0] for name in names}
    return {"seconds": (time.perf_counter() - begin) * 17 / len(names), "falls": falls}


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
    effects = effects_of_catalogue(short[:, :2].reshape(2, -1))
    print(json.dumps({"W1": timed(lambda: fit(short[:, 0]), 200), "W3": many, "W4": million, "W5": effects}))


if __name__ == "__main__":
    main()
