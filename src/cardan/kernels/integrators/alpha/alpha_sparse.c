/* The generalized-alpha method for finite-element meshes, with sparse matrices.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Unknowns are the corrections of the increment and of the multipliers, the latter scaled by beta
 * h^2 so that the matrix stays bounded as h -> 0. For index 2 the constraint rows act on speeds.
 * Positions are corrected by a second solve with the same matrix, [S Gᵀ; G 0] (shift, eta) = (0,
 * g): the stabilization in the metric of the step, without a larger matrix.
 *
 * S is the tangent of the balance by the increment (alpha_matrix.c), T as in alpha_newton.c. One matrix
 * for both levels replaces G T by G. If bodies turn far in a step this is inaccurate, and the levels
 * are split: positions use [S Gᵀ; G T 0], as for index 3, then speeds use [M + C Gᵀ; G 0]. The second
 * solve changes the speeds only: what they add to the increment is subtracted from it as part of the
 * stabilization. The multipliers of the second solve balance the inertia forces of that change, so
 * the balance of the first solve still holds.
 * Source: as in alpha_matrix.c.
 */
#include "alpha.h"
#include "mesh_matrix.h"
#include <math.h>

/* Whether both positions and speeds are constrained (stabilized index 2). */
static int stabilized(const cardan_alpha *v)
{
    return v->index == 2 && v->mp > 0;
}

/* Point all arrays into the memory of a run. Returns how many numbers they need. */
ptrdiff_t cardan_alpha_sparse_lay(const cardan_mesh *mesh, real *memory, cardan_alpha *v)
{
    const ptrdiff_t moved = mesh->nq + 9 * mesh->places;
    ptrdiff_t used;

    v->size = mesh->plan->n;
    v->moved = memory;
    v->room = memory ? memory + moved : memory;
    used = moved + v->nu;
    used += cardan_mesh_lay(mesh, memory ? memory + used : memory, &v->system);
    /* the second system exists only if positions and speeds may be split */
    if (stabilized(v))
        used += cardan_mesh_lay(mesh, memory ? memory + used : memory, &v->settling);
    return used;
}

/* Whether the stored factors name rows that exist. */
int cardan_alpha_sparse_sound(const cardan_alpha *v)
{
    const cardan_sparse *plan = v->mesh->plan;
    const real lost = v->now[ALPHA_VELOCITY_RANK_LOSS];

    return cardan_sparse_sound(plan, &v->system.factors, v->now[ALPHA_WEAK])
           && (!stabilized(v) || cardan_sparse_sound(plan, &v->settling.factors, lost));
}

/* New matrix of a step h at t, y, udot, lam; h = 0: for initial accelerations and multipliers. */
int cardan_alpha_sparse_renew(cardan_run *run, const cardan_alpha *v, real h, real t,
                              const real *y, const real *udot, const real *lam)
{
    const real part = (1 - v->af) / (1 - v->am);
    const cardan_state at = {.t = t, .q = y, .u = y + run->nq, .udot = udot, .lam = lam,
                             .z = y + run->nq + run->nu, .s = run->s, .r = run->r};
    const int levels_split = h != 0 && v->now[ALPHA_SPLIT_LEVELS] != 0;
    const cardan_assembly parts = {{h * h * v->beta * part, h * v->gamma * part, 1},
                                   h * v->beta / v->gamma,
                                   v->index == 2 && !levels_split,
                                   h == 0 ? NULL : v->moved + run->nq, 0};
    const cardan_assembly speeds = {{0, h * v->gamma * part, 1}, 0, 1, NULL, 0};
    cardan_mesh_system system = v->system, settling = v->settling;
    int assembled, status = cardan_inputs_at(run, t, y);

    if (status == 0 && h != 0)
        status = cardan_alpha_sparse_place(run, v, v->moved, v->moved + run->nq);
    if (status != 0)
        return status;
    /* all constraints stay in use: the sparse factorization replaces pivots of redundant ones */
    for (ptrdiff_t k = 0; k < v->m && h == 0; k++)
        v->picked[k] = 1;
    /* where positions are still off by gaps (`open`), redundant rows look independent by as much:
     * pivots of loop-closing rows up to that size count as zero */
    if (h != 0 && v->m > 0) {
        status = cardan_alpha_gaps(run, v, t);
        system.open = settling.open = v->residual + run->nu;
    }
    if (status != 0)
        return status;
    run->jacobians++;
    run->factorizations++;
    status = cardan_mesh_factor(v->mesh, &at, &parts, &system, &assembled);
    if (status == 0 && levels_split) {
        run->factorizations++;
        status = cardan_mesh_factor(v->mesh, &at, &speeds, &settling, &assembled);
        v->now[ALPHA_VELOCITY_RANK_LOSS] = (real)settling.factors.weak;
    }
    /* initial accelerations depend on the mass matrix alone: massless directions are an error */
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

/* Coordinates (nq) at the end of the increment; its T (places, 9), which a matrix alone needs, NULL: not
 * wanted. */
int cardan_alpha_sparse_place(cardan_run *run, const cardan_alpha *v, real *q, real *tangent_maps)
{
    run->model_status = cardan_mesh_move(v->mesh, run->y, v->increment, q, tangent_maps, run->work);
    return run->model_status != 0 ? CARDAN_MODEL : 0;
}

/* Shift the increment until position gaps `right` are closed. */
static int close_gaps(const cardan_alpha *v, cardan_mesh_system *system)
{
    int status;

    for (ptrdiff_t i = 0; i < v->nu; i++)
        system->right[i] = 0;
    status = cardan_mesh_solve(v->mesh, system);
    for (ptrdiff_t i = 0; i < v->nu; i++)
        v->shift[i] -= system->solution[i];
    return status;
}

/* The shift that `closing` stands for, by the last matrix. */
int cardan_alpha_sparse_shift(const cardan_alpha *v)
{
    cardan_mesh_system system = v->system;

    if (!stabilized(v) || v->now[ALPHA_SPLIT_LEVELS] != 0)
        return 0;
    for (ptrdiff_t i = 0; i < v->nu; i++)
        v->shift[i] = 0;
    system.factors.weak = (int32_t)v->now[ALPHA_WEAK];
    for (ptrdiff_t k = 0; k < v->m; k++)
        system.right[v->mesh->unknown[k]] = k < v->mp ? v->closing[k] : 0;
    return close_gaps(v, &system);
}

/* Newton correction: solve for the residual of the trial, update a', shift and multipliers.
 *
 * dx (nu) receives the change of the increment; for h = 0 that of the accelerations.
 */
int cardan_alpha_sparse_correct(cardan_run *run, const cardan_alpha *v, real h, real *dx)
{
    const ptrdiff_t nu = v->nu, *unknown = v->mesh->unknown;
    const real *g = v->residual + nu, *rates = g + v->mp;
    const real scale = h == 0 ? 1 : h * h * v->beta * (1 - v->af) / (1 - v->am);
    const real lever = h * v->beta / v->gamma;
    const int stabilized_step = h != 0 && stabilized(v) && v->now[ALPHA_SPLIT_LEVELS] == 0;
    cardan_mesh_system system = v->system;
    int status;

    (void)run;
    system.factors.weak = (int32_t)v->now[ALPHA_WEAK];
    for (ptrdiff_t i = 0; i < nu; i++)
        system.right[i] = -scale * v->residual[i];
    for (ptrdiff_t k = 0; k < v->m; k++)
        system.right[unknown[k]] = h == 0 ? 0 : k < v->mp && !stabilized_step ? -g[k] : -lever * rates[k];
    /* first solve: balance and rates, or positions for index 3 and split levels */
    status = cardan_mesh_solve(v->mesh, &system);
    for (ptrdiff_t i = 0; i < nu; i++) {
        dx[i] = system.solution[i];
        if (h != 0)
            v->a_new[i] += dx[i] / (v->beta * h * h);
    }
    for (ptrdiff_t k = 0; k < v->m; k++)
        v->lam_new[k] -= system.solution[unknown[k]] / scale;
    if (!stabilized_step || status != 0)
        return status;
    /* second solve, stabilization: position gap minus the part the first solve already corrects */
    for (ptrdiff_t k = 0; k < v->m; k++) {
        const real gap = k < v->mp ? -g[k] + lever * rates[k] : 0;
        system.right[unknown[k]] = gap;
        if (k < v->mp)
            v->closing[k] += gap;
    }
    status = close_gaps(v, &system);
    for (ptrdiff_t i = 0; i < nu; i++)
        dx[i] += system.solution[i];
    return status;
}

/* Largest angle by which a node turns in a step h. */
real cardan_alpha_sparse_turn(const cardan_run *run, const cardan_alpha *v, real h)
{
    const cardan_mesh *mesh = v->mesh;
    real largest = 0;

    for (ptrdiff_t k = 0; k < mesh->nodes; k++) {
        const real *omega = run->y + v->nq + mesh->u[mesh->node[k]];
        largest = cardan_most(largest,
                              omega[0] * omega[0] + omega[1] * omega[1] + omega[2] * omega[2]);
    }
    for (ptrdiff_t k = 0; k < mesh->flats; k++)
        largest = fmax(largest, pow(run->y[v->nq + mesh->u[mesh->flat[k]] + 2], 2));
    return fabs(h) * sqrt(largest);
}

/* Split levels: make speeds satisfy their constraints after positions were corrected by dx (nu).
 *
 * Coordinates do not change: h times the change of speeds would move them, and the stabilization takes
 * the same amount back. dx is increased by the change of the increment. Returns 0, CARDAN_UNSOLVED, CARDAN_MODEL or CARDAN_INPUT.
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
    system.factors.weak = (int32_t)v->now[ALPHA_VELOCITY_RANK_LOSS];
    for (ptrdiff_t i = 0; i < nu; i++)
        system.right[i] = 0;
    for (ptrdiff_t k = 0; k < v->m; k++)
        system.right[unknown[k]] = -h * v->beta / v->gamma * rates[k];
    status = cardan_mesh_solve(v->mesh, &system);
    for (ptrdiff_t i = 0; i < nu; i++) {
        v->a_new[i] += system.solution[i] / (v->beta * h * h);
        v->shift[i] += system.solution[i];
        dx[i] += system.solution[i];
    }
    for (ptrdiff_t k = 0; k < v->m; k++)
        v->lam_new[k] -= system.solution[unknown[k]] / scale;
    return status;
}
