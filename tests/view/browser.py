"""A Chromium without a window, by its DevTools protocol over two pipes."""

import base64
import json
import os
import select
import shutil
import subprocess
import tempfile
import time

WORDS = ("--headless=new", "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader",
         "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist", "--disable-gpu-watchdog",
         "--hide-scrollbars", "--no-first-run", "--disable-background-networking",
         "--disable-component-update", "--disable-sync", "--disable-default-apps",
         "--disable-dev-shm-usage", "--remote-debugging-pipe")


def program():
    return shutil.which("chromium") or shutil.which("chromium-browser")


class Browser:
    """One page. errors: what its scripts complained of; asked: addresses that it wanted to load."""

    def __init__(self, patience=180, size=(1000, 700)):
        self.patience, self.number, self.buffer = patience, 0, b""
        self.errors, self.asked = [], []
        self.profile = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        to_them, self.write_end = os.pipe()
        self.read_end, from_them = os.pipe()

        def as_three_and_four():
            high = [os.dup2(end, 60 + k) for k, end in enumerate((to_them, from_them))]
            for k, end in enumerate(high):
                os.dup2(end, 3 + k)

        self.process = subprocess.Popen(
            [program(), *WORDS, f"--user-data-dir={self.profile.name}",
             "--window-size={},{}".format(*size), "about:blank"],
            preexec_fn=as_three_and_four, close_fds=False, stdin=subprocess.DEVNULL,
            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, start_new_session=True)
        os.close(to_them)
        os.close(from_them)
        self.session = None
        pages = self.call("Target.getTargets")["targetInfos"]
        page = next(one for one in pages if one["type"] == "page")
        self.session = self.call("Target.attachToTarget", targetId=page["targetId"],
                                 flatten=True)["sessionId"]
        for what in ("Page", "Runtime", "Log", "Network"):
            self.call(f"{what}.enable")
        self.resize(*size)

    def resize(self, width, height, mobile=False):
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height,
                  deviceScaleFactor=1, mobile=mobile)

    def call(self, method, **words):
        self.number += 1
        message = {"id": self.number, "method": method, "params": words}
        if self.session:
            message["sessionId"] = self.session
        os.write(self.write_end, json.dumps(message).encode() + b"\0")
        while True:
            told = self._next()
            if told.get("id") == self.number:
                if "error" in told:
                    raise RuntimeError(f"{method}: {told['error']['message']}")
                return told["result"]

    def _next(self):
        end = time.monotonic() + self.patience
        while b"\0" not in self.buffer:
            if not select.select([self.read_end], [], [], max(0, end - time.monotonic()))[0]:
                raise TimeoutError(f"no answer of the browser in {self.patience} s")
            piece = os.read(self.read_end, 1 << 20)
            if not piece:
                raise RuntimeError("the browser has ended")
            self.buffer += piece
        line, _, self.buffer = self.buffer.partition(b"\0")
        told = json.loads(line)
        self._notice(told.get("method"), told.get("params", {}))
        return told

    def _notice(self, method, about):
        if method == "Runtime.exceptionThrown":
            details = about["exceptionDetails"]
            self.errors.append(details.get("exception", {}).get("description", details["text"]))
        if method == "Runtime.consoleAPICalled" and about["type"] in ("error", "warning", "assert"):
            self.errors.append(str(about["args"]))
        if method == "Log.entryAdded" and about["entry"]["level"] == "error":
            self.errors.append(about["entry"]["text"])
        if method == "Network.requestWillBeSent":
            self.asked.append(about["request"]["url"])

    def open(self, address):
        self.call("Page.navigate", url=address)
        for _ in range(600):
            if self.told("document.readyState") == "complete":
                break
            time.sleep(0.1)
        self.told("window.vortreeReady")

    def told(self, script):
        """The value of an expression, when its promise is kept."""
        found = self.call("Runtime.evaluate", expression=script, awaitPromise=True,
                          returnByValue=True)
        if "exceptionDetails" in found:
            raise RuntimeError(found["exceptionDetails"].get("exception", {}).get(
                "description", found["exceptionDetails"]["text"]))
        return found["result"].get("value")

    def press(self, key, code=None):
        for kind in ("keyDown", "keyUp"):
            text = {"text": key} if len(key) == 1 and kind == "keyDown" else {}
            self.call("Input.dispatchKeyEvent", type=kind, key=key, code=code or key, **text)

    def click(self, x, y):
        for kind in ("mousePressed", "mouseReleased"):
            self.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", clickCount=1)

    def picture(self):
        """A PNG."""
        return base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"])

    def close(self):
        try:
            self.session = None
            self.call("Browser.close")
        except (OSError, RuntimeError):
            pass
        try:
            self.process.wait(20)
        except subprocess.TimeoutExpired:
            self.process.kill()
            self.process.wait()
        os.close(self.write_end)
        os.close(self.read_end)
        self.profile.cleanup()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.close()
