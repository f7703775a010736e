/* Radau IIA method of 3 stages: order 5, stiffly accurate, dense output of order 3, adaptive step.
 *
 * Part of cardan. Caller owns all memory; k holds the increments z of the stages, and in place of
 * energies the powers there; `own` scalars that outlive a step, the dense output before, the
 * Jacobian, the factors of both systems.
 * The Jacobian and its factors serve as long as iterations converge fast and the step stays.
 * Source: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.8.
 */
#include "radau_tables.h"
#include "shift.h"
#include <float.h>
#include <math.h>

/* the error of a step behaves like h^4 */
enum { ORDER = 4, ITERATIONS = 7, TO_ROUNDING = 30 };
/* iterations that converge faster keep the Jacobian; steps that would change by less stay */
static const real FAST = 1e-3, SHRINK = 0.9, GROW = 1.2;

/* What outlives a step, at the start of `own`. */
typedef struct memory {
    real factored; /* the step whose factors are there, 0: none are */
    real current;  /* 1: the Jacobian is that of the present state */
    real kept;     /* 1: the Jacobian may serve another step */
    real rate;     /* of the last iterations, as a factor of the next error */
    real h, error; /* of the last accepted step, 0: there was none in this segment */
} memory;
enum { SCALARS = (int)(sizeof(memory) / sizeof(real)) };

/* The parts of `own`. */
typedef struct parts {
    memory *now;
    real *before;   /* (3, nx) rows of the dense output of the last step */
    real *jacobian;
    real *w, *g;     /* (3, nx) transformed increments and right sides */
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
    parts own;

    own.now = (memory *)run->own;
    own.before = run->own + SCALARS;
    own.jacobian = own.before + 3 * nx;
    own.w = own.jacobian + cardan_jacobian_length(run);
    own.g = own.w + 3 * nx;
    own.error = own.g + 3 * nx;
    own.state = own.error + nx;
    own.alone = cardan_shift_in(run, own.jacobian, own.state + run->n, 0);
    own.pair = cardan_shift_in(run, own.jacobian,
                               own.state + run->n + cardan_shift_length(run, 0), 1);
    return own;
}

/* Whether the factors in memory are of rows that exist. */
static int sound(const cardan_run *run)
{
    const parts own = parts_of(run);

    return cardan_shift_sound(&own.alone) && cardan_shift_sound(&own.pair);
}

static int init(cardan_run *run)
{
    return cardan_first_step(run, ORDER);
}

/* Factor ALONE / h - J and (REAL + i IMAG) / h - J. */
static int factor(cardan_run *run, const parts *own, real h)
{
    run->factorizations++;
    own->now->factored = 0;
    if (cardan_shift_factor(&own->alone, ALONE / h, 0)
        || cardan_shift_factor(&own->pair, REAL / h, IMAG / h))
        return CARDAN_NOT_FINITE;
    own->now->factored = h;
    return 0;
}

/* Jacobian and factors for a step of size h, as far as they are not there. */
static int prepare(cardan_run *run, const parts *own, real h)
{
    int status;

    if (own->now->factored == h && own->now->kept)
        return 0;
    if (!own->now->current) {
        status = cardan_jacobian(run, h, own->jacobian);
        if (status != 0)
            return status;
        own->now->current = 1;
    }
    own->now->kept = 1;
    return factor(run, own, h);
}

/* Increments to begin with: the polynomial of the last step goes on. */
static void predict(const cardan_run *run, const parts *own, real h)
{
    const ptrdiff_t n = run->n, nx = run->nx;
    const int known = own->now->h != 0;

    for (ptrdiff_t i = 0; i < nx; i++) {
        real z[3] = {0, 0, 0};
        for (int s = 0; s < 3 && known; s++) {
            const real theta = NODES[s] * h / own->now->h;
            /* beyond its end, less its end: rows 1 and 2 vanish there */
            const real a = own->before[i], b = own->before[nx + i], c = own->before[2 * nx + i];
            z[s] = theta * a - (1 + theta) * theta * (b + (1 + theta) * c);
        }
        for (int s = 0; s < 3; s++) {
            run->k[s * n + i] = z[s];
            own->w[s * nx + i] =
                T_INVERSE[s][0] * z[0] + T_INVERSE[s][1] * z[1] + T_INVERSE[s][2] * z[2];
        }
    }
}

/* y + z of stage s with quaternions of unit length, in `state`. */
static void place(const cardan_run *run, const parts *own, int s)
{
    for (ptrdiff_t i = 0; i < run->nx; i++)
        own->state[i] = run->y[i] + run->k[s * run->n + i];
    cardan_normalize(run, own->state);
}

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

/* One iteration: changes w and z; `size` becomes the norm of the change. */
static int iterate(cardan_run *run, const parts *own, real h, real *size)
{
    const ptrdiff_t n = run->n, nx = run->nx;
    real *g = own->g, *w = own->w, *k = run->k;
    int status = 0;

    for (int s = 0; s < 3 && status == 0; s++) {
        place(run, own, s);
        status = cardan_evaluate(run, run->t + NODES[s] * h, own->state, g + s * nx, NULL);
    }
    if (status != 0)
        return status;
    for (ptrdiff_t i = 0; i < nx; i++) {
        real f[3], v[3] = {w[i], w[nx + i], w[2 * nx + i]};
        for (int s = 0; s < 3; s++)
            f[s] = T_INVERSE[s][0] * g[i] + T_INVERSE[s][1] * g[nx + i]
                   + T_INVERSE[s][2] * g[2 * nx + i];
        g[i] = f[0] - ALONE / h * v[0];
        g[nx + i] = f[1] - (REAL * v[1] - IMAG * v[2]) / h;
        g[2 * nx + i] = f[2] - (REAL * v[2] + IMAG * v[1]) / h;
    }
    cardan_shift_solve(&own->alone, ALONE / h, 0, g, NULL);
    cardan_shift_solve(&own->pair, REAL / h, IMAG / h, g + nx, g + 2 * nx);
    *size = norm(run, g, 3);
    for (ptrdiff_t j = 0; j < 3 * nx; j++)
        w[j] += g[j];
    for (ptrdiff_t i = 0; i < nx; i++)
        for (int s = 0; s < 3; s++)
            k[s * n + i] = T[s][0] * w[i] + T[s][1] * w[nx + i] + T[s][2] * w[2 * nx + i];
    return 0;
}

/* Increments of the stages by simplified Newton iterations; `count` of them.
 *
 * Returns 0, a status of the model, or CARDAN_TOO_SMALL where they do not converge.
 */
static int solve(cardan_run *run, const parts *own, real h, int *count)
{
    const real rounding = 10 * DBL_EPSILON * norm(run, run->y, 1);
    const real wanted = fmax(rounding, fmin(0.03, sqrt(run->rtol)));
    /* without a relative tolerance nothing says when it is enough: to rounding */
    const int most = run->rtol > 0 ? ITERATIONS : TO_ROUNDING;
    real last = 0, size, rate = 0;
    /* how the iterations before went says something of the first one */
    real left = pow(fmax(own->now->rate, DBL_EPSILON), 0.8);

    predict(run, own, h);
    for (*count = 1; *count <= most; (*count)++) {
        int status = iterate(run, own, h, &size);
        if (status != 0)
            return status;
        if (!(size - size == 0))
            return CARDAN_NOT_FINITE;
        if (*count > 1) {
            rate = *count == 2 ? size / last : sqrt(rate * size / last);
            if (rate >= 0.99 && size > 100 * rounding)
                return CARDAN_TOO_SMALL;
            left = rate / (1 - fmin(rate, 0.99));
            /* what is left after the last one is told in advance */
            if (left * size * pow(rate, most - 1 - *count) > 10 * wanted)
                return CARDAN_TOO_SMALL;
        }
        last = size;
        if (size == 0 || left * size <= wanted
            || (*count > 1 && (size <= rounding || rate >= 0.99))) {
            own->now->rate = left;
            if (*count > 1 && rate > FAST)
                own->now->kept = 0;
            return 0;
        }
    }
    return CARDAN_TOO_SMALL;
}

/* Error of the trial in units of the tolerance. */
static int error_of(cardan_run *run, const parts *own, real h, real *error)
{
    const ptrdiff_t n = run->n, nx = run->nx;
    const real *k = run->k;
    int status = 0;

    for (int again = 0; again < 2 && status == 0; again++) {
        real sum = 0, worst = -1;
        for (ptrdiff_t i = 0; i < nx; i++) {
            real lack = (ERROR[0] * k[i] + ERROR[1] * k[n + i] + ERROR[2] * k[2 * n + i]) / h;
            own->error[i] = (again ? own->g[i] : run->f[i]) + lack;
        }
        cardan_shift_solve(&own->alone, ALONE / h, 0, own->error, NULL);
        for (ptrdiff_t i = 0; i < nx; i++) {
            real e = own->error[i] / cardan_scale(run, run->trial, i);
            if (!(e * e <= worst)) {
                worst = e * e;
                run->culprit = i;
            }
            sum += e * e;
        }
        *error = sqrt(sum / (real)(nx > 0 ? nx : 1));
        /* stiff parts that the first step, or one after a rejection, would see too large */
        if (*error <= 1 || again || !(run->rejected || own->now->h == 0))
            break;
        for (ptrdiff_t i = 0; i < nx; i++)
            own->state[i] = run->y[i] + own->error[i];
        cardan_normalize(run, own->state);
        status = cardan_evaluate(run, run->t, own->state, own->g, NULL);
    }
    return status;
}

/* The energies at the end of the step, from the powers at its stages. */
static int energies(cardan_run *run, const parts *own, real h)
{
    const ptrdiff_t n = run->n, nx = run->nx;
    int status = 0;

    for (int s = 0; s < 3 && status == 0 && n > nx; s++) {
        place(run, own, s);
        status = cardan_evaluate(run, run->t + NODES[s] * h, own->state, NULL,
                                 run->k + s * n + nx);
    }
    for (ptrdiff_t e = nx; e < n; e++) {
        run->trial[e] = run->y[e];
        for (int s = 0; s < 3; s++)
            run->trial[e] += h * ENERGY[0][s] * run->k[s * n + e];
    }
    return status;
}

/* A trial of size h: x and energies at its end in `trial`, its error, iterations spent. */
static int attempt(cardan_run *run, const parts *own, real h, real *error, int *count)
{
    int status = prepare(run, own, h);

    *error = 0;
    if (status == 0)
        status = solve(run, own, h, count);
    if (status != 0)
        return status;
    for (ptrdiff_t i = 0; i < run->nx; i++)
        run->trial[i] = run->y[i] + run->k[2 * run->n + i];
    status = error_of(run, own, h, error);
    if (status == 0 && *error <= 1)
        status = energies(run, own, h);
    return status == 0 && !(*error - *error == 0) ? CARDAN_NOT_FINITE : status;
}

/* The error that asks for the next step: with iterations spent, and how errors change. */
static real asking(const memory *now, real h, real error, int count)
{
    const real patience = (2 * ITERATIONS + 1.0) / (2 * ITERATIONS + count);
    real trend = 1;

    if (now->h != 0 && error > 0)
        trend = fmin(1, h / now->h * pow(now->error / error, 1.0 / ORDER));
    return error * pow(patience * trend, -ORDER);
}

/* What the next step knows of this one. */
static void remember(cardan_run *run, const parts *own, real h, real error, real wish)
{
    const ptrdiff_t n = run->n, nx = run->nx;
    const real *k = run->k;

    for (ptrdiff_t i = 0; i < nx; i++)
        for (int m = 0; m < 3; m++)
            own->before[m * nx + i] =
                DENSE[m][0] * k[i] + DENSE[m][1] * k[n + i] + DENSE[m][2] * k[2 * n + i];
    /* a shorter step, though this one was good */
    if (wish > 1 && error <= 1)
        run->h *= fmax(0.2, pow(wish, -1.0 / ORDER));
    own->now->h = h;
    own->now->error = fmax(error, 0.01);
    own->now->current = 0;
    /* a change by little is not worth new factors */
    if (own->now->kept && fabs(run->h) >= SHRINK * fabs(h) && fabs(run->h) < GROW * fabs(h))
        run->h = h;
}

/* One accepted step from t, y. */
static int step(cardan_run *run)
{
    const parts own = parts_of(run);
    int status = cardan_refresh(run);

    /* a new segment: nothing of the one before need hold */
    if (run->in_segment == 0) {
        own.now->h = own.now->current = own.now->kept = 0;
        own.now->rate = 1;
    }
    while (status == 0 && !run->stop) {
        real h, t_new, error, wish;
        int failed, count = 0;

        status = cardan_trial_step(run, &h, &t_new);
        if (status != 0)
            return status;
        run->culprit = -1;
        failed = attempt(run, &own, h, &error, &count);
        /* iterations that fail with an old Jacobian get a new one */
        if (failed == CARDAN_TOO_SMALL && !own.now->current) {
            own.now->kept = 0;
            continue;
        }
        wish = asking(own.now, h, error, count);
        if (failed == 0 && error <= 1)
            failed = cardan_commit(run, t_new, run->trial);
        if (failed == 0 && error <= 1) {
            cardan_accept_step(run, h, fmax(error, fmin(fmax(wish, run->correction), 1)), ORDER);
            remember(run, &own, h, error, wish);
            return 0;
        }
        status = cardan_reject_step(run, h, wish, ORDER, failed);
    }
    return status != 0 ? status : CARDAN_STOPPED;
}

/* Polynomial of degree 3 over the last step. */
static int dense(cardan_run *run)
{
    const ptrdiff_t n = run->n;
    const real h = run->t - run->t_old, *k = run->k;

    for (ptrdiff_t i = 0; i < n; i++) {
        run->spread[i] = run->y[i] - run->y_old[i];
        for (int m = 1; m < 3; m++) {
            real sum = 0;
            for (int s = 0; s < 3; s++)
                sum += i < run->nx ? DENSE[m][s] * k[s * n + i] : h * ENERGY[m][s] * k[s * n + i];
            run->spread[m * n + i] = sum;
        }
    }
    run->is_dense = 1;
    return 0;
}

const cardan_method cardan_radau_method
    = {init, step, dense, length, sound, 3, 3};
