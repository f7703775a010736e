"""Batches over the zoo: order "F" gives the bits of order "C"; floats stay near doubles."""

from __future__ import annotations

import numpy as np
import pytest

import cardan as cd
from laws.cases import derived
from mechanisms import ZOO
from spread import some

FUNCTIONS = ("forward_dynamics", "rhs", "mass_matrix", "energy")
COUNT = 40  # two whole vectors of floats and a remainder
UNIT = 2.0**-24  # a rounding in single precision


def model_of(name: str) -> cd.CompiledModel:
    model = cd.compile(derived(name), functions=(*FUNCTIONS, "bias"), dtype="float32", threads=1)
    model.prepare(*FUNCTIONS, batch=True)
    return model


def arguments(model: cd.CompiledModel, dtype: str = "float64") -> dict[str, tuple[np.ndarray, ...]]:
    """Arguments of every function; those of doubles are what floats hold, too."""
    x = model.random_state(7, (COUNT,)).astype(np.float32)
    q, u = (block.astype(np.float32) for block in model.split(x))
    tau = np.random.default_rng(8).uniform(-1, 1, u.shape).astype(np.float32)
    t = np.full(COUNT, 0.25, np.float32)
    rows = {"forward_dynamics": (q, u, tau), "rhs": (t, x), "mass_matrix": (q,), "energy": (q, u)}
    return {name: tuple(a.astype(dtype) for a in arrays) for name, arrays in rows.items()}


def called(model: cd.CompiledModel, name: str, arrays: tuple[np.ndarray, ...]) -> np.ndarray:
    if name == "forward_dynamics":
        result = model.forward_dynamics(*arrays[:2], tau=arrays[2])
    else:
        result = getattr(model, name)(*arrays)
    return np.stack(result, axis=-1) if isinstance(result, tuple) else result


# lanes of every mechanism take a compiler some seconds
@pytest.mark.parametrize("name", some(sorted(ZOO), 40, 3))
def test_order_in_memory_changes_no_bit(name: str) -> None:
    model = model_of(name)
    for dtype in ("float64", "float32"):
        for function, rows in arguments(model, dtype).items():
            expected = called(model, function, rows)
            result = called(model, function, tuple(np.asfortranarray(a) for a in rows))
            assert result.dtype == expected.dtype == dtype
            assert np.ascontiguousarray(result).tobytes() == expected.tobytes(), (function, dtype)


@pytest.mark.parametrize("name", some(sorted(ZOO), 40, 3))
def test_floats_are_as_near_as_the_condition_allows(name: str) -> None:
    """Roundings of M, h and tau by k units, four for every joint of a chain, and a solve.

    (M + dM) udot = tau - h + dh with |dM| <= k eps |M|, |dh| <= k eps (|tau| + |h|).
    """
    model = model_of(name)
    doubles, floats = arguments(model), arguments(model, "float32")
    q, u, tau = doubles["forward_dynamics"]
    M, h = model.mass_matrix(q), model.bias(q, u)
    k = 4 * (model.nu + 2)
    norm = np.linalg.norm
    mass = called(model, "mass_matrix", floats["mass_matrix"])
    assert (norm(mass - M, axis=(1, 2)) <= k * UNIT * norm(M, axis=(1, 2))).all()
    exact = called(model, "forward_dynamics", doubles["forward_dynamics"])
    single = called(model, "forward_dynamics", floats["forward_dynamics"])
    inverse = norm(np.linalg.inv(M), 2, axis=(1, 2))
    condition = inverse * norm(M, 2, axis=(1, 2))
    loads = norm(tau, axis=1) + norm(h, axis=1) + speed_terms(model, q, u)
    bound = k * UNIT * (condition * norm(exact, axis=1) + inverse * loads)
    error = norm(single - exact, axis=1)
    print(f"{name}: {np.max(error / bound):.1e} of the bound")
    assert (error <= bound).all()
    # they are floats
    assert error.max() > 0.01 * UNIT * np.abs(exact).max()


def speed_terms(model: cd.CompiledModel, q: np.ndarray, u: np.ndarray) -> np.ndarray:
    """What may cancel in h: products of speeds with entries of M."""
    M = np.abs(model.mass_matrix(q)).sum(axis=(1, 2))
    return np.asarray(M * (u**2).sum(axis=1))
