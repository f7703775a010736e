"""An antenna that unfolds: one record in several places, gears, a spring and a latch.

Numbers are our own. Ribs are straight beams with a section of 2 cm by 4 cm.
"""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

import cardan as cd

RIBS, STOWED = 4, -1.0


def add_beam(scene: cd.Scene, name: str, root: Any) -> Any:
    section = cd.section.rectangle(0.02, 0.04)
    carbon = cd.material(E=70e9, nu=0.3, rho=1600, damping=1e-3)
    return scene.beam(name, root, (2.0, 0, 0), section, carbon, elements=4, base=root)


@cache
def rib() -> Any:
    scene = cd.Scene("rib", gravity=(0, 0, 0))
    add_beam(scene, "rib", scene.ground)
    return cd.superelement.from_beams(scene, "rib", modes=18)  # all of them


def antenna(beams: tuple[int, ...] = ()) -> Any:
    """The model; ribs whose numbers are given are compiled beams, the others superelements."""
    scene = cd.Scene("antenna", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=30.0, inertia=(4.0, 4.0, 6.0))
    scene.joint("drift", cd.Free(), scene.ground, hub)
    for k in range(RIBS):
        turn = 2 * np.pi * k / RIBS
        place = hub.at(0.3 * np.cos(turn), 0.3 * np.sin(turn), 0, rotation=("ZYX", turn, 0, 0))
        fitting = scene.body(f"fitting{k}", mass=0.5, inertia=(1e-2, 1e-2, 1e-2))
        gear = ("hinge0", 1) if k else None
        scene.joint(f"hinge{k}", cd.Revolute("y"), place, fitting, couple=gear)
        if k in beams:
            tip = add_beam(scene, f"rib{k}", fitting).end
        else:
            one = scene.superelement(f"rib{k}", rib(), {"start": fitting}, frame="start")
            tip = one.at("end")
        # in axes of the hinge, in which ribs move alike
        for axis, value in zip("xyz", tip.position(wrt=fitting, in_=fitting), strict=True):
            scene.output(f"tip{k}.{axis}", value, unit="m")
    scene.force("spring", cd.JointSpring("hinge0", stiffness=20.0, rest=0.0))
    scene.force("latch", cd.Lock("hinge0", when=-scene.q("hinge0")))
    return cd.compile(scene)


def tips(motion: Any) -> Any:
    """Positions (ribs, 3, nt)."""
    return np.array([[motion[f"tip{k}.{axis}"] for axis in "xyz"] for k in range(RIBS)])


def test_unfolding_keeps_momentum_energy_and_symmetry() -> None:
    """From a spin, and beyond the latch, whose impulses are inside the system."""
    model = antenna()
    start = {"q": {"hinge0": STOWED}, "u": {"drift": [0, 0, 1.0, 0.1, 0, 0]}}
    motion = model.simulate(1.3, method="Radau", rtol=1e-7, **start)
    (latch,) = motion.events
    momentum = model.momentum(motion.q, motion.u)
    angular, linear = np.abs(momentum - momentum[0]).max(axis=0).reshape(2, 3).max(axis=1)
    balance, places = motion.balance, tips(motion)
    unequal = np.abs(places - places[0]).max()
    print(f"latched at {latch.t:.3f} s; momentum off by {angular:.1e} N m s, {linear:.1e} N s")
    print(f"energy off by {abs(balance.residual):.1e} of {balance.before:.1f} J")
    print(
        f"ribs bend by {np.ptp(places[0, 1:], axis=1).max():.1e} m, and differ by {unequal:.1e} m"
    )
    assert 1.0 < latch.t < 1.1
    assert max(angular, linear) < 1e-6
    assert abs(balance.residual) < 1e-6 * balance.before
    assert unequal < 1e-12


def test_a_rib_of_compiled_beams_moves_like_the_others() -> None:
    """Differences are of second order in the deflection, as those of linear theory are."""
    alike, mixed = antenna(), antenna((2,))
    errors = []
    for angle in (-0.2, -0.1):
        runs = [
            model.simulate(
                np.linspace(0, 0.2, 21), q={"hinge0": angle}, method="GeneralizedAlpha", step=1e-3
            )
            for model in (alike, mixed)
        ]
        bent = [tips(run) - [[[2.0], [0.0], [0.0]]] for run in runs]
        size = np.abs(bent[0]).max()
        errors.append(np.abs(bent[1] - bent[0]).max() / size)
        print(f"{angle} rad: ribs bend by {size:.1e} m, off by {errors[-1]:.1e}")
    assert errors[0] < 1e-4
    assert abs(errors[0] / errors[1] - 2) < 0.1
