"""What all movies share: units, colours, and how many pictures there must be."""

import numpy as np
from _colours import COLOURS

LEAST = 10  # pictures


class Units:
    """The body's radius and the stream's speed, from its centre; those of the scene in free space.
    """

    def __init__(self, run):
        self.run, self.body = run, bool(run.bodies)
        self.length, self.centre = run.body if self.body else (1.0, np.zeros(2))
        self.speed = run.speed if self.body else 1.0

    def time(self, t):
        return t * self.speed / self.length

    def label(self, words, letters, units):
        return f"{words}  ${letters} {units if self.body else ''}$"


def even_colours(end):
    return {"cmap": COLOURS, "vmin": -end, "vmax": end}


def count(number, noun):
    return f"{number or 'no'} {noun}{'' if number == 1 else 's'}"
