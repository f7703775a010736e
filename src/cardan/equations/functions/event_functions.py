"""State of elements over time: rates of internal states, events and their effects.

Source: F. Pfeiffer and Ch. Glocker, Multibody Dynamics with Unilateral Contacts, 1996, chapters 5
and 8 (impacts, stick and slip as constraints that come and go).
"""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property

from ...elements.forces.force import Places
from ...elements.internal_states import Impulse
from ...ir.arithmetic import Scalar, select
from ...ir.derivative import forward
from ...ir.graph import MINUS_ONE, ZERO
from ...ir.matrix import Matrix
from ...ir.rewrite import rebuild
from ...topology.system import Force
from ..constraints.constraints import VELOCITY
from ..constraints.treatments import Labels
from ..kinematics.loads import places
from .dynamics import Dynamics

# how often impulses that would pull are left out before the rest is taken as it is
PASSES = 3
ATTEMPTS = ("", "second_", "third_", "fourth_")


class Along:
    """Motion under the element's own forces, as elements may read it.

    Args:
        d: The dynamics.
    """

    def __init__(self, d: Dynamics) -> None:
        self.k = d.k
        zero_tau = Matrix.zeros(d.k.graph, d.k.system.nu)
        self.udot = d.forward(zero_tau)
        self._lam = d.bound(zero_tau)[1] if d.k.system.closed else zero_tau
        self._rows = [row.name for row in d.constraints.rows] if d.k.system.closed else []
        self._certainty = d.friction_forces.certainty

    def of(self, force: Force) -> ElementState:
        """The part of one element."""
        names = [f"{force.name}.{name}" for name, _ in force.element.locked_velocities()]
        nodes = [self._lam.nodes[self._rows.index(name)] for name in names]
        certainty = self._certainty.get(force.name)
        return ElementState(self, Matrix(self.k.graph, len(nodes), 1, nodes), certainty)

    def derivative(self, x: Scalar) -> Scalar:
        """Time derivative of an expression along the motion."""
        g = self.k.graph
        seeds = dict(self.k.time_seeds)
        for i, node in enumerate(self.udot.nodes):
            seeds[g.var("u", i)] = node
        return Scalar(g, forward(g, [x.node], seeds)[0])


class ElementState:
    """The part of the solution of the equations of motion that one element may read."""

    def __init__(self, along: Along, multipliers: Matrix, certainty: Scalar | None) -> None:
        self.multipliers, self.certainty = multipliers, certainty
        self._along = along

    def derivative(self, x: Scalar) -> Scalar:
        """Time derivative of an expression along the motion."""
        return self._along.derivative(x)


def rates(d: Dynamics) -> Matrix:
    """Rates of internal states, ``zdot = law of the element`` (nz, 1)."""
    d.k.graph.describe(rates)
    nodes: list[int] = []
    for force in d.k.system.forces:
        if force.element.internals():
            with d.k.graph.made_by(force.name, "zdot"):
                nodes += force.element.rates(places(d.k, force)).nodes
    return Matrix(d.k.graph, len(nodes), 1, nodes)


def signs(d: Dynamics) -> Matrix:
    """Values of all events (ne, 1): it happens where ``event = value that falls through zero``."""
    d.k.graph.describe(signs)
    along, nodes = Along(d), list[int]()
    for force in d.k.system.forces:
        if force.element.events():
            with d.k.graph.made_by(force.name, "event"):
                values = force.element.signs(places(d.k, force), along.of(force))
                nodes += [value.node for value in values]
    return Matrix(d.k.graph, len(nodes), 1, nodes)


class Jump:
    """The events of an element, and the speeds behind all that happen together."""

    def __init__(self, d: Dynamics, force: Force, speeds: Matrix) -> None:
        self.k, self._d, self._force, self._speeds = d.k, d, force, speeds

    @cached_property
    def before(self) -> ElementState:
        """The solution of the equations of motion before the event."""
        return Along(self._d).of(self._force)

    def fired(self, event: int) -> Scalar:
        """1 where this event of the element happened, else 0."""
        return Scalar(self.k.graph, self.k.graph.var("e", self._force.e + event))

    def after(self, x: Scalar) -> Scalar:
        """Value of an expression with the speeds behind the event."""
        g = self.k.graph
        behind = {g.var("u", i): node for i, node in enumerate(self._speeds.nodes)}
        return Scalar(g, rebuild(g, [x.node], behind, into=g)[1][0])

    def response(self, velocity: Scalar) -> Scalar:
        """Acceleration of a velocity per force along it, loops and what others hold included."""
        nodes = self._d.constraints.gradient(self._force.name, velocity.node, VELOCITY)
        row = Matrix(self.k.graph, 1, len(nodes), nodes)
        return (row @ self._d.response(row))[0]


def transition(d: Dynamics) -> tuple[Matrix, Matrix, Matrix]:
    """u (nu, 1), z (nz, 1) and s (ns, 1) behind the events that the block ``e`` says happened.

    Impulses P along velocities J u go through the whole system:
    ``speeds = u + M⁻¹ Jᵀ P, J speeds as the events ask``.
    """
    k = d.k
    k.graph.describe(transition)
    before = k.block("u", 0, k.system.nu)
    impulses: list[Impulse] = []
    names: list[str] = []
    for force in k.system.forces:
        with k.graph.made_by(force.name, "impulse"):
            impulses_of_force = force.element.impulses(places(k, force), Jump(d, force, before))
        impulses += impulses_of_force
        names += [
            f"{force.name}.{event.name}"
            for event in force.element.events()[: len(impulses_of_force)]
        ]
    with k.graph.made_by("impact", "speeds"):
        behind = _jumped(d, before, impulses, names)
    z, s = list[int](), list[int]()
    for force in k.system.forces:
        with k.graph.made_by(force.name, "change"):
            at = places(k, force)
            change = force.element.change(at, Jump(d, force, behind))
            z += _behind(at, change.z, at.z)
            s += _behind(at, change.s, at.s)
    return behind, Matrix(k.graph, len(z), 1, z), Matrix(k.graph, len(s), 1, s)


def _behind(at: Places, changed: Matrix | None, stays: Matrix) -> Sequence[int]:
    return (stays if changed is None else changed).nodes


def _jumped(
    d: Dynamics, before: Matrix, impulses: Sequence[Impulse], names: Sequence[str]
) -> Matrix:
    """Speeds behind impulses: M du = Jᵀ P + Gᵀ P', J u as wanted, the loops closed.

    Impulses that would pull where they can only push are left out, again and again.
    """
    if not impulses:
        return before
    g = d.k.graph
    bound, row_names = _bound_rows(d)
    active = [impulse.active for impulse in impulses]
    unilateral = [i for i, impulse in enumerate(impulses) if impulse.unilateral]
    jacobian = [
        Matrix(g, 1, before.rows, d.constraints.gradient("impact", i.velocity.node, VELOCITY))
        for i in impulses
    ]
    inertia = {
        i: _effective_inertia(d, jacobian[i], bound, (names[i], *row_names))
        for i in unilateral
        if len(unilateral) > 1 and impulses[i].release_speed is not None
    }
    behind = before
    for attempt in ATTEMPTS[: min(max(len(unilateral), 1) - 1, PASSES) + 1]:
        for on, name in zip(active, names, strict=True):
            g.hint(on.node, name, f"{attempt}active")
        rows = [row * on for row, on in zip(jacobian, active, strict=True)]
        missing = [(i.velocity - i.after) * on for i, on in zip(impulses, active, strict=True)]
        step, pushes = d.pushed(
            Matrix.vstack(*rows, *([bound] if bound.rows else [])),
            Matrix(g, len(rows) + bound.rows, 1, [m.node for m in missing] + [ZERO] * bound.rows),
            Labels(
                d.k.speed_names,
                tuple(f"{attempt}{name}" for name in (*names, *row_names)),
                f"{attempt}impact",
                "missing_speed",
            ),
        )
        behind = (before + step).hint("", f"{attempt}behind", d.k.speed_names)
        for push, name in zip(pushes, names, strict=False):
            g.hint(push.node, name, f"{attempt}impulse")
        for i in unilateral:
            pull = pushes[i] * -1
            release_speed = impulses[i].release_speed
            if release_speed is None or i not in inertia:
                pushing = pull.apply("le", pull * 0)
            else:
                # against the impulse that gives it that speed where nothing else holds it
                pushing = pull.apply("le", release_speed * inertia[i])
            active[i] = active[i] * select(pushing, 1, 0)
    return behind


def _effective_inertia(d: Dynamics, row: Matrix, bound: Matrix, names: tuple[str, ...]) -> Scalar:
    """Effective inertia along a velocity (1, nu), the loops closed: impulse for a unit of it."""
    g = d.k.graph
    one = [MINUS_ONE] + [ZERO] * bound.rows
    pushes = d.pushed(
        Matrix.vstack(row, *([bound] if bound.rows else [])),
        Matrix(g, 1 + bound.rows, 1, one),
        Labels(d.k.speed_names, tuple(f"unit {name}" for name in names), "unit", "unit_speed"),
    )[1]
    g.hint(pushes[0].node, names[0], "inertia")
    return pushes[0]


def _bound_rows(d: Dynamics) -> tuple[Matrix, list[str]]:
    """G of everything but what elements hold: that says itself what it bears; names of the rows."""
    g, nu = d.k.graph, d.k.system.nu
    if not d.k.system.closed:
        return Matrix(g, 0, nu, ()), []
    switched = {
        f"{force.name}.{name}"
        for force in d.k.system.forces
        for name, _ in force.element.locked_velocities()
    }
    G = d.constraints.jacobian
    remaining = [i for i, row in enumerate(d.constraints.rows) if row.name not in switched]
    nodes = [n for i in remaining for n in G.block(slice(i, i + 1)).nodes]
    return Matrix(g, len(remaining), nu, nodes), [d.constraints.rows[i].name for i in remaining]
