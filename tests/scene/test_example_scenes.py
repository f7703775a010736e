"""The example scenes: each loads, derives, compiles and runs as its file says."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.cli import main

# of a run as its file says, or of one second: a name and where it ends
ENDS = {
    # hung at the grip, nothing moves it
    "acrobat": ("grip", 0.0, 0.1),
    # it goes straight on, leaning at first
    "bicycle": ("rear_contact.u.lean", 0.0, 5.0),
    # it rests on the ground
    "bouncing_ball": ("height", 0.0, 0.2),
    "bucket": ("hang.angle1", 0.0, 1e-9),
    # upright is not stable: it falls and swings about 2 pi / 2
    "cart_pole": ("pole", np.pi, np.pi + 0.1),
    "double_pendulum": ("elbow", 0.0, 3.2),
    # torque times time squared over the moment of inertia, and what still swings
    "flexible_arm": ("shoulder", 0.4 * 0.25 / 0.282, 0.02),
    "four_bar": ("A", 19.76, 0.01),
    # level again
    "quadrotor": ("base.qw", 1.0, 1e-3),
    # as if its rod were rigid, at 10.5 rad
    "slider_crank": ("guide", -0.2519, 2e-3),
    # beyond the flat truss
    "snap_through": ("guide", -0.4, 0.03),
    "trolley": ("left.hang.angle1", 0.0, 0.5),
}


@pytest.mark.parametrize("name", list(cd.examples))
def test_example_runs(name: str) -> None:
    scene = cd.examples[name]
    assert isinstance(scene, cd.Scene)
    assert scene.name == name
    model = cd.compile(scene)
    motion = model.simulate(**{"t": 1.0, **scene.settings})
    assert motion.success
    assert np.isfinite(motion.x).all()
    quantity, value, within = ENDS[name]
    assert motion[quantity][-1] == pytest.approx(value, abs=within)


def test_the_list_has_a_line_on_each() -> None:
    lines = repr(cd.examples).splitlines()
    assert [line.split()[0] for line in lines] == list(cd.examples) == sorted(ENDS)
    for name, line in zip(cd.examples, lines, strict=True):
        assert len(cd.examples.description(name)) > 20
        assert line.endswith(cd.examples.description(name))
    assert "four_bar" in cd.examples
    assert cd.examples.path("four_bar").is_file()


def test_unknown_names() -> None:
    with pytest.raises(cd.ModelError, match=r"no scene 'fourbar'.*Did you mean 'four_bar'"):
        cd.examples["fourbar"]
    assert "fourbar" not in cd.examples


def test_commands_take_names(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["simulate", "cart_pole", "--time", "0.1", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["time"] == 0.1
    # a file of that name comes first
    Path("cart_pole").write_text("nonsense")
    assert main(["simulate", "cart_pole", "--time", "0.1"]) != 0
