"""Ways to treat constraints: ``cd.derive(scene, constraints=cd.constraints.Penalty(1e9))``."""

from ....errors import DerivationError, near
from .augmented import Augmented
from .baumgarte import Baumgarte
from .elimination import Elimination
from .multipliers import Multipliers
from .null_space import NullSpace
from .penalty import Penalty
from .perturbed import Perturbed
from .treatment import Bound, Labels, Treatment

TREATMENTS: dict[str, type[Treatment]] = {
    treatment.name: treatment
    for treatment in (Multipliers, Elimination, NullSpace, Baumgarte, Penalty, Augmented, Perturbed)
}


def treatment(requested: str | Treatment) -> Treatment:
    """A treatment by its name, or as it is.

    Raises:
        DerivationError: there is none of that name.
    """
    if isinstance(requested, Treatment):
        return requested
    if requested in ("auto", "closed_form"):
        return Multipliers()
    if requested not in TREATMENTS:
        hint = near(requested, (*TREATMENTS, "closed_form"))
        raise DerivationError(f"constraints='{requested}' is not a way to treat them.{hint}")
    return TREATMENTS[requested]()


__all__ = [
    "TREATMENTS",
    "Augmented",
    "Baumgarte",
    "Bound",
    "Elimination",
    "Labels",
    "Multipliers",
    "NullSpace",
    "Penalty",
    "Perturbed",
    "Treatment",
    "treatment",
]
