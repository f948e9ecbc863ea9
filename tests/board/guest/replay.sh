# A recorded sensor log is played on the bus; the controller's frames are logged and sent to the host for comparison.
# bus: the controller's interface. On a real one the sensors play on can1.
sensors=$bus
interface_up "$bus"
[ "$bus" = can0 ] && { sensors=can1; interface_up can1; }
start_controller /board.toml
candump -L "$bus,081:7FF,181:7FF,281:7EF,381:7FF,400:780,481:7FF,681:7FF,701:7FF" >/tmp/frames.log &
logger=$!
await grep -q . /tmp/frames.log
canplayer -I /sensors.log "$sensors=vcan0" || result canplayer failed
sleep 1
cansend "$sensors" 000#0201
sleep 1
end_controller
check controller_ends_well test $status -eq 0
kill $logger
cat /tmp/controller.log
grep -q " 0 lost, 0 frames lost" /tmp/controller.log
check every_sensor_frame_arrived test $? -eq 0
grep -E " (4[0-7].|281)#" /tmp/frames.log >/tmp/estimates.log
send_file /tmp/estimates.log
