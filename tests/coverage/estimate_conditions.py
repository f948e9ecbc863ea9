#!/usr/bin/python3
"""What `host_sim estimate` says of rigs that are right, from files to statuses, by condition and sensor set.

  estimate_conditions.py BIN --page docs/estimate_coverage.md [--draws 8] [--first-seed 1] [--jobs N]
  estimate_conditions.py BIN --conditions a,b --sensors x,v   prints the table alone
  estimate_conditions.py BIN --check                          a small part of it with limits; exit status 1 where one is missed

BIN: folder of host_sim and hidden_rig_files. The rigs are drawn by tests/hidden_rig, which shares no code with the estimator."""
import argparse
import json
import os
import pathlib
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

SENSORS = ("xva", "xa", "x", "a", "v")
MEASURABLE = 0.05  # half an interval over the true value, at most


class Tally:
    def __init__(self):
        self.records = self.suspect = self.refused = self.coefficients = 0
        self.valid = self.held = self.wrong = self.measurable = self.measurable_valid = 0

    def add(self, other):
        for name, value in vars(other).items():
            setattr(self, name, getattr(self, name) + value)

    def take(self, answer, truth):
        self.records += 1
        parameters = [p for p in answer["parameters"] if p["name"] in truth]
        self.suspect += any(p["status"] == "MODEL_SUSPECT" for p in parameters)
        for p in parameters:
            (low, high), true = p["ci95"], truth[p["name"]]
            self.coefficients += 1
            valid = p["status"] == "VALID"
            measurable = 0 < high - low < 2 * MEASURABLE * abs(true)
            self.measurable += measurable
            self.measurable_valid += measurable and valid
            if valid:
                off = abs(p["value"] - true)
                self.valid += 1
                self.held += low <= true <= high
                self.wrong += off > 0.05 * abs(true) and off > 4 * p["std"]

    def cell(self):
        if self.coefficients == 0:
            return "-"
        held = f"{percent(self.held, self.valid)}" if self.valid else "-"
        marks = [f"{percent(self.valid, self.coefficients)}, {held}, {percent(self.measurable_valid, self.measurable)}"]
        marks += [f"{self.suspect} suspected"] * (self.suspect > 0) + [f"**{self.wrong} wrong**"] * (self.wrong > 0)
        marks += [f"{self.refused} refused"] * (self.refused > 0)
        return ", ".join(marks)


def percent(part, whole):
    return f"{100 * part / whole:.0f}" if whole else "-"


def estimated(programs, condition, sensors, seed):
    """The tally of one drawn rig."""
    tally = Tally()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        subprocess.run([programs / "hidden_rig_files", "--condition", condition, "--seed", str(seed), "--sensors", sensors,
                        "--hidden", "none", "--out", folder], check=True, capture_output=True)
        truth = {c["name"]: c["value"] for c in json.loads((folder / "truth.json").read_text())["coefficients"]}
        records = sorted(folder.glob("record_*.csv"), key=lambda path: int(path.stem.split("_")[1]))
        subprocess.run([programs / "host_sim", "estimate", "--rig", folder / "rig.toml", "--data", *records, "--json",
                        folder / "out.json"], capture_output=True)
        if (folder / "out.json").exists():
            tally.take(json.loads((folder / "out.json").read_text()), truth)
        else:
            tally.refused += 1
    return tally


def measured(programs, conditions, sensors, draws, first_seed, jobs):
    """One row of tallies a condition."""
    with ThreadPoolExecutor(jobs) as pool:
        for condition in conditions:
            row = []
            for s in sensors:
                total = Tally()
                seeds = range(first_seed, first_seed + draws)
                for one in pool.map(lambda seed: estimated(programs, condition, s, seed), seeds):
                    total.add(one)
                row.append(total)
            yield condition, row


def page_of(rows, sensors, draws, first_seed):
    text = f"""# What `host_sim estimate` warrants

Written by `tests/coverage/estimate_conditions.py build/host/bin --page docs/estimate_coverage.md` (`tests/run.sh --bench`). Rigs are drawn
by `tests/hidden_rig`, nothing is hidden in them; seeds {first_seed} to {first_seed + draws - 1}, the same for every condition and sensor set. A cell
says how many percent of the coefficients go out VALID, how many percent of their 95 % intervals hold the truth, and how many percent
are VALID of those whose interval is within 5 % of the truth on either side. Records that are suspected of lacking something, and
coefficients that are wrong (VALID, over 5 % and over four quoted standard deviations off), are counted beside it.

[coverage.md](coverage.md) has the same of the board's core, which takes every sample as it comes.

"""
    text += "| condition | " + " | ".join(sensors) + " |\n" + "|---" * (1 + len(sensors)) + "|\n"
    total = [Tally() for _ in sensors]
    for condition, row in rows:
        print(f"| {condition} | " + " | ".join(t.cell() for t in row) + " |", flush=True)
        text += f"| {condition} | " + " | ".join(t.cell() for t in row) + " |\n"
        for sum_, one in zip(total, row):
            sum_.add(one)
    return text + "| **all** | " + " | ".join(t.cell() for t in total) + " |\n"


# At least so many percent of all coefficients VALID, of 8 rigs each. Displacements alone, whose accelerations are second slopes, under random
# forces with 1 and 5 % noise and on a moving base; all that can be measured beside noise that its neighbours know.
CHECKED = {("random_1pct", "x"): 85, ("random_5pct", "x"): 52, ("moving_base", "x"): 80, ("ar_0p8_5pct", "xva"): 35}


def check(programs, jobs):
    failures, all_ = [], Tally()
    for (condition, sensors), least in CHECKED.items():
        for _, (tally,) in measured(programs, [condition], [sensors], 8, 95000001, jobs):
            print(f"{condition}, {sensors}: {tally.cell()}")
            all_.add(tally)
            if 100 * tally.valid < least * tally.coefficients:
                failures.append(f"{condition}, {sensors}: fewer than {least} % are VALID")
    if all_.wrong or all_.suspect > 1 or all_.refused:  # under the strongest noise one of some 60 is
        failures.append("right rigs are suspected or refused, or a coefficient is wrong")
    if 100 * all_.held < 90 * all_.valid:  # of some 100 intervals of 95 %; fewer hold once in 60 times
        failures.append("fewer than 90 % of the intervals hold the truth")
    for failure in failures:
        print("estimate_conditions.py: " + failure, file=sys.stderr)
    return 1 if failures else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("programs", type=pathlib.Path)
    parser.add_argument("--page", type=pathlib.Path)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--draws", type=int, default=8)
    parser.add_argument("--first-seed", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--conditions")
    parser.add_argument("--sensors", default=",".join(SENSORS))
    arguments = parser.parse_args()
    programs = arguments.programs.resolve()
    if arguments.check:
        return check(programs, arguments.jobs)
    listed = subprocess.run([programs / "hidden_rig_files", "--list"], check=True, capture_output=True, text=True).stdout
    conditions = (arguments.conditions.split(",") if arguments.conditions
                  else listed.splitlines()[0].split(":")[1].split())
    sensors = arguments.sensors.split(",")
    rows = measured(programs, conditions, sensors, arguments.draws, arguments.first_seed, arguments.jobs)
    text = page_of(rows, sensors, arguments.draws, arguments.first_seed)
    if arguments.page:
        arguments.page.write_text(text)
    return 0


if __name__ == "__main__":
    sys.exit(main())
