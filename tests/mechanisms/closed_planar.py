"""Planar closed mechanisms: linkages in the x-y plane, all axes along z.

Links lie along the x axis of their bodies; angles are counted from the ground's x axis.
"""

from __future__ import annotations

import json
import math
from pathlib import Path

import cardan as cd

ANDREWS = Path(__file__).parents[1] / "references" / "andrews.json"
G = 9.81

Angles = dict[str, float]
Point = tuple[float, float]


def meet(a: Point, ra: float, b: Point, rb: float, side: int) -> Point:
    """The point at distances ra from a and rb from b, left (+1) or right (-1) of a -> b."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    distance = math.hypot(dx, dy)
    angle = math.acos((ra**2 + distance**2 - rb**2) / (2 * ra * distance))
    direction = math.atan2(dy, dx) + side * angle
    return a[0] + ra * math.cos(direction), a[1] + ra * math.sin(direction)


def heading(a: Point, b: Point) -> float:
    """Angle of the line a -> b."""
    return math.atan2(b[1] - a[1], b[0] - a[0])


def _link(scene: cd.Scene, name: str, mass: float, length: float) -> cd.scene.Body:
    inertia = cd.inertia.box(mass, length, 0.02, 0.01)
    return scene.body(name, mass=mass, com=(length / 2, 0, 0), inertia=inertia)


# the four-bar: A and D on the ground, A-B crank, B-C coupler, D-C rocker

FOUR_BAR = {"ground": 0.3, "crank": 0.1, "coupler": 0.25, "rocker": 0.2}


def four_bar(
    ground: float = 0.3, crank: float = 0.1, coupler: float = 0.25, rocker: float = 0.2
) -> cd.Scene:
    """A crank-rocker under gravity along -y; lengths in m, 1 kg per meter of link."""
    scene = cd.Scene("four_bar", gravity=(0, -G, 0))
    links = {"crank": crank, "coupler": coupler, "rocker": rocker}
    a, b, c = (_link(scene, name, length, length) for name, length in links.items())
    scene.joint("A", cd.Revolute("z"), scene.ground, a)
    scene.joint("B", cd.Revolute("z"), a.at(crank, 0, 0), b)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(ground, 0, 0), c)
    scene.joint("C", cd.Revolute("z"), b.at(coupler, 0, 0), c.at(rocker, 0, 0))
    return scene


def four_bar_angles(theta: float, side: int = 1) -> Angles:
    """Angles of all joints of the default four-bar; side +1 is the open branch."""
    lengths = FOUR_BAR
    tip = (lengths["crank"] * math.cos(theta), lengths["crank"] * math.sin(theta))
    pivot = (lengths["ground"], 0.0)
    corner = meet(tip, lengths["coupler"], pivot, lengths["rocker"], side)
    coupler, rocker = heading(tip, corner), heading(pivot, corner)
    return {"A": theta, "B": coupler - theta, "D": rocker, "C": rocker - coupler}


def slider_crank(crank: float = 0.1, rod: float = 0.3, offset: float = 0.0) -> cd.Scene:
    """A slider on the line y = offset, driven by crank and rod; lengths in m."""
    scene = cd.Scene("slider_crank", gravity=(0, -G, 0))
    a, b = _link(scene, "crank", 0.3, crank), _link(scene, "rod", 0.5, rod)
    slider = scene.body("slider", mass=0.8, inertia=cd.inertia.box(0.8, 0.04, 0.03, 0.03))
    scene.joint("A", cd.Revolute("z"), scene.ground, a)
    scene.joint("B", cd.Revolute("z"), a.at(crank, 0, 0), b)
    scene.joint("guide", cd.Prismatic("x"), scene.ground.at(0, offset, 0), slider)
    scene.joint("C", cd.Revolute("z"), b.at(rod, 0, 0), slider)
    return scene


def slider_crank_coordinates(theta: float) -> Angles:
    """Coordinates of all joints of the default slider-crank."""
    rod = math.asin(-0.1 * math.sin(theta) / 0.3)
    place = 0.1 * math.cos(theta) + 0.3 * math.cos(rod)
    return {"A": theta, "B": rod - theta, "guide": place, "C": -rod}


def parallelogram(windows: int = 2) -> cd.Scene:
    """N windows of four bars with equal links; singular where all links lie on one line.

    Source: IFToMM library of multibody benchmarks, problem A02 (N four-bars).
    """
    scene = cd.Scene(f"parallelogram{windows}", gravity=(0, -G, 0))
    rod = cd.inertia.rod(1.0, 1.0, axis="x")
    cranks = []
    for k in range(windows + 1):
        crank = scene.body(f"crank{k}", mass=1.0, com=(0.5, 0, 0), inertia=rod)
        scene.joint(f"A{k}", cd.Revolute("z"), scene.ground.at(k, 0, 0), crank)
        cranks.append(crank)
    for k in range(windows):
        coupler = scene.body(f"coupler{k}", mass=1.0, com=(0.5, 0, 0), inertia=rod)
        scene.joint(f"B{k}", cd.Revolute("z"), cranks[k].at(1, 0, 0), coupler)
        scene.joint(f"C{k}", cd.Revolute("z"), coupler.at(1, 0, 0), cranks[k + 1].at(1, 0, 0))
    return scene


def parallelogram_angles(phi: float, windows: int = 2) -> Angles:
    """Angles of all joints where all cranks are parallel at the angle phi."""
    angles = {f"A{k}": phi for k in range(windows + 1)}
    for k in range(windows):
        angles |= {f"B{k}": -phi, f"C{k}": phi}
    return angles


# the squeezer of Andrews: K1 on O, K3 on B, K5 and K7 on A; K2, K3, K4 and K6 meet in E


def _andrews() -> dict[str, float]:
    return dict(json.loads(ANDREWS.read_text("utf-8"))["parameters"])


def andrews() -> cd.Scene:
    """The squeezing mechanism of Andrews: seven bodies, three loops, one freedom.

    Source: F. Mazzia and C. Magherini, Test Set for IVP Solvers, release 2.4, problem "andrews".
    """
    p = _andrews()
    scene = cd.Scene("andrews", gravity=(0, 0, 0))
    centers = {
        "K1": (p["ra"], 0, 0),
        "K2": (-p["da"], 0, 0),
        "K3": (p["sb"], -p["sa"], 0),
        "K4": (0, -(p["e"] - p["ea"]), 0),
        "K5": (p["ta"], p["tb"], 0),
        "K6": (p["zf"] - p["fa"], 0, 0),
        "K7": (-p["ub"], -p["ua"], 0),
    }
    k = {}
    for number, (name, center) in enumerate(centers.items(), 1):
        mass, moment = p[f"m{number}"], p[f"I{number}"]
        # only the moment about z acts
        inertia = (moment / 2, moment / 2, moment)
        k[name] = scene.body(name, mass=mass, com=center, inertia=inertia)
    turn, ground = cd.Revolute("z"), scene.ground
    scene.joint("beta", turn, ground, k["K1"])
    scene.joint("theta", turn, k["K1"].at(p["rr"], 0, 0), k["K2"])
    scene.joint("gamma", turn, ground.at(p["xb"], p["yb"], 0), k["K3"])
    scene.joint("delta", turn, ground.at(p["xa"], p["ya"], 0), k["K5"])
    scene.joint("phi", turn, k["K5"].at(p["zt"], 0, 0), k["K4"])
    scene.joint("epsilon", turn, ground.at(p["xa"], p["ya"], 0), k["K7"])
    scene.joint("omega", turn, k["K7"].at(0, -p["u"], 0), k["K6"])
    tip = k["K2"].at(-p["d"], 0, 0)
    scene.joint("E3", turn, tip, k["K3"].at(0, -p["ss"], 0))
    scene.joint("E4", turn, tip, k["K4"].at(0, -p["e"], 0))
    scene.joint("E6", turn, tip, k["K6"].at(p["zf"], 0, 0))
    hook, anchor = k["K3"].at(p["sd"], -p["sc"], 0), ground.at(p["xc"], p["yc"], 0)
    scene.force("spring", cd.SpringDamper(anchor, hook, stiffness=p["c0"], rest_length=p["l0"]))
    scene.force("drive", cd.JointForce("beta", p["mom"]))
    return scene


def andrews_angles(beta: float) -> Angles:
    """Angles of all joints at the drive angle beta, on the branch of the published start."""
    p, quarter = _andrews(), math.pi / 2
    a, b = (p["xa"], p["ya"]), (p["xb"], p["yb"])
    pin = (p["rr"] * math.cos(beta), p["rr"] * math.sin(beta))
    e = meet(pin, p["d"], b, p["ss"], 1)
    second, gamma = heading(e, pin), heading(b, e) + quarter
    # K5 and K4 from A to E
    corner = meet(a, p["zt"], e, p["e"], 1)
    delta, fourth = heading(a, corner), heading(corner, e) + quarter
    # K7 and K6 from A to E
    corner = meet(a, p["u"], e, p["zf"], -1)
    epsilon, sixth = heading(a, corner) + quarter, heading(corner, e)
    return {
        "beta": beta,
        "theta": second - beta,
        "gamma": gamma,
        "delta": delta,
        "phi": fourth - delta,
        "epsilon": epsilon,
        "omega": sixth - epsilon,
        "E3": gamma - second,
        "E4": fourth - second,
        "E6": sixth - second,
    }


def arc_angles(links: int, span: float) -> list[float]:
    """Angles of links of length 1 / links along an arc that sags between pivots ``span`` apart."""
    shares = [(2 * k + 1) / links - 1 for k in range(links)]
    low, high = 1e-6, math.pi
    while high - low > 1e-15 * high:
        middle = (low + high) / 2
        wide = sum(math.cos(middle * share) for share in shares) > span * links
        low, high = (middle, high) if wide else (low, middle)
    return [high * share for share in shares]


def hanging_chain(links: int, span: float = 0.8, stretched: bool = False) -> cd.Scene:
    """A chain of equal rods, 1 m and 1 kg in all, between two pivots at one height.

    Its joints start along an arc, which is not how it hangs at rest. ``stretched``: they start at
    0, on a line that is too long for the pivots.
    """
    scene = cd.Scene(f"hanging_chain{links}", gravity=(0, -G, 0))
    length, angle, end = 1 / links, 0.0, scene.ground
    rod = cd.inertia.rod(length, length, axis="x")
    for k, absolute in enumerate([0.0] * links if stretched else arc_angles(links, span)):
        link = scene.body(f"link{k}", mass=length, com=(length / 2, 0, 0), inertia=rod)
        at = end.at(length, 0, 0) if k else end
        scene.joint(f"pin{k}", cd.Revolute("z"), at, link, q0=absolute - angle)
        angle, end = absolute, link
    pivot = scene.ground.at(span, 0, 0)
    scene.joint("last pin", cd.Revolute("z"), end.at(length, 0, 0), pivot, cut=True)
    return scene
