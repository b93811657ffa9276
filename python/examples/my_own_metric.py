"""How do I use a metric of my own, and how wrong can the result be?"""

import numpy as np

import tautline_geodesics as tautline

# A metric needs only its formula. The function is called once, with symbols.
sheet = tautline.Metric(lambda x: np.diag([1 + 0.5 * np.sin(x[0]) ** 2, 2]), dimension=2)
curve = tautline.solve(sheet, [0.2, 0], [2.5, 1], n=512)
energy = curve.energy
print(f"E = {energy.value:.9f} is an upper bound on d², up to {energy.error:.0e}".replace("e-0", "e-"))

# Bounds also need constants: c1 ≤ H ≤ c2, and L_H and M_H of (½ sin²)′ = ½ sin 2x₁ and
# (½ sin²)″ = cos 2x₁. Without `claimed` they would be proved from the formula.
constants = (1, 2, 0.5, 1)
excess = tautline.theorem_1_1_excess(constants, curve.length.value, 2, curve.n)
print(f"E − d² is at most {excess:.3e} for a global minimiser (Theorem 1.1)".replace("e+0", "e"))

bounds = curve.bounds(claimed=constants)
print(f"{bounds.lower**2:.9f} ≤ d² ≤ {bounds.upper**2:.9f} (Proposition S.6)")
if bounds.global_minimum == "assumed":
    print(f"if no other sequence of {curve.n} chords has less discrete energy")
