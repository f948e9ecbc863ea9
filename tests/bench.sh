#!/usr/bin/env bash
# The long measurements, called by tests/run.sh --bench: docs/speed.md, docs/accuracy.md, docs/coverage.md, docs/estimate_coverage.md, docs/warrant.md, docs/diagnosis.md. They take about
# an hour on two cores; nothing else should run meanwhile. A page appears whole or not at all.
#   tests/bench.sh speed    docs/speed.md alone
set -euo pipefail
cd "$(dirname "$0")/.."
bin=build/host/bin

# measured PROGRAM ...: says what runs, and what the build does not have.
measured() {
  if [ ! -x "$bin/$1" ]; then
    echo "tests/bench.sh: SKIPPED $1, the build has no such program" >&2
    return 1
  fi
  echo "tests/bench.sh: $*" >&2
}

if measured bench_core; then
  "$bin/bench_core" --json build/host/bench_core.json > build/host/bench_core.txt
  {
    echo "# Speed of the core"
    echo
    echo "Measured by \`build/host/bin/bench_core\` (written by \`tests/run.sh --bench\`) on $(sed -n 's/^model name[^:]*: //p' /proc/cpuinfo | head -1)."
    echo "All rows are measured interleaved in one run; \`core\` is the plain sums, \`core_full\` adds the instrument and the"
    echo "displacement rows, the others are what a user would write in double precision with Eigen."
    echo
    sed 's/^/    /' build/host/bench_core.txt
    echo
    echo "\`core_full\` sums the displacement's rows only where a mass, a spring or the like is unknown: here none is."
    echo
    echo "## On a Cortex-M4, in instructions"
    echo
    echo "Counted by \`tests/bench/m4_counts.py\` in the emulator, over whole runs of 20 s a level from raw codes, without score"
    echo "tests. They are instructions, not cycles. A test fails where a count leaves \`tests/bench/m4_limits.txt\` by more than"
    echo "3 % in either direction."
    echo
    if [ -x build/cortex-m/bin/rig_image ]; then
      python3 tests/bench/m4_counts.py build --page
    else
      echo "SKIPPED: no build/cortex-m/bin/rig_image."
    fi
    echo
    echo "## \`estimate\` beside a script"
    echo
    echo "\`tests/bench/estimate_numpy.py\` is what a user would write: it reads the same two files and gives the numbers alone."
    echo "A user waits for wall time; processor time is that of all threads."
    echo
    if [ -x "$bin/host_sim" ] && /usr/bin/python3 -c "import numpy" 2> /dev/null; then
      "$bin/host_sim" run --scenario paper_3dof_random --records build/host/bench_records > /dev/null
      /usr/bin/python3 tests/bench/estimate_numpy.py --ratio "$bin/host_sim" build/host/bench_records/rig.toml \
        build/host/bench_records/level_1.csv build/host/bench_records/level_2.csv
    else
      echo "SKIPPED: no host_sim or no numpy."
    fi
    echo
    echo "## \`run\` beside real time"
    echo
    if [ -x "$bin/host_sim" ]; then
      python3 tests/bench/run_speed.py "$bin/host_sim"
    else
      echo "SKIPPED: no host_sim."
    fi
  } > build/host/speed.md
  mv build/host/speed.md docs/speed.md
fi
[ "${1:-all}" != speed ] || exit 0
# Every compiler, level of optimisation and processor; sizes at some capacities.
if measured scenario_script; then
  mapfile -t combinations < <(tests/bit_identity/identity.py --list)
  tests/bit_identity/identity.py "$bin/scenario_script" "${combinations[@]}" >&2
  python3 tests/memory_budget/budget.py --write
fi
if measured accuracy_report; then "$bin/accuracy_report" docs/accuracy.md; fi
if measured coverage_report; then "$bin/coverage_report" docs/coverage.md; fi
if measured host_sim; then python3 tests/accuracy/one_percent.py "$bin" --page docs/limits.md; fi
if measured host_sim; then tests/coverage/estimate_conditions.py "$bin" --page docs/estimate_coverage.md > /dev/null; fi
if measured warrant_bench; then "$bin/warrant_bench" --page docs/warrant.md --draws 100; fi
if measured diagnosis_report; then "$bin/diagnosis_report" --jobs "$(nproc)" docs/diagnosis.md; fi
if measured limit_report; then "$bin/limit_report" --draws 10 --out docs/detection_limits.md; fi
if measured condition_report; then
  python3 tests/diagnosis/conditions.py "$bin/condition_report" build/host/conditions --draws 20 --first-seed 1 --jobs "$(nproc)"
  python3 tests/diagnosis/conditions.py --page build/host/conditions docs/diagnosis_conditions.md docs/conditions_raw.txt
fi
