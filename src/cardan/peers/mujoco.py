"""MuJoCo's C library: the steps that smooth dynamics needs and no more, without contacts.

Source: E. Todorov, T. Erez, Y. Tassa, MuJoCo: A physics engine for model-based control, IROS 2012.
"""

from __future__ import annotations

import ctypes
import importlib.metadata
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from scipy.spatial.transform import Rotation

from ..api.comparison import MUJOCO, Scene, build
from ..arrays import Array
from ..errors import BuildError
from . import coordinates
from .circuits import Circuits, Connection
from .loop import HERE, Loop, peer_loop
from .peer import Contender, Peer, States, installed
from .tree import central, directions

if TYPE_CHECKING:
    from types import ModuleType

JOINT = {"revolute": "hinge", "prismatic": "slide", "spherical": "ball", "free": "free"}
PLACE = ("mj_kinematics", "mj_comPos")
STEPS = {
    "forward_dynamics": (*PLACE, "mj_makeM", "mj_factorM", "mj_comVel"),
    "inverse_dynamics": (*PLACE, "mj_comVel"),
    "mass_matrix": (*PLACE, "mj_makeM"),
    "derivatives": (*PLACE, "mj_makeM", "mj_factorM", "mj_comVel"),
}
# loops: what makes their rows, and the solver that follows the accelerations
CONSTRAIN = ("mj_makeConstraint", "mj_projectConstraint", "mj_comVel", "mj_referenceConstraint")
CLOSED_STEPS = {"forward_dynamics": (*PLACE, "mj_makeM", "mj_factorM", *CONSTRAIN)}
# the hardest that it takes: impedance d of a constraint, at a residual of any size
HARD = (0.9999, 0.9999, 0.001, 0.5, 2.0)
MOST = 12
OLDEST = (3, 10)
STEP = ctypes.c_void_p * MOST


class Program(ctypes.Structure):
    """``peer`` of mujoco.c."""

    _fields_ = (
        *((name, ctypes.c_void_p) for name in ("model", "data")),
        ("steps", STEP * len(STEPS)),
        *((name, ctypes.c_void_p) for name in ("accelerate", "constrain", "rne", "full")),
        *((name, ctypes.c_void_p) for name in ("slopes", "solve")),
        *((name, ctypes.c_void_p) for name in ("qpos", "qvel", "force", "qacc", "bias", "result")),
        ("slope", ctypes.c_void_p),
        ("nq", ctypes.c_int),
        ("nv", ctypes.c_int),
    )


def missing() -> str:
    """Reason why it cannot be called, "" where there is none."""
    why = installed("mujoco", "mujoco")
    if why:
        return why
    version = importlib.metadata.version("mujoco")
    # mj_fullM took other arguments before
    old = tuple(int(part) for part in version.split(".")[:2]) < OLDEST
    return f"version {version} is called otherwise: pip install -U mujoco" if old else ""


def refusal(scene: Scene, joints: Sequence[str]) -> str:
    """Free joints give the pose in ground axes there."""
    for i, kind in enumerate(scene.kinds):
        n = scene.numbers
        displaced = np.any(n["position"][i]) or np.any(n["rotation"][i] != np.eye(3))
        if kind == "free" and (scene.parents[i] >= 0 or displaced):
            return f"joint '{joints[i]}' is free, but not at the origin of the ground"
    return coordinates.refusal(scene, joints)


def _text(scene: Scene, connections: Sequence[Connection] = ()) -> str:
    """The tree as MJCF; masses follow later, as its reader would correct them."""
    n, axes = scene.numbers, directions(scene)
    children: dict[int, list[int]] = {}
    for body, parent in enumerate(scene.parents):
        children.setdefault(parent, []).append(body)
    lines: list[str] = []
    # a body, and whether its end is meant
    waiting = [(body, False) for body in children.get(-1, [])[::-1]]
    while waiting:
        body, closes = waiting.pop()
        if closes:
            lines.append("</body>")
            continue
        turn = Rotation.from_matrix(n["rotation"][body]).as_quat(scalar_first=True)
        place = f'pos="{_row(n["position"][body])}" quat="{_row(turn)}"'
        kind = scene.kinds[body]
        axis = "" if kind in ("free", "spherical") else f' axis="{_row(axes[body])}"'
        lines += [
            f'<body name="b{body}" {place}><joint name="j{body}" type="{JOINT[kind]}"{axis}/>',
            '<inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/>',
        ]
        waiting.append((body, True))
        waiting += [(child, False) for child in children.get(body, [])[::-1]]
    off = 'island="disable"' if connections else 'constraint="disable"'
    option = f'<option gravity="{_row(n["gravity"])}"><flag contact="disable" {off}/></option>'
    tree = "\n".join(lines)
    loops = "".join(map(_equality, connections))
    text = f"{option}<worldbody>{tree}</worldbody><equality>{loops}</equality>"
    return f"<mujoco>{text}</mujoco>"


def _equality(connection: Connection) -> str:
    """Two frames that are held together; where they are follows later."""
    one, other = ("world" if body < 0 else f"b{body}" for body in connection.bodies)
    if connection.aligned:
        return f'<weld body1="{one}" body2="{other}"/>'
    return f'<connect body1="{one}" body2="{other}" anchor="0 0 0"/>'


def _row(numbers: Any) -> str:
    return " ".join(repr(float(x)) for x in numbers)


def model_and_data(
    mujoco: ModuleType, scene: Scene, connections: Sequence[Connection] = ()
) -> tuple[Any, Any]:
    """Model and data with the masses of the tree, and with points held together."""
    model = mujoco.MjModel.from_xml_string(_text(scene, connections))
    data = mujoco.MjData(model)
    com, inertia = central(scene)
    moments, axes = np.linalg.eigh(inertia)
    axes[np.linalg.det(axes) < 0, :, 0] *= -1
    turns = Rotation.from_matrix(axes).as_quat(scalar_first=True)
    for body in range(len(scene.parents)):
        i = model.body(f"b{body}").id
        model.body_mass[i] = scene.numbers["mass"][body]
        model.body_ipos[i], model.body_iquat[i] = com[body], turns[body]
        model.body_inertia[i] = moments[body]
        # flags that say: no offset, no turn
        model.body_sameframe[i] = 0
        model.body_simple[i] = 0
    model.dof_simplenum[:] = 0
    mujoco.mj_setConst(model, data)
    for k, connection in enumerate(connections):
        model.eq_data[k, :6] = connection.positions.reshape(-1)
        model.eq_solimp[k] = HARD
    mujoco.mj_forward(model, data)
    return model, data


def contender(scene: Scene) -> Contender:
    """MuJoCo on a tree."""
    return _contender(scene, (), STEPS)


def closed_contender(circuits: Circuits) -> Contender:
    """MuJoCo with its solver of soft constraints, as hard as they get.

    Raises:
        BuildError: frames are held together, not points.
    """
    if any(connection.aligned for connection in circuits.connections):
        raise BuildError("only points are held together there, not frames")
    inner = _contender(circuits.scene, circuits.connections, CLOSED_STEPS)

    def results(function: str, states: States) -> Array:
        return inner.results(function, circuits.states(states))[:, : circuits.nu]

    def start(function: str, states: States) -> Callable[[int], float]:
        return inner.start(function, circuits.states(states))

    return Contender(inner.title, inner.functions, start, results, inner.references)


def _contender(
    scene: Scene, connections: Sequence[Connection], steps: Mapping[str, tuple[str, ...]]
) -> Contender:
    import mujoco

    model, data = model_and_data(mujoco, scene, connections)
    joints = [model.joint(f"j{body}") for body in range(len(scene.parents))]
    places = [(int(j.qposadr[0]), int(j.dofadr[0])) for j in joints]
    library_file = next(Path(mujoco.__file__).parent.glob("libmujoco*.so*"))
    adapter, shared = build([HERE / "mujoco.c"]).load(), ctypes.CDLL(str(library_file))

    def at(name: str) -> int | None:
        return ctypes.cast(shared[name], ctypes.c_void_p).value

    rows = [STEP(*(at(name) for name in steps.get(function, ()))) for function in STEPS]
    result = data.qacc if connections else data.qacc_smooth
    arrays = (data.qpos, data.qvel, data.qfrc_applied, data.qacc, data.qfrc_bias, result)
    slope = np.empty(4 * model.nv**2)
    program = Program(
        model._address,
        data._address,
        (STEP * len(STEPS))(*rows),
        at("mj_fwdAcceleration"),
        at("mj_fwdConstraint") if connections else None,
        *(at(name) for name in ("mj_rne", "mj_fullM", "mjd_inverseFD", "mj_solveM")),
        *(array.ctypes.data for array in arrays),
        slope.ctypes.data,
        model.nq,
        model.nv,
    )
    coordinate_map = coordinates.coordinates(scene, MUJOCO.convention, places)
    loop = Loop(peer_loop(adapter), ctypes.byref(program), coordinate_map)
    title = f"MuJoCo {importlib.metadata.version('mujoco')}"
    references = (model, data, slope, program, adapter, shared)
    return Contender(title, tuple(steps), loop.start, loop.results, references)


PEER = Peer("MuJoCo", "mujoco", missing, refusal, contender, closed_contender)
