# The tests of hal/linux on a kernel that has CAN.
interface_up vcan0
hal_test >/tmp/hal.log 2>&1
check hal_tests test $? -eq 0
grep -E "FAILED|SKIPPED|PASSED" /tmp/hal.log
check can_tests_were_not_skipped test "$(grep -c SKIPPED /tmp/hal.log)" -eq 0
