# The relay and the mode of a driven board, for the tests that drive.
relay=$(sed -n 's/^relay = "\(.*\)"/\1/p' /drive.toml)
# A line without a name is known to debugfs by its number: that of the chip's first line plus its offset.
case $relay in
  gpiochip0:*)
    first=$(grep -o 'GPIOs [0-9]*' /sys/kernel/debug/gpio | head -n 1 | cut -d' ' -f2)
    relay="gpio-$((first + ${relay#*:}))"
    ;;
esac
level() { grep "$relay " /sys/kernel/debug/gpio | grep -oE ' (hi|lo)' | tr -d ' '; }
line_is() { [ "$(level)" = "$1" ]; }
# relay_outside on|off: the relay's line as the world outside sees it
relay_outside() {
  outside relay
  check "relay_seen_${1}_from_outside" test "$answer" = "$1"
}
# The mode is the low half of byte 2 of the status frame: modes 2 to 5 drive, 7 is the emergency stop, 8 a fault.
mode_is() { grep " 181#" /tmp/frames.log | tail -n 1 | cut -d'#' -f2 | cut -c6 | grep -q "$1"; }
