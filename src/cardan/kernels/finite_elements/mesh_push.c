/* Changes of the functions of a mesh along a direction: see mesh_pull.h.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "mesh_pull.h"
#include <string.h>

real *cardan_mesh_data_change(const cardan_data_slopes *data, const real *p, const ptrdiff_t *element,
                              ptrdiff_t lanes, real *to)
{
    for (ptrdiff_t i = 0; i < data->count; i++)
        for (ptrdiff_t lane = 0; lane < lanes; lane++) {
            const ptrdiff_t row = (data->shared ? 0 : element[lane] * data->count) + i;
            real change = 0;
            for (ptrdiff_t k = data->start[row]; k < data->start[row + 1]; k++)
                change += data->slope[k] * p[data->parameter[k]];
            *to++ = change;
        }
    return to;
}

/* Their data included. */
real *cardan_mesh_give_direction(const cardan_mesh *mesh, const cardan_group *g,
                                 const ptrdiff_t *element, ptrdiff_t lanes,
                                 const cardan_gift *gift, real *to)
{
    const cardan_place *here = gift->more;
    const cardan_slopes *way = &here->way;
    const cardan_data_slopes *data = here->product->data + (g - mesh->groups);

    to = cardan_mesh_fetch_places(g, element, lanes, mesh->q, way->q, to);
    to = cardan_mesh_fetch_places(g, element, lanes, mesh->u, way->u, to);
    to = cardan_mesh_fetch_places(g, element, lanes, mesh->u, way->udot, to);
    to = cardan_mesh_pick_rows(g, g->m, element, lanes, way->lam, to);
    to = cardan_mesh_pick(way->z, g->z, g->nz, element, lanes, to);
    to = cardan_mesh_pick(way->s, g->s, g->ns, element, lanes, to);
    /* what all elements share: inputs and time */
    for (ptrdiff_t i = 0; i < mesh->nr; i++)
        for (ptrdiff_t lane = 0; lane < lanes; lane++)
            *to++ = way->r[i];
    for (ptrdiff_t lane = 0; lane < lanes; lane++)
        *to++ = *way->t;
    if (here->at.behind)
        to = cardan_mesh_give_events(mesh, g, element, lanes, way, to);
    /* changes of parameters become those of data */
    return cardan_mesh_data_change(data, way->p, element, lanes, to);
}

/* what takes changes, and how they stand there */
typedef struct taken {
    int layout;
    const cardan_summands *summands;
    real *to;
} taken;

/* Add the changes of elements: see mesh_pull.h. */
static void take_change(const cardan_mesh *mesh, const cardan_group *g,
                        const cardan_element_lanes *some, real *out, void *into)
{
    const taken *change = into;
    const real *next = out;
    real *to = change->to, *rates = to + mesh->nu + mesh->mp;

    if (change->layout == CARDAN_FORMS) {
        const cardan_summands *summands = change->summands + (g - mesh->groups);
        (void)cardan_mesh_add_picked(some, summands->which, summands->size, out, to);
        return;
    }
    next = cardan_mesh_add_places(g, some, mesh->u, next, to);
    if (change->layout == CARDAN_TANGENT) {
        (void)cardan_mesh_add_rows(g, g->m, some, next, to + mesh->nu);
        return;
    }
    next = cardan_mesh_add_rows(g, g->mp, some, next, to + mesh->nu);
    next = cardan_mesh_add_rows(g, g->m, some, next, rates);
    next = cardan_mesh_add_rows(g, g->m, some, next, rates + mesh->m);
    for (ptrdiff_t i = 0; i < g->z_states; i++)
        for (ptrdiff_t lane = 0; lane < some->filled; lane++)
            rates[2 * mesh->m + g->z[some->element[lane] * g->nz + i]] +=
                next[i * some->lanes + lane];
}

int cardan_mesh_push_with(cardan_place *here, const cardan_form *forms, cardan_taker *take, void *to)
{
    const cardan_gift gift = {cardan_mesh_give_direction, 0, NULL, here};
    cardan_state at = here->at;
    int status = 0;

    at.gift = &gift;
    for (ptrdiff_t k = 0; k < here->mesh->group_count && status == 0; k++)
        status = cardan_mesh_group(here->mesh, here->mesh->groups + k, forms + k, &at, take, to,
                                   here->room);
    return status;
}

int cardan_mesh_push_elements(cardan_place *here, const cardan_form *forms, int layout, ptrdiff_t size,
                              real *to)
{
    taken change = {layout, here->product->summands, to};

    memset(to, 0, (size_t)size * sizeof(real));
    return cardan_mesh_push_with(here, forms, take_change, &change);
}

/* Changes of a balance and of all that belongs to it. */
static int sweep_dynamics(cardan_place *here)
{
    const cardan_mesh *mesh = here->mesh;

    return cardan_mesh_push_elements(here, here->product->dynamics, CARDAN_BALANCE,
                                     mesh->nu + mesh->mp + 2 * mesh->m + mesh->nz, here->weights);
}

int cardan_mesh_push_solution(cardan_place *here)
{
    const cardan_mesh *mesh = here->mesh;
    const real *missed = here->weights + mesh->nu + mesh->mp + mesh->m;
    cardan_mesh_system *system = &here->system;
    int status = sweep_dynamics(here);

    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        system->right[i] = here->way.tau[i] - here->weights[i];
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        system->right[mesh->unknown[k]] = -missed[k];
    if (status == 0)
        status = mesh->frictions > 0 ? cardan_mesh_friction_solve(mesh, system, &here->friction, 0)
                                     : cardan_mesh_solve(mesh, system);
    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        here->way.udot[i] = system->solution[i];
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        here->way.lam[k] = -system->solution[mesh->unknown[k]];
    return status;
}

/* Changes of sums, into `sums`. */
static int push_sums(cardan_place *here)
{
    const cardan_mesh_product *product = here->product;
    const int status = product->solved ? cardan_mesh_push_solution(here) : 0;

    return status != 0 ? status
                       : cardan_mesh_push_elements(here, product->direct, CARDAN_FORMS,
                                                   product->sums + 1, here->sums);
}

/* Change of a formula. */
static int push_expression(cardan_place *here, real *out)
{
    const cardan_mesh *mesh = here->mesh;
    const cardan_form *form = here->product->formula + 1;
    const cardan_in in = cardan_formula_in(here, form);
    const cardan_slopes *way = &here->way;
    const ptrdiff_t sizes[] = {1, mesh->nq, mesh->nu, mesh->nz, mesh->nr, here->product->np,
                               mesh->outputs};
    const real *directions[] = {way->t, way->q, way->u, way->z, way->r, way->p, here->sums};
    const real *slope = here->room;
    int status = 0;

    if (mesh->outputs > 0)
        status = push_sums(here);
    if (status == 0)
        status = form->call(&in, here->room, here->room + form->size);
    out[0] = 0;
    for (int k = 0; k < 7; slope += sizes[k++])
        out[0] += cardan_dot(slope, directions[k], sizes[k]);
    return status;
}

/* Change of what a projection moves (nu), for that of gaps in the first rows. */
static int push_closing(cardan_place *here, const real *gaps, ptrdiff_t rows)
{
    const cardan_mesh *mesh = here->mesh;
    cardan_mesh_system *system = &here->system;

    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        system->right[i] = 0;
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        system->right[mesh->unknown[k]] = k < rows ? -gaps[k] : 0;
    return cardan_mesh_solve(mesh, system);
}

int cardan_mesh_push_increment(cardan_place *here, int speeds)
{
    const cardan_mesh *mesh = here->mesh;
    const int status = sweep_dynamics(here);

    return status != 0 ? status
                       : push_closing(here, here->weights + mesh->nu + (speeds ? mesh->mp : 0),
                                      speeds ? mesh->m : mesh->mp);
}

/* Changes of projected positions or speeds, and of the gaps before. */
static int push_projection(cardan_place *here, int speeds, real *out)
{
    const cardan_mesh *mesh = here->mesh;
    const real *gaps = here->weights + mesh->nu + (speeds ? mesh->mp : 0);
    const ptrdiff_t rows = speeds ? mesh->m : mesh->mp, count = speeds ? mesh->nu : mesh->nq;
    const real *before = speeds ? here->way.u : here->way.q, *moved = here->system.solution;
    int status = cardan_mesh_push_increment(here, speeds);

    /* an increment moves coordinates along the speeds */
    if (status == 0 && !speeds) {
        status = cardan_mesh_rates(mesh, here->at.q, moved, here->by.q, here->room);
        moved = here->by.q;
    }
    for (ptrdiff_t i = 0; i < count; i++)
        out[i] = before[i] + moved[i];
    memcpy(out + count, gaps, (size_t)rows * sizeof(real));
    return status;
}

int cardan_mesh_direction(cardan_place *here, const real *v)
{
    const cardan_mesh_product *product = here->product;
    const cardan_mesh *mesh = here->mesh;
    cardan_slopes *way = &here->way;
    int status;

    memset(way->t, 0, (size_t)way->count * sizeof(real));
    for (ptrdiff_t i = 0; i < product->columns; i++)
        way->t[product->column[i]] += v[i];
    status = cardan_mesh_rates(mesh, here->at.q, way->along, here->by.q, here->room);
    for (ptrdiff_t i = 0; i < mesh->nq; i++)
        way->q[i] += here->by.q[i];
    /* a quaternion counts by its direction */
    for (ptrdiff_t k = 0; k < product->quaternions; k++) {
        const ptrdiff_t at = product->quaternion[k];
        here->stretch[k] = cardan_take_along(here->at.q + at, way->q + at);
    }
    return status;
}

int cardan_mesh_push(cardan_place *here, const real *v, real *out)
{
    const cardan_mesh *mesh = here->mesh;
    const ptrdiff_t function = here->product->function, nq = mesh->nq, nu = mesh->nu;
    const real *gaps = here->weights + nu, *rates = gaps + mesh->mp;
    int status = cardan_mesh_direction(here, v);

    if (status != 0)
        return status;
    switch (function) {
    /* what elements give as they are */
    case CARDAN_OF_INVERSE_DYNAMICS:
    case CARDAN_OF_CONSTRAINTS:
    case CARDAN_OF_CONSTRAINT_RATES:
        status = sweep_dynamics(here);
        memcpy(out,
               function == CARDAN_OF_INVERSE_DYNAMICS ? here->weights
               : function == CARDAN_OF_CONSTRAINTS    ? gaps
                                                      : rates,
               (size_t)here->product->results * sizeof(real));
        return status;
    case CARDAN_OF_ENERGY:
    case CARDAN_OF_MOMENTUM:
    case CARDAN_OF_POWER:
    case CARDAN_OF_OUTPUTS:
    case CARDAN_OF_REACTION:
    case CARDAN_OF_ELEMENT_FORCES:
        status = push_sums(here);
        memcpy(out, here->sums, (size_t)here->product->sums * sizeof(real));
        if (function == CARDAN_OF_ENERGY)
            out[2] = out[0] + out[1];
        return status;
    case CARDAN_OF_MASS_MATRIX:
    case CARDAN_OF_CONSTRAINT_JACOBIAN:
        return cardan_mesh_push_matrix(here, out);
    case CARDAN_OF_POSE:
    case CARDAN_OF_VELOCITY:
    case CARDAN_OF_ACCELERATION:
    case CARDAN_OF_FRAME_JACOBIAN:
        return cardan_mesh_push_frame(here, out);
    case CARDAN_OF_EXPRESSION:
        return push_expression(here, out);
    case CARDAN_OF_QDOT:
        return cardan_mesh_push_rates(here, out);
    case CARDAN_OF_EVENTS:
        return cardan_mesh_push_events(here, out);
    case CARDAN_OF_TRANSITION:
        return cardan_mesh_push_transition(here, out);
    /* what is solved for */
    case CARDAN_OF_RHS:
        status = cardan_mesh_push_rates(here, out);
        if (status == 0)
            status = cardan_mesh_push_solution(here);
        memcpy(out + nq, here->way.udot, (size_t)nu * sizeof(real));
        memcpy(out + nq + nu, rates + 2 * mesh->m, (size_t)mesh->nz * sizeof(real));
        return status;
    case CARDAN_OF_FORWARD_DYNAMICS:
    case CARDAN_OF_MULTIPLIERS:
        status = cardan_mesh_push_solution(here);
        memcpy(out, function == CARDAN_OF_MULTIPLIERS ? here->way.lam : here->way.udot,
               (size_t)here->product->results * sizeof(real));
        return status;
    default:
        return push_projection(here, function == CARDAN_OF_CLOSE_VELOCITY, out);
    }
}
