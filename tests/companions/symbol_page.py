"""Writes docs/companions/symbols.md, and one page in the notation of every book."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory

import cardan as cd
from cardan.equations.reading.book_symbols import BOOKS, DEFAULT, NOTATIONS, TABLE

ROOT = Path(__file__).parents[2]
FOLDER = "docs/companions"
BOOK_KEYS = tuple(key for key in BOOKS if key != DEFAULT)
# quantity -> what holds or computes it
CALLS = {
    "coordinates": "`model.coordinates`, `q`",
    "speeds": "`model.speeds`, `u`",
    "kinematic_matrix": "`model.qdot(q, u)`, `equations.kinematics`",
    "incidence": "`scene.graph.incidence`",
    "paths": "`scene.graph.path`",
    "joint_modes": "`model.frame_jacobian(frame, q)` of one joint",
    "mass_matrix": "`model.mass_matrix(q)`",
    "bias": "`model.bias(q, u)` = `gravity` + `coriolis`",
    "applied_forces": "`model.applied_forces(q, u)`",
    "outer_forces": "`tau=`, `wrenches=`",
    "active_forces": "`applied_forces` - `gravity`",
    "inertia_forces": "-(`mass_matrix` udot + `coriolis`)",
    "partial_velocities": "`model.frame_jacobian(frame, q)`, rows 4 to 6",
    "partial_angular_velocities": "`model.frame_jacobian(frame, q)`, rows 1 to 3",
    "constraints": "`model.constraints(q)`",
    "constraint_jacobian": "`equations.constraint_jacobian`",
    "constraint_bias": "`equations.constraint_bias`",
    "multipliers": "`model.multipliers(q, u)`",
    "energy": "`model.energy(q, u).total`",
    "kinetic_energy": "`model.energy(q, u).kinetic`",
    "potential_energy": "`model.energy(q, u).potential`",
    "linear_momentum": "`model.momentum(q, u)[3:]`",
    "angular_momentum": "`model.momentum(q, u)[:3]`",
    "momentum": "`equations.conserved()`",
    "mass": '`cd.vectors(equations).mass("upper")`',
    "center_of_mass": '`cd.vectors(equations).center_of_mass("upper")`',
    "inertia": '`cd.vectors(equations).inertia("upper")`',
    "gravity": "`cd.Scene(gravity=)`",
    "base_mass": "`equations.base_parameters()`",
    "base_moment": "`equations.base_parameters()`",
    "base_inertia": "`equations.base_parameters()`",
    "rotation": "`model.pose(frame, q)[:3, :3]`",
    "position": "`model.pose(frame, q)[:3, 3]`",
    "angular_velocity": '`model.velocity(frame, q, u, in_="frame")[:3]`',
    "velocity": "`model.velocity(frame, q, u)[3:]`",
    "balance": "`model.residual(...)`, rows of a node",
    "force": "`model.reaction(joint, q, u)[3:]`",
    "moment": "`model.reaction(joint, q, u)[:3]`",
    "unit_matrix": "",
}
HEAD = """\
# Symbols of three books

`equations.explain("page.html", notation="rs")` writes a page of equations in the symbols of a
book, `cardan inspect scene.yaml -o page.md --notation kane` does so on the command line. Pages of
[a four-bar](pages/rs.md), of [a double pendulum over nodes](pages/gc.md) and of
[a double pendulum](pages/kane.md) show the three notations. This list is written from the same
table as the pages:

| notation | book |
|---|---|
"""
RULES = """
Symbols with the mark ° are ours: the book has none for the quantity, or none that we could
confirm. They were chosen so that no letter of a notation has two meanings. The symbols without the
mark are from the literature of the authors; they were not compared with the printed lists entry by
entry. For Roberson and Schwertassek, the state variables z_I and z_II are those of R. Schwertassek
and O. Wallrapp, Dynamik flexibler Mehrkörpersysteme (1999).

| quantity | cardan | in cardan | Roberson, Schwertassek | Géradin, Cardona | Kane, Levinson |
|---|---|---|---|---|---|
"""
NOTES = """
## What differs beyond letters

- **Multipliers.** Our balance is M u̇ + h = f + τ + Gᵀ λ, with +Gᵀ λ on the side of forces. Géradin
  and Cardona write M q̈ + Bᵀ λ = g: their λ is ours with the opposite sign.
- **Speeds.** Velocity variables need not be rates of coordinates: a spherical or free joint has the
  angular velocity of the child in its own axes (Ω of Géradin and Cardona, the material one).
- **Kane's forces.** F_r contains the weight of the bodies, our f does not: F = f - gravity, and
  F* = -(M u̇ + coriolis), where `bias` = `gravity` + `coriolis`.
- **Rotations.** R, A and C here take coordinates in axes of the frame to coordinates in axes of the
  ground. Kane and Levinson's matrix of direction cosines and the matrix A of Roberson and
  Schwertassek carry the two frames as indices: check which way round a formula uses them.
- **Quaternions** are Euler parameters with the scalar first.
- **6-vectors** have the angular part first.
- **Letters of elements.** In formulas of beams, forces and joints over nodes, a letter that the
  book uses for a quantity of this table has a bar.
- Letters that cardan's own pages use twice: g (gravity, with the index of an axis; constraints,
  with the name of a row), p (position; momentum, with the name of a speed), M (mass matrix; moment
  on an end), I (inertia; unit matrix).
"""


def page() -> str:
    """``docs/companions/symbols.md``."""
    books = "".join(f'| `"{key}"` | {BOOKS[key]} |\n' for key in BOOK_KEYS)
    rows = [
        f"| {about} | {_shown(DEFAULT, quantity)} | {CALLS[quantity]} | "
        + " | ".join(_shown(key, quantity) for key in BOOK_KEYS)
        + " |"
        for quantity, about, *_ in TABLE
    ]
    return HEAD + books + RULES + "\n".join(rows) + "\n" + NOTES


def _shown(key: str, quantity: str) -> str:
    book = NOTATIONS[key]
    return f"${book.sign(quantity).latex()}$" + "°" * (quantity in book.ours)


def four_bar() -> cd.Scene:
    """A plane loop: rs."""
    scene = cd.Scene("four_bar", gravity=(0, -9.81, 0))
    a, b, c = (
        scene.parameter(name, value, unit="m") for name, value in (("a", 1), ("b", 3), ("c", 2))
    )
    m = scene.parameter("m", 1.0, unit="kg")
    crank, coupler, rocker = (
        scene.body(name, mass=m, com=(length / 2, 0, 0), inertia=(0, 0, 0))
        for name, length in (("crank", a), ("coupler", b), ("rocker", c))
    )
    scene.joint("A", cd.Revolute("z"), scene.ground, crank)
    scene.joint("B", cd.Revolute("z"), crank.at(a, 0, 0), coupler)
    scene.joint("D", cd.Revolute("z"), scene.ground.at(3, 0, 0), rocker)
    scene.joint("C", cd.Revolute("z"), coupler.at(b, 0, 0), rocker.at(c, 0, 0), cut=True)
    return scene


def double_pendulum() -> cd.Scene:
    """Two links: kane, and over nodes gc."""
    scene = cd.Scene("double_pendulum", gravity=(0, 0, -9.81))
    m, l = scene.parameter("m", 1.0, unit="kg"), scene.parameter("l", 0.5, unit="m")
    rod = {"mass": m, "com": (0, 0, -l / 2), "inertia": cd.inertia.rod(m, l, axis="z")}
    upper, lower = scene.body("upper", **rod), scene.body("lower", **rod)
    scene.joint("theta1", cd.Revolute("y"), scene.ground, upper)
    scene.joint("theta2", cd.Revolute("y"), upper.at(0, 0, -l), lower)
    return scene


def written() -> Iterator[tuple[str, str]]:
    """Files by their path in the project."""
    yield f"{FOLDER}/symbols.md", page()
    scenes = {
        "rs": cd.derive(four_bar()),
        "gc": cd.derive(double_pendulum(), coordinates="absolute"),
        "kane": cd.derive(double_pendulum()),
    }
    for key, equations in scenes.items():
        with TemporaryDirectory() as folder:
            path = equations.explain(Path(folder) / f"{key}.md", notation=key)
            for made in (path, path.with_suffix(".svg")):
                yield f"{FOLDER}/pages/{made.name}", made.read_text("utf-8")
