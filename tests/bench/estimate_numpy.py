#!/usr/bin/env python3
"""What a user would write in numpy in place of `host_sim estimate`, and how long both take.

  estimate_numpy.py DATA.csv ...               prints the dampers and the friction
  estimate_numpy.py --ratio HOST_SIM RIG.toml DATA.csv ...   times it and host_sim estimate, from the files to the numbers: wall time
                                               and processor time (of all threads), with all processors and with one; the shortest of
                                               nine. host_sim is started each time, the script's interpreter is not.

The rig is that of paper_3dof_random, written into the script: masses and springs known, a viscous damper in each of four links,
friction in the last. Energies of every DOF over intervals of 0.1 s, one least-squares solve. No intervals, no check of the data, no
test of the model, no simulation of the result."""
import os
import resource
import subprocess
import sys
import time

import numpy as np

MASSES_KG = (1.5, 1.3, 2.0)
LINKS = ((0, None), (0, 1), (1, 2), (2, None))
STIFFNESS_N_PER_M, WINDOW_S = 10000.0, 0.1
REPETITIONS = 9


def energies(path):
    with open(path) as file:
        names = file.readline().split(",")
    table = np.loadtxt(path, delimiter=",", skiprows=1)
    zero = np.zeros(len(table))

    def channel(kind, dof):
        found = [i for i, name in enumerate(names) if dof is not None and name.startswith(f"{kind}_{dof + 1}_")]
        return table[:, found[0]] if found else zero

    starts = np.arange(0, len(table) - 1, max(1, round(WINDOW_S / (table[1, 0] - table[0, 0]))))
    rows, right = [], []
    for dof, mass_kg in enumerate(MASSES_KG):
        power = channel("force", dof) - mass_kg * channel("acceleration", dof)
        terms = [zero] * (len(LINKS) + 1)
        for number, link in enumerate(LINKS):
            if dof not in link:
                continue
            other = link[1 - link.index(dof)]
            power = power - STIFFNESS_N_PER_M * (channel("displacement", dof) - channel("displacement", other))
            terms[number] = channel("velocity", dof) - channel("velocity", other)
        if dof in LINKS[-1]:
            terms[-1] = np.sign(terms[-2])
        integrals = [np.add.reduceat(channel("velocity", dof) * term, starts) for term in (*terms, power)]
        rows.append(np.array(integrals[:-1]).T)
        right.append(integrals[-1])
    return np.vstack(rows), np.concatenate(right), len(MASSES_KG) * len(table)


def estimate(paths):
    parts = [energies(path) for path in paths]
    solution = np.linalg.lstsq(np.vstack([p[0] for p in parts]), np.concatenate([p[1] for p in parts]), rcond=None)[0]
    return solution, sum(p[2] for p in parts)


def processor_s():
    children = resource.getrusage(resource.RUSAGE_CHILDREN)
    return time.process_time() + children.ru_utime + children.ru_stime


def timed(work):
    begun, begun_processor = time.perf_counter(), processor_s()
    work()
    return time.perf_counter() - begun, processor_s() - begun_processor


def compare(host_sim, rig, paths):
    samples = estimate(paths)[1]
    command = [host_sim, "estimate", "--rig", rig, "--data", *paths]
    own, theirs = [], []
    for _ in range(REPETITIONS):  # by turns, the shortest of each: what else runs on the machine hits both
        own.append(timed(lambda: estimate(paths)))
        theirs.append(timed(lambda: subprocess.run(command, check=True, stdout=subprocess.DEVNULL)))
    words = []
    for one, other in zip(map(min, zip(*own)), map(min, zip(*theirs))):
        words.append(f"numpy {samples / one / 1e6:.2f} and host_sim estimate {samples / other / 1e6:.2f} million DOF samples a second"
                     f"{' of processor time' if words else ''}: {one / other:.2f} times as fast")
    return "; ".join(words)


def main():
    if len(sys.argv) > 4 and sys.argv[1] == "--ratio":
        processors = os.sched_getaffinity(0)
        print(f"{len(processors)} processors: {compare(*sys.argv[2:4], sys.argv[4:])}")
        if len(processors) > 1:
            os.sched_setaffinity(0, {max(processors)})
            print(f"\n1 processor: {compare(*sys.argv[2:4], sys.argv[4:])}")
        return 0
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        print(__doc__)
        return 2
    solution, _ = estimate(sys.argv[1:])
    print(" ".join(f"{value:.6g}" for value in solution))
    return 0


if __name__ == "__main__":
    sys.exit(main())
