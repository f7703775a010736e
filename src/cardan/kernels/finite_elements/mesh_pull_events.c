/* Sweeps in reverse through values of events and through what events change: see mesh_pull.h.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Neither impulses nor responses are differentiated through their solution. Impulses P move speeds by du
 * and press constraints by L, b = M du - G^T L - J^T P = 0, m = G du - H L = 0, J du + missing = 0 among
 * those that act, so that the gradient of w.du is that of
 *
 *     -mu.(b) - kappa.(m) - pi.(J du + missing),   [M G^T J^T; G H 0; J 0 0] (mu, kappa, pi) = (w, 0, 0)
 *
 * and the matrix is the one that gave du. A response J x, [M G^T; G H] (x, -l) = (J^T, 0), has that of
 * 2 x.J^T - x.b(x, l) + l.m(x, l). Which impulses act is held.
 */
#include "mesh_pull.h"
#include <string.h>

ptrdiff_t cardan_mesh_lay_event(const cardan_mesh_product *product, real *block, cardan_event_place *to)
{
    const cardan_mesh *mesh = product->mesh;
    ptrdiff_t used = 0;

    if (product->function != CARDAN_OF_EVENTS && product->function != CARDAN_OF_TRANSITION)
        return 0;
    used += cardan_mesh_jumps_lay(mesh, block, &to->all);
    used += cardan_mesh_lay_weights(product, block ? block + used : NULL, to);
    to->values = cardan_reserve(block, &used, mesh->ne);
    to->work = cardan_reserve(block, &used, cardan_mesh_call_work(mesh));
    return used;
}

ptrdiff_t cardan_mesh_lay_weights(const cardan_mesh_product *product, real *block, cardan_event_place *to)
{
    const cardan_mesh *mesh = product->mesh;
    const ptrdiff_t n = mesh->nu + mesh->m, k = mesh->frictions;
    ptrdiff_t used = 0;

    if (product->function != CARDAN_OF_EVENTS && product->function != CARDAN_OF_TRANSITION)
        return 0;
    to->rows = cardan_reserve(block, &used, mesh->jumps * CARDAN_JUMP_ROW);
    to->J = cardan_reserve(block, &used, mesh->jumps * mesh->nu);
    to->P = cardan_reserve(block, &used, mesh->jumps);
    to->moved = cardan_reserve(block, &used, n);
    to->answer = cardan_reserve(block, &used, n);
    to->by_motion = cardan_reserve(block, &used, n);
    to->force = cardan_reserve(block, &used, mesh->nu);
    to->shares = cardan_reserve(block, &used, k * (1 + mesh->nu + 3 * mesh->m));
    return used;
}

int cardan_mesh_enter_event(const cardan_in *in, real *solution, real *work, cardan_place *here)
{
    const cardan_mesh *mesh = here->mesh;
    cardan_event_place *event = &here->event;
    int status;

    if (here->product->function == CARDAN_OF_EVENTS)
        return cardan_mesh_events(mesh, &here->at, solution, event->values, &event->solved, &here->system,
                                  work, here->room);
    status = cardan_mesh_solve_motion(mesh, &here->at, NULL, solution, work, &here->system);
    here->at.udot = solution;
    here->at.lam = solution + mesh->nu;
    here->at.e = in->e;
    return status != 0 ? status
                       : cardan_mesh_jump(mesh, &here->at, &event->all, &event->released, event->work);
}

/* Add derivatives by numbers of elements that stand one behind the other, from the first of a group. */
static const real *add_numbered(const cardan_element_lanes *some, ptrdiff_t n, const real *next,
                                 real *by)
{
    for (ptrdiff_t i = 0; i < n; i++, next += some->lanes)
        for (ptrdiff_t lane = 0; lane < some->filled; lane++)
            by[some->element[lane] * n + i] += next[lane];
    return next;
}

const real *cardan_mesh_add_events(const cardan_mesh *mesh, const cardan_group *g,
                                   const cardan_element_lanes *some, const real *next,
                                   const cardan_slopes *by)
{
    next = cardan_mesh_add_places(g, some, mesh->u, next, by->behind);
    next = add_numbered(some, g->frictions, next, by->certainty + CARDAN_FIRST(mesh, g, frictions));
    return add_numbered(some, g->responses, next, by->responses + CARDAN_FIRST(mesh, g, responses));
}

/* Directions of numbers of elements that stand one behind the other, from the first of a group. */
static real *give_numbered(const real *from, ptrdiff_t n, const ptrdiff_t *element, ptrdiff_t lanes,
                            real *to)
{
    for (ptrdiff_t i = 0; i < n; i++)
        for (ptrdiff_t lane = 0; lane < lanes; lane++)
            *to++ = from[element[lane] * n + i];
    return to;
}

real *cardan_mesh_give_events(const cardan_mesh *mesh, const cardan_group *g, const ptrdiff_t *element,
                              ptrdiff_t lanes, const cardan_slopes *way, real *to)
{
    to = cardan_mesh_fetch_places(g, element, lanes, mesh->u, way->behind, to);
    to = give_numbered(way->certainty + CARDAN_FIRST(mesh, g, frictions), g->frictions, element, lanes, to);
    return give_numbered(way->responses + CARDAN_FIRST(mesh, g, responses), g->responses, element, lanes, to);
}

/* Weights of M udot - G^T lam (nu) and G udot - H lam (m). */
static real *give_impulse(const cardan_mesh *mesh, const cardan_group *g, const ptrdiff_t *element,
                          ptrdiff_t lanes, const cardan_gift *gift, real *to)
{
    to = cardan_mesh_fetch_places(g, element, lanes, mesh->u, gift->v, to);
    return cardan_mesh_pick_rows(g, g->m, element, lanes, gift->v + mesh->nu, to);
}

/* Of values of events, and of whether some read accelerations, which has no derivative. */
static real *give_signs(const cardan_mesh *mesh, const cardan_group *g, const ptrdiff_t *element,
                        ptrdiff_t lanes, const cardan_gift *gift, real *to)
{
    (void)mesh;
    to = cardan_mesh_pick(gift->v, g->events, g->ne, element, lanes, to);
    for (ptrdiff_t lane = 0; lane < lanes; lane++)
        *to++ = 0;
    return to;
}

/* Of rows of impulses, and of the velocities along which they act. */
static real *give_jumps(const cardan_mesh *mesh, const cardan_group *g, const ptrdiff_t *element,
                        ptrdiff_t lanes, const cardan_gift *gift, real *to)
{
    const cardan_event_place *event = gift->more;
    const ptrdiff_t first = CARDAN_FIRST(mesh, g, jumps), size = g->jumps * CARDAN_JUMP_ROW;

    for (ptrdiff_t lane = 0; lane < lanes; lane++) {
        const ptrdiff_t jump = first + element[lane] * g->jumps;
        real *weight = to + lane;
        for (ptrdiff_t i = 0; i < size; i++, weight += lanes)
            *weight = event->rows[jump * CARDAN_JUMP_ROW + i];
        for (ptrdiff_t j = jump; j < jump + g->jumps; j++)
            for (ptrdiff_t k = 0; k < g->places; k++) {
                const ptrdiff_t *entries = mesh->u + g->place[element[lane] * g->places + k];
                for (ptrdiff_t i = entries[0]; i < entries[1]; i++, weight += lanes)
                    *weight = event->J[j * mesh->nu + i];
            }
    }
    return to + (size + g->jumps * g->nu) * lanes;
}

/* Of states behind events, of those that elements keep themselves. */
static real *give_states(const cardan_mesh *mesh, const cardan_group *g, const ptrdiff_t *element,
                         ptrdiff_t lanes, const cardan_gift *gift, real *to)
{
    for (ptrdiff_t i = 0; i < g->z_states; i++)
        for (ptrdiff_t lane = 0; lane < lanes; lane++)
            *to++ = gift->v[g->z[element[lane] * g->nz + i]];
    for (ptrdiff_t i = 0; i < g->s_states; i++)
        for (ptrdiff_t lane = 0; lane < lanes; lane++)
            *to++ = gift->v[mesh->nz + g->s[element[lane] * g->ns + i]];
    return to;
}

int cardan_mesh_pull_impulse(cardan_place *here, const real *motion, const real *weights, real *change)
{
    const cardan_mesh *mesh = here->mesh;
    const cardan_gift gift = {give_impulse, 0, weights, NULL};
    const cardan_state at = here->at;
    const cardan_slopes by = here->by, way = here->way;
    const ptrdiff_t nu = mesh->nu;
    int status;

    here->at.udot = motion;
    here->at.lam = motion + nu;
    here->at.behind = here->at.certainty = NULL;
    /* speeds that jump are no accelerations: what the equations are by them is no result */
    here->by.udot = here->event.by_motion;
    here->by.lam = here->event.by_motion + nu;
    memset(here->event.by_motion, 0, (size_t)(nu + mesh->m) * sizeof(real));
    if (change) {
        here->way.udot = change;
        here->way.lam = change + nu;
    }
    status = cardan_mesh_pull_with(here, here->product->impulse, &gift, change != NULL);
    here->by = by;
    here->way = way;
    here->at = at;
    return status;
}

int cardan_mesh_pull_signs(cardan_place *here, const real *v, int along)
{
    const cardan_gift signs = {give_signs, 0, v, NULL};
    int status;

    here->at.behind = here->at.u;
    status = cardan_mesh_pull_with(here, here->product->direct, &signs, along);
    here->at.behind = NULL;
    return status;
}

int cardan_mesh_pull_states(cardan_place *here, const real *v, int along)
{
    const cardan_gift states = {give_states, 0, v, NULL};
    int status;

    here->at.behind = here->event.all.behind;
    here->at.responses = here->event.all.responses;
    status = cardan_mesh_pull_with(here, here->product->direct, &states, along);
    here->at.behind = here->at.responses = NULL;
    return status;
}

int cardan_mesh_pull_jumps(cardan_place *here, const cardan_event_place *weights, int along)
{
    const cardan_gift jumps = {give_jumps, 0, NULL, weights};
    cardan_slopes *by = &here->by;
    int status;

    /* impulses are asked for with speeds before the event */
    here->at.behind = here->at.u;
    memset(by->behind, 0, (size_t)here->mesh->nu * sizeof(real));
    status = cardan_mesh_pull_with(here, here->product->jumps, &jumps, along);
    for (ptrdiff_t i = 0; i < here->mesh->nu; i++)
        by->u[i] += by->behind[i];
    here->at.behind = NULL;
    return status;
}

int cardan_mesh_motion_of(const cardan_mesh *mesh, cardan_mesh_system *system, const real *force,
                          const real *gap, real *motion)
{
    int status;

    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        system->right[i] = force ? force[i] : 0;
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        system->right[mesh->unknown[k]] = gap ? gap[k] : 0;
    status = cardan_mesh_solve(mesh, system);
    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        motion[i] = system->solution[i];
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        motion[mesh->nu + k] = -system->solution[mesh->unknown[k]];
    return status;
}

/* Derivatives through responses, by which there are some. */
static int pull_responses(cardan_place *here)
{
    const cardan_mesh *mesh = here->mesh;
    cardan_event_place *event = &here->event;
    const real *weight = here->by.responses, *end = weight + mesh->responses;
    int status = 0;

    for (ptrdiff_t j = 0; j < mesh->jumps && status == 0 && weight < end; j++) {
        if ((int)event->all.rows[CARDAN_JUMP_ROW * j + CARDAN_JUMP_KIND] != CARDAN_RESPONSE)
            continue;
        if (*weight != 0) {
            status = cardan_mesh_motion_of(mesh, &here->system, event->all.J + j * mesh->nu, NULL,
                                           event->moved);
            for (ptrdiff_t i = 0; i < mesh->nu; i++) {
                event->J[j * mesh->nu + i] += 2 * *weight * event->moved[i];
                event->answer[i] = -*weight * event->moved[i];
            }
            for (ptrdiff_t k = mesh->nu; k < mesh->nu + mesh->m; k++)
                event->answer[k] = *weight * event->moved[k];
            if (status == 0)
                status = cardan_mesh_pull_impulse(here, event->moved, event->answer, NULL);
        }
        weight++;
    }
    return status;
}

/* Derivatives of speeds behind all impulses with weights w (nu), but for those by speeds before. */
static int pull_impulses(cardan_place *here, const real *w)
{
    const cardan_mesh *mesh = here->mesh;
    cardan_event_place *event = &here->event;
    const cardan_mesh_jumps *all = &event->all;
    const ptrdiff_t nu = mesh->nu, n = mesh->jumps;
    int status;

    /* pi: impulses that take back what w says of the velocities along which they act */
    for (ptrdiff_t i = 0; i < n; i++)
        all->right[i] = cardan_dot(all->X + i * nu, w, nu);
    cardan_mesh_among_impulses(all, n, all->right, event->P);
    for (ptrdiff_t i = 0; i < nu; i++) {
        event->force[i] = 0;
        event->answer[i] = w[i];
        for (ptrdiff_t j = 0; j < n; j++) {
            event->force[i] += all->P[j] * all->J[j * nu + i];
            event->answer[i] -= event->P[j] * all->J[j * nu + i];
        }
    }
    /* du and L of the event, then mu and -kappa */
    status = cardan_mesh_motion_of(mesh, &event->released, event->force, NULL, event->moved);
    if (status == 0)
        status = cardan_mesh_motion_of(mesh, &event->released, event->answer, NULL, event->answer);
    for (ptrdiff_t j = 0; j < n; j++) {
        event->rows[CARDAN_JUMP_ROW * j + CARDAN_JUMP_MISSING] -= event->P[j];
        for (ptrdiff_t i = 0; i < nu; i++)
            event->J[j * nu + i] += all->P[j] * event->answer[i] - event->P[j] * event->moved[i];
    }
    /* what came out as a multiplier is the weight of its row with the opposite sign */
    for (ptrdiff_t i = 0; i < nu; i++)
        event->answer[i] = -event->answer[i];
    return status != 0 ? status : cardan_mesh_pull_impulse(here, event->moved, event->answer, NULL);
}

/* Derivatives through accelerations and multipliers, by which there are some. */
static int pull_motion(cardan_place *here)
{
    const int status = cardan_mesh_pull_solution(here, here->by.udot, here->by.lam);

    return status != 0 ? status : cardan_mesh_pull_balance(here, here->weights, 0);
}

int cardan_mesh_pull_transition(cardan_place *here, const real *v)
{
    const cardan_mesh *mesh = here->mesh;
    const ptrdiff_t nu = mesh->nu;
    const real *v_z = v + nu, *v_s = v_z + mesh->nz;
    cardan_event_place *event = &here->event;
    cardan_slopes *by = &here->by;
    int status;

    /* what no element changes stays as it is */
    memcpy(by->z, v_z, (size_t)mesh->nz * sizeof(real));
    memcpy(by->s, v_s, (size_t)mesh->ns * sizeof(real));
    /* states that elements change are no longer those before */
    for (ptrdiff_t k = 0; k < mesh->group_count; k++) {
        const cardan_group *g = mesh->groups + k;
        for (ptrdiff_t e = 0; g->forms[CARDAN_CHANGE].call && e < g->count; e++) {
            for (ptrdiff_t i = 0; i < g->z_states; i++)
                by->z[g->z[e * g->nz + i]] = 0;
            for (ptrdiff_t i = 0; i < g->s_states; i++)
                by->s[g->s[e * g->ns + i]] = 0;
        }
    }
    /* states behind the event, by speeds behind it and by responses */
    status = cardan_mesh_pull_states(here, v_z, 0);
    memset(event->rows, 0, (size_t)(mesh->jumps * CARDAN_JUMP_ROW) * sizeof(real));
    memset(event->J, 0, (size_t)(mesh->jumps * nu) * sizeof(real));
    /* speeds behind are those before, and what impulses add */
    for (ptrdiff_t i = 0; i < nu; i++) {
        by->behind[i] += v[i];
        by->u[i] += by->behind[i];
    }
    if (status == 0)
        status = pull_responses(here);
    if (status == 0 && cardan_mesh_any_impulse(mesh, &event->all))
        status = pull_impulses(here, by->behind);
    if (status == 0)
        status = cardan_mesh_pull_jumps(here, event, 0);
    return status != 0 ? status : pull_motion(here);
}

int cardan_mesh_pull_events(cardan_place *here, const real *v)
{
    int status = cardan_mesh_pull_signs(here, v, 0);

    if (status != 0 || !here->event.solved)
        return status;
    if (here->mesh->frictions > 0)
        status = cardan_mesh_pull_certainty(here);
    return status != 0 ? status : pull_motion(here);
}
