/* Rosenbrock method Rodas5P: order 5, stiffly accurate, dense output of order 4, adaptive step.
 *
 * Part of cardan. Caller owns all memory; k holds the 8 stages u, and in place of energies the
 * powers at four points of the step; `own` the Jacobian and the factors of a step.
 * Source: G. Steinebach, BIT Numerical Mathematics 63 (2023), 27; E. Hairer, G. Wanner, Solving
 * Ordinary Differential Equations II, section IV.7.
 */
#include "rosenbrock_tables.h"
#include "shift.h"
#include <math.h>

/* the error of a step, of the embedded method of order 4, behaves like h^5 */
enum { ORDER = 5, STAGES = 8 };

static int init(cardan_run *run)
{
    return cardan_first_step(run, ORDER);
}

static ptrdiff_t length(const cardan_run *run)
{
    return cardan_jacobian_length(run) + run->n + cardan_shift_length(run, 0);
}

/* A state (n) to evaluate at, behind the Jacobian. */
static real *state_of(const cardan_run *run)
{
    return run->method_memory + cardan_jacobian_length(run);
}

/* y + sum A u for stage s, in `trial`: the last three add one stage each to the one before. */
static void place(const cardan_run *run, int s)
{
    const ptrdiff_t n = run->n;
    const real *k = run->k, *y = run->y;
    real *trial = run->trial;

    for (ptrdiff_t i = 0; i < run->nx; i++) {
        if (s < 6)
            trial[i] = y[i];
        for (int j = 0; j < s && s < 6; j++)
            trial[i] += A[s][j] * k[j * n + i];
        if (s >= 6)
            trial[i] += k[(s - 1) * n + i];
    }
}

/* The stages of a step of size h, and x at its end in `trial`. */
static int stages(cardan_run *run, real h)
{
    const ptrdiff_t n = run->n, nx = run->nx;
    const real *by_t = run->method_memory + nx * nx;
    const cardan_shift system = cardan_shift_in(run, run->method_memory, state_of(run) + n, 0);
    const real shift = 1 / (h * GAMMA);
    real *k = run->k, *state = state_of(run);
    int status = 0;

    run->factorizations++;
    if (cardan_shift_factor(&system, shift, 0))
        return CARDAN_NOT_FINITE;
    for (int s = 0; s < STAGES && status == 0; s++) {
        real *u = k + s * n;
        if (s > 0) {
            place(run, s);
            /* the sum goes on where it is; its quaternions are normalized in a copy */
            for (ptrdiff_t i = 0; i < nx; i++)
                state[i] = run->trial[i];
            cardan_normalize(run, state);
            status = cardan_evaluate(run, run->t + NODES[s] * h, state, u, NULL);
        }
        for (ptrdiff_t i = 0; i < nx; i++) {
            real sum = 0;
            for (int j = 0; j < s; j++)
                sum += C[s][j] * k[j * n + i];
            u[i] = (s > 0 ? u[i] : run->f[i]) + sum / h + h * SLOPES[s] * by_t[i];
        }
        cardan_shift_solve(&system, shift, 0, u, NULL);
    }
    place(run, STAGES);
    return status;
}

/* Rows 1, 2, ... of the dense output of x, entry i. */
static void rows_of(const cardan_run *run, ptrdiff_t i, real *row)
{
    const ptrdiff_t n = run->n;
    real sum[3];

    for (int m = 0; m < 3; m++) {
        sum[m] = 0;
        for (int s = 0; s < STAGES; s++)
            sum[m] += H[m][s] * run->k[s * n + i];
    }
    row[0] = sum[0];
    row[1] = sum[1] + sum[2];
    row[2] = -sum[2];
}

/* The energies at the end of the step, from the powers inside it. */
static int energies(cardan_run *run, real h)
{
    const ptrdiff_t n = run->n, nx = run->nx;
    real *k = run->k, *state = state_of(run);
    int status = 0;

    if (n == nx)
        return 0;
    for (ptrdiff_t e = nx; e < n; e++)
        k[e] = run->f[e];
    for (int p = 1; p < 4 && status == 0; p++) {
        const real theta = POINTS[p];
        for (ptrdiff_t i = 0; i < nx; i++) {
            real row[3];
            rows_of(run, i, row);
            state[i] = run->y[i] + theta * (run->trial[i] - run->y[i] + (1 - theta)
                       * (row[0] + theta * (row[1] + (1 - theta) * row[2])));
        }
        cardan_normalize(run, state);
        status = cardan_evaluate(run, run->t + theta * h, state, NULL, k + p * n + nx);
    }
    for (ptrdiff_t e = nx; e < n; e++) {
        run->trial[e] = run->y[e];
        for (int p = 0; p < 4; p++)
            run->trial[e] += h * ENERGY[0][p] * k[p * n + e];
    }
    return status;
}

/* Error of the trial in units of the tolerance: the last stage. */
static real error_of(cardan_run *run)
{
    const real *error = run->k + (STAGES - 1) * run->n;
    real sum = 0, worst = -1;

    for (ptrdiff_t i = 0; i < run->nx; i++) {
        real e = error[i] / cardan_scale(run, run->trial, i);
        if (cardan_exceeds(e * e, worst)) {
            worst = e * e;
            run->culprit = i;
        }
        sum += e * e;
    }
    return sqrt(sum / (real)(run->nx > 0 ? run->nx : 1));
}

/* One accepted step from t, y. */
static int step(cardan_run *run)
{
    int status = cardan_refresh(run);

    /* at the present state it serves every trial */
    if (status == 0)
        status = cardan_jacobian(run, run->h, run->method_memory);
    while (status == 0 && !run->stop) {
        real h, t_new, error = 0;
        int failed;

        status = cardan_trial_step(run, &h, &t_new);
        if (status != 0)
            return status;
        run->culprit = -1;
        failed = stages(run, h);
        if (failed == 0) {
            error = error_of(run);
            failed = error <= 1 ? energies(run, h) : 0;
        }
        if (failed == 0) {
            failed = error <= 1 ? cardan_commit(run, t_new, run->trial) : 0;
            failed = error - error == 0 ? failed : CARDAN_NOT_FINITE;
        }
        if (failed == 0 && error <= 1) {
            cardan_accept_step(run, h, fmax(error, run->correction), ORDER);
            return 0;
        }
        status = cardan_reject_step(run, h, error, ORDER, failed);
    }
    return status != 0 ? status : CARDAN_STOPPED;
}

/* Polynomial of degree 4 over the last step. */
static int dense(cardan_run *run)
{
    const ptrdiff_t n = run->n;
    const real h = run->t - run->t_old, *k = run->k;

    for (ptrdiff_t i = 0; i < n; i++) {
        real row[3] = {0, 0, 0};
        if (i < run->nx)
            rows_of(run, i, row);
        for (int m = 0; m < 3; m++) {
            for (int p = 0; p < 4 && i >= run->nx; p++)
                row[m] += h * ENERGY[m + 1][p] * k[p * n + i];
            run->interpolant[(m + 1) * n + i] = row[m];
        }
        run->interpolant[i] = run->y[i] - run->y_old[i];
    }
    run->is_dense = 1;
    return 0;
}

const cardan_method cardan_rosenbrock_method
    = {init, step, dense, length, NULL, 8, 4, NULL, 0};
