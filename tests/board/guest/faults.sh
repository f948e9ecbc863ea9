# Bus faults, ten times each in a row: the node is back with a heartbeat, its counters are right, nothing has leaked.
interface_up "$bus"
[ "$bus" = can0 ] && interface_up can1
start_controller /board.toml
candump -D -L "$bus,081:7FF,281:7EF,701:7FF" >/tmp/frames.log &
logger=$!
await grep -q " 281#" /tmp/frames.log
descriptors=$(ls /proc/$controller/fd | wc -l)
memory=$(grep VmRSS /proc/$controller/status)

back() { await fresh_heartbeat; }
fresh_heartbeat() { [ "$(count 701 /tmp/frames.log)" -gt "$before" ]; }
# ten NAME COMMAND...: each time the fault, then a heartbeat
ten() {
  name=$1 missing=0
  shift
  for i in 1 2 3 4 5 6 7 8 9 10; do
    "$@"
    before=$(count 701 /tmp/frames.log)
    back || missing=$((missing + 1))
  done
  check "heartbeat_after_$name" test $missing -eq 0
}
# Bytes of the newest frame 281 (health) and 291 (bus health).
byte() { grep " $1#" /tmp/frames.log | tail -n 1 | cut -d'#' -f2 | cut -c$((2 * $2 + 1))-$((2 * $2 + 2)); }
counted() {
  sleep 1.2
  check "counted_$1" test "$(byte "$2" "$3")" = 0A
}

inject() { cansend "$bus" "$1"; usleep 20000; }
bus_off() { inject 20000040#0000000000000000; }
restarted() { inject 20000100#0000000000000000; }
off_and_back() { bus_off; restarted; }
passive() { inject 20000004#0030000000000000; inject 20000004#0040000000000000; }
overflow() { inject 20000004#0001000000000000; }
down_and_up() {
  ip link set "$bus" down
  usleep 200000
  ip link set "$bus" up
}
# A frame takes 16 bytes: two at once, two waiting, one each 160 ms. At least 12 are due in the 600 ms.
full_queue() {
  tc qdisc add dev "$bus" root tbf rate 800bit burst 40 limit 32
  usleep 600000
  tc qdisc del dev "$bus" root
}

if [ "$bus" = vcan0 ]; then
  ten bus_off_and_restart off_and_back
  counted bus_off 281 7
  counted restarts 291 0
  ten bus_off_without_a_word bus_off
  sleep 1.2
  check counted_silent_bus_off test "$(byte 281 7)" = 14
  ten error_passive passive
  counted error_passive 291 1
  ten overflow overflow
  counted overflow 291 2
else
  cangen can1 -I 700 -L 8 -g 2 -i &
  load=$!
fi
ten interface_down down_and_up
counted interface_down 291 3
ten full_queue full_queue
kill $load 2>/dev/null

check nothing_leaked test "$(ls /proc/$controller/fd | wc -l)" -eq "$descriptors"
check memory_is_flat test "$(grep VmRSS /proc/$controller/status)" = "$memory"
end_controller
cat /tmp/controller.log
grep -q " 0 refused by a full queue" /tmp/controller.log
check queue_was_full test $? -ne 0
check controller_ends_well test $status -eq 0
