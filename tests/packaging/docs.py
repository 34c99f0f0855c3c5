#!/usr/bin/env python3
"""docs.py ROOT [ALIDADE_CLI [ALIDADE]]: what the Markdown files of the tree promise.

Every link leads to a file, every anchor to a heading, and every option written in a command is one of its --help. With the
programs at hand the commands of code blocks that need nothing but the samples end with 0, and each line of a `text` block
that stands right below them is printed by them, blanks aside. The page of the effects lists the catalogue with its plausible
sizes. README.md, those of the rooms and the decisions stay short, and the index lists every decision.
"""

import os
import re
import shlex
import subprocess
import sys
import tempfile
import unicodedata
from concurrent.futures import ThreadPoolExecutor

SKIPPED = {".git", "build"}
# Not run: commands that draw hundreds of trials, wait for input, or need files other than samples.
SLOW = re.compile(r"trial --(count|series) |instrument-simulator ")
COMMAND = re.compile(r"\b(alidade-cli|alidade)\b((?: +[^\s`]+)*)")


def markdown_files(root):
    for folder, folders, files in os.walk(root):
        folders[:] = sorted(f for f in folders if f not in SKIPPED)
        yield from (os.path.join(folder, f) for f in sorted(files) if f.endswith(".md"))


def parts(text):
    """(line number, line, language of the code block it is in or None)."""
    language = None
    for number, line in enumerate(text.split("\n"), 1):
        fence = re.match(r"\s*```(.*)", line)
        if fence:
            language = None if language is not None else fence.group(1).strip()
            continue
        yield number, line, language


def slug(heading):
    """As forges make an anchor of a heading."""
    heading = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", heading.strip()).replace("`", "").replace("*", "").lower()
    kept = [c for c in heading if c in " -_" or unicodedata.category(c)[0] in "LN" or unicodedata.category(c) == "Mn"]
    return "".join(kept).replace(" ", "-")


def anchors(text):
    found = {}
    for _, line, language in parts(text):
        heading = re.match(r"#{1,6} +(.*)", line) if language is None else None
        if heading:
            name = slug(heading.group(1))
            count = found.get(name, 0)
            found[name] = count + 1
            if count:
                found[f"{name}-{count}"] = 1
    return set(found) | set(re.findall(r'<a (?:name|id)="([^"]+)"', text))


def link_problems(root, path, text):
    for number, line, language in parts(text):
        if language is not None:
            continue
        bare = re.sub(r"`[^`]*`", lambda m: "`" * len(m.group(0)), line)
        targets = re.findall(r"\]\(<?([^)>\s]+)>?(?: \"[^\"]*\")?\)", bare) + re.findall(r"^\[[^\]]+\]: *(\S+)", bare)
        for target in targets:
            where = f"{os.path.relpath(path, root)}:{number}: {target}"
            if re.match(r"[a-z]+:", target):
                continue
            file, _, anchor = target.partition("#")
            to = os.path.normpath(os.path.join(os.path.dirname(path), file)) if file else path
            if not os.path.exists(to):
                yield f"{where}: there is no such file"
            elif os.path.relpath(to, root).startswith(".."):
                yield f"{where}: leads out of the repository"
            elif anchor and to.endswith(".md"):
                with open(to, encoding="utf-8") as linked:
                    if anchor not in anchors(linked.read()):
                        yield f"{where}: there is no such heading"


class Programs:
    """The programs and what their --help knows."""

    def __init__(self, root, cli, window):
        self.root, self.help = root, {}
        self.paths = {name: os.path.abspath(path) for name, path in (("alidade-cli", cli), ("alidade", window)) if path}
        self.environment = dict(os.environ, QT_QPA_PLATFORM="offscreen", LC_ALL="C.UTF-8")

    def has(self, name):
        return bool(self.paths.get(name))

    def help_of(self, name, subcommand):
        key = (name, subcommand)
        if key not in self.help:
            call = [self.paths[name]] + ([subcommand] if subcommand else []) + ["--help"]
            run = subprocess.run(call, capture_output=True, text=True, env=self.environment, timeout=60)
            self.help[key] = run.stdout if run.returncode == 0 else None
        return self.help[key]

    def run(self, words, folder):
        return subprocess.run([self.paths[words[0]]] + words[1:], capture_output=True, text=True, cwd=folder,
                              env=self.environment, timeout=300)


def commands_of(text):
    """(line number, program, words after it) of code blocks and of `code` in prose."""
    for number, line, language in parts(text):
        pieces = [line.split(" #")[0]] if language in ("sh", "bash", "shell") else \
            re.findall(r"`([^`]+)`", line) if language is None else []
        for piece in pieces:
            piece = piece.strip()
            call = COMMAND.match(piece)
            if call:
                yield number, call.group(1), piece.split()[1:]


def option_problems(root, path, text, programs):
    for number, name, words in commands_of(text):
        if not programs.has(name):
            continue
        where = f"{os.path.relpath(path, root)}:{number}"
        alternatives = words[0].split("|") if name == "alidade-cli" and words and words[0][0].isalpha() else [""]
        for subcommand in alternatives:
            known = programs.help_of(name, subcommand)
            if known is None:
                yield f"{where}: {name} has no subcommand {subcommand}"
                continue
            for word in words:
                option = re.match(r"\[?(--[a-z][a-z0-9-]*)", word)
                if option and not re.search(rf"(?<![\w-]){re.escape(option.group(1))}(?![\w-])", known):
                    yield f"{where}: {name} {subcommand} has no option {option.group(1)}"


def blocks(text):
    """(line of the block, commands, lines that they print)."""
    inside, current = None, []
    commands = None
    for number, line in enumerate(text.split("\n"), 1):
        fence = re.match(r"\s*```(.*)", line)
        if fence and inside is None:
            inside, current, begun = fence.group(1).strip(), [], number
        elif fence:
            if inside in ("sh", "bash", "shell"):
                if commands:
                    yield commands[0], commands[1], []
                commands = (begun, current)
            elif commands:
                yield commands[0], commands[1], current if inside == "text" else []
                commands = None
            inside = None
        elif inside is not None:
            current.append(line.strip())
        elif line.strip() and commands:
            yield commands[0], commands[1], []
            commands = None
    if commands:
        yield commands[0], commands[1], []


def runnable(root, programs, line):
    """The words of a command that needs nothing but the repository; None of others."""
    try:
        words = shlex.split(line, comments=True)
    except ValueError:
        return None
    if not words or not programs.has(words[0]) or SLOW.search(line + " ") or "|" in words or "$" in line:
        return None
    inputs = [w for i, w in enumerate(words[1:], 1) if "/" in w and not words[i - 1] in ("--out", "--truth", "--report")]
    if any(not os.path.exists(os.path.join(root, w)) for w in inputs):
        return None
    named = [w for i, w in enumerate(words[1:], 1)
             if re.search(r"\.(alidade|gsi|csv|json|alidade-instrument)$", w) and "/" not in w and
             words[i - 1] not in ("--out", "--truth")]
    placeholder = any(re.fullmatch(r"[A-Z][A-Z_]+", w) for w in words[1:])
    return None if named or placeholder else words


def run_problems(root, path, text, programs, folder):
    counted = 0
    for number, commands, expected in blocks(text):
        where = f"{os.path.relpath(path, root)}:{number}"
        printed = ""
        for line in commands:
            words = runnable(root, programs, line)
            if words is None or (words[0] == "alidade" and not {"--report", "--self-test", "--help", "--version"} & set(words)):
                continue
            counted += 1
            run = programs.run(words, folder)
            printed += run.stdout + run.stderr
            if run.returncode != 0:
                yield f"{where}: `{line}` ends with {run.returncode}: {run.stderr.strip()[:200]}"
        if not expected or not printed:
            if any(e for e in expected) and any(COMMAND.match(c) for c in commands):
                yield f"{where}: what should print the lines below was not run"
            continue
        flat = " ".join(printed.split())
        for line in expected:
            if line and " ".join(line.split()) not in flat:
                yield f"{where}: does not print “{line}”"
    programs.counted = getattr(programs, "counted", 0) + counted


def catalogue(text):
    """{id: (name, [(name of a number, plausible size with its unit)])} of core/effects/catalogue.cpp."""
    body = text[text.index("makeCatalogue()"):text.index("/// Each error term")]
    body = re.sub(r"^ *//.*$", "", body, flags=re.M)
    units = {"arcsec": "″", "deg": "°", "mm": " mm", "1": "", "-": ""}
    effects = {}
    for own in re.split(r"\n      \{(?=relationId|\")", body)[1:]:
        id_of = re.match(r"(relationId|\"(\w+)\")", own)
        name = re.search(r'PHRASE_LATER\("Phrase", "([^"]+)"\)', own).group(1)
        numbers = re.findall(r'\{PHRASE_LATER\("Phrase", "([^"]+)"\), \w+, "([^"]+)", ([\d.e-]+)[,}]', own)
        effects[id_of.group(2) or "vertical_angle_relation"] = \
            (name, [(number, f"{float(size):g}{units[unit]}") for number, unit, size in numbers])
    return effects


def effect_problems(root):
    """The rows of the page of the effects against the catalogue."""
    page = os.path.join(root, "resources", "docs", "effects.md")
    source = os.path.join(root, "core", "effects", "catalogue.cpp")
    if not os.path.exists(page) or not os.path.exists(source):
        return
    with open(source, encoding="utf-8") as file:
        missing = catalogue(file.read())
    if not missing:
        yield "core/effects/catalogue.cpp: no effect was found in it"
    with open(page, encoding="utf-8") as file:
        text = file.read().split("\n## Causes outside the catalogue")[0]
    for number, line, _ in parts(text):
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        row = re.fullmatch(r"(.+?) `(\w+)`", cells[0]) if len(cells) > 2 else None
        if not row:
            continue
        where, known = f"resources/docs/effects.md:{number}", missing.pop(row.group(2), None)
        if known is None:
            yield f"{where}: {row.group(2)} is not in the catalogue, or was listed above"
            continue
        name, numbers = known
        sizes = ", ".join(f"{each} {size}" for each, size in numbers) if len(numbers) > 1 else numbers[0][1]
        if row.group(1) != name and not row.group(1).startswith(name + " "):
            yield f"{where}: the catalogue calls it “{name}”"
        if cells[2] != sizes:
            yield f"{where}: the plausible size is {sizes}, not {cells[2]}"
    for identifier in missing:
        yield f"resources/docs/effects.md: {identifier} is missing"


def length_problems(root, texts):
    """Pages that are read at one sitting."""
    rooms = ("app", "core", "packaging", "samples", "tests", "ui")
    for path, text in texts.items():
        name = os.path.relpath(path, root)
        folders = name.split(os.sep)[:-1]
        most = None
        if name == "README.md":
            most = 70
        elif os.path.basename(name) == "README.md" and folders[0] in rooms and folders[:2] != ["tests", "reference"]:
            most = 40
        elif folders == ["resources", "docs", "decisions"] and not name.endswith("README.md"):
            most = 40
        lines = text.count("\n")
        if most and lines > most:
            yield f"{name}: {lines} lines, at most {most}"


def index_problems(root, texts):
    """Every decision stands in the index, under a number of its own."""
    folder = os.path.join(root, "resources", "docs", "decisions")
    index = texts.get(os.path.join(folder, "README.md"), "")
    numbers = set()
    for path in texts:
        name = os.path.basename(path)
        if os.path.dirname(path) != folder or name == "README.md":
            continue
        number = name[:3]
        if not re.match(r"\d{3}-[a-z0-9-]+\.md$", name):
            yield f"resources/docs/decisions/{name}: is called NNN-title.md"
        elif number in numbers:
            yield f"resources/docs/decisions/{name}: its number comes twice"
        if f"]({name})" not in index:
            yield f"resources/docs/decisions/{name}: not in the index"
        numbers.add(number)


def main():
    root = os.path.abspath(sys.argv[1])
    programs = Programs(root, *(sys.argv[2:4] + ["", ""])[:2])
    complaints, texts = [], {}
    for path in markdown_files(root):
        with open(path, encoding="utf-8") as file:
            texts[path] = file.read()
        complaints += link_problems(root, path, texts[path])
        complaints += option_problems(root, path, texts[path], programs)
    complaints += effect_problems(root)
    complaints += length_problems(root, texts)
    complaints += index_problems(root, texts)
    if programs.has("alidade-cli"):
        def tried(path):
            # A separate folder with the samples, so that nothing is written into the tree.
            with tempfile.TemporaryDirectory() as folder:
                for name in ("samples", "tests"):
                    if os.path.isdir(os.path.join(root, name)):
                        os.symlink(os.path.join(root, name), os.path.join(folder, name))
                return list(run_problems(root, path, texts[path], programs, folder))

        with ThreadPoolExecutor(2) as pool:
            for found in pool.map(tried, texts):
                complaints += found
    for complaint in complaints:
        print(complaint)
    print(f"{len(texts)} files, {getattr(programs, 'counted', 0)} commands run")
    sys.exit(1 if complaints else 0)


if __name__ == "__main__":
    main()
