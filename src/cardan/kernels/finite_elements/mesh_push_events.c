/* Changes of values of events and of what events change: see mesh_pull_events.c.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "mesh_pull.h"
#include <string.h>

/* Take changes of M udot - G^T lam (nu) and G udot - H lam (m). */
static void take_impulse(const cardan_mesh *mesh, const cardan_group *g,
                         const cardan_element_lanes *some, real *out, void *into)
{
    real *to = into;
    const real *next = cardan_mesh_add_places(g, some, mesh->u, out, to);

    (void)cardan_mesh_add_rows(g, g->m, some, next, to + mesh->nu);
}

/* Of values of events; whether some read accelerations does not change. */
static void take_signs(const cardan_mesh *mesh, const cardan_group *g,
                       const cardan_element_lanes *some, real *out, void *to)
{
    (void)mesh;
    (void)cardan_mesh_add_picked(some, g->events, g->ne, out, to);
}

/* Of rows of impulses, and of the velocities along which they act. */
static void take_jumps(const cardan_mesh *mesh, const cardan_group *g,
                       const cardan_element_lanes *some, real *out, void *into)
{
    const cardan_event_place *event = into;
    const ptrdiff_t first = CARDAN_FIRST(mesh, g, jumps), size = g->jumps * CARDAN_JUMP_ROW;

    for (ptrdiff_t lane = 0; lane < some->filled; lane++) {
        const ptrdiff_t jump = first + some->element[lane] * g->jumps;
        const real *change = out + lane;
        for (ptrdiff_t i = 0; i < size; i++, change += some->lanes)
            event->rows[jump * CARDAN_JUMP_ROW + i] = *change;
        for (ptrdiff_t j = jump; j < jump + g->jumps; j++)
            for (ptrdiff_t k = 0; k < g->places; k++) {
                const ptrdiff_t *entries = mesh->u + g->place[some->element[lane] * g->places + k];
                for (ptrdiff_t i = entries[0]; i < entries[1]; i++, change += some->lanes)
                    event->J[j * mesh->nu + i] += *change;
            }
    }
}

/* Of states behind events, of those that elements keep themselves. */
static void take_states(const cardan_mesh *mesh, const cardan_group *g,
                        const cardan_element_lanes *some, real *out, void *to)
{
    real *z = to, *s = z + mesh->nz;

    for (ptrdiff_t lane = 0; lane < some->filled; lane++) {
        const real *change = out + lane;
        for (ptrdiff_t i = 0; i < g->z_states; i++, change += some->lanes)
            z[g->z[some->element[lane] * g->nz + i]] = *change;
        for (ptrdiff_t i = 0; i < g->s_states; i++, change += some->lanes)
            s[g->s[some->element[lane] * g->ns + i]] = *change;
    }
}

int cardan_mesh_push_impulse(cardan_place *here, const real *motion)
{
    const cardan_mesh *mesh = here->mesh;
    const cardan_state at = here->at;
    const cardan_slopes way = here->way;
    const ptrdiff_t nu = mesh->nu, n = nu + mesh->m;
    int status;

    here->at.udot = motion;
    here->at.lam = motion + nu;
    here->at.behind = here->at.certainty = NULL;
    /* the motion itself is held */
    here->way.udot = here->event.by_motion;
    here->way.lam = here->event.by_motion + nu;
    memset(here->event.by_motion, 0, (size_t)n * sizeof(real));
    memset(here->event.answer, 0, (size_t)n * sizeof(real));
    status = cardan_mesh_push_with(here, here->product->impulse, take_impulse, here->event.answer);
    here->way = way;
    here->at = at;
    return status;
}

int cardan_mesh_push_motion(cardan_place *here, cardan_mesh_system *system, const real *motion,
                            const real *force, real *out)
{
    const cardan_mesh *mesh = here->mesh;
    real *answer = here->event.answer;
    const int status = cardan_mesh_push_impulse(here, motion);

    for (ptrdiff_t i = 0; i < mesh->nu + mesh->m; i++)
        answer[i] = (i < mesh->nu ? force[i] : 0) - answer[i];
    return status != 0 ? status : cardan_mesh_motion_of(mesh, system, answer, answer + mesh->nu, out);
}

/* Changes of responses. */
static int push_responses(cardan_place *here)
{
    const cardan_mesh *mesh = here->mesh;
    cardan_event_place *event = &here->event;
    const ptrdiff_t nu = mesh->nu;
    real *change = here->way.responses, *end = change + mesh->responses;
    int status = 0;

    for (ptrdiff_t j = 0; j < mesh->jumps && status == 0 && change < end; j++) {
        if ((int)event->all.rows[CARDAN_JUMP_ROW * j + CARDAN_JUMP_KIND] != CARDAN_RESPONSE)
            continue;
        status = cardan_mesh_motion_of(mesh, &here->system, event->all.J + j * nu, NULL, event->moved);
        if (status == 0)
            status = cardan_mesh_push_impulse(here, event->moved);
        *change++ = 2 * cardan_dot(event->J + j * nu, event->moved, nu)
                    - cardan_dot(event->answer, event->moved, nu)
                    + cardan_dot(event->answer + nu, event->moved + nu, mesh->m);
    }
    return status;
}

/* Add to changes of speeds (nu) those by impulses. */
static int push_impulses(cardan_place *here, real *speeds)
{
    const cardan_mesh *mesh = here->mesh;
    cardan_event_place *event = &here->event;
    const cardan_mesh_jumps *all = &event->all;
    const ptrdiff_t nu = mesh->nu, n = mesh->jumps;
    real *force = event->force;
    int status;

    /* speeds and multipliers by the impulses as they are */
    memset(force, 0, (size_t)nu * sizeof(real));
    for (ptrdiff_t j = 0; j < n; j++)
        for (ptrdiff_t i = 0; i < nu; i++)
            force[i] += all->P[j] * all->J[j * nu + i];
    status = cardan_mesh_motion_of(mesh, &event->released, force, NULL, event->moved);
    /* as the same impulses would, on what the equations are now */
    memset(force, 0, (size_t)nu * sizeof(real));
    for (ptrdiff_t j = 0; j < n; j++)
        for (ptrdiff_t i = 0; i < nu; i++)
            force[i] += all->P[j] * event->J[j * nu + i];
    for (ptrdiff_t j = 0; j < n; j++)
        all->right[j] = -event->rows[CARDAN_JUMP_ROW * j + CARDAN_JUMP_MISSING]
                        - cardan_dot(event->J + j * nu, event->moved, nu);
    if (status == 0)
        status = cardan_mesh_push_motion(here, &event->released, event->moved, force, event->answer);
    /* and the impulses change, so that velocities are what they should be */
    for (ptrdiff_t j = 0; j < n; j++)
        all->right[j] -= cardan_dot(all->J + j * nu, event->answer, nu);
    cardan_mesh_among_impulses(all, n, all->right, event->P);
    for (ptrdiff_t i = 0; i < nu; i++) {
        speeds[i] += event->answer[i];
        for (ptrdiff_t j = 0; j < n; j++)
            speeds[i] += event->P[j] * all->X[j * nu + i];
    }
    return status;
}

int cardan_mesh_push_jump(cardan_place *here)
{
    const cardan_mesh *mesh = here->mesh;
    cardan_event_place *event = &here->event;
    cardan_slopes *way = &here->way;
    const ptrdiff_t nu = mesh->nu;
    int status;

    /* what impulses are asked for with speeds before the event */
    memset(event->rows, 0, (size_t)(mesh->jumps * CARDAN_JUMP_ROW) * sizeof(real));
    memset(event->J, 0, (size_t)(mesh->jumps * nu) * sizeof(real));
    memcpy(way->behind, way->u, (size_t)nu * sizeof(real));
    here->at.behind = here->at.u;
    status = cardan_mesh_push_with(here, here->product->jumps, take_jumps, event);
    here->at.behind = NULL;
    if (status == 0)
        status = push_responses(here);
    if (status == 0 && cardan_mesh_any_impulse(mesh, &event->all))
        status = push_impulses(here, way->behind);
    return status;
}

int cardan_mesh_push_transition(cardan_place *here, real *out)
{
    const cardan_mesh *mesh = here->mesh;
    const cardan_event_place *event = &here->event;
    const cardan_slopes *way = &here->way;
    const ptrdiff_t nu = mesh->nu;
    /* accelerations and multipliers before the event change first */
    int status = cardan_mesh_push_solution(here);

    if (status == 0)
        status = cardan_mesh_push_jump(here);
    /* states follow from speeds behind the event; those that no element changes stay */
    here->at.behind = event->all.behind;
    here->at.responses = event->all.responses;
    memcpy(out, way->behind, (size_t)nu * sizeof(real));
    memcpy(out + nu, way->z, (size_t)mesh->nz * sizeof(real));
    memcpy(out + nu + mesh->nz, way->s, (size_t)mesh->ns * sizeof(real));
    if (status == 0)
        status = cardan_mesh_push_with(here, here->product->direct, take_states, out + nu);
    here->at.behind = here->at.responses = NULL;
    return status;
}

int cardan_mesh_push_events(cardan_place *here, real *out)
{
    int status = 0;

    if (here->event.solved) {
        status = cardan_mesh_push_solution(here);
        if (status == 0 && here->mesh->frictions > 0)
            status = cardan_mesh_push_certainty(here);
    }
    memset(out, 0, (size_t)here->mesh->ne * sizeof(real));
    here->at.behind = here->at.u;
    if (status == 0)
        status = cardan_mesh_push_with(here, here->product->direct, take_signs, out);
    here->at.behind = NULL;
    return status;
}
