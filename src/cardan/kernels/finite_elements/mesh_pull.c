/* Sweeps in reverse through the functions of a mesh: see mesh_pull.h.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "mesh_pull.h"
#include <string.h>

ptrdiff_t cardan_mesh_lay_slopes(const cardan_mesh_product *product, real *block, cardan_slopes *by)
{
    const cardan_mesh *mesh = product->mesh;
    ptrdiff_t used = 0;

    by->t = cardan_reserve(block, &used, 1);
    by->along = cardan_reserve(block, &used, mesh->nu);
    by->q = cardan_reserve(block, &used, mesh->nq);
    by->u = cardan_reserve(block, &used, mesh->nu);
    by->z = cardan_reserve(block, &used, mesh->nz);
    by->s = cardan_reserve(block, &used, mesh->ns);
    by->r = cardan_reserve(block, &used, mesh->nr);
    by->p = cardan_reserve(block, &used, product->np);
    by->udot = cardan_reserve(block, &used, mesh->nu);
    by->tau = cardan_reserve(block, &used, mesh->nu);
    by->lam = cardan_reserve(block, &used, mesh->m);
    by->behind = cardan_reserve(block, &used, mesh->nu);
    by->certainty = cardan_reserve(block, &used, mesh->frictions);
    by->responses = cardan_reserve(block, &used, mesh->responses);
    by->count = used;
    return used;
}

ptrdiff_t cardan_mesh_lay_place(const cardan_mesh_product *product, real *block, cardan_place *here)
{
    const cardan_mesh *mesh = product->mesh;
    /* what is solved with comes first */
    ptrdiff_t used = cardan_mesh_call_work(mesh) + mesh->nu + mesh->m;

    here->weights = cardan_reserve(block, &used, mesh->nu + mesh->mp + 2 * mesh->m + mesh->nz);
    here->direct = cardan_reserve(block, &used, mesh->outputs);
    here->sums = cardan_reserve(block, &used, product->sums + 1);
    here->unit = cardan_reserve(block, &used, product->results);
    here->probe = cardan_reserve(block, &used, mesh->nu);
    here->column = cardan_reserve(block, &used, product->columns + product->results);
    used += cardan_mesh_lay_slopes(product, block ? block + used : NULL, &here->by);
    used += cardan_mesh_lay_slopes(product, block ? block + used : NULL, &here->way);
    here->stretch = cardan_reserve(block, &used, product->quaternions);
    used += cardan_mesh_lay_event(product, block ? block + used : NULL, &here->event);
    here->room = cardan_reserve(block, &used, cardan_mesh_room(mesh));
    return used;
}

void cardan_mesh_add_data(const cardan_data_slopes *data, const cardan_element_lanes *some,
                          const real *out, real *by_p, real *by_data)
{
    for (ptrdiff_t i = 0; i < data->count; i++, out += some->lanes)
        for (ptrdiff_t lane = 0; lane < some->filled; lane++) {
            const ptrdiff_t row = (data->shared ? 0 : some->element[lane] * data->count) + i;
            for (ptrdiff_t k = data->start[row]; k < data->start[row + 1]; k++)
                by_p[data->parameter[k]] += data->slope[k] * out[lane];
            if (by_data)
                by_data[data->first_row + row] += out[lane];
        }
}

/* Add the gradients of elements. */
static void take_gradient(const cardan_mesh *mesh, const cardan_group *g,
                          const cardan_element_lanes *some, real *out, void *to)
{
    const cardan_place *here = to;
    const cardan_slopes *by = &here->by;
    const real *next = cardan_mesh_add_places(g, some, mesh->q, out, by->q);

    next = cardan_mesh_add_places(g, some, mesh->u, next, by->u);
    next = cardan_mesh_add_places(g, some, mesh->u, next, by->udot);
    next = cardan_mesh_add_rows(g, g->m, some, next, by->lam);
    /* internal states and modes, of which each belongs to one element */
    next = cardan_mesh_add_picked(some, g->z, g->nz, next, by->z);
    next = cardan_mesh_add_picked(some, g->s, g->ns, next, by->s);
    /* what all elements share: inputs, time and parameters */
    for (ptrdiff_t i = 0; i < mesh->nr; i++, next += some->lanes)
        for (ptrdiff_t lane = 0; lane < some->filled; lane++)
            by->r[i] += next[lane];
    for (ptrdiff_t lane = 0; lane < some->filled; lane++)
        *by->t += next[lane];
    next += some->lanes;
    if (here->at.behind)
        next = cardan_mesh_add_events(mesh, g, some, next, by);
    if (here->product->data)
        cardan_mesh_add_data(here->product->data + (g - mesh->groups), some, next, by->p,
                             here->by_data);
}

/* Weights of the results of elements, in the layout of `gift`: see mesh_pull.h. */
static real *give_weights(const cardan_mesh *mesh, const cardan_group *g, const ptrdiff_t *element,
                          ptrdiff_t lanes, const cardan_gift *gift, real *to)
{
    const cardan_place *here = gift->more;
    const real *v = gift->v, *rates = v + mesh->nu + mesh->mp;

    if (gift->form == CARDAN_FORMS) {
        const cardan_summands *summands = here->product->summands + (g - mesh->groups);
        return cardan_mesh_pick(v, summands->which, summands->size, element, lanes, to);
    }
    to = cardan_mesh_fetch_places(g, element, lanes, mesh->u, v, to);
    if (gift->form == CARDAN_TANGENT)
        return cardan_mesh_pick_rows(g, g->m, element, lanes, v + mesh->nu, to);
    to = cardan_mesh_pick_rows(g, g->mp, element, lanes, v + mesh->nu, to);
    to = cardan_mesh_pick_rows(g, g->m, element, lanes, rates, to);
    to = cardan_mesh_pick_rows(g, g->m, element, lanes, rates + mesh->m, to);
    /* an element has rates of its own states, the first of those that it reads */
    for (ptrdiff_t i = 0; i < g->z_states; i++)
        for (ptrdiff_t lane = 0; lane < lanes; lane++)
            *to++ = rates[2 * mesh->m + g->z[element[lane] * g->nz + i]];
    return to;
}

/* Weights, and then the direction along which their gradient changes. */
static real *give_both(const cardan_mesh *mesh, const cardan_group *g, const ptrdiff_t *element,
                       ptrdiff_t lanes, const cardan_gift *gift, real *to)
{
    const cardan_gift *const *two = gift->more;

    to = two[0]->give(mesh, g, element, lanes, two[0], to);
    return two[1]->give(mesh, g, element, lanes, two[1], to);
}

int cardan_mesh_pull_with(cardan_place *here, const cardan_form *forms, const cardan_gift *weights,
                          int along)
{
    const cardan_gift direction = {cardan_mesh_give_direction, 0, NULL, here};
    const cardan_gift *const two[] = {weights, &direction};
    const cardan_gift both = {give_both, 0, NULL, two};
    cardan_state at = here->at;
    int status = 0;

    at.gift = along ? &both : weights;
    for (ptrdiff_t k = 0; k < here->mesh->group_count && status == 0; k++)
        status = cardan_mesh_group(here->mesh, here->mesh->groups + k, forms + k, &at, take_gradient,
                                   here, here->room);
    return status;
}

int cardan_mesh_pull_elements(cardan_place *here, const cardan_form *forms, int layout,
                              const real *weights, int along)
{
    const cardan_gift gift = {give_weights, layout, weights, here};

    return cardan_mesh_pull_with(here, forms, &gift, along);
}

int cardan_mesh_pull_solution(cardan_place *here, const real *by_udot, const real *by_lam)
{
    const cardan_mesh *mesh = here->mesh;
    cardan_mesh_system *system = &here->system;
    real *missed = here->weights + mesh->nu + mesh->mp + mesh->m;
    int status;

    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        system->right[i] = by_udot ? by_udot[i] : 0;
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        system->right[mesh->unknown[k]] = by_lam ? -by_lam[k] : 0;
    /* without friction that follows from reactions the matrix is symmetric */
    status = mesh->frictions > 0 ? cardan_mesh_friction_solve(mesh, system, &here->friction, 1)
                                 : cardan_mesh_solve(mesh, system);
    for (ptrdiff_t i = 0; i < mesh->nu; i++) {
        here->weights[i] -= system->solution[i];
        here->by.tau[i] += system->solution[i];
    }
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        missed[k] -= system->solution[mesh->unknown[k]];
    return status;
}

/* Derivatives of `sums` with these weights, also through what was solved for. */
static int pull_sums(cardan_place *here)
{
    const cardan_mesh_product *product = here->product;
    cardan_slopes *by = &here->by;
    int status;

    here->sums[product->sums] = 0;
    status = cardan_mesh_pull_elements(here, product->direct, CARDAN_FORMS, here->sums, 0);
    if (status == 0 && product->solved)
        status = cardan_mesh_pull_solution(here, by->udot, by->lam);
    if (status == 0 && product->solved)
        status = cardan_mesh_pull_balance(here, here->weights, 0);
    return status;
}

/* Add a factor times n slopes to derivatives. Returns the slopes that follow. */
static const real *add_slopes(ptrdiff_t n, real factor, const real *slope, real *by)
{
    for (ptrdiff_t i = 0; i < n; i++)
        by[i] += factor * slope[i];
    return slope + n;
}

/* Derivatives of a formula: its own, and those through outputs. */
static int pull_expression(cardan_place *here, real weight)
{
    const cardan_mesh *mesh = here->mesh;
    const cardan_form *form = here->product->formula + 1;
    const cardan_in in = cardan_formula_in(here, form);
    const ptrdiff_t np = form->size - 1 - mesh->nq - mesh->nu - mesh->nz - mesh->nr - mesh->outputs;
    cardan_slopes *by = &here->by;
    const real *slope = here->room;
    int status = form->call(&in, here->room, here->room + form->size);

    /* in the order in which the formula has them; parameters are left out where nobody asks */
    slope = add_slopes(1, weight, slope, by->t);
    slope = add_slopes(mesh->nq, weight, slope, by->q);
    slope = add_slopes(mesh->nu, weight, slope, by->u);
    slope = add_slopes(mesh->nz, weight, slope, by->z);
    slope = add_slopes(mesh->nr, weight, slope, by->r);
    (void)add_slopes(here->product->np, weight, slope, by->p);
    for (ptrdiff_t i = 0; i < mesh->outputs; i++)
        here->sums[i] = weight * slope[np + i];
    return status == 0 && mesh->outputs > 0 ? pull_sums(here) : status;
}

/* Derivatives of a step that closes positions or speeds: `moved` is what its increment counts. */
static int pull_closing(cardan_place *here, const real *moved, real *weights, ptrdiff_t rows)
{
    const cardan_mesh *mesh = here->mesh;
    cardan_mesh_system *system = &here->system;
    int status;

    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        system->right[i] = moved[i];
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        system->right[mesh->unknown[k]] = 0;
    status = cardan_mesh_solve(mesh, system);
    for (ptrdiff_t k = 0; k < rows; k++)
        weights[k] -= system->solution[mesh->unknown[k]];
    /* those of the equations of the increment, which is 0 itself */
    for (ptrdiff_t i = 0; i < mesh->nu && here->closing; i++)
        here->closing[i] = -system->solution[i];
    for (ptrdiff_t k = 0; k < mesh->m && here->closing; k++)
        here->closing[mesh->nu + mesh->mp + mesh->m + k] = -system->solution[mesh->unknown[k]];
    return status != 0 ? status : cardan_mesh_pull_balance(here, here->weights, 0);
}

/* Copy n weights. */
static void copy(ptrdiff_t n, const real *v, real *to)
{
    for (ptrdiff_t i = 0; i < n; i++)
        to[i] = v[i];
}

/* Derivatives of the functions that follow from accelerations, and of those of elements. */
static int pull_dynamics(cardan_place *here, const real *v)
{
    const cardan_mesh *mesh = here->mesh;
    const ptrdiff_t function = here->product->function, nu = mesh->nu;
    real *gaps = here->weights + nu, *rates = gaps + mesh->mp;
    int status = 0;

    switch (function) {
    /* parts of the balance of the elements as they are */
    case CARDAN_OF_INVERSE_DYNAMICS:
        copy(nu, v, here->weights);
        break;
    case CARDAN_OF_CONSTRAINTS:
        copy(mesh->mp, v, gaps);
        break;
    case CARDAN_OF_CONSTRAINT_RATES:
        copy(mesh->m, v, rates);
        break;
    /* what was solved for counts by its equations */
    case CARDAN_OF_RHS:
        status = cardan_mesh_pull_rates(here, here->at.u, v, here->by.q, here->by.u);
        copy(mesh->nz, v + mesh->nq + nu, rates + 2 * mesh->m);
        if (status == 0)
            status = cardan_mesh_pull_solution(here, v + mesh->nq, NULL);
        break;
    case CARDAN_OF_FORWARD_DYNAMICS:
        status = cardan_mesh_pull_solution(here, v, NULL);
        break;
    case CARDAN_OF_MULTIPLIERS:
        status = cardan_mesh_pull_solution(here, NULL, v);
        break;
    }
    return status != 0 ? status : cardan_mesh_pull_balance(here, here->weights, 0);
}

int cardan_mesh_pull_stored(cardan_place *here, const real *v)
{
    const cardan_mesh *mesh = here->mesh;
    const ptrdiff_t nq = mesh->nq, nu = mesh->nu;
    cardan_slopes *by = &here->by;
    real *gaps = here->weights + nu, *rates = gaps + mesh->mp;
    int status;

    memset(here->weights, 0, (size_t)(nu + mesh->mp + 2 * mesh->m + mesh->nz) * sizeof(real));
    memset(by->t, 0, (size_t)by->count * sizeof(real));
    switch (here->product->function) {
    case CARDAN_OF_QDOT:
        return cardan_mesh_pull_rates(here, here->at.u, v, by->q, by->u);
    case CARDAN_OF_ENERGY:
        /* the third result is the sum of the others */
        here->sums[0] = v[0] + v[2];
        here->sums[1] = v[1] + v[2];
        return pull_sums(here);
    case CARDAN_OF_MOMENTUM:
    case CARDAN_OF_POWER:
    case CARDAN_OF_OUTPUTS:
    case CARDAN_OF_REACTION:
    case CARDAN_OF_ELEMENT_FORCES:
        copy(here->product->sums, v, here->sums);
        return pull_sums(here);
    case CARDAN_OF_EXPRESSION:
        return pull_expression(here, v[0]);
    case CARDAN_OF_MASS_MATRIX:
    case CARDAN_OF_CONSTRAINT_JACOBIAN:
        return cardan_mesh_pull_matrix(here, v, 0);
    case CARDAN_OF_POSE:
    case CARDAN_OF_VELOCITY:
    case CARDAN_OF_ACCELERATION:
    case CARDAN_OF_FRAME_JACOBIAN:
        return cardan_mesh_pull_frame(here, v);
    case CARDAN_OF_EVENTS:
        return cardan_mesh_pull_events(here, v);
    case CARDAN_OF_TRANSITION:
        return cardan_mesh_pull_transition(here, v);
    case CARDAN_OF_CLOSE_POSITION:
        copy(nq, v, by->q);
        copy(mesh->mp, v + nq, gaps);
        /* an increment moves q along the speeds */
        status = cardan_mesh_pull_rates(here, NULL, v, NULL, by->tau);
        return status != 0 ? status : pull_closing(here, by->tau, gaps, mesh->mp);
    case CARDAN_OF_CLOSE_VELOCITY:
        copy(nu, v, by->u);
        copy(mesh->m, v + nu, rates);
        return pull_closing(here, v, rates, mesh->m);
    default:
        return pull_dynamics(here, v);
    }
}

/* Derivatives by q along the speeds, and along itself where a quaternion counts by its direction. */
static int finish(const cardan_place *here)
{
    const cardan_slopes *by = &here->by;
    const int status = cardan_mesh_pull_rates(here, NULL, by->q, NULL, by->along);

    for (ptrdiff_t k = 0; k < here->product->quaternions; k++) {
        const ptrdiff_t at = here->product->quaternion[k];
        (void)cardan_take_along(here->at.q + at, by->q + at);
    }
    return status;
}

int cardan_mesh_pull(cardan_place *here, const real *v)
{
    const int status = cardan_mesh_pull_stored(here, v);

    return status != 0 ? status : finish(here);
}
