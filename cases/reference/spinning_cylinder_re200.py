"""Circle that sets off in a stream and spins anticlockwise at once, its wall as fast as the stream,
Re = 200, to T = 10. Makes spinning_cylinder_forces_re200.csv, in some minutes.

    python3 spinning_cylinder_re200.py OUTDIR [--fine F]
"""

from ellipse_flow import Case, main

SPINNING = Case("Cylinder that spins anticlockwise in a sudden stream, Re = 200, its wall as fast as"
                " the stream.",
                reynolds=200, end=10, reach=6.5, points=(144, 256), spin=2.0)

if __name__ == "__main__":
    main(SPINNING, "spinning_cylinder_forces_re200.csv")
