"""Circle that moves to and fro in fluid at rest, KC = 5, Re = 100, three periods: the flow of
cases/oscillating_cylinder.toml. Makes oscillating_cylinder_forces_re100.csv, in 5 minutes.

    python3 oscillating_cylinder_re100.py OUTDIR [--fine F]
"""

import numpy as np
from ellipse_flow import Case, main

OSCILLATING = Case("Cylinder that moves to and fro in fluid at rest, Re = 100, KC = 5;"
                   " x = KC/(2 pi) D cos(2 pi 0.2 V t/D).",
                   reynolds=100, end=30, reach=7, points=(112, 192), stream=0,
                   amplitude=5 / (2 * np.pi), frequency=0.2)

if __name__ == "__main__":
    main(OSCILLATING, "oscillating_cylinder_forces_re100.csv")
