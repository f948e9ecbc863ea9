#!/usr/bin/env python3
"""RAM by object, flash and worst stack of the core at some capacities, on three processors.

  budget.py --write    measures everything and renews docs/memory_budget.md (some minutes)
  budget.py --check    measures RAM on the Cortex-M4, and code and stack of the smallest core there; exit status 1 where
                       one is more than the page says, 77 where the cross compiler is missing

The stack is the deepest path through the call graph that the compiler writes (-fcallgraph-info), without interrupts."""
import argparse
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(__file__).resolve().parents[2]
HERE = pathlib.Path(__file__).resolve().parent
PAGE = ROOT / "docs/memory_budget.md"
SKIPPED = 77
# As firmware/CMakeLists.txt does.
FOR_SIZE = (ROOT / "firmware/compiled_for_size.txt").read_text().split()
SIZE_OPTIONS = ["-Os", "-fno-move-loop-invariants", "-fno-schedule-insns2"]
CAPACITIES = {
    "3 / 5": dict(MAX_DOFS=3, MOVING_BASE=0, MAX_LINKS=4, MAX_UNKNOWNS=5, MAX_TERMS=12, MAX_EFFECTS=1, MAX_LEVELS=2,
                  MAX_BATCHES=6, MAX_WEIGHTS=2, MAX_PRODUCTS=48, BLOCK_SAMPLES=16, FILTER_HALF=0, MAX_WAITING=64,
                  CAN_FD=0),
    "8 / 10": dict(MAX_DOFS=8, MOVING_BASE=0, MAX_LINKS=10, MAX_UNKNOWNS=10, MAX_TERMS=32, MAX_EFFECTS=4, MAX_LEVELS=2,
                   MAX_BATCHES=8, MAX_WEIGHTS=2, MAX_PRODUCTS=144, BLOCK_SAMPLES=32, FILTER_HALF=0, MAX_WAITING=64),
    "16 / 48": dict(MAX_DOFS=16, MAX_LINKS=32, MAX_UNKNOWNS=48, MAX_TERMS=96, MAX_EFFECTS=16, MAX_LEVELS=2,
                    MAX_BATCHES=16, MAX_WEIGHTS=3, MAX_PRODUCTS=640, FILTER_HALF=28, MAX_WAITING=64),
}
# With the score tests: sums, probes and stretches that there is room for.
SCORE_TESTS = {
    "3 / 5": dict(WARRANT_NUMBERS=4096, WARRANT_PROBES=80, WARRANT_STRETCHES=16),
    "8 / 10": dict(WARRANT_NUMBERS=8192, WARRANT_PROBES=160, WARRANT_STRETCHES=16),
    "16 / 48": dict(WARRANT_NUMBERS=32768, WARRANT_PROBES=448, WARRANT_STRETCHES=32),
}
CORTEX = ("-mcpu=cortex-m4 -mthumb -mfloat-abi=soft -fno-threadsafe-statics --specs=nano.specs").split()
PROCESSORS = {
    "Cortex-M4": ("arm-none-eabi-", CORTEX),
    "armhf": ("arm-linux-gnueabihf-", ["-fno-pic"]),
    "arm64": ("aarch64-linux-gnu-", ["-fno-pic"]),
}
OBJECTS = {"CoreConfiguration": "configuration", "Conditioning": "conditioning", "Frame": "columns of a block",
           "EnergySums": "sums", "BatchTable": "batches", "BatchCollector": "collector",
           "IdentificationMemory": "solve", "Estimates": "estimates", "ScoreTests": "score tests"}


def definitions(capacity, tested):
    values = dict(CAPACITIES[capacity], **(SCORE_TESTS[capacity] if tested else dict(WARRANT_NUMBERS=0)))
    return [f"-DFIRMWARE_{name}={value}" for name, value in values.items()]


def compile_one(job):
    command, source, target = job
    if command[0].startswith("arm-none-eabi") and any(f"firmware/{name}" in str(source) for name in FOR_SIZE):
        command = [*command, *SIZE_OPTIONS]
    subprocess.run([*command, "-c", str(source), "-o", str(target)], check=True, cwd=target.parent)
    return target


def compiler(processor, capacity, tested):
    prefix, flags = PROCESSORS[processor]
    return [prefix + "g++", "-std=c++17", "-O2", "-w", "-fno-exceptions", "-fno-rtti", "-ffunction-sections",
            "-fdata-sections", *flags, *definitions(capacity, tested), "-I", str(ROOT)]


def ram(processor, capacity, tested, folder):
    target = compile_one((compiler(processor, capacity, tested), HERE / "objects.cpp", folder / "objects.o"))
    text = subprocess.run([PROCESSORS[processor][0] + "nm", "-S", target], check=True, capture_output=True, text=True)
    return {m.group(2): int(m.group(1), 16) for m in re.finditer(r"\S+ (\S+) . budget_(\w+)", text.stdout)}


def compiled_core(processor, capacity, tested, folder):
    command = compiler(processor, capacity, tested) + ["-fstack-usage", "-fcallgraph-info=su"]
    others = ("rig_controller", "can_protocol", "supervision", "excitation")
    stages = [path for path in (ROOT / "firmware").rglob("*.cpp")
              if path.relative_to(ROOT / "firmware").parts[0] not in others]
    sources = sorted(stages) + [HERE / "entry.cpp"]
    jobs = [(command, source, folder / (str(source.relative_to(ROOT)).replace("/", "_") + ".o")) for source in sources]
    with ThreadPoolExecutor(2) as pool:
        return list(pool.map(compile_one, jobs))


def flash(processor, objects, folder):
    prefix, flags = PROCESSORS[processor]
    program = folder / "program"
    subprocess.run([prefix + "g++", *flags, "-nostartfiles", "-nostdlib", "-static", "-Wl,--gc-sections", "-Wl,-e,entry",
                    "-Wl,--undefined=placed", "-Wl,--unresolved-symbols=ignore-all", "-Wl,--no-warn-rwx-segments",
                    *map(str, objects), "-lgcc", "-o", str(program)], check=True, capture_output=True)
    sizes = subprocess.run([prefix + "size", program], check=True, capture_output=True, text=True).stdout
    text, data = map(int, sizes.splitlines()[1].split()[:2])
    return text + data


class CallGraph:
    """Frames and calls of all object files; the deepest sum of frames from a function on."""

    def __init__(self, folder):
        self.frame, self.calls, self.name = {}, {}, {}
        for path in folder.glob("*.ci"):
            text = path.read_text()
            for title, label in re.findall(r'node: { title: "([^"]+)" label: "([^"]*)"', text):
                size = re.search(r"(\d+) bytes \(", label)
                if size:
                    self.frame[title] = max(self.frame.get(title, 0), int(size.group(1)))
                self.name[title] = label.split("\\n")[0]
            for source, target in re.findall(r'edge: { sourcename: "([^"]+)" targetname: "([^"]+)"', text):
                self.calls.setdefault(source, set()).add(target)
        # The only calls through a pointer are those of the force laws.
        self.laws = [title for title in self.frame if "effect_laws" in title]
        self.known = {}

    def depth(self, title, above=()):
        if title in above:
            raise RuntimeError(f"{title} calls itself: its stack has no bound")
        if title == "__indirect_call":
            return max((self.depth(law, above) for law in self.laws), default=0)
        if title not in self.known:
            deepest = max((self.depth(call, above + (title,)) for call in self.calls.get(title, ())), default=0)
            self.known[title] = self.frame.get(title, 0) + deepest
        return self.known[title]

    def of(self, pattern):
        found = [title for title in self.frame if re.search(pattern, title)]
        return max(self.depth(title) for title in found)


def measure(processor, capacity, tested, with_code=True):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        result = ram(processor, capacity, tested, folder)
        if with_code:
            objects = compiled_core(processor, capacity, tested, folder)
            result["flash"] = flash(processor, objects, folder)
            graph = CallGraph(folder)
            result["stack push"] = graph.of(r"EstimatorCore4push")
            result["stack solve"] = graph.of(r"EstimatorCore5solve")
        return result


COLUMNS = ["core and configuration", "score tests", "whole controller", "flash", "stack: sample", "stack: solve"]


def row_of(processor, capacity, tested, found):
    core = found["EstimatorCore"] + found["CoreConfiguration"] - found["ScoreTests"]
    numbers = [core, found["ScoreTests"] if tested else 0, found["RigController"], found.get("flash"),
               found.get("stack push"), found.get("stack solve")]
    return [processor, capacity, "yes" if tested else "no"] + numbers


def table(head, rows):
    lines = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    lines += ["| " + " | ".join("" if cell is None else f"{cell:,}" if isinstance(cell, int) else cell for cell in row) +
              " |" for row in rows]
    return "\n".join(lines)


def write_page():
    rows, objects = [], []
    for capacity in CAPACITIES:
        for tested in (False, True):
            for processor in PROCESSORS:
                found = measure(processor, capacity, tested)
                rows.append(row_of(processor, capacity, tested, found))
                if processor == "Cortex-M4" and not tested:
                    objects.append([capacity] + [found[name] for name in list(OBJECTS)[:-1]])
    macros = [[name] + ["default" if name not in CAPACITIES[c] and name not in SCORE_TESTS[c] else
                        str(dict(CAPACITIES[c], **SCORE_TESTS[c])[name]) for c in CAPACITIES]
              for name in list(CAPACITIES["3 / 5"]) + list(SCORE_TESTS["3 / 5"])]
    page = (HERE / "page.md").read_text()
    page = page.replace("TOTALS", table(["processor", "DOF / unknowns", "score tests", *COLUMNS], rows))
    page = page.replace("OBJECTS", table(["DOF / unknowns", *list(OBJECTS.values())[:-1]], objects))
    page = page.replace("MACROS", table(["`FIRMWARE_...`", *CAPACITIES], macros))
    PAGE.write_text(page)


def committed():
    rows = {}
    for line in PAGE.read_text().splitlines():
        cells = [cell.strip() for cell in line.strip("|").split("|")]
        if cells[0] in PROCESSORS and len(cells) == 3 + len(COLUMNS):
            rows[tuple(cells[:3])] = [int(cell.replace(",", "")) if cell else None for cell in cells[3:]]
    return rows


def check():
    if not shutil.which("arm-none-eabi-g++"):
        print("SKIPPED: no arm-none-eabi-g++; tests/run.sh installs it")
        return SKIPPED
    wanted, grown = committed(), 0
    for capacity in CAPACITIES:
        for tested in (False, True):
            found = measure("Cortex-M4", capacity, tested, with_code=capacity == "3 / 5" and not tested)
            row = row_of("Cortex-M4", capacity, tested, found)
            for what, number, limit in zip(COLUMNS, row[3:], wanted[tuple(row[:3])]):
                if number is not None and number > limit:
                    print(f"{capacity}, score tests {row[2]}: {what} takes {number:,} bytes, docs/memory_budget.md says {limit:,}")
                    grown += 1
    print(f"{grown} numbers have grown; where that is meant, tests/memory_budget/budget.py --write renews the page")
    return 1 if grown else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--check", action="store_true")
    a = parser.parse_args()
    if a.write:
        write_page()
        return 0
    return check()


if __name__ == "__main__":
    sys.exit(main())
