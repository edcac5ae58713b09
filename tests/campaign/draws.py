"""Flows by SPH drawn at random: what flows, and how it is computed."""

import dataclasses
import math

REYNOLDS = (1, 2, 5, 10, 20, 50, 100, 200, 500, 1000)
METHODS = ("qcg", "level-grids", "uniform-grid", "linked-list", "leaf-quadtree", "r-tree",
           "all-pairs")
MOST_PARTICLES = 5000
LONGEST = 2  # lengths at the speed of the flow: T = 4, as far as the plain runs go


@dataclasses.dataclass
class Draw:
    family: str
    keys: dict        # of the scene, as they are written
    plain: dict       # the same flow for vortices: length and speed 1, the stream along x; or none
    length: float
    speed: float
    end: float        # T of the end
    edge: float = 0   # volume of particles that the nodes of the box overlap, in that of the box

    def words(self):
        return [f"{key}={written(value)}" for key, value in self.keys.items()]


def written(value):
    if isinstance(value, bool):
        return str(value).lower()
    if isinstance(value, float):
        return f"{value:.12g}"
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(map(written, value))}]"
    if isinstance(value, dict):
        return f"{{{', '.join(f'{key}={written(one)}' for key, one in value.items())}}}"
    return str(value)


def rounded(value):
    """Short enough for a command line."""
    return float(f"{value:.3g}")


def between(random, low, high):
    return rounded(random.uniform(low, high))


def logarithmic(random, low, high):
    return rounded(math.exp(random.uniform(math.log(low), math.log(high))))


def turned(angle, vector):
    x, y = vector
    c, s = math.cos(angle), math.sin(angle)
    return [c * x - s * y, s * x + c * y]


# What flows: keys for a length and a speed of 1, with all along x. Few values each, so that plain
# runs serve many draws.

def circle(random):
    return {"body.shape": "circle", "body.radius": 0.5}


def ellipse(random):
    return {"body.shape": "ellipse", "body.radius": 0.5, "body.across": random.choice((0.15, 0.3)),
            "body.incidence": random.choice((0.0, 30.0, 90.0))}


def foil(random):
    return {"body.shape": "naca0012", "body.chord": 1.0,
            "body.incidence": random.choice((0.0, 15.0))}


def plunging(random):
    # Greatest speed 1 in fluid at rest, 0.5 in a stream of 1.
    if random.random() < 0.5:
        return {**circle(random), "plunge.amplitude": 0.4, "plunge.frequency": 1 / (0.8 * math.pi),
                "plunge.direction": [1.0, 0.0], "flow.stream": [0.0, 0.0]}
    return {**circle(random), "plunge.amplitude": 0.1, "plunge.frequency": 2.5 / math.pi,
            "plunge.direction": [0.0, 1.0]}


def spinning(random):
    stream = [0.0, 0.0] if random.random() < 0.3 else [1.0, 0.0]
    return {**circle(random), "motion.spin": random.choice((-2.0, 2.0)), "flow.stream": stream}


def beside_vortex(random):
    return {**circle(random), "initial.kind": "lamb_oseen", "initial.core": 0.25,
            "initial.circulation": random.choice((-1.0, 1.0, 5.0)), "initial.centre": [1.2, 0.4]}


BODIES = {"circle": circle, "circle in a box": circle, "ellipse": ellipse, "foil": foil,
          "plunging": plunging, "spinning": spinning, "beside a vortex": beside_vortex}
FAMILIES = (*BODIES, "taylor_green")


def scaled(flow, angle, length, speed, centre):
    """The flow turned, of another size, and elsewhere."""
    powers = {"body.radius": (1, 0), "body.across": (1, 0), "body.chord": (1, 0),
              "plunge.amplitude": (1, 0), "plunge.frequency": (-1, 1), "motion.spin": (-1, 1),
              "initial.core": (1, 0), "initial.circulation": (1, 1), "flow.stream": (0, 1),
              "initial.centre": (1, 0), "plunge.direction": (0, 0)}
    keys = dict(flow)
    for key, (by_length, by_speed) in powers.items():
        if key not in keys:
            continue
        by = length ** by_length * speed ** by_speed
        value = keys[key]
        keys[key] = ([by * x for x in turned(angle, value)] if isinstance(value, list)
                     else by * value)
    if "initial.centre" in keys:
        keys["initial.centre"] = [x + c for x, c in zip(keys["initial.centre"], centre)]
    if "body.incidence" in keys:
        incidence = keys["body.incidence"] - math.degrees(angle)
        keys["body.incidence"] = (incidence + 180) % 360 - 180
    keys["body.centre"] = list(centre)
    return keys


# How it is computed: lengths in those of the flow.

def numbers(random):
    """Keys of every family, each left to its default now and then."""
    degree = random.choice((2, 2, 4))
    keys = {"seed": random.randrange(2 ** 31), "sph.degree": degree}

    def maybe(share, key, value):
        if random.random() < share:
            keys[key] = value

    maybe(0.5, "sph.reach", between(random, 2.4, 4) if degree == 2 else between(random, 3.2, 5))
    maybe(0.6, "sph.shift", random.choice((0.0, between(random, 0, 4), between(random, 4, 15))))
    maybe(0.7, "sph.courant", logarithmic(random, 0.05, 1))
    maybe(0.3, "sph.tolerance", logarithmic(random, 1e-9, 1e-2))
    maybe(0.3, "sph.growth", between(random, 1, 4))
    maybe(0.3, "neighbors.method", random.choice(METHODS))
    maybe(0.3, "neighbors.skin", between(random, 0, 1))
    if degree == 2:
        maybe(0.15, "sph.operators", "pair_sums")
    return keys


def region(random, around, spacing, widest, length):
    x, y = (c + between(random, -2, 2) * length for c in around)
    return {"centre": [x, y], "half_axes": [between(random, 0.1, 0.6) * length for _ in range(2)],
            "angle": between(random, -90, 90),
            "spacing": logarithmic(random, spacing, widest)}


def widths(finest, levels, zone, growth):
    """Spacing of each level and how far from the body it reaches, as sph/adapt/wanted_spacing."""
    width, spacing = zone, finest
    for _ in range(levels):
        yield spacing, width
        spacing *= 2
        width = growth * width + 2 * spacing


def particles(finest, levels, zone, growth, area):
    """About how many there are: bands around the body, and the rest of the box."""
    count, inner = 0, 0
    for spacing, width in list(widths(finest, levels, zone, growth))[:-1]:
        count += min(area, (3 + math.pi * (inner + width)) * (width - inner)) / spacing ** 2
        inner = width
    return count + area / (finest * 2 ** (levels - 1)) ** 2


def fits(finest, levels, zone, growth, rings, room):
    """The box has room for rings and levels."""
    reached = list(widths(finest, levels, zone, growth))
    coarsest = reached[-1][0]
    if (rings + 2) * finest + 2 * coarsest > room:
        return False
    return levels == 1 or room > (reached[-2][1] + zone) / 2


def past_body(random, family):
    flow = {"flow.reynolds": random.choice(REYNOLDS), "flow.stream": [1.0, 0.0],
            **BODIES[family](random)}
    usual = random.random() < 0.7
    length, speed = (1.0, 1.0) if usual else (logarithmic(random, 1e-3, 1e3) for _ in range(2))
    angle = random.choice((0.0, math.pi / 2, math.pi, -math.pi / 2, between(random, -3, 3)))
    centre = [0.0, 0.0] if usual else [between(random, -9, 9) * length for _ in range(2)]
    keys = {**scaled(flow, angle, length, speed, centre), **numbers(random)}

    thin = {"foil": 5, "ellipse": 1.5}.get(family, 1)
    spacing = logarithmic(random, 1 / 16 / thin, 1 / 4.5 / thin)
    if random.random() < 0.15 and family != "foil":
        keys["accuracy"] = logarithmic(random, 0.015, 0.3)
        spacing = min(5 * keys["accuracy"] * min(1, math.sqrt(20 / flow["flow.reynolds"])), 0.1)
    else:
        keys["sph.spacing"] = spacing * length
    rings = 4
    if random.random() < 0.3:
        rings = keys["sph.rings"] = random.randint(1, 6)
    zone = max(0.5, rings * spacing)
    if random.random() < 0.5:
        zone = between(random, 0.3, 1.5)
        keys["sph.zone"] = zone * length
    sides = [5.0, 5.0, 5.0, 5.0]
    if random.random() < 0.6:
        sides = [logarithmic(random, 1.2, 7) for _ in range(4)]
        keys["sph.box"] = [centre[0] - sides[0] * length, centre[1] - sides[1] * length,
                           centre[0] + sides[2] * length, centre[1] + sides[3] * length]
    growth = keys.get("sph.growth", 2)
    room = min(sides) - 0.5
    levels = random.randint(1, 7)
    if random.random() < 0.9:  # else as drawn, which may be refused
        if zone < rings * spacing:
            zone = keys["sph.zone"] = 1.01 * rings * spacing
            keys["sph.zone"] *= length
        while levels > 1 and not fits(spacing, levels, zone, growth, rings, room):
            levels -= 1
    keys["sph.levels"] = levels
    if family == "circle in a box" or random.random() < 0.1:
        keys["sph.outside"] = "box"
    if random.random() < 0.25:
        keys["sph.vorticity"] = logarithmic(random, 0.03, 3) * speed
    if random.random() < 0.25:
        widest = spacing * 2 ** (levels - 1)
        keys["sph.region"] = [region(random, centre, spacing * length, widest * length, length)
                              for _ in range(random.randint(1, 2))]
    count = particles(spacing, levels, zone, growth, (sides[0] + sides[2]) * (sides[1] + sides[3]))
    if "sph.vorticity" in keys:
        count *= 1.5
    if count > MOST_PARTICLES:
        return None
    fastest = 1.5 if family == "plunging" else 2 if family == "spinning" else 1
    step = keys.get("sph.courant", 0.3) * spacing / fastest
    if random.random() < 0.2:
        step = rounded(logarithmic(random, 0.02, 2) * spacing)
        keys["time.dt"] = step * length / speed
    end = min(max(step, steps_for(random, count) * step), max(step, LONGEST))
    keys["time.end"] = rounded(end) * length / speed
    width, height = sides[0] + sides[2], sides[1] + sides[3]
    edge = spacing * 2 ** (levels - 1) * (width + height) / (width * height)
    still = "motion.spin" in flow and flow["flow.stream"] == [0.0, 0.0]  # nothing pulls anywhere
    return Draw(family, keys, {} if still else flow, length, speed, 2 * end, edge)


def steps_for(random, count):
    """A second or so, at some 300 000 particles and steps a second."""
    return max(5, min(150, round(random.uniform(0.3, 1) * 3e5 / count)))


def taylor_green(random):
    length, speed = (1.0, 1.0) if random.random() < 0.7 else (
        logarithmic(random, 1e-3, 1e3) for _ in range(2))
    spacing = rounded(1 / random.uniform(7, 40))
    levels = random.choice((1, 1, 2, 3))
    waves = random.choice((1, 1, 2))
    corner = [0.0, 0.0] if random.random() < 0.5 else [between(random, -1, 1) * length
                                                       for _ in range(2)]
    keys = {"initial.kind": "taylor_green", "initial.wavelength": length, "initial.speed": speed,
            "flow.reynolds": random.choice(REYNOLDS), "sph.outside": "periodic",
            "sph.box": [*corner, *(c + waves * length for c in corner)], **numbers(random),
            "sph.levels": levels, "sph.spacing": spacing / 2 ** (levels - 1) * length}
    if random.random() < 0.5:
        keys["sph.region"] = [
            region(random, [c + length / 2 for c in corner], keys["sph.spacing"],
                   spacing * length, 0.5 * length) for _ in range(random.randint(1, 2))]
    if random.random() < 0.3:
        keys["sph.vorticity"] = logarithmic(random, 0.03, 3) * speed
    count = waves ** 2 / spacing ** 2 * (1.5 if levels > 1 else 1)
    if count > MOST_PARTICLES:
        return None
    step = keys.get("sph.courant", 0.3) * keys["sph.spacing"] / length
    if random.random() < 0.2:
        step = rounded(logarithmic(random, 0.02, 2) * spacing)
        keys["time.dt"] = step * length / speed
    end = max(steps_for(random, count) * step, step)
    keys["time.end"] = rounded(end) * length / speed
    return Draw("taylor_green", keys, {}, length, speed, end)


def draw(random):
    """One that takes a second or so, if it can be computed at all."""
    while True:
        family = random.choice(FAMILIES)
        one = taylor_green(random) if family == "taylor_green" else past_body(random, family)
        if one:
            return one
