#!/usr/bin/env python3
"""Mixing fixed-point formats must not compile: must_not_compile.py COMPILER SOURCE_ROOT

Each case is one line. The good ones prove that the frame around them compiles; the bad ones must be refused."""
import subprocess
import sys

FRAME = """
#include "firmware/acquisition/columns.hpp"
#include "firmware/excitation/drive.hpp"
#include "firmware/fixed_point/fixed.hpp"
#include "firmware/fixed_point/scaled.hpp"
using namespace firmware;
using Code = Fixed<int32_t, 0>;
using FilterTap = Fixed<int32_t, 24>;
using Fraction = Fixed<int32_t, 16>;
void f(Code code, FilterTap tap, Fraction fraction, Drive drive, Fixed<int64_t, 24> wide, Scaled scaled, Frame& frame) {
  (void)frame, (void)code, (void)tap, (void)fraction, (void)drive, (void)wide, (void)scaled;
  CASE
}
"""

GOOD = [
    "auto sum = code + code; (void)sum;",
    "auto product = code * tap; product = wide; (void)product;",
    "bool less = fraction < fraction; (void)less;",
    "Fraction made = rescale<Fraction>(drive); (void)made;",
    "auto sum = wide + rescale<Fixed<int64_t, 24>>(code); (void)sum;",
    "frame.effect(0).put(1, frame.effect(0)[0]); frame.codes(0).put(1, 4 * frame.codes(0)[0]);",
    "frame.passed_sign(0).put(0, rescale<PassedSign>(frame.codes(0)[0]));",
]

BAD = [
    "auto sum = code + tap; (void)sum;",
    "auto difference = fraction - drive; (void)difference;",
    "bool less = tap < fraction; (void)less;",
    "bool equal = drive == fraction; (void)equal;",
    "code = tap;",
    "Fraction made = drive; (void)made;",
    "Drive made = 0.5; (void)made;",
    "Drive made = 5; (void)made;",
    "int32_t raw = drive; (void)raw;",
    "auto sum = drive + 1; (void)sum;",
    "auto sum = wide + code; (void)sum;",
    "auto product = wide * code; (void)product;",      # 64-bit factor: the product would not fit
    "auto product = code * code; product = wide; (void)product;",  # 0 fraction bits against 24
    "auto sum = scaled + drive; (void)sum;",
    "Scaled made = 5; (void)made;",
    "double value = drive; (void)value;",
    "frame.effect(0).put(0, frame.codes(0)[0]);",
    "frame.passed_sign(0).put(0, frame.codes(0)[0]);",
    "frame.codes(0).put(0, frame.codes(0)[0] * tap);",
    "frame.codes(0).put(0, 5);",
]


def compiles(compiler, root, case):
    command = [compiler, "-std=c++17", "-fsyntax-only", "-w", "-I", root, "-x", "c++", "-"]
    return subprocess.run(command, input=FRAME.replace("CASE", case), capture_output=True, text=True).returncode == 0


def main():
    compiler, root = sys.argv[1:]
    wrong = [case for case in GOOD if not compiles(compiler, root, case)]
    wrong += [case for case in BAD if compiles(compiler, root, case)]
    for case in wrong:
        print("refused although good:" if case in GOOD else "compiles although wrong:", case)
    print(f"{len(GOOD)} good and {len(BAD)} bad lines, {len(wrong)} judged wrongly")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
