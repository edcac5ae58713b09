#!/usr/bin/python3
"""What becomes of a run when something breaks.

    faults.py PROGRAM PRELOAD [--trials N] [--seed S] [--all] [--only WORD]

Every trial spoils one run (or one other output), looks at how the program ended, then goes on with
--resume. The end must be one of these: the same results as those of a run that nothing happened to,
bit for bit but for seconds; or one line that says why not, with exit code 2, after which a run with
--overwrite gives the same results. Never a signal that nobody sent, never words of a library's
inside, never different results, never a file left over.

PRELOAD is the library made from faults.c. --trials: how many runs are killed up to three times, and
in proportion the damages of each kind and the places of failing calls (12); --all: more scenes.
"""

import argparse
import collections
import concurrent.futures
import os
import random
import sys
import tempfile
import traceback
from pathlib import Path

import calls
import damage
import outputs
import while_running
from bench import Bench


KINDS = (*calls.KINDS, *damage.KINDS, *while_running.KINDS, *outputs.KINDS)


def main():
    words = argparse.ArgumentParser(usage=__doc__)
    words.add_argument("program", type=Path)
    words.add_argument("preload", type=Path)
    words.add_argument("--trials", type=int, default=12)
    words.add_argument("--seed", type=int, default=1)
    words.add_argument("--all", action="store_true")
    words.add_argument("--only", default="")
    # In memory: what is tried is the order of calls, not the disk, which would be waited for.
    words.add_argument("--where", default="/dev/shm" if os.access("/dev/shm", os.W_OK) else None)
    asked = words.parse_args()
    with tempfile.TemporaryDirectory(prefix="vortree-faults-", dir=asked.where) as folder:
        os.chmod(folder, 0o777)
        bench = Bench(asked.program.resolve(), asked.preload.resolve(), Path(folder), asked.all)
        chance = random.Random(asked.seed)
        trials = [trial for kind in KINDS for trial in kind(bench, asked.trials, chance)
                  if asked.only in trial.kind]
        failed = run_all(trials)
    sys.exit("\n".join(failed) or None)


def run_all(trials):
    held, failed = collections.Counter(), []
    outcomes = collections.defaultdict(collections.Counter)

    def one(trial):
        try:
            return trial.act(), None
        except AssertionError as wrong:
            return None, str(wrong)
        except Exception:  # a fault of the test itself
            return None, traceback.format_exc()

    with concurrent.futures.ThreadPoolExecutor(os.cpu_count() or 1) as pool:
        for trial, (outcome, wrong) in zip(trials, pool.map(one, trials)):
            outcomes[trial.kind][outcome or "FAILED"] += 1
            held[trial.kind] += wrong is None
            if wrong:
                failed.append(f"{trial.kind}: {trial.what}: {wrong}")
    for kind, counts in outcomes.items():
        told = ", ".join(f"{n} {what}" for what, n in counts.most_common())
        print(f"{kind:34} {held[kind]:4} of {sum(counts.values()):4}   {told}")
    print(f"{'all':34} {sum(held.values()):4} of {len(trials):4}")
    return failed


main()
