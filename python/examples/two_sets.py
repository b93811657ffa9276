"""Where does the shortest way between two bodies begin and end?"""

import tautline_geodesics as tautline

# From a ball to the nearest of three harbours. The one that is nearest in a straight line lies on a
# ridge of the metric, so the search tries all three.
ball = tautline.ball([0, 0], 0.5)
harbours = tautline.points([[3, 0], [0, 3.5], [-3, 1]])
curve = tautline.solve(tautline.Metric.cost("2 - cos(x1)", 2), ball, harbours, n=256)

first, last = curve.points[0], curve.points[-1]
print(f"leaves the ball at ({first[0]:.4f}, {first[1]:.4f})")
print(f"arrives at         ({last[0]:.4f}, {last[1]:.4f})")
print(f"length             {curve.length.value:.6f}")
