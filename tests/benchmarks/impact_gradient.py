"""Gradients through one impact: cardan, Brax and MuJoCo MJX beside the closed form.

Writes docs/performance/impact_gradient.md and its picture. Needs ``pip install brax mujoco-mjx``;
takes minutes, which JAX compiles.

usage: impact_gradient.py [--quick]
"""

from __future__ import annotations

import argparse
import platform
import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

# the benchmarks stand in the folder above
sys.path.insert(0, str(Path(__file__).parents[1]))

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from rich.console import Console
from rich.table import Table

import cardan as cd
from benchmarks.impact_peers import Array, Engine, Throw, engines, jax, mjx
from benchmarks.page import markdown
from benchmarks.provenance import signed
from cardan.peers.processor import name as processor

FOLDER = Path(__file__).parents[2] / "docs" / "performance"
THROW = Throw(radius=0.1, restitution=0.8, speed=2.0, t=0.5)
GRAVITY = {"without gravity": 0.0, "with gravity": 9.81}
# no multiples of what a step goes
HEIGHTS = np.linspace(0.3037, 0.8963, 41)
SHOWN = HEIGHTS[4::8]
OURS = "cardan"
SHADES = ("#1b6ca8", "#c8553d", "#e0a030", "#5a8f4e", "#8a6aa8", "#12355b", "#888888")
TEXT = """# A gradient through one impact

A ball of 1 kg and radius 0.1 m at the height h is thrown down with v = 2 m/s. It meets the floor
once and keeps e = 0.8 of its speed. Where is it after 0.5 s, and what does that change by with h
and v? Written by `tests/benchmarks/impact_gradient.py`; {versions}.

Without gravity z = r + e (v t - h + r): who starts higher meets the floor later, and is lower at
the end. So dz/dh = -e. With gravity v' = sqrt(v^2 + 2 g (h - r)), t' = (v' - v) / g and
z = r + e v' (t - t') - g (t - t')^2 / 2.

![heights at the end, and the slopes that programs tell](impact_gradient.svg)

"""
NOTES = """
Errors are the largest of {count} starts between h = {least:.2f} m and {most:.2f} m; *wrong signs*
are starts at which the derivative has another sign than the true one (✗).

**Why.** A step is either free or in contact. Automatic differentiation takes this as decided: the
*time* of the impact does not move. Brax's impulse turns the speed around at the end of a step, and
dz/dh = 1 as if there was no floor. Where the depth is corrected in the same step, the correction
of the depth, divided by the step or not, comes on top: it has no relation to the motion. MuJoCo's
contact is a spring with a damper. The part of the damper begins with a jump, and how the time of
this jump moves is missing, however small the steps; it counts the more, the stiffer the contact is.
{undamped}

Values are right, to what the tables say: it is their derivatives alone that are not. cardan finds
the time of the impact and differentiates it ([gradients](../gradients.md#what-is-differentiated)).

**What was set.** Brax has its restitution from `elasticity`; other settings are its defaults but
for what the table says. Its generalized pipeline has no restitution: it and MJX have springs and
dampers for which MuJoCo's ball keeps e of its speed. All numbers are of double precision.
Derivatives are those of forward mode; reverse mode does not go through the loop of MJX's solver.

Others on the same scenes: [issue 317 of Brax](https://github.com/google/brax/issues/317) has the
one without gravity; Paulus et al., *Differentiable simulation of hard contacts with soft gradients
for learning and control* (2025), measure MJX.
"""


@dataclass(frozen=True)
class Sweep:
    """What a program makes of all starts.

    Attributes:
        name, settings: Of the program.
        z: Heights at the end, by scene (n,).
        slopes: By height and speed at the start, by scene (n, 2).
    """

    name: str
    settings: str
    z: dict[str, Array]
    slopes: dict[str, Array]


def exact(heights: Array, g: float) -> tuple[Array, Array]:
    """Heights at the end and their derivatives, by the formulas of the page."""
    r, e, v, t = THROW.radius, THROW.restitution, THROW.speed, THROW.t
    if g == 0:
        slopes = np.broadcast_to([-e, e * t], (len(heights), 2))
        return r + e * (v * t - heights + r), slopes
    hit = np.sqrt(v**2 + 2 * g * (heights - r))
    left = t - (hit - v) / g
    z = r + e * hit * left - g * left**2 / 2
    # of the speed at the impact, and of the time that is left
    by_hit, by_left = e * left, e * hit - g * left
    by_height = by_hit * g / hit - by_left / hit
    by_speed = by_hit * v / hit - by_left * (v / hit - 1) / g
    return z, np.stack([by_height, by_speed], axis=1)


def ball() -> cd.CompiledModel:
    """The ball, whose height is that of its center."""
    scene = cd.Scene("ball", gravity=(0, 0, -9.81))
    scene.joint("z", cd.Prismatic("z"), scene.ground, scene.body("ball", mass=1.0))
    floor = cd.Stop("z", lower=THROW.radius, restitution=THROW.restitution)
    scene.force("floor", floor)
    return cd.compile(scene)


def ours(heights: Array, gravity: Array) -> tuple[Array, Array]:
    """Heights at the end and their derivatives by :meth:`cardan.CompiledModel.gradient`."""
    model, cost = ball(), cd.cost(final="z")
    z, slopes = [], []
    for h, g in zip(heights, gravity, strict=True):
        found = model.gradient(
            THROW.t, cost, wrt=("q0.z", "u0.z"), q={"z": float(h)}, u={"z": -THROW.speed},
            parameters={"gravity.z": -float(g)},
        )  # fmt: skip
        z.append(found.value)
        slopes.append([found.slope["q0.z"], -np.asarray(found.slope["u0.z"])])
    return np.array(z), np.array(slopes, dtype=float)


def sweeps(tried: Sequence[Engine]) -> Iterator[Sweep]:
    """All programs over all starts, of both scenes at once."""
    heights = np.tile(HEIGHTS, len(GRAVITY))
    gravity = np.repeat(list(GRAVITY.values()), len(HEIGHTS))
    settings = "`model.gradient`, defaults"
    own = Engine(f"{OURS} {cd.__version__}", settings, lambda _, h, g: ours(h, g))
    for engine in (own, *tried):
        z, slopes = engine.run(THROW, heights, gravity)
        parts = [np.split(values, len(GRAVITY)) for values in (z, slopes)]
        by_scene = [dict(zip(GRAVITY, part, strict=True)) for part in parts]
        print(engine.name, engine.settings)
        yield Sweep(engine.name, engine.settings, *by_scene)


def undamped() -> str:
    """A sentence on a contact without a damper, whose force begins with 0."""
    throw, height = replace(THROW, restitution=1.0), np.array([0.5])
    slope = mjx(1e4, 1e-4)(throw, height, np.zeros(1))[1][0, 0]
    return f"Without the damper (e = 1, no gravity) MJX tells dz/dh = {slope:.3f}; -1 is right."


HEADINGS = (
    "program", "settings", "error of z [m]", "dz/dh", "error of it", "wrong signs", "dz/dv",
    "error of it", "wrong signs",
)  # fmt: skip


def summary(scene: str, found: Sequence[Sweep]) -> list[tuple[str, ...]]:
    """A row for each program."""
    z, slopes = exact(HEIGHTS, GRAVITY[scene])
    rows = [("closed form", "", "", between(slopes[:, 0]), "", "", between(slopes[:, 1]), "", "")]
    for sweep in found:
        cells = [sweep.name, sweep.settings, f"{np.abs(sweep.z[scene] - z).max():.0e}"]
        for k in range(2):
            own, true = sweep.slopes[scene][:, k], slopes[:, k]
            wrong = int(np.sum(np.sign(own) != np.sign(true)))
            error = f"{np.abs(own - true).max():.1g}"
            cells += [between(own), error, f"**{wrong} of {len(own)}**" if wrong else "none"]
        rows.append(tuple(cells))
    return rows


def between(values: Array) -> str:
    """Least and greatest of some values."""
    least, most = values.min(), values.max()
    same = most - least <= 1e-6 * abs(most)
    return f"{least:.3g}" if same else f"{least:.3g} to {most:.3g}"


def starts(scene: str, found: Sequence[Sweep]) -> tuple[tuple[str, ...], list[tuple[str, ...]]]:
    """Headings, and a row for the value and one for the slope at some starts."""
    places = [int(np.abs(HEIGHTS - h).argmin()) for h in SHOWN]
    z, slopes = exact(HEIGHTS, GRAVITY[scene])
    rows = []
    for k in places:
        values = (z[k], *(sweep.z[scene][k] for sweep in found))
        rows.append((f"{HEIGHTS[k]:.4f}", "z [m]", *(f"{x:.5f}" for x in values)))
        told = [sweep.slopes[scene][k, 0] for sweep in found]
        marks = ["" if np.sign(x) == np.sign(slopes[k, 0]) else " ✗" for x in told]
        cells = (f"{x:.4g}{mark}" for x, mark in zip(told, marks, strict=True))
        rows.append(("", "dz/dh", f"{slopes[k, 0]:.4g}", *cells))
    return ("h [m]", "", "closed form", *labels(found)), rows


def labels(found: Sequence[Sweep]) -> list[str]:
    """Short names of programs, told apart by their settings."""
    short = {"erp 0": "no correction", "stiffness 1e4": "1e4 N/m", "stiffness 1e5": "1e5 N/m"}
    result = []
    for sweep in found:
        first = " ".join(word for word in sweep.name.split() if not word[0].isdigit())
        notes = [text for key, text in short.items() if key in sweep.settings]
        result.append(", ".join([first, *notes]))
    return result


def draw(found: Sequence[Sweep]) -> None:
    """Heights at the end over those at the start, with the slopes that programs tell."""
    style = {"svg.hashsalt": "cardan", "svg.fonttype": "none", "font.size": 9}
    with mpl.rc_context(style):
        figure = Figure(figsize=(9, 4.2), layout="constrained")
        both: Any = figure.subplots(1, len(GRAVITY))
        for axes, (scene, g) in zip(both, GRAVITY.items(), strict=True):
            axes.plot(HEIGHTS, exact(HEIGHTS, g)[0], color="#bbbbbb", lw=5, label="closed form")
            width, height = np.ptp(HEIGHTS), np.ptp(exact(HEIGHTS, g)[0])
            for sweep, label, shade in zip(found, labels(found), SHADES, strict=False):
                # ours on top, since it lies on the closed form
                above = 4 if label == OURS else 2
                axes.plot(HEIGHTS, sweep.z[scene], color=shade, lw=0.9, label=label, zorder=above)
                for k in range(4, len(HEIGHTS), 8):
                    # as long as others, whatever its slope
                    slope = sweep.slopes[scene][k, 0]
                    along = 0.045 / np.hypot(1 / width, slope / height)
                    x, y = HEIGHTS[k], sweep.z[scene][k]
                    ends = [x - along, x + along], [y - slope * along, y + slope * along]
                    axes.plot(*ends, color=shade, lw=2.2, solid_capstyle="round", zorder=above)
            axes.set(title=scene, xlabel="height at the start h [m]", ylabel="z after 0.5 s [m]")
            axes.grid(alpha=0.25)
        both[0].legend(frameon=False, fontsize=7)
        figure.savefig(FOLDER / "impact_gradient.svg", metadata={"Date": None})


def main() -> int:
    """Measure, write, print."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--quick", action="store_true", help="cardan and Brax's springs, no page")
    quick = parser.parse_args().quick
    found = list(sweeps(engines()[:1] if quick else engines()))
    parts = []
    for scene in GRAVITY:
        rows = summary(scene, found)
        table = Table(*HEADINGS, title=scene)
        for row in rows:
            table.add_row(*row)
        Console(width=180).print(table)
        parts += [f"## {scene[0].upper()}{scene[1:]}", "", *markdown(HEADINGS, rows), ""]
        headings, lines = starts(scene, found)
        parts += [*markdown(headings, lines), ""]
    if not quick:
        draw(found)
        versions = f"{processor()}, Python {platform.python_version()}, JAX {jax().__version__}"
        text = TEXT.format(versions=versions) + "\n".join(parts)
        least, most = HEIGHTS[0], HEIGHTS[-1]
        notes = {"count": len(HEIGHTS), "least": least, "most": most, "undamped": undamped()}
        text += NOTES.format(**notes)
        (FOLDER / "impact_gradient.md").write_text(signed(text), "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
