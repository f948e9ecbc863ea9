#!/usr/bin/env bash
# The emulated boards: AST2600 (armhf: GPIO and ADC by the kernel's own drivers, vcan) and arm64 virt (two SJA1000 CAN
# controllers, PL061 GPIO), with Debian's kernels and the cross-built rig_controller. Called by tests/run.sh --board.
#   --bench       the endurance test takes 10 minutes of guest time instead of one
#   --only TESTS  these tests (package, hal, replay, stop, killed, kernel, settings, faults, session,
#                 samples, gpiod2, endurance) instead of all
# Downloads go to ${XDG_CACHE_HOME:-~/.cache}/rig_damping/board, results to build/board.
set -euo pipefail
cd "$(dirname "$0")/../.."
. host_sim/prepare.sh

seconds=60 only=
while [ $# -gt 0 ]; do
  case $1 in
    --bench) seconds=600 ;;
    --only) only=$2; shift ;;
    *) echo "tests/board/run.sh: unknown option $1, expected --bench or --only TESTS" >&2; exit 2 ;;
  esac
  shift
done

cache=${XDG_CACHE_HOME:-$HOME/.cache}/rig_damping/board
results=build/board
here=tests/board
rm -rf $results
mkdir -p $results "$cache"

skipped() {
  echo "tests/board/run.sh: SKIPPED, $*"
  exit 0
}

# ---- What the boards are made of
fetch() {
  local status=0
  $here/sysroot.sh "$1" >/dev/null || status=$?
  [ $status -ne 75 ] || skipped "the Debian packages of the $1 board could not be downloaded (message above)"
  return $status
}
fetch armhf
fetch arm64
# Debian 13's libgpiod, for one test; without it the others still run.
gpiod2=$($here/sysroot.sh armhf trixie) || gpiod2=

declare -A preset=([armhf]=arm-linux-gnueabihf [arm64]=aarch64-linux-gnu)
declare -A guest_programs=([arm64]="rig_controller_guarded hal_test sensor_player")
guest_programs[armhf]="${guest_programs[arm64]}${gpiod2:+ rig_controller_gpiod2 gpio_test_gpiod2}"
configure host
build host record_sensors board_reference host_sim
for arch in armhf arm64; do
  cmake --preset ${preset[$arch]} $([ -e build/${preset[$arch]}/CMakeCache.txt ] || echo -G Ninja) \
    -DRIG_SYSROOT="$cache/$arch/root" -DRIG_GUEST_TESTS=ON \
    -DRIG_GPIOD_2_ROOT="$([ $arch != armhf ] || echo "$gpiod2")" >&2
  build ${preset[$arch]} package ${guest_programs[$arch]}
  # The boards run what a user installs: the program and the network file out of the Debian package.
  rm -rf $results/$arch && mkdir $results/$arch
  dpkg-deb -x build/${preset[$arch]}/rig-controller_*_$arch.deb $results/$arch
done

# ---- What is played and what must come back
declare -A bus=([armhf]=vcan0 [arm64]=can0)
for arch in armhf arm64; do
  sed -e "s/@INTERFACE@/${bus[$arch]}/" -e '/@GPIO@/d' $here/board_head.toml >$results/head.toml
  build/host/bin/record_sensors paper_3dof_random 0.5 4 $results/sensors.log $results/head.toml $results/${arch}_board.toml
  { sed -e "s/@INTERFACE@/${bus[$arch]}/" -e "/@GPIO@/{r $here/${arch}_gpio.toml
d}" $here/drive_head.toml; sed -n '/^\[\[channel/,$p' $results/${arch}_board.toml; } >$results/${arch}_drive.toml
done
# For the session: sensors without acceleration, which fit a real bus of 1 Mbit/s beside the drive (rig_controller --check).
# Longer than it needs: the press comes from outside, where time does not stand still for the board.
{ build/host/bin/host_sim run --scenario paper_3dof_random --print
  echo 'channels = ["force", "displacement", "velocity"]'; } >$results/session_scenario.toml
build/host/bin/record_sensors $results/session_scenario.toml 0.5 12 $results/session_sensors.log $results/head.toml $results/session_board.toml
{ sed '/^\[\[channel/,$d' $results/arm64_drive.toml; sed -n '/^\[\[channel/,$p' $results/session_board.toml; } >$results/session.toml
sed 's/^rate_Hz = .*/rate_Hz = 1000/' $here/iio.toml >$results/iio_fast.toml
build/host/bin/board_reference $results/armhf_board.toml $results/sensors.log >$results/reference.log

# ---- The boards
dtb=$results/ast2600.dtb
cp "$cache"/armhf/root/usr/lib/linux-image-*/aspeed-ast2600-evb.dtb $dtb
for node in 1e6e9000 1e6e9100; do
  fdtput -t s $dtb /ahb/apb/adc@$node status okay
  fdtput -t u $dtb /ahb/apb/adc@$node aspeed,int-vref-microvolt 2500000
done
# The seed for random numbers that a boot loader adds (emulator.py says what it is for).
fdtput -p -t x $dtb /chosen rng-seed $(seq -f '%.0f' 1 8)
# The lines' names as a board's device tree gives them: gpioB0 is line 8, the next ones follow.
fdtput -t s $dtb /ahb/apb/gpio@1e780000 gpio-line-names "" "" "" "" "" "" "" "" \
  emergency_stop shaker_enable ready_lamp sync

make_initrd() {
  local arch=$1 arguments=() file
  shift
  for file in usr/bin/{candump,cansend,canplayer,cangen,gpioinfo} sbin/{ip,tc}; do arguments+=(--program $file); done
  for file in $here/guest/*.sh; do arguments+=(--file "$file=/tests/$(basename "$file")"); done
  for file in ${guest_programs[$arch]}; do arguments+=(--file build/${preset[$arch]}/bin/$file=/usr/bin/$file); done
  python3 $here/initrd.py --root "$cache/$arch/root" $([ $arch != armhf ] || echo ${gpiod2:+--root "$gpiod2"}) --out $results/$arch.gz --init $here/guest/init.sh \
    "${arguments[@]}" --file $results/$arch/usr/bin/rig_controller=/usr/bin/rig_controller \
    --file $results/sensors.log=/sensors.log --file $results/${arch}_board.toml=/board.toml \
    --file $results/${arch}_drive.toml=/drive.toml --file $here/iio.toml=/iio.toml \
    --file $results/$arch/usr/lib/systemd/system/rig_controller.service=/usr/lib/systemd/system/rig_controller.service \
    --file $results/iio_fast.toml=/iio_fast.toml "$@"
}
make_initrd armhf --module gpio-aspeed --module aspeed_adc --module vcan --module can-raw --module sch_tbf
make_initrd arm64 --program lib/systemd/systemd-networkd --program lib/systemd/systemd-udevd --program bin/udevadm \
  --file $results/arm64/usr/lib/systemd/network/80-rig-can.network=/lib/systemd/network/80-rig-can.network \
  --file $results/session.toml=/session.toml --file $results/session_sensors.log=/session_sensors.log \
  --file $results/arm64/usr/share/doc/rig-controller/board.example.toml=/board.example.toml \
  --file $results/arm64/usr/share/doc/rig-controller/80-rig-can-fd.network=/80-rig-can-fd.network \
  --module kvaser_pci --module vcan --module can-raw --module sch_tbf --module i6300esb

wanted() { [ -z "$only" ] || [[ " $only " = *" $1 "* ]]; }

# board_test ARCH TEST [option...]
board_test() {
  local arch=$1 test=$2
  shift 2
  wanted "$test" || return 0
  if [ "$test" = gpiod2 ] && [ -z "$gpiod2" ]; then
    echo "$arch gpiod2: SKIPPED, Debian 13's libgpiod could not be downloaded (message above)"
    return 0
  fi
  python3 $here/board_tests.py $arch $test --packages "$cache" --initrd $results/$arch.gz --results $results \
    --bus ${bus[$arch]} --seconds $seconds $([ $arch = armhf ] && echo --dtb $dtb) "$@" ||
    echo "$arch $test: FAILED"
}

# The estimates' frames of a board against those of this machine: identifier and data, in their order.
estimates() { grep -oE ' 4[0-7][0-9A-F]#[0-9A-F]+' "$1" || true; }
compare() {
  wanted replay || return 0
  local log=$results/$1_replay_estimates.log count
  count=$(estimates $results/reference.log | wc -l)
  if [ "$count" -gt 0 ] && cmp <(estimates $results/reference.log) <(estimates "$log"); then
    echo "$1 compare: $count estimate frames are those of this machine, byte for byte: 1 ok, 0 failed"
  else
    echo "$1 compare: FAILED, estimate frames differ: $results/reference.log, $log"
  fi
}

# The package holds what `cmake --install` copies, and asks for a C library as new as the program's symbols.
package_test() {
  wanted package || return 0
  local deb=build/${preset[$1]}/rig-controller_*_$1.deb folder=$results/$1 copy=$results/$1_installed asked newest
  cmake --install build/${preset[$1]} --prefix $copy/usr >/dev/null
  asked=$(dpkg-deb -f $deb Depends | sed -n 's/.*libc6 (>= \([0-9.]*\)).*/\1/p')
  newest=$(readelf -W --dyn-syms $folder/usr/bin/rig_controller | grep -o 'GLIBC_[0-9.]*' | cut -d_ -f2 | sort -uV | tail -n 1)
  if diff <(cd $folder && find . -type f | sort) <(cd $copy && find . -type f | sort) &&
    grep -q '^WatchdogSec=' $folder/usr/lib/systemd/system/rig_controller.service &&
    [ "$(dpkg-deb -f $deb Architecture)" = "$1" ] && printf '%s\n' "$newest" "$asked" | sort -CV; then
    echo "$1 package: $(find $folder -type f | wc -l) files as installed, libc6 $asked: 1 ok, 0 failed"
  else
    echo "$1 package: FAILED, $deb: files or dependencies (libc6 >= $asked, program $newest)"
  fi
}

# Both boards at a time, each its tests in order.
test_board() {
  local arch=$1
  package_test $arch
  board_test $arch hal
  board_test $arch replay
  compare $arch
  board_test $arch stop
  board_test $arch killed
  board_test $arch kernel --limit 300
  board_test $arch settings
  board_test $arch faults
  if [ $arch = arm64 ]; then
    board_test $arch session
  else
    board_test $arch samples
    board_test $arch gpiod2
  fi
  board_test $arch endurance --limit $((30 * seconds + 600))
  echo "$arch: all tests were run"
}
test_board arm64 >$results/arm64.out 2>&1 &
test_board armhf 2>&1 | tee $results/armhf.out || true
wait
cat $results/arm64.out

# A board that did not get to its end has failed, whatever it printed before.
counted() { cat $results/*.out | grep -cE "$1" || true; }
passed=$(counted '^(arm64|armhf) [a-z0-9]+: .*[0-9]+ ok, 0 failed')
failed=$(($(counted ': FAILED') + 2 - $(counted '^(arm64|armhf): all tests were run')))
skipped=$(counted ': SKIPPED')
echo "tests/board/run.sh: $passed passed, $failed failed, $skipped skipped"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
