"""The commonest calls, prepared, each with the least time that it could take."""

from __future__ import annotations

import os
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

Prepared = tuple[Callable[[], object], float]


@dataclass(frozen=True)
class Work:
    """A call that users make.

    Attributes:
        title: What it does.
        prepare: Makes the call, and the seconds of its floor.
        floor: What the floor is.
        compiled: Whether most of it is C: perf splits it, not cProfile.
        once: Whether a process can do it only once.
        parts: Where the time goes that is the floor, where it is not measured apart.
    """

    title: str
    prepare: Callable[[], Prepared]
    floor: str
    compiled: bool = True
    once: bool = False
    parts: tuple[str, ...] = ()


def least(call: Callable[[], object], seconds: float = 0.2) -> float:
    """Shortest of many rounds [s]."""
    call()
    end, best = time.perf_counter() + seconds, float("inf")
    while time.perf_counter() < end:
        begin = time.perf_counter()
        call()
        best = min(best, time.perf_counter() - begin)
    return best


def panda() -> Any:
    """Scene of the arm."""
    import cardan as cd
    from mechanisms import robots

    return cd.load(robots.folder() / "panda_description" / "urdf" / "panda.urdf")


def importing() -> Prepared:
    """Importing cardan; the floor is numpy in the same process, before."""
    begin = time.perf_counter()
    import numpy as np

    assert np.__version__
    floor = time.perf_counter() - begin

    def call() -> object:
        import cardan

        # names are loaded when they are asked for
        return cardan.load, cardan.compile, cardan.CompiledModel

    return call, floor


def loading() -> Prepared:
    """A scene file; the floor is what its parser takes."""
    from ruamel.yaml import YAML

    import cardan as cd

    file = Path(cd.examples.path("slider_crank"))
    text = file.read_text("utf-8")
    return lambda: cd.load(file), least(lambda: YAML(typ="safe").load(text))


def deriving() -> Prepared:
    """The arm's equations; the floor is making their expressions once, in one pass."""
    import cardan as cd
    from cardan.ir.serialize import from_dict, to_dict

    scene = panda()
    function = cd.derive(scene).form("forward_dynamics")
    data = to_dict(function)
    return lambda: cd.derive(scene).form("forward_dynamics"), least(lambda: from_dict(data))


def compiling() -> Prepared:
    """The arm from equations to a first result, nothing in the cache; the floor is the compiler."""
    import cardan as cd

    equations = cd.derive(panda())
    os.environ["CARDAN_CACHE"] = tempfile.mkdtemp()
    return lambda: cd.compile(equations).prepare("forward_dynamics"), float("nan")


def calling() -> Prepared:
    """The arm's accelerations at one state; the floor is the C in a loop of C."""
    model, x = compiled_arm()
    model.rhs(0.0, x)
    return lambda: model.rhs(0.0, x), 1e-9 * cost(model, "rhs").call_ns


def batches() -> Prepared:
    """The arm's accelerations at 10,000 states; the floor is the C in lanes, on one core."""
    import numpy as np

    model, x = compiled_arm()
    many = np.tile(x, (10_000, 1)) * np.linspace(0.5, 1.0, 10_000)[:, None]
    return lambda: model.rhs(0.0, many), 1e-5 * cost(model, "rhs").state_ns


def compiled_arm() -> tuple[Any, Any]:
    """The arm and a state."""
    import numpy as np

    import cardan as cd

    model = cd.compile(panda())
    return model, np.concatenate([np.linspace(0.1, 0.7, model.nq), np.zeros(model.nx - model.nq)])


def cost(model: Any, function: str) -> Any:
    """What a function of a model costs."""
    model.prepare(function)
    return next(row for row in model.report().rows if row.function == function)


def runs_of(model: Any, function: str, **options: Any) -> Prepared:
    """A simulation; the floor is the C of its evaluations."""
    motion = model.simulate(**options)
    assert motion.success, motion.message
    evaluations = motion.statistics["evaluations"]
    return lambda: model.simulate(**options), 1e-9 * evaluations * cost(model, function).call_ns


def tree() -> Prepared:
    """Ten seconds of a double pendulum."""
    import cardan as cd

    model = cd.compile(cd.load(cd.examples.path("double_pendulum")))
    return runs_of(model, "rhs", t=10.0, q={"shoulder": 1.0}, method="DOP853", rtol=1e-9)


def loop() -> Prepared:
    """Ten seconds of a four-bar."""
    import cardan as cd

    model = cd.compile(cd.load(cd.examples.path("four_bar")))
    return runs_of(model, "rhs", t=10.0, q={"A": 0.6}, method="DOP853", rtol=1e-9)


def beam() -> Prepared:
    """A second of the flexible arm; what the floor would be is not one function."""
    import cardan as cd

    model = cd.compile(cd.load(cd.examples.path("flexible_arm")))
    options = {"t": 1.0, "method": "GeneralizedAlpha", "step": 1e-3}
    assert model.simulate(**options).success
    return lambda: model.simulate(**options), float("nan")


def ensemble() -> Prepared:
    """A thousand double pendulums for ten seconds; the floor is its evaluations in batches."""
    import numpy as np

    import cardan as cd

    model = cd.compile(cd.load(cd.examples.path("double_pendulum")))
    starts = np.zeros((1000, model.nx))
    starts[:, 0] = np.linspace(0.1, 1.5, 1000)
    options = {"method": "DOP853", "rtol": 1e-6, "threads": 1}
    runs = model.ensemble(10.0, x0=starts, **options)
    evaluations = float(np.sum(runs.statistics["evaluations"]))
    return (
        lambda: model.ensemble(10.0, x0=starts, **options),
        1e-9 * evaluations * cost(model, "rhs").state_ns,
    )


WORK = {
    "import": Work(
        "`import cardan`, `load`, `compile` and models", importing, "importing NumPy", False, True
    ),
    "load": Work("loading a scene file (slider-crank)", loading, "its parser", False),
    "derive": Work(
        "deriving (Panda, forward dynamics)", deriving, "making its expressions once", False
    ),
    "compile": Work(
        "compiling (Panda, empty cache)",
        compiling,
        "the compiler of C",
        False,
        True,
        ("the compiler of C",),
    ),
    "call": Work("one call (Panda, `rhs`)", calling, "the C of one state"),
    "batch": Work("a batch of 10,000 states (Panda)", batches, "batches of 1024 of the same"),
    "tree": Work("10 s of a double pendulum, rtol 1e-9", tree, "the C of its evaluations"),
    "loop": Work("10 s of a four-bar, rtol 1e-9", loop, "the C of its evaluations"),
    "beam": Work(
        "1 s of a flexible arm, 1000 steps",
        beam,
        "all of its C",
        parts=("cardan's kernels", "generated C"),
    ),
    "ensemble": Work(
        "1000 double pendulums for 10 s, rtol 1e-6", ensemble, "its evaluations in batches of 1024"
    ),
}
