"""The formula of a metric, read as the steps in which it is printed."""

import re

import numpy as np

from refused import require

NUMBER = r"-?\d+(?:\.\d+)?(?:e-?\d+)?"
NAME = r"[xs][1-9]\d*"


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
        require(
            square and all(name in known for row in self.entries for name in row),
            "no matrix of steps",
        )

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
