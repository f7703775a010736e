/* Internal states of elements in implicit steps. Part of cardan. */
#ifndef CARDAN_MESH_STATES_H
#define CARDAN_MESH_STATES_H

#include "mesh.h"

/* Which of the internal states (nz) those of an element are; NULL: all, in their order. */
typedef struct cardan_element_states {
    ptrdiff_t count;
    const ptrdiff_t *z;
} cardan_element_states;

static inline ptrdiff_t cardan_state_index(const cardan_element_states *of, ptrdiff_t i)
{
    return of->z ? of->z[i] : i;
}

static inline cardan_element_states cardan_mesh_states_of(const cardan_group *g, ptrdiff_t element)
{
    const cardan_element_states of = {g->z_states, g->z + element * g->nz};

    return of;
}

/* Numbers of `block` below for n states: two matrices, an order, two right-hand sides. */
static inline ptrdiff_t cardan_states_block(ptrdiff_t n)
{
    return n * (2 * n + 3);
}

/* How many states the element has that has most; numbers of `block` for it. */
ptrdiff_t cardan_mesh_most_states(const cardan_mesh *mesh);
ptrdiff_t cardan_mesh_states_block(const cardan_mesh *mesh);
/* Slopes (most states of an element, nz): changes of the rates zdot (nz) where the j-th state of
 * every element changes by `change` (nz). z (nz): the states of `at`, which change on the way. */
int cardan_mesh_slopes(const cardan_mesh *mesh, const cardan_state *at, const real *zdot,
                       const real *change, real *z, real *slopes, real *room);
/* (1 - c slopes / change) x = x of the states of an element, c = re + i im; y: the imaginary part of
 * x, NULL where im is 0. Where the matrix is singular x is not finite. */
void cardan_states_solve(cardan_element_states of, ptrdiff_t nz, real re, real im, const real *change,
                         const real *slopes, real *x, real *y, real *block);
/* The same element by element. */
void cardan_mesh_states_solve(const cardan_mesh *mesh, real re, real im, const real *change,
                              const real *slopes, real *x, real *y, real *block);

#endif
