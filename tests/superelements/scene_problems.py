"""Published and independently computed values, and scenes with superelements that have them.

Each problem gives rows: what was computed, what it is known to be, and the error that its source
allows, relative where what is known is not 0. Where that is of a continuum, beams of several meshes
are extrapolated to it.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import Any

import numpy as np

import cardan as cd
from superelements.components import bar, beam, planar_beam, reference

Array = Any
Row = tuple[str, Array, Array, float]
STIFF = 1e11  # shear of beams that are to have none, EI and rho A of which are about 1
LIGHT = 1e-11  # of their mass: rotary inertia
IN_SPACE = "x y z rx ry rz"


def extrapolated(sizes: Sequence[int], values: Sequence[Array], first: int = 2) -> Array:
    """Values of meshes for elements without length: a series in even powers of it."""
    powers = [0, *range(first, first + 2 * (len(sizes) - 1), 2)]
    series = np.array([[float(n) ** -k for k in powers] for n in sizes])
    return np.linalg.solve(series, np.array(values))[0]


def nearest(found: Array, expected: Array) -> Array:
    """Of many values those that are next to some."""
    wanted = np.asarray(expected)
    return found[np.abs(found[:, None] / wanted - 1).argmin(axis=0)]


def euler_section(EA: float, EI: float, rhoA: float, GA: float | None = None) -> Any:
    """A section without shear and rotary inertia."""
    shear = STIFF * EI if GA is None else GA
    return cd.section.general(EA=EA, GA=shear, EI=EI, GJ=EI, rhoA=rhoA, rhoI=LIGHT * rhoA)


# bars and beams that spin about their middle


def _spun_bar(record: Any, frame: str) -> Any:
    scene = cd.Scene("bar", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=1.0, inertia=(1.0, 1.0, 1.0))
    scene.joint("spin", cd.Revolute("z"), scene.ground, hub)
    scene.superelement("bar", record, {"middle": hub}, frame=frame)
    return cd.compile(scene)


def stretch_of_beams(EA: float, rhoA: float, half: float, spin: float) -> float:
    """How far the tip of half a bar goes out, by geometrically exact beams."""
    sizes, tips = (4, 8, 16, 32), []
    for elements in sizes:
        scene = cd.Scene("beams", gravity=(0, 0, 0))
        hub = scene.body("hub", mass=1.0, inertia=(1.0, 1.0, 1.0))
        scene.joint("spin", cd.Revolute("z"), scene.ground, hub)
        section = cd.section.general(EA=EA, GA=EA, EI=EA, GJ=EA, rhoA=rhoA, rhoI=1e-3 * rhoA)
        scene.beam("half", hub, (half, 0, 0), section, elements=elements)
        steady = cd.compile(scene).equilibrium(u={"spin": spin}, check=True)
        tips.append(np.linalg.norm(steady.pose("half.end")[:3, 3]) - half)
    return float(extrapolated(sizes, tips))


def spinning_bars() -> Iterator[Row]:
    for name in ("spinning_bar_A", "spinning_bar_B"):
        given = reference(name)
        data, known = given["parameters"], given["reference"]
        half, n, spin = data["half_length"], data["elements_per_half"], data["Omega"]
        ends = {"left": 0, "middle": n, "right": 2 * n}
        record = bar(2 * half, 2 * n, data["E"], data["rho"], ends, modes=2 * n - 2)
        frame = "mean" if name == "spinning_bar_A" else "left"
        steady = _spun_bar(record, frame).equilibrium(u={"spin": spin}, check=True)
        tip = np.linalg.norm(steady.pose("bar.right")[:3, 3]) - half
        yield f"{name}, frame {frame}", tip, known["u_tip_fe"], 1e-9


def _flying(record: Any, frame: str) -> Any:
    """A component that slides along a hub, which turns on a cart."""
    scene = cd.Scene("flying", gravity=(0, 0, 0))
    cart = scene.body("cart", mass=1.0, inertia=(1.0, 1.0, 1.0))
    hub = scene.body("hub", mass=0.0, inertia=(0.0, 0.0, 0.0))
    boom = scene.superelement("boom", record, frame=frame)
    scene.joint("fly", cd.Prismatic("x"), scene.ground, cart)
    scene.joint("spin", cd.Revolute("z"), cart, hub)
    scene.joint("slide", cd.Prismatic("x"), hub, boom.at(record.interfaces[0].name))
    return cd.compile(scene)


def spin_and_translation() -> Iterator[Row]:
    """The elongation, and that accelerations do not depend on a common velocity."""
    given = reference("se_spin_translate_16")
    data, known = given["parameters"], given["reference"]
    spin, speed = data["spin"], data["translation_velocity"]
    cases = [
        (bar(1.0, 16, 4194304.0, 3.28125), "elongation_isotropic_linear_mass", "mean"),
        (beam(modes=45), "elongation_full_FE_consistent_beam_mass", "root"),
        (beam(modes=0), "elongation_cb_0", "mean"),
        (beam(modes=3), "elongation_cb_3", "chord"),
        (beam(modes=8), "elongation_cb_8", "root"),
    ]
    for record, name, frame in cases:
        model = _flying(record, frame)
        steady = model.equilibrium(q={"slide": -0.5}, u={"spin": spin}, check=True)
        ends = [steady.pose(f"boom.{one.name}")[:3, 3] for one in record.interfaces]
        longer = np.linalg.norm(ends[1] - ends[0]) - 1
        yield f"{name}, frame {frame}", longer, known[name], 1e-9
        place = dict(zip(model.coordinates, steady.q, strict=True))
        rates = []
        for boost in (0.0, speed):
            q, u = model.split(model.initial(q=place, u={"spin": spin, "fly": boost}))
            rates.append(np.asarray(model.forward_dynamics(q, u)) / spin**2)
        yield f"{name}, accelerations at {speed} m/s", abs(rates[1] - rates[0]).max(), 0.0, 1e-9


def spin_of_beams() -> Iterator[Row]:
    """The same bars and the same beam without elements."""
    for name in ("spinning_bar_A", "spinning_bar_B"):
        given = reference(name)
        E, rho, half, spin = list(given["parameters"].values())[:4]
        expected = given["reference"]["u_tip_exact"]
        yield f"{name}, beams", stretch_of_beams(E, rho, half, spin), expected, 1e-9
    given = reference("se_spin_translate_16")
    half = stretch_of_beams(4194304.0, 3.28125, 0.5, given["parameters"]["spin"])
    yield "continuum, beams", 2 * half, given["reference"]["continuum"], 1e-9


# small motions of several components


def frame_of_two() -> Iterator[Row]:
    """Two beams at a right angle. Records without mass, those of MacNeal, move in no scene."""
    given = reference("coupled_L_frame_A")
    data, known = given["parameters"], given["reference"]
    sizes = {name: tuple(data[name].values()) for name in "AB"}
    M, K, nodes = planar_beam(*sizes["A"])
    m, k, places = planar_beam(*sizes["B"])
    turn = np.kron(np.eye(len(places)), [[0, -1, 0], [1, 0, 0], [0, 0, 1]])
    other = turn @ m @ turn.T, turn @ k @ turn.T, places[:, [1, 0, 2]] + (sizes["A"][0], 0, 0)
    counts = {(2, 2): "2_2", (4, 3): "4_3", (6, 6): "6_6"}
    cases = [
        (key, f"{way}_{text}_omega") for key, text in counts.items() for way in ("cb", "rubin")
    ]
    for modes, name in [*cases, ((45, 33), "full_omega")]:
        scene = cd.Scene("frame", gravity=(0, 0, 0))
        way = "rubin" if name.startswith("rubin") else "craig_bampton"
        parts = {}
        for part, matrices, count in zip("AB", ((M, K, nodes), other), modes, strict=True):
            ends = {"root": 0, "tip": sizes[part][1]}
            record = cd.superelement.reduce(
                *matrices, ends, node_dofs="x y rz", method=way, modes=count
            )
            joined = {"root": scene.ground} if part == "A" else {}
            parts[part] = scene.superelement(part, record, joined)
        scene.joint("corner", cd.Fixed(), parts["A"].at("tip"), parts["B"].at("root"))
        found = np.sort(cd.compile(scene).modes().angular)[: len(known[name])]
        yield name, found, known[name], 1e-7


# a satellite


def _satellite(elements: int, EA: float, GA: float) -> Any:
    """The hub and its beams."""
    data = reference("satellite_two_beams_A")["parameters"]
    scene, J = cd.Scene("satellite", gravity=(0, 0, 0)), data["J_hub"]
    hub = scene.body("hub", mass=data["m_hub"], inertia=(J, J, J), pose=(0, 0, 0))
    section = euler_section(EA, data["EI"], data["rhoA"], GA)
    for name, side in (("left", -1), ("right", 1)):
        root, tip = side * data["a"], side * (data["a"] + data["L"])
        scene.beam(name, hub.at(root, 0, 0), (tip, 0, 0), section, elements=elements, base=hub)
    return scene


def _families(turning: Any, moving: Any, allowed: float, what: str) -> Iterator[Row]:
    """Rows of models that turn about the axis and that move across the beams."""
    known = reference("satellite_two_beams_A")["reference"]
    symmetric = known["still_symmetric"]
    yield f"{what}, symmetric", nearest(moving(), symmetric), symmetric, allowed
    for spin, text in ((0.0, ""), (0.3, "Om0.3"), (1.0, "Om1")):
        expected = known["still_antisymmetric"]
        if text:
            expected = known["spinning"][text]["antisymmetric_inplane"]
        found = nearest(turning(spin), expected)
        yield f"{what}, antisymmetric at {spin} rad/s", found, expected, allowed


def _turned(scene: Any, joint: Any, body: Any) -> Any:
    scene.joint("free", joint, scene.ground, body)
    return cd.compile(scene)


def satellite(modes: int = 24) -> Iterator[Row]:
    """Both beams and the hub as one superelement, the frame on the hub; 1e-5 with these modes."""
    beams = _satellite(96, 1e9, 1e12)
    record = cd.superelement.from_beams(
        beams, ["left", "right"], {"hub": "hub"}, bodies=["hub"], modes=modes, stiffening="hub"
    )

    def model(joint: Any) -> Any:
        scene = cd.Scene("craft", gravity=(0, 0, 0))
        body = scene.superelement("body", record, stiffening=True)
        return _turned(scene, joint, body.at("hub"))

    turning = model(cd.Revolute("z"))
    yield from _families(
        lambda spin: (
            turning.modes(modes, turning.equilibrium(u={"free": spin}, check=True)).angular
        ),
        lambda: model(cd.Prismatic("y")).modes(modes).angular,
        1e-5,
        f"{modes} modes",
    )


def satellite_of_beams() -> Iterator[Row]:
    """Lengths of elements go to 0, and so does what the spin stretches them."""
    sizes, parts = (12, 16, 24, 32), (1.0, 2.0)
    wanted = reference("satellite_two_beams_A")["reference"]

    def models(joint: Any, part: float) -> list[Any]:
        return [_turned(_satellite(n, 3e8 * part, 1e12), joint, "hub") for n in sizes]

    turned = [models(cd.Revolute("z"), part) for part in parts]

    def turning(spin: float) -> Array:
        expected = wanted["still_antisymmetric"]
        if spin:
            name = {0.3: "Om0.3", 1.0: "Om1"}[spin]
            expected = wanted["spinning"][name]["antisymmetric_inplane"]
        meshes = []
        for row in turned:
            steady = [model.equilibrium(u={"free": spin}, check=True) for model in row]
            found = [
                nearest(model.modes(20, one).angular, expected)
                for model, one in zip(row, steady, strict=True)
            ]
            meshes.append(extrapolated(sizes, found, first=2 if spin else 4))
        return 2 * meshes[1] - meshes[0]

    def moving() -> Array:
        expected = wanted["still_symmetric"]
        row = models(cd.Prismatic("y"), 1.0)
        found = [nearest(model.modes(20).angular, expected) for model in row]
        return extrapolated(sizes, found, first=4)

    yield from _families(turning, moving, 1e-8, "beams")


# a top


def top(stem: Callable[[Any, float], Any], little: float, axis: str = "x") -> Any:
    """A disk on a stem that stands on a spherical joint; what is massless and rigid is nearly so.

    Args:
        stem: Adds it, with such a mass by length and compliance, and returns its upper end.
        little: Of both, without unit.
        axis: Of the stem in axes of its upper end.
    """
    data = reference("top_flexible_stem_A")["parameters"]
    scene = cd.Scene("top", gravity=(0, 0, -data["g"]))
    along = stem(scene, little)
    inertia = [data["Ip"] if one == axis else data["It"] for one in "xyz"]
    disk = scene.body("disk", mass=data["m"], inertia=inertia)
    scene.joint("held", cd.Fixed(), along, disk)
    return cd.compile(scene)


def rates(model: Any, spin: float, expected: Array) -> Array:
    """Growth, then frequencies that an observer sees who turns along."""
    found = model.modes(12, model.equilibrium(u={"ball": [0, 0, spin]}, check=True)).values
    slow = found[np.abs(found) < 1e3]
    return np.concatenate([[slow.real.max()], nearest(slow.imag, expected)])


def stem_of_beams(elements: int, shear: float = 1.0) -> Callable[[Any, float], Any]:
    """A stem of beams, whose stiffness against shear is that part of the one along it."""
    data = reference("top_flexible_stem_A")["parameters"]

    def add(scene: Any, little: float) -> Any:
        foot = scene.body("foot", mass=0.0, inertia=(0.0, 0.0, 0.0))
        scene.joint("ball", cd.Spherical(), scene.ground, foot)
        stiff, light = 1e2 / little, little
        section = cd.section.general(
            EA=stiff, GA=shear * stiff, EI=data["EI"], GJ=data["EI"], rhoA=light, rhoI=1e-4 * light
        )
        top = (0, 0, data["L"])
        return scene.beam("stem", foot, top, section, elements=elements).end

    return add


def top_of_beams() -> Iterator[Row]:
    """Mass and compliance of the stem, and lengths of elements, go to 0."""
    sizes, parts = (6, 12, 24), (1.0, 2.0, 3.0)
    models = [[top(stem_of_beams(n), 1e-5 * part) for part in parts] for n in sizes]
    for name, case in reference("top_flexible_stem_A")["reference"]["cases"].items():
        spin = float(name.removeprefix("Omega_"))
        expected = np.abs(np.array(case["precession_rates"]) - spin)
        found = [[rates(model, spin, expected) for model in row] for row in models]
        meshes = [3 * one - 3 * two + three for one, two, three in found]
        both = extrapolated(sizes, meshes, first=4)
        yield f"{spin:.0f} rad/s, beams", both[1:], expected, 1e-8
        if case["growth"] > 1e-6:
            yield f"growth at {spin:.0f} rad/s, beams", both[0], case["growth"], 1e-8
