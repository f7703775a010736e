/* End of a step of the Radau IIA method over elements: constraints closed to rounding, stages for
 * dense output, error estimate.
 *
 * Part of cardan. Caller owns all memory.
 *
 * The difference to the embedded formula, per unit of time, is e = u + sum ERROR[i] (d_i - shift_i) / h
 * for increments, E = u' + sum ERROR[i] u_i / h for speeds. It is filtered by the real system, along
 * the constraints: with c = h / ALONE
 *
 *     [M + c C + c^2 K  Gᵀ] [d]   [c^2 (M E + C e) + c M e]
 *     [G + c R          H ] [ ] = [c G e                  ],   u = d / c - e
 *
 * Source: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, 2nd ed., sections IV.8
 * and VII.7.
 */
#include "mesh_states.h"
#include "radau_elements.h"
#include "radau_tables.h"
#include <math.h>
#include <string.h>

enum { POLISH = 6 };

/* Largest gap of positions and of speeds at the last stage, each in its unit. */
static int open_gaps(cardan_run *run, const cardan_radau_stages *v, real h, real *largest)
{
    const real t = run->t + h, *state = v->states + 2 * run->nx;
    const ptrdiff_t mp = v->mesh->mp;
    cardan_state at;
    int status = cardan_inputs_at(run, t, state);

    if (status != 0)
        return status;
    at = cardan_radau_state(run, &t, state, NULL);
    run->model_status = cardan_mesh_gaps(v->mesh, &at, v->residual, v->alone.work);
    *largest = 0;
    for (ptrdiff_t k = 0; k < mp + v->m; k++) {
        const real unit = k < mp ? 1 : fmax(1, v->now[RADAU_FASTEST]);
        *largest = cardan_worst(*largest, fabs(v->residual[v->nu + k]) / unit);
    }
    return run->model_status == 0 ? 0 : CARDAN_MODEL;
}

/* The real system for gaps of some rows alone, added to increments or speeds x (nu). */
static void take_gaps(const cardan_radau_stages *v, const real *gaps, ptrdiff_t count, real *x)
{
    cardan_mesh_system system = v->alone;

    for (ptrdiff_t i = 0; i < v->nu; i++)
        system.right[i] = 0;
    for (ptrdiff_t k = 0; k < v->m; k++)
        system.right[v->mesh->unknown[k]] = k < count ? -gaps[k] : 0;
    if (cardan_mesh_solve(v->mesh, &system) != 0)
        return;
    cardan_radau_forward(v, 2, system.solution);
    for (ptrdiff_t i = 0; i < v->nu; i++)
        x[i] += system.solution[i];
}

/* Newton's iterations end with gaps of their tolerance: take these to rounding. */
static int polish(cardan_run *run, const cardan_radau_stages *v, real h)
{
    const ptrdiff_t nu = v->nu, mp = v->mesh->mp;
    real gap, last = INFINITY;
    int status = 0;

    for (int k = 0; k < POLISH && status == 0; k++) {
        status = open_gaps(run, v, h, &gap);
        if (status != 0 || !(gap > 0 && gap < 0.5 * last))
            break;
        last = gap;
        if (mp > 0)
            take_gaps(v, v->residual + nu, mp, v->d + 2 * nu);
        take_gaps(v, v->residual + nu + mp, v->m, v->x + 2 * v->width);
        status = cardan_radau_place(run, v, 2);
    }
    return status;
}

int cardan_radau_elements_end(cardan_run *run, real h)
{
    const ptrdiff_t n = run->n, nx = run->nx;
    cardan_radau_stages v;
    int status = 0;

    cardan_radau_stages_at(run, &v);
    for (int s = 0; s < 3 && status == 0; s++)
        status = cardan_radau_place(run, &v, s);
    if (status == 0 && v.m > 0)
        status = polish(run, &v, h);
    /* what dense output and energies interpolate, with the end as it was closed */
    for (int s = 0; s < 3; s++)
        for (ptrdiff_t i = 0; i < nx; i++)
            run->k[s * n + i] = v.states[s * nx + i] - run->y[i];
    for (ptrdiff_t i = 0; i < nx; i++)
        run->trial[i] = v.states[2 * nx + i];
    return status;
}

/* Sum of ERROR over the stages of entry i (3, n). */
static real sum_of(const real *x, ptrdiff_t n, ptrdiff_t i)
{
    return ERROR[0] * x[i] + ERROR[1] * x[n + i] + ERROR[2] * x[2 * n + i];
}

/* What is missing in the balance after the estimated error, at the acceleration of the start, and
 * the rates of internal states there. */
static int evaluate_again(cardan_run *run, const cardan_radau_stages *v, real *missing, real *zdot)
{
    const ptrdiff_t nu = v->nu;
    real *state = v->states, *moved = v->states + run->nx;
    cardan_state at;
    int status;

    for (ptrdiff_t i = 0; i < nu + v->nz; i++)
        state[run->nq + i] = run->y[run->nq + i] + v->error[nu + i];
    run->model_status = cardan_mesh_move(v->mesh, run->y, v->error, moved, NULL, v->alone.work);
    memcpy(state, moved, (size_t)run->nq * sizeof(real));
    status = run->model_status == 0 ? cardan_inputs_at(run, run->t, state) : CARDAN_MODEL;
    if (status != 0)
        return status;
    at = cardan_radau_state(run, &run->t, state, v->lam);
    at.udot = run->f + run->nq;
    run->evaluations++;
    run->model_status = cardan_mesh_balance(v->mesh, &at, missing, v->alone.work);
    if (run->model_status == 0 && v->nz > 0)
        run->model_status = cardan_mesh_zdot(v->mesh, &at, zdot, v->alone.work);
    return run->model_status == 0 ? 0 : CARDAN_MODEL;
}

/* The filter of increments and speeds; `missing` (nu) of the balance, NULL: nothing. */
static int filter(cardan_run *run, const cardan_radau_stages *v, real h, const real *u,
                  const real *missing)
{
    const ptrdiff_t nu = v->nu, n = v->mesh->plan->n, *unknown = v->mesh->unknown;
    const real c = h / ALONE;
    cardan_mesh_system system = v->alone;
    real *rate = v->kinematic, *out = v->product, *x = v->padded;
    int status;

    /* c M e + c^2 M E in one product */
    for (ptrdiff_t i = 0; i < n; i++)
        x[i] = 0;
    for (ptrdiff_t i = 0; i < nu; i++) {
        real sum = u[i];
        for (int s = 0; s < 3; s++)
            sum += ERROR[s] * (A[s][0] * v->rates[i] + A[s][1] * v->rates[nu + i]
                               + A[s][2] * v->rates[2 * nu + i]);
        rate[i] = sum;
        x[i] = c * rate[i] + c * c * (run->f[run->nq + i] + sum_of(v->x, v->width, i) / h);
    }
    cardan_sparse_multiply(v->mesh->plan, v->powers[0], x, out);
    for (ptrdiff_t i = 0; i < nu; i++)
        system.right[i] = out[i] - (missing ? c * c * missing[i] : 0);
    /* rows of constraints have e alone: accelerations of the start and the stages keep them */
    for (ptrdiff_t i = 0; i < nu; i++)
        x[i] = c * rate[i];
    cardan_sparse_multiply(v->mesh->plan, v->powers[0], x, out);
    for (ptrdiff_t k = 0; k < v->m; k++)
        system.right[unknown[k]] = out[unknown[k]];
    cardan_sparse_multiply(v->mesh->plan, v->powers[1], x, out);
    for (ptrdiff_t i = 0; i < nu; i++)
        system.right[i] += c * out[i];
    status = cardan_mesh_solve(v->mesh, &system);
    /* speeds follow from increments */
    for (ptrdiff_t i = 0; i < nu; i++) {
        v->error[i] = system.solution[i];
        v->error[nu + i] = system.solution[i] / c - rate[i];
    }
    return status == 0 ? 0 : CARDAN_TOO_SMALL;
}

int cardan_radau_elements_error(cardan_run *run, real h, int again, real *error)
{
    const ptrdiff_t nq = run->nq, nu = run->nu, nz = run->nz;
    const real c = h / ALONE;
    cardan_radau_stages v;
    real largest = 0, *speeds, *z;
    int status = 0;

    cardan_radau_stages_at(run, &v);
    speeds = v.udot;
    z = v.error + 2 * nu;
    for (ptrdiff_t i = 0; i < nu; i++)
        speeds[i] = run->y[nq + i] + (again ? v.error[nu + i] : 0);
    for (ptrdiff_t i = 0; i < nz; i++)
        v.zdot[i] = run->f[nq + nu + i];
    if (again)
        status = evaluate_again(run, &v, v.residual, v.zdot);
    /* internal states by themselves, the motion along its constraints */
    if (status == 0)
        status = filter(run, &v, h, speeds, again ? v.residual : NULL);
    if (status != 0)
        return status;
    for (ptrdiff_t i = 0; i < nz; i++)
        z[i] = c * v.zdot[i] + sum_of(v.x + nu, v.width, i) / ALONE;
    if (nz > 0)
        cardan_mesh_states_solve(v.mesh, c, 0, v.change, v.slopes, z, NULL, v.block);
    run->culprit = -1;
    *error = cardan_radau_squares(run, &v, v.error, v.error + nu, z, &largest);
    *error = sqrt(*error / (real)cardan_larger_of(2 * nu + nz, 1));
    return 0;
}

/* Polynomials of the stages, multipliers at the end, and the largest of positions and speeds. */
void cardan_radau_elements_remember(cardan_run *run)
{
    cardan_radau_stages v;
    real largest = 0;

    cardan_radau_stages_at(run, &v);
    for (ptrdiff_t i = 0; i < v.width; i++)
        for (int m = 0; m < 3; m++)
            v.before[m * v.width + i] = DENSE[m][0] * v.x[i] + DENSE[m][1] * v.x[v.width + i]
                                        + DENSE[m][2] * v.x[2 * v.width + i];
    for (ptrdiff_t k = 0; k < v.m; k++)
        v.lam[k] += v.x[2 * v.width + v.nu + v.nz + k];
    cardan_mesh_extent(run, v.mesh, v.now + RADAU_EXTENT, 0);
    (void)cardan_mesh_squares(run, v.mesh, v.now + RADAU_EXTENT, run->y + run->nq, &largest);
    v.now[RADAU_FASTEST] = fmax(v.now[RADAU_FASTEST], sqrt(largest));
    run->culprit = -1;
}
