/* Reference length for tolerances, and the first step size, over elements.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "alpha.h"
#include "mesh_extent.h"
#include <math.h>

/* error of the first step relative to the tolerance; probe step relative to the time scale of the
 * motion */
static const real CAREFUL = 0.1, PROBE = 1e-3;
enum { FARTHER = 100 /* largest first step, in probe steps */ };

/* Update the reference length with the present state; first: initialize it. */
void cardan_alpha_extent(const cardan_run *run, const cardan_alpha *v, int first)
{
    if (v->mesh)
        cardan_mesh_extent(run, v->mesh, v->now + ALPHA_EXTENT, first);
}

/* Rounding of node coordinates, relative to the reference length; large far from the origin. */
real cardan_alpha_rounding(const cardan_run *run, const cardan_alpha *v)
{
    return cardan_mesh_rounding(run, v->mesh, v->now + ALPHA_EXTENT);
}

/* Root mean square of an increment dx (nu): angles relative to 1, lengths relative to the reference
 * length, each divided by rtol + atol. */
real cardan_alpha_sparse_norm(cardan_run *run, const cardan_alpha *v, const real *dx, real rtol,
                              real atol)
{
    real largest = 0;
    const real sum = cardan_mesh_squares(run, v->mesh, v->now + ALPHA_EXTENT, dx, &largest);

    return sqrt(sum / (real)(v->nu > 0 ? v->nu : 1)) / (atol + rtol);
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
