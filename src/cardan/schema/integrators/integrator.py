"""Everything that an integrator says of itself but its arithmetic, which is C."""

from __future__ import annotations

from ...records import dataclass


@dataclass(frozen=True)
class Integrator:
    """A method for initial value problems.

    Attributes:
        name: As users say it; that of SciPy where it exists.
        kernel: Its file in ``kernels``, which ends with ``cardan_<kernel>_method``.
        order: Order of the global error in the step.
        dense_order: The error inside one step is of order h^(dense_order + 1).
        adaptive: Whether it chooses its steps from rtol and atol.
        charted: Whether it takes quaternions by their increments (a Lie group method).
        applies: Where it is the one to take, in words.
        source: Where it comes from.
        needs: Functions of the model that it calls besides ``rhs``: fields of the run record.
        differenced: Those of them that it takes by differences where the model is large.
        multipliers: Whether it finds multipliers along with the motion.
        options: Numbers that its kernel reads, before the one that says whether it is adaptive.
        fixed_step_on_request: Whether it is adaptive, but steps as told where a step is given.
        conditions: What it asks of a model, by the names of
            ``analyses/simulation/method_requirements.py``, in this order; some choose options
            for the model.
        lanes: Whether ``kernels/lane_<kernel>.c`` takes its steps side by side.
        elements: Whether it is one for elements in absolute coordinates alone.
        tableau: Of a Runge-Kutta method without a class in SciPy: rows of a, those of an explicit
            one up to the diagonal, then b.
    """

    name: str
    kernel: str
    order: int
    dense_order: int
    adaptive: bool
    applies: str
    source: str
    charted: bool = False
    needs: tuple[str, ...] = ()
    differenced: tuple[str, ...] = ()
    multipliers: bool = False
    options: tuple[float, ...] = ()
    fixed_step_on_request: bool = False
    conditions: tuple[str, ...] = ()
    lanes: bool = False
    elements: bool = False
    tableau: tuple[tuple[float, ...], ...] = ()

    def called(self, elements: bool, states: bool) -> tuple[str, ...]:
        """Functions that it calls of a model besides ``rhs``.

        Args:
            elements: Whether the model consists of elements in tables, which assemble tangents and
                have the rates of their internal states.
            states: Whether the model has internal states.
        """
        without = {*(self.differenced if elements and "assembled" in self.conditions else ())}
        if elements or not states:
            without.add("internal_rates")
        return tuple(name for name in self.needs if name not in without)
