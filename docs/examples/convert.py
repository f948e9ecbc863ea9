#!/usr/bin/env python3
"""The published recordings of docs/examples_measured.md as CSV files for host_sim (needs python3-scipy).

convert.py emps DATA_EMPS.mat FOLDER
convert.py pendulum SinglePendulumDataForParameterEstimation.mat FOLDER
convert.py mr_damper FOLDER_WITH_ensaioN.1.mat FOLDER
"""
import pathlib
import sys

import numpy
import scipy.io


def write(path, step_s, head, columns, decimals):
    """Columns side by side after one of time; decimals: of each column."""
    path.parent.mkdir(parents=True, exist_ok=True)
    with open(path, "w") as stream:
        stream.write("t_s," + ",".join(head) + "\n")
        for i, row in enumerate(zip(*columns)):
            stream.write(f"{i * step_s:.{2 if step_s == 0.01 else 3}f}")
            stream.write("".join(f",{value:.{digits}f}" for value, digits in zip(row, decimals)) + "\n")
    print(f"{path}: {len(columns[0])} samples")


def emps(source, folder):
    """Position in m, motor voltage in V; the authors state 35.1507 N per V."""
    data = scipy.io.loadmat(source)
    write(folder / "emps.csv", 0.001, ["displacement_1_m", "force_1_N"],
          [data["qm"].ravel(), 35.1507 * data["vir"].ravel()], [8, 5])


def pendulum(source, folder):
    """Six pieces of one swing, counted from the upright position: the angle from the hanging one is pi less."""
    data = scipy.io.loadmat(source, squeeze_me=True)
    pieces = [piece[0] for name in ("Y_id", "Y_vad") for piece in data[name]]
    write(folder / "pendulum_free_swing.csv", 0.001, ["angle_1_rad"], [numpy.concatenate(pieces) - numpy.pi], [7])


def mr_damper(source, folder):
    """Displacement in mm, force in N, at 0 V; the samples before the crank runs evenly are left out."""
    for number, first in ((1, 236), (3, 212), (5, 286), (7, 319), (9, 246)):
        data = scipy.io.loadmat(pathlib.Path(source) / f"ensaio{number}.1.mat")
        last = first + {1: 2713, 3: 2726, 5: 2663, 7: 2630, 9: 2703}[number]
        write(folder / f"mr_damper_0V_record_{number:02}.csv", 0.01, ["displacement_1_m", "force_1_N"],
              [0.001 * data["dist"].ravel()[first:last], data["forc"].ravel()[first:last]], [7, 4])


if __name__ == "__main__":
    makers = {maker.__name__: maker for maker in (emps, pendulum, mr_damper)}
    if len(sys.argv) != 4 or sys.argv[1] not in makers:
        sys.exit(__doc__)
    makers[sys.argv[1]](sys.argv[2], pathlib.Path(sys.argv[3]))
