#!/usr/bin/env python3
"""Writes the sessions beside this script. Seeded: running it again writes the same files.

Readings of a theodolite (exact relation, or the planar one where the session says so) on a circle, normal noise of the
stated sigma times `noise`, rounded as typed.
"""

import json
import math
import pathlib
import random

HERE = pathlib.Path(__file__).parent


def angle_text(degrees, decimals):
    unit = 10**decimals
    total = round(degrees % 360 * 3600 * unit)
    seconds, fraction = divmod(total, unit)
    text = f"{seconds // 3600 % 360}°{seconds // 60 % 60:02d}'{seconds % 60:02d}"
    return text + (f".{fraction:0{decimals}d}" if decimals else "") + '"'


def spread(count, span, middle):
    return [middle + span * (i / (count - 1) - 0.5) for i in range(count)]


def rows(case, axis, circle, rng):
    distance, elevation = case.get("distance", 2405), case.get("elevation", False)
    sigma_h, sigma_v = case.get("sigma_h", 2), case.get("sigma_v", 2)
    zero_h, zero_v = (12.4275, 90.0008) if not elevation else (347.25, 0.0014)
    x0, y0, radius = circle
    turn = 1 if axis == 0 else -1
    readings = []
    for round_ in range(1, case.get("rounds", 1) + 1):
        for point, degrees in enumerate(spread(case["count"], case["span"], turn * case.get("middle", 90)), 1):
            if (axis, round_, point) in case.get("missing", []):
                continue
            phi = math.radians(degrees)
            x, y = x0 + radius * math.cos(phi), y0 + radius * math.sin(phi)
            a = math.degrees(math.atan2(x, distance))
            e = math.degrees(math.atan2(y, math.hypot(x, distance) if case.get("relation", "exact") == "exact" else distance))
            slider = angle_text(3.25 + turn * degrees + rng.gauss(0, 5) / 3600, 1)
            for face in range(1, case.get("faces", 1) + 1):
                h = zero_h + a + rng.gauss(0, sigma_h) / 3600
                v = zero_v + (e if elevation else -e) + rng.gauss(0, sigma_v) / 3600
                if face == 2:
                    h, v = h + 180, (180 if elevation else 360) - v
                decimals = case.get("decimals", 1)
                reading = {"point": point, "round": round_, "face": face,
                           "horizontal": angle_text(h, decimals), "vertical": angle_text(v, decimals)}
                if case.get("slider") and face == 1 and point % case["slider"] == 0:
                    reading["slider"] = slider
                readings.append(reading)
    decimals = 4
    return {"axis_deg": axis, "pointing_zero": {"horizontal": angle_text(zero_h, decimals), "vertical": angle_text(zero_v, decimals)},
            "readings": readings}


CASES = {
    "seventeen-points": dict(count=17, span=160),
    "seventeen-points-planar": dict(count=17, span=160, relation="planar"),
    "five-points": dict(count=5, span=120),
    "twenty-degrees": dict(count=17, span=20),
    "half-circle": dict(count=25, span=180),
    "near": dict(count=17, span=140, distance=700),
    "far": dict(count=17, span=160, distance=20000),
    "near-planar": dict(count=17, span=140, distance=900, relation="planar"),
    "unequal-sigma": dict(count=17, span=150, sigma_h=1, sigma_v=6),
    "noise-20-seconds": dict(count=17, span=160, sigma_h=20, sigma_v=20),
    "noise-tenth-second": dict(count=17, span=160, sigma_h=0.1, sigma_v=0.1, decimals=3),
    "one-position": dict(count=9, span=130, rounds=2, missing=[(0, 1, 4), (0, 2, 9)], elevation=True, axes=[0]),
    "two-faces": dict(count=17, span=160, faces=2),
    "two-faces-sliders": dict(count=17, span=160, faces=2, rounds=2, slider=1, sigma_v=3),
    "some-sliders": dict(count=13, span=70, slider=3, missing=[(180, 1, 2)]),
}


def session(name, case):
    rng = random.Random(name)
    circles = {0: (0.4 + rng.uniform(-2, 2), rng.uniform(-2, 2), 400 + rng.uniform(-2, 2)),
               180: (0.4 + rng.uniform(-2, 2), rng.uniform(-2, 2), 400 + rng.uniform(-2, 2))}
    return {
        "format": "alidade-session", "version": 1, "title": name,
        "instrument": {"sigma_horizontal_arcsec": case.get("sigma_h", 2), "sigma_vertical_arcsec": case.get("sigma_v", 2),
                       "sigma_zero_arcsec": 0, "sigma_slider_arcsec": 5},
        "geometry": {"distance_mm": case.get("distance", 2405), "radius_mm": 400,
                     "vertical_circle": "elevation" if case.get("elevation") else "zenith"},
        "model": {"vertical_angle": case.get("relation", "exact")},
        "positions": [rows(case, axis, circles[axis], rng) for axis in case.get("axes", [0, 180])],
    }


def text_of(document):
    """One line for each reading."""
    head = {key: value for key, value in document.items() if key != "positions"}
    lines = json.dumps(head, ensure_ascii=False, indent=1)[:-2] + ',\n "positions": [\n'
    positions = []
    for position in document["positions"]:
        readings = ",\n    ".join(json.dumps(reading, ensure_ascii=False) for reading in position["readings"])
        zero = json.dumps(position["pointing_zero"], ensure_ascii=False)
        positions.append(f'  {{"axis_deg": {position["axis_deg"]}, "pointing_zero": {zero}, "readings": [\n    {readings}\n  ]}}')
    return lines + ",\n".join(positions) + "\n ]\n}\n"


if __name__ == "__main__":
    for name, case in CASES.items():
        (HERE / f"{name}.alidade").write_text(text_of(session(name, case)), encoding="utf-8")
