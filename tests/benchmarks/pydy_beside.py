"""from_sympy beside PyDy on PyDy's own examples: build, call and error in one run.

    python tests/benchmarks/pydy_beside.py [--quick]

prints a table and writes docs/performance/sympy.md. Needs PyDy and Cython.
"""

from __future__ import annotations

import gc
import os
import resource
import sys
import tempfile
import warnings
from collections.abc import Callable
from contextlib import chdir
from dataclasses import dataclass
from pathlib import Path
from time import thread_time
from typing import Any

import numpy as np

ROOT = Path(__file__).parents[2]
sys.path.insert(0, str(ROOT))
# every build is a first one
os.environ["CARDAN_CACHE"] = tempfile.mkdtemp(prefix="beside-")

from tests.benchmarks.provenance import signed  # noqa: E402
from tests.benchmarks.pydy_examples import EXAMPLES  # noqa: E402

import cardan as cd  # noqa: E402
from cardan.runtime.calls import samples  # noqa: E402
from cardan.runtime.calls.function_costs import _measure  # noqa: E402
from cardan.runtime.calls.measuring import BATCH  # noqa: E402

PAGE = ROOT / "docs" / "performance" / "sympy.md"
ROUNDS, CALLS, DIGITS = 15, 300, 40
FORCE = 0.3


@dataclass(frozen=True)
class Row:
    """One example: seconds and errors, ours and PyDy's.

    Attributes:
        derivation: What SymPy takes before either begins.
        build: From the KanesMethod to the first right-hand side, compilers included.
        call: Of a right-hand side from Python.
        inner: Of ours as integrators call it, in C.
        batch: Of ours, per state of many.
        error: Against SymPy's matrices in 40 digits, of the largest derivative.
    """

    name: str
    speeds: int
    derivation: float
    build: tuple[float, float]
    call: tuple[float, float]
    inner: float
    batch: float
    error: tuple[float, float]


def measured(name: str, rounds: int) -> Row:
    """One example by both."""
    began = spent()
    kane, values = EXAMPLES[name]()
    derivation = spent() - began
    began, count = spent(), len(kane.q) + len(kane.u)
    theirs, r = pydy(kane, values), np.full(len(inputs_of(kane)), FORCE)
    theirs(np.full(count, 0.1), r)
    pydy_build = spent() - began
    began = spent()
    model = cd.compile(cd.from_sympy(kane, parameters=values, name=name))
    pushing = model._vector("r", {str(f.func): FORCE for f in inputs_of(kane)})
    model.rhs(0.0, np.full(count, 0.1), pushing)
    our_build = spent() - began
    x = closed(model)
    true = truth(kane, values, x)
    found = model.rhs(0.0, x, pushing), theirs(x, r)
    own, their = (float(np.abs(f - true).max() / np.abs(true).max()) for f in found)
    call = alternately(lambda: model.rhs(0.0, x, pushing), lambda: theirs(x, r), rounds)
    function = model._function("rhs")
    drawn = samples.values(model, function, np.random.default_rng(1), BATCH)
    rows = [_measure(function, drawn, None) for _ in range(3)]
    return Row(
        name,
        len(kane.u),
        derivation,
        (our_build, pydy_build),
        call,
        min(row.call_ns for row in rows) * 1e-9,
        min(row.state_ns for row in rows) * 1e-9,
        (own, their),
    )


def spent() -> float:
    """Seconds of processor that this process and the compilers it started have used."""
    used = [resource.getrusage(who) for who in (resource.RUSAGE_SELF, resource.RUSAGE_CHILDREN)]
    return sum(each.ru_utime + each.ru_stime for each in used)


def inputs_of(kane: Any) -> list[Any]:
    """Functions of time that move the system, in order."""
    from sympy.physics.mechanics import find_dynamicsymbols

    found = find_dynamicsymbols(kane.forcing) - set(kane.q) - set(kane.u)
    return sorted(found, key=str)


def pydy(kane: Any, values: dict[Any, float]) -> Callable[[np.ndarray, np.ndarray], np.ndarray]:
    """Its right-hand side, as fast as it can be called."""
    from pydy.codegen.ode_function_generators import generate_ode_function
    from sympy import Matrix

    symbols = {s for m in (kane.mass_matrix, kane.forcing) for s in m.free_symbols}
    symbols = {s for s in symbols if s.name in {str(key) for key in values}}
    constants, specifieds = sorted(symbols, key=str), inputs_of(kane)
    numbers = np.array([{str(k): v for k, v in values.items()}[s.name] for s in constants])
    rates = kane.kindiffdict()
    given = {"specifieds": specifieds, "specifieds_arg_type": "array"} if specifieds else {}
    with tempfile.TemporaryDirectory() as folder, chdir(folder), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        rhs = generate_ode_function(
            kane.forcing, list(kane.q), list(kane.u), constants=constants,
            mass_matrix=kane.mass_matrix, constants_arg_type="array", generator="cython",
            coordinate_derivatives=Matrix([rates[q.diff()] for q in kane.q]), **given,
        )  # fmt: skip
    if specifieds:
        return lambda x, r: rhs(x, 0.0, r, numbers)
    return lambda x, r: rhs(x, 0.0, numbers)


def closed(model: cd.CompiledModel) -> np.ndarray:
    """A random state on the constraints."""
    rng = np.random.default_rng(4)
    q, u = rng.uniform(0.1, 0.4, model.nq), rng.uniform(-1, 1, model.nu)
    if model.manifest["multipliers"]:
        for _ in range(40):
            g = model.constraints(q)
            q = model.integrate(q, -np.linalg.pinv(model.constraint_jacobian(q)[: len(g)]) @ g)
        G = model.constraint_jacobian(q)
        u = u - np.linalg.pinv(G) @ model.constraint_rates(q, u)
    return np.concatenate([q, u])


def truth(kane: Any, values: dict[Any, float], x: np.ndarray) -> np.ndarray:
    """SymPy's equations in 40 digits, by its own lambdify and mpmath."""
    import mpmath
    import sympy as sm

    known = {sm.Symbol(str(name)): value for name, value in values.items()}
    known |= dict(zip([*kane.q, *kane.u], x.tolist(), strict=True))
    known |= dict.fromkeys(inputs_of(kane), FORCE)
    plain = {symbol: sm.Dummy() for symbol in known}
    rates = kane.kindiffdict()
    matrices = kane.mass_matrix, kane.forcing, sm.Matrix([rates[q.diff()] for q in kane.q])
    told = [m.xreplace(rates).xreplace(plain) for m in matrices]
    with mpmath.workdps(DIGITS):
        function = sm.lambdify(list(plain.values()), told, modules="mpmath", cse=True)
        M, f, qdot = function(*(mpmath.mpf(value) for value in known.values()))
        udot = mpmath.lu_solve(M, f)
        return np.array([float(v) for v in (*qdot, *udot)])


def timed(call: Callable[[], Any], count: int) -> float:
    """Seconds of processor for one call."""
    began = thread_time()
    for _ in range(count):
        call()
    return (thread_time() - began) / count


def alternately(
    ours: Callable[[], Any], theirs: Callable[[], Any], rounds: int
) -> tuple[float, float]:
    """Seconds of a call of both, measured in turn: the best of the rounds."""
    gc.disable()
    pairs = [(timed(ours, 10 * CALLS), timed(theirs, CALLS)) for _ in range(rounds)]
    gc.enable()
    mine, other = map(min, zip(*pairs, strict=True))
    return mine, other


def page(rows: list[Row]) -> str:
    """The page for the documentation."""
    from importlib.metadata import version

    import sympy

    lines = [
        "# Equations of SymPy, beside PyDy",
        "",
        "Written by `python tests/benchmarks/pydy_beside.py`: PyDy's published examples, rebuilt,",
        "derived once by SymPy and then handed to `cd.from_sympy` and to PyDy's fastest generator",
        "(Cython, arrays as arguments). One run, seconds of processor, calls measured in turn.",
        "",
        f"- SymPy {sympy.__version__}, PyDy {version('pydy')}, Python {sys.version.split()[0]}",
        "- derivation: what SymPy takes before either of them begins",
        "- build: from the KanesMethod to the first right-hand side, compilers included; ours is",
        "  checked against SymPy's numbers",
        "- call: of a right-hand side from Python, linear system solved; in C: as our integrators,",
        "  ensembles and exports call it, which PyDy's cannot be; batch: per state of many",
        "- error: against SymPy's matrices in 40 digits, of the largest derivative",
        "",
        "| example | u | derivation | build | PyDy | ratio | call | PyDy | ratio | in C | ratio | "
        "batch | error | PyDy |",
        "| --- |" + " --- |" * 13,
    ]
    for row in rows:
        (ours, theirs), (mine, other), (own, their) = row.build, row.call, row.error
        lines.append(
            f"| {row.name} | {row.speeds} | {row.derivation:.1f} s | {ours:.2f} s | {theirs:.1f} s "
            f"| {theirs / ours:.0f} | {mine * 1e6:.2f} µs | {other * 1e6:.1f} µs "
            f"| {other / mine:.0f} | {row.inner * 1e9:.0f} ns | {other / row.inner:.0f} "
            f"| {row.batch * 1e9:.0f} ns | {own:.0e} | {their:.0e} |"
        )
    return "\n".join(lines) + "\n"


def main() -> None:
    """Measure all examples, print and write the page."""
    quick = "--quick" in sys.argv
    # what is loaded once in a process belongs to no example
    cd.compile(cd.from_sympy(*_first())).rhs(0.0, np.zeros(2))
    rows = []
    for name in EXAMPLES:
        rows.append(measured(name, 3 if quick else ROUNDS))
        print(page(rows[-1:]).splitlines()[-1], flush=True)
    PAGE.write_text(signed(page(rows)), encoding="utf-8")


def _first() -> tuple[Any, ...]:
    from sympy.physics.mechanics import dynamicsymbols

    q, u = dynamicsymbols("q u")
    return (([q], [u], [[1]], [-q]),)


if __name__ == "__main__":
    main()
