#!/usr/bin/env python3
"""Tests the tests: changes one operator or constant of the numeric core at a time and counts the changes that no test notices.

  mutation.py --build build/host [--count 100] [--seed 1] [--only energy] [--report FILE.md]

A mutant is compiled by itself and linked before the core's archive, in place of its original, with the objects of the folder's
own test program, which must exist in the build. A mutant that does not compile is not counted; one that makes the test fail, crash or
run for more than the time limit is noticed. Exit status 0 when at least --least percent of the mutants were noticed."""
import argparse
import pathlib
import random
import re
import shlex
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
TESTS = {"fixed_point": ("tests/fixed_point", "fixed_point_tests"), "energy": ("tests/energy", "energy_tests"),
         "identification": ("tests/identification", "identification_tests")}
TIME_LIMIT_S = 60

SWAPS = [(r" \+ ", " - "), (r" - ", " + "), (r" \* ", " + "), (r" / ", " * "), (r" << ", " >> "), (r" >> ", " << "),
         (r" < ", " <= "), (r" <= ", " < "), (r" > ", " >= "), (r" >= ", " > "), (r" == ", " != "), (r" != ", " == "),
         (r" && ", " || "), (r" \|\| ", " && "), (r" \+= ", " -= "), (r" -= ", " += "), (r"\btrue\b", "false"),
         (r"\bfalse\b", "true"), (r"(?<![\w.])-(?=[a-z(])", "")]
NUMBER = re.compile(r"(?<![\w.'\[])(\d+)(?![\w.'\]])")  # array sizes are left alone
SKIP = re.compile(r"^\s*(//|#|using |static_assert|template|namespace|case |\}|class |struct )")


def mutants_of(path):
    found = []
    for number, line in enumerate(path.read_text().splitlines()):
        code = line.split("//")[0]
        if SKIP.match(code):
            continue
        for pattern, new in SWAPS:
            found += [(number, m.start(), m.end(), new) for m in re.finditer(pattern, code)]
        found += [(number, m.start(), m.end(), str(int(m.group()) + 1)) for m in NUMBER.finditer(code)]
    return found


def mutate(path, mutant):
    number, start, end, new = mutant
    lines = path.read_text().splitlines()
    before = lines[number]
    lines[number] = before[:start] + new + before[end:]
    return "\n".join(lines) + "\n", before.strip(), lines[number].strip()


def link_line(build, program):
    """Ninja's own command for the program, cut to what the linker needs."""
    text = subprocess.run(["ninja", "-C", build, "-t", "commands", f"bin/{program}"], check=True, capture_output=True,
                          text=True).stdout.strip().splitlines()[-1]
    command = next(part for part in text.split("&&") if f"-o bin/{program}" in part)
    return [word for word in shlex.split(command) if word != ":"]


def judge(build, folder, path, mutant, scratch):
    text, before, after = mutate(path, mutant)
    source, target, program = scratch / path.name, scratch / "mutant.o", scratch / "test"
    source.write_text(text)
    compiled = subprocess.run(["c++", "-std=c++17", "-O1", "-w", "-I", ROOT, "-c", source, "-o", target], capture_output=True)
    if compiled.returncode != 0:
        return "invalid", before, after
    words = link_line(build, TESTS[folder][1])
    words[words.index("-o") + 1] = str(program)
    words.insert(words.index("-o"), str(target))
    subprocess.run(words, check=True, cwd=build, capture_output=True)
    try:
        run = subprocess.run([program, "--gtest_fail_fast", "--gtest_brief=1"], capture_output=True, timeout=TIME_LIMIT_S,
                             cwd=scratch)
        verdict = "survived" if run.returncode == 0 else "noticed"
    except subprocess.TimeoutExpired:
        verdict = "noticed"
    return verdict, before, after


def report(rows, counts, target):
    noticed, survived = counts["noticed"], counts["survived"]
    total = max(noticed + survived, 1)
    lines = [f"{noticed} of {noticed + survived} mutants noticed ({100 * noticed // total} %), {counts['invalid']} did not compile",
             "", "| survivor | was | became |", "|---|---|---|"]
    lines += [f"| {place} | `{before}` | `{after}` |" for place, before, after in rows]
    print("\n".join(lines))
    if target:
        pathlib.Path(target).write_text("# Mutation test of the numeric core\n\n" + "\n".join(lines) + "\n")
    return 100 * noticed // total


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", default=str(ROOT / "build/host"))
    parser.add_argument("--count", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", choices=sorted(TESTS))
    parser.add_argument("--least", type=int, default=0)
    parser.add_argument("--seconds", type=float, default=3600.0, help="stop choosing new mutants after that time")
    parser.add_argument("--report")
    a = parser.parse_args()
    choices = []
    for folder in [a.only] if a.only else sorted(TESTS):
        if not pathlib.Path(a.build, "bin", TESTS[folder][1]).exists():
            print(f"no {TESTS[folder][1]} in {a.build}/bin: build it first", file=sys.stderr)
            return 2
        for path in sorted((ROOT / "firmware" / folder).glob("*.cpp")):
            choices += [(folder, path, mutant) for mutant in mutants_of(path)]
    random.Random(a.seed).shuffle(choices)
    counts, survivors, end = {"noticed": 0, "survived": 0, "invalid": 0}, [], time.monotonic() + a.seconds
    with tempfile.TemporaryDirectory() as scratch:
        for folder, path, mutant in choices:
            if counts["noticed"] + counts["survived"] >= a.count or time.monotonic() > end:
                break
            verdict, before, after = judge(a.build, folder, path, mutant, pathlib.Path(scratch))
            counts[verdict] += 1
            if verdict == "survived":
                survivors.append((f"{path.relative_to(ROOT)}:{mutant[0] + 1}", before, after))
    return 0 if report(survivors, counts, a.report) >= a.least else 1


if __name__ == "__main__":
    sys.exit(main())
