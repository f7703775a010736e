"""A compiled model as users hold it: data and calls, and every analysis as a method.

What type checkers read stands in ``compiled_model.pyi``, which
``pytest tests/golden/test_verbs.py --accept`` writes.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, final

from ..runtime.models.loaded_model import LoadedModel
from ..schema.wasm_kernels import WasmFunction
from .faces import verb

if TYPE_CHECKING:
    from ..ir.function import Function


def _as_webassembly(function: Function) -> WasmFunction:
    """What runs where there is no C compiler."""
    from ..codegen.wasm.function import translated

    return translated(function)


@final
class CompiledModel(LoadedModel):
    """Functions of a system as compiled C.

    All functions broadcast over leading axes like NumPy gufuncs, return fresh arrays (or fill
    ``out=``), may be called from several threads at once, and release the GIL where they work
    long. A vector may be given by names, ``{"elbow": 0.3}``; the rest then takes its default.

    Conventions: the speeds u are what robotics calls v, tau is a generalized applied force; the
    equations are M udot + h = f + tau with gravity inside h; quaternions are (w, x, y, z) and must
    have length 1; 6-vectors have the angular part first. SI units, radians.

    Raises:
        ArgumentError: wrong shape.
        ModelError: unknown name, or a function that was not compiled.
        SolveError: a number given is not finite; or, for one state, the result is not. In a batch
            the states that fail hold NaN or infinity and a SolveWarning names the first.
    """

    _translate = staticmethod(_as_webassembly)

    # runs

    simulate = verb("cardan.analyses.simulation.simulate:simulate")
    stepper = verb("cardan.analyses.simulation.stepper:stepper")
    resume = verb("cardan.analyses.simulation.stepper:resume")
    step = verb("cardan.analyses.simulation.stepper:step")
    ensemble = verb("cardan.analyses.ensembles:ensemble")
    initial = verb("cardan.analyses.simulation.starts.start:initial")
    report = verb("cardan.analyses.simulation.precision.report:report")

    # mechanisms

    assemble = verb("cardan.analyses.mechanisms.kinematics:assemble")
    sweep = verb("cardan.analyses.mechanisms.kinematics:sweep")
    singular_positions = verb("cardan.analyses.mechanisms.singular_positions:singular_positions")
    workspace = verb("cardan.analyses.mechanisms.workspace:workspace")
    redundancy = verb("cardan.analyses.mechanisms.redundancy:redundancy")
    actuation = verb("cardan.analyses.mechanisms.actuation:actuation")
    hybrid_dynamics = verb("cardan.analyses.mechanisms.actuation:hybrid_dynamics")
    partition = verb("cardan.analyses.mechanisms.minimal_coordinates:partition")
    screw_axis = verb("cardan.analyses.mechanisms.screw_axis:screw_axis")
    reduced_rhs = verb("cardan.analyses.mechanisms.minimal_coordinates:reduced_rhs")
    residual = verb("cardan.analyses.simulation.residual:residual")

    # rest, motions that last, and what is linear about them

    equilibrium = verb("cardan.analyses.statics.equilibrium:equilibrium")
    statics = verb("cardan.analyses.statics.statics:statics")
    continuation = verb("cardan.analyses.continuation.continuation:continuation")
    stability_chart = verb("cardan.analyses.continuation.stability_chart:stability_chart")
    fit = verb("cardan.analyses.fits.fit:fit")
    gradient = verb("cardan.analyses.gradients.gradient:gradient")
    cycle = verb("cardan.analyses.cycles.cycle:cycle")
    trim = verb("cardan.analyses.linear.trim:trim")
    linearize = verb("cardan.analyses.linear.linearize:linearize")
    modes = verb("cardan.analyses.linear.modes:modes")
    root_locus = verb("cardan.analyses.linear.root_locus:root_locus")
    campbell = verb("cardan.analyses.linear.campbell:campbell")
    sensitivity = verb("cardan.analyses.linear.sensitivity:sensitivity")
    stiffness = verb("cardan.analyses.simulation.precision.stiffness:stiffness")
    beam = verb("cardan.runtime.models.finite_elements.beams:beam")
    superelement = verb("cardan.runtime.models.finite_elements.superelements:superelement")
    superelement_parts = verb(
        "cardan.runtime.models.finite_elements.superelement_parts:superelement_parts"
    )
    cable = verb("cardan.runtime.trajectory.cables:cable")

    # measured motions

    torques = verb("cardan.analyses.identification.torques:torques")
    base_parameters = verb("cardan.analyses.identification.base_parameters:base_parameters")
    excitation = verb("cardan.analyses.identification.excitation:excitation")
    identify = verb("cardan.analyses.identification.identify:identify")

    # programs that differentiate

    to_jax = verb("cardan.analyses.autodiff.jax_function:to_jax")
    to_torch = verb("cardan.analyses.autodiff.torch_function:to_torch")

    # builds

    verify = verb("cardan.runtime.verification.verify:verify_model")
    _verify_built = verb("cardan.runtime.verification.verify:verify_built")
    _verify_elements = verb("cardan.runtime.verification.verify:verify_elements")

    _undetermined = verb("cardan.analyses.mechanisms.undetermined_reactions:undetermined_reaction")

    def __reduce__(self) -> tuple[object, ...]:
        from .saved_model import reduced

        return reduced(self)
