"""``--vary NAME=VALUES``: words of the command line as a sampling plan."""

from __future__ import annotations

import argparse
import math
import re
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from ...analyses.ensembles import sampling
from ...errors import ModelError, near

NUMBER = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
LIST = re.compile(rf"\s*{NUMBER}\s*(?:,\s*{NUMBER}\s*)*")
CALL = re.compile(rf"\s*(\w+)\s*\(({LIST.pattern})\)\s*")

# word -> what it makes of its numbers, and their names
AXES: dict[str, tuple[Callable[..., Any], str]] = {
    "linspace": (lambda a, b, n: np.linspace(a, b, _integer(n)), "first, last, count"),
    "geomspace": (lambda a, b, n: np.geomspace(a, b, _integer(n)), "first, last, count"),
}
KINDS: dict[str, tuple[Callable[..., Any], str]] = {
    "uniform": (sampling.uniform, "low, high"),
    "normal": (sampling.normal, "mean, deviation"),
    "log_uniform": (sampling.log_uniform, "low, high"),
}
PLANS = {
    "random": sampling.random,
    "latin_hypercube": sampling.latin_hypercube,
    "sobol": sampling.sobol,
}
FORMS = ", ".join(f"{word}({names})" for word, (_, names) in {**AXES, **KINDS}.items())


def vary(text: str) -> tuple[str, Any]:
    """The type of ``m=linspace(1, 2, 100)``, ``elbow=normal(0, 0.1)`` or ``m=1,2,5``."""
    name, separator, values = text.partition("=")
    if not (separator and name.strip()):
        raise argparse.ArgumentTypeError(f"'{text}' does not read NAME=VALUES: {FORMS} or 1,2,5")
    try:
        return name.strip(), _values(values)
    except (ModelError, ValueError, TypeError) as problem:
        raise argparse.ArgumentTypeError(f"'{text}': {problem}") from None


def _values(argument: str) -> Any:
    """An array of values or a distribution. Nothing is evaluated as code."""
    call = CALL.fullmatch(argument)
    if call is None:
        if not LIST.fullmatch(argument):
            raise ModelError(f"values are {FORMS} or a list 1,2,5")
        return np.array(_numbers(argument))
    word, numbers = call.groups()
    samplers = {**AXES, **KINDS}
    if word not in samplers:
        raise ModelError(f"there is no '{word}'.{near(word, samplers)}")
    make, names = samplers[word]
    values = _numbers(numbers)
    if len(values) != names.count(",") + 1:
        raise ModelError(f"{word} takes {names}")
    return make(*values)


def _numbers(text: str) -> list[float]:
    values = [float(word) for word in text.split(",")]
    if not all(map(math.isfinite, values)):
        raise ModelError("numbers must be finite")
    return values


def _integer(count: float) -> int:
    if count != int(count) or not 1 <= count <= sampling.MOST:
        raise ModelError(f"{count:g} is not a number of values: 1, 2, ...")
    return int(count)


def plan(
    variations: Sequence[tuple[str, object]], runs: int | None, kind: str, seed: int
) -> sampling.Plan | None:
    """Every combination of the listed values; what is distributed is drawn for every run.

    Args:
        variations: Names with arrays or distributions.
        runs: In all; with listed values a multiple of their combinations.
        kind: How to draw, of :data:`PLANS`.
        seed: Of what is drawn.

    Raises:
        ModelError: a name twice, or a number of runs that does not fit.
    """
    names = [name for name, _ in variations]
    twice = next((name for name in names if names.count(name) > 1), None)
    if twice is not None:
        raise ModelError(f"--vary: '{twice}' is given twice")
    axes = {name: value for name, value in variations if isinstance(value, np.ndarray)}
    kinds = {name: value for name, value in variations if not isinstance(value, np.ndarray)}
    grid = sampling.grid(axes) if axes else None
    count = len(grid) if grid else 1
    total = runs or count
    if not variations:
        return None
    if kinds and runs is None and not axes:
        raise ModelError("--vary draws values: say of how many runs with --runs")
    if total % count:
        raise ModelError(f"--runs {total} is not a multiple of the {count} combinations of values")
    if not kinds and total != count:
        raise ModelError(f"--runs {total}: the values have {count} combinations, all alike then")
    values = {n: np.repeat(v, total // count) for n, v in grid.values.items()} if grid else {}
    drawn = PLANS[kind](total, kinds, seed=seed).values if kinds else {}
    parts = [*(["grid"] if grid else []), *([kind.replace("_", " ")] if kinds else [])]
    return sampling.Plan(" and ".join(parts), {name: {**values, **drawn}[name] for name in names})
