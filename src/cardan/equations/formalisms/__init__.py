"""The formalisms: each derives some of M, h, tau or udot from the kinematics of a tree."""

from __future__ import annotations

from .articulated import ARTICULATED
from .barycentric import BARYCENTRIC
from .composite import COMPOSITE
from .formalism import Formalism
from .gibbs_appell import GIBBS_APPELL
from .hamilton import HAMILTON
from .kane import KANE
from .lagrange import LAGRANGE
from .newton_euler import NEWTON_EULER

# name used in derive(method=...) -> formalism
FORMALISMS: dict[str, Formalism] = {
    formalism.name: formalism
    for formalism in (
        KANE,
        NEWTON_EULER,
        COMPOSITE,
        ARTICULATED,
        LAGRANGE,
        HAMILTON,
        GIBBS_APPELL,
        BARYCENTRIC,
    )
}

# names of other schools, for error messages
OTHER_NAMES = {
    "aba": "articulated",
    "crba": "composite",
    "rnea": "newton_euler",
    "rne": "newton_euler",
    "featherstone": "articulated",
    "kanes_method": "kane",
    "lagranges_method": "lagrange",
    "euler_lagrange": "lagrange",
    "lagrangian": "lagrange",
    "boltzmann_hamel": "lagrange",
    "hamiltonian": "hamilton",
    "canonical": "hamilton",
    "appell": "gibbs_appell",
    "gibbs": "gibbs_appell",
    "appellian": "gibbs_appell",
    "hooker_margulies": "barycentric",
    "wittenburg": "barycentric",
    "roberson_wittenburg": "barycentric",
    "augmented_bodies": "barycentric",
    "jourdain": "kane",
}
