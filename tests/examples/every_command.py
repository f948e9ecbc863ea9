"""Every host_sim command that README.md, docs/*.md and the help texts show, run as it stands.

every_command.py SOURCE_DIR BUILD_DIR

Blocks marked ```sh are run by tests/host_sim/readme_test.cpp; here the indented ones. A command that cannot run here
has a reason in CANNOT; everything else has to end with the status that the page lets expect.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

# Pattern of a command, and why it is not run.
CANNOT = [
    (r"\bv?can0\b|^cansend|^candump", "needs a CAN interface"),
    (r"^(ssh|scp|sudo|apt|systemctl)\b", "needs a board or the right to install"),
    (r"^(cmake|ctest)\b|^\./host_sim/run\.sh|^\./tests/run\.sh|^tests/", "builds, or runs these tests"),
    (r"host_sim watch", "needs a terminal: tests/live drives it in an emulated one"),
    (r"/etc/rig_controller", "needs a board or the right to install"),
    (r"^mpirun\b|--seeds 1\.\.200", "needs many cores"),
]

# Pattern of a command, and what its output has to hold.
ANSWERS = [
    (r"host_sim diagnose --rig rig\.toml --data record\.csv", r"none: The rig file explains the measurement"),
    (r"host_sim check .*level_1", r"verdict: (good|usable)"),
    (r"host_sim run\s*(#|$)", r"viscous\[1-0\] +20 "),
    (r"host_sim run --scenario paper_2dof --seed 7", r"seed 7"),
    (r"host_sim estimate .*Chan 1", r"viscous\[1-0\]"),
    (r"decode --changes", r"viscous\[1-0\]"),
    (r"measured_examples", r""),
]

# Needs the published recordings, which are not part of the project.
NEEDS_RECORDINGS = r"recordings\b"

FIXTURE = """schema = "scenario/1"
name = "fixture"
[[dof]]
mass_kg = 2.0
[[link]]
between = [1, 0]
stiffness_N_m = 800.0
viscous_N_s_m = "estimate"
coulomb_N = "estimate"
[truth]
"viscous[1-0]" = 4.0
"coulomb[1-0]" = 2.0
"""
CHANNELS = "".join(f'[[channel]]\nname = "{name}"\nunit_per_code = 1.0e-6\n' for name in
                   ("force_1_N", "displacement_1_m", "velocity_1_m_s"))
LEVEL = '[[level]]\nkind = "random"\nrms_N = {}\nband_Hz = [1.0, 20.0]\nsettle_s = 2.0\nduration_s = 20.0\n'


def commands_of(page):
    """Commands in the indented blocks of a page, continuation lines joined."""
    commands, inside, pending = [], False, ""
    for line in page.read_text().split("\n"):
        if line.startswith("```"):
            inside = not inside
        if inside or not line.startswith("    ") or line.startswith("        ") and not pending:
            pending = ""
            continue
        pending += line.strip()
        if pending.endswith("\\"):
            pending = pending[:-1]
            continue
        if re.match(r"(\S*/)?(host_sim|measured_examples|rig_controller)(?= )|python3 docs|(\./)?(host_sim|tests)/run\.sh"
                    r"|cmake |ctest |ssh |scp |sudo |cansend |candump |mpirun ", pending):
            commands.append(pending)
        pending = ""
    return commands


def commands_of_help(host_sim):
    commands = []
    environment = {**os.environ, "COLUMNS": "200"}
    for name in ("run", "estimate", "check", "diagnose", "sweep", "decode", "watch", "dbc"):
        text = subprocess.run([host_sim, name, "--help"], capture_output=True, text=True, env=environment).stdout
        commands += re.findall(r"^(?:Examples?:)?\s*((?:mpirun -np \d+ )?(?:host_sim|candump) .*\S)$", text.split("\n\n")[-1], re.M)
    return commands


def workspace(place, source, build, recordings):
    """What the pages take for granted: a rig file, recordings of it, a scenario, the build."""
    (place / "build").mkdir()
    (place / "build/host").symlink_to(build)
    shutil.copytree(source / "docs", place / "docs")
    (place / "hal/my_board").mkdir(parents=True)
    if recordings:
        (place / "recordings").symlink_to(recordings)
    for rate, folder in (("1000.0", "."), ("2048.0", "fast")):
        (place / "fixture.toml").write_text(f"sample_rate_Hz = {rate}\n" + FIXTURE + LEVEL.format("10.0") +
                                            LEVEL.format("30.0") + "[sensors]\nbits = 16\nnoise_percent = 1.0\n")
        subprocess.run(["build/host/bin/host_sim", "run", "--scenario", "fixture.toml", "--records", folder, "--log",
                        "run.log"], cwd=place, check=True, capture_output=True)
    for name, copy in (("level_1", "record"), ("level_1", "low_level"), ("level_2", "high_level"), ("level_2", "holdout")):
        shutil.copy(place / f"{name}.csv", place / f"{copy}.csv")
    (place / "my_rig.toml").write_text((place / "rig.toml").read_text() + CHANNELS)
    # A recorder with names of its own, acceleration in g and no time.
    rows = [row.split(",") for row in (place / "fast/level_2.csv").read_text().split()]
    force, acceleration = rows[0].index("force_1_N"), rows[0].index("acceleration_1_m_s2")
    (place / "run7.txt").write_text("Chan 1,Chan 3\n" + "".join(
        f"{row[force]},{float(row[acceleration]) / 9.80665:.9g}\n" for row in rows[1:]))


def main():
    source, build = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    shared = os.environ.get("RIG_SHARED_DIR", str(source / "../shared"))
    recordings = pathlib.Path(shared, "measured").resolve()
    recordings = recordings if recordings.is_dir() else None
    pages = [source / "README.md", *sorted((source / "docs").glob("*.md"))]
    todo = [(page.name, command) for page in pages for command in commands_of(page)]
    todo += [("help", command) for command in commands_of_help(str(build / "bin/host_sim"))]
    failures, ran, left, answered = [], 0, {}, set()
    with tempfile.TemporaryDirectory(prefix="every_command_") as folder:
        place = pathlib.Path(folder)
        workspace(place, source, build, recordings)
        environment = {**os.environ, "PATH": f"{build}/bin:{os.environ['PATH']}"}
        for page, command in todo:
            reason = next((why for pattern, why in CANNOT if re.search(pattern, command)), None)
            if reason is None and re.search(NEEDS_RECORDINGS, command):
                if "convert.py" in command:
                    reason = "needs the published files"
                elif recordings is None:
                    reason = "needs the recordings (RIG_SHARED_DIR)"
            if reason:
                left[reason] = left.get(reason, 0) + 1
                continue
            done = subprocess.run(["bash", "-c", "set -o pipefail; " + command], cwd=place, env=environment,
                                  capture_output=True, text=True, timeout=120)
            ran += 1
            if done.returncode != 0:
                failures.append(f"{page}: {command}\n  status {done.returncode}: {done.stderr.strip()[:400]}")
            for pattern, answer in ANSWERS:
                if re.search(pattern, command):
                    answered.add(pattern)
                    if not re.search(answer, done.stdout):
                        failures.append(f"{page}: {command}\n  does not answer {answer!r}: {done.stdout[:300]}")
    failures += [f"no page shows a command like {pattern!r}, whose answer is checked"
                 for pattern, _ in ANSWERS if pattern not in answered and (recordings or "measured" not in pattern)]
    for failure in failures:
        print(failure)
    for reason, count in left.items():
        print(f"{count} commands not run: {reason}")
    print(f"{ran} commands run, {len(failures)} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
