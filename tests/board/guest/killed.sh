# The program is killed while it drives: what its unit runs then leaves relay and drive safe, within 100 ms, and the hardware's
# watchdog disarmed; the program starts again. A start that fails arms nothing.
. /tests/relay.sh
unit=/usr/lib/systemd/system/rig_controller.service
stop_post=$(sed -n 's/^ExecStopPost=//p' $unit)
mkdir -p /etc/rig_controller
cp /drive.toml /etc/rig_controller/board.toml
watchdog=/sys/class/watchdog/watchdog0
watchdog_is() { [ "$(cat $watchdog/state)" = "$1" ]; }

sensors=$bus
interface_up "$bus"
[ "$bus" = can0 ] && { sensors=can1; interface_up can1; }
cat $watchdog/identity
check watchdog_sleeps_before watchdog_is inactive
start_controller /etc/rig_controller/board.toml
cat /tmp/controller.log
check hardware_watchdog_is_taken grep -q "guarded by /dev/watchdog0" /tmp/controller.log
check watchdog_counts watchdog_is active
candump -L "$bus,181:7FF,201:7FF,7FF:7FF" >/tmp/frames.log &
logger=$!
canplayer -I /sensors.log "$sensors=vcan0" &
player=$!
sleep 0.1
cansend "$sensors" 000#0101
sleep 1.5
check driving mode_is '[2345]'
check relay_on_while_driving line_is hi
relay_outside on

# As systemd does: the process is gone, whatever killed it, then its ExecStopPost runs. The markers are the bounds in time.
cansend "$sensors" 7FF#01
kill -KILL $controller
wait $controller
$stop_post
status=$?
cansend "$sensors" 7FF#02
check stop_post_ends_well test $status -eq 0
relay_outside off
check watchdog_disarmed watchdog_is inactive
usleep 200000
send_file /tmp/frames.log

start_controller /etc/rig_controller/board.toml
cat /tmp/controller.log
check starts_again grep -q "guarded by /dev/watchdog0" /tmp/controller.log
end_controller
check watchdog_disarmed_at_the_end watchdog_is inactive
kill $player
wait $player

sed 's/^relay = .*/relay = "no_such_line"/' /drive.toml >/tmp/broken.toml
rig_controller /tmp/broken.toml
check start_fails test $? -eq 1
check failed_start_arms_nothing watchdog_is inactive
# The other outputs are made safe nevertheless, and the status tells that one was not.
before=$(count 201 /tmp/frames.log)
rig_controller --safe /tmp/broken.toml
check unsafe_is_told test $? -eq 1
zero_was_sent() { [ "$(count 201 /tmp/frames.log)" -gt "$before" ]; }
check drive_zero_nevertheless await zero_was_sent
kill $logger
sleep 8
check board_stays_up true
