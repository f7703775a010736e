/*
 * solids.h: matrices of a solid of linear elastic finite elements, small displacements.
 *
 * A call treats cells of one kind and one material. Shape functions and their slopes come as tables
 * at the points of a quadrature rule, so that a new kind of cell needs no C. Unknowns are the three
 * displacements of each node. Stresses and strains have the order xx, yy, zz, yz, zx, xy, with
 * engineering shear strains.
 *
 * Matrices are added to compressed rows of nodes: row a holds the nodes that share a cell with a,
 * ascending. Caller owns all memory; nothing is allocated here.
 * Source: T. J. R. Hughes, The Finite Element Method, chapters 2 and 3; K.-J. Bathe, Finite Element
 * Procedures, 2nd ed., sections 5.3 and 6.2; O. C. Zienkiewicz, R. L. Taylor, The Finite Element
 * Method, 5th ed., vol. 1, chapters 8 and 14.
 */
#ifndef CARDAN_SOLIDS_H
#define CARDAN_SOLIDS_H

#include "cardan.h"
#include <stddef.h>

/* what the functions return, besides 0 */
enum { CARDAN_SOLID_FOLDED = 1, CARDAN_SOLID_PATTERN = 2 };

/* Cells of one kind and material, with a rule of quadrature. */
typedef struct cardan_solid {
    ptrdiff_t cells;
    ptrdiff_t nodes;  /* of a cell */
    ptrdiff_t points; /* of the rule */
    const int32_t *cell;      /* cells x nodes: nodes of the mesh */
    const double *position;   /* nodes of the mesh x 3 [m] */
    const double *weight;     /* points */
    const double *shape;      /* points x nodes: values of the shape functions */
    const double *slope;      /* points x nodes x 3: their slopes in the reference cell */
    const double *elasticity; /* 6 x 6 [Pa], symmetric */
    double density;           /* [kg/m^3] */
    /* compressed rows */
    const int32_t *first;  /* rows + 1: where the list of a row begins in `column` */
    const int32_t *column; /* nodes of the mesh */
    /* work memory */
    double *gradient; /* nodes x 3: gradients of the shape functions at a point [1/m] */
    double *product;  /* nodes x 18: elasticity times strain of a unit displacement */
    double *block;    /* nodes x nodes x 9: matrix of a cell */
    ptrdiff_t culprit; /* result: the cell that is to blame for an answer other than 0 */
} cardan_solid;

/* Stiffness, added to `values`: 9 numbers for each entry of `column`. */
int cardan_solid_stiffness(cardan_solid *solid, double *values);

/* Mass, added to `values`: 1 number for each entry of `column`, equal in all directions.
 *
 * lumped  1: only on the diagonal, in proportion to that of the consistent matrix
 * Source of lumping: E. Hinton, T. Rock, O. C. Zienkiewicz, Earthq. Eng. Struct. Dyn. 4 (1976).
 */
int cardan_solid_mass(cardan_solid *solid, double *values, int lumped);

/* Geometric stiffness of stresses (cells x points x 6), added to `values` as mass is. */
int cardan_solid_geometric(cardan_solid *solid, const double *stress, double *values);

/* Stresses (cells x points x 6) of displacements (nodes of the mesh x 3). */
int cardan_solid_stress(cardan_solid *solid, const double *displacement, double *stress);

/* Nodal forces (nodes of the mesh x 3) in balance with stresses (cells x points x 6), added. */
int cardan_solid_force(cardan_solid *solid, const double *stress, double *force);

/* Stresses at nodes by displacements, added to `values`: 6 x 3 numbers for each entry of `column`.
 *
 * extrapolation  nodes x points: from the points of the rule to the nodes of the cell
 * row            nodes of the mesh: row of a node in `first`, -1 for a node without one
 * share          nodes of the mesh: weight of each cell at a node
 */
int cardan_solid_recovery(cardan_solid *solid, const double *extrapolation, const int32_t *row,
                          const double *share, double *values);

#endif
