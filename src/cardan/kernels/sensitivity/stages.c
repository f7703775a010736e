/* Stages of implicit Runge-Kutta methods, solved again: see steps.h.
 *
 * Part of cardan. Caller owns all memory.
 *
 *     k_i = f(t + c_i h, x_i),  x_i = y + h sum_j a_ij k_j, quaternions scaled to length 1
 *
 * A run solves these equations to a part of its tolerance. A derivative needs them solved to rounding:
 * it is that of the method itself. The matrix of the last Newton iteration is made at the solution, so
 * that its factors serve the derivatives: forward as they are, backward transposed.
 * Source: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.8.
 */
#include "linear.h"
#include "steps.h"
#include <float.h>
#include <math.h>

enum { MOST = 50 };
/* corrections that shrink less than this ask for a new matrix */
static const real SLOW = 0.1;
/* corrections relative to the slopes that count as rounding */
static const real ROUNDING = 32 * DBL_EPSILON;
/* what may be left where rounding of stiff rates keeps corrections from shrinking further */
static const real STUCK = 1e-6;

typedef struct rooms {
    ptrdiff_t nx, size; /* size: of all stages */
    real *matrix;       /* (size, size) and its factors */
    real *order;        /* (size) */
    real *jacobians;    /* (stages, nx, nx) at the stages */
    real *change;       /* (size) */
    real *by;           /* result of the Jacobian */
} rooms;

static ptrdiff_t lay(const cardan_run *run, ptrdiff_t stages, real *memory, rooms *at)
{
    const ptrdiff_t nx = run->nx, size = stages * nx;
    ptrdiff_t used = 0;

    at->nx = nx, at->size = size;
    at->matrix = cardan_reserve(memory, &used, size * size);
    at->order = cardan_reserve(memory, &used, size);
    at->jacobians = cardan_reserve(memory, &used, size * nx);
    at->change = cardan_reserve(memory, &used, size);
    at->by = cardan_reserve(memory, &used, nx * (nx + 1 + run->nr));
    return used;
}

ptrdiff_t cardan_stages_length(const cardan_run *run, ptrdiff_t stages)
{
    rooms at = {0};

    return run->mesh ? cardan_element_stages_length(run) : lay(run, stages, NULL, &at);
}

/* States of the stages of a step of size h from y, for their slopes. */
void cardan_stage_states(const cardan_steps *steps, real h, const real *y)
{
    const cardan_run *run = steps->run;
    const ptrdiff_t nx = run->nx;

    for (ptrdiff_t s = 0; s < steps->stages; s++) {
        const real *a = steps->matrix + s * steps->stages;
        real *x = steps->states + s * nx;
        for (ptrdiff_t i = 0; i < nx; i++) {
            real sum = 0;
            for (ptrdiff_t j = 0; j < steps->stages; j++)
                sum += a[j] * steps->slopes[j * nx + i];
            x[i] = y[i] + h * sum;
        }
        for (ptrdiff_t k = 0; k < run->quaternion_count; k++) {
            const real *q = x + run->quaternions[k];
            steps->lengths[s * run->quaternion_count + k] = sqrt(cardan_dot(q, q, 4));
        }
        cardan_normalize(run, x);
    }
}

/* Factors of I - h A J with the Jacobians at the stages. */
static int factor(const cardan_steps *steps, const rooms *at, real t, real h)
{
    const ptrdiff_t nx = at->nx, stages = steps->stages;

    for (ptrdiff_t s = 0; s < stages; s++) {
        const real time = t + steps->nodes[s] * h;
        cardan_in in = cardan_step_in(steps, &time, steps->states + s * nx);
        in.w = steps->jacobian.w;
        if (steps->jacobian.function(&in, at->by, steps->work) != 0)
            return CARDAN_MODEL;
        for (ptrdiff_t i = 0; i < nx; i++) {
            real *row = at->jacobians + (s * nx + i) * nx;
            for (ptrdiff_t j = 0; j < nx; j++)
                row[j] = at->by[i * nx + j];
            cardan_stage_lengths(steps, s, row);
        }
    }
    /* block (s, j): what the state of stage j adds to the equation of stage s */
    for (ptrdiff_t s = 0; s < stages; s++)
        for (ptrdiff_t j = 0; j < stages; j++) {
            const real share = h * steps->matrix[s * stages + j];
            for (ptrdiff_t i = 0; i < nx; i++) {
                const real *by = at->jacobians + (s * nx + i) * nx;
                real *row = at->matrix + (s * nx + i) * at->size + j * nx;
                for (ptrdiff_t k = 0; k < nx; k++)
                    row[k] = (s == j && i == k) - share * by[k];
            }
        }
    return cardan_factor(at->size, at->matrix, at->order) ? CARDAN_NOT_FINITE : 0;
}

/* One Newton iteration; `left` receives its largest correction, of the largest slope of its block. */
static int iterate(const cardan_steps *steps, const rooms *at, real t, real h, const real *y, real *left)
{
    const cardan_run *run = steps->run;
    const ptrdiff_t nx = at->nx, ends[4] = {0, run->nq, run->nq + run->nu, nx};
    real sizes[3] = {0, 0, 0};

    cardan_stage_states(steps, h, y);
    for (ptrdiff_t s = 0; s < steps->stages; s++)
        if (cardan_rates_at(steps, t + steps->nodes[s] * h, steps->states + s * nx,
                            at->change + s * nx)
            != 0)
            return CARDAN_MODEL;
    for (ptrdiff_t i = 0; i < at->size; i++)
        at->change[i] -= steps->slopes[i];
    cardan_substitute(at->size, at->matrix, at->order, at->change);
    *left = 0;
    /* rates of coordinates, speeds and internal states count against their own kind */
    for (int block = 0; block < 3; block++) {
        for (ptrdiff_t k = 0; k < at->size; k++)
            if (k % nx >= ends[block] && k % nx < ends[block + 1])
                sizes[block] = cardan_worst(sizes[block], fabs(steps->slopes[k] + at->change[k]));
        for (ptrdiff_t k = 0; k < at->size && sizes[block] != 0; k++)
            if (k % nx >= ends[block] && k % nx < ends[block + 1])
                *left = cardan_worst(*left, fabs(at->change[k]) / sizes[block]);
    }
    for (ptrdiff_t i = 0; i < at->size; i++)
        steps->slopes[i] += at->change[i];
    return *left - *left == 0 ? 0 : CARDAN_NOT_FINITE;
}

/* Solve for the stages of the step from row k, and factor their matrix there. Returns 0,
 * CARDAN_MODEL, CARDAN_NOT_FINITE, or CARDAN_UNSOLVED. */
static int solve_stages(const cardan_steps *steps, ptrdiff_t k)
{
    const ptrdiff_t width = cardan_row_width(steps->run);
    const real *row = steps->rows + k * width, *y = row + 1, *next = row + width + 1;
    const real t = row[0], h = row[width] - t;
    real left, last = INFINITY;
    rooms at = {0};
    int status;

    if (steps->run->mesh)
        return cardan_element_stages_solve(steps, k);
    (void)lay(steps->run, steps->stages, steps->system, &at);
    /* the mean slope is near enough: the step was short enough for a Newton method */
    for (ptrdiff_t i = 0; i < at.size; i++)
        steps->slopes[i] = (next[i % at.nx] - y[i % at.nx]) / h;
    cardan_stage_states(steps, h, y);
    status = factor(steps, &at, t, h);
    for (int n = 0; n < MOST && status == 0; n++, last = left) {
        status = iterate(steps, &at, t, h, y, &left);
        if (status != 0)
            return status;
        /* solved, or as far as rounding lets it */
        if (left <= ROUNDING || (left > 0.5 * last && left <= STUCK)) {
            cardan_stage_states(steps, h, y);
            return factor(steps, &at, t, h);
        }
        if (left > SLOW * last) {
            cardan_stage_states(steps, h, y);
            status = factor(steps, &at, t, h);
        }
    }
    return status != 0 ? status : CARDAN_UNSOLVED;
}

/* change (stages, nx): what slopes would change by if the states of stages did not follow becomes the
 * change with them. `product`: with the Jacobians. */
int cardan_stages_forward(const cardan_steps *steps, real *change, cardan_stage_product *product,
                          const void *context)
{
    rooms at = {0};

    if (steps->run->mesh)
        return cardan_element_stages_refine(steps, 0, change, product, context);
    (void)lay(steps->run, steps->stages, steps->system, &at);
    cardan_substitute(at.size, at.matrix, at.order, change);
    return 0;
}

/* weights (stages, nx): the gradient by slopes becomes that by the rates in their equations. `product`:
 * with the transposed Jacobians. */
static int pull_stages(const cardan_steps *steps, real *weights, cardan_stage_product *product,
                       const void *context)
{
    rooms at = {0};

    if (steps->run->mesh)
        return cardan_element_stages_refine(steps, 1, weights, product, context);
    (void)lay(steps->run, steps->stages, steps->system, &at);
    cardan_substitute_transposed(at.size, at.matrix, at.order, weights);
    return 0;
}

const cardan_coupled cardan_coupled_stages = {cardan_stages_length, solve_stages, pull_stages};
