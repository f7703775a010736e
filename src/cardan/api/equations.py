"""Equations as users hold them."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from functools import partial
from pathlib import Path
from typing import NoReturn, final

from numpy.typing import ArrayLike

from ..arguments import checked
from ..equations.finite_elements.record import FiniteElementRecord
from ..equations.linearized.along import LinearizedAlong, along
from ..equations.linearized.linear import Linearizable
from ..equations.reading.explained import Explained
from ..errors import DerivationError
from ..notebooks import html
from ..schema.cost import Cost
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
        language: str | None = None,
        integrators: Sequence[str] = (),
        reproducible: bool = False,
        loops: bool | None = None,
        prefix: str = "",
        precision: str = "double",
        *,
        gradient: Cost | None = None,
        fmi: str | None = None,
        kinds: Sequence[str] | None = None,
        platforms: Sequence[str] | None = None,
        q: Mapping[str, ArrayLike] | None = None,
        u: Mapping[str, ArrayLike] | None = None,
    ) -> Path:
        """Write C that needs nothing but a C compiler, or an FMU that other programs simulate.

        Args:
            directory: A new or empty one, or an earlier export of cardan, which is replaced. A
                name that ends with ``.fmu``: the file of a Functional Mock-up Unit.
            functions: Names such as ``"mass_matrix"``, or pairs such as ``("pose", "hand")``; by
                default the dynamics and the energy, of a closed system also what closes it, of one
                with events what happens.
            language: ``"cython"`` adds a package for NumPy (default), ``"casadi"`` and ``"jax"`` a
                module whose functions have exact first derivatives there, ``"wasm"`` WebAssembly
                and a module of JavaScript, ``"c"`` leaves it at C. With CasADi and JAX a derivative
                among ``functions`` that does not name p, such as ``("derivative",
                "forward_dynamics: q u")``, leaves out derivatives by parameters.
            integrators: By their files, such as ``"dop853"``, ``"rk4"`` or ``"radau"``: their C
                comes along, and ``example.c`` simulates. An FMU takes the first one for
                co-simulation, ``"dop853"`` where none is named.
            reproducible: The flags written down forbid contraction: equal bits from every compiler.
            loops: As :func:`cardan.compile` takes it.
            prefix: Put before the names of all functions and data, such as ``"arm_"``: exports with
                different prefixes can be linked into one program. With ``language="c"``.
            precision: ``"single"`` for float instead of double everywhere, as processors of
                microcontrollers have it. With ``language="c"``.
            gradient: A cost, ``cd.cost(final="elbow^2")``: C that runs a motion and sweeps back
                over its steps comes along, ``motion_gradient.h``; with NumPy a function
                ``gradient``, with JAX ``cost``. With ``integrators`` ``"dop853"``, ``"rk45"``,
                ``"rk4"``, ``"radau"``.
            fmi: Of an FMU: version ``"3.0"`` (default) or ``"2.0"``.
            kinds: Of an FMU: ``"me"`` (model exchange) and ``"cs"`` (co-simulation); by default
                both, of elements in absolute coordinates, such as beams, co-simulation alone.
            platforms: Of an FMU: ``"linux"``, ``"linux-aarch64"``, ``"windows"``, ``"macos"``,
                ``"macos-x86_64"``; by default this machine's; () for sources alone. Binaries for
                other machines are linked by ziglang, not run.
            q, u: Of an FMU: coordinates and speeds to start from by name, as ``simulate`` has
                them.

        Returns:
            The directory or file. It appears whole or not at all.

        Raises:
            CodegenError: the directory holds other things; an unknown language, integrator or
                platform; an option of the other kind of export. ModelError: a start that loops
                cannot be closed with. BuildError: the binaries of an FMU cannot be compiled.
            DerivationError: an unknown function; for CasADi and JAX one without a derivative.
        """
        from ..analyses.simulation.export_plan import started
        from ..codegen.export.export import export
        from ..codegen.fmu.export import of_joints
        from ..codegen.fmu.request import FmuOptions, request_of
        from ..runtime.build.unit_binary import unit_binary

        foreign: dict[str, object] = {
            "functions": functions, "language": language, "loops": loops, "prefix": prefix
        }  # fmt: skip
        foreign |= {"precision": precision, "gradient": gradient}
        options, name = FmuOptions(fmi, kinds, platforms, q, u), self.system.name
        fmu = request_of(directory, name, False, options, foreign, integrators, reproducible)
        start = partial(started, CompiledModel, q=q, u=u)
        if fmu is not None:
            return of_joints(self, fmu, start, unit_binary)
        how = (language or "cython", integrators, reproducible, loops, prefix, precision, gradient)
        return export(self, directory, start, functions, *how)

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
        language: str | None = None,
        integrators: Sequence[str] = (),
        reproducible: bool = False,
        prefix: str = "",
        precision: str = "double",
        *,
        gradient: Cost | None = None,
        fmi: str | None = None,
        kinds: Sequence[str] | None = None,
        platforms: Sequence[str] | None = None,
        q: Mapping[str, ArrayLike] | None = None,
        u: Mapping[str, ArrayLike] | None = None,
    ) -> Path:
        """Write C that needs no cardan, or an FMU, as :meth:`Equations.export` does."""
        from ..analyses.simulation.export_plan import planned
        from ..codegen.export.finite_elements import export
        from ..codegen.export.gradient import check
        from ..codegen.fmu.export import of_elements
        from ..codegen.fmu.request import FmuOptions, request_of
        from ..runtime.build.unit_binary import unit_binary

        foreign: dict[str, object] = {
            "functions": functions,
            "language": language,
            "prefix": prefix,
        }
        foreign |= {"precision": precision, "gradient": gradient}
        options, name = FmuOptions(fmi, kinds, platforms, q, u), self.system.name
        fmu = request_of(directory, name, True, options, foreign, integrators, reproducible)
        plan = partial(planned, CompiledModel, q=q, u=u)
        if fmu is not None:
            return of_elements(self, fmu, plan, unit_binary)
        how = (language or "c", integrators, reproducible, prefix, precision)
        check(gradient, language or "c", integrators, precision, name)
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
