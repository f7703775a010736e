"""The record every formalism returns: the equations of motion of a system."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, Self

from ..arguments import checked
from ..errors import DerivationError, counted
from ..ir.function import Block, Function
from ..ir.recursion import Recursion
from ..ir.stage import stage
from ..ir.trees.assembly import Assembly, Form
from ..processes import collector_paused
from ..records import dataclass
from ..schema.blocks import ABI_ORDER
from ..schema.functions import FUNCTIONS
from ..schema.request import Request
from ..topology.system import Named, System
from .constraints.constraints import Row, rows
from .constraints.kinematic_coefficients import KinematicCoefficients
from .constraints.reaction_friction import friction_forces
from .constraints.treatments import Multipliers, Treatment
from .formalisms import FORMALISMS
from .formalisms.formalism import Formalism
from .functions import blocks
from .functions.context import Context, settled
from .functions.dynamics import Dynamics
from .functions.recipes import RECIPES, about, blocks_of, c_name, check, is_rewritable, missing
from .kinematics.kinematics import Kinematics
from .reading.counts import Counts, overview
from .recursion.looped import LOOPED, by_bodies, repeats
from .rewrites import Rewritten, candidates
from .tree_kernels.assemblies import derivative, mass_matrix, refusal
from .tree_kernels.parts import Names

if TYPE_CHECKING:
    import sympy

    pass

COUNTED = ("mass_matrix", "bias", "forward_dynamics", "inverse_dynamics")


@dataclass(frozen=True, repr=False)
class EquationRecord:
    """Equations of motion M udot + h = f + tau, qdot = N(q) u + n(t, q).

    Nothing is derived before it is asked for.

    Attributes:
        system: The system graph they belong to.
        method: Formalism.
        chosen: User-chosen generalized speeds, () for those of the joints.
        reason: Why ``method="auto"`` took this formalism, "" where the user did.
        rewrites: Rewrites of the system graph that may be applied; None: what suits the formalism.
        free: The system with all its parameters, where some were built in.
        treatment: How constraints are treated; without any it does nothing.
    """

    system: System
    method: str
    chosen: tuple[Named, ...] = ()
    reason: str = ""
    rewrites: tuple[str, ...] | None = None
    free: System | None = None
    treatment: Treatment = field(default_factory=Multipliers)
    _systems: dict[bool, list[Rewritten]] = field(default_factory=dict, compare=False)
    _rewrites_of: dict[str, tuple[str, ...]] = field(default_factory=dict, compare=False)
    _counts: dict[str, Counts] = field(default_factory=dict, compare=False)
    _functions: dict[str, Function] = field(default_factory=dict, compare=False)
    _read: dict[tuple[str, str | None], Any] = field(default_factory=dict, compare=False)

    @cached_property
    def blocks(self) -> dict[str, Block]:
        """Input blocks by letter."""
        return blocks.blocks(self.system, tuple(s.name for s in self.chosen))

    @cached_property
    def symbols(self) -> dict[tuple[str, int], sympy.Symbol]:
        """SymPy symbol of every entry of every block."""
        return blocks.symbols(self.blocks)

    @property
    def formalism(self) -> Formalism:
        """The formalism that derives them."""
        return FORMALISMS[self.method]

    @property
    def coordinates(self) -> tuple[str, ...]:
        """Names of q."""
        return self.blocks["q"].entries

    @property
    def speeds(self) -> tuple[str, ...]:
        """Names of u."""
        return self.blocks["u"].entries

    @property
    def parameters(self) -> tuple[str, ...]:
        """Names of p."""
        return self.blocks["p"].entries

    @property
    def inputs(self) -> tuple[str, ...]:
        """Names of r."""
        return self.blocks["r"].entries

    @property
    def multipliers(self) -> tuple[str, ...]:
        """Names of the Lagrange multipliers; a tree has none."""
        return tuple(row.name for row in self.constraint_rows)

    @cached_property
    def constraint_rows(self) -> tuple[Row, ...]:
        """Constraints on the speeds: name, unit and level of each."""
        return rows(self.system)

    @property
    def sources(self) -> tuple[str, ...]:
        """Literature behind the formalism, the joints and the force elements."""
        texts = [self.formalism.source]
        texts += [joint.element.source for joint in self.system.joints]
        texts += [cut.element.source for cut in self.system.cuts]
        texts += [force.element.source for force in self.system.forces]
        if self.system.closed:
            texts.append(self.treatment.source)
        return tuple(dict.fromkeys(s for s in texts if s))

    def names(self) -> list[str]:
        """Functions that :meth:`function` can derive; those of frames and joints take ``of``."""
        return [name for name in FUNCTIONS if not missing(self.system, name)]

    def c_name(self, name: str, of: str | None = None) -> str:
        """C name of a function."""
        return c_name(self.system, name, of)

    @checked
    def function(self, name: str, of: str | None = None) -> Function:
        """One function as expressions.

        Args:
            name: Such as ``"forward_dynamics"``.
            of: Frame or joint, for ``pose velocity acceleration frame_jacobian reaction``.

        Raises:
            DerivationError: no such function, frame or joint; or it does not exist for this
                system, such as udot where M is singular.
        """
        check(name, of)
        if missing(self.system, name):
            raise DerivationError(missing(self.system, name))
        symbol = self.c_name(name, of)
        if symbol not in self._functions:
            with collector_paused():
                self._functions[symbol], self._rewrites_of[symbol] = self._fewest(name, symbol, of)
        return self._functions[symbol]

    @checked
    def rewritten(self, name: str, of: str | None = None) -> tuple[str, ...]:
        """Rewrites of the system graph from which a function was derived; see :func:`derive`."""
        self.function(name, of)
        return self._rewrites_of[self.c_name(name, of)]

    def notes(self, name: str, of: str | None, form: Form) -> list[str]:
        """Remarks for the head of a generated file on the derivation of its function."""
        rewrites = self.rewritten(name, of) if isinstance(form, Function) else ()
        return [
            f"formalism: {self.method}",
            *([f"rewrites: {', '.join(rewrites)}"] if rewrites else []),
        ]

    def ways(self, name: str, of: str | None) -> list[Rewritten]:
        """Rewritten systems that a function may be derived from."""
        # friction that follows from reactions: regrouped inertia has others
        if not is_rewritable(name, of) or friction_forces(self.system) or self.system.written:
            return [((), self.system)]
        rigid = FUNCTIONS[name].displaces
        if rigid not in self._systems:
            rewrites = () if self.chosen else self.rewrites
            self._systems[rigid] = candidates(self.system, self.formalism, rewrites, rigid)
        return self._systems[rigid]

    def _fewest(self, name: str, symbol: str, of: str | None) -> tuple[Function, tuple[str, ...]]:
        """A function by the rewrites that leave the fewest operations."""
        chosen = () if FUNCTIONS[name].joint_speeds else self.chosen
        candidates_by_way = [
            (self._derive(name, symbol, of, Kinematics(system, chosen)), names)
            for names, system in self.ways(name, of)
        ]
        if len(candidates_by_way) == 1:
            return candidates_by_way[0]
        return min(candidates_by_way, key=lambda pair: sum(stage(pair[0]).operations().values()))

    @checked
    def derivative(
        self, function: str, wrt: Sequence[str] = ("q", "u", "r", "p"), of: str | None = None
    ) -> Function:
        """The derivative of a function as expressions.

        Args:
            function: Such as ``"forward_dynamics"``; ``of``: its frame or joint.
            wrt: Blocks ``t q u z r p udot tau``, or parameters and inputs by name; ``"q"`` stands
                for columns along the speeds, ``"coordinates"`` for those along q as it is stored.

        Returns:
            One output ``d_<wrt>`` for each: the shape of the function, then the columns, which
            t and single parameters and inputs do not have.

        Raises:
            DerivationError: no such function, block, parameter or input.
        """
        return self.function("derivative", str(Request(function, of, blocks_of(wrt))))

    def recursion(self, name: str) -> Recursion:
        """One function as a recursion: steps that visit the bodies, for loops over tables.

        Args:
            name: A function whose results belong to single joints or to the system, such as
                ``"forward_dynamics"`` by ``articulated``, ``"inverse_dynamics"`` or ``"bias"``.

        Raises:
            DerivationError: the function is none of these, or the formalism has no recursion.
        """
        check(name, None)
        if not self.loops(name):
            raise DerivationError(
                f"function '{name}' by method '{self.method}' is not a recursion over the bodies. "
                f"Those that are: {', '.join(n for n in FUNCTIONS if self.loops(n)) or 'none'}"
            )
        with collector_paused():
            return by_bodies(self.system, lambda k: self._derive(name, name, None, k), name)

    def form(self, name: str, of: str | None = None, loops: bool | None = None) -> Form:
        """A function as its C is written: straight-line, as loops over the bodies, by a kernel.

        Args:
            name, of: As :meth:`function` takes them.
            loops: True for loops wherever there is a recursion, False for none; by default where
                there are many bodies, and many of them alike.
        """
        if loops is not False and not self.refusal(name, of, bool(loops)):
            with collector_paused():
                assembly = self._assembly(name, of, loops)
            if assembly is not None:
                return assembly
        many = len(self.system.bodies) > LOOPED if loops is None else loops
        if many and of is None and self.loops(name):
            recursion = self.recursion(name)
            if loops or repeats(recursion):
                return recursion
        return self.function(name, of)

    def refusal(self, name: str, of: str | None = None, short: bool = False) -> str:
        """Why a function is not assembled by a kernel over the tree, "" where it may be.

        Args:
            name, of: As :meth:`function` takes them.
            short: Whether short trees may be, too.
        """
        return refusal(self.system, name, of, bool(self.chosen), short)

    def _assembly(self, name: str, of: str | None, loops: bool | None) -> Assembly | None:
        """A function by a kernel over the tree; None where forces change by more than it takes."""
        names = Names(
            self.c_name(name, of),
            about(name, of),
            tuple(self.blocks[letter] for letter in ABI_ORDER),
            blocks.labels(self.blocks)[0],
            self._owners,
        )
        if name == "mass_matrix":
            return mass_matrix(self.system, names, loops)
        assembly = derivative(self.system, names, Request.read(of or ""), loops)
        return None if isinstance(assembly, str) else assembly

    def loops(self, name: str) -> bool:
        """True when a function can be derived as a recursion."""
        return not self.chosen and not self.system.closed and name in self.formalism.loops

    @property
    def follows(self) -> bool:
        """True when loops determine coordinates that :meth:`named` has names for."""
        return bool(self.system.closures) and not self.chosen

    def named_function(self, name: str) -> tuple[Function, KinematicCoefficients]:
        """A function with what closed loops determine under names; see :meth:`named`."""
        coefficients = KinematicCoefficients.of(self.system, self.blocks)
        # a method that differentiates energies would have to differentiate what has names
        plain = replace(self.without_rewrites.fresh, method="composite")
        k = Kinematics(self.system, coefficients=coefficients)
        return plain._derive(name, self.c_name(name), None, k), coefficients

    def _derive(self, name: str, symbol: str, of: str | None, k: Kinematics) -> Function:
        labels = blocks.labels(self.blocks)
        context = Context(Dynamics(k, self.method, self.treatment), *labels, of)
        results = settled(context, RECIPES[name](context))
        return Function(
            symbol,
            k.graph,
            tuple(context.extra_blocks.get(letter, self.blocks[letter]) for letter in ABI_ORDER),
            results,
            self._owners,
            about(name, of),
        )

    @property
    def _owners(self) -> tuple[str, ...]:
        """Joints and bodies, forces and constraints: the order of sections."""
        owners = [
            owner
            for joint, body in zip(self.system.joints, self.system.bodies, strict=True)
            for owner in (joint.name, body.name)
        ]
        owners += [force.name for force in self.system.forces]
        owners += [row.owner for row in self.constraint_rows]
        return tuple(dict.fromkeys(owners))

    # readable forms

    @property
    def operations(self) -> dict[str, Counts]:
        """Operators of M, h, forward (where it exists) and inverse dynamics at every call.

        Each counts by operator, by body, joint and force element in ``.blocks``, and what
        parameters alone determine in ``.prepared``.
        """
        counts = {}
        for name in COUNTED:
            try:
                counts[name] = self.operations_of(name)
            except DerivationError:
                # M is singular, or the formalism does not take the joints: the rest can be shown
                if name != "forward_dynamics":
                    raise
        return counts

    @checked
    def operations_of(self, name: str, of: str | None = None) -> Counts:
        """Operators of one function as its C has them, after all passes."""
        c_name = self.c_name(name, of)
        if c_name not in self._counts:
            self._counts[c_name] = Counts(self.function(name, of), self.rewritten(name, of))
        return self._counts[c_name]

    @property
    def gain(self) -> dict[str, tuple[int, int]]:
        """Operations at every call, and what they were without ``specialize=``; {} without it."""
        if self.free is None:
            return {}
        before = replace(self.fresh, system=self.free, free=None).operations
        return {
            name: (counts.total, before[name].total) for name, counts in self.operations.items()
        }

    @property
    def fresh(self) -> Self:
        """The same with nothing derived."""
        return replace(self, _systems={}, _rewrites_of={}, _counts={}, _functions={}, _read={})

    def with_rewrites(self, rewrites: tuple[str, ...]) -> Self:
        """The same equations by these rewrites only."""
        return replace(self.fresh, rewrites=rewrites)

    @cached_property
    def without_rewrites(self) -> Self:
        """The same without rewrites: in the frames and numbers of the user, for reading."""
        return self if self.rewrites == () else self.with_rewrites(())

    def __repr__(self) -> str:
        bodies = counted(len(self.system.bodies), "body", "bodies")
        coordinates = counted(len(self.coordinates), "coordinate")
        return f"Equations('{self.system.name}', {self.method}: {bodies}, {coordinates})"

    def __str__(self) -> str:
        return overview(self)
