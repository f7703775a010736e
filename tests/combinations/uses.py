"""What is done with a combination besides running it, each against an independent route."""

from __future__ import annotations

import subprocess
import tempfile
import warnings
from collections.abc import Callable
from pathlib import Path
from typing import Any

import numpy as np

import cardan as cd
from cardan.runtime.build import cache

from .mechanism import SPAN
from .routes import FINE, OUTPUTS, Names, Route, other_route, places, route

# Newton's method ends where forces are rounding; what is soft is further off
REST = 1e-7
EIGEN = 1e-5
EXPORTED = 1e-8
# two runs that pass the kinks of tables at different steps are apart by 600 times the tolerance
FINEST = {**FINE, "rtol": 1e-12, "atol": 1e-14}
TOLERANCES = ", ".join(f".{name} = {FINEST[name]}" for name in ("rtol", "atol"))
# with dry friction places of rest fill sets, and no two searches end in the same place (Coulomb's
# law is set-valued at rest: Pfeiffer and Glocker, Multibody Dynamics with Unilateral Contacts, 3)
HANGING = {"shoulder": 1.5, "elbow": 0.1}
AT_STOP = {"shoulder": 0.39, "elbow": 1.2}
DRY = {"Coulomb friction", "friction from reaction"}


def equilibrium(names: Names) -> None:
    """Rest is the same place in both kinds of coordinates, and accelerations vanish there."""
    mine, theirs = route(names), other_route(names)
    here = resting(mine)

    def rests(q: Any, z: Any) -> bool:
        rates = mine.model.forward_dynamics(q, here.u, z=z, t=here.t, s=here.point.at.s)
        return bool(np.abs(rates - here.point.at.udot).max() < 1e-5)

    assert rests(here.q, mine.model.parts_of(here.x)[2])
    if {*names} & DRY:
        return
    there = resting(theirs, q=joints_of(mine, here, theirs))
    if any(row.level == "velocity" for row in mine.model.manifest.multipliers):
        # what rolls rests in sets of places: the other one must belong to the same set
        # (J. I. Neimark, N. A. Fufaev, Dynamics of Nonholonomic Systems, chapter 5)
        model = mine.model
        named = [
            [there.named[name] for name in part] for part in (model.coordinates, model.internals)
        ]
        assert rests(*map(np.array, named))
        return
    np.testing.assert_allclose(outputs(mine, here), outputs(theirs, there), atol=REST)


def joints_of(mine: Route, here: cd.Equilibrium, theirs: Route) -> dict[str, Any]:
    """The joints of a position, as those of another model: it may rest in several places."""
    return {
        row.name: here.q[slice(row.q[0], row.q[0] + row.q[1])]
        for row in mine.model.manifest.joints
        if row.q and row.q[1] and row.name in theirs.model.joints
    }


def resting(side: Route, **start: Any) -> cd.Equilibrium:
    """Rest, with what is prescribed moving as prescribed."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", cd.SolveWarning)
        found = side.model.equilibrium(u={}, **start)
        if not (found.converged or start):
            # the cure that the message names: nearer to where the bars hang
            near = AT_STOP if "bump" in side.made.scene.forces else HANGING
            found = side.model.equilibrium(u={}, q=near)
    assert found.converged, found.message
    return found


def outputs(side: Route, point: Any) -> Any:
    """Where the tip and the forearm are at a state."""
    model = side.model
    q, u, z = model.parts_of(point.x)
    values = model.outputs(q, u, z=z)
    names = [row.name for row in model.manifest.outputs]
    return np.array([values[names.index(name)] for name in OUTPUTS])


def linearize(names: Names) -> None:
    """Small motions about the start are the same in both kinds.

    Where both take the same increments the matrices are; about a place of rest eigenvalues are,
    whatever the coordinates.
    """
    sides = route(names), other_route(names)
    ours, other = (side.model.linearize(side.model.initial()) for side in sides)
    if {*ours.states} == {*other.states}:
        order = [other.states.index(name) for name in ours.states]
        matrix = other.A[np.ix_(order, order)]
        size = np.abs(ours.A).max(initial=1.0)
        np.testing.assert_allclose(ours.A, matrix, atol=EIGEN * size)
    elif not {*names} & DRY:
        here = resting(sides[0])
        there = resting(sides[1], q=joints_of(sides[0], here, sides[1]))
        rests = zip(sides, (here, there), strict=True)
        one, two = (side.model.linearize(rest).eigenvalues for side, rest in rests)
        assert one.shape == two.shape, (one.shape, two.shape)
        gaps = np.abs(one[:, None] - two).min(axis=1)
        assert gaps.max(initial=0.0) < EIGEN * np.abs(one).max(initial=1.0), gaps


def ensemble(names: Names) -> None:
    """Runs of an ensemble are those of single runs, to the bit."""
    side = route(names)
    starts, inputs = np.array([0.0, 0.1]), side.made.inputs or None
    together = side.model.ensemble(SPAN, u={"shoulder": starts}, inputs=inputs)
    for k, start in enumerate(starts):
        alone = side.model.simulate(SPAN, u={"shoulder": start}, inputs=inputs)
        np.testing.assert_array_equal(together.run(k).x[-1], alone.x[-1])


def checkpoint(names: Names) -> None:
    """A run that goes on from a file has the same bits."""
    side = route(names)
    # a stepper takes numbers
    inputs = dict.fromkeys(side.made.inputs, 1.0) or None
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "run.npz"
        stepper = side.model.stepper(inputs=inputs)
        stepper.step(SPAN / 2)
        stepper.save(file)
        further = side.model.resume(file)
        np.testing.assert_array_equal(stepper.step(SPAN / 3), further.step(SPAN / 3))


def export(names: Names) -> None:
    """The exported C compiles alone and ends where the model ends."""
    side = route(names)
    made = side.made
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder)
        sources = cd.derive(made.scene).export(out / "c", language="c", integrators=["dop853"])
        example = sources / "example.c"
        example.write_text(
            example.read_text().replace(".end = 1,", f".end = {SPAN}, {TOLERANCES},")
        )
        command = [*cache.compiler().command, "-std=c99", "-O1", "-DCARDAN_EXAMPLE"]
        files = map(str, sorted(sources.glob("*.c")))
        command += ["-o", str(out / "run"), *files, "-lm"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        assert done.returncode == 0, done.stderr
        said = subprocess.run([str(out / "run")], capture_output=True, text=True, check=False)
        assert said.returncode == 0, said.stderr
    x = [float(line.split("=")[1]) for line in said.stdout.splitlines() if line.startswith("x[")]
    motion = side.model.simulate(SPAN, **FINEST)
    np.testing.assert_allclose(x, motion.x[-1], rtol=EXPORTED, atol=EXPORTED)


def save(names: Names) -> None:
    """A saved run has the same numbers, and a saved scene the same motion."""
    side = route(names)
    motion = side.run()
    with tempfile.TemporaryDirectory() as folder:
        motion.save(Path(folder) / "run.nc")
        again = cd.load_motion(Path(folder) / "run.nc")
        np.testing.assert_array_equal(again.x, motion.x)
        np.testing.assert_array_equal(places(again), places(motion))
        side.made.scene.save(Path(folder) / "scene.yaml")
        scene = cd.load(Path(folder) / "scene.yaml")
    other = Route(side.made, cd.compile(scene)).run()
    np.testing.assert_allclose(places(other), places(motion), atol=1e-9)


USES: dict[str, Callable[[Names], None]] = {
    use.__name__: use for use in (equilibrium, linearize, ensemble, checkpoint, export, save)
}
