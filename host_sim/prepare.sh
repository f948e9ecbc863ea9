# Sourced by host_sim/run.sh and tests/run.sh: Debian packages and the host build.

# What the host programs are built with.
build_packages=(g++ cmake ninja-build pkg-config libsundials-dev libeigen3-dev libboost-dev libtomlplusplus-dev libcli11-dev
  nlohmann-json3-dev libfmt-dev libmatio-dev libfftw3-dev libncurses-dev libjs-dygraphs)
# What the tests need on top: test and benchmark libraries, peers for the logs, cross compilers and emulators.
test_packages=(libgtest-dev libbenchmark-dev can-utils tshark python3 python3-pyte chromium python3-scipy libiio-dev libgpiod-dev
  clang g++-arm-linux-gnueabihf g++-aarch64-linux-gnu gcc-arm-none-eabi libnewlib-arm-none-eabi
  libstdc++-arm-none-eabi-newlib qemu-system-arm qemu-user device-tree-compiler)
# What tests/static_analysis.sh looks at the sources with.
analysis_packages=(clang-format clang-tidy cppcheck git)

# Prints the packages of its arguments that are not installed.
missing_packages() {
  local package
  for package in "$@"; do
    [ "$(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null)" = installed ] || echo "$package"
  done
}

# Installs what is missing; needs root (or sudo) only then.
install_packages() {
  local missing as_root=()
  mapfile -t missing < <(missing_packages "$@")
  [ ${#missing[@]} -eq 0 ] && return
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null; then
      echo "These Debian packages are missing, and there is no sudo to install them: ${missing[*]}" >&2
      return 1
    fi
    as_root=(sudo)
  fi
  echo "Installing: ${missing[*]}" >&2
  "${as_root[@]}" apt-get update -qq >&2
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends "${missing[@]}" >&2
}

# configure PRESET: with Ninja, unless the build folder already uses another generator.
configure() {
  local generator=()
  [ -e "build/$1/CMakeCache.txt" ] || generator=(-G Ninja)
  cmake --preset "$1" "${generator[@]}" >&2
}

# build PRESET [TARGET ...]
build() {
  local preset=$1 targets=()
  shift
  [ $# -eq 0 ] || targets=(--target "$@")
  cmake --build --preset "$preset" -j "$(nproc)" "${targets[@]}" >&2
}
