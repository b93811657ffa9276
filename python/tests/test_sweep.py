"""Sweeps, as users of the Python module see them; without Dask and Ray."""

import importlib.util
import math
import pickle
import tempfile
import unittest
from pathlib import Path

import numpy as np

import tautline_geodesics as tl
from tautline_geodesics import sweep

FILE = """
[parameters]
height = 1
y = 0
[metric]
cost = "1 + height*exp(-(x1^2 + x2^2))"
[from]
point = [-2, "y"]
[to]
point = [2, 0]
[solve]
n = 16
[sweep]
draws = 5
[sweep.vary]
height = [1, 2, -1.5]
y = { uniform = [-1, 1] }
"""


class Sweeps(unittest.TestCase):
    def setUp(self):
        self.plan = sweep.Plan(FILE)
        self.whole = self.plan.solved(0, 15)
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def test_shards_merge_to_one_run_in_any_number(self):
        for n in (1, 4, 20):
            folder = self.folder / str(n)
            paths = [sweep.run_shard(self.plan, k, n, folder) for k in range(1, n + 1)]
            sweep.merge(folder, self.folder / "merged.csv")
            self.assertEqual((self.folder / "merged.csv").read_text(), self.whole)
            sweep.merge(paths[::-1], self.folder / "merged.csv")
            self.assertEqual((self.folder / "merged.csv").read_text(), self.whole)
            self.assertEqual(sorted(folder.iterdir()), sorted(map(Path, paths)))

    def test_a_finished_shard_is_not_done_again_and_an_incomplete_one_is(self):
        path = Path(sweep.run_shard(self.plan, 2, 3, self.folder))
        before, text = path.stat().st_mtime_ns, path.read_text()
        sweep.run_shard(self.plan, 2, 3, self.folder)
        self.assertEqual(path.stat().st_mtime_ns, before)
        (self.folder / f".{path.name}.abandoned.part").touch()
        path.write_text(text[:-9])
        sweep.run_shard(self.plan, 2, 3, self.folder)
        self.assertEqual((path.read_text(), [*self.folder.iterdir()]), (text, [path]))
        for other in ("a diary\n", sweep.Plan(FILE.replace("n = 16", "n = 8")).solved(5, 10)):
            path.write_text(other)
            with self.assertRaisesRegex(tl.ProblemError, "no results|another plan"):
                sweep.run_shard(self.plan, 2, 3, self.folder)
            self.assertEqual(path.read_text(), other)

    def test_what_is_missing_or_doubled_is_named(self):
        part = self.plan.solved
        with self.assertRaisesRegex(tl.ProblemError, "ids 4 to 6 are missing"):
            sweep.merged([part(7, 15), part(0, 4)])
        with self.assertRaisesRegex(tl.ProblemError, "ids 7 to 7 are both in block 1 and in block 2"):
            sweep.merged([part(0, 8), part(7, 15)])
        with self.assertRaisesRegex(tl.ProblemError, "incomplete"):
            sweep.merged([self.whole[:-1]])

    def test_a_plan_is_its_table_its_file_and_its_pickle(self):
        table = self.folder / "plan.csv"
        table.write_text(self.plan.table)
        for again in (sweep.read(table), sweep.Plan(self.plan.file), pickle.loads(pickle.dumps(self.plan))):
            self.assertEqual((again.file, again.hash, len(again)), (FILE, self.plan.hash, 15))
            np.testing.assert_array_equal(again.rows(0, 15), self.plan.rows(0, 15))
        table.write_text(self.plan.table.replace("\n3,", "\n3,1"))
        with self.assertRaisesRegex(tl.ProblemError, "the row of problem 3"):
            sweep.read(table)
        with self.assertRaisesRegex(tl.ProblemError, "did you mean height"):
            sweep.Plan(FILE.replace("height = [", "hieght = ["))

    def test_columns_are_those_of_single_solves(self):
        table = sweep.columns(self.whole)
        self.assertEqual(table["id"].tolist(), [*range(15)])
        np.testing.assert_array_equal(np.column_stack([table["height"], table["y"]]), self.plan.rows(0, 15))
        hill = tl.Metric.cost("1 + 2*exp(-(x1^2 + x2^2))", 2)
        curve = tl.solve(hill, [-2, self.plan.rows(7, 8)[0, 1]], [2, 0], n=16)
        self.assertEqual(table["length"][7], curve.length.value)
        self.assertEqual(table["status"][[7, 12]].tolist(), ["solved", "failed"])
        self.assertTrue(math.isnan(table["length"][12]) and "positive" in table["reason"][12])

    def test_batches_have_the_rows_of_their_ids(self):
        ids = np.array([3, 4, 9, 0])
        table, batch = sweep.columns(self.whole), sweep.Batch(self.plan)({"id": ids})
        self.assertEqual([*batch], [*table])
        for name, column in batch.items():
            np.testing.assert_array_equal(column, table[name][ids])
        function = pickle.loads(pickle.dumps(sweep.Batch(self.plan, lines=True)))
        lines = [line for start in (0, 5, 10) for line in function({"id": np.arange(start, start + 5)})["line"]]
        self.assertEqual(self.plan.results(lines), self.whole)
        with self.assertRaisesRegex(tl.ProblemError, "id"):
            self.plan.results(lines[::-1])
        with self.assertRaisesRegex(tl.ProblemError, "the column id has masked cells"):
            sweep.Batch(self.plan)({"id": np.ma.masked_array([3, 4], [False, True])})

    def test_the_same_sweep_in_two_folders_is_two_works_of_one_cluster(self):
        class Cluster:
            """As a client of Dask, one result for each key."""

            def __init__(self):
                self.results = {}

            def submit(self, function, *arguments, key, pure, retries, **options):
                if key not in self.results:
                    self.results[key] = function(*arguments, **options)
                return key

            def gather(self, keys):
                return [self.results[key] for key in keys]

        cluster = Cluster()
        for folder in (self.folder / "a", self.folder / "b", self.folder / "a"):
            paths = sweep.run_on_dask(self.plan, cluster, folder, shards=3)
            self.assertEqual({Path(path).parent for path in paths}, {folder})
            sweep.merge(folder, self.folder / "merged.csv")
            self.assertEqual((self.folder / "merged.csv").read_text(), self.whole)
        self.assertEqual(len(cluster.results), 6)

    @unittest.skipUnless(importlib.util.find_spec("pyarrow"), "needs pyarrow")
    def test_parquet(self):
        import pyarrow.parquet

        path = self.folder / "plan.parquet"
        sweep.to_parquet(self.plan, path)
        self.assertEqual(sweep.read(path).hash, self.plan.hash)
        table = pyarrow.parquet.read_table(path)
        pyarrow.parquet.write_table(table.slice(1), path)
        with self.assertRaisesRegex(tl.ProblemError, "changed"):
            sweep.read(path)
        sweep.results_to_parquet(self.whole, path)
        table = pyarrow.parquet.read_table(path)
        self.assertEqual(table["length"].to_numpy()[7], sweep.columns(self.whole)["length"][7])
        with self.assertRaisesRegex(tl.ProblemError, "is no plan"):
            sweep.read(path)


def load_tests(loader, tests, pattern):
    import doctest

    tests.addTests(doctest.DocTestSuite(sweep))
    return tests


if __name__ == "__main__":
    unittest.main()
