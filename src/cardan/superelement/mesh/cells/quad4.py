"""Quadrilateral with 4 nodes: a face of a hex8.

Source: T. J. R. Hughes, The Finite Element Method, chapter 3.
"""

from .cell import Cell, gauss, products

CELL = Cell(
    kind="quad4",
    meshio="quad",
    nodes=((-1, -1), (1, -1), (1, 1), (-1, 1)),
    powers=products(2),
    linear=products(2),
    edges=(),
    faces=(),
    stiffness=gauss(2, 2),
    mass=gauss(2, 2),
    stress=gauss(2, 2),
)
