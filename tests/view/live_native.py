"""The model of a live page as C: the same functions, data and kernels, built here."""

from __future__ import annotations

import ctypes
import subprocess
from pathlib import Path

import numpy as np

from cardan.codegen import header
from cardan.codegen.export import companions, model_file
from cardan.codegen.export.model_file import Content
from cardan.codegen.header import Exported
from cardan.codegen.manifest import base
from cardan.codegen.wasm import live_model
from cardan.codegen.writing import generate
from codegen.running import compilers

MAIN = """
#include <stdio.h>
#include <stdlib.h>
#include "functions.h"
int run(const double *x, double end, double rtol, double atol, int slices, double *out)
{
    cardan_simulation s = {0};
    double *state = malloc(sizeof(double) * (cardan_nq + cardan_nu + cardan_nz));
    int status = 0;
    memcpy(state, x, sizeof(double) * (cardan_nq + cardan_nu + cardan_nz));
    s.x = state;
    s.rtol = rtol, s.atol = atol;
    void *memory = malloc(cardan_simulation_size(&cardan_scene, &s));
    for (int k = 0; k < slices && status == 0; k++) {
        s.start = s.t;
        s.end = s.start + end / slices;
        status = cardan_simulate(&cardan_scene, &s, memory);
        memcpy(state, s.x_end, sizeof(double) * (cardan_nq + cardan_nu + cardan_nz));
    }
    memcpy(out, state, sizeof(double) * (cardan_nq + cardan_nu + cardan_nz));
    free(memory);
    free(state);
    return status;
}
"""


def library(equations, frames, folder: Path) -> ctypes.CDLL:
    """Build it without contraction."""
    functions = live_model.functions(equations, frames)
    manifest = base(equations).data
    described = {}
    folder.mkdir(parents=True)
    files = dict(companions.kernels((live_model.METHOD,), elements=False))
    for name, function in functions.items():
        written = generate(function, manifest.name)
        files[f"{name}.c"] = written.text
        described[name] = Exported.of(written.entry)
    content = Content(described, {}, live_model.fields(manifest))
    text = model_file.text(manifest, content, (live_model.METHOD,))
    inputs = ", ".join(map(repr, live_model.inputs(manifest)))
    start = "const double cardan_default_q"
    declared = f"static const double inputs[] = {{{inputs}}};"
    files["model.c"] = text.replace(start, f"{declared}\n{start}")
    files["model.h"] = header.slots(manifest)
    files["functions.h"] = header.prototypes(manifest.name, described, ["simulate.h"])
    files["main.c"] = MAIN
    for name, text in files.items():
        (folder / name).write_text(text, "utf-8")
    sources = sorted(str(path) for path in folder.glob("*.c"))
    command = [*next(iter(compilers().values())), "-std=c99", "-O2", "-ffp-contract=off"]
    command += ["-fno-math-errno", "-shared", "-fPIC", f"-I{folder}", "-o", str(folder / "live.so")]
    subprocess.run([*command, *sources, "-lm"], check=True)
    return ctypes.CDLL(str(folder / "live.so"))


def run(library: ctypes.CDLL, x, end: float, rtol: float, atol: float, slices: int) -> np.ndarray:
    """The state at the end of a run in slices."""
    x, out = np.ascontiguousarray(x, dtype=float), np.empty(len(x))
    pointer = ctypes.POINTER(ctypes.c_double)
    doubles = (ctypes.c_double(value) for value in (end, rtol, atol))
    status = library.run(x.ctypes.data_as(pointer), *doubles, slices, out.ctypes.data_as(pointer))
    assert status == 0
    return out
