"""What constraints leave and hold along a motion."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .calling import Array

if TYPE_CHECKING:
    from .trajectory import Trajectory


def residuals(motion: Trajectory) -> dict[str, Array]:
    """Residual (nt,) of every constraint of positions by multiplier."""
    rows = [row for row in motion.manifest["multipliers"] if row["level"] == "position"]
    if rows and "constraints" not in motion.stored:
        model = motion._model("the constraints")
        motion.stored["constraints"] = model._evaluate(
            ("constraints", None), (motion.t, motion.q, motion._r), None, None
        )
    return {row["name"]: motion.stored["constraints"][:, k] for k, row in enumerate(rows)}


def multipliers(motion: Trajectory) -> dict[str, Array]:
    """History (nt,) of every multiplier [N, N m].

    Those that the method found along with the motion, else those of the accelerations at its
    states. Where rows follow from others their forces are not unique: then one set of them.
    """
    rows = motion.manifest.get("multipliers", ())
    if rows and "multipliers" not in motion.stored:
        model = motion._model("the multipliers")
        motion.stored["multipliers"] = model.multipliers(
            motion.q, motion.u, t=motion.t, r=motion._r, **motion._own
        )
    return {row["name"]: motion.stored["multipliers"][:, k] for k, row in enumerate(rows)}
