# A first session (docs/board_session.md): can0 comes up by the shipped network file, the estimates of a rig whose sensors
# play on the bus are logged, the emergency stop is pressed.
echo "root:x:0:0:root:/root:/bin/sh" >/etc/passwd
echo "systemd-network:x:101:101::/:/bin/false" >>/etc/passwd
echo "root:x:0:" >/etc/group
echo "systemd-network:x:101:" >>/etc/group
mkdir -p /run/systemd/network /run/udev
# The file for CAN FD is read too, for an interface that is not there: this board's controllers are for classic CAN.
sed 's/^Name=.*/Name=canfd0/' /80-rig-can-fd.network >/run/systemd/network/70-rig-can-fd.network
/lib/systemd/systemd-udevd --daemon
udevadm trigger --type=devices --action=add
udevadm settle --timeout=30
SYSTEMD_LOG_LEVEL=info /lib/systemd/systemd-networkd >/tmp/networkd.log 2>&1 &
brought_up() { ip -d link show can0 | grep -q "state UP" && ip -d link show can0 | grep -q "bitrate 1000000"; }
check can0_comes_up_by_the_network_file await brought_up
cat /tmp/networkd.log
# It knows every word of both files.
check network_files_are_understood sh -c '! grep -iE "unknown|failed to parse|invalid" /tmp/networkd.log'
ip -d link show can0
check restart_after_bus_off sh -c '/sbin/ip -d link show can0 | grep -q "restart-ms 100"'
check bus_errors_reported sh -c '/sbin/ip -d link show can0 | grep -q BERR-REPORTING'

interface_up can1 2>/dev/null # up already, by the same file
check session_fits_its_bus rig_controller --check /session.toml
check example_fits_its_bus rig_controller --check /board.example.toml
start_controller /session.toml
candump -L can0,081:7FF,181:7FF,201:7FF,400:780,681:7FF,701:7FF >/tmp/frames.log &
canplayer -I /session_sensors.log can1=vcan0 &
player=$!
sleep 0.1
cansend can1 000#0101
sleep 3.5
outside press
check stop_is_noticed await grep -q "after the edge" /tmp/controller.log
sleep 0.5
kill $player
end_controller
cat /tmp/controller.log
# All but the drive commands, of which there is one for each sample: a few at the start and around the stop.
grep -v " 201#" /tmp/frames.log >/tmp/session.log
grep " 201#" /tmp/frames.log | tail -n 5 >>/tmp/session.log
sort /tmp/session.log >/tmp/sorted.log
mv /tmp/sorted.log /tmp/session.log
check driven_until_the_stop sh -c 'grep -m 1 " 081#" /tmp/frames.log | grep -q "081#01FF"'
send_file /tmp/session.log
