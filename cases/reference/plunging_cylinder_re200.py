"""Circle that plunges across a sudden stream, X = D/4 cos(2 pi 0.2 t) in y, Re = 200, to T = 10.
Makes plunging_cylinder_forces_re200.csv, in ten minutes.

    python3 plunging_cylinder_re200.py OUTDIR [--fine F]
"""

from ellipse_flow import Case, main

PLUNGING = Case("Cylinder that plunges across a stream, Re = 200; y = 0.25 D cos(2 pi 0.2 U t/D).",
                reynolds=200, end=10, reach=6.5, points=(144, 320), amplitude=0.25j, frequency=0.2)

if __name__ == "__main__":
    main(PLUNGING, "plunging_cylinder_forces_re200.csv")
