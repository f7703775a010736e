"""What commands share that look for a wanted motion: ``--want`` and ``--free``."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from ..errors import ModelError
from . import resting, running

if TYPE_CHECKING:
    from ..model import Model
    from ..runtime.compiled import CompiledModel


def arguments(group: argparse._ArgumentGroup) -> None:
    """Declare what is wanted and what is free."""
    group.add_argument("--want", metavar="NAME=VALUE", type=running.named, action="append",
                       default=[], help="coordinate, speed or output with this value")  # fmt: skip
    group.add_argument("--free", metavar="NAME", action="append", default=[],
                       help="input, parameter, JOINT.force or SPEED that may change")  # fmt: skip


def asked(scene: Model, model: CompiledModel, options: argparse.Namespace) -> dict[str, Any]:
    """What ``model.trim`` takes.

    Raises:
        ModelError: something is held.
    """
    given = resting.loads(scene, model, options)
    if given.pop("hold"):
        raise ModelError("--hold does not go with --want: want it, and give --free JOINT.force")
    return {**given, "wanted": dict(options.want), "free": options.free, "u": dict(options.u)}
