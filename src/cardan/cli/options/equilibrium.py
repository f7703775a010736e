"""Options shared by the commands about equilibria: where they look, and under which loads."""

from __future__ import annotations

import argparse
import math
from typing import TYPE_CHECKING, Any

from ...errors import ModelError
from . import run as run_options
from . import scene as scene_options

if TYPE_CHECKING:
    from ...analyses.statics.equilibrium import EquilibriumRecord
    from ...api.compiled_model import CompiledModel
    from ...api.scene import Scene


def arguments(parser: argparse.ArgumentParser) -> argparse._ArgumentGroup:
    """Declare file, start and loads."""
    scene_options.arguments(parser)
    group = parser.add_argument_group("where it rests")
    group.add_argument("--q", metavar="JOINT=VALUE", type=run_options.named, action="append",
                       default=[], help="coordinate to start from; again for another")  # fmt: skip
    group.add_argument("--lock", metavar="JOINT=VALUE", type=run_options.named, action="append",
                       default=[], help="coordinate that is held, by what it takes")  # fmt: skip
    group.add_argument("--set", metavar="NAME=VALUE", type=run_options.named, action="append",
                       default=[], help="value of a parameter or input")  # fmt: skip
    parser.add_argument("--json", action="store_true", help="print JSON for another program")
    return group


def model(options: argparse.Namespace) -> tuple[Scene, CompiledModel]:
    """The scene and its compiled model."""
    from ...compilation import compile
    from ..terminal import progress

    scene = scene_options.read(options)
    with progress() as show:
        show("deriving and compiling")
        return scene, compile(scene)


def loads(scene: Scene, model: CompiledModel, options: argparse.Namespace) -> dict[str, Any]:
    """Start and loads as equilibria take them."""
    values = dict(options.set)
    inputs = {name: value for name, value in values.items() if name in model.inputs}
    parameters = {name: value for name, value in values.items() if name not in inputs}
    q = {**scene.settings.get("q", {}), **dict(options.q)}
    return {"q": q, "locked": dict(options.lock), "inputs": inputs, "parameters": parameters}


def trim_arguments(group: argparse._ArgumentGroup) -> None:
    """Declare what is wanted and what is free."""
    group.add_argument("--target", metavar="NAME=VALUE", type=run_options.named, action="append",
                       default=[], help="coordinate, speed or output with this value")  # fmt: skip
    group.add_argument("--free", metavar="NAME", action="append", default=[],
                       help="input, parameter, SPEED, JOINT.driving_force that may change"
                       )  # fmt: skip


def trim_values(scene: Scene, model: CompiledModel, options: argparse.Namespace) -> dict[str, Any]:
    """Arguments of ``model.trim`` for commands that look for a required motion.

    Raises:
        ModelError: something is held.
    """
    loads_named = loads(scene, model, options)
    if loads_named.pop("locked"):
        raise ModelError(
            "--lock does not go with --target: make it a target, and give "
            "--free JOINT.driving_force"
        )
    return {
        **loads_named,
        "targets": dict(options.target),
        "free": options.free,
        "u": dict(options.u),
    }


def numbers(equilibrium: EquilibriumRecord) -> dict[str, Any]:
    """An equilibrium for JSON."""
    model = equilibrium.model
    return {
        "converged": equilibrium.converged,
        "message": equilibrium.message,
        "stable": equilibrium.stable,
        "unstable_directions": equilibrium.n_negative,
        "free_motions": list(equilibrium.free_motions),
        "iterations": equilibrium.iterations,
        "q": dict(zip(model.coordinates, equilibrium.q.tolist(), strict=True)),
        "multipliers": dict(zip(model.multipliers_of, equilibrium.lam.tolist(), strict=True)),
        "holding_forces": dict(equilibrium.holding_forces),
    }


def finite(value: float) -> float | None:
    """A number as JSON has it."""
    return float(value) if math.isfinite(value) else None
