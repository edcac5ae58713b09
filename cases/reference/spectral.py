"""Reference solutions of vortices in free space: how the *_moments.csv beside this file were made.

    python3 spectral.py SCENE N OUT.csv      SCENE: gaussian_ellipse, corotating_pair or tripole

Vorticity on N x N points of a square, derivatives by Fourier series (the vorticity dies out before
the edges), velocities by convolution with the free-space Green's function, cut off beyond the
square's diagonal so that its transform is smooth (Vico, Greengard & Ferrando, J. Comput. Phys. 323
(2016)): spectral accuracy in space. Classical Runge-Kutta with the viscous term integrated exactly.
Needs numpy and scipy; shares nothing with the program that is held against it.
"""

import sys

import numpy as np
from scipy.fft import fft2, ifft2, irfft2, rfft2
from scipy.special import j0, j1

SCENES = {  # nu, side of the square, end, time between rows
    "gaussian_ellipse": (5e-4, 3.0, 5.0, 0.05),
    "corotating_pair": (1e-3, 3.6, 20.0, 0.2),
    "tripole": (2e-4, 2.8, 10.0, 0.1),
}


def start(scene, x, y):
    def gaussian(x, y, gamma, a, b):
        return gamma / (np.pi * a * b) * np.exp(-(x / a)**2 - (y / b)**2)

    if scene == "gaussian_ellipse":
        return gaussian(x, y, 1.0, 0.28, 0.14)
    if scene == "corotating_pair":
        return gaussian(x - 0.5, y, 1.0, 0.15, 0.15) + gaussian(x + 0.5, y, 1.0, 0.15, 0.15)
    return gaussian(x, y, 1.0, 0.2, 0.2) * (1 + (x**2 - y**2) / 0.2**2)


class Square:
    def __init__(self, side, n):
        self.n, self.h = n, side / n
        self.x = (np.arange(n) - n / 2) * self.h
        self.X, self.Y = np.meshgrid(self.x, self.x)
        self.kx = 2 * np.pi * np.fft.rfftfreq(n, self.h)
        self.ky = 2 * np.pi * np.fft.fftfreq(n, self.h)[:, None]
        self.k2 = self.kx**2 + self.ky**2
        self.dx, self.dy = 1j * self.kx, 1j * self.ky
        self.dx[-1] = 0
        self.dy[n // 2] = 0
        self.green = self.greens_function(1.5 * side)

    def greens_function(self, reach):
        """Transform on 2n x 2n points of -ln(r)/(2 pi), cut off at r = reach."""
        k = 2 * np.pi * np.fft.fftfreq(4 * self.n, self.h)
        k = np.hypot(k, k[:, None])
        k[0, 0] = 1
        g = (1 - j0(reach * k)) / k**2 - reach * np.log(reach) * j1(reach * k) / k
        g[0, 0] = reach**2 / 4 - reach**2 * np.log(reach) / 2
        near = np.roll(ifft2(g).real, (self.n, self.n), (0, 1))[:2 * self.n, :2 * self.n]
        return fft2(np.roll(near, (-self.n, -self.n), (0, 1)))[:, :self.n + 1]

    def stream(self, omega):
        """psi with u = d psi/dy, v = -d psi/dx."""
        n = self.n
        return irfft2(self.green * rfft2(omega, (2 * n, 2 * n)), (2 * n, 2 * n))

    def velocity(self, omega):
        n = self.n
        hat = self.green * rfft2(omega, (2 * n, 2 * n))
        kx = 2j * np.pi * np.fft.rfftfreq(2 * n, self.h)
        ky = 2j * np.pi * np.fft.fftfreq(2 * n, self.h)[:, None]
        return (irfft2(ky * hat, (2 * n, 2 * n))[:n, :n],
                irfft2(-kx * hat, (2 * n, 2 * n))[:n, :n])

    def rate(self, hat):
        omega = irfft2(hat, (self.n, self.n))
        u, v = self.velocity(omega)
        return -rfft2(u * irfft2(self.dx * hat, omega.shape) + v * irfft2(self.dy * hat, omega.shape))

    def step(self, hat, nu, dt):
        half = np.exp(-nu * self.k2 * dt / 2)
        k1 = self.rate(hat)
        k2 = self.rate(half * (hat + dt / 2 * k1))
        k3 = self.rate(half * hat + dt / 2 * k2)
        k4 = self.rate(half**2 * hat + dt * half * k3)
        return half**2 * (hat + dt / 6 * k1) + dt / 3 * half * (k2 + k3) + dt / 6 * k4

    def moments(self, omega):
        """Quadrupole about the centre, separation (twice the mean distance from it along the major
        axis), kinetic energy but for a constant (int omega psi dA/2), enstrophy, peak."""
        w, X, Y = omega * self.h**2, self.X, self.Y
        xx, xy = (w * (X**2 - Y**2)).sum(), (w * 2 * X * Y).sum()
        tilt = 0.5 * np.arctan2(xy, xx)
        apart = 2 * (w * np.abs(np.cos(tilt) * X + np.sin(tilt) * Y)).sum() / w.sum()
        energy = (w * self.stream(omega)[:self.n, :self.n]).sum() / 2
        return xx, xy, apart, energy, (w * omega).sum(), omega.max()


def main(scene, n, out):
    nu, side, end, every = SCENES[scene]
    square = Square(side, n)
    omega = start(scene, square.X, square.Y)
    u, v = square.velocity(omega)
    steps = int(np.ceil(every / (0.7 * square.h / np.hypot(u, v).max())))  # between rows
    hat = rfft2(omega)
    with open(out, "w") as file:
        print(f"# {scene}: spectral.py, {n} x {n} points, side {side}, nu = {nu}, "
              f"dt = {every / steps:.3g}", file=file)
        print("t,quadrupole_xx,quadrupole_xy,separation,energy,enstrophy,peak", file=file)
        for row in range(round(end / every) + 1):
            omega = irfft2(hat, (n, n))
            values = ",".join(f"{value:.9g}" for value in square.moments(omega))
            print(f"{row * every:.6g},{values}", file=file, flush=True)
            for _ in range(steps):
                hat = square.step(hat, nu, every / steps)
    np.save(out.replace(".csv", ".npy"), omega)


main(sys.argv[1], int(sys.argv[2]), sys.argv[3])
