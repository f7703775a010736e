"""The regressor of joint torques against Pinocchio's, column by column."""

from __future__ import annotations

import numpy as np
import pinocchio as pin
import pytest

import cardan as cd
from external.robots import ROBOTS, Peer, Slot

# our mass, moments, xx yy zz xy xz yz in the order of Pinocchio: ... xx xy yy xz yz zz
ORDER = [0, 1, 2, 3, 4, 7, 5, 8, 9, 6]
CASES = (
    ("panda_description/urdf/panda.urdf", "fixed"),
    ("ur_description/urdf/ur5_robot.urdf", "fixed"),
    ("solo_description/robots/solo12.urdf", "free"),
)


@pytest.mark.parametrize(("name", "base"), CASES, ids=[name.split("_")[0] for name, _ in CASES])
def test_regressor_is_that_of_pinocchio(name: str, base: str) -> None:
    scene = cd.load(ROBOTS / name, base=base, mimic="free", snap=False)
    equations = cd.derive(scene)
    slots = tuple(Slot(j.name, j.q, j.u, j.element.kind == "free") for j in equations.system.joints)
    peer = Peer.read(name, base == "free", False, slots)
    model = cd.compile(equations)
    x = model.random_state(5, (4,))
    q, u = model.split(x)
    udot = np.random.default_rng(6).uniform(-1, 1, u.shape)
    ours = model.regressor(q, u, udot)
    bodies = len(equations.system.bodies)
    names = list(model.inertial_parameters())
    for k in range(len(q)):
        way = peer.speeds(q[k])
        rate = way @ udot[k] + peer.speeds_rate(q[k], u[k])
        theirs = pin.computeJointTorqueRegressor(
            peer.model, peer.data, peer.q(q[k]), way @ u[k], rate
        )
        theirs = way.T @ np.array(theirs)
        compared = 0
        for i, slot in enumerate(slots):
            j = peer.model.getJointId("root_joint" if slot.free else slot.name)
            block = theirs[:, 10 * (j - 1) : 10 * j]
            own = ours[k][:, 10 * i : 10 * i + 10][:, ORDER]
            # both sum a dozen products of numbers of size 10
            assert np.abs(own - block).max() <= 1e-12 * max(1.0, np.abs(block).max())
            compared += 1
        assert compared == bodies == peer.model.njoints - 1
    assert names[0].endswith(".mass")
    assert len(names) == ours.shape[-1]
