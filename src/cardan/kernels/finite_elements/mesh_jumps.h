/* Impulses at events of a mesh: what they are asked for, and the speeds behind them.
 *
 * Part of cardan. Caller owns all memory.
 */
#ifndef CARDAN_MESH_JUMPS_H
#define CARDAN_MESH_JUMPS_H

#include "mesh_calls.h"

/* kinds of rows; the last asks for a response, and pushes nothing */
enum { CARDAN_BILATERAL, CARDAN_UNILATERAL, CARDAN_SLOW_RELEASE, CARDAN_RESPONSE };
/* numbers of a row */
enum { CARDAN_JUMP_KIND, CARDAN_JUMP_ACTIVE, CARDAN_JUMP_MISSING, CARDAN_JUMP_RELEASE, CARDAN_JUMP_ROW };

/* What a transition works with. */
typedef struct cardan_mesh_jumps {
    real *rows;      /* (jumps, CARDAN_JUMP_ROW) */
    real *J, *X;     /* (jumps, nu) velocities, and speeds by an impulse along each */
    real *R, *left;  /* (jumps, jumps) J X, and as it is eliminated */
    real *P, *right; /* (jumps) impulses, missing speeds */
    real *behind;    /* (nu) */
    real *responses; /* of all elements that ask for some */
} cardan_mesh_jumps;

/* Point into a block, NULL: only measure. Returns how many numbers that takes. */
ptrdiff_t cardan_mesh_jumps_lay(const cardan_mesh *mesh, real *block, cardan_mesh_jumps *to);
/* Values (ne) of all events; accelerations and multipliers (nu + m) are those of the present modes, which
 * are solved for only where some value reads them in these modes: `solved`. They stand in `at` then, and the
 * factored system in `work`, unless that is the room of loops over elements too. */
int cardan_mesh_events(const cardan_mesh *mesh, cardan_state *at, real *solution, real *out, int *solved,
                       cardan_mesh_system *system, real *work, real *room);
/* All of it at a state with accelerations and multipliers, for events `e`; the block is cleared first.
 * `released`: masses and constraints without what modes hold, factored in `work` where an impulse acts. */
int cardan_mesh_jump(const cardan_mesh *mesh, const cardan_state *at, const cardan_mesh_jumps *all,
                     cardan_mesh_system *released, real *work);
/* The row of the first jump of a group. */
/* Where numbers of the elements of a group begin that stand one behind the other; `of`: the field of the
 * group with how many an element has. */
#define CARDAN_FIRST(mesh, g, of) cardan_mesh_first_number(mesh, g, offsetof(cardan_group, of))
ptrdiff_t cardan_mesh_first_number(const cardan_mesh *mesh, const cardan_group *g, size_t field);
/* Whether any impulse acts. */
int cardan_mesh_any_impulse(const cardan_mesh *mesh, const cardan_mesh_jumps *all);
/* x (jumps) with R x = right among rows that act, 0 of all that do not or follow from those that do:
 * right (jumps) is lost. */
void cardan_mesh_among_impulses(const cardan_mesh_jumps *all, ptrdiff_t n, real *right, real *x);

#endif
