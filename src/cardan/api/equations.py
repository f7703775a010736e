"""Equations as users hold them."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from functools import partial
from pathlib import Path
from typing import NoReturn, final

from ..arguments import checked
from ..equations.finite_elements.record import FiniteElementRecord
from ..equations.linearized.along import LinearizedAlong, along
from ..equations.linearized.linear import Linearizable
from ..equations.reading.explained import Explained
from ..errors import DerivationError
from ..notebooks import html
from ..schema.functions import FUNCTIONS
from .compiled_model import CompiledModel
from .faces import verb
from .trajectory import Trajectory


@final
class Equations(Explained, Linearizable):
    """Equations of motion M udot + h = f + tau, qdot = N(q) u + n(t, q).

    Made by :func:`cardan.derive`. Nothing is derived before it is asked for.
    """

    feasibility = verb("cardan.equations.constraints.feasibility:feasibility")
    classification = verb("cardan.equations.constraints.classification:classification")
    base_parameters = verb("cardan.equations.functions.base_parameters:base_parameters")
    to_sympy = verb("cardan.equations.reading.mechanics:mechanics")
    explain = verb("cardan.explain:explain")
    _repr_html_ = html

    @checked
    def export(
        self,
        directory: str | Path,
        functions: Sequence[object] | None = None,
        language: str = "cython",
        integrators: Sequence[str] = (),
        reproducible: bool = False,
        loops: bool | None = None,
        prefix: str = "",
        precision: str = "double",
    ) -> Path:
        """Write C that needs nothing but a C compiler, and what makes it easy to use.

        Args:
            directory: A new or empty one, or an earlier export of cardan, which is replaced.
            functions: Names such as ``"mass_matrix"``, or pairs such as ``("pose", "hand")``; by
                default the dynamics and the energy, of a closed system also what closes it, of one
                with events what happens.
            language: ``"cython"`` adds a package for NumPy, ``"casadi"`` and ``"jax"`` a module
                whose functions have exact first derivatives there, ``"c"`` leaves it at C. A
                derivative among ``functions`` that does not name p, such as ``("derivative",
                "forward_dynamics: q u")``, leaves out derivatives by parameters there.
            integrators: By their files, such as ``"dop853"``, ``"rk4"`` or ``"radau"``: their C
                comes along, and ``example.c`` simulates.
            reproducible: The flags written down forbid contraction: equal bits from every compiler.
            loops: As :func:`cardan.compile` takes it.
            prefix: Put before the names of all functions and data, such as ``"arm_"``: exports with
                different prefixes can be linked into one program. With ``language="c"``.
            precision: ``"single"`` for float instead of double everywhere, as processors of
                microcontrollers have it. With ``language="c"``.

        Returns:
            The directory. It appears whole or not at all.

        Raises:
            CodegenError: the directory holds other things; an unknown language or integrator.
            DerivationError: an unknown function; for CasADi and JAX one without a derivative.
        """
        from ..analyses.simulation.export_plan import started
        from ..codegen.export.export import export

        how = (language, integrators, reproducible, loops, prefix, precision)
        return export(self, directory, partial(started, CompiledModel), functions, *how)

    @checked
    def linearize_along(
        self,
        motion: Trajectory,
        *,
        inputs: Iterable[str] | None = None,
        outputs: Iterable[str] | None = None,
        independent: Iterable[str] | None = None,
    ) -> LinearizedAlong:
        """Linear models along a simulated motion of this system: A(t), B(t), C(t), D(t).

        Args:
            motion: In one mode all along.
            inputs, outputs, independent: As for :meth:`linearize`; what is independent stays so.

        Returns:
            Arrays along ``motion.t``; transition matrix and Floquet multipliers.

        Raises:
            DerivationError: a motion of another system, one whose modes change, or one along which
                the independent coordinates become dependent.
        """
        return along(self, motion, inputs, outputs, independent)


@final
class FiniteElementEquations(FiniteElementRecord):
    """Equations in finite-element coordinates: blocks, kinds of elements, tables of members."""

    explain = verb("cardan.explain:explain")
    _repr_html_ = html

    @checked
    def export(
        self,
        directory: str | Path,
        functions: Sequence[object] | None = None,
        language: str = "c",
        integrators: Sequence[str] = (),
        reproducible: bool = False,
        prefix: str = "",
        precision: str = "double",
    ) -> Path:
        """Write C that needs no cardan, as :meth:`Equations.export` does."""
        from ..analyses.simulation.export_plan import planned
        from ..codegen.export.finite_elements import export

        how = (language, integrators, reproducible, prefix, precision)
        plan = partial(planned, CompiledModel)
        return export(self, directory, plan, functions, *how)

    def __getattr__(self, name: str) -> NoReturn:
        # what joint coordinates offer is named with the call that gives it
        if name.startswith("_") or not hasattr(Equations, name):
            raise AttributeError(f"'FiniteElementEquations' object has no attribute '{name}'")
        cure = f" Joint coordinates have it: derive(scene, coordinates='relative').{name}"
        if self.system.segments:
            # beams have no other coordinates; what runs over their elements is there in numbers
            numbers = [f.name for f in FUNCTIONS.values() if f.elements] + ["linearize"]
            cure = f" In numbers: cd.compile(...).{name}(...)" if name in numbers else ""
        raise DerivationError(
            f"equations of '{self.system.name}' in absolute coordinates have no '{name}': their "
            f"elements have functions, see .kinds.{cure}"
        )
