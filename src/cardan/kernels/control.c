/* Step size control of the adaptive methods.
 *
 * Part of cardan. Caller owns all memory.
 * Source: E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I, 2nd ed.,
 * section II.4 (choice of the step and of the first one).
 */
#include "run.h"
#include <float.h>
#include <math.h>

static const real SAFETY = 0.9, SHRINK = 1.0 / 3, GROW = 6;
/* Size against which an error of entry i counts. */
real cardan_scale(const cardan_run *run, const real *y, ptrdiff_t i)
{
    return run->atol + run->rtol * fmax(fabs(run->y[i]), fabs(y[i]));
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

/* Of two numbers; unlike calls of the mathematical library these are inline. */
static inline real smaller(real a, real b)
{
    return b < a ? b : a;
}

static inline real larger(real a, real b)
{
    return a < b ? b : a;
}

static real end_of(const cardan_run *run)
{
    return run->stops[run->stop_count - 1];
}

/* The smallest step that t can resolve; beside t = 0 one that is nothing to the motion. */
static real least(const cardan_run *run)
{
    const real span = smaller(fabs(end_of(run) - run->t_start), run->moment);

    return 16 * DBL_EPSILON * larger(fabs(run->t), span);
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
                                                  : pow(0.01 / fmax(d1, d2), 1.0 / order));
    run->h = sign * fmax(fmin(h0, h), 10 * least(run));
    return 0;
}

/* The step to try: h from t to t_new, not over the stop. */
int cardan_trial_step(cardan_run *run, real *h, real *t_new)
{
    real stop = run->until, left = stop - run->t;

    *h = copysign(smaller(fabs(run->h), run->max_step), run->h);
    if (fabs(*h) < least(run) && fabs(left) > least(run))
        return CARDAN_TOO_SMALL;
    /* the step that t can tell: roundings of many times would add up */
    *t_new = run->t + *h;
    *h = *t_new - run->t;
    /* stretch a little rather than leave a sliver before the stop */
    if (fabs(left) <= larger(fabs(*h) + least(run), smaller(1.01 * fabs(*h), run->max_step))) {
        *h = left;
        *t_new = stop;
    }
    return 0;
}

/* Next step after one of size h was good enough; a step cut at a stop does not shrink it. */
void cardan_accept_step(cardan_run *run, real h, real error, int order)
{
    real factor = error > 0 ? SAFETY * pow(smaller(error, 1), -1.0 / order) : GROW;
    real next;

    factor = smaller(run->rejected ? 1 : GROW, larger(SHRINK, factor));
    next = fabs(h) * factor;
    if (fabs(h) < 0.99 * fabs(run->h) && factor >= 1)
        next = larger(next, fabs(run->h));
    run->h = copysign(smaller(next, run->max_step), h);
    run->rejected = 0;
}

/* Next trial after a step of size h was not good enough or failed with a status.
 *
 * Returns 0 to try again, or why there is nothing left to try.
 */
int cardan_reject_step(cardan_run *run, real h, real error, int order, int status)
{
    real factor = status == 0 ? SAFETY * pow(error, -1.0 / order) : 0.25;

    if (status == CARDAN_INPUT)
        return status;
    run->rejections++;
    run->rejected++;
    run->h = h * smaller(0.9, larger(0.2, factor));
    if (fabs(run->h) >= least(run))
        return 0;
    return status == 0 ? CARDAN_TOO_SMALL : status;
}
