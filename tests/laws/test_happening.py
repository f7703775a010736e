"""Elements with modes and states of their own against closed forms and independent solutions."""

from __future__ import annotations

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp

import cardan as cd
from mechanisms import closed_planar
from table import each

G = 9.81
FINE = {"rtol": 1e-11, "atol": 1e-12}


def slider(name: str, axis: str = "x", gravity: float = 0.0, mass: float = 1.0) -> cd.Scene:
    """A mass on a rail."""
    scene = cd.Scene(name, gravity=(0, 0, -gravity))
    scene.joint("x", cd.Prismatic(axis), scene.ground, scene.body("block", mass=mass))
    return scene


def test_dry_friction_takes_the_same_amplitude_every_half_cycle() -> None:
    m, k, friction = 2.0, 50.0, 1.5
    scene = slider("oscillator", mass=m)
    scene.force("spring", cd.JointSpring("x", stiffness=k))
    scene.force("rail", cd.Friction("x", coulomb=friction))
    motion = cd.compile(scene).simulate(12.0, q={"x": 1.0}, **FINE)
    half = np.pi * np.sqrt(m / k)
    stops = [event for event in motion.events if event.name == "rail.stop"]
    # until the spring is too weak to pull it loose
    count = int(np.ceil((1.0 - friction / k) / (2 * friction / k)))
    assert np.allclose([e.t for e in stops], half * np.arange(1, count + 1), rtol=0, atol=1e-9)
    places = [float(motion.at(event.t)[0]) for event in stops]
    wanted = [(-1) ** n * (1.0 - 2 * n * friction / k) for n in range(1, count + 1)]
    assert places == pytest.approx(wanted, abs=1e-9)
    assert motion["x"][-1] == pytest.approx(wanted[-1], abs=1e-9)
    assert abs(motion["x.u"][-1]) < 1e-12
    assert motion["rail"][-1] == 2
    assert np.abs(motion.energy_residual).max() < 1e-8


def test_a_ball_bounces_until_it_settles() -> None:
    restitution, settle = 0.7, 1e-3
    scene = slider("ball", "z", G, mass=2.0)
    scene.force("floor", cd.Stop("x", lower=0.0, restitution=restitution, settle=settle))
    motion = cd.compile(scene).simulate(10.0, q={"x": 1.0}, **FINE)
    times, speed = [np.sqrt(2 / G)], np.sqrt(2 * G)
    while speed > settle:
        speed *= restitution
        times.append(times[-1] + 2 * speed / G)
    hits = [event.t for event in motion.events if event.name == "floor.lower"]
    # the last one is below the speed at which it stays
    assert np.allclose(hits, times, rtol=0, atol=1e-11)
    assert motion["floor"][-1] == -1
    assert np.abs(motion.x[-1]).max() < 1e-12


def four_bar(stop: float) -> cd.Scene:
    """A crank-rocker whose rocker meets a stop."""
    scene = cd.Scene("stopped", gravity=(0, 0, -G))
    bars = {}
    for name, length in (("crank", 0.3), ("coupler", 0.9), ("rocker", 0.7)):
        inertia = cd.inertia.rod(length, length, axis="x")
        bars[name] = scene.body(name, mass=length, com=(length / 2, 0, 0), inertia=inertia)
    scene.joint("A", cd.Revolute("y"), scene.ground, bars["crank"])
    scene.joint("B", cd.Revolute("y"), bars["crank"].at(0.3, 0, 0), bars["coupler"])
    scene.joint("D", cd.Revolute("y"), scene.ground.at(0.9, 0, 0), bars["rocker"])
    scene.joint("C", cd.Revolute("y"), bars["coupler"].at(0.9, 0, 0), bars["rocker"].at(0.7, 0, 0))
    scene.force("buffer", cd.Stop("D", upper=stop, restitution=0.4))
    return scene


def test_an_impact_goes_through_a_closed_loop() -> None:
    model = cd.compile(four_bar(-1.2))
    start = model.assemble({"A": 0.5}).x
    q = start[: model.nq]
    u = model.close_velocity(q, [1.0, 0.0, 0.0])[: model.nu]
    rocker = model.speeds.index("D.u")
    u *= np.sign(u[rocker])
    fired = {name: float(name == "buffer.upper") for name in model.event_names}
    behind = model.transition(q, u, fired)[: model.nu]
    # M du = Gt P + J P', G du = 0, J u+ = -e J u
    n = model.nu
    G_all = model.constraint_jacobian(q)
    rows = [i for i, name in enumerate(model.multipliers_of) if not name.startswith("buffer")]
    full = np.vstack([G_all[rows], np.eye(n)[rocker]])
    kkt = np.block([[model.mass_matrix(q), -full.T], [full, np.zeros((len(full),) * 2)]])
    right = np.concatenate([np.zeros(n + len(rows)), [-1.4 * u[rocker]]])
    wanted = u + np.linalg.solve(kkt, right)[:n]
    assert behind == pytest.approx(wanted, abs=1e-12)
    assert behind[rocker] == pytest.approx(-0.4 * u[rocker], abs=1e-12)


def test_two_stops_hit_at_once_share_the_impulse() -> None:
    """A block that falls flat on two feet: both stay, or both bounce."""
    scene = cd.Scene("feet", gravity=(0, 0, -G))
    block = scene.body("block", mass=2.0, inertia=(0.1, 0.2, 0.3))
    scene.joint("leg", cd.Prismatic("z"), scene.ground, block)
    other = scene.body("other", mass=1.0)
    scene.joint("knee", cd.Prismatic("z"), block, other)
    scene.force("low", cd.Stop("leg", lower=0.0, restitution=0.0))
    scene.force("high", cd.Stop("knee", lower=0.0, restitution=0.0))
    model = cd.compile(scene)
    motion = model.simulate(2.0, q={"leg": 0.5, "knee": 0.5}, **FINE)
    assert np.abs(motion.x[-1]).max() < 1e-10
    assert motion["low"][-1] == motion["high"][-1] == -1
    # the lower one bears both
    assert model.multipliers(motion.q[-1], motion.u[-1], s=motion.s[-1]) == pytest.approx(
        [3.0 * G, 1.0 * G]
    )


def test_a_lock_keeps_the_momentum_it_does_not_bear() -> None:
    scene = cd.Scene("lock", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=2.0, inertia=(1.0, 1.0, 0.5))
    panel = scene.body("panel", mass=1.0, com=(0.5, 0, 0), inertia=(0.1, 0.1, 0.2))
    scene.joint("base", cd.Revolute("z"), scene.ground, hub)
    scene.joint("hinge", cd.Revolute("z"), hub.at(1, 0, 0), panel)
    scene.force("latch", cd.Lock("hinge", when=0.4 - scene.q("hinge")))
    model = cd.compile(scene)
    motion = model.simulate(2.0, u={"base": 0.3, "hinge": 1.0}, **FINE)
    (event,) = motion.events
    momentum = model.momentum(motion.q, motion.u)[:, 2]
    assert np.ptp(momentum) < 1e-9
    assert motion["hinge"][-1] == pytest.approx(0.4, abs=1e-11)
    assert motion["hinge.u"][-1] == pytest.approx(0.0, abs=1e-14)
    # one rigid body from there on
    q = motion.q[-1]
    inertia = np.array([1.0, 0.0]) @ model.mass_matrix(q) @ np.array([1.0, 0.0])
    assert motion["base.u"][-1] == pytest.approx(momentum[0] / inertia, rel=1e-10)
    assert 0 < event.t < 2


def inclined(name: str, friction: bool) -> cd.Scene:
    """A cart on an inclined rail that carries a pendulum."""
    scene = cd.Scene(name, gravity=(0, 0, -G))
    cart = scene.body("cart", mass=1.0)
    arm = scene.body("arm", mass=2.5, com=(0.4, 0, 0), inertia=(1e-2, 5e-2, 6e-2))
    scene.joint("x", cd.Prismatic((1, 0, 0.3)), scene.ground, cart)
    scene.joint("h", cd.Revolute("y"), cart.at(0.1, 0, 0.05), arm)
    if friction:
        scene.force("rail", cd.Friction("x", mu=0.3))
        scene.force("pin", cd.Friction("h", mu=0.2, radius=0.05, static=0.4))
    return scene


@pytest.mark.parametrize("seed", range(4))
def test_friction_and_reaction_are_solved_for_together(seed: int) -> None:
    """Against a fixed point of reactions of the same system without friction."""
    model, free = cd.compile(inclined("rough", True)), cd.compile(inclined("smooth", False))
    rng = np.random.default_rng(seed)
    q, u = rng.uniform(-1, 1, 2), rng.uniform(-1, 1, 2)
    signs, size = np.sign(u), np.zeros(2)
    axes = {"x": np.array([1, 0, 0.3]) / np.hypot(1, 0.3), "h": np.array([0, 1.0, 0])}
    for _ in range(200):
        across = []
        for joint, axis in axes.items():
            force = free.reaction(joint, q, u, tau=-signs * size)[3:]
            across.append(np.linalg.norm(force - axis * (axis @ force)))
        size = np.array([0.3, 0.2 * 0.05]) * across
    wanted = free.forward_dynamics(q, u, tau=-signs * size)
    assert model.forward_dynamics(q, u) == pytest.approx(wanted, abs=1e-12)
    assert model.rhs(0.0, np.r_[q, u], s=signs)[2:] == pytest.approx(wanted, abs=1e-12)
    assert model.power(q, u) == pytest.approx(-size * abs(u), abs=1e-12)
    # and the other way round
    assert model.inverse_dynamics(q, u, wanted) == pytest.approx(np.zeros(2), abs=1e-12)


def test_a_run_ends_where_friction_has_no_unique_solution() -> None:
    """A heavy rod on a light cart: leaning enough, it wedges the cart."""
    scene = cd.Scene("wedge", gravity=(0, 0, -G))
    cart = scene.body("cart", mass=0.1)
    rod = scene.body("rod", mass=10.0, com=(0, 0, 1.0), inertia=(0.1, 0.1, 0.01))
    scene.joint("x", cd.Prismatic("x"), scene.ground, cart)
    scene.joint("h", cd.Revolute("y"), cart, rod)
    scene.force("rail", cd.Friction("x", mu=0.9))
    motion = cd.compile(scene).simulate(5.0, q={"h": 1.2}, u={"x": 50.0, "h": -4.0}, **FINE)
    assert motion.events[-1].name == "rail.jam"
    assert motion.status == "event"
    assert "'rail.jam'" in motion.message
    assert 0 < motion.t[-1] < 5
    # where mu |dR/dD| is 1, but for a thousandth
    model = cd.compile(scene)
    value = model.events(motion.q[-1], motion.u[-1], s=motion.s[-1])
    assert value[-1] == pytest.approx(0.0, abs=1e-8)


def test_a_contact_bounces_as_its_equation_says() -> None:
    m, k, c, radius = 0.5, 1e5, 0.3, 0.1
    scene = slider("hertz", "z", G, mass=m)
    ball = scene.bodies["block"]
    scene.force("floor", cd.Contact(ball, scene.ground, radius=radius, stiffness=k, damping=c))
    motion = cd.compile(scene).simulate(1.0, q={"x": 0.5}, **FINE)

    def falls(t: float, y: np.ndarray) -> list[float]:
        depth = max(0.0, radius - y[0])
        push = max(0.0, k * depth**1.5 * (1 - c * y[1]))
        return [y[1], push / m - G]

    wanted = solve_ivp(falls, (0, 1), [0.5, 0], rtol=1e-12, atol=1e-13, max_step=1e-3).y[:, -1]
    assert motion.x[-1] == pytest.approx(wanted, abs=1e-7)
    names = [event.name for event in motion.events]
    assert names[:3] == ["floor.touch", "floor.part", "floor.touch"][: len(names)]
    assert np.abs(motion.energy_residual).max() < 1e-8


@pytest.mark.parametrize("direction", ["down", "up", "both"])
def test_events_of_the_user_are_located(direction: str) -> None:
    """Zeros of a harmonic motion, ten times better than the tolerance asks."""
    errors = []
    for rtol in (1e-5, 1e-7, 1e-9):
        scene = slider("clock", mass=1.0)
        scene.force("spring", cd.JointSpring("x", stiffness=4.0))
        scene.force("zero", cd.Event(scene.q("x"), direction=direction))
        motion = cd.compile(scene).simulate(6.0, q={"x": 1.0}, rtol=rtol, atol=rtol)
        wanted = np.pi / 4 + np.pi / 2 * np.arange(4)
        wanted = {"down": wanted[::2], "up": wanted[1::2], "both": wanted}[direction]
        found = np.array([event.t for event in motion.events])
        assert len(found) == len(wanted[wanted < 6])
        errors.append(np.abs(found - wanted[: len(found)]).max())
        assert errors[-1] <= 10 * rtol
    assert errors[-1] < errors[0]


def test_a_watch_ends_the_run() -> None:
    scene = slider("fall", "z", G)
    scene.force("floor", cd.Event(scene.q("x") + 0.5, terminal=True))
    motion = cd.compile(scene).simulate(10.0, **FINE)
    assert motion.t[-1] == pytest.approx(np.sqrt(1.0 / G), abs=1e-12)
    assert motion.status == "event"


def test_stribeck_friction_falls_with_speed() -> None:
    friction = cd.Friction("x", coulomb=1.0, static=2.0, stribeck=0.3, viscous=0.5)
    scene = slider("stribeck")
    scene.force("rail", friction)
    model = cd.compile(scene)
    for v in (0.05, -0.4, 2.0):
        wanted = -np.sign(v) * (1 + np.exp(-((v / 0.3) ** 2))) - 0.5 * v
        assert model.applied_forces([0.0], [v]) == pytest.approx([wanted], rel=1e-14)


@each(
    ("make", "message"),
    [
        (lambda: cd.Friction("x"), "give either coulomb"),
        (lambda: cd.Friction("x", 1.0, mu=0.3), "give either coulomb"),
        (lambda: cd.Friction("x", 1.0, stribeck=0.1), "give static"),
        (lambda: cd.Friction("x", -1.0), "coulomb is -1"),
        (lambda: cd.Friction("x", 1.0, smooth=0.0), "smooth is 0"),
        (lambda: cd.Friction("x", mu=0.0), "mu is 0"),
        (lambda: cd.Friction("x", 2.0, static=1.0), "less than the 2 of sliding"),
        (lambda: cd.Controller.pid("x", 1.0, kd=2.0), "kd acts on rate"),
        (lambda: cd.Controller.pid("x", 1.0, kp=2.0, limit=-1.0), "limit is -1"),
        (lambda: cd.Friction("x", 1.0, radius=0.1), "radius goes with mu"),
        (lambda: cd.Stop("x"), "give lower or upper"),
        (lambda: cd.Stop("x", lower=1.0, upper=0.0), "must be below upper"),
        (lambda: cd.Stop("x", lower=1.0, restitution=1.5), r"give 0 \.\.\. 1"),
        (lambda: cd.Lock("x", when=1.0, strength=-2.0), "strength is -2"),
        (lambda: cd.Actuator("x", 1.0, lag=0.0), "lag is 0"),
        (lambda: cd.Actuator("x", 1.0, lag=1.0, limit=-1.0), "limit is -1"),
        (lambda: cd.Controller("x", states=("a",), force=1.0), "1 states, 0 changes"),
        (lambda: cd.Controller("x"), "go together"),
        (lambda: cd.Controller(force=1.0), "go together"),
        (lambda: cd.Controller(), "give a force with its joint"),
        (lambda: cd.Controller("x", force=1.0, sample=-1.0), "sample is -1"),
        (lambda: cd.Event(1.0, direction="left"), "direction='left' is unknown"),
        (lambda: cd.Event(1.0, terminal="end"), "terminal"),
        (lambda: cd.Contact("a", "b", radius=-1.0, stiffness=1.0), "radius is -1"),
    ],
)
def test_what_cannot_be_is_refused(make: object, message: str) -> None:
    with pytest.raises(cd.ModelError, match=message):
        make()  # type: ignore[operator]


def test_states_nobody_keeps_are_refused() -> None:
    scene = slider("lost")
    scene.output("y", scene.state("motor.force"))
    with pytest.raises(cd.ModelError, match=r"state\('motor.force'\)"):
        cd.derive(scene)


def test_saved_scenes_keep_their_elements(tmp_path: object) -> None:
    scene = slider("kept")
    x, v = scene.q("x"), scene.u("x")
    scene.force("rail", cd.Friction("x", coulomb=1 / (1 + 3 * sp.Abs(v)), static=1.0))
    scene.force("pid", cd.Controller.pid("x", x, v, kp=2.0, ki=1.0, limit=3.0, sample=0.01))
    scene.force("end", cd.Stop("x", lower=-1.0, upper=1.0, restitution=0.5))
    scene.output("sum", scene.state("pid.integral"))
    scene.save(f"{tmp_path}/kept.yaml")
    again = cd.load(f"{tmp_path}/kept.yaml")
    models = [cd.compile(s) for s in (scene, again)]
    one, two = (m.rhs(0.0, [0.3, -0.2], s=[1, 0.1, 0.2, 0]) for m in models)
    assert np.array_equal(one, two)


def rough_four_bar(friction: bool) -> cd.Scene:
    """A crank-rocker with bearings that its own reactions press."""
    scene = cd.Scene("rough" if friction else "smooth", gravity=(0, 0, -G))
    bars = {}
    for name, length in (("crank", 0.3), ("coupler", 0.9), ("rocker", 0.7)):
        inertia = cd.inertia.rod(length, length, axis="x")
        bars[name] = scene.body(name, mass=length, com=(length / 2, 0, 0), inertia=inertia)
    tip = bars["coupler"].at(0.9, 0, 0)
    scene.joint("A", cd.Revolute("y"), scene.ground, bars["crank"])
    scene.joint("B", cd.Revolute("y"), bars["crank"].at(0.3, 0, 0), bars["coupler"])
    scene.joint("D", cd.Revolute("y"), scene.ground.at(0.9, 0, 0), bars["rocker"])
    scene.joint("C", cd.Revolute("y"), tip, bars["rocker"].at(0.7, 0, 0), cut=True)
    if friction:
        scene.force("fa", cd.Friction("A", mu=0.2, radius=0.05))
        scene.force("fd", cd.Friction("D", mu=0.3, radius=0.05))
    return scene


@pytest.mark.parametrize("treatment", ["multipliers", "elimination", "null_space"])
def test_friction_of_reactions_in_a_closed_loop(treatment: str) -> None:
    """Against a fixed point of reactions; the rocker turns round where nothing can hold it."""
    model = cd.compile(cd.derive(rough_four_bar(True), constraints=treatment))
    free = cd.compile(cd.derive(rough_four_bar(False), constraints=treatment))
    q = free.assemble({"A": 0.5}).x[:3]
    u = free.close_velocity(q, [1.0, 0.0, 0.0])[:3]
    at = [free.speeds.index("A.u"), free.speeds.index("D.u")]
    signs, tau = np.sign(u[at]), np.zeros(3)
    for _ in range(100):
        across = [free.reaction(joint, q, u, tau=tau)[3:] * [1, 0, 1] for joint in "AD"]
        tau[at] = -signs * 0.05 * np.array([0.2, 0.3]) * np.linalg.norm(across, axis=1)
    wanted = free.forward_dynamics(q, u, tau=tau)
    assert model.forward_dynamics(q, u) == pytest.approx(wanted, abs=1e-11)
    motion = model.simulate(3.0, q={"A": 0.5}, u={"A": 2.0}, rtol=1e-8)
    assert motion.success
    assert len([event for event in motion.events if event.name == "fd.stop"]) > 3
    assert np.abs(motion.energy_residual).max() < 1e-6


@pytest.mark.parametrize("treatment", ["multipliers", "elimination", "null_space", "closed_form"])
def test_friction_turns_round_where_the_mechanism_has_a_dead_point(treatment: str) -> None:
    # the rocker rests there while the crank goes on: nothing can stick
    torque = 0.1
    scene = closed_planar.four_bar()
    scene.force("pivot", cd.Friction("D", coulomb=torque))
    model = cd.compile(cd.derive(scene, constraints=treatment))
    motion = model.simulate(1.0, q={"A": 1.0}, **FINE)
    assert motion.success, motion.message
    stops = [event for event in motion.events if event.name == "pivot.stop"]
    # the crank moves: no end of the motion itself
    at_dead_points = [event for event in stops if abs(event.x[model.nq]) > 1]
    assert len(at_dead_points) >= 3
    assert [event.s_after[0] for event in at_dead_points] == [-e.s[0] for e in at_dead_points]
    # Coulomb friction takes its torque times the way
    times = [0.0, *(event.t for event in stops), 1.0]
    cranks = motion.at(np.array(times))[:, 0]
    way = np.abs(np.diff([closed_planar.four_bar_angles(crank)["D"] for crank in cranks])).sum()
    assert motion.work["pivot"][-1] == pytest.approx(-torque * way, rel=1e-9)


def test_a_sliding_block_bounces_against_its_friction() -> None:
    scene = slider("buffer", mass=2.0)
    scene.force("end", cd.Stop("x", upper=1.0, restitution=0.5))
    scene.force("rail", cd.Friction("x", coulomb=1.0))
    motion = cd.compile(scene).simulate(3.0, u={"x": 2.0}, **FINE)
    # 0.5 m/s^2 on the way there, back with half of what is left, again 0.5 m/s^2
    back = 0.5 * np.sqrt(4.0 - 2 * 0.5)
    assert motion["x"][-1] == pytest.approx(1.0 - back**2 / (2 * 0.5), abs=1e-9)
    assert [e.name for e in motion.events] == ["end.upper", "rail.stop"]
    assert motion.events[0].s_after.tolist() == [0, -1]
    assert motion.events[1].t == pytest.approx((2 - 2 * back) / 0.5 + back / 0.5, abs=1e-9)
    assert np.abs(motion.energy_residual).max() < 1e-12


def test_no_run_starts_beyond_a_stop() -> None:
    scene = slider("under", "z", G)
    scene.force("floor", cd.Stop("x", lower=0.0, restitution=0.5))
    model = cd.compile(scene)
    for begin in (lambda: model.simulate(1.0, q=[-0.5]), lambda: model.stepper(q=[-0.5])):
        with pytest.raises(cd.ModelError, match=r"'x' starts beyond its lower stop \('floor'\)"):
            begin()
    assert model.simulate(1.0, q=[0.0]).success


def test_friction_of_a_bearing_needs_its_radius() -> None:
    scene = cd.Scene("bearing")
    scene.joint("hinge", cd.Revolute("y"), scene.ground, scene.body("a", mass=1, com=(1, 0, 0)))
    scene.force("pin", cd.Friction("hinge", mu=0.2))
    with pytest.raises(cd.ModelError, match="give radius="):
        cd.derive(scene)
