"""A spring and a damper in series."""

from __future__ import annotations

from typing import ClassVar

from ...errors import ModelError
from ...ir.arithmetic import Scalar, norm
from ...ir.matrix import Matrix
from ...records import dataclass
from ..formulas import Lines
from ..internal_states import Internal
from ..limits import Limit, positive
from ..quantity import Place, Units, Value
from ..validation import number
from .force import Action, ForceElement, Places
from .line import PULL, SPAN, along_line, direction


@dataclass(frozen=True)
class Maxwell(ForceElement):
    """A spring in series with a damper between two frames: a strut that gives way in time.

    The length of the damper is a state ``<name>.flow``: damping d(flow)/dt = force, and
    ``force = stiffness (distance - rest_length - flow)`` pulls the frames together where it is
    positive. What
    it takes, stores and gives back is its work in the ledger. Beside a :class:`SpringDamper` it
    makes a standard linear solid.

    Args:
        frame_a, frame_b: Frames or bodies at its ends.
        stiffness: [N/m].
        damping: [N s/m].
        rest_length: Distance at which nothing pulls while flow is 0 [m].
        start: Flow at the start of a run [m].

    Raises:
        ModelError: stiffness or damping not above 0, or what is not a finite number or expression.

    Source: R. E. Roberson and R. Schwertassek, Dynamics of Multibody Systems, 1988, section 12.1.
    """

    kind: ClassVar[str] = "maxwell"
    units: ClassVar[Units] = {"stiffness": "N/m", "damping": "N*s/m", "rest_length": "m"}
    frame_a: Place
    frame_b: Place
    stiffness: Value
    damping: Value
    rest_length: Value = 0.0
    start: Value = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "start", number(self.kind, "start", self.start))
        if not isinstance(self.start, float):
            raise ModelError(f"{self.kind}: start must be a number")
        super().__post_init__()

    def limits(self) -> tuple[Limit, ...]:
        return positive("stiffness", "damping")

    def internals(self) -> tuple[Internal, ...]:
        return (Internal("flow", "m", self.start),)

    def rates(self, at: Places) -> Matrix:
        rate = self._line(at)[1] / at.data["damping"][0]
        return Matrix.vector(at.motion.graph, [rate])

    def straight(self) -> bool:
        return True

    def paired(self) -> bool:
        return True

    def act(self, at: Places) -> tuple[Action, ...]:
        along, force = self._line(at)
        return (along_line(at.motion, at.frames["a"], at.frames["b"], along * force, None),)

    def _line(self, at: Places) -> tuple[Matrix, Scalar]:
        """Its direction and its force."""
        span = at.motion.position(at.frames["b"]) - at.motion.position(at.frames["a"])
        distance = norm(*span)
        force = at.data["stiffness"][0] * (distance - at.data["rest_length"][0] - at.z[0])
        return direction(span, distance), force

    def formulas(self, at: Places) -> Lines:
        return (
            *SPAN,
            (
                "force, k the stiffness, ell_0 the free length, z the flow",
                "f = k * (ell - ell_0 - z)",
            ),
            *PULL,
            ("rate of the flow, c the damping", "zdot = f / c"),
        )
