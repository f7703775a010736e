"""Speeds of beams that named speeds and conditions bend: the least change of the kinetic energy.

Where beams cannot go along rigidly, what is not named changes so that 1/2 du M du is least with
G du given. Without the condition the same scene starts rigidly; the change between these starts has
to be free of anything but forces of the constraints.
"""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd

RODS = cd.section.tube(0.01, 0.008), cd.material(E=7e10, nu=0.3, rho=2700)
COORDINATES = ("auto", "absolute")
# moments of inertia of light nodes beside the masses of bodies
HEAVY = (1.0, 300.0)


def tower(mass: float, tied: bool) -> cd.Scene:
    """A hub on a post turns a beam, whose tip may be tied to a plane."""
    scene = cd.Scene("tower")
    post = scene.beam("post", scene.ground, (0, 0, 0.6), *RODS, elements=2)
    hub = scene.body("hub", mass=mass, com=(0.02, 0, 0), inertia=np.full(3, 2e-3 * mass).tolist())
    scene.joint("yaw", cd.Revolute("x"), post.end, hub)
    plate = scene.body("plate", mass=0.2, com=(0, 0.1, 0), inertia=(1e-3, 1e-3, 1e-3))
    scene.joint("tilt", cd.Revolute("z"), hub.at(0.1, 0, 0), plate)
    boom = scene.beam("boom", plate.at(0, 0.2, 0), (0.1, 0.7, 0.65), *RODS, elements=2)
    if tied:
        scene.constraint("tie", boom.end.position()[0] - 0.1)
    return scene


@pytest.mark.parametrize("mass", HEAVY)
@pytest.mark.parametrize("coordinates", COORDINATES)
def test_named_speeds_bend_beams_with_the_least_energy(coordinates: str, mass: float) -> None:
    """By linear algebra on M and G of the model, in both kinds of coordinates."""
    named = {"yaw": 2.0, "tilt": 3.0}
    free = cd.compile(tower(mass, False), coordinates=coordinates)
    tied = cd.compile(tower(mass, True), coordinates=coordinates)
    q, rigid = free.split(free.initial(u=named))
    place, u = tied.split(tied.initial(u=named))
    np.testing.assert_array_equal(place, q)
    M, G = tied.mass_matrix(q), tied.constraint_jacobian(q)
    held = [tied.speeds.index(f"{name}.u") for name in named]
    assert u[held] == pytest.approx(list(named.values()), rel=1e-12)
    others = np.setdiff1d(np.arange(tied.nu), held)
    # joint coordinates between nodes have no inertia of their own
    impulses = (M @ (u - rigid))[others]
    forces = G[:, others].T
    left = impulses - forces @ np.linalg.lstsq(forces, impulses, rcond=None)[0]
    assert np.abs(left).max() < 1e-5 * np.abs(impulses).max()
    assert np.abs(tied.constraint_rates(q, u)).max() < 1e-9
    # it is the rotation of the plate that the tip misses, by 1.4 m/s
    assert 0 < (u - rigid) @ M @ (u - rigid) < 0.1


def test_both_kinds_of_coordinates_bend_them_alike() -> None:
    """Accelerations follow from the same start, so they agree as well."""
    speeds = []
    for coordinates in COORDINATES:
        model = cd.compile(tower(300.0, True), coordinates=coordinates)
        q, u = model.split(model.initial(u={"yaw": 2.0, "tilt": 3.0}))
        speeds.append(model.velocity("boom.end", q, u))
    np.testing.assert_allclose(*speeds, rtol=1e-5, atol=1e-5)
