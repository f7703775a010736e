/* The generalized-alpha method on elements in tables, with sparse matrices.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Unknown are the correction of the increment and, in beta h^2, that of the multipliers, so that no
 * step size shows in the matrix. Of index 2 rows bind the speeds; positions are brought back by a
 * second solution with the same matrix, [S Gᵀ; G 0] (shift, eta) = (0, g): the stabilization in the
 * metric of the step, which costs no larger matrix.
 *
 * One matrix for both takes G for G T. Where bodies turn far in a step that is not so, and they are
 * bound apart: positions by [S Gᵀ; G T 0], as of index 3, then speeds by [M + C Gᵀ; G 0]. What this
 * adds to speeds is taken off the increment, and its inertia is balanced by multipliers, so that the
 * first solution stays one.
 * Source: as of alpha_matrix.c.
 */
#include "alpha.h"
#include "mesh_matrix.h"
#include <math.h>

/* Whether positions are bound beside speeds. */
static int stabilized(const cardan_alpha *v)
{
    return v->index == 2 && v->mp > 0;
}

/* Point into the memory of a run. Returns how many numbers that takes. */
ptrdiff_t cardan_alpha_sparse_lay(const cardan_mesh *mesh, real *own, cardan_alpha *v)
{
    const ptrdiff_t moved = mesh->nq + 9 * mesh->places;
    ptrdiff_t used;

    v->size = mesh->plan->n;
    v->moved = own;
    v->room = own ? own + moved : own;
    used = moved + v->nu;
    used += cardan_mesh_lay(mesh, own ? own + used : own, &v->system);
    /* what is not written to takes no memory */
    if (stabilized(v))
        used += cardan_mesh_lay(mesh, own ? own + used : own, &v->settling);
    return used;
}

/* A new matrix of a step h at t, y, udot, lam. */
int cardan_alpha_sparse_renew(cardan_run *run, const cardan_alpha *v, real h, real t,
                              const real *y, const real *udot, const real *lam)
{
    const real part = (1 - v->af) / (1 - v->am);
    const cardan_state at = {t, y, y + run->nq, udot, lam, y + run->nq + run->nu, run->s, run->r,
                             NULL, NULL};
    const int apart = h != 0 && v->now[ALPHA_APART] != 0;
    const cardan_assembly parts = {{h * h * v->beta * part, h * v->gamma * part, 1},
                                   h * v->beta / v->gamma,
                                   v->index == 2 && !apart,
                                   h == 0 ? NULL : v->moved + run->nq};
    const cardan_assembly speeds = {{0, h * v->gamma * part, 1}, 0, 1, NULL};
    cardan_mesh_system system = v->system, settling = v->settling;
    int assembled, status = cardan_inputs_at(run, t, y);

    if (status != 0)
        return status;
    for (ptrdiff_t k = 0; k < v->m && h == 0; k++)
        v->picked[k] = 1;
    if (h != 0 && v->m > 0) {
        status = cardan_alpha_gaps(run, v, t);
        system.open = settling.open = v->residual + run->nu;
    }
    if (status != 0)
        return status;
    run->jacobians++;
    run->factorizations++;
    status = cardan_mesh_factor(v->mesh, &at, &parts, &system, &assembled);
    if (status == 0 && apart) {
        run->factorizations++;
        status = cardan_mesh_factor(v->mesh, &at, &speeds, &settling, &assembled);
        v->now[ALPHA_LAME] = (real)settling.factors.weak;
    }
    /* a run begins with accelerations, which masses decide alone */
    if (assembled && h == 0) {
        status = status == 0 ? cardan_mesh_massless(v->mesh, &system) : CARDAN_SINGULAR;
        assembled = status == 0;
    }
    v->now[ALPHA_MATRIX] = status == 0 ? h : 0;
    v->now[ALPHA_RATE] = 1;
    v->now[ALPHA_WEAK] = (real)system.factors.weak;
    if (assembled)
        return status;
    run->model_status = status;
    return CARDAN_MODEL;
}

/* Correct accelerations, stabilization and multipliers of the trial by its residual.
 *
 * dx (nu) becomes the change of the increment; for h = 0 that of the accelerations.
 */
int cardan_alpha_sparse_correct(cardan_run *run, const cardan_alpha *v, real h, real *dx)
{
    const ptrdiff_t nu = v->nu, *unknown = v->mesh->unknown;
    const real *g = v->residual + nu, *rates = g + v->mp;
    const real scale = h == 0 ? 1 : h * h * v->beta * (1 - v->af) / (1 - v->am);
    const real lever = h * v->beta / v->gamma;
    const int together = h != 0 && stabilized(v) && v->now[ALPHA_APART] == 0;
    cardan_mesh_system system = v->system;
    int status;

    (void)run;
    system.factors.weak = (int32_t)v->now[ALPHA_WEAK];
    for (ptrdiff_t i = 0; i < nu; i++)
        system.right[i] = -scale * v->residual[i];
    for (ptrdiff_t k = 0; k < v->m; k++)
        system.right[unknown[k]] = h == 0 ? 0 : k < v->mp && !together ? -g[k] : -lever * rates[k];
    status = cardan_mesh_solve(v->mesh, &system);
    for (ptrdiff_t i = 0; i < nu; i++) {
        dx[i] = system.found[i];
        if (h != 0)
            v->a_new[i] += dx[i] / (v->beta * h * h);
    }
    for (ptrdiff_t k = 0; k < v->m; k++)
        v->lam_new[k] -= system.found[unknown[k]] / scale;
    if (!together || status != 0)
        return status;
    /* positions: the gap at the present trial less what its speeds are about to move */
    for (ptrdiff_t i = 0; i < nu; i++)
        system.right[i] = 0;
    for (ptrdiff_t k = 0; k < v->m; k++)
        system.right[unknown[k]] = k < v->mp ? -g[k] + lever * rates[k] : 0;
    status = cardan_mesh_solve(v->mesh, &system);
    for (ptrdiff_t i = 0; i < nu; i++) {
        v->shift[i] -= system.found[i];
        dx[i] += system.found[i];
    }
    return status;
}

/* The largest angle by which a node turns in a step h. */
real cardan_alpha_sparse_turn(const cardan_run *run, const cardan_alpha *v, real h)
{
    const cardan_mesh *mesh = v->mesh;
    real largest = 0;

    for (ptrdiff_t k = 0; k < mesh->nodes; k++) {
        const real *omega = run->y + v->nq + mesh->u[mesh->node[k]];
        largest = fmax(largest, omega[0] * omega[0] + omega[1] * omega[1] + omega[2] * omega[2]);
    }
    for (ptrdiff_t k = 0; k < mesh->flats; k++)
        largest = fmax(largest, pow(run->y[v->nq + mesh->u[mesh->flat[k]] + 2], 2));
    return fabs(h) * sqrt(largest);
}

/* Speeds that fit, after positions have been corrected by dx (nu), to which it adds.
 *
 * Coordinates stay, as what speeds gain is taken off the increment. Returns 0, CARDAN_UNSOLVED,
 * CARDAN_MODEL or CARDAN_INPUT.
 */
int cardan_alpha_sparse_settle(cardan_run *run, const cardan_alpha *v, real h, real t, real *dx)
{
    const ptrdiff_t nu = v->nu, *unknown = v->mesh->unknown;
    const real *rates = v->residual + nu + v->mp;
    const real scale = h * h * v->beta * (1 - v->af) / (1 - v->am);
    cardan_mesh_system system = v->settling;
    int status = cardan_alpha_gaps(run, v, t);

    if (status != 0)
        return status;
    system.factors.weak = (int32_t)v->now[ALPHA_LAME];
    for (ptrdiff_t i = 0; i < nu; i++)
        system.right[i] = 0;
    for (ptrdiff_t k = 0; k < v->m; k++)
        system.right[unknown[k]] = -h * v->beta / v->gamma * rates[k];
    status = cardan_mesh_solve(v->mesh, &system);
    for (ptrdiff_t i = 0; i < nu; i++) {
        v->a_new[i] += system.found[i] / (v->beta * h * h);
        v->shift[i] += system.found[i];
        dx[i] += system.found[i];
    }
    for (ptrdiff_t k = 0; k < v->m; k++)
        v->lam_new[k] -= system.found[unknown[k]] / scale;
    return status;
}
