"""Every robot of example-robot-data against Pinocchio: masses, inertias and placements."""

from __future__ import annotations

import warnings
from pathlib import Path

import numpy as np
import pytest

from cardan.api.scene_file import load
from cardan.errors import ModelError
from cardan.topology import build
from table import each
from topology.numbers_of import body_mass, body_poses, values

pin = pytest.importorskip("pinocchio")


def robots():
    """Every URDF file of the package, found beside Pinocchio."""
    share = Path(pin.__file__).parents[4] / "share" / "example-robot-data" / "robots"
    return sorted(share.rglob("*.urdf"))


FILES = robots()


def reference(path):
    """Pinocchio's model, None where it cannot read the file."""
    try:
        return pin.buildModelFromUrdf(str(path))
    except (ValueError, RuntimeError):
        return None


def ours(path, **options):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return build(load(path, snap=False, **options))


def test_the_robots_are_there():
    assert len(FILES) == 69


@each("path", FILES)
def test_robot_as_pinocchio_reads_it(path):
    other = reference(path)
    if other is None:
        with pytest.raises(ModelError):
            load(path)
        return
    system = ours(path, mimic="free")
    assert {j.name for j in system.joints} == set(other.names[1:])
    assert system.nu == other.nv

    # a random configuration within a turn
    rng = np.random.default_rng(len(path.stem))
    theirs, q = pin.neutral(other), np.zeros(system.nq)
    for joint in system.joints:
        entry = other.joints[other.getJointId(joint.name)]
        if len(joint.element.coordinates) != 1:
            defaults = [c.default for c in joint.element.coordinates]
            q[joint.q : joint.q + len(defaults)] = defaults
            continue
        q[joint.q] = rng.uniform(-3, 3)
        if entry.nq == 1:
            theirs[entry.idx_q] = q[joint.q]
        elif entry.nq == 2:
            theirs[entry.idx_q : entry.idx_q + 2] = np.cos(q[joint.q]), np.sin(q[joint.q])
    data = other.createData()
    pin.forwardKinematics(other, data, theirs)
    poses = body_poses(system, q)
    for k, joint in enumerate(system.joints):
        i = other.getJointId(joint.name)
        # twenty roundings along the longest arm of about 2 m; axes printed with 1e-6 or so are
        # normalized in a different order of operations
        np.testing.assert_allclose(poses[k], data.oMi[i].homogeneous, rtol=0, atol=1e-13)

    # mass, first moment and inertia of everything that moves with the joint
    for k, joint in enumerate(system.joints):
        spatial = other.inertias[other.getJointId(joint.name)]
        mass, first, inertia = body_mass(system, k)
        c, m = spatial.lever, spatial.mass
        about_origin = spatial.inertia + m * (c @ c * np.eye(3) - np.outer(c, c))
        scale = max(np.abs(about_origin).max(), 1e-12)
        assert mass == pytest.approx(m, rel=1e-14, abs=1e-300)
        np.testing.assert_allclose(first, m * c, rtol=0, atol=1e-14 * max(m, 1e-12) * 2)
        np.testing.assert_allclose(inertia, about_origin, rtol=0, atol=2e-14 * scale)
    ground = sum(values(system, [part.mass])[0] for part in system.ground_parts)
    assert ground == pytest.approx(other.inertias[0].mass, rel=1e-14)


def test_snapping_moves_bodies_by_the_rounding_of_the_files_only():
    snapped_files = 0
    for path in FILES:
        if reference(path) is None:
            continue
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            exact = build(load(path, mimic="free"))
        a, b = body_poses(exact), body_poses(ours(path, mimic="free"))
        moved = max(np.abs(a[k] - b[k]).max() for k in a)
        snapped_files += bool(exact.snaps)
        # a snap turns by less than half of 1e-2 (the fewest decimals that snap); arms reach 2 m
        assert moved < 2 * 5e-3, path.stem
        if not exact.snaps:
            assert moved == 0, path.stem
    assert snapped_files > 20
