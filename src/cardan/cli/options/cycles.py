"""Options of paths of cycles: the motion next to which the first one is looked for."""

from __future__ import annotations

import argparse
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import ArrayLike

from ...errors import ModelError, SolveError, counted, near
from . import equilibrium as equilibrium_options
from . import run as run_options

if TYPE_CHECKING:
    from ...analyses.continuation.record import ContinuationRecord, SpecialPointRecord
    from ...api.compiled_model import CompiledModel
    from ...api.scene import Scene

# what a search for a cycle takes; the other starts know it
SEARCH = ("u", "z", "period", "section", "settle", "guess")
ALL = (*SEARCH, "mode", "hopf")


def arguments(parser: argparse.ArgumentParser) -> None:
    """Declare where a path of cycles starts."""
    group = parser.add_argument_group(
        "where cycles start (--of cycles)",
        "at the cycle next to --q, --u and --z, or to where simulate: of the file starts; at a "
        "mode; or at a Hopf point",
    )
    group.add_argument("--u", metavar="JOINT=VALUE", type=run_options.named, action="append",
                       default=[], help="speed to start from; again for another")  # fmt: skip
    group.add_argument("--z", metavar="STATE=VALUE", type=run_options.named, action="append",
                       default=[], help="internal state of an element to start from")  # fmt: skip
    group.add_argument("--period", metavar="SECONDS",
                       help="of what forces the motion: a number, or an expression in parameters "
                            "such as 2*pi/omega (default: unknown)")  # fmt: skip
    group.add_argument("--section", metavar="EVENT",
                       help="event of the scene that ends a lap, such as an impact")  # fmt: skip
    group.add_argument("--settle", metavar="LAPS", type=run_options.count,
                       help="laps to run before the search (default 0)")  # fmt: skip
    group.add_argument("--guess", metavar="SECONDS", type=run_options.positive,
                       help="of an unknown period (default: the first return)")  # fmt: skip
    group.add_argument("--mode", metavar="NUMBER", type=int,
                       help="start at a mode, from 0, of what keeps its energy; goes with "
                            "--vary energy=0:1 [J]")  # fmt: skip
    group.add_argument("--hopf", metavar="NUMBER", type=run_options.count, nargs="?", const=1,
                       help="start at a Hopf point of the equilibria, by default at the first"
                       )  # fmt: skip


def refuse(options: argparse.Namespace, coordinates: Sequence[str]) -> None:
    """Refuse options that do not go together.

    Raises:
        ModelError: they do not.
    """
    from ...analyses.cycles.energy_level import ENERGY

    typed = [name for name in ALL if getattr(options, name) not in (None, [])]
    if options.of != "cycles":
        if typed:
            raise ModelError(f"--{typed[0]} says where cycles start: it goes with --of cycles")
        return
    starts = [name for name in ("mode", "hopf") if name in typed]
    if len(starts) == 2:
        raise ModelError("--mode and --hopf both say where the path starts: leave one out")
    search = [name for name in SEARCH if name in typed]
    if starts and search:
        raise ModelError(
            f"--{search[0]} is of a cycle that is looked for: leave it out with --{starts[0]}"
        )
    if options.lock:
        raise ModelError("--lock does not go with --of cycles, whose joints all move")
    for name, _ in options.vary:
        if name == ENERGY and "mode" not in typed:
            raise ModelError("--vary energy=0:1 starts at a mode of vibration: give --mode 0")
        if name in coordinates:
            raise ModelError(
                f"--vary {name}: cycles go by parameters and inputs, and '{name}' is a coordinate; "
                "--vary energy=0:1 with --mode gives families of free vibrations"
            )


def start(scene: Scene, model: CompiledModel, options: argparse.Namespace) -> object:
    """The cycle, mode or Hopf point at which a path starts.

    Raises:
        ModelError: unknown names, no such mode or Hopf point. SolveError: no cycle was reached.
    """
    conditions = equilibrium_options.loads(scene, model, options)
    if options.mode is not None:
        equilibrium = model.equilibrium(**conditions, check=True)
        return model.modes(None, equilibrium)[options.mode]
    if options.hopf is not None:
        return _hopf_point(model.continuation(dict(options.vary), **conditions), options.hopf)
    q, _ = conditions.pop("q"), conditions.pop("locked")
    # what varies begins at its first value
    for name, (low, _) in options.vary:
        conditions["inputs" if name in model.inputs else "parameters"][name] = low
    u, z = ({**scene.settings.get(b, {}), **dict(getattr(options, b))} for b in "uz")
    return model.cycle(
        {**q, **_speeds(model, u), **z}, period=_period(model, options.period),
        section=options.section, settle=options.settle or 0, guess=options.guess, check=True,
        **conditions,
    )  # fmt: skip


def _hopf_point(path: ContinuationRecord, number: int) -> SpecialPointRecord:
    """A Hopf point of the equilibria over the same range.

    Raises:
        SolveError: there are not so many.
    """
    from ...analyses.continuation.special_points import HOPF

    points = [point for point in path.points if point.kind == HOPF]
    if len(points) < number:
        raise SolveError(
            f"--hopf {number}: the equilibria have {counted(len(points), HOPF)}; {path.message}. "
            "Vary it further, or look at them: without --of cycles"
        )
    return points[number - 1]


def _speeds(model: CompiledModel, named: Mapping[str, ArrayLike]) -> dict[str, ArrayLike]:
    """Speeds by their own names: that of a hinge ``elbow`` is ``elbow.u``."""
    slots, speeds = model.manifest.slots("u"), dict[str, ArrayLike]()
    for name, value in named.items():
        names = [name] if name in model.speeds else model.speeds[slots.get(name, slice(0))]
        values = np.atleast_1d(np.asarray(value, dtype=np.float64)).tolist()
        if len(values) != len(names):
            cure = "" if names else near(name, dict.fromkeys([*slots, *model.speeds]))
            many = counted(len(names), "speed")
            raise ModelError(f"--u: '{name}' has {many}, not {len(values)}.{cure}")
        speeds |= dict(zip(names, values, strict=True))
    return speeds


def _period(model: CompiledModel, text: str | None) -> object:
    """A time, or an expression in parameters and inputs.

    Raises:
        ModelError: it is neither.
    """
    if text is None:
        return None
    from sympy import Symbol

    from ...scene.files.expression import parse

    names = {name: Symbol(name) for name in (*model.parameters, *model.inputs)}
    return parse(text, names, where="--period")
