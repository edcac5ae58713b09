"""The outline of a body, as a patch in units of its radius, from its centre."""

import numpy as np
from _style import INK
from matplotlib.patches import Ellipse, Polygon

LOOK = {"facecolor": "#4d4d4d", "edgecolor": INK, "lw": 0.8, "zorder": 3}


def outline(body):
    turned = -body.get("incidence", 0)
    if body.get("shape") == "naca0012":
        return foil(body.get("edge", 0.005), np.radians(turned))
    across = body.get("across", body["radius"]) / body["radius"]
    return Ellipse((0, 0), 2, 2 * across, angle=turned, **LOOK)


def foil(edge, angle):
    """NACA 0012 with a rounded trailing edge, as in src/body/outline.hpp."""
    x = 0.5 * (1 + np.cos(np.linspace(0, np.pi, 200)))
    y = 0.6 * (0.2969 * np.sqrt(x) + x * (-0.126 + x * (-0.3516 + x * (0.2843 - 0.1036 * x))))
    y = (y + edge * x**4) * np.sqrt((1 - x) / (1 - x + edge / 2))
    x, y = 2 * np.r_[x, x[::-1]] - 1, 2 * np.r_[y, -y[::-1]]
    return Polygon(np.c_[x * np.cos(angle) - y * np.sin(angle),
                         x * np.sin(angle) + y * np.cos(angle)], **LOOK)
