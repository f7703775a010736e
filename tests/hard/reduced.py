"""Superelements that are hard, small enough for a formula or a reference to say what they do."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
from scipy.linalg import eigh
from scipy.special import ellipj

import cardan as cd
from mechanisms.superelements import slider_crank
from superelements.components import reference

from .case import Case, Cell
from .flexible import LIGHT, SPIN, TOLERANCES, at, bounds, spinning_error

FAST_ROD = reference("slider_crank_superelement_A")["reference"]["rows"][:2]


def rod_error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Largest error of the angles of both ends of the rod against its chord [rad]."""
    ends = {"rod.pin.rz": "theta1", "rod.slider.rz": "theta2"}
    known = {name: [0.0, *(row[value] for row in FAST_ROD)] for name, value in ends.items()}
    return float(max(np.abs(motion[name] - known[name]).max() for name in ends))


def blade() -> cd.Scene:
    """The spinning blade of beams as one superelement with the stiffness that its spin gives it."""
    light = cd.Scene("blade", gravity=(0, 0, 0))
    tip = light.body("tip", mass=1.0, inertia=(1e-9, 1e-9, 1e-9), pose=(1, 0, 0))
    section = cd.section.general(EA=1e8, GA=1e8, GJ=1e3, EI=1.0, **LIGHT)
    light.beam("blade", (0, 0, 0), tip, section, cd.material(damping=1e-6), elements=8)
    ends = {"root": "blade.start", "tip": "tip"}
    record = cd.superelement.from_beams(
        light, "blade", ends, bodies=["tip"], modes=8, stiffening="root"
    )
    scene = cd.Scene("spinning", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=1.0, inertia=(1.0, 1.0, 1.0))
    scene.joint("drive", cd.Revolute("z"), scene.ground, hub, prescribed=SPIN * cd.t)
    one = scene.superelement("blade", record, {"root": hub}, frame="root", stiffening=True)
    scene.output("flap", one.at("tip").position()[2])
    return scene


SOUND, SIDE, RATE = 2e9, 0.125, 1e3


def rigid() -> cd.Scene:
    """A bar of 1 m and 1 kg that is nearly rigid, on a hinge with a soft spring."""
    free = cd.Scene("bar", gravity=(0, 0, 0))
    EA, square = SOUND**2, SIDE**2 / 12  # radius of gyration of the section
    section = cd.section.general(
        EA=EA, GA=0.4 * EA, GJ=0.8 * EA * square, EI=EA * square, rhoA=1.0, rhoI=square
    )
    free.beam("bar", (0, 0, 0), (1, 0, 0), section, elements=8)
    scene = cd.Scene("rigid", gravity=(0, 0, 0))
    record = cd.superelement.from_beams(free, "bar", modes=8, damping=0.05)
    bar = scene.superelement("bar", record, frame="start")
    scene.joint("hinge", cd.Revolute("y"), scene.ground, bar.at("start"))
    scene.force("spring", cd.JointSpring("hinge", stiffness=(1 / 3 + square) * RATE**2))
    return scene


def rigid_error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Error over the amplitude; the bar gives by a part of 1e-12."""
    return float(np.abs(motion["hinge"] / 0.1 - np.cos(RATE * motion.t)).max())


CRANK, COUPLER, TURNED = 0.3, 0.5, 1.0


def redundant() -> cd.Scene:
    """Two equal cranks with two couplers, one of them flexible, that swing under gravity."""
    free = cd.Scene("rod", gravity=(0, 0, 0))
    section = cd.section.general(EA=1e7, GA=1e7, GJ=1e3, EI=1e4, rhoA=1.0, rhoI=1e-3)
    free.beam("rod", (0, 0, 0), (COUPLER, 0, 0), section, elements=4)
    scene = cd.Scene("redundant", gravity=(0, -9.81, 0))
    hinge, cranks = cd.Revolute("z"), []
    for k, name in enumerate("AD"):
        crank = scene.body(f"crank{name}", mass=1.0, inertia=(0.01, 0.01, 0.01))
        scene.joint(name, hinge, scene.ground.at(COUPLER * k, 0, 0), crank)
        cranks.append(crank)
    bar = scene.body("bar", mass=0.5, com=(COUPLER / 2, 0, 0), inertia=(0.01, 0.01, 0.01))
    scene.joint("B", hinge, cranks[0].at(CRANK, 0, 0), bar)
    scene.joint("C", hinge, bar.at(COUPLER, 0, 0), cranks[1].at(CRANK, 0, 0))
    record = cd.superelement.from_beams(free, "rod", modes=2, damping=0.05)
    rod = scene.superelement("rod", record)
    for crank, end in zip(cranks, ("start", "end"), strict=True):
        scene.joint(f"pin_{end}", hinge, crank.at(CRANK, 0, 0.05), rod.at(end))
    return scene


def redundant_error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Error of both cranks [rad]: a pendulum, of which the rod gives by a part of 1e-6."""
    mass = 0.5 + COUPLER
    rate = np.sqrt(9.81 * mass * CRANK / (mass * CRANK**2 + 0.02))
    k = np.sin(TURNED / 2)
    _, cn, dn, _ = ellipj(rate * motion.t, k**2)
    angle = 2 * np.arcsin(k * cn / dn) - np.pi / 2
    return float(max(np.abs(motion[name] - angle).max() for name in "AD"))


PUSH, ON, OFF = 1e3, 0.01, 0.011


@cache
def bar() -> Any:
    """A bar of 1 kg in which sound travels at 100 m/s, by its free modes."""
    free = cd.Scene("bar", gravity=(0, 0, 0))
    section = cd.section.general(EA=1e4, GA=1e4, GJ=1e3, EI=1e3, rhoA=1.0, rhoI=0.1)
    free.beam("bar", (0, 0, 0), (1, 0, 0), section, elements=8)
    return cd.superelement.from_beams(free, "bar", method="rubin", modes=12)


def struck() -> cd.Scene:
    """The free bar under an impulse of 1 N s along it within 1 ms."""
    from sympy import Piecewise

    scene = cd.Scene("struck", gravity=(0, 0, 0))
    one = scene.superelement("bar", bar(), frame="start")
    scene.joint("free", cd.Free(), scene.ground, one.at("start"))
    push = Piecewise((0, cd.t < ON), (PUSH, cd.t < OFF), (0, True))
    scene.force("push", cd.Force(one.at("start"), (push, 0, 0)))
    for name, time in (("on", ON), ("off", OFF)):
        scene.force(name, cd.Event(time - cd.t))
    scene.output("far", one.at("end").position()[0])
    return scene


def struck_error(model: cd.CompiledModel, motion: cd.Trajectory) -> float:
    """Error of the far end over its way: the bar does not turn, so that its modes say it all."""
    record = bar()
    squares, shapes = eigh(record.K, record.M)
    near, far = 0, 6  # rows of motions along x of both ends

    def answer(t: Any) -> Any:
        """Of the far end, to a force of 1 N from time 0 on."""
        t = np.maximum(t, 0.0)[:, None]
        rate = np.sqrt(np.maximum(squares, 0.0))
        rigid = rate < 1e-3
        rate = np.where(rigid, 1.0, rate)
        parts = np.where(rigid, t**2 / 2, (1 - np.cos(rate * t)) / rate**2)
        return parts @ (shapes[near] * shapes[far])

    known = PUSH * (answer(motion.t - ON) - answer(motion.t - OFF))
    return float(np.abs(motion["far"] - 1.0 - known).max() / known.max())


# the first step meets a force that is there at once, and a start without deformation
UNSOLVED = Cell(0.0, {"step": 2e-5}, "not_solved")
# explicit steps beyond the limit of stability
UNSTABLE = Cell(0.0, {"step": 1e-3}, "not_closed")
# models of superelements take long to compile: one case is in every run
CASES = (
    Case(
        name="fast superelement rod",
        hard="a crank at 120 rad/s drives a slider by a slender superelement that bends by 1/500",
        oracle="two other programs; error of the angles of the ends of the rod [rad]",
        advice="use `DOP853` or `Radau` where the vibration of the rod counts",
        build=slider_crank,
        t=[0.0, *(row["t"] for row in FAST_ROD)],
        start={},
        error=rod_error,
        quick=False,
        slow=("Rosenbrock", "EnergyMidpoint"),
        fine=TOLERANCES,
        **bounds(1e-6, 1e-3, 5e-6),
    ),
    Case(
        name="spinning superelement blade",
        hard="the spinning blade as one superelement that its spin stiffens, `stiffening=True`",
        oracle="closed form of a beam-column under the pull m Omega^2 L; error over the amplitude",
        advice="use `Radau`, or `GeneralizedAlpha` with steps of the slow motion",
        build=blade,
        t=at(5.0),
        start={"u": {"blade.tip.u.z": 1e-3}},
        error=spinning_error,
        quick=False,
        fine=TOLERANCES,
        **bounds(1e-3, 1e-3, 2e-3, True),
    ),
    Case(
        name="stiff superelement on a soft hinge",
        hard="a bar of which modes of 1e9 Hz are kept swings on a hinge at 160 Hz",
        oracle="closed form of a rigid bar on a spring, within 1e-12; error over the amplitude",
        advice="use `Radau`, and damping in the component; others do not pass the first step",
        build=rigid,
        t=at(0.02),
        start={"q": {"hinge": 0.1}},
        error=rigid_error,
        quick=False,
        fine=TOLERANCES,
        **bounds(1e-4, 1e-2, 2e-5, True, GeneralizedAlpha=UNSOLVED, HHT=UNSOLVED),
    ),
    Case(
        name="superelement in a redundant loop",
        hard="two cranks with a rigid coupler, with some redundant rows, and a flexible one",
        oracle="closed form of a pendulum, to 1e-6 as the rod bends; error of the cranks [rad]",
        advice="give the rod some damping: `Radau` follows vibrations that nothing damps",
        build=redundant,
        t=at(2.0),
        start={"q": {"A": TURNED - np.pi / 2, "D": TURNED - np.pi / 2}},
        error=redundant_error,
        quick=False,
        slow=("DOP853", "RK45", "RKMK853", "RKMK45", "Rosenbrock", "EnergyMidpoint"),
        fine=TOLERANCES,
        **bounds(1e-5, 1e-4, 1e-3, RK4=UNSTABLE, RKMK4=UNSTABLE),
    ),
    Case(
        name="struck superelement",
        hard="a free bar is struck within 1 ms; a wave runs up and down in it",
        oracle="its free modes in closed form; error of the far end over its way",
        advice="take any adaptive method; `cd.Event` at both ends of an impulse shows it to them",
        build=struck,
        t=at(0.1),
        start={},
        error=struck_error,
        slow=("RK4", "RKMK4", "Rosenbrock", "EnergyMidpoint"),
        fine=TOLERANCES,
        **bounds(1e-5, 1e-3, 1e-5, Newmark=Cell(1e-3, {"step": 1e-5})),
    ),
)
