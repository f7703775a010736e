"""Where a run of elements in tables starts: circuits are closed next to what was named."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import ModelError
from ..runtime.absolute.assembled import Assembled
from ..runtime.closing import size_of
from ..runtime.compiled import CompiledModel
from ..runtime.initial import entries

Array = NDArray[np.float64]
MOST = 60
CLOSED, GOOD = 1e-12, 1e-9  # gaps against the size of the scene: sought, and good enough


def meshed_start(model: CompiledModel, x: Array, q: Any, u: Any, t: float, r: Array) -> Array:
    """A state (nx,) whose constraints hold, named coordinates and speeds kept as they are.

    Args:
        model: In absolute coordinates.
        x: The start as it was named, with defaults.
        q, u: As the user gave them.
        t, r: Time and inputs.

    Raises:
        ModelError: no state near it fulfills the constraints.
    """
    place, speed, internal = model.parts_of(x)
    given = {"t": t, "r": r, "z": internal}
    held = _held(model, q, "q")
    scale = max(size_of(model), float(np.abs(place).max(initial=0.0)), 1e-9)
    positions = sum(row["level"] == "position" for row in model.manifest["multipliers"])
    place = place.copy()
    gap = np.inf
    for _ in range(MOST if positions else 0):
        found = _closed(model, "close_position", place, speed, held, given)
        last, gap = gap, float(np.abs(found[model.nq :]).max(initial=0.0))
        if gap <= CLOSED * scale or (gap <= GOOD * scale and gap >= 0.5 * last):
            break
        place = found[: model.nq]
        _normalize(model, place)
    else:
        if positions:
            raise ModelError(_open(model, found[model.nq :], place))
    found = _closed(model, "close_velocity", place, speed, _held(model, u, "u"), given)
    return np.concatenate([place, found[: model.nu], internal])


def _held(model: CompiledModel, named: Any, letter: str) -> Array:
    """1 for the speeds (nu,) along which nothing may change."""
    held = np.zeros(model.nu)
    if not isinstance(named, Mapping) or not named:
        return held
    places = entries(model.manifest, letter)
    sizes = {"q": model.nq, "u": model.nu}[letter]
    known = {k for name in named for k in range(*places[name].indices(sizes))}
    for joint in model.manifest["joints"]:
        (start, count), (first, speeds) = joint["q"], joint["u"]
        if letter == "u":
            held[[k for k in range(first, first + speeds) if k in known]] = 1.0
        elif known & set(range(start, start + count)):
            own = count == speeds
            held[[first + k for k in range(speeds) if not own or start + k in known]] = 1.0
    return held


def _closed(
    model: CompiledModel, name: str, q: Array, u: Array, held: Array, given: dict[str, Any]
) -> Array:
    source = model._source
    assert isinstance(source, Assembled)
    return source.results(model).closed(name, q, u, held, given)


def _normalize(model: CompiledModel, q: Array) -> None:
    entries = np.array(model.manifest["quaternions"], dtype=np.intp)[:, None] + np.arange(4)
    q[entries] /= np.linalg.norm(q[entries], axis=1)[:, None]


def _open(model: CompiledModel, gaps: Array, q: Array) -> str:
    """What cannot be closed."""
    k = int(np.argmax(np.abs(gaps)))
    row = model.manifest["multipliers"][k]
    return (
        f"the start cannot be assembled: '{row['name']}' stays open by {abs(gaps[k]):.3g}. "
        f"Name other coordinates of the circuit of joint '{row['joint']}', or fewer"
    )
