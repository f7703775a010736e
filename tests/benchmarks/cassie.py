"""Cassie, from its SDF file, beside Pinocchio and MuJoCo: speed, error and drift in one run.

    python tests/benchmarks/cassie.py

prints the tables and writes docs/performance/cassie.md. Needs example-robot-data, Pinocchio with
its headers (extra bench) and MuJoCo.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from importlib.metadata import version
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np

ROOT = Path(__file__).parents[2]
sys.path[:0] = [str(ROOT), str(ROOT / "tests")]

from tests.benchmarks.provenance import signed  # noqa: E402

import cardan as cd  # noqa: E402
from cardan.peers import coordinates  # noqa: E402
from cardan.peers.circuits import Circuits, circuits  # noqa: E402
from cardan.peers.comparison import compare, drawn  # noqa: E402
from cardan.peers.contest import few, relative  # noqa: E402
from cardan.peers.ours import Ours  # noqa: E402
from mechanisms.robots import folder  # noqa: E402

PAGE = ROOT / "docs" / "performance" / "cassie.md"
FILE = "cassie_description/robots/cassie_v2.sdf"
MOTORS = ("roll-op", "yaw-op", "pitch-op", "knee-op", "foot-op")
# ten motors, and the springs of the shins: the freedoms of the robot on a fixed pelvis
FREE = [f"{side}-{name}" for side in ("left", "right") for name in (*MOTORS, "knee-shin-joint")]
BENT = {"left-knee-op": -0.6, "right-pitch-op": 0.4}
END, COUNT, EXACT, ROUNDS, REPEATS = 10.0, 32, 3, 9, 5
TIGHT = 1e-11
PEERS = ("pinocchio", "mujoco")
ACTUATORS = "forces of the actuators"


def robot(base: str = "fixed", forces: bool = True) -> cd.Scene:
    """The scene, without springs and dampers where programs shall compute the same."""
    scene = cd.load(folder() / FILE, base=base, packages=folder().parents[1])
    if not forces:
        scene.forces.clear()
    return scene


def per_state(call: Callable[[], object]) -> float:
    """Microseconds per state of a call that treats ``COUNT`` of them; the best round."""
    best = np.inf
    for _ in range(ROUNDS):
        began = perf_counter()
        for _ in range(REPEATS):
            call()
        best = min(best, (perf_counter() - began) / REPEATS)
    return 1e6 * float(best) / COUNT


@dataclass(frozen=True)
class Functions:
    """Functions of the bare mechanism at random states on its constraints."""

    model: cd.CompiledModel

    @cached_property
    def states(self) -> Any:
        return drawn(self.model, COUNT)

    @cached_property
    def udot(self) -> np.ndarray:
        """Accelerations at the states."""
        states = self.states
        return self.model.forward_dynamics(states.q, states.u, tau=states.third)

    @cached_property
    def pinocchio(self) -> Any:
        """Its model with the loops held together, for calls from Python."""
        from external.closed import Constrained

        loops = circuits(self.model)
        assert isinstance(loops, Circuits), loops
        return Constrained(loops)

    def rows(self) -> list[str]:
        """Lines of the table."""
        names = ("forward_dynamics", "derivatives", "inverse_dynamics")
        comparison = compare(self.model, names, PEERS, ROUNDS)
        lines: dict[str, list[str]] = {name: [] for name in (*names, "at the actuators")}
        for row in comparison.rows:
            time, error = 1e6 * row.time.least, f"{row.error:.0e}" if row.error else "-"
            lines[row.function].append(line(row.function, row.title, f"{time:.2f} µs", error))
        for name, why in comparison.absent.items():
            print(f"{name} does not take part: {why}")
        lines["at the actuators"].append(self.actuation())
        if "pinocchio" not in comparison.absent:
            lines["derivatives"].append(self.their_derivatives())
            lines["at the actuators"].append(self.their_actuation())
        return [text for group in lines.values() for text in group]

    def their(self, k: int) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
        """q, v and tau of a state in Pinocchio's order."""
        states, change = self.states, self.pinocchio.map
        one = slice(k, k + 1)
        q, u = states.q[one], states.u[one]
        return change.q(q)[0], change.speeds(q, u)[0], change.speeds(q, states.third[one])[0]

    @cached_property
    def order(self) -> list[int]:
        """Pinocchio's speed behind each of ours."""
        n = self.model.nu
        rows = self.pinocchio.map.speeds(np.broadcast_to(self.states.q[:1], (n, n)), np.eye(n))
        return [int(np.flatnonzero(row)[0]) for row in rows]

    def their_derivatives(self) -> str:
        """Pinocchio's derivatives by q and v; the error along motions that the loops allow."""
        import pinocchio as pin

        peer = self.pinocchio
        settings = pin.ProximalSettings(1e-12, 1e-10, 5)
        loops = (peer.models, peer.datas, settings)
        states = [self.their(k) for k in range(COUNT)]

        def once(k: int) -> Any:
            pin.constraintDynamics(peer.model, peer.data, *states[k], *loops)
            return pin.computeConstraintDynamicsDerivatives(peer.model, peer.data, *loops)

        exact = Ours(self.model).exact("derivatives", few(self.states, EXACT))
        worst = [0.0, 0.0]
        for k in range(EXACT):
            G = self.model.constraint_jacobian(self.states.q[k])
            along = np.linalg.svd(G)[2][np.linalg.matrix_rank(G) :].T
            parts = once(k)
            for which in (0, 1):
                found = parts[which][np.ix_(self.order, self.order)] @ along
                error = relative(found[None], (exact[k, which] @ along)[None])
                worst[which] = max(worst[which], error)
        time = per_state(lambda: [once(k) for k in range(COUNT)])
        title = f"Pinocchio {pin.__version__} from Python, forward dynamics included"
        return line(
            "derivatives", title, f"{time:.1f} µs", f"{worst[0]:.0e} by q, {worst[1]:.0e} by u"
        )

    def actuation(self) -> str:
        """Our forces of the actuators."""
        states, udot = self.states, self.udot
        found = self.model.actuation(states.q, states.u, udot, FREE)
        back = self.model.forward_dynamics(states.q, states.u, tau=found.tau)
        time = per_state(lambda: self.model.actuation(states.q, states.u, udot, FREE))
        error = f"{relative(back, udot):.0e}"
        return line(
            "forces of the actuators", "cardan, `actuation` from Python", f"{time:.1f} µs", error
        )

    def their_actuation(self) -> str:
        """The same by Pinocchio's rnea and Jacobian of the constraints."""
        import pinocchio as pin

        peer, states, n = self.pinocchio, self.states, self.model.nu
        a = peer.map.accelerations(states.q, states.u, self.udot)
        theirs = [self.their(k) for k in range(COUNT)]
        active = [self.order[self.model.speeds.index(f"{name}.u")] for name in FREE]
        passive = [k for k in range(n) if k not in active]

        def once(k: int) -> np.ndarray:
            q, v, _ = theirs[k]
            tau = pin.rnea(peer.model, peer.data, q, v, a[k])
            pin.computeJointJacobians(peer.model, peer.data, q)
            for loop, data in zip(peer.models, peer.datas, strict=True):
                loop.calc(peer.model, peer.data, data)
            G = pin.getConstraintsJacobian(peer.model, peer.data, peer.models, peer.datas)
            forces = np.linalg.lstsq(G[:, passive].T, tau[passive], rcond=1e-10)[0]
            carried = np.zeros(n)
            carried[active] = tau[active] - G[:, active].T @ forces
            return carried

        taus = peer.map.back(states.q, np.array([once(k) for k in range(COUNT)]))
        back = self.model.forward_dynamics(states.q, states.u, tau=taus)
        time = per_state(lambda: [once(k) for k in range(COUNT)])
        title = f"Pinocchio {pin.__version__} from Python, `rnea` and NumPy's `lstsq`"
        return line(
            "forces of the actuators", title, f"{time:.1f} µs", f"{relative(back, self.udot):.0e}"
        )


def line(*cells: str) -> str:
    """A line of a table; names of functions as people say them."""
    return f"| {' | '.join(cell.replace('_', ' ') for cell in cells)} |"


# runs


def runs() -> list[str]:
    """Ten seconds of swinging from a fixed pelvis, with the springs and dampers of the file."""
    model = cd.compile(robot())
    truth = model.simulate(END, q=BENT, rtol=TIGHT, atol=TIGHT)
    lines = []
    for rtol in (1e-4, 1e-6, 1e-8):
        # the first run compiles what it needs
        model.simulate(END, q=BENT, rtol=rtol, atol=1e-3 * rtol)
        began = perf_counter()
        motion = model.simulate(END, q=BENT, rtol=rtol, atol=1e-3 * rtol)
        spent = perf_counter() - began
        drift = np.abs(model.constraints(motion.q)).max()
        error = np.abs(motion.q[-1] - truth.q[-1]).max()
        title = f"cardan, rtol {rtol:g}"
        lines.append(line(title, f"{spent:.2f} s", f"{drift:.0e} m", f"{error:.0e} rad"))
    return lines + mujoco_runs(model, truth)


def mujoco_runs(model: cd.CompiledModel, truth: cd.Trajectory) -> list[str]:
    """MuJoCo, its constraints as by default and as hard as they get."""
    try:
        import mujoco

        from cardan.api.comparison import MUJOCO
        from cardan.peers.mujoco import HARD, model_and_data
    except ImportError as problem:
        print(f"MuJoCo does not take part: {problem}")
        return []
    loops = circuits(model)
    assert isinstance(loops, Circuits), loops
    lines = []
    default = (0.9, 0.95, 0.001, 0.5, 2.0)
    for title, impedance in (("default", default), ("hardest", HARD)):
        for step in (2e-3, 1e-3, 1e-4):
            peer, data = model_and_data(mujoco, loops.scene, loops.connections)
            joints = [peer.joint(f"j{body}") for body in range(len(loops.scene.parents))]
            places = [(int(j.qposadr[0]), int(j.dofadr[0])) for j in joints]
            change = coordinates.coordinates(loops.scene, MUJOCO.convention, places)
            peer.eq_solimp[:] = impedance
            peer.opt.timestep = step
            peer.opt.integrator = mujoco.mjtIntegrator.mjINT_IMPLICITFAST
            add_forces(model, peer, places)
            data.qpos[:] = change.q(truth.q[:1])[0]
            drift, spent = 0.0, 0.0
            for _ in range(round(END / step)):
                began = perf_counter()
                mujoco.mj_step(peer, data)
                spent += perf_counter() - began
                drift = max(drift, float(np.abs(data.efc_pos).max()))
            error = np.abs(data.qpos - change.q(truth.q[-1:])[0]).max()
            name = f"MuJoCo {version('mujoco')}, {title} impedance, step {1e3 * step:g} ms"
            lines.append(line(name, f"{spent:.2f} s", f"{drift:.0e} m", f"{error:.0e} rad"))
    return lines


def add_forces(model: cd.CompiledModel, peer: Any, places: list[tuple[int, int]]) -> None:
    """Springs and dampers of the file, in MuJoCo's joints."""
    forces = robot().forces
    for joint, (q, u) in zip(model.manifest.joints, places, strict=False):
        damper, spring = (forces.get(f"{joint.name}.{kind}") for kind in ("damping", "spring"))
        if damper is not None:
            peer.dof_damping[u] = damper.element.damping
        if spring is not None:
            peer.jnt_stiffness[peer.dof_jntid[u]] = spring.element.stiffness
            peer.qpos_spring[q] = spring.element.rest


TEXT = """\
# Cassie beside Pinocchio and MuJoCo

Written by `python tests/benchmarks/cassie.py`, in one run on one core. On a fixed pelvis
[Cassie](../cassie.md) has 22 coordinates, 10 independent closing conditions and 12 freedoms.

## Functions

The states are random and on the constraints. Springs and dampers are left out. Calls are made from
loops in C, and from Python where the row says so, which adds about a microsecond. The best of nine
rounds is shown. Batch means many states in one call.

| function | program | time per state | error |
|---|---|---|---|
{functions}

Errors are relative to the largest entry and against 40 digits. Those of Pinocchio's derivatives
count motions that the loops allow. The error of actuator forces is that of the accelerations
which forward dynamics returns for them. Inverse dynamics is that of the tree; the forces of the
actuators are those of the ten motors and of the two springs of the shins.

Pinocchio receives the balls of the file. Two of their conditions are redundant, so it makes as few
proximal steps as change nothing any more. Its headers call its derivatives unsupported.
MuJoCo's constraints are as hard as they get, and it neglects the derivative of their Jacobian.

## Ten seconds from a bent knee

Springs and dampers of the file act, limits do not. Drift is the largest opening of a loop. The
error is that of the last coordinates, against a run at a tolerance of {tight:g}. MuJoCo's
integrator is `implicitfast`.

| program | time of the run | drift | error |
|---|---|---|---|
{runs}
"""


def page() -> str:
    """The page for the documentation."""
    functions = Functions(cd.compile(robot(forces=False))).rows()
    return TEXT.format(functions="\n".join(functions), runs="\n".join(runs()), tight=TIGHT)


if __name__ == "__main__":
    text = page()
    print(text)
    PAGE.write_text(signed(text), encoding="utf-8")
