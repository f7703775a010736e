/* Second derivatives of weighted sums of the results of a mesh: see mesh_product.h.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Forward over reverse, column by column. The gradient of phi(x, y), y solved from R(x, y) = 0, is that
 * of L = phi - mu R, with L_y = 0. Along a direction dx of a column y changes by dy, one solve, and the
 * gradient of L at fixed mu by L_xx dx + L_xy dy, one sweep of curvatures. What L_y changes by makes mu
 * follow, a second solve with the same factors, and a sweep of gradients adds what dmu does.
 * Source: A. Griewank, A. Walther, Evaluating Derivatives (2008), sections 3.2, 5.1 and 15.3.
 */
#include "mesh_pull.h"
#include <string.h>

/* The gradient at a state, and its changes along one column after the other. */
typedef struct hessian {
    cardan_place here;    /* gradient: its weights and derivatives, by q as it is stored */
    cardan_place change;  /* changes of what was solved for; shares its direction with the next */
    cardan_place along;   /* changes of that gradient */
    cardan_slopes closed; /* a direction of an increment that closes loops alone */
    real *formula;        /* what the slopes of a formula read, and a direction of that */
    real *unit;           /* changes of the weights of outputs */
    real *by_q, *by_u;    /* (nq), (nu) */
    const real *v;        /* weights of the results */
} hessian;

static ptrdiff_t weights_of(const cardan_mesh *mesh)
{
    return mesh->nu + mesh->mp + 2 * mesh->m + mesh->nz;
}

/* Point into memory behind that of the gradient, NULL: only measure; `here` is laid out already. */
static ptrdiff_t lay(const cardan_mesh_product *product, real *block, hessian *h)
{
    const cardan_mesh *mesh = product->mesh;
    ptrdiff_t used = cardan_mesh_lay_place(product, block, &h->here);

    h->formula = cardan_reserve(block, &used, 1 + mesh->nq + mesh->nu + mesh->nz + mesh->nr + product->np
                                                  + 2 * mesh->outputs);
    h->unit = cardan_reserve(block, &used, mesh->outputs);
    h->by_q = cardan_reserve(block, &used, mesh->nq);
    h->by_u = cardan_reserve(block, &used, mesh->nu);
    used += cardan_mesh_lay_slopes(product, block ? block + used : NULL, &h->closed);
    /* changes have a direction, a system and room in common with the gradient */
    h->along = h->here;
    h->along.weights = cardan_reserve(block, &used, weights_of(mesh));
    h->along.sums = cardan_reserve(block, &used, product->sums + 1);
    h->along.probe = cardan_reserve(block, &used, mesh->nu);
    used += cardan_mesh_lay_slopes(product, block ? block + used : NULL, &h->along.by);
    h->change = h->along;
    used += cardan_mesh_lay_weights(product, block ? block + used : NULL, &h->change.event);
    used += cardan_mesh_lay_weights(product, block ? block + used : NULL, &h->along.event);
    h->change.product = product->change;
    h->along.product = product->curvature;
    h->here.by_data = cardan_reserve(block, &used, product->data_rows);
    h->here.closing = cardan_reserve(block, &used, weights_of(mesh));
    return used;
}

ptrdiff_t cardan_mesh_hessian_work(const cardan_mesh_product *product)
{
    hessian h = {0};

    return lay(product, NULL, &h);
}

/* True where functions follow from accelerations or multipliers. */
static int solved(const hessian *h)
{
    const ptrdiff_t function = h->here.product->function;

    return h->here.product->solved || function == CARDAN_OF_TRANSITION
           || (function == CARDAN_OF_EVENTS && h->here.event.solved);
}

/* True for steps that close positions or speeds. */
static int closes(ptrdiff_t function)
{
    return function == CARDAN_OF_CLOSE_POSITION || function == CARDAN_OF_CLOSE_VELOCITY;
}

static void clear(cardan_slopes *by)
{
    memset(by->t, 0, (size_t)by->count * sizeof(real));
}

/* Add n numbers times a factor. */
static const real *add(ptrdiff_t n, real factor, const real *from, real *to)
{
    for (ptrdiff_t i = 0; i < n; i++)
        to[i] += factor * from[i];
    return from + n;
}

/* Changes of the slopes of a formula along the direction: its second derivatives. */
static int formula_along(hessian *h)
{
    const cardan_mesh *mesh = h->here.mesh;
    const cardan_slopes *way = &h->along.way;
    const cardan_form *form = h->along.product->formula + 2;
    const ptrdiff_t np = h->here.product->np;
    const real *from[] = {h->here.direct, way->t, way->q, way->u, way->z, way->r, way->p, h->along.sums};
    const ptrdiff_t sizes[] = {mesh->outputs, 1, mesh->nq, mesh->nu, mesh->nz, mesh->nr, np,
                               mesh->outputs};
    cardan_in in = cardan_formula_in(&h->here, form);
    cardan_slopes *by = &h->along.by;
    real *to = h->formula;
    const real *slope = h->here.room;
    int status;

    for (int k = 0; k < 8; to += sizes[k++])
        memcpy(to, from[k], (size_t)sizes[k] * sizeof(real));
    in.v = h->formula;
    status = form->call(&in, h->here.room, h->here.room + form->size);
    slope = add(1, h->v[0], slope, by->t);
    slope = add(mesh->nq, h->v[0], slope, by->q);
    slope = add(mesh->nu, h->v[0], slope, by->u);
    slope = add(mesh->nz, h->v[0], slope, by->z);
    slope = add(mesh->nr, h->v[0], slope, by->r);
    slope = add(np, h->v[0], slope, by->p);
    for (ptrdiff_t i = 0; i < mesh->outputs; i++)
        h->unit[i] = h->v[0] * slope[i];
    return status;
}

/* Changes of the gradients of what elements give as it is, weights fixed but those of outputs by a formula. */
static int direct_along(hessian *h)
{
    const cardan_mesh *mesh = h->here.mesh;
    const cardan_mesh_product *product = h->here.product;
    int status = 0;

    switch (product->function) {
    case CARDAN_OF_QDOT:
    case CARDAN_OF_RHS:
        return cardan_mesh_pull_rates_along(&h->along, h->here.at.u, h->v, h->along.way.q, h->along.way.u,
                                            h->along.by.q, h->along.by.u);
    case CARDAN_OF_ENERGY:
    case CARDAN_OF_MOMENTUM:
    case CARDAN_OF_POWER:
    case CARDAN_OF_OUTPUTS:
    case CARDAN_OF_REACTION:
    case CARDAN_OF_ELEMENT_FORCES:
        return cardan_mesh_pull_elements(&h->along, h->along.product->direct, CARDAN_FORMS,
                                         h->here.sums, 1);
    case CARDAN_OF_MASS_MATRIX:
    case CARDAN_OF_CONSTRAINT_JACOBIAN:
        return cardan_mesh_pull_matrix(&h->along, h->v, 1);
    case CARDAN_OF_POSE:
    case CARDAN_OF_VELOCITY:
    case CARDAN_OF_ACCELERATION:
    case CARDAN_OF_FRAME_JACOBIAN:
        return cardan_mesh_pull_frame_along(&h->here, &h->change, &h->along, h->v);
    case CARDAN_OF_EVENTS:
        return cardan_mesh_pull_events_along(&h->here, &h->change, &h->along, h->v);
    case CARDAN_OF_TRANSITION:
        return cardan_mesh_pull_transition_along(&h->here, &h->change, &h->along, h->v);
    case CARDAN_OF_EXPRESSION:
        status = formula_along(h);
        if (status == 0 && mesh->outputs > 0)
            status = cardan_mesh_pull_elements(&h->along, h->along.product->direct, CARDAN_FORMS,
                                               h->here.sums, 1);
        /* their weights are slopes of the formula */
        h->along.product = product;
        if (status == 0 && mesh->outputs > 0)
            status = cardan_mesh_pull_elements(&h->along, product->direct, CARDAN_FORMS, h->unit, 0);
        h->along.product = product->curvature;
        return status;
    default:
        return 0;
    }
}

/* Add what changes of the weights of the dynamics do to the gradient. */
static int weights_along(hessian *h)
{
    int status;

    h->along.product = h->here.product;
    status = cardan_mesh_pull_balance(&h->along, h->along.weights, 0);
    h->along.product = h->here.product->curvature;
    return status;
}

/* Changes of the gradient of phi - mu R, and of mu, where the dynamics count. */
static int dynamics_along(hessian *h)
{
    const ptrdiff_t function = h->here.product->function;
    cardan_slopes *by = &h->along.by;
    int status = 0;

    if (solved(h))
        status = cardan_mesh_push_solution(&h->change);
    if (status == 0 && function == CARDAN_OF_EXPRESSION && h->here.mesh->outputs > 0)
        /* a part of the direction of the formula */
        status = cardan_mesh_push_elements(&h->change, h->change.product->direct, CARDAN_FORMS,
                                           h->here.product->sums + 1, h->along.sums);
    if (status == 0)
        status = direct_along(h);
    if (status == 0 && (solved(h) || function == CARDAN_OF_INVERSE_DYNAMICS
                        || function == CARDAN_OF_CONSTRAINTS
                        || function == CARDAN_OF_CONSTRAINT_RATES))
        status = cardan_mesh_pull_balance(&h->along, h->here.weights, 1);
    if (status != 0 || !solved(h))
        return status;
    memset(h->along.weights, 0, (size_t)weights_of(h->here.mesh) * sizeof(real));
    status = cardan_mesh_pull_solution(&h->along, by->udot, by->lam);
    return status != 0 ? status : weights_along(h);
}

/* Where an increment d moves q, weights v of that, by q and by d in h->by_q and h->by_u.
 *
 * Of v.N(q) d, and of the second order in d: the mean of both orders of N, as for columns along speeds. */
static int moved_along(hessian *h)
{
    const cardan_mesh *mesh = h->here.mesh;
    const real *d = h->closed.udot;
    int status = cardan_mesh_rates(mesh, h->here.at.q, d, h->closed.q, h->here.room);

    for (ptrdiff_t i = 0; i < mesh->nq; i++)
        h->closed.q[i] = h->along.way.q[i] + 0.5 * h->closed.q[i];
    if (status == 0)
        status = cardan_mesh_pull_rates_along(&h->along, NULL, h->v, h->closed.q, d, h->by_q, h->by_u);
    for (ptrdiff_t i = 0; i < mesh->nq; i++)
        h->closed.q[i] = 0.5 * h->by_q[i];
    if (status == 0)
        status = cardan_mesh_pull_rates(&h->here, NULL, h->closed.q, NULL, h->by_u);
    memset(h->closed.q, 0, (size_t)mesh->nq * sizeof(real));
    return status;
}

/* Changes of the gradient of a projection where gaps are closed.
 *
 * The increment d and its multipliers y, M d - Gᵀ y = 0 and G d = -gaps, are 0 there, so that second
 * derivatives have their changes once: in mu (M_x d - Gᵀ_x y) + nu G_x d, and where d moves q.
 */
static int closing_along(hessian *h)
{
    const cardan_mesh *mesh = h->here.mesh;
    const ptrdiff_t nu = mesh->nu, speeds = h->here.product->function == CARDAN_OF_CLOSE_VELOCITY;
    const ptrdiff_t rows = speeds ? mesh->m : mesh->mp;
    cardan_mesh_system *system = &h->here.system;
    cardan_slopes *by = &h->along.by, way = h->along.way;
    real *gaps = h->along.weights + nu + (speeds ? mesh->mp : 0);
    int status = cardan_mesh_push_increment(&h->change, (int)speeds);

    clear(&h->closed);
    for (ptrdiff_t i = 0; i < nu; i++)
        h->closed.udot[i] = system->solution[i];
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        h->closed.lam[k] = -system->solution[mesh->unknown[k]];
    /* what the equations of increment and multipliers change by makes the weights of gaps follow */
    if (status == 0)
        status = cardan_mesh_pull_balance(&h->along, h->here.closing, 1);
    memset(h->by_q, 0, (size_t)mesh->nq * sizeof(real));
    memcpy(h->by_u, by->udot, (size_t)nu * sizeof(real));
    if (status == 0 && !speeds)
        status = moved_along(h);
    for (ptrdiff_t i = 0; i < nu; i++)
        system->right[i] = h->by_u[i];
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        system->right[mesh->unknown[k]] = -by->lam[k];
    clear(by);
    memcpy(by->q, h->by_q, (size_t)mesh->nq * sizeof(real));
    if (status == 0)
        status = cardan_mesh_solve(mesh, system);
    memset(h->along.weights, 0, (size_t)weights_of(mesh) * sizeof(real));
    for (ptrdiff_t k = 0; k < rows; k++)
        gaps[k] = -system->solution[mesh->unknown[k]];
    if (status == 0)
        status = weights_along(h);
    /* gaps, and the equations along the increment */
    if (status == 0)
        status = cardan_mesh_pull_balance(&h->along, h->here.weights, 1);
    h->along.way = h->closed;
    if (status == 0)
        status = cardan_mesh_pull_balance(&h->along, h->here.closing, 1);
    h->along.way = way;
    return status;
}

void cardan_mesh_add_second(const cardan_data_slopes *data, const real *by_data, const real *p, real *by_p)
{
    for (ptrdiff_t row = 0; row < data->rows; row++)
        for (ptrdiff_t k = data->second_start[row]; k < data->second_start[row + 1]; k++) {
            const ptrdiff_t *of = data->second_parameters + 2 * k;
            /* data without derivatives, NaN, may not reach what nobody asks for */
            if (p[of[1]] != 0)
                by_p[of[0]] += by_data[row] * data->second[k] * p[of[1]];
        }
}

/* Second derivatives of data of elements by parameters, along the direction. */
static void data_along(hessian *h)
{
    for (ptrdiff_t n = 0; n < h->here.mesh->group_count; n++) {
        const cardan_data_slopes *data = h->here.product->data + n;
        cardan_mesh_add_second(data, h->here.by_data + data->first_row, h->along.way.p, h->along.by.p);
    }
}

/* Along the speeds, and along coordinates where a quaternion counts by its direction. */
static int finish(hessian *h)
{
    const cardan_mesh_product *product = h->here.product;
    const real *by = h->here.by.q, *way = h->along.way.q;
    real *change = h->along.by.q;
    int status = cardan_mesh_pull_rates(&h->here, NULL, change, NULL, h->along.by.along);

    /* speeds move coordinates otherwise at other coordinates */
    if (status == 0)
        status = cardan_mesh_pull_rates_along(&h->along, NULL, by, way, NULL, NULL, h->along.by.along);
    for (ptrdiff_t k = 0; k < product->quaternions; k++) {
        const ptrdiff_t first = product->quaternion[k];
        const real *q = h->here.at.q + first, *b = by + first, *d = way + first;
        const real square = cardan_dot(q, q, 4), along = cardan_dot(q, b, 4) / square;
        const real more = (cardan_dot(q, change + first, 4) + cardan_dot(d, b, 4)) / square;
        /* a derivative becomes less as a quaternion becomes longer */
        for (int i = 0; i < 4; i++)
            change[first + i] -= q[i] * more + d[i] * along
                                 + h->along.stretch[k] * (b[i] - along * q[i]);
    }
    return status;
}

/* Which of two mirrored entries counts: columns along the speeds do not commute, and the Hessian of the
 * function behind `integrate` is the mean of both orders; so is that of all others but for rounding. Where
 * one is along the speeds and one along coordinates, the former moves what the latter have changed. */
static void mirror(const cardan_mesh_product *product, real *out)
{
    const ptrdiff_t n = product->columns;
    ptrdiff_t starts[10];

    cardan_mesh_product_starts(product, starts);
    for (ptrdiff_t i = 0; i < n; i++)
        for (ptrdiff_t j = 0; j < i; j++) {
            const ptrdiff_t a = product->column[i], b = product->column[j];
            const int mixed = a >= starts[2] && a < starts[3] && b >= starts[1] && b < starts[2];
            real *lower = out + i * n + j, *upper = out + j * n + i;
            if (!mixed)
                *lower = 0.5 * (*lower + *upper);
            *upper = *lower;
        }
}

int cardan_mesh_call_hessian(const cardan_in *in, real *out, real *work)
{
    const cardan_mesh_product *product = (const cardan_mesh_product *)(const void *)in->w;
    const ptrdiff_t n = product->columns;
    hessian h = {0};
    int status = cardan_mesh_enter(in, work, &h.here);

    if (status != 0)
        return status;
    (void)lay(product, work, &h);
    h.v = in->v;
    memset(h.here.by_data, 0, (size_t)product->data_rows * sizeof(real));
    memset(h.here.closing, 0, (size_t)weights_of(product->mesh) * sizeof(real));
    status = cardan_mesh_pull_stored(&h.here, in->v);
    for (ptrdiff_t j = 0; j < n && status == 0; j++) {
        for (ptrdiff_t i = 0; i < n; i++)
            h.here.column[i] = i == j;
        status = cardan_mesh_direction(&h.change, h.here.column);
        clear(&h.along.by);
        if (status == 0)
            status = closes(product->function) ? closing_along(&h) : dynamics_along(&h);
        data_along(&h);
        if (status == 0)
            status = finish(&h);
        for (ptrdiff_t i = 0; i < n; i++)
            out[i * n + j] = h.along.by.t[product->column[i]];
    }
    mirror(product, out);
    return status;
}
