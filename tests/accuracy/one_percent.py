#!/usr/bin/python3
"""What an error of 1 % in masses, springs or channels does to `host_sim estimate` and to the interval that it quotes.

  one_percent.py BIN                       prints the tables
  one_percent.py BIN --page docs/limits.md writes them between the page's markers

BIN: folder of host_sim. The records are those of two shipped scenarios without noise; the errors are made in their files."""
import argparse
import csv
import json
import pathlib
import re
import subprocess
import sys
import tempfile

RIGS = (("paper_2dof", "Two DOF, sines at three levels"), ("paper_3dof_random", "Three DOF, random force"))
BEGIN, END = "<!-- one percent: written by tests/accuracy/one_percent.py -->\n", "<!-- one percent: end -->\n"
ERROR = 1.01


def in_rig(pattern):
    """Scales the rig file's values of these keys."""
    def change(rig, columns):
        return re.sub(rf"^({pattern} *= *)([-+.0-9e]+)", lambda m: m[1] + repr(float(m[2]) * ERROR), rig, flags=re.M), set()
    return change


def in_channels(pattern):
    """Scales the columns whose names begin so."""
    def change(rig, columns):
        return rig, {c for c in columns if re.match(pattern, c)}
    return change


def in_both(rig, columns):
    return in_rig("(?:mass_kg|stiffness_N_m)")(rig, columns)


ERRORS = (("all masses", in_rig("mass_kg")), ("all stiffnesses", in_rig("stiffness_N_m")), ("masses and stiffnesses", in_both),
          ("force gain", in_channels("force")), ("displacement gain", in_channels("displacement")),
          ("velocity gain", in_channels("velocity")), ("velocity gain of DOF 1 alone", in_channels("velocity_1")),
          ("acceleration gain", in_channels("acceleration")))


def scaled(path, out, names):
    with open(path, newline="") as source, open(out, "w", newline="") as target:
        rows, writer = csv.reader(source), csv.writer(target)
        head = next(rows)
        writer.writerow(head)
        factor = [ERROR if name in names else None for name in head]
        for row in rows:
            writer.writerow([repr(float(cell) * f) if f else cell for cell, f in zip(row, factor)])


def estimate(programs, rig, records, folder):
    subprocess.run([programs / "host_sim", "estimate", "--rig", rig, "--data", *records, "--json", folder / "out.json"],
                   capture_output=True)
    return json.loads((folder / "out.json").read_text())


def said(answer):
    warrant = answer["warrant"]
    found = warrant.get("corrected") or [warrant[key] for key in ("suspect",) if key in warrant]
    if not found:
        nearest = warrant.get("nearest")
        return f"that something does not fit, nearest {nearest['effect'].replace('_', ' ')}" if nearest else "nothing"
    named = ", ".join(one["effect"].replace("_", " ") + " of " + re.sub("^channel ", "", one["where"]) for one in found)
    return ("corrected: " if warrant.get("corrected") else "suspected: ") + named


def table(programs, scenario, title):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([programs / "host_sim", "run", "--scenario", scenario, "--records", folder / "records"], check=True,
                       capture_output=True, cwd=folder)
        rig = (folder / "records/rig.toml").read_text()
        records = sorted((folder / "records").glob("level_*.csv"))
        columns = records[0].open().readline().strip().split(",")
        right = estimate(programs, folder / "records/rig.toml", records, folder)
        names = [p["name"] for p in right["parameters"]]
        text = f"{title}:\n\n| 1 % more of | " + " | ".join(f"`{n}`" for n in names) + " | said |\n" + "|---" * (2 + len(names)) + "|\n"
        for what, change in ERRORS:
            other, channels = change(rig, columns)
            (folder / "rig.toml").write_text(other)
            changed = []
            for record in records:
                changed.append(folder / record.name)
                scaled(record, changed[-1], channels)
            answer = estimate(programs, folder / "rig.toml", changed, folder)
            text += f"| {what} | " + " | ".join(cell(p, q) for p, q in zip(answer["parameters"], right["parameters"]))
            text += f" | {said(answer)} |\n"
        return text + "\n"


def cell(p, right):
    move = 100 * (p["value"] / right["value"] - 1)
    half = 50 * (p["ci95"][1] - p["ci95"][0]) / abs(p["value"])
    text = f"{move:+.2f} ± {half:.2f}".replace("+0.00 ", "0.00 ").replace("-0.00 ", "0.00 ")
    return text if p["status"] == "VALID" else f"{text} `{p['status']}`"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=pathlib.Path)
    parser.add_argument("--page", type=pathlib.Path)
    arguments = parser.parse_args()
    text = "".join(table(arguments.programs.resolve(), scenario, title) for scenario, title in RIGS)
    if not arguments.page:
        print(text)
        return 0
    page = arguments.page.read_text()
    before, found, rest = page.partition(BEGIN)
    _, end, after = rest.partition(END)
    if not found or not end:
        print(f"one_percent.py: {arguments.page} lacks the lines {BEGIN}{END}", file=sys.stderr)
        return 1
    arguments.page.write_text(before + BEGIN + text + END + after)
    return 0


if __name__ == "__main__":
    sys.exit(main())
