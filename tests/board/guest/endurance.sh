# 1 kHz for a long time, with the program in which every allocation after the start is fatal: samples as sensor frames; where
# the board has a converter, samples from that; and eleven seconds of driving, in which the table of energies gets full and
# its solve, long on this processor, must hold up neither drive nor supervision.
cp /usr/bin/rig_controller_guarded /usr/bin/rig_controller
interface_up vcan0
for file in board drive; do
  sed -e 's/^interface = .*/interface = "vcan0"/' -e 's/^wiring = "24"/wiring = "16"/' /$file.toml >/tmp/$file.toml
done

# judge WHAT SAMPLES: the controller that has just ended took at least so many, none missed, each step in time
judge() {
  check "controller_ends_well_$1" test $status -eq 0
  cat /tmp/controller.log
  longest=$(sed -n 's/.*longest step while measuring \([0-9]*\) us/\1/p' /tmp/controller.log)
  check "step_fits_into_a_sample_period_$1" test "${longest:-9999}" -lt 1000
  samples=$(sed -n 's/.*: \([0-9]*\) samples, 0 missed, 0 saturated; .*/\1/p' /tmp/controller.log)
  check "no_sample_missed_$1" test "${samples:-0}" -ge "$2"
}

start_controller --for "$seconds" /tmp/board.toml
first=$(grep VmRSS /proc/$controller/status)
sensor_player vcan0 $((seconds - 1)) || result sensors failed
sleep 0.5
check memory_is_flat test "$(grep VmRSS /proc/$controller/status)" = "$first"
wait $controller
status=$?
judge frames $(((seconds - 1) * 1000))

if [ -e /sys/bus/iio/devices/iio:device0 ]; then
  start_controller --for "$seconds" /iio_fast.toml
  wait $controller
  status=$?
  judge converter $(((seconds - 1) * 1000))
fi

start_controller --for 12 /tmp/drive.toml
sensor_player vcan0 13 &
player=$!
sleep 0.2
cansend vcan0 000#0101
wait $controller
status=$?
kill $player
check no_fault_while_driving sh -c '! grep -q "relay off" /tmp/controller.log'
judge driven 11000
