/* Where a motion starts: what joints carry brought to where these stand.
 *
 * Part of cardan. Caller owns all memory.
 * Source: as of analyses/simulation/starts/finite_element_start.py, which assembles loops and whose bounds these are.
 */
#include "mesh_calls.h"
#include <math.h>

enum { MOST = 60 };
/* gaps against the size of the scene: sought, and good enough where nothing more is gained */
static const real CLOSED = 1e-12, GOOD = 1e-9;

static real largest(const real *x, ptrdiff_t n, real most)
{
    for (ptrdiff_t i = 0; i < n; i++)
        most = cardan_worst(most, fabs(x[i]));
    return most;
}

static void normalize(const ptrdiff_t *quaternions, ptrdiff_t count, real *q)
{
    for (ptrdiff_t k = 0; k < count; k++) {
        real *e = q + quaternions[k];
        const real length = sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + e[3] * e[3]);

        for (int i = 0; i < 4; i++)
            e[i] /= length;
    }
}

/* By how much entries that are held have moved. */
static real moved(const real *locked, const real *x, const real *x0, ptrdiff_t n)
{
    real most = 0;

    for (ptrdiff_t i = 0; i < n; i++)
        if (locked[i] != 0)
            most = cardan_worst(most, fabs(x[i] - x0[i]));
    return most;
}

ptrdiff_t cardan_mesh_start_work(const cardan_mesh *mesh)
{
    return cardan_mesh_call_work(mesh) + 2 * mesh->nq + mesh->nu + mesh->m;
}

int cardan_mesh_start(const cardan_mesh *mesh, real t, const real *r, const ptrdiff_t *quaternions,
                      ptrdiff_t count, const real *locked, real *x, real *work)
{
    real *q0 = work + cardan_mesh_call_work(mesh), *solution = q0 + mesh->nq, *u = x + mesh->nq;
    const real scale = largest(x, mesh->nq, 1), speed = largest(u, mesh->nu, 1);
    const cardan_in in = {.t = &t, .q = x, .u = u, .z = u + mesh->nu, .r = r, .tau = locked + mesh->nq,
                          .w = (const wreal *)(const void *)mesh};
    real gap = INFINITY, last;
    int status = 0, closed = mesh->mp == 0;

    for (ptrdiff_t i = 0; i < mesh->nq; i++)
        q0[i] = x[i];
    for (int k = 0; k < MOST && !closed && status == 0; k++) {
        status = cardan_mesh_call_close_position(&in, solution, work);
        last = gap;
        gap = largest(solution + mesh->nq, mesh->mp, 0);
        closed = gap <= CLOSED * scale || (gap <= GOOD * scale && gap >= 0.5 * last);
        for (ptrdiff_t i = 0; i < mesh->nq && !closed; i++)
            x[i] = solution[i];
        if (!closed)
            normalize(quaternions, count, x);
    }
    /* what is held resists, but gives way where nothing else can */
    closed = closed && moved(locked, x, q0, mesh->nq) <= GOOD * scale;
    if (status == 0 && closed)
        status = cardan_mesh_call_close_velocity(&in, solution, work);
    if (status == 0 && closed)
        closed = moved(locked + mesh->nq, solution, u, mesh->nu) <= GOOD * speed;
    for (ptrdiff_t i = 0; i < mesh->nu && status == 0 && closed; i++)
        u[i] = solution[i];
    return status != 0 ? status : closed ? 0 : CARDAN_CONSTRAINT_OPEN;
}
