# Samples of the board's own converter through its driver, single reads at 200 Hz.
interface_up vcan0
cat /sys/bus/iio/devices/iio:device0/name
start_controller --for 5 /iio.toml
wait $controller
check controller_ends_well test $? -eq 0
cat /tmp/controller.log
samples=$(sed -n 's/.*: \([0-9]*\) samples, 0 missed, 0 saturated; .*/\1/p' /tmp/controller.log)
check every_sample_taken test "${samples:-0}" -ge 999
