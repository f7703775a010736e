"""What goes along with exported C: a header of all functions, an example, words for the reader."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..schema.integrators import KERNELS
from . import header
from .naming import comment
from .simulating import CLOSING, HAPPENING, simulation

# integrators by their files
INTEGRATORS = {name: method for name, method in KERNELS.items() if not method.elements}
# what every run needs of ``kernels/``, beside what its method leads to
RUN = ("run.c", "memory.c")


def prototypes(manifest: dict[str, Any]) -> str:
    """The header of the exported functions, with the sizes a caller must provide."""
    lines = [
        "/*",
        f" * functions.h: what model '{comment(manifest['name'])}' computes.",
        " *",
        " * out, work and w are arrays of the caller of at least the sizes given here.",
        " */",
        "#ifndef CARDAN_FUNCTIONS_H",
        "#define CARDAN_FUNCTIONS_H",
        "",
        '#include "model.h"',
        "",
        "/* model.c: values to start from; speeds start from 0 */",
        *(f"extern const double {header.array(block)};" for block in "qrp"),
    ]
    for name, entry in manifest["functions"].items():
        reads = ", ".join(entry["inputs"]) or "nothing"
        lines += ["", f"/* {comment(entry['about'] or name)}; reads {reads} */", "enum {"]
        lines += [
            f"    {name}_out_size = {entry['output_size']},",
            f"    {name}_work_size = {entry['work_size']},",
            f"    {name}_w_size = {entry['prepared_size']}",
            "};",
            f"CARDAN_API int {name}(const cardan_in *in, real *out, real *work);",
            f"CARDAN_API void prepare_{name}(const wreal *p, wreal *w);",
        ]
    return "\n".join([*lines, "", "#endif"]) + "\n"


def example(manifest: dict[str, Any], integrators: Sequence[str], compile_line: str) -> str:
    """``example.c``: the first function at the start, and one second of motion if it can."""
    called = {*CLOSING, *HAPPENING, *(name for method in KERNELS.values() for name in method.needs)}
    name = min(manifest["functions"], key=called.__contains__)
    fields = _fields(manifest["functions"][name]["inputs"])
    zero = f"zero[{_zeros(manifest)}], " if "zero" in fields else ""
    lines = [
        f"/* Try it:  {compile_line} */",
        '#include "functions.h"',
        *(['#include "run.h"'] if integrators else []),
        "#include <stdio.h>",
        "",
        "/* so that *.c of this folder links with a main of yours */",
        "#ifdef CARDAN_EXAMPLE",
        "",
        *(simulation(integrators[0], manifest).splitlines() if integrators else []),
        "int main(void)",
        "{",
        f"    static real {zero}out[{name}_out_size + 1];",
        f"    static real work[{name}_work_size + 1], w[{name}_w_size + 1];",
        f"    const cardan_in in = {{{fields}}};",
        "",
        f"    prepare_{name}(cardan_default_p, w);",
        f"    int status = {name}(&in, out, work);",
        f"    for (int k = 0; k < {name}_out_size; k++)",
        f'        printf("{name}[%d] = %.17g\\n", k, out[k]);',
        *(["    status |= simulate();"] if integrators else []),
        "    return status;",
        "}",
        "",
        "#endif",
    ]
    return "\n".join(lines) + "\n"


def _zeros(manifest: dict[str, Any]) -> str:
    """Length of what stands for everything that is zero."""
    parts = sum(len(body["parts"]) for body in manifest["bodies"])
    blocks = ("speeds", "coordinates", "z", "s", "events")
    return f"{max(6 * parts, 1, *(len(manifest.get(block, ())) for block in blocks))}"


def _fields(inputs: Sequence[str]) -> str:
    """The input blocks at the start; what the function does not read stays NULL."""
    known = {"q": "cardan_default_q", "q0": "cardan_default_q", "r": "cardan_default_r"}
    read = [block for block in inputs if block != "p"]
    return ", ".join([*(f".{b} = {known.get(b, 'zero')}" for b in read), ".w = w"])


def compile_line(flags: Sequence[str]) -> str:
    """How to compile and run the example."""
    return f"cc {' '.join(flags)} -DCARDAN_EXAMPLE -o example *.c -lm && ./example"


def readme(manifest: dict[str, Any], package: str, compile_line: str) -> str:
    """``README.md``: what is here, in which units, under which conventions."""
    lines = [
        f"# {words(manifest['name'])}",
        "",
        "C functions of a multibody model, written by cardan; nothing here needs cardan.",
        "",
        "| file | what it is |",
        "|---|---|",
        "| `functions.h`, `model.h` | prototypes and sizes; places of entries by name |",
        "| `model.c` | values of the scene: parameters, start, inputs |",
        "| `example.c` | a call from C: `" + compile_line + "` |",
        "| `manifest.json` | all names, units, shapes and hashes, for programs |",
    ]
    if package:
        use = f"`pip install .`, then `import {package}`"
        lines.append(f"| `{package}.pyx`, `setup.py` | a package for NumPy: {use} |")
    lines += ["", "| function | reads | gives |", "|---|---|---|"]
    for name, entry in manifest["functions"].items():
        shape = ", ".join(f"{o['name']} {tuple(o['shape'])}" for o in entry["outputs"])
        lines.append(
            f"| `{name}` | {', '.join(entry['inputs'])} | {words(entry['about'])}: {shape} |"
        )
    if manifest.get("events"):
        lines += [
            "",
            "This model has events: where a number of `events` falls through zero the states",
            "become those of `transition`. A run that calls `rhs` alone runs past them; exported",
            "with integrators, `simulate` of `example.c` finds and prints them and goes on. Modes",
            "`s` start from the defaults in `manifest.json`.",
        ]
    for title, key in (("q", "coordinates"), ("u", "speeds"), ("r", "inputs")):
        rows = [f"{words(row['name'])} [{row['unit'] or '1'}]" for row in manifest[key]]
        lines += ["", f"**{title}** ({key}, {len(rows)}): {', '.join(rows) or 'none'}"]
    lines += [
        "",
        "Conventions: M udot + h = f + tau, where the bias h holds velocity products and gravity;",
        "u are speeds (v of robotics); quaternions are w x y z and of unit length; speeds of",
        "spherical and free joints are the angular velocity in body axes; 6-vectors have the",
        "angular part first; SI units, radians. Call `prepare_<function>` once per set of",
        "parameters.",
        "",
        "Many states at once: gcc and clang compile the same files with `-DCARDAN_LANES=8`",
        "(4, 2). A `real` is then a vector, entry k of an array belongs to 8 states, element j of",
        "it to state j; arrays begin at multiples of 64 bytes. Parameters are shared, or one set",
        "per state with `-DCARDAN_LANE_PARAMETERS`. Flags that make lanes equal to single states",
        "to the bit: `-O2 -march=native -fno-tree-vectorize -fno-math-errno`, and with gcc",
        "`-ffp-contract=fast --param=avoid-fma-max-bits=0`, with clang `-ffp-contract=on`. A",
        "program that wants both renames one: `-Drhs=rhs_lanes`.",
        "",
        "Compile only what you trust: C runs with all your rights.",
    ]
    return "\n".join(lines) + "\n"


def words(text: str) -> str:
    """Words of the user in Markdown."""
    plain = "".join(c if c.isprintable() else " " for c in text)
    return "".join(f"\\{c}" if c in "\\`*_{}[]<>|#&" else c for c in plain)
