"""``model_lanes.c``: what an exported model has of runs side by side."""

from __future__ import annotations

from collections.abc import Iterable

from ...schema.integrators import KERNELS
from ...schema.kernel_files import text as kernel_text
from ...schema.manifest import Manifest
from ..sources import source
from . import linkage

HEAD = """\
/*
 * model_lanes.c: rhs of the model and steps of its methods for several states side by side.
 *
 * Compile it, simd_steps.c and lane_*.c with -DCARDAN_LANES=4 (8, 2) and link them to the others:
 * simulate_lanes.h. Without lanes there is nothing in it.
 */
#include "simd_steps.h"

#if CARDAN_LANES > 1
int rhs_lanes(const cardan_in *in, real *out, real *work);
void prepare_rhs_lanes(const wreal *p, wreal *w);
#define rhs rhs_lanes
#define prepare_rhs prepare_rhs_lanes
#include "rhs.c"

"""
TAIL = """\
const cardan_lane_build cardan_scene_lanes = {
    CARDAN_LANES, (cardan_any_function)rhs_lanes, cardan_simd_try, cardan_simd_move,
    choices, sizeof choices / sizeof *choices,
};
#endif
"""


def methods(manifest: Manifest, integrators: Iterable[str]) -> list[str]:
    """Methods of an export whose runs go side by side: of systems with nothing on the way."""
    if manifest.absolute or manifest.events or manifest.multipliers:
        return []
    return [name for name in integrators if KERNELS[name].lanes]


def files(names: Iterable[str]) -> dict[str, str]:
    """The files of these methods by name."""
    listed = [*names]
    roots = ["simulate_lanes.c", "simd_steps.c", "lane_control.c"]
    roots += [f"lane_{name}.c" for name in listed]
    declared = [f"extern const cardan_lane_method cardan_{name}_lane_method;" for name in listed]
    choices = [
        f'    {{"{name}", &cardan_{name}_lane_method, {KERNELS[name].order}}},' for name in listed
    ]
    table = ["static const cardan_lane_choice choices[] = {", *choices, "};"]
    return {name: kernel_text(name) for name in linkage.closure(roots)} | {
        "model_lanes.c": HEAD + "\n".join([*declared, *table, TAIL]),
        "example_lanes.c": source("example_lanes.c"),
    }
