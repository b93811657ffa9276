"""The formula of a metric, read as the steps in which it is printed."""

import re

import numpy as np

from refused import require
from table import tabulated

NUMBER = r"-?\d+(?:\.\d+)?(?:e-?\d+)?"
NAME = r"[xs][1-9]\d*"

# The most memory for the values of steps on a batch of boxes, and the most boxes in one.
MOST_BYTES, MOST_BOXES = 1 << 27, 1 << 13


class Formula:
    """The steps of a formula, to be evaluated on numbers with + - * / and methods for functions."""

    def __init__(self, lines, dimension, tables=()):
        self.dimension, self.steps, self.tables = dimension, [], tables
        called, known = {}, {f"x{i + 1}" for i in range(dimension)}
        for line in lines[:-1]:
            match = re.fullmatch(r"(s\d+)(?:, (s\d+))? = (.+);", line, re.ASCII)
            require(match, f"{line[:60]!r} is no step of a formula")
            names = [name for name in match.groups()[:2] if name]
            step = self.step(match[3], len(names), known)
            if not step and len(names) == 1:
                step = self.call(match[3], known)
                called.update({step[1]: None} if step else {})
            require(step, f"{match[3][:60]!r} is no operation on earlier steps")
            for name in names:
                following = f"s{len(known) - dimension + 1}"
                require(name == following, f"{name[:60]} is not the next step")
                known.add(name)
            self.steps.append((names, step))
        in_order = list(called) == list(range(len(tables)))
        require(in_order, "the tables are not those that the formula calls, in the order of calls")
        match = re.fullmatch(r"\[(.*)\]", lines[-1], re.ASCII)
        require(match, "the last line of the formula is no matrix")
        self.entries = [row.split(", ") for row in match[1].split("; ")]
        square = [len(row) for row in self.entries] == [dimension] * dimension
        require(
            square and all(name in known for row in self.entries for name in row),
            "no matrix of steps",
        )
        # The entry ij is the same step as ji, so that H is one matrix with one domain.
        transposed = [list(column) for column in zip(*self.entries)]
        require(self.entries == transposed, "the matrix is not symmetric")
        self.drop_after_last_use()
        # What an evaluation costs, in the units of FORMAT.md.
        self.weight = 1 + sum(map(self.weight_of, self.steps))

    def weight_of(self, named_step):
        _, (what, *rest) = named_step
        if what == "table":
            return 4 ** (len(rest[2]) + 1)
        if what == "power":
            return max(1, abs(rest[1]).bit_length())
        cheap = ("number", "negative", "sqr", "recip", "+", "-", "*", "/")
        return 1 if what in cheap else 4

    def drop_after_last_use(self):
        """Finds after which steps which values are not read any more, and how many there are."""
        read = {name for row in self.entries for name in row}
        self.unread_after = [[] for _ in self.steps]
        for at in reversed(range(len(self.steps))):
            names, step = self.steps[at]
            require(read.intersection(names), f"no entry of the matrix needs {names[0]}")
            arguments = set(step[3]) if step[0] == "table" else set(step[1:])
            last = {name for name in arguments if isinstance(name, str)} - read
            self.unread_after[at] = [*last, *(name for name in names if name not in read)]
            read |= last
        self.most_values = live = self.dimension
        for (names, _), unread in zip(self.steps, self.unread_after):
            live += len(names)
            self.most_values = max(self.most_values, live)
            live -= len(unread)

    def batch(self, parts):
        """How many boxes to evaluate together, if a value has so many intervals."""
        return int(np.clip(MOST_BYTES // (16 * parts * self.most_values), 1, MOST_BOXES))

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
        if found := parse(rf"({NAME})\^(0|-?[1-9]\d{{0,9}})"):
            return ("power", found[0], int(found[1])) if -(2**31) <= int(found[1]) < 2**31 else None
        if found := parse(rf"-({NAME})"):
            return ("negative", found[0])
        functions = "sqr|recip|sqrt|exp|ln|sin|cos|tan|atan|sinh|cosh|tanh"
        return parse(rf"({functions})\(({NAME})\)")

    def call(self, text, known):
        """A step such as table1(s1, x2) or table1_10(s1, x2): the number, the orders, the names."""
        pattern = rf"table([1-9]\d{{0,8}})(?:_([012]{{1,3}}))?\(({NAME}(?:, {NAME})*)\)"
        match = re.fullmatch(pattern, text, re.ASCII)
        if not match or int(match[1]) > len(self.tables):
            return None
        number, names = int(match[1]) - 1, match[3].split(", ")
        axes = self.tables[number].coefficients.ndim
        orders = tuple(map(int, match[2] or "0" * axes))
        if len(names) != axes or len(orders) != axes or not all(name in known for name in names):
            return None
        return ("table", number, orders, names)

    def __call__(self, x, constant):
        """The entries on and above the diagonal, which define the others."""
        values = {f"x{i + 1}": xi for i, xi in enumerate(x)}
        operators = {"+": "__add__", "-": "__sub__", "*": "__mul__", "/": "__truediv__"}
        for (names, (what, *rest)), unread in zip(self.steps, self.unread_after):
            if what == "number":
                results = [constant(rest[0])]
            elif what in operators:
                results = [getattr(values[rest[0]], operators[what])(values.get(rest[1], rest[1]))]
            elif what == "power":
                results = [values[rest[0]].powi(rest[1])]
            elif what == "negative":
                results = [-values[rest[0]]]
            elif what == "table":
                number, orders, arguments = rest
                u = [values[name] for name in arguments]
                results = [tabulated(self.tables[number], orders, u)]
            else:
                results = [getattr(values[rest[0]], name)() for name in what.split("_")]
            values.update(zip(names, results))
            for name in unread:
                del values[name]
        n = self.dimension
        return {(i, j): values[self.entries[i][j]] for i in range(n) for j in range(i, n)}
