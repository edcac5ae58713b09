"""A page that shows a run: its blobs or particles, the bodies where they are, drag and lift.

Says on standard error how many frames it has read, and in the end what it has made; leaves with 2
if the folder lacks what it takes.
"""

import argparse
import sys
from pathlib import Path

from _movie_shown import count
from _replaced import Refused, printable, refuse, replaced, told
from _style import Broken, Nothing, Run
from _view_frames import Frames, packed
from _view_live import serve
from _view_page import about, in_one_file

LARGEST = 60e6  # bytes of a page; of a run that makes more, every second frame is left out, ...
EACH = 14  # bytes of a blob in it, or less; of a particle twice that


def asked():
    parser = argparse.ArgumentParser()
    parser.add_argument("folder", type=Path)
    parser.add_argument("--out", type=Path)
    parser.add_argument("--live", action="store_true")
    parser.add_argument("--port", type=int, default=0)
    return parser.parse_args()


def chosen(sizes, each):
    """Every frame, or every second, ..., the last among them, so that the page does not become too
    large."""
    for apart in range(1, len(sizes) + 1):
        numbers = range(len(sizes) - 1, -1, -apart)[::-1]
        if each * sum(sizes[k] for k in numbers) <= LARGEST:
            break
    return numbers, apart


def make(folder, out):
    frames = Frames(Run(folder))
    if not len(frames):
        raise Refused(f"{printable(folder)}: no frame there; output.frames says the time between "
                      "two")
    numbers, apart = chosen(frames.sizes, EACH * (2 if frames.particles else 1))
    run, packs = {**about(frames), "frames": []}, []
    for k in numbers:
        beside, columns = frames.frame(k)
        packs.append(packed(columns, frames.columns, beside))
        run["frames"].append({**beside, "name": frames.names[k]})
        print(f"frame {len(packs)} of {len(numbers)}", file=sys.stderr, flush=True)
    with replaced(out) as part, part.open("w", encoding="utf-8") as file:
        file.writelines(in_one_file(run, packs))
    most = count(max(one["many"] for one in run["frames"]), run["particle"])
    left_out = f", every {ordinal(apart)} of {len(frames)}" if apart > 1 else ""
    print(f"{printable(out)}: {count(len(numbers), 'frame')}{left_out}, up to {most}, "
          f"{out.stat().st_size / 1e6:.2f} MB", file=sys.stderr)


def ordinal(n):
    ending = "th" if n % 100 in (11, 12, 13) else {1: "st", 2: "nd", 3: "rd"}.get(n % 10, "th")
    return f"{n}{ending}"


def main():
    job = asked()
    speaker = "vortree: " if job.live else ""  # else the program says what it hears
    try:
        serve(job.folder, job.port) if job.live else make(job.folder, job.out)
    except (Refused, Broken) as error:
        refuse(f"{speaker}{error}")
    except Nothing as error:
        refuse(speaker + (str(error) or f"{job.folder}: nothing to show"))
    except OSError as error:
        sys.exit(speaker + told(error))


if __name__ == "__main__":
    main()
