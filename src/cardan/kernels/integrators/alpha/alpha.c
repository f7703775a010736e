/* The generalized-alpha method for constrained systems: implicit, order 2.
 *
 * Part of cardan. Caller owns all memory; run->k holds the derivative at the start of the last step,
 * run->f that at its end.
 * Newmark and HHT-alpha are the same method with other coefficients.
 *
 * Algorithm of one step (equations in alpha_newton.c, iteration matrix in alpha_matrix.c):
 *   1. shift the algorithmic acceleration a in time if the step size changed;
 *   2. predict a' and lambda', correct them by Newton iterations until the balance of forces and
 *      the constraints hold;
 *   3. error: h^2 |beta + (am - af) / 2 - 1/6| |a' - a|, and the error of the dense output;
 *   4. accept or retry; h_new = 0.9 h error^(-1/3). An accepted step keeps h unless
 *      h_new is at least 1.5 h, so that the factored matrix can be reused; only a rejected step
 *      lowers h.
 * Source: J. Chung, G. M. Hulbert, J. Appl. Mech. 60 (1993); M. Arnold, O. Brüls, A. Cardona,
 * Numer. Math. 129 (2015); M. Géradin, A. Cardona, Flexible Multibody Dynamics (2001), chapter 11
 * (step size control).
 */
#include "alpha.h"
#include <math.h>

enum { LOCAL = 3 }; /* the local error behaves like h^3 */
/* SAFETY: factor of h_new. WORTH: growth below which h is kept. GROW, LEAST: bounds of h_new / h */
static const real SAFETY = 0.9, WORTH = 1.5, GROW = 3, LEAST = 0.2;
/* Index 3: a change of step size excites an oscillation of the accelerations that decays over some
 * steps and is not an error of the motion. For QUIET steps after a change h is kept while the error
 * is at most WAVE. Later changes are bounded by GROW_3 instead of GROW. */
static const real WAVE = 8, QUIET = 10, GROW_3 = 1.4;
/* relative difference up to which two step sizes count as equal */
static const real SAME = 1e-9;

/* Largest values so far, against which relative tolerances count; those of a mesh count against its
 * reference length instead. */
static void grow_amplitudes(const cardan_run *run, const cardan_alpha *v)
{
    for (ptrdiff_t i = 0; i < v->nq && !v->mesh; i++)
        v->amplitude[i] = cardan_most(v->amplitude[i], fabs(run->y[i]));
}

/* Begin a segment at the present state with a step h. */
static int begin(cardan_run *run, const cardan_alpha *v, real h)
{
    int status;

    grow_amplitudes(run, v);
    status = cardan_alpha_restart(run, v, h);
    run->begun = status == 0;
    return status;
}

static int init(cardan_run *run)
{
    const cardan_alpha v = cardan_alpha_at(run);
    int status = 0;

    cardan_alpha_extent(run, &v, 1);
    if (v.adaptive)
        status = cardan_alpha_first_step(run, &v, LOCAL);
    else
        run->h = copysign(run->h, run->stops[run->stop_count - 1] - run->t);
    /* initial accelerations and multipliers; the first output row reports multipliers too */
    return status != 0 ? status : begin(run, &v, run->h);
}

/* Size and end time of the next step. */
static int aim(cardan_run *run, const cardan_alpha *v, real *h, real *t_new)
{
    const real stop = run->until;

    if (v->adaptive)
        return cardan_trial_step(run, h, t_new);
    /* fixed step: next grid point of the segment, or the stop if it is nearer */
    *t_new = run->segment + (real)(run->in_segment + 1) * run->h;
    if ((stop - *t_new) / run->h < 1e-9)
        *t_new = stop;
    *h = *t_new - run->t;
    return 0;
}

/* Shift a to another step size: it approximates udot at t + (am - af) h, so its distance from udot is
 * scaled by the ratio of the sizes. */
static void stand_for(const cardan_run *run, const cardan_alpha *v, real h)
{
    const real share = h / v->now[ALPHA_STEP];

    for (ptrdiff_t i = 0; i < v->nu && share != 1; i++)
        v->a[i] = v->udot[i] + share * (v->a[i] - v->udot[i]);
    if (share != 1)
        cardan_alpha_internal_restart(run, v, share, 0);
    /* sizes that differ by the rounding of times do not count as a change */
    if (fabs(share - 1) > SAME)
        v->now[ALPHA_STEPS_SINCE_CHANGE] = 0;
    v->now[ALPHA_STEP] = h;
}

/* Error of a step in units of the tolerance: the larger of two estimates.
 *
 * The first is the leading error term of the increment, of order h^3, from the change of a. The
 * second is the error of the dense output inside the step; see alpha_dense.c. */
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
    if (run->nz > 0)
        inside = cardan_worst(inside, cardan_alpha_internal_error(run, v, h));
    if (cardan_exceeds(inside, error))
        return inside;
    run->culprit = culprit;
    return error;
}

/* Whether the trial satisfies its constraints. Small corrections do not imply this if the linear
 * system was singular.
 *
 * For index 3 the rates of position constraints are not checked: no equation enforces them, and
 * speeds miss them by the error of the increment over h, many times the tolerance in healthy runs. */
static int closed(const cardan_run *run, const cardan_alpha *v, real h)
{
    const real reach = fmax(fmax(1, run->size), v->mesh ? v->now[ALPHA_EXTENT] : 1);
    const ptrdiff_t first = v->index == 2 ? 0 : v->mp;

    return cardan_gaps_close(run, v->residual + v->nu, first, h, reach, v->adaptive != 0);
}

/* Derivative at the end of a step, written to `k`: coordinate rates, accelerations, powers. */
static int derivative(cardan_run *run, const cardan_alpha *v, real t)
{
    const ptrdiff_t nq = v->nq, nx = run->nx;
    cardan_in in = cardan_at(run, &t, run->trial);
    int status = cardan_call_model(run, &run->qdot, &in, run->k);

    if (status == 0 && run->nz > 0)
        status = cardan_alpha_internal(run, v, t);
    for (ptrdiff_t i = 0; i < run->nz; i++)
        run->k[nq + v->nu + i] = v->zdot[i];
    for (ptrdiff_t i = 0; i < v->nu; i++)
        run->k[nq + i] = v->udot_new[i];
    if (status == 0 && run->power.function)
        status = cardan_call_model(run, &run->power, &in, run->k + nx);
    /* energies by the trapezoidal rule, which has the order of the method */
    for (ptrdiff_t i = nx; i < run->n; i++)
        run->trial[i] = run->y[i] + 0.5 * (t - run->t) * (run->f[i] + run->k[i]);
    return status;
}

/* Check the trial and make it the present state. */
static int commit(cardan_run *run, const cardan_alpha *v, real t)
{
    int status = 0;

    cardan_normalize(run, run->trial);
    /* constraints are enforced by the step itself: check them, no projection */
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
        return CARDAN_ROTATION_UNRESOLVED;
    /* nothing can fail from here on; exchange k and f, so that k holds the derivative at the start */
    for (ptrdiff_t i = 0; i < run->n; i++) {
        const real before = run->f[i];
        run->f[i] = run->k[i];
        run->k[i] = before;
        run->y_old[i] = run->y[i];
        run->y[i] = run->trial[i];
    }
    /* history for the predictor of the next step */
    for (ptrdiff_t i = 0; i < v->nu; i++) {
        v->rise[i] = (v->a_new[i] - v->a[i]) / (t - run->t);
        v->a[i] = v->a_new[i];
        v->udot[i] = v->udot_new[i];
    }
    for (ptrdiff_t i = 0; i < run->nz; i++)
        v->w[i] = v->w_new[i];
    for (ptrdiff_t k = 0; k < v->m; k++) {
        v->lam_old[k] = v->lam[k];
        v->lam[k] = v->lam_new[k];
    }
    grow_amplitudes(run, v);
    cardan_alpha_extent(run, v, 0);
    run->t_old = run->t;
    run->t = t;
    run->fresh = 1;
    run->is_dense = 0;
    run->steps++;
    run->begun = 0;
    v->now[ALPHA_STEPS_SINCE_CHANGE]++;
    v->now[ALPHA_AGE]++;
    run->in_segment++;
    return 0;
}

/* Choose the next step size from the error of the accepted one, in units of the tolerance. */
static void accept(cardan_run *run, const cardan_alpha *v, real h, real error)
{
    const int waves = v->index == 3 && v->m > 0;
    real factor = error > 0 ? SAFETY * pow(error, -1.0 / (real)LOCAL) : GROW;

    if (!v->adaptive)
        return;
    /* keeping the step size saves a factorization */
    if ((factor >= 1 && factor < WORTH)
        || (waves && factor < GROW && v->now[ALPHA_STEPS_SINCE_CHANGE] < QUIET))
        factor = 1;
    factor = fmax(SAFETY, fmin(factor, waves && factor < GROW ? GROW_3 : GROW));
    cardan_accept_step(run, h, pow(SAFETY / factor, LOCAL), LOCAL);
}

/* Largest error at which a step is accepted; see WAVE. */
static real allowed(const cardan_alpha *v)
{
    return v->index == 3 && v->m > 0 && v->now[ALPHA_STEPS_SINCE_CHANGE] < QUIET ? WAVE : 1;
}

/* Solve a step of size h and commit it unless its error is too large.
 *
 * error: in units of the tolerance, 0 for a fixed step size. taken: whether it was committed.
 */
static int attempt(cardan_run *run, const cardan_alpha *v, real h, real t_new, real *error,
                   int *taken)
{
    int status;

    *taken = 0;
    *error = 0;
    run->culprit = -1;
    stand_for(run, v, h);
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

/* Take one step from t, y. */
static int step(cardan_run *run)
{
    const cardan_alpha v = cardan_alpha_at(run);
    real h, t_new, error;
    int status = cardan_refresh(run), failed, taken;

    if (status == 0)
        status = aim(run, &v, &h, &t_new);
    /* start of a segment: consistent accelerations, multipliers and a for this step size */
    if (status == 0 && run->in_segment == 0 && !(run->begun && v.now[ALPHA_STEP] == h))
        status = begin(run, &v, h);
    while (status == 0 && !run->stop) {
        real factor;

        failed = attempt(run, &v, h, t_new, &error, &taken);
        if (taken) {
            accept(run, &v, h, error);
            return 0;
        }
        /* a fixed step cannot be retried */
        if (!v.adaptive || failed == CARDAN_INPUT)
            return failed;
        /* rejected: a smaller h from the error, or a quarter if Newton failed */
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
    = {init, step, cardan_alpha_dense, cardan_alpha_length, cardan_alpha_sound, 1, 3, NULL, 0};
