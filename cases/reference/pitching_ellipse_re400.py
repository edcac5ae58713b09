"""Ellipse of half axes 0.5 x 0.25 that pitches about a quarter of its length in a sudden stream,
angle = -20 sin(2 pi 0.5 t) degrees, Re = 400, to T = 4. Makes pitching_ellipse_forces_re400.csv, in
some minutes.

    python3 pitching_ellipse_re400.py OUTDIR [--fine F]
"""

from ellipse_flow import Case, main

PITCHING = Case("Ellipse of half axes 0.5 and 0.25 that pitches about x = -0.25 by 20 degrees,"
                " 0.5 U/D times a time D/U, Re = 400.",
                reynolds=400, end=4, reach=4.0, points=(128, 256), axes=(0.5, 0.25), pitch=-20,
                pitch_frequency=0.5, about=-0.25)

if __name__ == "__main__":
    main(PITCHING, "pitching_ellipse_forces_re400.csv")
