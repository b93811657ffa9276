"""Reads a certificate, as `../FORMAT.md` describes it. Whatever the format does not name is refused."""

import itertools
import re
import struct

import numpy as np

FARTHEST = 1 << 28
NUMBER = r"-?\d+(?:\.\d+)?(?:e-?\d+)?"
NAME = r"[xs][1-9]\d*"


class Refused(Exception):
    """The certificate proves nothing, for this reason."""


def require(true, reason):
    if not true:
        raise Refused(reason)


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


def integer(word):
    require(re.fullmatch(r"0|-?[1-9]\d{0,17}", word, re.ASCII), f"{word[:60]!r} is no integer")
    return int(word)


def doubles(words):
    for word in words:
        require(re.fullmatch("[0-9a-f]{16}", word), f"{word[:60]!r} is not the bits of a double")
    values = np.array([struct.unpack(">d", bytes.fromhex(word))[0] for word in words])
    require(np.isfinite(values).all(), "a number is not finite")
    return values


class Formula:
    """The steps of a formula, to be evaluated on numbers with + - * / and methods for functions."""

    def __init__(self, lines, dimension):
        self.dimension, self.steps = dimension, []
        known = [f"x{i + 1}" for i in range(dimension)]
        for line in lines[:-1]:
            match = re.fullmatch(r"(s\d+)(?:, (s\d+))? = (.+);", line, re.ASCII)
            require(match, f"{line[:60]!r} is no step of a formula")
            names = [name for name in match.groups()[:2] if name]
            for name in names:
                require(name == f"s{len(known) - dimension + 1}", f"{name} is not the next step")
                known.append(name)
            step = self.step(match[3], len(names), known[: -len(names)])
            require(step, f"{match[3][:60]!r} is no operation on earlier steps")
            self.steps.append((names, step))
        match = re.fullmatch(r"\[(.*)\]", lines[-1], re.ASCII)
        require(match, "the last line of the formula is no matrix")
        self.entries = [row.split(", ") for row in match[1].split("; ")]
        square = [len(row) for row in self.entries] == [dimension] * dimension
        require(square and all(name in known for row in self.entries for name in row), "no matrix of steps")

    @staticmethod
    def step(text, count, known):
        def parse(pattern):
            match = re.fullmatch(pattern, text, re.ASCII)
            groups = match.groups() if match else ()
            names = [g for g in groups if re.fullmatch(NAME, g, re.ASCII)]
            return groups if match and all(name in known for name in names) else None

        if count == 2:
            found = parse(rf"(sin_cos|sinh_cosh)\(({NAME})\)")
            return found and (found[0], found[1])
        if found := parse(rf"number\(({NUMBER})\)"):
            return ("number", float(found[0])) if abs(float(found[0])) < np.inf else None
        if found := parse(rf"({NAME}) ([-+*/]) ({NAME}|{NUMBER})"):
            b = found[2] if found[2] in known else float(found[2])
            return (found[1], found[0], b) if b in known or abs(b) < np.inf else None
        if found := parse(rf"({NAME})\^(-?\d+)"):
            return ("power", found[0], int(found[1])) if abs(int(found[1])) <= 2**31 else None
        if found := parse(rf"-({NAME})"):
            return ("negative", found[0])
        functions = "sqr|recip|sqrt|exp|ln|sin|cos|tan|atan|sinh|cosh|tanh"
        return parse(rf"({functions})\(({NAME})\)")

    def __call__(self, x, constant):
        """The entries on and above the diagonal, which define the others."""
        values = {f"x{i + 1}": xi for i, xi in enumerate(x)}
        operators = {"+": "__add__", "-": "__sub__", "*": "__mul__", "/": "__truediv__"}
        for names, (what, *rest) in self.steps:
            if what == "number":
                results = [constant(rest[0])]
            elif what in operators:
                results = [getattr(values[rest[0]], operators[what])(values.get(rest[1], rest[1]))]
            elif what == "power":
                results = [values[rest[0]].powi(rest[1])]
            elif what == "negative":
                results = [-values[rest[0]]]
            else:
                results = [getattr(values[rest[0]], name)() for name in what.split("_")]
            values.update(zip(names, results))
        n = self.dimension
        return {(i, j): values[self.entries[i][j]] for i in range(n) for j in range(i, n)}


class Level:
    """Cubes (rows of places), their side, and for each node of a cube two values."""

    def __init__(self, exponent, cubes, values):
        self.exponent, self.side, self.cubes = exponent, 2.0**exponent, cubes
        self.dimension = cubes.shape[1]
        require(len(cubes), "a level has no cubes")
        self.low = cubes.min(axis=0)
        self.extent = cubes.max(axis=0) - self.low + 3
        require(np.prod(2.0 * self.extent + 3) < 2**62, "the cubes of a level are too far apart")
        _, self.nodes = self.numbers(2)
        found = self.nodes.max(initial=-1) + 1
        require(found == len(values), f"{len(values)} pairs of values for {found} nodes")
        self.values = [values[:, f][self.nodes] for f in (0, 1)]  # 3^D rows, a column for each cube
        self.keys = self.key(cubes, 1)

    def key(self, places, n):
        """A number for each place of the lattice of side/n, increasing lexicographically."""
        return np.ravel_multi_index(tuple((places - n * self.low + 1).T), tuple(n * self.extent + 3))

    def numbers(self, n):
        """The points from n k to n k + n of all cubes k, each once, and their numbers cube by cube."""
        offsets = np.array(list(itertools.product(range(n + 1), repeat=self.dimension)))
        keys = np.array([self.key(n * self.cubes + offset, n) for offset in offsets])
        keys, numbers = np.unique(keys, return_inverse=True)
        points = np.unravel_index(keys, tuple(n * self.extent + 3))
        return np.array(points) + (n * self.low - 1)[:, None], numbers.reshape(len(offsets), -1)

    def holds(self, places):
        """Whether there is a cube at each place."""
        near = ((places >= self.low - 1) & (places < self.low + self.extent)).all(axis=1)
        found = np.zeros(len(places), bool)
        found[near] = np.isin(self.key(places[near], 1), self.keys)
        return found


class Certificate:
    def __init__(self, text):
        lines = Lines(text)
        lines.next("tautline-distance 1")
        self.dimension = integer(lines.next(r"dimension (\S+)")[0])
        require(1 <= self.dimension <= 3, f"dimension {self.dimension}: only 1 to 3 can be checked")
        start = lines.at
        count = integer(lines.words("metric")[0])
        require(1 <= count <= len(lines.lines), "the formula has no lines")
        self.formula = Formula([lines.next("(.*)")[0] for _ in range(count)], self.dimension)
        self.sets = [self.read_set(lines, name) for name in ("from", "to")]
        self.hi = doubles(lines.words("hi"))[0]
        (kind, *bits), numbers = lines.words("region"), {"tubes": 2, "declared": 1, "exit-one": 0, "exit-two": 0}
        require(numbers.get(kind) == len(bits), "the region is none that the format names")
        self.region = (kind, *doubles(bits))
        self.statement = lines.lines[start + 1 : start + 1 + count]
        self.curve = None
        if lines.peek().startswith("curve "):
            count = integer(lines.words("curve")[0])
            self.curve = self.rows(lines, count, self.dimension)
        self.levels = []
        while lines.peek().startswith("level "):
            self.levels.append(self.read_level(lines))
        lines.next("end")
        require(lines.at == len(lines.lines), "there are lines after the end")

    @staticmethod
    def rows(lines, count, width):
        require(0 <= count <= len(lines.lines) - lines.at, "there are fewer lines than announced")
        rows = [line.split(" ") for line in lines.lines[lines.at : lines.at + count]]
        lines.at += count
        require(all(len(row) == width for row in rows), f"a row does not have {width} numbers")
        return doubles([word for row in rows for word in row]).reshape(count, width)

    def read_set(self, lines, name):
        pieces, n = [], self.dimension
        while lines.peek().startswith(name + " "):
            kind, *bits = lines.words(name)
            x = doubles(bits)
            sizes = {"point": n, "ball": n + 1, "box": 2 * n, "half-space": n + 1}
            valid = sizes.get(kind) == len(x)
            valid = valid and (kind != "ball" or x[n] >= 0) and (kind != "half-space" or x[:n].any())
            require(valid and (kind != "box" or (x[:n] <= x[n:]).all()), f"no valid set: {kind[:60]!r}")
            pieces.append((kind, x))
        require(pieces, f"there is no set {name!r}")
        return pieces

    def read_level(self, lines):
        numbers = [integer(word) for word in lines.words("level")]
        require(len(numbers) == 3 and -200 <= numbers[0] <= 200, "no level EXPONENT RUNS NODES")
        exponent, runs, nodes = numbers
        require(0 <= runs and 0 <= nodes <= len(lines.lines), "there are fewer lines than announced")
        cubes = []
        for _ in range(runs):
            *first, length = [integer(word) for word in lines.next("(.+)")[0].split(" ")]
            require(len(first) == self.dimension and 1 <= length <= nodes - len(cubes), "no run of cubes")
            cubes.extend((*first[:-1], first[-1] + step) for step in range(length))
        require(all(a < b for a, b in itertools.pairwise(cubes)), "the cubes are not in order")
        far = any(abs(k) > FARTHEST for cube in cubes for k in cube)
        require(not far, "a cube is too far from the origin")
        cubes = np.array(cubes, np.int64).reshape(len(cubes), self.dimension)
        return Level(exponent, cubes, self.rows(lines, nodes, 2))
