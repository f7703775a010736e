"""A mechanism for the searches in C: ``kernels/solve/position.h`` without targets."""

from __future__ import annotations

import ctypes
from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ...arrays import Array
from ...records import dataclass
from ...runtime.calls.interpreted import PythonFunction
from ...schema.records import COUNT, PositionRecord, TargetRecord, check

if TYPE_CHECKING:
    from .mechanism import Mechanism


@dataclass(frozen=True, eq=False)
class Connection:
    """Time-independent data of a mechanism for searches in C.

    Attributes:
        library: The kernels.
        record: A ``cardan_position`` without targets.
        references: What its pointers point to.
        rows: Of the Jacobian of the constraints.
        work: Numbers of work memory of its functions.
        called_back: Whether some of these are Python.
    """

    library: ctypes.CDLL
    record: PositionRecord
    references: list[Any]
    rows: int
    work: int = 0
    called_back: bool = False


def called(function: Callable[..., Array], size: int, **blocks: int) -> PythonFunction:
    """A function of arrays for kernels.

    Args:
        function: Blocks -> array.
        size: Numbers of the latter.
        blocks: Name -> numbers of each.
    """

    def results(*values: list[float]) -> Array:
        return np.asarray(function(*map(np.array, values)))

    return PythonFunction(results, [*blocks.items()], size)


@lru_cache(maxsize=4)
def searching(library: ctypes.CDLL) -> ctypes.CDLL:
    """The kernels with the types of the functions of searches declared.

    Raises:
        BuildError: their records differ from those here.
    """
    for name, structure in (("position", PositionRecord), ("target", TargetRecord)):
        check(library, f"cardan_{name}", structure)
    record = ctypes.POINTER(PositionRecord)
    for name in ("begin", "residuals", "jacobian"):
        getattr(library, f"cardan_position_{name}").argtypes = [record]
    library.cardan_position_length.argtypes = [record]
    library.cardan_position_length.restype = COUNT
    library.cardan_position_solve.argtypes = [record, COUNT]
    return library


def connect(m: Mechanism, required: NDArray[np.bool_]) -> Connection:
    """The connection to the functions of a model.

    Args:
        m: The mechanism.
        required: Which constraints of positions must hold.
    """
    model, record = m.model, PositionRecord()
    layout = model._layout
    arrays = {
        **{letter: layout.start(letter).copy() for letter in "zsr"},
        "hard_rows": np.flatnonzero(required),
        "rows": m.rows[: len(required)].copy(),
        "columns": m.columns,
        "quaternions": np.array(model.manifest.quaternions, dtype=np.intp),
    }
    for name, array in arrays.items():
        setattr(record, name, array.ctypes.data)
    record.nq, record.nu, record.positions = model.nq, m.nu, len(required)
    record.hard_count, record.quaternion_count = (
        len(arrays["hard_rows"]),
        len(arrays["quaternions"]),
    )
    names = ["constraints", "constraint_jacobian"] if len(required) else []
    names += ["assembly_signs"] if m.cuts and "assembly_signs" in model.manifest.available else []
    names += [] if m.chosen else ["integrate"]
    # a start goes on with these: one run of the compiler makes all
    later = ("constraint_rates", *(("difference", "qdot") if m.cuts else ()))
    more = [name for name in later if name in model.manifest.available]
    functions = model._load([(name, None) for name in (*names, *more)])[: len(names)]
    references: list[Any] = [arrays, functions]
    # C reads addresses; Python keeps the arrays and functions alive in `references`
    for name, function in zip(names, functions, strict=True):
        setattr(record, name, function.address)
        setattr(record, f"{name}_w", function.w.ctypes.data)
        if name == "assembly_signs":
            record.assembly_sign_count = function.caller.size
    if m.chosen:
        moved = called(m.moved, model.nq, q=model.nq, du=m.nu)
        record.integrate = moved.address
        references.append(moved)
    work = max((function.work_size for function in functions), default=0)
    python = m.chosen or any(function.interpreted for function in functions)
    return Connection(
        searching(model._kernels()), record, references, len(m.closing.rows), work, python
    )
