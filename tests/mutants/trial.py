"""Tries one fault after another against the tests."""

import re
from pathlib import PurePosixPath

QUICK = 0.5  # seconds: the tests that take longer are asked last

COMPILED, CAUGHT, SURVIVED, NO_FAULT = "compiled", "caught", "survived", "does not compile"


def suites_in(place, folder):
    """The test suites that the sources of a folder of tests hold, by file."""
    named = {}
    for source in sorted((place / folder).rglob("*_test.cpp")) if (place / folder).is_dir() else []:
        text = source.read_text(encoding="utf-8")
        names = set(re.findall(r"^(?:TEST|TEST_F|TEST_P|TYPED_TEST)\((\w+),", text, re.MULTILINE))
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

    def of(test):
        names = set(test.split(".")[0].split("/"))  # Prefix/Suite of TEST_P, Suite/0 of TYPED_TEST
        return 0 if names & own else 1 if names & of_room else 2

    return of


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
