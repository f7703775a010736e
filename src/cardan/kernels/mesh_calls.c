/* Functions of a whole mesh with the interface of generated ones; `w` is the mesh.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "mesh_calls.h"

static const cardan_mesh *mesh_of(const cardan_in *in)
{
    return (const cardan_mesh *)(const void *)in->w;
}

static cardan_state state_of(const cardan_in *in)
{
    const cardan_state at = {in->t ? *in->t : 0, in->q, in->u, in->udot, in->lam,
                             in->z, in->s, in->r};

    return at;
}

int cardan_mesh_call_balance(const cardan_in *in, real *out, real *work)
{
    const cardan_state at = state_of(in);

    return cardan_mesh_balance(mesh_of(in), &at, out, work);
}

int cardan_mesh_call_qdot(const cardan_in *in, real *out, real *work)
{
    return cardan_mesh_rates(mesh_of(in), in->q, in->u, out, work);
}

int cardan_mesh_call_move(const cardan_in *in, real *out, real *work)
{
    const cardan_mesh *mesh = mesh_of(in);

    return cardan_mesh_move(mesh, in->q, in->du, out, out + mesh->nq, work);
}

int cardan_mesh_call_energy(const cardan_in *in, real *out, real *work)
{
    const cardan_state at = state_of(in);
    const int status = cardan_mesh_sum(mesh_of(in), &at, CARDAN_ENERGY, 2, out, work);

    out[2] = out[0] + out[1];
    return status;
}

/* qdot, then udot with M udot + h = f + Gᵀ lam, G udot = gamma. */
int cardan_mesh_call_rhs(const cardan_in *in, real *out, real *work)
{
    const cardan_mesh *mesh = mesh_of(in);
    const cardan_assembly parts = {{0, 0, 1}, 0, 0, NULL};
    cardan_mesh_system system = {0};
    const ptrdiff_t size = cardan_mesh_lay(mesh, work, &system);
    real *missing = work + size, *gamma = missing + mesh->nu + mesh->mp + mesh->m;
    cardan_state at = state_of(in);
    int assembled, status = cardan_mesh_rates(mesh, in->q, in->u, out, system.work);

    at.udot = at.lam = NULL;
    if (status == 0)
        status = cardan_mesh_balance(mesh, &at, missing, system.work);
    if (status == 0)
        status = cardan_mesh_gamma(mesh, &at, gamma, system.work);
    if (status == 0)
        status = cardan_mesh_factor(mesh, &at, &parts, &system, &assembled);
    if (status != 0)
        return status;
    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        system.right[i] = -missing[i];
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        system.right[mesh->unknown[k]] = gamma[k];
    status = cardan_mesh_solve(mesh, &system);
    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        out[mesh->nq + i] = system.found[i];
    return status;
}

/* Numbers of work memory that each of these needs, at most. */
ptrdiff_t cardan_mesh_call_work(const cardan_mesh *mesh)
{
    cardan_mesh_system system;

    return cardan_mesh_lay(mesh, NULL, &system) + mesh->nu + mesh->mp + 2 * mesh->m;
}
