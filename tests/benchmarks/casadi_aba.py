"""The articulated-body algorithm written in CasADi, as C: the fast peer on the same robot.

Bodies, placements and inertias come from Pinocchio's reading of the URDF. Constant zeros are
dropped by CasADi as it builds the expressions.
"""

from __future__ import annotations

import ctypes
import subprocess
from pathlib import Path
from typing import Any

import casadi as ca
import numpy as np

FLAGS = ("-O2", "-march=native", "-fno-math-errno", "-ffp-contract=fast", "-shared", "-fPIC")
LOOP = """
#include <time.h>
double spine_loop(const double *q, const double *u, double *out, int count, int n, int repeats) {
  struct timespec start, stop;
  double w[spine_SZ_W + 1];
  long long int iw[spine_SZ_IW + 1];
  clock_gettime(CLOCK_MONOTONIC, &start);
  for (int r = 0; r < repeats; ++r)
    for (int k = 0; k < count; ++k) {
      const double *arg[spine_SZ_ARG + 2] = {q + k * n, u + k * n};
      double *res[spine_SZ_RES + 1] = {out + k * n};
      spine(arg, res, iw, w, 0);
    }
  clock_gettime(CLOCK_MONOTONIC, &stop);
  double whole = (double)(stop.tv_sec - start.tv_sec);
  double rest = 1e-9 * (double)(stop.tv_nsec - start.tv_nsec);
  return (whole + rest) / repeats / count;
}
"""


def skew(v: Any) -> Any:
    return ca.skew(v)


def joint_rotation(axis: np.ndarray, angle: Any) -> Any:
    """Rotation of a hinge about a coordinate axis or a general one."""
    k = ca.DM(skew(ca.DM(axis)))
    return ca.DM.eye(3) + ca.sin(angle) * k + (1 - ca.cos(angle)) * ca.sparsify(k @ k)


def across(v: Any) -> Any:
    """Operator v x on motion vectors [angular, linear]."""
    zero = ca.SX(3, 3)
    return ca.vertcat(ca.horzcat(skew(v[:3]), zero), ca.horzcat(skew(v[3:]), skew(v[:3])))


def articulated(model: Any) -> ca.Function:
    """udot(q, u) of a Pinocchio model of hinges on a fixed base."""
    n = model.nv
    q, u = ca.SX.sym("q", n), ca.SX.sym("u", n)
    x, s, v, c, inertia, bias = [], [], [], [], [], []
    for j in range(1, model.njoints):
        place, i = model.jointPlacements[j], j - 1
        axis = np.round(_axis(model.joints[j]), 12)
        rotation = ca.sparsify(ca.DM(np.where(abs(place.rotation) < 1e-9, 0, place.rotation)))
        r = (rotation @ joint_rotation(axis, q[i])).T
        low = ca.horzcat(-r @ skew(ca.sparsify(ca.DM(place.translation))), r)
        x.append(ca.vertcat(ca.horzcat(r, ca.SX(3, 3)), low))
        s.append(ca.sparsify(ca.DM(np.concatenate([axis, np.zeros(3)]))))
        joint = s[i] * u[i]
        p = model.parents[j] - 1
        v.append(x[i] @ v[p] + joint if p >= 0 else ca.SX(joint))
        c.append(across(v[i]) @ joint)
        inertia.append(ca.SX(_spatial(model.inertias[j])))
        bias.append(-across(v[i]).T @ (inertia[i] @ v[i]))
    # inwards
    reach, d, push = [None] * n, [None] * n, [None] * n
    for i in range(n - 1, -1, -1):
        reach[i], d[i] = inertia[i] @ s[i], s[i].T @ inertia[i] @ s[i]
        push[i] = -s[i].T @ bias[i]
        p = model.parents[i + 1] - 1
        if p >= 0:
            left = inertia[i] - reach[i] @ reach[i].T / d[i]
            pull = bias[i] + left @ c[i] + reach[i] * (push[i] / d[i])
            inertia[p] += x[i].T @ left @ x[i]
            bias[p] += x[i].T @ pull
    # outwards
    a, udot = [], []
    lift = ca.DM([0, 0, 0, *(-model.gravity.linear)])
    for i in range(n):
        p = model.parents[i + 1] - 1
        carried = x[i] @ (a[p] if p >= 0 else ca.sparsify(lift)) + c[i]
        udot.append((push[i] - reach[i].T @ carried) / d[i])
        a.append(carried + s[i] * udot[i])
    return ca.Function("spine", [q, u], [ca.vertcat(*udot)], {"cse": True})


def _axis(joint: Any) -> np.ndarray:
    """Hinge axis of a Pinocchio joint."""
    data = joint.createData()
    joint.calc(data, np.zeros(joint.nq) if joint.nq == 1 else np.array([1.0, 0.0]))
    return np.asarray(data.S).ravel()[3:]


def _spatial(inertia: Any) -> np.ndarray:
    """Spatial inertia (6, 6), angular part first."""
    m, com = inertia.mass, np.array(ca.DM(skew(ca.DM(inertia.lever))))
    top = inertia.inertia - m * com @ com
    return np.block([[top, m * com], [-m * com, m * np.eye(3)]])


class Peer:
    """The C of CasADi, compiled with our flags and timed by a loop in C."""

    def __init__(self, model: Any, folder: Path) -> None:
        function = articulated(model)
        self.n = model.nv
        self.operations = function.n_instructions()
        source, library = folder / "spine.c", folder / "spine.so"
        text = _text(function) + LOOP
        source.write_text(text, encoding="utf-8")
        subprocess.run(["cc", *FLAGS, str(source), "-o", str(library), "-lm"], check=True)
        self.loop = ctypes.CDLL(str(library)).spine_loop
        self.loop.restype = ctypes.c_double

    def time(self, q: np.ndarray, u: np.ndarray, repeats: int) -> tuple[float, np.ndarray]:
        """Seconds per call and the results, (count, n)."""
        out = np.empty_like(q)
        pointer = ctypes.POINTER(ctypes.c_double)
        blocks = [array.ctypes.data_as(pointer) for array in (q, u, out)]
        seconds = min(self.loop(*blocks, len(q), self.n, repeats) for _ in range(5))
        return seconds, out


def _text(function: ca.Function) -> str:
    """The C of the function with the sizes of what it needs."""
    generator = ca.CodeGenerator("spine", {"with_header": False})
    generator.add(function)
    sizes = {name: getattr(function, f"sz_{name.lower()}")() for name in ("ARG", "RES", "IW", "W")}
    defines = "".join(f"#define spine_SZ_{name} {size}\n" for name, size in sizes.items())
    return defines + str(generator.dump())
