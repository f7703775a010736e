"""What a numerical method states about itself."""

from __future__ import annotations

from dataclasses import dataclass


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
        applies: Where it is the one to take, in words.
        source: Where it comes from.
        needs: Functions of the model that it calls besides ``rhs``: fields of the run record.
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
    needs: tuple[str, ...] = ()
