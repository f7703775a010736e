"""Scenes for runs without compiled model functions, and models as such a machine opens them."""

from __future__ import annotations

import itertools
import pickle
import signal
import warnings
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.errors import CompilerMissing
from cardan.ir import straight_line
from cardan.ir.function import Function
from cardan.runtime.build import cache
from cardan.runtime.calls import interpreted, webassembly


def without_compiler(model: cd.CompiledModel, monkeypatch: pytest.MonkeyPatch) -> cd.CompiledModel:
    """The model as it is opened where C of the kernels exists and no compiler."""
    # written and compiled while there is a compiler
    model._kernels()
    content = pickle.dumps(model)
    monkeypatch.setattr(cache, "compiled_separately", no_compiler)
    monkeypatch.setattr("cardan.runtime.calls.webassembly.available", lambda: False)
    interpreted.announce.cache_clear()
    other = pickle.loads(content)
    with pytest.warns(cd.BuildWarning, match=r"no C compiler.*cardan\[compiler\]"):
        other.prepare("rhs")
    assert other._function("rhs").interpreted
    return other


def no_compiler(*given: Any, **named: Any) -> Any:
    """What compiles models, where kernels alone were compiled before."""
    raise CompilerMissing("no C compiler")


def four_bar() -> cd.Scene:
    """A linkage whose loop is closed by constraints."""
    scene = cd.Scene("four_bar", gravity=(0, -9.81, 0))
    links = {}
    for name, length in {"crank": 0.1, "coupler": 0.25, "rocker": 0.2}.items():
        rod = cd.inertia.box(length, length, 0.02, 0.01)
        links[name] = scene.body(name, mass=length, com=(length / 2, 0, 0), inertia=rod)
    crank, coupler, rocker = links.values()
    scene.joint("A", cd.Revolute("z"), scene.ground, crank)
    scene.joint("B", cd.Revolute("z"), crank.at(0.1, 0, 0), coupler)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(0.3, 0, 0), rocker)
    scene.joint("C", cd.Revolute("z"), coupler.at(0.25, 0, 0), rocker.at(0.2, 0, 0))
    return scene


def bouncing() -> cd.Scene:
    """A slide that meets an elastic stop with friction on the way: impacts and modes."""
    scene = cd.Scene("bouncing", gravity=(0, 0, -9.81))
    body = scene.body("body", mass=1.0, com=(0, 0, 0), inertia=(1, 1, 1))
    scene.joint("rail", cd.Prismatic("z"), scene.ground, body, q0=0.5)
    scene.force("stop", cd.Stop("rail", lower=0.0, restitution=0.6))
    return scene


def beam() -> cd.Scene:
    """a bar of rubber that falls around its pin."""
    scene = cd.Scene("beam", gravity=(0, 0, -9.81))
    rubber = cd.material(E=5e6, nu=0.45, rho=1100)
    section = cd.section.rectangle(0.02, 0.02)
    ends = (0, 0, 0), (0.5, 0, 0)
    bar = scene.beam("bar", *ends, section, rubber, elements=3, inertia="lumped")
    scene.joint("pin", cd.Revolute("y"), scene.ground, bar.start)
    return scene


# Ctrl-C, in a process of its own


def simulated(model: cd.CompiledModel) -> dict[str, Any]:
    """A run that would take very long."""
    motion = model.simulate(1e4, method="RK4", step=1e-3)
    return {"status": motion.status, "rows": len(motion), "end": motion.t[-1]}


def many(model: cd.CompiledModel) -> dict[str, Any]:
    """An ensemble by four threads."""
    made = model.ensemble(20.0, q={"elbow": np.linspace(0, 1, 400)}, threads=4)
    return {"status": "interrupted" if made.interrupted else "", "rows": made.done}


def assembled(model: cd.CompiledModel) -> dict[str, Any]:
    """Searches from many starts."""
    found = model.assemble({"A": 0.5}, starts=10_000)
    gap = max(abs(part) for parts in found.gaps.values() for part in parts)
    return {"rows": found.starts, "status": "interrupted", "gap": gap}


def loaded(model: cd.CompiledModel) -> dict[str, Any]:
    """A path of many loads."""
    path = model.statics(locked={"pin": (0.0, 0.1)}, steps=10_000)
    return {"status": path.status, "rows": len(path)}


def interrupted(work: Callable[[cd.CompiledModel], Any], calls: int, place: str, to: Any) -> None:
    """Do work without a compiler, with one Ctrl-C after so many calls of model functions.

    Args:
        work, calls: What, and when.
        place: Folder of the model.
        to: Takes what the work gives, and its warnings.
    """
    usual, count = straight_line.straight_line, itertools.count(1)

    def counted(function: Function) -> Callable[..., list[float]]:
        evaluate = usual(function)

        def evaluated(*blocks: Sequence[float]) -> list[float]:
            if next(count) == calls:
                signal.raise_signal(signal.SIGINT)
            return evaluate(*blocks)

        return evaluated

    straight_line.straight_line = counted
    cache.compiled_separately = no_compiler
    webassembly.available = lambda: False
    with warnings.catch_warnings(record=True) as said:
        warnings.simplefilter("always")
        found = work(cd.load_model(place))
    to.send(found | {"calls": next(count), "said": [str(one.message) for one in said]})
