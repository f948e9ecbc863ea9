"""A recording of 38 MB: what `estimate`, `check` and `diagnose` need beside its samples, and what they say of it.

long_recording.py HOST_SIM     3 DOF, 192 s at 1 kHz, ten channels: 1.92 million values, 15 MB of samples
"""
import os
import pathlib
import subprocess
import sys
import tempfile

SECONDS, CHANNELS, RATE_HZ = 192, 10, 1000
MOST_BESIDE_SAMPLES_MB = 150


def peak_MB(command, place):
    """Largest resident memory of the program; its output in place/said."""
    with open(place / "said", "w") as said:
        process = subprocess.Popen(command, stdout=said, stderr=subprocess.STDOUT)
        _, status, usage = os.wait4(process.pid, 0)
    if os.waitstatus_to_exitcode(status) != 0:
        raise SystemExit(f"{' '.join(map(str, command))}: {(place / 'said').read_text()}")
    return usage.ru_maxrss / 1024.0


def main():
    host_sim = str(pathlib.Path(sys.argv[1]).resolve())
    samples_MB = SECONDS * RATE_HZ * CHANNELS * 8 / 1e6
    failed = False
    with tempfile.TemporaryDirectory() as name:
        place = pathlib.Path(name)
        scenario = subprocess.run([host_sim, "run", "--scenario", "paper_3dof_random_noise", "--print"],
                                  capture_output=True, text=True, check=True).stdout
        head, first_level, _ = scenario.split("[[level]]")
        long_level = first_level.replace("duration_s = 20.0", f"duration_s = {SECONDS}.0")
        assert long_level != first_level
        (place / "long.toml").write_text(head + "[[level]]" + long_level)
        subprocess.run([host_sim, "run", "--scenario", place / "long.toml", "--records", place, "--log", place / "log"],
                       capture_output=True, check=True)
        data = place / "level_1.csv"
        print(f"{data.stat().st_size / 1e6:.0f} MB of CSV, {samples_MB:.0f} MB of samples")
        for command in ("check", "estimate", "diagnose"):
            peak = peak_MB([host_sim, command, "--rig", place / "rig.toml", "--data", data], place)
            print(f"{command}: {peak:.0f} MB, {peak - samples_MB:.0f} beside the samples")
            failed = failed or peak > samples_MB + MOST_BESIDE_SAMPLES_MB
        verdict = (place / "said").read_text().splitlines()[1]
        print(verdict)
        failed = failed or not verdict.startswith("none:")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
