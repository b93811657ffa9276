"""How different are two normal distributions? Their metric has constants on balls only."""

import math

import tautline_geodesics as tautline

# The coordinates are the mean and the logarithm of the standard deviation.
fisher = tautline.Metric.diag(["exp(-2*x2)", "2"], 2)
before, after = [0, 0], [0.1, 0.05]
curve = tautline.solve(fisher, before, after, n=1000)

# No constants hold on the whole plane. But no curve shorter than this one leaves a certain ball, on
# which constants are proved from the formula.
bounds = curve.bounds()
assert bounds.within is not None and bounds.lower <= float(curve.length) <= bounds.upper

deviations = [math.exp(t) for _, t in (before, after)]
apart = (after[0] - before[0]) ** 2 / 2 + (deviations[1] - deviations[0]) ** 2
exact = math.sqrt(2) * math.acosh(1 + apart / (2 * deviations[0] * deviations[1]))
print(f"d² = {exact**2:.9f}")
