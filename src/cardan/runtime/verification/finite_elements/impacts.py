"""Events of a whole model in finite-element coordinates against dense linear algebra.

Values of events are those of the elements at accelerations and multipliers solved for here.
A transition changes momentum by impulses alone that elements ask for and constraints add, as
constraints allow; every impulse that acts reaches its speed; the kinetic energy changes by their
work.

Source: F. Pfeiffer and Ch. Glocker, Multibody Dynamics with Unilateral Contacts, 1996, chapter 8.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from ....errors import SolveError
from ....records import dataclass
from ...calls import loaded_function
from ...calls.code import Code
from ...calls.lanes import unpacked
from ...models.finite_elements.elements import State
from ...models.finite_elements.mesh import Mesh
from ..differences import relative, worst_of
from ..joint_motion import Array
from .element_events import ACTIVE, KIND, MISSING, RESPONSE, jumps
from .members import length_of, state_of

if TYPE_CHECKING:
    from ...models.loaded_model import LoadedModel

# larger models are not written out
LARGEST = 300
TRIALS, CLOSINGS, CLOSED = 8, 10, 1e-12
NEWTON = 8  # steps: each doubles the digits
# parts of the largest impulse, and of a response, that are none
NOTHING = 1e-9
# relative errors of a rounding, and how much more rounding may do than one that is tried
SHAKEN, LESS = 1e-15, 1e3
# difference of states that are the same
NEAR = 1e-6
NOWHERE = "not checked: nowhere its loops are closed"


def check_events(
    model: LoadedModel, mesh: Mesh, codes: Mapping[str, Code], states: int, seed: int
) -> dict[str, float | str]:
    """Error of values of events, of transitions, and of the energy that changes; or why not."""
    names = ("events", "transition", "energy at events")
    if mesh.tables.nu > LARGEST:
        return dict.fromkeys(names, f"not checked: more than {LARGEST} speeds")
    rng, errors = np.random.default_rng(seed), list[tuple[float, float, float]]()
    length = length_of(mesh.tables)
    start, modes = model._layout.start("s"), [row.labels for row in model.manifest.s]
    for k in range(max(states, *(len(each) for each in modes), 1)):
        # nearer and nearer to the start of the scene
        near = (state_of(model, mesh, rng, 0.5**n * length, 0.5**n) for n in range(TRIALS))
        at = next(filter(None, (_closed(mesh, state, start) for state in near)), None)
        if at is None:
            continue
        # the k-th mode of every element
        chosen = [
            float(list(each)[k % len(each)]) if each else x
            for each, x in zip(modes, start, strict=True)
        ]
        event_state = _Events(mesh, codes, replace(at, s=np.array(chosen)))
        try:
            errors += event_state.errors(rng)
        except SolveError:
            continue
    if not errors:
        return dict.fromkeys(names, NOWHERE)
    return dict(zip(names, (worst_of(*each) for each in zip(*errors, strict=True)), strict=True))


def _closed(mesh: Mesh, at: State, modes: Array) -> State | None:
    """A state near another that closes all loops; None where none is errors."""
    tables = mesh.tables
    at = replace(at, s=modes)
    try:
        for _ in range(CLOSINGS):
            out = mesh.call("close_position", at, tables.nq + tables.mp)
            at = replace(at, q=out[: tables.nq])
            if np.abs(out[tables.nq :]).max(initial=0.0) <= CLOSED:
                return at
    except SolveError:
        pass
    return None


@dataclass(frozen=True)
class _Events:
    """What happens at a state.

    Attributes:
        mesh, codes: Elements and their functions.
        at: Positions that close loops, and modes.
    """

    mesh: Mesh
    codes: Mapping[str, Code]
    at: State

    def errors(self, rng: np.random.Generator) -> Iterator[tuple[float, float, float]]:
        """Errors of values, transitions and energies, one event after the other and all at once.

        Towards what is hit, and away from it.
        """
        u = np.asarray(self.at.u)
        for speeds in (u, -u):
            at = replace(self.at, u=speeds, udot=None, lam=None)
            moving = replace(self, at=replace(at, u=self._closed(at)))
            values, ne = moving._values(), moving.mesh.tables.ne
            for e in (*np.eye(ne), self._simultaneous(rng, 1.0), self._simultaneous(rng, 0.5)):
                yield (values, *moving._transition(e))

    def _simultaneous(self, rng: np.random.Generator, share: float) -> Array:
        """Events of one time: one of every element, of a share of them.

        Those of one element exclude each other: no joint is at both its stops.
        """
        e = np.zeros(self.mesh.tables.ne)
        for group in self.mesh.tables.groups:
            for member in (
                () if group.events is None else np.reshape(group.events, (len(group), -1))
            ):
                if len(member) and rng.random() < share:
                    e[rng.choice(member)] = 1.0
        return e

    # the state

    def _closed(self, at: State) -> Array:
        """Speeds as constraints, and modes, ask for them."""
        nu = self.mesh.tables.nu
        return self.mesh.call("close_velocity", at, nu + self.mesh.tables.m)[:nu]

    @cached_property
    def matrices(self) -> tuple[Array, Array, Array]:
        """M, G and H."""
        tangent = self.mesh.tangent(self.at)
        M, G, H = (tangent[name].toarray() for name in "MGH")
        return M, G, H

    @cached_property
    def permanent(self) -> Array:
        """Which rows no mode lets go (m,)."""
        tables = self.mesh.tables
        rows = np.ones(tables.m, bool)
        for number, group in enumerate(tables.groups):
            rows[tables.lines(number)[:, group.kind.m - group.kind.released :]] = False
        return rows

    def struck(self, numbers: Array) -> Array:
        """Which rows belong to elements with impulses that act (m,): the modes behind these hold
        what has been brought to zero."""
        tables, first = self.mesh.tables, 0
        rows = np.zeros(tables.m, bool)
        for number in self._having("jumps"):
            group = tables.groups[number]
            count = len(group) * group.kind.jumps
            row_numbers = numbers[first : first + count].reshape(len(group), group.kind.jumps, -1)
            acting = (row_numbers[..., KIND] != RESPONSE) & (row_numbers[..., ACTIVE] != 0)
            if count and group.kind.m:
                rows[tables.lines(number)[acting.any(axis=1)]] = True
            first += count
        return rows

    @cached_property
    def system(self) -> Array:
        """Of accelerations and multipliers."""
        M, G, H = self.matrices
        return np.block([[M, -G.T], [G, H]])

    @cached_property
    def solution(self) -> State:
        """With accelerations and multipliers under the forces that act."""
        return self._solved(0.0)

    def _solved(self, rounding: float) -> State:
        """The same with so much rounding of all forces and coefficients."""
        nu, at = self.mesh.tables.nu, replace(self.at, udot=None, lam=None)
        gamma, rng = self.mesh.gamma(at), np.random.default_rng(9)
        _, G, H = self.matrices
        solution: Array = np.zeros(len(self.system))
        # friction that follows from reactions is solved for by Newton steps
        for _ in range(NEWTON if self.frictions else 1):
            at = replace(self.at, udot=solution[:nu], lam=solution[nu:])
            rows = gamma - G @ solution[:nu] - H @ solution[nu:]
            right = np.concatenate([-self.mesh.balance(at)[0], rows])
            system = self.system.copy()
            if self.frictions:
                system[:nu, nu:] = self._columns(at)
            a, b = (x * (1 + rounding * rng.uniform(-1, 1, x.shape)) for x in (system, right))
            solution = solution + np.linalg.lstsq(a, b, rcond=None)[0].astype(float)
        return replace(self.at, udot=solution[:nu], lam=solution[nu:])

    def _columns(self, at: State) -> Array:
        """Derivatives of the balance by the multipliers (nu, m)."""
        tables, tangent = self.mesh.tables, self.mesh.tangent(at)
        columns: Array = -tangent["G"].toarray().T
        L = tangent["L"].toarray().T
        for number, group in enumerate(tables.groups):
            if "L" in group.kind.parts:
                lines = tables.lines(number).ravel()
                columns[:, lines] = -L[:, lines]
        return columns

    @cached_property
    def frictions(self) -> int:
        """Number of those that follow from reactions."""
        return sum(len(group) * group.kind.frictions for group in self.mesh.tables.groups)

    @cached_property
    def certainty(self) -> Array:
        """How certain each of these is: 1 - sum_j c_i |F_ij| (frictions,)."""
        tables, at = self.mesh.tables, replace(self.at, udot=None, lam=None)
        coefficients, loads, normals = list[Array](), list[Array](), list[Array]()
        for number in self._having("reaction_friction"):
            group = tables.groups[number]
            k, nu, m = group.kind.frictions, group.kind.nu, group.kind.m
            values = self._call(number, "reaction_friction", at)
            c, along, normal = np.split(values, [k, k + k * nu], axis=-1)
            for member in range(len(group)):
                load, full = np.zeros((k, tables.nu)), np.zeros((k, 3, tables.m))
                np.add.at(load.T, tables.columns(group)[member], along[member].reshape(k, nu).T)
                full[:, :, tables.lines(number)[member]] = normal[member].reshape(k, 3, m)
                loads.append(load)
                normals.append(full)
            coefficients.append(c.ravel())
        force = np.concatenate([np.concatenate(loads), np.zeros((self.frictions, tables.m))], 1)
        moved = np.linalg.lstsq(self.system, force.T, rcond=None)[0][tables.nu :]
        shares = np.linalg.norm(np.concatenate(normals) @ moved, axis=1)
        return np.asarray(1 - np.concatenate(coefficients) * shares.sum(axis=1))

    def _more(self, number: int, responses: Array) -> dict[str, Array]:
        """What the events of a group read as ``tau``: certainties, then responses (n, k)."""
        groups = self.mesh.tables.groups
        k, n = groups[number].kind.frictions, len(groups[number])
        if not k:
            return {"tau": responses}
        first = sum(len(group) * group.kind.frictions for group in groups[:number])
        certainty = self.certainty[first : first + n * k].reshape(n, k)
        return {"tau": np.concatenate([certainty, responses], axis=1)}

    def _call(self, number: int, form: str, at: State, **more: Array) -> Array:
        """Results (n, size) of a function of a group."""
        group = self.mesh.tables.groups[number]
        code = self.codes[group.kind.functions[form]]
        n, blocks = len(group), {**self.mesh.read(number, at), **more}
        blocks = {k: np.array(np.broadcast_to(x, (n, x.shape[-1]))) for k, x in blocks.items()}
        run, out = loaded_function.calls(code, blocks, n)
        run()
        return unpacked(out, code.lanes)[:n]

    def _having(self, form: str) -> list[int]:
        groups = self.mesh.tables.groups
        return [k for k, group in enumerate(groups) if form in group.kind.functions]

    # what is judged

    def _values(self) -> float:
        """Of all events, less what rounding of accelerations and multipliers may do."""
        expected, result = (
            self._signs(self.solution),
            self.mesh.call("events", self.at, self.mesh.tables.ne),
        )
        rounded = LESS * np.abs(self._signs(self._solved(SHAKEN)) - expected)
        unique = np.ones(len(expected), bool)
        if np.linalg.matrix_rank(self.system) < len(self.system):
            # multipliers of redundant rows are not the only ones: values that read none are left
            other = replace(self.solution, lam=self._other_multipliers())
            unique = self._signs(other) == expected
        gap = np.maximum(np.abs(result - expected) - rounded, 0.0)
        return relative(gap[None, unique], expected[None, :], np.ones((1, 1)))

    def _signs(self, at: State) -> Array:
        """Values (ne,) of events by the elements."""
        tables = self.mesh.tables
        values = np.zeros(tables.ne)
        for number in self._having("signs"):
            events = tables.groups[number].events
            if events is not None:
                more = self._more(
                    number, np.zeros((len(events), tables.groups[number].kind.responses))
                )
                values[events] = self._call(number, "signs", at, **more)[:, :-1]
        return values

    def _other_multipliers(self) -> Array:
        """Multipliers that make the same forces where rows are redundant."""
        G, lam = self.matrices[1], self.solution.lam
        assert lam is not None
        free = np.eye(len(lam)) - np.linalg.pinv(G.T) @ G.T
        return np.asarray(lam + free @ np.linspace(1.0, 2.0, len(lam)))

    def _transition(self, e: Array) -> tuple[float, float]:
        """Error of a transition, and of the change of kinetic energy by it."""
        tables, nu = self.mesh.tables, self.mesh.tables.nu
        u = np.asarray(self.at.u)
        result = self.mesh.call("transition", self.at, nu + tables.nz + tables.ns, e=e)
        behind = result[:nu]
        numbers, J, responses = self._impulses(e)
        M, G, _ = self.matrices
        acting = (numbers[:, KIND] != RESPONSE) & (numbers[:, ACTIVE] != 0)
        rows = np.concatenate([J[acting], G[self.permanent]])
        momentum, count = M @ (behind - u), int(acting.sum())
        impulses, *_ = np.linalg.lstsq(rows.T, momentum, rcond=None)
        size = np.abs(M @ u)[None, :], np.abs(momentum)[None, :]
        worst = relative((rows.T @ impulses - momentum)[None, :], *size)
        # speeds were drawn of order 1
        scale = np.abs(u)[None, :], np.abs(behind)[None, :], np.ones((1, 1))
        worst = max(worst, relative((G[self.permanent] @ (behind - u))[None, :], *scale))
        worst = max(
            worst, self._unreached(J[acting], numbers[acting], behind - u, impulses[:count])
        )
        states = self._changed(e, behind, responses)
        # what rounding decides, such as of a mode that cannot end here, is left out
        near = [self._changed(e, behind, responses, shift) for shift in (-NOTHING, NOTHING)]
        certain = np.all([np.abs(other - states) <= NEAR for other in near], axis=0)
        worst = max(worst, relative((result[nu:] - states)[None, certain], np.ones((1, 1))))
        at = replace(self.at, u=behind, s=result[nu + tables.nz :])
        left = self.mesh.balance(at)[2][self.struck(numbers)]
        worst = max(worst, relative(left[None, :], *scale))
        work = 0.5 * impulses @ (rows @ (u + behind))
        energies = [
            self.mesh.total("energy", 2, replace(self.at, u=speeds))[0] for speeds in (u, behind)
        ]
        gap = np.array([[energies[1] - energies[0] - work]])
        return worst, relative(gap, np.array([energies]))

    def _impulses(self, e: Array) -> tuple[Array, Array, dict[int, Array]]:
        """Numbers (k, 4) and velocities (k, nu) of all impulses, and responses by group."""
        tables = self.mesh.tables
        numbers, rows, responses = list[Array](), list[Array](), dict[int, Array]()
        for number in self._having("jumps"):
            group = tables.groups[number]
            if not group.kind.jumps or group.events is None:
                continue
            values = self._call(number, "jumps", self.solution, e=e[group.events])
            row_numbers, local = jumps(values, group.kind.jumps)
            J = np.zeros((len(group), group.kind.jumps, tables.nu))
            columns = tables.columns(group)
            for member in range(len(group)):
                for k in range(columns.shape[1]):
                    J[member, :, columns[member, k]] += local[member, :, k]
            velocities = J[row_numbers[..., KIND] == RESPONSE]
            force = np.concatenate([velocities, np.zeros((len(velocities), tables.m))], axis=1)
            moved = np.linalg.lstsq(self.system, force.T, rcond=None)[0][: tables.nu]
            responses[number] = (velocities.T * moved).sum(axis=0).reshape(len(group), -1)
            numbers.append(row_numbers.reshape(-1, row_numbers.shape[-1]))
            rows.append(J.reshape(-1, tables.nu))
        if not rows:
            return np.zeros((0, 4)), np.zeros((0, tables.nu)), responses
        return np.concatenate(numbers), np.concatenate(rows), responses

    def _unreached(self, J: Array, numbers: Array, change: Array, impulses: Array) -> float:
        """What impulses that act miss of their speeds; some that only push are left out."""
        M, G, _ = self.matrices
        worst, size = 0.0, np.abs(impulses).max(initial=0.0)
        permanent = G[self.permanent]
        basis = np.linalg.qr(permanent.T)[0] if len(permanent) else np.zeros((len(M), 0))
        for row, row_numbers, impulse in zip(J, numbers, impulses, strict=True):
            # along what constraints hold nothing can be reached
            free = row - basis @ (basis.T @ row)
            pushed = row_numbers[KIND] == 0 or abs(impulse) > NOTHING * size
            if np.abs(free).max() <= NOTHING * np.abs(row).max(initial=0.0) or not pushed:
                continue
            gap = np.array([[row @ change + row_numbers[MISSING]]])
            worst = max(
                worst,
                relative(gap, np.array([[row_numbers[MISSING], 1.0]]), np.abs(change)[None, :]),
            )
        return worst

    def _changed(
        self, e: Array, behind: Array, responses: Mapping[int, Array], shift: float = 0.0
    ) -> Array:
        """z and s behind the events by the elements; shifted accelerations and multipliers."""
        tables, at = self.mesh.tables, self.solution
        udot, lam = np.asarray(at.udot), np.asarray(at.lam)
        udot, lam = (x + shift * (1.0 + np.abs(x).max(initial=0.0)) for x in (udot, lam))
        at = replace(at, udot=udot, lam=lam, du=behind)
        z = np.zeros(tables.nz) if self.at.z is None else np.array(self.at.z)
        s = np.zeros(tables.ns) if self.at.s is None else np.array(self.at.s)
        for number in self._having("change"):
            group = tables.groups[number]
            more = {"e": e[group.events]} if group.events is not None else {}
            if number in responses:
                more |= self._more(number, responses[number])
            values = self._call(number, "change", at, **more)
            first, second = group.kind.states
            if group.z is not None:
                z[group.z[:, :first]] = values[:, :first]
            if group.s is not None:
                s[group.s[:, :second]] = values[:, first : first + second]
        return np.concatenate([z, s])
