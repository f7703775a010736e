"""``functions.h`` and ``elements.c``: what the elements of an exported model give together."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ..equations.absolute.record import Absolute
from . import header, tables
from .naming import comment

KERNEL = "cardan_mesh_call_"
COLUMNS = "cardan_columns[cardan_nu + (cardan_nu == 0)]"
HELD = "cardan_held[cardan_nq + cardan_nu + (cardan_nq + cardan_nu == 0)]"
QUATERNIONS = "cardan_quaternions[cardan_nquaternions + (cardan_nquaternions == 0)]"


@dataclass(frozen=True)
class Whole:
    """A function of the whole model.

    Attributes:
        name: C name.
        about: What it gives.
        reads: Blocks.
        size: How many numbers, as C says it.
        body: Lines of C; none: the kernels have it.
    """

    name: str
    about: str
    reads: tuple[str, ...]
    size: str
    body: tuple[str, ...] = ()


SOLVED = ("t", "q", "u", "s", "r")
MESH = "    const cardan_mesh *mesh = cardan_mesh_of(in);"
AT = "    const cardan_state at = cardan_state_of(in);"
WHOLE = {
    whole.name: whole
    for whole in (
        Whole("rhs", "derivative of the state: qdot, udot", SOLVED, "cardan_nq + cardan_nu"),
        Whole(
            "forward_dynamics",
            "accelerations udot, then the multipliers lam",
            (*SOLVED, "tau"),
            "cardan_nu + cardan_nlam",
            (MESH, AT, "", "    return cardan_mesh_accelerations(mesh, &at, in->tau, out, work);"),
        ),
        Whole(
            "balance",
            "M udot + h - f - G^T lam, gaps of positions, of speeds",
            ("t", "q", "u", "udot", "lam", "s", "r"),
            "cardan_nu + cardan_npositions + cardan_nlam",
        ),
        Whole(
            "mass_matrix",
            "values of [M G^T; G 0], sparse: see model_pattern",
            SOLVED,
            "cardan_nvalues",
            (
                MESH,
                AT,
                "    const real shares[3] = {0, 0, 1}; /* of K, C and M */",
                "",
                "    return cardan_mesh_values(mesh, &at, shares, out, work);",
            ),
        ),
        Whole("energy", "kinetic, potential and their sum", ("t", "q", "u", "s", "r"), "3"),
        Whole(
            "momentum",
            "angular momentum about the origin of the ground, then linear",
            ("t", "q", "u", "s", "r"),
            "6",
            (
                MESH,
                AT,
                "",
                "    return cardan_mesh_sum(mesh, &at, CARDAN_MOMENTUM, 6, out, work);",
            ),
        ),
        Whole("power", "power of every source", SOLVED, "cardan_npowers"),
        Whole(
            "outputs",
            "outputs of the scene",
            ("t", "q", "u", "udot", "lam", "s", "r"),
            "cardan_noutputs",
            (
                MESH,
                AT,
                "",
                "    for (int i = 0; i < cardan_noutputs; i++)",
                "        out[i] = 0;",
                "    return cardan_mesh_each(mesh, &at, CARDAN_OUTPUTS, take_outputs, out, work);",
            ),
        ),
        Whole("qdot", "rates of the coordinates", ("q", "u"), "cardan_nq"),
        Whole(
            "move",
            "coordinates moved by du along the speeds, then a rotation (3, 3) for every place",
            ("q", "du"),
            "cardan_nq + 9 * cardan_nplaces",
        ),
        Whole(
            "close_position",
            "coordinates a step nearer to closing all circuits, then how open they were",
            ("t", "q", "u", "r", "tau"),
            "cardan_nq + cardan_npositions",
        ),
        Whole(
            "close_velocity",
            "speeds that the constraints allow, then what the given ones missed",
            ("t", "q", "u", "r", "tau"),
            "cardan_nu + cardan_nlam",
        ),
    )
}


def prototypes(
    absolute: Absolute, manifest: Mapping[str, Any], planned: tables.Planned, names: Sequence[str]
) -> str:
    """``functions.h``.

    Args:
        absolute: The equations.
        manifest: Of the model, with the functions of its elements.
        planned: What is known of its matrices.
        names: Functions of the whole model.
    """
    counts = _counts(absolute, manifest["functions"], planned)
    blocks = [header.array(block) for block in "qurp"]
    lines = [
        "/*",
        f" * functions.h: what model '{comment(absolute.system.name)}' computes.",
        " *",
        " * A model is a table of elements with numbers that follow from the parameters. The",
        " * caller owns all memory:",
        " *",
        " *     static cardan_model model;",
        " *     int status = prepare_model(cardan_default_p, &model);",
        " *     real *work = malloc(model_work_size(&model) * sizeof(real));",
        " *     cardan_in in = {.t = &t, .q = q, .u = u, .w = model_w(&model)};",
        " *     status = energy(&in, out, work);",
        " */",
        "#ifndef CARDAN_FUNCTIONS_H",
        "#define CARDAN_FUNCTIONS_H",
        "",
        '#include "model.h"',
        '#include "mesh_calls.h"',
        "",
        "enum {",
        *(f"    cardan_{name} = {value}, /* {about} */" for name, value, about in counts[:-1]),
        *(f"    cardan_{name} = {value} /* {about} */" for name, value, about in counts[-1:]),
        "};",
        "",
        "/* model.c: values to start from, all loops closed */",
        *(f"extern const double {block};" for block in blocks),
        f"extern const double {header.array('s')};",
        "/* first entry of every unit quaternion in q */",
        f"extern const ptrdiff_t {QUATERNIONS};",
        "/* 1: entries of x = [q, u] that stay as they are where parameters move the rest */",
        f"extern const double {HELD};",
        "/* of the scene: what lengths count against [m]; what speeds count in: that, or 1 */",
        f"extern const double cardan_size, {COLUMNS};",
        "",
        "/* The elements with their numbers. It points into itself: prepare another, copy none. */",
        "typedef struct cardan_model {",
        "    cardan_mesh mesh;",
        "    cardan_group groups[cardan_ngroups + (cardan_ngroups == 0)];",
        "    real w[cardan_nw + 1]; /* prepared for the functions of elements */",
        "    real data[cardan_ndata + 1], scratch[cardan_nscratch + 1];",
        "} cardan_model;",
        "",
        "/* the numbers of all elements at parameters p (cardan_np); returns a status */",
        "CARDAN_API int prepare_model(const double *p, cardan_model *model);",
        "/* what the functions below take as `w` */",
        "CARDAN_API const wreal *model_w(const cardan_model *model);",
        "/* how many numbers of work memory each of them takes */",
        "CARDAN_API size_t model_work_size(const cardan_model *model);",
        "/* x = [q, u] where simulate() starts; at other parameters, times or inputs nodes follow",
        " * the joints of the tree. Returns a status: CARDAN_OPEN where joints or beams would have",
        " * to move too: take x = model.with_parameters(...).initial() of cardan there */",
        "CARDAN_API int start_model(const cardan_model *model, real t, const real *r, real *x,",
        "    real *work);",
        "/* the sparse matrix by rows: the column of every value (cardan_nvalues), where every row",
        " * begins (cardan_nunknowns + 1), the unknown that every multiplier is (cardan_nlam); the",
        " * first unknowns are the speeds */",
        "CARDAN_API void model_pattern(int32_t *columns, int32_t *starts, ptrdiff_t *unknowns);",
    ]
    for name in names:
        whole = WHOLE[name]
        lines += ["", f"/* {whole.about}; reads {', '.join(whole.reads)} */"]
        lines += [f"enum {{ {name}_out_size = {whole.size} }};"]
        lines += [f"CARDAN_API int {name}(const cardan_in *in, real *out, real *work);"]
    return "\n".join([*lines, "", "#endif"]) + "\n"


def _counts(
    absolute: Absolute, functions: Mapping[str, Any], planned: tables.Planned
) -> list[tuple[str, int, str]]:
    """Sizes with their meaning."""
    sizes, groups = tables.sizes(absolute), absolute.groups
    data = tables.data(absolute, functions)
    prepared = sum(form.nw * len(groups[form.group]) for form in tables.forms(absolute, functions))
    numbers = max((len(group) * (d.each + d.own) for group, d in zip(groups, data, strict=True)),
                  default=0)  # fmt: skip
    quaternions = sum(
        int((absolute.places.kind == k).sum())
        for k, kind in enumerate(absolute.places.kinds)
        if kind.quaternion is not None
    )
    return [
        ("nlam", sizes["m"], "multipliers: those of positions, then the others"),
        ("npositions", sizes["mp"], "constraints of positions"),
        ("ns", sizes["ns"], "modes"),
        ("nplaces", len(absolute.places), "places: nodes and joints"),
        ("nquaternions", quaternions, "unit quaternions"),
        ("noutputs", len(absolute.results), "outputs"),
        ("npowers", len(absolute.powers), "sources of power"),
        ("nunknowns", planned.numbers["n"], "speeds and multipliers"),
        ("nvalues", planned.numbers["values"], "numbers of the sparse matrix"),
        ("ngroups", len(groups), "groups of elements"),
        ("nw", prepared, "numbers prepared for all elements"),
        ("ndata", numbers, "numbers of the elements of a group"),
        ("nscratch", max((d.scratch for d in data), default=0), "what finding these takes"),
    ]


ELEMENTS = """\
#include "functions.h"
#include "tables.h"

/* The data (count, each + more) of the elements of a group. */
static int given(const data *d, ptrdiff_t count, const real *p, real *scratch, real *to)
{
    real *out = scratch, *w = out + d->size;
    const cardan_in in = {.w = w};
    int status = 0;

    if (d->function) {
        d->prepare(p, w);
        status = d->function(&in, out, w + d->nw);
    }
    for (ptrdiff_t e = 0; e < count; e++) {
        for (ptrdiff_t i = 0; i < d->each; i++)
            *to++ = out[(d->alike ? 0 : e * d->each) + i];
        for (ptrdiff_t i = 0; i < d->more; i++)
            *to++ = d->own[e * d->more + i];
    }
    return status;
}

int prepare_model(const double *p, cardan_model *model)
{
    const form *f = forms;
    real *w = model->w;
    int status = 0;

    model->mesh = whole;
    model->mesh.groups = model->groups;
    for (ptrdiff_t k = 0; k < cardan_ngroups && status == 0; k++) {
        cardan_group *group = &model->groups[k];
        const ptrdiff_t size = data_of[k].each + data_of[k].more;

        *group = grouped[k];
        status = given(&data_of[k], group->count, p, model->scratch, model->data);
        for (; f->group == k; f++) {
            cardan_form *own = &group->forms[f->form];

            own->one = f->function;
            own->w = w;
            own->nw = f->nw;
            own->size = f->size;
            for (ptrdiff_t e = 0; e < group->count; e++, w += f->nw)
                f->prepare(model->data + e * size, w);
        }
    }
    return status;
}

const wreal *model_w(const cardan_model *model)
{
    return (const wreal *)(const void *)&model->mesh;
}

size_t model_work_size(const cardan_model *model)
{
    return (size_t)cardan_mesh_start_work(&model->mesh);
}

int start_model(const cardan_model *model, real t, const real *r, real *x, real *work)
{
    for (int i = 0; i < cardan_nq; i++)
        x[i] = cardan_default_q[i];
    for (int i = 0; i < cardan_nu; i++)
        x[cardan_nq + i] = cardan_default_u[i];
    return cardan_mesh_start(&model->mesh, t, r, cardan_quaternions, cardan_nquaternions,
                             cardan_held, x, work);
}

void model_pattern(int32_t *columns, int32_t *starts, ptrdiff_t *unknowns)
{
    int32_t count = 0;

    for (ptrdiff_t block = 0; block < plan.blocks; block++)
        for (int32_t row = plan.first[block]; row < plan.first[block + 1]; row++) {
            starts[row] = count;
            for (int32_t k = plan.row[block]; k < plan.row[block + 1]; k++) {
                const int32_t *first = plan.first + plan.column[k];

                for (int32_t i = first[0]; i < first[1]; i++)
                    columns[count++] = i;
            }
        }
    starts[plan.n] = count;
    for (ptrdiff_t k = 0; k < cardan_nlam; k++)
        unknowns[k] = whole.unknown[k];
}
"""
OUTPUTS = """
/* Add what elements contribute to the outputs of the scene. */
static void take_outputs(const cardan_mesh *mesh, const cardan_group *g,
                         const cardan_element_lanes *some, real *out, void *to)
{
    const ptrdiff_t size = g->forms[CARDAN_OUTPUTS].size, *which = output_of[g - mesh->groups];

    for (ptrdiff_t lane = 0; lane < some->filled; lane++)
        for (ptrdiff_t i = 0; i < size; i++)
            ((real *)to)[which[some->element[lane] * size + i]] += out[i * some->lanes + lane];
}
"""


def elements(absolute: Absolute, names: Sequence[str]) -> str:
    """``elements.c``; arguments as of :func:`prototypes`."""
    parts = [
        f"/*\n * elements.c: model '{comment(absolute.system.name)}' as a whole.\n */\n{ELEMENTS}"
    ]
    for name in names:
        body = WHOLE[name].body or (f"    return {KERNEL}{name}(in, out, work);",)
        signature = f"int {name}(const cardan_in *in, real *out, real *work)"
        parts += [OUTPUTS] if name == "outputs" else []
        parts.append("\n" + "\n".join([signature, "{", *body, "}"]) + "\n")
    return "".join(parts)
