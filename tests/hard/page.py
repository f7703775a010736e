"""Measures every cell and writes docs/hard_cases.md; status 1 where one is not as expected.

usage: python tests/hard/page.py [CASE ...]

With names of cases, only their rows and sections are written anew; ``paths`` and ``gradients`` are
among them.
"""

from __future__ import annotations

import platform
import sys
from collections.abc import Iterator
from pathlib import Path

# the cases and the zoo stand in the folder above
sys.path.insert(0, str(Path(__file__).parents[1]))

from benchmarks.provenance import signed
from cardan.cli.terminal import progress
from hard import CASES
from hard.case import FINISHED, METHODS, Case, Cell, Never, Outcome, measure
from hard.gradient_page import GRADIENTS, with_gradients
from hard.path_page import PATHS, with_paths

PAGE = Path(__file__).parents[2] / "docs" / "hard_cases.md"
Found = dict[tuple[str, str], Outcome]
HEAD = """\
# Hard cases

The first part says what to do about difficult models. The second part runs every integrator on
difficult cases, rigid ones and, from [latch under load](#latch-under-load) on, flexible ones.
(`EnergyMomentum`, for absolute coordinates only, has its own tests.)

"""
# ruff: noqa: E501 (rows of tables)
ADVICE = """\
Start with `method="auto"`: it changes to a stiff method where stability limits the steps.
`cardan check FILE` finds faults of a model. `cardan report FILE` compares methods on your scene.

## Singular mass matrix

M is singular if a motion moves neither mass nor inertia. cardan recognizes this at three times:

- A massless body at the end of a chain causes a `DerivationError`, which names its joint.
- A parameter that makes M singular causes a `SolveWarning`, which names the speeds.
- If M becomes singular during a run, the run ends with the status `not_finite` or `model_failed`.

Causes are a missing mass, a point mass that turns about itself, and a position such as radius 0 of
polar coordinates. Give the body a mass or an inertia, or make its joint fixed or `prescribed=`.
Massless bodies within a chain are allowed. For a spring and a damper in series use `cd.Maxwell`,
which needs no body between them. In the example, a mass of 1e-6 kg makes M nearly singular:

```python
import numpy as np

import cardan as cd

scene = cd.Scene("arm", gravity=(0, 0, -9.81))
upper = scene.body("upper", mass=1.0, com=(0, 0, -0.5))
tip = scene.body("tip", mass=1e-6, com=(0, 0, -0.5))
scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
scene.joint("wrist", cd.Revolute("y"), upper.at(0, 0, -1.0), tip)
model = cd.compile(scene)
values, motions = np.linalg.eigh(model.mass_matrix({"wrist": 0.2}))
print(f"condition number {values[-1] / values[0]:.0e}")
print("light motion:", model.speeds[abs(motions[:, 0]).argmax()])
```

```
condition number 1e+06
light motion: wrist.u
```

A large condition number by itself does little harm, as [Mass ratio](#mass-ratio) shows for 1e8.
Fast vibrations of the light body make the motion stiff: use `Rosenbrock`.

## Slow derivation or compilation

Functions are derived and compiled when they are first called. [The cache](building.md#cache) keeps
them, so a second start is fast. `print(equations)` and `model.report()` count operations. First
runs of tree-like scenes on one machine, in seconds:

| change | scene | before | after |
|---|---|---:|---:|
| environment variable `CARDAN_OPTIMIZATION=0` | 14 bodies | 3.7 | 1.0 |
| `cd.compile(scene, loops=True)` | 14 bodies | 3.7 | 0.7 |
| `cd.compile(scene, specialize=True)`, which fixes all parameters | 14 bodies | 3.7 | 2.4 |
| `cd.compile(scene, coordinates="absolute")` | 60 bodies | 11.7 | 3.7 |
| `"DOP853"` instead of `"Rosenbrock"`, which needs a Jacobian | 14 bodies | 34 | 3.7 |
| `cd.compile(scene)` instead of `method="hamilton"` | 12 hinged rods | 5.1 | 0.8 |

The bodies are on ball joints. With `CARDAN_OPTIMIZATION=0`, runs take about four times as long.
`loops=True` is the default for trees of more than 60 bodies; closed loops do not use it.

If a compiler process reaches its limit of time or memory, raise `CARDAN_COMPILE_SECONDS` or
`CARDAN_COMPILE_MEMORY` ([building](building.md#compiler)). Large stiff models are best in absolute
coordinates with `GeneralizedAlpha`, which needs no Jacobian of `rhs`.

## Friction, stops and contact

[Forces](forces.md) describes the elements, [events](events.md) how runs find their events.

| behavior | element |
|---|---|
| sticks and slips | `cd.Friction("x", coulomb=0.6, static=1.0)` |
| slips by a smooth, stiff law | `cd.Friction("x", coulomb=0.6, smooth=1e-3)` |
| hits an end, may settle there | `cd.Stop("height", lower=0.0, restitution=0.5, settle=1e-4)` |
| presses elastically, stiff | `cd.Contact(...)`: a sphere on a plane or on another sphere |
| is caught | `cd.Lock(...)` |

Add them with `scene.force("floor", cd.Stop(...))`. `settle=` is the speed below which a joint stays
at its stop. With `settle=0`, bounces may end the run with the status `chatter`. Events that cause
each other at one time end it with `event_storm`. If rates differ widely and the fast motion does
not matter, use `Rosenbrock`, or `Radau` for many digits. `model.stiffness(x)` compares the rates.

The same elements work in scenes with [beams](flexible.md), in every method that takes beams:

| behavior | what happens with beams |
|---|---|
| a node meets a stop | the impulse goes through the masses of all elements; the finer the mesh, the less it takes |
| it stays at the stop, `restitution=0` | the multiplier tells when it leaves; give steps that resolve the vibration behind an impact, else `chatter` |
| a compliant stop | `cd.Contact(...)`: the result hardly depends on the mesh |
| dry friction, locks | rows that modes hold; a lock brings its speed to rest by an impulse |
| controllers, actuators, `cd.Maxwell` | `GeneralizedAlpha` and `HHT` keep order 2; a step whose states do not converge is shortened, at given steps it ends the run |
| a velocity that constraints block | its impulse is left out, others act as without it |

A cantilever of 8 elements at a stop takes 0.22 ms a step, 0.12 ms while it is free, and 0.12 ms with a
contact instead. Without either it takes 0.09 ms. Values of events that read reactions cost a solution
each.

## Structures that buckle and snap

Where elastic members hold a mechanism, `model.sweep(..., by="strain_energy")` follows
[positions of least strain energy](closed_loops.md#members-that-give-way-least-strain-energy). Against closed forms:

| case | what is hard | error |
|---|---|---|
| truss bay of three longerons | the load falls, pulls and rises again | load 4e-14 of it, limit points 2e-12 m |
| truss pushed through by a soft spring | the minimum ends at a fold | place of the fold 1e-10 m |
| strut of beams that is shortened | the straight minimum becomes a saddle | none that shows beside `statics` |
| four-bar of bars and a soft spring | stiffness ratio 1e12 | 7e-13 m from rigid links |
| mast between prestressed cables | one goes slack | energy 1e-10 J |

`snap=True` goes on from a fold or a saddle to the next minimum. Without it the sweep stops at a fold and says so, and
keeps saddles with a warning. A slack cable of several pieces has nodes that nothing holds: make it one element.

[The next section](#paths-of-equilibria-and-cycles) has paths through limit loads and branch points.

## When to use another approach

- Contact of arbitrary shapes: cardan has no meshes and no collision search. Use a program such as
  MuJoCo or Chrono.
- Large deflections of other parts than [beams](flexible.md): [superelements](superelements.md) of
  shells and solids deform by little.
- Chaos over long times: compare statistics of an [ensemble](ensembles.md) instead of one motion.
- Beams, and a node for every body: `Rosenbrock` takes its Jacobian by differences there: use `Radau`.
- `Newmark` takes no constraints; use `GeneralizedAlpha` or `HHT`.
- Friction with `mu=` may have no unique solution (Painlevé); the run then ends and names the joint.

## Measured cases

`make hard` runs every method on every case and writes this page. The expected statuses and error
bounds are in `tests/hard`. The tests enforce them: `make test` checks a selection, and
`CARDAN_HARD=1 make slow` the others. `make hard` takes about a quarter of an hour, most of it for
the 1e7 steps. If the code has changed since the measurements, a line at the
top says so. Statuses and bounds then still hold; measured errors, steps and times may differ.

Most bounds were set before the first run. The bounds of micrometers, astronomical units, the free
body, stick-slip, and EnergyMidpoint on 100 links were set after it. They follow from theory, or are
at least three times the measured error. For generalized-alpha over 1e7 steps it is at least twice.
The step sizes for passing gimbal lock and for the four-bar were also set after the first run, as
were those of order 2 and the statuses of superelements.

From the source folder, `python -m pytest -s tests/hard -k "satellite and HHT"` runs one cell. With
`CARDAN_HARD=1` this includes the slow ones. For your own method and tolerances write a script, run
with `PYTHONPATH=tests`:

```py
import cardan as cd
from hard import CASES

case = CASES["satellite"]
model = cd.compile(case.build(), **case.options)
motion = model.simulate(case.t, method="HHT", rtol=1e-8, atol=1e-11, **case.start)
print(motion.status, case.error(model, motion), motion.statistics["steps"])
```

**References.** Four of them are computed as follows:

- Chaos: textbook equations in absolute angles, Gragg-Bulirsch-Stoer extrapolation with 40 digits.
  Two step sizes agree within 4e-12 up to 15 s, and within 3e-9 at 20 s.
- Fast top: the same method with 30 digits; its energy stays within 2e-24.
- 100 links: cardan's DOP853 at rtol 1e-12 and RK45 at rtol 1e-11 agree within 4e-12 in all angles.
- Near-singular four-bar: the quadrature asks for 1e-12, piecewise around the folds. DOP853 at rtol
  1e-13 and Radau at 1e-12 reach it within 4e-12 rad.

**Columns.** Errors are the largest of all entries at all compared times, 6 to 101 over the run. The
four-bar, the free body and chatter are compared at the end only. Steps are accepted steps, without
rejected ones. The time is that of the run alone, without derivation, compilation and evaluation.

**Warnings.** Runs with the status `finished` gave no `SolveWarning`, not even those with errors of
0.01 and more. (The runs of 1e7 steps were not examined.) A run
[accounts](integrators.md#what-a-run-accounts-for) for energy, momentum and closure only. To see
other errors, repeat it with a tenth of `rtol`.

"""
MACHINE = """\
Errors and times come from one run on one core of a present server ({machine}); compare times
within this page only. Methods of order 4 and higher run at tight tolerances, methods of order 2
at coarse ones. The cases show how reliable the methods
are, not which is fastest.

In the table: ✓ as expected, ✗ not as expected, – not applicable, with the reason given below."""


def expectation(cell: Cell | Never) -> str:
    """What a cell expects, as the page says it."""
    if isinstance(cell, Never):
        return f"not applicable: {cell.reason}"
    status = "" if cell.status == FINISHED else f"{cell.status}, "
    return f"{status}≤ {cell.bound:.0e}" if cell.bound else cell.status


def settings(case: Case, method: str) -> str:
    """Tolerances or step in words."""
    return ", ".join(f"{name} {value:.2g}" for name, value in case.how(method).items())


def mark(case: Case, method: str, found: Found) -> str:
    """One sign for a cell."""
    cell = case.expected[method]
    if isinstance(cell, Never):
        return "–"
    return "✓" if found[case.name, method].meets(cell) else "✗"


def overview(found: Found) -> Iterator[str]:
    """Case by method."""
    yield f"| case | {' | '.join(METHODS)} |"
    yield f"|---|{':---:|' * len(METHODS)}"
    for case in CASES.values():
        marks = " | ".join(mark(case, method, found) for method in METHODS)
        yield f"| [{case.title}](#{anchor(case)}) | {marks} |"


def anchor(case: Case) -> str:
    """Where the section of a case stands in the page."""
    kept = "".join(c for c in case.title.lower() if c.isalnum() or c in " -")
    return kept.replace(" ", "-")


def section(case: Case, found: Found) -> Iterator[str]:
    """The table of a case."""
    yield f"\n## {case.title}\n"
    yield f"{case.hard[0].upper()}{case.hard[1:]}.\n"
    yield f"Measured by: {case.oracle}.\n"
    yield f"Recommended: {case.advice}.\n"
    yield "| method | settings | expected | found | steps | ms |"
    yield "|---|---|---|---|---:|---:|"
    for method, cell in case.expected.items():
        if isinstance(cell, Never):
            yield f"| {method} | | {expectation(cell)} | | | |"
            continue
        one = found[case.name, method]
        status = "" if one.status == FINISHED else f"{one.status}, "
        missed = "" if one.meets(cell) else " ✗"
        yield (
            f"| {method} | {settings(case, method)} | {expectation(cell)} "
            f"| {status}{one.error:.1e}{missed} | {one.steps} | {one.milliseconds:.2g} |"
        )
    said = {
        found[case.name, method].message
        for method, cell in case.expected.items()
        if isinstance(cell, Cell) and found[case.name, method].status != FINISHED
    }
    if said:
        yield f"\nMessage of a run: {min(said, key=lambda words: (len(words), words))}."


def overwritten(page: str, names: list[str], found: Found) -> str:
    """The page with rows and sections of some cases anew, those of the others as they are."""
    for case in (CASES[name] for name in names):
        marks = " | ".join(mark(case, method, found) for method in METHODS)
        row = f"| [{case.title}](#{anchor(case)}) |"
        lines = [line for line in page.splitlines() if not line.startswith(row)]
        last = max(k for k, line in enumerate(lines) if line.startswith("| ["))
        page = "\n".join([*lines[: last + 1], f"{row} {marks} |", *lines[last + 1 :]])
        before, *rest = page.split(f"\n## {case.title}\n")
        after = "\n## ".join(["", *rest[0].split("\n## ")[1:]]) if rest else ""
        page = before.rstrip() + "\n" + "\n".join(section(case, found)) + after
    return page.rstrip() + "\n"


def main(names: list[str]) -> int:
    """Measure some cases, or all; write."""
    sections = {PATHS: with_paths, GRADIENTS: with_gradients}
    if len(names) == 1 and names[0] in sections:
        PAGE.write_text(sections[names[0]](PAGE.read_text("utf-8")), "utf-8")
        return 0
    found: Found = {}
    cases = [CASES[name] for name in names] or list(CASES.values())
    with progress() as show:
        for k, case in enumerate(cases):
            for method, cell in case.expected.items():
                show(f"{case.name}, {method}", k / len(cases))
                if isinstance(cell, Cell):
                    found[case.name, method] = measure(case, method)
    machine = f"{platform.machine()}, {platform.system()}"
    if names:
        PAGE.write_text(overwritten(PAGE.read_text("utf-8"), names, found), "utf-8")
    else:
        lines = [HEAD + ADVICE + MACHINE.format(machine=machine), "", *overview(found)]
        for case in cases:
            lines += section(case, found)
        PAGE.write_text(signed(with_paths(with_gradients("\n".join(lines)))), "utf-8")
    wrong = 0
    for (name, method), one in found.items():
        cell = CASES[name].expected[method]
        if isinstance(cell, Cell) and not one.meets(cell):
            wrong += 1
            print(f"{name}, {method}: {one.status}, {one.error:.1e}; {expectation(cell)}")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
