"""The contract of a model in absolute coordinates: large, sparse, by the tables of its elements."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import replace
from functools import cached_property
from typing import Any, final

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array, vstack

from ..errors import ModelError, near
from ..runtime.absolute.elements import Elements, State
from ..runtime.absolute.frames import rotation
from ..runtime.absolute.tables import Tables
from ..runtime.closing import unit
from ..runtime.compiled import CompiledModel
from ..runtime.initial import entries, missing
from .blockwise import Blockwise
from .contract import Internal, Moment, Parameters, Rates, Seen, Tangents
from .meshed_start import meshed_start
from .modeled import Modeled
from .saddle import Dense, Saddle, Sparse
from .settings import blocks, start

Array = NDArray[np.float64]
REACH = 3.0  # radians or sizes: slender structures turn far in one step
STEP = 1e-5  # of central differences; their error is 1e-10 of third derivatives


@final
class Absolute(Modeled):
    """A model in absolute coordinates as :class:`cardan.analyses.contract.Contract`.

    Attributes:
        model: The model.
        Others: as the contract has them.
    """

    def __init__(self, model: CompiledModel) -> None:
        """Args:
            model: Compiled in absolute coordinates.

        Raises:
            ModelError: its elements have internal states.
        """
        if model.internals:
            raise ModelError(
                f"model '{model.name}' has internal states ('{model.internals[0]}'): in absolute "
                "coordinates equilibria and linear models take none. Use coordinates='relative'"
            )
        self._meshes: dict[Any, Elements] = {}
        self.model = model
        self.tables = self._mesh(None).tables
        super().__init__(model, self.tables.mp, _extent(model, self.tables))
        rows = model.manifest.get("multipliers", ())
        self.rows = np.array([1.0 if row["unit"] == "rad" else self.size for row in rows])
        self.reach = REACH
        blockwise = _blocks(self.tables)
        self.saddle: Saddle = Sparse(blockwise, blockwise.counted)

    def _mesh(self, parameters: Parameters) -> Elements:
        """The elements with values of parameters; the first and the last ones are kept."""
        key = tuple(sorted((parameters or {}).items()))
        if key not in self._meshes:
            model = self.model.with_parameters(dict(parameters)) if parameters else self.model
            kept = {k: mesh for k, mesh in self._meshes.items() if k == ()}
            mesh: Elements = model._source.results(model).mesh  # type: ignore[attr-defined]
            self._meshes = {**kept, key: mesh}
        return self._meshes[key]

    def _asked(self, at: Moment) -> tuple[Elements, State]:
        state = State(at.q, at.u, at.udot, at.lam, at.t, at.r, at.z, at.s)
        if len(at.inner):
            state = replace(state, inner=at.inner, du=np.zeros(len(at.u)))
        return self._mesh(at.parameters), state

    # where to begin

    def start(self, t: float, q: Any, r: Array, hold: Mapping[str, Any], p: Parameters) -> Moment:
        """As :meth:`Contract.start`; what stays open is closed by the search that begins here."""
        model, x = self.started(q, hold, p)
        # where this way of closing fails Newton's method has forces to find one
        with suppress(ModelError):
            x = meshed_start(model, x, hold, None, t, r)
        still, lam = np.zeros(model.nu), np.zeros(len(self.multipliers))
        return Moment(t, x[: model.nq], still, still, lam, r, np.zeros(0), self.modes, p)

    def state(self, x0: Any, q: Any, u: Any, z: Any, t: float, r: Array, p: Parameters) -> Moment:
        """As :meth:`Contract.state`."""
        model = self.model.with_parameters(dict(p)) if p else self.model
        begin = start(model, x0, q, u, z)
        place, speed = model.split(meshed_start(model, begin.x, *blocks(x0, q, u), t, r))
        lam = np.zeros(len(self.multipliers))
        return Moment(t, place, speed, 0 * speed, lam, r, np.zeros(0), self.modes, p)

    def consistent(self, at: Moment, given: Mapping[str, Any]) -> Array:
        """As :meth:`Contract.consistent`: of all such speeds the smallest without units.

        Raises:
            ModelError: nodes of beams, which no constraint takes along.
        """
        if self.model.manifest["beams"]:
            beam = self.model.manifest["beams"][0]["name"]
            raise ModelError(
                f"u= ({', '.join(given)}): beam '{beam}' would stand still while the rest moves, "
                "as a steady motion does not carry nodes of beams along. Simulate it, with "
                "damping, until it is steady"
            )
        places, nu = entries(self.model.manifest, "u"), self.model.nu
        rows, values = list[int](), list[float]()
        for name, value in given.items():
            if name not in places:
                words = missing(self.model.manifest, "u", name)
                raise ModelError(f"u={{'{name}': ...}}: {words}{near(name, places)}")
            rows += range(*places[name].indices(nu))
            values += np.atleast_1d(np.asarray(value, dtype=np.float64)).tolist()
        pick = csr_array((np.ones(len(rows)), (np.arange(len(rows)), rows)), (len(rows), nu))
        mesh, state = self._asked(replace(at, u=0 * at.u))
        right = np.concatenate([-mesh.balance(state)[2] / self.rows, values])
        G = csr_array(self.tangents(at).G / self.rows[:, None])
        alike = csr_array((np.ones(nu), (np.arange(nu), np.arange(nu))))
        bound = csr_array(vstack([G * self.columns, pick * self.columns]))
        found: Array = self.saddle.solve(alike, bound, np.zeros(nu), right)[0] * self.columns
        return found

    # equations

    def balance(self, at: Moment) -> Array:
        """As :meth:`Contract.balance`."""
        mesh, state = self._asked(at)
        return np.concatenate(mesh.mixed_balance(state) if len(at.inner) else mesh.balance(state))

    def tangents(self, at: Moment) -> Tangents:
        """As :meth:`Contract.tangents`."""
        mesh, state = self._asked(at)
        found = mesh.mixed_tangent(state) if len(at.inner) else mesh.tangent(state)
        return Tangents(*(csr_array(found[name]) for name in "KCMRG"))

    def internal_rates(self, at: Moment) -> Array:
        """As :meth:`Contract.internal_rates`: there are none."""
        return np.zeros(0)

    def internal(self, at: Moment) -> Internal:
        """As :meth:`Contract.internal`: there are none."""
        none = np.zeros((0, self.model.nu))
        return Internal(none.T, none, none, np.zeros((0, 0)))

    def accelerations(self, at: Moment, tau: Array | None = None) -> Moment:
        """As :meth:`Contract.accelerations`."""
        mesh, state = self._asked(at)
        udot, lam = mesh.accelerations(state, tau)
        return replace(at, udot=udot, lam=lam)

    def rates(self, at: Moment, tau: Array | None = None) -> Rates:
        """As :meth:`Contract.rates`: by tangents, exact at rest.

        In motion what constraints say of accelerations is differentiated by central differences.
        """
        there = self.accelerations(at, tau)
        found, nu = self.tangents(there), self.model.nu
        M = found.M.toarray() * self.columns * self.columns[:, None]
        G = found.G.toarray() * self.columns / self.rows[:, None]
        parts = []
        for block, matrix in (("q", found.K), ("u", found.C)):
            bent = np.zeros((len(self.rows), nu))
            if np.any(at.u) or np.any(there.udot):
                bent = self._differences(there, block, self._bent)
            right = -matrix.toarray() * self.columns[:, None]
            parts.append(Dense().solve(M, G, right, -bent / self.rows[:, None])[0])
        along, by_u = (part * self.columns[:, None] for part in parts)
        by_r = self._differences(at, "r", lambda x: self.accelerations(x, tau).udot)
        return Rates(along, by_u, np.zeros((nu, 0)), by_r)

    def _bent(self, at: Moment) -> Array:
        """G udot - gamma (m,)."""
        mesh, state = self._asked(at)
        return np.asarray(self.tangents(at).G @ at.udot - mesh.gamma(state))

    def seen(self, at: Moment) -> Seen:
        """As :meth:`Contract.seen`, by central differences."""

        def outputs(x: Moment) -> Array:
            found: Array = self.model.outputs(
                x.q, x.u, r=x.r, z=x.z, s=x.s, t=x.t, parameters=x.parameters
            )
            return found

        along, by_u, by_r = (self._differences(at, block, outputs) for block in "qur")
        return Seen(along, by_u, np.zeros((len(self.outputs), 0)), by_r)

    def _differences(self, at: Moment, block: str, function: Callable[[Moment], Array]) -> Array:
        """Derivative (k, n) of a function along increments, by speeds or by inputs."""
        size = self.model.nr if block == "r" else self.model.nu
        unit_of = np.ones(size) if block == "r" else self.columns
        columns = []
        for k in range(size):
            sides = []
            for sign in (1.0, -1.0):
                step = np.zeros(size)
                step[k] = sign * STEP * unit_of[k]
                if block == "q":
                    moved = replace(at, q=self.integrate(at.q, step))
                elif block == "u":
                    moved = replace(at, u=at.u + step)
                else:
                    moved = replace(at, r=at.r + step)
                sides.append(function(moved))
            columns.append((sides[0] - sides[1]) / (2 * STEP * unit_of[k]))
        return np.stack(columns, axis=1) if columns else np.zeros((len(function(at)), 0))

    # coordinates

    @cached_property
    def increments(self) -> tuple[str, ...]:
        """As the contract has them."""
        turning = set(self._turning.ravel().tolist())
        found = []
        for k, name in enumerate(self.speeds):
            own = name.replace(".u", "", 1)
            same = own in self.coordinates and k not in turning
            found.append(own if same else f"along {name}")
        return tuple(found)

    @cached_property
    def _turning(self) -> NDArray[np.intp]:
        """Speeds that turn something, in body axes (n, 3)."""
        kinds, starts = self.tables.kinds, self.tables.u[:-1]
        turns = np.array([k.name == "node" or bool(k.functions) for k in kinds], dtype=bool)
        first = starts[turns[self.tables.kind]] if len(starts) else starts
        return np.asarray(first[:, None] + np.arange(3))

    def turning(self, at: Moment) -> Array:
        """As :meth:`Contract.turning`."""
        mesh = self._mesh(at.parameters)
        basis = np.eye(self.model.nu)
        return np.stack([mesh.rates(at.q, row) for row in basis], axis=1)

    def kinematics(self, at: Moment) -> Any:
        """As :meth:`Contract.kinematics`: rotations e obey e' = v - omega x e."""
        first, second, third = self._turning.T
        x, y, z = at.u[first], at.u[second], at.u[third]
        i = np.concatenate([first, first, second, second, third, third])
        j = np.concatenate([second, third, first, third, first, second])
        values = np.concatenate([z, -y, -z, x, y, -x])
        nu = self.model.nu
        return csr_array((values, (i, j)), (nu, nu)).toarray()

    def opened(self, at: Moment) -> Moment:
        """As :meth:`Contract.opened`: the stress of beams is an unknown of its own."""
        mesh, state = self._asked(at)
        return replace(at, inner=mesh.settled(state))

    def advanced(self, at: Moment, du: Array) -> Moment:
        """As :meth:`Contract.advanced`."""
        inner = at.inner
        if len(inner):
            mesh, state = self._asked(at)
            inner = mesh.stepped(replace(state, du=du))
        return replace(at, q=self.integrate(at.q, du) if np.any(du) else at.q, inner=inner)

    def integrate(self, q: Array, du: Array) -> Array:
        """As :meth:`Contract.integrate`."""
        moved: Array = unit(self._mesh(None).move(q, du), self.model.manifest["quaternions"])
        return moved

    def difference(self, q0: Array, q: Array) -> Array:
        """As :meth:`Contract.difference`, by Newton's method where rotations are no quaternions."""
        tables, found = self.tables, np.zeros(self.model.nu)
        for k, kind in enumerate(tables.kinds):
            places = np.flatnonzero(tables.kind == k)
            a = q0[tables.q[places][:, None] + np.arange(kind.nq)]
            b = q[tables.q[places][:, None] + np.arange(kind.nq)]
            spots = tables.u[places][:, None] + np.arange(kind.nu)
            if kind.nq == kind.nu:
                found[spots] = b - a
            elif kind.quaternion is not None:
                at = kind.quaternion
                turn = np.einsum("nji,njk->nik", rotation(a[:, at : at + 4]),
                                 rotation(b[:, at : at + 4]))  # fmt: skip
                found[spots[:, :3]] = _vectors(turn)
                others = [n for n in range(kind.nq) if not at <= n < at + 4]
                found[spots[:, 3:]] = (b - a)[:, others]
        return found


def _blocks(tables: Tables) -> Blockwise:
    """How the speeds and multipliers of a model stand together."""
    poses = np.array([kind.name == "node" for kind in tables.kinds], dtype=bool)
    elements, known = np.zeros(tables.m, dtype=np.intp), 0
    for number, group in enumerate(tables.groups):
        lines = tables.lines(number)
        elements[lines] = known + np.arange(len(group))[:, None]
        known += len(group)
    return Blockwise(tables.u, ~poses[tables.kind], elements)


def _vectors(turns: Array) -> Array:
    """Rotation vectors (n, 3) of rotation matrices (n, 3, 3)."""
    from scipy.spatial.transform import Rotation

    if not len(turns):
        return np.zeros((0, 3))
    found: Array = Rotation.from_matrix(turns).as_rotvec()
    return found


def _extent(model: CompiledModel, tables: Tables) -> float:
    """The largest distance of a node from their middle, at first [m]; 1 without any."""
    q = model.split(model.initial())[0]
    nodes = [k for k, kind in enumerate(tables.kind) if tables.kinds[kind].node]
    spread = np.array([tables.pose(q, k)[4:] for k in nodes] or np.zeros((1, 3)))
    size = float(np.linalg.norm(spread - spread.mean(axis=0), axis=1).max())
    return 2 * size or 1.0
