"""Tetrahedron with 10 nodes: linear strain.

Stiffness has 4 points (exact with straight edges), mass 15 points of degree 5.
Source: O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, 5th ed., vol. 1, chapters 8 and
9; rules: P. Keast, Comput. Methods Appl. Mech. Eng. 55 (1986), and A. H. Stroud, Approximate
Calculation of Multiple Integrals, T3:5-1.
"""

from .cell import Cell, complete, simplex

A = (5 - 5**0.5) / 20
ROOT = 15**0.5
NEAR, FAR, MIDDLE = (7 - ROOT) / 34, (7 + ROOT) / 34, (10 - 2 * ROOT) / 40

CELL = Cell(
    kind="tet10",
    meshio="tetra10",
    abaqus=("C3D10", "C3D10H", "C3D10I", "C3D10M", "C3D10MH", "C3D10T"),
    nodes=(
        *((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)),
        *((0.5, 0, 0), (0.5, 0.5, 0), (0, 0.5, 0), (0, 0, 0.5), (0.5, 0, 0.5), (0, 0.5, 0.5)),
    ),
    powers=complete(3, 2),
    linear=complete(3, 1),
    edges=((0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)),
    faces=((0, 2, 1, 6, 5, 4), (0, 1, 3, 4, 8, 7), (1, 2, 3, 5, 9, 8), (0, 3, 2, 7, 9, 6)),
    stiffness=simplex((1 / 24, (A, A, A, 1 - 3 * A))),
    mass=simplex(
        (8 / 405, (0.25, 0.25, 0.25, 0.25)),
        ((2665 + 14 * ROOT) / 226800, (NEAR, NEAR, NEAR, 1 - 3 * NEAR)),
        ((2665 - 14 * ROOT) / 226800, (FAR, FAR, FAR, 1 - 3 * FAR)),
        (5 / 567, (MIDDLE, MIDDLE, 0.5 - MIDDLE, 0.5 - MIDDLE)),
    ),
    stress=simplex((1 / 24, (A, A, A, 1 - 3 * A))),
)
