/* Stages of the Radau IIA method over elements, as rates of the state: see stages.c.
 *
 * Part of cardan. Caller owns all memory.
 *
 * The matrix of the stages is never made. Systems with it are solved by iterations
 *
 *     x += P^-1 (b - (I - h A J) x),  P = I - h A J0
 *
 * with one J0 for all stages, that at the middle one. By the eigenvalues of A, P is a real and a
 * complex system, and these are those of a step of the method itself: with c = 1 / s
 *
 *     s dq - du = a,  s du - du' = b  =>  [M + c C + c^2 K, G^T; G + c R, H] du = [c M b - c^2 K a; c G b]
 *
 * where changes of axes within the step are left out, which costs iterations and no accuracy.
 * Source: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.8.
 */
#include "stages_elements.h"
#include <float.h>
#include <math.h>
#include <string.h>

enum { MOST = 60, STAGES = 3 };
/* corrections of entries, of the largest one of their block, that count as rounding */
static const real ROUNDING = 64 * DBL_EPSILON;
/* what may be left where rounding keeps corrections from shrinking further */
static const real STUCK = 1e-6;

ptrdiff_t cardan_element_stages_length(const cardan_run *run)
{
    cardan_element_stages at = {0};

    return cardan_element_stages_lay(run, NULL, &at);
}

/* The largest correction (3, nx) of an entry, of the largest entry of its block in x. */
static real size_of(const cardan_run *run, const real *correction, const real *x)
{
    const ptrdiff_t nx = run->nx, ends[4] = {0, run->nq, run->nq + run->nu, nx};
    real largest = 0;

    for (int block = 0; block < 3; block++) {
        real most = 0, size = 0;
        for (ptrdiff_t s = 0; s < STAGES; s++)
            for (ptrdiff_t i = s * nx + ends[block]; i < s * nx + ends[block + 1]; i++) {
                most = fmax(most, fabs(correction[i]));
                size = fmax(size, fabs(x[i]));
                if (!(correction[i] - correction[i] == 0))
                    return INFINITY;
            }
        largest = fmax(largest, size > 0 ? most / size : most);
    }
    return largest;
}

/* Whether corrections are over: 1, or CARDAN_UNSOLVED where they grow. */
static int settled(real size, real *last)
{
    const int done = size <= ROUNDING || (size <= STUCK && size > 0.5 * *last);

    if (!done && !(size < 4 * *last))
        return CARDAN_UNSOLVED;
    *last = size;
    return done;
}

/* First slopes from states at both ends: of speeds the mean, of coordinates those of the cubic polynomial
 * with their rates at the ends, as positions that leave gaps may have no accelerations. */
static void guess(const cardan_steps *steps, const cardan_element_stages *at, real h, const real *y, const real *next)
{
    const cardan_run *run = steps->run;
    const ptrdiff_t nq = run->nq, nx = run->nx;
    real *first = at->missing, *last = at->missing + nx;

    cardan_element_rates(at->mesh, y, y + nq, first);
    cardan_element_rates(at->mesh, next, next + nq, last);
    for (ptrdiff_t s = 0; s < STAGES; s++)
        for (ptrdiff_t i = 0; i < nx; i++) {
            const real c = steps->nodes[s], mean = (next[i] - y[i]) / h;
            real *slope = steps->slopes + s * nx + i;
            *slope = mean;
            if (i < nq)
                *slope = (1 - c) * (1 - 3 * c) * first[i] + c * (3 * c - 2) * last[i] + 6 * c * (1 - c) * mean;
        }
}

int cardan_element_stages_solve(const cardan_steps *steps, ptrdiff_t k)
{
    const cardan_run *run = steps->run;
    const ptrdiff_t width = cardan_row_width(run), nx = run->nx;
    const real *row = steps->rows + k * width, *y = row + 1, *next = row + width + 1;
    const real t = row[0], h = row[width] - t;
    real last = INFINITY;
    cardan_element_stages at = {0};
    int status;

    (void)cardan_element_stages_lay(run, steps->system, &at);
    guess(steps, &at, h, y, next);
    cardan_stage_states(steps, h, y);
    /* as far as corrections shrink, with the factors at the stage in the middle */
    status = cardan_element_stages_factor(steps, &at, t + steps->nodes[1] * h, h, steps->states + nx);
    for (int n = 0; n < MOST && status == 0; n++) {
        cardan_stage_states(steps, h, y);
        for (ptrdiff_t s = 0; s < STAGES && status == 0; s++)
            status = cardan_rates_at(steps, t + steps->nodes[s] * h, steps->states + s * nx,
                                     at.missing + s * nx);
        if (status != 0)
            return status;
        for (ptrdiff_t i = 0; i < STAGES * nx; i++)
            at.missing[i] -= steps->slopes[i];
        cardan_element_stages_precondition(steps, &at, 0, at.missing);
        for (ptrdiff_t i = 0; i < STAGES * nx; i++)
            steps->slopes[i] += at.missing[i];
        status = settled(size_of(run, at.missing, steps->slopes), &last);
    }
    if (status == 1)
        cardan_stage_states(steps, h, y);
    return status == 1 ? 0 : status == 0 ? CARDAN_UNSOLVED : status;
}

/* out (3, nx) = A x, or A^T x, over the stages, times a factor. */
static void combine(const cardan_steps *steps, int transposed, real factor, const real *x, real *out)
{
    const ptrdiff_t nx = steps->run->nx;

    for (ptrdiff_t i = 0; i < STAGES * nx; i++) {
        const ptrdiff_t s = i / nx;
        real sum = 0;
        for (ptrdiff_t j = 0; j < STAGES; j++)
            sum += steps->matrix[transposed ? j * STAGES + s : s * STAGES + j] * x[j * nx + i % nx];
        out[i] = factor * sum;
    }
}

int cardan_element_stages_refine(const cardan_steps *steps, int transposed, real *x,
                                 cardan_stage_product *product, const void *context)
{
    const cardan_run *run = steps->run;
    const ptrdiff_t size = STAGES * run->nx;
    real *b = steps->open, last = INFINITY;
    cardan_element_stages at = {0};
    int status = 0;

    (void)cardan_element_stages_lay(run, steps->system, &at);
    memcpy(b, x, (size_t)size * sizeof(real));
    cardan_element_stages_precondition(steps, &at, transposed, x);
    for (int n = 0; n < MOST && status == 0; n++) {
        /* the Jacobian of a stage is that of its own equation: it comes last, transposed first */
        if (!transposed)
            combine(steps, 0, *at.h, x, at.missing);
        if (product(context, transposed ? x : at.missing, at.applied) != 0)
            return CARDAN_MODEL;
        if (transposed) {
            combine(steps, 1, *at.h, at.applied, at.missing);
            memcpy(at.applied, at.missing, (size_t)size * sizeof(real));
        }
        for (ptrdiff_t i = 0; i < size; i++)
            at.missing[i] = b[i] - x[i] + at.applied[i];
        cardan_element_stages_precondition(steps, &at, transposed, at.missing);
        for (ptrdiff_t i = 0; i < size; i++)
            x[i] += at.missing[i];
        status = settled(size_of(run, at.missing, x), &last);
    }
    return status == 1 ? 0 : status == 0 ? CARDAN_UNSOLVED : status;
}
