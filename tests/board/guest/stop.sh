# The rig is driven, then the emergency stop is pressed from outside: drive zero and relay off before the next sample, seen
# on the bus and on the line. Then the sensors fall silent, with the same result.
. /tests/relay.sh

sensors=$bus
interface_up "$bus"
[ "$bus" = can0 ] && { sensors=can1; interface_up can1; }
start_controller /drive.toml
candump -L "$bus,081:7FF,181:7FF,1C1:7FF,201:7FF,281:7EF,701:7FF" >/tmp/frames.log &
logger=$!
play() {
  canplayer -I /sensors.log "$sensors=vcan0" &
  player=$!
  sleep 0.1
  cansend "$sensors" 000#0101
}

cat /sys/kernel/debug/gpio
check relay_off_before_start line_is lo
play
sleep 1.5
check driving mode_is '[2345]'
check relay_on_while_driving line_is hi
relay_outside on
outside press
check stop_is_noticed await grep -q "after the edge" /tmp/controller.log
check relay_off_after_stop line_is lo
relay_outside off
grep "after the edge" /tmp/controller.log
usleep 50000
grep -B 40 -A 60 " 081#01FF" /tmp/frames.log >/tmp/stop.log
send_file /tmp/stop.log
kill $player
wait $player

outside release
sleep 0.5
cansend "$sensors" 000#8101
sleep 0.3
check reset_is_taken mode_is '[16]'
play
sleep 1
check drives_again line_is hi
kill $player
wait $player
check silent_sensors_are_noticed await grep -q "fault: samples lost (drive zero" /tmp/controller.log
check relay_off_without_sensors line_is lo
end_controller
cat /tmp/controller.log
check controller_ends_well test $status -eq 0
