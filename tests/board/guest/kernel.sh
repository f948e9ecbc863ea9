# The kernel itself stops while the rig is driven: the hardware's watchdog resets the board.
. /tests/relay.sh
sensors=$bus
interface_up "$bus"
[ "$bus" = can0 ] && { sensors=can1; interface_up can1; }
start_controller /drive.toml
candump -L "$bus,181:7FF" >/tmp/frames.log &
canplayer -I /sensors.log "$sensors=vcan0" &
sleep 0.1
cansend "$sensors" 000#0101
sleep 1.5
check driving mode_is '[2345]'
echo 0 >/proc/sys/kernel/panic # a panic is the end, the kernel does not restart by itself
echo "MARK reset-expected"
echo c >/proc/sysrq-trigger
sleep 60
