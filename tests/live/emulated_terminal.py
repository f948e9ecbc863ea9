"""A program on a pseudo-terminal whose screen is a model of a terminal (pyte): what it shows can be read as text."""
import fcntl
import os
import pty
import select
import signal
import struct
import termios
import time

import pyte


class Terminal:
    """stdin: None for the terminal itself, "pipe" for a pipe that feed() writes to."""

    def __init__(self, command, columns, lines, stdin=None, term="linux", environment=None):
        self.screen = pyte.Screen(columns, lines)
        self.stream = pyte.ByteStream(self.screen)
        self.raw = b""
        self.status = None
        read_end, self.pipe = os.pipe() if stdin == "pipe" else (None, None)
        self.pid, self.master = pty.fork()
        if self.pid == 0:
            if read_end is not None:
                os.dup2(read_end, 0)
                os.close(read_end)
                os.close(self.pipe)
            # The size is set before the program looks at it.
            fcntl.ioctl(1, termios.TIOCSWINSZ, struct.pack("HHHH", lines, columns, 0, 0))
            variables = {k: v for k, v in os.environ.items() if k not in ("COLUMNS", "LINES", "NO_COLOR")}
            variables.update({"TERM": term, "LC_ALL": "C.UTF-8"}, **(environment or {}))
            os.execve(command[0], command, variables)
        if read_end is not None:
            os.close(read_end)
        os.set_blocking(self.master, False)

    def feed(self, text):
        os.write(self.pipe, text.encode())

    def press(self, keys):
        os.write(self.master, keys.encode())

    def resize(self, columns, lines):
        self.screen.resize(lines, columns)
        fcntl.ioctl(self.master, termios.TIOCSWINSZ, struct.pack("HHHH", lines, columns, 0, 0))

    def signal(self, number=signal.SIGTERM):
        os.kill(self.pid, number)

    def take(self, timeout):
        """Output that comes within the timeout goes to the screen; False at the end of the program."""
        if not select.select([self.master], [], [], timeout)[0]:
            return True
        try:
            data = os.read(self.master, 65536)
        except OSError:
            data = b""
        self.raw += data
        self.stream.feed(data)
        return bool(data)

    def wait_for(self, condition, what, timeout=20.0, meanwhile=None):
        """Until condition(text of the screen) holds; meanwhile() is called about twenty times a second."""
        end = time.monotonic() + timeout
        while not condition(self.text()):
            if meanwhile:
                meanwhile()
            if not self.take(0.05) or time.monotonic() > end:
                raise AssertionError(f"never seen: {what}\n{self.text()}")

    def wait_for_text(self, words, timeout=20.0, meanwhile=None):
        self.wait_for(lambda text: words in text, words, timeout, meanwhile)

    def wait_until_quiet(self, seconds=0.3):
        """Takes output until none has come for so long: for a screen that has stopped changing."""
        before = -1
        while before != len(self.raw):
            before = len(self.raw)
            self.take(seconds)

    def end(self, timeout=20.0):
        """Waits for the program to end; its exit status, 128 + signal where a signal ended it."""
        end = time.monotonic() + timeout
        while self.take(0.05):
            if time.monotonic() > end:
                os.kill(self.pid, signal.SIGKILL)
                raise AssertionError("did not end\n" + self.text())
        _, status = os.waitpid(self.pid, 0)
        self.status = os.waitstatus_to_exitcode(status)
        return self.status

    def lines(self):
        return [line.rstrip() for line in self.screen.display]

    def text(self):
        return "\n".join(self.lines())
