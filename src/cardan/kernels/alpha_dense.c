/* Dense output of the generalized-alpha method, and what it misses of the motion inside a step.
 *
 * Part of cardan. Caller owns all memory.
 *
 * A step goes by an increment along the speeds and is right at its end however coordinates describe
 * rotations. Dense output is a cubic in the coordinates themselves: where these turn much faster than
 * the body, as three angles do beside their gimbal lock, it is not what happens between the ends.
 */
#include "alpha.h"
#include <math.h>

enum { PULLS = 3 }; /* corrections of the slope of increments at the end of a step */
/* where it is looked, part of a step; in the middle what turns steadily is met by symmetry alone */
static const real LOOK = 0.25;

/* There, the cubic of a rise and its slopes at both ends, each times h. */
static real cubic_at(real rise, real first, real last)
{
    return LOOK * (rise + (1 - LOOK) * (first - rise + LOOK * (2 * rise - first - last)));
}

/* Whether coordinates rise by the increments themselves: then both cubics are one. */
static int straight(const cardan_run *run, const cardan_alpha *v)
{
    /* poses of nodes are quaternions, which turn as fast as the bodies do */
    if (v->mesh)
        return 1;
    for (ptrdiff_t i = 0; i < v->nq && v->nq == v->nu; i++)
        if (run->trial[i] != run->y[i] + v->increment[i])
            return 0;
    return v->nq == v->nu;
}

/* The increment (nu) up to there by the cubic of increments, whose slope at the end is h times the
 * solution of T slope = u'. */
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

/* What the cubic of the coordinates misses inside a step, in units of the tolerance. */
real cardan_alpha_misfit(cardan_run *run, const cardan_alpha *v, real h, int *status)
{
    real *part = v->room, *cubic = v->rates, sum = 0, largest = 0;
    cardan_in in;

    if (straight(run, v))
        return 0;
    in = cardan_at(run, &run->t, run->trial);
    *status = cardan_call_model(run, &run->qdot, &in, cubic);
    for (ptrdiff_t i = 0; i < v->nq; i++)
        cubic[i] = run->y[i] + cubic_at(run->trial[i] - run->y[i], h * run->f[i], h * cubic[i]);
    cardan_normalize(run, cubic);
    part_of(run, v, h, part);
    in = cardan_at(run, &run->t, run->y);
    in.du = part;
    if (*status == 0)
        *status = cardan_call_model(run, &run->move, &in, v->moved);
    for (ptrdiff_t i = 0; i < v->nq && *status == 0; i++) {
        const real size = fmax(v->amplitude[i], fabs(run->trial[i]));
        const real missed = (cubic[i] - v->moved[i]) / (run->atol + run->rtol * size);
        sum += missed * missed;
        if (!(missed * missed <= largest)) {
            largest = missed * missed;
            run->culprit = i;
        }
    }
    return sqrt(sum / (real)(v->nq > 0 ? v->nq : 1));
}

/* Cubic through values and derivatives at both ends of the last step. */
int cardan_alpha_dense(cardan_run *run)
{
    const ptrdiff_t n = run->n;
    const real h = run->t - run->t_old;

    for (ptrdiff_t i = 0; i < n; i++) {
        const real rise = run->y[i] - run->y_old[i];
        run->spread[i] = rise;
        run->spread[n + i] = h * run->k[i] - rise;
        run->spread[2 * n + i] = 2 * rise - h * (run->k[i] + run->f[i]);
    }
    run->is_dense = 1;
    return 0;
}
