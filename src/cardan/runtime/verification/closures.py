"""Closing conditions of all joints that close circuits, dependent ones too."""

from __future__ import annotations

import numpy as np

from ..verify_circuits import relative
from .asked import ELSEWHERE, Asked


def closure(asked: Asked, of: str | None) -> float | str:
    """As the constraints say, near where circuits close, row by row of the same name."""
    if not asked.knows("constraints", "integrate"):
        return ELSEWHERE
    model = asked.model
    du = 0.1 * np.random.default_rng(9).uniform(-1, 1, (len(asked.truth.q), model.nu))
    given = {"q": asked.call("integrate", None, {"du": du})}
    own, known = (
        {name: k for k, name in enumerate(model._function(f, None).caller.entries)}
        for f in ("closure", "constraints")
    )
    both = [name for name in own if name in known]
    if not both:
        return ELSEWHERE
    value, g = (asked.call(f, None, given) for f in ("closure", "constraints"))
    a, b = value[:, [own[n] for n in both]], g[:, [known[n] for n in both]]
    if asked.adrift:
        # no state was found at which it would have to vanish
        return relative(a - b, b)
    closed = asked.call("closure")
    return max(relative(a - b, b), relative(closed, np.full_like(closed, asked.length)))


JUDGES = {"closure": closure}
