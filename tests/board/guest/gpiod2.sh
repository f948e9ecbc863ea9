# The lines, and the stop, with the other generation of libgpiod.
rm /usr/bin/rig_controller
cp /usr/bin/rig_controller_gpiod2 /usr/bin/rig_controller
check program_uses_libgpiod_2 sh -c 'rig_controller --version | grep -q "libgpiod 2.x"'
rig_controller --version
gpio_test_gpiod2 >/tmp/gpio.log 2>&1
check gpio_tests test $? -eq 0
grep -E "FAILED|SKIPPED|PASSED|Failure" -A 3 /tmp/gpio.log
check line_tests_ran test "$(grep -c "OK.*OnLine" /tmp/gpio.log)" -eq 4
. /tests/stop.sh
