"""How far is each of many points from each of the others?"""

import numpy as np

import tautline_geodesics as tautline

# A dozen points on a spiral that winds out of a bump of high cost.
bump = tautline.Metric.cost("1 + 4*exp(-2*(x1^2 + x2^2))", 2)
k = np.arange(12)
points = 0.15 * k[:, None] * np.stack([np.cos(k), np.sin(k)], axis=1)

for row in tautline.distance_matrix(bump, points, n=128):
    print(" ".join(f"{distance:5.3f}" for distance in row))
