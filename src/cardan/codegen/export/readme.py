"""``README.md`` of an export: what is here, in which units, under which conventions."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from ...schema.manifest import BLOCKS, Manifest
from ..header import BLOCKS as LISTED
from ..header import Exported
from ..languages.binding import Binding
from ..sources import source

MOST = 60  # names in a list
FILES = {
    "`functions.h`, `model.h`": "prototypes and sizes; places of entries by name",
    "`model.c`": "values of the scene: parameters, start, inputs",
    "`manifest.json`": "all names, units, shapes and hashes, for programs",
}
ELEMENT_FILES = {
    "`elements.c`, `tables.h`": "the model as a whole; its elements, and the plan of its sparse "
    "matrix",
    "`<kind>__<function>.c`": "what an element of a kind does",
    "`data_<k>__<kind>.c`": "numbers of its elements by the parameters",
    "`mesh*.c`, `sparse*.c`": "loops over elements and sparse matrices: the same for every model",
    "`functions.json`, `mesh.npz`": "expressions and numbers, for programs",
}
RUN_FILES = {"`simulate.h`": "a run from C: methods, tolerances, rows of output, events"}
SWEEP_FILES = {
    "`motion_gradient.h`": "a cost of a run and its gradient, by a sweep back over the steps"
}
LANE_FILES = {
    "`simulate_lanes.h`, `model_lanes.c`, `lane_*.c`": "runs side by side in vectors: "
    "`simulate_lanes.h` says how to compile them; `example_lanes.c` is an example"
}
NOTATION = """\
Values are called `<owner>_<quantity>_<component>`; above a section stand formulas of what it
computes: R turns axes of the child to those of its parent, p is where the child is, S its modes of
motion, [x] the matrix of x cross; h and J are first and second moment of mass, I is inertia, all
about the origin of a body and in its axes; X takes twists from parent to child."""
EVENTS = """\
This model has events: where a number of `events` falls through zero the states become those of
`transition`. A run that calls `rhs` alone runs past them; exported with integrators,
`cardan_simulate` finds them and goes on, and `example.c` prints them. Modes `s` start from the
defaults in `manifest.json`."""


def readme(
    manifest: Manifest,
    functions: Mapping[str, Exported],
    compile_line: str,
    runs: tuple[bool, bool, bool],
    binding: Binding | None = None,
) -> str:
    """The file.

    Args:
        manifest: Of the model.
        functions: Those of the export.
        compile_line: How to compile and run the example.
        runs: Whether integrators came along, whether they run side by side, and have a gradient.
        binding: What calls the C, if anything does.
    """
    meshed = manifest.absolute
    files = {**FILES, "`example.c`": f"a call from C: `{compile_line}`"}
    files |= (ELEMENT_FILES if meshed else {}) | (RUN_FILES if runs[0] else {})
    files |= LANE_FILES if runs[1] else {}
    files |= SWEEP_FILES if runs[2] else {}
    if binding:
        package = binding.package(manifest)
        files[binding.listed.format(package=package)] = binding.use.format(package=package)
    listed = [
        (f"`{name}`", ", ".join(entry.inputs), escaped(entry.about) + _shapes(entry))
        for name, entry in functions.items()
    ]
    lines = [
        f"# {escaped(manifest.name)}",
        "",
        "C of a multibody model, written by cardan; nothing here needs cardan or Python.",
        *_table(("file", "what it is"), files.items()),
        *(_table(("elements", "how many", "functions"), _kinds(manifest)) if meshed else ()),
        *_table(("function", "reads", "gives"), listed),
    ]
    lines += ["", *NOTATION.splitlines()]
    if manifest.events:
        lines += ["", *EVENTS.splitlines()]
    for block in LISTED:
        rows = manifest.block(block)
        names = [f"{escaped(row.name)} [{row.unit or '1'}]" for row in rows[:MOST]]
        more = len(rows) - len(names)
        listing = ", ".join(names) + (f" and {more} more in `model.h`" if more > 0 else "")
        lines += ["", f"**{block}** ({BLOCKS[block]}, {len(rows)}): {listing or 'none'}"]
    guide = binding.guide(manifest) if binding else ""
    lines += ["", guide] if guide else []
    return "\n".join([*lines, "", source("elements.md" if meshed else "relative.md")])


def _table(head: Sequence[str], rows: Iterable[Sequence[str]]) -> list[str]:
    """A table of Markdown, after an empty line."""
    lines = (f"| {' | '.join(row)} |" for row in (head, *rows))
    first = next(lines)
    return ["", first, f"|{'---|' * len(head)}", *lines]


def _shapes(entry: Exported) -> str:
    """Names and shapes of the results of a function."""
    shapes = ", ".join(f"{output.name} {tuple(output.shape)}" for output in entry.outputs)
    vector = f"; v has {entry.vector} numbers" if entry.vector else ""
    return (f": {shapes}" if shapes else "") + vector


def _kinds(manifest: Manifest) -> list[tuple[str, str, str]]:
    """Kinds of elements, how many there are of each, and their functions."""
    counts: dict[str, int] = {}
    for group in manifest.elements.groups:
        counts[group.kind] = counts.get(group.kind, 0) + len(group.members)
    functions = {kind.name: ", ".join(kind.functions) for kind in manifest.elements.kinds}
    return [(escaped(k), str(count), escaped(functions[k])) for k, count in counts.items()]


def escaped(text: str) -> str:
    """Words of the user in Markdown."""
    plain = "".join(c if c.isprintable() else " " for c in text)
    return "".join(f"\\{c}" if c in "\\`*_{}[]<>|#&" else c for c in plain)
