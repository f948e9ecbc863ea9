#!/usr/bin/env python3
"""What `cmake --install` puts on a board is what docs/board.md promises: packaging_test.py BUILD_FOLDER

The files are where the page and the unit look for them, systemd takes the unit, and the shipped example passes --check with
the installed program. Exit status 77: rig_controller is not built."""
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

FILES = [
    "bin/rig_controller",
    "lib/systemd/system/rig_controller.service",
    "lib/systemd/network/80-rig-can.network",
    "share/doc/rig-controller/board.example.toml",
    "share/doc/rig-controller/80-rig-can-fd.network",
    "share/doc/rig-controller/board.md",
    "share/doc/rig-controller/copyright",
]


def install(build, prefix):
    subprocess.run(["cmake", "--install", build, "--prefix", prefix], check=True, stdout=subprocess.DEVNULL)
    return [f"{name} is not installed" for name in FILES if not (prefix / name).exists()]


def check_unit(prefix):
    """Everything systemd has to say of the unit, with the program where it has been installed."""
    if shutil.which("systemd-analyze") is None:
        print("systemd-analyze is not here: the unit was not looked at")
        return []
    text = (prefix / FILES[1]).read_text()
    unit = prefix / "rig_controller.service"
    unit.write_text(text.replace("/usr/bin/rig_controller", str(prefix / "bin/rig_controller")))
    said = subprocess.run(["systemd-analyze", "verify", "--man=no", "--recursive-errors=no", unit],
                          capture_output=True, text=True).stderr
    return [line for line in said.splitlines() if "rig_controller" in line]


def check_example(prefix):
    """The example fits its bus: --check adds up the frames and refuses over 80 %."""
    done = subprocess.run([prefix / "bin/rig_controller", "--check", prefix / FILES[3]], capture_output=True, text=True)
    print(done.stdout, end="")
    wrong = [] if done.returncode == 0 else [f"--check of the example: {done.stderr.strip()}"]
    return wrong + ([] if "bus: " in done.stdout else ["--check does not say how much of the bus the example takes"])


def main():
    build = sys.argv[1]
    if not os.path.exists(os.path.join(build, "bin", "rig_controller")):
        print("rig_controller is not built")
        return 77
    with tempfile.TemporaryDirectory() as folder:
        prefix = pathlib.Path(folder)
        wrong = install(build, prefix)
        wrong = wrong or check_unit(prefix) + check_example(prefix)
    print("\n".join(wrong) or f"{len(FILES)} files installed")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
