"""Certificates by chance, honest and changed: python3 campaign.py FOLDER [SEED [COUNT]].

Each goes to a file of the folder, and a line tells what this checker says of it: the number of the
file, `accepted` with the lower bound and the number of cubes that are kept or `refused`, and what it
is. Ends with an error if anything false is accepted: a lower bound above the distance, an upper bound
below it, or a curve that leaves the domain of the metric.
"""

import itertools
import math
import random
import sys
from pathlib import Path

import numpy as np

from certificate import Certificate
from check import check, following
from formula import Formula
from intervals import of
from level import Level
from metric import gram
from refused import Refused
from region import required_cubes
from sweep import Sweep
from table import Table

# Two checkers round differently: a certificate keeps a little more than it has to.
MARGIN = 1 + 1e-12

# The most cubes of a first level, by dimension.
MOST = {1: 60, 2: 500, 3: 400, 4: 100}


def bits(*numbers):
    return " ".join(
        np.array(numbers, ">f8").tobytes().hex()[16 * i :][:16] for i in range(len(numbers))
    )


def number(x):
    """As formulas print it."""
    text = repr(float(x))
    mantissa, _, power = text.partition("e")
    return f"{mantissa}e{int(power)}" if power else text


class Metric:
    """Lines of a formula with a lower bound c1 on its eigenvalues, if there is one."""

    def __init__(self, lines, dimension, c1, tables=(), constant=None):
        self.lines, self.dimension, self.c1, self.tables = lines, dimension, c1, list(tables)
        self.constant = constant
        self.formula = Formula(lines, dimension, [Table(t) for t in self.tables])

    def at(self, points):
        """H at points, with NaN where it is undefined."""
        n, h = self.dimension, gram(self.formula, [of(x) for x in points.T])
        full = np.empty((len(points), n, n))
        for (i, j), e in h.items():
            full[:, i, j] = full[:, j, i] = 0.5 * (e.lo + e.hi)
        return full

    def on_polygon(self, points, samples=200):
        """The length of a polygon, about, and whether H is positive definite wherever it was tried."""
        s = (np.arange(samples) + 0.5) / samples
        length, good = 0.0, True
        for a, b in zip(points, points[1:]):
            tried = np.vstack([[a], a + s[:, None] * (b - a), [b]])
            h = self.at(tried)
            good &= bool(np.isfinite(h).all() and (np.linalg.eigvalsh(np.nan_to_num(h)) > 0).all())
            speed = np.einsum("i,nij,j->n", b - a, h[1:-1], b - a)
            length += float(np.mean(np.sqrt(np.maximum(np.nan_to_num(speed), 0))))
        return length, good


def matrix(rows):
    return "[" + "; ".join(", ".join(row) for row in rows) + "]"


def diagonal(n, entry, zero):
    return matrix([[entry if i == j else zero for j in range(n)] for i in range(n)])


def constant(chance, n):
    a = np.round(np.array([[chance.uniform(-1, 1) for _ in range(n)] for _ in range(n)]), 2)
    h = np.round(a @ a.T + np.eye(n), 3)
    lines, names = [], {}
    for i, j in itertools.combinations_with_replacement(range(n), 2):
        x = float(h[i, j]) + 0.0
        if x not in names:
            names[x] = f"s{len(names) + 1}"
            lines.append(f"{names[x]} = number({number(x)});")
    rows = [[names[float(h[i, j]) + 0.0] for j in range(n)] for i in range(n)]
    c1 = 0.99 * float(np.linalg.eigvalsh(h)[0])
    return Metric([*lines, matrix(rows)], n, c1, constant=h)


def wave(chance, n):
    """1 + a sin(k x₁) on the diagonal, and a part of it beside."""
    a, k = round(chance.uniform(0.05, 0.6), 2), round(chance.uniform(0.5, 4), 2)
    pair = chance.choice(["sin", "cos"])
    lines = [
        f"s1 = x1 * {number(k)};",
        f"s2 = {pair}(s1);",
        f"s3 = s2 * {number(a)};",
        "s4 = s3 + 1.0;",
    ]
    if n == 1:
        return Metric([*lines, "[s4]"], n, 0.99 * (1 - a))
    lines += ["s5 = s2 * 0.1;"] + ["s6 = number(0.0);"] * (n > 2)
    rows = [["s4" if i == j else "s5" if i + j == 1 else "s6" for j in range(n)] for i in range(n)]
    return Metric([*lines, matrix(rows)], n, 0.99 * (0.9 - a))


def bump(chance, n, depth=None):
    """1 + depth exp(−k|x|²) on the diagonal: a pocket where H is not positive if depth < −1."""
    k = round(chance.uniform(3, 40), 1)
    depth = round(chance.uniform(-0.8, 2), 2) if depth is None else depth
    lines = [f"s{i + 1} = sqr(x{i + 1});" for i in range(n)]
    last = n
    total = "s1"
    for i in range(1, n):
        last += 1
        lines.append(f"s{last} = {total} + s{i + 1};")
        total = f"s{last}"
    steps = [f"{total} * {number(-k)}", f"exp(s{last + 1})", f"s{last + 2} * {number(depth)}"]
    steps += [f"s{last + 3} + 1.0", f"s{last + 2} * -0.5", f"s{last + 5} + 1.0", "number(0.0)"]
    lines += [f"s{last + 1 + i} = {step};" for i, step in enumerate(steps)]
    deep, shallow, zero = f"s{last + 4}", f"s{last + 6}", f"s{last + 7}"
    if n == 1:
        return Metric([*lines[:-3], f"[{deep}]"], n, 0.99 * min(1, 1 + depth))
    rows = [[zero] * n for _ in range(n)]
    for i in range(n):
        rows[i][i] = deep if i == n - 1 else shallow
    return Metric([*lines, matrix(rows)], n, 0.99 * min(0.5, 1 + depth))


def pocket(chance, n):
    return bump(chance, n, round(chance.uniform(-4, -1.05), 2))


def pole(chance, n):
    """1 + a/x₁², or a quotient that cancels but is undefined at x₁ = 0."""
    kind, a = chance.choice(["square", "cancelled", "power"]), round(chance.uniform(0.01, 0.3), 2)
    lines = {
        "square": ["sqr(x1)", f"number({number(a)})", "s2 / s1", "s3 + 1.0"],
        "cancelled": ["recip(x1)", "s1 * x1", f"s2 * {number(a)}", "s3 + 1.0"],
        "power": ["recip(x1)", "s1^0", f"s2 * {number(a)}", "s3 + 1.0"],
    }[kind]
    lines = [f"s{i + 1} = {step};" for i, step in enumerate(lines)]
    lines += ["s5 = number(0.0);"] * (n > 1)
    return Metric([*lines, diagonal(n, "s4", "s5")], n, 0.99)


def tabled(chance, n):
    """1 + a positive multiple of a table, or of one of its derivatives."""
    axes = chance.randint(1, min(n, 2))
    shape = [chance.randint(1, 5) for _ in range(axes)]
    table = np.round(np.array([chance.uniform(0, 1) for _ in range(math.prod(shape))]), 3).reshape(
        shape
    )
    orders = [chance.choice([0, 0, 1, 2]) for _ in range(axes)]
    call = "table1" + (f"_{''.join(map(str, orders))}" if any(orders) else "")
    arguments = ", ".join(f"x{i + 1}" for i in range(axes))
    # Differences of numbers in [0, 1] of these orders are at most 2^order.
    factor = round(0.5 / 2 ** sum(orders), 3)
    lines = [f"s1 = {call}({arguments});", f"s2 = s1 * {number(factor)};", "s3 = s2 + 1.0;"]
    lines += ["s4 = number(0.0);"] * (n > 1)
    return Metric([*lines, diagonal(n, "s3", "s4")], n, 0.45, [table])


FAMILIES = [constant, constant, wave, bump, pocket, pocket, pole, tabled, tabled]


class Sets:
    """Pieces with a point of each set where a curve may end, and distances."""

    def __init__(self, chance, n, start, end):
        self.ends, self.pieces, self.on_boundary = [], [], chance.random() < 0.4
        for x, away in ((start, start - end), (end, end - start)):
            pieces, point = self.piece(chance, n, x, away)
            if chance.random() < 0.3:
                more = self.piece(chance, n, x + 0.1 * away, away)[0]
                pieces = chance.choice([pieces + more, more + pieces])
            self.pieces.append(pieces)
            self.ends.append(point)
        if all(any(kind == "half-space" for kind, _ in p) for p in self.pieces):
            self.pieces[0], self.ends[0] = [("point", start)], start

    def piece(self, chance, n, x, away):
        kind = chance.choice(["point", "point", "ball", "ball", "box", "half-space"])
        r = chance.choice([0.0, 0.05, 0.1, 0.3]) * np.linalg.norm(away)
        unit = away / np.linalg.norm(away)
        if kind == "ball":
            # Along an axis, the end is a point of the boundary in doubles, too.
            axis = int(np.argmax(np.abs(unit)))
            point = x.copy()
            if self.on_boundary:
                point[axis] = x[axis] - math.copysign(r, unit[axis])
            return [("ball", np.append(x, r))], point
        if kind == "box":
            half = np.array([r * chance.choice([0, 0.5, 1]) for _ in range(n)])
            low, high = x - half, x + half
            return [("box", np.append(low, high))], (
                np.where(unit > 0, low, high) if self.on_boundary else x
            )
        if kind == "half-space":
            axis = int(np.argmax(np.abs(unit)))
            normal = np.zeros(n)
            normal[axis] = -math.copysign(chance.choice([1.0, 0.75, 3.0]), unit[axis])
            if not self.on_boundary:
                normal += np.round(0.1 * np.array([chance.uniform(-1, 1) for _ in range(n)]), 3)
            return [
                (
                    "half-space",
                    np.append(normal, float(normal @ x) + (0 if self.on_boundary else 1e-3)),
                )
            ], x
        return [("point", x)], x

    @staticmethod
    def distances(pieces, points):
        """About, from each point to the nearest piece."""
        found, n = np.full(len(points), np.inf), points.shape[1]
        for kind, s in pieces:
            if kind == "half-space":
                d = np.maximum(points @ s[:n] - s[n], 0) / np.linalg.norm(s[:n])
            elif kind == "box":
                d = np.linalg.norm(
                    np.maximum(0, np.maximum(s[:n] - points, points - s[n:])), axis=1
                )
            else:
                d = np.linalg.norm(points - s[:n], axis=1) - (s[n] if kind == "ball" else 0)
            found = np.minimum(found, np.maximum(d, 0))
        return found


class Made:
    """A certificate as data, to be changed and written."""

    def __init__(self, metric, pieces, hi, region, curve, levels):
        self.metric, self.pieces, self.hi, self.region = metric, pieces, hi, region
        self.curve, self.levels = curve, levels

    def text(self):
        lines = ["tautline-distance 1", f"dimension {self.metric.dimension}"]
        for table in self.metric.tables:
            lines.append("table " + " ".join(map(str, table.shape)))
            lines += [bits(*row) for row in table.reshape(-1, table.shape[-1])]
        lines += [f"metric {len(self.metric.lines)}", *self.metric.lines]
        for name, pieces in zip(("from", "to"), self.pieces):
            lines += [f"{name} {kind} {bits(*numbers)}" for kind, numbers in pieces]
        kind, *numbers = self.region
        lines += [f"hi {bits(self.hi)}", " ".join(["region", kind, *(bits(x) for x in numbers)])]
        if self.curve is not None:
            lines += [f"curve {len(self.curve)}", *(bits(*x) for x in self.curve)]
        for exponent, cubes, values in self.levels:
            runs = runs_of(cubes)
            lines.append(f"level {exponent} {len(runs)} {len(values)}")
            lines += [" ".join(map(str, run)) for run in runs]
            lines += [bits(*row) for row in values]
        return "\n".join([*lines, "end"]) + "\n"


def runs_of(cubes):
    runs = []
    for cube in cubes.tolist():
        if runs and cube[:-1] == runs[-1][:-2] and cube[-1] == runs[-1][-2] + runs[-1][-1]:
            runs[-1][-1] += 1
        else:
            runs.append([*cube, 1])
    return runs


def nodes_of(cubes, exponent):
    offsets = np.array(list(itertools.product(range(3), repeat=cubes.shape[1])))
    nodes = np.unique((2 * cubes[:, None] + offsets).reshape(-1, cubes.shape[1]), axis=0)
    return nodes * 2.0 ** (exponent - 1)


def make(chance):
    """A certificate, and what is known of it: the distance, and whether its curve leaves the domain."""
    n = chance.choice([1, 1, 2, 2, 2, 2, 3, 3, 4])
    family = chance.choice(FAMILIES)
    metric = family(chance, n)
    metric.family = family.__name__
    # On a lattice, so that ends may be knots, poles, nodes or points of a boundary in doubles.
    unit = chance.choice([0.5, 0.25, 0.1])
    start = np.array([chance.randint(-6, 6) * unit for _ in range(n)]) * (1.0 / n)
    end = start + np.array([chance.randint(-4, 4) * unit for _ in range(n)])
    end[0] += chance.choice([1.0, 1.5])
    if chance.random() < 0.5:
        start[1:], end[1:] = 0.0, 0.0
    sets = Sets(chance, n, start, end)
    a, b = sets.ends
    chords = chance.choice([1, 2, 7, 16])
    s = np.arange(chords + 1)[:, None] / chords
    curve = np.vstack([a + s[:-1] * (b - a), [b]])
    if n > 1 and chance.random() < 0.3:
        curve[1:-1, 1] += chance.uniform(0.2, 0.7) * np.sin(math.pi * s[1:-1, 0])
    length, good = metric.on_polygon(curve)
    length = length or 0.1
    hi = length * chance.choice([1.01, 1.1, 1.3]) if math.isfinite(length) else 2.0
    c1 = metric.c1 if metric.c1 > 0 else 0.3
    region = chance.choice(["declared", "declared", "tubes", "exit-one", "exit-two"])
    unbounded = sum(any(kind == "half-space" for kind, _ in p) for p in sets.pieces)
    radius = 1.001 * hi / math.sqrt(c1) / (1 if unbounded else 2)
    region = (region, *{"declared": [c1], "tubes": [radius, c1]}.get(region, []))
    levels = levels_of(chance, metric, sets, hi, region, c1)
    d = None
    kinds = {kind for pieces in sets.pieces for kind, _ in pieces}
    if metric.constant is not None and kinds == {"point"} and sum(map(len, sets.pieces)) == 2:
        d = math.sqrt((end - start) @ metric.constant @ (end - start))
    made = Made(metric, sets.pieces, hi, region, curve if chance.random() < 0.85 else None, levels)
    return made, d, good, length


def levels_of(chance, metric, sets, hi, region, c1):
    n = metric.dimension
    exponent = math.floor(math.log2(hi)) - chance.choice([2, 3] if n < 3 else [1, 2])
    while True:
        try:
            if region[0].startswith("exit"):
                low = np.min([p for p in sets.ends], axis=0) - 0.7 * hi / math.sqrt(c1)
                high = np.max([p for p in sets.ends], axis=0) + 0.7 * hi / math.sqrt(c1)
                side = 2.0**exponent
                ranges = [
                    range(math.floor(a / side), math.ceil(b / side)) for a, b in zip(low, high)
                ]
                count = math.prod(map(len, ranges))
                cubes = np.array(list(itertools.product(*ranges))) if count <= 4 * MOST[n] else None
            else:
                found, parts = 0, []
                for part in required_cubes(region, sets.pieces, hi * MARGIN, exponent, n):
                    found += len(part)
                    parts.append(part)
                    if found > MOST[n]:
                        break
                # Far from each other, the sets require no cube at all.
                parts.append(np.zeros((0, n), np.int64))
                cubes = np.unique(np.concatenate(parts), axis=0) if found <= MOST[n] else None
        except Refused:
            return []
        if cubes is not None and len(cubes):
            break
        if cubes is not None:
            return []
        exponent += 1
    levels, factor = [], chance.choice([1.0, 1.0, 1.05, 0.7])
    noise = chance.choice([0.0, 0.0, 1e-3, 0.1])
    for number in range(chance.choice([1, 2, 3] if n < 4 else [1, 2])):
        values = proposals(chance, metric, sets, nodes_of(cubes, exponent), c1, hi, factor, noise)
        levels.append((exponent, cubes, values))
        level = Level(exponent, cubes, values)
        kept = Sweep(metric.formula, sets.pieces, level).shorter_than(hi * MARGIN)[1]
        halvings = chance.choice([0, 1])
        if not kept.any() or kept.sum() << (n * halvings) > 4 * MOST[n]:
            break
        exponent -= halvings
        cubes = np.unique(following(cubes[kept], halvings), axis=0)
        if chance.random() < 0.3:
            cubes = np.unique(np.vstack([cubes, cubes[:1] - 1]), axis=0)
    return levels


def proposals(chance, metric, sets, points, c1, hi, factor, noise):
    both = []
    for pieces in sets.pieces:
        if metric.constant is not None and [kind for kind, _ in pieces] == ["point"]:
            x = points - pieces[0][1]
            d = np.sqrt(np.einsum("ni,ij,nj->n", x, metric.constant, x))
        else:
            d = math.sqrt(c1) * Sets.distances(pieces, points)
        d = d + noise * hi * np.array([chance.uniform(-1, 1) for _ in d])
        both.append(factor * d)
    return np.array(both).T


def change(chance, made):
    """The name of a change, and the changed certificate."""
    m = Made(made.metric, made.pieces, made.hi, made.region, made.curve, list(made.levels))
    what = chance.choice(
        ["hi up", "hi down", "c1", "cube", "value", "values", "end", "swap", "region"]
    )
    if what == "hi up":
        m.hi *= 1.5
    elif what == "hi down":
        m.hi *= 0.9
    elif what == "c1" and len(m.region) > 1:
        m.region = (*m.region[:-1], m.region[-1] * chance.choice([0.3, 1.2, 3.0, -1.0, 0.0]))
    elif what == "cube" and m.levels:
        at = chance.randrange(len(m.levels))
        exponent, cubes, values = m.levels[at]
        fewer = np.delete(cubes, chance.randrange(len(cubes)), axis=0)
        if len(fewer):
            before, after = nodes_of(cubes, exponent), nodes_of(fewer, exponent)
            index = {tuple(x): i for i, x in enumerate(before.tolist())}
            m.levels[at] = exponent, fewer, values[[index[tuple(x)] for x in after.tolist()]]
    elif what in ("value", "values") and m.levels:
        at = chance.randrange(len(m.levels))
        exponent, cubes, values = m.levels[at]
        values = values.copy()
        for _ in range(1 if what == "value" else 5):
            i, j = chance.randrange(len(values)), chance.randrange(2)
            values[i, j] = chance.choice(
                [values[i, j] + m.hi, -m.hi, 0.0, 1e300, -1e300, 1e-300, values[i, j] * 1.3]
            )
        m.levels[at] = exponent, cubes, values
    elif what == "end" and m.curve is not None:
        m.curve = m.curve.copy()
        at = chance.choice([0, -1])
        m.curve[at, 0] = chance.choice(
            [np.nextafter(m.curve[at, 0], 9), np.nextafter(m.curve[at, 0], -9), 0.3]
        )
    elif what == "swap":
        m.pieces = m.pieces[::-1]
    elif what == "region":
        m.region = (chance.choice(["exit-one", "exit-two"]),)
    return what, m


def verdict(text):
    """The lower and the upper bound and the number of cubes kept, or why the text is refused."""
    said = []
    try:
        lower, upper = check(Certificate(text), said.append)
    except Refused as reason:
        return str(reason)
    kept = int(said[-1].split(", ")[1].split(" ")[0])
    return lower, upper, kept


def false(found, d, length, good, curve, false_c1):
    """What is false of a verdict."""
    if isinstance(found, str):
        return None
    lower, upper, _ = (0.0, *found[1:]) if false_c1 else found
    if d is not None and not lower <= d * (1 + 1e-14):
        return f"a lower bound {lower} of the distance {d}"
    if good and not lower <= length * (1 + 1e-3):
        return f"a lower bound {lower} above the length {length}"
    if d is not None and upper is not None and not upper >= d * (1 - 1e-14):
        return f"an upper bound {upper} of the distance {d}"
    if curve is not None and not good:
        return "a curve that leaves the domain"
    return None


def main(folder, seed=1, count=200):
    chance, wrong, made = random.Random(int(seed)), [], None
    for at in range(int(count)):
        if at % 2 == 0 or not made.levels:
            made, d, good, length = make(chance)
            what, m = "nothing", made
        else:
            what, m = change(chance, made)
        name = f"{made.metric.dimension}-D {made.metric.family}, {m.region[0]}, {what} changed"
        text = m.text()
        (Path(folder) / f"{at}.cert").write_text(text, encoding="ascii", newline="")
        found = verdict(text)
        # Nothing is known of another curve, and of what follows from a false hypothesis.
        false_c1 = m.region[0] == "declared" and not m.region[1] <= made.metric.c1
        known = m.curve is None or m.curve is made.curve
        error = false(found, d, length, good, m.curve, false_c1) if known else None
        if error:
            wrong.append(f"{at}: {name}: {error}")
        if isinstance(found, str):
            print(at, "refused", f"{name}: {found}")
        else:
            print(at, "accepted", found[0], found[2], name)
    if wrong:
        sys.exit("\n".join(wrong))


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]) if 2 <= len(sys.argv) <= 4 else __doc__)
