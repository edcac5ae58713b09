"""The same page over loopback, of a run that may still go on."""

import errno
import json
import signal
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

from _replaced import Refused, printable
from _style import Broken, Nothing, Run
from _view_frames import Frames, packed
from _view_page import PARTS, about, inside, served, title_of

KINDS = {".js": "text/javascript", ".css": "text/css"}
LOST = (Broken, Nothing, OSError, KeyError, ValueError, IndexError)  # of files half written


class Follower:
    """What is known of a run; looked at again when its files have changed."""

    def __init__(self, folder):
        self.folder, self.lock = folder, threading.Lock()
        self.mark, self.told, self.origin, self.packs = None, None, "", {}
        self.title = title_of(Run(folder))

    def _mark(self):
        return [[(self.folder / name).stat()[k] for k in (6, 8)]
                for name in ("frames.h5", "report.csv") if (self.folder / name).exists()]

    def run(self):
        """As JSON; as it was last, if the run is just writing."""
        with self.lock:
            mark = self._mark()
            if mark != self.mark:
                try:
                    self._look(mark)
                except LOST:
                    if self.told is None:
                        raise
            return self.told

    def _look(self, mark):
        run = Run(self.folder)
        frames = Frames(run)
        with run.hdf5("frames.h5") as file:
            origin = str(file.attrs.get("checksum", ""))
        if origin != self.origin:
            self.packs.clear()
        self.origin = origin
        for k, name in enumerate(frames.names):
            if name not in self.packs:
                beside, columns = frames.frame(k)
                pack = packed(columns, frames.columns, beside)
                self.packs[name] = ({**beside, "name": name}, pack)
        told = {**about(frames), "origin": origin, "mark": json.dumps(mark),
                "frames": [self.packs[name][0] for name in frames.names]}
        self.told, self.mark = inside(told), mark

    def frame(self, name):
        with self.lock:
            return self.packs[name][1]


class Answer(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    timeout = 30

    def do_GET(self):
        if self.headers.get("Host") not in self.server.own_names:
            return self._send(403, b"this page is for this machine alone", "text/plain")
        try:
            found = self._found(self.path)
        except LOST as error:
            lacking = isinstance(error, Nothing) or not str(error)
            words = "no frame of the run yet" if lacking else str(error)
            return self._send(503, words.encode(errors="replace"), "text/plain")
        return self._send(200, *found) if found else self._send(404, b"not here", "text/plain")

    def _found(self, path):
        follower = self.server.follower
        if path == "/":
            return served(follower.title).encode(), "text/html; charset=utf-8"
        if path == "/data/run.json":
            return follower.run().encode(), "application/json"
        if path.startswith("/data/frame/") and (name := path[12:]) in follower.packs:
            return follower.frame(name), "application/octet-stream"
        parts = {f"/view/{one.name}": one for one in PARTS.iterdir() if one.suffix in KINDS}
        if path in parts:
            return parts[path].read_bytes(), KINDS[parts[path].suffix]
        return None

    def _send(self, code, body, kind):
        self.send_response(code)
        for name, value in (("Content-Type", kind), ("Content-Length", str(len(body))),
                            ("Cache-Control", "no-store"), ("X-Content-Type-Options", "nosniff")):
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, *_):
        pass


class Server(ThreadingHTTPServer):
    daemon_threads = True

    def handle_error(self, *_):  # a browser that went away
        pass


def server_at(port):
    try:
        return Server(("127.0.0.1", port), Answer)
    except OSError as error:
        why = "is in use" if error.errno == errno.EADDRINUSE else f"cannot serve: {error.strerror}"
        raise Refused(f"port {port} {why}") from None


def serve(folder, port):
    """Until it is interrupted."""
    follower = Follower(folder)
    with server_at(port) as server:
        server.follower, port = follower, server.server_address[1]
        server.own_names = {f"127.0.0.1:{port}", f"localhost:{port}"}
        signal.signal(signal.SIGTERM, signal.default_int_handler)
        print(f"http://127.0.0.1:{port}/ shows {printable(folder)}; Ctrl-C ends it", flush=True)
        try:
            server.serve_forever(poll_interval=0.1)
        except KeyboardInterrupt:
            pass
