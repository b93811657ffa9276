"""Tests of one level: level sets, the vertex test, pieces of sets, and batches."""

import itertools
import math
import random
import unittest
from fractions import Fraction

import numpy as np

import campaign
import curve
import formula
import region
import sweep
import table
from certificate import Certificate
from check import check, following
from formula import Formula
from intervals import Interval, of
from level import Level
from level_sets import LevelSets
from metric import curvature, dual_square, eliminated, gram, positive
from refused import Refused
from sweep import Sweep


class Rescaling(unittest.TestCase):
    def test_slopes_respect_every_simplex_and_bounds_are_bounds(self):
        chance = random.Random(1)
        for _ in range(3):
            count = 60
            lo = np.array([chance.uniform(-0.5, 2) for _ in range(count)])
            hi = lo + np.array([chance.choice([0.0, 1e-5, 0.01, 0.3, 3.0]) for _ in range(count)])
            q = np.array([chance.choice([0.0, 0.5, 1.0, 3.0, 1e4, math.inf]) for _ in range(count)])
            start, end = chance.uniform(-0.1, 0.1), chance.uniform(0.9, 1.5)
            # Ranges that end at levels do not meet the bins beyond.
            levels = start + np.float64(1.1) * (end - start) / 4096 * np.arange(4097)
            lo[:5], hi[:5] = levels[100:600:100], levels[103:1103:200]
            f = LevelSets(lo, hi, q, start, end)
            self.assertEqual(f.levels[0], start)
            self.assertTrue((f.slopes >= 0).all() and (f.slopes <= 1).all())
            for b, slope in enumerate(f.slopes):
                meets = (lo < f.levels[b + 1]) & (hi > f.levels[b])
                meets |= (lo == hi) & (f.levels[b] < lo) & (lo < f.levels[b + 1])
                worst = q[meets].max(initial=0)
                if worst == math.inf:
                    self.assertEqual(slope, 0)
                else:
                    self.assertLessEqual(Fraction(slope) ** 2 * Fraction(worst), 1)
                    self.assertGreaterEqual(
                        slope, min(1, 1 / math.sqrt(worst) if worst else 1) * (1 - 1e-15)
                    )
            heights = [Fraction(0)]
            for b, slope in enumerate(f.slopes):
                heights.append(
                    heights[-1]
                    + Fraction(slope) * (Fraction(f.levels[b + 1]) - Fraction(f.levels[b]))
                )
            t = [chance.uniform(start - 0.1, end + 0.3) for _ in range(300)] + [
                *f.levels[::97],
                start,
                end,
            ]
            for x, below, excess in zip(t, f.below(t), f.excess(t)):
                b = int(np.searchsorted(f.levels, x, "right")) - 1
                if b < 0:
                    exact = Fraction(0)
                elif b >= len(f.slopes):
                    exact = heights[-1]
                else:
                    exact = heights[b] + Fraction(f.slopes[b]) * (
                        Fraction(x) - Fraction(f.levels[b])
                    )
                self.assertLessEqual(Fraction(float(below)), exact)
                self.assertLessEqual(exact - Fraction(float(below)), Fraction(1e-15))
                self.assertGreaterEqual(
                    Fraction(float(excess)), Fraction(x) - Fraction(float(below))
                )
            self.assertEqual(f.below([-math.inf, math.inf]).tolist(), [0, f.below(end + 9.0)])
            self.assertEqual(f.excess([math.inf]).tolist(), [math.inf])

    def test_the_excess_is_rounded_up(self):
        chance = random.Random(8)
        f = LevelSets(np.array([-1.0]), np.array([3.0]), np.array([7.0]), 0.0, 1.3)
        t = [chance.uniform(0, 1.4) for _ in range(300)]
        for x, below, excess in zip(t, f.below(t), f.excess(t)):
            self.assertGreaterEqual(Fraction(float(excess)), Fraction(x) - Fraction(float(below)))

    def test_levels_in_the_wrong_order_prove_nothing(self):
        for start, end in (
            (1.0, 1.0),
            (1.0, 0.5),
            (-math.inf, 1.0),
            (0.0, math.inf),
            (math.nan, 1.0),
            (0.0, math.nan),
        ):
            f = LevelSets(np.zeros(1), np.ones(1), np.ones(1), np.float64(start), np.float64(end))
            self.assertEqual(f.below([0.0, 0.7, 9.0]).tolist(), [0, 0, 0])


class VertexTest(unittest.TestCase):
    @staticmethod
    def quadratic(chance, n):
        """H with entries that are quadratic polynomials, and its second derivatives."""
        bends = np.zeros((n, n, n, n))
        lines, rows = [], [[""] * n for _ in range(n)]
        for i, j in itertools.combinations_with_replacement(range(n), 2):
            b = np.array([[chance.uniform(-2, 2) for _ in range(n)] for _ in range(n)])
            bends[i, j] = bends[j, i] = b = b + b.T
            lines.append(f"s{len(lines) + 1} = number(1.0);")
            total = f"s{len(lines)}"
            for k, l in itertools.product(range(n), repeat=2):
                lines.append(f"s{len(lines) + 1} = x{k + 1} * x{l + 1};")
                lines.append(f"s{len(lines) + 1} = s{len(lines)} * {float(b[k, l]) / 2!r};")
                lines.append(f"s{len(lines) + 1} = {total} + s{len(lines)};")
                total = f"s{len(lines)}"
            rows[i][j] = rows[j][i] = total
        return Formula([*lines, campaign.matrix(rows)], n), bends

    def test_curvature_is_the_lesser_of_two_sums(self):
        chance, lesser = random.Random(2), set()
        for _ in range(30):
            n = chance.randint(1, 4)
            f, bends = self.quadratic(chance, n)
            # Rows (i, k), columns (j, l).
            m = bends.transpose(0, 2, 1, 3).reshape(n * n, n * n)
            rows = np.diag(m) + np.abs(m).sum(axis=1) - np.abs(np.diag(m))
            along = np.maximum(0, rows.reshape(n, n).max(axis=0)).sum()
            expected = min(along, n * np.linalg.norm(m))
            lesser.add(bool(along < n * np.linalg.norm(m)))
            box = [Interval(np.zeros(3), np.array([0.0, 1e-3, 0.5]))] * n
            for found in curvature(f, box):
                self.assertTrue(expected * (1 - 1e-13) <= found <= expected * (1 + 1e-11) + 1e-13)
        self.assertEqual(lesser, {False, True})

    def test_curvature_bounds_the_form(self):
        chance, generator = random.Random(3), np.random.default_rng(3)
        for _ in range(20):
            n = chance.randint(1, 3)
            f, bends = self.quadratic(chance, n)
            found = curvature(f, [Interval(np.zeros(1), np.ones(1))] * n)[0]
            u, e = generator.normal(size=(200, n)), generator.normal(size=(200, n))
            u /= np.linalg.norm(u, axis=1)[:, None]
            e /= np.abs(e).max(axis=1)[:, None]
            form = np.einsum("ijkl,ai,aj,ak,al->a", bends, u, u, e, e)
            self.assertLessEqual(form.max(), found + 1e-12)

    def test_there_is_no_curvature_where_a_step_is_undefined(self):
        # The derivatives of ln are defined at negative numbers, too.
        f = Formula(["s1 = ln(x1);", "[s1]"], 1)
        found = curvature(f, [Interval(np.array([-2.0, 0.0, 1.0]), np.array([-1.0, 1.0, 2.0]))])
        self.assertEqual(np.isnan(found).tolist(), [True, True, False])

    def test_squares_in_the_dual_norm_are_those_of_the_inverse(self):
        generator = np.random.default_rng(4)
        for _ in range(100):
            n = int(generator.integers(1, 5))
            a = generator.normal(size=(n, n))
            h, p = a @ a.T + 0.1 * np.eye(n), generator.normal(size=n)
            entries = {(i, j): of(h[i, j]) for i in range(n) for j in range(i, n)}
            exact = p @ np.linalg.inv(h - 0.05 * np.eye(n)) @ p
            found = float(dual_square(eliminated(entries, n, of(0.05)), [of(x) for x in p]))
            # The condition of these matrices is at most about 1000.
            self.assertTrue(exact * (1 - 1e-10) <= found <= exact * (1 + 1e-10), (exact, found))
            least = np.linalg.eigvalsh(h)[0]
            self.assertTrue(positive(entries, n, of(least - 1e-6)))
            self.assertFalse(positive(entries, n, of(least + 1e-6)))


class Pieces(unittest.TestCase):
    def test_of_several_pieces_in_a_simplex_all_count(self):
        chance = random.Random(5)
        for _ in range(4):
            n = chance.randint(1, 3)
            f = Formula(campaign.constant(chance, n).lines, n)
            cubes = np.array(list(itertools.product(range(-1, 1), repeat=n)))
            nodes = campaign.nodes_of(cubes, 0)
            level = Level(
                0, cubes, np.array([[chance.uniform(-1, 1) for _ in range(2)] for _ in nodes])
            )
            pieces = [
                ("point", np.array([chance.uniform(-1, 1) for _ in range(n)])) for _ in range(4)
            ]
            pieces.append(
                ("ball", np.append(np.array([chance.uniform(-1, 1) for _ in range(n)]), 0.2))
            )
            both = Sweep(f, [pieces, pieces[::-1]], level).meetings
            each = [Sweep(f, [[piece], [piece]], level).meetings for piece in pieces]
            for i in (0, 1):
                met, own, other = both[i]
                self.assertTrue((met == np.any([m[i][0] for m in each], axis=0)).all())
                most = np.max([np.where(m[i][0], m[i][1], -np.inf) for m in each], axis=0)
                least = np.min([np.where(m[i][0], m[i][2], np.inf) for m in each], axis=0)
                np.testing.assert_array_equal(own[met], most[met])
                np.testing.assert_array_equal(other[met], least[met])

    def test_the_pieces_that_are_farthest_apart_do_not_hide_the_nearest(self):
        # On the line: from −1 or 0.4 to 1 or 3; the distance is 0.6. Any one pair alone has more.
        f = Formula(["s1 = number(1.0);", "[s1]"], 1)
        sets = [[("point", np.array([x])) for x in xs] for xs in ((-1.0, 0.4), (3.0, 1.0))]
        for order in itertools.product((1, -1), repeat=2):
            ends = [pieces[::step] for pieces, step in zip(sets, order)]
            cubes = np.arange(-24, 56)[:, None]
            x = campaign.nodes_of(cubes, -3)[:, 0]
            values = [np.min([np.abs(x - s[0]) for _, s in pieces], axis=0) for pieces in ends]
            level = Level(-3, cubes, np.array(values).T)
            lower, _ = Sweep(f, ends, level).shorter_than(0.65)
            self.assertTrue(0.55 < lower <= 0.6, lower)


class Batches(unittest.TestCase):
    """What is looked at together is a matter of memory only."""

    sizes = {
        sweep: "MOST_CUBES",
        region: "BATCH",
        curve: "BATCH",
        formula: "MOST_BOXES",
        table: "MOST_ARGUMENTS",
    }

    def setUp(self):
        self.before = {module: getattr(module, name) for module, name in self.sizes.items()}

    def tearDown(self):
        for module, name in self.sizes.items():
            setattr(module, name, self.before[module])

    def test_results_do_not_depend_on_the_sizes_of_batches(self):
        # In one and two dimensions, with a table, unions, tubes, and several levels.
        for seed in (2, 6, 7):
            text = campaign.make(random.Random(seed))[0].text()
            whole = self.found(text)
            self.assertGreater(whole[0][0], 0)
            for module, name in self.sizes.items():
                setattr(module, name, 13 if module is sweep else 101)
            self.assertEqual(self.found(text), whole)
            self.tearDown()

    @staticmethod
    def found(text):
        said = []
        try:
            return check(Certificate(text), said.append), said
        except Refused as reason:
            return str(reason), said

    def test_tubes_and_the_region_are_found_in_any_batches(self):
        # 1 + 3 exp(−20|x|²), which is at least 1: the tubes take some hundred boxes.
        f = campaign.bump(random.Random(1), 2, 3.0).formula
        ends = [[("point", np.array([-0.5, 0.0]))], [("ball", np.array([0.7, 0.0, 0.1]))]]
        f_low = campaign.bump(random.Random(1), 2, -0.9).formula

        def required():
            parts = region.required_cubes(("declared", 1.0), ends, 1.2, -3, 2)
            return np.unique(np.concatenate([*parts]), axis=0).tolist()

        whole = required()
        region.BATCH = formula.MOST_BOXES = 17
        self.assertEqual(required(), whole)
        region.BATCH, before, region.MOST_BOXES = 2, region.MOST_BOXES, 600
        try:
            region.prove_tubes(f, ends, 0.9, 1.0, 0.3)
            # H is too small within the radius of both sets, and of one of them, but not in them.
            far = [("point", np.array([-9.0, 0.0]))]
            for low in (ends, [far, ends[1]], [ends[1], far]):
                with self.assertRaises(Refused):
                    region.prove_tubes(f_low, low, 0.9, 1.0, 0.3)
                region.prove_tubes(f_low, low, 0.09, 0.1, 0.3)
        finally:
            region.MOST_BOXES = before

    def test_gram_is_that_of_each_box(self):
        f = campaign.wave(random.Random(2), 2).formula
        x = [of(np.linspace(-1, 1, 20)), of(np.linspace(0, 1, 20))]
        whole = gram(f, x)
        formula.MOST_BOXES = 3
        for ij, entry in gram(f, x).items():
            np.testing.assert_array_equal(entry.lo, whole[ij].lo)
            np.testing.assert_array_equal(entry.hi, whole[ij].hi)


class Chains(unittest.TestCase):
    def test_the_next_level_has_all_halves(self):
        kept = np.array([[0, -1], [3, 5]])
        halves = {(2 * x + a, 2 * y + b) for x, y in kept.tolist() for a in (0, 1) for b in (0, 1)}
        self.assertEqual(set(map(tuple, following(kept, 1).tolist())), halves)
        self.assertEqual(following(kept, 0).tolist(), kept.tolist())
        for halvings in (-1, 2):
            with self.assertRaises(Refused):
                following(kept, halvings)

    def test_neighbours_of_the_cubes_are_not_cubes(self):
        cubes = np.array(list(itertools.product(range(2, 4), range(-3, -1))))
        level = Level(0, cubes, np.zeros((25, 2)))
        around = np.array(list(itertools.product(range(-1, 7), range(-6, 3))))
        expected = [tuple(c) in set(map(tuple, cubes.tolist())) for c in around.tolist()]
        self.assertEqual(level.holds(around).tolist(), expected)
        far = np.array([[2**40, 0], [-(2**40), -2], [2, 2**40]])
        self.assertEqual(level.holds(far).tolist(), [False] * 3)


if __name__ == "__main__":
    unittest.main()
