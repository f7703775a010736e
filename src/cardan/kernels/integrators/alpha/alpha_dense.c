/* Dense output of the generalized-alpha method, and its error inside a step.
 *
 * Part of cardan. Caller owns all memory.
 *
 * A step uses an increment along the speeds, so its end is correct for any choice of rotation
 * coordinates. Dense output is a cubic in the coordinates. Near a gimbal lock three angles turn
 * much faster than the body, and the cubic then misses the motion between the ends.
 */
#include "alpha.h"
#include <math.h>

enum { PULLS = 3 }; /* fixed-point iterations for the slope of the increment at the end */
/* where the error is sampled, as a fraction of the step; at the midpoint it may cancel by symmetry */
static const real LOOK = 0.25;

/* Hermite cubic at LOOK from the rise over the step and the slopes at both ends, each times h. */
static real cubic_at(real rise, real first, real last)
{
    return LOOK * (rise + (1 - LOOK) * (first - rise + LOOK * (2 * rise - first - last)));
}

/* Whether coordinates change by the increments themselves: then both cubics agree. */
static int straight(const cardan_run *run, const cardan_alpha *v)
{
    /* node poses use quaternions, which turn only as fast as the bodies */
    if (v->mesh)
        return 1;
    for (ptrdiff_t i = 0; i < v->nq && v->nq == v->nu; i++)
        if (run->trial[i] != run->y[i] + v->increment[i])
            return 0;
    return v->nq == v->nu;
}

/* Increment (nu) from the start to LOOK by the cubic of the increment. Its slope at the end is h
 * times the solution of T slope = u', found by fixed-point iteration. */
static void part_of(const cardan_run *run, const cardan_alpha *v, real h, real *part)
{
    const real *u = run->y + v->nq, *last = run->trial + v->nq, *tangent = v->moved + v->nq;

    for (ptrdiff_t i = 0; i < v->nu; i++)
        part[i] = last[i];
    for (int k = 0; k < PULLS; k++)
        for (ptrdiff_t i = 0; i < v->nu; i++) {
            real missing = last[i];
            for (ptrdiff_t j = 0; j < v->nu; j++)
                missing -= tangent[i * v->nu + j] * part[j];
            part[i] += missing;
        }
    for (ptrdiff_t i = 0; i < v->nu; i++)
        part[i] = cubic_at(v->increment[i], h * u[i], h * part[i]);
}

/* Error of the coordinate cubic inside a step, in units of the tolerance. */
real cardan_alpha_misfit(cardan_run *run, const cardan_alpha *v, real h, int *status)
{
    real *part = v->room, *cubic = v->rates, sum = 0, largest = 0;
    cardan_in in;

    if (straight(run, v))
        return 0;
    /* what dense output gives at LOOK */
    in = cardan_at(run, &run->t, run->trial);
    *status = cardan_call_model(run, &run->qdot, &in, cubic);
    for (ptrdiff_t i = 0; i < v->nq; i++)
        cubic[i] = run->y[i] + cubic_at(run->trial[i] - run->y[i], h * run->f[i], h * cubic[i]);
    cardan_normalize(run, cubic);
    /* reference: the same partial increment applied to the coordinates at the start */
    part_of(run, v, h, part);
    in = cardan_at(run, &run->t, run->y);
    in.du = part;
    if (*status == 0)
        *status = cardan_call_model(run, &run->move, &in, v->moved);
    for (ptrdiff_t i = 0; i < v->nq && *status == 0; i++) {
        const real size = fmax(v->amplitude[i], fabs(run->trial[i]));
        const real missed = (cubic[i] - v->moved[i]) / (run->atol + run->rtol * size);
        sum += missed * missed;
        if (cardan_exceeds(missed * missed, largest)) {
            largest = missed * missed;
            run->culprit = i;
        }
    }
    return sqrt(sum / (real)(v->nq > 0 ? v->nq : 1));
}

/* Cubic Hermite interpolant of the last step. */
int cardan_alpha_dense(cardan_run *run)
{
    const ptrdiff_t n = run->n;
    const real h = run->t - run->t_old;

    for (ptrdiff_t i = 0; i < n; i++) {
        const real rise = run->y[i] - run->y_old[i];
        run->interpolant[i] = rise;
        run->interpolant[n + i] = h * run->k[i] - rise;
        run->interpolant[2 * n + i] = 2 * rise - h * (run->k[i] + run->f[i]);
    }
    run->is_dense = 1;
    return 0;
}
