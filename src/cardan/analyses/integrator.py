"""What a numerical method states about itself."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from ..runtime.compiled import CompiledModel


@dataclass(frozen=True)
class Integrator:
    """A method for initial value problems; its C functions are ``cardan_<kernel>_...``.

    Attributes:
        name: As users say it; that of SciPy where it exists.
        kernel: Its file in ``kernels`` and the middle of its C names.
        order: Order of the global error in the step.
        dense_order: The error inside one step is of order h^(dense_order + 1).
        stages: Derivatives it keeps.
        dense_rows: Rows of its dense output.
        adaptive: Whether it chooses its steps from rtol and atol.
        charted: Whether it takes quaternions by their increments (a Lie group method).
        applies: Where it is the one to take, in words.
        source: Where it comes from.
        needs: Functions of the model that it calls besides ``rhs``: fields of the run record.
        differenced: Those of them that it takes by differences where the model is large.
        multipliers: Whether it finds multipliers along with the motion.
        options: Numbers that its kernel reads, before the one that says whether it is adaptive.
        given_step: Whether it is adaptive, but steps as told where a step is given.
        suited: What it makes of itself for a model, with words to print; raises ModelError where
            that is none for it.
        lanes: Whether ``kernels/lane_<kernel>.c`` takes its steps side by side.
        elements: Whether it is one for elements in absolute coordinates alone.
    """

    name: str
    kernel: str
    order: int
    dense_order: int
    stages: int
    dense_rows: int
    adaptive: bool
    applies: str
    source: str
    charted: bool = False
    needs: tuple[str, ...] = ()
    differenced: tuple[str, ...] = ()
    multipliers: bool = False
    options: tuple[float, ...] = ()
    given_step: bool = False
    # in words a method is the same in every process
    suited: Callable[[CompiledModel, Integrator], tuple[Integrator, str]] | None = field(
        default=None, repr=False
    )
    lanes: bool = False
    elements: bool = False
