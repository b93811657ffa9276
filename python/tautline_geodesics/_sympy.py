"""Expressions of SymPy as functions. Their numbers are exact, or steps that intervals enclose."""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Mapping, Sequence
from fractions import Fraction
from functools import reduce
from typing import Any, NamedTuple

import numpy as np

from ._tautline import ProblemError
from ._trace import TraceError, Traced, constant

# The functions of SymPy that numbers may have, as methods of a step.
FUNCTIONS = {
    **{name: name for name in "exp log sin cos tan sinh cosh tanh".split()},
    **{name: f"arc{name[1:]}" for name in "asin acos atan acosh atanh".split()},
}


class Step(NamedTuple):
    """A number that is no double, and the symbol in its place."""

    symbol: Any
    value: Traced


def is_sympy(what: Any) -> bool:
    """Whether it is of SymPy, or a list of such."""
    if isinstance(what, (list, tuple)):
        return any(is_sympy(each) for each in what)
    return hasattr(what, "free_symbols")


def of_sympy(
    what: Any, variables: Sequence[Any] | None, parameters: Mapping[str, float]
) -> Callable[[np.ndarray], Any]:
    """A SymPy expression, matrix or list as a function. It uses all parameters."""
    import sympy  # type: ignore[import-untyped, import-not-found, unused-ignore]

    found = sympy.sympify(what)
    # A matrix as nested lists, which need no arrays of numbers.
    entries = found.tolist() if hasattr(found, "tolist") else found
    symbols = _by_name(symbol for each in _leaves(entries) for symbol in each.free_symbols)
    if variables is None:
        names = sorted(symbols.keys() - parameters.keys()) or ["x", "y"]
        raise ProblemError(
            f"variables=({', '.join(names)}) are needed, in the order of the coordinates, for an "
            "expression of SymPy"
        )
    names = _names(variables)
    if unknown := sorted(symbols.keys() - {*names} - parameters.keys()):
        raise ProblemError(f"{', '.join(unknown)}: neither in `variables` nor in `parameters`")
    if unused := [name for name in parameters if name not in symbols]:
        raise ProblemError(f"the parameter {unused[0]} is not used")
    if any(name in parameters for name in names):
        raise ProblemError(f"{[*parameters]} are parameters, and {names} variables")
    # Symbols with assumptions are others than those of the same name without.
    arguments = [symbols.get(name, sympy.Symbol(name)) for name in names]
    given = {
        symbols[name]: sympy.Rational(*value.as_integer_ratio()) for name, value in parameters.items()
    }
    steps = {symbols[name]: Step(symbols[name], constant(value)) for name, value in parameters.items()}
    entries = _mapped(lambda entry: _with_steps(entry, given, steps), entries)
    arguments += [step.symbol for step in steps.values()]
    try:
        function = sympy.lambdify(arguments, entries, "numpy", cse=True)
    except (SyntaxError, NotImplementedError, ValueError) as error:
        first, *_ = str(error).splitlines()
        raise TraceError(f"SymPy writes no function of NumPy for {what}: {first}") from None

    def called(x: np.ndarray) -> Any:
        try:
            return function(*x, *(step.value for step in steps.values()))
        except NameError as error:
            raise TraceError(f"a function of SymPy that NumPy does not have: {error}") from None

    return called


def _names(variables: Sequence[Any]) -> list[str]:
    import sympy

    for variable in variables:
        if not isinstance(variable, (sympy.Symbol, str)):
            raise ProblemError(f"{variable!r} in `variables` is no symbol")
    names = [str(variable) for variable in variables]
    if twice := [name for i, name in enumerate(names) if name in names[:i]]:
        raise ProblemError(f"{twice[0]} is twice in variables=({', '.join(names)})")
    return names


def _by_name(symbols: Any) -> dict[str, Any]:
    found: dict[str, Any] = {}
    for symbol in symbols:
        if found.setdefault(str(symbol), symbol) != symbol:
            raise ProblemError(f"two symbols have the name {symbol}, with different assumptions")
    return found


def _leaves(found: Any) -> list[Any]:
    if _is_list(found):
        return [leaf for each in found for leaf in _leaves(each)]
    return [found]


def _mapped(function: Callable[[Any], Any], found: Any) -> Any:
    if _is_list(found):
        return [_mapped(function, each) for each in found]
    return function(found)


def _is_list(found: Any) -> bool:
    return isinstance(found, (list, tuple)) or type(found).__name__ in ("Tuple", "List")


def _with_steps(found: Any, given: Mapping[Any, Any], steps: dict[Any, Step]) -> Any:
    """An expression whose numbers are doubles, or symbols for steps. Exponents have the given parameters."""
    import sympy

    def step(number: Any) -> Any:
        if number not in steps:
            steps[number] = Step(sympy.Dummy(), _step(number))
        return steps[number].symbol

    if found.is_Float:
        return _double(found)
    if found.is_Rational:
        if _is_double(found):
            return found
        powers = (found.q & -found.q).bit_length() - 1
        above: Any = sympy.Rational(found.p, 2**powers)
        if not _is_double(above):
            if not _is_double(sympy.Rational(1, 2**powers)):
                raise ProblemError(f"the number {float(found)!r} in a formula is too small")
            above = step(sympy.Integer(found.p)) * sympy.Rational(1, 2**powers)
        odd = found.q >> powers
        return above / step(sympy.Integer(odd)) if odd > 1 else above
    if not found.args and not found.is_number:
        return found
    if isinstance(found, sympy.Expr) and not found.free_symbols:
        return step(found)
    if found.is_Pow:
        exponent = found.exp.xreplace(given)
        base = _with_steps(found.base, given, steps)
        if found.base.free_symbols <= given.keys() and not exponent.free_symbols:
            return base ** _with_steps(exponent, given, steps)
        if exponent.is_Rational or exponent.is_Float:
            return base ** sympy.Rational(_exact(exponent))
    return found.func(*(_with_steps(each, given, steps) for each in found.args))


def _step(found: Any) -> Traced:
    """A number that is no double, as steps."""
    import sympy

    if found.is_Float or found.is_Rational:
        exact = _exact(found)
        above = constant(exact.numerator)
        return above if exact.denominator == 1 else above / constant(exact.denominator)
    if found is sympy.pi:
        return 4 * constant(1).arctan()  # type: ignore[no-any-return]
    if found is sympy.E:
        return constant(1).exp()
    if found is sympy.GoldenRatio:
        return (1 + constant(5).sqrt()) / 2  # type: ignore[no-any-return]
    if found.is_real is False:
        kind = "not finite" if found.is_finite is False else "complex"
        raise TraceError(f"the number {found} in a formula, which is {kind}")
    if found.is_Add:
        return reduce(operator.add, map(_step, found.args))
    if found.is_Mul:
        return reduce(operator.mul, map(_step, found.args))
    if found.is_Pow:
        base, exponent = found.args
        if exponent.is_Rational and (2 * exponent).is_Integer:
            return _step(base) ** float(exponent)  # type: ignore[no-any-return]
        return (_step(exponent) * _step(base).log()).exp()  # type: ignore[no-any-return]
    name = FUNCTIONS.get(type(found).__name__)
    if name is None:
        raise TraceError(
            f"the number {found} in a formula, which has no elementary functions alone; as the nearest "
            f"double it is sympy.Float({found})"
        )
    return getattr(_step(found.args[0]), name)()  # type: ignore[no-any-return]


def _exact(found: Any) -> Fraction:
    """A Rational, or a Float that is a double, as a fraction."""
    found = _double(found) if found.is_Float else found
    return Fraction(int(found.p), int(found.q))


def _double(found: Any) -> Any:
    """A Float as an exact fraction."""
    import sympy

    try:
        nearest = float(found)
    except OverflowError:
        nearest = math.inf
    # Neither a fraction nor a text of it: it may have more digits than there is memory.
    if not math.isfinite(nearest):
        raise ProblemError("a Float of SymPy is larger than all doubles")
    if found._mpf_ != sympy.Float(nearest, precision=53)._mpf_:
        raise ProblemError(
            f"a Float of SymPy has more digits than a double: the nearest double is {nearest!r}; for a fraction "
            "take sympy.Rational"
        )
    return sympy.Rational(*nearest.as_integer_ratio())


def _is_double(found: Any) -> bool:
    """Whether a fraction is a double."""
    exact = Fraction(int(found.p), int(found.q))
    try:
        return Fraction(float(exact)) == exact
    except OverflowError:
        return False
