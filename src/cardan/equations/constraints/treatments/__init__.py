"""The ways to treat constraints, by name."""

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


def treatment(asked: str | Treatment) -> Treatment:
    """A treatment by its name, or as it is.

    Raises:
        DerivationError: there is none of that name.
    """
    if isinstance(asked, Treatment):
        return asked
    if asked in ("auto", "closed_form"):
        return Multipliers()
    if asked not in TREATMENTS:
        known = near(asked, (*TREATMENTS, "closed_form"))
        raise DerivationError(f"constraints='{asked}' is no way to treat them.{known}")
    return TREATMENTS[asked]()


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
