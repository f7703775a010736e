/* Products with derivatives of the rates of coordinates: see mesh_pull.h.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "mesh_pull.h"
#include <string.h>

/* v . qdot of the unit quaternion of a pose by itself and by its angular velocity. It is bilinear in both:
 * at their changes in place of them this is the change of its gradient. */
static void pull_quaternion(const real *q, const real *u, const real *v, real *by_q, real *by_u)
{
    if (by_u) {
        by_u[0] += 0.5 * (-q[1] * v[0] + q[0] * v[1] + q[3] * v[2] - q[2] * v[3]);
        by_u[1] += 0.5 * (-q[2] * v[0] - q[3] * v[1] + q[0] * v[2] + q[1] * v[3]);
        by_u[2] += 0.5 * (-q[3] * v[0] + q[2] * v[1] - q[1] * v[2] + q[0] * v[3]);
    }
    if (!u || !by_q)
        return;
    by_q[0] += 0.5 * (u[0] * v[1] + u[1] * v[2] + u[2] * v[3]);
    by_q[1] += 0.5 * (-u[0] * v[0] - u[2] * v[2] + u[1] * v[3]);
    by_q[2] += 0.5 * (-u[1] * v[0] + u[2] * v[1] - u[0] * v[3]);
    by_q[3] += 0.5 * (-u[2] * v[0] - u[1] * v[1] + u[0] * v[2]);
}

int cardan_mesh_pull_rates(const cardan_place *here, const real *u, const real *v, real *by_q, real *by_u)
{
    const cardan_mesh *mesh = here->mesh;
    int status = 0;

    for (ptrdiff_t k = 0; k < mesh->nodes; k++) {
        const ptrdiff_t q = mesh->q[mesh->node[k]], n = mesh->u[mesh->node[k]];
        pull_quaternion(here->at.q + q, u ? u + n : NULL, v + q, by_q ? by_q + q : NULL, by_u + n);
        /* velocity is told in axes of the ground */
        for (int i = 3; i < 6; i++)
            by_u[n + i] += v[q + 1 + i];
    }
    /* the other kinds of places by gradients of their own, if speeds are not rates there */
    for (ptrdiff_t n = 0; n < mesh->mover_count; n++) {
        const cardan_movers *movers = mesh->movers + n;
        const cardan_form *form = here->product->rates + n;
        for (ptrdiff_t k = 0; k < movers->count && status == 0; k++) {
            const ptrdiff_t q = mesh->q[movers->place[k]], at = mesh->u[movers->place[k]];
            real *out = here->room;
            cardan_in in = {0};
            if (!form->call) {
                for (ptrdiff_t i = 0; i < movers->nq; i++)
                    by_u[at + i] += v[q + i];
                continue;
            }
            in.q = here->at.q + q;
            in.u = (u ? u : here->at.q) + (u ? at : q);
            in.v = v + q;
            in.w = form->w;
            status = form->call(&in, out, out + movers->nq + movers->nu);
            for (ptrdiff_t i = 0; i < movers->nq && u; i++)
                by_q[q + i] += out[i];
            for (ptrdiff_t i = 0; i < movers->nu; i++)
                by_u[at + i] += out[movers->nq + i];
        }
    }
    return status;
}

int cardan_mesh_pull_rates_along(const cardan_place *here, const real *u, const real *v, const real *dq,
                                 const real *du, real *by_q, real *by_u)
{
    const cardan_mesh *mesh = here->mesh;
    int status = 0;

    for (ptrdiff_t k = 0; k < mesh->nodes; k++) {
        const ptrdiff_t q = mesh->q[mesh->node[k]], n = mesh->u[mesh->node[k]];
        pull_quaternion(dq + q, du ? du + n : NULL, v + q, by_q ? by_q + q : NULL, by_u + n);
    }
    for (ptrdiff_t n = 0; n < mesh->mover_count; n++) {
        const cardan_movers *movers = mesh->movers + n;
        const cardan_form *form = here->product->rates + n;
        for (ptrdiff_t k = 0; form->call && k < movers->count && status == 0; k++) {
            const ptrdiff_t q = mesh->q[movers->place[k]], at = mesh->u[movers->place[k]];
            const ptrdiff_t nq = movers->nq, nu = movers->nu;
            /* weights, a direction, the speeds and then the change of the gradient */
            real *weights = here->room, *way = weights + nq, *speeds = way + nq + nu, *out = speeds + nu;
            const cardan_in in = {.q = here->at.q + q, .u = speeds, .v = weights, .w = form->w};
            memcpy(weights, v + q, (size_t)nq * sizeof(real));
            memcpy(way, dq + q, (size_t)nq * sizeof(real));
            for (ptrdiff_t i = 0; i < nu; i++) {
                way[nq + i] = du ? du[at + i] : 0;
                speeds[i] = u ? u[at + i] : 0;
            }
            status = form->call(&in, out, out + nq + nu);
            for (ptrdiff_t i = 0; i < nq && by_q; i++)
                by_q[q + i] += out[i];
            for (ptrdiff_t i = 0; i < nu; i++)
                by_u[at + i] += out[nq + i];
        }
    }
    return status;
}

/* Change of the rates of a unit quaternion that turns with w while it changes by d. */
static void push_quaternion(const real *d, const real *w, real *rate)
{
    rate[0] -= 0.5 * (d[1] * w[0] + d[2] * w[1] + d[3] * w[2]);
    rate[1] += 0.5 * (d[0] * w[0] + d[2] * w[2] - d[3] * w[1]);
    rate[2] += 0.5 * (d[0] * w[1] + d[3] * w[0] - d[1] * w[2]);
    rate[3] += 0.5 * (d[0] * w[2] + d[1] * w[1] - d[2] * w[0]);
}

int cardan_mesh_push_rates(const cardan_place *here, real *out)
{
    const cardan_mesh *mesh = here->mesh;
    const cardan_slopes *way = &here->way;
    int status = cardan_mesh_rates(mesh, here->at.q, way->u, out, here->room);

    for (ptrdiff_t k = 0; k < mesh->nodes; k++) {
        const ptrdiff_t q = mesh->q[mesh->node[k]];
        push_quaternion(way->q + q, here->at.u + mesh->u[mesh->node[k]], out + q);
    }
    /* the other kinds of places by functions of their own, where speeds are not rates */
    for (ptrdiff_t n = 0; n < mesh->mover_count; n++) {
        const cardan_movers *movers = mesh->movers + n;
        const cardan_form *form = here->product->rates + n;
        for (ptrdiff_t k = 0; form->call && k < movers->count && status == 0; k++) {
            const ptrdiff_t q = mesh->q[movers->place[k]], u = mesh->u[movers->place[k]];
            real *direction = here->room, *change = direction + movers->nq + movers->nu;
            const cardan_in in = {.q = here->at.q + q, .u = here->at.u + u, .v = direction,
                                  .w = form->w};
            memcpy(direction, way->q + q, (size_t)movers->nq * sizeof(real));
            memcpy(direction + movers->nq, way->u + u, (size_t)movers->nu * sizeof(real));
            status = form->call(&in, change, change + movers->nq);
            memcpy(out + q, change, (size_t)movers->nq * sizeof(real));
        }
    }
    return status;
}
