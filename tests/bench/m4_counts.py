#!/usr/bin/env python3
"""Instructions of a Cortex-M4 per sample, step and solve, counted in the emulator.

  m4_counts.py BUILD_FOLDER --page       measures all of it and prints a table for docs/speed.md
  m4_counts.py BUILD_FOLDER --check      measures rigs of 3 DOF, and slices; exit status 1 where a count has left
                                         tests/bench/m4_limits.txt by more than 3 % in either direction, or a slice takes
                                         more than 15,000 instructions, 77 where the emulator or a build is missing
  m4_counts.py BUILD_FOLDER --write      renews that file

BUILD_FOLDER holds host (scenario_script, chain_script) and cortex-m (rig_image). The emulator runs one instruction in 64 ns
(-icount shift=6); the program reads the board's 25 MHz timer before and after each step, so counts are exact to some
two instructions a reading. They are instructions, not cycles."""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys

LIMITS = pathlib.Path(__file__).with_name("m4_limits.txt")
SKIPPED = 77
TOLERANCE = 0.03
LONGEST_SLICE = 15000  # docs/porting.md
INSTRUCTIONS_PER_TICK = 40 / 64
# Title, writer and its arguments (FILE: the script), DOFs.
RIGS = {
    "1 DOF": (["scenario_script", "paper_1dof", "1", "FILE"], 1),
    "3 DOF, random force": (["scenario_script", "paper_3dof_random", "1", "FILE"], 3),
    "3 DOF, displacement only": (["scenario_script", "paper_3dof_random", "1", "FILE", "1000000", "x"], 3),
    "16 DOF": (["chain_script", "16", "20000", "FILE"], 16),
    "16 DOF, 48 unknowns": (["chain_script", "16", "8000", "FILE", "all"], 16),
}
OPEN = ", length of the level unknown"
DETAILS = {"plain": "plain", "plain" + OPEN: "plain open", "full": "untested", "full" + OPEN: "untested open"}
CHECKED = [("3 DOF, random force", "plain"), ("3 DOF, random force", "full"), ("3 DOF, random force", "full" + OPEN),
           ("3 DOF, displacement only", "plain")]
SLICED = ["3 DOF, random force", "3 DOF, displacement only", "16 DOF", "16 DOF, 48 unknowns"]


def script_of(build, rig):
    folder = build / "bench"
    folder.mkdir(exist_ok=True)
    path = folder / (re.sub(r"\W+", "_", rig) + ".bin")
    words = [str(path) if word == "FILE" else word for word in RIGS[rig][0]]
    subprocess.run([str(build / "host/bin" / words[0]), *words[1:]], check=True)
    return path


def run(build, path, words):
    arguments = ",".join(f"arg={word}" for word in ["image", str(path), *words.split()])
    command = ["qemu-system-arm", "-M", "mps2-an386", "-nographic", "-monitor", "none", "-serial", "none",
               "-semihosting-config", f"enable=on,target=native,{arguments}", "-icount", "shift=6",
               "-kernel", str(build / "cortex-m/bin/rig_image")]
    text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
    found = {}
    for name, count, total, worst in re.findall(r"^([a-z ]+): count (\d+) total (\d+) worst (\d+)", text, re.M):
        found[name] = tuple(int(int(n) * (1 if i == 0 else INSTRUCTIONS_PER_TICK))
                            for i, n in enumerate((count, total, worst)))
    median = re.search(r"^median (\d+)", text, re.M)
    return found, int(int(median.group(1)) * INSTRUCTIONS_PER_TICK) if median else 0


def measured(build, rig, detail):
    found, median = run(build, script_of(build, rig), DETAILS[detail])
    count, total, worst = found["push"]
    return {"per DOF and sample": total / count / RIGS[rig][1], "median step": median, "worst step": worst,
            "worst solve": found["solve"][2]}


def worst_slice(build, rig):
    found, _ = run(build, script_of(build, rig), "untested sliced")
    return found["slice"][2]


def controller(build, rig):
    path = script_of(build, rig)
    core, _ = run(build, path, "untested")
    whole, _ = run(build, path, "untested frames")
    steps, work, worst = whole["step"]
    return (work / steps) - core["push"][1] / core["push"][0], worst


def page(build):
    lines = ["| rig | sums | per DOF and sample | median step | worst step | worst solve |", "|---|---|---|---|---|---|"]
    for rig in RIGS:
        for detail in DETAILS:
            m = measured(build, rig, detail)
            lines.append(f"| {rig} | {detail} | {m['per DOF and sample']:.0f} | {m['median step']:,} | {m['worst step']:,} "
                         f"| {m['worst solve'] / 1e6:.1f} million |")
    extra, worst = controller(build, "3 DOF, random force")
    slices = ", ".join(f"{worst_slice(build, rig):,} ({rig})" for rig in SLICED)
    lines += ["", "A solve in slices (hal/bare_metal/sliced_worker.hpp) gives the same bits. Its longest slice takes",
              f"{slices} instructions.", "", f"The whole controller takes {extra:.0f} instructions a sample more than its core (3 DOF), {worst:,} in the step",
              "that sends most frames; steps with a solve apart."]
    print("\n".join(lines))


def limits(build):
    found = {f"{rig}; {detail}; {what}": value for rig, detail in CHECKED
             for what, value in measured(build, rig, detail).items()}
    found.update({f"{rig}; full; worst slice": worst_slice(build, rig) for rig in SLICED})
    found[f"{SLICED[0]}; controller; per sample more than its core"] = controller(build, SLICED[0])[0]
    return found


def check(build):
    wrong = 0
    wanted = {line.rsplit(";", 1)[0]: float(line.rsplit(";", 1)[1]) for line in LIMITS.read_text().splitlines()
              if line and line[0] != "#"}
    for name, value in limits(build).items():
        limit = wanted.get(name, 0.0)
        if abs(value - limit) > TOLERANCE * limit:
            print(f"{name}: {value:.0f} instructions, {LIMITS.name} says {limit:.0f}")
            wrong += 1
        if name.endswith("slice") and value > LONGEST_SLICE:
            print(f"{name}: {value:.0f} instructions, more than {LONGEST_SLICE:,}")
            wrong += 1
    print(f"{wrong} counts have left their limits; m4_counts.py --write renews them where that is meant")
    return 1 if wrong else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=pathlib.Path)
    for name in ("--page", "--check", "--write"):
        parser.add_argument(name, action="store_true")
    a = parser.parse_args()
    for missing in (None if shutil.which("qemu-system-arm") else "qemu-system-arm",
                    *(path for path in (a.build / "cortex-m/bin/rig_image", a.build / "host/bin/scenario_script")
                      if not path.exists())):
        if missing:
            print(f"SKIPPED: no {missing}; tests/run.sh builds or installs it")
            return SKIPPED
    if a.page:
        page(a.build)
    elif a.write:
        lines = ["# Instructions on a Cortex-M4; a count may leave these by 3 % in either direction."]
        LIMITS.write_text("\n".join(lines + [f"{name}; {value:.1f}" for name, value in limits(a.build).items()]) + "\n")
    else:
        return check(a.build)
    return 0


if __name__ == "__main__":
    sys.exit(main())
