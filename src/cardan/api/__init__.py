"""Classes that users hold: records with verbs."""

from .faces import FACES

FACES |= {
    "cardan.superelements.record:SuperelementRecord": "cardan.api.components:Superelement",
    "cardan.superelements.readers.matrix_files:ComponentMatricesRecord": (
        "cardan.api.components:ComponentMatrices"
    ),
    "cardan.runtime.models.finite_elements.superelements:DeformedSuperelementRecord": (
        "cardan.api.components:DeformedSuperelement"
    ),
    "cardan.scene.scene:SceneRecord": "cardan.api.scene:Scene",
    "cardan.equations.record:EquationRecord": "cardan.api.equations:Equations",
    "cardan.equations.finite_elements.record:FiniteElementRecord": (
        "cardan.api.equations:FiniteElementEquations"
    ),
    "cardan.runtime.trajectory.trajectory:TrajectoryRecord": "cardan.api.trajectory:Trajectory",
    **{
        f"cardan.analyses.{module}:{name}Record": f"cardan.api.results:{name}"
        for module, name in (
            ("continuation.record", "Continuation"),
            ("cycles.cycle_record", "Cycle"),
            ("ensembles.result", "Ensemble"),
            ("fits.record", "Fit"),
            ("identification.excitation", "Excitation"),
            ("identification.result", "Identification"),
            ("identification.torques", "Torques"),
            ("linear.campbell", "Campbell"),
            ("linear.linear_model", "LinearModel"),
            ("linear.mode_shapes", "Modes"),
            ("linear.root_locus", "Locus"),
            ("linear.steady_motion", "SteadyMotion"),
            ("mechanisms.assembly", "Assembly"),
            ("mechanisms.sweep", "Sweep"),
            ("mechanisms.workspace", "Workspace"),
            ("simulation.precision.work_precision", "Precision"),
            ("statics.equilibrium", "Equilibrium"),
            ("statics.static_path", "StaticPath"),
        )
    },
}
