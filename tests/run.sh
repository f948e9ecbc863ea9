#!/usr/bin/env bash
# Installs what is missing (Debian 12), builds everything and runs all tests.
#   --board   the emulated boards instead (downloads kernels on first use)
#   --bench   after the tests, the long measurements that write docs/accuracy.md, docs/diagnosis.md, docs/speed.md and
#             docs/memory_budget.md, and the bits of every compiler and processor
set -euo pipefail
cd "$(dirname "$0")/.."
. host_sim/prepare.sh

board=no bench=no
for argument in "$@"; do
  case $argument in
    --board) board=yes ;;
    --bench) bench=yes ;;
    -h | --help) sed -n '2,5s/^# \{0,1\}//p' "$0"; exit 0 ;;
    *) echo "tests/run.sh: unknown option $argument, expected --board or --bench" >&2; exit 2 ;;
  esac
done

install_packages "${build_packages[@]}" "${test_packages[@]}"

if [ $board = yes ]; then
  [ -x tests/board/run.sh ] || { echo "tests/run.sh: SKIPPED, no tests/board/run.sh in this checkout" >&2; exit 0; }
  arguments=()
  [ $bench = no ] || arguments=(--bench)
  exec tests/board/run.sh "${arguments[@]}"
fi

configure host
build host
# The core must compile for every board, also without an operating system.
# The programs beside it run in emulators (tests/bit_identity).
for preset in arm-linux-gnueabihf aarch64-linux-gnu cortex-m; do
  configure "$preset"
  program=script_host
  [ $preset != cortex-m ] || program=rig_image
  build "$preset" firmware_core $program
done

status=0
ctest --test-dir build/host -j "$(nproc)" --output-on-failure --output-junit ctest.xml || status=$?

if [ $bench = yes ] && [ $status -eq 0 ]; then
  tests/bench.sh || status=$?
fi

attribute() { tr -d '\n' < build/host/ctest.xml | sed -n "s/.*<testsuite[^>]*[[:space:]]$1=\"\([0-9]*\)\".*/\1/p"; }
echo "tests/run.sh: $(attribute tests) tests, $(attribute failures) failed, $(attribute skipped) skipped"
exit $status
