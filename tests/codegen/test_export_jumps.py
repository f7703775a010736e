"""Exported runs end their steps where the model jumps at a time."""

from __future__ import annotations

from pathlib import Path

import pytest
import sympy as sp

import cardan as cd
from codegen.running import compilers
from codegen.test_export_mesh import Builder, builder
from codegen.test_export_mesh_events import exported_run

__all__ = ["builder"]

pytestmark = pytest.mark.skipif("gcc" not in compilers(), reason="needs a C compiler")

# of a force that nothing else hints at [N, s]: steps that do not end there pass over it
PUSH, MASS, END = 40.0, 2.0, 1.0
START, STOP = 0.37, 0.372
LATER, PULL = 0.7000000000000001, 1.0  # at a time of many digits [s, N]


def pushed() -> cd.Scene:
    """A mass on a rail that is pushed shortly and pulled back from a later time on."""
    scene = cd.Scene("pushed")
    times = zip(("first", "last", "later"), (START, STOP, LATER), strict=True)
    first, last, later = (scene.parameter(name, value, unit="s") for name, value in times)
    scene.joint("rail", cd.Prismatic("x"), scene.ground, scene.body("mass", mass=MASS))
    force = sp.Piecewise((0, cd.t < first), (PUSH, cd.t < last), (0, cd.t <= later), (-PULL, True))
    scene.force("push", cd.JointForce("rail", force))
    return scene


def expected(t: float) -> tuple[float, float]:
    """Position and speed at a time after the push, from impulses."""
    speed = PUSH * (STOP - START) / MASS
    position = speed * (t - 0.5 * (START + STOP))
    pulled = max(0.0, t - LATER)
    return position - PULL * pulled**2 / (2 * MASS), speed - PULL * pulled / MASS


@pytest.mark.parametrize(
    ("coordinates", "method"),
    [("relative", "dop853"), ("absolute", "dop853"), ("absolute", "radau")],
)
def test_no_step_passes_over_a_jump(
    coordinates: str, method: str, builder: Builder, tmp_path: Path
) -> None:
    equations = cd.derive(pushed(), coordinates=coordinates)
    folder = equations.export(tmp_path / "c", language="c", integrators=(method,))
    status, rows, _ = exported_run(builder, folder, END, {"rtol": 1e-9, "atol": 1e-12})
    assert status == 0
    nq = 1 if coordinates == "relative" else 8
    for row in rows[2:]:
        assert (row[1], row[1 + nq]) == pytest.approx(expected(row[0]), abs=1e-14)


def test_backward_runs_stop_there_too(builder: Builder, tmp_path: Path) -> None:
    equations = cd.derive(pushed())
    folder = equations.export(tmp_path / "c", language="c", integrators=("dop853",))
    settings = {"start": END, "rtol": 1e-9, "atol": 1e-12}
    status, rows, _ = exported_run(builder, folder, 0.0, settings, x=expected(END))
    assert status == 0
    assert rows[-1][1:] == pytest.approx([0.0, 0.0], abs=1e-14)
