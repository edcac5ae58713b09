"""The phases of a step, their words and their colours."""

from _style import BLUE, GREEN, GREY, INK, ORANGE, RED, SKY

WORDS = {"convect": "convect: velocities", "wall": "wall: slip and sheet"}
PURPLE, YELLOW = "#cc79a7", "#f0e442"  # the rest of Okabe & Ito
# Of the phases that a method names; output is grey.
COLOURS = (BLUE, ORANGE, GREEN, SKY, RED, PURPLE, YELLOW, INK)


def phases(report):
    """Those of the run's method, in the order of the report, with their words and colours."""
    names = [name.removeprefix("seconds_") for name in report if name.startswith("seconds_")]
    return [(name, WORDS.get(name, name), GREY if name == "output" else COLOURS[k % len(COLOURS)])
            for k, name in enumerate(names)]
