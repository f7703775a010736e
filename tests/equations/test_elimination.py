"""Only what a scene needs is derived: what is always zero or equal costs no operation."""

from __future__ import annotations

import pytest

import cardan as cd
from mechanisms.chain import chain


def total(scene: cd.Scene, function: str, **options: object) -> int:
    return cd.derive(scene, **options).operations_of(function).total


def top(*inertia: str, gravity: tuple = (0, 0, -9.81), com: tuple = (0, 0, 0.3)) -> cd.Scene:
    scene = cd.Scene("top", gravity=gravity)
    symbols = {name: scene.parameter(name, 0.2) for name in sorted(set(inertia))}
    moments = tuple(symbols[name] for name in inertia)
    body = scene.body("top", mass=1.0, com=com, inertia=moments)
    scene.joint("tip", cd.Spherical(), scene.ground, body)
    return scene


@pytest.mark.parametrize(
    ("function", "most"), [("bias", 25), ("mass_matrix", 0), ("inverse_dynamics", 31)]
)
def test_motion_in_a_plane(function: str, most: int) -> None:
    # per link: nothing turns or moves out of the plane
    extra = total(chain(9, "y"), function, method="newton_euler") - total(
        chain(8, "y"), function, method="newton_euler"
    )
    spatial = total(chain(9), function, method="newton_euler") - total(
        chain(8), function, method="newton_euler"
    )
    assert 2 * extra < spatial
    if function != "mass_matrix":
        assert extra <= most


def test_out_of_the_plane_nothing_is_read() -> None:
    equations = cd.derive(chain(4, "y"))
    base = equations.base_parameters()
    assert {f"rod{i}.inertia.zz" for i in range(4)} & set(equations.parameters) <= set(
        base.without_effect
    )


def test_bodies_of_revolution() -> None:
    general = total(top("A", "B", "C"), "bias")
    symmetric = total(top("A", "A", "C"), "bias")
    assert symmetric < general
    # a ball that turns about its center has no bias at all
    assert total(top("A", "A", "A", com=(0, 0, 0)), "bias") == 0


def test_without_gravity() -> None:
    weightless = top("A", "B", "C", gravity=(0, 0, 0))
    assert total(weightless, "gravity") == 0
    assert total(weightless, "bias") < total(top("A", "B", "C"), "bias")


def test_only_what_is_asked_for_is_written() -> None:
    model = cd.compile(top("A", "B", "C"), functions=["bias"])
    model.bias([1, 0, 0, 0], [1, 2, 3])
    assert set(model.manifest["functions"]) == {"bias"}
