"""Check of a pose that a user wrote: the frames of the joint coincide at the default q."""

from __future__ import annotations

import math

from ...elements.joints.joint import Joint
from ...errors import ModelError
from ...ir.matrix import Matrix
from ..conversion import Converter
from ..system import Nodes

ROUNDING = 1e-9  # of numbers that a user types


def check_coincidence(
    convert: Converter, name: str, element: Joint, data: dict[str, tuple[int, int, Nodes]]
) -> None:
    """Evaluate a custom pose at its default coordinates and the default parameters.

    Raises:
        ModelError: the pose there is not the identity.
    """
    if not element.coincident or not any(q.local for q in element.quantities().values()):
        return
    graph = convert.graph
    q = Matrix.vector(graph, [c.default for c in element.coordinates])
    matrices = {key: Matrix(graph, *entry) for key, entry in data.items()}
    rotation, position = element.pose(q, **matrices)
    values = convert.defaults([*rotation.nodes, *position.nodes])
    identity = [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]
    off = [abs(a - b) for a, b in zip(values, identity, strict=True)]
    if not all(math.isfinite(x) and x <= ROUNDING for x in off):
        raise ModelError(
            f"joint '{name}' ({element.kind}): its frames do not coincide where all coordinates "
            f"are 0: rotation {[round(v, 6) for v in values[:9]]}, position "
            f"{[round(v, 6) for v in values[9:]]}. Put what is left there into the parent frame"
        )
