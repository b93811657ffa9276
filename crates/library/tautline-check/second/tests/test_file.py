"""Tests of the program: broken files, the budget of work, the time limit, and what is printed."""

import contextlib
import io
import itertools
import random
import re
import tempfile
import unittest
from decimal import Decimal
from fractions import Fraction
from pathlib import Path
from unittest import mock

import numpy as np

import campaign
import check
from certificate import Certificate
from formula import Formula
from refused import Refused
from region import required_cubes
from test_check import along, bits, flat, level, lines, required
from work import Work

ENDS = [("point", 0.0, 0.03), ("point", 1.0, 0.03)]


def certificate(
    hi=1.0001, region=None, exponent=-3, curve=((0.0, 0.03), (1.0, 0.03)), levels=1, c1=0.999
):
    region = region or f"declared {bits(c1)}"
    cubes = required(hi, ENDS, exponent, c1)
    one = level(exponent, cubes, along(ENDS[0][1:], ENDS[1][1:]))
    return lines(flat(2), ENDS, hi, region, [one] * levels, curve), len(cubes)


def text(lines):
    return "\n".join(lines) + "\n"


def is_refused(content):
    """Whether the text is no certificate, whatever it proves."""
    try:
        Certificate(content)
    except Refused:
        return True
    return False


def ran(content, *options):
    """The exit code and what is printed for a file with these bytes."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "c.cert"
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        said, complained = io.StringIO(), io.StringIO()
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(complained):
            code = check.main([*options, str(path)])
        return code, said.getvalue(), complained.getvalue()


class Files(unittest.TestCase):
    def test_proved_refused_and_not_read_have_codes_of_their_own(self):
        good = text(certificate()[0])
        self.assertEqual(ran(good)[0], 0)
        for broken in (
            "",
            "\n",
            good[:-1],
            good[:-5],
            good.replace("hi", "ho"),
            good + "x\n",
            good.replace("end", "é"),
        ):
            code, said, complained = ran(broken)
            self.assertEqual((code, said, complained[:9]), (1, "", "refused: "), broken[-50:])
        self.assertEqual(ran(b"\xff\xfe" + good.encode())[0], 2)
        with contextlib.redirect_stderr(io.StringIO()):
            for arguments in (
                ["/nowhere"],
                ["/"],
                [],
                ["a", "b"],
                ["--time-limit", "x", "a"],
                ["--no", "1", "a"],
            ):
                self.assertEqual(check.main(arguments), 2, arguments)

    def test_broken_texts_are_refused_whatever_is_broken(self):
        chance, accepted = random.Random(1), 0
        words = "0 -1 1 2 99999999999999999 -0 00 x9 s99 nan 7ff8000000000000 fff0000000000000 é 1e999".split()
        words += [
            "0000000000000001",
            "7fefffffffffffff",
            "ffefffffffffffff",
            "8000000000000000",
            "",
            "\t",
        ]
        words += [
            "table1_3",
            "ball",
            "half-space",
            "exit-one",
            "tubes",
            "^2147483648",
            "1" + "0" * 5000,
        ]
        texts = [
            text(certificate(0.9, exponent=-2, curve=())[0][:4] + certificate(exponent=-2)[0][4:])
        ]
        texts += [campaign.make(random.Random(seed))[0].text() for seed in (2, 6, 31)]
        for _ in range(150):
            broken = chance.choice(texts).split("\n")
            for _ in range(chance.choice([1, 1, 2])):
                # Half of the changes are among the first lines.
                at = chance.randrange(
                    min(len(broken), 25) if chance.random() < 0.5 else len(broken)
                )
                what = chance.randrange(5)
                if what == 0:
                    broken = broken[: at + 1]
                elif what == 1:
                    broken.insert(at, chance.choice(broken))
                elif what == 2:
                    del broken[at : at + 1]
                else:
                    parts = broken[at].split(" ") if broken else [""]
                    parts[chance.randrange(len(parts))] = chance.choice(words)
                    broken[at : at + 1] = [" ".join(parts)]
                broken = broken or [""]
            try:
                check.check(Certificate("\n".join(broken)))
                accepted += 1
            except Refused:
                pass
        self.assertLess(accepted, 75)

    def test_a_mistake_of_the_checker_proves_nothing(self):
        with mock.patch("check.Sweep", side_effect=IndexError("planted")):
            code, said, complained = ran(text(certificate()[0]))
        self.assertEqual((code, said), (1, ""))
        self.assertIn("planted", complained)

    def test_cubes_are_not_too_far_in_any_direction(self):
        for k, far in ((2**28, False), (2**28 + 1, True), (-(2**28), False), (-(2**28) - 1, True)):
            one = ["level 0 1 3", f"{k} 1", *["0" * 16 + " " + "0" * 16] * 3]
            content = text(lines(flat(1), [("point", 0.0)] * 2, 1.0, "exit-one", [one]))
            if far:
                with self.assertRaises(Refused):
                    Certificate(content)
            else:
                Certificate(content)

    def test_cubes_are_not_too_far_from_each_other(self):
        for last, far in (((2**24 - 4, 2**24 + 4), False), ((2**24 - 4, 2**24 + 5), True)):
            one = level(0, [(-3, 5), last], along((0.0, 0.0), (1.0, 0.0)))
            file = text(lines(flat(2), [("point", 0.0, 0.0)] * 2, 1.0, "exit-one", [one]))
            self.assertEqual(is_refused(file), far, last)
        # So many places that a product of doubles is needed to count them, or of integers of any size.
        one = level(0, [[-(2**28)] * 4, [2**28] * 4], along((0.0,) * 4, (1.0, 0.0, 0.0, 0.0)))
        file = text(lines(flat(4), [("point", *[0.0] * 4)] * 2, 1.0, "exit-one", [one]))
        self.assertTrue(is_refused(file))

    def test_half_spaces_are_not_too_far(self):
        for normal, offset, far in (
            ((2.0**-100, 2.0**-3), 2.0**997, False),
            ((2.0**-100, -(2.0**-3)), -(2.0**997), False),
            ((2.0**-100, 2.0**-3), np.nextafter(2.0**997, np.inf), True),
            ((-(2.0**-3), 0.0), -np.nextafter(2.0**997, np.inf), True),
            ((0.0, 2.0**-1074), -(2.0**-74), False),
            ((2.0**-1074, 0.0), np.nextafter(2.0**-74, 1.0), True),
            ((0.0, 0.0), 0.0, True),
        ):
            ends = [("point", 0.0, 0.0), ("half-space", *normal, offset)]
            file = text(lines(flat(2), ends, 1.0, "exit-one"))
            self.assertEqual(is_refused(file), far, (normal, offset))

    def test_a_formula_is_not_too_long(self):
        file = text(lines(flat(2), ENDS, 1.0, "exit-one"))
        for most, far in ((3, False), (2, True)):
            with mock.patch("certificate.MOST_LINES", most):
                self.assertEqual(is_refused(file), far, most)

    def test_no_two_tables_are_equal(self):
        """They differ by a bit, or by their lengths."""
        steps = ["s1 = table1({});", "s2 = table2({});", "s3 = s1 + s2;", "[s3, s3; s3, s3]"]
        for first, second, calls, equal in (
            (["table 1", bits(1.0)], ["table 1", bits(1.0)], ("x1", "x2"), True),
            (["table 1", bits(0.0)], ["table 1", bits(-0.0)], ("x1", "x1"), False),
            (["table 2", bits(1.0, 2.0)], ["table 2", bits(1.0, 2.0)], ("x1", "x1"), True),
            (["table 2", bits(1.0, 2.0)], ["table 1 2", bits(1.0, 2.0)], ("x1", "x1, x2"), False),
        ):
            metric = [*(s.format(c) for s, c in zip(steps, calls)), *steps[2:]]
            file = lines(metric, ENDS, 1.0, "exit-one")
            file[2:2] = [*first, *second]
            self.assertEqual(is_refused(text(file)), equal, (first, second))

    def test_infinite_numbers_are_refused_wherever_they_are(self):
        good = text(certificate()[0])
        at = [m.start() for m in re.finditer(r"\b[0-9a-f]{16}\b", good)]
        for start in at[:: max(1, len(at) // 40)]:
            for word in ("7ff0000000000000", "fff0000000000000", "7ff8000000000001"):
                with self.assertRaises(Refused):
                    Certificate(good[:start] + word + good[start + 16 :])


class Matrices(unittest.TestCase):
    def test_the_matrix_is_symmetric_by_its_steps(self):
        steps = ["s1 = number(1.0);", "s2 = number(0.0);", "s3 = recip(x1);"]
        Formula([*steps, "[s1, s2; s2, s3]"], 2)
        for matrix in ("[s1, s2; s3, s1]", "[s1, s3; s2, s1]"):
            with self.assertRaises(Refused):
                Formula([*steps, matrix], 2)
        with self.assertRaises(Refused):
            Formula([*steps, "[s1, s2; s2, s1]"], 2)

    def test_steps_are_kept_as_long_as_they_are_read(self):
        f = Formula(
            [
                "s1 = x1 + 1.0;",
                "s2 = s1 * s1;",
                "s3, s4 = sin_cos(s1);",
                "s5 = s3 + s2;",
                "s6 = s5 - s1;",
                "[s6]",
            ],
            1,
        )
        self.assertEqual(f.unread_after, [["x1"], [], ["s4"], f.unread_after[3], f.unread_after[4]])
        self.assertEqual(
            (set(f.unread_after[3]), set(f.unread_after[4])), ({"s2", "s3"}, {"s1", "s5"})
        )
        self.assertEqual(f.most_values, 4)

        class Number(float):
            def __add__(self, other):
                return Number(float(self) + other)

            def __sub__(self, other):
                return Number(float(self) - other)

            def __mul__(self, other):
                return Number(float(self) * other)

            def sin(self):
                return Number(np.sin(self))

            def cos(self):
                return Number(np.cos(self))

        self.assertEqual(f([Number(1.0)], Number)[0, 0], np.sin(2.0) + 4 - 2)


class Budget(unittest.TestCase):
    """What FORMAT.md says in "The budget of work"."""

    def spent(self, content):
        with mock.patch("check.Work", side_effect=Work) as made:
            kept = []
            made.side_effect = lambda budget: kept.append(Work(budget)) or kept[-1]
            check.check(Certificate(content))
        return kept[0]

    def test_the_size_counts_doubles_and_lines_of_the_formula(self):
        for seed in (2, 6, 7, 31):
            content = campaign.make(random.Random(seed))[0].text()
            count = int(re.search(r"^metric (\d+)$", content, re.M)[1])
            doubles = len(re.findall(r"\b[0-9a-f]{16}\b", content))
            self.assertEqual(Certificate(content).size, doubles + count)

    def test_cubes_parts_and_boxes_are_counted(self):
        # Three lines, two pieces, each in or beside two cubes; the chord is one part.
        file, cubes = certificate()
        per_cube, near = (4 + 6) * 3 + 2, 2 * 2 * 64 * 2
        # The search begins with 16 cubes of side 4. Those that would be required are halved.
        halved = sum(len(required(1.0001, ENDS, larger, 0.999)) for larger in range(-2, 3))
        near += (16 + 4 * halved) * 2
        work = self.spent(text(file))
        self.assertEqual(work.spent, cubes * per_cube + near + 6 * 3)
        self.assertEqual(work.budget, 2**24 + 2**16 * Certificate(text(file)).size)
        file, cubes = certificate(levels=2, curve=())
        twice = 2 * (cubes * per_cube + near) - (16 + 4 * halved) * 2
        self.assertEqual(self.spent(text(file)).spent, twice)
        # H ≥ c1 on the whole box of each tube: one box each.
        file, cubes = certificate(region=f"tubes {bits(0.51, 0.999)}")
        self.assertEqual(
            self.spent(text(file)).spent, cubes * per_cube + near + 6 * 3 + 2 * (3 + 2)
        )

    def test_a_search_for_required_cubes_that_finds_none_ends(self):
        # Curves shorter than hi, a little less than the distance, are in no cube of this side, but in
        # more and more cubes of smaller and smaller sides.
        ends = [("point", 0.0, 0.0), ("point", 1.0, 0.75)]
        one = level(-25, [(0, 0)], [lambda x: 0.0] * 2)
        file = lines(flat(2), ends, 1.25 * (1 - 2**-24), f"declared {bits(1.0)}", [one])
        code, _, complained = ran(text(file))
        self.assertEqual(code, 1)
        self.assertIn("units of work", complained)

    def test_more_large_cubes_may_be_looked_at_than_the_level_has(self):
        # Between ends that are farther apart than hi no cube is required, but large cubes meet both.
        one = level(-3, [(56,)], [lambda x: 0.0] * 2)
        ends = [("point", 0.0), ("point", 3.0)]
        file = lines(flat(1), ends, 2.0, f"declared {bits(1.0)}", [one])
        for name, shift in (("to", 3), ("from", 0)):
            at = next(n for n, line in enumerate(file) if line.startswith(name)) + 1
            file[at:at] = [f"{name} point {bits(10 * k + shift)}" for k in range(1, 100)]
        self.assertEqual(check.check(Certificate(text(file)))[0], 2.0)

    def test_each_near_piece_of_a_cube_is_counted_and_a_box_for_each_of_its_sides(self):
        metric, one = flat(3), level(0, [(0, 0, 0)], [lambda x: 0.0] * 2)
        box, ball = ("box", *[0.2] * 3, *[0.4] * 3), ("ball", 0.5, 0.5, 0.5, 0.1)
        far = ("point", 5.0, 5.0, 5.0)
        for ends, near in (((box, box), 12), ((ball, box), 7), ((ball, ball), 2), ((ball, far), 1)):
            file = text(lines(metric, ends, 1e-3, f"declared {bits(9.0)}", [one]))
            units = 64 * 2 + (8 + 10) * 3 + 2 + 64 * 6 * near
            self.assertEqual(self.spent(file).spent, units, ends)

    def test_there_are_at_most_1024_tables(self):
        for count in (1024, 1025):
            steps = [f"s{k} = table{k}(x1);" for k in range(1, count + 1)]
            steps += [
                f"s{count + k} = s{count + k - 1 if k > 1 else 1} + s{k + 1};"
                for k in range(1, count)
            ]
            file = lines([*steps, f"[s{2 * count - 1}]"], [("point", 0.0)] * 2, 1.0, "exit-one")
            file[2:2] = [line for k in range(count) for line in ("table 1", bits(1.0 + k))]
            if count == 1024:
                Certificate(text(file))
            else:
                with self.assertRaises(Refused):
                    Certificate(text(file))

    def test_functions_weigh_four_and_tables_more(self):
        for step, weight in (
            ("exp(x1)", 4),
            ("sqrt(x1)", 4),
            ("sqr(x1)", 1),
            ("x1^0", 1),
            ("x1^3", 2),
            ("x1^-3", 2),
            ("x1^8", 4),
            ("-x1", 1),
            ("recip(x1)", 1),
            ("x1 / 2.0", 1),
            ("number(2.0)", 1),
        ):
            self.assertEqual(Formula([f"s1 = {step};", "[s1]"], 1).weight, weight + 1)
        self.assertEqual(Formula(["s1, s2 = sin_cos(x1);", "s3 = s1 + s2;", "[s3]"], 1).weight, 6)
        table = check.Certificate(campaign.make(random.Random(6))[0].text()).formula
        self.assertEqual(table.weight, 4**2 + sum(1 for _ in table.steps[1:]) + 1)

    def test_a_unit_too_much_is_refused(self):
        content = text(certificate(levels=2)[0])
        units = self.spent(content).spent
        with mock.patch.multiple("check", ALWAYS=units, FOR_A_NUMBER=0):
            check.check(Certificate(content))
        with (
            mock.patch.multiple("check", ALWAYS=units - 1, FOR_A_NUMBER=0),
            self.assertRaises(Refused),
        ):
            check.check(Certificate(content))

    def test_a_small_file_does_not_ask_for_hours(self):
        # H − c1 is 0 at a point: no number of boxes would do.
        metric = [
            "s1 = sqr(x1);",
            *(f"s{n} = sin(s{n - 1});" for n in range(2, 60)),
            "s60 = s59 + 1.0;",
            "[s60]",
        ]
        one = level(0, [(0,)], [lambda x: x[0], lambda x: 1 - x[0]])
        content = text(
            lines(metric, [("point", 0.0), ("point", 1.0)], 1.9, f"tubes {bits(1.0, 1.0)}", [one])
        )
        patched = mock.patch.multiple("check", ALWAYS=2**16, FOR_A_NUMBER=2**10)
        with patched, self.assertRaises(Refused) as refused:
            check.check(Certificate(content))
        self.assertIn(str(2**16 + 2**10 * Certificate(content).size), str(refused.exception))

    def test_cubes_that_are_missing_are_found_out_at_once(self):
        pieces = [("point", k / 64, 0.0) for k in range(400)]
        file = lines(
            flat(2),
            [("point", 0.0, 0.0), ("point", 1.0, 0.5)],
            700.0,
            f"declared {bits(1)}",
            [level(-2, [(0, 0)], [lambda x: 0.0] * 2)],
        )
        at = next(i for i, line in enumerate(file) if line.startswith("from"))
        file[at : at + 1] = [f"from point {bits(*x)}" for _, *x in pieces]
        with self.assertRaises(Refused) as refused:
            check.check(Certificate(text(file)))
        self.assertIn("lacks", str(refused.exception))

    def test_what_is_not_checked_in_the_time_is_said(self):
        with mock.patch("check.Sweep", side_effect=check.OutOfTime):
            code, said, complained = ran(text(certificate()[0]), "--time-limit", "1000")
        self.assertEqual((code, said), (2, ""))
        self.assertIn("not checked in the time", complained)
        self.assertIn("checked: the curve", complained)
        self.assertEqual(ran(text(certificate()[0]), "--time-limit", "0.001")[0], 2)


class Proofs(unittest.TestCase):
    def test_the_lower_bound_is_that_of_the_best_level(self):
        file, _ = certificate(curve=())
        alone, _ = check.check(Certificate(text(file)))
        cubes = required(1.0001, ENDS, -3, 0.999)
        worse = level(-3, cubes, [lambda x: 0.0] * 2)
        for more in (file[:-1] + worse + ["end"],):
            self.assertEqual(check.check(Certificate(text(more)))[0], alone)

    def test_a_later_level_has_the_cubes_that_are_kept(self):
        file, _ = certificate(curve=())
        cubes = required(1.0001, ENDS, -3, 0.999)
        functions = along(ENDS[0][1:], ENDS[1][1:])
        halves = sorted(
            {
                tuple(2 * k + h for k, h in zip(c, half))
                for c in cubes.tolist()
                for half in itertools.product(range(2), repeat=2)
            }
        )
        whole = file[:-1] + level(-4, halves, functions) + ["end"]
        check.check(Certificate(text(whole)))
        # The geodesic runs at height 0.03 through the cubes in the row 0.
        lacking = [c for c in halves if c != (7, 0)]
        with self.assertRaises(Refused):
            check.check(Certificate(text(file[:-1] + level(-4, lacking, functions) + ["end"])))

    def test_a_curve_and_a_proof_that_there_is_none_are_a_contradiction(self):
        # By the false c1 = 9 no cubes are required, and those of the file do not meet the sets.
        one = level(-3, [(40, 40)], [lambda x: 0.0] * 2)
        for curve, accepted in (((), True), (ENDS[0][1:], False)):
            curve = [ENDS[0][1:], ENDS[1][1:]] if curve else ()
            file = lines(flat(2), ENDS, 1.5, f"declared {bits(9.0)}", [one], curve)
            if accepted:
                self.assertEqual(check.check(Certificate(text(file)))[0], 1.5)
            else:
                with self.assertRaises(Refused):
                    check.check(Certificate(text(file)))

    def test_both_ends_of_the_curve_lie_in_their_sets_and_it_is_shorter_than_hi(self):
        for curve in (
            [(0.0, 0.031), (1.0, 0.03)],
            [(0.0, 0.03), (1.0, 0.031)],
            [(0.0, 0.03), (0.5, 0.04), (1.0, 0.03)],
        ):
            with self.assertRaises(Refused):
                check.check(Certificate(text(certificate(curve=curve)[0])))

    def test_curves_may_leave_the_first_level_only_if_it_says_why(self):
        file, _ = certificate(region="exit-two", levels=2)
        with self.assertRaises(Refused):
            check.check(Certificate(text(file)))


class Exits(unittest.TestCase):
    def test_exit_two_needs_the_cubes_of_both_sets_and_exit_one_those_of_the_first(self):
        ends = [[("point", np.array([0.5]))], [("ball", np.array([5.0, 0.6]))]]
        for kind, cubes in (("exit-one", [0]), ("exit-two", [0, 4, 5])):
            found = np.concatenate([*required_cubes((kind,), ends, 1.0, 0, 1)])
            self.assertEqual(np.unique(found).tolist(), cubes)

    def test_a_facet_that_is_just_outside_of_the_second_set_counts(self):
        # 3 times the double 0.1 is more than the double 0.3, by 3e-17; rounded, it may be less.
        cubes = [(k,) for k in range(3, 8)]
        one = level(0, cubes, [lambda x: abs(x[0] - 5), lambda x: 0.0])
        for offset, accepted in ((0.3, False), (0.31, True)):
            ends = [("point", 5.0), ("half-space", 0.1, offset)]
            file = text(lines(flat(1), ends, 2.5, "exit-one", [one]))
            if accepted:
                check.check(Certificate(file))
            else:
                with self.assertRaises(Refused):
                    check.check(Certificate(file))


class Printed(unittest.TestCase):
    def test_decimals_are_bounds(self):
        c, chance = Certificate(text(certificate()[0])), random.Random(1)
        for _ in range(300):
            upper = chance.uniform(0.5, 2) * 10.0 ** chance.randint(-300, 300)
            lower = upper * chance.choice([1.0, chance.random()])
            said = dict(line.split(maxsplit=1) for line in check.statement(c, lower, upper)[-3:])
            self.assertLessEqual(Decimal(said["lower"]), Decimal(lower))
            self.assertGreaterEqual(Decimal(said["upper"]), Decimal(upper))
            self.assertGreaterEqual(Fraction(said["gap"]), 1 - Fraction(lower) / Fraction(upper))
            self.assertLessEqual(
                Fraction(said["gap"]),
                (1 - Fraction(lower) / Fraction(upper)) * (1 + Fraction(1, 10**5)),
            )


if __name__ == "__main__":
    unittest.main()
