"""A model as WebAssembly that pages run: its functions, and its data as the kernels take them."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ...equations.functions import live
from ...equations.record import EquationRecord
from ...ir.function import Function
from ...ir.recursion import Recursion
from ...ir.trees.assembly import Assembly
from ...records import dataclass
from ...schema import wasm_kernels
from ...schema.manifest import Manifest
from ..export import model_file
from ..export.constants import Name, Value
from ..export.model_file import Content
from ..flat_scene import time_jumps
from ..header import Exported
from ..languages import wasm
from ..manifest import base
from ..writing import lowered
from .memory import Memory, places
from .module import Module

KERNELS, METHOD = "kernels", "dop853"
# records that a page fills in
RECORDS = ("cardan_simulation", "cardan_export")
# what runs call beside rhs, and what a page shows
CALLED = ("close_position", "close_velocity", "constraint_jacobian", "events", "transition")
DISPLAYED = ("energy", "outputs")


@dataclass(frozen=True)
class LiveModel:
    """A model for pages.

    Attributes:
        module: It works on the memory and the table of the kernels.
        manifest: What its numbers mean.
        scene: Address of ``cardan_scene``.
        end: First address behind its data.
        table: Length of the table with its functions.
        functions: Number of each function in ``cardan_scene``, and how many results it has.
        records: Where fields of records begin.
    """

    module: bytes
    manifest: Manifest
    scene: int
    end: int
    table: int
    functions: Mapping[str, tuple[int, int]]
    records: Mapping[str, Mapping[str, int]]


def build(
    equations: EquationRecord, frames: Sequence[str], start: Mapping[str, Sequence[float]]
) -> LiveModel:
    """Write a model.

    Args:
        equations: What to write.
        frames: Whose poses and velocities ``frames`` gives.
        start: Values to start from, by block.
    """
    manifest = base(equations).data
    written = functions(equations, frames)
    kernels = wasm_kernels.places(KERNELS)
    module = Module(kernels["heap_base"] + -kernels["heap_base"] % 16, table_base=kernels["table"])
    rows: dict[str, Exported] = {}
    sizes: dict[str, int] = {}
    for name, function in written.items():
        program = lowered(function)
        wasm.add(module, program)
        out = sum(output.size for output in function.outputs)
        counts = {"out": out, "work": program.work_size, "w": program.prepared_size}
        sizes |= {f"{name}_{key}_size": count for key, count in counts.items()}
        rows[name] = Exported("", program.blocks, counts)
    memory = Memory(module, kernels, sizes)
    memory.named("double inputs[]", inputs(manifest), ())
    model_file.declare(memory, manifest, Content(rows, start, fields(manifest)), (METHOD,))
    encoded = module.encoded()
    return LiveModel(
        encoded,
        manifest,
        memory.addresses["cardan_scene"],
        module.end,
        module.table_end,
        {name: (k, sizes[f"{name}_out_size"]) for k, name in enumerate(written)},
        {record: {n: at for n, (at, _) in places(record).items()} for record in RECORDS},
    )


def inputs(manifest: Manifest) -> list[float]:
    """Inputs where a run starts; behind those of the model stand forces along the speeds."""
    return [*model_file.starts(manifest, "r"), *[0.0] * len(manifest.speeds)]


def fields(manifest: Manifest) -> dict[str, Value]:
    """Fields of ``cardan_export`` that differ from those of an export."""
    return {"nr": len(inputs(manifest)), "r": Name("inputs")}


def functions(equations: EquationRecord, frames: Sequence[str]) -> dict[str, Function | Recursion]:
    """The functions of a page by their names.

    Args:
        equations: Of the model.
        frames: As of :func:`build`.
    """
    listed: dict[str, Function | Recursion] = {"rhs": live.rhs(equations)}
    available = equations.names()
    for name in (*CALLED, *DISPLAYED):
        if name in available:
            form = equations.form(name)
            # these are no sums over a tree, whose kernels WebAssembly does not have
            assert not isinstance(form, Assembly)
            listed[name] = form
    listed["frames"] = live.frames(equations, frames)
    jumps = time_jumps(equations.system)
    if jumps is not None:
        listed[jumps.name] = jumps
    return listed
