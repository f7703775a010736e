/* Internal states of elements in implicit steps. Part of cardan. */
#ifndef CARDAN_MESH_STATES_H
#define CARDAN_MESH_STATES_H

#include "mesh.h"

/* How many states the element has that has most; numbers of `block` below. */
ptrdiff_t cardan_mesh_most_states(const cardan_mesh *mesh);
ptrdiff_t cardan_mesh_states_block(const cardan_mesh *mesh);
/* Slopes (most states of an element, nz): changes of the rates zdot (nz) where the j-th state of
 * every element changes by `change` (nz). z (nz): the states of `at`, which change on the way. */
int cardan_mesh_slopes(const cardan_mesh *mesh, const cardan_state *at, const real *zdot,
                       const real *change, real *z, real *slopes, real *room);
/* (1 - c slopes / change) x = x, c = re + i im, element by element; y: the imaginary part of x,
 * NULL where im is 0. */
void cardan_mesh_states_solve(const cardan_mesh *mesh, real re, real im, const real *change,
                              const real *slopes, real *x, real *y, real *block);

#endif
