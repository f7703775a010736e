"""The rules of docs/architecture.md as data. A change here is a change of the architecture."""

from __future__ import annotations

# each room may import the rooms before it
ORDER = (
    "errors",
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
    "pipeline",
    "peers",
    "cli",
    "__init__",
    "__main__",
)

# a shipped model runs without the compiler half: these rooms know files and saved Functions only
RUNNING = frozenset({"runtime", "analyses", "view"})
RUNNING_MAY_IMPORT = RUNNING | {"errors", "ir"}

# public methods whose work lives further down: (module, function) -> module imported inside it
DOWNWARD: dict[tuple[str, str], frozenset[str]] = {
    ("cardan.codegen.languages.cython", "_arguments"): {"cardan.runtime.layout"},
    ("cardan.equations.counts", "Counts.__init__"): frozenset(
        {"cardan.codegen.owners", "cardan.passes"}
    ),
    ("cardan.equations.absolute.record", "Absolute.export"): frozenset(
        {"cardan.codegen.meshed", "cardan.runtime.absolute.planned"}
    ),
    ("cardan.equations.record", "Equations.export"): frozenset({"cardan.codegen.export"}),
    ("cardan.equations.savings", "savings"): frozenset({"cardan.passes"}),
    ("cardan.equations.readable", "Readable.symbolic"): frozenset({"cardan.passes.trig"}),
    ("cardan.model.model", "Model.graph"): frozenset({"cardan.topology.graph_view"}),
    **{
        ("cardan.runtime.analyzed", f"Analyzed.{method}"): frozenset({f"cardan.analyses.{module}"})
        for method, module in (
            ("assemble", "assemble"),
            ("sweep", "sweep"),
            ("singular_positions", "singular"),
            ("workspace", "workspace"),
            ("redundancy", "redundancy"),
            ("actuation", "actuation"),
            ("hybrid_dynamics", "actuation"),
            ("stiffness", "stiffness"),
            ("equilibrium", "equilibrium"),
            ("statics", "statics"),
            ("linearize", "linearize"),
            ("modes", "modes"),
            ("partition", "reduced"),
            ("residual", "implicit"),
            ("ensemble", "ensembles"),
        )
    },
    ("cardan.runtime.analyzed", "Analyzed._doubt"): frozenset({"cardan.analyses.redundancy"}),
    ("cardan.runtime.compiled", "CompiledModel.simulate"): frozenset({"cardan.analyses.simulate"}),
    ("cardan.runtime.compiled", "CompiledModel.step"): frozenset({"cardan.analyses.stepper"}),
    ("cardan.runtime.compiled", "CompiledModel.stepper"): frozenset({"cardan.analyses.stepper"}),
    ("cardan.runtime.compiled", "CompiledModel.report"): frozenset(
        {"cardan.analyses.precision_runs"}
    ),
    ("cardan.analyses.precision", "Precision.plot"): frozenset({"cardan.view.plot"}),
    ("cardan.runtime.compiled", "CompiledModel.resume"): frozenset({"cardan.analyses.stepper"}),
    ("cardan.analyses.mode_shapes", "Modes.plot"): frozenset({"cardan.view.plot"}),
    ("cardan.analyses.static_path", "StaticPath.plot"): frozenset({"cardan.view.plot"}),
    ("cardan.analyses.sweep", "Sweep.plot"): frozenset({"cardan.view.plot"}),
    ("cardan.analyses.workspace", "Workspace.plot"): frozenset({"cardan.view.plot"}),
    ("cardan.runtime.trajectory", "Trajectory.animate"): frozenset({"cardan.view.page"}),
    ("cardan.runtime.trajectory", "Trajectory.plot"): frozenset({"cardan.view.plot"}),
}

# the only files that load SymPy when they are imported; every one is itself imported on demand
SYMPY_AT_IMPORT: frozenset[str] = frozenset(
    {
        "cardan.ir.sympy_bridge",
        "cardan.ir.sympy_out",
        "cardan.ir.readable",
        "cardan.equations.mathml",
        "cardan.equations.named",
        "cardan.equations.mechanics",
        *(
            f"cardan.model.mechanics.{module}"
            for module in ("bound", "making", "numbers", "reference", "sources", "words")
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
    "elements.forces": frozenset({"force"}),
    "elements.sections": frozenset({"section"}),
    "elements.centerlines": frozenset({"centerline"}),
    "spatial.rotations": frozenset({"rotation"}),
    "equations.relative": frozenset({"formalism"}),
    "equations.treatments": frozenset({"treatment"}),
    "passes": frozenset(),
    "peers": frozenset(
        {
            *("peer", "coordinates", "tree", "loop", "ours", "contest", "comparison", "urdf"),
            *("processor", "cplusplus", "casadi_algorithms", "circuits"),
        }
    ),
    "codegen.languages": frozenset({"expressions"}),
    "analyses.integrators": frozenset(),
    "model.files": frozenset({"angles", "document", "expression", "meshes", "options", "pose"}),
    "cli": frozenset(
        {
            "terminal",
            "tour",
            "screen",
            "health",
            "reading",
            "running",
            "resting",
            "varying",
            "report_page",
            "sheet",
            "sheet_page",
        }
    ),
}

FILE_LINES = 400
FUNCTION_LINES = 80
