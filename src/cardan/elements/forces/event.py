"""An event of the user: a time to record, or the end of a run."""

from __future__ import annotations

from typing import ClassVar

from ...errors import ModelError, brief, near
from ...ir.arithmetic import Scalar
from ...records import dataclass
from ..internal_states import HALT, MARK, EventSpec, Solved
from ..quantity import Units, Value
from .force import Action, ForceElement, Places

DIRECTIONS = {"down": (1,), "up": (-1,), "both": (1, -1)}


@dataclass(frozen=True)
class Event(ForceElement):
    """Records when an expression passes zero, or ends the run there; it exerts no force.

    Args:
        expression: In coordinates, speeds, motions of frames, states of elements and t.
        terminal: True: the run ends. False: it goes on, and ``motion.events`` has the time.
        direction: ``"down"``: from positive to negative values; ``"up"``; ``"both"``.

    Raises:
        ModelError: no expression, an unknown direction, or terminal neither True nor False.

    Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, II.6.
    """

    kind: ClassVar[str] = "event"
    units: ClassVar[Units] = {"expression": ""}
    expression: Value
    terminal: bool = False
    direction: str = "down"

    def __post_init__(self) -> None:
        super().__post_init__()
        if not isinstance(self.direction, str) or self.direction not in DIRECTIONS:
            raise ModelError(
                f"event: direction={brief(self.direction)} is unknown."
                f"{near(self.direction, DIRECTIONS)}"
            )

    def paired(self) -> bool:
        return True

    def act(self, at: Places) -> tuple[Action, ...]:
        return ()

    def events(self) -> tuple[EventSpec, ...]:
        signs = DIRECTIONS[self.direction]
        names = {1: "down", -1: "up"} if len(signs) > 1 else {signs[0]: ""}
        verbs = {1: "falls", -1: "rises"}
        kind = HALT if self.terminal else MARK
        return tuple(EventSpec(names[s], kind, f"it {verbs[s]} through zero") for s in signs)

    def signs(self, at: Places, solved: Solved) -> tuple[Scalar, ...]:
        value = at.data["expression"][0]
        return tuple(value * sign for sign in DIRECTIONS[self.direction])
