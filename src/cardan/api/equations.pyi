"""Written from the functions of its verbs: pytest tests/golden/test_verbs.py --accept"""

from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import final

from numpy.typing import ArrayLike

from ..equations.constraints.classification import Classification
from ..equations.constraints.feasibility import Feasibility
from ..equations.finite_elements.record import FiniteElementRecord
from ..equations.functions.base_parameters import BaseParameters
from ..equations.linearized.along import LinearizedAlong
from ..equations.linearized.linear import Linearizable
from ..equations.reading.explained import Explained
from ..equations.reading.mechanics import Mechanics
from ..schema.cost import Cost
from .trajectory import Trajectory

@final
class Equations(Explained, Linearizable):
    """Equations of motion M udot + h = f + tau, qdot = N(q) u + n(t, q).

    Made by :func:`cardan.derive`. Nothing is derived before it is asked for.
    """
    def feasibility(
        self,
        seed: int = 1,
    ) -> Feasibility:
        """Try to close all loops at the default parameters.

        Args:
            seed: Of the starts beside the initial values.
        """
    def classification(
        self,
        seed: int = 1,
    ) -> Classification:
        """Look at all constraints.

        Args:
            seed: Of the positions at which integrability is measured.
        """
    def base_parameters(
        self,
    ) -> BaseParameters:
        """The base parameters of inverse dynamics, in the frames of the user's joints.
        """
    def to_sympy(
        self,
    ) -> Mechanics:
        """The equations with functions of time for q, u and r.

        Raises:
            DerivationError: they are too long to be written out.
        """
    def explain(
        self,
        path: str | Path,
        progress: Callable[[str], object] | None = None,
        notation: str = "cardan",
    ) -> Path:
        """Write equations as a page.

        Args:
            path: Its ending says how: ``.html``, ``.tex`` or ``.md``.
            progress: Told what is under way.
            notation: Whose symbols the page uses: ``"cardan"``, ``"rs"`` (Roberson and Schwertassek),
                ``"gc"`` (Géradin and Cardona) or ``"kane"`` (Kane and Levinson).

        Returns:
            The file.

        Raises:
            DerivationError: another ending, an unknown notation.
        """
    def export(self, directory: str | Path, functions: Sequence[object] | None=None, language: str | None=None, integrators: Sequence[str]=(), reproducible: bool=False, loops: bool | None=None, prefix: str='', precision: str='double', *, gradient: Cost | None=None, fmi: str | None=None, kinds: Sequence[str] | None=None, platforms: Sequence[str] | None=None, q: Mapping[str, ArrayLike] | None=None, u: Mapping[str, ArrayLike] | None=None) -> Path:
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
    def linearize_along(self, motion: Trajectory, *, inputs: Iterable[str] | None=None, outputs: Iterable[str] | None=None, independent: Iterable[str] | None=None) -> LinearizedAlong:
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

@final
class FiniteElementEquations(FiniteElementRecord):
    """Equations in finite-element coordinates: blocks, kinds of elements, tables of members.
    """
    def explain(
        self,
        path: str | Path,
        progress: Callable[[str], object] | None = None,
        notation: str = "cardan",
    ) -> Path:
        """Write equations as a page.

        Args:
            path: Its ending says how: ``.html``, ``.tex`` or ``.md``.
            progress: Told what is under way.
            notation: Whose symbols the page uses: ``"cardan"``, ``"rs"`` (Roberson and Schwertassek),
                ``"gc"`` (Géradin and Cardona) or ``"kane"`` (Kane and Levinson).

        Returns:
            The file.

        Raises:
            DerivationError: another ending, an unknown notation.
        """
    def export(self, directory: str | Path, functions: Sequence[object] | None=None, language: str | None=None, integrators: Sequence[str]=(), reproducible: bool=False, prefix: str='', precision: str='double', *, gradient: Cost | None=None, fmi: str | None=None, kinds: Sequence[str] | None=None, platforms: Sequence[str] | None=None, q: Mapping[str, ArrayLike] | None=None, u: Mapping[str, ArrayLike] | None=None) -> Path:
        """Write C that needs no cardan, or an FMU, as :meth:`Equations.export` does."""
