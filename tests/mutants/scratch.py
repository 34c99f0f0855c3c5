"""A copy of the tree in which faults are put in, built and tested."""

import json
import os
import re
import resource
import shutil
import subprocess
from pathlib import Path

NICENESS = 10
MOST_MEMORY = 8 << 30  # bytes: what asks for more is taken for caught
LEFT_OUT = (".git", "build")


def copy_tree(root, to):
    """Only files that differ are written, so that a build of the copy stays what it is."""
    kept = set()
    for folder, folders, files in os.walk(root):
        folders[:] = [name for name in folders if name not in LEFT_OUT and name != "__pycache__"]
        for name in files:
            source = Path(folder) / name
            target = to / source.relative_to(root)
            kept.add(target)
            if target.exists() and target.read_bytes() == source.read_bytes():
                continue
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(source, target)
    for folder, folders, files in os.walk(to):
        folders[:] = [name for name in folders if name not in LEFT_OUT]
        for name in files:
            if Path(folder) / name not in kept:
                (Path(folder) / name).unlink()


class Outcome:
    """How a call ended: `ok`, its output, and `why` where it failed."""

    def __init__(self, ok, output="", why=""):
        self.ok, self.output, self.why = ok, output, why


def call(command, cwd, cpu_seconds=None):
    def limit():
        os.nice(NICENESS)
        if cpu_seconds:
            resource.setrlimit(resource.RLIMIT_CPU, (int(cpu_seconds), int(cpu_seconds) + 5))
            resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
            resource.setrlimit(resource.RLIMIT_CORE, (0, 0))

    environment = dict(os.environ, QT_QPA_PLATFORM="offscreen", LC_ALL="C.UTF-8")
    # Who waits for what never comes uses no processor: twenty times as long is long enough on a busy machine.
    wait = 20 * cpu_seconds + 60 if cpu_seconds else None
    try:
        done = subprocess.run(command, cwd=cwd, env=environment, preexec_fn=limit, timeout=wait, check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace")
    except subprocess.TimeoutExpired:
        return Outcome(False, why="waits for ever")
    if done.returncode == 0:
        return Outcome(True, done.stdout)
    names = {-24: "runs for ever", -9: "runs for ever", -11: "segmentation fault", -6: "abort", -8: "SIGFPE"}
    return Outcome(False, done.stdout, names.get(done.returncode, f"exit code {done.returncode}"))


class Suite:
    """A test program, what is needed for it, and how long each of its tests takes."""

    def __init__(self, name, program, target):
        self.name, self.program, self.target = name, program, target
        self.seconds = {}  # of each test


class Scratch:
    """`suites` in the order in which they are asked. `build`: the command that builds a target."""

    def __init__(self, place, suites, build, say):
        self.place, self.suites, self.build_command, self.say = Path(place), suites, build, say

    def build(self, target):
        return call([*self.build_command, target], self.place)

    def run(self, suite, tests):
        """The named tests of a suite, up to the first that fails; None means all."""
        command = [str(self.place / suite.program), "--gtest_fail_fast", "--gtest_brief=1"]
        allowed = 60 + 4 * sum(s for t, s in suite.seconds.items() if tests is None or t in tests)
        if tests is not None:
            command.append("--gtest_filter=" + ":".join(tests))
        outcome = call(command, self.place, allowed)
        failed = re.search(r"\[  FAILED  \] ([\w./]+)", outcome.output)
        if failed:
            outcome.why = failed.group(1)
        return outcome

    def measure(self, suite, state):
        """All tests of a suite on the sound tree, each with its time. Whatever fails here says nothing later."""
        report = self.place / "build" / f"{suite.name}-{state}.json"
        if not report.exists():
            call([str(self.place / suite.program), "--gtest_brief=1", f"--gtest_output=json:{report}"], self.place)
        failing = []
        for group in json.loads(report.read_text(encoding="utf-8"))["testsuites"]:
            for test in group["testsuite"]:
                name = f"{group['name']}.{test['name']}"
                if test.get("failures"):
                    failing.append(name)
                elif test.get("result") == "COMPLETED":
                    suite.seconds[name] = float(test["time"].rstrip("s"))
        if failing:
            self.say(f"failing without any fault, and left out: {', '.join(failing)}")

    def put_in(self, fault):
        """The text as it was."""
        path = self.place / fault.path
        sound = path.read_text(encoding="utf-8")
        path.write_text(fault.put_into(sound), encoding="utf-8")
        return sound

    def take_out(self, fault, sound):
        (self.place / fault.path).write_text(sound, encoding="utf-8")
