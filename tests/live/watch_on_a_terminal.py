#!/usr/bin/env python3
"""host_sim watch in an emulated terminal: watch_on_a_terminal.py HOST_SIM. Exit status 77: skipped."""
import os
import subprocess
import sys
import tempfile
import time

try:
    from emulated_terminal import Terminal
except ImportError:
    print("SKIPPED: python3-pyte is not installed")
    sys.exit(77)

HOST_SIM = sys.argv[1]

# Frames by hand (docs/can_protocol.md). Estimate: value, std, exponent + 24 and status, exponent of std and window.
NAME = "681#000202010200"  # estimate 0 of 2: viscous[1-2]
NAME_2 = "681#010203030000"  # estimate 1: coulomb[3-0]
VALUE = "410#C06837770C301072"  # 20.0012 +- 0.0123 VALID
VALUE_2 = "411#00CA9A3B0A000F70"  # 1000000000e-9 = 1 +- 10e-9, VALID
SKEWED = "411#00CA9A3B0A006F70"
HEARTBEAT = "701#05"
STOPPED = "701#04"
STATUS = "181#0000040A01000000"  # no fault, INTEGRATE
FAULT = "181#0400080A01000000"  # SENSOR_LOST, FAULT
HEALTH = "281#7B0000000000000000"[:20]  # up 123 s
EMERGENCY = "081#03FF0141" + "09000000"  # SENSOR_LOST, velocity[1], 9
DIAGNOSIS = "481#030102070A000000"  # stiffness_error on link 1-2


def line(time_s, frame):
    return f"({time_s:.6f}) can0 {frame}\n"


def recording(path, duration_s=6.0):
    with open(path, "w") as log:
        for i in range(int(duration_s * 10)):
            t = 1700000000 + i / 10
            for frame in (HEARTBEAT, STATUS, VALUE, VALUE_2):
                log.write(line(t, frame))
            if i % 10 == 0:
                for frame in (NAME, NAME_2, HEALTH, DIAGNOSIS):
                    log.write(line(t, frame))
            if i == 30:
                log.write(line(t, EMERGENCY))


def check(condition, what, terminal=None):
    if not condition:
        raise AssertionError(what + ("\n" + terminal.text() if terminal else ""))


def replay_is_the_table_printed_once(folder):
    """At each width the screen ends with what --once prints there, and no line is cut by the terminal."""
    log = os.path.join(folder, "run.log")
    recording(log)
    for columns in (60, 80, 200):
        printed = subprocess.run([HOST_SIM, "watch", log, "--once"], capture_output=True, text=True, check=True,
                                 env={**os.environ, "COLUMNS": str(columns), "LC_ALL": "C.UTF-8"}).stdout
        terminal = Terminal([HOST_SIM, "watch", log, "--speed", "0"], columns, 24)
        expected = [text.rstrip() for text in printed.splitlines()]
        # The source is cut with the title; everything below is the same, line for line.
        terminal.wait_for(lambda _: terminal.lines()[1:len(expected)] == expected[1:],
                          f"{columns} columns, the lines of\n{printed}")
        for words in ("viscous[1-2]", "20.001", "±0.024", "N s/m", "VALID", "coulomb[3-0]", "OPERATIONAL", "INTEGRATE",
                      "diagnosis: stiffness_error on link 1-2", "SENSOR_LOST, velocity[1] (9)", "load at most"):
            check(words in terminal.text(), f"{columns} columns lack {words}", terminal)
        terminal.wait_for(lambda _: terminal.lines()[23].startswith("Tab node"), "keys in the last line")
        terminal.press("q")
        check(terminal.end() == 0, "q ends with 0", terminal)
        check(b"\x1b[?25h" in terminal.raw, "the cursor comes back")


class LiveBus:
    """A controller that sends ten times a second, as long as send() is called."""

    def __init__(self, terminal):
        self.terminal, self.next = terminal, 0.0
        self.frames = [HEARTBEAT, STATUS, VALUE, VALUE_2, NAME, NAME_2]

    def send(self):
        now = time.time()
        if now >= self.next:
            self.next = now + 0.1
            self.terminal.feed("".join(line(now, frame) for frame in self.frames))


def a_live_bus_from_start_to_fault_to_silence_and_back(_folder):
    terminal = Terminal([HOST_SIM, "watch", "-"], 80, 24, stdin="pipe")
    terminal.wait_for_text("waiting for the first frame")
    bus = LiveBus(terminal)
    terminal.wait_for_text("bus up", meanwhile=bus.send)
    terminal.wait_for_text("coulomb[3-0]", meanwhile=bus.send)
    terminal.wait_for_text("faults: none", meanwhile=bus.send)

    bus.frames = [STOPPED, FAULT, VALUE, SKEWED, EMERGENCY]
    terminal.wait_for_text("faults: SENSOR_LOST", meanwhile=bus.send)
    terminal.wait_for_text("SKEWED", meanwhile=bus.send)
    for words in ("STOPPED", "FAULT", "SENSOR_LOST, velocity[1] (9)"):
        terminal.wait_for_text(words, meanwhile=bus.send)

    terminal.wait_for_text("BUS SILENT for")  # nobody sends
    terminal.wait_for_text("node 1  SILENT for")
    bus.frames = [HEARTBEAT, STATUS, VALUE, VALUE_2]
    terminal.wait_for_text("bus back after", meanwhile=bus.send)
    terminal.wait_for_text("faults: none", meanwhile=bus.send)
    terminal.wait_for_text("away 1x", meanwhile=bus.send)

    terminal.feed(line(time.time(), "20000040#0000000000000000"))  # an error frame: bus-off
    terminal.wait_for_text("BUS-OFF for")
    terminal.feed(line(time.time(), "20000100#0000000000000000") + line(time.time(), HEARTBEAT))  # restarted
    terminal.wait_for_text("bus up", meanwhile=bus.send)

    terminal.press("s")
    terminal.wait_for_text("only an interface takes commands", meanwhile=bus.send)
    terminal.resize(60, 20)
    terminal.wait_for(lambda text: text.splitlines()[19].startswith("only an interface"), "the prompt in line 20",
                      meanwhile=bus.send)
    os.close(terminal.pipe)
    terminal.wait_for_text("end of the log")
    terminal.press("\x03")  # ctrl-C
    check(terminal.end() == 0, "ctrl-C ends with 0", terminal)


def real_pace_and_speed(folder):
    """Six seconds of log take a fifth of a second at 30 times their pace, and a tenth of it is not yet the end."""
    log = os.path.join(folder, "paced.log")
    recording(log)
    start = time.monotonic()
    terminal = Terminal([HOST_SIM, "watch", log, "--speed", "30"], 80, 24)
    terminal.wait_for_text("end of the log")
    check(0.15 < time.monotonic() - start < 10.0, "pace", terminal)
    terminal.signal()
    check(terminal.end() == 0, "a termination gives the terminal back and ends", terminal)
    check(b"\x1b[?25h" in terminal.raw, "the cursor comes back")


def without_a_terminal(folder):
    log = os.path.join(folder, "piped.log")
    recording(log)
    with open(log) as text:
        piped = subprocess.run([HOST_SIM, "watch", "-"], stdin=text, capture_output=True, text=True)
    check(piped.returncode == 0 and "viscous[1-2]" in piped.stdout, piped.stdout + piped.stderr)
    check("\x1b" not in piped.stdout, "no control characters in a pipe")
    nowhere = subprocess.run([HOST_SIM, "watch", "can77"], capture_output=True, text=True)
    check(nowhere.returncode == 2 and "can77" in nowhere.stderr, nowhere.stderr)
    terminal = Terminal([HOST_SIM, "watch", log], 80, 24, term="no-such-terminal")
    check(terminal.end() == 2 and b"--once" in terminal.raw, "an unknown terminal is named", terminal)


with tempfile.TemporaryDirectory() as temporary:
    for test in (replay_is_the_table_printed_once, a_live_bus_from_start_to_fault_to_silence_and_back,
                 real_pace_and_speed, without_a_terminal):
        test(temporary)
        print("passed:", test.__name__)
