#!/usr/bin/env bash
# Fetches what the cross compiler and the emulated board of an architecture need, and prints the sysroot's folder.
# usage: sysroot.sh armhf|arm64            Debian 12
#        sysroot.sh armhf|arm64 trixie     Debian 13's libgpiod (2.x) alone, to stand before the other: "$(...);$(...)"
set -euo pipefail
cd "$(dirname "$0")"
packages=(busybox-static libstdc++6 can-utils gpiod libgpiod-dev iproute2 libgtest-dev)
case ${1-} in
  armhf) kernel=linux-image-armmp ;;
  arm64) kernel=linux-image-arm64 packages+=(systemd udev) ;;
  *) echo "usage: sysroot.sh armhf|arm64 [trixie]" >&2; exit 2 ;;
esac
cache=${XDG_CACHE_HOME:-$HOME/.cache}/rig_damping/board
if [ $# -gt 1 ]; then
  RELEASE=$2 ./fetch_packages.sh "$1" "$cache" none libgpiod-dev libgpiod3 >&2
  echo "$cache/$1-$2/root"
  exit
fi
./fetch_packages.sh "$1" "$cache" $kernel "${packages[@]}" >&2
echo "$cache/$1/root"
