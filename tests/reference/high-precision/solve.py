#!/usr/bin/env python3
"""Solves every session beside this script, and Table I, at 60 digits and writes results.json (python3-mpmath).

Independent of the program's formulation: centre, radius, slider zero and every arc angle are unknowns of one Newton
iteration on the full gradient of

    chi^2 = sum ((a - a(P(phi)))/sigma_h)^2 + ((e - e(P(phi)))/sigma_v)^2 + ((s - s0 - s(phi))/sigma_s)^2,

with P(phi) = (x + R cos phi, y + L tan e0 + R sin phi, -L): vertical angles count from the plumb line, y from the pointing
zero, which is inclined by e0. Its Hessian is taken by differences at 60 digits. Nothing is eliminated, linearised or rounded on the way. Covariances
are those of the linearised problem at the minimum from the stated sigma, (J^T W J)^-1 over all unknowns.
"""

import json
import pathlib
import re

from mpmath import atan2, cos, inverse, lu_solve, matrix, mp, mpf, nstr, pi, sin, sqrt, tan

HERE = pathlib.Path(__file__).parent
mp.dps = 60
STEP = mpf(10) ** -22  # of the differences: central, so good to some 40 digits
SECOND = pi / 180 / 3600


def angle(text):
    degrees, minutes, seconds = re.fullmatch(r"(\d+)°(\d+)'([\d.]+)\"", text).groups()
    return (mpf(degrees) + mpf(minutes) / 60 + mpf(seconds) / 3600) * pi / 180


def wrapped(value):
    while value >= pi:
        value -= 2 * pi
    while value < -pi:
        value += 2 * pi
    return value


class Visit:
    """Everything read while the slider stood at one place."""

    def __init__(self, model, turn):
        self.model, self.turn = model, turn
        self.readings, self.slider = [], None

    def terms(self, x, y, radius, zero, phi):
        """(observed - computed)/sigma of every reading."""
        distance = self.model["distance"]
        px, py = x + radius * cos(phi), y + distance * tan(self.model["e0"]) + radius * sin(phi)
        a = atan2(px, distance)
        e = atan2(py, sqrt(px**2 + distance**2) if self.model["exact"] else distance)
        for read_a, read_e in self.readings:
            yield (read_a - a) / self.model["sigma_h"]
            yield (read_e - e) / self.model["sigma_v"]
        if self.slider is not None:
            yield wrapped(self.slider - zero - self.turn * phi) / self.model["sigma_s"]

    def jacobian(self, unknowns):
        columns = []
        for i in range(5):
            ahead, behind = list(unknowns), list(unknowns)
            ahead[i] += STEP
            behind[i] -= STEP
            columns.append([(p - q) / (2 * STEP) for p, q in zip(self.terms(*ahead), self.terms(*behind))])
        return columns

    def gradient(self, unknowns):
        values = list(self.terms(*unknowns))
        return [sum(d * v for d, v in zip(column, values)) for column in self.jacobian(unknowns)]


def visits_of(document, position, relation):
    instrument, geometry = document["instrument"], document["geometry"]
    model = {"distance": mpf(geometry["distance_mm"]), "exact": relation == "exact",
             "sigma_h": mpf(str(instrument["sigma_horizontal_arcsec"])) * SECOND,
             "sigma_v": mpf(str(instrument["sigma_vertical_arcsec"])) * SECOND,
             "sigma_s": mpf(str(instrument.get("sigma_slider_arcsec", 5))) * SECOND}
    zenith = geometry.get("vertical_circle", "zenith") == "zenith"
    zero_h, zero_v = angle(position["pointing_zero"]["horizontal"]), angle(position["pointing_zero"]["vertical"])
    horizon = pi / 2 if zenith else mpf(0)
    model["e0"] = wrapped(horizon - zero_v if zenith else zero_v)
    visits = {}
    for reading in position["readings"]:
        key = (reading.get("round", 1), reading["point"])
        visit = visits.setdefault(key, Visit(model, 1 if position["axis_deg"] == 0 else -1))
        h, v = angle(reading["horizontal"]), angle(reading["vertical"])
        if reading.get("face", 1) == 2:
            h, v = h - pi, (2 * pi if zenith else pi) - v
        visit.readings.append((wrapped(h - zero_h), wrapped(horizon - v if zenith else v)))
        if "slider" in reading and visit.slider is None:
            visit.slider = angle(reading["slider"])
    return list(visits.values())


def solve(visits):
    """Newton's iteration on the whole gradient: x, y, R, slider zero if there is one, then an arc angle for each visit."""
    with_slider = any(visit.slider is not None for visit in visits)
    common = 4 if with_slider else 3
    size = common + len(visits)
    distance = visits[0].model["distance"]
    unknowns = [mpf(0), mpf(0), mpf(400)] + ([mpf(0)] if with_slider else [])
    for visit in visits:
        a, e = visit.readings[0]
        unknowns.append(atan2(distance * (tan(e) - tan(visits[0].model["e0"])), distance * tan(a)))
    if with_slider:
        unknowns[3] = next(wrapped(v.slider - v.turn * phi) for v, phi in zip(visits, unknowns[4:]) if v.slider is not None)

    def of_visit(i):
        return unknowns[:3] + [unknowns[3] if with_slider else mpf(0), unknowns[common + i]]

    def places(i):
        return [0, 1, 2, 3 if with_slider else None, common + i]

    for iteration in range(40):
        gradient, hessian = matrix(size, 1), matrix(size, size)
        for i, visit in enumerate(visits):
            # Gauss-Newton far out, where the true Hessian may not be positive; Newton at the end.
            at, here = places(i), of_visit(i)
            columns, values = visit.jacobian(here), list(visit.terms(*here))
            for p in range(5):
                if at[p] is None:
                    continue
                gradient[at[p]] += sum(d * v for d, v in zip(columns[p], values))
                if iteration >= 5:
                    ahead, behind = list(here), list(here)
                    ahead[p] += STEP
                    behind[p] -= STEP
                    row = [(g - f) / (2 * STEP) for g, f in zip(visit.gradient(ahead), visit.gradient(behind))]
                else:
                    row = [sum(d * f for d, f in zip(columns[p], columns[q])) for q in range(5)]
                for q in range(5):
                    if at[q] is not None:
                        hessian[at[p], at[q]] += row[q]
        step = lu_solve(hessian, gradient)
        unknowns = [u - s for u, s in zip(unknowns, step)]
        if iteration > 5 and max(abs(s) for s in step) < mpf(10) ** -36:
            break
    else:
        raise RuntimeError("no convergence")

    normal, chi_square = matrix(size, size), mpf(0)
    for i, visit in enumerate(visits):
        columns, at = visit.jacobian(of_visit(i)), places(i)
        chi_square += sum(v**2 for v in visit.terms(*of_visit(i)))
        for p in range(5):
            for q in range(5):
                if at[p] is not None and at[q] is not None:
                    normal[at[p], at[q]] += sum(d * f for d, f in zip(columns[p], columns[q]))
    return unknowns[:3], inverse(normal), chi_square


def digits(value):
    return nstr(value, 32, strip_zeros=False)


def result_of(name, path, relation):
    document = json.loads((HERE / path).read_text(encoding="utf-8"))
    result, heights = {"name": name, "session": path, "relation": relation, "arcs": []}, {}
    for position in document["positions"]:
        (x, y, radius), covariance, chi_square = solve(visits_of(document, position, relation))
        heights[position["axis_deg"]] = (y, covariance[1, 1])
        sigmas = [sqrt(covariance[i, i]) for i in range(3)]
        result["arcs"].append({"axis_deg": position["axis_deg"], "x": digits(x), "y": digits(y), "radius": digits(radius),
                               "sigma_x": digits(sigmas[0]), "sigma_y": digits(sigmas[1]), "sigma_radius": digits(sigmas[2]),
                               "chi_square": digits(chi_square)})
    if len(heights) == 2:
        result["intersection"] = digits((heights[0][0] - heights[180][0]) / 2)
        result["sigma_intersection"] = digits(sqrt(heights[0][1] + heights[180][1]) / 2)
    return result


def main():
    table = "../../../samples/paper-table-1.alidade"
    results = [result_of("table-1", table, "exact"), result_of("table-1-planar", table, "planar")]
    for path in sorted(HERE.glob("*.alidade")):
        relation = json.loads(path.read_text(encoding="utf-8"))["model"]["vertical_angle"]
        results.append(result_of(path.stem, path.name, relation))
        print(path.stem, flush=True)
    (HERE / "results.json").write_text(json.dumps(results, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
