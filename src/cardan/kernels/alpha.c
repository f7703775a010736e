/* The generalized-alpha method for systems with constraints: implicit, order 2.
 *
 * Part of cardan. Caller owns all memory; k holds the derivative at the start of the last step.
 * Newmark's method and that of Hilber, Hughes and Taylor are this one with other coefficients.
 * Source: J. Chung, G. M. Hulbert, J. Appl. Mech. 60 (1993); M. Arnold, O. Brüls, A. Cardona,
 * Numer. Math. 129 (2015); M. Géradin, A. Cardona, Flexible Multibody Dynamics (2001), chapter 11
 * (step size control).
 */
#include "alpha.h"
#include <math.h>

enum { LOCAL = 3 }; /* order of the error of a step */
/* steps stay as they are unless they may grow by more: their matrix serves again */
static const real SAFETY = 0.9, WORTH = 1.5, GROW = 3, LEAST = 0.2;
/* Of index 3, whose accelerations answer to a change of the step by a wave that dies out over some
 * steps: what it shows is no error of the motion. */
static const real WAVE = 8, QUIET = 10, GROW_3 = 1.4;
/* part of a step by which one of the same size may differ */
static const real SAME = 1e-9;

static int init(cardan_run *run)
{
    const cardan_alpha v = cardan_alpha_at(run);
    int status = 0;

    cardan_alpha_extent(run, &v, 1);
    if (v.adaptive)
        status = cardan_alpha_first_step(run, &v, LOCAL);
    else
        run->h = copysign(run->h, run->stops[run->stop_count - 1] - run->t);
    /* the first row shows multipliers too */
    return status != 0 ? status : cardan_alpha_restart(run, &v, run->h);
}

/* End of the next step. */
static int aim(cardan_run *run, const cardan_alpha *v, real *h, real *t_new)
{
    const real stop = run->until;

    if (v->adaptive)
        return cardan_trial_step(run, h, t_new);
    /* on the grid of the segment, or the stop if that is as near */
    *t_new = run->segment + (real)(run->in_segment + 1) * run->h;
    if ((stop - *t_new) / run->h < 1e-9)
        *t_new = stop;
    *h = *t_new - run->t;
    return 0;
}

/* a, which stands for t + (am - af) h, for a step of another size. */
static void stand_for(const cardan_alpha *v, real h)
{
    const real share = h / v->now[ALPHA_STEP];

    for (ptrdiff_t i = 0; i < v->nu && share != 1; i++)
        v->a[i] = v->udot[i] + share * (v->a[i] - v->udot[i]);
    /* the same size again differs by the rounding of times, which starts no wave */
    if (fabs(share - 1) > SAME)
        v->now[ALPHA_SINCE] = 0;
    v->now[ALPHA_STEP] = h;
}

/* Error of a step in units of the tolerance: of its increment, what h^3 udot'' / 6 is missed by; of
 * its dense output, which sees what angles do inside the step. */
static real error_of(cardan_run *run, const cardan_alpha *v, real h, int *status)
{
    const real constant = v->beta + (v->am - v->af) / 2 - 1.0 / 6;
    real *missed = v->room, error, inside;
    ptrdiff_t culprit;

    for (ptrdiff_t i = 0; i < v->nu; i++)
        missed[i] = h * h * constant * (v->a_new[i] - v->a[i]);
    error = cardan_alpha_norm(run, v, missed, run->rtol, run->atol, status);
    culprit = run->culprit;
    inside = *status == 0 ? cardan_alpha_misfit(run, v, h, status) : 0;
    if (!(inside <= error))
        return inside;
    run->culprit = culprit;
    return error;
}

/* Whether the trial closes its constraints: corrections that were small do not say so where the
 * equations behind them were not solved.
 *
 * Of index 3 nothing is asked of rates where positions bind: speeds are bound there by no equation
 * and miss the constraints by the error of the increment over h, many times the tolerance in healthy
 * runs. */
static int closed(const cardan_run *run, const cardan_alpha *v, real h)
{
    const real reach = fmax(fmax(1, run->size), v->mesh ? v->now[ALPHA_EXTENT] : 1);
    const ptrdiff_t first = v->index == 2 ? 0 : v->mp;

    return cardan_gaps_close(run, v->residual + v->nu, first, h, reach, v->adaptive != 0);
}

/* Derivative at the end of a step into `k`: rates, the accelerations found, power. */
static int derivative(cardan_run *run, const cardan_alpha *v, real t)
{
    const ptrdiff_t nq = v->nq, nx = run->nx;
    cardan_in in = cardan_at(run, &t, run->trial);
    int status = cardan_call_model(run, &run->qdot, &in, run->k);

    for (ptrdiff_t i = 0; i < v->nu; i++)
        run->k[nq + i] = v->udot_new[i];
    if (status == 0 && run->power.function)
        status = cardan_call_model(run, &run->power, &in, run->k + nx);
    /* quadratures of the same order as the method */
    for (ptrdiff_t i = nx; i < run->n; i++)
        run->trial[i] = run->y[i] + 0.5 * (t - run->t) * (run->f[i] + run->k[i]);
    return status;
}

/* Make the trial the present state. */
static int commit(cardan_run *run, const cardan_alpha *v, real t)
{
    int status = 0;

    cardan_normalize(run, run->trial);
    if (v->m > 0) {
        status = cardan_alpha_gaps(run, v, t);
        if (status == 0 && !closed(run, v, t - run->t))
            status = CARDAN_UNSOLVED;
        if (status == 0)
            cardan_note_gaps(run, v->residual + v->nu, t);
    }
    if (status == 0)
        status = derivative(run, v, t);
    if (status != 0)
        return status;
    run->culprit = cardan_not_finite(run->trial, run->n);
    if (run->culprit >= 0)
        return CARDAN_NOT_FINITE;
    if (!cardan_follows(run, t, run->trial, run->k))
        return CARDAN_WHIRLED;
    for (ptrdiff_t i = 0; i < run->n; i++) {
        const real before = run->f[i];
        run->f[i] = run->k[i];
        run->k[i] = before;
        run->y_old[i] = run->y[i];
        run->y[i] = run->trial[i];
    }
    for (ptrdiff_t i = 0; i < v->nu; i++) {
        v->rise[i] = (v->a_new[i] - v->a[i]) / (t - run->t);
        v->a[i] = v->a_new[i];
        v->udot[i] = v->udot_new[i];
    }
    for (ptrdiff_t k = 0; k < v->m; k++) {
        v->lam_old[k] = v->lam[k];
        v->lam[k] = v->lam_new[k];
    }
    for (ptrdiff_t i = 0; i < v->nq; i++)
        v->amplitude[i] = fmax(v->amplitude[i], fabs(run->y[i]));
    cardan_alpha_extent(run, v, 0);
    run->t_old = run->t;
    run->t = t;
    run->fresh = 1;
    run->is_dense = 0;
    run->steps++;
    v->now[ALPHA_SINCE]++;
    v->now[ALPHA_AGE]++;
    run->in_segment++;
    return 0;
}

/* The next step after one of some error, in units of the tolerance. */
static void accept(cardan_run *run, const cardan_alpha *v, real h, real error)
{
    const int waves = v->index == 3 && v->m > 0;
    real factor = error > 0 ? SAFETY * pow(error, -1.0 / (real)LOCAL) : GROW;

    if (!v->adaptive)
        return;
    /* the same size again is a matrix less */
    if ((factor >= 1 && factor < WORTH)
        || (waves && factor < GROW && v->now[ALPHA_SINCE] < QUIET))
        factor = 1;
    factor = fmax(SAFETY, fmin(factor, waves && factor < GROW ? GROW_3 : GROW));
    cardan_accept_step(run, h, pow(SAFETY / factor, LOCAL), LOCAL);
}

/* The error that a step may show. */
static real allowed(const cardan_alpha *v)
{
    return v->index == 3 && v->m > 0 && v->now[ALPHA_SINCE] < QUIET ? WAVE : 1;
}

/* Solve for a step of size h, and take it unless its error is too large.
 *
 * error: in units of the tolerance, 0 of a given step. taken: whether it was.
 */
static int attempt(cardan_run *run, const cardan_alpha *v, real h, real t_new, real *error,
                   int *taken)
{
    int status;

    *taken = 0;
    *error = 0;
    run->culprit = -1;
    stand_for(v, h);
    status = cardan_alpha_solve(run, v, h, t_new);
    if (status == 0 && v->adaptive)
        *error = error_of(run, v, h, &status);
    if (status == 0 && *error - *error != 0)
        status = CARDAN_NOT_FINITE;
    if (status == 0 && *error <= allowed(v)) {
        status = commit(run, v, t_new);
        *taken = status == 0;
    }
    return status;
}

/* One step from t, y. */
static int step(cardan_run *run)
{
    const cardan_alpha v = cardan_alpha_at(run);
    real h, t_new, error;
    int status = cardan_refresh(run), failed, taken;

    if (status == 0)
        status = aim(run, &v, &h, &t_new);
    if (status == 0 && run->in_segment == 0) {
        for (ptrdiff_t i = 0; i < v.nq; i++)
            v.amplitude[i] = fmax(v.amplitude[i], fabs(run->y[i]));
        status = cardan_alpha_restart(run, &v, h);
    }
    while (status == 0 && !run->stop) {
        real factor;

        failed = attempt(run, &v, h, t_new, &error, &taken);
        if (taken) {
            accept(run, &v, h, error);
            return 0;
        }
        if (!v.adaptive || failed == CARDAN_INPUT)
            return failed;
        factor = failed == 0 ? SAFETY * pow(error, -1.0 / (real)LOCAL) : 0.25;
        run->rejections++;
        run->rejected++;
        run->h = h * fmin(0.9, fmax(LEAST, factor));
        status = aim(run, &v, &h, &t_new);
        if (status == CARDAN_TOO_SMALL && failed != 0)
            status = failed;
    }
    return status != 0 ? status : CARDAN_STOPPED;
}

const cardan_method cardan_alpha_method
    = {init, step, cardan_alpha_dense, cardan_alpha_length, cardan_alpha_sound, 1, 3};
