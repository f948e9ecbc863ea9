#!/usr/bin/env python3
"""What the fixed-point core must not contain, read from its archive; and the stack that its functions take.

  footprint.py --archive LIB.a --machine x86|arm [--prefix arm-none-eabi-]   heap, floating point, exceptions, RTTI
  footprint.py --stack FOLDER --largest-frame BYTES                          table of the .su files below the folder
  footprint.py --self-test --compiler CXX --machine x86                      plants each forbidden thing and must find it
  footprint.py --version X.Y.Z --header version.hpp                          the two versions are the same

Exit status 0 clean, 1 something forbidden, 77 there is no such build."""
import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

SKIPPED = 77

FORBIDDEN_SYMBOLS = {
    "heap": r"^(malloc|calloc|realloc|free|aligned_alloc|posix_memalign|_Zn[wa]\w*|_Zd[la]P\w*)$",
    "exceptions": r"^(__cxa_(throw|rethrow|allocate_exception|begin_catch|end_catch)|_Unwind_\w+|__gxx_personality\w*)$",
    "RTTI": r"^(_ZT[IS]\w+|__dynamic_cast|_ZTVN10__cxxabiv1\w+)$",
    "start-up and shut-down code": r"^(__cxa_guard_\w+|__cxa_atexit|__aeabi_atexit)$",
    "floating point": r"^(__aeabi_[df]\w*|__aeabi_[iul]+2[df]|__(add|sub|mul|div|neg|fix\w*|float\w*|extend|trunc)[sdtx]f\w*|"
                      r"sinf?|cosf?|sqrtf?|powf?|expf?|logf?|fabsf?|lroundf?|floorf?|ldexpf?)$",
    "input and output": r"^(printf|puts|fopen|fwrite|snprintf|sprintf|_ZNSo\w*|_ZSt4cout)$",
}

# Arithmetic and conversions; plain moves of 16 bytes are how compilers copy structs.
FLOAT_INSTRUCTIONS = {
    "x86": r"\b(v?(add|sub|mul|div|sqrt|min|max|ucomi|comi|cmp\w*)[sp][sd]|v?cvt\w+|f(ld|st|add|sub|mul|div|ild|istp?|comi?p?)\w*)\b",
    "arm": r"\bv(add|sub|mul|div|sqrt|cmp|cvt|mla|neg|abs|ldr|str|mov)\b",
}


def output_of(command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


# Working memory that all estimators of a program would share. Constants with addresses in them are no such memory.
MUTABLE_SECTION = r"^\.(bss|data)(?!\.rel\.ro)"
# Who listens to a calculation's progress (firmware/fixed_point/work_meter.hpp): no number is kept in it, and it is null but for the
# slices that a board without an operating system runs.
SHARED_ON_PURPOSE = {"_ZN8firmware10work_meterE"}


def mutable_in(archive, prefix):
    found = []
    for line in output_of([prefix + "objdump", "-t", archive]).splitlines():
        words = line.split()
        if (len(words) >= 6 and words[2] == "O" and re.match(MUTABLE_SECTION, words[3]) and words[4].strip("0")
                and words[-1] not in SHARED_ON_PURPOSE):
            found.append(f"mutable globals: {words[-1]}")
    return found


def forbidden_in(archive, machine, prefix):
    found = mutable_in(archive, prefix)
    for line in output_of([prefix + "nm", "-A", archive]).splitlines():
        place, symbol = line.split(":")[-2], line.split()[-1]
        for kind, pattern in FORBIDDEN_SYMBOLS.items():
            if re.match(pattern, symbol):
                found.append(f"{kind}: {symbol} in {place}")
    function = ""
    for line in output_of([prefix + "objdump", "-d", "--no-show-raw-insn", archive]).splitlines():
        if line.endswith(">:"):
            function = line.split("<")[1][:-2]
        elif "\t" in line and re.search(FLOAT_INSTRUCTIONS[machine], line.split("\t", 1)[1].split("#")[0].split("<")[0]):
            found.append(f"floating point: {line.strip()} in {function}")
    return found


def check_archive(archive, machine, prefix):
    if not pathlib.Path(archive).exists():
        print(f"SKIPPED: no {archive}; tests/run.sh builds it")
        return SKIPPED
    found = forbidden_in(archive, machine, prefix)
    for line in found[:40]:
        print(line)
    members = len(output_of([prefix + "ar", "t", archive]).split())
    print(f"{archive}: {members} objects, {len(found)} forbidden symbols or instructions")
    return 1 if found or members < 20 else 0


def check_stack(folder, largest):
    rows = []
    for path in sorted(pathlib.Path(folder).rglob("*.su")):
        for line in path.read_text().splitlines():
            place, size, kind = line.split("\t")
            rows.append((int(size), kind, place))
    if not rows:
        print(f"SKIPPED: no .su files below {folder}; tests/run.sh builds them")
        return SKIPPED
    rows.sort(reverse=True)
    print(f"{len(rows)} functions; the largest frames in bytes:")
    for size, kind, place in rows[:15]:
        print(f"{size:6} {kind:8} {place}")
    bad = [row for row in rows if row[0] > largest or row[1] not in ("static", "dynamic,bounded")]
    for size, kind, place in bad:
        print(f"over {largest} bytes or of unknown size: {size} {kind} {place}")
    return 1 if bad else 0


PLANTED = {
    "heap": "int* f() { return new int(3); }",
    "exceptions": "void f(int x) { if (x) throw x; }",
    "RTTI": "struct A { virtual int g(); }; int A::g() { return 1; }",
    "start-up and shut-down code": "struct A { A(); ~A(); }; A& f() { static A a; return a; }",
    "floating point": "double f(double x) { return x * 3.1; }",
    "mutable globals": "static int count; int f() { return ++count; }",
    "input and output": "#include <cstdio>\nvoid f(int x) { printf(\"%d\", x); }",
}


def self_test(compiler, machine):
    missed = []
    with tempfile.TemporaryDirectory() as folder:
        for kind, text in PLANTED.items():
            source, target = pathlib.Path(folder, "planted.cpp"), pathlib.Path(folder, "planted.o")
            source.write_text(text)
            subprocess.run([compiler, "-O2", "-c", source, "-o", target], check=True)
            if not any(line.startswith(kind) for line in forbidden_in(str(target), machine, "")):
                missed.append(kind)
    print("not found:", missed if missed else "nothing, all planted things were seen")
    return 1 if missed else 0


def check_version(version, header):
    text = pathlib.Path(header).read_text()
    parts = [re.search(rf"kVersion{name} = (\d+)", text).group(1) for name in ("Major", "Minor", "Patch")]
    words = re.search(r'kVersionText\[\] = "([^"]+)"', text).group(1)
    print(f"CMakeLists.txt {version}, numbers {'.'.join(parts)}, text {words}")
    return 0 if version == ".".join(parts) == words else 1


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for name in ("--archive", "--machine", "--stack", "--compiler", "--version", "--header"):
        parser.add_argument(name)
    parser.add_argument("--prefix", default="")
    parser.add_argument("--largest-frame", type=int, default=4608)
    parser.add_argument("--self-test", action="store_true")
    a = parser.parse_args()
    if a.self_test:
        return self_test(a.compiler, a.machine)
    if a.stack:
        return check_stack(a.stack, a.largest_frame)
    if a.version:
        return check_version(a.version, a.header)
    return check_archive(a.archive, a.machine, a.prefix)


if __name__ == "__main__":
    sys.exit(main())
