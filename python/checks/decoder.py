"""The time of a shortest curve in the latent space of a decoder x -> W tanh(A x), from Python.

    python checks/decoder.py [LATENT HIDDEN OUTPUTS CHORDS]

The metric is the pullback J^T J, by its values and its derivatives along vectors. The search starts from
the straight line alone: the automatic starts bend it to both sides of every axis, and take 2 D times as
long. Prints the time, the residual, and the length beside that of the straight line.
"""

import sys
import time

import numpy as np

import tautline_geodesics as tautline


def decoder(latent, hidden, outputs, seed=1):
    """The weights of a decoder with random layers, scaled so that its units are about half saturated."""
    random = np.random.default_rng(seed)
    a = random.normal(size=(hidden, latent)) / latent**0.5
    w = random.normal(size=(outputs, hidden)) / hidden**0.5
    return a, w


def pullback(a, w):
    """The metric J^T J with J = W S A, where S is the diagonal matrix of 1 - tanh(A x)^2."""
    inner = w.T @ w

    def slopes(x):
        t = np.tanh(x @ a.T)
        return t, 1 - t**2

    def h(x):
        s = slopes(x)[1][:, :, None] * a
        return np.swapaxes(s, 1, 2) @ (inner @ s)

    def first(x, v):
        # H v = Aᵀ S M S A v with M = Wᵀ W, and S changes by -2 t s along the rows of A.
        t, s = slopes(x)
        u, bent = v @ a.T, -2 * t * s
        moved = (bent * ((s * u) @ inner))[:, :, None] * a
        return a.T @ (moved + s[:, :, None] * (inner @ ((bent * u)[:, :, None] * a)))

    def second(x, v):
        # vᵀ H v = pᵀ M p with p = s u; its second derivatives are 2 p'ᵀ M p' + 2 (M p)·p''.
        t, s = slopes(x)
        u = v @ a.T
        once, twice = (-2 * t * s * u)[:, :, None] * a, (-2 + 6 * t**2) * s * u
        back = (s * u) @ inner
        steps = np.swapaxes(once, 1, 2) @ (inner @ once)
        return 2 * (steps + np.swapaxes((twice * back)[:, :, None] * a, 1, 2) @ a)

    metric = tautline.Metric.black_box(h, a.shape[1], first_along=first, second_along=second)
    return metric, first, second, h


def main(latent=64, hidden=256, outputs=784, chords=100):
    a, w = decoder(latent, hidden, outputs)
    metric, *_ = pullback(a, w)
    random = np.random.default_rng(2)
    start, goal = random.normal(size=(2, latent))
    began = time.perf_counter()
    line = np.stack([start, goal])
    curve = tautline.solve(metric, start, goal, n=chords, starts=line, only_these_starts=True)
    seconds = time.perf_counter() - began
    fine = start + np.linspace(0, 1, 1001)[:, None] * (goal - start)
    images = np.tanh(fine @ a.T) @ w.T
    straight = np.linalg.norm(np.diff(images, axis=0), axis=1).sum()
    print(f"{latent} latent dimensions, {hidden} hidden units, {outputs} outputs, {chords} chords:")
    print(f"  {seconds:.2f} s, converged: {curve.converged}, residual {curve.residual:.1e}")
    print(f"  length {float(curve.length):.6f}, of the straight line {straight:.6f}")


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
