"""Options shared by the commands that run a scene: times, starts, tolerances, output files."""

from __future__ import annotations

import argparse
import math
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ...api.scene import Scene
    from ...runtime.formats.contents import Ending

DEFAULTS: dict[str, Any] = {"t": 10.0}


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare what a run takes."""
    run = start(parser)
    run.add_argument("--method", metavar="NAME",
                     help="integrator, such as DOP853, Radau or RK4 (default auto)")  # fmt: skip
    run.add_argument("--rtol", type=positive, help="relative tolerance per step (default 1e-6)")
    run.add_argument("--atol", type=positive,
                     help="absolute one (default 1e-3 rtol, at most 1e-9)")  # fmt: skip
    run.add_argument("--step", metavar="SECONDS", type=positive,
                     help="fixed step of RK4, generalized-alpha and others; first step of DOP853 "
                          "and its like")  # fmt: skip


def start(parser: argparse.ArgumentParser) -> argparse._ArgumentGroup:
    """Declare where a run starts and ends."""
    run = parser.add_argument_group("the run")
    run.add_argument("--time", metavar="SECONDS", type=positive, help="end time (default 10)")
    run.add_argument("--q", metavar="JOINT=VALUE", type=named, action="append", default=[],
                     help="initial coordinate of a joint; give it again for another")  # fmt: skip
    run.add_argument("--u", metavar="JOINT=VALUE", type=named, action="append", default=[],
                     help="initial speed of a joint")  # fmt: skip
    run.add_argument("--z", metavar="STATE=VALUE", type=named, action="append", default=[],
                     help="initial internal state of an element, such as motor.force")  # fmt: skip
    return run


def file(*endings: str) -> Callable[[str], Path]:
    """The type of a file whose ending says what it holds."""

    def path(text: str) -> Path:
        target = Path(text)
        if target.suffix.lower() not in endings:
            raise argparse.ArgumentTypeError(f"'{text}' does not end in {' or '.join(endings)}")
        return target

    return path


def saved(text: str) -> Path:
    """The type of a file that an ensemble or a path is written to."""
    from ...runtime.formats import FORMATS

    return _written(text, FORMATS, "results")


def motion(text: str) -> Path:
    """The type of a file that a run is written to."""
    from ...view.motion_files import FORMATS

    return _written(text, FORMATS, "runs")


def _written(text: str, table: Sequence[Ending], what: str) -> Path:
    """The path of a file in one of some formats; what is missing is said before a run begins."""
    from ...errors import ModelError
    from ...runtime.formats import by_ending

    path = Path(text)
    try:
        by_ending(path, table, what, bare=False)
    except (ModelError, ModuleNotFoundError) as problem:
        raise argparse.ArgumentTypeError(str(problem)) from problem
    return path


def data(text: str) -> Path:
    """The type of a file of measurements: a table or a saved run."""
    from ...runtime import formats

    return file(".csv", *formats.readable())(text)


def positive(text: str) -> float:
    """The type of a positive number."""
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not (math.isfinite(value) and value > 0):
        raise argparse.ArgumentTypeError(f"{text} is not a positive number")
    return value


def count(text: str) -> int:
    """The type of a number of things."""
    if not (text.isascii() and text.isdigit() and int(text) > 0):
        raise argparse.ArgumentTypeError(f"{text} is not a number such as 1, 2, 3")
    return int(text)


def _value(text: str) -> float:
    """A number, or a constant such as pi/3.

    Raises:
        ValueError: it is neither.
    """
    try:
        return float(text)
    except ValueError:
        if "pi" not in text:
            raise
    from ...errors import CardanError
    from ...scene.files.expression import parse

    try:
        return float(parse(text, {}, where=text))
    except (CardanError, TypeError) as problem:
        raise ValueError(text) from problem


def named(text: str) -> tuple[str, float | list[float]]:
    """The type of ``elbow=0.3`` or ``ball=1,0,0,0``."""
    name, separator, numbers = text.rpartition("=")
    try:
        values = [_value(x) for x in numbers.split(",")]
    except ValueError:
        values = []
    if not (separator and name and values and all(map(math.isfinite, values))):
        raise argparse.ArgumentTypeError(f"'{text}' does not read JOINT=VALUE, such as elbow=0.3")
    return name, values[0] if len(values) == 1 else values


def settings(scene: Scene, options: argparse.Namespace) -> dict[str, Any]:
    """Arguments of the run: the defaults, then what the file says, then what was typed."""
    keys = ("method", "rtol", "atol", "step")
    typed = {"t": options.time} | {word: getattr(options, word) for word in keys}
    values = DEFAULTS | scene.settings | {k: value for k, value in typed.items() if value}
    return values | _blocks(values, options)


def begin(scene: Scene, options: argparse.Namespace) -> dict[str, Any]:
    """End and start of the run, whatever method takes it: t, q, u, and z where the file says so."""
    values = {k: value for k, value in scene.settings.items() if k in ("t", "q", "u", "z")}
    values["t"] = options.time or values.get("t", DEFAULTS["t"])
    return values | _blocks(values, options)


def _blocks(values: dict[str, Any], options: argparse.Namespace) -> dict[str, Any]:
    """Initial values: what the file says, then what was typed."""
    return {b: {**values.get(b, {}), **dict(getattr(options, b))} for b in ("q", "u", "z")}
