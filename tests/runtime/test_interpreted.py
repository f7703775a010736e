"""Without a compiler every function gives the same numbers, from its saved expressions."""

from __future__ import annotations

import pickle
import warnings
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.runtime.build import toolchain
from cardan.runtime.calls import interpreted, webassembly
from mechanisms import ZOO
from spread import some

pytestmark = pytest.mark.usefixtures("cache_directory")

MEMBERS = ("double_pendulum", "satellite", "drives", "spherical_ZYX", "crane", "driven", "springs")
# rounding of two orders of the same operations, by the condition of M where it is divided by
CLOSE = 1e-12


@pytest.fixture
def bare(monkeypatch):
    """Take every compiler away."""

    def remove() -> None:
        monkeypatch.setenv("PATH", "/nonexistent")
        monkeypatch.delenv("CC", raising=False)
        monkeypatch.setattr(toolchain, "ziglang", lambda: [])
        monkeypatch.setattr(webassembly, "available", lambda: False)

    return remove


def calls(model: cd.CompiledModel, n: int) -> dict[str, np.ndarray]:
    """Results of every function at n states."""
    x = model.random_state(3, (n,) if n else ())
    q, u = model.split(x)
    rng = np.random.default_rng(4)
    tau, t = rng.uniform(-1, 1, u.shape), 0.3
    body, joint = model.bodies[-1], model.joints[0]
    found = {
        "rhs": model.rhs(t, x),
        "udot": model.forward_dynamics(q, u, tau=tau, t=t),
        "tau": model.inverse_dynamics(q, u, tau, t=t),
        "M": model.mass_matrix(q, t=t),
        "h": model.bias(q, u, t=t),
        "gravity": model.gravity(q, t=t),
        "coriolis": model.coriolis(q, u, t=t),
        "qdot": model.qdot(q, u, t=t),
        "energy": np.stack(model.energy(q, u, t=t), axis=-1),
        "pose": model.pose(body, q, t=t),
        "velocity": model.velocity(body, q, u, t=t),
        "acceleration": model.acceleration(body, q, u, tau, t=t),
        "jacobian": model.frame_jacobian(body, q, t=t),
        "com": model.com(q, t=t),
        "momentum": model.momentum(q, u, t=t),
        "reaction": model.reaction(joint, q, u, t=t),
        "integrate": model.integrate(q, 0.1 * tau),
        "difference": model.difference(q, model.integrate(q, 0.1 * tau)),
        "wrenches": model.forward_dynamics(q, u, t=t, wrenches={body: [1, 2, 3, 4, 5, 6]}),
    }
    name = next(iter(model.parameters))
    changed = {name: model.parameters[name] * np.array([1.0, 1.1])[:, None] if n else 1.1}
    return found | {"M of others": model.mass_matrix(q, t=t, parameters=changed)}


@pytest.mark.filterwarnings("ignore::cardan.errors.BuildWarning")
@pytest.mark.parametrize("name", some(MEMBERS, 2))
def test_every_function_gives_the_same_numbers(name, bare):
    model = cd.compile(ZOO[name].build())
    known = {n: calls(model, n) for n in (0, 5)}
    scale = {key: np.abs(value).max() for key, value in known[5].items()}
    condition = np.linalg.cond(known[5]["M"]).max()
    content = pickle.dumps(model)
    bare()
    other = pickle.loads(content)
    for n, expected in known.items():
        for key, value in calls(other, n).items():
            error = np.abs(value - expected[key]).max(initial=0.0)
            assert value.shape == expected[key].shape
            assert error <= CLOSE * condition * max(1.0, scale[key]), (key, n)
    assert other._function("rhs").interpreted
    verified = other.verify()
    assert not verified.checked or verified.worst < 1e-9


def test_it_is_said_once(bare):
    bare()
    with pytest.warns(cd.BuildWarning, match=r"Python.*pip install 'cardan\[compiler\]'") as said:
        # two at once: the threads that would compile them know nothing of this line
        cd.load_model(bare_model()).prepare("rhs", "energy")
    assert [warning.filename for warning in said] == [__file__]
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        cd.load_model(bare_model()).prepare("rhs", "energy")


def bare_model() -> Path:
    """The directory of a pendulum, two of whose functions are written."""
    scene = cd.Scene("bob", gravity=(0, 0, -9.81))
    scene.joint("j", cd.Revolute("y"), scene.ground, scene.body("b", mass=1.0, com=(0, 0, -1.0)))
    equations = cd.derive(scene)
    model = cd.compile(equations)
    for name in ("rhs", "energy"):
        model._objects.symbol(name)
    return model.directory


def test_expressions_that_were_not_saved(model, bare):
    """A directory with C alone needs a compiler, and says so."""
    bare()
    (model.directory / "functions.json").write_text("{}")
    with pytest.raises(cd.CompilerMissing, match="no C compiler"):
        model.prepare("energy")


@pytest.mark.filterwarnings("ignore::cardan.errors.BuildWarning")
def test_singular_states_of_a_batch_become_nan(bare):
    """Only they, with a warning; one alone is an error; as compiled."""
    scene = cd.Scene("hanging", gravity=(0, 0, -9.81))
    ring, bob = scene.body("ring", mass=0), scene.body("bob", mass=1.0, com=(0, 0, -1.0))
    scene.joint("turn", cd.Revolute("z"), scene.ground, ring)
    scene.joint("lift", cd.Revolute("y"), ring, bob)
    model = cd.compile(scene, functions=["forward_dynamics"])
    # hanging straight down, nothing resists the turn
    q, u = np.array([[0.0, 0.3], [0.0, 0.0], [0.0, 0.4]]), np.ones((3, 2))
    with pytest.warns(cd.SolveWarning, match="at state 1; 1 of 3 states failed"):
        known = model.forward_dynamics(q, u)
    content = pickle.dumps(model)
    bare()
    other = pickle.loads(content)
    with pytest.warns(cd.SolveWarning, match="at state 1; 1 of 3 states failed"):
        found = other.forward_dynamics(q, u)
    np.testing.assert_allclose(found[[0, 2]], known[[0, 2]], rtol=1e-12)
    assert not np.isfinite(found[1]).all()
    for one in (model, other):
        with pytest.raises(cd.SolveError, match="no finite result"):
            one.forward_dynamics(q[1], u[1])


def test_report_tells_what_there_is(bare, capsys):
    bare()
    interpreted.announce.cache_clear()
    with pytest.warns(cd.BuildWarning, match="no C compiler"):
        report = cd.load_model(bare_model()).report()
    assert "no C compiler" in report.compiler
    assert all(np.isnan(row.call_ns) and row.state_ns > 0 for row in report.rows)
    assert all(row.error < 1e-12 for row in report.rows)
    assert "rhs" in capsys.readouterr().out
