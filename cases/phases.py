#!/usr/bin/python3
"""Writes methods_phases.csv anew: what a run by each method has paid, and for what.

    ./vortree run SCENE method=METHOD ... --out RUN       one for each method
    cases/phases.py RUN...

A row for each number of its summary.json: particles at most, steps, particle-steps, bytes of memory
at most, seconds of the processor, and seconds by phase.
"""

from _kept import summaries, write

NAMES = ("method", "what", "number")
TOLD = ("steps", "particle_steps", "peak_bytes", "processor_seconds")


def rows_of(summary):
    most = next(name for name in summary if name.startswith("largest_") and name.endswith("_count"))
    yield "particles", summary[most]
    for name in TOLD:
        yield name, summary[name]
    for phase, seconds in summary["seconds"].items():
        if phase != "total":
            yield f"seconds {phase}", seconds


write("methods_phases.csv", "phases.py", NAMES,
      ((summary["method"], *row) for summary in summaries(__doc__) for row in rows_of(summary)))
