/* Matrices of a mesh in the places of a sparse plan, and systems with them. Part of cardan. */
#ifndef CARDAN_MESH_MATRIX_H
#define CARDAN_MESH_MATRIX_H

#include "mesh.h"

/* What a matrix is made of. */
typedef struct cardan_assembly {
    real shares[3];     /* of K, C and M */
    real lever;         /* of R in rows that bind speeds */
    int stabilized;     /* 1: rows of positions bind speeds too */
    const real *tangent_maps; /* (places, 9), NULL: increments are small */
    int released;       /* 1: modes hold nothing */
} cardan_assembly;

/* A matrix with its factors, and room for what is solved with it. */
typedef struct cardan_mesh_system {
    real *a; /* as the plan has it */
    cardan_sparse_factors factors;
    real *rows, *units;   /* (n) what equations are multiplied with, what unknowns are counted in */
    real *right, *solution;  /* (n) */
    const real *open;     /* (mp) gaps of positions that hide redundant rows; NULL: there are none */
    real sine;            /* of the angle that redundant rows may have because of them */
    real unfit;           /* what rows of constraints leave where some are redundant, of the motion */
    int unsettled;        /* 1: not because they contradict each other, but corrections were too few */
    real *work;           /* of refinement (3 n); of loops over elements */
} cardan_mesh_system;

/* Point into a block, NULL: only measure. Returns how many numbers that takes. */
ptrdiff_t cardan_mesh_lay(const cardan_mesh *mesh, real *block, cardan_mesh_system *system);
int cardan_mesh_matrix(const cardan_mesh *mesh, const cardan_state *at,
                       const cardan_assembly *parts, const cardan_mesh_system *system);
/* Three matrices (plan->values) of which a step of an implicit method is made with c in proportion to
 * it: powers[0] + c powers[1] + c^2 powers[2] = [M + c C + c^2 K, Gᵀ; G + c R, H]. */
int cardan_mesh_powers(const cardan_mesh *mesh, const cardan_state *at, real *const *powers,
                       real *room);
/* Assemble and factor. Returns the status of an element, or CARDAN_UNSOLVED; `assembled` says which
 * came first. */
int cardan_mesh_factor(const cardan_mesh *mesh, const cardan_state *at,
                       const cardan_assembly *parts, cardan_mesh_system *system, int *assembled);
int cardan_mesh_refactor(const cardan_mesh *mesh, cardan_mesh_system *system);
/* mesh_open.c */
real cardan_mesh_sine(const cardan_mesh *mesh, const cardan_mesh_system *system, const real *open);
/* Of a factored matrix of masses and constraints: CARDAN_SINGULAR where a motion is left to which
 * nothing has mass or inertia, else 0. */
int cardan_mesh_massless(const cardan_mesh *mesh, const cardan_mesh_system *system);
/* found = a^-1 right, CARDAN_UNSOLVED where it leaves more of that than rounding does. Redundant rows
 * may ask for something else: how much of the motion that is stands in `unfit`; what may be, the
 * caller knows. Corrections of gaps are judged by the gaps they leave: those of a step that
 * is taken close (cardan_gaps_close), and so do positions that are closed. */
int cardan_mesh_solve(const cardan_mesh *mesh, cardan_mesh_system *system);

#endif
