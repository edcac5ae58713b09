"""Ellipse of half axes 0.5 x 0.25 at 20 degrees of incidence in a sudden stream, Re = 400, to
T = 6: the flow of cases/ellipse.toml with body.across=0.25. Makes ellipse_forces_re400.csv, in ten
minutes.

    python3 ellipse_re400.py OUTDIR [--fine F]
"""

from ellipse_flow import Case, main

ELLIPSE = Case("Impulsively started ellipse, half axes 0.5 and 0.25, nose up by 20 degrees,"
               " Re = 400.",
               reynolds=400, end=6, reach=4.5, points=(160, 320), axes=(0.5, 0.25), incidence=20)

if __name__ == "__main__":
    main(ELLIPSE, "ellipse_forces_re400.csv")
