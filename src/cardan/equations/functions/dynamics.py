"""The dynamics of a tree by one formalism: M, h, tau and udot."""

from __future__ import annotations

from functools import cached_property

from ...errors import DerivationError
from ...ir.arithmetic import Scalar
from ...ir.function import Function, Output
from ...ir.graph import ONE, ZERO, SystemNames
from ...ir.interpreter import evaluate
from ...ir.matrix import Matrix
from ...ir.solve import solve
from ..constraints.constraints import Constraints
from ..constraints.driven_rows import DrivenRows, driven_rows
from ..constraints.reaction_friction import ReactionFriction, friction_forces, solved, with_values
from ..constraints.treatments import Bound, Labels, Multipliers, Treatment
from ..formalisms import FORMALISMS
from ..kinematics.kinematics import Kinematics
from ..kinematics.loads import Loads, applied, none

DEFAULT_TREATMENT = Multipliers()
# of the largest mass: forces of constraint that nearly cancel on less leave accelerations rounded
LIGHT = 1e-3


class Dynamics:
    """Expressions of the dynamics, derived when asked for.

    Args:
        k: Motion of the tree.
        method: Name of the formalism.
        treatment: How constraints are treated.
    """

    def __init__(
        self, k: Kinematics, method: str, treatment: Treatment = DEFAULT_TREATMENT
    ) -> None:
        self.k = k
        self.formalism = FORMALISMS[method]
        self.treatment = treatment
        # (tau, udot, multipliers) of everything that was solved for
        self.solutions: list[tuple[Matrix, Matrix, Matrix]] = []
        self._bound: dict[tuple[object, ...], tuple[Matrix, Matrix]] = {}
        # friction that follows from reactions, once accelerations are known
        self.friction_forces = ReactionFriction({}, {})
        self._in_friction = False

    @cached_property
    def loads(self) -> Loads:
        return applied(self.k)

    @cached_property
    def gravity(self) -> Matrix:
        return self.k.vector(self.k.system.gravity)

    def block(self, name: str, count: int) -> Matrix:
        """An input block as a vector."""
        return Matrix(self.k.graph, count, 1, [self.k.graph.var(name, i) for i in range(count)])

    @cached_property
    def tau(self) -> Matrix:
        return self.block("tau", self.k.system.nu)

    @cached_property
    def mass_matrix(self) -> Matrix:
        """M (nu, nu)."""
        return self.formalism.mass_matrix(self.k, none(self.k))

    def bias(self, gravity: bool = True, moving: bool = True) -> Matrix:
        """h (nu, 1), or its part of gravity or velocities alone."""
        down = self.gravity if gravity else Matrix.zeros(self.k.graph, 3)
        return self.formalism.bias(self.k, none(self.k), down, moving)

    def forces(self) -> Matrix:
        """f (nu, 1): applied forces of the model."""
        return self.formalism.forces(self.k, self.loads)

    def inverse(self, udot: Matrix) -> Matrix:
        """tau (nu, 1) with M udot + h = f + tau."""
        if self.formalism.inverse is None:
            return self.mass_matrix @ udot + self.bias() - self.forces()
        return self.formalism.inverse(self.k, udot, self.loads, self.gravity)

    def forward(self, tau: Matrix) -> Matrix:
        """udot (nu, 1).

        Raises:
            DerivationError: M is structurally singular; names the joints.
        """
        if self.k.system.closed:
            return self.bound(tau)[0]
        udot, none = self._free(tau), Matrix.zeros(self.k.graph, 0)
        self.solutions.append((tau, udot, none))
        return self._with_friction(tau, udot, none)[0]

    def _with_friction(self, tau: Matrix, udot: Matrix, lam: Matrix) -> tuple[Matrix, Matrix]:
        """udot and lam with the friction that their reactions make."""
        if self._in_friction or not friction_forces(self.k.system):
            return udot, lam
        self._in_friction = True
        self.friction_forces = solved(self, tau, udot)
        self._in_friction = False
        values = self.friction_forces.values
        return with_values(udot, values), with_values(lam, values)

    def _free(self, tau: Matrix) -> Matrix:
        """udot of a tree: ``udot = M⁻¹ drive`` by ``factor = L, D with M = Lᵀ D L``."""
        if self.formalism.forward is not None:
            return self.formalism.forward(self.k, tau, self.loads, self.gravity)
        self._refuse_massless()
        self.k.graph.describe(Dynamics._free)
        drive = self._drive(tau)
        with self.k.graph.made_by("M", "factor"):
            names = SystemNames("M", self.k.speed_names, ("",))
            udot = solve("spd", self.mass_matrix, drive, names) if drive.rows else drive
        return self._label(udot, "udot")

    def _drive(self, tau: Matrix) -> Matrix:
        """Forces that accelerate (nu, 1): ``drive = tau + f - h``."""
        self.k.graph.describe(Dynamics._drive)
        zero_udot = Matrix.zeros(self.k.graph, self.k.system.nu)
        return self._label(tau - self.inverse(zero_udot), "drive")

    @cached_property
    def constraints(self) -> Constraints:
        """Constraints on the speeds."""
        return Constraints(self.k)

    @cached_property
    def driven_rows(self) -> DrivenRows:
        """Shares of prescribed joints in relations and in what elements hold."""
        return driven_rows(self.constraints)

    def bound(self, tau: Matrix) -> tuple[Matrix, Matrix]:
        """udot (nu, 1) and the multipliers (m, 1) of a system with constraints.

        Raises:
            DerivationError: the formalism takes no constraints.
        """
        key = (tau.nodes, id(self.loads))
        if key not in self._bound:
            self._bound[key] = self._accelerations(tau)
        return self._with_friction(tau, *self._bound[key])

    def _accelerations(self, tau: Matrix) -> tuple[Matrix, Matrix]:
        if not self.formalism.binds:
            names = ", ".join(f"'{name}'" for name in dict.fromkeys(self._owners()))
            raise DerivationError(
                f"method '{self.formalism.name}' takes no constraints, but here are those of "
                f"{names}: use method='composite' (or 'auto')"
            )
        if not self.k.system.nu:
            none = Matrix.zeros(self.k.graph, len(self.constraints.rows))
            return Matrix.zeros(self.k.graph, 0), none
        c = self.constraints
        mass, drive = self._regular(self.mass_matrix, self._drive(tau))
        # what is made here first would belong to the multipliers
        labels = self._labels()
        problem = Bound(mass, drive, c.jacobian, c.gamma, c.position, c.rates, labels)
        with self.k.graph.made_by("constraints", "multipliers"):
            udot, lam = self.treatment.accelerations(problem)
            self._label_multipliers(lam, "multiplier")
        if isinstance(self.treatment, Multipliers) and mass is self.mass_matrix:
            self.solutions.append((tau, udot, lam))
        return self._label(udot, "udot"), lam

    def _labels(self, *system: str) -> Labels:
        rows = tuple(row.word(row.owner) for row in self.constraints.rows)
        return Labels(self.k.speed_names, rows, *system)

    def _owners(self) -> list[str]:
        return [row.owner for row in self.constraints.rows]

    def _regular(self, mass: Matrix, drive: Matrix) -> tuple[Matrix, Matrix]:
        """M and drive; where bodies have no mass or hardly any, with the constraints added to both.

        w Gᵀ (G udot - gamma) vanishes for the accelerations that are looked for. Rows that hold in
        some modes only are left out: where they do not hold, others must bear what has no mass,
        and the metric of positions is the same in all modes.
        """
        regular = all(mass[i, i].node != ZERO for i in range(mass.rows))
        if regular and not (self._has_light_bodies and self.treatment.exact):
            return mass, drive
        weight = Scalar(self.k.graph, ZERO)
        for mass_of_body in self._masses:
            weight = weight + mass_of_body
        if weight.node == ZERO:
            weight = Scalar(self.k.graph, ONE)
        rows = [k for k, row in enumerate(self.constraints.rows) if not row.switched]
        always = (self.constraints.jacobian, self.constraints.gamma)
        jacobian, gamma = (
            Matrix(self.k.graph, len(rows), x.columns, [n for k in rows for n in x.row(k)])
            for x in always
        )
        across = jacobian.T * weight
        return (mass + across @ jacobian).mirrored, drive + across @ gamma

    @cached_property
    def _masses(self) -> list[Scalar]:
        """Masses of all bodies, those too that the equations of motion need no mass of."""
        return [
            sum(
                (Scalar(self.k.graph, self.k.resolve([part.mass])[0]) for part in body.parts),
                Scalar(self.k.graph, ZERO),
            )
            for body in self.k.system.bodies
        ]

    @cached_property
    def _has_light_bodies(self) -> bool:
        """True when a mass is far below the largest, by default values of parameters."""
        nodes = tuple(mass.node for mass in self._masses)
        function = Function("masses", self.k.graph, (), (Output("masses", (len(nodes),), nodes),))
        values = {"p": [parameter.value for parameter in self.k.system.parameters]}
        masses = [float(x) for x in evaluate(function, values)["masses"] if x > 0]
        return min(masses, default=1.0) < LIGHT * max(masses, default=1.0)

    def response(self, row: Matrix) -> Matrix:
        """Accelerations (nu, 1) under a force along a velocity (1, nu) alone."""
        nothing = Matrix.zeros(self.k.graph, 0)
        if not self.k.system.closed:
            return solve("spd", self.mass_matrix, row.T)
        zero_force = Matrix.zeros(self.k.graph, row.columns)
        mass, G = self._regular(self.mass_matrix, zero_force)[0], self.constraints.jacobian
        still = Matrix.zeros(self.k.graph, G.rows)
        labels = self._labels("response", "response_gamma")
        problem = Bound(mass, row.T, G, still, nothing, nothing, labels)
        udot, lam = Multipliers().accelerations(problem)
        self._label_multipliers(lam, "response_multiplier")
        return udot

    def pushed(self, jacobian: Matrix, residual: Matrix, labels: Labels) -> tuple[Matrix, Matrix]:
        """du (nu, 1) and impulses P with M du = Jᵀ P and J du = -residual."""
        zero_force, nothing = Matrix.zeros(self.k.graph, jacobian.columns), self.k.block("u", 0, 0)
        mass = (
            self._regular(self.mass_matrix, zero_force)[0]
            if self.k.system.closed
            else self.mass_matrix
        )
        problem = Bound(mass, zero_force, jacobian, -residual, nothing, nothing, labels)
        return Multipliers().accelerations(problem)

    def projected(self, mass: Matrix, jacobian: Matrix, residual: Matrix) -> Matrix:
        """The smallest change du (nu, 1) in the metric of M with G du = -residual."""
        zero_force = Matrix.zeros(self.k.graph, mass.rows)
        regular = self._regular(mass, zero_force)[0] if jacobian.rows else mass
        nothing = Matrix.zeros(self.k.graph, 0)
        problem = Bound(regular, zero_force, jacobian, -residual, nothing, nothing)
        return Multipliers().accelerations(problem)[0]

    def _label_multipliers(self, lam: Matrix, quantity: str) -> None:
        """Name multipliers after the elements whose constraints they belong to."""
        for row, node in zip(self.constraints.rows, lam.nodes, strict=True):
            self.k.graph.label(node, row.owner, row.word(quantity))

    def _label(self, x: Matrix, quantity: str) -> Matrix:
        """Name the entries of a vector like u after the joints they belong to."""
        for joint in self.k.system.joints:
            if joint.u >= 0:
                names = [c.name for c in joint.element.speeds]
                block = x.block(slice(joint.u, joint.u + len(names)))
                block.label(joint.name, quantity, names)
        return x

    def _refuse_massless(self) -> None:
        """Name the joints along whose motion nothing has inertia."""
        m, singular = self.mass_matrix, []
        for joint in self.k.system.joints:
            if joint.u >= 0:
                slots = range(joint.u, joint.u + len(joint.element.speeds))
                if any(m[j, j].node == ZERO for j in slots):
                    singular.append(f"'{joint.name}'")
        if singular:
            raise DerivationError(
                f"M is singular: nothing moved by joint {', '.join(singular)} has mass or inertia "
                "along its motion. Give a body outboard of it a mass or an inertia, or make the "
                "joint fixed or prescribed; mass_matrix, bias and inverse_dynamics exist all the "
                "same"
            )
