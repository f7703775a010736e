"""One-step methods as functions: what a step makes of a linear system y' = Z y / h.

Source: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., sections IV.2,
IV.3 (stability functions), IV.5 (Radau IIA) and IV.7 (Rosenbrock methods).
"""

from __future__ import annotations

import ast
import re
from functools import lru_cache
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ....arrays import Array
from ....errors import ModelError
from ....schema import kernel_files
from ....schema.integrators import KERNELS, Integrator

Matrix = NDArray[np.complexfloating[Any, Any]]


def response(method: Integrator, z: Matrix) -> Matrix:
    """R(Z), by which a step multiplies the state.

    Args:
        method: A Runge-Kutta or Rosenbrock method.
        z: h times the matrix of the system (..., m, m).

    Returns:
        (..., m, m).

    Raises:
        ModelError: nothing of the kind is known of the method.
    """
    if method.kernel == "rosenbrock":
        return _rosenbrock(z)
    tableau = _tableau(KERNELS[method.kernel])
    if tableau is None:
        kernels = ", ".join(name for name, one in KERNELS.items() if _tableau(one))
        raise ModelError(
            f"'{method.name}': a response is known of the kernels {kernels}, rosenbrock"
        )
    a, b = tableau
    unit = np.broadcast_to(np.eye(z.shape[-1], dtype=np.complex128), z.shape)
    stages = _solved(a, z) if a.any(where=np.triu(np.ones_like(a, dtype=bool))) else _followed(a, z)
    result: Matrix = unit + sum(weight * k for weight, k in zip(b, stages, strict=True))
    return result


def _followed(a: Array, z: Matrix) -> list[Matrix]:
    """Stages of an explicit method, one after the other."""
    stages: list[Matrix] = []
    for row in a:
        stages.append(z + z @ sum((x * k for x, k in zip(row, stages, strict=False)), 0 * z))
    return stages


def _solved(a: Array, z: Matrix) -> list[Matrix]:
    """Stages of an implicit method, all at once: K = Z (1 + a K)."""
    m, count = z.shape[-1], len(a)
    matrix = np.eye(count * m) - _kronecker(a, z)
    k = np.linalg.solve(matrix, _kronecker(np.ones((count, 1)), z))
    return [k[..., s * m : (s + 1) * m, :] for s in range(count)]


def _kronecker(a: Array, z: Matrix) -> Matrix:
    """Kronecker product (..., rows m, columns m) of a (rows, columns) and z (..., m, m)."""
    product: Matrix = np.einsum("ab,...ij->...aibj", a, z)
    m = z.shape[-1]
    return product.reshape(*z.shape[:-2], a.shape[0] * m, a.shape[1] * m)


def _tableau(method: Integrator) -> tuple[Array, Array] | None:
    """Coefficients a (stages, stages) and b (stages,) of a Runge-Kutta method."""
    import scipy.integrate

    kind = getattr(scipy.integrate, method.name, None)
    *rows, b = method.tableau or (*getattr(kind, "A", ()), getattr(kind, "B", ()))
    if not len(b):
        return None
    a = np.zeros((len(b), len(b)))
    for full, row in zip(a, rows, strict=True):
        full[: len(row)] = row
    return a, np.asarray(b, dtype=np.float64)


# Rosenbrock: stages that are solved for with the Jacobian


@lru_cache(maxsize=1)
def _tables() -> dict[str, list[list[float]]]:
    """The tables of the kernel, row by row."""
    text = kernel_files.text("rosenbrock_tables.h")
    tables = {}
    for name, body in re.findall(r"real ([AC])\[\d\]\[\d\] = (\{.*?\});", text, re.DOTALL):
        tables[name] = ast.literal_eval(body.replace("{", "[").replace("}", "]"))
    gamma = re.search(r"real GAMMA = ([\d.]+);", text)
    return tables | {"GAMMA": [[float(gamma[1])]] if gamma else []}


def _rosenbrock(z: Matrix) -> Matrix:
    tables = _tables()
    unit = np.broadcast_to(np.eye(z.shape[-1], dtype=np.complex128), z.shape)
    matrix = unit / tables["GAMMA"][0][0] - z
    stages: list[Matrix] = []
    state = unit
    for row, c in enumerate(tables["C"]):
        if row < len(tables["A"]):
            # the others stand at the one before plus its own
            state = unit + sum(a * u for a, u in zip(tables["A"][row], stages, strict=False))
        slopes = sum((x * u for x, u in zip(c, stages, strict=False)), np.zeros_like(z))
        stages.append(np.linalg.solve(matrix, z @ state + slopes))
        if row + 1 >= len(tables["A"]):
            state = state + stages[-1]
    return state
