#!/usr/bin/env python3
"""The same bits on every processor, compiler and level of optimisation.

  identity.py SCENARIO_SCRIPT --build BUILD_FOLDER COMBINATION ...    compares with tests/bit_identity/answers.txt
  identity.py SCENARIO_SCRIPT --build BUILD_FOLDER --write            renews that file from the host's build
  identity.py --list                                                  the combinations

BUILD_FOLDER holds the presets' folders (build/host, build/cortex-m ...); what is not there is compiled below
build/identity. SCENARIO_SCRIPT writes what a board would sample in a scenario. Its codes come out of a simulation in
double precision, so another machine may write other codes: answers.txt has their check sum too, and where it differs
the answers of this machine's own host build are what the others are compared with.

Exit status 0 identical, 1 a difference, 77 nothing to compare with."""
import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import zlib

ROOT = pathlib.Path(__file__).resolve().parents[2]
ANSWERS = pathlib.Path(__file__).with_name("answers.txt")
SKIPPED = 77
# Scenario, samples of each level, words. Few samples a level: every stage has worked, and the emulators stay quick.
# ":x" measures force and displacement alone: the filters work.
RUNS = [
    ("paper_1dof", 1500, ""),
    ("paper_2dof_noise", 1200, ""),
    ("paper_3dof_free_decay", 1200, ""),
    ("paper_3dof_one_frequency", 1200, ""),
    ("paper_3dof_random_noise", 2500, ""),
    ("paper_3dof_random_noise", 2500, "plain"),
    ("paper_3dof_random", 1500, "frames"),
    ("paper_3dof_two_frequencies_noise", 1200, "frames"),
    ("paper_3dof_random_noise:x", 1200, ""),
]
CORTEX = "-mthumb -fno-exceptions -fno-rtti -fno-threadsafe-statics -ffunction-sections -fdata-sections"


def emulated(machine):
    return ["qemu-system-arm", "-M", machine, "-nographic", "-monitor", "none", "-serial", "none"]


# name: built program of a preset (or None), compiler, flags, how to run it
COMBINATIONS = {"host": ("host/bin/script_host", None, "", [])}
for optimised in ("-O0", "-O2", "-O3"):
    COMBINATIONS["gcc" + optimised] = (None, "g++", optimised, [])
    COMBINATIONS["clang" + optimised] = (None, "clang++", optimised, [])
COMBINATIONS["gcc-without-int128"] = (None, "g++", "-O2 -DFIRMWARE_WITHOUT_INT128", [])
COMBINATIONS["gcc-without-vectors"] = (None, "g++", "-O2 -DFIRMWARE_WITHOUT_VECTORS", [])
COMBINATIONS["armhf"] = ("arm-linux-gnueabihf/bin/script_host", None, "", ["qemu-arm", "-L", "/usr/arm-linux-gnueabihf"])
COMBINATIONS["arm64"] = ("aarch64-linux-gnu/bin/script_host", None, "", ["qemu-aarch64", "-L", "/usr/aarch64-linux-gnu"])
# Solves in slices give what solves in one piece give, in every shipped scenario. (Frames come later, so their order on the bus is
# another.)
SLICED = {"host-sliced": "host", "cortex-m4-sliced": "cortex-m4"}
SCENARIOS = ("paper_1dof paper_2dof paper_2dof_noise paper_3dof_two_frequencies paper_3dof_one_frequency "
             "paper_3dof_two_frequencies_noise paper_3dof_random paper_3dof_random_noise paper_3dof_free_decay").split()
SLICED_SAMPLES = 700
COMBINATIONS["cortex-m4"] = ("cortex-m/bin/rig_image", None, "", emulated("mps2-an386"))
# The board of the M3 runs what is compiled for the M0+, whose instructions are some of its own.
for core, machine in (("cortex-m0plus", "mps2-an385"), ("cortex-m3", "mps2-an385"), ("cortex-m7", "mps2-an500")):
    COMBINATIONS[core] = (None, "arm-none-eabi-g++", f"-O2 -mcpu={core} {CORTEX}", emulated(machine))


for name, whole in SLICED.items():
    COMBINATIONS[name] = COMBINATIONS[whole]


def sources(bare):
    own = ["run_core.cpp", "run_controller.cpp", "script_reader.cpp"]
    own += ["start_up.cpp", "semihosting.cpp", "image.cpp"] if bare else ["script_host.cpp"]
    switch = ROOT / "hal/bare_metal" / f"coroutine_{'cortex_m' if bare else 'ucontext'}.cpp"
    return sorted((ROOT / "firmware").rglob("*.cpp")) + [ROOT / "tests/bare_metal" / name for name in own] + [switch]


def compiled(name, compiler, flags, folder):
    """The program of a combination, each object as old as its newest source."""
    bare = compiler.startswith("arm-none-eabi")
    folder = folder / "identity" / name
    folder.mkdir(parents=True, exist_ok=True)
    launcher = [os.environ["CMAKE_CXX_COMPILER_LAUNCHER"]] if os.environ.get("CMAKE_CXX_COMPILER_LAUNCHER") else []
    newest = max(path.stat().st_mtime for pattern in ("firmware", "hal/interface", "hal/bare_metal", "tests/bare_metal")
                 for path in (ROOT / pattern).rglob("*.[hi]*"))
    objects = []
    for source in sources(bare):
        target = folder / (str(source.relative_to(ROOT)).replace("/", "_") + ".o")
        objects.append(target)
        if target.exists() and target.stat().st_mtime > max(newest, source.stat().st_mtime):
            continue
        subprocess.run(launcher + [compiler, "-std=c++17", "-w", *flags.split(), "-I", ROOT, "-c", source, "-o", target],
                       check=True)
    program = folder / "program"
    memory = ["-Wl,--defsym=image_large_memory=0x60000000"] if "cortex-m7" in flags else []  # as image.ld says
    link = [*memory, "-nostartfiles", "--specs=nano.specs", "-Wl,--gc-sections", "-T", ROOT / "tests/bare_metal/image.ld"]
    subprocess.run([compiler, *flags.split(), *objects, *(link if bare else []), "-o", program], check=True)
    return program


def program_of(name, build):
    """(command, None), or (None, why there is none)."""
    built, compiler, flags, run = COMBINATIONS[name]
    if run and not shutil.which(run[0]):
        return None, f"no {run[0]}"
    if built is None:
        if not shutil.which(compiler):
            return None, f"no {compiler}"
        return [*run, compiled(name, compiler, flags, build)], None
    path = build / built
    return ([*run, path], None) if path.exists() else (None, f"no {path}; tests/run.sh builds it")


def output_of(command, script, words):
    command = [str(word) for word in command]
    if command[0] == "qemu-system-arm":
        arguments = ",".join(f"arg={word}" for word in ["image", str(script), *words.split()])
        command[-1:] = ["-semihosting-config", f"enable=on,target=native,{arguments}", "-kernel", command[-1]]
    else:
        command += [str(script), *words.split()]
    text = subprocess.run(command, capture_output=True, text=True, timeout=900)
    if text.returncode != 0:
        return f"exit status {text.returncode}"
    # What the work cost is the machine's own.
    lines = [line for line in text.stdout.splitlines() if not re.match(r"(push|solve|step|slice)[a-z ]*: count|median", line)]
    return f"{zlib.crc32(chr(10).join(lines).encode()):08x} {len(lines)}"


def scripts(writer, folder):
    """Each run's script and the check sum of its bytes."""
    folder.mkdir(parents=True, exist_ok=True)
    made = {}
    for scenario, samples, _ in RUNS:
        path = folder / f"{scenario.replace(':', '_')}_{samples}.bin"
        name, *sensors = scenario.split(":")
        subprocess.run([writer, name, "1", path, str(samples), *sensors], check=True)
        made[scenario, samples] = (path, f"{zlib.crc32(path.read_bytes()):08x}")
    return made


def answers_of(command, made, sliced=False):
    return {run: (made[run[:2]][1], output_of(command, made[run[:2]][0], f"{run[2]} sliced" if sliced else run[2]))
            for run in RUNS if not (sliced and "frames" in run[2])}


def title(run):
    return f"{run[0]} {run[1]} {run[2] or 'full'}"


def read_answers():
    wanted = {}
    for line in ANSWERS.read_text().splitlines():
        words = line.split()
        if words and words[0] != "#":
            wanted[" ".join(words[:3])] = (words[3], " ".join(words[4:]))
    return wanted


def write_answers(found):
    lines = ["# What the core makes of each scenario: scenario, samples of a level, words, check sum of the codes,",
             "# check sum and number of the lines that come out. tests/bit_identity/identity.py --write renews it."]
    lines += [f"{title(run)} {codes} {answer}" for run, (codes, answer) in found.items()]
    ANSWERS.write_text("\n".join(lines) + "\n")


def compare_slices(name, command, writer, folder):
    wrong = 0
    for scenario in SCENARIOS:
        path = folder / f"{scenario}_{SLICED_SAMPLES}.bin"
        subprocess.run([writer, scenario, "1", path, str(SLICED_SAMPLES)], check=True)
        whole, sliced = (output_of(command, path, words) for words in ("", "sliced"))
        if whole != sliced:
            wrong += 1
            print(f"{name}: {scenario} gives {sliced} in slices, {whole} in one piece")
    print(f"{name}: {len(SCENARIOS) - wrong} of {len(SCENARIOS)} scenarios the same in slices")
    return wrong


def compare(name, found, wanted):
    wrong = 0
    for run, (codes, answer) in found.items():
        expected = wanted.get(title(run), ("", ""))
        if (codes, answer) != expected:
            wrong += 1
            print(f"{name}: {title(run)} gives {answer}, expected {expected[1]} (codes {codes}, expected {expected[0]})")
    print(f"{name}: {len(found) - wrong} of {len(found)} runs identical")
    return wrong


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("writer", nargs="?")
    parser.add_argument("combinations", nargs="*")
    parser.add_argument("--build", type=pathlib.Path, default=ROOT / "build")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--list", action="store_true")
    a = parser.parse_intermixed_args()
    if a.list:
        print("\n".join(COMBINATIONS))
        return 0
    if not a.writer or not pathlib.Path(a.writer).exists():
        print(f"SKIPPED: no {a.writer}")
        return SKIPPED
    made = scripts(a.writer, a.build / "identity" / "scripts")
    wanted = read_answers() if ANSWERS.exists() else {}
    if a.write or any(wanted.get(title(run), ("",))[0] != made[run[:2]][1] for run in RUNS):
        command, why = program_of("host", a.build)
        if why:
            print(f"SKIPPED: {why}")
            return SKIPPED
        found = answers_of(command, made)
        if a.write:
            write_answers(found)
            return 0
        print("the scenarios' codes are not those of answers.txt on this machine: compared with its own host build")
        wanted = {title(run): answer for run, answer in found.items()}
    wrong = skipped = 0
    for name in a.combinations:
        command, why = program_of(name, a.build)
        if why:
            print(f"{name}: SKIPPED, {why}")
            skipped += 1
            continue
        wrong += compare(name, answers_of(command, made, name in SLICED), wanted)
        if name in SLICED:
            wrong += compare_slices(name, command, a.writer, a.build / "identity" / "scripts")
    return 1 if wrong else SKIPPED if skipped == len(a.combinations) else 0


if __name__ == "__main__":
    sys.exit(main())
