"""Batches of order "F", and of float32: what is taken and given, failures, threads, parameters."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
import sympy

import cardan as cd
from cardan.errors import ArgumentError, BuildWarning, ModelError, SolveError, SolveWarning
from cardan.runtime.calls import batch, lanes
from table import each

pytestmark = [pytest.mark.optimized, pytest.mark.usefixtures("cache_directory")]

FUNCTIONS = ("forward_dynamics", "rhs", "pose", "mass_matrix")
UNIT = 2.0**-24
TYPES = ("float64", "float32")


def scene() -> cd.Scene:
    scene = cd.Scene("pair", gravity=(0, 0, -9.81))
    upper = scene.body("upper", mass=2.0, com=(0.1, 0, -0.2), inertia=(0.02, 0.03, 0.01))
    lower = scene.body("lower", mass=1.0, com=(0, 0.02, -0.3), inertia=(0.01, 0.02, 0.01))
    scene.joint("shoulder", cd.Universal("x", "y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -0.4), lower)
    return scene


@pytest.fixture(scope="module")
def model() -> cd.CompiledModel:
    found = cd.compile(scene(), functions=FUNCTIONS, dtype="float32", threads=1)
    found.prepare("forward_dynamics", "rhs", "mass_matrix", ("pose", "lower"), batch=True)
    return found


def drawn(count: int, dtype: str = "float64", order: str = "C") -> tuple[np.ndarray, ...]:
    """q, u and tau, which floats hold too."""
    rows = np.random.default_rng(1).uniform(-1, 1, (3, count, 3)).astype(np.float32)
    return tuple(np.array(x, dtype, order=order) for x in rows)


def test_results_lie_as_arguments_do(model: cd.CompiledModel) -> None:
    for dtype in TYPES:
        q, u, tau = drawn(77, dtype)
        rows = model.forward_dynamics(q, u, tau=tau)
        assert rows.flags.c_contiguous
        columns = model.forward_dynamics(*(x.copy("F") for x in (q, u)), tau=tau.copy("F"))
        assert columns.flags.f_contiguous
        assert columns.dtype == rows.dtype == dtype
        assert columns.tobytes() == rows.tobytes()
        # mixed, and with what all states share: rows; an array over entries first, its transpose
        assert model.forward_dynamics(q.copy("F"), u, tau=tau).tobytes() == rows.tobytes()
        entries = model.forward_dynamics(q.T.copy().T, u.T.copy().T, tau=tau.T.copy().T)
        assert entries.T.flags.c_contiguous
        shared = model.forward_dynamics(q.copy("F"), u[0], tau=tau[0])
        assert shared.flags.f_contiguous
        assert shared.tobytes() == model.forward_dynamics(q, u[0], tau=tau[0]).tobytes()


def test_more_axes_and_matrices(model: cd.CompiledModel) -> None:
    for dtype in TYPES:
        q = drawn(66, dtype)[0]
        rows = model.mass_matrix(q)
        columns = model.mass_matrix(q.copy("F"))
        assert columns.transpose(1, 2, 0).flags.c_contiguous
        assert columns.tobytes() == rows.tobytes()
        # two leading axes behind those of entries
        cube = np.moveaxis(np.ascontiguousarray(np.moveaxis(q.reshape(6, 11, 3), -1, 0)), 0, -1)
        assert model.mass_matrix(cube).tobytes() == rows.tobytes()
        poses = model.pose("lower", q.copy("F"))
        assert poses.dtype == dtype
        assert poses.tobytes() == model.pose("lower", q).tobytes()


def test_out_of_every_order(model: cd.CompiledModel) -> None:
    for dtype in TYPES:
        q, u, tau = drawn(50, dtype)
        expected = model.forward_dynamics(q, u, tau=tau)
        for order in "CF":
            out = np.empty((50, 3), dtype, order=order)
            assert model.forward_dynamics(q, u, tau=tau, out=out) is out
            assert out.tobytes() == expected.tobytes()
            arguments = q.copy("F"), u.copy("F")
            # into an argument that is read meanwhile
            assert model.forward_dynamics(*arguments, tau=tau, out=arguments[0]) is arguments[0]
            assert arguments[0].tobytes() == expected.tobytes()
    with pytest.raises(ArgumentError, match=r"float32, expected \(50, 3\) of float64"):
        model.forward_dynamics(*drawn(50)[:2], out=np.empty((50, 3), np.float32))
    with pytest.raises(ArgumentError, match=r"float64, expected \(50, 3\) of float32"):
        model.forward_dynamics(*drawn(50, "float32")[:2], out=np.empty((50, 3)))


def test_out_has_a_place_for_every_number(model: cd.CompiledModel) -> None:
    for dtype in TYPES:
        q, u, tau = drawn(50, dtype)
        one = np.zeros(3, dtype)
        out = np.lib.stride_tricks.as_strided(one, (50, 3), (0, one.itemsize))
        with pytest.raises(ArgumentError, match="out has one place for several numbers"):
            model.forward_dynamics(q, u, tau=tau, out=out)
        assert not one.any()


def test_failing_states_leave_the_others_alone(model: cd.CompiledModel) -> None:
    for dtype, order in ((d, o) for d in TYPES for o in "CF"):
        q, u, tau = drawn(45, dtype, order)
        good = model.forward_dynamics(q, u, tau=tau)
        u[17] = 1e30 if dtype == "float32" else 1e200
        with pytest.warns(SolveWarning, match="state 17; 1 of 45"):
            found = model.forward_dynamics(q, u, tau=tau)
        assert not np.isfinite(found[17]).all()
        assert np.delete(found, 17, axis=0).tobytes() == np.delete(good, 17, axis=0).tobytes()


def test_numbers_that_are_not_finite_are_named(model: cd.CompiledModel) -> None:
    for dtype, order, place in ((d, o, k) for d in TYPES for o in "CF" for k in (0, 35, 299)):
        q, u, tau = drawn(300, dtype, order)
        for bad in (np.nan, np.inf):
            u[place, 2] = bad
            with pytest.raises(SolveError, match=f"u of elbow.* is {bad} at state {place}"):
                model.forward_dynamics(q, u, tau=tau)


def test_a_state_without_solution_is_done_again_in_doubles(tmp_path: object) -> None:
    """A mass matrix that is singular at one state: NaN there alone, in floats too."""
    made = cd.Scene("slider")
    body = made.body("point", mass=1.0)
    made.joint("slide", cd.Prismatic("x"), made.ground, body)
    found = cd.compile(made, functions=("forward_dynamics",), dtype="float32", threads=1)
    q, u = np.zeros((2, 40, 1))
    masses = np.ones(40)
    masses[3] = 0.0
    for dtype in TYPES:
        with pytest.warns(SolveWarning, match="state 3; 1 of 40"):
            udot = found.forward_dynamics(
                q.astype(dtype),
                u.astype(dtype),
                tau=q.astype(dtype) + 1,
                parameters={"point.mass": masses},
            )
        assert udot.dtype == dtype
        assert (np.delete(udot, 3, axis=0) == 1).all()


def test_floats_where_all_arrays_of_states_are(model: cd.CompiledModel) -> None:
    q, u, tau = drawn(40, "float32")
    assert model.forward_dynamics(q, u, tau=tau).dtype == np.float32
    # what all states share has no say, and so have lists
    assert model.forward_dynamics(q, u, tau=tau[0].astype(float)).dtype == np.float32
    assert model.rhs(0.5, np.concatenate([q, u], axis=1)).dtype == np.float32
    # doubles, one state, and a model without them
    assert model.forward_dynamics(q, u.astype(float), tau=tau).dtype == np.float64
    assert model.forward_dynamics(q[0], u[0], tau=tau[0]).dtype == np.float64
    plain = cd.compile(scene(), functions=FUNCTIONS)
    assert plain.forward_dynamics(q, u, tau=tau).dtype == np.float64


def test_bits_depend_on_no_number_of_states(model: cd.CompiledModel) -> None:
    q, u, tau = drawn(700, "float32")
    expected = model.forward_dynamics(q, u, tau=tau)
    exact = model.forward_dynamics(*(x.astype(float) for x in (q, u)), tau=tau.astype(float))
    assert 0 < np.abs(expected - exact).max() <= 1e3 * UNIT * np.abs(exact).max()
    for count in (1, 2, 15, 16, 17, 31, 33, 257):
        found = model.forward_dynamics(q[:count], u[:count], tau=tau[:count])
        assert found.tobytes() == expected[:count].tobytes()


def test_parameters_of_every_state_in_floats(model: cd.CompiledModel) -> None:
    q, u, tau = drawn(50, "float32")
    masses = np.random.default_rng(3).uniform(1, 2, 50)
    found = model.forward_dynamics(q, u, tau=tau, parameters={"upper.mass": masses})
    doubles = model.forward_dynamics(
        *(x.astype(float) for x in (q, u)), tau=tau.astype(float), parameters={"upper.mass": masses}
    )
    assert found.dtype == np.float32
    assert 0 < np.abs(found - doubles).max() <= 1e3 * UNIT * np.abs(doubles).max()
    columns = model.forward_dynamics(
        q.copy("F"), u.copy("F"), tau=tau.copy("F"), parameters={"upper.mass": masses}
    )
    assert columns.tobytes() == found.tobytes()


@pytest.mark.parametrize("many", [1, 3])
def test_threads_share_them(many: int, monkeypatch: pytest.MonkeyPatch) -> None:
    found = cd.compile(scene(), functions=FUNCTIONS, threads=many, dtype="float32")
    found.prepare("forward_dynamics", batch=True)
    monkeypatch.setattr(batch, "THREADED", 0.0)
    monkeypatch.setattr(batch, "CHUNK_SECONDS", 1e-5)
    for dtype in TYPES:
        q, u, tau = drawn(5000, dtype)
        expected = found.forward_dynamics(q[:300], u[:300], tau=tau[:300])
        for order in "CF":
            some = found.forward_dynamics(q.copy(order), u.copy(order), tau=tau.copy(order))
            assert some[:300].tobytes() == expected.tobytes()
            assert some.flags[f"{order}_CONTIGUOUS"]


def test_without_vectors_doubles_are_rounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("CARDAN_LANES", "1")
    found = cd.compile(scene(), functions=FUNCTIONS, dtype="float32")
    q, u, tau = drawn(40, "float32", "F")
    exact = found.forward_dynamics(*(x.astype(float) for x in (q, u)), tau=tau.astype(float))
    udot = found.forward_dynamics(q, u, tau=tau)
    # of parameters that are floats
    assert np.abs(udot - exact).max() <= 64 * UNIT * np.abs(exact).max()
    assert udot.dtype == np.float32
    assert udot.flags.f_contiguous


def test_all_else_stays_in_doubles(model: cd.CompiledModel) -> None:
    plain = cd.compile(scene())
    floats = cd.compile(scene(), dtype="float32")
    start = {"q": {"elbow": 0.3}}
    assert floats.simulate(1.0, **start).x.tobytes() == plain.simulate(1.0, **start).x.tobytes()
    states = plain.random_state(1, (9,))
    ends = [m.ensemble(0.5, x0=states).final.tobytes() for m in (plain, floats)]
    assert ends[0] == ends[1]


def test_they_travel_and_are_opened_again(model: cd.CompiledModel) -> None:
    q, u, tau = drawn(40, "float32")
    expected = model.forward_dynamics(q, u, tau=tau)
    others = (
        pickle.loads(pickle.dumps(model)),
        cd.load_model(model.directory, dtype="float32"),
        model.with_parameters({"upper.mass": 2.0}),
    )
    for other in others:
        assert other.forward_dynamics(q, u, tau=tau).tobytes() == expected.tobytes()
    assert cd.load_model(model.directory).forward_dynamics(q, u, tau=tau).dtype == np.float64


def test_the_report_says_what_floats_cost_and_lose(model: cd.CompiledModel) -> None:
    report = model.report()
    rows = {row.function: row for row in report.rows}
    row = rows["forward_dynamics"]
    assert 0.01 * UNIT < row.float_error < 1e3 * UNIT
    assert row.float_ns > 0
    assert [c.header for c in report.table().columns][-2:] == ["of float32", "difference"]
    assert model.lanes("forward_dynamics") == lanes.width(single=True)


def test_few_digits_deserve_a_word() -> None:
    """A difference of lengths of a million meters: floats tell 6 cm apart."""
    made = cd.Scene("far", gravity=(0, 0, -9.81))
    mass = made.body("mass", mass=1.0)
    made.joint("slide", cd.Prismatic("x"), made.ground, mass)
    angle = made.q("slide")
    made.force("pull", cd.JointForce("slide", sympy.sqrt((angle + 1e6) ** 2) - 1e6))
    found = cd.compile(made, functions=("forward_dynamics",), dtype="float32")
    with pytest.warns(BuildWarning, match="float32 differs from doubles by"):
        found.prepare("forward_dynamics", batch=True)


def test_builds_that_were_made_before_get_the_word_too(cache_directory: object) -> None:
    """Whoever made them; and with other parameters again."""
    made = cd.Scene("near", gravity=(0, 0, -9.81))
    mass = made.body("mass", mass=1.0)
    made.joint("slide", cd.Prismatic("x"), made.ground, mass)
    far = made.parameter("far", 1e6)
    pull = sympy.sqrt((made.q("slide") + far) ** 2) - far
    made.force("pull", cd.JointForce("slide", pull))
    q = np.linspace(0, 1, 40, dtype=np.float32)[:, None]
    for _ in range(3):
        found = cd.compile(made, functions=("forward_dynamics",), dtype="float32")
        with pytest.warns(BuildWarning, match="float32 differs from doubles by"):
            found.forward_dynamics(q, q)
        # once is enough
        found.forward_dynamics(q, q)
        near = found.with_parameters(far=1.0)
        near.forward_dynamics(q, q)
        with pytest.warns(BuildWarning, match="float32 differs from doubles by"):
            near.with_parameters(far=2e6).forward_dynamics(q, q)


@each("mass, text", [(1e-39, "1e-39"), (1e-300, "1e-300"), (1e42, r"1e\+42")])
def test_parameters_that_floats_cannot_hold_are_refused(mass: float, text: str) -> None:
    """As 0, or as infinity, they would give other motions in silence."""
    made = cd.compile(scene(), functions=FUNCTIONS, dtype="float32")
    error = (
        rf"forward_dynamics: \S+, computed from parameters? 'upper.mass' \({text}\).* is outside"
    )
    other = made.with_parameters({"upper.mass": mass})
    for order in "CF":
        q, u, tau = drawn(40, "float32", order)
        good = made.forward_dynamics(q, u, tau=tau)
        with pytest.raises(ModelError, match=error):
            other.forward_dynamics(q, u, tau=tau)
        masses = np.full(40, 2.0)
        masses[7] = mass
        with pytest.raises(ModelError, match=r"computed from parameters? 'upper.mass',"):
            made.forward_dynamics(q, u, tau=tau, parameters={"upper.mass": masses})
        assert made.forward_dynamics(q, u, tau=tau).tobytes() == good.tobytes()
    # doubles hold them
    assert np.isfinite(other.forward_dynamics(*drawn(40)[:2])).all()


def test_products_of_parameters_that_floats_cannot_hold_are_refused() -> None:
    made = cd.Scene("small")
    mass, length = made.parameter("m", 1.0, "kg"), made.parameter("l", 1.0, "m")
    body = made.body("bob", mass=mass, com=(0, 0, -length))
    made.joint("pivot", cd.Revolute("y"), made.ground, body)
    found = cd.compile(made, functions=("mass_matrix",), dtype="float32")
    q = np.zeros((40, 1), np.float32)
    assert (found.mass_matrix(q) == 1).all()
    small = found.with_parameters(m=1e-20, l=1e-15)
    with pytest.raises(ModelError, match=r"1e-50, computed from parameters 'm' \(1e-20\), 'l'"):
        small.mass_matrix(q)
    assert small.mass_matrix(q.astype(float)) == pytest.approx(1e-50)


def test_arguments_that_floats_cannot_hold_are_refused(model: cd.CompiledModel) -> None:
    q, u, _ = drawn(40, "float32")
    with pytest.raises(ArgumentError, match=r"tau: 1e\+39 is more than the 3.4e\+38"):
        model.forward_dynamics(q, u, tau=[0.0, 1e39, 0.0])
    with pytest.raises(ArgumentError, match=r"tau: -1e\+300 is more than"):
        model.forward_dynamics(q, u, tau={"elbow": -1e300})


@each(
    ("dtype", "error"),
    [("float16", "dtype 'float16' does not exist"), ("single", "dtype 'single' does not exist")],
)
def test_other_types_are_refused(dtype: str, error: str) -> None:
    with pytest.raises(ModelError, match=error):
        cd.compile(scene(), dtype=dtype)


def test_elements_are_refused() -> None:
    with pytest.raises(ModelError, match="absolute coordinates need doubles"):
        cd.compile(scene(), coordinates="absolute", dtype="float32")
