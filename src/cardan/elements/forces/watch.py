"""An event of the user: something to record, or the end of a run."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, ClassVar

from ...errors import ModelError, near, shown
from ...ir.arithmetic import Scalar
from ..internal_states import END, MARK, Event, Solved
from ..quantity import Units
from .force import Action, ForceElement, Places

THEN = {"mark": MARK, "end": END}
DIRECTIONS = {"down": (1,), "up": (-1,), "both": (1, -1)}


@dataclass(frozen=True)
class Watch(ForceElement):
    """Notes when an expression passes zero, or ends the run there; it exerts no force.

    Args:
        expression: In coordinates, speeds, motions of frames, states of elements and t.
        then: ``"mark"``: it is recorded in ``motion.events``; ``"end"``: the run ends.
        direction: ``"down"``: from positive to negative values; ``"up"``; ``"both"``.

    Raises:
        ModelError: no expression, or an unknown word.

    Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, II.6.
    """

    kind: ClassVar[str] = "watch"
    units: ClassVar[Units] = {"expression": ""}
    expression: Any
    then: str = "mark"
    direction: str = "down"

    def __post_init__(self) -> None:
        super().__post_init__()
        for name, known in (("then", THEN), ("direction", DIRECTIONS)):
            if not isinstance(getattr(self, name), str) or getattr(self, name) not in known:
                word = getattr(self, name)
                told = (
                    near(word, known) if isinstance(word, str) else f" Known: {', '.join(known)}."
                )
                raise ModelError(f"watch: {name}={shown(word)} is unknown.{told}")

    def paired(self) -> bool:
        return True

    def act(self, at: Places) -> tuple[Action, ...]:
        return ()

    def events(self) -> tuple[Event, ...]:
        signs = DIRECTIONS[self.direction]
        names = {1: "down", -1: "up"} if len(signs) > 1 else {signs[0]: ""}
        words = {1: "falls", -1: "rises"}
        kind = THEN[self.then]
        return tuple(Event(names[s], kind, f"it {words[s]} through zero") for s in signs)

    def signs(self, at: Places, solved: Solved) -> tuple[Scalar, ...]:
        value = at.data["expression"][0]
        return tuple(value * sign for sign in DIRECTIONS[self.direction])
