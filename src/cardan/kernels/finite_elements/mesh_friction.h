/* Friction that follows from reactions, beside a factored system of masses and constraints. Part of
 * cardan. */
#ifndef CARDAN_MESH_FRICTION_H
#define CARDAN_MESH_FRICTION_H

#include "mesh_matrix.h"

/* What its equations are made of; k: frictions of the mesh. */
typedef struct cardan_mesh_friction {
    real *certainty;   /* (k) where it is positive for all, friction is the only solution */
    real *value;       /* (k) the friction forces */
    real *coefficient; /* (k) friction per force across the line of its joint */
    real *along;       /* (k, nu) generalized force of a unit of friction */
    real *normal;      /* (k, 3, m) force across the line by multipliers */
    real *moved;       /* (k, nu + m) accelerations and multipliers by a unit of friction */
    real *start;       /* (k, 3) forces across lines without friction */
    real *share;       /* (k, k, 3) that of joint i by friction j at [j, i] */
    real *matrix, *step, *order; /* of Newton */
} cardan_mesh_friction;

/* Point into a block, NULL: only measure. Returns how many numbers that takes. */
ptrdiff_t cardan_mesh_friction_lay(const cardan_mesh *mesh, real *block, cardan_mesh_friction *to);
/* Add to accelerations and multipliers `out` (nu + m) without friction what friction does. */
int cardan_mesh_with_friction(const cardan_mesh *mesh, const cardan_state *at,
                              cardan_mesh_system *system, const cardan_mesh_friction *all, real *out);
/* Of a factored system with friction solved for at a state: what `right` of it asks for with the changes
 * of friction by multipliers in its matrix, or in its transposed. */
int cardan_mesh_friction_solve(const cardan_mesh *mesh, cardan_mesh_system *system,
                               const cardan_mesh_friction *all, int transposed);

#endif
