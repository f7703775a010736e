"""Tetrahedron with 4 nodes: constant strain.

Source: O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, 5th ed., vol. 1, chapter 6;
rule of mass: P. Keast, Comput. Methods Appl. Mech. Eng. 55 (1986).
"""

from .cell import Cell, complete, simplex

A = (5 - 5**0.5) / 20

CELL = Cell(
    kind="tet4",
    meshio="tetra",
    abaqus=("C3D4", "C3D4H"),
    nodes=((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)),
    powers=complete(3, 1),
    linear=complete(3, 1),
    edges=(),
    faces=((0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)),
    stiffness=simplex((1 / 6, (0.25, 0.25, 0.25, 0.25))),
    mass=simplex((1 / 24, (A, A, A, 1 - 3 * A))),
    stress=simplex((1 / 6, (0.25, 0.25, 0.25, 0.25))),
)
