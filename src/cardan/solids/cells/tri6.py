"""Triangle with 6 nodes: a face of a tet10.

Source: O. C. Zienkiewicz, R. L. Taylor, The Finite Element Method, 5th ed., vol. 1, chapters 8
and 9.
"""

from .cell import Cell, complete, simplex

ROOT = 15**0.5
NEAR, FAR = (6 - ROOT) / 21, (6 + ROOT) / 21
# degree 5 (Radon): exact for pressures on curved faces
RULE = simplex(
    (9 / 80, (1 / 3, 1 / 3, 1 / 3)),
    ((155 - ROOT) / 2400, (NEAR, NEAR, 1 - 2 * NEAR)),
    ((155 + ROOT) / 2400, (FAR, FAR, 1 - 2 * FAR)),
)

CELL = Cell(
    kind="tri6",
    meshio="triangle6",
    abaqus=("CPS6", "CPE6", "CAX6", "S6", "STRI65", "M3D6", "SFM3D6"),
    nodes=((0, 0), (1, 0), (0, 1), (0.5, 0), (0.5, 0.5), (0, 0.5)),
    powers=complete(2, 2),
    linear=complete(2, 1),
    edges=((0, 1), (1, 2), (2, 0)),
    faces=(),
    stiffness=RULE,
    mass=RULE,
    stress=RULE,
    triangles=((0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5)),
)
