"""Flows that end in a fraction of a second and leave every kind of file."""

OUTPUT = """
[output]
frames = {frames}
fields = [0.0, {frames}, {end}]
window = [-1.0, -1.0, 1.0, 1.0]
field_spacing = 0.25
"""

VORTEX = """
[flow]
nu = 1e-3
[cores]
sigma_0 = 0.06
sigma_max = 0.062
[initial]
kind = "lamb_oseen"
circulation = 1.0
core = 0.2
[time]
dt = 0.02
end = 0.16
[check]
circulation_max = 1e-9
""" + OUTPUT.format(frames=0.06, end=0.16)

CYLINDER = """
[flow]
nu = 0.02
stream = [1.0, 0.0]
[body]
shape = "circle"
radius = 0.5
panels = 64
[cores]
sigma_0 = 0.06
sigma_max = 0.09
[time]
dt = 0.02
end = 0.16
[velocity]
tolerance = 1e-4
""" + OUTPUT.format(frames=0.06, end=0.16)

FOIL = """
[flow]
nu = 0.02
stream = [1.0, 0.0]
[body]
shape = "naca0012"
chord = 1.0
panels = 600
[plunge]
amplitude = 0.1
frequency = 1.0
[cores]
sigma_0 = 0.02
sigma_max = 0.1
[merging]
box = [-1.0, -1.0, 0.6, 1.0]
[time]
dt = 0.02
end = 0.16
[velocity]
tolerance = 1e-4
""" + OUTPUT.format(frames=0.06, end=0.16)

WALK = VORTEX + """
[diffusion]
kind = "random_walk"
"""

# The table beside report.csv.
TABLES = {"vortex": "energy.csv", "walk": "energy.csv", "exchange": "energy.csv",
          "cylinder": "wall.csv", "foil": "wall.csv"}

QUICK = {"vortex": VORTEX, "cylinder": CYLINDER}
ALL = {**QUICK, "foil": FOIL, "walk": WALK,
       "exchange": WALK.replace("random_walk", "particle_exchange")}
