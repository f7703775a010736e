"""Head of a generated file: its results, inputs and cost."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from typing import NamedTuple

from ...ir.function import Block, Function, Output
from ...ir.ops import LEAVES
from ...ir.trees.assembly import Form
from ...schema.blocks import BLOCKS
from .naming import comment
from .routines import Built


class Cost(NamedTuple):
    """Cost of a call: lengths of work and w, operations of the call and of prepare."""

    work: int
    w: int
    run: dict[str, int]
    prepare: dict[str, int]


# blocks longer than this are not listed entry by entry
LONG = 150


def operations(built: Built) -> dict[str, int]:
    """Number of computed nodes per operator, the most frequent first."""
    counts = built.operators
    rows = [(op, n) for op, n in counts.items() if op not in LEAVES and op != "item"]
    return dict(sorted(rows, key=lambda row: (-row[1], row[0])))


def head(
    function: Form, model: str, notes: Sequence[str], blocks: Collection[str], cost: Cost
) -> tuple[tuple[str, ...], ...]:
    """Paragraphs of the head comment.

    Args:
        blocks: Input blocks that are read.
        cost: What it needs.
    """
    title = f"{function.name} of {model}" if model else function.name
    first = [comment(title)]
    if function.about:
        first.append(comment(function.about))
    if isinstance(function, Function):
        # of a kind of elements
        formula = function.graph.formulas.get(function.name.partition("__")[0])
        first.extend([comment(formula)] if formula else [])
    first.extend(comment(note) for note in notes)
    size = sum(output.size for output in function.outputs)
    sizes = (
        f"Sizes: out {size}, work {cost.work}, w {cost.w}",
        f"Operations per call: {_counts(cost.run)}",
        f"Operations of prepare: {_counts(cost.prepare)}",
    )
    paragraphs = [tuple(first), sizes]
    paragraphs.extend(_input(block) for block in function.inputs if block.name in blocks)
    at = 0
    for output in function.outputs:
        paragraphs.append(_output(output, at))
        at += output.size
    return tuple(paragraphs)


def _counts(counts: dict[str, int]) -> str:
    listed = ", ".join(f"{n} {op}" for op, n in counts.items())
    return f"{sum(counts.values())} = {listed}" if counts else "none"


def _input(block: Block) -> tuple[str, ...]:
    meaning = BLOCKS[block.name].meaning if block.name in BLOCKS else "input"
    if block.name == "p":
        return (f"Input p ({len(block)}): {meaning}, read by prepare_ only",)
    return (
        f"Input {block.name} ({len(block)}): {meaning}",
        *_entries(block.name, 0, block.entries, block.units),
    )


def _output(output: Output, at: int) -> tuple[str, ...]:
    shape = " x ".join(str(n) for n in output.shape) or "scalar"
    line = f"Output {comment(output.name)} ({shape})"
    if not output.size:
        return (f"{line}: empty",)
    if output.entries and len(output.shape) < 2:
        return (line, *_entries("out", at, output.entries, output.units))
    last = f" ... {at + output.size - 1}" if output.size > 1 else ""
    rows = ", row by row" if len(output.shape) > 1 else ""
    return (f"{line}: out[{at}{last}]{rows}",)


def _entries(array: str, at: int, entries: Sequence[str], units: Sequence[str]) -> tuple[str, ...]:
    """One line per entry: element, name and unit."""
    if len(entries) > LONG:
        return (f"  {array}[{at} ... {at + len(entries) - 1}]: named where they are read",)
    lines = []
    for k, entry in enumerate(entries):
        unit = f" [{units[k]}]" if units and units[k] else ""
        lines.append(comment(f"  {array}[{at + k}]  {entry}{unit}"))
    return tuple(lines)
