"""The table of model functions: what each reads and gives, and which systems have it.

A row is everything that is said of a function but how it is derived (``equations``), how it is
evaluated over elements in tables (``runtime/models/finite_elements``), and what it is compared with
(``runtime/verification``). Arguments, methods of a compiled model with their signatures and
docstrings, what is compiled, pickled and exported, and the table in ``docs/functions.md`` follow.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from math import prod
from typing import Any, NamedTuple

from .blocks import ARGUMENTS

# a function: name | blocks it reads | shape | unit | what a system must have or know | traits,
# then what it gives as the heads of C files say it, then fields of a ModelFunction and its text
TABLE = """
rhs | t x r s | nx | of the state per s | | elements rewritable
    time derivative of the state [q, u, z]
    like: q u z
    also: tau wrenches parameters out
    As SciPy's solvers want it.
forward_dynamics | t q u z s r tau | nu | rad/s^2 or m/s^2 | | elements rewritable
    udot with M udot + h = f + tau
    like: u
    also: wrenches parameters out
inverse_dynamics | t q u udot z s r | nu | N m or N | known friction | elements rewritable
    tau with M udot + h = f + tau
    like: u
    also: wrenches parameters out
    f are the forces of the model; wrenches act too, so that tau is what is left to do.
mass_matrix | t q r | nu nu | kg m^2, kg m or kg | | elements rewritable
    M: kinetic energy is 1/2 uᵀ M u
    Of what prescribed motions add to the energy nothing is in it.
bias | t q u r | nu | N m or N | | rewritable
    h: velocity products and gravity
    like: u
    As in Pinocchio and MuJoCo.
gravity | t q r | nu | N m or N | causes of forces | rewritable
    part of h that is left at rest
coriolis | t q u r | nu | N m or N | causes of forces | rewritable
    h without gravity
applied_forces | t q u r z s | nu | N m or N
    f: generalized forces of the model's elements
qdot | t q u r | nq | rad/s, 1/s or m/s | | elements
    qdot = N(q) u + n(t, q)
    like: q
    Rates of the coordinates.
energy | t q u r | 3 | J | | elements
    kinetic, potential and total energy
    also: parameters
    returns: Energy
    The potential of gravity is 0 at the ground origin.
pose(frame) | t q r | 4 4 | 1 and m | bodies | elements
    transform from frame axes to ground axes
    A homogeneous transform [R, p; 0, 1].
velocity(frame) | t q u r | 6 | rad/s and m/s | bodies | elements
    angular velocity and velocity of the origin, ground axes
    also: in_ parameters out
acceleration(frame) | t q u udot r | 6 | rad/s^2 and m/s^2 | bodies | elements
    angular acceleration and acceleration of the origin, ground axes
    also: in_ parameters out
    Gravity is not in it: a body at rest has 0.
frame_jacobian(frame) | t q r | 6 nu | 1, m or 1/m | bodies | elements
    velocity = J u, ground axes
    also: in_ parameters out
    Rows are [omega, v] of the frame origin. Where joints are prescribed, their part of the
    velocity is not a part of J u.
com | t q r | 3 | m | bodies
    center of mass in ground axes
    Of everything that moves.
momentum | t q u r | 6 | kg m^2/s and kg m/s | bodies | elements
    angular (about the ground origin) and linear momentum
    In ground axes.
momenta | t q u r | nu | kg m^2/s or kg m/s | kinetic energy
    p = dT/du: momenta along the speeds
    They are canonical where speeds are rates of coordinates.
momentum_rates | t q u r tau z s | nu | N m or N | kinetic energy
    rates of the momenta under forces and constraints
    Of ``momenta``, under tau, the forces of the model and its constraints.
hamiltonian | t q u r | | J | kinetic energy
    H = p . u - T + V
    The energy, where no motion is prescribed.
reaction(joint) | t q u r tau wrench z s | 6 | N m and N | bodies | elements
    wrench of parent on child at the child joint frame, in its axes
    [Mx, My, Mz, Fx, Fy, Fz]. The system accelerates under tau and wrenches. Where redundant
    constraints leave reactions undetermined those of least norm come out: the smallest sum over
    the joints of squares of forces, and of moments over the largest distance between two of
    them. A SolveWarning says so once; see ``model.redundancy(q)``. Forces along the joint,
    such as JointSpring, and its tau act through it: Mz of a hinge about z holds them.
outputs | t q u r z s | ny | as declared | | elements
    declared outputs, then ``<joint>.driving_force`` of prescribed joints
    like: y
expression(formula) | t q u r z s | | as its entries have it | | rare
    value of a formula in names of the model
    Of coordinates, speeds, internal states, inputs, parameters, outputs and t, as formulas in
    scene files are: ``"(hand.x - 0.4)^2 + 1e-3*tau^2"``.
element_forces | t q u r tau z s | nforces | N or N m | element forces | elements rare
    forces of elements by name: along a line or a joint, or on a frame
    like: forces
    In the order of ``manifest.element_forces``. Along a line a positive force pulls the ends
    together; along a joint it pushes the child in the positive direction; on a frame it is
    [force, moment] at its origin in ground axes. Stops, latches and sticking friction hold
    under the forces of the model and tau; impulses of impacts are not in it.
power | t q u r z s | nsources | W | | elements
    power of everything that has no potential, by source
    like: sources
dependents | t q u r | ndependent | of the coordinates and speeds | closed form
    coordinates, then speeds, of joints that loops determine
constraints | t q r | npositions | m or rad | constraints | elements
    g: what vanishes at position level
    like: positions
constraint_rates | t q u r z s | nlam | m/s or rad/s | constraints | elements
    G u + g_t: what vanishes at velocity level
    The derivative of g first.
constraint_jacobian | t q r s | nlam nu | 1, m or 1/m | constraints | elements
    G: G udot = gamma
closure | t q r | nclosing | m or 1 | constraints
    closing conditions of all cut joints, dependent ones too
    Also those that follow from others.
assembly_signs | t q r | ncosines | 1 | constraints
    cosines, all positive where no cut joint is turned round
    Closing conditions vanish too where an axis is turned round; then one of these does not
    exceed 0. They are named in the manifest after their joints.
multipliers | t q u r tau z s | nlam | N or N m | constraints | elements rewritable
    lam: forces of constraint, M udot + h = f + tau + Gᵀ lam
    like: lam
    0 for rows that follow from others. q and u are on the constraints.
close_position | t q r | nq+npositions | of q, then of g | constraints | \
    elements rewritable joint_speeds
    q moved onto the constraints by one step, and g before it
    The step is the shortest in the metric of M; repeated, it converges quadratically.
close_velocity | t q u r z s | nu+nlam | of u, then of the rates | constraints | elements rewritable
    u moved onto the constraints, and their rates before
    M is the metric.
events | t q u r z s | ne | of each event | events | elements rewritable
    numbers that fall through zero where an event happens
transition | t q u r z s e | nu+nz+ns | of u, z and s | events | elements rewritable
    speeds, internal and discrete states behind the events e
    call: q u events
balance | t q u udot lam r z s | nu+npositions+nlam | of tau, g and its rates | | \
    elements rewritable rare internal no_derivative
    M udot + h - f - Gᵀ lam, then g and G u + g_t
balance_tangent | t q u udot lam r z s | 3*nu*nu+2*nlam*nu | of tau per step | | \
    rewritable rare displaces internal no_derivative
    derivatives of the balance along q, u, udot, of the rates along q, and G
internal_rates | t q u r z s | nz | of z per s | internal states | \
    rewritable rare internal no_derivative
    zdot: rates of the internal states
strain_energy | t q r | | J
    energy of springs, bushings and cables, without loads
    Of all elements whose potential is the energy of a strain, at the present time and inputs.
strain_balance | t q lam r s | nu+npositions | of tau, then of g | | rewritable rare internal
    gradient of the strain energy along the speeds, less Gᵀ lam; then g
move | q du | nq+ntangent | of q, then 1 | | elements rare internal no_derivative
    q moved by the increment du along the speeds, and its tangent
regressor | t q u udot z s r | nu nphi | of tau per phi | inertias, linear, known friction | rare
    Y: tau is Y phi and what does not depend on phi, the inertial parameters
    source: Atkeson, An and Hollerbach, Int. J. Robotics Research 5 (1986).
    The numbers phi are named by ``inertial_parameters``: ten of every body, then
    coefficients of force elements. Nothing else is left over in a robot whose forces are
    gravity, damping and friction.
energy_regressor | t q u r z s | 3 nphi | J, J, W per phi | inertias, linear, known friction | rare
    kinetic and potential energy, and power without a potential, per inertial parameter
    source: Gautier and Khalil, IEEE Conf. Decision and Control (1988).
    The power is that of coefficients without a potential, such as damping, negative where
    they take energy. What the energies gain is what tau and powers give: no accelerations
    are needed. Not for systems that time or inputs move.
inertial_parameters | | nphi | kg, kg m, kg m^2 and as declared | inertias | rare
    phi: what forces and energies are linear in
    also: parameters
    returns: dict[str, Any]
    By name: ``<body>.mass``, ``.moment_x`` ..., ``.xx`` ... ``.yz``: mass, first moments
    and inertia about the frame of the body, in its axes, of the body with everything fixed
    to it; then ``<element>.damping`` and the like.
integrate | q du | nq | of q | | elements no_derivative
    q moved by a finite increment du along the speeds
    also: out
difference | q0 q | nu | rad or m | | no_derivative
    du that moves q0 to q1
    call: q0 q1
    also: out
    ``integrate(q0, du)`` is q1.
derivative(function) | |  | |  | rare displaces internal no_derivative
    derivative, q along the speeds, of
vjp(function) | v |  | |  | rare displaces internal no_derivative
    weights times the derivative, q along the speeds, of
jvp(function) | v |  | |  | rare displaces internal no_derivative
    change along a direction, q along the speeds, of
hessian(function) | v |  | |  | rare displaces internal no_derivative
    second derivative of the weighted sum, q along the speeds, of
rhs_jacobian | t x r s | nx*nx+nx+nx*nr | of rhs per x, s and r | | \
    rewritable rare displaces no_derivative
    d rhs / d x, / d t and / d r, x as it is stored
    also: parameters
    returns: tuple[Array, Array, Array]
    A unit quaternion counts by its direction alone: along itself nothing changes.
    Derivatives along the speeds instead: ``derivative("rhs", wrt="q")``. Three arrays:
    (..., nx, nx), (..., nx) and (..., nx, nr).
constraint_bias | t q u r z s | nlam | m/s^2 or rad/s^2 | constraints | for_display
    gamma: G udot = gamma
wrenches | t q u r z s | | N m or N | | for_display
    what elements do on every body, at its origin in its axes, and along joints
"""


class ModelFunction(NamedTuple):
    """A function of a model.

    Attributes:
        name: As users call it.
        reads: Blocks in the order in which they are handed over.
        shape: Of the result: an axis per word, in numbers and counts such as ``nu``.
        unit: Of the result; of several entries one after the other.
        needs: What a system must have or know of itself: ``"constraints"``, ``"bodies"``.
        about: What it gives.
        of: What it is a function of besides the state: ``"frame"``, ``"joint"``, ``"function"``.
        text: What else the docstring says.
        like: Blocks that name the entries of a vector.
        call: What its required arguments are called, where not as their blocks.
        also: Arguments of the method besides blocks.
        returns: What the method returns.
        source: Literature.
        elements: Whether there is one of elements in tables.
        rewritable: Whether it is the same in whatever frames, and by whatever grouping of inertia,
            the bodies are described.
        joint_speeds: Whether it moves along the speeds of joints, whatever speeds the user chose.
        displaces: Whether it displaces bodies as a whole.
        rare: Whether only some analyses call it: pickles have it if it was used.
        internal: Whether a compiled model has no method that follows from this row.
        no_derivative: Whether it has no derivatives by blocks and parameters.
        for_display: Whether it is derived for people and checks alone, never written as C.
    """

    name: str
    reads: str
    shape: str
    unit: str
    needs: tuple[str, ...]
    about: str
    of: str = ""
    text: str = ""
    like: str = ""
    call: str = ""
    also: str = "parameters out"
    returns: str = "Array"
    source: str = ""
    elements: bool = False
    rewritable: bool = False
    joint_speeds: bool = False
    displaces: bool = False
    rare: bool = False
    internal: bool = False
    no_derivative: bool = False
    for_display: bool = False

    @property
    def arguments(self) -> list[str]:
        """Blocks that it reads."""
        return self.reads.split()

    @property
    def required(self) -> list[str]:
        """Blocks that have no default; of functions that solvers call all, in their order."""
        solvers = "x" in self.arguments
        return [name for name in self.arguments if solvers or not ARGUMENTS[name].default]

    @property
    def renamed(self) -> dict[str, str]:
        """Blocks that the method has under another name, and this."""
        return dict(zip(self.required, self.call.split(), strict=False)) | {"wrench": "wrenches"}

    def sizes(self, counts: Mapping[str, int]) -> tuple[int, ...]:
        """Shape of the result where counts such as ``nu`` are these."""
        numbers = {digit: int(digit) for digit in "123456"} | dict(counts)
        return tuple(
            sum(prod(numbers[factor] for factor in part.split("*")) for part in axis.split("+"))
            for axis in self.shape.split()
        )


def _rows(table: str) -> Iterator[ModelFunction]:
    """The rows of a table of text."""
    for block in re.split(r"\n(?=\w)", table.strip()):
        head, about, *more = (line.strip() for line in block.splitlines())
        name, reads, shape, unit, needs, traits = (
            cell.strip() for cell in (head + " |" * 5).split("|")[:6]
        )
        fields: dict[str, Any] = dict.fromkeys(traits.split(), True)
        text = []
        for line in more:
            key, _, value = line.partition(": ")
            if key in ModelFunction._fields:
                fields[key] = value
            else:
                text.append(line)
        name, _, of = name.rstrip(")").partition("(")
        required = tuple(filter(None, needs.split(", ")))
        yield ModelFunction(
            name, reads, shape, unit, required, about, of, "\n".join(text), **fields
        )


FUNCTIONS = {row.name: row for row in _rows(TABLE)}
# what compile() may be asked for unless functions= says otherwise
STANDARD = tuple(name for name, row in FUNCTIONS.items() if not row.for_display)
# what elements in tables have
OF_ELEMENTS = tuple(name for name, row in FUNCTIONS.items() if row.elements)
# those that have derivatives by blocks and parameters
DIFFERENTIABLE = tuple(name for name, row in FUNCTIONS.items() if not row.no_derivative)
