"""A headless Chromium driven over its DevTools protocol by a pipe: no other package, no port, one process for many pages."""
import base64
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

ARGUMENTS = ["--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", "--no-first-run", "--disable-quic",
             "--disable-background-networking", "--disable-component-update", "--disable-sync",
             "--disable-dev-shm-usage", "--remote-debugging-pipe"]


def find_chromium():
    """Path of Debian's browser, or None."""
    return shutil.which("chromium") or shutil.which("chromium-browser")


class BrowserError(Exception):
    """The browser ended, did not answer in time, or refused a command."""


class Chromium:
    """with Chromium(path) as browser: browser.open(url, width, height, dark) ..."""

    def __init__(self, path):
        self._profile = tempfile.TemporaryDirectory(prefix="pages_browser_")
        command_read, self._commands = os.pipe()
        self._answers, answer_write = os.pipe()

        def place_pipes():  # Chromium reads commands from descriptor 3 and writes answers to 4
            for source, target in ((command_read, 3), (answer_write, 4)):
                if source != target:
                    os.dup2(source, target, inheritable=True)
                else:
                    os.set_inheritable(target, True)

        # Out of the way of 3 and 4, which are about to be taken.
        command_read, answer_write = _moved_up(command_read), _moved_up(answer_write)
        self._commands, self._answers = _moved_up(self._commands), _moved_up(self._answers)
        self._process = subprocess.Popen([path, *ARGUMENTS, "--user-data-dir=" + self._profile.name],
                                         preexec_fn=place_pipes, close_fds=False, stdin=subprocess.DEVNULL,
                                         stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(command_read)
        os.close(answer_write)
        self._buffer, self._next, self._session = b"", 0, None
        self.complaints = []  # console errors, exceptions, failed loads since the last open()
        target = self._call("Target.createTarget", url="about:blank")["targetId"]
        self._session = self._call("Target.attachToTarget", targetId=target, flatten=True)["sessionId"]
        for domain in ("Page", "Runtime", "Log", "Network"):
            self._call(domain + ".enable")

    def __enter__(self):
        return self

    def __exit__(self, *_):
        os.close(self._commands)  # the browser ends when nobody commands it
        try:
            self._process.wait(10)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        os.close(self._answers)
        for _ in range(50):  # its children may still write into the profile
            try:
                self._profile.cleanup()
                return
            except OSError:
                time.sleep(0.1)

    def open(self, url, width, height, dark):
        """Loads a page as a screen of that size and colour scheme shows it; returns when it is laid out."""
        self.complaints = []
        self.show_as(width, height, dark)
        self._loaded = False
        self._call("Page.navigate", url=url)
        while not self._loaded:
            self._read_message(time.monotonic() + 30)

    def show_as(self, width, height, dark):
        """Another size and colour scheme for the page that is open."""
        self._call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
        self._call("Emulation.setEmulatedMedia",
                   features=[{"name": "prefers-color-scheme", "value": "dark" if dark else "light"}])

    def evaluate(self, script):
        """Value of a JavaScript expression (or of what its promise gives) in the page."""
        answer = self._call("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in answer:
            raise BrowserError(json.dumps(answer["exceptionDetails"]))
        return answer["result"].get("value")

    def screenshot(self, path, whole_page=True):
        image = self._call("Page.captureScreenshot", format="png", captureBeyondViewport=whole_page)
        with open(path, "wb") as stream:
            stream.write(base64.b64decode(image["data"]))

    def drag(self, start, end):
        """Presses the left button at start, moves to end in steps, lets go; points are (x, y) of the viewport."""
        def mouse(kind, point, buttons):
            self._call("Input.dispatchMouseEvent", type=kind, x=point[0], y=point[1], button="left", buttons=buttons,
                       clickCount=1)
        mouse("mousePressed", start, 1)
        for step in range(1, 6):
            mouse("mouseMoved", [a + (b - a) * step / 5 for a, b in zip(start, end)], 1)
        mouse("mouseReleased", end, 0)

    def _call(self, method, **parameters):
        self._next += 1
        message = {"id": self._next, "method": method, "params": parameters}
        if self._session:
            message["sessionId"] = self._session
        os.write(self._commands, json.dumps(message).encode() + b"\0")
        deadline = time.monotonic() + 30
        while True:
            answer = self._read_message(deadline)
            if answer.get("id") != self._next:
                continue
            if "error" in answer:
                raise BrowserError(f"{method}: {answer['error']}")
            return answer["result"]

    def _read_message(self, deadline):
        while b"\0" not in self._buffer:
            if not select.select([self._answers], [], [], max(0.0, deadline - time.monotonic()))[0]:
                raise BrowserError("no answer from the browser")
            more = os.read(self._answers, 1 << 20)
            if not more:
                raise BrowserError("the browser ended")
            self._buffer += more
        text, self._buffer = self._buffer.split(b"\0", 1)
        message = json.loads(text)
        self._note(message.get("method"), message.get("params", {}))
        return message

    def _note(self, event, details):
        if event == "Page.loadEventFired":
            self._loaded = True
        elif event == "Runtime.exceptionThrown":
            self.complaints.append("exception: " + json.dumps(details["exceptionDetails"])[:400])
        elif event == "Runtime.consoleAPICalled" and details["type"] in ("error", "warning", "assert"):
            self.complaints.append(f"console.{details['type']}: " + json.dumps(details["args"])[:400])
        elif event == "Network.requestWillBeSent" and details["type"] != "Document":
            if not details["request"]["url"].startswith("data:"):
                self.complaints.append("fetches " + details["request"]["url"][:200])
        elif event == "Log.entryAdded" and details["entry"]["level"] in ("error", "warning"):
            self.complaints.append("log: " + details["entry"]["text"][:400])


def _moved_up(descriptor):
    """The same pipe end under a number of at least 10."""
    import fcntl
    moved = fcntl.fcntl(descriptor, fcntl.F_DUPFD_CLOEXEC, 10)
    os.close(descriptor)
    return moved
