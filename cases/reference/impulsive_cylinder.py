"""Reference solutions of the impulsively started cylinder: how cylinder_*_re{N}.csv beside this
file were made (but for Re = 550, which is older and by another program).

    python3 impulsive_cylinder.py RE END OUTDIR [--fine F] [--wall T,T,...]

F = 1 is the grid of the files, a larger F has finer cells, more harmonics and shorter steps.
Units inside: radius, stream and density are 1, so nu = 2/Re, T = U t/R is the time and the drag
coefficient is the force. The stream goes towards +x, theta counts from the rear.

The flow is symmetric: omega and psi are sine series in theta (products on 3/2 as many points), with
differences over seven points in r, on points fine at the wall that reach to where the flow has no
vorticity. There psi_n ~ r^-n exactly. At the wall the vorticity of each harmonic is what makes the
slip vanish: a multiple of the solution that is 1 at the wall is added in every step (the integral
condition of Collins & Dennis, J. Fluid Mech. 60 (1973), and Quartapelle & Valz-Gris, Int. J. Numer.
Meth. Fluids 1 (1981), in the discrete form). Time: backward differences of third order for
diffusion, extrapolation of third order for convection, from the Rayleigh layer at T = 2e-4 on, with
steps that grow with T. Harmonics are added as the spectrum fills. Needs numpy and scipy; shares
nothing with the program that is held against it.
"""

import argparse
import os
import sys
import time

import numpy as np
from scipy.fft import dct, dst
from scipy.interpolate import CubicSpline, RectBivariateSpline

LOWER, UPPER, EDGE, START = 3, 5, 3, 2e-4


def weights(x, x0, m):
    """Weights of the derivatives 0..m at x0 from values at x (Fornberg, Math. Comp. 51 (1988))."""
    c = np.zeros((m + 1, len(x)))
    c[0, 0] = c1 = 1.0
    for i in range(1, len(x)):
        c2 = 1.0
        for j in range(i):
            c3 = x[i] - x[j]
            c2 *= c3
            if j == i - 1:
                for k in range(m, -1, -1):
                    less = k * c[k - 1, i - 1] if k else 0.0
                    c[k, i] = c1 * (less - (x[i - 1] - x0) * c[k, i - 1]) / c2
            for k in range(m, -1, -1):
                less = k * c[k - 1, j] if k else 0.0
                c[k, j] = ((x[i] - x0) * c[k, j] - less) / c3
        c1 = c2
    return c


def radial_points(nu, end, fine):
    """Spacing: a part of the first layer at the wall, 5 % of the distance beyond, then a part of
    a layer of age 1/4; wider again where little vorticity is left."""
    first, most = 0.18 * np.sqrt(4 * nu * START), 0.4 * np.sqrt(nu)
    reach = 1.5 + 0.55 * end + 5 * np.sqrt(4 * nu * end)

    def spacing(y):
        return 1 / (1 / (first + 0.05 * y) + 1 / (most * (1 + (y / 3)**2)) + 1 / 0.4) / fine

    y, rows = 0.0, [0.0]
    while y < reach:
        y += spacing(y + spacing(y) / 2)
        rows.append(y)
    return 1 + np.array(rows)


class Bands:
    """One matrix for each harmonic, banded in r, as factors L U (no pivots)."""

    def __init__(self, bands):
        n = len(bands)
        self.b = bands
        for j in range(n):
            inverse = 1 / bands[j, LOWER]
            right = bands[j, LOWER + 1:]
            for i in range(1, min(LOWER, n - 1 - j) + 1):
                low = bands[j + i, LOWER - i]
                low *= inverse
                bands[j + i, LOWER - i + 1:LOWER - i + 1 + UPPER] -= low * right
            bands[j, LOWER] = inverse

    def solve(self, f):
        n, x = len(f), np.zeros((LOWER + len(f) + UPPER, f.shape[1]))
        x[LOWER:LOWER + n] = f
        for j in range(n):
            x[LOWER + j] -= np.einsum("kn,kn->n", self.b[j, :LOWER], x[j:j + LOWER])
        for j in range(n - 1, -1, -1):
            k = LOWER + j
            x[k] -= np.einsum("kn,kn->n", self.b[j, LOWER + 1:], x[k + 1:k + 1 + UPPER])
            x[k] *= self.b[j, LOWER]
        return x[LOWER:LOWER + n]


class Flow:
    """The stream may set off in any way: `speed`, of T."""

    def __init__(self, reynolds, end, fine, speed=lambda t: 1.0):
        self.nu, self.fine, self.speed = 2 / reynolds, fine, speed
        self.r = radial_points(self.nu, end, fine)
        self.differences()
        self.t = START
        self.resize(round(24 * fine))
        times = START * np.array([1, 0.98, 0.98**2])
        self.past = []  # (time, omega, convection), the newest first
        for t in times:
            omega = self.rayleigh(t)
            self.psi = self.stream(omega)
            self.past.append((t, omega, self.convection(omega)))
        self.psi = self.stream(self.past[0][1])

    def differences(self):
        """d/dr and the Laplacian but for -n^2/r^2, as bands; one-sided next to the wall."""
        n, r = len(self.r), self.r
        self.d1 = np.zeros((n, LOWER + 1 + UPPER))
        self.d2 = np.zeros_like(self.d1)
        for j in range(1, n - EDGE):
            first = max(j - 3, 0)
            w = weights(r[first:first + 7], r[j], 2)
            at = slice(LOWER + first - j, LOWER + first - j + 7)
            self.d1[j, at] = w[1]
            self.d2[j, at] = w[2] + w[1] / r[j]
        self.wall_d1 = weights(r[:7], r[0], 1)[1]
        self.dr = np.gradient(r)[:, None]

    def resize(self, n):
        """n harmonics: the solver for psi, and what depends on n only."""
        self.n = np.arange(1, n + 1)
        self.points = 3 * n // 2
        bands = self.operator(0.0, 1.0)
        for j in range(len(self.r) - EDGE, len(self.r)):
            bands[j, LOWER - 1] = -(self.r[j - 1] / self.r[j])**self.n
        self.poisson = Bands(bands)
        self.factor = None
        if hasattr(self, "past"):
            def pad(a):
                return np.pad(a, ((0, 0), (0, n - a.shape[1])))
            self.past = [(t, pad(omega), pad(rate)) for t, omega, rate in self.past]
            self.psi = pad(self.psi)

    def operator(self, a, b):
        """a - b Laplacian, with rows of the identity at the wall and at the edge."""
        bands = np.repeat(-b * self.d2[:, :, None], len(self.n), axis=2)
        inner = slice(1, len(self.r) - EDGE)
        bands[inner, LOWER] += a + b * (self.n / self.r[inner, None])**2
        bands[0, LOWER] = bands[-EDGE:, LOWER] = 1
        return bands

    def stream(self, omega, body=True):
        """psi of the disturbance: -sin theta at the wall if there is a stream."""
        f = omega.copy()
        f[0] = f[-EDGE:] = 0
        if body:
            f[0, 0] = -self.speed(self.t)
        return self.poisson.solve(f)

    def rayleigh(self, t):
        omega = np.zeros((len(self.r), len(self.n)))
        y = self.r - 1
        omega[:, 0] = -2 / np.sqrt(np.pi * self.nu * t) * np.exp(-y**2 / (4 * self.nu * t))
        omega *= self.speed(t)
        return omega

    def d_dr(self, f):
        out = np.zeros_like(f)
        n = len(f)
        for k in range(LOWER + 1 + UPPER):
            shift = k - LOWER
            j = slice(max(0, -shift), min(n, n - shift))
            if self.d1[j, k].any():
                out[j] += self.d1[j, k, None] * f[j.start + shift:j.stop + shift]
        out[0] = self.wall_d1 @ f[:7]
        return out

    def sines(self, a):
        return dst(self.padded(a), 3) / 2

    def cosines(self, a):
        full = self.padded(a)
        return dct(np.concatenate((np.zeros((len(a), 1)), full[:, :-1]), 1), 3) / 2

    def padded(self, a):
        return np.pad(a, ((0, 0), (0, self.points - a.shape[1])))

    def convection(self, omega):
        """u . grad omega; leaves the largest u/spacing in self.fastest."""
        psi = self.psi.copy()
        psi[:, 0] += self.speed(self.t) * self.r
        r = self.r[:, None]
        u_r = self.cosines(self.n * psi) / r
        u_theta = -self.sines(self.d_dr(psi)) / r
        self.fastest = max((np.abs(u_theta) * len(self.n) + 1.6 * np.abs(u_r) / self.dr).max(), 1.0)
        rate = u_r * self.sines(self.d_dr(omega)) + u_theta * self.cosines(self.n * omega)
        rate[0] = 0
        return dst(rate, 2)[:, :len(self.n)] / self.points

    def step(self, t):
        times = np.array([t] + [past[0] for past in self.past])
        back = weights(times, t, 1)[1]
        ahead = weights(times[1:], t, 0)[0]
        if self.factor is None or abs(back[0] / self.rate - 1) > 1e-9:
            self.rate = back[0]
            self.factor = Bands(self.operator(back[0], self.nu))
            unit = np.zeros((len(self.r), len(self.n)))
            unit[0] = 1
            self.layer = self.factor.solve(unit)
            self.layer_psi = self.stream(self.layer, body=False)
        f = sum(-b * omega - e * rate for b, e, (_, omega, rate) in zip(back[1:], ahead, self.past))
        f[0] = f[-EDGE:] = 0
        self.t = t
        omega = self.factor.solve(f)
        psi = self.stream(omega)
        slip = self.wall_d1 @ psi[:7]
        slip[0] += self.speed(t)
        more = -slip / (self.wall_d1 @ self.layer_psi[:7])
        omega += more * self.layer
        self.psi = psi + more * self.layer_psi
        self.past = [(t, omega, self.convection(omega))] + self.past[:2]

    def advance(self, t):
        """To t in equal steps; more harmonics if the last tenth of the spectrum is not small."""
        omega = np.abs(self.past[0][1]).max(axis=0)
        tail = omega[-len(omega) // 10:].max() / omega.max()
        if tail > 3e-5 / self.fine**4:
            self.resize(round(len(omega) * 1.34 / 8) * 8)
            self.convection(self.past[0][1])
        longest = min(0.04 * self.t, 0.4 / self.fastest, 0.006) / self.fine
        steps = int(np.ceil((t - self.t) / longest))
        start = self.t
        for k in range(1, steps + 1):
            self.step(start + (t - start) * k / steps)

    def drag(self):
        omega = self.past[0][1]
        return (np.pi * self.nu * (self.wall_d1 @ omega[:7, 0]), -np.pi * self.nu * omega[0, 0])

    def wall_vorticity(self, theta):
        return np.sin(np.outer(theta, self.n)) @ self.past[0][1][0]

    def separation(self):
        """Degrees from the rear; 0 while attached."""
        theta = np.radians(np.linspace(150, 0.02, 15000))
        w = self.wall_vorticity(theta)
        turns = np.flatnonzero((w[:-1] < 0) & (w[1:] >= 0))
        if not len(turns):
            return 0.0
        k = turns[0]
        return np.degrees(theta[k] + (theta[k + 1] - theta[k]) * w[k] / (w[k] - w[k + 1]))

    def axis(self):
        """Length of the closed wake in diameters and the lowest u on the rear axis."""
        u = (self.psi * self.n).sum(axis=1) / self.r + 1
        u[0] = 0
        spline = CubicSpline(self.r, u)
        points = [1.0, *spline.derivative().roots(extrapolate=False)]
        roots = [x for x in spline.roots(extrapolate=False)
                 if x > 1 + 1e-9 and spline(x, 1) > 0]
        return (roots[0] - 1) / 2 if roots else 0.0, round(min(0.0, *spline(points)), 4) + 0.0

    def core(self):
        """The lowest psi of the upper half, from the centre in diameters; 0, 0 if none is < 0."""
        psi = self.psi.copy()
        psi[:, 0] += self.r
        theta = np.pi * (np.arange(400) + 0.5) / 400
        values = psi @ np.sin(np.outer(self.n, theta))
        i, j = np.unravel_index(values.argmin(), values.shape)
        if values[i, j] > -1e-7 or not 3 <= j < 397 or i < 3:
            return 0.0, 0.0
        a, b = slice(i - 3, i + 4), slice(j - 3, j + 4)
        spline = RectBivariateSpline(self.r[a], theta[b], values[a, b], kx=4, ky=4)
        rr = np.linspace(self.r[i - 1], self.r[i + 1], 201)
        tt = np.linspace(theta[j - 1], theta[j + 1], 201)
        i, j = np.unravel_index(spline(rr, tt).argmin(), (201, 201))
        return rr[i] * np.cos(tt[j]) / 2, rr[i] * np.sin(tt[j]) / 2


def stops(end):
    """Times: of rows, of what is passed on the way to the first."""
    rows = np.concatenate((np.arange(2, 6) / 100, [0.06, 0.08, 0.1, 0.15], np.arange(4, 20) / 20,
                           np.arange(10, round(10 * end) + 1) / 10))
    return START * 1.08**np.arange(1, 60), rows


def header(reynolds, flow):
    return f"""\
# Impulsively started circular cylinder, Re = U D / nu = {reynolds:g}, symmetric flow.
# Solution made for this project (impulsive_cylinder.py).
# T = U t / R (t in D/U is T/2). C_D = F_x / (0.5 rho U^2 D) = C_Dp (pressure) + C_Df (friction).
# sep_deg: main separation angle from the rear stagnation point.
# L_over_D: closed-wake length behind the cylinder. umin: lowest u on the rear axis.
# core_x, core_y: centre of the primary recirculation (upper half) from the cylinder centre.
# Method: Fourier sine series in theta, finite differences in stretched r, exact no-slip
# constraint per mode, BDF3; {len(flow.r)} points to r = {flow.r[-1]:.1f} R.
T,tstar,C_D,C_Dp,C_Df,sep_deg,L_over_D,core_x_over_D,core_y_over_D,umin_over_U
"""


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("reynolds", type=float)
    parser.add_argument("end", type=float)
    parser.add_argument("out")
    parser.add_argument("--fine", type=float, default=1.0)
    parser.add_argument("--wall", default="0.2,0.5,1,2,3,4,5,6,7")
    a = parser.parse_args()
    flow = Flow(a.reynolds, a.end, a.fine)
    wall_times = np.array([float(t) for t in a.wall.split(",")])
    before, rows = stops(a.end)
    began = time.time()
    drag = open(os.path.join(a.out, f"cylinder_drag_re{a.reynolds:g}.csv"), "w")
    wall = open(os.path.join(a.out, f"cylinder_wall_vorticity_re{a.reynolds:g}.csv"), "w")
    drag.write(header(a.reynolds, flow))
    wall.write(f"""\
# Wall vorticity omega R / U on the impulsively started cylinder, Re = {a.reynolds:g};
# same solution as cylinder_drag_re{a.reynolds:g}.csv.
# theta_deg from the rear stagnation point (0) to the front (180), upper half, stream in +x.
T,theta_deg,omega_R_over_U
""")
    for t in before[before < rows[0]]:
        flow.advance(t)
    degrees = np.arange(181)
    for t in rows:
        flow.advance(t)
        (cp, cf), (length, umin), (x, y) = flow.drag(), flow.axis(), flow.core()
        drag.write(f"{t:.2f},{t / 2:.3f},{cp + cf:.5f},{cp:.5f},{cf:.5f},{flow.separation():.3f},"
                   f"{length:.5f},{x:.4f},{y:.4f},{umin:.4f}\n")
        drag.flush()
        if np.abs(wall_times - t).min() < 1e-9:
            values = flow.wall_vorticity(np.radians(degrees))
            wall.writelines(f"{t:.4f},{d},{w:.5f}\n" for d, w in zip(degrees, values))
            wall.flush()
        omega = np.abs(flow.past[0][1])
        print(f"T {t:.2f} C_D {cp + cf:.5f} harmonics {len(flow.n)} "
              f"dt {flow.past[0][0] - flow.past[1][0]:.2e} at edge {omega[-9:].max():.1e} "
              f"seconds {time.time() - began:.0f}", file=sys.stderr, flush=True)


if __name__ == "__main__":
    main()
