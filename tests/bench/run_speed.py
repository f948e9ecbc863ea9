#!/usr/bin/env python3
"""How many times as fast as the rig `host_sim run` is.

  run_speed.py HOST_SIM [SCENARIO]     simulates it, lets the controller estimate from it, writes its frames; the shortest of nine

Wall time and processor time (of all threads) against the time that the measured samples stand for; settling is simulated too and does
not count."""
import json
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

REPETITIONS = 9


def main():
    if len(sys.argv) not in (2, 3) or sys.argv[1].startswith("-"):
        print(__doc__)
        return 2
    host_sim, scenario = pathlib.Path(sys.argv[1]).resolve(), (sys.argv[2:] or ["paper_3dof_random"])[0]
    wall_s, processor_s = [], []
    with tempfile.TemporaryDirectory() as folder:
        for _ in range(REPETITIONS):
            before, begun = resource.getrusage(resource.RUSAGE_CHILDREN), time.perf_counter()
            subprocess.run([host_sim, "run", "--scenario", scenario, "--json", "out.json", "--log", "run.log"], cwd=folder,
                           check=True, stdout=subprocess.DEVNULL)
            wall_s.append(time.perf_counter() - begun)
            after = resource.getrusage(resource.RUSAGE_CHILDREN)
            processor_s.append(after.ru_utime - before.ru_utime + after.ru_stime - before.ru_stime)
        out = json.loads((pathlib.Path(folder) / "out.json").read_text())
    samples_s = out["samples"] / out["sample_rate_Hz"]
    print(f"{scenario}: {samples_s:.1f} s of samples in {min(wall_s):.3f} s, {samples_s / min(wall_s):.0f} times real time; "
          f"{min(processor_s):.3f} s of processor time, {samples_s / min(processor_s):.0f} times")
    return 0


if __name__ == "__main__":
    sys.exit(main())
