"""The measurements behind ``cardan demo``: every figure is taken while the user waits."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from time import perf_counter
from typing import TYPE_CHECKING

import numpy as np

from ..api.scene_file import load
from ..codegen import generate
from ..errors import CompilerMissing
from ..peers.comparison import BATCH, drawn
from ..peers.contest import contest, relative
from ..peers.ours import Ours
from ..peers.urdf import agreement
from ..pipeline import compile, derive
from ..records import dataclass
from ..scene.summary import notes_of

if TYPE_CHECKING:
    from ..api.compiled_model import CompiledModel
    from ..api.trajectory import Trajectory

STATES = 20
TIME = 10.0


@dataclass(frozen=True)
class Tour:
    """Contents of the screen.

    Attributes:
        graph: Drawing of bodies and joints.
        bodies: Their number.
        derived: Time from file to C text of forward dynamics [s].
        operations: In that text.
        compiled: Time to compile, load and check it [s].
        python: Without a compiler: its expressions are evaluated in Python.
        lines: Six lines of the C.
        call: Time of one forward dynamics [s].
        state: The same per state of a batch [s].
        error: Largest relative error of udot against 40 digits.
        peer: Largest relative difference from Pinocchio, None where it is not installed.
        simulated: Time of the simulation [s].
        steps: Steps it took.
        energy_residual: Energy unaccounted for over the largest kinetic energy.
        notes: What the file says and the model does not act on.
        files: What was written.
        page: Of these the one that plays the motion.
    """

    graph: str
    bodies: int
    derived: float
    operations: int
    compiled: float
    python: bool
    lines: tuple[str, ...]
    call: float
    state: float
    error: float
    peer: float | None
    simulated: float
    steps: int
    energy_residual: float
    notes: tuple[str, ...]
    files: tuple[Path, ...]
    page: Path


def take(
    path: Path,
    packages: Sequence[Path],
    out: Path,
    q: Mapping[str, float],
    show: Callable[..., None],
    picture: bool,
) -> Tour:
    """Go the whole way with a URDF.

    Args:
        path: The file.
        packages: Folders from which it names meshes.
        out: Folder for what is written.
        q: Where the simulation starts.
        show: Receives the name of each step.
        picture: Draw the plot, which needs matplotlib.
    """
    show("deriving")
    start = perf_counter()
    scene = load(path, packages=packages, limits="stop", friction=True)
    equations = derive(scene)
    text = generate(equations.function("forward_dynamics"), model=equations.system.name)
    derived = perf_counter() - start

    show("compiling")
    model = compile(equations, directory=out / "c")
    state = np.zeros(model.nq), np.zeros(model.nu)
    start = perf_counter()
    model.forward_dynamics(*state)
    compiled = perf_counter() - start

    show("measuring")
    call, batch, error = speed_and_error(model)
    show("comparing with Pinocchio")
    peer = agreement(path)

    show("simulating")
    # the first run compiles the integrator
    model.simulate(1e-3, q=dict(q))
    start = perf_counter()
    motion = model.simulate(TIME, q=dict(q), rtol=1e-10, atol=1e-12)
    simulated = perf_counter() - start
    show("drawing")
    files = write(motion, out, picture)
    kinetic = motion.energy.kinetic.max()
    return Tour(
        graph=str(scene.graph),
        bodies=len(equations.system.bodies),
        derived=derived,
        operations=text.entry.total_operations,
        compiled=compiled,
        python=model._function("forward_dynamics").interpreted,
        lines=excerpt(
            text.text,
            [joint.name for joint in equations.system.joints],
            [body.name for body in equations.system.bodies],
        ),
        call=call,
        state=batch,
        error=error,
        peer=peer,
        simulated=simulated,
        steps=int(motion.statistics["steps"]),
        energy_residual=float(np.abs(motion.energy_residual).max() / kinetic),
        notes=tuple(notes_of(scene)),
        files=files,
        page=page_of(out),
    )


def speed_and_error(model: CompiledModel) -> tuple[float, float, float]:
    """Seconds per forward dynamics, alone and in a batch, and its error against 40 digits."""
    name, ours, states = "forward_dynamics", Ours(model), drawn(model, STATES)
    try:
        runs = {"call": ours.start(name, states), "state": ours.batch(name, drawn(model, BATCH))}
    except CompilerMissing:
        # Python takes the states of a batch one by one: few of them tell how long it needs
        runs = {way: ours.batch(name, states) for way in ("call", "state")}
    times = contest(runs)
    error = relative(ours.results(name, states), ours.exact(name, states))
    return times["call"].least, times["state"].least, error


def excerpt(text: str, joints: Sequence[str], bodies: Sequence[str]) -> tuple[str, ...]:
    """Six neighboring products of the C: those with most names of joints and bodies."""
    lines = [line.strip() for line in text.splitlines()]
    # C names spell what is not a letter or digit as _
    moving, owners = (
        "|".join(re.sub(r"\W", "_", name) for name in names)
        for names in (joints, (*joints, *bodies))
    )
    speaks, owned = re.compile(rf"\b({moving})_"), re.compile(rf"const real ({owners})_")
    # products that fit on one line; other lines may stand between a few
    assignments = [
        i for i, line in enumerate(lines) if re.match(r"const real \w+ = .* \* .*;", line)
    ]
    windows = [
        [lines[i] for i in assignments[k : k + 6]]
        for k in range(len(assignments) - 5)
        if assignments[k + 5] - assignments[k] <= 16
    ]

    def quality(window: list[str]) -> tuple[int, int]:
        # among equals the short lines read best
        names = sum(bool(owned.match(line)) + bool(speaks.search(line)) for line in window)
        return names, -sum(map(len, window))

    best = max(windows, key=quality) if windows else []
    return tuple(best)


def page_of(out: Path) -> Path:
    """The page that plays the motion."""
    return out / "motion.html"


def write(motion: Trajectory, out: Path, picture: bool) -> tuple[Path, ...]:
    """The page, the numbers and, where it can be drawn, the plot."""
    page, data, plot = page_of(out), out / "motion.nc", out / "motion.png"
    motion.animate(page)
    motion.save(data)
    if picture:
        motion.plot(plot)
    return (*((plot,) if picture else ()), page, data, out / "c" / "forward_dynamics.c")
