/* Reference length for the tolerances of a mesh.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Node coordinates say where nodes are, not how far they move. A tolerance relative to each
 * coordinate would be loose far from the origin and tight near it, and would compare meters with
 * quaternion entries. So every length is measured against one reference length: the largest
 * distance of a node from the centroid, or the motion of the centroid if that is larger. If all
 * nodes start at one point, it is the size of the model. Angles are measured against 1. The result
 * depends neither on the position of the origin nor on the unit of length.
 * Source: M. Géradin, A. Cardona, Flexible Multibody Dynamics (2001), chapter 11 (step size
 * control).
 */
#include "mesh_extent.h"
#include <float.h>
#include <math.h>

/* spread of the nodes, relative to the size of the model, below which it counts as rounding */
static const real LEAST = 1e-9;

/* Position of node k (planar nodes follow the spatial ones); `wide` is its number of components. */
static const real *at(const cardan_mesh *mesh, ptrdiff_t k, const real *q)
{
    if (k < mesh->nodes)
        return q + mesh->q[mesh->node[k]] + 4;
    return q + mesh->q[mesh->flat[k - mesh->nodes]];
}

static int wide(const cardan_mesh *mesh, ptrdiff_t k)
{
    return k < mesh->nodes ? 3 : 2;
}

/* Centroid (3) of all nodes. */
static void middle_of(const cardan_mesh *mesh, const real *q, real *middle)
{
    const ptrdiff_t count = mesh->nodes + mesh->flats;

    for (int i = 0; i < 3; i++)
        middle[i] = 0;
    for (ptrdiff_t k = 0; k < count; k++)
        for (int i = 0; i < wide(mesh, k); i++)
            middle[i] += at(mesh, k, q)[i];
    for (int i = 0; i < 3; i++)
        middle[i] /= (real)count;
}

void cardan_mesh_extent(const cardan_run *run, const cardan_mesh *mesh, real *extent, int first)
{
    real middle[3], largest = 0, moved = 0;

    middle_of(mesh, run->y, middle);
    for (ptrdiff_t k = 0; k < mesh->nodes + mesh->flats; k++) {
        real square = 0;
        for (int i = 0; i < wide(mesh, k); i++)
            square += (at(mesh, k, run->y)[i] - middle[i]) * (at(mesh, k, run->y)[i] - middle[i]);
        largest = square > largest ? square : largest;
    }
    for (int i = 0; i < 3; i++) {
        real *before = extent + 1 + i;
        *before = first ? middle[i] : *before;
        moved += (middle[i] - *before) * (middle[i] - *before);
    }
    if (first) {
        const real size = run->size > 0 ? run->size : 1;
        extent[0] = sqrt(largest) > LEAST * size ? 0 : size;
    }
    extent[0] = fmax(extent[0], sqrt(fmax(largest, moved)));
}

real cardan_mesh_rounding(const cardan_run *run, const cardan_mesh *mesh, const real *extent)
{
    real far = 0;

    for (ptrdiff_t k = 0; k < mesh->nodes + mesh->flats; k++)
        for (int i = 0; i < wide(mesh, k); i++)
            far = cardan_most(far, fabs(at(mesh, k, run->y)[i]));
    return DBL_EPSILON * far / extent[0];
}

real cardan_mesh_squares(cardan_run *run, const cardan_mesh *mesh, const real *extent,
                         const real *dx, real *largest)
{
    const real length = 1 / extent[0];
    real sum = 0;

    for (ptrdiff_t k = 0, j = 0, place = 0; place < mesh->places; place++) {
        const int pose = k < mesh->nodes && mesh->node[k] == place;
        const int flat = j < mesh->flats && mesh->flat[j] == place;
        const ptrdiff_t start = mesh->u[place], n = mesh->u[place + 1] - start;

        for (ptrdiff_t i = 0; i < n; i++) {
            const int slides = run->columns && run->columns[start + i] != 1;
            const int moves = (pose && i >= 3) || (flat && i < 2) || slides;
            const real part = dx[start + i] * (moves ? length : 1);
            sum += part * part;
            if (cardan_exceeds(part * part, *largest)) {
                *largest = part * part;
                run->culprit = mesh->q[place] + (pose ? 1 + i : i);
            }
        }
        k += pose;
        j += flat;
    }
    return sum;
}
