# 1 kHz for a long time, with the program in which every allocation after the start is fatal. Samples come as sensor frames,
# and where the board has a converter a second run reads that.
cp /usr/bin/rig_controller_guarded /usr/bin/rig_controller
interface_up vcan0
sed -e 's/^interface = .*/interface = "vcan0"/' -e 's/^wiring = "24"/wiring = "16"/' /board.toml >/tmp/board.toml
run() {
  what=$1
  shift
  start_controller --for "$seconds" "$1"
  first=$(grep VmRSS /proc/$controller/status)
  [ "$what" = frames ] && { sensor_player vcan0 $((seconds - 1)) || result sensors failed; }
  sleep 0.5
  [ "$what" = frames ] && check "memory_is_flat_$what" test "$(grep VmRSS /proc/$controller/status)" = "$first"
  wait $controller
  check "controller_ends_well_$what" test $? -eq 0
  cat /tmp/controller.log
  samples=$(sed -n 's/.*: \([0-9]*\) samples, 0 missed, 0 saturated; .*/\1/p' /tmp/controller.log)
  check "no_sample_missed_$what" test "${samples:-0}" -ge $(((seconds - 1) * 1000))
}
run frames /tmp/board.toml
[ -e /sys/bus/iio/devices/iio:device0 ] && run converter /iio_fast.toml
