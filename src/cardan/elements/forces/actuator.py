"""An actuator that follows its command with a lag."""

from __future__ import annotations

from typing import ClassVar

from ...errors import ModelError
from ...ir.arithmetic import Scalar
from ...ir.matrix import Matrix
from ...records import dataclass
from ..internal_states import Internal
from ..limits import Limit, not_negative, positive
from ..quantity import JointName, Units, Value
from ..validation import number
from .force import Action, ForceElement, JointLoad, Places


@dataclass(frozen=True)
class Actuator(ForceElement):
    """A motor or cylinder on a joint whose force follows the command with a first-order lag.

    lag d(force)/dt = command - force; the joint feels ``force = state cut off at +-limit``.

    Args:
        joint: Name of a joint with one speed.
        command: Wanted force [N m] or [N]: input, parameter or expression.
        lag: Time constant [s].
        limit: Largest force [N m] or [N]; None: none.
        start: Force at the start of a run [N m] or [N].

    Raises:
        ModelError: a value that is not a number or expression, a lag that is not positive or a
            negative limit.

    Source: K. J. Astrom and R. M. Murray, Feedback Systems, 2008, section 3.1.
    """

    kind: ClassVar[str] = "actuator"
    units: ClassVar[Units] = {"command": "N*m|N", "lag": "s", "limit": "N*m|N"}
    joint: JointName
    command: Value
    lag: Value
    limit: Value | None = None
    start: Value = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "start", number(self.kind, "start", self.start))
        super().__post_init__()
        if not isinstance(self.start, float):
            raise ModelError(f"{self.title}: start must be a number")

    def limits(self) -> tuple[Limit, ...]:
        return (*positive("lag", requirement="a time of more than 0 [s]"), *not_negative("limit"))

    def internals(self) -> tuple[Internal, ...]:
        return (Internal("force", "N*m|N", self.start),)

    def rates(self, at: Places) -> Matrix:
        return Matrix.vector(
            at.motion.graph, [(at.data["command"][0] - at.z[0]) / at.data["lag"][0]]
        )

    def act(self, at: Places) -> tuple[Action, ...]:
        force: Scalar = at.z[0]
        if "limit" in at.data:
            limit = at.data["limit"][0]
            force = (-limit).apply("max", limit.apply("min", force))
        load = JointLoad(at.joints["joint"], Matrix.vector(at.motion.graph, [force]))
        return (Action(joint_loads=(load,)),)
