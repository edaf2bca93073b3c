"""Headless Chromium, driven over its debugging pipe; standard library only."""
import base64
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

NAMES = ("chromium", "chromium-browser", "google-chrome", "chrome")


def find():
    """The browser's path, or None; $CHROMIUM is asked first."""
    return os.environ.get("CHROMIUM") or next(filter(None, map(shutil.which, NAMES)), None)


class Browser:
    """One tab. Use as a context: `with Browser(path, 1000, 800) as b: b.open(file)`."""

    def __init__(self, path, width, height):
        self.home = tempfile.TemporaryDirectory(prefix="homeo-chromium-", ignore_cleanup_errors=True)
        self.number, self.buffer, self.events = 0, b"", []
        command_read, self.write_end = os.pipe()
        self.read_end, answer_write = os.pipe()

        def pipes():  # the browser reads from 3 and writes to 4
            a, b = os.dup(command_read), os.dup(answer_write)
            os.dup2(a, 3)
            os.dup2(b, 4)

        arguments = ["--headless=new", "--remote-debugging-pipe", f"--window-size={width},{height}",
                     f"--user-data-dir={self.home.name}", "--no-first-run", "--hide-scrollbars", "--use-angle=swiftshader",
                     "--enable-unsafe-swiftshader", "--disable-dev-shm-usage", "--force-device-scale-factor=1"]
        if hasattr(os, "geteuid") and os.geteuid() == 0:
            arguments.append("--no-sandbox")
        self.process = subprocess.Popen([path, *arguments, "about:blank"], preexec_fn=pipes, close_fds=False,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        os.close(command_read)
        os.close(answer_write)
        target = self.call("Target.createTarget", {"url": "about:blank"}, page=False)
        attached = self.call("Target.attachToTarget", {"targetId": target["targetId"], "flatten": True}, page=False)
        self.session = attached["sessionId"]
        for domain in ("Page", "Runtime", "Network", "Log"):
            self.call(f"{domain}.enable")
        self.resize(width, height)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.kill()
        self.process.wait()
        os.close(self.write_end)
        os.close(self.read_end)
        self.home.cleanup()

    def call(self, method, parameters=None, page=True, seconds=120):
        """The result of a command of the DevTools protocol."""
        self.number += 1
        message = {"id": self.number, "method": method, "params": parameters or {}}
        if page:
            message["sessionId"] = self.session
        os.write(self.write_end, json.dumps(message).encode() + b"\0")
        until = time.time() + seconds
        while True:
            answer = self.message(until)
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]
            self.events.append(answer)

    def message(self, until):
        while b"\0" not in self.buffer:
            if not select.select([self.read_end], [], [], max(0.0, until - time.time()))[0]:
                raise TimeoutError("no answer from Chromium")
            part = os.read(self.read_end, 1 << 16)
            if not part:
                raise RuntimeError("Chromium ended")
            self.buffer += part
        first, self.buffer = self.buffer.split(b"\0", 1)
        return json.loads(first)

    def resize(self, width, height):
        size = {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": False}
        self.call("Emulation.setDeviceMetricsOverride", size)

    def open(self, file):
        """Loads a file and waits until the page says that it has drawn, or cannot; what it says."""
        self.events.clear()
        self.call("Page.navigate", {"url": "file://" + os.path.abspath(file)})
        until = time.time() + 120
        while time.time() < until:
            ready = self.value("document.readyState === 'complete' && document.documentElement.dataset.ready")
            if ready:
                return ready
            time.sleep(0.05)
        raise TimeoutError(f"{file}: never ready")

    def value(self, expression):
        """The value of an expression in the page (promises are awaited)."""
        given = {"expression": expression, "returnByValue": True, "awaitPromise": True}
        answer = self.call("Runtime.evaluate", given)
        if "exceptionDetails" in answer:
            raise RuntimeError(f"{expression}: {answer['exceptionDetails']}")
        return answer["result"].get("value")

    def mouse(self, kind, x, y, buttons=1):
        given = {"type": kind, "x": x, "y": y, "button": "left" if buttons else "none", "buttons": buttons, "clickCount": 1}
        self.call("Input.dispatchMouseEvent", given)

    def click(self, x, y):
        """A click as a mouse makes it."""
        self.mouse("mousePressed", x, y)
        self.mouse("mouseReleased", x, y)

    def drag(self, x, y, dx, dy):
        self.mouse("mousePressed", x, y)
        for k in range(1, 5):
            self.mouse("mouseMoved", x + dx * k / 4, y + dy * k / 4)
        self.mouse("mouseReleased", x + dx, y + dy)

    def pinch(self, x, y, before, after):
        """Two fingers, so far apart before and after."""
        def points(size):
            return [{"x": x - size / 2, "y": y, "id": 0}, {"x": x + size / 2, "y": y, "id": 1}]
        steps = [("touchStart", before), *(("touchMove", before + (after - before) * k / 4) for k in range(1, 5))]
        for kind, size in steps:
            self.call("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points(size)})
        self.call("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})

    def screenshot(self, file):
        with open(file, "wb") as out:
            out.write(base64.b64decode(self.call("Page.captureScreenshot", {"format": "png"})["data"]))

    def complaints(self):
        """Exceptions, errors in the console, and what was asked of the network."""
        out = []
        for event in self.events:
            method, p = event.get("method"), event.get("params", {})
            if method == "Runtime.exceptionThrown":
                out.append(str(p["exceptionDetails"]))
            elif method == "Log.entryAdded" and p["entry"]["level"] == "error":
                out.append(p["entry"]["text"])
            elif method == "Network.requestWillBeSent" and p.get("type") != "Document":
                out.append("asked for " + p["request"]["url"][:200])
        return out
