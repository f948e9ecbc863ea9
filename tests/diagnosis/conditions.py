#!/usr/bin/env python3
"""Draws rigs under many conditions, several conditions at a time, and writes the page of what the diagnosis says of them.

  conditions.py CONDITION_REPORT DIR --draws 20 --first-seed 1 [--conditions a,b] [--jobs N]
                                      asks; what is in DIR already is not asked again
  conditions.py --page DIR PAGE RAW   writes its tables between the marks of PAGE, and every draw to RAW; conditions that PAGE has and
                                      DIR does not stay as they are

DIR gets what condition_report says, one file for each condition and for what is hidden: random_1pct.nothing, random_1pct.one; and
what was asked for: asked.txt."""
import argparse
import os
import pathlib
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

DRAW = re.compile(r"^(right|set|missed|WRONG|refused) (\S+) (\S+) (\d+) (.*) \(([\d.e+-]+) s\)$")
ROW = re.compile(r"^\| all \|(.*)\|$")
BEGIN, END = "<!-- tables: written by tests/diagnosis/conditions.py -->", "<!-- end of tables -->"
HEAD = ("| {} | nothing hidden: `none` | `unknown` | hidden: exact | in a set | missed | wrong | refused |"
        " intervals that hold, %: nothing hidden | one effect | median s | longest s |\n" + "|---" * 12 + "|")


SENSORS = ("| sensors | nothing hidden: `none` | `unknown` | hidden: exact | in a set | missed | wrong | refused |\n" + "|---" * 8 + "|")


def ask(report, directory, condition, hidden, draws, first_seed):
    path = directory / f"{condition}.{hidden}"
    if path.exists():
        return
    command = [report, "--draws", str(draws), "--first-seed", str(first_seed), "--conditions", condition, "--hidden", hidden]
    answer = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    part = path.with_suffix(path.suffix + ".part")
    part.write_text(answer)
    part.rename(path)


def asked(report, directory, conditions, draws, first_seed, jobs):
    directory.mkdir(parents=True, exist_ok=True)
    told, what = directory / "asked.txt", f"--draws {draws} --first-seed {first_seed}"
    if told.exists() and told.read_text() != what:
        sys.exit(f"{directory} holds the answers to {told.read_text()}: another directory, please")
    told.write_text(what)
    with ThreadPoolExecutor(jobs) as pool:
        for job in [pool.submit(ask, report, directory, c, h, draws, first_seed) for c in conditions
                    for h in ("nothing", "one")]:
            job.result()


def draws_of(path):
    """The draws of one file, as (word, condition, sensors, seed, text, seconds), and the share of intervals that hold."""
    draws, holding = [], "-"
    for line in path.read_text().splitlines():
        if match := DRAW.match(line):
            draws.append((*match.groups()[:5], float(match[6])))
        elif match := ROW.match(line):
            holding = match[1].split("|")[-3].strip()  # the last such row is over all sensors
    return draws, holding


def row(name, nothing, one, holding):
    count = lambda draws, word: sum(d[0] == word for d in draws)
    seconds = sorted(d[5] for d in nothing + one) or [0.0]
    cells = [name, f"{count(nothing, 'right')} of {len(nothing)}", count(nothing, "missed"), count(one, "right"), count(one, "set"),
             count(one, "missed"), count(one, "WRONG"), count(nothing + one, "refused"), *holding,
             f"{seconds[len(seconds) // 2]:.2f}", f"{seconds[-1]:.1f}"]
    return "| " + " | ".join(str(c) for c in cells) + " |"


def told_before(page, raw):
    """Rows of the first table of a page, and the draws of RAW, each by its condition."""
    rows, draws = {}, {}
    for line in page.split(BEGIN)[1].split(END)[0].split("| sensors |")[0].splitlines():
        if match := re.match(r"\| `(\w+)` \|", line):
            rows[match[1]] = line
    for line in raw.read_text().splitlines() if raw.exists() else []:
        word, condition, sensors, seed, text = line.split(" ", 4)
        draws.setdefault(condition, []).append((word, condition, sensors, seed, text))
    return rows, draws


def all_row(rows, nothing, one):
    """Over all conditions; the draws of earlier ones have no times of their own, their rows have."""
    cells = row("all", nothing, one, ("", "")).split("|")
    times = [[float(cell) for cell in line.split("|")[-3:-1]] for line in rows]
    cells[-3] = f" {sorted(t[0] for t in times)[len(times) // 2]:.2f} "
    cells[-2] = f" {max(t[1] for t in times):.1f} "
    return "|".join(cells)


def tables(directory, page, raw):
    nothing, one, rows = [], [], {}
    before_rows, before_draws = told_before(page, raw)
    for path in sorted(directory.glob("*.nothing")):
        own, held = draws_of(path)
        hidden, held_one = draws_of(path.with_suffix(".one")) if path.with_suffix(".one").exists() else ([], "-")
        rows[path.stem] = row(f"`{path.stem}`", own, hidden, (held, held_one))
        nothing += own
        one += hidden
    for condition in before_rows.keys() - rows.keys():
        rows[condition] = before_rows[condition]
        for draw in before_draws.get(condition, []):
            (nothing if "hidden: nothing" in draw[4] else one).append((*draw, 0.0))
    nothing.sort(key=lambda draw: (draw[1], int(draw[3])))
    one.sort(key=lambda draw: (draw[1], int(draw[3])))
    rows = [rows[name] for name in sorted(rows)]
    lines = [f"Written by `tests/diagnosis/conditions.py build/host/bin/condition_report DIR {(directory / 'asked.txt').read_text()}`",
             f"and `--page`: {len(nothing)} draws with nothing hidden, {len(one)} with one effect, in {len(rows)} conditions.", "",
             HEAD.format("condition"), *rows, all_row(rows, nothing, one), "", SENSORS]
    for sensors in ("xva", "xa", "x", "a", "v", "mixed"):
        cells = row(f"`{sensors}`", [d for d in nothing if d[2] == sensors], [d for d in one if d[2] == sensors], ("", "")).split("|")
        lines.append("|".join(cells[:9]) + "|")
    return "\n".join(lines), nothing + one


def write_page(directory, page, raw):
    text, draws = tables(directory, page.read_text(), raw)
    before, rest = page.read_text().split(BEGIN)
    page.write_text(before + BEGIN + "\n" + text + "\n" + END + rest.split(END)[1])
    raw.write_text("".join(" ".join(draw[:5]) + "\n" for draw in draws))


def main():
    if len(sys.argv) == 5 and sys.argv[1] == "--page":
        write_page(*map(pathlib.Path, sys.argv[2:]))
        return 0
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("report")
    parser.add_argument("directory", type=pathlib.Path)
    parser.add_argument("--draws", type=int, default=20)
    parser.add_argument("--first-seed", type=int, default=1)
    parser.add_argument("--conditions", type=lambda text: text.split(","))
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    told = parser.parse_args()
    conditions = told.conditions
    if not conditions:
        listing = subprocess.run([pathlib.Path(told.report).parent / "hidden_rig_files", "--list"], capture_output=True,
                                 text=True, check=True).stdout
        conditions = next(line for line in listing.splitlines() if line.startswith("conditions:")).split()[1:]
    asked(told.report, told.directory, conditions, told.draws, told.first_seed, told.jobs)
    return 0


if __name__ == "__main__":
    sys.exit(main())
