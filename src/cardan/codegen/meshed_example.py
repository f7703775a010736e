"""``example.c`` and ``README.md`` of an exported model whose elements stand in tables."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from ..schema.integrators import KERNELS
from . import elements
from .companions import words

CHOICE = """\
/* What may be chosen when this is compiled: -DSTEP=1e-3, -DRHO_INF=0.9 */
#ifndef STEP
#define STEP 0.0 /* [s]; 0: steps as the tolerances ask for */
#endif
#ifndef RHO_INF
#define RHO_INF 0.8 /* what is too fast for a step keeps this part of itself; at most 0.95 */
#endif

"""
ALPHA = """\
    const real step = STEP, rho = RHO_INF;
    const real am = (2 * rho - 1) / (rho + 1), af = rho / (rho + 1);
    const real beta = (1 - am + af) * (1 - am + af) / 4, gamma = 0.5 - am + af;
    /* 2: constraints hold for positions and for speeds; 3: for positions alone. Then 0: a tangent
     * serves corrections and steps while it can; 1: a new one at every correction */
    const real options[] = {am, af, beta, gamma, 2, 0, !(step > 0)};
"""
GIVEN = """\
    run.options = options, run.on_grid = step > 0, run.h = step;
    run.rtol = step > 0 ? 0 : 1e-6, run.atol = step > 0 ? 1 : 1e-9;
"""
TOLERANCES = """\
    run.rtol = 1e-9, run.atol = 1e-12, run.h = 1e-3;
"""
STEPS = """\
    run.rtol = 0, run.atol = 1, run.on_grid = 1, run.h = 1e-3;
"""
SIMULATE = """\
/* One second of motion from x, printed at its end. */
static int simulate(const cardan_model *model, const real *x)
{{
{choice}\
    const size_t rest = cardan_nu + 6 * cardan_nparts, work = model_work_size(model);
    const wreal *w = model_w(model);
    const real end = 1.0;
    cardan_run run = {{0}};
    real *memory;
    int status;

    CARDAN_METHOD(&run, {method});
    run.nq = cardan_nq, run.nu = cardan_nu, run.nx = run.n = cardan_nq + cardan_nu;
    run.nr = cardan_nr, run.ns = cardan_ns;
    run.rhs.function = rhs, run.rhs.w = w;
    run.balance.function = balance, run.balance.w = w;
    run.move.function = move, run.move.w = w;
    run.qdot.function = qdot, run.qdot.w = w;
    run.close_position.function = cardan_npositions > 0 ? close_position : NULL;
    run.close_velocity.function = cardan_nlam > 0 ? close_velocity : NULL;
    run.close_position.w = run.close_velocity.w = w;
    run.positions = cardan_npositions, run.rates = cardan_nlam, run.size = cardan_size;
    run.columns = cardan_columns;
    run.mesh = &model->mesh;
    run.quaternions = cardan_quaternions, run.quaternion_count = cardan_nquaternions;
{settings}\
    run.max_step = INFINITY, run.budget = 1000000;
    run.stops = &end, run.stop_count = 1;
    memory = malloc(cardan_run_length(&run, rest, work) * sizeof(real));
    if (!memory)
        return 1;
    cardan_run_lay(&run, memory, rest, work);
    for (int i = 0; i < run.nx; i++)
        run.y[i] = x[i];
    for (int i = 0; i < run.nr; i++)
        run.r[i] = cardan_default_r[i];
    for (int i = 0; i < run.ns; i++)
        run.s[i] = cardan_default_s[i];
    status = cardan_run_start(&run);
    for (status = status == 0 ? CARDAN_MORE : status; status == CARDAN_MORE;)
        status = cardan_run_drive(&run);
    if (status != CARDAN_DONE)
        fprintf(stderr, "simulate: status %d at t = %g; run.h says what that is\\n", status, run.t);
    for (int i = 0; i < run.nx; i++)
        printf("x[%d] = %.17g\\n", i, run.y[i]);
    free(memory);
    return status;
}}

"""
MAIN = """\
int main(void)
{
    static cardan_model model;
    static real x[cardan_nq + cardan_nu + 1], out[energy_out_size];
    const real t = 0;
    const cardan_in in = {.t = &t, .q = x, .u = x + cardan_nq, .r = cardan_default_r,
                          .s = cardan_default_s, .w = model_w(&model)};
    int status = prepare_model(cardan_default_p, &model);
    real *work = malloc(model_work_size(&model) * sizeof(real));

    if (!work)
        return 1;
    if (status == 0)
        status = start_model(&model, t, cardan_default_r, x, work);
    if (status == 0)
        status = energy(&in, out, work);
    if (status != 0)
        fprintf(stderr, "the start: status %d; run.h says what that is\\n", status);
    for (int k = 0; k < energy_out_size; k++)
        printf("energy[%d] = %.17g\\n", k, out[k]);
    free(work);
"""


def example(integrators: Sequence[str], compile_line: str) -> str:
    """``example.c``: the energy at the start, and one second of motion if it can."""
    lines = [
        f"/* Try it:  {compile_line} */",
        '#include "functions.h"',
        "#include <math.h>",
        "#include <stdio.h>",
        "#include <stdlib.h>",
        "",
        "/* so that *.c of this folder links with a main of yours */",
        "#ifdef CARDAN_EXAMPLE",
        "",
        "",
    ]
    text = "\n".join(lines)
    method = integrators[0] if integrators else ""
    if method:
        alpha = method == "alpha"
        usual = TOLERANCES if KERNELS[method].adaptive else STEPS
        choice, settings = (ALPHA, GIVEN) if alpha else ("", usual)
        text += CHOICE if alpha else ""
        text += SIMULATE.format(method=method, choice=choice, settings=settings)
    last = "status != 0 ? status : simulate(&model, x)" if method else "status"
    return f"{text}{MAIN}    return {last};\n}}\n\n#endif\n"


def readme(manifest: dict[str, Any], names: Sequence[str], compile_line: str) -> str:
    """``README.md``: what is here, in which units, under which conventions."""
    lines = [
        f"# {words(manifest['name'])}",
        "",
        "C of a multibody model whose elements - bodies, joints, beams, forces - stand in tables,",
        "written by cardan; nothing here needs cardan or Python.",
        "",
        "| file | what it is |",
        "|---|---|",
        "| `functions.h`, `model.h` | prototypes and sizes; places of entries by name |",
        "| `elements.c`, `tables.h` | the model as a whole; its elements, and the plan of its "
        "sparse matrix |",
        "| `<kind>__<function>.c` | what an element of a kind does |",
        "| `data_<k>__<kind>.c` | numbers of its elements by the parameters |",
        "| `model.c` | values of the scene: parameters, start, inputs |",
        "| `example.c` | a call from C: `" + compile_line + "` |",
        "| `mesh*.c`, `sparse*.c`, others | loops over elements, sparse matrices, integrators: "
        "the same for every model |",
        "| `manifest.json`, `functions.json`, `mesh.npz` | all names, units, shapes, hashes and "
        "numbers, for programs |",
        "",
        "| elements | how many | functions |",
        "|---|---|---|",
    ]
    functions = {kind["name"]: kind["functions"] for kind in manifest["mesh"]["kinds"]}
    for kind, count in _counted(manifest).items():
        lines.append(f"| {words(kind)} | {count} | {words(', '.join(functions[kind]))} |")
    lines += ["", "| function | reads | gives |", "|---|---|---|"]
    for name in names:
        whole = elements.WHOLE[name]
        lines.append(f"| `{name}` | {', '.join(whole.reads)} | {words(whole.about)} |")
    for title, key in (("q", "coordinates"), ("u", "speeds"), ("r", "inputs"), ("p", "parameters")):
        rows = [f"{words(row['name'])} [{row['unit'] or '1'}]" for row in manifest[key][:MOST]]
        more = len(manifest[key]) - len(rows)
        listed = ", ".join(rows) + (f" and {more} more in `model.h`" if more > 0 else "")
        lines += ["", f"**{title}** ({key}, {len(manifest[key])}): {listed or 'none'}"]
    lines += ["", *CONVENTIONS]
    return "\n".join(lines) + "\n"


MOST = 60  # names in a list
CONVENTIONS = """\
Parameters: `prepare_model(p, &model)` finds the numbers of all elements for values of p, which may
be others than those of the scene; the lengths of beams between their nodes and which elements there
are stay as they were exported. `start_model` gives the start in `model.c`, that of cardan's
`simulate`: joints stand as they are, nodes follow them. Where other parameters, times or inputs
open loops, or move ends of beams, it returns `CARDAN_OPEN`: x is then
`model.with_parameters(...).initial()` of cardan.

Conventions: M udot + h = f + G^T lam with G udot = gamma, where the bias h holds velocity products
and gravity. A node holds q = \\[w x y z, px py pz\\], a unit quaternion and the position, and u =
\\[angular velocity in its axes, velocity in those of the ground\\]; a node of a plane holds x, y,
angle; a joint its own coordinates. 6-vectors have the angular part first; SI units, radians.

What elements do one by one, such as reactions or the stress of beams: `cardan_mesh_results` in
`mesh.h`. Other shares of stiffness, damping and mass in a sparse matrix: `cardan_mesh_values` in
`mesh_calls.h`; factors of it: `sparse.h`.

Compile only what you trust: C runs with all your rights.""".splitlines()


def _counted(manifest: dict[str, Any]) -> dict[str, int]:
    """How many elements there are of every kind."""
    counted: dict[str, int] = {}
    for group in manifest["mesh"]["groups"]:
        counted[group["kind"]] = counted.get(group["kind"], 0) + len(group["members"])
    return counted
