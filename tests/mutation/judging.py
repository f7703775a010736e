"""Whether a fault changes a result, and who notices it."""

from __future__ import annotations

import ctypes
import subprocess
import tempfile
import warnings
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from cardan.api.compiled_model import CompiledModel
from cardan.errors import CardanError
from cardan.ir.interpreter import evaluate
from cardan.ir.serialize import from_dict, to_dict
from cardan.runtime.calls.code import Code
from cardan.runtime.verification.closed_states import bound
from cardan.runtime.verification.flat_scene import scene_of
from cardan.runtime.verification.verify import _reference, verify

from .scenes import Loaded

STATES, SEED = 12, 99
# results that differ by less than this part of their largest entry differ by rounding
ROUNDING = 1e-10
# functions that are there for positions at which loops are not closed
OFF = ("constraints", "constraint_rates", "constraint_jacobian", "closure", "assembly_signs")
OFF += ("close_position", "close_velocity", "integrate", "move", "difference")


@dataclass(frozen=True)
class States:
    """Where the functions of a scene are compared with and without a fault, (n, ...) each."""

    on: dict[str, Any]
    off: dict[str, Any]


def states_of(base: Loaded) -> States:
    """Random states that obey the constraints, and others; modes and events drawn too."""
    model, rng = base.model, np.random.default_rng(SEED)
    if not base.keys:
        return States({}, {})
    truth = _reference(model, scene_of(model), STATES, SEED, circuits=bound(model))
    layout, n = model._layout, len(truth.q)
    sizes = {"lam": len(layout.multipliers), "du": model.nu, "e": len(layout.events)}
    sizes["z"] = model.nz
    found = {k: rng.uniform(-1, 1, (n, size)) for k, size in sizes.items()}
    found["e"] = (found["e"] > 0).astype(float)
    found["wrench"] = rng.uniform(-1, 1, (n, 6 * len(layout.parts)))
    found["s"] = np.broadcast_to(layout.start("s"), (n, len(layout.modes)))
    found |= {"t": np.full((n, 1), truth.t), "q": truth.q, "u": truth.u, "r": truth.r}
    found |= {"udot": truth.udot, "tau": truth.tau, "p": model.parameters.vector}
    found["q0"] = truth.q[::-1].copy()
    away = 0.05 * rng.uniform(-1, 1, (n, model.nu))
    off = model._function("integrate", None).caller(None, *_asked(model, found, away))
    return States(found, {**found, "q": off})


def _asked(model: CompiledModel, found: dict[str, Any], du: Any) -> list[Any]:
    return [found["q"], du]


def results(text: dict[str, Any], blocks: dict[str, Any]) -> Any:
    """Everything a function gives, one row per state."""
    function, n = from_dict(text), len(blocks["q"])
    with np.errstate(all="ignore"):
        found = evaluate(function, blocks, "numpy")
    parts = []
    for o in function.outputs:
        lead = found[o.name].shape[: found[o.name].ndim - len(o.shape)]
        flat = found[o.name].reshape(*lead, len(o.nodes))
        parts.append(np.broadcast_to(flat, (n, len(o.nodes))))
    return parts


def changes(one: list[Any], other: list[Any]) -> bool:
    """Whether results differ by more than rounding."""
    for a, b in zip(one, other, strict=True):
        good = np.isfinite(a).all(axis=-1) & np.isfinite(b).all(axis=-1)
        if (np.isfinite(a).all(axis=-1) != np.isfinite(b).all(axis=-1)).any():
            return True
        size = np.abs(a[good]).max(initial=0.0)
        if np.abs(a[good] - b[good]).max(initial=0.0) > ROUNDING * (size or 1.0):
            return True
    return False


def by_verify(model: CompiledModel, keys: Any) -> str:
    """What the verification says of a model; "" where it finds nothing."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            verify(model, functions=keys)
        except CardanError as found:
            return str(found)[:200]
        except (FloatingPointError, np.linalg.LinAlgError, ValueError, ZeroDivisionError) as found:
            return f"{type(found).__name__}: {found}"[:200]
    return ""


def by_laws(base: Loaded, name: str, text: dict[str, Any], at: States) -> bool:
    """Whether another formalism disagrees, as the law of formalisms asks."""
    other = "newton_euler" if base.equations.method != "newton_euler" else "kane"
    try:
        known = to_dict(replace(base.equations.fresh, method=other).function(name))
        return changes(results(known, at.on), results(text, at.on))
    except (CardanError, KeyError, ValueError):
        return False


def by_ledger(model: CompiledModel) -> bool:
    """Whether a short run leaves energy that no power accounts for."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            x, h, work = model.random_state(3), 2e-3, 0.0
            r = model._layout.start("r")

            def power(x: Any, t: float) -> float:
                q, u, z = model.parts_of(x)
                return float(np.sum(model.power(q, u, z=z, t=t)))

            def total(x: Any, t: float) -> float:
                q, u, _ = model.parts_of(x)
                return float(model.energy(q, u, t=t)[2])

            start, moved, t = total(x, 0.0), 0.0, 0.0
            for _ in range(25):
                k1 = model.rhs(t, x, r)
                k2 = model.rhs(t + h / 2, x + h / 2 * k1, r)
                k3 = model.rhs(t + h / 2, x + h / 2 * k2, r)
                middle = x + h / 2 * k2
                k4 = model.rhs(t + h, x + h * k3, r)
                new = x + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4)
                step = h / 6 * (power(x, t) + 4 * power(middle, t + h / 2) + power(new, t + h))
                work, moved = work + step, moved + abs(step)
                x, t = new, t + h
            end = total(x, t)
            kinetic = float(model.energy(*model.parts_of(x)[:2], t=t)[0])
            return bool(abs(end - start - work) > 1e-5 * (kinetic + moved + 1e-9))
        except (CardanError, ArithmeticError, ValueError, KeyError):
            return True


def compiled(base: Loaded, symbol: str, text: str) -> Code:
    """A function from C with a fault, without any optimization.

    Raises:
        subprocess.CalledProcessError: it is not a C any more.
    """
    folder = Path(tempfile.mkdtemp())
    source, target = folder / f"{symbol}.c", folder / "fault.so"
    source.write_text(text, encoding="utf-8")
    command = ["cc", "-O0", "-w", "-std=gnu99", "-fPIC", "-shared", "-I", str(base.model.directory)]
    subprocess.run(
        [*map(str, command), str(source), "-o", str(target), "-lm"], check=True, capture_output=True
    )
    library = ctypes.CDLL(str(target))
    address = ctypes.cast(library[symbol], ctypes.c_void_p).value or 0
    prepare = ctypes.cast(library[f"prepare_{symbol}"], ctypes.c_void_p).value or 0
    entry = base.model.manifest["functions"][symbol]
    return Code(symbol, entry, False, address, prepare, library=library)
