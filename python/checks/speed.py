"""What Python costs, and a cost image beside scikit-image.

    cargo xtask python speed

calls this script with the path of the same measurements in Rust. They run in turns, three times each,
and the least of the medians counts. `cargo xtask peers` has Tautline from Python beside JAX and
geomstats.
"""

from __future__ import annotations

import os
import statistics
import subprocess
import sys
import time

import numpy as np
import tautline_geodesics as tautline
from skimage.graph import route_through_array

CHORDS = (16, 64, 256)
HILL = tautline.Metric("cost(1 + 4*exp(-2*(x1^2 + x2^2)))", 2)
PROBLEMS = 10_000
RUNS = 501


def solves() -> dict[str, float]:
    """The median seconds of a solve, for each number of chords."""
    found = {}
    for n in CHORDS:
        seconds = []
        for _ in range(RUNS):
            start = time.perf_counter()
            tautline.solve(HILL, [-1.5, 0.05], [1.5, -0.1], n=n)
            seconds.append(time.perf_counter() - start)
        found[f"solve {n}"] = statistics.median(seconds)
    return found


def batch() -> tuple[float, float]:
    """The seconds of a batch, and the sum of its discrete energies."""
    k = np.arange(PROBLEMS)
    starts = np.stack([-1.5 + 0.2 * np.cos(k), 0.2 * np.sin(k)], axis=1)
    goals = np.stack([1.5 - 0.2 * np.sin(k), 0.2 * np.cos(k)], axis=1)
    start = time.perf_counter()
    curves = tautline.solve_batch(HILL, starts, goals, n=64)
    total = 0.0
    for curve in curves:
        total += curve.discrete_energy
    return time.perf_counter() - start, total


def in_rust(program: str) -> tuple[dict[str, float], float]:
    """The same numbers of the program in Rust, and its sum of energies."""
    printed = subprocess.run(
        [program, *map(str, CHORDS)], check=True, capture_output=True, text=True
    ).stdout.splitlines()
    words = [line.split() for line in printed]
    return {" ".join(line[:2]): float(line[2]) for line in words}, float(words[-1][3])


def beside_rust(program: str) -> None:
    """Prints what calls from Python take, beside those of Rust."""
    python: dict[str, list[float]] = {}
    rust: dict[str, list[float]] = {}
    name = f"batch {PROBLEMS}"
    for _ in range(3):
        found, expected = in_rust(program)
        for key, seconds in found.items():
            rust.setdefault(key, []).append(seconds)
        for key, seconds in solves().items():
            python.setdefault(key, []).append(seconds)
        seconds, total = batch()
        python.setdefault(name, []).append(seconds)
        # Sines and cosines of NumPy and of Rust may differ in the last place.
        if abs(total - expected) > 1e-12 * expected:
            raise SystemExit(f"the batch has the energies {total!r}, in Rust {expected!r}")
    print(f"{'':14}{'Rust':>12}{'Python':>12}{'more':>12}{'ratio':>8}")
    for key in rust:
        a, b = min(rust[key]), min(python[key])
        unit, scale = ("us", 1e6) if key.startswith("solve") else ("ms", 1e3)
        cells = (f"{scale * x:.1f} {unit}" for x in (a, b, b - a))
        print(f"{key:14}" + "".join(f"{cell:>12}" for cell in cells) + f"{b / a:8.3f}")


def smooth(size: int, seed: int) -> np.ndarray:
    """A landscape with hills of about 60 pixels: noise with the high frequencies removed."""
    noise = np.random.default_rng(seed).normal(size=(size, size))
    frequencies = np.fft.fftfreq(size)
    spectrum = np.exp(-((frequencies[:, None] ** 2 + frequencies**2) * 30.0**2))
    hills = np.fft.ifft2(np.fft.fft2(noise) * spectrum).real
    return np.exp(hills / hills.std() / 4)


def rough(size: int, seed: int) -> np.ndarray:
    """A cost between 1 and 4 that is independent from pixel to pixel."""
    return np.random.default_rng(seed).uniform(1.0, 4.0, size=(size, size))


def images() -> None:
    """Prints paths through two images of 512 x 512 pixels, by scikit-image and by Tautline."""
    size, first, last = 512, (20, 30), (490, 480)
    for name, cost in (("hills", smooth(size, 1)), ("noise", rough(size, 1))):
        metric = tautline.Metric.image(cost)
        start = time.perf_counter()
        constants = metric.constants()
        seconds = time.perf_counter() - start
        shown = ", ".join(f"{key} {it.upper if key != 'c1' else it.lower:.4g}" for key, it in constants.items())
        print(f"{name}: constants of all of space in {seconds:.1f} s: {shown}")
        start = time.perf_counter()
        route, weight = route_through_array(cost, first, last, fully_connected=True, geometric=True)
        print(f"  scikit-image {weight:.2f}, {len(route)} pixels, {time.perf_counter() - start:.2f} s")
        # The same polygon under the smooth cost, so that both lengths are of one metric.
        polygon = np.array(route, float)
        middles, chords = (polygon[1:] + polygon[:-1]) / 2, np.diff(polygon, axis=0)
        speeds = np.sqrt(np.einsum("ni,nij,nj->n", chords, metric(middles), chords))
        print(f"  the polygon of its pixels, in the smooth cost, {speeds.sum():.2f}")
        start = time.perf_counter()
        curve = tautline.solve(metric, first, last, n=4096)
        seconds = time.perf_counter() - start
        length = float(curve.length)
        print(
            f"  Tautline {length:.2f}, {100 * (1 - length / weight):.1f} % shorter than its weight, "
            f"{100 * (1 - length / speeds.sum()):.1f} % than the polygon, {curve.n} chords, "
            f"{seconds:.2f} s, {curve.stop}, {'' if curve.resolved else 'not '}resolved"
        )
        start = time.perf_counter()
        try:
            found = curve.certificate(gap=1e-2, cubes=1_000_000)
            seconds = time.perf_counter() - start
            print(
                f"  certificate {found.lower:.2f} to {found.upper:.2f}, gap {100 * found.gap:.1f} %, "
                f"{seconds:.1f} s, {found.ended}"
            )
        except tautline.NotCertified as reason:
            print(f"  no certificate: {reason}")


def main() -> None:
    """Measures everything."""
    print(f"{os.cpu_count()} processors, numpy {np.__version__}, tautline {tautline.__version__}")
    if len(sys.argv) > 1:
        beside_rust(sys.argv[1])
    images()


if __name__ == "__main__":
    main()
