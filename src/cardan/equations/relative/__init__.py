"""The formalisms: each derives some of M, h, tau or udot from the kinematics of a tree."""

from __future__ import annotations

from . import articulated, composite, kane, newton_euler

# name used in derive(method=...) -> module
FORMALISMS = {
    "kane": kane,
    "newton_euler": newton_euler,
    "composite": composite,
    "articulated": articulated,
}

# names of other schools, for error messages
OTHER_NAMES = {
    "aba": "articulated",
    "crba": "composite",
    "rnea": "newton_euler",
    "rne": "newton_euler",
    "featherstone": "articulated",
    "kanes_method": "kane",
}
