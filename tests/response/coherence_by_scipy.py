"""usage: coherence_by_scipy.py HOST_SIM FOLDER: coherence and frequency response of `host_sim estimate --export` beside
scipy's. Exit status 77: this machine has no scipy."""
import csv, os, subprocess, sys
try:
    import numpy as np
    from scipy import signal
except ImportError:
    print("SKIPPED: python3-scipy is not installed")
    sys.exit(77)

host_sim, folder = os.path.abspath(sys.argv[1]), sys.argv[2]
os.makedirs(folder, exist_ok=True)
os.chdir(folder)
def run(*words):
    subprocess.run([host_sim, *words], check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)

run("run", "--scenario", "paper_3dof_random_noise", "--records", "records", "--log", "run.log")
run("estimate", "--rig", "records/rig.toml", "--data", "records/level_1.csv", "--export", "export")

def columns(path):
    with open(path) as file:
        rows = list(csv.reader(file))
    return {name: np.array([float(row[i]) for row in rows[1:]]) for i, name in enumerate(rows[0])}

record = columns("records/level_1.csv")
force = record["force_1_N"]
worst = 0.0
for dof in (1, 2, 3):
    ours = columns(f"export/response_{dof}.csv")
    length = 2 * len(ours["frequency_Hz"])
    motion = record[f"acceleration_{dof}_m_s2"]
    settings = dict(fs=1000.0, window="hann", nperseg=length, noverlap=length // 2, detrend="constant")
    frequency, coherence = signal.coherence(force, motion, **settings)
    cross = signal.csd(force, motion, **settings)[1]
    power = signal.welch(force, **settings)[1]
    response = np.abs(cross / power)
    assert np.allclose(frequency[1:], ours["frequency_Hz"], rtol=1e-7), "other frequencies"
    # the last bin is scipy's without its doubling: the ratio is the same
    worst = max(worst, np.max(np.abs(coherence[1:] - ours["coherence"])),
                np.max(np.abs(response[1:] / ours["measured"] - 1.0)))
print(f"largest difference {worst:.2g}")
sys.exit(0 if worst < 1e-6 else 1)
