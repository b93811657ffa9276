"""Files of sweeps, and the tasks that go to other machines."""

import importlib.util
import pathlib
import tempfile
import unittest
from unittest import mock

import numpy as np
from test_sweep import FILE

import tautline_geodesics as tl
from tautline_geodesics import sweep

needs_pyarrow = unittest.skipUnless(importlib.util.find_spec("pyarrow"), "needs pyarrow")


class Client:
    """A cluster that computes at once."""

    def __init__(self):
        self.keys = []

    def submit(self, function, *arguments, key, **_):
        self.keys.append(key)
        return function(*arguments)

    def gather(self, found):
        return found


class Counted:
    """A plan that notes the numbers of threads."""

    def __init__(self):
        self.plan, self.threads = sweep.Plan(FILE), []

    def __len__(self):
        return len(self.plan)

    def solved(self, start, end, threads=None):
        self.threads.append(threads)
        return self.plan.solved(start, end)

    def lines(self, ids, threads=None):
        self.threads.append(threads)
        return self.plan.lines(ids)


class Files(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def test_tables_are_found_from_the_folder_of_the_file(self):
        np.save(self.folder / "h.npy", np.ones((3, 3)))
        file = FILE.replace("height*exp", "h(x1, x2)*height*exp")
        path = self.folder / "a.toml"
        path.write_text(file.replace("[metric]", '[tables.h]\nfile = "h.npy"\n[metric]'))
        self.assertEqual(len(sweep.read(path)), 15)

    @needs_pyarrow
    def test_a_parquet_file_of_results_names_its_plan(self):
        import pyarrow.parquet

        plan, path = sweep.Plan(FILE), self.folder / "results.parquet"
        sweep.results_to_parquet(plan.solved(0, 15), path)
        metadata = pyarrow.parquet.read_schema(path).metadata
        self.assertEqual(metadata[b"tautline_hash"].decode(), plan.hash)

    @needs_pyarrow
    def test_a_parquet_plan_with_another_row_or_another_hash_is_refused(self):
        import pyarrow
        from pyarrow import parquet

        plan, path = sweep.Plan(FILE), self.folder / "plan.parquet"
        sweep.to_parquet(plan, path)
        table = parquet.read_table(path)
        y = table["y"].to_numpy().copy()
        y[7] += 1
        place = table.column_names.index("y")
        parquet.write_table(table.set_column(place, "y", pyarrow.array(y)), path)
        with self.assertRaisesRegex(tl.ProblemError, "changed"):
            sweep.read(path)
        other = table.schema.metadata | {b"tautline_hash": b"0" * 64}
        parquet.write_table(table.replace_schema_metadata(other), path)
        with self.assertRaises(tl.ProblemError):
            sweep.read(path)

    def test_a_cluster_gets_every_shard_once_under_a_key_of_its_own(self):
        plan, client = sweep.Plan(FILE), Client()
        shards = sweep.run_on_dask(plan, client, self.folder, shards=4)
        sweep.merge(shards, self.folder / "all")
        self.assertEqual((self.folder / "all").read_text(), plan.solved(0, 15))
        self.assertEqual(len(set(client.keys)), 4)
        # Those of another plan differ.
        keys = []
        noting = mock.Mock(submit=lambda *_, key, **__: keys.append(key))
        for text in (FILE, FILE.replace("n = 16", "n = 8")):
            sweep.run_on_dask(sweep.Plan(text), noting, "folder", shards=2)
        self.assertEqual(len(set(keys)), 4)

    def test_the_number_of_threads_arrives(self):
        plan = Counted()
        sweep.run_shard(plan, 1, 3, self.folder, threads=7)
        sweep.Batch(plan, threads=8)({"id": np.arange(2)})
        self.assertEqual((plan.threads[0], plan.threads[-1]), (7, 8))

    def test_a_missing_whole_number_is_minus_one(self):
        # The problem with the id 12 fails.
        columns = sweep.columns(sweep.Plan(FILE).solved(0, 15))
        self.assertEqual(columns["newton_steps"][12], -1)


if __name__ == "__main__":
    unittest.main()
