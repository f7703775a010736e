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
    "scene",
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
    *("scene", "topology", "equations", "codegen", "runtime", "view", "analyses"),
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
    ("cardan.equations.reading.counts", "Counts.__init__"): frozenset(
        {"cardan.codegen.program.owners", "cardan.passes"}
    ),
    ("cardan.equations.finite_elements.record", "Absolute.export"): frozenset(
        {"cardan.codegen.export.finite_elements", "cardan.analyses.simulation.export_plan"}
    ),
    ("cardan.equations.reading.explained", "Explainable.explain"): frozenset({"cardan.explain"}),
    ("cardan.equations.record", "Equations.export"): frozenset({"cardan.codegen.export.export"}),
    ("cardan.equations.reading.readable", "Readable.symbolic"): frozenset({"cardan.passes.trig"}),
    ("cardan.equations.linearized.matrices", "Written.symbolic"): frozenset({"cardan.passes.trig"}),
    ("cardan.scene.scene", "Model.graph"): frozenset({"cardan.topology.drawing.graph_view"}),
    ("cardan.analyses.identification.torques", "Torques.plot"): frozenset({"cardan.view.plot"}),
    **{
        (f"cardan.analyses.identification.{module}", f"{record}.plot"): frozenset(
            {"cardan.view.plot"}
        )
        for module, record in (("result", "Identification"), ("excitation", "Excitation"))
    },
    ("cardan.analyses.simulation.precision.work_precision", "Precision.plot"): frozenset(
        {"cardan.view.plot"}
    ),
    ("cardan.analyses.linear.mode_shapes", "Modes.plot"): frozenset({"cardan.view.plot"}),
    ("cardan.analyses.linear.campbell", "Campbell.plot"): frozenset({"cardan.view.loci"}),
    ("cardan.analyses.linear.linear_model", "LinearModel.plot"): frozenset({"cardan.view.loci"}),
    ("cardan.analyses.linear.root_locus", "Locus.plot"): frozenset({"cardan.view.loci"}),
    ("cardan.analyses.statics.static_path", "StaticPath.plot"): frozenset({"cardan.view.plot"}),
    ("cardan.analyses.mechanisms.sweep", "Sweep.plot"): frozenset({"cardan.view.plot"}),
    ("cardan.analyses.mechanisms.workspace", "Workspace.plot"): frozenset({"cardan.view.plot"}),
    ("cardan.runtime.trajectory.trajectory", "Trajectory.animate"): frozenset({"cardan.view.page"}),
    ("cardan.runtime.trajectory.trajectory", "Trajectory.plot"): frozenset({"cardan.view.plot"}),
    ("cardan.runtime.trajectory.trajectory", "Trajectory.torques"): frozenset(
        {"cardan.analyses.identification.torques"}
    ),
}

# the only files that load SymPy when they are imported; every one is itself imported on demand
SYMPY_AT_IMPORT: frozenset[str] = frozenset(
    {
        "cardan.ir.forms.sympy_bridge",
        "cardan.ir.forms.sympy_out",
        "cardan.ir.forms.readable",
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
            "carried_load",
            "element",
            "element_ends",
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
    "elements.forces": frozenset({"force", "gravitation", "line"}),
    "elements.sections": frozenset({"section"}),
    "elements.centerlines": frozenset({"centerline"}),
    "spatial.rotations": frozenset({"rotation"}),
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
    "codegen.languages": frozenset({"expressions"}),
    "runtime.formats": frozenset({"contents", "number_file"}),
    "schema.integrators": frozenset({"integrator", "alpha_family"}),
    "scene.files": frozenset({"angles", "document", "expression", "meshes", "options", "pose"}),
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
