"""A motion as users read it: by name, between the steps, along frames and joints."""

from __future__ import annotations

import builtins
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from scipy.io import netcdf_file

import cardan as cd
from cardan import load_motion as load
from cardan.errors import SolveWarning


def build() -> cd.CompiledModel:
    """Pendulum with damping, on it a ball joint."""
    scene = cd.Scene("swing", gravity=(0, 0, -9.81))
    rod = scene.body("rod", mass=1.0, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    bob = scene.body("bob", mass=0.5, com=(0, 0, -0.2), inertia=(0.02, 0.02, 0.01))
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    scene.joint("socket", cd.Spherical(), rod.at(0, 0, -1.0), bob)
    scene.force("bearing", cd.JointDamper("pivot", 0.3))
    scene.output("height", bob.position()[2])
    return cd.compile(scene)


START: dict[str, Any] = {"q": {"pivot": 1.0}, "u": {"socket": [0.1, 0.2, 3.0]}, "rtol": 1e-9}


@pytest.fixture
def motion() -> cd.Trajectory:
    return build().simulate(2.0, **START)


def test_histories_by_name(motion: cd.Trajectory) -> None:
    np.testing.assert_array_equal(motion["pivot"], motion.q[:, 0])
    np.testing.assert_array_equal(motion["socket"], motion.q[:, 1:])
    np.testing.assert_array_equal(motion["socket.qw"], motion.q[:, 1])
    np.testing.assert_array_equal(motion["pivot.u"], motion.u[:, 0])
    np.testing.assert_array_equal(motion["socket.u"], motion.u[:, 1:])
    np.testing.assert_array_equal(motion["socket.u.z"], motion.u[:, 3])
    np.testing.assert_allclose(motion["height"], motion.pose("bob")[:, 2, 3], atol=1e-15)
    with pytest.raises(cd.ModelError, match="Did you mean 'pivot'"):
        motion["pivt"]


def test_poses_and_reactions_along_the_motion(motion: cd.Trajectory) -> None:
    assert motion.model is not None
    rotation = motion.pose("rod")[:, :3, :3]
    np.testing.assert_allclose(rotation[:, 0, 0], np.cos(motion["pivot"]), atol=1e-15)
    reaction = motion.reaction("pivot")
    assert reaction.shape == (len(motion), 6)
    # about the hinge only the bearing acts: minus damping times speed
    np.testing.assert_allclose(
        motion.model.reaction("socket", motion.q, motion.u)[0], motion.reaction("socket")[0]
    )


def test_between_the_steps(motion: cd.Trajectory) -> None:
    assert motion.at(1.0).shape == (6 + 3,)
    times = np.linspace(0, 2, 41)
    fine = build().simulate(times, **{**START, "rtol": 1e-13, "atol": 1e-14})
    # the dense output is as good as the steps: rtol times the growth of errors over 2 s
    np.testing.assert_allclose(motion.at(times), fine.x, rtol=0, atol=1e-6)
    again = motion.resample(times)
    np.testing.assert_array_equal(again.x, motion.at(times))
    assert np.abs(again.energy_residual).max() < 1e-6
    with pytest.raises(cd.ModelError, match=r"covers 0 \.\.\. 2 s"):
        motion.at(2.1)
    with pytest.raises(cd.ModelError, match="kept nothing between"):
        fine.at(0.51)


def test_damping_takes_energy(motion: cd.Trajectory) -> None:
    (name,) = motion.work
    assert motion.work[name][-1] < 0
    assert (np.diff(motion.work[name]) <= 0).all()
    scale = motion.energy.kinetic.max()
    assert np.abs(motion.energy_residual).max() < 1e-7 * scale


def test_saved_runs_come_back_whole(motion: cd.Trajectory, tmp_path: Path) -> None:
    path = motion.save(tmp_path / "run.nc")
    back = load(path)
    for name in ("t", "x", "r", "work_done"):
        np.testing.assert_array_equal(getattr(back, name), getattr(motion, name))
    assert repr(back) == repr(motion)
    np.testing.assert_array_equal(back.at(0.77), motion.at(0.77))
    np.testing.assert_array_equal(back.energy_residual, motion.energy_residual)
    np.testing.assert_array_equal(back.pose("bob"), motion.pose("bob"))
    # frames of a body follow from its pose
    for frame in motion.manifest["frames"]:
        here, there = back.pose(frame["name"]), motion.pose(frame["name"])
        np.testing.assert_allclose(here, there, rtol=0, atol=1e-14)
    with pytest.raises(cd.ModelError, match=r"needs the model.*cd\.load_motion\(path, model\)"):
        back.reaction("pivot")
    whole = load(path, model=build())
    np.testing.assert_array_equal(whole.reaction("pivot"), motion.reaction("pivot"))
    # a run read back can be saved again
    np.testing.assert_array_equal(load(back.save(tmp_path / "copy.nc")).x, motion.x)
    assert sorted(p.name for p in tmp_path.glob("*.nc")) == ["copy.nc", "run.nc"]
    assert not list(tmp_path.glob(".cardan-*"))


def test_files_explain_themselves(motion: cd.Trajectory, tmp_path: Path) -> None:
    with netcdf_file(motion.save(tmp_path / "run.nc"), "r", mmap=False) as file:
        assert file.variables["q"].shape == motion.q.shape
        assert b'"socket.qw"' in file.variables["q"].names
        assert file.variables["time"].units == b"s"


def test_files_that_are_no_runs(motion: cd.Trajectory, tmp_path: Path) -> None:
    with pytest.raises(cd.ModelError, match="no such file"):
        load(tmp_path / "none.nc")
    (tmp_path / "text.nc").write_text("hello")
    with pytest.raises(cd.ModelError, match="not a run"):
        load(tmp_path / "text.nc")
    whole = motion.save(tmp_path / "run.nc").read_bytes()
    (tmp_path / "half.nc").write_bytes(whole[: len(whole) // 2])
    with pytest.raises(cd.ModelError, match="not a run"):
        load(tmp_path / "half.nc")
    with pytest.raises(cd.ModelError, match="does not exist"):
        motion.save(tmp_path / "missing" / "run.nc")
    scene = cd.Scene("other")
    body = scene.body("b", mass=1, com=(0, 0, -1), inertia=(1, 1, 1))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, body)
    with pytest.raises(cd.ModelError, match="another model"):
        load(tmp_path / "run.nc", model=cd.compile(scene))


def test_a_failed_save_leaves_the_old_file(
    motion: cd.Trajectory, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = motion.save(tmp_path / "run.nc")
    before = path.read_bytes()
    monkeypatch.setattr("cardan.runtime.formats.netcdf._write", lambda *_: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        motion.save(path)
    assert path.read_bytes() == before
    assert not list(tmp_path.glob(".cardan-*"))


def test_missing_extras_are_named(motion: cd.Trajectory, monkeypatch: pytest.MonkeyPatch) -> None:
    usual = builtins.__import__

    def without(name: str, *rest: Any) -> Any:
        if name.partition(".")[0] in ("xarray", "matplotlib"):
            raise ModuleNotFoundError(name)
        return usual(name, *rest)

    monkeypatch.setattr(builtins, "__import__", without)
    with pytest.raises(ModuleNotFoundError, match=r"cardan\[data\]"):
        motion.to_xarray()
    with pytest.raises(ModuleNotFoundError, match=r"cardan\[plot\]"):
        motion.plot()


def test_xarray_has_names_and_units(motion: cd.Trajectory) -> None:
    pytest.importorskip("xarray")
    data = motion.to_xarray()
    np.testing.assert_array_equal(data["q"].sel(coordinate="pivot"), motion["pivot"])
    np.testing.assert_array_equal(data["kinetic"], motion.energy.kinetic)


def test_a_run_without_accelerations_is_saved(tmp_path: Path) -> None:
    scene = cd.Scene("blade", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=1.0, inertia=(1.0, 1.0, 1.0))
    scene.joint("drive", cd.Revolute("z"), scene.ground, hub, prescribed=6 * cd.t)
    # without rhoI its nodes turn without inertia
    section = cd.section.general(EA=1e3, GA=1e3, GJ=1.0, EI=1.0, rhoA=1.0)
    scene.beam("blade", hub, (1, 0, 0), section, elements=2)
    model = cd.compile(scene)
    with pytest.warns(SolveWarning, match="M is singular"):
        motion = model.simulate(0.1)
    with pytest.warns(
        SolveWarning, match="outputs has no value at 1 of 1 times, the first t = 0 s"
    ):
        path = motion.save(tmp_path / "blade.nc")
    back = cd.load_motion(path)
    assert np.isnan(back["drive.driving_force"]).all()
    np.testing.assert_array_equal(back.x, motion.x)
