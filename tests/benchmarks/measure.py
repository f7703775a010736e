"""Runs the cases and collects what was found."""

from __future__ import annotations

import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import cardan as cd
from benchmarks.batches import Way, second_thread, ways
from benchmarks.cases import CASES, DERIVATIVES, FORWARD, LONG, MASS, Case
from benchmarks.ensembles import beside
from cardan.errors import CardanError
from cardan.peers.comparison import BATCH, LANES, LOOP, OURS, Comparison, compare, drawn
from cardan.peers.contest import Time, contest
from cardan.peers.ours import Ours
from cardan.peers.peer import States
from cardan.peers.processor import Peak, peak
from cardan.schema.functions import STANDARD

# what is prepared from a scene to its first accelerations, and of how many bodies
PREPARED, MANY = (
    {"chain": "chain", "tree": "random tree", "absolute": "chain in absolute coordinates"},
    10_000,
)
BUILDING = Path(__file__).with_name("building.py")
COUNTS = Path(__file__).parents[1] / "golden" / "counts.json"
SECONDS = 300
ENSEMBLES = ("panda",)


@dataclass(frozen=True)
class Found:
    """Everything measured.

    Attributes:
        comparisons, buildings: By name of the case; a building by the long chains' bodies too.
        counts: The committed operation counts.
        lacking: Case or peer -> why it was left out.
        peak: Of the processor, the larger of two measurements.
        lanes: States that a batch does at once.
        formulas: Closed case -> seconds of a call and of a state in a batch, its loops solved
            by formulas.
        ensembles: Case -> seconds of a run among many: one by one, in lanes.
        batches: Case -> ways of a batch to lie in memory, in doubles and floats.
        threads: Case -> time of a batch in one thread over that in two; None where other work
            kept it from being measured.
        prepared: Kind of scene -> seconds of all processors until its bodies have accelerations.
    """

    comparisons: dict[str, Comparison]
    buildings: dict[str, dict[str, Any]]
    counts: dict[str, dict[str, dict[str, int]]]
    lacking: dict[str, str]
    peak: Peak
    lanes: int
    formulas: dict[str, tuple[Time, Time]] = field(default_factory=dict)
    ensembles: dict[str, tuple[float, float]] = field(default_factory=dict)
    batches: dict[str, list[Way]] = field(default_factory=dict)
    threads: dict[str, float | None] = field(default_factory=dict)
    prepared: dict[str, float] = field(default_factory=dict)


def undamped(model: cd.CompiledModel) -> cd.CompiledModel:
    """The same without the damping of joints, which the peers are not told of."""
    damping = {name: 0.0 for name in model.parameters if name.endswith(".damping")}
    return model.with_parameters(damping) if damping else model


def measure(case: Case, rounds: int, show: Callable[[str], None]) -> tuple[Comparison, int]:
    """A case beside all peers, and the lanes of its batch."""
    plain = [function for function in case.functions if function != DERIVATIVES]
    plain = list(dict.fromkeys((FORWARD, *plain, MASS, "applied_forces")))
    # states of a closed system have to be found first, which may need anything
    functions = STANDARD if case.closed else (*plain, "derivative")
    model = undamped(cd.compile(case.build(), functions=functions, loops=case.loops))
    show(f"{case.title}: compiling")
    model.prepare(*plain)

    def told(text: str) -> None:
        show(f"{case.title}: {text}")

    return compare(model, case.functions, rounds=rounds, show=told), model.lanes(FORWARD)


def formulas(case: Case, rounds: int) -> tuple[Time, Time] | None:
    """Forward dynamics with loops in closed form, None where no loop has one."""
    whole, own = cd.compile(case.build()), cd.compile(case.build(), constraints="closed_form")
    if own.nu == whole.nu:
        return None
    q, u = ([names.index(name) for name in mine] for names, mine in (
        (whole.coordinates, own.coordinates), (whole.speeds, own.speeds)))  # fmt: skip

    def states(count: int) -> States:
        s = drawn(whole, count)
        return States(s.q[:, q].copy(), s.u[:, u].copy(), s.third[:, u].copy())

    ours = Ours(own)
    runs = {OURS: ours.start(FORWARD, states(LOOP)), LANES: ours.batch(FORWARD, states(BATCH))}
    times = contest(runs, rounds)
    return times[OURS], times[LANES]


def building(arguments: Sequence[str], limit: int) -> dict[str, Any]:
    """What ``building.py`` prints, with a cache of its own.

    Raises:
        TimeoutError: not within the limit [s]. RuntimeError: it failed, with its last line.
    """
    with tempfile.TemporaryDirectory(prefix="cardan-bench-") as private:
        environment = {**os.environ, "CARDAN_CACHE": f"{private}/cache"}
        command = [sys.executable, "-W", "ignore", str(BUILDING), *arguments]
        try:
            done = subprocess.run(
                command, capture_output=True, text=True, env=environment, timeout=limit
            )
        except subprocess.TimeoutExpired:
            raise TimeoutError(f"not within {limit} s") from None
    if done.returncode:
        lines = done.stderr.strip().splitlines() or [f"status {done.returncode}"]
        raise RuntimeError(lines[-1])
    return dict(json.loads(done.stdout))


def run(quick: bool, rounds: int, show: Callable[[str], None]) -> Found:
    """All cases; what cannot be measured is named."""
    comparisons: dict[str, Comparison] = {}
    buildings: dict[str, dict[str, Any]] = {}
    lacking: dict[str, str] = {}
    by_formulas: dict[str, tuple[Time, Time]] = {}
    many: dict[str, tuple[float, float]] = {}
    batches: dict[str, list[Way]] = {}
    threads: dict[str, float | None] = {}
    peaks, lanes = [peak()], 1
    for case in CASES:
        if quick and not case.quick:
            continue
        try:
            comparisons[case.name], width = measure(case, rounds, show)
            lanes = max(lanes, width)
            solved = formulas(case, rounds) if case.closed else None
            if solved is not None:
                by_formulas[case.name] = solved
            if case.name in ENSEMBLES:
                show(f"{case.title}: ensemble")
                many[case.name] = beside(case, rounds)
                show(f"{case.title}: batches")
                batches[case.name] = ways(case, rounds)
                threads[case.name] = second_thread(case)
            show(f"{case.title}: building")
            buildings[case.name] = building([case.name], SECONDS)
        except (CardanError, FileNotFoundError, TimeoutError, RuntimeError) as problem:
            lacking[case.title] = str(problem).splitlines()[0]
    for bodies, limit in {} if quick else LONG.items():
        show(f"chain of {bodies}")
        try:
            buildings[str(bodies)] = building(["--long", str(bodies)], limit)
        except (TimeoutError, RuntimeError) as problem:
            lacking[f"chain of {bodies:,}"] = str(problem)
    prepared: dict[str, float] = {}
    for kind, title in {} if quick else PREPARED.items():
        show(f"preparing a {title} of {MANY:,}")
        try:
            row = building(["--prepare", kind, str(MANY)], SECONDS)
            prepared[kind] = row["prepared"]
        except (TimeoutError, RuntimeError) as problem:
            lacking[f"preparing a {title} of {MANY:,}"] = str(problem)
    peaks.append(peak())
    best = max(peaks, key=lambda found: found.vector)
    counts = json.loads(COUNTS.read_text("utf-8"))
    return Found(
        comparisons,
        buildings,
        counts,
        lacking,
        best,
        lanes,
        by_formulas,
        many,
        batches,
        threads,
        prepared,
    )
