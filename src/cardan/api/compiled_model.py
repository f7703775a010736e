"""A compiled model as users hold it: data and calls, and every analysis as a method.

What type checkers read stands in ``compiled_model.pyi``, which
``pytest tests/golden/test_verbs.py --accept`` writes.
"""

from __future__ import annotations

from typing import final

from ..runtime.loaded_model import LoadedModel
from .verb import verb


@final
class CompiledModel(LoadedModel):
    """Functions of a system as compiled C.

    All functions broadcast over leading axes like NumPy gufuncs, return fresh arrays (or fill
    ``out=``), may be called from several threads at once, and release the GIL where they work
    long. A vector may be given by names, ``{"elbow": 0.3}``; the rest then takes its default.

    Conventions: the speeds u are what robotics calls v, tau is a generalized applied force; the
    equations are M udot + h = f + tau with gravity inside h; quaternions are (w, x, y, z) and must
    have length 1; 6-vectors have the angular part first. SI units, radians.

    Raises (every function):
        ArgumentError: wrong shape. ModelError: unknown name, or a function that was not compiled.
        SolveError: a number given is not finite; or, for one state, the result is not. In a batch
            the states that fail hold NaN or infinity and a SolveWarning names the first.
    """

    # runs

    simulate = verb("cardan.analyses.simulate:simulate")
    stepper = verb("cardan.analyses.stepper:stepper")
    resume = verb("cardan.analyses.stepper:resume")
    step = verb("cardan.analyses.stepper:step")
    ensemble = verb("cardan.analyses.ensembles:ensemble")
    initial = verb("cardan.analyses.closed_start:initial")
    report = verb("cardan.analyses.report:report")

    # mechanisms

    assemble = verb("cardan.analyses.assemble:assemble")
    sweep = verb("cardan.analyses.sweep:sweep")
    singular_positions = verb("cardan.analyses.singular:singular_positions")
    workspace = verb("cardan.analyses.workspace:workspace")
    redundancy = verb("cardan.analyses.redundancy:redundancy")
    actuation = verb("cardan.analyses.actuation:actuation")
    hybrid_dynamics = verb("cardan.analyses.actuation:hybrid_dynamics")
    partition = verb("cardan.analyses.reduced:partition")
    reduced_rhs = verb("cardan.analyses.reduced:reduced_rhs")
    residual = verb("cardan.analyses.implicit:residual")

    # rest, motions that last, and what is linear about them

    equilibrium = verb("cardan.analyses.equilibrium:equilibrium")
    statics = verb("cardan.analyses.statics:statics")
    trim = verb("cardan.analyses.trim:trim")
    linearize = verb("cardan.analyses.linearize:linearize")
    modes = verb("cardan.analyses.modes:modes")
    root_locus = verb("cardan.analyses.locus:root_locus")
    campbell = verb("cardan.analyses.campbell:campbell")
    sensitivity = verb("cardan.analyses.sensitivity:sensitivity")
    stiffness = verb("cardan.analyses.stiffness:stiffness")
    beam = verb("cardan.runtime.absolute.beams:beam")

    # measured motions

    torques = verb("cardan.analyses.torques:torques")
    base_parameters = verb("cardan.analyses.identification.base:base_parameters")
    excitation = verb("cardan.analyses.identification.excitation:excitation")
    identify = verb("cardan.analyses.identification.identify:identify")

    _doubt = verb("cardan.analyses.redundancy:doubt")

    def __reduce__(self) -> tuple[object, ...]:
        from .saved_model import reduced

        return reduced(self)
