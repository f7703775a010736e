/* Second derivatives of values of events and of what events change: see mesh_pull_events.c, mesh_hessian.c.
 *
 * Part of cardan. Caller owns all memory.
 *
 * The gradient through impulses is that of
 *
 *     w.du - mu.b - kappa.m - pi.(J du + missing)
 *
 * at fixed mu, kappa, pi, with b = M du - G^T L - J^T P and m = G du - H L. Along a direction du, L and P
 * change as the event does, and mu, kappa and pi so that derivatives of this by du, L and P stay 0: both by
 * one more solve with the matrix that gave them. Then the gradient changes by its curvature along all of
 * that, and by the gradient with what the weights change by. The same holds of responses, whose weights are
 * the motion itself. Which impulses act, and which of them follow from others, is held.
 * Source: A. Griewank, A. Walther, Evaluating Derivatives (2008), sections 5.1 and 15.3.
 */
#include "mesh_pull.h"
#include <string.h>

/* Three views of one state: its gradient, changes of values, and changes of that gradient, to which `along`
 * adds curvatures and `gradient` what changes of weights do. */
typedef struct views {
    const cardan_place *here;
    cardan_place *change, *along, gradient;
} views;

static views views_of(const cardan_place *here, cardan_place *change, cardan_place *along)
{
    views of = {here, change, along, *along};

    of.gradient.product = here->product;
    return of;
}

/* Add factor times the sum of sizes (jumps) times velocities (jumps, nu). */
static void add_forces(const cardan_mesh *mesh, real factor, const real *sizes, const real *J, real *force)
{
    for (ptrdiff_t j = 0; j < mesh->jumps; j++)
        for (ptrdiff_t i = 0; i < mesh->nu; i++)
            force[i] += factor * sizes[j] * J[j * mesh->nu + i];
}

/* Speeds and multipliers that the impulses make change, besides on fixed impulses, as these do. */
static int motion_along(views *of)
{
    cardan_event_place *change = &of->change->event;
    const cardan_mesh *mesh = of->here->mesh;
    int status;

    memset(change->force, 0, (size_t)mesh->nu * sizeof(real));
    add_forces(mesh, 1, change->P, change->all.J, change->force);
    status = cardan_mesh_motion_of(mesh, &change->released, change->force, NULL, change->moved);
    for (ptrdiff_t i = 0; i < mesh->nu + mesh->m; i++)
        change->moved[i] += change->answer[i];
    return status;
}

/* Changes of mu, kappa (into `answer`: mu and -kappa) and pi (`P`), where the derivatives of what they weigh
 * by the motion have changed by `by_motion`, and w (nu) by `behind`. */
static int weights_along(views *of)
{
    const cardan_mesh *mesh = of->here->mesh;
    const cardan_event_place *base = &of->here->event, *change = &of->change->event;
    cardan_event_place *by = &of->along->event;
    const cardan_mesh_jumps *all = &by->all;
    const ptrdiff_t nu = mesh->nu;
    real *gap = by->by_motion + nu;
    int status;

    for (ptrdiff_t i = 0; i < nu; i++)
        by->force[i] = of->along->by.behind[i] + by->by_motion[i];
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        gap[k] = -gap[k];
    add_forces(mesh, -1, base->P, change->J, by->force);
    status = cardan_mesh_motion_of(mesh, &by->released, by->force, gap, by->answer);
    /* mu stays without velocities along which impulses act; what stands in `answer` is -mu */
    for (ptrdiff_t j = 0; j < mesh->jumps; j++)
        all->right[j] = cardan_dot(all->J + j * nu, by->answer, nu)
                        - cardan_dot(change->J + j * nu, base->answer, nu);
    cardan_mesh_among_impulses(all, mesh->jumps, all->right, by->P);
    add_forces(mesh, -1, by->P, all->J, by->force);
    return status != 0 ? status
                       : cardan_mesh_motion_of(mesh, &by->released, by->force, gap, by->answer);
}

/* Changes of what impulses add to the gradient, of weights of their rows and velocities too. */
static int impulses_along(views *of)
{
    const cardan_mesh *mesh = of->here->mesh;
    const cardan_event_place *base = &of->here->event, *change = &of->change->event;
    cardan_event_place *by = &of->along->event;
    const real *P = base->all.P;
    const ptrdiff_t nu = mesh->nu;
    int status = motion_along(of);

    if (status == 0)
        status = cardan_mesh_pull_impulse(of->along, base->moved, base->answer, change->moved);
    if (status == 0)
        status = weights_along(of);
    for (ptrdiff_t j = 0; j < mesh->jumps; j++) {
        by->rows[CARDAN_JUMP_ROW * j + CARDAN_JUMP_MISSING] -= by->P[j];
        for (ptrdiff_t i = 0; i < nu; i++)
            by->J[j * nu + i] += P[j] * by->answer[i] - change->P[j] * base->answer[i]
                                 - by->P[j] * base->moved[i] - base->P[j] * change->moved[i];
    }
    for (ptrdiff_t i = 0; i < nu; i++)
        by->answer[i] = -by->answer[i];
    return status != 0 ? status
                       : cardan_mesh_pull_impulse(&of->gradient, base->moved, by->answer, NULL);
}

/* Set weights (nu + m) of the equations of a motion that answers a velocity. */
static void answer_weights(const cardan_mesh *mesh, real weight, const real *motion, real *weights)
{
    for (ptrdiff_t i = 0; i < mesh->nu + mesh->m; i++)
        weights[i] = i < mesh->nu ? -weight * motion[i] : weight * motion[i];
}

/* Changes of what the response of velocity j adds to the gradient, its weight and the change of that. */
static int response_along(views *of, ptrdiff_t j, real weight, real d_weight)
{
    const cardan_mesh *mesh = of->here->mesh;
    cardan_event_place *change = &of->change->event, *by = &of->along->event;
    const ptrdiff_t nu = mesh->nu;
    real *moved = by->moved, *d_moved = change->moved;
    int status = cardan_mesh_motion_of(mesh, &of->along->system, by->all.J + j * nu, NULL, moved);

    if (status == 0)
        status = cardan_mesh_push_motion(of->change, &of->change->system, moved, change->J + j * nu,
                                         d_moved);
    for (ptrdiff_t i = 0; i < nu; i++)
        by->J[j * nu + i] += 2 * (d_weight * moved[i] + weight * d_moved[i]);
    answer_weights(mesh, weight, moved, by->answer);
    if (status == 0)
        status = cardan_mesh_pull_impulse(of->along, moved, by->answer, d_moved);
    /* weights change as the motion does, and with the weight of the response */
    answer_weights(mesh, weight, d_moved, by->answer);
    for (ptrdiff_t i = 0; i < nu + mesh->m; i++)
        by->answer[i] += i < nu ? -d_weight * moved[i] : d_weight * moved[i];
    return status != 0 ? status : cardan_mesh_pull_impulse(&of->gradient, moved, by->answer, NULL);
}

/* The same of all responses. */
static int responses_along(views *of)
{
    const cardan_mesh *mesh = of->here->mesh;
    const real *rows = of->here->event.all.rows;
    const real *weight = of->here->by.responses, *d_weight = of->along->by.responses;
    const real *end = weight + mesh->responses;
    int status = 0;

    for (ptrdiff_t j = 0; j < mesh->jumps && status == 0 && weight < end; j++) {
        if ((int)rows[CARDAN_JUMP_ROW * j + CARDAN_JUMP_KIND] != CARDAN_RESPONSE)
            continue;
        if (*weight != 0 || *d_weight != 0)
            status = response_along(of, j, *weight, *d_weight);
        weight++;
        d_weight++;
    }
    return status;
}

int cardan_mesh_pull_transition_along(const cardan_place *here, cardan_place *change, cardan_place *along,
                                      const real *v)
{
    const cardan_mesh *mesh = here->mesh;
    const ptrdiff_t nu = mesh->nu;
    views of = views_of(here, change, along);
    cardan_event_place *by = &along->event;
    int status = cardan_mesh_push_jump(change);

    memset(by->rows, 0, (size_t)(mesh->jumps * CARDAN_JUMP_ROW) * sizeof(real));
    memset(by->J, 0, (size_t)(mesh->jumps * nu) * sizeof(real));
    /* states behind the event; speeds behind it are those before, and what impulses add */
    if (status == 0)
        status = cardan_mesh_pull_states(along, v + nu, 1);
    for (ptrdiff_t i = 0; i < nu; i++)
        along->by.u[i] += along->by.behind[i];
    if (status == 0 && cardan_mesh_any_impulse(mesh, &by->all))
        status = impulses_along(&of);
    if (status == 0)
        status = responses_along(&of);
    /* what impulses are asked for, with speeds before the event */
    memcpy(along->way.behind, along->way.u, (size_t)nu * sizeof(real));
    if (status == 0)
        status = cardan_mesh_pull_jumps(along, &here->event, 1);
    return status != 0 ? status : cardan_mesh_pull_jumps(&of.gradient, by, 0);
}

int cardan_mesh_pull_events_along(const cardan_place *here, cardan_place *change, cardan_place *along,
                                  const real *v)
{
    const int by_reaction = here->event.solved && here->mesh->frictions > 0;
    int status = 0;

    if (by_reaction)
        status = cardan_mesh_push_certainty(change);
    if (status == 0)
        status = cardan_mesh_pull_signs(along, v, 1);
    return status != 0 || !by_reaction ? status
                                       : cardan_mesh_pull_certainty_along(here, change, along);
}
