"""Flow of a viscous fluid past an ellipse or a circle that starts at once, moves to and fro, spins or
pitches: the solver of ellipse_re400.py, plunging_cylinder_re200.py, oscillating_cylinder_re100.py,
spinning_cylinder_re200.py and pitching_ellipse_re400.py.

The plane outside the ellipse of half axes a, b is that outside a circle of radius R0 = (a + b)/2,

    z = zeta + c2/zeta,   zeta = R0 exp(xi + i theta),   c2 = (a^2 - b^2)/4,

whose metric factor h2 = |zeta - c2/zeta|^2 is all that vorticity and stream function feel of it:

    h2 d omega/dt = psi_xi omega_theta - psi_theta omega_xi + nu (omega_xixi + omega_thetatheta)
    psi_xixi + psi_thetatheta = -h2 omega,   u = psi_y,  v = -psi_x

in the frame of the body: one that moves by X(t) is at rest in the stream U - dX/dt. psi is the
potential flow of that stream, which is known, and a rest that is 0 at the wall and falls off as
exp(-|n| xi) beyond all vorticity.

A body that turns, at the rate Omega, has axes that turn with it. Convection is then by psi +
Omega |z|^2/2, which is even and flat at the wall; of it the potential flow makes what is not even,

    psi = -Omega c2 cos(2 theta) exp(-2 xi),

and the slip has Omega (2 c2 cos(2 theta) + R0^2 - c2^2/R0^2) more. So the circulation of fluid and
body, -2 Omega A + 2 Omega A, is 0.

Theta: Fourier series, no symmetry assumed. Xi: Chebyshev points in s, exp(xi) - 1 a multiple of
exp(STRETCH s) - 1: fine at the wall, and fine enough in the wake. Time: backward differences of
third order for diffusion along xi, implicit on each line of constant theta; extrapolation of third
order for all else. At the wall the vorticity is what makes the slip vanish: the slip of mode n is a
sum of its h2 omega over xi with fixed weights (the integral condition of Quartapelle & Valz-Gris,
Int. J. Numer. Meth. Fluids 1 (1981), in the discrete form), so that the slip by a layer which is 1
at the wall on one line is a column of a matrix. The start is the boundary layer of first order in
sqrt(nu t), its strength corrected by the same condition, at t = START; what it lacks is forgotten
as START/t.

Per unit density, with the fluid pushed by X'' in this frame (area A), the force on the body is

    F = nu oint (y, -x) omega_xi d theta + A X''    by pressure
      + nu oint (x_theta, y_theta) omega d theta    by friction
      = -d/dt int (y, -x) omega dA + A X''          by impulse, held against both.

(About its centre, an ellipse that turns feels no force of the turning itself.) The moment about the
centre is that of -dp/ds = -nu omega_n + a t, a the wall's acceleration, and of the friction nu
(omega - 2 Omega).

Units: stream (or greatest speed), diameter (or long axis) and density are 1, nu = 1/Re, T = 2 t.
ellipse_flow_checks.py holds this against other solutions. Needs numpy and scipy; shares nothing
with the program that is held against it.
"""

import argparse
import os
import sys
import time
from dataclasses import dataclass

import numpy as np
from scipy.fft import irfft, rfft
from scipy.special import erfc

from impulsive_cylinder import weights

START, STRETCH, COARSE = 1e-4, 4.5, 0.75


@dataclass
class Case:
    title: str
    reynolds: float
    end: float                 # of T
    reach: float               # of the points, in long axes from the centre
    points: tuple              # in xi and in theta
    axes: tuple = (0.5, 0.5)   # half axes a, b
    incidence: float = 0.0     # nose up [degrees]
    stream: complex = 1.0
    amplitude: complex = 0.0   # X = amplitude cos(2 pi frequency t)
    frequency: float = 0.0
    spin: float = 0.0          # turned by spin t + pitch sin(2 pi pitch_frequency t), anticlockwise
    pitch: float = 0.0         # [degrees]
    pitch_frequency: float = 0.0
    about: complex = 0.0       # the pivot, from the centre at angle 0

    def turning(self, t):
        """Angle, rate and spin-up."""
        w, a = 2 * np.pi * self.pitch_frequency, np.radians(self.pitch)
        return (self.spin * t + a * np.sin(w * t), self.spin + a * w * np.cos(w * t),
                -a * w * w * np.sin(w * t))

    def turn(self, t):
        """From the body's axes to those of the stream."""
        return np.exp(1j * (self.turning(t)[0] - np.radians(self.incidence)))

    def relative_stream(self, t):
        w, (angle, rate, _) = 2 * np.pi * self.frequency, self.turning(t)
        return (self.stream + w * np.sin(w * t) * self.amplitude
                + 1j * rate * self.about * np.exp(1j * angle))

    def acceleration(self, t):
        w, (angle, rate, spin_up) = 2 * np.pi * self.frequency, self.turning(t)
        return (-w * w * np.cos(w * t) * self.amplitude
                - (1j * spin_up - rate**2) * self.about * np.exp(1j * angle))


def chebyshev(n):
    """Points of [0, 1], and the derivative's matrix (Berrut & Trefethen, SIAM Rev. 46 (2004))."""
    s = np.sin(np.pi * np.arange(n) / (2 * n - 2))**2
    w = (-1.0)**np.arange(n)
    w[[0, -1]] /= 2
    apart = s[:, None] - s + np.eye(n)
    d = w / w[:, None] / apart - np.eye(n)
    return s, d - np.diag(d.sum(axis=1))


class Flow:
    def __init__(self, case, fine=1.0):
        self.case, self.nu, self.fine = case, 1 / case.reynolds, fine
        self.radial_points(round(case.points[0] * fine) + 1)
        self.map_to_ellipse(4 * round(case.points[1] * fine / 4))
        self.solve_poisson()
        self.t, self.rate, self.past = START, None, []
        for t in START * np.array([0.98**3, 0.98**2, 0.98, 1]):
            self.keep(t, self.first_layer(t))

    def radial_points(self, n):
        a, b = self.case.axes
        far = self.case.reach / ((a + b) / 2) - 1
        s, d = chebyshev(n)
        self.xi = np.log1p(far * np.expm1(STRETCH * s) / np.expm1(STRETCH))
        self.d1 = d / (d @ self.xi)[:, None]
        self.d2 = self.d1 @ self.d1
        self.over_xi = np.concatenate(([0], np.linalg.inv(self.d1[1:, 1:])[-1]))  # integral
        self.spacing = np.gradient(self.xi)[:, None]

    def map_to_ellipse(self, n):
        a, b = self.case.axes
        self.radius, self.c2 = (a + b) / 2, (a * a - b * b) / 4
        c2 = self.c2
        self.theta, self.n = 2 * np.pi * np.arange(n) / n, np.arange(n // 2 + 1)
        self.first, self.second = 1j * self.n, -self.n**2.0
        self.first[-1] = 0
        zeta = self.radius * np.exp(self.xi[:, None] + 1j * self.theta)
        self.z, self.h2 = zeta + c2 / zeta, np.abs(zeta - c2 / zeta)**2
        self.z_theta = 1j * (zeta[0] - c2 / zeta[0])
        self.zeta, self.area = zeta, np.pi * a * b
        quarter = np.arange(n // 4 + 1)  # lines of one h2 side by side
        self.alike = (np.arange(n)[None] if c2 == 0 else
                      np.stack([quarter, n // 2 - quarter, n // 2 + quarter, -quarter % n], 1))

    def solve_poisson(self):
        """psi of h2 omega for each mode, and the weights of its slip at the wall."""
        m, n = len(self.xi), self.n
        matrix = self.d2 - (n**2)[:, None, None] * np.eye(m)
        matrix[:, 0], matrix[:, -1] = np.eye(m)[0], self.d1[-1] + n[:, None] * np.eye(m)[-1]
        self.poisson = -np.linalg.inv(matrix)
        self.poisson[:, :, [0, -1]] = 0
        self.slip_weights = self.d1[0] @ self.poisson

    def stream_function(self, omega):
        """Of the rest: its modes."""
        f = np.ascontiguousarray(rfft(self.h2 * omega).T)
        both = f.view(float).reshape(*f.shape, 2)
        return np.ascontiguousarray(self.poisson @ both).view(complex)[:, :, 0].T

    def slip(self, t, omega):
        """psi_xi at the wall, as the body sees it."""
        stream = np.conj(self.case.relative_stream(t) / self.case.turn(t))
        rest = np.einsum("nk,kn->n", self.slip_weights, rfft(self.h2 * omega))
        turning = 2 * self.c2 * np.cos(2 * self.theta) + self.area / np.pi
        return (irfft(rest) + 2 * np.imag(stream * self.zeta[0])
                + self.case.turning(t)[1] * turning)

    def influence(self, layer):
        """Column j: the slip by the layer on line j alone."""
        alone = self.slip_weights @ (self.h2 * layer)
        return irfft(alone * np.exp(-1j * np.outer(self.n, self.theta)), axis=0)

    def first_layer(self, t):
        y = np.sqrt(self.h2[0]) * self.xi[:, None] / np.sqrt(4 * self.nu * t)
        layer = np.exp(-y**2)  # of a sudden stream; else of one that grows with t
        if self.case.relative_stream(0) == 0 and self.case.turning(0)[1] == 0:
            layer = layer / np.sqrt(np.pi) - y * erfc(y)
        return -layer * np.linalg.solve(self.influence(layer), self.slip(t, 0 * layer))

    def keep(self, t, omega):
        """omega, what acts on it but for radial diffusion, and its impulse; the last four."""
        impulse = self.over_xi @ (-1j * self.z * omega * self.h2).mean(axis=1) * 2 * np.pi
        impulse *= self.case.turn(t)
        self.t = t
        self.past = [(t, omega, self.convection(t, omega), impulse)] + self.past[:3]

    def convection(self, t, omega):
        """Convection less diffusion along theta; leaves the rate that bounds steps."""
        modes, psi = rfft(omega), self.stream_function(omega)
        stream = np.conj(self.case.relative_stream(t) / self.case.turn(t)) * self.zeta
        rate = self.case.turning(t)[1]
        mirrored = np.exp(-2 * self.xi[:, None])
        far, near = np.abs(self.zeta)**2, self.c2**2 / np.abs(self.zeta)**2
        psi_xi = (self.d1 @ irfft(psi) + (1 + mirrored) * stream.imag
                  + rate * (2 * self.c2 * np.cos(2 * self.theta) * mirrored + far - near))
        psi_theta = (irfft(self.first * psi) + (1 - mirrored) * stream.real
                     - 2 * rate * self.c2 * np.sin(2 * self.theta) * (1 - mirrored))
        last = self.n[-1]
        self.fastest = ((np.abs(psi_xi) * last + np.abs(psi_theta) * 1.5 / self.spacing
                         + 0.7 * self.nu * last**2) / self.h2)[1:-1].max()
        return (psi_theta * (self.d1 @ omega) - psi_xi * irfft(self.first * modes)
                - self.nu * irfft(self.second * modes))

    def implicit(self, rate):
        """The inverse of rate h2 - nu d2/dxi2 on each line, and layers that are 1 at the wall."""
        if self.rate is not None and abs(rate / self.rate - 1) < 1e-9:
            return
        inner = slice(1, -1)
        self.rate = rate
        matrix = np.tile(-self.nu * self.d2[inner, inner], (len(self.alike), 1, 1))
        k = np.arange(matrix.shape[1])
        matrix[:, k, k] += rate * self.h2[inner, self.alike[:, 0]].T
        self.inverse = np.linalg.inv(matrix)
        self.layer = np.zeros_like(self.h2)
        self.layer[0] = 1
        self.along_lines(self.layer, np.tile(self.nu * self.d2[inner, :1], len(self.theta)))
        self.cancel = np.linalg.inv(self.influence(self.layer))

    def along_lines(self, out, f):
        f = f[:, self.alike].transpose(1, 0, 2)
        out[1:-1, self.alike] = (self.inverse @ f).transpose(1, 0, 2)

    def step(self, t):
        times = np.array([t] + [past[0] for past in self.past[:3]])
        back, ahead = weights(times, t, 1)[1], weights(times[1:], t, 0)[0]
        self.implicit(back[0])
        f = sum(-b * self.h2 * past[1] - e * past[2]
                for b, e, past in zip(back[1:], ahead, self.past))
        omega = np.zeros_like(self.h2)
        self.along_lines(omega, f[1:-1])
        omega -= self.layer * (self.cancel @ self.slip(t, omega))
        self.keep(t, omega)

    def advance(self, t):
        """To t in equal steps."""
        longest = min(0.05 * self.t / self.fine, 0.6 / self.fastest)
        start, steps = self.t, int(np.ceil((t - self.t) / longest - 1e-9))
        for k in range(1, steps + 1):
            self.step(start + (t - start) * k / steps)

    def forces(self):
        """Coefficients, drag + i lift: by pressure, by friction, by the rate of impulse; moment."""
        t, omega = self.past[0][:2]
        push = self.area * self.case.acceleration(t)

        def around(f):
            return 2 * np.pi * f.mean() * self.case.turn(t)

        pressure = -1j * self.nu * around(self.z[0] * (self.d1[0] @ omega)) + push
        friction = self.nu * around(self.z_theta * omega[0])
        rates = weights(np.array([past[0] for past in self.past]), t, 1)[1]
        impulse = -sum(r * past[3] for r, past in zip(rates, self.past)) + push
        return 2 * pressure, 2 * friction, 2 * impulse, 2 * self.moment(t, omega)

    def moment(self, t, omega):
        _, rate, spin_up = self.case.turning(t)
        z, z_theta = self.z[0], self.z_theta
        wall = (1j * spin_up - rate**2) * z + self.case.acceleration(t) / self.case.turn(t)
        pushed = np.real(np.conj(wall) * z_theta) - self.nu * (self.d1[0] @ omega)
        rubbed = self.nu * (omega[0] - 2 * rate) * np.imag(np.conj(z) * z_theta)
        return 2 * np.pi * (np.abs(z)**2 * pushed / 2 + rubbed).mean()

    def left_over(self):
        """Of all vorticity: the last twentieth of the modes, and what is next to the edge."""
        omega = self.past[0][1]
        modes = np.abs(rfft(omega)).max(axis=0)
        edge = np.abs(omega[self.xi > 0.97 * self.xi[-1]]).max() / np.abs(omega).max()
        return modes[-len(modes) // 20:].max() / modes.max(), edge


def rows_until(end):
    """T of the rows: close enough that a cubic through four of them is good to 2e-5."""
    return np.concatenate((np.arange(4, 40) / 200, np.arange(20, 50, 2) / 100,
                           np.arange(10, round(20 * end) + 1) / 20))


def solve(case, fine):
    """Rows of T and the forces."""
    flow, began, rows = Flow(case, fine), time.time(), []
    for t in np.geomspace(START, 0.01, 12)[1:-1]:
        flow.advance(t)
    for T in rows_until(case.end):
        flow.advance(T / 2)
        pressure, friction, impulse, moment = flow.forces()
        rows.append((T, pressure, friction, impulse, moment))
        force, (modes, edge) = pressure + friction, flow.left_over()
        print(f"T {T:.3f} C_D {force.real:.6f} C_L {force.imag:.6f} "
              f"routes {abs(force - impulse):.1e} modes {modes:.1e} edge {edge:.1e} "
              f"dt {flow.t - flow.past[1][0]:.2e} seconds {time.time() - began:.0f}",
              file=sys.stderr, flush=True)
    return flow, np.array(rows)


def largest(T, off, bounds):
    """Of differences, in windows of T that end at the bounds."""
    return "  ".join(f"{np.abs(off[(T >= a - 1e-9) & (T <= b + 1e-9)]).max():.0e}"
                     for a, b in zip(bounds, bounds[1:]))


def header(case, flow, rows, coarse):
    T, force = rows[:, 0].real, rows[:, 1] + rows[:, 2]
    off = force - coarse[:, 1] - coarse[:, 2]
    layers, angles = flow.h2.shape
    bounds = [0.02, 0.05, 0.2, 1, *(b for b in (4, 10, 20) if b < case.end), case.end]
    return f"""\
# {case.title}
# Solution made for this project (ellipse_flow.py).
# T = 2 t in units of the diameter (or long axis) D and the stream (or greatest speed) U; tstar = T/2.
# C_D, C_L = forces along and across / (0.5 rho U^2 D) = C_Dp, C_Lp (pressure) + C_Df, C_Lf (friction).
# C_M = moment about the centre, anticlockwise / (0.5 rho U^2 D^2).
# Method: Fourier series in theta ({angles} points), Chebyshev points ({layers}) to {case.reach:g} D,
# exact no-slip constraint, BDF3.
# Check: largest differences in windows that end at T =  {"  ".join(f"{b:<5g}" for b in bounds[1:])}
#   C_D with {COARSE:g} of the points, longer steps        {largest(T, off.real, bounds)}
#   C_L                                              {largest(T, off.imag, bounds)}
#   force at the wall less rate of impulse           {largest(T, force - rows[:, 3], bounds)}
T,tstar,C_D,C_Dp,C_Df,C_L,C_Lp,C_Lf,C_M
"""


def write(path, case, fine):
    coarse = solve(case, COARSE * fine)[1]
    flow, rows = solve(case, fine)
    with open(path, "w") as out:
        out.write(header(case, flow, rows, coarse))
        for T, p, f, _, m in rows:
            values = [x + 0.0 for w in (p + f, p, f) for x in (round(w.real, 5), round(w.imag, 5))]
            values = values[::2] + values[1::2] + [round(m.real, 5) + 0.0]
            out.write(f"{T.real:.3f},{T.real / 2:.4f}," + ",".join(f"{x:.5f}" for x in values)
                      + "\n")


def main(case, name):
    """The command of a script that makes one reference."""
    parser = argparse.ArgumentParser()
    parser.add_argument("out")
    parser.add_argument("--fine", type=float, default=1.0)
    a = parser.parse_args()
    write(os.path.join(a.out, name), case, a.fine)
