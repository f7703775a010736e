"""Flexible parts that are hard, small enough for a formula to say what they do."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np

import cardan as cd
from mechanisms.machines import MACHINES

from .case import METHODS, UNDAMPED, Case, Cell, Never, kind, table

# bearings, wheels: an inertia so small that the rods are springs
LIGHT = {"rhoA": 1e-6, "rhoI": 1e-9}


def slender() -> cd.Scene:
    """A mass on a rod of which EA L^2 / EI is 1e12."""
    scene = cd.Scene("slender", gravity=(0, 0, 0))
    tip = scene.body("tip", mass=1.0, inertia=(1e-9, 1e-9, 1e-9), pose=(1, 0, 0))
    section = cd.section.general(EA=1e12, GA=1e12, GJ=1.0, EI=1.0, **LIGHT)
    scene.beam("rod", scene.ground, tip, section, cd.material(damping=1e-7), elements=8)
    scene.output("aside", tip.position()[2])
    return scene


def slender_error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Error over the amplitude."""
    rate = np.sqrt(3.0)
    return float(np.abs(motion["aside"] * rate / 1e-4 - np.sin(rate * motion.t)).max())


def spinning() -> cd.Scene:
    """A mass on a light blade that turns as fast as it would vibrate at rest."""
    scene = cd.Scene("spinning", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=1.0, inertia=(1.0, 1.0, 1.0))
    scene.joint("drive", cd.Revolute("z"), scene.ground, hub, prescribed=SPIN * cd.t)
    tip = scene.body("tip", mass=1.0, inertia=(1e-9, 1e-9, 1e-9), pose=(1, 0, 0))
    section = cd.section.general(EA=1e8, GA=1e8, GJ=1e3, EI=1.0, **LIGHT)
    scene.beam("blade", hub, tip, section, cd.material(damping=1e-6), elements=8)
    scene.output("flap", tip.position()[2])
    return scene


SPIN = np.sqrt(3.0)


def spinning_error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Error over the amplitude: the pull m SPIN^2 L stiffens the blade as a beam-column."""
    rate = np.sqrt(SPIN**2 / (1 - np.tanh(SPIN) / SPIN))
    return float(np.abs(motion["flap"] * rate / 1e-3 - np.sin(rate * motion.t)).max())


def whirling() -> cd.Scene:
    """A disk amid a light shaft with damping inside, at 1.3 times the limit of stability."""
    scene = cd.Scene("whirling", gravity=(0, 0, 0))
    drum = scene.body("drum", mass=0.1, inertia=(1e-3, 1e-3, 1e-3))
    disk = scene.body("disk", mass=2.0, inertia=(4e-3, 2e-3, 2e-3), pose=(0.3, 0, 0))
    end = scene.body("end", mass=0.1, inertia=(1e-3, 1e-3, 1e-3))
    scene.joint("bearing", cd.Revolute("x"), scene.ground, drum, prescribed=SPEED * cd.t)
    scene.joint("other", cd.Cylindrical("x"), scene.ground.at(0.6, 0, 0), end)
    stiff = {"EA": 1e8, "GA": 1e9, "GJ": 1e3, "EI": BENDING}
    section = cd.section.general(**stiff, rhoA=1e-4, rhoI=1e-8)
    loss = cd.material(damping=LOSS)
    for name, ends in (("near", (drum, disk)), ("far", (disk, end))):
        scene.beam(name, *ends, section, loss, elements=1)
    _, vy, vz = disk.velocity()
    scene.force("air", cd.Force(disk, (0, -OUTER * vy, -OUTER * vz)))
    scene.output("y", disk.position()[1])
    scene.output("z", disk.position()[2])
    return scene


BENDING, LOSS, OUTER = 98.0, 1e-4, 20.0
K = 192 * BENDING / 0.6**3
SPEED = 1.3 * np.sqrt(K / 2) * (1 + OUTER / (LOSS * K))


def whirling_error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Error over the largest radius."""
    inner = LOSS * K
    a, b = np.roots([2.0, OUTER + inner, K - 1j * inner * SPEED])
    w = [0.002 * (np.exp(a * t) - np.exp(b * t)) / (a - b) for t in (motion.t, 0.5)]
    return float(np.abs(motion["y"] + 1j * motion["z"] - w[0]).max() / np.abs(w[1]))


def torsion(scene: cd.Scene, disk: Any) -> None:
    """A rod of 8 N m / rad from the ground to a disk."""
    section = cd.section.general(EA=1e6, GA=1e6, GJ=8.0, EI=1e3, **LIGHT)
    scene.beam("rod", scene.ground, disk, section, elements=1)


def latched() -> cd.Scene:
    """A wheel that a torque turns, caught by the disk at the end of a rod."""
    scene = cd.Scene("latched", gravity=(0, 0, 0))
    disk = scene.body("disk", mass=1.0, inertia=(0.3, 0.2, 0.2))
    scene.joint("bearing", cd.Revolute("x"), scene.ground.at(1, 0, 0), disk)
    wheel = scene.body("wheel", mass=1.0, inertia=(0.2, 0.2, 0.2))
    scene.joint("axle", cd.Revolute("x"), disk, wheel)
    torsion(scene, disk)
    scene.force("load", cd.Torque(wheel, (0.4, 0, 0)))
    scene.force("latch", cd.Lock("axle", when=1 - scene.q("axle")))
    return scene


def latched_error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Error of the angle of the disk [rad]."""
    late, rate = np.maximum(motion.t - 1.0, 0), 4.0
    # the wheel turns by 1 rad in 1 s; both go on with two fifths of its 2 rad/s
    angle = 0.8 / rate * np.sin(rate * late) + 0.05 * (1 - np.cos(rate * late))
    return float(np.abs(motion["bearing"] - angle).max())


def stopped() -> cd.Scene:
    """A disk on a twisted rod that hits a stop where the rod is straight."""
    scene = cd.Scene("stopped", gravity=(0, 0, 0))
    disk = scene.body("disk", mass=1.0, inertia=(0.5, 0.3, 0.3))
    scene.joint("bearing", cd.Revolute("x"), scene.ground.at(1, 0, 0), disk)
    torsion(scene, disk)
    scene.force("stop", cd.Stop("bearing", upper=0.0, restitution=0.5))
    return scene


def stopped_error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Error of the angle [rad]: half swings, each half as wide as the one before it."""
    phase = 4.0 * motion.t + np.pi / 2
    swing = np.floor(phase / np.pi)
    angle = -0.5 * 0.5**swing * np.sin(phase - np.pi * swing)
    return float(np.abs(motion["bearing"] - angle).max())


def snapping() -> cd.Scene:
    """A mass that falls on a cable, slack at first."""
    scene = cd.Scene("snapping", gravity=(0, 0, -9.81))
    mass = scene.body("mass", mass=1.0, inertia=(1e-3, 1e-3, 1e-3))
    scene.joint("fall", cd.Prismatic("z"), scene.ground, mass, q0=-0.5)
    scene.cable("rope", scene.ground, mass, EA=1e4, rhoA=0, length=1.0, elements=1)
    return scene


def snapping_error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Error of the height [m]: free fall, half a vibration, free flight, in turn."""
    g, rate, fall = 9.81, 100.0, np.sqrt(1 / 9.81)
    # taut from -1 on: the mass swings about the place where the rope carries it
    speed, sag = g * fall, g / rate**2
    pull = 2 * (np.pi - np.arctan2(speed, sag * rate)) / rate
    t = np.mod(motion.t + fall, 2 * fall + pull) - fall
    held = t - fall
    down = sag * (1 - np.cos(rate * held)) + speed / rate * np.sin(rate * held)
    height = np.where(t <= fall, -0.5 - g * t**2 / 2, -1 - down)
    return float(np.abs(motion["fall"] - height).max())


def driven() -> cd.Scene:
    """A crank at 50 rad/s, a stiff rod without damping, a slider."""
    scene = cd.Scene("driven", gravity=(0, 0, 0))
    crank = scene.body("crank", mass=1.0, inertia=(1e-2, 1e-2, 1e-2))
    slider = scene.body("slider", mass=1.0, inertia=(1e-3, 1e-3, 1e-3))
    scene.joint("drive", cd.Revolute("z"), scene.ground, crank, prescribed=50 * cd.t)
    scene.joint("guide", cd.Prismatic("x"), scene.ground.at(0.4, 0, 0), slider)
    section = cd.section.general(EA=1e10, GA=1e10, GJ=1e6, EI=1e6, **LIGHT)
    hinges = {"release_start": "rz", "release_end": "rz"}
    scene.beam("rod", crank.at(0.1, 0, 0), slider, section, elements=1, **hinges)
    return scene


def driven_error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Error of the slider [m]; the rod gives by some 1e-8."""
    angle = 50 * motion.t
    place = 0.1 * np.cos(angle) + np.sqrt(0.09 - (0.1 * np.sin(angle)) ** 2)
    return float(np.abs(motion["guide"] - (place - 0.4)).max())


def parallel() -> cd.Scene:
    """Two equal cranks with an elastic coupler, in line twice in a turn."""
    scene = cd.Scene("parallel", gravity=(0, 0, 0))
    first = scene.body("first", mass=1.0, inertia=(0.1, 0.1, 0.1))
    second = scene.body("second", mass=1.0, inertia=(0.1, 0.1, 0.1))
    scene.joint("A", cd.Revolute("z"), scene.ground, first, prescribed=5 * cd.t)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(0.5, 0, 0), second)
    section = cd.section.general(EA=1e5, GA=1e5, GJ=1e3, EI=1e3, **LIGHT)
    hinges = {"release_start": "rz", "release_end": "rz"}
    ends = (first.at(0.2, 0, 0), second.at(0.2, 0, 0))
    scene.beam("coupler", *ends, section, elements=1, **hinges)
    return scene


def parallel_error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Angle by which the second crank leaves the first [rad]."""
    return float(np.abs(motion["D"] - 5 * motion.t).max())


def flying() -> cd.Scene:
    """Two masses on a rod that vibrates along itself and flies at 10 km/s."""
    scene = cd.Scene("flying", gravity=(0, 0, 0))
    small = {"mass": 1.0, "inertia": (0.1, 0.1, 0.1)}
    front, back = scene.body("front", **small, pose=(1, 0, 0)), scene.body("back", **small)
    scene.joint("drift", cd.Free(), scene.ground, back)
    section = cd.section.general(EA=200.0, GA=200.0, GJ=10.0, EI=10.0, **LIGHT)
    scene.beam("rod", back, front, section, elements=1)
    scene.output("stretch", front.position()[0] - back.position()[0] - 1)
    return scene


def flying_error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Error of the stretch over its amplitude."""
    return float(np.abs(motion["stretch"] / 0.01 - np.sin(20 * motion.t)).max())


@cache
def unfolded() -> Any:
    """The folded panels with a node for every body, at a tight tolerance."""
    array = MACHINES["folded_array"]
    model = cd.compile(array.build(), coordinates="absolute")
    return model.simulate(np.linspace(0, array.end, 51), method="Radau", rtol=1e-9, q=array.q)


def panels_error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Largest error of a hinge [rad] and of the tip [m]."""
    known, names = unfolded(), MACHINES["folded_array"].watched
    return float(max(np.abs(motion[name] - known[name]).max() for name in names))


SLOW = Never("too slow here: its steps follow the vibrations of the elements")


def bounds(
    fine: float, damped: float, step: float, fast: bool = False, **others: Cell | Never
) -> dict[str, Any]:
    """Bounds of methods of high order, and of those of order 2 and of fixed steps.

    Args:
        fine: DOP853, RK45, RKMK853, RKMK45, Radau, Rosenbrock, RK4, RKMK4.
        damped: GeneralizedAlpha, HHT, EnergyMidpoint; Newmark takes no constraints.
        step: Of the methods of order 2 and of fixed steps [s].
        fast: Whether vibrations are so fast that only Radau and the damped methods are measured.
        others: Methods with a cell of their own.
    """
    cells: dict[str, float | Cell | Never] = {}
    for name in METHODS:
        order_two = kind(name) in ("damped", "energy")
        bound = damped if order_two else fine
        given = order_two or kind(name) == "fixed"
        cells[name] = Cell(bound, {"step": step}) if given else Cell(bound)
        if fast and name not in ("Radau", "GeneralizedAlpha", "HHT"):
            cells[name] = SLOW
    return {"expected": table(cells | {"Newmark": UNDAMPED} | others), "step": step}


TOLERANCES = {"rtol": 1e-7, "atol": 1e-9}
UNSOLVED = Cell(0.0, {"step": 5e-3}, "not_solved")
# steps that are not stable end where nothing can be solved any more
FAILED = Cell(0.0, {"step": 1e-4}, "model_failed")
TOO_LONG = Cell(0.0, {"step": 1e-4}, "step_too_long")
PANELS = MACHINES["folded_array"]


def at(end: float) -> np.ndarray:
    """Times of comparison."""
    return np.linspace(0, end, 51)


CASES = (
    Case(
        name="slender rod",
        hard="a mass on a rod of slenderness 1e6 in bending, EA L^2 / EI = 1e12, 8 elements",
        oracle="closed form of a mass on a spring of 3 EI / L^3; error over the amplitude",
        advice="use `Radau`, and damping in the rod: it follows vibrations that nothing damps",
        build=slender,
        t=at(5.0),
        start={"u": {"tip.u.pz": 1e-4}},
        error=slender_error,
        fine=TOLERANCES,
        **bounds(
            1e-4, 1e-2, 5e-3, True, GeneralizedAlpha=UNSOLVED, HHT=UNSOLVED, EnergyMidpoint=UNSOLVED
        ),
    ),
    Case(
        name="spinning blade",
        hard="a mass flaps on a blade that turns at its first frequency and stretches at the start",
        oracle="closed form of a beam-column under the pull m Omega^2 L; error over the amplitude",
        advice="use `Radau`: long steps of the other methods do not pass the first stretch",
        build=spinning,
        t=at(5.0),
        start={"u": {"tip.u.pz": 1e-3}},
        error=spinning_error,
        fine=TOLERANCES,
        **bounds(1e-3, 1e-3, 2e-4, True, EnergyMidpoint=SLOW),
    ),
    Case(
        name="shaft above its limit",
        hard="a disk on a shaft with internal damping whirls at 1.3 times the limit of stability",
        oracle="Jeffcott's linear equation, which holds to 1e-3 here; error over the last radius",
        advice="use `Radau`, or `GeneralizedAlpha` with small steps: coarse ones damp the whirl",
        build=whirling,
        t=at(0.5),
        start={"u": {"disk.u.py": 0.002}},
        error=whirling_error,
        fine=TOLERANCES,
        slow=("DOP853", "RK45", "RKMK853", "RKMK45", "Rosenbrock"),
        **bounds(5e-3, 2e-2, 1e-4, RK4=FAILED, RKMK4=TOO_LONG),
    ),
    Case(
        name="latch under load",
        hard="a wheel under a torque is caught by a disk at the end of an elastic rod",
        oracle="closed form, momentum kept by the latch; error of the angle of the disk [rad]",
        advice="take any adaptive method",
        build=latched,
        t=at(2.5),
        start={},
        error=latched_error,
        fine=TOLERANCES,
        **bounds(1e-6, 1e-4, 2e-3),
    ),
    Case(
        name="flexible stop",
        hard="a disk on a twisted rod hits a stop three times, each time with half its speed left",
        oracle="closed form of half swings; error of the angle [rad]",
        advice="take any adaptive method",
        build=stopped,
        t=at(2.0),
        start={"q": {"bearing": -0.5}},
        error=stopped_error,
        fine=TOLERANCES,
        **bounds(1e-6, 1e-4, 2e-3),
    ),
    Case(
        name="slack cable",
        hard="a mass falls on a slack cable, which snaps taut and throws it back, three times",
        oracle="closed form, free fall and half a vibration in turn; error of the height [m]",
        advice="use small tolerances: the force has a kink that no event announces",
        build=snapping,
        t=at(2.0),
        start={},
        error=snapping_error,
        fine=TOLERANCES,
        **bounds(1e-3, 1e-2, 1e-3, Newmark=Cell(1e-2, {"step": 1e-3})),
    ),
    Case(
        name="stiff rod",
        hard="a crank at 50 rad/s drives a slider by an undamped rod that vibrates at 1e5 rad/s",
        oracle="a rigid rod, within 2e-8; error of the place of the slider [m]",
        advice="use `Radau` or `GeneralizedAlpha`, which pass over the vibration",
        build=driven,
        t=at(0.3),
        start={},
        error=driven_error,
        fine=TOLERANCES,
        **bounds(2e-7, 1e-6, 1e-4, True, EnergyMidpoint=Cell(0.0, {"step": 1e-4}, "not_solved")),
    ),
    Case(
        name="singular loop with a beam",
        hard="two equal cranks with an elastic coupler come into line four times and start there",
        oracle="both turn alike; angle by which one leaves the other [rad]",
        advice="name the speeds of both cranks at the start, where the loop has two branches",
        build=parallel,
        t=at(2.6),
        start={"u": {"D": 5.0}},
        error=parallel_error,
        fine=TOLERANCES,
        slow=("EnergyMidpoint",),
        **bounds(1e-6, 1e-5, 2e-3, True, EnergyMidpoint=Cell(1e-3, {"step": 2e-3}, "not_solved")),
    ),
    Case(
        name="fast flight",
        hard="an elastic rod vibrates with 0.1 m/s at its ends while it flies with 10 km/s",
        oracle="closed form of two masses on a spring; error of the stretch over its amplitude",
        advice="set rtol far below small speeds over large ones; at 1e-7 `Radau` errs by 0.4",
        build=flying,
        t=at(1.0),
        start={"u": {"drift": (0, 0, 0, 1e4 - 0.1, 0, 0), "front": (0, 0, 0, 1e4 + 0.1, 0, 0)}},
        error=flying_error,
        fine={"rtol": 1e-11, "atol": 1e-13},
        **bounds(1e-4, 5e-3, 1e-3, Newmark=Cell(5e-3, {"step": 1e-3})),
    ),
    Case(
        name="folded panels",
        hard="three elastic panels unfold, latch and go on vibrating, the hinges between panels",
        oracle="Radau at rtol 1e-9 with a node for every body; error of hinges [rad] and tip [m]",
        advice="use `Radau`; the latches excite vibrations that methods of order 2 damp",
        build=PANELS.build,
        t=at(PANELS.end),
        start={"q": PANELS.q},
        error=panels_error,
        fine=TOLERANCES,
        slow=("EnergyMidpoint",),
        **bounds(1e-5, 2e-3, 5e-4, True, EnergyMidpoint=Cell(2e-3, {"step": 5e-4})),
    ),
)
