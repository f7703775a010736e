"""The figures to reach, each with what was measured."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from benchmarks.cases import CASES, DERIVATIVES, FORWARD, INVERSE, MASS
from benchmarks.measure import MANY, PREPARED, Found
from cardan.peers import PEERS, peer
from cardan.peers.comparison import LANES, OURS, Comparison

EPS = float(np.finfo(float).eps)
# multiplications and additions of one sine with its cosine in kernels/sincos.h
SINCOS = 48
# "a small multiple" of eps cond(M)
MULTIPLE = 10


@dataclass(frozen=True)
class Figure:
    """One figure to reach.

    Attributes:
        name: What it is.
        target: Not to be exceeded; to be reached where ``least``.
        value: Measured, None where it could not be.
        unit: ``""`` for counts and ratios.
        least: Whether more is better.
    """

    name: str
    target: float
    value: float | None
    unit: str = ""
    least: bool = False

    @property
    def reached(self) -> bool:
        """Whether it is."""
        if self.value is None:
            return False
        return self.value >= self.target if self.least else self.value <= self.target

    def texts(self) -> tuple[str, str, str, str]:
        """Name, target, measured, verdict."""
        sign, unit = ("≥" if self.least else "≤"), f" {self.unit}" if self.unit else ""
        measured = "not measured" if self.value is None else f"{self.value:.3g}{unit}"
        if self.value is not None and not self.unit and self.value >= 10:
            measured = f"{self.value:.0f}"
        verdict = "reached" if self.reached else "missed"
        return self.name, f"{sign} {self.target:g}{unit}", measured, verdict


def figures(found: Found) -> list[Figure]:
    """All of them, in the order of the table."""
    return [
        *counts(found),
        *scalar(found),
        *batch(found),
        *derivatives(found),
        *circuits(found),
        *ensembles(found),
        *in_memory(found),
        *building(found),
        *accuracy(found),
        Figure("peers that took part", len(PEERS), len(present()), "", least=True),
    ]


def present() -> list[str]:
    """Peers that are installed and can be built."""
    return [name for name in PEERS if not peer(name).missing()]


def operations(found: Found, case: str, function: str) -> float | None:
    """Multiplications and additions of a function."""
    row = found.counts.get(case, {}).get(function)
    return None if row is None else float(row["mul"] + row["add"])


def flops(found: Found, case: str, function: str) -> float:
    """Everything the processor does at one state, as far as it is arithmetic."""
    row = found.counts[case][function]
    plain = sum(row.get(name, 0) for name in ("mul", "add", "neg", "div", "sqrt"))
    return plain + SINCOS * row.get("trig", 0) / 2


def counts(found: Found) -> Iterator[Figure]:
    for case, title, forward, inverse in (("panda", "Panda", 1165, 605), ("ur5", "UR5", 415, 295)):
        for function, target in ((FORWARD, forward), (INVERSE, inverse)):
            name = f"operations, {title}, {function.replace('_', ' ')}"
            yield Figure(name, target, operations(found, case, function))
    value = operations(found, "puma560", INVERSE)
    yield Figure("operations, PUMA 560, inverse dynamics", 440, value)


def ratio(found: Found, case: str, function: str, program: str, of: str = OURS) -> float | None:
    """Our time over that of a peer."""
    comparison = found.comparisons.get(case)
    mine, theirs = (comparison and comparison.row(function, name) for name in (of, program))
    return mine.time.least / theirs.time.least if mine and theirs else None


def scalar(found: Found) -> Iterator[Figure]:
    for case, title in (("panda", "Panda"), ("ur5", "UR5"), ("chain7", "7R chain")):
        for program, target in (("casadi", 0.55), ("pinocchio", 0.16)):
            name = f"forward dynamics, {title}, of {peer(program).name}'s time"
            yield Figure(name, target, ratio(found, case, FORWARD, program))
    rest = [(case, title, 0.6) for case, title in
            (("anymal", "ANYmal"), ("talos", "Talos"), ("icub", "iCub"), ("g1", "G1"))]  # fmt: skip
    rest += [("chain30", "chain of 30", 0.45), ("chain100", "chain of 100", 0.45)]
    for case, title, target in rest:
        name = f"forward dynamics, {title}, of CasADi's time"
        yield Figure(name, target, ratio(found, case, FORWARD, "casadi"))

    for case, title, program, target in (
        ("full30", "chain of 30, full inertias", "casadi", 0.45),
        ("full100", "chain of 100, full inertias", "pinocchio", 0.25),
    ):
        name = f"forward dynamics, {title}, of {peer(program).name}'s time"
        yield Figure(name, target, ratio(found, case, FORWARD, program))


def batch(found: Found) -> Iterator[Figure]:
    comparison = found.comparisons.get("panda")
    for function, target in ((FORWARD, 24), (INVERSE, 12)):
        row = comparison and comparison.row(function, LANES)
        time = 1e9 * row.time.least if row else None
        name = f"Panda, {function.replace('_', ' ')}, batch"
        yield Figure(f"{name}, per state", target, time, "ns")
        share = time and 100 * flops(found, "panda", function) / time / found.peak.vector
        yield Figure(f"{name}, of the peak", 45, share, "%", least=True)


def derivatives(found: Found) -> Iterator[Figure]:
    for case, title in (("panda", "Panda"), ("talos", "Talos")):
        for of, way, target in ((OURS, "scalar", 0.3), (LANES, "batch", 0.08)):
            value = ratio(found, case, DERIVATIVES, "pinocchio", of)
            yield Figure(f"derivatives, {title}, {way}, of Pinocchio's time", target, value)
    for case, title, target in (
        ("chain30", "chain of 30", 0.45),
        ("chain100", "chain of 100", 0.5),
    ):
        value = ratio(found, case, DERIVATIVES, "pinocchio")
        yield Figure(f"derivatives, {title}, of Pinocchio's time", target, value)
    for case, title, target in (("talos", "Talos", 0.25), ("chain100", "chain of 100", 0.5)):
        value = ratio(found, case, MASS, "pinocchio")
        yield Figure(f"mass matrix, {title}, of Pinocchio's time", target, value)


def circuits(found: Found) -> Iterator[Figure]:
    # Pinocchio knows no rolling wheels
    for case in (case for case in CASES if case.closed and case.name != "bicycle"):
        name = f"closed, {case.title}, of Pinocchio's time"
        yield Figure(name, 0.3, ratio(found, case.name, FORWARD, "pinocchio"))
    for case, title in (("four_bar", "four-bar"), ("slider_crank", "slider-crank")):
        solved = found.formulas.get(case)
        name = f"closed, {title}, by formulas"
        yield Figure(name, 0.5, 1e6 * solved[0].least if solved else None, "us")


def ensembles(found: Found) -> Iterator[Figure]:
    alone, lanes = found.ensembles.get("panda", (None, None))
    gain = alone / lanes if alone and lanes else None
    yield Figure("ensemble of Panda, runs per time, of our loop in C", 5.5, gain, least=True)


def in_memory(found: Found) -> Iterator[Figure]:
    """Batches from Python, by how they lie in memory and by the type of their numbers."""
    ways = {way.name: 1e9 * way.seconds for way in found.batches.get("panda", [])}
    targets = {"rows": 33, "structure of arrays": 25, "structure of arrays, float32": 13.5}
    for name, target in targets.items():
        title = f"Panda, forward dynamics, batch from Python, {name}"
        yield Figure(title, target, ways.get(name), "ns")
    second = found.threads.get("panda")
    yield Figure("Panda, forward dynamics, two threads, of one", 1.85, second, least=True)


def building(found: Found) -> Iterator[Figure]:
    def value(case: str, key: str, scale: float = 1.0) -> float | None:
        return found.buildings[case][key] * scale if case in found.buildings else None

    yield Figure("derivation, Panda", 12, value("panda", "derived", 1e3), "ms")
    yield Figure("derivation, chain of 100", 150, value("chain100", "derived", 1e3), "ms")
    yield Figure("cold compile, Panda", 0.3, value("panda", "compiled"), "s")
    yield Figure("cold compile, chain of 100", 3, value("chain100", "compiled"), "s")
    for case, title in (
        ("chain30", "chain of 30"),
        ("talos", "Talos"),
        ("chain100", "chain of 100"),
    ):
        yield Figure(f"derivatives written and compiled, {title}", 1, value(case, "slopes"), "s")
    yield Figure("cold compile, chain of 1,000, loops", 0.4, value("1000", "compiled"), "s")
    for kind, title in PREPARED.items():
        yield Figure(f"prepare {MANY:,} bodies, {title}", 5, found.prepared.get(kind), "s")
    far, near = value("100000", "call"), value("1000", "call")
    growth = far / near if far and near else None
    yield Figure("100,000 bodies, per body and state, of the time at 1,000", 1.3, growth)


def multiple(comparison: Comparison) -> float:
    """Largest error of ours in units of eps cond(M)."""
    ours = [row.error for row in comparison.rows if row.program in (OURS, LANES)]
    worst = max(error for error in ours if error is not None)
    return worst / (EPS * comparison.condition)


def accuracy(found: Found) -> Iterator[Figure]:
    worst = max((multiple(c) for c in found.comparisons.values()), default=None)
    yield Figure("largest error of ours in eps cond(M)", MULTIPLE, worst)
    comparison = found.comparisons.get("chain100")
    row = comparison and comparison.row(FORWARD, OURS)
    yield Figure("error, chain of 100", 2e-14, row.error if row else None)
