"""vortree: velocities of vortices, neighbors of particles, quadtrees and flows.

- Plan, velocity: velocities of many vortices to a tolerance, by fast multipoles
- Neighbors: who is near whom, for particles of many sizes
- Quadtree: the tree under both
- run, read: a flow by the program, or a sweep of flows, and the folder that it leaves
- Simulation: a flow in memory, step by step
"""

import os as _os

# As the program itself does: threads that wait for the next sum leave the processor to others. Read
# once, as OpenMP is loaded with the compiled module; what the user has set stays.
_told = "OMP_WAIT_POLICY" in _os.environ
_os.environ.setdefault("OMP_WAIT_POLICY", "passive")
from . import _core as _core  # noqa: E402

if not _told:
    del _os.environ["OMP_WAIT_POLICY"]
from ._neighbors import Neighbors  # noqa: E402
from ._plan import Plan, velocity  # noqa: E402
from ._quadtree import Quadtree  # noqa: E402
from ._runs import Run, Sweep, read, run  # noqa: E402
from ._simulation import Simulation  # noqa: E402

__version__: str = _core.version
__all__ = ["Neighbors", "Plan", "Quadtree", "Run", "Simulation", "Sweep", "read", "run", "velocity"]
