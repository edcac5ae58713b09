#!/usr/bin/python3
"""Random flows by SPH, well and badly chosen: none may end in another way than it should.

    campaign.py PROGRAM [--count N] [--seed S] [--first K] [--no-plain] [--verbose]

Each run draws a flow (a body at rest, that plunges or spins, in free space or a box; vortices in a
periodic box) at one of ten Reynolds numbers from 1 to 1000, and how it is computed: start, shift,
levels from 1 to 7, sides of the box, regions, Courant numbers and spacings up to what is too
large, and the rest of the keys of [sph] and [neighbors]. It has to end in one of these ways:

  refused   before anything runs, exit code 2, with one line that says why
  well      finite, with particles that fill the box within a tenth and a force within a factor of
            three of that by vortices, or with a warning beforehand; every eighth run by two
            threads, too, to the same bits
  stopped   exit code 1, with one line that tells step, reason and last good frame; frames open, and
            --resume comes to the same line

All else is a fault, and told with the command that shows it.

--count: how many runs (100), in a second or two each. --first: the number of the first, to see one
again by --seed S --first K --count 1. --no-plain: forces are not held against vortices. --verbose:
how each run ended, and its command.
"""

import argparse
import collections
import os
import random
import re
import sys
import tempfile
from pathlib import Path

from draws import FAMILIES, draw
from trial import Campaign, Fault, Outcome, exact_command


def main():
    words = argparse.ArgumentParser(usage=__doc__)
    words.add_argument("program", type=Path)
    words.add_argument("--count", type=int, default=100)
    words.add_argument("--seed", type=int, default=1)
    words.add_argument("--first", type=int, default=0)
    words.add_argument("--no-plain", action="store_true")
    words.add_argument("--verbose", action="store_true")
    # In memory: the disk is not what is tried.
    words.add_argument("--where", default="/dev/shm" if os.access("/dev/shm", os.W_OK) else None)
    asked = words.parse_args()
    with tempfile.TemporaryDirectory(prefix="vortree-campaign-", dir=asked.where) as folder:
        campaign = Campaign(asked.program.resolve(), Path(folder), not asked.no_plain)
        outcomes = [one(campaign, asked, k) for k in range(asked.first, asked.first + asked.count)]
    tell(outcomes)
    sys.exit(any(outcome.kind == "fault" for _, outcome in outcomes))


def one(campaign, asked, k):
    """Each has random numbers of its own, so that it can be had alone."""
    drawn = draw(random.Random(f"{asked.seed} {k}"))
    try:
        outcome = campaign.judge(drawn, other_threads=k % 8 == 0)
    except Fault as wrong:
        outcome = Outcome("fault", why=str(wrong))
        print(f"FAULT {k}, {drawn.family}: {wrong}\n    {exact_command(campaign, drawn)}",
              flush=True)
    if asked.verbose:
        print(f"{k} {drawn.family} {outcome}\n    {exact_command(campaign, drawn)}", flush=True)
    return drawn.family, outcome


COLUMNS = ("runs", "refused", "ended well", "of them warned of", "and poor", "stopped",
           "of them warned of", "faults")


def counts(outcomes):
    ended = [outcome for outcome in outcomes if outcome.kind == "well"]
    stopped = [outcome for outcome in outcomes if outcome.kind == "stopped"]
    return (len(outcomes), sum(outcome.kind == "refused" for outcome in outcomes), len(ended),
            sum(outcome.warned for outcome in ended), sum(bool(outcome.poor) for outcome in ended),
            len(stopped), sum(outcome.warned for outcome in stopped),
            sum(outcome.kind == "fault" for outcome in outcomes))


def tell(outcomes):
    print(f"| {'flow':15} | {' | '.join(COLUMNS)} |")
    print("|---" * (len(COLUMNS) + 1) + "|")
    for family in (*FAMILIES, "all"):
        among = [outcome for name, outcome in outcomes if family in (name, "all")]
        print(f"| {family:15} | {' | '.join(map(str, counts(among)))} |")
    doubts = collections.Counter(doubt.split()[1].rstrip(":") for _, outcome in outcomes
                                 if outcome.kind == "stopped" for doubt in outcome.doubts)
    print(f"stopped, and warned of: {', '.join(f'{key} {n}' for key, n in doubts.most_common())}")
    for kind in ("refused", "stopped"):
        reasons = collections.Counter(reason(outcome.why) for _, outcome in outcomes
                                      if outcome.kind == kind)
        for why, count in reasons.most_common():
            print(f"{kind} {count}: {why}")
    for poor, count in collections.Counter(outcome.poor.split(" = ")[0] for _, outcome in outcomes
                                           if outcome.poor).most_common():
        print(f"poor {count}: {poor}")


def reason(why):
    """Without its numbers and places."""
    why = re.sub(r"^step \d+, t = [^:]*: |; the last good frame.*", "", why)
    return re.sub(r"[-+]?\d[\d.]*(e[-+]?\d+)?", "#", why)[:110]


main()
