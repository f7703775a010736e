"""A blade that spins: by beams, as one superelement and as a chain of them; tops on such stems.

``python tests/superelements/blades.py`` prints the table of docs/superelements.md.
"""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[1]))

import cardan as cd
from superelements.components import reference, spatial_beam
from superelements.scene_problems import IN_SPACE, Row, euler_section, extrapolated, nearest

Array = Any
EA, SPINS = 1e4, (0.0, 3.0, 6.0, 12.0)
ELEMENTS = 128  # of the whole blade, whatever it is cut into
COUNTS = (1, 2, 4, 8, 16)


@cache
def known(spin: float) -> dict[str, Any]:
    found: dict[str, Any] = reference("rotating_blade_superelement_A")["reference"][f"Om{spin:.0f}"]
    return found


def _hub() -> tuple[Any, Any]:
    scene = cd.Scene("blade", gravity=(0, 0, 0))
    hub = scene.body("hub", mass=1.0, inertia=(1.0, 1.0, 1.0))
    scene.joint("drive", cd.Revolute("z"), scene.ground, hub)
    return scene, hub


@cache
def chain(count: int, bending: int = 2, inertia: str = "nodal") -> Any:
    """The blade as some superelements, one after the other, with modes of bending in each plane."""
    scene, last = _hub()
    for k in range(count):
        elements = ELEMENTS // count
        M, K, nodes = spatial_beam(1 / count, elements, EA, 1.0, 1.0)
        record = cd.superelement.reduce(
            M,
            K,
            nodes + np.array([k / count, 0, 0]),
            {"root": 0, "tip": elements},
            node_dofs=IN_SPACE,
            modes=2 * bending,
        )
        part = scene.superelement(f"part{k}", record, frame="chord", inertia=inertia)
        scene.joint(f"joint{k}", cd.Fixed(), last, part.at("root"))
        last = part.at("tip")
    return cd.compile(scene)


@cache
def stiffened(elements: int = 48, inertia: str = "nodal", modes: int = 12) -> Any:
    """The blade as one superelement with its frame on the hub and its geometric stiffness."""
    source, hub = _hub()
    source.beam("blade", hub, (1, 0, 0), euler_section(EA, 1.0, 1.0), elements=elements)
    record = cd.superelement.from_beams(source, "blade", modes=modes, stiffening="start")
    scene, hub = _hub()
    options = {"stiffening": True, "inertia": inertia}
    scene.superelement("blade", record, {"start": hub}, frame="start", **options)
    return cd.compile(scene)


@cache
def beams(elements: int) -> Any:
    """The blade as geometrically exact beams."""
    scene, hub = _hub()
    scene.beam("blade", hub, (1, 0, 0), euler_section(EA, 1.0, 1.0), elements=elements)
    return cd.compile(scene)


def flap(model: Any, spin: float, expected: Array) -> Array:
    """Frequencies next to those expected, about a steady spin that something keeps."""
    steady = model.equilibrium(u={"drive": spin}, locked={"drive": 0.0}, check=True)
    return nearest(model.modes(8, steady).angular, expected)


def refined(spin: float) -> Array:
    """First three frequencies of beams, extrapolated to elements without length."""
    expected = known(spin)["exact_extensible"]
    sizes, first = ((12, 16, 24, 32, 48), 2) if spin else ((8, 16, 32), 4)
    return extrapolated(sizes, [flap(beams(n), spin, expected) for n in sizes], first)


def blade_of_beams() -> Iterator[Row]:
    for spin in SPINS:
        expected = known(spin)["exact_extensible"]
        yield f"{spin:.0f} rad/s, beams", refined(spin), expected, 1e-9


def _by_poses(model: Any, linear: Any) -> tuple[Array, Array]:
    """Mass and stiffness by motions of the tips of all parts, and modal coordinates."""
    moves = linear.increments[:, : linear.n]
    q = model.split(linear.x)[0]
    tips = [x.name for x in model.manifest.frames if re.fullmatch(r"part\d+\.tip", x.name)]
    rows = [model.frame_jacobian(tip, q) @ moves for tip in tips]
    rows += [moves[k : k + 1] for k, name in enumerate(linear.along) if ".mode" in name]
    inverse = np.linalg.inv(np.concatenate(rows))
    K = -linear.mass @ linear.A[linear.n :, : linear.n]
    return inverse.T @ linear.mass @ inverse, inverse.T @ K @ inverse


def _flap_by_mass_at_rest(model: Any, spin: float, expected: Array) -> Array:
    """Frequencies by the stiffness of the spinning blade and the mass of the one at rest."""
    mass, stiffness = (
        _by_poses(
            model,
            model.linearize(model.equilibrium(u={"drive": w}, locked={"drive": 0.0}, check=True)),
        )[part]
        for part, w in enumerate((0.0, spin))
    )
    squares = np.linalg.eigvals(np.linalg.solve(mass, stiffness))
    return nearest(np.sqrt(np.abs(squares)), expected)


def chains() -> Iterator[Row]:
    """The reference takes the mass of the blade at rest; modes have that of the stretched one.

    These tend to the exact ones, as the parts become shorter.
    """
    for count in COUNTS:
        for bending in (0, 2):
            model = chain(count, bending, "projected")
            for spin in SPINS:
                expected = known(spin)[f"se{count}_int{bending}"]
                found = _flap_by_mass_at_rest(model, spin, expected)
                yield f"{count} with {bending} modes, {spin:.0f} rad/s", found, expected, 1e-4
    for spin in SPINS:
        exact = known(spin)["exact_extensible"][:2]
        near = {count: known(spin)[f"se{count}_int2"][:2] for count in COUNTS[2:]}
        found = [flap(chain(n, 2, "projected"), spin, near[n]) for n in near]
        yield f"{spin:.0f} rad/s, parts without length", extrapolated([*near], found), exact, 1e-4


def table() -> str:
    """First and second flap frequency by angular velocity, and by how much they are off."""
    heads = [f"{spin:.0f}" for spin in SPINS[1:]]
    lines = [
        f"| blade | {' | '.join(f'w = {head}' for head in heads)} |",
        "|---|" + "---|" * len(heads),
    ]
    exact = {spin: np.array(known(spin)["exact_extensible"][:2]) for spin in SPINS[1:]}
    closed = {spin: np.array(known(spin)["exact_inextensible"][:2]) for spin in SPINS[1:]}

    def line(what: str, found: dict[float, Array]) -> str:
        cells = [
            f"{a:.4f}, {b:.4f}"
            + (
                ""
                if what.startswith("closed")
                else f" ({100 * (a / c - 1):+.2f}, {100 * (b / d - 1):+.2f} %)"
            )
            for (a, b), (c, d) in ((found[spin], exact[spin]) for spin in exact)
        ]
        return f"| {what} | {' | '.join(cells)} |"

    lines.append(line("closed form, stretched", exact))
    lines.append(line("closed form, without stretch", closed))
    lines.append(line("16 beam elements", {w: flap(beams(16), w, exact[w]) for w in exact}))
    by_one = {w: flap(stiffened(), w, closed[w]) for w in exact}
    lines.append(line("1 superelement, `stiffening=True`", by_one))
    for count in COUNTS:
        found = {w: flap(chain(count), w, known(w)[f"se{count}_int2"][:2]) for w in exact}
        text = "superelement" if count == 1 else "superelements"
        lines.append(line(f'{count} {text}, `frame="chord"`', found))
    return "\n".join(lines)


# tops


def top_on_superelements() -> Iterator[Row]:
    """A stem of superelements without modes, in number without end, against one of beams."""
    from superelements import scene_problems as problems

    data = reference("top_flexible_stem_A")["parameters"]
    little, counts = 1e-4, (1, 2, 4, 8)
    upright = np.array([[0.0, 1, 0], [0, 0, 1], [1, 0, 0]])  # x of a beam is z of the ground

    def stem(count: int) -> Any:
        def add(scene: Any, _: float) -> Any:
            last, h = scene.ground, data["L"] / count
            M, K, nodes = spatial_beam(h, 1, 1e2 / little, data["EI"], little, twisting=1e-2)
            B = np.kron(np.eye(4), upright)
            for k in range(count):
                record = cd.superelement.reduce(
                    B @ M @ B.T,
                    B @ K @ B.T,
                    nodes @ upright.T + np.array([0, 0, k * h]),
                    {"root": 0, "tip": 1},
                    node_dofs=IN_SPACE,
                    modes=0,
                )
                part = scene.superelement(f"part{k}", record)
                joint = cd.Fixed() if k else cd.Spherical()
                scene.joint(f"joint{k}" if k else "ball", joint, last, part.at("root"))
                last = part.at("tip")
            return last

        return add

    whole = problems.top(problems.stem_of_beams(16, shear=1e3), little)
    models = [problems.top(stem(count), little, "z") for count in counts]
    for name, case in reference("top_flexible_stem_A")["reference"]["cases"].items():
        spin = float(name.removeprefix("Omega_"))
        expected = np.abs(np.array(case["precession_rates"]) - spin)
        wanted = problems.rates(whole, spin, expected)[1:]
        found = [problems.rates(model, spin, wanted)[1:] for model in models]
        print(f"{name}: errors of {counts} superelements", *(one / wanted - 1 for one in found))
        yield f"{spin:.0f} rad/s, superelements", extrapolated(counts, found), wanted, 1e-4


if __name__ == "__main__":
    print(table())
