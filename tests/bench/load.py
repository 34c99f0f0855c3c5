"""Times alidade-cli on sessions of 10⁴, 10⁵ and 10⁶ rows: processor time and peak memory of one process.

Usage: load.py ALIDADE_CLI [ROWS]...

W12 and W13 of the table of workloads. Each row says by how much it grew since the row before: ten times the rows
should take ten times the time.
"""
import json
import os
import re
import subprocess
import sys
import tempfile

COMMANDS = ("fit --no-diagnosis", "fit", "diagnose", "plan", "import")


def measured(arguments):
    """User and system seconds, peak memory in MB; the call must succeed."""
    process = subprocess.Popen(arguments, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    message = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    if os.waitstatus_to_exitcode(status) != 0:
        sys.exit(f"{' '.join(arguments)}: {message.decode(errors='replace')}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def simulate(cli, folder, rows):
    """Rows in face 1, a hundred thousand places at most, in both positions."""
    places = min(rows // 2, 100_000)
    path = os.path.join(folder, f"{rows}.alidade")
    subprocess.run(
        [cli, "simulate", "--out", path, "--truth", os.path.join(folder, "truth.json"), "--seed", "5", "--protocol",
         "paper", "--points", str(places), "--rounds", str(rows // 2 // places)],
        check=True, stdout=subprocess.DEVNULL)
    return path


def as_table(session, path):
    """The same readings as a CSV file."""
    row = re.compile(r'\{"point": (\d+), "round": (\d+), "face": (\d+), "horizontal": ("[^\n]*?"), "vertical": ("[^\n]*?")\}')
    axis = None
    with open(session, encoding="utf-8") as lines, open(path, "w", encoding="utf-8") as table:
        table.write("axis;point;round;face;horizontal;vertical\n")
        for line in lines:
            if '"axis_deg"' in line:
                axis = re.search(r"\d+", line.split(":")[1]).group()
            found = row.search(line)
            if found:
                point, round_, face, horizontal, vertical = found.groups()
                table.write(f"{axis};{point};{round_};{face};{json.loads(horizontal)};{json.loads(vertical)}\n")


def main():
    cli = sys.argv[1]
    sizes = [int(size) for size in sys.argv[2:]] or [10_000, 100_000, 1_000_000]
    print("| call | rows | processor time, s | grew | peak memory, MB |\n|---|---|---|---|---|")
    before = {}
    with tempfile.TemporaryDirectory() as folder:
        for rows in sizes:
            session = simulate(cli, folder, rows)
            table = os.path.join(folder, f"{rows}.csv")
            as_table(session, table)
            for command in COMMANDS:
                arguments = [cli, *command.split(), session]
                if command == "import":
                    arguments = [cli, command, table, "--out", os.path.join(folder, "imported.alidade")]
                seconds, memory = measured(arguments)
                grew = f"{seconds / before[command]:.1f} ×" if command in before else ""
                before[command] = seconds
                print(f"| {command} | {rows} | {seconds:.2f} | {grew} | {memory:.0f} |", flush=True)


if __name__ == "__main__":
    main()
