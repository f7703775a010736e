"""Expressions: graphs of scalars, their values, derivatives and saved forms. No mechanics here.

The names below are what a program that loads a saved Function needs; the rooms of the compiler
import from the modules. Nothing here loads SymPy, NumPy or mpmath before it is asked to.
"""

from .arithmetic import Scalar
from .derivative import forward, gradient, jacobian
from .function import Block, Function, Output, Staged
from .graph import Graph
from .interpreter import evaluate
from .matrix import Matrix
from .serialize import from_dict, to_dict
from .table import Table

__all__ = [
    "Block",
    "Function",
    "Graph",
    "Matrix",
    "Output",
    "Scalar",
    "Staged",
    "Table",
    "evaluate",
    "forward",
    "from_dict",
    "gradient",
    "jacobian",
    "to_dict",
]
