"""The ways to treat constraints, by name."""

from .augmented import Augmented
from .baumgarte import Baumgarte
from .elimination import Elimination
from .multipliers import Multipliers
from .null_space import NullSpace
from .penalty import Penalty
from .perturbed import Perturbed
from .treatment import Bound, Treatment

TREATMENTS: dict[str, type[Treatment]] = {
    treatment.name: treatment
    for treatment in (
        Multipliers,
        Elimination,
        NullSpace,
        Baumgarte,
        Penalty,
        Augmented,
        Perturbed,
    )
}

__all__ = ["TREATMENTS", "Bound", "Treatment", *(t.__name__ for t in TREATMENTS.values())]
