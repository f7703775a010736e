/* The generalized-alpha method on elements in tables, with sparse matrices.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Unknown are the correction of the increment and, in beta h^2, that of the multipliers, so that no
 * step size shows in the matrix. Of index 2 rows bind the speeds; positions are brought back by a
 * second solution with the same matrix, [S Gᵀ; G 0] (shift, eta) = (0, g): the stabilization in the
 * metric of the step, which costs no larger matrix.
 * Source: as of alpha_matrix.c; M. Géradin, A. Cardona, Flexible Multibody Dynamics (2001),
 * chapter 11 (sizes against which corrections count).
 */
#include "alpha.h"
#include "mesh_matrix.h"
#include <math.h>

/* Point into the memory of a run. Returns how many numbers that takes. */
ptrdiff_t cardan_alpha_sparse_lay(const cardan_mesh *mesh, real *own, cardan_alpha *v)
{
    const ptrdiff_t moved = mesh->nq + 9 * mesh->places;

    v->size = mesh->plan->n;
    v->moved = own;
    v->room = own ? own + moved : own;
    return moved + v->nu + cardan_mesh_lay(mesh, own ? own + moved + v->nu : own, &v->system);
}

/* A new matrix of a step h at t, y, udot, lam. */
int cardan_alpha_sparse_renew(cardan_run *run, const cardan_alpha *v, real h, real t,
                              const real *y, const real *udot, const real *lam)
{
    const real part = (1 - v->af) / (1 - v->am);
    const cardan_state at = {t, y, y + run->nq, udot, lam, y + run->nq + run->nu, run->s, run->r,
                             NULL, NULL};
    const cardan_assembly parts = {{h * h * v->beta * part, h * v->gamma * part, 1},
                                   h * v->beta / v->gamma,
                                   v->index == 2,
                                   h == 0 ? NULL : v->moved + run->nq};
    cardan_mesh_system system = v->system;
    int assembled, status = cardan_inputs_at(run, t, y);

    if (status != 0)
        return status;
    for (ptrdiff_t k = 0; k < v->m && h == 0; k++)
        v->picked[k] = 1;
    run->jacobians++;
    run->factorizations++;
    status = cardan_mesh_factor(v->mesh, &at, &parts, &system, &assembled);
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
    const int stabilized = v->index == 2 && h != 0 && v->mp > 0;
    cardan_mesh_system system = v->system;
    int status;

    (void)run;
    system.factors.weak = (int32_t)v->now[ALPHA_WEAK];
    for (ptrdiff_t i = 0; i < nu; i++)
        system.right[i] = -scale * v->residual[i];
    for (ptrdiff_t k = 0; k < v->m; k++)
        system.right[unknown[k]] = h == 0 ? 0 : k < v->mp && !stabilized ? -g[k] : -lever * rates[k];
    status = cardan_mesh_solve(v->mesh, &system);
    for (ptrdiff_t i = 0; i < nu; i++) {
        dx[i] = system.found[i];
        if (h != 0)
            v->a_new[i] += dx[i] / (v->beta * h * h);
    }
    for (ptrdiff_t k = 0; k < v->m; k++)
        v->lam_new[k] -= system.found[unknown[k]] / scale;
    if (!stabilized || status != 0)
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

/* Largest distance of nodes from their middle, or from where they were: the size of the scene. */
static real span_of(const cardan_alpha *v, const real *q)
{
    const cardan_mesh *mesh = v->mesh;
    real middle[3] = {0}, largest = 0, span;

    for (ptrdiff_t k = 0; k < mesh->nodes; k++)
        for (int i = 0; i < 3; i++)
            middle[i] += q[mesh->q[mesh->node[k]] + 4 + i];
    for (int i = 0; i < 3; i++)
        middle[i] /= (real)(mesh->nodes > 0 ? mesh->nodes : 1);
    for (ptrdiff_t k = 0; k < mesh->nodes; k++) {
        const real *place = q + mesh->q[mesh->node[k]] + 4;
        real square = 0;
        for (int i = 0; i < 3; i++)
            square += (place[i] - middle[i]) * (place[i] - middle[i]);
        largest = square > largest ? square : largest;
    }
    span = sqrt(largest);
    for (int i = 0; i < 3; i++)
        span = fmax(span, mesh->nodes > 0 ? fabs(middle[i]) : 0);
    return span;
}

/* Mean size of an increment dx (nu): angles against 1, lengths against the size of the scene. */
real cardan_alpha_sparse_norm(cardan_run *run, const cardan_alpha *v, const real *dx, real rtol,
                              real atol)
{
    const cardan_mesh *mesh = v->mesh;
    const real length = 1 / (atol + rtol * span_of(v, run->y)), angle = 1 / (atol + rtol);
    real sum = 0, largest = 0;

    for (ptrdiff_t k = 0, place = 0; place < mesh->places; place++) {
        const int pose = k < mesh->nodes && mesh->node[k] == place;
        const ptrdiff_t start = mesh->u[place], n = mesh->u[place + 1] - start;

        for (ptrdiff_t i = 0; i < n; i++) {
            const real part = dx[start + i] * (pose && i >= 3 ? length : angle);
            sum += part * part;
            if (!(part * part <= largest)) {
                largest = part * part;
                run->culprit = mesh->q[place] + (pose ? 1 + i : i);
            }
        }
        k += pose;
    }
    return sqrt(sum / (real)(v->nu > 0 ? v->nu : 1));
}
