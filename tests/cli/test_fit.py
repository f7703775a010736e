"""``cardan fit``: from a table of samples to parameters with their errors."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.analyses.fits import shooting
from cardan.cli import main

TRUE = {"length": 1.1, "damping": 0.06}


def status(*words: str) -> int:
    try:
        return main(("fit", *words))
    except SystemExit as stop:
        return int(stop.code or 0)


@pytest.fixture(autouse=True)
def swing(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A scene, and a table of what somebody measured of it with other parameters."""
    monkeypatch.chdir(tmp_path)
    scene = cd.Scene("pendulum", gravity=(0, 0, -9.81))
    length = scene.parameter("length", 0.8, unit="m")
    damping = scene.parameter("damping", 0.1, unit="N*m*s/rad")
    bar = scene.body(
        "bar", mass=1.0, com=(0, 0, -length / 2), inertia=cd.inertia.rod(1.0, length, axis="z")
    )
    scene.joint("hinge", cd.Revolute("y"), scene.ground, bar)
    scene.force("bearing", cd.JointDamper("hinge", damping))
    scene.force("motor", cd.JointForce("hinge", scene.input("tau", unit="N*m")))
    scene.output("tip", bar.at(0, 0, -length).position()[0])
    scene.save("pendulum.yaml")
    t = np.linspace(0, 4, 81)
    tau = np.sin(2 * t)
    truth = cd.compile(scene).simulate(
        t, q={"hinge": 1.2}, inputs={"tau": (t, tau)}, parameters=TRUE, rtol=1e-10
    )
    rng = np.random.default_rng(1)
    columns = {"t [s]": t, "x [m]": truth["tip"], "hinge [rad]": truth["hinge"]}
    for name in ("x [m]", "hinge [rad]"):
        columns[name] = columns[name] + 0.002 * rng.standard_normal(81)
    columns["x [m]"][7] = np.nan
    columns["tau [N*m]"] = columns["torque"] = tau
    table = np.column_stack(list(columns.values()))
    np.savetxt("run.csv", table, delimiter=",", header=",".join(columns), comments="")


WORDS = ("pendulum.yaml", "run.csv", "--unknown", "length,damping", "--unknown", "q0")


def test_estimates_with_intervals(capsys: pytest.CaptureFixture[str]) -> None:
    assert status(*WORDS, "--measured", "tip=x", "--noise", "0.002", "--json") == 0
    found = json.loads(capsys.readouterr().out)
    assert found["converged"]
    assert list(found["estimates"]) == ["q0.hinge", "length", "damping"]
    for name, value in (TRUE | {"q0.hinge": 1.2}).items():
        one = found["estimates"][name]
        low, high = one["interval"]
        # of 77 degrees of freedom
        assert high - low == pytest.approx(2 * 1.9913 * one["standard_error"], rel=1e-4)
        assert abs(one["value"] - value) < 4 * one["standard_error"] < 0.05 * abs(value)
    assert found["freedom"] == 77
    assert found["sigma"] == pytest.approx(1.0, abs=0.25)
    assert found["serially_correlated"] == []
    assert np.diag(found["correlation"]) == pytest.approx([1, 1, 1])
    assert found["start"]["hinge"] == found["estimates"]["q0.hinge"]["value"]


def test_texts_pictures_and_motions(capsys: pytest.CaptureFixture[str]) -> None:
    pytest.importorskip("matplotlib")
    words = ("--measured", "tip=x [m]", "--plot", "out/fit.png", "-o", "fit.npz")
    assert status(*WORDS, *words, "--robust", "--bounds", "damping=0,") == 0
    said = capsys.readouterr().out
    assert "fit of 'pendulum': converged after" in said
    assert "95 % interval" in said
    assert "Durbin-Watson tip" in said
    assert "wrote out/fit.png" in said
    assert Path("out/fit.png").read_bytes().startswith(b"\x89PNG")
    motion = cd.load_motion("fit.npz")
    assert motion["hinge"][0] == pytest.approx(1.2, abs=0.01)


def test_inputs_are_columns_or_numbers(capsys: pytest.CaptureFixture[str]) -> None:
    """What a column of its name says, unless another is named: without the torque nothing fits."""
    sigmas = []
    both = ("--measured", "hinge=hinge", "--measured", "tip=x", "--json")
    for words in ((), ("--input", "tau=torque"), ("--input", "tau=0")):
        noise = ("--noise", "hinge=0.002", "--noise", "tip=1")
        assert status(*WORDS, *words, *noise, *both) == 0
        found = json.loads(capsys.readouterr().out)
        sigmas.append(found["sigma"])
    assert sigmas[1] == pytest.approx(sigmas[0], rel=1e-6)
    assert sigmas[2] > 10 * sigmas[0]
    assert "hinge" in found["serially_correlated"]
    assert status(*WORDS, "--input", "tau=0") == 0
    assert "the model misses something" in capsys.readouterr().out


def test_seeds_segments_and_what_is_known(capsys: pytest.CaptureFixture[str]) -> None:
    words = ("pendulum.yaml", "run.csv", "--unknown", "damping", "--set", "length=1.1", "--q")
    words = (*words, "hinge=1.2", "--set", "damping=9", "--segments", "1", "--json")
    assert status(*words, "--seeds", "identify") == 0
    found = json.loads(capsys.readouterr().out)
    assert found["segments"] == 1
    assert found["estimates"]["damping"]["value"] == pytest.approx(0.06, abs=0.005)
    assert status("pendulum.yaml", "run.csv", "--unknown", "gravity.z", "--seeds", "identify") == 1
    assert "no unknown of gravity.z is a mass" in capsys.readouterr().err


def test_ctrl_c_keeps_what_was_found(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    calls, every = list[int](), shooting.Shooting.every

    def interrupted(*arguments: object) -> object:
        calls.append(1)
        if len(calls) == 4:
            raise KeyboardInterrupt
        return every(*arguments)  # type: ignore[arg-type]

    monkeypatch.setattr(shooting.Shooting, "every", interrupted)
    assert status(*WORDS, "--measured", "tip=x", "--json") == 130
    streams = capsys.readouterr()
    assert json.loads(streams.out)["message"].startswith("interrupted in iteration 3")
    assert "interrupted in iteration 3" in streams.err


WRONG = {
    "no unknown": ((), 2, "--unknown"),
    "no names": (("--unknown", "a,,b"), 2, "does not read NAME,NAME"),
    "no column": (("--unknown", "q0", "--measured", "tip"), 2, "does not read NAME=COLUMN"),
    "no bounds": (("--unknown", "length", "--bounds", "length=2,1"), 2, "NAME=LOW,HIGH"),
    "no noise": (("--unknown", "q0", "--noise", "-1"), 2, "is not a positive number"),
    "no segments": (("--unknown", "q0", "--segments", "0"), 2, "is not a number such as"),
    "two noises": (
        ("--unknown", "q0", "--noise", "1", "--noise", "hinge=1"), 1, "one value for all",
    ),
    "other unknown": (("--unknown", "lenght"), 1, "Did you mean 'length'"),
    "other column": (("--unknown", "q0", "--measured", "tip=y"), 1, "no column 'y'"),
    "other input": (("--unknown", "q0", "--input", "tau=torqe"), 1, "Did you mean 'torque'"),
    "other formula": (("--unknown", "q0", "--measured", "top=x"), 1, "--measured"),
}  # fmt: skip


@pytest.mark.parametrize("case", WRONG)
def test_what_makes_no_sense(case: str, capsys: pytest.CaptureFixture[str]) -> None:
    words, answer, message = WRONG[case]
    assert status("pendulum.yaml", "run.csv", *words) == answer
    assert message in capsys.readouterr().err
    assert not Path("fit.png").exists()


def test_beams(capsys: pytest.CaptureFixture[str]) -> None:
    """A scene that is compiled in absolute coordinates, measured at its tip."""
    scene = cd.Scene("hose", gravity=(0, 0, -9.81))
    hub = scene.body("hub", mass=0.2, inertia=(0.002, 0.002, 0.002))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, hub)
    rubber = cd.material(E=scene.parameter("E", 3e6), nu=0.45, rho=1100, damping=1e-3)
    square = cd.section.rectangle(0.03, 0.02)
    bar = scene.beam("bar", hub, (0.4, 0, 0), square, rubber, elements=1)
    scene.force("spring", cd.JointSpring("hinge", stiffness=8.0))
    scene.output("tip", bar.end.position()[2])
    scene.save("hose.yaml")
    t = np.linspace(0, 0.3, 31)
    truth = cd.compile(scene).simulate(t, q={"hinge": 0.3}, parameters={"E": 4e6}, rtol=1e-10)
    table = np.column_stack([t, truth["tip"]])
    np.savetxt("tip.csv", table, delimiter=",", header="t,tip", comments="", fmt="%.15g")
    words = ("hose.yaml", "tip.csv", "--unknown", "E", "--q", "hinge=0.3", "--json")
    assert status(*words) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["estimates"]["E"]["value"] == pytest.approx(4e6, rel=1e-6)
