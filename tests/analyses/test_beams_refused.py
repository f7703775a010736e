"""Structures of beams that have no rest: what is told, and what is kept."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd

SECTION = cd.section.general(EA=1e6, GA=1e6, GJ=100, EI=100, rhoA=1)


def test_a_beam_that_nothing_holds_is_named() -> None:
    scene = cd.Scene("free", gravity=(0, 0, -9.81))
    scene.beam("rod", (0, 0, 0), (1, 0, 0), SECTION, elements=2)
    with pytest.warns(cd.SolveWarning, match=r"nothing holds 'rod\.start'.*rigid-body mode"):
        found = cd.compile(scene).equilibrium()
    assert not found.converged


def arch() -> cd.CompiledModel:
    """A shallow arch, clamped at both ends, with a load P in the middle: it snaps through."""
    scene = cd.Scene("arch", gravity=(0, 0, 0))
    load, far = scene.parameter("P", 0.0), scene.ground.at(1, 0, 0)
    line = cd.arc(through=(0.5, 0, 0.1))
    beam = scene.beam("arch", scene.ground, far, SECTION, line=line, elements=4)
    scene.force("load", cd.Force(beam.at(0.5), (0, 0, -load)))
    return cd.compile(scene)


def test_behind_a_limit_load_the_path_is_kept() -> None:
    model = arch()
    with pytest.warns(cd.SolveWarning, match=r"beyond P = .*at the limit point P = 1639\.5"):
        path = model.statics(P=(0, 1e5), steps=5)
    assert not path.success
    # before it snaps it buckles to one side; both as a path of short steps has them
    buckling, limit = path.critical()
    assert buckling["P"] == pytest.approx(1376.56, rel=1e-5)
    fold = model.continuation(P=(0, 2000)).point("fold 1")
    assert limit["P"] == pytest.approx(fold["P"], rel=1e-9)
    assert path["P"][-1] == pytest.approx(limit["P"], rel=1e-3)
    last = path[-1]
    assert last.converged
    assert 0 < path["P"][-1] < 1e5
    # the last position is one of rest: a search that begins there ends there
    again = model.equilibrium(q=last.q, parameters={"P": float(path["P"][-1])})
    np.testing.assert_allclose(again.q, last.q, atol=1e-6)
    assert again.iterations <= 3
    with pytest.raises(cd.SolveError, match="gives way"):
        model.statics(P=(0, 1e5), steps=5, check=True)
