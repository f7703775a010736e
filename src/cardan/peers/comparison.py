"""A compiled model beside all peers that are here: speed, error and agreement in one run."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from ..api.comparison import CompiledModel, scene_of
from ..arrays import Array
from ..errors import CardanError
from ..records import dataclass
from . import PEERS, peer
from .circuits import Circuits, circuits
from .contest import ROUNDS, Run, Time, contest, few, relative
from .ours import Ours
from .peer import Contender, States

SEED = 3
# of a loop, of a batch, and judged with 40 digits
LOOP, BATCH, EXACT_STATES = 64, 2048, 3
OURS, LANES = "cardan", "cardan, batch"
JUDGE = "pinocchio"
# states of closed systems: how far from the start [rad or m], steps back onto the constraints, and
# the residual that they must reach [m or 1]
NEAR, NEWTON, CLOSED = 0.2, 8, 1e-12
Show = Callable[[str], None]


@dataclass(frozen=True)
class Row:
    """One function of one program.

    Attributes:
        program: ``OURS``, ``LANES`` or the name of a peer.
        title: Program, version, compiler.
        function: Of ``FUNCTIONS``.
        time: Per call, of a batch per state.
        error: Largest |error| / |largest entry| against 40 digits; None where ours cannot judge.
        agreement: The same against Pinocchio, None where there is nothing to compare.
    """

    program: str
    title: str
    function: str
    time: Time
    error: float | None
    agreement: float | None


@dataclass(frozen=True)
class Comparison:
    """Rows of a comparison and the peers left out.

    Attributes:
        rows: By function, ours first.
        absent: Peer -> why it does not take part.
        condition: Largest condition number of M at the judged states.
    """

    rows: tuple[Row, ...]
    absent: dict[str, str]
    condition: float

    def row(self, function: str, program: str) -> Row | None:
        """One row, None where there is none."""
        for row in self.rows:
            if (row.function, row.program) == (function, program):
                return row
        return None


def compare(
    model: CompiledModel,
    functions: Sequence[str],
    chosen: Sequence[str] = tuple(PEERS),
    rounds: int = ROUNDS,
    show: Show = lambda text: None,
) -> Comparison:
    """Time functions of a model against peers, round by round, and judge everybody's numbers.

    Args:
        model: Has ``mass_matrix``, ``applied_forces`` and the functions.
        functions: Of ``FUNCTIONS``.
        chosen: Peers, of ``PEERS``.
        show: Receives what is being done.
    """
    ours = Ours(model)
    contenders, absent = taking_part(model, chosen, show)
    for name, contender in contenders.items():
        if not {*contender.functions} & {*functions}:
            absent[name] = f"it is compared in {', '.join(contender.functions)}"
    rows: list[Row] = []
    for function in functions:
        able = {name: c for name, c in contenders.items() if function in c.functions}
        rows += _measured(ours, able, function, rounds, show)
    place = model.mass_matrix(drawn(model, EXACT_STATES).q)
    return Comparison(tuple(rows), absent, float(np.linalg.cond(place).max()))


def _measured(
    ours: Ours, able: dict[str, Contender], function: str, rounds: int, show: Show
) -> list[Row]:
    """One function of everybody who has it, ours first."""
    states, batch = (drawn(ours.model, count) for count in (LOOP, BATCH))
    theirs = pushed(ours.model, function, states)
    # derivatives by speeds that are not ours, or without our forces: nothing to compare with
    shared = ours.model.nq == ours.model.nu and theirs is states
    show(f"{function}: compiling")
    runs: dict[str, Run] = {}
    values_of: dict[str, Array] = {}
    # the batch draws the same states first
    if function in ours.functions:
        runs = {OURS: ours.start(function, states), LANES: ours.batch(function, batch)}
        values_of = {OURS: ours.results(function, states), LANES: ours.results(function, batch)}
    runs |= {name: contender.start(function, theirs) for name, contender in able.items()}
    for name, contender in able.items():
        values = contender.results(function, theirs)
        if function == "inverse_dynamics":
            values = values - ours.model.applied_forces(states.q, states.u)
        if function != "derivatives" or shared:
            values_of[name] = values
    show(f"{function}: measuring")
    times = contest(runs, rounds)
    exact = ours.exact(function, few(states, EXACT_STATES)) if function in ours.functions else None
    return [
        Row(
            name,
            able[name].title if name in able else name,
            function,
            times[name],
            _difference(values_of.get(name), exact),
            _difference(values_of.get(name), values_of.get(JUDGE)),
        )
        for name in runs
    ]


def _difference(values: Array | None, expected: Array | None) -> float | None:
    """Relative difference at the states that both have."""
    if values is None or expected is None:
        return None
    count = min(len(values), len(expected))
    return relative(values[:count], expected[:count])


def taking_part(
    model: CompiledModel, chosen: Sequence[str], show: Show = lambda text: None
) -> tuple[dict[str, Contender], dict[str, str]]:
    """Peers made ready for the mechanism of a model, and why the others are not."""
    scene, joints = scene_of(model), [row.name for row in model.manifest.joints]
    closed = circuits(model) if model.manifest.multipliers else None
    contenders, absent = {}, {}
    for name in chosen:
        adapter = peer(name)
        why = adapter.missing() or adapter.refusal(scene, joints)
        if not why and closed is not None:
            why = closed if isinstance(closed, str) else "" if adapter.closed else "there are loops"
        if not why:
            show(f"preparing {adapter.name}")
            try:
                if adapter.closed and isinstance(closed, Circuits):
                    contenders[name] = adapter.closed(closed)
                else:
                    contenders[name] = adapter.contender(scene)
            except (CardanError, ValueError, ImportError) as problem:
                why = str(problem).splitlines()[0]
        if why:
            absent[name] = why
    return contenders, absent


def drawn(model: CompiledModel, count: int) -> States:
    """Random states inside limits, the same first ones for every count.

    Those of a closed system are on its constraints, around the position next to its initial one.
    """
    rng = np.random.default_rng(SEED)
    if model.manifest.multipliers:
        q, u = _on_constraints(model, rng)
    else:
        q, u = model.split(model.random_state(SEED, (BATCH,)))
    third = rng.uniform(-1, 1, (BATCH, model.nu))
    return States(*(np.ascontiguousarray(block[:count]) for block in (q, u, third)))


def _on_constraints(model: CompiledModel, rng: np.random.Generator) -> tuple[Array, Array]:
    """States near an assembled position (BATCH, nq), (BATCH, nu)."""
    start = model.assemble().q
    away, u = rng.uniform(-1, 1, (2, BATCH, model.nu))
    # along the motions that are allowed, then back onto the constraints
    along = model.close_velocity(start, NEAR * away)[:, : model.nu]
    q = model.integrate(np.broadcast_to(start, (BATCH, model.nq)), along)
    for _ in range(NEWTON):
        q = model.close_position(q)[:, : model.nq]
    lost = ~(np.abs(model.constraints(q)) < CLOSED).all(axis=1)
    q[lost] = start
    return q, model.close_velocity(q, u)[:, : model.nu]


def pushed(model: CompiledModel, function: str, states: States) -> States:
    """The states for programs that know nothing of the model's forces: they are part of tau."""
    if function == "inverse_dynamics":
        return states
    internal_forces = model.applied_forces(states.q, states.u)
    return (
        States(states.q, states.u, states.third + internal_forces)
        if np.any(internal_forces)
        else states
    )
