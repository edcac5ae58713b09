"""How figures, pages and videos come to stand under their names."""

import os
import secrets
import sys
from contextlib import contextmanager
from pathlib import Path

READ = (".h5", ".csv", ".toml")  # files that a run reads, or leaves to be read


class Refused(Exception):
    """What was asked for cannot be done with what is there; the message is one line."""


def printable(path):
    return os.fsencode(path).decode(errors="backslashreplace")


def refuse(words):
    """Ends the script with 2 and a line on standard error."""
    print(printable(str(words)), file=sys.stderr)
    sys.exit(2)


def told(error):
    """Of an OSError, without its number."""
    if not error.strerror:
        return str(error) or type(error).__name__
    return f"{error.filename}: {error.strerror}" if error.filename else error.strerror


def require_replaceable(path, place):
    """place: where the links at path lead. Refused unless that is free, or a file of the same kind
    and none that a file of a run beside path stands for."""
    if place.suffix != path.suffix:
        raise Refused(f"{path} is a link to {place}, which is no {path.suffix} file; the output "
                      "would destroy it")
    if place.exists() and not place.is_file():
        raise Refused(f"{path} is no file, and is not replaced")
    for beside in path.parent.glob("*"):
        if beside.suffix in READ and beside.is_symlink() and beside.resolve() == place:
            raise Refused(f"{path} is the input {beside}; the output would destroy it")


def new_part(path, place):
    """An empty file beside place that no other writer has."""
    part = place.with_name(f"{place.name}.{secrets.token_hex(4)}.vortree.part")
    try:
        part.open("xb").close()
    except OSError as error:
        raise Refused(f"{path} cannot be written in the folder {place.parent}: "
                      f"{error.strerror}") from None
    return part


@contextmanager
def replaced(path):
    """A name to write under. What is written becomes the file in the end, the old one or the new one
    whatever happens; of several writers at once the last. A link is followed, but only onto a file
    of the same suffix."""
    place = Path(os.path.realpath(path))
    require_replaceable(path, place)
    part = new_part(path, place)
    try:
        yield part
        part.replace(place)
    finally:
        part.unlink(missing_ok=True)
