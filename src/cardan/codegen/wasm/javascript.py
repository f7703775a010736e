"""JavaScript that loads the functions of a model in WebAssembly, and calls them."""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping, Sequence
from math import prod
from textwrap import wrap

from ...schema.blocks import ARGUMENTS, ORDER
from ...schema.c_functions import FunctionRow, ResultRow
from ...schema.manifest import Manifest
from ..export.model_file import starts
from ..languages import binding
from ..languages.binding import BoundModel
from ..program import naming
from ..sources import source

COLUMNS = 100
# files that every export has
TAKEN = ("functions", "example")
# what a call shows best
EXAMPLES = ("forward_dynamics", "rhs", "mass_matrix", "energy")
# entries of a result that a comment lists
FEW = 12
# shapes in the texts of arguments
_SHAPE = re.compile(r",? \(\.\.\.[^)]*\)")
_TAG = re.compile(r"<(?=[/!]|script)", re.IGNORECASE)

HEAD = """\
/* {title}: functions of a multibody model as WebAssembly, for node and for pages.
 *
 * {about}
 * Speeds u are what robotics calls v, quaternions are (w, x, y, z), 6-vectors have the angular part
 * first, units are SI and radians. Blocks are arrays, or objects that change values at the start by
 * their names. Matrices come row by row. All numbers have the bits of the C of this folder without
 * contraction.
 *
 *     import {{ load }} from "./{package}.mjs";
 *     const model = await load();
 *     model.{call};
 */

const MODEL_FILE = "{package}.wasm", KERNELS_FILE = "{kernels}.wasm";
const END = {end}; // first address behind the constants of both

export const NAME = {name};
export const COORDINATES = {coordinates};
export const SPEEDS = {speeds};
export const INPUTS = {inputs};
export const PARAMETERS = {parameters};
export const BODIES = {bodies};

/** Where the scene starts, with its inputs and parameters. */
export const START = Object.freeze({{
{start}
}});

const NAMES = {{
  q: COORDINATES, q0: COORDINATES, u: SPEEDS, udot: SPEEDS, tau: SPEEDS, du: SPEEDS, r: INPUTS,
  p: PARAMETERS,
}};
const DEFAULTS = {{ ...START, q0: START.q }};
const SIZES = {sizes};
// places of their pointers
const SLOTS = {slots};
// blocks of each, those that have no default, lengths of what it works on, entries of its results
// and of its block v, where it has one
const FUNCTIONS = {{
{functions}
}};
"""
EXAMPLE = """\
// Try it:  node example.mjs
import {{ load, START }} from "./{package}.mjs";

const model = await load();
console.log(model.{call});
"""


def package(manifest: Manifest) -> str:
    """Name of the files of a model."""
    name = naming.mangle(manifest.name).lower()
    return f"{name}_model" if name in TAKEN else name


def text(model: BoundModel, kernels: str, end: int) -> str:
    """The module of JavaScript.

    Args:
        model: What it calls.
        kernels: Name of the kernels that the functions call.
        end: First address behind the constants of both.
    """
    manifest = model.manifest
    sizes = _sizes(manifest)
    lists = {key: _list(names) for key, names in binding.names(manifest).items()}
    start = {block: model.start.get(block) or starts(manifest, block) for block in "quzsrp"}
    head = HEAD.format(
        title=_comment(manifest.name),
        about=binding.summary(manifest),
        package=package(manifest),
        call=_call(manifest),
        kernels=kernels,
        end=end,
        name=_literal(manifest.name),
        start="\n".join(f"  {block}: {_list(values, 2)}," for block, values in start.items()),
        sizes=_record(sizes),
        slots=_record({block: ORDER.index(block) for block in ORDER if block != "zdot"}),
        functions="\n".join(_row(*one) for one in manifest.functions.items()),
        **lists,
    )
    methods = "".join(_method(*one, sizes) for one in manifest.functions.items())
    return head + source("wasm.mjs").replace("__FUNCTIONS__", methods)


def example(manifest: Manifest) -> str:
    """A program that calls one function."""
    return EXAMPLE.format(package=package(manifest), call=_call(manifest))


def guide(manifest: Manifest) -> str:
    """Usage, for the README."""
    return source("wasm.md").format(package=package(manifest), call=_call(manifest)).rstrip()


def _sizes(manifest: Manifest) -> dict[str, int]:
    """Lengths of what functions take; of w there is one for every function."""
    size = binding.sizes(manifest)
    parts = sum(len(body.parts) for body in manifest.bodies)
    size |= {"w": 0, "q0": size["q"], "lam": len(manifest.multipliers), "wrench": 6 * parts}
    # of v the longest one
    vectors = [len(row.vector) for row in manifest.functions.values()]
    size |= {"e": len(manifest.events), "v": max(vectors, default=0)}
    return {block: size[block] for block in (*ORDER, "x") if block != "zdot"}


def _call(manifest: Manifest) -> str:
    """A call of a function at the start."""
    functions = manifest.functions
    name = next((one for one in EXAMPLES if one in functions), next(iter(functions)))
    size, state = _sizes(manifest), [f"...START.{block}" for block in "quz"]
    size["v"] = len(functions[name].vector)
    values = {"q": "START.q", "q0": "START.q", "u": "START.u", "x": f"[{', '.join(state)}]"}
    blocks = [
        f"{block}: {values.get(block, f'new Float64Array({size[block]})')}"
        for block in _needed(name, functions[name])
    ]
    return f"{name}({{ {', '.join(blocks)} }})" if blocks else f"{name}()"


def _needed(name: str, entry: FunctionRow) -> list[str]:
    """Blocks without which a function cannot be called."""
    return [one for one in binding.arguments(name, entry) if not ARGUMENTS[one].default]


def _row(name: str, entry: FunctionRow) -> str:
    """Facts that a call of a function has to know."""
    takes, needs = (
        _array(blocks, 4) for blocks in (binding.arguments(name, entry), _needed(name, entry))
    )
    sizes = f"out: {entry.output_size}, work: {entry.work_size}, w: {entry.prepared_size}"
    entries = [one for output in entry.outputs for one in _entries(output)]
    vector = f"    vector: {_array(entry.vector, 4)},\n" if entry.vector else ""
    return (
        f"  {name}: {{\n    takes: {takes}, needs: {needs}, {sizes},\n"
        f"    entries: {_array(entries, 4)},\n{vector}  }},"
    )


def _entries(output: ResultRow) -> Sequence[str]:
    """A name for every entry of a result."""
    count = prod(output.shape)
    if len(output.entries) == count:
        return output.entries
    return [output.name if count == 1 else f"{output.name}[{k}]" for k in range(count)]


def _method(name: str, entry: FunctionRow, sizes: Mapping[str, int]) -> str:
    """The method of a function, with what it takes and gives."""
    takes, needs = binding.arguments(name, entry), _needed(name, entry)
    outputs = _results(name, entry)
    call = f'this.#call("{name}", blocks)'
    if len(outputs) == 1:
        kind, at = ("Float64Array", "") if outputs[0].shape else ("number", "[0]")
        body = [f"  return {call}{at};"]
    else:
        kind, start, body = "object", 0, [f"  const results = {call};", "  return {"]
        for output in outputs:
            end = start + prod(output.shape)
            part = f".slice({start}, {end})" if output.shape else f"[{start}]"
            body.append(f"    {_key(output.name)}: results{part},")
            start = end
        body.append("  };")
    listed = "; ".join(_summary(output) for output in outputs)
    lines = ["", *_paragraph("/** ", f"{entry.about or name}."), " *", " * @param {object} blocks"]
    for one in takes:
        size = len(entry.vector) if one == "v" else sizes[one]
        about = _SHAPE.sub("" if one == "t" else f" ({size})", ARGUMENTS[one].text)
        lines += _paragraph(f" *   {one}{'' if one in needs else '?'}: ", about)
    lines += [*_paragraph(f" * @returns {{{kind}}} ", listed), " */"]
    lines += [f"{name}(blocks{'' if needs else ' = {}'}) {{", *body, "}"]
    return "".join(f"  {line}\n" if line else "\n" for line in lines)


def _paragraph(first: str, about: str) -> list[str]:
    """Lines of a comment."""
    indent = " *     " if first.startswith(" *") else " *  "
    return wrap(
        f"{first}{_comment(about)}",
        COLUMNS - 2,
        subsequent_indent=indent,
        break_long_words=False,
        break_on_hyphens=False,
    )


def _key(name: str) -> str:
    """A field of an object; a computed ``__proto__`` is a field as any other."""
    return name if re.fullmatch(r"[a-z]\w*", name, re.ASCII) else f"[{_literal(name)}]"


def _results(name: str, entry: FunctionRow) -> Sequence[ResultRow]:
    """Results of a function; the derivative of a state is one, as the state is."""
    if name == "rhs":
        entries = [one for output in entry.outputs for one in _entries(output)]
        return [ResultRow(name="xdot", shape=[entry.output_size], entries=entries)]
    return entry.outputs


def _summary(output: ResultRow) -> str:
    """Name, shape and entries of a result."""
    units = output.units or [""] * len(output.entries)
    pairs = zip(output.entries, units, strict=True)
    named = [f"{one} [{unit}]" if unit else one for one, unit in pairs]
    shape = f" ({' x '.join(map(str, output.shape))})" if output.shape else ""
    listed = f": {', '.join(named)}" if output.shape and 0 < len(named) <= FEW else ""
    return f"{output.name}{shape}{listed}"


def _comment(content: str) -> str:
    """Words of the user in a comment, also of a script that stands in a page."""
    return _TAG.sub("< ", naming.comment(content))


def _literal(value: object) -> str:
    """A string or a number, also in a script that stands in a page."""
    encoded = json.dumps(value, ensure_ascii=False).replace("<", "\\u003c")
    return "".join(c if c.isprintable() else json.dumps(c)[1:-1] for c in encoded)


def _record(fields: dict[str, int]) -> str:
    """Numbers by block."""
    return _wrapped("{", [f"{name}: {value}" for name, value in fields.items()], "}", 0)


def _list(values: Iterable[object], indent: int = 0) -> str:
    """An array that nobody changes."""
    return f"Object.freeze({_array(values, indent)})"


def _array(values: Iterable[object], indent: int) -> str:
    return _wrapped("[", [_literal(one) for one in values], "]", indent)


def _wrapped(first: str, items: Sequence[str], last: str, indent: int) -> str:
    """Items between brackets: in one line, or in several."""
    line = ", ".join(items)
    if len(line) + indent < COLUMNS - 40:
        return f"{first}{line}{last}"
    lines, inner = [""], " " * (indent + 2)
    for item in items:
        if lines[-1] and len(inner) + len(lines[-1]) + len(item) + 2 > COLUMNS:
            lines.append("")
        lines[-1] += f"{' ' if lines[-1] else ''}{item},"
    return "\n".join([first, *(inner + line for line in lines), " " * indent + last])
