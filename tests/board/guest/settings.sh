# Settings over the bus (SDO): changed, saved to the board's own files, there again after a restart; "load" takes them back.
sensors=$bus
interface_up "$bus"
[ "$bus" = can0 ] && { sensors=can1; interface_up can1; }
candump -D -L "$bus,581:7FF" >/tmp/replies.log &
answered() { [ "$(count 581 /tmp/replies.log)" -gt "$before" ]; }
# ask NAME REQUEST REPLY: a request to node 1, and how its reply begins
ask() {
  before=$(count 581 /tmp/replies.log)
  cansend "$sensors" "601#$2"
  await answered
  check "$1" sh -c "tail -n 1 /tmp/replies.log | grep -q '581#$3'"
}

start_controller /board.toml
ask heartbeat_is_the_files 4017100000000000 4B1710006400
ask heartbeat_changes 2B171000FA000000 60171000
ask saved 2310100173617665 60101001
end_controller
ls -l /var/state
start_controller /board.toml
ask heartbeat_is_as_saved 4017100000000000 4B171000FA00
ask loaded 231110016C6F6164 60111001
end_controller
start_controller /board.toml
ask heartbeat_is_the_files_again 4017100000000000 4B1710006400
end_controller
check controller_ends_well test $status -eq 0
tail -n 3 /tmp/replies.log
