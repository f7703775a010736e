"""Times at which a model jumps: comparisons of t, such as of ``Piecewise``, that change there.

Steps end at them, and what is evaluated at such an end is evaluated one rounding inside the segment
that the step belongs to: both sides of the jump are seen from their own side, whatever the
comparison says of the time itself.
"""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from ...arrays import Array
from ...ir.function import live
from ...ir.serialize import from_dict
from ...ir.straight_line import repeated
from ...runtime.models.loaded_model import LoadedModel
from .signals import Signals

FUNCTION = "time_jumps"
LOOKS = 4097  # times of a span at which every comparison is looked at
FEW = 65  # where the caller steps
HALVINGS = 200


def stops_of(
    model: LoadedModel,
    input_signals: Signals,
    start: float,
    end: float,
    looks: int = LOOKS,
    more: Iterable[float] = (),
) -> list[float]:
    """Times at which steps must end, in their direction: corners of inputs, jumps, the end.

    ``more`` are others inside, such as those of samples.
    """
    inside = {*input_signals.corners(start, end), *time_jumps(model, start, end, looks), *more}
    return [*sorted(inside, reverse=end < start), end]


def jumps(model: LoadedModel) -> bool:
    """True when comparisons of the time make a model jump."""
    if FUNCTION not in model._derived:
        model._derived[FUNCTION] = FUNCTION in model.saved
    return bool(model._derived[FUNCTION])


def jump_parameters(model: LoadedModel) -> tuple[str, ...]:
    """Names of the parameters that decide when a model jumps."""
    if not jumps(model):
        return ()
    function = from_dict(model._objects.saved()[FUNCTION])
    roots = [node for output in function.outputs for node in output.nodes]
    nodes = (function.graph.nodes[i] for i in live(function.graph, roots))
    places = {node[2] for node in nodes if node[:2] == ("var", "p")}
    return tuple(name for k, name in enumerate(model.parameters) if k in places)


def time_jumps(model: LoadedModel, start: float, end: float, looks: int = LOOKS) -> list[float]:
    """Times strictly inside a span at which the model jumps, in the direction of the span.

    A comparison that changes twice between two of the looks is not seen.
    """
    if not jumps(model) or start == end:
        return []

    def compared(t: Array) -> Array:
        p = model.parameters.vector
        jumps = model._evaluate_saved(FUNCTION, p=p, t=t[:, None])["jumps"]
        return np.broadcast_to(np.asarray(jumps), (len(t), np.shape(jumps)[-1]))

    at_one = repeated(model._objects.function(FUNCTION))
    p = model.parameters.vector.tolist()
    times = np.linspace(start, end, looks)
    holds = compared(times) < 0
    instants = set[float]()
    for k, which in zip(*np.nonzero(holds[1:] != holds[:-1]), strict=True):
        low, high = float(times[k]), float(times[k + 1])
        for _ in range(HALVINGS):
            middle = 0.5 * (low + high)
            if middle in (low, high):
                break
            if (at_one({"p": p, "t": [middle]})["jumps"][which] < 0) == holds[k, which]:
                low = middle
            else:
                high = middle
        # where both sides are equal neither neighbor is on the wrong one, whether < or <= is asked
        equal = at_one({"p": p, "t": [low]})["jumps"][which] == 0
        instants.add(low if equal else high)
    low, high = min(start, end), max(start, end)
    return sorted((t for t in instants if low < t < high), reverse=end < start)
