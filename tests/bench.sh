#!/usr/bin/env bash
# The long measurements, called by tests/run.sh --bench: docs/speed.md, docs/accuracy.md, docs/coverage.md, docs/warrant.md, docs/diagnosis.md. They take about
# an hour on two cores; nothing else should run meanwhile. A page appears whole or not at all.
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
  } > build/host/speed.md
  mv build/host/speed.md docs/speed.md
fi
if measured accuracy_report; then "$bin/accuracy_report" docs/accuracy.md; fi
if measured coverage_report; then "$bin/coverage_report" docs/coverage.md; fi
if measured warrant_bench; then "$bin/warrant_bench" --page docs/warrant.md --draws 100; fi
if measured diagnosis_report; then "$bin/diagnosis_report" --jobs "$(nproc)" docs/diagnosis.md; fi
if measured condition_report; then
  "$bin/condition_report" --draws 20 --table docs/diagnosis_conditions.md --raw docs/conditions_raw.txt
fi
