/* Three-stage Radau IIA method (RADAU5): order 5, adaptive step size, dense output of order 3.
 *
 * Part of cardan. Caller owns all memory. k stores the stage increments z and, for energies, powers.
 * A step extrapolates the last collocation polynomial and solves for z by simplified Newton
 * iterations on w = T^-1 z. T decouples them into a real system ALONE / h - J and a complex one
 * (REAL + i IMAG) / h - J, both nx by nx. The error estimate is filtered with the real factors.
 * Jacobian and factors are reused while Newton converges fast and the step size does not change.
 * Source: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.8.
 */
#include "radau_tables.h"
#include "shift.h"
#include <float.h>
#include <math.h>

/* the error of a step behaves like h^4 */
enum { ORDER = 4, ITERATIONS = 7, TO_ROUNDING = 30 };
/* convergence rates up to FAST keep the Jacobian, step ratios within [SHRINK, GROW) h and factors */
static const real FAST = 1e-3, SHRINK = 0.9, GROW = 1.2;

/* State that persists between steps, at the start of `mem`. */
typedef struct memory {
    real factored; /* step size of the stored factors, 0: none */
    real current;  /* 1: the Jacobian was evaluated at the present state */
    real reusable; /* 1: the Jacobian may be kept for the next step */
    real rate;     /* theta / (1 - theta) of the last Newton solve, theta its convergence rate */
    real h, error; /* size and error of the last accepted step; h = 0: none in this segment */
} memory;
enum { SCALARS = (int)(sizeof(memory) / sizeof(real)) };

/* The parts of `mem`. */
typedef struct parts {
    memory *now;
    real *before;   /* (3, nx) rows of the dense output of the last step, to extrapolate */
    real *jacobian;
    real *w, *g;     /* (3, nx) transformed increments w = T^-1 z, right-hand sides */
    real *error;     /* (nx) */
    real *state;     /* (n) */
    cardan_shift alone, pair; /* the real system and the complex one */
} parts;

static ptrdiff_t length(const cardan_run *run)
{
    const ptrdiff_t nx = run->nx;

    return SCALARS + 10 * nx + run->n + cardan_jacobian_length(run) + cardan_shift_length(run, 0)
           + cardan_shift_length(run, 1);
}

static parts parts_of(const cardan_run *run)
{
    const ptrdiff_t nx = run->nx;
    parts mem;

    mem.now = (memory *)run->method_memory;
    mem.before = run->method_memory + SCALARS;
    mem.jacobian = mem.before + 3 * nx;
    mem.w = mem.jacobian + cardan_jacobian_length(run);
    mem.g = mem.w + 3 * nx;
    mem.error = mem.g + 3 * nx;
    mem.state = mem.error + nx;
    mem.alone = cardan_shift_in(run, mem.jacobian, mem.state + run->n, 0);
    mem.pair = cardan_shift_in(run, mem.jacobian,
                               mem.state + run->n + cardan_shift_length(run, 0), 1);
    return mem;
}

/* Whether the pivots stored with the factors are valid indices (memory may come from a file). */
static int sound(const cardan_run *run)
{
    const parts mem = parts_of(run);

    return cardan_shift_sound(&mem.alone) && cardan_shift_sound(&mem.pair);
}

static int init(cardan_run *run)
{
    return cardan_first_step(run, ORDER);
}

/* Factor the real system ALONE / h - J and the complex system (REAL + i IMAG) / h - J. */
static int factor(cardan_run *run, const parts *mem, real h)
{
    run->factorizations++;
    mem->now->factored = 0;
    if (cardan_shift_factor(&mem->alone, ALONE / h, 0)
        || cardan_shift_factor(&mem->pair, REAL / h, IMAG / h))
        return CARDAN_NOT_FINITE;
    mem->now->factored = h;
    return 0;
}

/* Provide Jacobian and factors for a step of size h. Factors for the same h are reused; new ones
 * come with a new Jacobian, unless it was already evaluated at the present state. */
static int prepare(cardan_run *run, const parts *mem, real h)
{
    int status;

    if (mem->now->factored == h && mem->now->reusable)
        return 0;
    if (!mem->now->current) {
        status = cardan_jacobian(run, h, mem->jacobian);
        if (status != 0)
            return status;
        mem->now->current = 1;
    }
    mem->now->reusable = 1;
    return factor(run, mem, h);
}

/* Starting values of the stages: extrapolate the polynomial of the last step; zero without one. */
static void predict(const cardan_run *run, const parts *mem, real h)
{
    const ptrdiff_t n = run->n, nx = run->nx;
    const int has_history = mem->now->h != 0;

    for (ptrdiff_t i = 0; i < nx; i++) {
        real z[3] = {0, 0, 0};
        for (int s = 0; s < 3 && has_history; s++) {
            const real theta = NODES[s] * h / mem->now->h;
            /* p(1 + theta) - p(1) for the last step on [0, 1]; the second and third row vanish at its end */
            const real a = mem->before[i], b = mem->before[nx + i], c = mem->before[2 * nx + i];
            z[s] = theta * a - (1 + theta) * theta * (b + (1 + theta) * c);
        }
        for (int s = 0; s < 3; s++) {
            run->k[s * n + i] = z[s];
            mem->w[s * nx + i] =
                T_INVERSE[s][0] * z[0] + T_INVERSE[s][1] * z[1] + T_INVERSE[s][2] * z[2];
        }
    }
}

/* State y + z of stage s with unit quaternions, written to `state`. */
static void place(const cardan_run *run, const parts *mem, int s)
{
    for (ptrdiff_t i = 0; i < run->nx; i++)
        mem->state[i] = run->y[i] + run->k[s * run->n + i];
    cardan_normalize(run, mem->state);
}

/* Root mean square of v (rows, nx), each entry divided by its tolerance. */
static real norm(const cardan_run *run, const real *v, ptrdiff_t rows)
{
    const ptrdiff_t nx = run->nx;
    real sum = 0;

    for (ptrdiff_t j = 0; j < rows * nx; j++) {
        real x = v[j] / cardan_scale(run, run->y, j % nx);
        sum += x * x;
    }
    return sqrt(sum / (real)(rows * (nx > 0 ? nx : 1)));
}

/* One simplified Newton iteration: updates w and z; `size` receives the norm of the update. */
static int iterate(cardan_run *run, const parts *mem, real h, real *size)
{
    const ptrdiff_t n = run->n, nx = run->nx;
    real *g = mem->g, *w = mem->w, *k = run->k;
    int status = 0;

    for (int s = 0; s < 3 && status == 0; s++) {
        place(run, mem, s);
        status = cardan_evaluate(run, run->t + NODES[s] * h, mem->state, g + s * nx, NULL);
    }
    if (status != 0)
        return status;
    /* transformed residual T^-1 f - (Lambda / h) w, Lambda = T^-1 A^-1 T: row 0 is real, rows 1
     * and 2 are the real and imaginary part of the complex system */
    for (ptrdiff_t i = 0; i < nx; i++) {
        real f[3], v[3] = {w[i], w[nx + i], w[2 * nx + i]};
        for (int s = 0; s < 3; s++)
            f[s] = T_INVERSE[s][0] * g[i] + T_INVERSE[s][1] * g[nx + i]
                   + T_INVERSE[s][2] * g[2 * nx + i];
        g[i] = f[0] - ALONE / h * v[0];
        g[nx + i] = f[1] - (REAL * v[1] - IMAG * v[2]) / h;
        g[2 * nx + i] = f[2] - (REAL * v[2] + IMAG * v[1]) / h;
    }
    /* the three coupled systems decouple into one real and one complex solve */
    cardan_shift_solve(&mem->alone, ALONE / h, 0, g, NULL);
    cardan_shift_solve(&mem->pair, REAL / h, IMAG / h, g + nx, g + 2 * nx);
    *size = norm(run, g, 3);
    for (ptrdiff_t j = 0; j < 3 * nx; j++)
        w[j] += g[j];
    for (ptrdiff_t i = 0; i < nx; i++)
        for (int s = 0; s < 3; s++)
            k[s * n + i] = T[s][0] * w[i] + T[s][1] * w[nx + i] + T[s][2] * w[2 * nx + i];
    return 0;
}

/* Solve for the stage increments by simplified Newton iterations; `count` receives their number.
 * Returns 0, a status of the model, CARDAN_NOT_FINITE, or CARDAN_TOO_SMALL without convergence. */
static int solve(cardan_run *run, const parts *mem, real h, int *count)
{
    const real rounding = 10 * DBL_EPSILON * norm(run, run->y, 1);
    const real tolerance = fmax(rounding, fmin(0.03, sqrt(run->rtol)));
    /* rtol = 0 (fixed step) gives no stopping criterion: iterate down to rounding */
    const int most = run->rtol > 0 ? ITERATIONS : TO_ROUNDING;
    real last = 0, size, rate = 0;
    /* factor of the error left after the first iteration, from the last solve (Hairer's eta) */
    real left = pow(fmax(mem->now->rate, DBL_EPSILON), 0.8);

    predict(run, mem, h);
    for (*count = 1; *count <= most; (*count)++) {
        int status = iterate(run, mem, h, &size);
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
            mem->now->rate = left;
            /* slow convergence: new Jacobian in the next step */
            if (*count > 1 && rate > FAST)
                mem->now->reusable = 0;
            return 0;
        }
    }
    return CARDAN_TOO_SMALL;
}

/* Error norm of the trial in units of the tolerance: (ALONE / h - J)^-1 (f + sum ERROR[i] z_i / h),
 * the difference to the embedded formula, filtered so that stiff components stay bounded. */
static int error_of(cardan_run *run, const parts *mem, real h, real *error)
{
    const ptrdiff_t n = run->n, nx = run->nx;
    const real *k = run->k;
    int status = 0;

    for (int again = 0; again < 2 && status == 0; again++) {
        real sum = 0, worst = -1;
        for (ptrdiff_t i = 0; i < nx; i++) {
            real lack = (ERROR[0] * k[i] + ERROR[1] * k[n + i] + ERROR[2] * k[2 * n + i]) / h;
            mem->error[i] = (again ? mem->g[i] : run->f[i]) + lack;
        }
        cardan_shift_solve(&mem->alone, ALONE / h, 0, mem->error, NULL);
        for (ptrdiff_t i = 0; i < nx; i++) {
            real e = mem->error[i] / cardan_scale(run, run->trial, i);
            if (!(e * e <= worst)) {
                worst = e * e;
                run->culprit = i;
            }
            sum += e * e;
        }
        *error = sqrt(sum / (real)(nx > 0 ? nx : 1));
        /* stiff components inflate it in the first step and after a rejection; if it is above 1, filter
         * once more with f(t, y + error) in place of f(t, y), eq. (IV.8.20) */
        if (*error <= 1 || again || !(run->rejected || mem->now->h == 0))
            break;
        for (ptrdiff_t i = 0; i < nx; i++)
            mem->state[i] = run->y[i] + mem->error[i];
        cardan_normalize(run, mem->state);
        status = cardan_evaluate(run, run->t, mem->state, mem->g, NULL);
    }
    return status;
}

/* Energies at the end of the step by Radau quadrature of the powers at the stages. */
static int energies(cardan_run *run, const parts *mem, real h)
{
    const ptrdiff_t n = run->n, nx = run->nx;
    int status = 0;

    for (int s = 0; s < 3 && status == 0 && n > nx; s++) {
        place(run, mem, s);
        status = cardan_evaluate(run, run->t + NODES[s] * h, mem->state, NULL,
                                 run->k + s * n + nx);
    }
    for (ptrdiff_t e = nx; e < n; e++) {
        run->trial[e] = run->y[e];
        for (int s = 0; s < 3; s++)
            run->trial[e] += h * ENERGY[0][s] * run->k[s * n + e];
    }
    return status;
}

/* Trial step of size h: x and energies at its end in `trial`, its error, its Newton iterations. */
static int attempt(cardan_run *run, const parts *mem, real h, real *error, int *count)
{
    int status = prepare(run, mem, h);

    *error = 0;
    if (status == 0)
        status = solve(run, mem, h, count);
    if (status != 0)
        return status;
    /* stiffly accurate: the last stage is the solution */
    for (ptrdiff_t i = 0; i < run->nx; i++)
        run->trial[i] = run->y[i] + run->k[2 * run->n + i];
    status = error_of(run, mem, h, error);
    if (status == 0 && *error <= 1)
        status = energies(run, mem, h);
    return status == 0 && !(*error - *error == 0) ? CARDAN_NOT_FINITE : status;
}

/* Effective error for the step size controller, h_new = 0.9 h (effective error)^(-1/4).
 * Includes a factor for many Newton iterations and Gustafsson's predictive factor,
 * h / h_old (error_old / error)^(1/4), which may only reduce the step. */
static real asking(const memory *now, real h, real error, int count)
{
    const real patience = (2 * ITERATIONS + 1.0) / (2 * ITERATIONS + count);
    real trend = 1;

    if (now->h != 0 && error > 0)
        trend = fmin(1, h / now->h * pow(now->error / error, 1.0 / ORDER));
    return error * pow(patience * trend, -ORDER);
}

/* Store what the next step needs: interpolant to extrapolate, error history, step size. */
static void remember(cardan_run *run, const parts *mem, real h, real error, real wish)
{
    const ptrdiff_t n = run->n, nx = run->nx;
    const real *k = run->k;

    for (ptrdiff_t i = 0; i < nx; i++)
        for (int m = 0; m < 3; m++)
            mem->before[m * nx + i] =
                DENSE[m][0] * k[i] + DENSE[m][1] * k[n + i] + DENSE[m][2] * k[2 * n + i];
    /* accepted, but the controller asks for a smaller step */
    if (wish > 1 && error <= 1)
        run->h *= fmax(0.2, pow(wish, -1.0 / ORDER));
    mem->now->h = h;
    mem->now->error = fmax(error, 0.01);
    mem->now->current = 0;
    /* keep h if it would change little: this saves a new Jacobian and new factors */
    if (mem->now->reusable && fabs(run->h) >= SHRINK * fabs(h) && fabs(run->h) < GROW * fabs(h))
        run->h = h;
}

/* Take one accepted step from t, y. */
static int step(cardan_run *run)
{
    const parts mem = parts_of(run);
    int status = cardan_refresh(run);

    /* new segment (input corner or event): discard history and Jacobian */
    if (run->in_segment == 0) {
        mem.now->h = mem.now->current = mem.now->reusable = 0;
        mem.now->rate = 1;
    }
    while (status == 0 && !run->stop) {
        real h, t_new, error, wish;
        int failed, count = 0;

        status = cardan_trial_step(run, &h, &t_new);
        if (status != 0)
            return status;
        run->culprit = -1;
        failed = attempt(run, &mem, h, &error, &count);
        /* Newton failed with an old Jacobian: repeat the same step with a new one */
        if (failed == CARDAN_TOO_SMALL && !mem.now->current) {
            mem.now->reusable = 0;
            continue;
        }
        wish = asking(mem.now, h, error, count);
        /* within tolerance: project onto the constraints and make it the present state */
        if (failed == 0 && error <= 1)
            failed = cardan_commit(run, t_new, run->trial);
        if (failed == 0 && error <= 1) {
            cardan_accept_step(run, h, fmax(error, fmin(fmax(wish, run->correction), 1)), ORDER);
            remember(run, &mem, h, error, wish);
            return 0;
        }
        /* rejected: retry with a smaller h, a quarter of it if Newton failed */
        status = cardan_reject_step(run, h, wish, ORDER, failed);
    }
    return status != 0 ? status : CARDAN_STOPPED;
}

/* Dense output of degree 3: collocation polynomial of x, integral of the stage powers. */
static int dense(cardan_run *run)
{
    const ptrdiff_t n = run->n;
    const real h = run->t - run->t_old, *k = run->k;

    for (ptrdiff_t i = 0; i < n; i++) {
        run->interpolant[i] = run->y[i] - run->y_old[i];
        for (int m = 1; m < 3; m++) {
            real sum = 0;
            for (int s = 0; s < 3; s++)
                sum += i < run->nx ? DENSE[m][s] * k[s * n + i] : h * ENERGY[m][s] * k[s * n + i];
            run->interpolant[m * n + i] = sum;
        }
    }
    run->is_dense = 1;
    return 0;
}

const cardan_method cardan_radau_method
    = {init, step, dense, length, sound, 3, 3};
