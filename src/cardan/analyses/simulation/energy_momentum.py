"""Check that the elements of a model are conservative, and find their symmetries."""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING

import numpy as np

from ...arrays import Array
from ...errors import ModelError
from ...runtime.models.finite_elements.frames import rotation

if TYPE_CHECKING:
    from ...runtime.models.finite_elements.mesh import Mesh
    from ...runtime.models.finite_elements.tables import Table, Tables
    from ...runtime.models.loaded_model import LoadedModel
    from ...schema.integrators import Integrator

# what differences of energies over a small way and rounding leave of forces
DIFFERENCE, WAY = 1e-5, 1e-4
SMALL = 1e-9
# at which forces are compared, so that those that begin late are seen [s]
MOMENTS = np.geomspace(1e-3, 1e3, 13)
# common motions that change no element: all rigid ones, those of what is heavy
RIGID, HEAVY = 6.0, 3.0


def conservative(model: LoadedModel, method: Integrator) -> tuple[Integrator, str]:
    """The method with the symmetries of the elements of a model, none of which loses energy.

    Raises:
        ModelError: something in it is not conservative.
    """
    mesh: Mesh = model._source.results(model).mesh  # type: ignore[attr-defined]
    looked = _Looked(mesh, f"method '{method.name}'", len(model.manifest.inputs))
    looked.refuse()
    down, symmetry = looked.symmetries()
    return replace(method, options=(*down, *symmetry)), "energy and momenta kept"


class _Looked:
    """The elements of a model at two states that nothing singles out."""

    def __init__(self, mesh: Mesh, who: str, inputs: int) -> None:
        from ...runtime.models.finite_elements.elements import State

        self.mesh, self.tables, self.who = mesh, mesh.tables, who
        self.random = random = np.random.default_rng(1)
        # loads that begin at 0, or that inputs give, act here
        r = random.uniform(-1, 1, inputs)
        self.state = partial(State, t=0.3, r=r)
        tables = mesh.tables
        q0 = np.zeros(tables.nq)
        for kind, start in zip(tables.kind, tables.q[:-1], strict=True):
            quaternion = tables.kinds[kind].quaternion
            if quaternion is not None:
                q0[start + quaternion] = 1.0
        away = [random.uniform(-1, 1, tables.nu) for _ in range(2)]
        self.q = [mesh.move(q0, du) for du in away]
        # others, such as outputs, do nothing to the motion
        self.acting = [g for g in tables.groups if "balance" in g.kind.functions]
        self.lam = random.uniform(-1, 1, tables.m)
        self.way = random.uniform(-1, 1, tables.nu)

    def refuse(self) -> None:
        """Look for what takes energy from the motion or gives it.

        Raises:
            ModelError: there is something; it is named.
        """
        tables = self.tables
        if tables.m != tables.mp:
            self._say("rolls", "rolling constraints bind speeds alone")
        for group in self.acting:
            kind, what = group.kind, _named(group)
            if "bodies" in kind.functions:
                raise ModelError(
                    f"{self.who} keeps the momenta of nodes, and {what} moves bodies by the "
                    "coordinates of joints: compile with coordinates='absolute', which gives "
                    "every body a node"
                )
            if "M" not in kind.parts and self._resists(group):
                self._say(what, "its force depends on speeds")
            if "generalized_momenta" in kind.functions:
                self.mesh.connect("generalized_momenta")
                if "power" in kind.functions:
                    self._say(what, "it is damped")
            elif "M" in kind.parts and kind.nu and len(group.place[0]) > 1:
                self._check_mass_blocks(group, what)
        for group, lost in zip(self.acting, self._lost(), strict=True):
            if lost:
                self._say(_named(group), "its force has no potential")
        rates = self.mesh.balance(self.state(self.q[0]))[2]
        if np.abs(rates).max(initial=0.0) > SMALL:
            self._say("a joint", "it is driven along a given motion")
        for group in self._changing():
            self._say(_named(group), "it depends on the time or an input")

    def _resists(self, group: Table) -> bool:
        """True when forces of a group change with speeds."""
        number, nu = self.acting.index(group), group.kind.nu
        moving = self.mesh.results("balance", self.state(self.q[0], u=self.way))[number]
        static = self.mesh.results("balance", self.state(self.q[0]))[number]
        change = np.abs(moving - static)[:, :nu].max(initial=0.0)
        return bool(change > SMALL * np.abs(static)[:, :nu].max(initial=0.0))

    def _say(self, what: str, why: str) -> None:
        raise ModelError(
            f"{self.who}: {what} is not conservative ({why}): take method='GeneralizedAlpha'"
        )

    def _check_mass_blocks(self, group: Table, what: str) -> None:
        """Masses of elements stand with their nodes."""
        having = [g for g in self.tables.groups if "balance_tangent" in g.kind.functions]
        results = self.mesh.results("balance_tangent", self.state(self.q[0]))
        values = results[next(k for k, g in enumerate(having) if g is group)]
        nu, start = group.kind.nu, group.kind.parts["M"]
        mass = values[0, start : start + nu * nu].reshape(nu, nu)
        sizes = [len(c) for c in _columns(self.tables, group, 0)]
        owner = np.repeat(np.arange(len(sizes)), sizes)
        if np.abs(mass[owner[:, None] != owner]).max(initial=0.0) > SMALL * np.abs(mass).max():
            raise ModelError(
                f"{self.who}: the mass of {what} couples nodes, and the energy of such elements "
                "is not kept: scene.beam(..., inertia='lumped')"
            )

    def _forces(self, q: Array, lam: Array | None) -> list[Array]:
        """Forces of every element on its places (n, nu), group by group."""
        balances = self.mesh.results("balance", self.state(q, lam=lam))
        return [f[:, : g.kind.nu] for f, g in zip(balances, self.acting, strict=True)]

    def _lost(self) -> list[bool]:
        """Mask of the groups whose forces do not derive from their energy."""
        tables, q, way = self.tables, self.q[0], WAY * self.way
        ends = [
            self.mesh.results("energy", self.state(self.mesh.move(q, s * way))) for s in (-1, 1)
        ]
        having = [g for g in tables.groups if "energy" in g.kind.functions]
        lost = []
        for group, force in zip(self.acting, self._forces(q, None), strict=True):
            work = np.einsum("ni,ni->n", force, way[tables.columns(group)])
            size = np.abs(force).max(initial=0.0) * WAY
            if any(g is group for g in having):
                k = next(k for k, g in enumerate(having) if g is group)
                work = work - 0.5 * (ends[1][k][:, 1] - ends[0][k][:, 1])
            lost.append(bool(np.abs(work).max(initial=0.0) > DIFFERENCE * size + 1e-300))
        return lost

    def _changing(self) -> list[Table]:
        """The groups that say something else at other times or by other inputs."""
        first = self.mesh.results("balance", self.state(self.q[0]))
        changing = np.zeros(len(first), dtype=bool)
        for t in MOMENTS.tolist():
            r = self.random.uniform(-1, 1, self.tables.nr)
            now = self.mesh.results("balance", self.state(self.q[0], t=t, r=r))
            # what reads neither is computed alike, to the bit
            changing |= [not np.array_equal(a, b) for a, b in zip(first, now, strict=True)]
        return [group for group, changes in zip(self.acting, changing, strict=True) if changes]

    def _power(self, force: Array, group: Table, q: Array, motion: Array) -> Array:
        """Power of forces over a rigid motion (6) of everything:

        turn, then velocity of the origin.
        """
        tables, power = self.tables, np.zeros(len(force))
        for e in range(len(force)):
            first = 0
            for place in group.place[e]:
                n = tables.u[place + 1] - tables.u[place]
                wrench = force[e, first : first + n]
                if tables.kinds[tables.kind[place]].name == "node":
                    pose = q[tables.q[place] : tables.q[place] + 7]
                    turn = rotation(pose[:4]).T @ motion[:3]
                    power[e] += wrench[:3] @ turn
                    power[e] += wrench[3:] @ (motion[3:] + np.cross(motion[:3], pose[4:]))
                first += n
        return power

    def symmetries(self) -> tuple[Array, Array]:
        """The direction of gravity (3,), and of every group how many motions leave it alone."""
        down = self._down()
        counts = np.zeros(len(self.tables.groups))
        across = np.linalg.svd(down[None, :])[2][1:] if down.any() else np.eye(3)[:2]
        heavy = [np.append(down, np.zeros(3)), *(np.append(np.zeros(3), d) for d in across)]
        cases = [(RIGID, list(np.eye(6))), (HEAVY, heavy if down.any() else [])]
        forces = self._forces(self.q[1], self.lam)
        for group, every in zip(self.acting, forces, strict=True):
            k, force = self.tables.groups.index(group), every[:1]
            size = np.abs(force).max(initial=0.0)
            for count, motions in cases:
                powers = [self._power(force, group, self.q[1], motion) for motion in motions]
                if motions and np.abs(powers).max(initial=0.0) <= SMALL * size:
                    counts[k] = count
                    break
        return down, counts

    def _down(self) -> Array:
        """The direction of the force that is on an element with mass wherever it is."""
        for group, every in zip(self.acting, self._forces(self.q[0], None), strict=True):
            if "M" in group.kind.parts:
                motions = np.eye(6)[3:]
                net = [self._power(every[:1], group, self.q[0], m)[0] for m in motions]
                if np.linalg.norm(net) > 0:
                    return np.array(net, float) / float(np.linalg.norm(net))
        return np.zeros(3)


def _columns(tables: Tables, group: Table, element: int) -> list[Array]:
    """Speeds of every place of an element."""
    places = group.place[element]
    return [np.arange(tables.u[place], tables.u[place + 1]) for place in places]


def _named(group: Table) -> str:
    """Name of an element of a group as users know it."""
    return f"'{group.members[0]}'" if len(group.members) else f"an element '{group.kind.name}'"
