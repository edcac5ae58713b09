"""A video of pictures that are piped to ffmpeg as they are made, and a small one made from it."""

import shutil
import subprocess
import tempfile

from _replaced import Refused

SECONDS, LARGEST = 5, 3e6  # of a small one, as a page can carry; bytes
RATE, HEIGHTS = 12, (400, 320, 256, 200, 144)  # pictures a second; the first that is not too large
BT709 = ("-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709")


class Ffmpeg:
    def __init__(self):
        self.program = shutil.which("ffmpeg")
        if not self.program:
            raise Refused("no ffmpeg is installed to write a video with; on Debian: "
                          "apt-get install ffmpeg")
        listed = self._told("-encoders").split("\n")
        self.encoders = {line.split()[1] for line in listed if len(line.split()) > 1}
        if "libx264" not in self.encoders:
            raise Refused(f"{self.program} has no encoder libx264; that of Debian's package ffmpeg "
                          "has")

    def _told(self, *words):
        return subprocess.run([self.program, "-hide_banner", "-loglevel", "error", *words],
                              capture_output=True, text=True, check=False).stdout

    def start(self, *words, **more):
        return subprocess.Popen([self.program, "-hide_banner", "-loglevel", "error", "-y", *words],
                                **more)

    def run(self, *words):
        with tempfile.TemporaryFile() as told:
            finish(self.start(*words, stdin=subprocess.DEVNULL, stderr=told), told)


def taken(give, *what):
    try:
        give(*what)
        return True
    except BrokenPipeError:
        return False


def finish(process, told):
    if process.wait() == 0:
        return
    told.seek(0)
    lines = told.read().decode(errors="replace").strip().split("\n")
    raise OSError(f"ffmpeg: {lines[-1] or f'ended with {process.returncode}'}")


def write(ffmpeg, path, size, fps, pictures):
    """size: width and height, even; pictures: buffers of width x height RGBA."""
    with tempfile.TemporaryFile() as told:
        process = ffmpeg.start(
            "-f", "rawvideo", "-pix_fmt", "rgba", "-s", "{}x{}".format(*size), "-r", str(fps),
            "-i", "-", "-an", "-vf", "scale=out_color_matrix=bt709:out_range=tv", *BT709,
            "-c:v", "libx264", "-preset", "medium", "-crf", "18", "-pix_fmt", "yuv420p",
            "-movflags", "+faststart", "-f", "mp4", str(path),
            stdin=subprocess.PIPE, stderr=told)
        try:
            for picture in pictures:
                if not taken(process.stdin.write, picture):
                    break  # it says itself why it has ended
            taken(process.stdin.close)
        except BaseException:
            process.kill()
            process.wait()
            raise
        finish(process, told)


def small_suffix(ffmpeg):
    return ".webp" if "libwebp_anim" in ffmpeg.encoders else ".gif"


def write_small(ffmpeg, path, suffix, video, seconds):
    """All of a video of so many seconds, faster if it is longer than a small one is to be."""
    speed = f"setpts=PTS*{min(1, SECONDS / seconds):.9f},fps={RATE}"
    for height in HEIGHTS:
        seen = f"{speed},scale=-2:{height}:flags=lanczos"
        if suffix == ".webp":
            ffmpeg.run("-i", str(video), "-vf", seen, "-c:v", "libwebp_anim", "-q:v", "80",
                       "-loop", "0", "-f", "webp", str(path))
        else:
            ffmpeg.run("-i", str(video), "-vf", f"{seen},split[a][b];[a]palettegen[c];[b][c]"
                       "paletteuse", "-loop", "0", "-f", "gif", str(path))
        if path.stat().st_size < LARGEST:
            return
