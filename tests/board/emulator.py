"""One emulated board: QEMU, its console as a text log, and its control socket (QMP) for what happens outside the board."""
import json
import os
import selectors
import socket
import subprocess
import time

COMMON = ["-m", "256", "-nographic", "-monitor", "none", "-serial", "stdio", "-nic", "none", "-no-reboot"]
# Guest time follows the count of instructions, 1 ns each: the same run twice, and a loop keeps its period on a busy machine.
DETERMINISTIC = ["-icount", "shift=0,sleep=off", "-rtc", "base=2026-01-01,clock=vm", "-seed", "1"]

# A boot loader hands the kernel a seed for its random numbers (/chosen/rng-seed), and so does the virt machine, out of -seed.
# Without it the generator never gets ready here, where every boot is the same, and hashes its pool anew for each number that the
# allocator asks for: up to 0.6 ms within a step of the controller, where a real board takes none.
MACHINES = {
    "armhf": {
        # The board's second core would only wait, busily: it is parked in a "wfi" of its own in the static memory.
        "command": ["qemu-system-arm", "-M", "ast2600-evb",
                    "-device", "loader,addr=0x10000000,data=0xeafffffde320f003,data-len=8",
                    "-device", "loader,addr=0x10000000,cpu-num=1"],
        "console": "ttyS4 maxcpus=1",
    },
    "arm64": {
        "command": ["qemu-system-aarch64", "-M", "virt", "-cpu", "cortex-a53",
                    "-object", "can-bus,id=cb0", "-device", "kvaser_pci,canbus=cb0", "-device", "kvaser_pci,canbus=cb0",
                    "-device", "i6300esb"],
        "console": "ttyAMA0",
    },
}


class Board:
    """Starts on construction; every line of the console is appended to `lines` and to the log file."""

    def __init__(self, arch, kernel, initrd, log, dtb=None, extra=(), command_line=""):
        machine = MACHINES[arch]
        self.socket_path = log + ".qmp"
        if os.path.exists(self.socket_path):
            os.unlink(self.socket_path)
        append = f"console={machine['console']} quiet panic=-1 norandmaps {command_line}".strip()
        command = machine["command"] + COMMON + list(extra) + DETERMINISTIC
        command += ["-kernel", kernel, "-initrd", initrd, "-append", append]
        command += ["-qmp", f"unix:{self.socket_path},server=on,wait=off"]
        if dtb:
            command += ["-dtb", dtb]
        self.lines = []
        self.partial = b""
        self.log = open(log, "wb")
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        self.selector = selectors.DefaultSelector()
        self.selector.register(self.process.stdout, selectors.EVENT_READ)
        self.control = None
        self.killed = False  # ended by quit(), not by itself

    def qmp(self, command, **arguments):
        """Sends one control command and returns its result."""
        if self.control is None:
            self.control = socket.socket(socket.AF_UNIX)
            self.control.connect(self.socket_path)
            self.stream = self.control.makefile("rw")
            self.stream.readline()
            self.qmp("qmp_capabilities")
        self.stream.write(json.dumps({"execute": command, "arguments": arguments}) + "\n")
        self.stream.flush()
        while True:
            answer = json.loads(self.stream.readline())
            if "error" in answer:
                raise RuntimeError(f"{command}: {answer['error']['desc']}")
            if "return" in answer:
                return answer["return"]

    def write(self, text):
        """Types a line on the console."""
        self.process.stdin.write(text.encode() + b"\n")
        self.process.stdin.flush()

    def read_lines(self, timeout_s):
        """New console lines; empty after timeout_s or at the end."""
        if not self.selector.select(timeout_s):
            return []
        data = os.read(self.process.stdout.fileno(), 65536)
        if not data:
            self.process.wait()
            return []
        self.log.write(data)
        self.log.flush()
        *lines, self.partial = (self.partial + data).split(b"\n")
        texts = [line.decode(errors="replace").rstrip("\r") for line in lines]
        self.lines += texts
        return texts

    def wait_for(self, marker, timeout_s, on_line=None):
        """Reads the console until a line starts with marker; returns that line, None at the end of the guest or of time."""
        end = time.monotonic() + timeout_s
        while time.monotonic() < end and self.process.poll() is None:
            for line in self.read_lines(1.0):
                if on_line:
                    on_line(line)
                if line.startswith(marker):
                    return line
        return None

    def quit(self):
        if self.process.poll() is None:
            self.killed = True
            try:
                self.qmp("quit")
                self.process.wait(10)
            except (OSError, RuntimeError, ValueError, subprocess.TimeoutExpired):
                self.process.kill()
                self.process.wait()
        self.log.close()
        if os.path.exists(self.socket_path):
            os.unlink(self.socket_path)
