#!/usr/bin/python3
"""Writes methods_cost.csv anew: what a step of SPH costs by particles and threads.

    ./vortree run SCENE sph.spacing=S time.end=T 'output.fields=[]' check={} --threads N --out RUN
    cases/cost.py RUN...

A row a run: particles at most, threads, microseconds of the steps' time a particle and step, shares
of pressure and neighbors in it, bytes of memory a particle.
"""

from _kept import summaries, write

NAMES = ("particles", "threads", "microseconds", "pressure", "neighbors", "bytes")


def row(summary):
    seconds = {phase: took for phase, took in summary["seconds"].items() if phase != "total"}
    whole = sum(seconds.values())
    return (summary["largest_particle_count"], summary["threads"],
            f"{1e6 * whole / summary['particle_steps']:.4f}",
            f"{seconds['pressure'] / whole:.4f}", f"{seconds['neighbors'] / whole:.4f}",
            f"{summary['peak_bytes'] / summary['largest_particle_count']:.0f}")


write("methods_cost.csv", "cost.py", NAMES, map(row, summaries(__doc__)))
