"""An animation of a run: the flow, the bodies where they are, and the drag with a mark that moves.

Says on standard error how many pictures it has drawn, and in the end what it has made; leaves with
2 if the folder or the machine lacks what it takes.
"""

import argparse
import sys
import time
from pathlib import Path

from _movie_blobs import Blobs
from _movie_file import Ffmpeg, small_suffix, write, write_small
from _movie_page import Page
from _movie_plane import Pressure, Speed, Vorticity
from _replaced import Refused, printable, refuse, replaced, told
from _style import Broken, Nothing, Run

SHOWN = {"vorticity": Vorticity, "speed": Speed, "pressure": Pressure, "blobs": Blobs}


def asked():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=Path)
    parser.add_argument("--out", type=Path, required=True)
    parser.add_argument("--what", choices=SHOWN, default="vorticity")
    parser.add_argument("--fps", type=int, default=25)
    parser.add_argument("--size", type=int, default=720)
    parser.add_argument("--streamlines", action="store_true")
    return parser.parse_args()


def drawn(page, count):
    for k in range(count):
        yield page.drawn_at(k)
        print(f"picture {k + 1} of {count}", file=sys.stderr, flush=True)


def make(job):
    ffmpeg = Ffmpeg()
    page = Page(SHOWN[job.what](Run(job.folder)), job.size - job.size % 2, job.streamlines)
    count = len(page.shown.times)
    little = job.out.with_suffix(suffix := small_suffix(ffmpeg))
    begin = time.monotonic()
    with replaced(job.out) as part, replaced(little) as little_part:
        write(ffmpeg, part, page.size, job.fps, drawn(page, count))
        rate = count / (time.monotonic() - begin)
        write_small(ffmpeg, little_part, suffix, part, count / job.fps)
    print(f"{printable(job.out)}: {count} pictures of {page.size[0]} x {page.size[1]}, "
          f"{count / job.fps:.1f} s, {size(job.out)}; {printable(little.name)} {size(little)}; "
          f"{rate:.0f} pictures drawn a second", file=sys.stderr)


def size(path):
    return f"{path.stat().st_size / 1e6:.2f} MB"


def main():
    job = asked()
    try:
        make(job)
    except (Refused, Broken) as error:
        refuse(error)
    except Nothing as error:
        refuse(str(error) or f"{job.folder}: nothing to show")
    except OSError as error:
        sys.exit(told(error))


main()
