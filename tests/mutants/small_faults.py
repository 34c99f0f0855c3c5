"""Puts small faults into the program and prints those that no test notices."""

import argparse
import hashlib
import os
import queue
import shutil
import sys
import threading
from pathlib import Path

from fault import Fault, draw, one_line, rooms, sources
from scratch import Scratch, Suite, call, copy_tree
from trial import CAUGHT, SURVIVED, first_that_compiles

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
LOCK = threading.Lock()


def say(text):
    with LOCK:
        print(text, flush=True)


def options():
    parser = argparse.ArgumentParser(prog="run.sh", description=__doc__, epilog=(
        "Faults are drawn by rule, spread over the rooms of core and ui by their lines of code, and are the same "
        "for the same sources and seed. Each is built in a copy of the tree below build/mutants and put before the "
        "tests: those of its file, its room, its program, and the rest. Exit code 1 where one survives."))
    parser.add_argument("--count", type=int, default=100, help="how many faults (100)")
    parser.add_argument("--seed", type=int, default=1, help="of the draw (1)")
    parser.add_argument("--room", action="append", metavar="FOLDER", help="only of this room, as core/base; repeatable")
    parser.add_argument("--only", action="append", metavar="ID", help="this fault alone; repeatable")
    parser.add_argument("--survived", action="store_true", help="the faults of once_survived.txt")
    parser.add_argument("--list", action="store_true", help="print the faults and try none")
    parser.add_argument("--programs", default="core,console,ui", help="test programs to ask (core,console,ui)")
    parser.add_argument("--jobs", type=int, default=1, help="copies of the tree worked on side by side (1)")
    return parser.parse_args()


def records(name):
    """The lines of a list beside this script, but comments and blanks, split at tabs."""
    lines = (HERE / name).read_text(encoding="utf-8").splitlines()
    return [line.split("\t") for line in lines if line.strip() and not line.startswith("#")]


def once_survived():
    """Lists of one fault each; a fault whose text is not there any more is said and left out."""
    for path, old, new in records("once_survived.txt"):
        text = (ROOT / path).read_text(encoding="utf-8")
        if text.count(old) != 1:
            say(f"{path}: “{old}” stands there {text.count(old)} times, not once: mend the list")
            continue
        start = text.index(old)
        shown = one_line(f"{old} → {new}")
        digest = hashlib.sha256(repr((path, old, new)).encode()).hexdigest()[:12]
        yield [Fault(path, "survived once", start, start + len(old), old, new, text.count("\n", 0, start) + 1, shown,
                     digest)]


def chosen(args):
    if args.survived:
        return list(once_survived())
    if args.only:
        wanted = set(args.only)
        found = [[f] for _, faults in rooms(ROOT).values() for f in faults if f.id in wanted]
        missing = wanted - {faults[0].id for faults in found}
        if missing:
            sys.exit(f"run.sh: no fault has the id {', '.join(sorted(missing))}; --list prints ids")
        return found
    known = {record[0].split()[0] for record in records("equivalent.txt")}
    drawn = draw(rooms(ROOT), args.count, args.seed, args.room, known)
    if not drawn:
        sys.exit("run.sh: that room holds no code; rooms are folders such as core/base")
    return drawn


def state_of_tree():
    """Changes with any source or test."""
    digest = hashlib.sha256()
    files = [p for p in (*(ROOT / "tests").rglob("*"), *(ROOT / "app").rglob("*")) if p.suffix in (".cpp", ".h")]
    for path in sorted(files) + sources(ROOT):
        digest.update(path.relative_to(ROOT).as_posix().encode() + path.read_bytes())
    return digest.hexdigest()[:12]


def prepared(number, programs):
    """A copy of the tree, built without a fault, whose tests are timed; on the same sources only once."""
    place = ROOT / "build" / "mutants" / str(number)
    place.mkdir(parents=True, exist_ok=True)
    copy_tree(ROOT, place)
    os.environ.setdefault("CCACHE_BASEDIR", str(ROOT))
    launcher = ["-DCMAKE_CXX_COMPILER_LAUNCHER=ccache"] if shutil.which("ccache") else []
    # The folders of this tree, not of the copy: so a compiler cache takes the copy's tests for the same.
    folders = [f"-DALIDADE_REFERENCE_DIR={ROOT}/tests/reference", f"-DALIDADE_SAMPLES_DIR={ROOT}/samples"]
    build = ["cmake", "--build", "build/release", "-j1", "--target"]
    suites = [Suite(name, f"build/release/tests/alidade_{name}_tests", f"alidade_{name}_tests") for name in programs]
    scratch = Scratch(place, suites, build, say)
    # Each source by itself: a fault is then compiled without the rest of its room.
    done = call(["cmake", "--preset", "test", "-DALIDADE_BY_ROOM=OFF", *launcher, *folders], place)
    for suite in suites:
        done = scratch.build(suite.target) if done.ok else done
    if not done.ok:
        sys.exit(f"run.sh: the tree does not build without a fault:\n{done.output}")
    for suite in suites:
        scratch.measure(suite, state_of_tree())
    return scratch


def tell(fault, outcome, by):
    say(f"{outcome:9} {fault}" + (f"   [{by}]" if by else ""))
    if outcome == SURVIVED:
        say(f"          {fault.shown}")


def try_all(drawn, scratches):
    """What became of each, in the order of the draw."""
    waiting = queue.Queue()
    for item in enumerate(drawn):
        waiting.put(item)
    results = {}

    def work(scratch):
        while True:
            try:
                number, faults = waiting.get_nowait()
            except queue.Empty:
                return
            found = first_that_compiles(faults, scratch)
            if found:
                results[number] = found
                tell(*found)

    threads = [threading.Thread(target=work, args=(scratch,)) for scratch in scratches]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    return [results[number] for number in sorted(results)]


def summarise(results):
    by_room = {}
    for fault, outcome, _ in results:
        caught, all_of_room = by_room.get(fault.room, (0, 0))
        by_room[fault.room] = caught + (outcome == CAUGHT), all_of_room + 1
    say("\nroom                             caught")
    for room, (caught, count) in sorted(by_room.items()):
        say(f"{room:32} {caught} of {count}")
    caught = sum(outcome == CAUGHT for _, outcome, _ in results)
    say(f"{'all':22} {caught} of {len(results)}, {100 * caught / max(len(results), 1):.0f} %")
    survivors = [(fault, by) for fault, outcome, by in results if outcome == SURVIVED]
    if survivors:
        say("\nsurvived: write the test that catches it, or list it in equivalent.txt with the reason")
        for fault, _ in survivors:
            say(f"{fault}\n          {fault.shown}")
    return 1 if survivors else 0


def main():
    args = options()
    drawn = chosen(args)
    if args.list:
        for faults in drawn:
            say(str(faults[0]))
        return 0
    scratches = [prepared(number, args.programs.split(",")) for number in range(min(args.jobs, len(drawn)))]
    return summarise(try_all(drawn, scratches))


if __name__ == "__main__":
    sys.exit(main())
