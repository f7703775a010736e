/* Newton's iterations of the Radau IIA method over elements: see radau_elements.c.
 *
 * Part of cardan. Caller owns all memory.
 *
 * An iteration places the stages, takes one iteration of their internal states, finds what is missing
 * in all equations, and solves for updates of speeds and multipliers. Increments follow from the new
 * speeds, and last a shift of them closes what their gaps of positions will be.
 */
#include "mesh_states.h"
#include "radau_elements.h"
#include "radau_tables.h"
#include <math.h>
#include <string.h>

/* least determinant of a tangent of a rotation: it is 0 at a whole turn */
static const real SINGULAR = 0.1;

/* a (3, n) = B a with a matrix over the stages */
void cardan_radau_transform(const real B[3][3], ptrdiff_t n, real *a)
{
    for (ptrdiff_t i = 0; i < n; i++) {
        const real x = a[i], y = a[n + i], z = a[2 * n + i];
        for (int s = 0; s < 3; s++)
            a[s * n + i] = B[s][0] * x + B[s][1] * y + B[s][2] * z;
    }
}

/* T d' = u of a place that turns: d' of its rotation. Returns whether T can be inverted. */
static int unturned(const real *T, const real *u, real *rate)
{
    const real a = T[4] * T[8] - T[5] * T[7], b = T[5] * T[6] - T[3] * T[8],
               c = T[3] * T[7] - T[4] * T[6], det = T[0] * a + T[1] * b + T[2] * c;

    rate[0] = (a * u[0] + (T[2] * T[7] - T[1] * T[8]) * u[1] + (T[1] * T[5] - T[2] * T[4]) * u[2]) / det;
    rate[1] = (b * u[0] + (T[0] * T[8] - T[2] * T[6]) * u[1] + (T[2] * T[3] - T[0] * T[5]) * u[2]) / det;
    rate[2] = (c * u[0] + (T[1] * T[6] - T[0] * T[7]) * u[1] + (T[0] * T[4] - T[1] * T[3]) * u[2]) / det;
    return det > SINGULAR;
}

/* Rates (nu) of increments whose rotations have the tangents `maps` at speeds u; CARDAN_TOO_SMALL: the
 * rotations are too large for a step. */
static int chart_rates(const cardan_mesh *mesh, const real *maps, const real *u, real *rates)
{
    int regular = 1;

    for (ptrdiff_t place = 0; place < mesh->places; place++) {
        const ptrdiff_t first = mesh->u[place], n = mesh->u[place + 1] - first;
        for (ptrdiff_t i = n >= 3 ? 3 : 0; i < n; i++)
            rates[first + i] = u[first + i];
        if (n >= 3)
            regular &= unturned(maps + 9 * place, u + first, rates + first);
    }
    return regular ? 0 : CARDAN_TOO_SMALL;
}

/* State of a stage for its present increments; the tangents of its rotations. */
int cardan_radau_place(cardan_run *run, const cardan_radau_stages *v, int stage)
{
    const real *x = v->x + stage * v->width;
    real *state = v->states + stage * run->nx;

    run->model_status = cardan_mesh_move(v->mesh, run->y, v->d + stage * v->nu, state,
                                         v->maps + 9 * stage * v->mesh->places, v->alone.work);
    for (ptrdiff_t i = 0; i < v->nu + v->nz; i++)
        state[run->nq + i] = run->y[run->nq + i] + x[i];
    cardan_radau_turns(run, v, stage);
    return run->model_status == 0 ? 0 : CARDAN_MODEL;
}

/* One iteration of the internal states of all stages. */
static int settle(cardan_run *run, const cardan_radau_stages *v, real h)
{
    const ptrdiff_t nz = v->nz, width = v->width;
    const real square = REAL * REAL + IMAG * IMAG, c = h / ALONE, re = h * REAL / square,
               im = -h * IMAG / square;
    real *f = v->zdot, *w = v->w + v->nu;

    for (int s = 0; s < 3; s++) {
        const real t = run->t + NODES[s] * h;
        int status = cardan_inputs_at(run, t, v->states + s * run->nx);
        const cardan_state at = cardan_radau_state(run, &t, v->states + s * run->nx, NULL);
        if (status != 0)
            return status;
        run->model_status = cardan_mesh_zdot(v->mesh, &at, f + s * nz, v->alone.work);
        if (run->model_status != 0)
            return CARDAN_MODEL;
    }
    /* c f - w, by the eigenvalues of the Runge-Kutta matrix */
    cardan_radau_transform(T_INVERSE, nz, f);
    for (ptrdiff_t i = 0; i < nz; i++) {
        const real x = f[nz + i], y = f[2 * nz + i];
        f[i] = c * f[i] - w[i];
        f[nz + i] = re * x - im * y - w[width + i];
        f[2 * nz + i] = re * y + im * x - w[2 * width + i];
    }
    /* slopes of an element's own rates alone: the real system, then the complex one */
    cardan_mesh_states_solve(v->mesh, c, 0, v->change, v->slopes, f, NULL, v->block);
    cardan_mesh_states_solve(v->mesh, re, im, v->change, v->slopes, f + nz, f + 2 * nz, v->block);
    /* updates stay in `zdot`, for their norm */
    for (int s = 0; s < 3; s++)
        for (ptrdiff_t i = 0; i < nz; i++)
            w[s * width + i] += f[s * nz + i];
    cardan_radau_transform(T, nz, f);
    for (int s = 0; s < 3; s++)
        for (ptrdiff_t i = 0; i < nz; i++) {
            v->x[s * width + v->nu + i] += f[s * nz + i];
            v->states[s * run->nx + run->nq + v->nu + i] += f[s * nz + i];
        }
    return 0;
}

/* What is missing in the equations of all stages, and what d misses of its own. */
static int residuals(cardan_run *run, const cardan_radau_stages *v, real h)
{
    const ptrdiff_t nu = v->nu, width = v->width, rows = nu + v->mesh->mp + v->m;
    const real *w = v->w;
    real *lam = v->padded;
    int status = 0;

    for (int s = 0; s < 3 && status == 0; s++) {
        const real t = run->t + NODES[s] * h, *state = v->states + s * run->nx;
        cardan_state at;

        /* accelerations: derivatives of the collocation polynomial */
        for (ptrdiff_t i = 0; i < nu; i++) {
            const real one = w[width + i], two = w[2 * width + i];
            v->udot[i] = (T[s][0] * ALONE * w[i] + T[s][1] * (REAL * one - IMAG * two)
                          + T[s][2] * (REAL * two + IMAG * one)) / h;
        }
        for (ptrdiff_t k = 0; k < v->m; k++)
            lam[k] = v->lam[k] + v->x[s * width + nu + v->nz + k];
        status = cardan_inputs_at(run, t, state);
        if (status != 0)
            return status;
        at = cardan_radau_state(run, &t, state, lam);
        at.udot = v->udot;
        run->evaluations++;
        run->model_status =
            cardan_mesh_balance(v->mesh, &at, v->residual + s * rows, v->alone.work);
        if (run->model_status != 0)
            return CARDAN_MODEL;
        status = chart_rates(v->mesh, v->maps + 9 * s * v->mesh->places,
                                          state + run->nq, v->rates + s * nu);
    }
    /* d is off by what its tangents have changed since its last update */
    for (int s = 0; s < 3; s++)
        for (ptrdiff_t i = 0; i < nu; i++) {
            real sum = v->shift[s * nu + i] - v->d[s * nu + i];
            for (int j = 0; j < 3; j++)
                sum += h * A[s][j] * v->rates[j * nu + i];
            v->kinematic[s * nu + i] = sum;
        }
    return status;
}

/* product (n) = a matrix times a vector of speeds */
static const real *times(const cardan_radau_stages *v, int power, const real *speeds, int room)
{
    const ptrdiff_t n = v->mesh->plan->n;
    real *x = v->padded, *y = v->product + room * n;

    for (ptrdiff_t i = 0; i < n; i++)
        x[i] = i < v->nu ? speeds[i] : 0;
    cardan_sparse_multiply(v->mesh->plan, v->powers[power], x, y);
    return y;
}

/* The real system for the transformed residual (nu + m) and what d misses (nu): updates of speeds and
 * multipliers in place of the residual. */
static int solve_alone(const cardan_radau_stages *v, real c, real *speeds, real *multipliers,
                       const real *missed)
{
    const ptrdiff_t *unknown = v->mesh->unknown;
    cardan_mesh_system system = v->alone;
    const real *stiff = times(v, 2, missed, 0), *rates = times(v, 1, missed, 1);
    int status;

    for (ptrdiff_t i = 0; i < v->nu; i++)
        system.right[i] = -c * c * (speeds[i] + stiff[i]);
    for (ptrdiff_t k = 0; k < v->m; k++)
        system.right[unknown[k]] = -c * (multipliers[k] + rates[unknown[k]]);
    status = cardan_mesh_solve(v->mesh, &system);
    for (ptrdiff_t i = 0; i < v->nu; i++)
        speeds[i] = system.solution[i] / c;
    for (ptrdiff_t k = 0; k < v->m; k++)
        multipliers[k] = -system.solution[unknown[k]] / (c * c);
    return status;
}

/* The same of the complex system, for real and imaginary parts one behind the other. */
static int solve_pair(const cardan_radau_stages *v, real re, real im, real *speeds, real *imaginary,
                      real *multipliers, real *imaginary_multipliers, const real *missed)
{
    const real re2 = re * re - im * im, im2 = 2 * re * im;
    const real size = re * re + im * im;
    const ptrdiff_t nu = v->nu, *unknown = v->mesh->unknown;
    cardan_mesh_system system = v->pair;
    const real *one = times(v, 2, missed, 0), *two = times(v, 2, missed + nu, 1);
    int status;

    /* -c^2 (b + K missed), as the product of complex numbers */
    for (ptrdiff_t i = 0; i < nu; i++) {
        const real x = speeds[i] + one[i], y = imaginary[i] + two[i];
        system.right[2 * i] = -re2 * x + im2 * y;
        system.right[2 * i + 1] = -re2 * y - im2 * x;
    }
    /* -c (rates + R missed) of the constraints */
    one = times(v, 1, missed, 0), two = times(v, 1, missed + nu, 1);
    for (ptrdiff_t k = 0; k < v->m; k++) {
        const ptrdiff_t j = unknown[k];
        const real x = multipliers[k] + one[j], y = imaginary_multipliers[k] + two[j];
        system.right[2 * j] = -re * x + im * y;
        system.right[2 * j + 1] = -re * y - im * x;
    }
    status = cardan_mesh_solve(&v->doubled, &system);
    /* unknowns were c du and -c^2 dlam */
    for (ptrdiff_t i = 0; i < nu; i++) {
        const real x = system.solution[2 * i], y = system.solution[2 * i + 1];
        speeds[i] = (re * x + im * y) / size;
        imaginary[i] = (re * y - im * x) / size;
    }
    for (ptrdiff_t k = 0; k < v->m; k++) {
        const ptrdiff_t j = unknown[k];
        const real x = system.solution[2 * j], y = system.solution[2 * j + 1];
        multipliers[k] = -(re2 * x + im2 * y) / (size * size);
        imaginary_multipliers[k] = -(re2 * y - im2 * x) / (size * size);
    }
    return status;
}

/* New increments d of a stage, `change` (nu) what that changes, and its shift, which takes the gap
 * of positions that will be left. */
static int close_stage(const cardan_radau_stages *v, int stage, real *change)
{
    const ptrdiff_t nu = v->nu, mp = v->mesh->mp, *unknown = v->mesh->unknown;
    const real *gaps = v->gaps + stage * mp;
    real *d = v->d + stage * nu, *shift = v->shift + stage * nu;
    cardan_mesh_system system = v->alone;
    int status = 0;

    if (mp > 0) {
        real *body_axes = v->udot;
        memcpy(body_axes, change, (size_t)nu * sizeof(real));
        cardan_radau_backward(v, stage, body_axes);
        const real *closing = times(v, 0, body_axes, 0);
        for (ptrdiff_t i = 0; i < nu; i++)
            system.right[i] = 0;
        for (ptrdiff_t k = 0; k < v->m; k++)
            system.right[unknown[k]] = k < mp ? -gaps[k] - closing[unknown[k]] : 0;
        status = cardan_mesh_solve(v->mesh, &system);
        cardan_radau_forward(v, stage, system.solution);
        for (ptrdiff_t i = 0; i < nu; i++) {
            shift[i] += system.solution[i];
            change[i] += system.solution[i];
        }
    }
    for (ptrdiff_t i = 0; i < nu; i++)
        d[i] += change[i];
    return status;
}

/* Updates of speeds and multipliers of all stages, in place of their residuals. */
static int solve(const cardan_radau_stages *v, real h)
{
    const ptrdiff_t nu = v->nu, mp = v->mesh->mp, rows = nu + mp + v->m;
    const real square = REAL * REAL + IMAG * IMAG;
    real *b = v->residual;
    int status;

    /* into axes in which one matrix serves all stages, and there by its eigenvalues */
    for (int s = 0; s < 3; s++) {
        cardan_radau_backward(v, s, b + s * rows);
        cardan_radau_backward(v, s, v->kinematic + s * nu);
    }
    cardan_radau_transform(T_INVERSE, rows, b);
    cardan_radau_transform(T_INVERSE, nu, v->kinematic);
    status = solve_alone(v, h / ALONE, b, b + nu + mp, v->kinematic);
    if (status == 0)
        status = solve_pair(v, h * REAL / square, -h * IMAG / square, b + rows, b + 2 * rows,
                            b + rows + nu + mp, b + 2 * rows + nu + mp, v->kinematic + nu);
    cardan_radau_transform(T, rows, b);
    for (int s = 0; s < 3; s++)
        cardan_radau_forward(v, s, b + s * rows);
    /* without convergence there are shorter steps */
    return status == 0 ? 0 : CARDAN_TOO_SMALL;
}

/* New increments of all stages by their new speeds, and what that changes. */
static int move(const cardan_radau_stages *v, real h, const real *speeds, ptrdiff_t stride)
{
    const ptrdiff_t nu = v->nu;
    int status = 0;

    for (int s = 0; s < 3 && status == 0; s++)
        status = chart_rates(v->mesh, v->maps + 9 * s * v->mesh->places,
                                          speeds + s * stride, v->rates + s * nu);
    for (int s = 0; s < 3 && status == 0; s++) {
        real *change = v->kinematic + s * nu;
        for (ptrdiff_t i = 0; i < nu; i++) {
            real sum = v->shift[s * nu + i] - v->d[s * nu + i];
            for (int j = 0; j < 3; j++)
                sum += h * A[s][j] * v->rates[j * nu + i];
            change[i] = sum;
        }
        status = close_stage(v, s, change);
    }
    return status == 0 ? 0 : CARDAN_TOO_SMALL;
}

/* One simplified Newton iteration; `size` receives the norm of the update. */
int cardan_radau_elements_iterate(cardan_run *run, real h, real *size)
{
    const ptrdiff_t nq = run->nq, nu = run->nu, nz = run->nz;
    cardan_radau_stages v;
    real largest = 0, sum = 0;
    int status = 0;

    cardan_radau_stages_at(run, &v);
    const ptrdiff_t mp = v.mesh->mp, rows = nu + mp + v.m;
    real *b = v.residual;
    for (int s = 0; s < 3 && status == 0; s++)
        status = cardan_radau_place(run, &v, s);
    if (status == 0 && nz > 0)
        status = settle(run, &v, h);
    if (status == 0)
        status = residuals(run, &v, h);
    /* gaps of stages: the systems leave those of their transforms */
    for (int s = 0; s < 3 && status == 0; s++)
        for (ptrdiff_t k = 0; k < mp; k++)
            v.gaps[s * mp + k] = b[s * rows + nu + k];
    if (status == 0)
        status = solve(&v, h);
    if (status != 0)
        return status;
    /* new speeds and multipliers */
    for (int s = 0; s < 3; s++) {
        real *x = v.x + s * v.width, *state = v.states + s * run->nx + nq;
        for (ptrdiff_t i = 0; i < nu; i++) {
            x[i] += b[s * rows + i];
            state[i] += b[s * rows + i];
        }
        for (ptrdiff_t k = 0; k < v.m; k++)
            x[nu + nz + k] += b[s * rows + nu + mp + k];
    }
    memcpy(v.w, v.x, (size_t)(3 * v.width) * sizeof(real));
    cardan_radau_transform(T_INVERSE, v.width, v.w);
    /* increments follow, and what they close */
    status = move(&v, h, v.states + nq, run->nx);
    for (int s = 0; s < 3; s++)
        sum += cardan_radau_squares(run, &v, v.kinematic + s * nu, b + s * rows, v.zdot + s * nz,
                                    &largest);
    *size = sqrt(sum / (real)cardan_larger_of(3 * (2 * nu + nz), 1));
    return status;
}
