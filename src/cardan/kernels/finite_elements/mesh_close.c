/* Loops closed by a step of all positions, and speeds that constraints allow.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "mesh_calls.h"
#include <math.h>
#include <string.h>

/* what resists a motion without inertia while loops are closed [kg] */
static const real LIGHT = 1e-6;
/* what resists the motion of what is held, of what resists most */
static const real HEAVY = 1e12;
/* what is open of closed constraints; a projection seeks the same (close.c) */
static const real CLOSED = 1e-15;
/* what redundant rows may leave of what is open while speeds are held */
static const real UNFIT = 1e-8;

/* Take speeds that are held, by `locked` other than 0, out of all equations: dx of them is 0. */
static void fix(const cardan_mesh *mesh, const real *locked, real diagonal,
                 cardan_mesh_system *system)
{
    const cardan_sparse *plan = mesh->plan;

    for (ptrdiff_t block = 0; block < plan->blocks; block++) {
        real *entry = system->a + plan->at[block];
        for (ptrdiff_t k = plan->first[block]; k < plan->first[block + 1]; k++) {
            real *end = entry + plan->stride[block];
            for (ptrdiff_t pair = plan->row[block]; pair < plan->row[block + 1]; pair++) {
                const int32_t column = plan->column[pair];
                for (ptrdiff_t j = plan->first[column]; j < plan->first[column + 1]; j++, entry++)
                    if ((k < mesh->nu && locked[k] != 0) || (j < mesh->nu && locked[j] != 0))
                        *entry = 0;
            }
            entry = end;
        }
    }
    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        if (locked[i] != 0)
            system->a[mesh->diagonal[i]] = diagonal;
}

/* Factor M and G with what nothing resists held a little.
 *
 * locked: speeds that are to be held, NULL for none; if not `fixed`, they give way, a little in
 * place of others, where nothing else can close the loops.
 */
int cardan_mesh_closing_factor(const cardan_mesh *mesh, const cardan_state *at, const real *locked,
                               int fixed, cardan_mesh_system *system)
{
    const cardan_assembly parts = {{0, 0, 1}, 0, 0, NULL, 0};
    int status = cardan_mesh_matrix(mesh, at, &parts, system);
    real largest = 0;

    if (status != 0)
        return status;
    for (ptrdiff_t i = 0; i < mesh->nu; i++) {
        real *entry = system->a + mesh->diagonal[i];
        if (*entry == 0)
            *entry = LIGHT;
        largest = fmax(largest, fabs(*entry));
    }
    if (locked && fixed)
        fix(mesh, locked, largest, system);
    for (ptrdiff_t i = 0; i < mesh->nu && locked && !fixed; i++)
        if (locked[i] != 0)
            system->a[mesh->diagonal[i]] += HEAVY * largest;
    return cardan_mesh_refactor(mesh, system);
}

/* Solve M dx + Gᵀ y = 0, G dx = -open; what nothing resists is held a little. */
static int closing_step(const cardan_mesh *mesh, const cardan_state *at, const real *locked,
                        int fixed, const real *open, ptrdiff_t rows, cardan_mesh_system *system)
{
    const int status = cardan_mesh_closing_factor(mesh, at, locked, fixed, system);

    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        system->right[i] = 0;
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        system->right[mesh->unknown[k]] = k < rows ? -open[k] : 0;
    return status != 0 ? status : cardan_mesh_solve(mesh, system);
}

/* The same with what is held fixed, unless that leaves loops open. */
static int close_by(const cardan_mesh *mesh, const cardan_state *at, const real *locked,
                    const real *open, ptrdiff_t rows, cardan_mesh_system *system)
{
    const int status = closing_step(mesh, at, locked, 1, open, rows, system);

    if (!locked || (status == 0 && system->unfit <= UNFIT))
        return status;
    return closing_step(mesh, at, locked, 0, open, rows, system);
}

/* Whether the largest of what is open (rows) is rounding, of which no step makes less. */
static int is_closed(const real *open, ptrdiff_t rows)
{
    real most = 0;

    for (ptrdiff_t k = 0; k < rows; k++)
        most = fabs(open[k]) <= most ? most : fabs(open[k]);
    return most <= CLOSED;
}

/* q (nq) a step nearer to closing all loops, then what was open (mp). */
int cardan_mesh_call_close_position(const cardan_in *in, real *out, real *work)
{
    const cardan_mesh *mesh = cardan_mesh_of(in);
    const cardan_state at = cardan_state_of(in);
    cardan_mesh_system system = {0};
    real *missing = work + cardan_mesh_lay(mesh, work, &system), *open = missing + mesh->nu;
    int status = cardan_mesh_balance(mesh, &at, missing, system.work);

    for (ptrdiff_t k = 0; k < mesh->mp; k++)
        out[mesh->nq + k] = open[k];
    if (status == 0 && is_closed(open, mesh->mp)) {
        memcpy(out, in->q, (size_t)mesh->nq * sizeof(real));
        return 0;
    }
    system.open = open;
    if (status == 0)
        status = close_by(mesh, &at, in->tau, open, mesh->mp, &system);
    return status != 0 ? status
                       : cardan_mesh_move(mesh, in->q, system.solution, out, NULL, system.work);
}

/* u (nu) that the constraints allow, then what the given ones missed (m). */
int cardan_mesh_call_close_velocity(const cardan_in *in, real *out, real *work)
{
    const cardan_mesh *mesh = cardan_mesh_of(in);
    const cardan_state at = cardan_state_of(in);
    cardan_mesh_system system = {0};
    real *missing = work + cardan_mesh_lay(mesh, work, &system);
    real *rates = missing + mesh->nu + mesh->mp;
    int status = cardan_mesh_balance(mesh, &at, missing, system.work);

    for (ptrdiff_t k = 0; k < mesh->m; k++)
        out[mesh->nu + k] = rates[k];
    if (status == 0 && is_closed(rates, mesh->m)) {
        memcpy(out, in->u, (size_t)mesh->nu * sizeof(real));
        return 0;
    }
    system.open = missing + mesh->nu;
    if (status == 0)
        status = close_by(mesh, &at, in->tau, rates, mesh->m, &system);
    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        out[i] = in->u[i] + system.solution[i];
    return status;
}
