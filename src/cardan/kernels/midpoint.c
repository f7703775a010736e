/* The implicit midpoint rule on which the energy balance is imposed: order 2, fixed step.
 *
 * Part of cardan. Caller owns all memory; k holds the derivatives at the start, the middle and the
 * end of a step.
 *
 * A step solves  x1 = x0 + h f(xm) + mu (0, um)  with xm = (x0 + x1) / 2, um its speeds, and
 *   E(x1) = E(start) + work of all sources without a potential, taken at the middles,
 * where mu, of order h^3, is as unknown as x1. It is a discrete gradient along the speeds, and
 * symmetric: exchanging the ends turns mu round. The balance holds at every step size, from the
 * start of the segment on, so that roundings do not add up. Quaternions go by their increments,
 * circuits are closed before the energy counts.
 *
 * The equations are solved by Broyden's method from an inverse matrix that is kept from step to
 * step, and made anew from differences where it no longer leads to the solution.
 * Source: O. Gonzalez, Time integration and discrete Hamiltonian systems, J. Nonlinear Sci. 6 (1996)
 * 449-467; E. Hairer, C. Lubich, G. Wanner, Geometric Numerical Integration, 2nd ed., sections V.3
 * and V.4; C. T. Kelley, Iterative Methods for Linear and Nonlinear Equations, chapter 7.
 */
#include "explicit.h"
#include <float.h>
#include <math.h>

/* corrections relative to the size of their block: sought, and what still counts as solved */
static const real SOUGHT = 4e-15, SOLVED = 1e-12;
static const real NEAR = 1e-3;
static const real LEARNT = 1e-10; /* smaller corrections are too noisy to learn from */
static const real BALANCED = 4 * DBL_EPSILON; /* of the energies */
static const real SHIFT = 1.5e-8; /* of differences, relative: the root of a rounding */
enum {
    MOST = 25,
    FRESH = 2,    /* matrices made for one step */
    SHORTEST = 64 /* parts of a step */
};

/* kept from step to step, before everything else in the method's memory */
enum { ENERGY, WORK, SIZE, SCALE, INVERTED, KEPT };

/* Parts of the method's own memory; size = nx + 1, of x1 and mu. */
typedef struct room {
    ptrdiff_t size;
    real *kept;     /* (KEPT) energy and work at the start of the segment, the sum of energies
                       without signs, what a residual is divided by, whether there is `inverse` */
    real *inverse;  /* (size, size) of the matrix of the equations */
    real *matrix;   /* (size, 2 size) */
    real *z;        /* (size) x1 in the chart, mu */
    real *residual; /* (size) */
    real *change;   /* (size) of z */
    real *image;    /* (size) */
    real *end;      /* (n) state at x1, closed */
} room;

ptrdiff_t cardan_midpoint_length(const cardan_run *run)
{
    const ptrdiff_t size = run->nx + 1;

    return KEPT + 3 * size * size + 4 * size + run->n;
}

static room room_of(const cardan_run *run)
{
    const ptrdiff_t size = run->nx + 1;
    real *inverse = run->own + KEPT, *z = inverse + 3 * size * size;
    const room at = {size,     run->own,     inverse,      inverse + size * size, z,
                     z + size, z + 2 * size, z + 3 * size, z + 4 * size};

    return at;
}

/* What a step solves for: from x0 in the chart to t_new. */
typedef struct problem {
    const real *base; /* (n) */
    real h, t_new;
} problem;

int cardan_midpoint_init(cardan_run *run)
{
    return cardan_fixed_init(run);
}

static real work_of(const cardan_run *run, const real *y)
{
    real sum = 0;

    for (ptrdiff_t i = run->nx; i < run->n; i++)
        sum += y[i];
    return sum;
}

/* Total energy and that of motion at t, y (n). */
static int energy_at(cardan_run *run, real t, const real *y, real *total, real *kinetic)
{
    real energies[3];
    cardan_in in;
    int status;

    cardan_inputs_at(run, t, y);
    in = cardan_at(run, &t, y);
    status = cardan_call_model(run, &run->energy, &in, energies);
    *kinetic = energies[0];
    *total = energies[2];
    return status;
}

/* Residuals of the equations of a step for z. */
static int residual_of(cardan_run *run, const room *at, const problem *step, real *residual)
{
    const ptrdiff_t n = run->n, nx = run->nx, nq = run->nq;
    const real *base = step->base;
    real *middle = run->trial, *f = run->k + n, total = 0, kinetic = 0;
    int status;

    for (ptrdiff_t i = 0; i < n; i++)
        middle[i] = i < nx ? 0.5 * (base[i] + at->z[i]) : base[i];
    status = cardan_slope(run, step->t_new - 0.5 * step->h, middle, f);
    if (status != 0)
        return status;
    for (ptrdiff_t i = 0; i < nx; i++) {
        const real along = i >= nq && i < nq + run->nu ? at->z[nx] * middle[i] : 0;
        residual[i] = at->z[i] - base[i] - step->h * f[i] - along;
    }
    /* the energy counts where the step will end: with unit quaternions and closed circuits */
    for (ptrdiff_t i = 0; i < n; i++)
        at->end[i] = i < nx ? at->z[i] : base[i] + step->h * f[i];
    cardan_leave(run, at->end);
    cardan_normalize(run, at->end);
    status = cardan_close(run, step->t_new, at->end, 0);
    if (status == 0)
        status = energy_at(run, step->t_new, at->end, &total, &kinetic);
    at->kept[SIZE] = fabs(kinetic) + fabs(total - kinetic) + fabs(at->kept[ENERGY]);
    residual[nx] = (total - at->kept[ENERGY] - (work_of(run, at->end) - at->kept[WORK]))
                   / at->kept[SCALE];
    return status;
}

/* Size against which entry i of z counts: the largest of its block. */
static real size_of(const cardan_run *run, const room *at, const problem *step, ptrdiff_t i)
{
    const ptrdiff_t nq = run->nq, nx = run->nx;
    const ptrdiff_t from = i < nq ? 0 : i < nq + run->nu ? nq : nq + run->nu;
    const ptrdiff_t to = i < nq ? nq : i < nq + run->nu ? nq + run->nu : nx;
    real largest = i == nx;

    for (ptrdiff_t j = from; j < to && i < nx; j++)
        largest = fmax(largest, fmax(fabs(at->z[j]), fabs(step->h * run->k[j])));
    return largest > 0 ? largest : 1;
}

/* Matrix of the equations by differences at z, beside a unit matrix. */
static int differences(cardan_run *run, const room *at, const problem *step)
{
    const ptrdiff_t size = at->size;
    int status = residual_of(run, at, step, at->residual);

    for (ptrdiff_t j = 0; j < size && status == 0; j++) {
        const real kept = at->z[j], shift = SHIFT * size_of(run, at, step, j);
        at->z[j] += shift;
        status = residual_of(run, at, step, at->image);
        for (ptrdiff_t i = 0; i < size; i++) {
            at->matrix[i * 2 * size + j] = (at->image[i] - at->residual[i]) / (at->z[j] - kept);
            at->matrix[i * 2 * size + size + j] = i == j;
        }
        at->z[j] = kept;
    }
    return status;
}

/* The inverse by elimination with pivots. At rest no mu changes the energy: it is 0 then. */
static void invert(const room *at)
{
    const ptrdiff_t size = at->size, width = 2 * size;
    real *a = at->matrix;

    for (ptrdiff_t k = 0; k < size; k++) {
        ptrdiff_t pivot = k;
        for (ptrdiff_t i = k + 1; i < size; i++)
            if (fabs(a[i * width + k]) > fabs(a[pivot * width + k]))
                pivot = i;
        if (!(fabs(a[pivot * width + k]) > DBL_EPSILON))
            a[pivot * width + k] = 1;
        for (ptrdiff_t j = 0; j < width; j++) {
            const real kept = a[k * width + j];
            a[k * width + j] = a[pivot * width + j];
            a[pivot * width + j] = kept;
        }
        for (ptrdiff_t j = width - 1; j >= k; j--)
            a[k * width + j] /= a[k * width + k];
        for (ptrdiff_t i = 0; i < size; i++)
            for (ptrdiff_t j = width - 1; j >= k && i != k; j--)
                a[i * width + j] -= a[i * width + k] * a[k * width + j];
    }
    for (ptrdiff_t i = 0; i < size; i++)
        for (ptrdiff_t j = 0; j < size; j++)
            at->inverse[i * size + j] = a[i * width + size + j];
    at->kept[INVERTED] = 1;
}

/* The first guess of z by the derivative at the start, and that in the middle of the last step if
 * no trial has taken its place yet. */
static void predict(const cardan_run *run, const room *at, const problem *step, int untried)
{
    const real *first = run->k, *before = run->k + run->n;

    for (ptrdiff_t i = 0; i < run->nx; i++) {
        const real f = untried && run->in_segment > 0 ? 2 * first[i] - before[i] : first[i];
        at->z[i] = step->base[i] + step->h * f;
    }
    at->z[run->nx] = 0;
}

/* image = inverse v; returns the largest entry of x1 in it against the size of its block. */
static real apply(const cardan_run *run, const room *at, const problem *step, const real *v)
{
    const ptrdiff_t size = at->size;
    real largest = 0;

    for (ptrdiff_t i = 0; i < size; i++) {
        real sum = 0;
        for (ptrdiff_t j = 0; j < size; j++)
            sum += at->inverse[i * size + j] * v[j];
        at->image[i] = sum;
        if (i < run->nx)
            largest = fmax(largest, fabs(sum) / size_of(run, at, step, i));
    }
    return largest;
}

/* Broyden's update: what `change` did to the residual, whose image stands in `image`. */
static void learn(const room *at)
{
    const ptrdiff_t size = at->size;
    real product = 0;

    for (ptrdiff_t i = 0; i < size; i++)
        product += at->change[i] * (at->change[i] + at->image[i]);
    if (product == 0)
        return;
    for (ptrdiff_t j = 0; j < size; j++) {
        real along = 0;
        for (ptrdiff_t i = 0; i < size; i++)
            along += at->change[i] * at->inverse[i * size + j];
        for (ptrdiff_t i = 0; i < size; i++)
            at->inverse[i * size + j] -= at->image[i] * along / product;
    }
}

/* Iterate from the first guess. Returns 0, CARDAN_UNSOLVED or why a residual has no value. */
static int iterate(cardan_run *run, const room *at, const problem *step)
{
    real last = INFINITY, before = INFINITY;
    int status = residual_of(run, at, step, at->residual);

    for (int k = 0; k < MOST && status == 0; k++) {
        real size = apply(run, at, step, at->residual);
        const real missing = fabs(at->residual[run->nx] * at->kept[SCALE]);

        /* rounding is all there is; what it leaves of the energy is sought by the next step */
        if ((size <= SOUGHT || (size <= SOLVED && size > 0.3 * last))
            && (missing <= BALANCED * at->kept[SIZE] || missing > 0.3 * before))
            return 0;
        if (!(size < 1e3) || (k > 4 && size > 2 * last && size > SOLVED))
            return CARDAN_UNSOLVED;
        last = size;
        before = missing;
        for (ptrdiff_t i = 0; i < at->size; i++) {
            at->change[i] = -at->image[i];
            at->z[i] += at->change[i];
        }
        status = residual_of(run, at, step, at->residual);
        if (status == 0 && size > LEARNT) {
            (void)apply(run, at, step, at->residual);
            learn(at);
        }
    }
    return status == 0 ? CARDAN_UNSOLVED : status;
}

/* Newton steps with a matrix of their own each, shortened until the next correction is smaller.
 *
 * They come near a solution from farther away; then `iterate` goes on. Returns 0 or a status.
 */
static int approach(cardan_run *run, const room *at, const problem *step)
{
    int status = 0;

    for (int k = 0; k < MOST; k++) {
        real size, next = INFINITY, share = 1;
        status = differences(run, at, step);
        if (status != 0)
            return status;
        invert(at);
        size = apply(run, at, step, at->residual);
        if (size < NEAR)
            return 0;
        for (ptrdiff_t i = 0; i < at->size; i++)
            at->change[i] = -at->image[i];
        for (; share > 1e-3 && !(next < (1 - 0.25 * share) * size); share *= 0.5) {
            for (ptrdiff_t i = 0; i < at->size; i++)
                at->z[i] += share * at->change[i];
            status = residual_of(run, at, step, at->residual);
            next = status == 0 ? apply(run, at, step, at->residual) : INFINITY;
            if (!(next < (1 - 0.25 * share) * size))
                for (ptrdiff_t i = 0; i < at->size; i++)
                    at->z[i] -= share * at->change[i];
        }
        if (!(next < size))
            return status == 0 ? CARDAN_UNSOLVED : status;
    }
    return CARDAN_UNSOLVED;
}

/* Energy and work at the start of a segment, which all its steps refer to. */
static int begin(cardan_run *run, const room *at)
{
    real total = 0, kinetic = 0;
    int status = energy_at(run, run->t, run->y, &total, &kinetic);

    at->kept[ENERGY] = total;
    at->kept[WORK] = work_of(run, run->y);
    at->kept[SCALE] = fmax(kinetic, 1e-3 * fabs(total));
    if (!(at->kept[SCALE] > 0))
        at->kept[SCALE] = 1;
    at->kept[INVERTED] = 0;
    return status;
}

/* Solve a step, from better and better beginnings. */
static int solve(cardan_run *run, const room *at, const problem *step, int untried)
{
    int status = CARDAN_UNSOLVED;

    for (int k = 0; k <= FRESH && status != 0; k++) {
        predict(run, at, step, untried && k == 0);
        status = 0;
        if (k == FRESH)
            status = approach(run, at, step);
        else if (at->kept[INVERTED] == 0) {
            status = differences(run, at, step);
            if (status == 0)
                invert(at);
        }
        if (status == 0)
            status = iterate(run, at, step);
        at->kept[INVERTED] = status == 0;
    }
    return status;
}

/* One step from t, y; half of it, a quarter, ... where the equations have no solution near by. */
int cardan_midpoint_step(cardan_run *run)
{
    const room at = room_of(run);
    const real whole = cardan_grid(run) - run->t;
    problem step = {run->y, whole, run->t + whole};
    int status = cardan_refresh(run);

    run->culprit = -1;
    if (status == 0 && run->in_segment == 0)
        status = begin(run, &at);
    if (status != 0)
        return status;
    step.base = cardan_enter(run, run->y, run->f, run->k);
    for (int part = 1; part <= SHORTEST; part *= 2) {
        step.t_new = part == 1 ? cardan_grid(run) : run->t + whole / part;
        step.h = step.t_new - run->t;
        status = solve(run, &at, &step, part == 1);
        if (status == 0) {
            for (ptrdiff_t i = 0; i < run->n; i++)
                run->trial[i] = at.end[i];
            status = cardan_commit(run, step.t_new, run->trial);
        }
        if (status == 0)
            return 0;
        run->rejections++;
    }
    return status;
}

/* Cubic through values and derivatives at both ends of the last step. */
int cardan_midpoint_dense(cardan_run *run)
{
    cardan_hermite(run, run->k, run->k + 2 * run->n);
    run->is_dense = 1;
    return 0;
}
