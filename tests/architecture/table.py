"""The rules of docs/architecture.md as data. A change here is a change of the architecture."""

from __future__ import annotations

# from the ground up: a room imports the rooms before it, in whatever way
ORDER = (
    *(
        "version",
        "errors",
        "records",
        "literature",
        "arrays",
        "processes",
        "regular_file",
        "atomic_file",
    ),
    *(
        "number_file",
        "build_progress",
        "arguments",
        "notebooks",
        "kernels",
        "ir",
        "passes",
        "spatial",
        "schema",
        "elements",
        "superelements",
    ),
    *(
        "scene",
        "topology",
        "equations",
        "codegen",
        "runtime",
        "view",
        "analyses",
        "solids",
        "explain",
    ),
    *("api", "pipeline", "compilation", "parts", "live", "peers", "cli", "__init__", "__main__"),
)

# a shipped model runs without the compiler half: these rooms know files and saved Functions only
RUNNING = frozenset({"runtime", "analyses", "view", "superelements"})
RUNNING_MAY_IMPORT = RUNNING | {
    "arrays",
    "version",
    "errors",
    "records",
    "processes",
    "regular_file",
    "atomic_file",
    "number_file",
    "build_progress",
    "arguments",
    "notebooks",
    "schema",
    "ir",
}

# adapters of other programs see what users see, and the parts that api/comparison.py names
PEERS_MAY_IMPORT = frozenset(
    {"api", "pipeline", "compilation", "peers", "arrays", "errors", "records"}
)

# the only files that load SymPy when they are imported; every one is itself imported on demand
SYMPY_AT_IMPORT: frozenset[str] = frozenset(
    {
        "cardan.ir.forms.sympy_bridge",
        "cardan.ir.forms.sympy_out",
        "cardan.ir.forms.readable",
        "cardan.equations.reading.energy_expressions",
        "cardan.equations.reading.mathml",
        "cardan.explain.breaking",
        "cardan.equations.reading.named",
        "cardan.equations.reading.mechanics",
        *(
            f"cardan.scene.sympy_import.{module}"
            for module in (
                "constraints",
                "leaves",
                "construction",
                "numbers",
                "reference",
                "sources",
                "names",
            )
        ),
    }
)

# family -> files in its folder that are not members: what every member builds on
FAMILIES: dict[str, frozenset[str]] = {
    "elements.flexible": frozenset(
        {
            "equilibrium_load",
            "element",
            "element_ends",
            "formulas",
            "node_set",
            "plane",
            "relative",
            "section",
            "strain",
            "stress_field",
            "inertia",
            "loading",
        }
    ),
    "elements.joints": frozenset({"joint", "hinge", "guided", "rolling"}),
    "elements.forces": frozenset({"bushing_laws", "force", "line", "relative_springs"}),
    "elements.forces.gravity": frozenset({"gravitation", "fields"}),
    "superelements.methods": frozenset({"method", "free_interface"}),
    "superelements.readers": frozenset({"matrix_files", "records", "labeled"}),
    "elements.sections": frozenset({"section"}),
    "elements.centerlines": frozenset({"centerline"}),
    "spatial.rotations": frozenset({"rotation"}),
    "solids.cells": frozenset({"cell"}),
    "equations.formalisms": frozenset({"formalism"}),
    "equations.constraints.treatments": frozenset({"treatment"}),
    "passes": frozenset(),
    "peers": frozenset(
        {
            *("peer", "coordinates", "tree", "loop", "ours", "contest", "comparison", "urdf"),
            *("processor", "casadi_algorithms", "circuits"),
        }
    ),
    "explain.writers": frozenset(),
    "codegen.languages": frozenset({"binding", "expressions"}),
    "runtime.formats": frozenset({"contents"}),
    "view.motion_files": frozenset({"motion_format"}),
    "schema.integrators": frozenset({"integrator", "alpha_family"}),
    "scene.files": frozenset(
        {"angles", "document", "expression", "meshes", "options", "pose", "robot", "unread"}
    ),
    "cli": frozenset(
        {"terminal", "tour", "screen", "health", "formulas", "options", "report_page"}
    ),
}

FILE_LINES = 400
FUNCTION_LINES = 80
