"""Vectors and dyadics against formulas by hand, SymPy's vectors and the compiled functions."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from sympy.physics.mechanics import Point, ReferenceFrame, dynamicsymbols
from sympy.physics.mechanics import inertia as sympy_inertia

import cardan as cd

m, l = sp.symbols("m l")
q1, q2, u1, u2 = sp.symbols("shoulder elbow shoulder.u elbow.u")
a1, a2 = sp.symbols("shoulder.udot elbow.udot")


def double_pendulum() -> cd.Scene:
    scene = cd.Scene("double_pendulum", gravity=(0, 0, -9.81))
    scene.parameter("m", 1.0, unit="kg")
    scene.parameter("l", 0.5, unit="m")
    inertia = cd.inertia.rod(m, l, axis="z")
    upper = scene.body("upper", mass=m, com=(0, 0, -l / 2), inertia=inertia)
    lower = scene.body("lower", mass=m, com=(0, 0, -l / 2), inertia=inertia)
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -l), lower)
    lower.at(0, 0, -l, name="tip")
    return scene


def gimbal() -> cd.Scene:
    """A rotor in two rings on a slide: Euler angles about z, x, z."""
    scene = cd.Scene("gimbal")
    ring = scene.body("ring", mass=2.0, com=(0.1, 0, 0.2), inertia=(0.1, 0.2, 0.25))
    cradle = scene.body("cradle", mass=1.0, com=(0, 0.1, 0), inertia=(0.1, 0.12, 0.15))
    rotor = scene.body("rotor", mass=3.0, inertia=[sp.Symbol(x) for x in ("A", "B", "C")])
    for name, value in (("A", 0.2), ("B", 0.3), ("C", 0.4)):
        scene.parameter(name, value, unit="kg*m^2")
    slide = scene.body("slide", mass=1.0)
    scene.joint("x", cd.Prismatic("x"), scene.ground, slide)
    scene.joint("psi", cd.Revolute("z"), slide.at(0, 0, 0.3), ring)
    scene.joint("theta", cd.Revolute("x"), ring.at(0.5, 0, 0.1), cradle)
    scene.joint("phi", cd.Revolute("z"), cradle.at(0, 0, 0.4), rotor)
    rotor.at(0.2, 0.3, -0.1, rotation=("XYZ", 0.3, -0.4, 0.5), name="sensor")
    return scene


def assert_equal(first: sp.Matrix, second: sp.Matrix) -> None:
    difference = sp.Matrix(first) - sp.Matrix(second)
    assert difference.applyfunc(sp.simplify) == sp.zeros(*difference.shape)


def test_double_pendulum_by_hand() -> None:
    vectors = cd.vectors(cd.derive(double_pendulum()))
    s1, c1, s12, c12 = sp.sin(q1), sp.cos(q1), sp.sin(q1 + q2), sp.cos(q1 + q2)
    tip, u12 = vectors.position("tip"), u1 + u2
    assert_equal(tip.express(), [-l * (s1 + s12), 0, -l * (c1 + c12)])
    assert_equal(
        vectors.velocity("tip").express(),
        [-l * (c1 * u1 + c12 * u12), 0, l * (s1 * u1 + s12 * u12)],
    )
    a12 = a1 + a2
    assert_equal(
        vectors.acceleration("tip").express(),
        [
            l * (s1 * u1**2 - c1 * a1 + s12 * u12**2 - c12 * a12),
            0,
            l * (c1 * u1**2 + s1 * a1 + c12 * u12**2 + s12 * a12),
        ],
    )
    # law of cosines for the distance
    assert sp.simplify(tip.magnitude() ** 2 - 2 * l**2 * (1 + sp.cos(q2))) == 0
    assert_equal(vectors.angular_velocity("lower").express("upper"), [0, u12, 0])
    assert_equal(vectors.angular_acceleration("lower").express(), [0, a12, 0])
    assert_equal(vectors.velocity("tip", wrt="upper").express("lower"), [-l * u2, 0, 0])


def test_kinetic_energy_of_bodies_gives_the_mass_matrix() -> None:
    for scene in (double_pendulum(), gimbal()):
        equations = cd.derive(scene)
        vectors, energy = cd.vectors(equations), sp.Integer(0)
        for body in scene.bodies:
            v, omega = vectors.center_of_mass(body).dt(), vectors.angular_velocity(body)
            spin = vectors.inertia(body).dot(omega)
            energy += (vectors.mass(body) * v.dot(v) + omega.dot(spin)) / 2
        speeds = [sp.Symbol(name) for name in equations.speeds]
        assert_equal(sp.hessian(energy, speeds), equations.mass_matrix)


def test_gimbal_against_sympy() -> None:
    equations = cd.derive(gimbal())
    vectors = cd.vectors(equations)
    names = dict(zip(("x", "psi", "theta", "phi"), dynamicsymbols("x psi theta phi"), strict=True))
    ground = ReferenceFrame("ground")
    ring = ground.orientnew("ring", "Axis", (names["psi"], ground.z))
    cradle = ring.orientnew("cradle", "Axis", (names["theta"], ring.x))
    rotor = cradle.orientnew("rotor", "Axis", (names["phi"], cradle.z))
    origin = Point("origin")
    origin.set_vel(ground, 0)
    arm = names["x"] * ground.x + 0.3 * ground.z
    arm += 0.5 * ring.x + 0.1 * ring.z + 0.4 * cradle.z
    frames = {"ground": ground, "ring": ring, "cradle": cradle, "rotor": rotor}
    A, B, C = sp.symbols("A B C")
    tensor = sympy_inertia(rotor, A, B, C)
    pairs = [
        (vectors.position("rotor"), arm),
        (vectors.velocity("rotor"), arm.dt(ground)),
        (vectors.acceleration("rotor"), arm.dt(ground).dt(ground)),
        (vectors.velocity("rotor", wrt="ring"), (arm - names["x"] * ground.x).dt(ring)),
        (vectors.angular_velocity("rotor"), rotor.ang_vel_in(ground)),
        (vectors.angular_velocity("ring", wrt="rotor"), ring.ang_vel_in(rotor)),
        (vectors.angular_acceleration("rotor", wrt="ring"), rotor.ang_acc_in(ring)),
        (
            vectors.inertia("rotor").dot(vectors.angular_velocity("rotor")).dt(),
            tensor.dot(rotor.ang_vel_in(ground)).dt(ground),
        ),
        (vectors.axes("cradle")[1].cross(vectors.axes("ground")[0]), cradle.y ^ ground.x),
        (
            vectors.axes("ring")[0].outer(vectors.axes("rotor")[1]).dot(vectors.axes("ground")[2]),
            ring.x * (rotor.y & ground.z),
        ),
    ]
    rng = np.random.default_rng(3)
    t = dynamicsymbols._t
    for ours, theirs in pairs:
        for name, frame in frames.items():
            # accelerations, then speeds, then coordinates
            values = [
                (sp.diff(x, t, order), rng.uniform(0.5, 1.5)) for order in (2, 1, 0)
                for x in names.values()
            ]  # fmt: skip
            suffixes = {2: ".udot", 1: ".u", 0: ""}
            plain = {
                sp.Symbol(joint + suffixes[order]): values[4 * (2 - order) + n][1]
                for order in (2, 1, 0)
                for n, joint in enumerate(names)
            }
            numbers = {A: 0.2, B: 0.3, C: 0.4}
            expected = theirs.to_matrix(frame).subs(values).subs(numbers)
            result = _numbers(equations, ours.express(name), plain | numbers)
            # products of less than a hundred numbers near 1
            np.testing.assert_allclose(result, np.array(expected, dtype=float), rtol=0, atol=1e-12)


def _numbers(
    equations: cd.Equations, matrix: sp.Matrix, values: dict[sp.Symbol, float]
) -> np.ndarray:
    defaults = {sp.Symbol(p.name): p.value for p in equations.system.parameters}
    return np.array(matrix.subs({**defaults, **values}), dtype=float)


def test_derivatives_of_dyadics() -> None:
    vectors = cd.vectors(cd.derive(gimbal()))
    inertia = vectors.inertia("rotor", about="ring")
    fixed = vectors.vector((0.2, 0.5, -0.3), "cradle")
    product = inertia.dot(fixed)
    # product rule in a frame that moves against both
    difference = (
        product.dt("slide") - inertia.dt("slide").dot(fixed) - inertia.dot(fixed.dt("slide"))
    )
    state = ([0.3, 0.4, 0.7, -0.5], [0.2, -1.1, 0.8, 0.6])
    np.testing.assert_allclose(difference.evaluate(*state, frame="rotor"), 0, atol=1e-14)
    turned = inertia.T - inertia
    np.testing.assert_allclose(turned.evaluate(*state), 0, atol=1e-14)
    assert np.all(vectors.inertia("rotor").dt("rotor").express() == sp.zeros(3, 3))


def test_inertia_about_points() -> None:
    vectors = cd.vectors(cd.derive(double_pendulum()))
    assert_equal(vectors.inertia("lower").express("lower"), sp.diag(1, 1, 0) * m * l**2 / 12)
    assert_equal(
        vectors.inertia("lower", "lower").express("lower"), sp.diag(1, 1, 0) * m * l**2 / 3
    )
    assert_equal(vectors.inertia("lower", "tip").express("lower"), sp.diag(1, 1, 0) * m * l**2 / 3)
    # about a point of another body: parallel axes, told by the trace
    d = vectors.center_of_mass("lower", wrt="ground")
    trace = vectors.inertia("lower").trace() + 2 * m * d.dot(d)
    assert sp.simplify(vectors.inertia("lower", "ground").trace() - trace) == 0


SPATIAL = {
    "free": lambda: cd.Free(),
    "euler": lambda: cd.Spherical(rotation="ZXZ"),
    "universal": lambda: cd.Universal(),
    "screw": lambda: cd.Screw("z", pitch=0.1),
    "cylindrical": lambda: cd.Cylindrical("x"),
}


@pytest.mark.parametrize("kind", SPATIAL)
def test_numbers_of_the_compiled_model(kind: str) -> None:
    scene = cd.Scene("spatial")
    first = scene.body("first", mass=1.0, com=(0.1, 0.2, 0), inertia=(0.1, 0.2, 0.25))
    second = scene.body("second", mass=2.0, com=(0, 0.1, 0.3), inertia=(0.3, 0.2, 0.25))
    scene.joint("a", SPATIAL[kind](), scene.ground.at(0.1, 0, 0.2), first)
    scene.joint("b", cd.Revolute((0, 0.6, 0.8)), first.at(0.3, 0.1, 0), second)
    second.at(0.2, -0.1, 0.4, rotation=("XYZ", 0.3, 0.2, 0.1), name="sensor")
    equations = cd.derive(scene)
    model, vectors = cd.compile(equations), cd.vectors(equations)
    x = model.random_state(np.random.default_rng(5))
    q, u = x[: model.nq], x[model.nq : model.nq + model.nu]
    udot = model.forward_dynamics(q, u)
    twist, rate = model.velocity("sensor", q, u), model.acceleration("sensor", q, u, udot)
    expected = {
        "position": model.pose("sensor", q)[:3, 3],
        "angular_velocity": twist[:3],
        "velocity": twist[3:],
        "angular_acceleration": rate[:3],
        "acceleration": rate[3:],
    }
    for name, value in expected.items():
        vector = getattr(vectors, name)("sensor")
        np.testing.assert_allclose(vector.evaluate(q, u, udot), value, rtol=1e-11, atol=1e-11)
    com = sum(
        (vectors.mass(b) * vectors.center_of_mass(b) for b in (first, second)),
        start=vectors.vector((0, 0, 0)),
    )
    np.testing.assert_allclose((com / 3).evaluate(q), model.com(q), rtol=1e-12, atol=1e-12)


def test_path_vectors_and_augmented_bodies() -> None:
    equations = cd.derive(gimbal())
    vectors = cd.vectors(equations)
    path = vectors.path_vectors("sensor")
    assert list(path) == ["ground", "slide", "ring", "cradle", "rotor"]
    total = sum(path.values(), start=vectors.vector((0, 0, 0)))
    assert_equal((total - vectors.position("sensor")).express(), sp.zeros(3, 1))
    bodies = vectors.augmented_bodies()
    # the barycenter of the ring carries cradle and rotor where its outboard joint is
    q = [0.3, 0.4, 0.7, -0.5]
    arm = np.array([0.5, 0, 0.1])
    expected = (2.0 * np.array([0.1, 0, 0.2]) + 4.0 * arm) / 6.0
    barycenter = bodies["ring"].barycenter.evaluate(q, frame="ring")
    np.testing.assert_allclose(barycenter, expected, rtol=1e-14)


def test_kinetic_energy_of_augmented_bodies() -> None:
    """Of a tree of turning joints on the ground, by Roberson and Schwertassek's tensors K_ij."""
    scene = double_pendulum()
    equations = cd.derive(scene)
    vectors = cd.vectors(equations)
    bodies = vectors.augmented_bodies()
    assert bodies["upper"].mass == 2 * m
    assert_equal(bodies["upper"].barycenter.express("upper"), [0, 0, -3 * l / 4])
    assert_equal(bodies["upper"].inertia.express("upper"), sp.diag(1, 1, 0) * m * l**2 * 4 / 3)
    spins = {name: vectors.angular_velocity(name) for name in bodies}
    energy = sum(
        (spins[name].dot(body.inertia.dot(spins[name])) / 2 for name, body in bodies.items()),
        start=sp.Integer(0),
    )
    d = vectors.path_vectors("lower")["upper"]
    b = bodies["lower"].mass * bodies["lower"].barycenter
    pair = d.dot(b) * vectors.identity - b.outer(d)
    energy += spins["upper"].dot(pair.dot(spins["lower"]))
    assert_equal(sp.hessian(energy, [u1, u2]), equations.mass_matrix)


def test_prescribed_and_chosen_speeds() -> None:
    scene = cd.Scene("prescribed")
    turntable = scene.body("turntable", mass=1.0, inertia=(1, 1, 1))
    slider = scene.body("slider", mass=1.0)
    scene.joint("turn", cd.Revolute("z"), scene.ground, turntable, prescribed=cd.t**2)
    scene.joint("slide", cd.Prismatic("x"), turntable, slider)
    t, x, v, a = sp.symbols("t slide slide.u slide.udot")
    vectors = cd.vectors(cd.derive(scene))
    # Coriolis and centrifugal terms of polar coordinates: omega = 2 t
    assert_equal(
        vectors.acceleration("slider").express("turntable"),
        [a - x * 4 * t**2, 2 * x + 4 * t * v, 0],
    )
    pendulum = double_pendulum()
    first, second = pendulum.u("shoulder"), pendulum.u("elbow")
    chosen = cd.derive(pendulum, speeds={"first": first, "total": first + second})
    omega = cd.vectors(chosen).angular_acceleration("lower").express()
    assert_equal(omega, [0, sp.Symbol(chosen.blocks["udot"].entries[1]), 0])


def test_scalars_and_outputs() -> None:
    scene = double_pendulum()
    vectors = cd.vectors(cd.derive(scene))
    assert scene.q("elbow") == q2
    assert scene.u("shoulder") == u1
    vectors_sum = vectors.position("tip") * (2 * sp.Symbol("m")) / sp.Symbol("m")
    assert_equal(vectors_sum.express("lower"), 2 * vectors.position("tip").express("lower"))
    # in the names that the scene takes: outputs of the model
    scene.q("shoulder"), scene.u("elbow")
    scene.output("height", vectors.position("tip").express()[2])
    scene.output("speed", vectors.velocity("tip").magnitude())
    model = cd.compile(scene)
    state = ([0.3, 0.4], [1.0, -0.5])
    velocity = model.velocity("tip", *state)[3:]
    expected = [model.pose("tip", state[0])[2, 3], np.linalg.norm(velocity)]
    np.testing.assert_allclose(model.outputs(*state), expected, rtol=1e-12)
    batch = vectors.velocity("tip").evaluate(np.tile(state[0], (3, 1)), np.tile(state[1], (3, 1)))
    np.testing.assert_allclose(batch, np.tile(velocity, (3, 1)), rtol=1e-12)
    longer = vectors.position("tip").evaluate([0.0, 0.0], parameters={"l": 2.0})
    np.testing.assert_allclose(longer, [0, 0, -4])


def test_long_components_are_counted_not_written() -> None:
    scene = cd.Scene("chain")
    place = scene.ground
    for k in range(3):
        body = scene.body(f"body{k}", mass=1.0, inertia=(1, 1, 1))
        scene.joint(f"joint{k}", cd.Spherical(), place, body)
        place = body.at(0.1, 0.2, 0.3)
    vectors = cd.vectors(cd.derive(scene))
    rate = vectors.acceleration("body2")
    product = rate.cross(vectors.velocity("body2")).cross(rate)
    assert "operations] in body" in repr(product)
    with pytest.raises(cd.DerivationError, match=r"too long to write out.*\.evaluate"):
        product.express()


def test_refusals_name_the_cure() -> None:
    scene = double_pendulum()
    vectors = cd.vectors(cd.derive(scene))
    with pytest.raises(cd.ArgumentError, match="Did you mean 'tip'"):
        vectors.position("tipp")
    with pytest.raises(cd.ArgumentError, match="no moving body 'tip'"):
        vectors.inertia("tip")
    with pytest.raises(cd.DerivationError, match=r"'shoulder\.udot'.*differentiate fewer times"):
        vectors.acceleration("tip").dt()
    with pytest.raises(cd.ArgumentError, match="two calls"):
        vectors.position("tip") + cd.vectors(cd.derive(scene)).position("tip")
    with pytest.raises(cd.ArgumentError, match="reads block 'u'"):
        vectors.velocity("tip").evaluate([0.1, 0.2])
    with pytest.raises(cd.ArgumentError, match="no parameter 'k'"):
        vectors.position("tip").evaluate([0.1, 0.2], parameters={"k": 1.0})
    with pytest.raises(cd.ArgumentError, match=r"give cd\.derive\(scene\)"):
        cd.vectors(scene)
    with pytest.raises(cd.ArgumentError, match=r"q has shape \(1,\), expected \(\.\.\., 2\)"):
        vectors.position("tip").evaluate([0.1])
    with pytest.raises(cd.ArgumentError, match="3 components"):
        vectors.vector((1, 2))
    # SymPy would run text as Python
    for act in (vectors.position("tip").__mul__, lambda text: vectors.vector((text, 0, 0))):
        with pytest.raises(cd.ArgumentError, match="number or a SymPy expression, not '1/0'"):
            act("1/0")
    with pytest.raises(TypeError):
        vectors.position("tip") * vectors.position("tip")
