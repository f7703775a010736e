/* Reference length for the tolerances of a mesh, and the first step size.
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
#include "alpha.h"
#include <float.h>
#include <math.h>

/* error of the first step relative to the tolerance; probe step relative to the time scale of the
 * motion */
static const real CAREFUL = 0.1, PROBE = 1e-3;
/* spread of the nodes, relative to the size of the model, below which it counts as rounding */
static const real LEAST = 1e-9;
enum { FARTHER = 100 /* largest first step, in probe steps */ };

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
            middle[i] += at(mesh, k, q)[i] / (real)count;
}

/* Update the reference length with the present state; first: initialize it. */
void cardan_alpha_extent(const cardan_run *run, const cardan_alpha *v, int first)
{
    const cardan_mesh *mesh = v->mesh;
    real middle[3], largest = 0, moved = 0;

    if (!mesh)
        return;
    middle_of(mesh, run->y, middle);
    for (ptrdiff_t k = 0; k < mesh->nodes + mesh->flats; k++) {
        real square = 0;
        for (int i = 0; i < wide(mesh, k); i++)
            square += (at(mesh, k, run->y)[i] - middle[i]) * (at(mesh, k, run->y)[i] - middle[i]);
        largest = square > largest ? square : largest;
    }
    for (int i = 0; i < 3; i++) {
        real *before = v->now + ALPHA_MIDDLE + i;
        *before = first ? middle[i] : *before;
        moved += (middle[i] - *before) * (middle[i] - *before);
    }
    if (first) {
        const real size = run->size > 0 ? run->size : 1;
        v->now[ALPHA_EXTENT] = sqrt(largest) > LEAST * size ? 0 : size;
    }
    v->now[ALPHA_EXTENT] = fmax(v->now[ALPHA_EXTENT], sqrt(fmax(largest, moved)));
}

/* Rounding of node coordinates, relative to the reference length; large far from the origin. */
real cardan_alpha_rounding(const cardan_run *run, const cardan_alpha *v)
{
    const cardan_mesh *mesh = v->mesh;
    real far = 0;

    for (ptrdiff_t k = 0; k < mesh->nodes + mesh->flats; k++)
        for (int i = 0; i < wide(mesh, k); i++)
            far = fmax(far, fabs(at(mesh, k, run->y)[i]));
    return DBL_EPSILON * far / v->now[ALPHA_EXTENT];
}

/* Root mean square of an increment dx (nu): angles relative to 1, lengths relative to the reference
 * length, each divided by rtol + atol. */
real cardan_alpha_sparse_norm(cardan_run *run, const cardan_alpha *v, const real *dx, real rtol,
                              real atol)
{
    const cardan_mesh *mesh = v->mesh;
    const real angle = 1 / (atol + rtol), length = angle / v->now[ALPHA_EXTENT];
    real sum = 0, largest = 0;

    for (ptrdiff_t k = 0, j = 0, place = 0; place < mesh->places; place++) {
        const int pose = k < mesh->nodes && mesh->node[k] == place;
        const int flat = j < mesh->flats && mesh->flat[j] == place;
        const ptrdiff_t start = mesh->u[place], n = mesh->u[place + 1] - start;

        for (ptrdiff_t i = 0; i < n; i++) {
            const int slides = run->columns && run->columns[start + i] != 1;
            const int moves = (pose && i >= 3) || (flat && i < 2) || slides;
            const real part = dx[start + i] * (moves ? length : angle);
            sum += part * part;
            if (!(part * part <= largest)) {
                largest = part * part;
                run->culprit = mesh->q[place] + (pose ? 1 + i : i);
            }
        }
        k += pose;
        j += flat;
    }
    return sqrt(sum / (real)(v->nu > 0 ? v->nu : 1));
}

/* Choose the first step unless the caller set one (h > 0): a probe step estimates the jerk, and the
 * leading error term, constant times jerk times h^3, becomes CAREFUL times the tolerance. */
int cardan_alpha_first_step(cardan_run *run, const cardan_alpha *v, int order)
{
    const real constant = fabs(v->beta + (v->am - v->af) / 2 - 1.0 / 6);
    const real left = run->stops[run->stop_count - 1] - run->t, sign = copysign(1, left);
    const real longest = fmin(run->max_step, fabs(left));
    real fastest, probe, jerk;
    int status = 0;

    if (run->h > 0 || !v->mesh)
        return cardan_first_step(run, order);
    status = cardan_refresh(run);
    if (status != 0)
        return status;
    /* rate at which the motion evolves: from speeds and from the root of accelerations */
    fastest = fmax(cardan_alpha_sparse_norm(run, v, run->y + v->nq, 1, 0),
                   sqrt(cardan_alpha_sparse_norm(run, v, run->f + v->nq, 1, 0)));
    probe = PROBE * fmin(longest, fastest > 0 ? 1 / fastest : INFINITY);
    for (ptrdiff_t i = 0; i < run->n; i++)
        run->trial[i] = run->y[i] + sign * probe * run->f[i];
    status = cardan_derivative(run, run->t + sign * probe, run->trial, run->k);
    if (status == CARDAN_INPUT)
        return status;
    for (ptrdiff_t i = 0; i < v->nu; i++)
        v->dx[i] = (run->k[v->nq + i] - run->f[v->nq + i]) / probe;
    jerk = constant * cardan_alpha_sparse_norm(run, v, v->dx, run->rtol, run->atol);
    /* if the probe fails, start with its step size; step size control may reduce it */
    if (status == 0 && isfinite(jerk))
        probe = fmin((real)FARTHER * probe, jerk > 0 ? cbrt(CAREFUL / jerk) : INFINITY);
    run->h = sign * fmin(probe, longest);
    return 0;
}
