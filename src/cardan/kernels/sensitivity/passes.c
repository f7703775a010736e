/* Steps over places where branches of a motion meet, taken again: see singular_crossing.c.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Such a step is a collocation method whose stages are projected onto the constraints before rates are
 * asked at them. Stages, and derivatives through them, are found by sweeps, as the run does: the matrix
 * of the stages would be that of rates which are steep off the constraints.
 */
#include "gauss.h"
#include "steps.h"
#include <float.h>
#include <math.h>

enum { MOST = 100 };
static const real SAME = 1e-9; /* of a step: how far its end may be from a stop */
/* changes of the slopes that count as rounding; beside the place it is magnified */
static const real ROUNDING = 4 * DBL_EPSILON, STUCK = 1e-6;

/* The noted pass to which the step from row k belongs, -1 if it is none. */
ptrdiff_t cardan_pass_of(const cardan_steps *steps, ptrdiff_t k)
{
    const cardan_run *run = steps->run;
    const ptrdiff_t width = cardan_row_width(run);
    const real middle = 0.5 * (steps->rows[k * width] + steps->rows[(k + 1) * width]);

    for (ptrdiff_t i = 0; run->passes && i < run->pass_count && i < run->pass_capacity; i++) {
        const real part = (middle - run->passes[3 * i]) / run->passes[3 * i + 1];
        if (part > 0 && part < 1)
            return i;
    }
    return -1;
}

/* Whether sweeps whose last one changed something of a size by `change` need no further one. */
int cardan_swept_enough(real change, real size, real *last)
{
    const int enough
        = change <= ROUNDING * size || (change <= STUCK * size && change > 0.5 * *last);

    *last = change;
    return enough;
}

/* One sweep over the stages from y at t; `change` and `size` receive those of the slopes, times h. */
static int sweep(const cardan_pass *pass, real t, real h, const real *y, real *change, real *size)
{
    const cardan_steps *steps = &pass->steps;
    cardan_run *run = steps->run;
    const ptrdiff_t nx = run->nx;
    int status = 0;

    *change = *size = 0;
    for (ptrdiff_t s = 0; s < steps->stages && status == 0; s++) {
        real *x = steps->states + s * nx, *slope = steps->slopes + s * nx;
        for (ptrdiff_t i = 0; i < nx; i++) {
            real sum = 0;
            for (ptrdiff_t j = 0; j < steps->stages; j++)
                sum += steps->matrix[s * steps->stages + j] * steps->slopes[j * nx + i];
            x[i] = steps->open[s * nx + i] = y[i] + h * sum;
        }
        cardan_normalize(run, x);
        /* rates off the constraints would be magnified by the cube of the distance */
        status = cardan_close(run, t + steps->nodes[s] * h, x, 0);
        if (status == 0)
            status = cardan_rates_at(steps, t + steps->nodes[s] * h, x, steps->end);
        for (ptrdiff_t i = 0; i < nx; i++) {
            *change = cardan_worst(*change, fabs(h * (steps->end[i] - slope[i])));
            *size = fmax(*size, fmax(fabs(h * steps->end[i]), fabs(y[i])));
            slope[i] = steps->end[i];
        }
    }
    return status;
}

/* First and last row of the noted pass to which the step from row k belongs; 0 where it is not whole. */
static int rows_of(const cardan_steps *steps, const real *noted, ptrdiff_t k, cardan_pass *again)
{
    const ptrdiff_t width = cardan_row_width(steps->run);
    const real *rows = steps->rows;

    again->from = k;
    again->to = k + 1;
    while (again->from > 0 && (rows[again->from * width] - noted[0]) / noted[1] > 0)
        again->from--;
    while (again->to + 1 < steps->count && (rows[again->to * width] - noted[0]) / noted[1] < 1 - SAME)
        again->to++;
    return rows[again->from * width] == noted[0]
           && (rows[again->to * width] - noted[0]) / noted[1] >= 1 - SAME;
}

/* The noted pass to which the step from row k belongs, with stages and end as cardan_step_again gives
 * them. Returns CARDAN_CONSTRAINT_OPEN where an event lies in it or sweeps do not settle. */
int cardan_pass_again(const cardan_steps *steps, ptrdiff_t pass, ptrdiff_t k, cardan_pass *again)
{
    cardan_run *run = steps->run;
    const ptrdiff_t width = cardan_row_width(run);
    const real *noted = run->passes + 3 * pass, *row, *end;
    real h, change = 0, size = 0, last = INFINITY;
    gauss at = {0};

    if (!rows_of(steps, noted, k, again))
        return CARDAN_CONSTRAINT_OPEN;
    again->steps = *steps;
    /* the tables of the step, from its number of points */
    lay(&at, (ptrdiff_t)noted[2]);
    again->steps.kind = CARDAN_PASS;
    again->steps.stages = at.s;
    again->steps.nodes = again->nodes;
    again->steps.weights = again->weights;
    again->steps.matrix = again->matrix;
    for (ptrdiff_t s = 0; s < at.s; s++) {
        again->nodes[s] = at.points[s];
        again->weights[s] = at.weights[s];
        integral(at.points, at.s, 0, at.points[s], again->matrix + s * at.s);
    }
    row = steps->rows + again->from * width;
    end = steps->rows + again->to * width;
    h = end[0] - row[0];
    /* inputs and modes as within the step, then its stages from the mean slope on */
    cardan_enter_step(run, row, end);
    for (ptrdiff_t i = 0; i < at.s * run->nx; i++)
        steps->slopes[i] = (end[1 + i % run->nx] - row[1 + i % run->nx]) / h;
    for (int n = 0; n < MOST; n++) {
        const int status = sweep(again, row[0], h, row + 1, &change, &size);
        if (status != 0)
            return status;
        if (cardan_swept_enough(change, size, &last)) {
            cardan_end_step(&again->steps, row + 1, h, end + 1);
            return 0;
        }
    }
    return CARDAN_CONSTRAINT_OPEN;
}

/* Weights (stages) of the slopes in the state at a row within a pass. */
void cardan_pass_part(const cardan_pass *pass, ptrdiff_t row, real *weights)
{
    const ptrdiff_t width = cardan_row_width(pass->steps.run);
    const real *rows = pass->steps.rows, start = rows[pass->from * width];
    const real part = (rows[row * width] - start) / (rows[pass->to * width] - start);

    integral(pass->nodes, pass->steps.stages, 0, part, weights);
}
