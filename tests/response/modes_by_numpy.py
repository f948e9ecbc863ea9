"""Modal table of `host_sim estimate --export` beside an eigen-solution of its own, made from the rig file.

modes_by_numpy.py HOST_SIM            frequencies and damping ratios of four rigs agree to 1e-6
modes_by_numpy.py HOST_SIM --draws N  and the 95 % intervals of N draws of noise hold the truth (a minute for 200)

Exit status 77: this machine has no numpy.
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import tomllib

try:
    import numpy as np
except ImportError:
    print("SKIPPED: python3-numpy is not installed")
    sys.exit(77)

RIGS = pathlib.Path(__file__).parent.parent / "reports/browser/rigs"
NAMES = {"mass": ("mass_kg", "inertia_kg_m2"), "stiffness": ("stiffness_N_m", "stiffness_N_m_rad"),
         "viscous": ("viscous_N_s_m", "viscous_N_m_s_rad")}


def modes(rig, estimates):
    """[(frequency in Hz, damping ratio)] of M a + C v + K x = 0, from the generalised eigenproblem of twice the size."""
    def value(table, kind, name):
        number = next((table[key] for key in NAMES[kind] if key in table), 0.0)
        return estimates[f"{kind}[{name}]"] if number == "estimate" else number

    n = len(rig["dof"])
    m, c, k = (np.zeros((n, n)) for _ in range(3))
    for i, dof in enumerate(rig["dof"]):
        m[i, i] = value(dof, "mass", i + 1)
    for link in rig["link"]:
        a, b = link["between"]
        for matrix, kind in ((c, "viscous"), (k, "stiffness")):
            q = value(link, kind, f"{a}-{b}")
            ends = [a - 1] + ([b - 1] if isinstance(b, int) and b > 0 else [])
            for i in ends:
                for j in ends:
                    matrix[i, j] += q if i == j else -q
    inverse = np.linalg.inv(m)
    a = np.block([[np.zeros((n, n)), np.eye(n)], [-inverse @ k, -inverse @ c]])
    values = np.linalg.eigvals(a)
    values = values[values.imag > 1e-6 * np.abs(values).max()]
    return sorted((abs(s) / (2 * np.pi), -s.real / abs(s)) for s in values)


def exported(host_sim, scenario, seed, folder):
    """Rig file, exported model, and the truth of the run."""
    def run(*words):
        done = subprocess.run([host_sim, *map(str, words)], capture_output=True, text=True)
        if done.returncode not in (0, 3):
            raise SystemExit(done.stderr)
    run("run", "--scenario", scenario, "--seed", seed, "--records", folder, "--log", folder / "run.log",
        "--json", folder / "run.json")
    data = [part for file in sorted(folder.glob("level_*.csv")) for part in ("--data", file)]
    run("estimate", "--rig", folder / "rig.toml", *data, "--export", folder / "model")
    truth = {p["name"]: p["truth"] for p in json.loads((folder / "run.json").read_text())["parameters"]}
    return (tomllib.loads((folder / "rig.toml").read_text()), json.loads((folder / "model/model.json").read_text()), truth)


def main():
    host_sim = str(pathlib.Path(sys.argv[1]).resolve())
    draws = int(sys.argv[3]) if len(sys.argv) > 3 else 0
    worst = 0.0
    for scenario in ("paper_3dof_random", "paper_2dof_noise", RIGS / "accelerometers.toml", RIGS / "shaker_table.toml"):
        with tempfile.TemporaryDirectory() as place:
            rig, model, _ = exported(host_sim, scenario, 1, pathlib.Path(place))
        estimates = {name: row[0] for name, row in zip(model["parameter_names"], model["parameter_value_std_low_high"])}
        ours = list(zip(model["natural_frequency_Hz_value_low_high"], model["damping_ratio_value_low_high"]))
        reference = modes(rig, estimates)
        assert len(ours) == len(reference), f"{scenario}: {len(ours)} modes, {len(reference)} by numpy"
        for (frequency, damping), (f, zeta) in zip(ours, reference):
            worst = max(worst, abs(frequency[0] / f - 1.0), abs(damping[0] / zeta - 1.0))
    print(f"largest relative difference of a frequency or damping ratio: {worst:.2g}")
    held = asked = 0
    for seed in range(1, draws + 1):
        with tempfile.TemporaryDirectory() as place:
            rig, model, truth = exported(host_sim, "paper_2dof_noise", seed, pathlib.Path(place))
        for interval, (_, zeta) in zip(model["damping_ratio_value_low_high"], modes(rig, truth)):
            held, asked = held + (interval[1] <= zeta <= interval[2]), asked + 1
    if asked:
        print(f"{held} of {asked} intervals of damping ratios hold the truth ({100.0 * held / asked:.1f} %)")
    # Both modes of a draw share its noise: at most twice the variance of independent trials; three deviations.
    enough = held >= 0.95 * asked - 3.0 * np.sqrt(2.0 * asked * 0.95 * 0.05)
    return 0 if worst < 1e-6 and enough else 1


if __name__ == "__main__":
    sys.exit(main())
