/* The equations of a step of the energy-keeping midpoint rule: see midpoint.c.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Broyden's method from an inverse matrix that is kept from step to step, and made anew from
 * differences where it no longer leads to the solution; from far away damped Newton steps first.
 * Source: C. T. Kelley, Iterative Methods for Linear and Nonlinear Equations, chapters 5, 7 and 8.
 */
#include "midpoint.h"
#include <math.h>

static const real SOUGHT = 4e-15; /* corrections relative to the size of their block */
static const real NEAR = 1e-3;   /* from here on Broyden leads on */
static const real LEARNT = 1e-10; /* smaller corrections are too noisy to learn from */
static const real FAINT = 1e-9;  /* roundings of the energy against that of motion */
static const real MOTIONLESS = 1e-6; /* of coordinates, what motions at rest may change in a step */
static const real SHIFT = 1.5e-8; /* of differences, relative: the root of a rounding */
enum {
    MOST = 25,    /* iterations */
    PATIENT = 12, /* of them before more roundings are accepted */
    FRESH = 2     /* matrices made for one step */
};

/* What roundings leave: of a correction, relative to its block, and of the energy. */
typedef struct rounding {
    real size, missing;
} rounding;

/* Speeds below which a motion is at rest: what is left of them where forces cancel are roundings. */
static real slowest(const cardan_run *run, const room *at, const problem *step)
{
    real largest = 0;

    for (ptrdiff_t i = 0; i < run->nq; i++)
        largest = fmax(largest, fabs(at->z[i]));
    return fmax(at->memory[FASTEST], MOTIONLESS * largest / fabs(step->h));
}

/* Size against which entry i of z counts: the largest of its block. */
static real size_of(const cardan_run *run, const room *at, const problem *step, ptrdiff_t i)
{
    const ptrdiff_t nq = run->nq, nx = run->nx;
    const ptrdiff_t from = i < nq ? 0 : i < nq + run->nu ? nq : nq + run->nu;
    const ptrdiff_t to = i < nq ? nq : i < nq + run->nu ? nq + run->nu : nx;
    real largest = from == nq && i < nx ? slowest(run, at, step) : i == nx;

    for (ptrdiff_t j = from; j < to && i < nx; j++)
        largest = fmax(largest, fmax(fabs(at->z[j]), fabs(step->h * run->k[j])));
    return largest > 0 ? largest : 1;
}

/* Matrix of the equations by differences at z, beside a unit matrix. */
static int differences(cardan_run *run, const room *at, problem *step)
{
    const ptrdiff_t size = at->size;
    int status = cardan_midpoint_residual(run, at, step, at->residual);

    run->jacobians++;
    for (ptrdiff_t j = 0; j < size && status == 0; j++) {
        const real memory = at->z[j], shift = SHIFT * size_of(run, at, step, j);
        at->z[j] += shift;
        status = cardan_midpoint_residual(run, at, step, at->image);
        for (ptrdiff_t i = 0; i < size; i++) {
            at->matrix[i * 2 * size + j] = (at->image[i] - at->residual[i]) / (at->z[j] - memory);
            at->matrix[i * 2 * size + size + j] = i == j;
        }
        at->z[j] = memory;
    }
    return status;
}

/* The inverse by elimination with pivots. */
static void invert(cardan_run *run, const room *at)
{
    const ptrdiff_t size = at->size, width = 2 * size;
    real *a = at->matrix;

    run->factorizations++;
    for (ptrdiff_t k = 0; k < size; k++) {
        ptrdiff_t pivot = k;
        for (ptrdiff_t i = k + 1; i < size; i++)
            if (fabs(a[i * width + k]) > fabs(a[pivot * width + k]))
                pivot = i;
        if (!(fabs(a[pivot * width + k]) > DBL_EPSILON))
            a[pivot * width + k] = 1;
        for (ptrdiff_t j = 0; j < width; j++) {
            const real memory = a[k * width + j];
            a[k * width + j] = a[pivot * width + j];
            a[pivot * width + j] = memory;
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
    at->memory[INVERTED] = 1;
}

/* d and the size of speeds from the first guess of x1; d keeps its side from step to step. */
static void aim(const cardan_run *run, const room *at, problem *step)
{
    const real *u0 = step->base + run->nq, *u1 = at->z + run->nq;
    real square = 0, first = 0, last = 0, before = 0;

    for (ptrdiff_t i = 0; i < run->nu; i++) {
        const real middle = 0.5 * (u0[i] + u1[i]);
        square += middle * middle;
        first += u0[i] * u0[i];
        last += u1[i] * u1[i];
        before += middle * at->direction[i];
    }
    step->speed = fmax(sqrt(fmax(first, last)), slowest(run, at, step));
    for (ptrdiff_t i = 0; i < run->nu; i++)
        at->direction[i] =
            square > 0 ? copysign(1 / sqrt(square), before) * 0.5 * (u0[i] + u1[i]) : 0;
}

/* The first guess of z by the derivative at the start, and that in the middle of the last step if
 * no trial has taken its place yet. */
static void predict(const cardan_run *run, const room *at, problem *step, int untried)
{
    const real *first = run->k, *before = run->k + run->n;

    for (ptrdiff_t i = 0; i < run->nx; i++) {
        const real f = untried && run->in_segment > 0 ? 2 * first[i] - before[i] : first[i];
        at->z[i] = step->base[i] + step->h * f;
    }
    at->z[run->nx] = 0;
    aim(run, at, step);
}

/* image = inverse v; returns the largest entry of x1 in it against the size of its block, and blames
 * it. */
static real apply(cardan_run *run, const room *at, const problem *step, const real *v)
{
    const ptrdiff_t size = at->size;
    real largest = 0;

    for (ptrdiff_t i = 0; i < size; i++) {
        real sum = 0, part;
        for (ptrdiff_t j = 0; j < size; j++)
            sum += at->inverse[i * size + j] * v[j];
        at->image[i] = sum;
        part = i < run->nx ? fabs(sum) / size_of(run, at, step, i) : 0;
        if (part > largest) {
            largest = part;
            run->culprit = i;
        }
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

/* Of the energy: what counts as balanced. */
static real noise_of(const room *at)
{
    return BALANCED * at->memory[SIZE] + at->memory[NOISE];
}

/* The correction that is left, as `apply`; `energy_fixed`: of x1 alone, with the nu that there is. */
static real correction(cardan_run *run, const room *at, const problem *step, int energy_fixed)
{
    const ptrdiff_t last = at->size - 1;
    const real *row = at->inverse + last * at->size, memory = at->residual[last];
    real size;

    if (energy_fixed && row[last] != 0) {
        real sum = 0;
        for (ptrdiff_t j = 0; j < last; j++)
            sum += row[j] * at->residual[j];
        at->residual[last] = -sum / row[last];
    }
    size = apply(run, at, step, at->residual);
    at->residual[last] = memory;
    return size;
}

/* What a few roundings of z, up and down, do to the equations; everything else stays as it is. */
static int shaken(cardan_run *run, const room *at, problem *step, rounding *left)
{
    const real missing = step->missing;
    int status;

    for (ptrdiff_t i = 0; i < at->size; i++) {
        at->change[i] = at->z[i];
        at->z[i] += (i % 2 == 0 ? 1 : -1) * BALANCED * size_of(run, at, step, i);
    }
    status = cardan_midpoint_residual(run, at, step, at->matrix);
    for (ptrdiff_t i = 0; i < at->size; i++) {
        at->z[i] = at->change[i];
        at->matrix[i] -= at->residual[i];
    }
    left->missing = fabs(step->missing - missing);
    left->size = status == 0 ? apply(run, at, step, at->matrix) : 0;
    /* the end of the step is that of z again */
    return status != 0 ? status : cardan_midpoint_residual(run, at, step, at->residual);
}

/* Iterate from the first guess. Returns 0, CARDAN_UNSOLVED or why a residual has no value.
 *
 * An energy that is balanced but for rounding asks for nothing: where the motion is slow, what it
 * rounds by would be large for the speeds. There nu stays 0 unless the solution with it misses some.
 */
static int iterate(cardan_run *run, const room *at, problem *step)
{
    real last = INFINITY, before = INFINITY;
    rounding left = {-1, 0};
    int status = cardan_midpoint_residual(run, at, step, at->residual);
    int slow_motion = noise_of(at) > FAINT * at->memory[KINETIC], energy_was_fixed = 0;

    for (int k = 0; k < MOST && status == 0; k++) {
        /* at rest no speed could bring or take energy */
        const real missing = step->motionless ? 0 : fabs(step->missing), noise = noise_of(at);
        const real most = k < PATIENT ? 10 : 100;
        const int energy_fixed = step->lever != 0 && (slow_motion || missing <= noise);
        real size = correction(run, at, step, energy_fixed);
        const int stuck = size > 0.3 * last && (energy_fixed || size > SOUGHT || missing > 0.3 * before);

        if (size <= SOUGHT && missing <= noise)
            return 0;
        if (stuck && left.size < 0 && size < NEAR) {
            status = shaken(run, at, step, &left);
            size = correction(run, at, step, energy_fixed);
        }
        /* rounding is all there is; what it leaves of the energy is sought by the next step */
        if (status == 0 && stuck && size <= fmax(SOUGHT, most * left.size)) {
            if (missing <= most * fmax(noise, left.missing))
                return 0;
            slow_motion = 0;
        }
        if (!(size < 1e3)
            || (k > 4 && energy_fixed == energy_was_fixed && size > 2 * last && size > most * left.size))
            return CARDAN_UNSOLVED;
        energy_was_fixed = energy_fixed;
        last = size;
        before = missing;
        for (ptrdiff_t i = 0; i < at->size; i++) {
            at->change[i] = -at->image[i];
            at->z[i] += at->change[i];
        }
        if (status == 0)
            status = cardan_midpoint_residual(run, at, step, at->residual);
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
static int approach(cardan_run *run, const room *at, problem *step)
{
    int status = 0;

    for (int k = 0; k < MOST; k++) {
        real size, next = INFINITY, share = 1;
        status = differences(run, at, step);
        if (status != 0)
            return status;
        invert(run, at);
        size = apply(run, at, step, at->residual);
        if (size < NEAR)
            return 0;
        for (ptrdiff_t i = 0; i < at->size; i++)
            at->change[i] = -at->image[i];
        for (; share > 1e-3 && !(next < (1 - 0.25 * share) * size); share *= 0.5) {
            for (ptrdiff_t i = 0; i < at->size; i++)
                at->z[i] += share * at->change[i];
            status = cardan_midpoint_residual(run, at, step, at->residual);
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

/* Solve a step, from better and better beginnings. */
int cardan_midpoint_solve(cardan_run *run, const room *at, problem *step, int untried)
{
    int status = CARDAN_UNSOLVED;

    for (int k = 0; k <= FRESH && status != 0; k++) {
        predict(run, at, step, untried && k == 0);
        status = 0;
        if (k == FRESH)
            status = approach(run, at, step);
        else if (at->memory[INVERTED] == 0) {
            status = differences(run, at, step);
            if (status == 0)
                invert(run, at);
        }
        if (status == 0)
            status = iterate(run, at, step);
        at->memory[INVERTED] = status == 0;
    }
    return status;
}
