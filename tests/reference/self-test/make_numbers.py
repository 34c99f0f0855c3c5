#!/usr/bin/env python3
"""The numbers that the self-test compares with, at 50 digits (python3-mpmath), from their definitions alone."""

import hashlib
import json
import re

from mpmath import atan2, betainc, cos, erf, erfinv, findroot, floor, gammainc, inf, mp, mpf, nstr, pi, sin, sqrt

mp.dps = 50
SECOND = pi / 648000
MASK = 2**64 - 1


def digits(value):
    return nstr(value, 30, strip_zeros=False)


# --- Distributions -------------------------------------------------------------------------------------------------


def within(t, f):
    """Probability that |Student's t| < t, f degrees of freedom; f = inf: normal."""
    if f == inf:
        return erf(t / sqrt(2))
    x = mpf(f) / (f + t * t)
    return 1 - betainc(mpf(f) / 2, mpf(1) / 2, 0, x, regularized=True)


def coverage_factor(coverage, f):
    start = sqrt(2) * erfinv(coverage)
    if f == inf:
        return start
    low, high = start, start
    while within(high, f) < coverage:
        high *= 2
    return findroot(lambda t: within(t, f) - coverage, (low, high), solver="anderson", tol=mpf(10) ** -40)


def chi_square_tail(x, f):
    return gammainc(mpf(f) / 2, mpf(x) / 2, inf, regularized=True)


def f_tail(ratio, m, n):
    """P(F > ratio) of m and n degrees of freedom."""
    return betainc(mpf(n) / 2, mpf(m) / 2, 0, mpf(n) / (n + m * mpf(ratio)), regularized=True)


def distributions():
    rows = []
    for coverage, f in (("0.95", 1), ("0.95", 10), ("0.95", 28), ("0.99", 5), ("0.9973", 28), ("0.95", inf)):
        rows.append({"function": "t", "arguments": [coverage, "infinite" if f == inf else str(f)],
                     "value": digits(coverage_factor(mpf(coverage), f))})
    for x, f in (("3.84", 1), ("28", 28), ("41.3", 28), ("747.0698868", 28), ("1020", 1000)):
        rows.append({"function": "chi2", "arguments": [x, str(f)], "value": digits(chi_square_tail(x, f))})
    for ratio, m, n in (("1.75", 32, 32), ("4.2", 2, 28), ("0.8", 5, 7), ("26.7", 28, 28)):
        rows.append({"function": "F", "arguments": [ratio, str(m), str(n)], "value": digits(f_tail(ratio, m, n))})
    for p in ("0.975", "0.001", "1e-12"):
        rows.append({"function": "z", "arguments": [p], "value": digits(sqrt(2) * erfinv(2 * mpf(p) - 1))})
    return rows


# --- Angles --------------------------------------------------------------------------------------------------------


def angles():
    parts = {
        "341°52'24\"": (mpf(341) + mpf(52) / 60 + mpf(24) / 3600),
        "88°16'49.35\"": (mpf(88) + mpf(16) / 60 + mpf("49.35") / 3600),
        "341-52-24.5": (mpf(341) + mpf(52) / 60 + mpf("24.5") / 3600),
        "3415224": (mpf(341) + mpf(52) / 60 + mpf(24) / 3600),
        "-0°00'01\"": -mpf(1) / 3600,
        "341.873333°": mpf("341.873333"),
        "379.859gon": mpf("379.859") * 9 / 10,
        "100.0001g": mpf("100.0001") * 9 / 10,
    }
    return [{"text": text, "radians": digits(degrees * pi / 180), "arcseconds": digits(degrees * 3600)}
            for text, degrees in parts.items()]


# --- Random numbers ------------------------------------------------------------------------------------------------


class Xoshiro:
    """xoshiro256++ (Blackman, Vigna 2021); its state by SplitMix64 from the seed and the scattered stream."""

    def __init__(self, seed, stream=0):
        _, scattered = self.split_mix(stream)
        state = scattered ^ seed
        self.s = []
        for _ in range(4):
            state, value = self.split_mix(state)
            self.s.append(value)

    @staticmethod
    def split_mix(state):
        state = (state + 0x9E3779B97F4A7C15) & MASK
        z = state
        z = ((z ^ (z >> 30)) * 0xBF58476D1CE4E5B9) & MASK
        z = ((z ^ (z >> 27)) * 0x94D049BB133111EB) & MASK
        return state, z ^ (z >> 31)

    def bits(self):
        def rotl(x, k):
            return ((x << k) | (x >> (64 - k))) & MASK

        s = self.s
        result = (rotl((s[0] + s[3]) & MASK, 23) + s[0]) & MASK
        shifted = (s[1] << 17) & MASK
        s[2] ^= s[0]
        s[3] ^= s[1]
        s[1] ^= s[2]
        s[0] ^= s[3]
        s[2] ^= shifted
        s[3] = rotl(s[3], 45)
        return result

    def uniform(self):
        return (mpf(self.bits() >> 11) + mpf(1) / 2) / 2**53

    def normal(self):
        return sqrt(2) * erfinv(2 * self.uniform() - 1)


def random_numbers():
    rows = []
    for seed, stream in ((42, 7), (1, 0), (20261125, 3)):
        bits, normal = Xoshiro(seed, stream), Xoshiro(seed, stream)
        rows.append({"seed": seed, "stream": stream, "bits": ["%016x" % bits.bits() for _ in range(4)],
                     "normal": [digits(normal.normal()) for _ in range(4)]})
    return rows


# --- A simulated session -------------------------------------------------------------------------------------------


def typed(seconds_of_arc):
    """To 0.1″, on the circle."""
    tenths = int(floor(seconds_of_arc * 10 + mpf(1) / 2)) % 12960000
    degrees, rest = divmod(tenths, 36000)
    minutes, rest = divmod(rest, 600)
    return "%d°%02d'%02d.%d\"" % (degrees, minutes, rest // 10, rest % 10)


def simulated():
    truth = {"seed": 20261125, "distance": "2405", "radius": "400.02", "centre_x": "-0.75", "axis_height": "1.25",
             "intersection": "0.35", "horizontal_zero": "332.5", "points": 17}
    distance, radius = mpf(truth["distance"]), mpf(truth["radius"])
    random = Xoshiro(truth["seed"])
    random.normal()  # the error of the distance, which is 0 here
    lines = []
    for axis, turn in ((0, 1), (180, -1)):
        y = mpf(truth["axis_height"]) + turn * mpf(truth["intersection"])
        zero = mpf(truth["horizontal_zero"]) * 3600
        horizontal = zero + 2 * random.normal()
        vertical = 90 * 3600 + 2 * random.normal()
        lines.append("%d zero %s %s" % (axis, typed(horizontal), typed(vertical)))
        for point in range(1, truth["points"] + 1):
            place = 10 * point * pi / 180 + 60 * SECOND * random.normal()
            random.normal()  # of the slider, which is not read
            px = mpf(truth["centre_x"]) + radius * cos(turn * place)
            py = y + radius * sin(turn * place)
            a, e = atan2(px, distance), atan2(py, sqrt(px**2 + distance**2))
            horizontal = zero + a / SECOND + 2 * random.normal()
            vertical = 90 * 3600 - e / SECOND + 2 * random.normal()
            lines.append("%d %d %s %s" % (axis, point, typed(horizontal), typed(vertical)))
    return {"truth": truth, "first": lines[1], "last": lines[-1],
            "sha256": hashlib.sha256(("\n".join(lines) + "\n").encode("utf-8")).hexdigest()}


def main():
    assert re.fullmatch(r"[0-9a-f]{16}", "%016x" % Xoshiro(42, 7).bits())
    print(json.dumps({"distributions": distributions(), "angles": angles(), "random": random_numbers(),
                      "simulated": simulated()}, indent=1, ensure_ascii=False))


if __name__ == "__main__":
    main()
