/* Step size control of the adaptive methods.
 *
 * Part of cardan. Caller owns all memory.
 * Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed.,
 * section II.4 (choice of the step and of the first one).
 */
#include "control.h"
#include "run.h"
#include <math.h>

/* x^(1 / order); of order 8 by square roots, which every processor rounds alike, so that runs by DOP853
 * have the same bits with every mathematical library */
static real root(int order, real x)
{
    return order == 8 ? sqrt(sqrt(sqrt(x))) : pow(x, 1.0 / (double)order);
}

/* The smallest tolerance of a speed, relative to the fastest. */
real cardan_finest(const cardan_run *run)
{
    real smallest = INFINITY, fastest = 0;

    for (ptrdiff_t i = run->nq; i < run->nq + run->nu; i++) {
        smallest = fmin(smallest, cardan_scale(run, run->y, i));
        fastest = fmax(fastest, fabs(run->y[i]));
    }
    return fastest > 0 ? smallest / fastest : 1;
}

static real end_of(const cardan_run *run)
{
    return run->stops[run->stop_count - 1];
}

/* The time against which a step is too small beside t = 0. */
real cardan_least_span(const cardan_run *run)
{
    const real length = fabs(end_of(run) - run->t_start);

    return CARDAN_SMALLER(length, run->moment);
}

/* The smallest step that t can resolve; beside t = 0 one that is nothing to the motion. */
static real least(const cardan_run *run)
{
    const real span = cardan_least_span(run);
    real smallest;

    cardan_least_step(&run->t, &span, &smallest);
    return smallest;
}

/* The time in which the fastest speed leads by 1, or of systems without speeds the state by itself.
 *
 * It does not depend on how long the run is to be. Rates of coordinates tell nothing: they have no
 * bounds where rotations are singular.
 */
void cardan_first_moment(cardan_run *run)
{
    const ptrdiff_t from = run->nu > 0 ? run->nq : 0, to = run->nu > 0 ? from + run->nu : run->nx;
    real state = 0, slope = 0;

    for (ptrdiff_t i = from; i < to; i++) {
        state = fmax(state, fabs(run->y[i]));
        slope = fmax(slope, fabs(run->f[i]));
    }
    if (run->nu > 0)
        run->moment = 1 / fmax(state, sqrt(slope));
    else
        run->moment = state > 0 && slope > 0 ? state / slope : INFINITY;
}

/* Root mean square of v / scale over the state, at scales of the present state. */
static real norm(const cardan_run *run, const real *v)
{
    real sum = 0;

    for (ptrdiff_t i = 0; i < run->nx; i++) {
        real x = v[i] / cardan_scale(run, run->y, i);
        sum += x * x;
    }
    return sqrt(sum / (real)(run->nx > 0 ? run->nx : 1));
}

/* Choose the first step h unless the caller gave one (h > 0).
 *
 * A step so small that an explicit Euler step is trusted shows the size of the second derivative;
 * the step then makes the first term left out by the method about 1 % of the tolerance.
 */
int cardan_first_step(cardan_run *run, int order)
{
    real sign = copysign(1, end_of(run) - run->t);
    real *f = run->k, h, h0, d0, d1, d2;
    int status = cardan_refresh(run);

    if (status != 0)
        return status;
    h = fmin(run->max_step, fabs(end_of(run) - run->t));
    if (run->h > 0) {
        run->h = sign * fmin(run->h, h);
        return 0;
    }
    d0 = norm(run, run->y);
    d1 = norm(run, run->f);
    h0 = fmin(h, d0 < 1e-5 || d1 < 1e-5 ? 1e-6 : 0.01 * d0 / d1);
    for (ptrdiff_t i = 0; i < run->n; i++)
        run->trial[i] = run->y[i] + sign * h0 * run->f[i];
    status = cardan_derivative(run, run->t + sign * h0, run->trial, f);
    if (status == CARDAN_INPUT)
        return status;
    for (ptrdiff_t i = 0; i < run->n; i++)
        f[i] -= run->f[i];
    d2 = norm(run, f) / h0;
    /* where the probe fails, the first trial step is the probe's; it may shrink from there */
    if (status == 0 && isfinite(d2))
        h0 = fmin(100 * h0, fmax(d1, d2) <= 1e-15 ? fmax(1e-6, h0 * 1e-3)
                                                  : root(order, 0.01 / fmax(d1, d2)));
    run->h = sign * fmax(fmin(h0, h), 10 * least(run));
    return 0;
}

/* The step to try: h from t to t_new, not over the stop. */
int cardan_trial_step(cardan_run *run, real *h, real *t_new)
{
    const real smallest = least(run);
    cardan_boolean lost;

    cardan_next_trial(&run->t, &run->until, &run->h, &smallest, run->max_step, h, t_new, &lost);
    return lost ? CARDAN_TOO_SMALL : 0;
}

static void accept(cardan_run *run, real h, const real *growth)
{
    const cardan_boolean rejected = run->rejected != 0;

    cardan_accepted_size(&h, &run->h, &rejected, growth, run->max_step, &run->h);
    run->rejected = 0;
}

/* Next step after one of size h was good enough; a step cut at a stop does not shrink it. */
void cardan_accept_step(cardan_run *run, real h, real error, int order)
{
    const real counted = error > 1 ? 1 : error;
    real growth;

    cardan_growth(order, &counted, &growth);
    accept(run, h, &growth);
}

/* The same of explicit methods, which look at the error of the step before as well. */
void cardan_accept_explicit_step(cardan_run *run, real h, real error, int order)
{
    const real counted = error > 1 ? 1 : error;
    real growth;

    cardan_damped_growth(order, &counted, &run->error_before, &growth);
    accept(run, h, &growth);
    run->error_before = counted;
}

/* Next trial after a step of size h was not good enough or failed with a status.
 *
 * Returns 0 to try again, or why there is nothing left to try.
 */
int cardan_reject_step(cardan_run *run, real h, real error, int order, int status)
{
    const cardan_boolean failed = status != 0;
    real growth;

    if (status == CARDAN_INPUT)
        return status;
    run->rejections++;
    run->rejected++;
    cardan_growth(order, &error, &growth);
    cardan_rejected_size(&h, &failed, &growth, &run->h);
    if (fabs(run->h) >= least(run))
        return 0;
    return status == 0 ? CARDAN_TOO_SMALL : status;
}
