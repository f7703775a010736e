/* Events of the elements of a mesh: when they happen, and what they change.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "mesh_jumps.h"
#include <string.h>

/* where values of events go, and whether some of them read accelerations or multipliers now */
typedef struct signs {
    real *values;
    int *solved;
} signs;

static void take_signs(const cardan_mesh *mesh, const cardan_group *g,
                       const cardan_element_lanes *some, real *out, void *to)
{
    const signs *all = to;

    (void)mesh;
    for (ptrdiff_t lane = 0; lane < some->filled; lane++) {
        for (ptrdiff_t i = 0; i < g->ne; i++)
            all->values[g->events[some->element[lane] * g->ne + i]] = out[i * some->lanes + lane];
        if (out[g->ne * some->lanes + lane] != 0)
            *all->solved = 1;
    }
}

int cardan_mesh_events(const cardan_mesh *mesh, cardan_state *at, real *solution, real *out, int *solved,
                       cardan_mesh_system *system, real *work, real *room)
{
    signs all = {out, solved};
    int status;

    *solved = 0;
    at->udot = at->lam = NULL;
    status = cardan_mesh_each(mesh, at, CARDAN_SIGNS, take_signs, &all, room);
    if (status != 0 || !*solved)
        return status;
    status = cardan_mesh_solve_motion(mesh, at, NULL, solution, work, system);
    at->udot = solution;
    at->lam = solution + mesh->nu;
    at->certainty = mesh->frictions > 0 ? cardan_mesh_certainty(mesh, work) : NULL;
    return status != 0 ? status : cardan_mesh_each(mesh, at, CARDAN_SIGNS, take_signs, &all, room);
}

int cardan_mesh_call_events(const cardan_in *in, real *out, real *work)
{
    const cardan_mesh *mesh = cardan_mesh_of(in);
    real *solution = work + cardan_mesh_call_work(mesh) - mesh->nu - mesh->m;
    cardan_state at = cardan_state_of(in);
    cardan_mesh_system system = {0};
    int solved;

    return cardan_mesh_events(mesh, &at, solution, out, &solved, &system, work, work);
}

/* where new states go */
typedef struct states {
    real *z, *s;
} states;

static void take_change(const cardan_mesh *mesh, const cardan_group *g,
                        const cardan_element_lanes *some, real *out, void *to)
{
    const states *all = to;

    (void)mesh;
    for (ptrdiff_t lane = 0; lane < some->filled; lane++) {
        const real *entries = out + lane;
        for (ptrdiff_t i = 0; i < g->z_states; i++, entries += some->lanes)
            all->z[g->z[some->element[lane] * g->nz + i]] = *entries;
        for (ptrdiff_t i = 0; i < g->s_states; i++, entries += some->lanes)
            all->s[g->s[some->element[lane] * g->ns + i]] = *entries;
    }
}

/* u (nu), z (nz) and s (ns) behind the events that happen. */
int cardan_mesh_call_transition(const cardan_in *in, real *out, real *work)
{
    const cardan_mesh *mesh = cardan_mesh_of(in);
    real *solution = work + cardan_mesh_call_work(mesh) - mesh->nu - mesh->m;
    real *room = solution - cardan_mesh_jump_room(mesh);
    cardan_state at = cardan_state_of(in);
    states behind = {out + mesh->nu, out + mesh->nu + mesh->nz};
    cardan_mesh_system released = {0};
    cardan_mesh_jumps all;
    int status;

    (void)cardan_mesh_jumps_lay(mesh, room, &all);
    at.udot = at.lam = NULL;
    status = cardan_mesh_accelerations(mesh, &at, NULL, solution, work);
    at.udot = solution;
    at.lam = solution + mesh->nu;
    at.e = in->e;
    if (status == 0)
        status = cardan_mesh_jump(mesh, &at, &all, &released, work);
    if (status != 0)
        return status;
    at.responses = all.responses;
    at.behind = all.behind;
    memcpy(out, all.behind, (size_t)mesh->nu * sizeof(real));
    for (ptrdiff_t i = 0; i < mesh->nz; i++)
        behind.z[i] = in->z[i];
    for (ptrdiff_t i = 0; i < mesh->ns; i++)
        behind.s[i] = in->s[i];
    return cardan_mesh_each(mesh, &at, CARDAN_CHANGE, take_change, &behind, work);
}
