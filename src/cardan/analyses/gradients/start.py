"""How the start of a run follows from what was named.

Where loops are closed, what was not named follows from what was, and from parameters and inputs: by
the shortest change that keeps the loops closed.
"""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
from scipy.linalg import null_space

from ...arrays import Array
from ...records import dataclass
from ...runtime.calls.methods import ByName
from ...runtime.models.constraint_projection import columns_of
from ...runtime.models.loaded_model import LoadedModel
from ...schema.blocks import Blocks
from ...schema.request import reads
from ..mechanisms.consistent_rates import inverse_root
from ..simulation.driving import RunSetup
from ..simulation.settings import start
from .start_by_differences import StartByDifferences
from .steps import StepsAgain
from .unknowns import Unknowns

CLOSED = 1e-9  # changes that close loops up to which a start was closed as it was named
RANK = 1e-9  # of the largest singular value: rows that say nothing new


@dataclass(frozen=True)
class Level:
    """Constraints of positions or of speeds at the start: their derivatives.

    Attributes:
        rows: Along what they determine (m, nu).
        by_q: Along coordinates (m, nu), of those of speeds; None of those of positions.
        by_r, by_p: By inputs (m, nr) and parameters (m, np).
        free: Changes (nu, k) that hold what was named, normal to each other as starts are closed:
            of coordinates where lengths count in sizes of the mechanism, of speeds where masses do.
    """

    rows: Array
    by_q: Array | None
    by_r: Array
    by_p: Array
    free: Array

    @property
    def unique(self) -> bool:
        """True where constraints leave nothing free."""
        size = self.free.shape[1]
        return not size or bool(np.linalg.matrix_rank(self.rows @ self.free, rtol=RANK) == size)

    @property
    def inverse(self) -> Array:
        """Changes (nu, m) that hold what was named, by which each row is met."""
        return self.free @ np.linalg.pinv(self.rows @ self.free, rcond=RANK)


@dataclass(frozen=True)
class NamedStart:
    """Derivatives of the start of a run by what was named, by parameters and by inputs.

    Attributes:
        model: The model.
        kinematic: N (nq, nu): rates of the coordinates by the speeds.
        positions, speeds: Constraints there; None without.
    """

    model: LoadedModel
    kinematic: Array
    positions: Level | None
    speeds: Level | None

    @classmethod
    def of(
        cls, setup: RunSetup, steps: StepsAgain, state: Mapping[str, object], s: Array, wide: bool
    ) -> NamedStart:
        """The derivatives at the start of a run.

        Args:
            setup: The run.
            steps: Its steps.
            state: x0, q, u and z as they were given.
            s: Modes (ns,) at the start.
            wide: Whether derivatives by parameters are asked for.
        """
        model = setup.model
        q, u, z = model.parts_of(setup.begin.x)
        at: ByName = {"t": setup.over.start, "r": steps.inputs_at(setup.over.start)[0]}
        N, closing, levels = _kinematic(model, q, u, at), steps.runner.closing, dict[str, Level]()
        if not closing.functions:
            return cls(model, N, None, None)
        units = columns_of(model, closing.size)
        blocks = ["r"] * (model.nr > 0) + ["p"] * (wide and len(model.parameters) > 0)
        empty = {"r": model.nr, "p": len(model.parameters) if wide else 0}
        functions = {"u": "constraint_rates" if closing.rates else ""}
        functions["q"] = "constraints" if closing.positions else ""
        for letter, function in functions.items():
            if not function:
                continue
            speeds = letter == "u"
            wrt = Blocks(("q", *["u"] * speeds, *blocks))
            states: ByName = {"u": u, "z": z, "s": s} if speeds else {}
            columns = dict(
                zip(wrt, model.derivative(function, wrt=wrt)(q=q, **states, **at), strict=True)
            )
            rows = columns[letter]
            by_r, by_p = (
                columns.get(name, np.zeros((len(rows), size))) for name, size in empty.items()
            )
            by_q = columns["q"] if speeds else None
            fixed = (np.eye(model.nu) if speeds else N)[_named(model, letter, state[letter])]
            free = units[:, None] * null_space(fixed * units, rcond=RANK)
            if speeds and "mass_matrix" in model.manifest.available:
                # speeds change by impulses
                free = free @ inverse_root(free.T @ model.mass_matrix(q, **at) @ free)
            levels[letter] = Level(rows, by_q, by_r, by_p, free)
        return cls(model, N, levels.get("q"), levels.get("u"))

    def backward(self, lam: Array) -> tuple[Array, Array, Array]:
        """Gradients by the named start (2 nu + nz,), by inputs and by parameters.

        Args:
            lam: Gradient by the state (nx,).
        """
        nq, nu = self.model.nq, self.model.nu
        by_q, by_u = self.kinematic.T @ lam[:nq], lam[nq : nq + nu].copy()
        by_r = by_p = np.zeros(0)
        for level, bars in ((self.speeds, by_u), (self.positions, by_q)):
            if level is None:
                continue
            # what is named is held: the rest makes up for it
            weights = level.inverse.T @ bars
            bars -= weights @ level.rows
            if level.by_q is not None:
                by_q -= weights @ level.by_q
            by_r = by_r - weights @ level.by_r if by_r.size else -weights @ level.by_r
            by_p = by_p - weights @ level.by_p if by_p.size else -weights @ level.by_p
        return np.concatenate([by_q, by_u, lam[nq + nu :]]), by_r, by_p

    def forward(self, start: Array, by_r: Array, by_p: Array) -> Array:
        """Changes of the state (k, nx) by those of what was named (k, 2 nu + nz).

        by_r (k, nr) and by_p (k, np) are those of inputs and parameters.
        """
        nu = self.model.nu
        q, u = start[:, :nu].copy(), start[:, nu : 2 * nu].copy()
        for level, change in ((self.positions, q), (self.speeds, u)):
            if level is None:
                continue
            missed = change @ level.rows.T + by_r @ level.by_r.T + by_p @ level.by_p.T
            if level.by_q is not None:
                missed = missed + q @ level.by_q.T
            change -= missed @ level.inverse.T
        return np.hstack([q @ self.kinematic.T, u, start[:, 2 * nu :]])


def named_start(
    setup: RunSetup,
    steps: StepsAgain,
    state: Mapping[str, object],
    s: Array,
    unknowns: Unknowns,
    wide: bool,
) -> NamedStart | StartByDifferences:
    """The derivatives at the start of a run, see :meth:`NamedStart.of`.

    ``state["next_to"]``: a state (nx,) next to which loops are closed, not that of the scene.
    """
    if setup.model.manifest.absolute:
        return StartByDifferences.of(setup, steps, state, s, unknowns)
    begin = NamedStart.of(setup, steps, state, s, wide)
    if not (begin.positions or begin.speeds):
        return begin
    by_names = state["x0"] is None and all(
        state[letter] is None or isinstance(state[letter], Mapping) for letter in "qu"
    )
    if not by_names or "next_to" in state:
        return begin
    model, nq = setup.model, setup.model.nq
    moved = np.abs(setup.begin.x - start(model, None, state["q"], state["u"], state["z"]).x)
    parts = ((begin.positions, moved[:nq]), (begin.speeds, moved[nq : nq + model.nu]))
    if any(level and not level.unique and part.max() > CLOSED for level, part in parts):
        # which of many starts it is depends on distances, and these on more than constraints
        return StartByDifferences.of(setup, steps, state, s, unknowns)
    return begin


def _kinematic(model: LoadedModel, q: Array, u: Array, at: ByName) -> Array:
    """N (nq, nu): rates of the coordinates by the speeds."""
    if not model.nu:
        return np.zeros((model.nq, 0))
    values, key = {"q": q, "u": u, **at}, ("derivative", "qdot: u")
    listed = tuple(values.get(name) for name in reads(*key))
    return model._evaluate(key, listed, None, None)


def _named(model: LoadedModel, letter: str, values: object) -> list[int]:
    """Entries of q or u that were named."""
    size, places = (model.nq if letter == "q" else model.nu), model.manifest.slots(letter)
    names = values if isinstance(values, Mapping) else ()
    # coordinates that follow by formulas have no place
    ranges = (range(*places[name].indices(size)) for name in names if name in places)
    return [k for entries in ranges for k in entries]
