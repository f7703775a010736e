"""One impact of a ball in Brax and MuJoCo MJX: heights at the end, and their derivatives by JAX.

Needs ``pip install brax mujoco-mjx``. All numbers are of double precision.
"""

from __future__ import annotations

import contextlib
import importlib
import io
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from importlib.metadata import version
from typing import Any

import numpy as np

Array = np.ndarray
BALL = """
<mujoco>
  <option timestep="{step}" gravity="0 0 0" solver="Newton" iterations="20"
          tolerance="0" cone="pyramidal"/>
  <custom>
    <numeric name="ang_damping" data="0"/>
    <numeric name="vel_damping" data="0"/>
    <numeric name="baumgarte_erp" data="{erp}"/>
  </custom>
  <worldbody>
    <geom name="floor" type="plane" size="9 9 9" condim="{condim}" friction="0 0 0" {contact}/>
    <body name="ball">
      <joint name="z" type="slide" axis="0 0 1"/>
      <geom name="ball" type="sphere" size="{radius}" mass="1" condim="{condim}" friction="0 0 0"
            {contact}/>
    </body>
  </worldbody>
</mujoco>
"""
# contacts as hard as their stiffness says, at every depth
IMPEDANCE = 'solimp="0.9999 0.9999 0.001 0.5 2"'


@dataclass(frozen=True)
class Throw:
    """A ball of 1 kg that is thrown down and meets a floor once.

    Attributes:
        radius: [m].
        restitution: Speed behind the impact of that before it.
        speed: With which it is thrown down [m/s].
        t: When it is looked at [s].
    """

    radius: float
    restitution: float
    speed: float
    t: float


@dataclass(frozen=True)
class Engine:
    """A program with settings.

    Attributes:
        name: Of the program.
        settings: In words.
        run: Heights (n,) at the end, and their derivatives (n, 2) by those at the start and by the
            speed; of heights at the start (n,) and gravity (n,) [m/s^2].
    """

    name: str
    settings: str
    run: Callable[[Throw, Array, Array], tuple[Array, Array]]


@cache
def jax() -> Any:
    """JAX, in double precision."""
    import jax

    jax.config.update("jax_enable_x64", True)
    return jax


def text(
    throw: Throw, step: float, erp: float = 0.1, contact: str = "", iterations: int = 20
) -> str:
    """The scene as MJCF: Brax takes spheres with friction alone, MJX also such without."""
    return BALL.format(
        step=step, erp=erp, contact=contact, iterations=iterations, radius=throw.radius,
        condim=1 if contact else 3,
    )  # fmt: skip


def swept(
    rollout: Callable[..., Any], throw: Throw, heights: Array, gravity: Array
) -> tuple[Array, Array]:
    """Heights at the end and their derivatives, by forward mode, of all starts at once."""

    def both(height: Any, speed: Any, g: Any) -> Any:
        ends, slopes = jax().vmap(
            lambda *ways: jax().jvp(lambda h, v: rollout(h, v, g), (height, speed), ways)
        )(*jax().numpy.eye(2))
        return ends[0], slopes

    ends, slopes = jax().jit(jax().vmap(both, in_axes=(0, None, 0)))(heights, throw.speed, gravity)
    return np.asarray(ends), np.asarray(slopes)


def brax(pipeline: str, step: float, erp: float, contact: str = "") -> Any:
    """Runs of a pipeline of Brax."""

    def run(throw: Throw, heights: Array, gravity: Array) -> tuple[Array, Array]:
        from brax.io import mjcf

        numbers = jax().numpy
        physics = importlib.import_module(f"brax.{pipeline}.pipeline")
        system = mjcf.loads(text(throw, step, erp, contact))
        elasticity = numbers.full_like(system.elasticity, throw.restitution)
        action = numbers.zeros(system.act_size())

        def rollout(height: Any, speed: Any, g: Any) -> Any:
            pulled = numbers.array([0.0, 0.0, -1.0]) * g
            there = system.replace(elasticity=elasticity, gravity=pulled)
            state = physics.init(there, numbers.array([height]), numbers.array([-speed]))

            def forward(state: Any, _: Any) -> Any:
                return physics.step(there, state, action), None

            return jax().lax.scan(forward, state, None, round(throw.t / step))[0].q[0]

        return swept(rollout, throw, heights, gravity)

    return run


def contact_of(stiffness: float, ratio: float, direct: bool) -> str:
    """Attributes of a contact: by stiffness and damping, or by a time and a ratio of damping."""
    if direct:
        return f'solref="{-stiffness} {-2 * ratio * stiffness**0.5}" {IMPEDANCE}'
    return f'solref="{1 / (ratio * stiffness**0.5)} {ratio}" {IMPEDANCE}'


@cache
def damping_ratio(throw: Throw, stiffness: float, step: float) -> float:
    """The ratio of damping for which MuJoCo gives the ball its restitution."""
    import mujoco
    from scipy.optimize import brentq

    def missed(ratio: float) -> float:
        contact = contact_of(stiffness, ratio, True)
        model = mujoco.MjModel.from_xml_string(text(throw, step, contact=contact))
        data = mujoco.MjData(model)
        data.qpos[0], data.qvel[0] = throw.radius + 0.01, -1.0
        while data.qpos[0] <= throw.radius + 0.01:
            mujoco.mj_step(model, data)
        return float(data.qvel[0]) - throw.restitution

    return float(brentq(missed, 1e-4, 0.5, xtol=1e-5)) if throw.restitution < 1 else 0.0


def mjx(stiffness: float, step: float) -> Any:
    """Runs of MuJoCo MJX."""

    def run(throw: Throw, heights: Array, gravity: Array) -> tuple[Array, Array]:
        import mujoco

        with contextlib.redirect_stdout(io.StringIO()):
            from mujoco import mjx

        numbers = jax().numpy
        ratio = damping_ratio(throw, stiffness, step)
        file = text(throw, step, contact=contact_of(stiffness, ratio, True))
        system = mjx.put_model(mujoco.MjModel.from_xml_string(file))
        empty = mjx.make_data(system)

        def rollout(height: Any, speed: Any, g: Any) -> Any:
            pulled = numbers.array([0.0, 0.0, -1.0]) * g
            there = system.replace(opt=system.opt.replace(gravity=pulled))
            start = empty.replace(qpos=numbers.array([height]), qvel=numbers.array([-speed]))

            def forward(state: Any, _: Any) -> Any:
                return mjx.step(there, state), None

            return jax().lax.scan(forward, start, None, round(throw.t / step))[0].qpos[0]

        return swept(rollout, throw, heights, gravity)

    return run


def generalized(stiffness: float, step: float) -> Any:
    """Runs of Brax's pipeline in generalized coordinates, whose contacts are those of MuJoCo."""

    def run(throw: Throw, heights: Array, gravity: Array) -> tuple[Array, Array]:
        ratio = damping_ratio(throw, stiffness, step)
        contact = contact_of(stiffness, ratio, False)
        return brax("generalized", step, 0.1, contact)(throw, heights, gravity)

    return run


def engines() -> list[Engine]:
    """Programs with the settings that are tried."""
    theirs, ours = f"Brax {version('brax')}", f"MuJoCo MJX {version('mujoco-mjx')}"
    damped = "steps of 0.1 ms, damping for e"
    return [
        Engine(f"{theirs} spring", "steps of 1 ms, defaults", brax("spring", 1e-3, 0.1)),
        Engine(f"{theirs} spring", "steps of 1 ms, baumgarte_erp 0", brax("spring", 1e-3, 0.0)),
        Engine(f"{theirs} positional", "steps of 1 ms, defaults", brax("positional", 1e-3, 0.1)),
        Engine(f"{theirs} generalized", "steps of 1 ms, stiffness 1e4 N/m, damping for e",
               generalized(1e4, 1e-3)),
        Engine(ours, f"stiffness 1e4 N/m, {damped}", mjx(1e4, 1e-4)),
        Engine(ours, f"stiffness 1e5 N/m, {damped}", mjx(1e5, 1e-4)),
    ]  # fmt: skip
