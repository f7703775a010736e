/* Reference length for the tolerances of a mesh. Part of cardan. */
#ifndef CARDAN_MESH_EXTENT_H
#define CARDAN_MESH_EXTENT_H

#include "mesh.h"

/* numbers of `extent`: the reference length, the centroid of the nodes at the start */
enum { CARDAN_EXTENT = 4 };

/* Update it with the present state; first: initialize it. */
void cardan_mesh_extent(const cardan_run *run, const cardan_mesh *mesh, real *extent, int first);
/* Rounding of node coordinates, relative to the reference length; large far from the origin. */
real cardan_mesh_rounding(const cardan_run *run, const cardan_mesh *mesh, const real *extent);
/* Sum of the squares of increments or speeds dx (nu): of angles relative to 1, of lengths relative
 * to the reference length. Where one is above `largest`, that becomes its square, and the entry
 * of the state that it changes the culprit. */
real cardan_mesh_squares(cardan_run *run, const cardan_mesh *mesh, const real *extent,
                         const real *dx, real *largest);

#endif
