"""The functions of a model as methods; what type checkers read of them is in ``functions.pyi``."""

from __future__ import annotations

from abc import ABC

from ...schema.functions import FUNCTIONS
from .evaluation import Evaluation
from .methods import method


class Functions(Evaluation, ABC):
    """A method for every function of the table; ``...`` are leading axes that broadcast."""


for _row in FUNCTIONS.values():
    if not (_row.internal or _row.for_display):
        setattr(Functions, _row.name, method(_row))
