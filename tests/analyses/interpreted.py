"""Scenes for runs without compiled model functions, and models as such a machine opens them."""

from __future__ import annotations

import pickle
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import pytest

import cardan as cd
from cardan.errors import CompilerMissing
from cardan.runtime import cache, interpreted, prebuilt

KERNELS = prebuilt.DIRECTORY


def without_compiler(model: cd.CompiledModel, monkeypatch: pytest.MonkeyPatch) -> cd.CompiledModel:
    """The model as it is opened where C of the kernels exists and no compiler."""
    # written and compiled while there is a compiler
    model._kernels()
    content = pickle.dumps(model)
    usual = cache.compiled

    def compiled(sources: Sequence[Path], *arguments: Any, **named: Any) -> cache.Object:
        if any(path.parent != KERNELS for path in sources):
            raise CompilerMissing("no C compiler")
        return usual(sources, *arguments, **named)

    monkeypatch.setattr(cache, "compiled", compiled)
    interpreted.announce.cache_clear()
    other = pickle.loads(content)
    with pytest.warns(cd.BuildWarning, match=r"no C compiler.*cardan\[compiler\]"):
        other.prepare("rhs")
    assert other._function("rhs").interpreted
    return other


def four_bar() -> cd.Model:
    """A linkage whose loop is closed by constraints."""
    scene = cd.Model("four_bar", gravity=(0, -9.81, 0))
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


def bouncing() -> cd.Model:
    """A slide that meets an elastic stop with friction on the way: impacts and modes."""
    scene = cd.Model("bouncing", gravity=(0, 0, -9.81))
    body = scene.body("body", mass=1.0, com=(0, 0, 0), inertia=(1, 1, 1))
    scene.joint("rail", cd.Prismatic("z"), scene.ground, body, q0=0.5)
    scene.force("stop", cd.Stop("rail", lower=0.0, restitution=0.6))
    return scene


def beam() -> cd.Model:
    """a bar of rubber that falls around its pin."""
    scene = cd.Model("beam", gravity=(0, 0, -9.81))
    rubber = cd.material(E=5e6, nu=0.45, rho=1100)
    section = cd.section.rectangle(0.02, 0.02)
    ends = (0, 0, 0), (0.5, 0, 0)
    bar = scene.beam("bar", *ends, section, rubber, elements=3, inertia="lumped")
    scene.joint("pin", cd.Revolute("y"), scene.ground, bar.start)
    return scene
