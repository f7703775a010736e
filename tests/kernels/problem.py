"""Small systems whose right-hand side is written by hand in C, in place of a compiled model."""

from __future__ import annotations

import ctypes
import inspect
from dataclasses import dataclass, field
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np

from cardan.analyses.simulation.simulate import simulate
from cardan.runtime.build import cache, kernels
from cardan.runtime.calls import abi
from cardan.runtime.calls.layout import Layout
from cardan.runtime.trajectory.trajectory import TrajectoryRecord
from cardan.schema import kernel_files
from cardan.schema.c_functions import ResultRow
from cardan.schema.integrators import INTEGRATORS
from cardan.schema.manifest import Manifest

# those that take x' = f(t, x) as it comes; others step what mechanics gives them
METHODS = {name: m for name, m in INTEGRATORS.items() if set(m.needs) <= {"rhs_jacobian"}}
HEAD = """
#include "cardan.h"
int NAME(const cardan_in *in, real *out, real *work);
int NAME(const cardan_in *in, real *out, real *work)
{
    const real t = in->t[0], *q = in->q, *u = in->u, *r = in->r;
    const real *z = in->z, *s = in->s, *e = in->e;
    (void)t; (void)q; (void)u; (void)r; (void)work; (void)z; (void)s; (void)e;
    { BODY }
    return 0;
}
"""


# differences of the right-hand side above, quaternions by their direction
DIFFERENCES = """
    real x[NX + NR + 1], lower[NX + NR + 1], upper[NX + NR + 1], time[1];
    cardan_in moved = *in;
    int status;
    for (int i = 0; i < NX + NR; i++)
        x[i] = i < NQ ? q[i] : i < NQ + NU ? u[i - NQ] : i < NX ? z[i - NQ - NU] : r[i - NX];
    moved.q = x; moved.u = x + NQ; moved.z = x + NQ + NU; moved.r = x + NX; moved.t = time;
    for (int j = 0; j <= NX + NR; j++) {
        real *at = j < NX + NR ? x + j : time, held, h;
        time[0] = t;
        held = *at, h = 6e-6 * (1 + fabs(held));
        *at = held + h; h = *at - held;
        status = right(&moved, upper, work);
        *at = held - h;
        status = status ? status : right(&moved, lower, work);
        if (status) return status;
        *at = held;
        for (int i = 0; i < NX; i++) {
            real slope = (upper[i] - lower[i]) / (2 * h);
            if (j < NX) out[i * NX + j] = slope;
            else if (j == NX + NR) out[NX * NX + i] = slope;
            else out[NX * NX + NX + i * NR + j - NX] = slope;
        }
    }
    const int quaternions[] = {QUATERNIONS -1};
    for (int k = 0; quaternions[k] >= 0; k++)
        for (int i = 0; i < NX; i++) {
            real *row = out + i * NX + quaternions[k], along = 0;
            for (int j = 0; j < 4; j++) along += row[j] * q[quaternions[k] + j];
            for (int j = 0; j < 4; j++) row[j] -= along * q[quaternions[k] + j];
        }
"""


def function(folder: Path, name: str, body: str, entries: list[str], before: str = "") -> Any:
    """A C function with the interface of a loaded one, and what stands before it."""
    path = folder / f"{name}.c"
    path.write_text(before + HEAD.replace("NAME", name).replace("BODY", body))
    library = ctypes.CDLL(str(cache.build([path], kernel_files.includes()).path))
    address = ctypes.cast(getattr(library, name), ctypes.c_void_p).value
    outputs = [ResultRow(name=name, entries=entries, shape=[len(entries)])]
    return SimpleNamespace(
        address=address,
        w=np.zeros(1),
        work_size=0,
        outputs=outputs,
        library=library,
        interpreted=False,
    )


WRITTEN = ("rhs", "power", "events", "transition")


class CompiledModel:
    """What is given for a compiled model is known by this name."""


@dataclass
class Problem(CompiledModel):
    """As much of a compiled model as the integrators need.

    Attributes:
        folder: Where its C goes.
        rhs: Body of the C function: writes ``out`` from t, q, u, r.
        nq, nu: Sizes.
        power: Body of the power of one source, "" without.
        inputs: Names of r.
        quaternions: First entries in q.
        energy_of: Body of the energies: kinetic, potential, total.
        jacobian: Body of ``rhs_jacobian``; by default differences of ``rhs``.
        position, velocity, held: Bodies of the functions that close, and of G.
        multipliers: Rows of the manifest.
        z, s: Names of internal and discrete states.
        events, transition: Bodies of the functions; the second writes u, z, s.
        kinds: Of every event; they are called e0, e1, ... of elements a0, a1, ...
        ticks: Rows of the manifest.
    """

    folder: Path
    rhs: str
    nq: int = 1
    nu: int = 1
    power: str = ""
    jacobian: str = ""
    inputs: tuple[str, ...] = ()
    quaternions: tuple[int, ...] = ()
    name: str = "problem"
    position: str = ""
    velocity: str = ""
    held: str = ""
    multipliers: tuple[dict[str, str], ...] = ()
    saved: tuple[str, ...] = ()
    energy_of: str = ""
    z: tuple[str, ...] = ()
    s: tuple[str, ...] = ()
    events: str = ""
    transition: str = ""
    kinds: tuple[str, ...] = ()
    ticks: tuple[dict[str, float], ...] = ()
    _size: float | None = None
    _made: dict[str, Any] = field(default_factory=dict)
    _derived: dict[object, Any] = field(default_factory=dict)

    @property
    def nx(self) -> int:
        return self.nq + self.nu + self.nz

    @property
    def nz(self) -> int:
        return len(self.z)

    @property
    def ns(self) -> int:
        return len(self.s)

    @property
    def internals(self) -> tuple[str, ...]:
        return self.z

    @property
    def _layout(self) -> Any:
        return Layout(self.manifest)

    def parts_of(self, x: Any) -> tuple[Any, Any, Any]:
        n = self.nq + self.nu
        return x[..., : self.nq], x[..., self.nq : n], x[..., n:]

    def split(self, x: Any) -> tuple[Any, Any, Any]:
        return self.parts_of(x)

    def _evaluate(self, key: Any, values: Any, parameters: None, out: None) -> np.ndarray:
        """Energies of every row."""
        t, q, u, r = values
        function, rows = self._function(key[0]), np.empty((len(q), 3))
        for k, row in enumerate(rows):
            at = {"t": np.array([t[k]]), "q": q[k], "u": u[k], "r": r[k] if self.nr else None}
            blocks = [at.get(name) for name in abi.ORDER]
            abi.run(function.address, blocks, [0] * len(blocks), 1, row[None, :], 0)
        return rows

    @property
    def bodies(self) -> tuple[str, ...]:
        return ()

    @property
    def nr(self) -> int:
        return len(self.inputs)

    @property
    def coordinates(self) -> tuple[str, ...]:
        return tuple(f"q{k}" for k in range(self.nq))

    @property
    def speeds(self) -> tuple[str, ...]:
        return tuple(f"u{k}" for k in range(self.nu))

    @property
    def manifest(self) -> Manifest:
        plain = {
            "name": self.name,
            "coordinates": [{"name": n, "default": 0.0} for n in self.coordinates],
            "speeds": [{"name": n} for n in self.speeds],
            "inputs": [{"name": n, "unit": "", "default": 0.0} for n in self.inputs],
            "outputs": [],
            "joints": [],
            "bodies": [],
            "quaternions": list(self.quaternions),
            "multipliers": list(self.multipliers),
            "z": [{"name": n, "unit": "", "default": 0.0} for n in self.z],
            "s": [{"name": n, "default": 0.0, "labels": {}} for n in self.s],
            "events": [
                {"name": f"e{k}", "element": f"a{k}", "kind": kind, "about": ""}
                for k, kind in enumerate(self.kinds)
            ],
            "ticks": list(self.ticks),
            "available": [
                *("rhs_jacobian", *(["energy"] if self.energy_of else [])),
                *(name for name in WRITTEN if getattr(self, name)),
            ],
        }
        return Manifest.read(plain, run=True)

    def prepare(self, *_: Any) -> None:
        """Nothing to compile side by side."""

    def _kernels(self) -> ctypes.CDLL:
        return kernels.library()

    def _function(self, name: str) -> Any:
        if name not in self._made:
            body = {
                "rhs": self.rhs,
                "rhs_jacobian": self.jacobian or DIFFERENCES,
                "power": self.power,
                "energy": self.energy_of,
                "close_position": self.position,
                "close_velocity": self.velocity,
                "events": self.events,
                "transition": self.transition,
                "constraint_jacobian": self.held,
            }[name]
            rows = [row["name"] for row in self.multipliers]
            positions = [row["name"] for row in self.multipliers if row["level"] == "position"]
            entries = {
                "power": ["source"],
                "close_position": [*self.coordinates, *positions],
                "close_velocity": [*self.speeds, *rows],
            }.get(name, [*self.coordinates, *self.speeds, *self.z])
            before = self._before() if body == DIFFERENCES else ""
            self._made[name] = function(self.folder, name, body, entries, before)
        return self._made[name]

    def _before(self) -> str:
        """The right-hand side and the sizes that differences of it need."""
        right = HEAD.replace("NAME", "right").replace("BODY", self.rhs)
        sizes = {"NX": self.nx, "NQ": self.nq, "NU": self.nu, "NR": self.nr}
        sizes["QUATERNIONS"] = "".join(f"{k}, " for k in self.quaternions)
        return "".join(f"#define {n} {v}\n" for n, v in sizes.items()) + right

    def run(self, t: Any, x0: Any, **options: Any) -> TrajectoryRecord:
        """Simulate from a state."""
        # what is checked is a compiled model
        plain = inspect.unwrap(simulate)
        motion: TrajectoryRecord = plain(self, t, x0=np.asarray(x0, dtype=float), **options)
        return motion


# x = exp(sin t^2), exp(cos t^2): nonlinear, depends on t, closed form
SWING = """
    out[0] = 2 * t * q[0] * log(u[0]);
    out[1] = -2 * t * u[0] * log(q[0]);
"""
OSCILLATOR = "out[0] = u[0]; out[1] = -q[0];"


def swing(t: Any) -> Any:
    """Solution of SWING, (..., 2)."""
    t = np.asarray(t, dtype=float)
    return np.stack([np.exp(np.sin(t**2)), np.exp(np.cos(t**2))], axis=-1)


# a pendulum of length 1 in Cartesian coordinates: x^2 + y^2 = 1, gravity 9.81 along -y
PENDULUM = """
    real rr = q[0] * q[0] + q[1] * q[1];
    real lam = (9.81 * q[1] - u[0] * u[0] - u[1] * u[1]) / rr;
    out[0] = u[0]; out[1] = u[1];
    out[2] = lam * q[0]; out[3] = lam * q[1] - 9.81;
"""
PENDULUM_POSITION = """
    real rr = q[0] * q[0] + q[1] * q[1], g = 0.5 * (rr - 1);
    out[0] = q[0] - q[0] * g / rr; out[1] = q[1] - q[1] * g / rr; out[2] = g;
"""
PENDULUM_VELOCITY = """
    real rr = q[0] * q[0] + q[1] * q[1], rate = q[0] * u[0] + q[1] * u[1];
    out[0] = u[0] - q[0] * rate / rr; out[1] = u[1] - q[1] * rate / rr; out[2] = rate;
"""
ROD = ({"name": "rod.length", "unit": "N", "joint": "rod", "level": "position"},)


def pendulum(folder: Path, **changed: Any) -> Problem:
    """The pendulum in Cartesian coordinates, closed by its rod."""
    given: dict[str, Any] = {
        "rhs": PENDULUM,
        "position": PENDULUM_POSITION,
        "velocity": PENDULUM_VELOCITY,
        "held": "out[0] = q[0]; out[1] = q[1];",
        "multipliers": ROD,
        "nq": 2,
        "nu": 2,
    }
    return Problem(folder, **(given | changed))


# the fast heavy top: 15 kg one meter along y from its fixed point, speeds in body axes
TOP = """
    real w = q[0], x = q[1], y = q[2], z = q[3], a = u[0], b = u[1], c = u[2];
    real gx = -9.81 * 2 * (x * z - w * y), gz = -9.81 * (1 - 2 * (x * x + y * y));
    out[0] = 0.5 * (-x * a - y * b - z * c); out[1] = 0.5 * (w * a + y * c - z * b);
    out[2] = 0.5 * (w * b + z * a - x * c); out[3] = 0.5 * (w * c + x * b - y * a);
    out[4] = (15 * gz - (15.234375 - 0.46875) * b * c) / 15.234375;
    out[5] = 0;
    out[6] = (-15 * gx - (0.46875 - 15.234375) * a * b) / 15.234375;
"""
TOP_START = [1, 0, 0, 0, 0, 150, -4.61538]
# at 0.1 s, by a Taylor series in 40 digits
TOP_THERE = [
    *(0.3318229126083008, 0.177338056666937, 0.9149751591387279, -0.1458260144308886),
    *(4.808941331728092, 150.0, 1.02830075671833),
]


def top(folder: Path, **changed: Any) -> Problem:
    """The fast heavy top of Geradin and Cardona (2001), chapter 5."""
    given: dict[str, Any] = {"rhs": TOP, "nq": 4, "nu": 3, "quaternions": (0,)}
    return Problem(folder, **(given | changed))
