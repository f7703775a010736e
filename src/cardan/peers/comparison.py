"""A compiled model beside all peers that are here: speed, error and agreement in one run."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from ..errors import CardanError
from ..runtime.compiled import CompiledModel
from ..runtime.newton_euler import Scene
from ..runtime.verify import scene_of
from . import PEERS, peer
from .contest import ROUNDS, Run, Time, contest, few, relative
from .ours import Ours
from .peer import Array, Contender, States

SEED = 3
# of a loop, of a batch, and judged with 40 digits
LOOP, BATCH, JUDGED = 64, 1024, 3
OURS, LANES = "cardan", "cardan, batch"
JUDGE = "pinocchio"


@dataclass(frozen=True)
class Row:
    """One function of one program.

    Attributes:
        program: ``OURS``, ``LANES`` or the name of a peer.
        title: Program, version, compiler.
        function: Of ``FUNCTIONS``.
        time: Per call, of a batch per state.
        error: Largest |error| / |largest entry| against 40 digits.
        agreement: The same against Pinocchio, None where that is not here.
    """

    program: str
    title: str
    function: str
    time: Time
    error: float
    agreement: float | None


@dataclass(frozen=True)
class Comparison:
    """What was found.

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
    show: Callable[[str], None] = lambda text: None,
) -> Comparison:
    """Time functions of a model against peers, round by round, and judge everybody's numbers.

    Args:
        model: Has ``mass_matrix``, ``applied`` and the functions.
        functions: Of ``FUNCTIONS``.
        chosen: Peers, of ``PEERS``.
        show: Receives what is being done.
    """
    ours, scene = Ours(model), scene_of(model)
    states, batch = (drawn(model, count) for count in (LOOP, BATCH))
    contenders, absent = taking_part(scene, chosen, show)
    rows: list[Row] = []
    for function in functions:
        show(f"{function}: compiling")
        able = {name: c for name, c in contenders.items() if function in c.functions}
        theirs = pushed(model, function, states)
        runs: dict[str, Run] = {}
        for name, contender in able.items():
            runs[name] = contender.start(function, theirs)
        runs[OURS] = ours.start(function, states)
        runs[LANES] = ours.batch(function, batch)
        show(f"{function}: measuring")
        times = contest(runs, rounds)
        found = {name: c.results(function, theirs) for name, c in able.items()}
        if function == "inverse_dynamics":
            own = model.applied(states.q, states.u)
            found = {name: values - own for name, values in found.items()}
        found[OURS] = ours.results(function, states)
        found[LANES] = ours.results(function, batch)
        titles = {name: c.title for name, c in able.items()} | {OURS: OURS, LANES: LANES}
        exact = ours.exact(function, few(states, JUDGED))
        # the batch draws the same states first
        rows += [
            Row(name, titles[name], function, times[name], relative(values[:JUDGED], exact),
                _agreement(values, found.get(JUDGE)))
            for name, values in sorted(found.items(), key=lambda item: not item[0].startswith(OURS))
        ]  # fmt: skip
    condition = float(np.linalg.cond(model.mass_matrix(states.q[:JUDGED])).max())
    return Comparison(tuple(rows), absent, condition)


def _agreement(values: Array, judge: Array | None) -> float | None:
    if judge is None:
        return None
    count = min(len(values), len(judge))
    return relative(values[:count], judge[:count])


def taking_part(
    scene: Scene, chosen: Sequence[str], show: Callable[[str], None] = lambda text: None
) -> tuple[dict[str, Contender], dict[str, str]]:
    """Peers made ready for a tree, and why the others are not."""
    contenders, absent = {}, {}
    for name in chosen:
        found = peer(name)
        why = found.missing() or found.refusal(scene)
        if not why:
            show(f"preparing {found.name}")
            try:
                contenders[name] = found.contender(scene)
            except (CardanError, ValueError, ImportError) as problem:
                why = str(problem).splitlines()[0]
        if why:
            absent[name] = why
    return contenders, absent


def drawn(model: CompiledModel, count: int) -> States:
    """Random states inside limits, the same first ones for every count."""
    q, u = model.split(model.random_state(SEED, (BATCH,)))
    third = np.random.default_rng(SEED).uniform(-1, 1, (BATCH, model.nu))
    return States(*(np.ascontiguousarray(block[:count]) for block in (q, u, third)))


def pushed(model: CompiledModel, function: str, states: States) -> States:
    """The states for programs that know nothing of the model's forces: they are part of tau."""
    if function == "inverse_dynamics":
        return states
    own = model.applied(states.q, states.u)
    return States(states.q, states.u, states.third + own)
