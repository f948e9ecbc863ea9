#!/usr/bin/env bash
# Installs what is missing (Debian 12), builds the simulator and runs it: ./host_sim/run.sh [options of `host_sim run`]
set -euo pipefail
cd "$(dirname "$0")/.."
. host_sim/prepare.sh
install_packages "${build_packages[@]}"
configure host
build host host_sim
exec build/host/bin/host_sim run "$@"
