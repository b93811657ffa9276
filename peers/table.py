"""The table of the comparison: its rows, as comma-separated values and in short as Markdown."""

from __future__ import annotations

import csv
from dataclasses import dataclass
from pathlib import Path

COLUMNS = (
    "problem",
    "n",
    "peer",
    "version",
    "seconds",
    "setup_seconds",
    "iterations",
    "energy",
    "residual",
    "converged",
    "ratio_to_tautline",
)


@dataclass
class Row:
    """One solve by one peer.  Times are of one processor, in seconds."""

    problem: str
    n: int
    peer: str
    version: str
    seconds: float | None = None
    set_up_seconds: float | None = None
    iterations: int | None = None
    energy: float | None = None
    residual: float | None = None
    converged: str = ""
    ratio_to_tautline: float | None = None

    def cells(self) -> list[str]:
        """The row as text, in the order of the columns."""
        return [
            self.problem,
            str(self.n),
            self.peer,
            self.version,
            written(self.seconds, ".2e"),
            written(self.set_up_seconds, ".2f"),
            written(self.iterations, "d"),
            written(self.energy, ".12g"),
            written(self.residual, ".1e"),
            self.converged,
            written(self.ratio_to_tautline, ".3g"),
        ]


def written(value: float | None, how: str) -> str:
    """A number in a format, or nothing."""
    return "" if value is None else format(value, how)


def write_csv(
    file: Path,
    shows: str,
    machine: str,
    limit: int,
    columns: tuple[str, ...],
    rows: list[list[str]],
) -> None:
    """Writes a table under a comment: what it shows, and where it was measured."""
    file.parent.mkdir(parents=True, exist_ok=True)
    with file.open("w", newline="") as output:
        output.write(f"# {file.stem}\n# {shows}\n# command: cargo xtask peers\n")
        output.write(f"# machine: {machine}; one thread, at most {limit} s for a solve\n")
        writer = csv.writer(output, lineterminator="\n")
        writer.writerow(columns)
        writer.writerows(rows)


def write(rows: list[Row], file: Path, machine: str, limit: int) -> None:
    """Writes the table and, beside it, the page."""
    shows = "the cost of a solve, beside its alternatives"
    write_csv(file, shows, machine, limit, COLUMNS, [row.cells() for row in rows])
    file.with_suffix(".md").write_text(page(rows, machine))


def page(rows: list[Row], machine: str) -> str:
    """The times of all peers side by side."""
    grids = sorted({row.n for row in rows})
    peers = list(dict.fromkeys(row.peer for row in rows))
    lines = [
        "Seconds of one processor for one solve, in brackets the ratio to Tautline's.",
        "*no*: the rule to stop is not fulfilled; *other*: another geodesic; a dash: no result.",
        "The reasons are in `peers.csv`.",
        "",
        f"Machine: {machine}.",
    ]
    for problem in dict.fromkeys(row.problem for row in rows):
        lines += ["", f"| {problem} | " + " | ".join(f"N = {n}" for n in grids) + " |"]
        lines.append("| --- |" + " ---: |" * len(grids))
        for peer in peers:
            found = {row.n: row for row in rows if (row.problem, row.peer) == (problem, peer)}
            cells = [cell(found[n]) if n in found else "" for n in grids]
            lines.append(f"| {peer} | " + " | ".join(cells) + " |")
    return "\n".join(lines) + "\n"


def cell(row: Row) -> str:
    """A time, its ratio, and what is wrong with the result."""
    if row.seconds is None:
        return "–"
    text = written(row.seconds, ".1e")
    if row.ratio_to_tautline is not None:
        # Two digits, and no exponent.
        text += f" ({float(f'{row.ratio_to_tautline:.1e}'):g})"
    if row.converged == "another geodesic":
        return text + " *other*"
    return text if row.converged == "yes" else text + " *no*"
