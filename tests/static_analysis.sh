#!/usr/bin/env bash
# The layout of the sources (.clang-format), what cppcheck finds in those of the product (.cppcheck-suppressions) and clang-tidy
# in those that run on a board, firmware and hal (.clang-tidy). Everything must be clean. Part of .ci/run.
# host_sim has cppcheck alone: clang-tidy over its 440 files, with Eigen and toml++ in most, takes a quarter of an hour.
#   --quick   without clang-tidy, which takes two minutes on two cores
#   FILE...   clang-tidy for these alone
set -euo pipefail
cd "$(dirname "$0")/.."
. host_sim/prepare.sh
install_packages "${analysis_packages[@]}"

quick=no
[ "${1-}" != --quick ] || { quick=yes; shift; }
status=0
step() {
  local began=$SECONDS name=$1
  shift
  if "$@"; then echo "$name: clean ($((SECONDS - began)) s)"; else echo "$name: FAILED"; status=1; fi
}

sources() { git ls-files -- "$@" | grep -E '\.[ch]pp$'; }
layout() { sources . | xargs -P "$(nproc)" -n 40 clang-format --dry-run --Werror; }
# Without the sources of the other libgpiod and of no libgpiod, which this machine does not compile.
product() { git ls-files 'firmware/*.cpp' 'hal/*.cpp' 'host_sim/*.cpp' | grep -vE 'gpio_line_(v1|v2|none)\.cpp'; }
check() {
  product | cppcheck --file-list=- --enable=warning,portability --std=c++17 --language=c++ -I . -j "$(nproc)" --quiet \
    --inline-suppr --suppressions-list=.cppcheck-suppressions --error-exitcode=1
}
tidy() {
  { if [ $# -gt 0 ]; then printf '%s\n' "$@"; else product | grep -v '^host_sim/'; fi; } |
    nice xargs -P "$(nproc)" -n 2 clang-tidy -p build/host --quiet 2> >(grep -vE '^[0-9]+ warnings? |^Suppressed|^Use -header' >&2)
}

step clang-format layout
step cppcheck check
if [ $quick = no ]; then
  [ -e build/host/compile_commands.json ] || configure host
  step clang-tidy tidy "$@"
fi
exit $status
