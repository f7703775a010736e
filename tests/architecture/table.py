"""The rules of docs/architecture.md as data. A change here is a change of the architecture."""

from __future__ import annotations

# each room may import the rooms before it
ORDER = (
    "version",
    "errors",
    "literature",
    "arrays",
    "processes",
    "regular_file",
    "whole_file",
    "arguments",
    "notebooks",
    "schema",
    "ir",
    "spatial",
    "elements",
    "model",
    "topology",
    "equations",
    "passes",
    "codegen",
    "runtime",
    "analyses",
    "view",
    "explain",
    "api",
    "pipeline",
    "peers",
    "cli",
    "__init__",
    "__main__",
)

# the rooms as they shall be, from the ground up; ratchet.json counts the imports against it
PLANNED = (
    *(
        "version",
        "errors",
        "literature",
        "arrays",
        "notebooks",
        "kernels",
        "ir",
        "passes",
        "spatial",
        "schema",
        "elements",
    ),
    *("model", "scene", "topology", "equations", "codegen", "runtime", "view", "analyses"),
    *("explain", "api", "pipeline", "peers", "cli", "__init__", "__main__"),
)

# a shipped model runs without the compiler half: these rooms know files and saved Functions only
RUNNING = frozenset({"runtime", "analyses", "view"})
RUNNING_MAY_IMPORT = RUNNING | {
    "arrays",
    "version",
    "errors",
    "processes",
    "regular_file",
    "whole_file",
    "arguments",
    "notebooks",
    "schema",
    "ir",
}

# public methods whose work lives further down: (module, function) -> module imported inside it
DOWNWARD: dict[tuple[str, str], frozenset[str]] = {
    ("cardan.equations.counts", "Counts.__init__"): frozenset(
        {"cardan.codegen.owners", "cardan.passes"}
    ),
    ("cardan.equations.absolute.record", "Absolute.export"): frozenset(
        {"cardan.codegen.meshed", "cardan.analyses.planned"}
    ),
    ("cardan.equations.explained", "Explainable.explain"): frozenset({"cardan.explain"}),
    ("cardan.equations.record", "Equations.export"): frozenset({"cardan.codegen.export"}),
    ("cardan.equations.readable", "Readable.symbolic"): frozenset({"cardan.passes.trig"}),
    ("cardan.equations.linearized.written", "Written.symbolic"): frozenset({"cardan.passes.trig"}),
    ("cardan.model.model", "Model.graph"): frozenset({"cardan.topology.graph_view"}),
    ("cardan.analyses.torques", "Torques.plot"): frozenset({"cardan.view.plot"}),
    **{
        (f"cardan.analyses.identification.{module}", f"{record}.plot"): frozenset(
            {"cardan.view.plot"}
        )
        for module, record in (("result", "Identification"), ("excitation", "Excitation"))
    },
    ("cardan.analyses.precision", "Precision.plot"): frozenset({"cardan.view.plot"}),
    ("cardan.analyses.mode_shapes", "Modes.plot"): frozenset({"cardan.view.plot"}),
    ("cardan.analyses.campbell", "Campbell.plot"): frozenset({"cardan.view.loci"}),
    ("cardan.analyses.linear_model", "LinearModel.plot"): frozenset({"cardan.view.loci"}),
    ("cardan.analyses.locus", "Locus.plot"): frozenset({"cardan.view.loci"}),
    ("cardan.analyses.static_path", "StaticPath.plot"): frozenset({"cardan.view.plot"}),
    ("cardan.analyses.sweep", "Sweep.plot"): frozenset({"cardan.view.plot"}),
    ("cardan.analyses.workspace", "Workspace.plot"): frozenset({"cardan.view.plot"}),
    ("cardan.runtime.trajectory", "Trajectory.animate"): frozenset({"cardan.view.page"}),
    ("cardan.runtime.trajectory", "Trajectory.plot"): frozenset({"cardan.view.plot"}),
    ("cardan.runtime.trajectory", "Trajectory.torques"): frozenset({"cardan.analyses.torques"}),
}

# the only files that load SymPy when they are imported; every one is itself imported on demand
SYMPY_AT_IMPORT: frozenset[str] = frozenset(
    {
        "cardan.ir.sympy_bridge",
        "cardan.ir.sympy_out",
        "cardan.ir.readable",
        "cardan.equations.mathml",
        "cardan.explain.breaking",
        "cardan.equations.named",
        "cardan.equations.mechanics",
        *(
            f"cardan.model.mechanics.{module}"
            for module in ("bound", "leaves", "making", "numbers", "reference", "sources", "words")
        ),
    }
)

# family -> files in its folder that are not members: what every member builds on
FAMILIES: dict[str, frozenset[str]] = {
    "elements.flexible": frozenset(
        {
            "carried_load",
            "element",
            "ends",
            "places",
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
    "elements.forces": frozenset({"force", "gravitation", "line"}),
    "elements.sections": frozenset({"section"}),
    "elements.centerlines": frozenset({"centerline"}),
    "spatial.rotations": frozenset({"rotation"}),
    "equations.relative": frozenset({"formalism"}),
    "equations.treatments": frozenset({"treatment"}),
    "passes": frozenset(),
    "peers": frozenset(
        {
            *("peer", "coordinates", "tree", "loop", "ours", "contest", "comparison", "urdf"),
            *("processor", "casadi_algorithms", "circuits"),
        }
    ),
    "explain.writers": frozenset(),
    "codegen.languages": frozenset({"expressions"}),
    "runtime.formats": frozenset({"contents"}),
    "schema.integrators": frozenset({"integrator", "alpha_family"}),
    "model.files": frozenset({"angles", "document", "expression", "meshes", "options", "pose"}),
    "cli": frozenset(
        {
            "terminal",
            "tour",
            "screen",
            "health",
            "formulas",
            "options",
            "report_page",
        }
    ),
}

FILE_LINES = 400
FUNCTION_LINES = 80
