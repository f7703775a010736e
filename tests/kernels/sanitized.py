"""A small C program that runs every function of an exported model on memory of exactly its size."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

import numpy as np

from cardan.schema.blocks import ORDER

HEAD = """\
#include "functions.h"
#include "map.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* numbers on the heap, not one more than asked for */
static real *room(size_t n)
{
    real *x = malloc(n * sizeof(real) + (n == 0));

    if (x == NULL)
        abort();
    memset(x, 255, n * sizeof(real));
    return x;
}

static real *copy(const real *given, size_t n)
{
    real *x = room(n);

    if (n > 0)
        memcpy(x, given, n * sizeof(real));
    return x;
}
"""

RUN = """
static int run_{name}(void)
{{
    real *p = copy(given_p, {np}), *w = room({name}_w_size), *work = room({name}_work_size);
    real *out = room({count} * {name}_out_size);
    real *block[{number}] = {{NULL}};
    const real *at[{number}] = {{NULL}};
    size_t stride[{number}] = {{0}};
    ptrdiff_t failed;
    int status;

    prepare_{name}(p, w);
{blocks}
    for (int k = 0; k < {number}; k++)
        at[k] = block[k];
    at[7] = w;
    status = cardan_map({name}, at, stride, {count}, out, {name}_out_size, work, &failed);
    for (size_t k = 0; k < {count} * (size_t){name}_out_size; k++)
        printf("%.17g\\n", out[k]);
    for (int k = 0; k < {number}; k++)
        free(block[k]);
    free(p);
    free(w);
    free(work);
    free(out);
    return status;
}}
"""


def program(
    manifest: Mapping[str, Any], names: Iterable[str], given: Mapping[str, np.ndarray], p: Any
) -> str:
    """The text of the program; it prints every result, state by state.

    Args:
        manifest: Of the exported model.
        names: C names of the functions, in the order of the output.
        given: Block -> (count, size).
        p: Parameters.
    """
    count = len(next(iter(given.values())))
    text = [HEAD, _array("p", np.asarray(p))]
    text += [_array(name, values) for name, values in given.items()]
    for name in names:
        entry = manifest["functions"][name]
        lines = []
        for block in entry["inputs"]:
            if block in ("p", "w"):
                continue
            k, size = ORDER.index(block), given[block].shape[1]
            lines.append(f"    block[{k}] = copy(given_{block}, {count} * {size});")
            lines.append(f"    stride[{k}] = {size};")
        blocks = "\n".join(lines)
        text.append(RUN.format(name=name, np=len(p), count=count, blocks=blocks, number=len(ORDER)))
    calls = " | ".join(f"run_{name}()" for name in names)
    return "\n".join([*text, f"int main(void)\n{{\n    return {calls};\n}}\n"])


def _array(name: str, values: np.ndarray) -> str:
    numbers = ", ".join(x.hex() for x in values.reshape(-1).tolist()) or "0"
    return f"static const real given_{name}[] = {{{numbers}}};"
