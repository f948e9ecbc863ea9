# What the tests in the guest share. Lines that start with MARK are for the runner on the host.

# busybox has an own `ip` and `tc`, which know less, and prefers them to the real ones.
ip() { /sbin/ip "$@"; }
tc() { /sbin/tc "$@"; }

# Nothing more can be tested.
give_up() {
  result "$1" failed
  cat /tmp/controller.log
  echo "MARK end"
  sleep 1
  poweroff -f
}

# result NAME ok|failed [remark]
result() { echo "MARK result $*"; }

# check NAME COMMAND...: ok where the command succeeds
check() {
  name=$1
  shift
  if "$@"; then result "$name" ok; else result "$name" failed "$*"; fi
}

# send_file NAME: the host finds it in its results folder
send_file() {
  echo "MARK file $(basename "$1")"
  gzip -c "$1" | base64
  echo "MARK file-end"
}

# outside REQUEST: done outside the board when this returns; what was heard there is in $answer
outside() {
  echo "MARK outside $*"
  read -r answer
}

# Waits (in guest time) until a command succeeds, ten seconds at most.
await() {
  tries=0
  until "$@" >/dev/null 2>&1; do
    tries=$((tries + 1))
    [ $tries -lt 1000 ] || return 1
    usleep 10000
  done
}

# count ID FILE: frames of an identifier in a candump log
count() { grep -c " $1#" "$2"; }

interface_up() {
  case $1 in
    vcan*)
      ip link add dev "$1" type vcan
      ip link set "$1" mtu 72
      ;;
    can*) ip link set "$1" type can bitrate 1000000 restart-ms 100 berr-reporting on ;;
  esac
  ip link set "$1" txqueuelen 1000
  ip link set "$1" up
}

# start_controller FILE [option...]: in the background; its words go to /tmp/controller.log
start_controller() {
  rm -f /tmp/controller.log # of a start before: it says that it runs, too
  rig_controller "$@" 2>/tmp/controller.log &
  controller=$!
  await grep -q "node 1 on" /tmp/controller.log || give_up start
}

# Ends the controller; its status is in $status
end_controller() {
  kill -TERM $controller
  wait $controller
  status=$?
}
