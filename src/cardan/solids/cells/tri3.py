"""Triangle with 3 nodes: a face of a tet4.

Source: O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, 5th ed., vol. 1, chapters 8
and 9.
"""

from .cell import Cell, complete, simplex

RULE = simplex((1 / 6, (1 / 6, 1 / 6, 2 / 3)))

CELL = Cell(
    kind="tri3",
    meshio="triangle",
    abaqus=("CPS3", "CPE3", "CAX3", "S3", "S3R", "STRI3", "M3D3", "R3D3", "SFM3D3"),
    nodes=((0, 0), (1, 0), (0, 1)),
    powers=complete(2, 1),
    linear=complete(2, 1),
    edges=(),
    faces=(),
    stiffness=RULE,
    mass=RULE,
    stress=RULE,
    triangles=((0, 1, 2),),
)
