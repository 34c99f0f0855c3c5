"""Tries one fault after another against the tests."""

import re
from pathlib import PurePosixPath

QUICK = 0.5  # seconds: the tests that take longer are asked last

COMPILED, CAUGHT, SURVIVED, NO_FAULT = "compiled", "caught", "survived", "does not compile"


def suites_in(place, folder):
    """The test suites that the sources of a folder of tests hold, by file."""
    named = {}
    for source in sorted((place / folder).rglob("*_test.cpp")) if (place / folder).is_dir() else []:
        names = set(re.findall(r"^(?:TEST|TEST_F|TEST_P)\((\w+),", source.read_text(encoding="utf-8"), re.MULTILINE))
        named[source.relative_to(place / "tests").as_posix()] = names
    return named


def nearness(fault, place):
    """How near a test suite is to a fault: 0 for those of its own file, 1 for those of its room."""
    room, stem = PurePosixPath(fault.path).parent, PurePosixPath(fault.path).stem
    own, of_room = set(), set()
    for path, names in suites_in(place, f"tests/{room}").items():
        of_room |= names
        if PurePosixPath(path).name.startswith(stem):
            own |= names
    return lambda test: 0 if test.split(".")[0] in own else 1 if test.split(".")[0] in of_room else 2


def stages(fault, scratch):
    """Suites with some of their tests each: the nearest first, of these the quick ones first."""
    near = nearness(fault, scratch.place)
    top = fault.path.split("/")[0]
    order = sorted(scratch.suites, key=lambda suite: suite.name != top)
    if top == "ui":  # the window knows the core, not the other way round
        order = [suite for suite in order if suite.name == "ui"]
    for suite in order:
        groups = {}
        for test, seconds in suite.seconds.items():
            groups.setdefault((near(test), seconds > QUICK), []).append(test)
        for key in sorted(groups):
            yield suite, groups[key]


def judge(fault, scratch):
    """(COMPILED or what became of it, by what)."""
    built = set()
    for suite, tests in stages(fault, scratch):
        if suite.target not in built:
            outcome = scratch.build(suite.target)
            if not outcome.ok:
                return NO_FAULT, outcome.output
            built.add(suite.target)
        outcome = scratch.run(suite, tests)
        if not outcome.ok:
            return CAUGHT, outcome.why
    return SURVIVED, ""


def try_fault(fault, scratch):
    sound = scratch.put_in(fault)
    try:
        return judge(fault, scratch)
    finally:
        scratch.take_out(fault, sound)


def first_that_compiles(faults, scratch):
    """The first of the list that compiles, what became of it and by what; None where none does."""
    for fault in faults:
        outcome, by = try_fault(fault, scratch)
        if outcome != NO_FAULT:
            return fault, outcome, by
    return None
