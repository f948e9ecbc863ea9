#!/usr/bin/env python3
"""Runs one test in an emulated board: starts it, plays what happens outside it, collects its results and files.

usage: board_tests.py ARCH TEST --packages DIR --initrd FILE --results DIR [--bus IFACE] [--seconds N] [--dtb FILE] [--limit S]
Prints one line per result; exit status 0 only when the guest reached its end and every result is ok.
"""
import argparse
import base64
import glob
import gzip
import os
import re
import sys
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from emulator import Board  # noqa: E402


class Session:
    """What the guest says, line by line."""

    def __init__(self, board, options):
        self.board = board
        self.options = options
        self.results = []
        self.file = None
        self.ended = False
        self.reset_expected = False

    def line(self, text):
        if self.file:
            if text == "MARK file-end":
                self.store()
            else:
                self.file[1].append(text)
            return
        if not text.startswith("MARK "):
            return
        kind, _, rest = text[5:].partition(" ")
        if kind == "result":
            self.results.append(rest)
            print(f"  {self.options.arch} {self.options.test}: {rest}", flush=True)
        elif kind == "file":
            self.file = (rest, [])
        elif kind == "end":
            self.ended = True
        elif kind == "reset-expected":
            self.reset_expected = True
        elif kind == "missing":
            self.results.append(f"start failed {rest}")
        elif kind == "outside":
            outside(self.board, self.options.arch, rest)

    def store(self):
        name, lines = self.file
        self.file = None
        path = os.path.join(self.options.results, f"{self.options.arch}_{self.options.test}_{name}")
        with open(path, "wb") as file:
            file.write(gzip.decompress(base64.b64decode("".join(lines))))
        if name in JUDGES:
            JUDGES[name](self, path)

    def judge(self, name, good, remark=""):
        self.line(f"MARK result {name} {'ok' if good else 'failed'} {remark}".rstrip())


def judge_stop(session, path):
    """In the log of the bus: after the stop no drive but zero, and no sample between the edge and the stop."""
    frames = []
    with open(path) as file:
        for line in file:
            time_text, _, frame = line.split()[:3]
            identifier, data = frame.split("#")
            frames.append((float(time_text.strip("()")), identifier, data))
    reactions = [line for line in session.board.lines if "us after the edge" in line]
    if not reactions or not frames:
        return session.judge("stop_is_in_the_log", False)
    reaction_s = int(re.search(r"(\d+) us after", reactions[0]).group(1)) * 1e-6
    alarm = next(i for i, frame in enumerate(frames) if frame[1] == "081" and frame[2].startswith("01FF"))
    stop = next(i for i, frame in enumerate(frames) if frame[1] == "201" and frame[2] == "00000000000002")
    edge_s = min(frames[alarm][0], frames[stop][0]) - reaction_s
    later = [frame for frame in frames[stop + 1:] if frame[1] == "201" and frame[2] != "00000000000002"]
    before = [frame for frame in frames[:stop] if frame[1] == "201" and not frame[2].startswith("00000000")]
    # The edge's place in the log is known to some 50 us: the clocks are read one after the other.
    between = [frame for frame in frames[:stop] if frame[1] == "1C1" and frame[0] > edge_s + 50e-6]
    samples = [frame for frame in frames[stop:] if frame[1] == "1C1"]
    session.judge("drive_before_stop_was_not_zero", bool(before))
    session.judge("drive_is_zero_and_stays", not later)
    session.judge("no_sample_between_edge_and_stop", not between and bool(samples), f"{reaction_s * 1e6:.0f} us after the edge")


def judge_killed(session, path):
    """In the log of the bus: between the markers, less than 100 ms apart, the drive goes to zero for good."""
    frames = []
    with open(path) as file:
        for line in file:
            time_text, _, frame = line.split()[:3]
            frames.append((float(time_text.strip("()")), *frame.split("#")))
    marks = [i for i, frame in enumerate(frames) if frame[1] == "7FF"]
    if len(marks) != 2:
        return session.judge("markers_are_in_the_log", False)
    killed, safe = marks
    driven = [frame for frame in frames[:killed] if frame[1] == "201" and not frame[2].startswith("00000000")]
    zero = [frame for frame in frames[killed:safe] if frame[1] == "201" and frame[2] == "00000000000002"]
    moving = [frame for frame in frames[safe:] if frame[1] == "201" and frame[2] != "00000000000002"]
    took_s = frames[safe][0] - frames[killed][0]
    session.judge("drive_before_the_kill_was_not_zero", bool(driven))
    session.judge("drive_is_zero_and_stays", bool(zero) and not moving)
    session.judge("safe_within_100_ms", took_s < 0.1, f"{took_s * 1e3:.0f} ms from the kill to relay off and drive zero")


JUDGES = {"stop.log": judge_stop, "frames.log": judge_killed}


def outside(board, arch, request):
    """What the guest asks the world outside for: `press` and `release` of the emergency stop, `relay` to see its line's level.

    The guest waits for the answer: its time may run faster than this machine's."""
    words = request.split()
    answer = "done"
    if arch == "armhf" and words[0] in ("press", "release"):
        board.qmp("qom-set", path="/machine/soc/gpio", property="gpioB0", value=words[0] == "press")
    elif arch == "armhf" and words[0] == "relay":
        answer = "on" if board.qmp("qom-get", path="/machine/soc/gpio", property="gpioB1") else "off"
    elif arch == "arm64" and words[0] in ("press", "release"):
        if words[0] == "press":
            board.qmp("system_powerdown")  # a pulse of 100 ms on line 3 of the PL061
    elif arch == "arm64" and words[0] == "relay":
        # The data register of the PL061 at 0x9030000; the address selects line 5.
        text = board.qmp("human-monitor-command", **{"command-line": "xp /1wx 0x9030080"})
        answer = "on" if int(text.split(":")[1], 16) != 0 else "off"
    else:
        raise RuntimeError(f"the guest asks for {request}, which {arch} has not")
    board.write(answer)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("arch")
    parser.add_argument("test")
    parser.add_argument("--packages", required=True)
    parser.add_argument("--initrd", required=True)
    parser.add_argument("--results", required=True)
    parser.add_argument("--dtb")
    parser.add_argument("--bus", default="vcan0")
    parser.add_argument("--seconds", default="60")
    parser.add_argument("--limit", type=float, default=900.0, help="real seconds")
    options = parser.parse_args()

    kernel = glob.glob(os.path.join(options.packages, options.arch, "root/boot/vmlinuz*"))[0]
    log = os.path.join(options.results, f"{options.arch}_{options.test}.console")
    began = time.monotonic()
    board = Board(options.arch, kernel, options.initrd, log, dtb=options.dtb,
                  command_line=f"test={options.test} bus={options.bus} seconds={options.seconds}")
    session = Session(board, options)
    try:
        while not session.ended and time.monotonic() - began < options.limit:
            lines = board.read_lines(1.0)
            if not lines and board.process.poll() is not None:
                break
            for text in lines:
                session.line(text)
    finally:
        board.quit()
    if session.reset_expected:
        # Without a reset the guest would have gone on to its end, or hung until the limit.
        session.judge("board_was_reset", not session.ended and board.process.returncode == 0 and not board.killed)
        session.ended = True
    failed = [result for result in session.results if result.split()[1] != "ok"]
    if not session.ended:
        failed.append("the guest did not reach its end")
    print(f"{options.arch} {options.test}: {len(session.results) - len(failed) + (not session.ended)} ok, {len(failed)} failed "
          f"in {time.monotonic() - began:.0f} s" + ("" if not failed else f", see {log}: {failed}"), flush=True)
    return 1 if failed or not session.results else 0


sys.exit(main())
