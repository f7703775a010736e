/* Three-stage Radau IIA method (RADAU5): order 5, adaptive step size, dense output of order 3.
 *
 * Part of cardan. Caller owns all memory. k stores the stage increments z and, for energies, powers.
 * A step extrapolates the last collocation polynomial and solves for z by simplified Newton
 * iterations: see radau_rates.c, and over elements radau_elements.c. Jacobian and factors are reused
 * while Newton converges fast and the step size does not change.
 * Source: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.8.
 */
#include "radau.h"
#include "radau_tables.h"
#include <float.h>
#include <math.h>

/* the error of a step behaves like h^4 */
enum { ORDER = 4, ITERATIONS = 7, TO_ROUNDING = 30 };
/* step ratios within [SHRINK, GROW) keep h and factors */
static const real SHRINK = 0.9, GROW = 1.2;

static cardan_radau *now_of(const cardan_run *run)
{
    return (cardan_radau *)run->method_memory;
}

/* The derivative (n) at the start of the last step. */
static real *start_of(const cardan_run *run)
{
    return run->method_memory + CARDAN_RADAU_NUMBERS + run->n;
}

static const cardan_radau_form *form_of(const cardan_run *run)
{
    return run->mesh ? &cardan_radau_elements : &cardan_radau_rates;
}

static ptrdiff_t length(const cardan_run *run)
{
    return CARDAN_RADAU_NUMBERS + 2 * run->n + form_of(run)->length(run);
}

/* Whether the indices stored with the factors are valid (memory may come from a file). */
static int sound(const cardan_run *run)
{
    return form_of(run)->sound(run);
}

static int init(cardan_run *run)
{
    return cardan_first_step(run, ORDER);
}

/* Provide Jacobian and factors for a step of size h. Factors for the same h are reused; new ones
 * come with a new Jacobian, unless it was already evaluated at the present state. */
static int prepare(cardan_run *run, real h)
{
    cardan_radau *now = now_of(run);
    int status = 0;

    if (now->factored == h && now->reusable != 0)
        return 0;
    if (now->current == 0) {
        status = form_of(run)->jacobian(run, h);
        if (status != 0)
            return status;
        now->current = 1;
    }
    now->reusable = 1;
    run->factorizations++;
    now->factored = 0;
    status = form_of(run)->factor(run, h);
    if (status == 0)
        now->factored = h;
    return status;
}

/* Solve for the stage increments by simplified Newton iterations; `count` receives their number.
 * Returns 0, a status of the model, CARDAN_NOT_FINITE, or CARDAN_TOO_SMALL without convergence. */
static int solve(cardan_run *run, real h, int *count)
{
    const cardan_radau_form *form = form_of(run);
    cardan_radau *now = now_of(run);
    const real rounding = form->rounding(run, h);
    const real tolerance = fmax(rounding, fmin(0.03, sqrt(run->rtol)));
    /* rtol = 0 (fixed step) gives no stopping criterion: iterate down to rounding */
    const int most = run->rtol > 0 ? ITERATIONS : TO_ROUNDING;
    real last = 0, size, rate = 0;
    /* factor of the error left after the first iteration, from the last solve (Hairer's eta) */
    real left = pow(fmax(now->rate, DBL_EPSILON), 0.8);

    int status = form->predict(run, h, now->h != 0 ? h / now->h : 0);

    for (*count = 1; *count <= most && status == 0; (*count)++) {
        status = form->iterate(run, h, &size);
        if (status != 0)
            return status;
        if (!(size - size == 0))
            return CARDAN_NOT_FINITE;
        if (*count > 1) {
            /* convergence rate, a geometric mean from the third iteration on */
            rate = *count == 2 ? size / last : sqrt(rate * size / last);
            if (rate >= 0.99 && size > 100 * rounding)
                return CARDAN_TOO_SMALL;
            left = rate / (1 - fmin(rate, 0.99));
            /* give up early if the error predicted after the last iteration is too large */
            if (left * size * pow(rate, most - 1 - *count) > 10 * tolerance)
                return CARDAN_TOO_SMALL;
        }
        last = size;
        /* converged: estimated remaining error within the tolerance, or update at rounding level */
        if (size == 0 || left * size <= tolerance
            || (*count > 1 && (size <= rounding || rate >= 0.99))) {
            now->rate = left;
            /* slow convergence: new Jacobian in the next step */
            if (*count > 1 && rate > form->fast)
                now->reusable = 0;
            return 0;
        }
    }
    return status != 0 ? status : CARDAN_TOO_SMALL;
}

/* Error norm of the trial in units of the tolerance. Stiff components inflate it in the first step
 * and after a rejection; if it is above 1, it is filtered once more, eq. (IV.8.20). Those of elements
 * do in every step: speeds of vibrations that no step follows pass the first filter. */
static int error_of(cardan_run *run, real h, real *error)
{
    const cardan_radau_form *form = form_of(run);
    const int status = form->error(run, h, 0, error);

    if (status != 0 || *error <= 1 || !(form->refilters || run->rejected || now_of(run)->h == 0))
        return status;
    return form->error(run, h, 1, error);
}

/* Energies at the end of the step by Radau quadrature of the powers at the stages. */
static int energies(cardan_run *run, real h)
{
    const ptrdiff_t n = run->n, nx = run->nx;
    real *state = run->method_memory + CARDAN_RADAU_NUMBERS;
    int status = 0;

    for (int s = 0; s < 3 && status == 0 && n > nx; s++) {
        for (ptrdiff_t i = 0; i < nx; i++)
            state[i] = run->y[i] + run->k[s * n + i];
        cardan_normalize(run, state);
        status = cardan_evaluate(run, run->t + NODES[s] * h, state, NULL, run->k + s * n + nx);
    }
    for (ptrdiff_t e = nx; e < n; e++) {
        run->trial[e] = run->y[e];
        for (int s = 0; s < 3; s++)
            run->trial[e] += h * ENERGY[0][s] * run->k[s * n + e];
    }
    return status;
}

/* Trial step of size h: x and energies at its end in `trial`, its error, its Newton iterations. */
static int attempt(cardan_run *run, real h, real *error, int *count)
{
    int status = prepare(run, h);

    *error = 0;
    if (status == 0)
        status = solve(run, h, count);
    if (status == 0)
        status = form_of(run)->end(run, h);
    if (status == 0)
        status = error_of(run, h, error);
    if (status == 0 && *error <= 1)
        status = energies(run, h);
    return status == 0 && !(*error - *error == 0) ? CARDAN_NOT_FINITE : status;
}

/* Effective error for the step size controller, h_new = 0.9 h (effective error)^(-1/4).
 * Includes a factor for many Newton iterations and Gustafsson's predictive factor,
 * h / h_old (error_old / error)^(1/4), which may only reduce the step. */
static real asking(const cardan_radau *now, real h, real error, int count)
{
    const real patience = (2 * ITERATIONS + 1.0) / (2 * ITERATIONS + count);
    real trend = 1;

    if (now->h != 0 && error > 0)
        trend = fmin(1, h / now->h * pow(now->error / error, 1 / (real)ORDER));
    return error * pow(patience * trend, -ORDER);
}

/* Store what the next step needs: interpolant to extrapolate, error history, step size. */
static void remember(cardan_run *run, real h, real error, real wish)
{
    cardan_radau *now = now_of(run);

    form_of(run)->remember(run);
    /* accepted, but the controller asks for a smaller step */
    if (wish > 1 && error <= 1)
        run->h *= fmax(0.2, pow(wish, -1 / (real)ORDER));
    now->h = h;
    now->error = fmax(error, 0.01);
    now->current = 0;
    /* keep h if it would change little: this saves a new Jacobian and new factors */
    if (now->reusable != 0 && fabs(run->h) >= SHRINK * fabs(h) && fabs(run->h) < GROW * fabs(h))
        run->h = h;
}

/* Take one accepted step from t, y. */
static int step(cardan_run *run)
{
    cardan_radau *now = now_of(run);
    real *start = start_of(run);
    int status = cardan_refresh(run);

    for (ptrdiff_t i = 0; i < run->n; i++)
        start[i] = run->f[i];

    /* new segment (input corner or event): discard history and Jacobian */
    if (run->in_segment == 0) {
        now->h = now->current = now->reusable = 0;
        now->rate = 1;
        status = status != 0 ? status : form_of(run)->begin(run);
    }
    while (status == 0 && !run->stop) {
        real h, t_new, error, wish;
        int failed, count = 0;

        status = cardan_trial_step(run, &h, &t_new);
        if (status != 0)
            return status;
        run->culprit = -1;
        failed = attempt(run, h, &error, &count);
        /* Newton failed with an old Jacobian: repeat the same step with a new one */
        if (failed == CARDAN_TOO_SMALL && now->current == 0) {
            now->reusable = 0;
            continue;
        }
        wish = asking(now, h, error, count);
        /* within tolerance: project onto the constraints and make it the present state */
        if (failed == 0 && error <= 1)
            failed = cardan_commit(run, t_new, run->trial);
        if (failed == 0 && error <= 1) {
            cardan_accept_step(run, h, fmax(error, fmin(fmax(wish, run->correction), 1)), ORDER);
            remember(run, h, error, wish);
            return 0;
        }
        /* rejected: retry with a smaller h, a quarter of it if Newton failed */
        status = cardan_reject_step(run, h, wish, ORDER, failed);
    }
    return status != 0 ? status : CARDAN_STOPPED;
}

/* Dense output of degree 3: collocation polynomial of x, integral of the stage powers.
 *
 * Over elements coordinates have the slopes of their speeds at both ends, so that a gap that begins
 * to open does not close again by an error of its rate; speeds, whose rates are stiff, do not.
 */
static int dense(cardan_run *run)
{
    const ptrdiff_t n = run->n;
    const real h = run->t - run->t_old, *k = run->k, *start = start_of(run);
    real *rows = run->interpolant;

    for (ptrdiff_t i = 0; i < n; i++) {
        rows[i] = run->y[i] - run->y_old[i];
        if (run->mesh && i < run->nq) {
            rows[n + i] = h * start[i] - rows[i];
            rows[2 * n + i] = 2 * rows[i] - h * (start[i] + run->f[i]);
            continue;
        }
        for (int m = 1; m < 3; m++) {
            real sum = 0;
            for (int s = 0; s < 3; s++)
                sum += i < run->nx ? DENSE[m][s] * k[s * n + i] : h * ENERGY[m][s] * k[s * n + i];
            rows[m * n + i] = sum;
        }
    }
    run->is_dense = 1;
    return 0;
}

const cardan_method cardan_radau_method
    = {init, step, dense, length, sound, 3, 3, NULL, 0};
