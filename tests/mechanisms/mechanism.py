"""What a member of the zoo states about itself."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field

import numpy as np

import cardan as cd
from cardan.equations.formalisms import FORMALISMS

Values = Mapping[str, object]
METHODS = tuple(FORMALISMS)
# a coupled joint, such as a geared rotor that is a body, has no speed of its own: the elimination
# of one joint after the other has no place for it
COUPLED = tuple(name for name, formalism in FORMALISMS.items() if formalism.couples)


@dataclass(frozen=True)
class State:
    """Initial values by joint; joints that are not named start at their defaults."""

    q: Values = field(default_factory=dict)
    u: Values = field(default_factory=dict)


@dataclass(frozen=True)
class Mechanism:
    """A scene with what the laws need to know about it.

    Attributes:
        name: Name in test output.
        build: Makes the scene afresh.
        states: Regular initial states; a motion of 10 s from the first stays regular.
        conservative: Undamped, unforced, no prescribed motion: total energy is constant.
        methods: Formalisms that take it; with a coupled joint ``COUPLED``.
        margin: Distance [rad] of a rotation matrix to the border of the domain of the rotation
            parameters of joint ``guarded``.
        guarded: The joint that ``margin`` speaks about.
        frame: A frame of the child side of that joint.
    """

    name: str
    build: Callable[[], cd.Scene]
    states: tuple[State, ...]
    conservative: bool = True
    methods: tuple[str, ...] = METHODS
    margin: Callable[[np.ndarray], float] | None = None
    guarded: str = ""
    frame: str = ""

    def __repr__(self) -> str:
        return self.name
