"""All small faults that the rules know of, and a draw of them."""

import hashlib
import random
import re
from pathlib import Path
from typing import NamedTuple

from code import lines_of_code, masked
from rules import ORIGINAL, RULES

TOPS = ("core", "ui")
SUFFIXES = (".cpp", ".h")

# What is only looks is looked at and not tested.
LOOKS = re.compile(r"""set(?:Contents)?Margins?\(|set\w*(?:Spacing|Stretch|Alignment|Width|Height|Size|SizePolicy|Pen|Brush
    |Color|Font|Opacity|Indent|WordWrap|FrameShape|FrameStyle|Icon|IconSize|ResizeMode)\(|addStretch|addSpacing|resize\(
    |\bQ(?:Pen|Color|Brush|Margins|MarginsF)\b|\w*[mM]argin\w*|\w*[pP]adding\w*|\bPen\b""", re.VERBOSE)


class Fault(NamedTuple):
    path: str
    rule: str
    start: int
    end: int
    old: str
    new: str
    line: int
    shown: str  # the line with the fault in it
    id: str

    @property
    def room(self):
        return self.path.rsplit("/", 1)[0]

    def put_into(self, text):
        return text[: self.start] + self.new + text[self.end :]

    def __str__(self):
        return f"{self.id} {self.path}:{self.line} {self.rule}: {one_line(self.old)} → {one_line(self.new)}"


def one_line(text):
    text = " ".join(text.split())
    return text if len(text) <= 70 else text[:67] + "…"


def _fault(path, rule, text, change, times):
    old = text[change.start : change.end]
    new = change.new.replace(ORIGINAL, old)
    first = text.rfind("\n", 0, change.start) + 1
    last = text.find("\n", change.end)
    own_line = text[first:last].strip()
    column = change.start - first - (len(text[first:last]) - len(text[first:last].lstrip()))
    # Of the line's own text, so that it outlives edits elsewhere in the file.
    key = (path, rule, own_line, column, new)
    times[key] = times.get(key, 0) + 1
    digest = hashlib.sha256(repr((*key, times[key])).encode()).hexdigest()[:12]
    line = text.count("\n", 0, change.start) + 1
    shown = one_line(text[first : change.start] + new + text[change.end : last])
    return Fault(path, rule, change.start, change.end, old, new, line, shown, digest)


def _is_looks(code, change):
    first = max(code.rfind(mark, 0, change.start) for mark in ";{}") + 1
    last = min((at for at in (code.find(mark, change.end) for mark in ";{}") if at >= 0), default=len(code))
    return LOOKS.search(code, first, last) is not None


def faults_of(path, text):
    code = masked(text)
    times = {}
    changes = ((rule, change) for rule in RULES for change in rule(code))
    return [_fault(path, rule.__name__, text, change, times) for rule, change in changes
            if not (path.startswith("ui/") and _is_looks(code, change))]


def sources(root):
    return sorted(p for top in TOPS for p in (Path(root) / top).rglob("*") if p.suffix in SUFFIXES)


def rooms(root):
    """Of each room its lines of code and all its faults."""
    found = {}
    for source in sources(root):
        path = source.relative_to(root).as_posix()
        text = source.read_text(encoding="utf-8")
        lines, faults = found.setdefault(path.rsplit("/", 1)[0], [0, []])
        found[path.rsplit("/", 1)[0]][0] = lines + lines_of_code(text)
        faults += faults_of(path, text)
    return {room: (lines, faults) for room, (lines, faults) in found.items() if faults}


def shares(sizes, count):
    """`count` divided in proportion to the sizes, by largest remainders."""
    total = sum(sizes.values())
    exact = {name: count * size / total for name, size in sizes.items()}
    whole = {name: int(value) for name, value in exact.items()}
    by_rest = sorted(exact, key=lambda name: (whole[name] - exact[name], name))
    for name in by_rest[: count - sum(whole.values())]:
        whole[name] += 1
    return whole


def shuffled(faults, seed, room):
    """Every rule as often as any other as long as it has places left; within a rule every place alike."""
    rng = random.Random(f"{seed} {room}")
    by_rule = {}
    for fault in faults:
        by_rule.setdefault(fault.rule, []).append(fault)
    for own in by_rule.values():
        rng.shuffle(own)
    order = []
    while by_rule:
        rule = rng.choice(sorted(by_rule))
        order.append(by_rule[rule].pop())
        if not by_rule[rule]:
            del by_rule[rule]
    return order


def draw(found, count, seed, only_rooms=None, known=()):
    """Of what `rooms` found `count` lists: a fault and those to take in its place should it not compile, the same for the same
    sources and seed. Faults in `known` are equivalent to no fault and are not drawn."""
    found = {room: value for room, value in found.items() if not only_rooms or room in only_rooms}
    if not found:
        return []
    quota = shares({room: lines for room, (lines, _) in found.items()}, count)
    drawn = []
    for room, (_, faults) in found.items():
        if quota[room]:
            order = [fault for fault in shuffled(faults, seed, room) if fault.id not in known]
            drawn += [order[i :: quota[room]] for i in range(quota[room])]
    return [faults for faults in drawn if faults]
