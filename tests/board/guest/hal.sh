# The tests of hal/linux on a kernel that has CAN, and on armhf GPIO lines with names and a converter.
interface_up vcan0
hal_test >/tmp/hal.log 2>&1
check hal_tests test $? -eq 0
grep -E "FAILED|SKIPPED|PASSED|Failure" -A 3 /tmp/hal.log
check can_tests_ran test "$(grep -c "OK.*OnVcan" /tmp/hal.log)" -ge 3
if [ -e /sys/bus/iio/devices/iio:device0 ]; then
  check converter_test_ran test "$(grep -c "OK.*OnConverter" /tmp/hal.log)" -eq 1
  check line_tests_ran test "$(grep -c "OK.*OnLine" /tmp/hal.log)" -eq 4
fi
