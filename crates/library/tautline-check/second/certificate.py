"""Reads a certificate, as `../FORMAT.md` describes it; whatever it does not name is refused."""

import hashlib
import itertools
import math
import re
from fractions import Fraction

import numpy as np

from formula import Formula
from level import Level
from refused import require
from table import Table

# The greatest coordinate of a cube, in sides.
FARTHEST = 1 << 28

MOST_TABLES, MOST_LINES = 1024, 500_000


class Lines:
    def __init__(self, text):
        require(text.isascii() and text.endswith("\n"), "the file is no text of whole lines")
        self.lines, self.at = text[:-1].split("\n"), 0

    def peek(self):
        return self.lines[self.at] if self.at < len(self.lines) else ""

    def next(self, pattern):
        """The groups of the next line, which has to have this form."""
        line = self.peek()
        match = re.fullmatch(pattern, line, re.ASCII)
        require(match, f"line {self.at + 1}: {line[:60]!r} where {pattern[:60]!r} should be")
        self.at += 1
        return match.groups()

    def words(self, first):
        return self.next(f"{first} (.+)")[0].split(" ")

    def word(self, first):
        return self.next(f"{first} ([^ ]+)")[0]


def integer(word):
    require(re.fullmatch(r"0|-?[1-9]\d{0,17}", word, re.ASCII), f"{word[:60]!r} is no integer")
    return int(word)


def doubles(words):
    for word in words:
        require(re.fullmatch("[0-9a-f]{16}", word), f"{word[:60]!r} is not the bits of a double")
    values = np.frombuffer(bytes.fromhex("".join(words)), ">f8").astype(float)
    require(np.isfinite(values).all(), "a number is not finite")
    return values


def is_half_space(normal, offset):
    """Whether there is a normal, and the offset is at most 2^1000 times as large. Both are exact."""
    largest = Fraction(np.abs(normal).max())
    return largest > 0 and abs(Fraction(offset)) <= 2**1000 * largest


class Certificate:
    def __init__(self, text):
        lines = Lines(text)
        lines.next("tautline-distance 1")
        self.dimension = integer(lines.next(r"dimension (\S+)")[0])
        require(1 <= self.dimension <= 4, f"dimension {self.dimension}: only 1 to 4 can be checked")
        # The number of doubles and of lines of the formula, by which the work is limited.
        self.size = 0
        tables, self.statement = [], []
        while lines.peek().startswith("table "):
            require(len(tables) < MOST_TABLES, f"there are more than {MOST_TABLES} tables")
            tables.append(self.read_table(lines))
            shape, numbers = tables[-1].coefficients.shape, tables[-1].coefficients
            digest = hashlib.sha256(numbers.astype("<f8").tobytes()).hexdigest()
            self.statement.append(f"table {' '.join(map(str, shape))} sha256 {digest}")
        require(len(set(self.statement)) == len(tables), "two tables are equal")
        start = lines.at
        count = integer(lines.word("metric"))
        require(1 <= count <= len(lines.lines), "the formula has no lines")
        require(count <= MOST_LINES, f"the formula has more than {MOST_LINES} lines")
        self.formula = Formula(
            [lines.next("(.*)")[0] for _ in range(count)], self.dimension, tables
        )
        self.size += count
        self.sets = [self.read_set(lines, name) for name in ("from", "to")]
        self.hi = doubles([lines.word("hi")])[0]
        (kind, *bits), numbers = (
            lines.words("region"),
            {"tubes": 2, "declared": 1, "exit-one": 0, "exit-two": 0},
        )
        require(numbers.get(kind) == len(bits), "the region is none that the format names")
        self.region = (kind, *doubles(bits))
        self.size += 1 + len(bits)
        self.statement += lines.lines[start + 1 : start + 1 + count]
        self.curve = None
        if lines.peek().startswith("curve "):
            count = integer(lines.word("curve"))
            self.curve = self.rows(lines, count, self.dimension)
        self.levels = []
        while lines.peek().startswith("level "):
            self.levels.append(self.read_level(lines))
        lines.next("end")
        require(lines.at == len(lines.lines), "there are lines after the end")

    def rows(self, lines, count, width):
        require(0 <= count <= len(lines.lines) - lines.at, "there are fewer lines than announced")
        rows = lines.lines[lines.at : lines.at + count]
        # A line of another length has another number of numbers, whatever they are.
        good = all(len(row) == 17 * width - 1 for row in rows)
        require(good, f"a row does not have {width} numbers")
        lines.at += count
        self.size += count * width
        return doubles([word for row in rows for word in row.split(" ")]).reshape(count, width)

    def read_table(self, lines):
        shape = [integer(word) for word in lines.words("table")]
        valid = 1 <= len(shape) <= 3 and all(length > 0 for length in shape)
        require(valid, "a table has one to three lengths")
        numbers = self.rows(lines, math.prod(shape[:-1]), shape[-1])
        require((np.abs(numbers) <= 2.0**1000).all(), "a number of a table is too large")
        return Table(numbers.reshape(shape))

    def read_set(self, lines, name):
        pieces, n = [], self.dimension
        while lines.peek().startswith(name + " "):
            kind, *bits = lines.words(name)
            x = doubles(bits)
            self.size += len(x)
            sizes = {"point": n, "ball": n + 1, "box": 2 * n, "half-space": n + 1}
            valid = sizes.get(kind) == len(x)
            valid = valid and (
                kind == "point"
                or (kind == "ball" and x[n] >= 0)
                or (kind == "box" and (x[:n] <= x[n:]).all())
                or (kind == "half-space" and is_half_space(x[:n], x[n]))
            )
            require(valid, f"no valid set: {kind[:60]!r}")
            pieces.append((kind, x))
        require(pieces, f"there is no set {name!r}")
        return pieces

    def read_level(self, lines):
        numbers = [integer(word) for word in lines.words("level")]
        require(len(numbers) == 3 and -200 <= numbers[0] <= 200, "no level EXPONENT RUNS NODES")
        exponent, runs, nodes = numbers
        require(
            0 <= runs and 0 <= nodes <= len(lines.lines), "there are fewer lines than announced"
        )
        cubes = []
        for _ in range(runs):
            *first, length = [integer(word) for word in lines.next("(.+)")[0].split(" ")]
            require(
                len(first) == self.dimension and 1 <= length <= nodes - len(cubes),
                "no run of cubes",
            )
            cubes.extend((*first[:-1], first[-1] + step) for step in range(length))
        require(all(a < b for a, b in itertools.pairwise(cubes)), "the cubes are not in order")
        far = any(abs(k) > FARTHEST for cube in cubes for k in cube)
        require(not far, "a cube is too far from the origin")
        cubes = np.array(cubes, np.int64).reshape(len(cubes), self.dimension)
        return Level(exponent, cubes, self.rows(lines, nodes, 2))
