"""A slider-crank whose rod is rigid, a superelement, or of beams.

``python tests/superelements/slider_crank.py`` writes docs/slider_crank.svg, and prints how far
forms of the inertia are from the truth.
"""

from __future__ import annotations

import sys
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))

import cardan as cd
from superelements.components import planar_beam, reference

Array = Any
PICTURE = Path(__file__).parents[2] / "docs" / "slider_crank.svg"
COLORS = {
    "beams": "#12355b",
    "4 superelements": "#5a8f4e",
    "1 superelement": "#e0a030",
    "rigid rod": "#999999",
}
TURN, SPIN = 2 * np.pi, 120.0
STEP = TURN / 4800  # of the crank [rad]
FORMS = ("nodal", "projected")


@dataclass(frozen=True)
class Motion:
    """Of a mechanism over the angle of its crank.

    Attributes:
        angle: Of the crank (nt,) [rad].
        bow: How far the middle of the rod is from the line between its ends (nt,) [m].
        slider: Its position (nt,) [m].
    """

    angle: Array
    bow: Array
    slider: Array


def data() -> dict[str, Any]:
    given: dict[str, Any] = reference("slider_crank_superelement_A")["parameters"]
    return given


def section() -> Any:
    """Of the rod, a solid one."""
    EA, EI, rhoA = (data()[name] for name in ("EA", "EI", "rhoA"))
    rhoI = rhoA * EI / EA
    return cd.section.general(EA=EA, GA=0.3 * EA, EI=EI, GJ=0.6 * EI, rhoA=rhoA, rhoI=rhoI)


def _mechanism(spin: float) -> tuple[Any, Any, Any, float, float]:
    """Scene, crank and slider, and where the rod begins and ends."""
    scene = cd.Scene("slider_crank", gravity=(0, 0, 0))
    start, end = data()["crank"], data()["crank"] + data()["rod"]
    crank = scene.body("crank", mass=1.0, inertia=(1.0, 1.0, 1.0))
    slider = scene.body("slider", mass=data()["slider_mass"], pose=(end, 0, 0))
    scene.joint("crank", cd.Revolute("z"), scene.ground, crank, prescribed=spin * cd.t)
    scene.joint("slide", cd.Prismatic("x"), scene.ground, slider)
    return scene, crank, slider, start, end


def _run(scene: Any, spin: float, turns: float, **options: Any) -> Any:
    times = np.linspace(0, TURN * turns / spin, round(120 * turns) + 1)
    model = cd.compile(scene)
    if not options:
        # high frequencies of short parts are damped
        options = {"method": cd.GeneralizedAlpha(0.8), "step": STEP / spin}
    return model.simulate(times, **options)


def _motion(run: Any, spin: float, bow: Array) -> Motion:
    return Motion(spin * np.asarray(run.t), bow, run.pose("slider")[:, 0, 3])


@cache
def beams(spin: float = SPIN, turns: float = 1.0, elements: int = 16) -> Motion:
    """With a rod of geometrically exact beams."""
    scene, crank, slider, start, _ = _mechanism(spin)
    pins = {"release_start": "rz", "release_end": "rz"}
    scene.beam("rod", crank.at(start), slider, section(), elements=elements, **pins)
    run = _run(scene, spin, turns)
    line = run.line("rod")[:, :, :2]
    along, arm = (line[:, k] - line[:, 0] for k in (-1, line.shape[1] // 2))
    cross = along[:, 0] * arm[:, 1] - along[:, 1] * arm[:, 0]
    return _motion(run, spin, cross / np.linalg.norm(along, axis=1))


@cache
def superelements(
    count: int = 1, spin: float = SPIN, turns: float = 1.0, elements: int = 16,
    inertia: str = "nodal", modes: int = 6,
) -> Motion:  # fmt: skip
    """With a rod of one or several superelements of beams; half their modes leave the plane."""
    scene, crank, slider, start, end = _mechanism(spin)
    cuts, last = np.linspace(start, end, count + 1), crank.at(start)
    for k in range(count):
        source = cd.Scene("rod", gravity=(0, 0, 0))
        left, right = (cuts[k], 0, 0), (cuts[k + 1], 0, 0)
        source.beam("rod", left, right, section(), elements=elements // count)
        record = cd.superelement.from_beams(source, "rod", modes=modes)
        part = scene.superelement(f"rod{k}", record, frame="chord", inertia=inertia)
        joint = cd.Fixed() if k else cd.Revolute("z")
        scene.joint(f"pin{k}", joint, last, part.at("start"))
        last = part.at("end")
    scene.joint("wrist", cd.Revolute("z"), last, slider)
    run = _run(scene, spin, turns)
    ends = [run.pose(f"rod{k}.{end}")[:, :2, 3] for k, end in ((0, "start"), (count - 1, "end"))]
    if count > 1:
        middle = run.pose(f"rod{count // 2}.start")[:, :2, 3]
        along, arm = ends[1] - ends[0], middle - ends[0]
        cross = along[:, 0] * arm[:, 1] - along[:, 1] * arm[:, 0]
        return _motion(run, spin, cross / np.linalg.norm(along, axis=1))
    shape = run.superelement("rod0")
    middle = np.abs(shape.surface.points[:, 0] - (start + end) / 2).argmin()
    return _motion(run, spin, shape.displacements[:, middle, 1])


def rigid(spin: float = SPIN, turns: float = 1.0) -> Motion:
    """With a rigid rod."""
    scene, crank, slider, start, end = _mechanism(spin)
    mass, length = data()["rhoA"] * data()["rod"], end - start
    across = mass * length**2 / 12
    rod = scene.body("rod", mass=mass, com=(length / 2, 0, 0), inertia=(across, across, across))
    scene.joint("pin", cd.Revolute("z"), crank.at(start), rod)
    scene.joint("wrist", cd.Revolute("z"), rod.at(length), slider)
    run = _run(scene, spin, turns, rtol=1e-10)
    return _motion(run, spin, np.zeros(len(run.t)))


def bow_error(elements: int, inertia: str) -> float:
    """Largest error of the bow, as a part of the largest bow: slowly, so that it is small."""
    slow, turns = 15.0, 0.25
    truth = beams(slow, turns).bow
    found = superelements(1, slow, turns, elements, inertia, 12).bow
    return float(np.abs(found - truth).max() / np.abs(truth).max())


def bent_in_flight(elements: int, inertia: str) -> float:
    """How far a beam is bent that turns while it flies, and in truth stays straight [m].

    Of 1 m, at 100 rad/s and 10 m/s, after 20 ms.
    """
    M, K, nodes = planar_beam(1.0, elements, 4194304.0, 128.0, 3.28125)
    ends = {"root": 0, "tip": elements}
    record = cd.superelement.reduce(M, K, nodes, ends, node_dofs="x y rz", modes=4)
    scene = cd.Scene("flying", gravity=(0, 0, 0))
    boom = scene.superelement("boom", record, frame="chord", inertia=inertia)
    scene.joint("plane", cd.Planar("z"), scene.ground, boom.at("root"))
    times = np.linspace(0, 0.02, 41)
    start = {"plane": [10.0, -50.0, 100.0]}
    run = cd.compile(scene).simulate(times, u=start, method="Radau", rtol=1e-8)
    return float(np.abs(run.superelement("boom").displacements[:, :, 1]).max())


def draw() -> None:
    """Write the picture: the same bytes for the same numbers."""
    import matplotlib as mpl
    from matplotlib.figure import Figure

    still = rigid()
    shown = {
        "beams": beams(),
        "4 superelements": superelements(4),
        "1 superelement": superelements(),
        "rigid rod": still,
    }
    style = {"svg.hashsalt": "cardan", "svg.fonttype": "none", "font.size": 9}
    with mpl.rc_context(style):
        figure = Figure(figsize=(8, 4.4), layout="constrained")
        upper, lower = figure.subplots(2, 1, sharex=True)
        for name, motion in shown.items():
            look = {"color": COLORS[name], "label": name}
            look |= {"lw": 3.5} if name == "beams" else {"lw": 1.2}
            degrees = np.degrees(motion.angle)
            upper.plot(degrees, 1e3 * motion.bow, **look)
            lower.plot(degrees, 1e6 * (motion.slider - still.slider), **look)
        upper.set(ylabel="bow of the rod [mm]")
        lower.set(
            ylabel="slider, less that of\nthe rigid rod [um]", xlabel="angle of the crank [deg]"
        )
        for axes in (upper, lower):
            axes.grid(alpha=0.25)
        upper.legend(frameon=False)
        figure.savefig(PICTURE, metadata={"Date": None})


def forms() -> str:
    """The table of forms of the inertia in docs/superelements.md."""
    lines = []
    for elements in (8, 16, 64):
        row = [1e3 * bent_in_flight(elements, form) for form in FORMS]
        row += [100 * bow_error(elements, form) for form in FORMS]
        lines.append(f"| {elements} | {' | '.join(f'{x:.2g}' for x in row)} |")
    return "\n".join(lines)


if __name__ == "__main__":
    draw()
    print(forms())
