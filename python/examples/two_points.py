"""How far is it from one point to another, and which way is the shortest?"""

import tautline_geodesics as tautline

# A plane with a bump of high cost around the origin, between the two points.
bump = tautline.Metric.cost("1 + 4*exp(-2*(x1^2 + x2^2))", 2)
curve = tautline.solve(bump, [-1.5, 0.05], [1.5, -0.1], n=1000)

print(f"length of the curve    {curve.length.value:.9f}")
middle = curve.at(0.5)
print(f"half way at            ({middle[0]:.4f}, {middle[1]:.4f})")
print(f"a local minimum?       {str(curve.converged).lower()}")
energies = ", ".join(f"{energy:.4f}" for energy in curve.local_minima)
print(f"energies of the local minima on the coarsest grid: [{energies}]")
