"""The figures to reach in computing motions, each with what was measured."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field

from benchmarks.figures import Figure
from benchmarks.motion.contest import Outcome
from benchmarks.motion.programs import PEERS, ours, scipy_same_c

OURS = (ours.NAME,)
# error at which the squeezer is compared [rad]
ANDREWS = 1e-7
OTHERS = tuple(program.name for program in PEERS)


@dataclass(frozen=True)
class Measured:
    """Everything measured.

    Attributes:
        outcomes: By name of the problem.
        gain: Time of an ensemble one by one over that in lanes, None where not measured.
        steps: Explicit steps over implicit ones of the stiff problem, None where not measured.
        lacking: Problem -> why it is not here.
    """

    outcomes: Mapping[str, Outcome]
    gain: float | None = None
    steps: float | None = None
    lacking: Mapping[str, str] = field(default_factory=dict)


def figures(found: Measured) -> list[Figure]:
    """All of them, in the order of the table."""
    return [
        *absolute(found),
        *panda(found),
        Figure("Panda, ensemble in lanes, of one by one", 5, found.gain, "", least=True),
        *andrews(found),
        Figure("stiff spring pendulum, explicit steps of implicit ones at 1e-5", 100, found.steps,
               "", least=True),
        Figure("programs beside cardan that took part", len(PEERS), len(present()), "",
               least=True),
    ]  # fmt: skip


def present() -> list[str]:
    """Other programs that are installed."""
    return [program.name for program in PEERS if not program.missing()]


def least(found: Measured, name: str, error: float, programs: tuple[str, ...]) -> float | None:
    """Seconds of the fastest run of some programs with at most this error."""
    outcome = found.outcomes.get(name)
    best = outcome and outcome.best(error, programs)
    return best.least if best else None


def ratio(found: Measured, name: str, error: float, others: tuple[str, ...]) -> float | None:
    """Fastest other program over the fastest of ours at an error."""
    mine, theirs = (least(found, name, error, who) for who in (OURS, others))
    return theirs / mine if mine and theirs else None


def absolute(found: Measured) -> Iterator[Figure]:
    for name, title, error, target in (
        ("double_pendulum", "double pendulum, 10 s", 1e-9, 1.0),
        ("ten_links", "ten-link pendulum, 10 s", 1e-10, 3.0),
    ):
        mine = least(found, name, error, OURS)
        value = 1e3 * mine if mine else None
        yield Figure(f"{title} to {error:g} m", target, value, "ms")
        beside = ratio(found, name, error, OTHERS)
        yield Figure(f"{title} to {error:g} m, fastest other of ours", 1, beside, "", least=True)


def panda(found: Measured) -> Iterator[Figure]:
    outcome = found.outcomes.get("panda")
    errors = [r.error for r in outcome.rows if r.program in OURS] if outcome else []
    yield Figure("Panda, 1 s, least error against 40 digits", 1e-9, min(errors, default=None),
                 "rad")  # fmt: skip
    rows = outcome.rows if outcome else ()
    explicit = {
        who: {r.setting: r for r in rows if r.program == who and r.method == "DOP853"}
        for who in (ours.NAME, scipy_same_c.NAME)
    }
    mine, theirs = (explicit[who].get(1e-9) for who in explicit)
    value = theirs.least / mine.least if mine and theirs else None
    yield Figure("Panda, 1 s at 1e-9, SciPy's DOP853 on our C of ours", 40, value, "", least=True)


def andrews(found: Measured) -> Iterator[Figure]:
    outcome = found.outcomes.get("andrews")
    for who in OTHERS:
        # MuJoCo has no such loops
        if outcome and who in outcome.absent:
            continue
        errors = [r.error for r in outcome.rows if r.program == who] if outcome else []
        # who does not get that far would take longer still
        reached = max(ANDREWS, min(errors, default=ANDREWS))
        theirs, mine = (
            least(found, "andrews", reached, (who,)),
            least(found, "andrews", ANDREWS, OURS),
        )
        note = f" (to {reached:.0e} only)" if reached > ANDREWS else ""
        name = f"Andrews' squeezer to {ANDREWS:g} rad, {who}{note} of ours"
        yield Figure(name, 1, theirs / mine if theirs and mine else None, "", least=True)
