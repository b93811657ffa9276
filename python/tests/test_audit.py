"""The audit, as users of the Python module see it. Most tests need the program `tautline-audit`."""

import doctest
import os
import pathlib
import signal
import stat
import sys
import tempfile
import threading
import time
import unittest
from unittest import mock

import numpy as np

import tautline_geodesics as tl
from tautline_geodesics import _audit, _tautline


def has_program():
    try:
        return bool(_audit._program())
    except FileNotFoundError:
        return False


needs_program = unittest.skipUnless(has_program(), "there is no program tautline-audit")


def load_tests(loader, tests, pattern):
    """The example of the documentation is a test."""
    if has_program():
        tests.addTests(doctest.DocTestSuite(_audit))
    return tests


@needs_program
class Audits(unittest.TestCase):
    def test_a_metric_holds_with_constants_that_are_proved(self):
        found = tl.audit(tl.Metric.cost("2 - cos(x1)", 2), cases=16, time_limit=120)
        self.assertEqual((found.verdict, found.lies), ("holds", []), found)
        self.assertTrue(found.constants_proved)
        np.testing.assert_allclose(found.constants, (1, 9, 4.4037, 6), rtol=0.05)
        self.assertGreater(len(found.laws), 40)
        self.assertTrue({law.status for law in found.laws} <= {"holds", "does_not_apply"})
        self.assertTrue(repr(found).startswith("<tautline.Audit: All laws hold. Of "), repr(found))
        self.assertIn("The laws that hold:", str(found))

    def test_true_claims_hold(self):
        valleys = tl.Metric.cost("2 - cos(x1)", 2)
        found = tl.audit(valleys, claimed=(1, 9, 4.404, None), cases=16, time_limit=120)
        self.assertEqual(found.verdict, "holds", found)
        self.assertEqual((found.constants, found.constants_proved), ((1, 9, 4.404, None), False))

    def test_what_is_proved_can_be_claimed(self):
        valleys = tl.Metric.cost("2 - cos(x1)", 2)
        proved = valleys.constants()
        found = tl.audit(valleys, claimed=proved, cases=16, time_limit=120)
        self.assertEqual(found.verdict, "holds", found)
        self.assertEqual(found.constants[0], proved["c1"].lower)
        self.assertEqual(found.constants[3], proved["M_H"].upper)

    def test_false_claims_are_refuted_at_a_point(self):
        valleys = tl.Metric.cost("2 - cos(x1)", 2)
        found = tl.audit(valleys, claimed=(1, 8, 4.404, 6.25), cases=16)
        self.assertEqual(found.verdict, "lies")
        [lie] = found.lies
        self.assertEqual((lie.about, lie.claim, lie.claimed), ("c2", "c2 = 8", 8.0))
        w = np.array(lie.direction)
        self.assertAlmostEqual(w @ valleys(lie.point) @ w, lie.found)
        self.assertGreater(lie.found, 8.9)
        [law] = [law for law in found.laws if law.id == "c2_is_an_upper_bound"]
        self.assertEqual((law.says, law.status), ("λ_max(H) ≤ c2", "fails"))
        self.assertIn("c2 = 8", law.why)
        self.assertRegex(repr(found), "^<tautline.Audit: A claim is false: c2.*\n  c2 = 8 is claimed")

    def test_a_formula_that_is_no_metric_is_refuted_at_a_point(self):
        found = tl.audit(
            tl.Metric.phi("x1", 2), region=tl.box([-1, 0], [1, 1]), cases=16, time_limit=120
        )
        self.assertEqual((found.verdict, found.lies[0].about), ("lies", "H"))
        self.assertLessEqual(found.lies[0].point[0], 0)
        self.assertIsNone(found.constants)

    def test_a_traced_function_with_tables(self):
        i, j = np.indices((5, 4))
        hill, slope = tl.Table(np.exp(-((i - 2) ** 2) - (j - 1) ** 2)), tl.Table([0.0, 0.1, 0.4])
        # The tables are numbered by their first calls.
        metric = tl.Metric.cost(lambda x: 1 + slope(x[0] / 2) + hill(x[0], x[1]), 2)
        found = tl.audit(metric, start=[0, 1], goal=[4, 1], cases=16, time_limit=120)
        self.assertEqual((found.verdict, found.constants_proved), ("holds", True), found)
        proved = metric.constants()
        self.assertEqual(found.constants[0], proved["c1"].lower)
        self.assertEqual(found.constants[1], proved["c2"].upper)

    def test_region_cases_and_seed_are_those_that_are_given(self):
        box = tl.box([-0.1, 1e-7], [1 / 3, 2.5])
        found = tl.audit(tl.Metric.phi("2", 2), region=box, cases=7, seed=5).document
        self.assertEqual((found["cases"], found["seed"]), (7, 5))
        corners = found["region"]["lower"], found["region"]["upper"]
        np.testing.assert_allclose(corners, [[-0.1, 1e-7], [1 / 3, 2.5]], rtol=1e-15)

    def test_a_time_limit_leaves_laws_untried(self):
        hill = tl.Metric.cost("1 + exp(-(x1^2 + x2^2 + x3^2))", 3)
        start = time.monotonic()
        found = tl.audit(hill, claimed=(1, 4, 4, 20), time_limit=0.5)
        self.assertLess(time.monotonic() - start, 5)
        untried = [law for law in found.laws if law.status == "not_tried"]
        self.assertTrue(untried and all(law.why for law in untried))

    def test_all_kinds_of_sets_are_taken(self):
        flat = tl.Metric.phi("1", 2)
        round_ones = tl.ball([0, 0], 0.5) | tl.sphere([3, 0], 0.5) | tl.point([9, 9])
        straight = tl.segment([5, 0], [5, 1]) | tl.affine_subspace([7, 0], [[0, 1]])
        for start, goal in [
            (round_ones, straight),
            (tl.box([0, 0], [1, 1]), tl.half_space([1, 0], at_least=3)),
            (tl.points([[0, 0], [0, 1]]), np.array([2.0, 2.0])),
        ]:
            found = tl.audit(flat, start=start, goal=goal, cases=2)
            self.assertIn("the box around the sets", found.document["region"]["why"])

    def test_wrong_input_says_what_is_wrong(self):
        flat = tl.Metric.phi("1", 2)
        cases = [
            ("both or neither", dict(start=[0, 0])),
            ("is a box", dict(region=tl.ball([0, 0], 1))),
            ("an empty region", dict(region=tl.box([0, 0], [1, 0]))),
            ("c1", dict(claimed=(2, 1, 0, None))),
            ("seconds", dict(time_limit=-1)),
            ("cases", dict(cases=0)),
            ("seed", dict(seed=-1)),
        ]
        for message, arguments in cases:
            with self.subTest(message), self.assertRaisesRegex(tl.ProblemError, message):
                tl.audit(flat, **arguments)


def _script(folder, lines):
    """A program in place of that of the audit."""
    program = pathlib.Path(folder, _audit.PROGRAM)
    program.write_text(f"#!/bin/sh\n{lines}\n")
    program.chmod(program.stat().st_mode | stat.S_IXUSR)


class WithoutTheProgram(unittest.TestCase):
    def test_a_report_of_another_version_is_named_or_read(self):
        lie = dict.fromkeys(_audit.Lie._fields, None) | {"about": "L_H", "a later field": 7}
        report = {"verdict": "lies", "lies": [lie], "laws": [], "constants": None, "text": "…"}
        self.assertEqual(_audit._audit(report).lies[0].about, "L_H")
        for missing in ("verdict", "laws", "constants", "text"):
            with self.assertRaisesRegex(RuntimeError, f"no '{missing}': it is of another version"):
                _audit._audit({name: value for name, value in report.items() if name != missing})
        del lie["formula"]
        with self.assertRaisesRegex(RuntimeError, "no 'formula'"):
            _audit._audit(report)

    def test_a_black_box_has_no_formula(self):
        black_box = tl.Metric.black_box(lambda x: np.ones((len(x), 1, 1)), 1)
        with self.assertRaisesRegex(tl.NotCertified, "no formula to audit"):
            tl.audit(black_box)

    def test_ends_are_given_both_or_neither(self):
        for ends in ({"start": [0]}, {"goal": [0]}):
            with self.assertRaisesRegex(tl.ProblemError, "both or neither"):
                tl.audit(tl.Metric.phi("1", 1), **ends)

    def test_constants_of_a_report_are_in_their_order(self):
        used = {"c1": 1, "c2": 9, "l_h": 4, "m_h": None, "proved": True}
        report = {"verdict": "holds", "lies": [], "laws": [], "constants": used, "text": ""}
        found = _audit._audit(report)
        self.assertEqual((found.constants, found.constants_proved), ((1, 9, 4, None), True))

    @unittest.skipUnless(os.name == "posix", "the program is a script")
    def test_bad_input_is_told_from_a_program_that_says_nothing(self):
        with tempfile.TemporaryDirectory() as folder:
            with mock.patch.object(sys, "executable", f"{folder}/python"):
                _script(folder, "cat > /dev/null; echo 'no such thing' >&2; exit 2")
                with self.assertRaisesRegex(tl.ProblemError, "^no such thing$"):
                    tl.audit(tl.Metric.phi("1", 1))
                _script(folder, "cat > /dev/null; exit 1")
                with self.assertRaisesRegex(RuntimeError, "ended with 1"):
                    tl.audit(tl.Metric.phi("1", 1))

    @unittest.skipUnless(os.name == "posix", "the program is a script")
    def test_the_program_beside_the_interpreter_comes_first(self):
        with tempfile.TemporaryDirectory() as beside, tempfile.TemporaryDirectory() as path:
            _script(beside, ""), _script(path, "")
            with mock.patch.object(sys, "executable", f"{beside}/python"):
                with mock.patch.dict(os.environ, PATH=path):
                    self.assertEqual(_audit._program(), f"{beside}/{_audit.PROGRAM}")

    def test_a_missing_program_is_named_with_its_package(self):
        with tempfile.TemporaryDirectory() as empty:
            with mock.patch.object(sys, "executable", f"{empty}/python"):
                with mock.patch.dict(os.environ, PATH=empty):
                    with self.assertRaisesRegex(FileNotFoundError, "pip install ./python/audit"):
                        tl.audit(tl.Metric.phi("1", 1))

    def test_the_numbers_of_a_problem_file_read_back_exactly(self):
        numbers = np.random.default_rng(5).normal(size=(3, 2, 4)) * 10.0 ** np.arange(-8, 8, 4)
        table = tl.Table(numbers, spline="smoothing")
        metric = tl.Metric("phi(1e-300 + ground(x1, x1, x1))", 1, tables={"ground": table})
        text = _tautline.problem_file(metric.program)
        found = text.split("values = ")[1].split("\n")[0]
        np.testing.assert_array_equal(np.array(eval(found)), numbers)
        self.assertIn("[tables.table1]", text)
        self.assertIn("1e-300", text)

    @unittest.skipUnless(os.name == "posix", "the program is a script")
    def test_ctrl_c_ends_the_program(self):
        # A job in the background of a shell ignores it.
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        with tempfile.TemporaryDirectory() as folder:
            pid = pathlib.Path(folder, "pid")
            _script(folder, f"echo $$ > {pid}\nexec sleep 60")
            timer = threading.Timer(0.5, signal.raise_signal, [signal.SIGINT])
            with mock.patch.object(sys, "executable", f"{folder}/python"):
                timer.start()
                start = time.monotonic()
                with self.assertRaises(KeyboardInterrupt):
                    tl.audit(tl.Metric.phi("1", 1))
            self.assertLess(time.monotonic() - start, 2)
            with self.assertRaises(ProcessLookupError):
                os.kill(int(pid.read_text()), 0)
