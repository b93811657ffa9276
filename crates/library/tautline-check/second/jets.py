"""Jets: values with first and second derivatives, over intervals."""

from intervals import of


class Jet:
    """A value with first and second derivatives; None is a derivative that is zero everywhere."""

    def __init__(self, value, first, second=None):
        self.value, self.first, self.second = of(value), first, second or {}

    def __neg__(self):
        first = [None if f is None else -f for f in self.first]
        return Jet(-self.value, first, {ij: -s for ij, s in self.second.items() if s is not None})

    def __add__(self, other):
        other = jet(other, self)
        pairs = self.second.keys() | other.second.keys()
        second = {ij: plus(self.second.get(ij), other.second.get(ij)) for ij in pairs}
        return Jet(self.value + other.value, list(map(plus, self.first, other.first)), second)

    def __sub__(self, other):
        return self + -jet(other, self)

    def __mul__(self, other):
        a, b = self, jet(other, self)
        first = [plus(times(f, b.value), times(g, a.value)) for f, g in zip(a.first, b.first)]
        second = {}
        for i, j in upper(len(first)):
            bent = plus(times(a.second.get((i, j)), b.value), times(b.second.get((i, j)), a.value))
            mixed = plus(times(a.first[i], b.first[j]), times(a.first[j], b.first[i]))
            second[i, j] = plus(bent, mixed)
        return Jet(a.value * b.value, first, second)

    def __truediv__(self, other):
        a, b = self, jet(other, self)
        q = a.value / b.value
        # a = q b, differentiated twice.
        first = [over(minus(f, times(g, q)), b.value) for f, g in zip(a.first, b.first)]
        second = {}
        for i, j in upper(len(first)):
            mixed = plus(times(first[i], b.first[j]), times(first[j], b.first[i]))
            rest = minus(minus(a.second.get((i, j)), mixed), times(b.second.get((i, j)), q))
            second[i, j] = over(rest, b.value)
        return Jet(q, first, second)

    def chain(self, value, d1, d2):
        """The composition with a function that has this value and these derivatives."""
        second = {}
        for i, j in upper(len(self.first)):
            a, b = self.first[i], self.first[j]
            product = a.sqr() if i == j and a is not None else times(a, b)
            second[i, j] = plus(times(self.second.get((i, j)), d1), times(product, d2))
        return Jet(value, [times(f, d1) for f in self.first], second)

    def sqr(self):
        return self.chain(self.value.sqr(), self.value.scaled(2.0), of(2.0))

    def powi(self, n):
        x = self.value
        if n in (0, 1):
            return self.chain(x.powi(0), None, None) if n == 0 else self
        return self.chain(x.powi(n), x.powi(n - 1) * n, x.powi(n - 2) * n * (n - 1))

    def recip(self):
        r = self.value.recip()
        return self.chain(r, -r.sqr(), r.powi(3).scaled(2.0))

    def sqrt(self):
        root = self.value.sqrt()
        d1 = root.recip().scaled(0.5)
        return self.chain(root, d1, -(d1 / self.value).scaled(0.5))

    def exp(self):
        e = self.value.exp()
        return self.chain(e, e, e)

    def ln(self):
        r = self.value.recip()
        return self.chain(self.value.ln(), r, -r.sqr())

    def sin(self):
        s, c = self.value.sin(), self.value.cos()
        return self.chain(s, c, -s)

    def cos(self):
        s, c = self.value.sin(), self.value.cos()
        return self.chain(c, -s, -c)

    def tan(self):
        t = self.value.tan()
        d1 = t.sqr() + 1.0
        return self.chain(t, d1, (t * d1).scaled(2.0))

    def atan(self):
        d1 = (self.value.sqr() + 1.0).recip()
        return self.chain(self.value.atan(), d1, -(self.value * d1.sqr()).scaled(2.0))

    def sinh(self):
        s, c = self.value.sinh(), self.value.cosh()
        return self.chain(s, c, s)

    def cosh(self):
        s, c = self.value.sinh(), self.value.cosh()
        return self.chain(c, s, c)

    def tanh(self):
        t, d1 = self.value.tanh(), self.value.cosh().sqr().recip()
        return self.chain(t, d1, -(t * d1).scaled(2.0))


def upper(n):
    return [(i, j) for i in range(n) for j in range(i, n)]


def jet(x, like):
    return x if isinstance(x, Jet) else Jet(x, [None] * len(like.first))


def plus(a, b):
    return b if a is None else a if b is None else a + b


def minus(a, b):
    return a if b is None else plus(a, -b)


def times(a, b):
    return None if a is None or b is None else a * b


def over(a, b):
    return None if a is None else a / b
