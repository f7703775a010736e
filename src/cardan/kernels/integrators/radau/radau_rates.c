/* Stages of the Radau IIA method for x' = f(t, x).
 *
 * Part of cardan. Caller owns all memory. k stores the stage increments z.
 * Newton iterations on w = T^-1 z: T decouples them into a real system ALONE / h - J and a complex
 * one (REAL + i IMAG) / h - J, both nx by nx. The error estimate is filtered with the real factors.
 * Source: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., section IV.8.
 */
#include "radau.h"
#include "radau_tables.h"
#include "shift.h"
#include <float.h>
#include <math.h>

/* The parts of the memory. Behind them lie the real system, then the complex one. */
typedef struct parts {
    real *before;   /* (3, nx) rows of the dense output of the last step, to extrapolate */
    real *w, *g;     /* (3, nx) transformed increments w = T^-1 z, right-hand sides */
    real *error;     /* (nx) */
    real *state;     /* (n) */
    real *jacobian;
} parts;

static ptrdiff_t length(const cardan_run *run)
{
    return 10 * run->nx + run->n + cardan_jacobian_length(run) + cardan_shift_length(run, 0)
           + cardan_shift_length(run, 1);
}

static inline parts parts_of(const cardan_run *run)
{
    const ptrdiff_t nx = run->nx;
    parts mem;

    mem.before = cardan_radau_memory(run);
    mem.w = mem.before + 3 * nx;
    mem.g = mem.w + 3 * nx;
    mem.error = mem.g + 3 * nx;
    mem.state = mem.error + nx;
    mem.jacobian = mem.state + run->n;
    return mem;
}

static inline cardan_shift alone_of(const cardan_run *run, const parts *mem)
{
    return cardan_shift_in(run, mem->jacobian, mem->jacobian + cardan_jacobian_length(run), 0);
}

static inline cardan_shift pair_of(const cardan_run *run, const parts *mem)
{
    real *alone = mem->jacobian + cardan_jacobian_length(run);

    return cardan_shift_in(run, mem->jacobian, alone + cardan_shift_length(run, 0), 1);
}

/* Whether the pivots stored with the factors are valid indices (memory may come from a file). */
static int sound(const cardan_run *run)
{
    const parts mem = parts_of(run);
    const cardan_shift alone = alone_of(run, &mem), pair = pair_of(run, &mem);

    return cardan_shift_sound(&alone) && cardan_shift_sound(&pair);
}

static int begin(cardan_run *run)
{
    (void)run;
    return 0;
}

static int jacobian(cardan_run *run, real h)
{
    return cardan_jacobian(run, h, parts_of(run).jacobian);
}

/* Factor the real system ALONE / h - J and the complex system (REAL + i IMAG) / h - J. */
static int factor(cardan_run *run, real h)
{
    const parts mem = parts_of(run);
    const cardan_shift alone = alone_of(run, &mem), pair = pair_of(run, &mem);

    if (cardan_shift_factor(&alone, ALONE / h, 0) || cardan_shift_factor(&pair, REAL / h, IMAG / h))
        return CARDAN_NOT_FINITE;
    return 0;
}

/* Extrapolate the polynomial of the last step; zero without one. */
static int predict(cardan_run *run, real h, real ratio)
{
    const parts mem = parts_of(run);
    const ptrdiff_t n = run->n, nx = run->nx;

    (void)h;
    for (ptrdiff_t i = 0; i < nx; i++) {
        real z[3] = {0, 0, 0};
        for (int s = 0; s < 3 && ratio != 0; s++)
            z[s] = cardan_radau_beyond(mem.before, nx, i, NODES[s] * ratio);
        for (int s = 0; s < 3; s++) {
            run->k[s * n + i] = z[s];
            mem.w[s * nx + i] =
                T_INVERSE[s][0] * z[0] + T_INVERSE[s][1] * z[1] + T_INVERSE[s][2] * z[2];
        }
    }
    return 0;
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

    for (ptrdiff_t row = 0; row < rows; row++, v += nx)
        for (ptrdiff_t i = 0; i < nx; i++) {
            real x = v[i] / cardan_scale(run, run->y, i);
            sum += x * x;
        }
    return sqrt(sum / (real)(rows * (nx > 0 ? nx : 1)));
}

static real rounding(cardan_run *run, real h)
{
    (void)h;
    return 10 * DBL_EPSILON * norm(run, run->y, 1);
}

/* One simplified Newton iteration: updates w and z; `size` receives the norm of the update. */
static int iterate(cardan_run *run, real h, real *size)
{
    const parts mem = parts_of(run);
    const cardan_shift alone = alone_of(run, &mem), pair = pair_of(run, &mem);
    const ptrdiff_t n = run->n, nx = run->nx;
    real *g = mem.g, *w = mem.w, *k = run->k;
    int status = 0;

    for (int s = 0; s < 3 && status == 0; s++) {
        place(run, &mem, s);
        status = cardan_evaluate(run, run->t + NODES[s] * h, mem.state, g + s * nx, NULL);
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
    cardan_shift_solve(&alone, ALONE / h, 0, g, NULL);
    cardan_shift_solve(&pair, REAL / h, IMAG / h, g + nx, g + 2 * nx);
    *size = norm(run, g, 3);
    for (ptrdiff_t j = 0; j < 3 * nx; j++)
        w[j] += g[j];
    for (ptrdiff_t i = 0; i < nx; i++)
        for (int s = 0; s < 3; s++)
            k[s * n + i] = T[s][0] * w[i] + T[s][1] * w[nx + i] + T[s][2] * w[2 * nx + i];
    return 0;
}

/* Stiffly accurate: the last stage is the solution. */
static int end(cardan_run *run, real h)
{
    (void)h;
    for (ptrdiff_t i = 0; i < run->nx; i++)
        run->trial[i] = run->y[i] + run->k[2 * run->n + i];
    return 0;
}

/* (ALONE / h - J)^-1 (f + sum ERROR[i] z_i / h), the difference to the embedded formula, filtered so
 * that stiff components stay bounded. */
static int error_of(cardan_run *run, real h, int again, real *error)
{
    const parts mem = parts_of(run);
    const cardan_shift alone = alone_of(run, &mem);
    const ptrdiff_t n = run->n, nx = run->nx;
    const real *k = run->k;
    real sum = 0, worst = -1;
    int status = 0;

    if (again) {
        for (ptrdiff_t i = 0; i < nx; i++)
            mem.state[i] = run->y[i] + mem.error[i];
        cardan_normalize(run, mem.state);
        status = cardan_evaluate(run, run->t, mem.state, mem.g, NULL);
    }
    for (ptrdiff_t i = 0; i < nx; i++) {
        real lack = (ERROR[0] * k[i] + ERROR[1] * k[n + i] + ERROR[2] * k[2 * n + i]) / h;
        mem.error[i] = (again ? mem.g[i] : run->f[i]) + lack;
    }
    cardan_shift_solve(&alone, ALONE / h, 0, mem.error, NULL);
    for (ptrdiff_t i = 0; i < nx; i++) {
        real e = mem.error[i] / cardan_scale(run, run->trial, i);
        if (cardan_exceeds(e * e, worst)) {
            worst = e * e;
            run->culprit = i;
        }
        sum += e * e;
    }
    *error = sqrt(sum / (real)(nx > 0 ? nx : 1));
    return status;
}

static void remember(cardan_run *run)
{
    const parts mem = parts_of(run);
    const ptrdiff_t n = run->n, nx = run->nx;
    const real *k = run->k;

    for (ptrdiff_t i = 0; i < nx; i++)
        for (int m = 0; m < 3; m++)
            mem.before[m * nx + i] =
                DENSE[m][0] * k[i] + DENSE[m][1] * k[n + i] + DENSE[m][2] * k[2 * n + i];
}

const cardan_radau_form cardan_radau_rates = {length,  sound,   begin, jacobian, factor, predict,
                                              rounding, iterate, end,   error_of, remember, 1e-3, 0};
