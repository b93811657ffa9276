"""Sweeps: many problems that differ in parameters, in blocks that any engine may run.

A sweep file is a problem file with a section [sweep]. From it follow the problems, numbered from 0:

>>> from tautline_geodesics import sweep
>>> plan = sweep.Plan('''
... [parameters]
... y = 0
... [metric]
... cost = "2 - cos(x1)"
... [from]
... point = [0, "y"]
... [to]
... point = [3, 0]
... [solve]
... n = 32
... [sweep.vary]
... y = { from = 0, to = 1, count = 5 }
... ''')
>>> len(plan), plan.rows(1, 3).tolist()
(5, [[0.25], [0.5]])
>>> results = sweep.merged([plan.solved(0, 2), plan.solved(2, 5)])
>>> results == plan.solved(0, 5)
True
>>> sweep.columns(results)["status"].tolist()
['solved', 'solved', 'solved', 'solved', 'solved']

`run_shard` writes a block to a file, `run_on_dask` lets a Dask cluster do so, `Batch` is a function for
`map_batches` of Ray Data, and `merge` joins the files. The bytes are the same, whoever computed them,
and those of the command `tautline run`.
"""

from __future__ import annotations

import csv
import hashlib
import os
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from ._convert import refuse_masked
from ._draft import write
from ._tautline import Plan, ProblemError, is_finished, merged, shard

__all__ = [
    "Batch",
    "Plan",
    "columns",
    "merge",
    "merged",
    "read",
    "results_to_parquet",
    "run_on_dask",
    "run_shard",
    "to_parquet",
]

# The columns of results that are no floating-point numbers.
_INTEGERS = ("id", "chords", "newton_steps", "other_minima")
_TEXTS = ("stop", "hessian", "status", "reason")


def read(path: str | os.PathLike[str]) -> Plan:
    """The plan of a sweep file, of a table that `tautline plan` wrote, or of one by `to_parquet`.

    Files with tables of numbers, which the sweep file names, are found from the folder of this path."""
    folder = Path(path).absolute().parent
    if Path(path).suffix == ".parquet":
        import pyarrow.parquet  # type: ignore[import-untyped, import-not-found, unused-ignore]

        table = pyarrow.parquet.read_table(path)
        metadata = table.schema.metadata or {}
        if b"tautline_sweep" not in metadata:
            raise ProblemError(f"{os.fspath(path)} is no plan")
        file, hash = (metadata.get(key, b"").decode() for key in (b"tautline_sweep", b"tautline_hash"))
        plan = Plan(file, folder, hash)
        ids, *parameters = (table[name].to_numpy() for name in ("id", *plan.names))
        if not np.array_equal(ids, np.arange(len(plan))) or not np.array_equal(
            np.column_stack(parameters), plan.rows(0, len(plan))
        ):
            raise ProblemError(f"{os.fspath(path)} was changed: its rows are not those of its sweep")
        return plan
    return Plan(Path(path).read_bytes().decode(), folder)


def to_parquet(plan: Plan, path: str | os.PathLike[str]) -> None:
    """Writes the table of a plan, with the sweep file in its metadata. Needs pyarrow."""
    values = plan.rows(0, len(plan))
    table = {"id": np.arange(len(plan))} | {name: values[:, i] for i, name in enumerate(plan.names)}
    metadata = {"tautline_sweep": plan.file, "tautline_hash": plan.hash}
    _parquet(table, metadata, path)


def results_to_parquet(results: str, path: str | os.PathLike[str]) -> None:
    """Writes results as they are in `columns`, with the hash of their plan in the metadata.

    Needs pyarrow."""
    _parquet(columns(results), {"tautline_hash": _line(results, "# plan ")}, path)


def columns(results: str) -> dict[str, np.ndarray]:
    """The columns of results as arrays. Numbers that are missing are NaN, or -1 for whole ones."""
    lines = [line for line in results.splitlines() if not line.startswith("#")]
    names, *rows = csv.reader(lines)
    return _typed(names, rows)


def run_shard(
    plan: Plan, k: int, n: int, folder: str | os.PathLike[str], *, threads: int = 1
) -> str:
    """Solves the k-th of n blocks, from 1, into a file of `folder`, and returns its path.

    A block that is complete there is not done again. The file appears once it is complete and on the
    disk. `threads` is 0 for one on each processor.
    """
    start, end, name = shard(k, n, len(plan))
    path = Path(folder, name)
    if path.exists():
        try:
            if is_finished(plan, path.read_bytes().decode(), start, end):
                return str(path)
        except (ProblemError, UnicodeDecodeError) as error:
            raise ProblemError(f"{path}: {error}") from None
    path.parent.mkdir(parents=True, exist_ok=True)
    write(path, plan.solved(start, end, threads))
    return str(path)


def merge(
    results: str | os.PathLike[str] | Iterable[str | os.PathLike[str]],
    output: str | os.PathLike[str],
) -> None:
    """Joins files of results, or all .csv files of a folder, to one file.

    Raises `ProblemError` unless every problem of one plan is there once; the message has the ids.
    """
    if isinstance(results, (str, os.PathLike)):
        results = sorted(Path(results).glob("[!.]*.csv"))
    write(Path(output), merged([Path(path).read_bytes().decode() for path in results]))


def run_on_dask(
    plan: Plan,
    client: Any,
    folder: str | os.PathLike[str],
    *,
    shards: int,
    threads: int = 1,
    retries: int = 3,
) -> list[str]:
    """Runs all blocks on the workers of a Dask client, and returns the paths of their files.

    `folder` must be one that all workers see. A block whose worker dies is done by another one; after a
    crash of everything, call it again: finished blocks are not done again. `merge` joins the files.
    """
    folder = str(Path(folder).absolute())
    # The same sweep in another folder is other work.
    work = hashlib.sha256(f"{plan.hash} {folder}".encode()).hexdigest()[:16]
    futures = [
        client.submit(
            run_shard,
            plan,
            k,
            shards,
            folder,
            threads=threads,
            key=f"tautline-{work}-{k}-of-{shards}",
            pure=False,
            retries=retries,
        )
        for k in range(1, shards + 1)
    ]
    paths: list[str] = client.gather(futures)
    return paths


class Batch:
    """A function for `map_batches` of Ray Data: ids in, results out.

    `ray.data.range(len(plan)).map_batches(Batch(plan))` is a data set with the columns of the results.
    With `lines` its columns are the id and the row as text, of which `plan.results` makes the file that
    `tautline run` writes, given the rows in the order of the ids.
    """

    def __init__(self, plan: Plan, *, threads: int = 1, lines: bool = False) -> None:
        self.plan, self.threads, self.lines = plan, threads, lines
        # The names of the columns, from results without rows.
        self.names = [*columns(plan.solved(0, 0))]

    def __call__(self, batch: Mapping[str, Any]) -> dict[str, np.ndarray]:
        """The results of the problems whose ids are in the column `id` of a batch."""
        refuse_masked(batch["id"], "the column id")
        ids = np.asarray(batch["id"])
        lines = self.plan.lines(ids.tolist(), self.threads)
        if self.lines:
            return {"id": ids, "line": np.array(lines, object)}
        return _typed(self.names, list(csv.reader(lines)))


def _typed(names: Sequence[str], rows: Sequence[Sequence[str]]) -> dict[str, np.ndarray]:
    table: dict[str, np.ndarray] = {}
    for name, column in zip(names, zip(*rows) if rows else [()] * len(names)):
        if name in _INTEGERS:
            table[name] = np.array([int(text) if text else -1 for text in column], np.int64)
        elif name in _TEXTS:
            table[name] = np.array(column, object)
        else:
            table[name] = np.array([float(text) if text else np.nan for text in column])
    return table


def _line(results: str, begin: str) -> str:
    return next(line[len(begin) :] for line in results.splitlines() if line.startswith(begin))


def _parquet(
    table: Mapping[str, np.ndarray], metadata: Mapping[str, str], path: str | os.PathLike[str]
) -> None:
    import pyarrow
    import pyarrow.parquet

    found = pyarrow.table(dict(table)).replace_schema_metadata(dict(metadata))
    sink = pyarrow.BufferOutputStream()
    pyarrow.parquet.write_table(found, sink)
    write(Path(path), sink.getvalue().to_pybytes())
