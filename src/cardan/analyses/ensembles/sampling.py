"""Sampling plans: which values the runs of an ensemble take.

::

    cd.sample.grid(m=(1, 2, 100))                            100 masses, evenly from 1 to 2
    cd.sample.latin_hypercube(1000, {"elbow": (-1, 1)}, seed=3)
    cd.sample.sobol(1024, {"elbow": cd.sample.normal(0, 0.1), "m": (1, 2)})

Source: J. C. Helton, F. J. Davis, Latin hypercube sampling and the propagation of uncertainty,
2003; S. Joe, F. Y. Kuo, Constructing Sobol sequences with better two-dimensional projections, 2008.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import field
from typing import Any, Protocol, runtime_checkable

import numpy as np

from ...arguments import Count, Seed, checked
from ...arrays import Array
from ...errors import ArgumentError, ModelError, SolveError, brief, counted
from ...records import dataclass
from ...runtime.calls.calling import numbers

MOST = 1 << 31  # runs of a plan


@runtime_checkable
class Distribution(Protocol):
    """Anything with quantiles:

    the frozen distributions of ``scipy.stats``, and those of this module.
    """

    def ppf(self, q: object) -> Any:
        """Values below which fractions q of all values lie."""


@dataclass(frozen=True)
class Uniform:
    """Every value between two is as likely."""

    low: float
    high: float

    def ppf(self, q: object) -> Any:
        """Quantiles."""
        return self.low + (self.high - self.low) * np.asarray(q)


@dataclass(frozen=True)
class Normal:
    """The bell curve."""

    mean: float
    deviation: float

    def ppf(self, q: object) -> Any:
        """Quantiles."""
        from scipy.special import ndtri

        return self.mean + self.deviation * ndtri(np.asarray(q))


@dataclass(frozen=True)
class LogUniform:
    """The logarithm of a positive value is uniform: every order of magnitude is as likely."""

    low: float
    high: float

    def ppf(self, q: object) -> Any:
        """Quantiles."""
        return np.exp(Uniform(math.log(self.low), math.log(self.high)).ppf(q))


@checked
def uniform(low: float, high: float) -> Uniform:
    """Values between two, all as likely.

    Raises:
        ModelError: ``low`` is not below ``high``, or one is not finite.
    """
    low, high = _reals("uniform", low, high)
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        raise ModelError(f"uniform({low:g}, {high:g}): low must be below high, both finite")
    return Uniform(float(low), float(high))


@checked
def normal(mean: float, deviation: float) -> Normal:
    """Values around a mean, with a standard deviation.

    Raises:
        ModelError: a deviation that is not positive, or a number that is not finite.
    """
    mean, deviation = _reals("normal", mean, deviation)
    if not (math.isfinite(mean) and math.isfinite(deviation) and deviation > 0):
        raise ModelError(
            f"normal(mean={mean:g}, deviation={deviation:g}): mean must be finite and the "
            "deviation must be positive"
        )
    return Normal(float(mean), float(deviation))


@checked
def log_uniform(low: float, high: float) -> LogUniform:
    """Positive values whose logarithm is uniform.

    Raises:
        ModelError: not 0 < low < high.
    """
    low, high = _reals("log_uniform", low, high)
    if not (math.isfinite(high) and 0 < low < high):
        raise ModelError(f"log_uniform({low:g}, {high:g}): it must be 0 < low < high")
    return LogUniform(float(low), float(high))


@dataclass(frozen=True)
class Plan:
    """Values of every run.

    Attributes:
        kind: ``grid``, ``latin hypercube``, ``sobol`` or ``random``.
        values: Name -> (runs,): coordinates, speeds (``elbow.u``), parameters or inputs.
    """

    kind: str
    values: Mapping[str, Array] = field(repr=False)

    @property
    def names(self) -> tuple[str, ...]:
        """Names of the varied quantities."""
        return tuple(self.values)

    def __len__(self) -> int:
        return len(next(iter(self.values.values())))

    def __repr__(self) -> str:
        rows = [
            f"  {name}: {column.min():g} ... {column.max():g}"
            for name, column in self.values.items()
        ]
        return "\n".join([f"{self.kind} plan of {counted(len(self), 'run')}", *rows])


@checked
def grid(values: Mapping[str, object] | None = None, **named: Any) -> Plan:
    """Every combination of values; the last name varies fastest.

    Args:
        values: Name -> ``(low, high, count)``, evenly with both ends, or an array of values.
        named: The same for plain names, ``m=(1, 2, 100)``.

    Raises:
        ModelError: nothing to vary, or too many runs. ArgumentError: neither of the two forms.
    """
    axes = {
        name: _axis(name, value) for name, value in _merged_values("grid", values, named).items()
    }
    runs = math.prod(map(len, axes.values()))
    if runs > MOST:
        raise ModelError(f"grid: {runs} runs are more than {MOST}; take fewer values per name")
    meshes = np.meshgrid(*axes.values(), indexing="ij")
    return Plan("grid", {n: m.reshape(-1) for n, m in zip(axes, meshes, strict=True)})


@checked
def random(runs: Count, values: Mapping[str, object], *, seed: Seed = 0) -> Plan:
    """Independent values.

    Args:
        runs: How many.
        values: Name -> ``(low, high)``, uniform, or a distribution: :func:`normal`,
            :func:`uniform`, :func:`log_uniform`, anything of ``scipy.stats`` with its numbers.
        seed: The same seed gives the same plan.

    Raises:
        ModelError: nothing to vary, or no number of runs.
    """
    kinds = _distributions("random", runs, values)
    cube = np.random.default_rng(checked_seed(seed)).random((runs, len(kinds)))
    return _filled("random", kinds, cube)


@checked
def latin_hypercube(runs: Count, values: Mapping[str, object], *, seed: Seed = 0) -> Plan:
    """Values that cover each range evenly: one in each of ``runs`` slices as likely as the others.

    Args and Raises: as of :func:`random`.
    """
    from scipy.stats import qmc

    kinds = _distributions("latin_hypercube", runs, values)
    cube = qmc.LatinHypercube(len(kinds), rng=np.random.default_rng(checked_seed(seed))).random(
        runs
    )
    return _filled("latin hypercube", kinds, cube)


@checked
def sobol(runs: Count, values: Mapping[str, object], *, seed: Seed = 0) -> Plan:
    """A scrambled Sobol sequence: means over it converge faster than over random values.

    Args and Raises: as of :func:`random`; ``runs`` must be a power of 2, which keeps the balance
    of the sequence.
    """
    from scipy.stats import qmc

    kinds = _distributions("sobol", runs, values)
    power = runs.bit_length() - 1
    if runs != 1 << power:
        raise ModelError(
            f"sobol: {runs} runs lose the balance of the sequence. Take {1 << power} or "
            f"{2 << power}, or latin_hypercube for any number"
        )
    cube = qmc.Sobol(len(kinds), rng=np.random.default_rng(checked_seed(seed))).random_base2(power)
    return _filled("sobol", kinds, cube)


def distribution(name: str, value: object) -> Distribution:
    """``(low, high)`` or a distribution.

    Raises:
        ArgumentError: neither.
    """
    if isinstance(value, tuple | list) and len(value) == 2:
        low, high = (float(_finite(name, numbers(f"'{name}'", v))) for v in value)
        return uniform(low, high)
    if isinstance(value, Distribution):
        return value
    raise ArgumentError(
        f"'{name}' is {brief(value)}; give (low, high), sample.normal(mean, deviation), "
        "sample.uniform(low, high) or a distribution of scipy.stats with its numbers"
    )


def checked_seed(seed: object) -> int:
    """A seed.

    Raises:
        ModelError: it is not a whole number from 0 on.
    """
    if not isinstance(seed, int | np.integer) or seed < 0:
        raise ModelError(f"seed={brief(seed)}: a whole number from 0 on is wanted")
    return int(seed)


def _reals(where: str, first: object, second: object) -> tuple[float, float]:
    """The two numbers of a distribution."""
    array = numbers(f"{where}({brief(first)}, {brief(second)})", [first, second])
    return float(array[0]), float(array[1])


def _merged_values(
    where: str, values: Mapping[str, object] | None, named: Mapping[str, object]
) -> Any:
    if values is not None and not isinstance(values, Mapping):
        raise ModelError(
            f"{where}: {brief(values)} does not say what is varied: give names with values, "
            f"{where}({{'m': ...}})"
        )
    merged = {**(values or {}), **named}
    if not merged:
        raise ModelError(
            f"{where}: name what is varied and its values, such as {where}(m=(1, 2, 100))"
        )
    return merged


def _axis(name: str, value: object) -> Array:
    """The values of one name in a grid."""
    array = _finite(name, numbers(f"grid: '{name}'", value))
    if isinstance(value, tuple) and array.shape == (3,):
        low, high, count = array.tolist()
        if count != int(count) or not 1 <= count <= MOST:
            raise ModelError(f"grid: '{name}': {count:g} is not a number of values: 1, 2, ...")
        return np.linspace(low, high, int(count))
    if array.ndim != 1 or not array.size:
        raise ArgumentError(
            f"grid: '{name}' is {brief(value)}; give (low, high, count) or an array of values"
        )
    return array


def _finite(name: str, array: Array) -> Array:
    bad = np.flatnonzero(~np.isfinite(array))
    if len(bad):
        raise SolveError(f"'{name}': value {bad[0]} is {array.reshape(-1)[bad[0]]}")
    return array


def _distributions(where: str, runs: int, values: Mapping[str, object]) -> dict[str, Distribution]:
    if not isinstance(runs, int | np.integer) or not 1 <= runs <= MOST:
        raise ModelError(f"{where}: {brief(runs)} is not a number of runs: 1, 2, ...")
    return {n: distribution(n, v) for n, v in _merged_values(where, values, {}).items()}


def _filled(kind: str, kinds: Mapping[str, Distribution], cube: Array) -> Plan:
    """A plan from numbers in 0 ... 1 (runs, names)."""
    # 0 has no quantile of a distribution without ends
    cube = np.clip(cube, 2.0**-53, 1 - 2.0**-53)
    columns = zip(kinds.items(), cube.T, strict=True)
    return Plan(kind, {name: np.array(d.ppf(column), float) for (name, d), column in columns})


def drawn(name: str, kind: Distribution, runs: int, seed: int) -> Array:
    """Values (runs,) that depend on the seed and the name alone, not on what else is drawn."""
    generator = np.random.default_rng([seed, *name.encode()])
    cube = np.clip(generator.random(runs), 2.0**-53, 1 - 2.0**-53)
    return np.array(kind.ppf(cube), dtype=np.float64)
