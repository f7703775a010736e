/* Derivatives of how certain friction is that follows from reactions: see mesh_pull.h.
 *
 * Part of cardan. Caller owns all memory.
 *
 * 1 - sum_j c_i |F_ij| with the force F_ij = normal_i l_j across line i by a unit of friction j, whose
 * motion is [M G^T; G H] (x_j, -l_j) = (along_j, 0). A weighted sum of F_ij has the gradient of
 * mu.along_j - mu.b(x_j, l_j) - kappa.m(x_j, l_j) and of what normals are, b and m as impulses have them:
 * mesh_pull_events.c.
 */
#include "mesh_pull.h"
#include <math.h>
#include <string.h>

/* of a force, of what it adds up from */
static const real ROUNDING = 1e-12;

/* weights or changes of what elements say of their friction */
typedef struct shares {
    real *coefficient; /* (k) */
    real *along;       /* (k, nu) */
    real *normal;      /* (k, 3, m) */
} shares;

static shares lay(const cardan_mesh *mesh, real *block)
{
    const ptrdiff_t k = mesh->frictions;
    const shares all = {block, block + k, block + k + k * mesh->nu};

    return all;
}

/* Where the i-th of the rows of an element is among all. */
static ptrdiff_t row_of(const cardan_group *g, ptrdiff_t element, ptrdiff_t i)
{
    const ptrdiff_t *rows = g->rows + 2 * element;

    return i < g->mp ? rows[0] + i : rows[1] + i - g->mp;
}

/* Go through what elements say, from `to` to the shares where `adding`, else the other way round. */
static real *exchange(const cardan_mesh *mesh, const cardan_group *g, ptrdiff_t element, ptrdiff_t lanes,
                      const shares *all, int adding, real *to)
{
    const ptrdiff_t first = CARDAN_FIRST(mesh, g, frictions) + element * g->frictions, k = g->frictions;

    for (ptrdiff_t j = first; j < first + k; j++, to += lanes) {
        if (adding)
            all->coefficient[j] += *to;
        else
            *to = all->coefficient[j];
    }
    for (ptrdiff_t j = first; j < first + k; j++)
        for (ptrdiff_t p = 0; p < g->places; p++) {
            const ptrdiff_t *entries = mesh->u + g->place[element * g->places + p];
            for (ptrdiff_t i = entries[0]; i < entries[1]; i++, to += lanes) {
                if (adding)
                    all->along[j * mesh->nu + i] += *to;
                else
                    *to = all->along[j * mesh->nu + i];
            }
        }
    for (ptrdiff_t j = 3 * first; j < 3 * (first + k); j++)
        for (ptrdiff_t i = 0; i < g->m; i++, to += lanes) {
            real *normal = all->normal + j * mesh->m + row_of(g, element, i);
            if (adding)
                *normal += *to;
            else
                *to = *normal;
        }
    return to;
}

static real *give_friction(const cardan_mesh *mesh, const cardan_group *g, const ptrdiff_t *element,
                           ptrdiff_t lanes, const cardan_gift *gift, real *to)
{
    real *end = to;

    for (ptrdiff_t lane = 0; lane < lanes; lane++)
        end = exchange(mesh, g, element[lane], lanes, gift->more, 0, to + lane) - lane;
    return end;
}

static void take_friction(const cardan_mesh *mesh, const cardan_group *g,
                          const cardan_element_lanes *some, real *out, void *to)
{
    for (ptrdiff_t lane = 0; lane < some->filled; lane++)
        (void)exchange(mesh, g, some->element[lane], some->lanes, to, 1, out + lane);
}

/* Size of the force across line i by a unit of friction j, its direction into `along`: none where that is
 * rounding of what it adds up from, as where what friction pushes is held. */
static real force_of(const cardan_mesh *mesh, const cardan_mesh_friction *friction, ptrdiff_t i,
                     ptrdiff_t j, real *along)
{
    const real *force = friction->share + 3 * (mesh->frictions * j + i);
    const real *lam = friction->moved + j * (mesh->nu + mesh->m) + mesh->nu;
    const real size = sqrt(cardan_dot(force, force, 3));
    real most = 0;

    for (ptrdiff_t x = 0; x < 3; x++)
        for (ptrdiff_t row = 0; row < mesh->m; row++)
            most = fmax(most, fabs(friction->normal[(3 * i + x) * mesh->m + row]));
    for (ptrdiff_t row = 0; row < mesh->m; row++)
        if (most * fabs(lam[row]) * ROUNDING >= size)
            most = 0;
    for (ptrdiff_t x = 0; x < 3; x++)
        along[x] = most > 0 ? force[x] / size : 0;
    return size;
}

int cardan_mesh_pull_certainty(cardan_place *here)
{
    const cardan_mesh *mesh = here->mesh;
    const cardan_mesh_friction *friction = &here->friction;
    const ptrdiff_t k = mesh->frictions, nu = mesh->nu, m = mesh->m, n = nu + m;
    shares by = lay(mesh, here->event.shares);
    const cardan_gift gift = {give_friction, 0, NULL, &by};
    const cardan_state at = here->at;
    real *answer = here->event.answer;
    int status = 0;

    memset(by.coefficient, 0, (size_t)(k * (1 + nu + 3 * m)) * sizeof(real));
    /* friction by friction: forces across lines by a unit of it, then the motion that makes them */
    for (ptrdiff_t j = 0; j < k && status == 0; j++) {
        const real *moved = friction->moved + j * n;
        real *weights = here->event.moved;

        memset(weights, 0, (size_t)m * sizeof(real));
        for (ptrdiff_t i = 0; i < k; i++) {
            const real weight = -here->by.certainty[i];
            real along[3];

            by.coefficient[i] += weight * force_of(mesh, friction, i, j, along);
            for (ptrdiff_t x = 0; x < 3; x++) {
                const real share = weight * friction->coefficient[i] * along[x];
                for (ptrdiff_t row = 0; row < m; row++) {
                    by.normal[(3 * i + x) * m + row] += share * moved[nu + row];
                    weights[row] -= share * friction->normal[(3 * i + x) * m + row];
                }
            }
        }
        /* mu and -kappa: multipliers come out with the opposite sign */
        status = cardan_mesh_motion_of(mesh, &here->system, NULL, weights, answer);
        for (ptrdiff_t i = 0; i < nu; i++) {
            by.along[j * nu + i] = answer[i];
            answer[i] = -answer[i];
        }
        if (status == 0)
            status = cardan_mesh_pull_impulse(here, moved, answer, NULL);
    }
    /* friction is told without multipliers */
    here->at.udot = here->at.lam = here->at.certainty = NULL;
    if (status == 0)
        status = cardan_mesh_pull_with(here, here->product->friction, &gift, 0);
    here->at = at;
    return status;
}

int cardan_mesh_push_certainty(cardan_place *here)
{
    const cardan_mesh *mesh = here->mesh;
    const cardan_mesh_friction *friction = &here->friction;
    const ptrdiff_t k = mesh->frictions, nu = mesh->nu, m = mesh->m;
    shares by = lay(mesh, here->event.shares);
    const cardan_state at = here->at;
    real *answer = here->event.answer;
    int status;

    memset(by.coefficient, 0, (size_t)(k * (1 + nu + 3 * m)) * sizeof(real));
    memset(here->way.certainty, 0, (size_t)k * sizeof(real));
    /* friction is told without multipliers */
    here->at.udot = here->at.lam = here->at.certainty = NULL;
    status = cardan_mesh_push_with(here, here->product->friction, take_friction, &by);
    here->at = at;
    for (ptrdiff_t j = 0; j < k && status == 0; j++) {
        const real *moved = friction->moved + j * (nu + m);

        /* the motion by a unit of it, on what the equations are now */
        status = cardan_mesh_push_motion(here, &here->system, moved, by.along + j * nu, answer);
        /* forces across lines by that motion */
        for (ptrdiff_t i = 0; i < k; i++) {
            real along[3], change = 0;
            const real size = force_of(mesh, friction, i, j, along);

            for (ptrdiff_t x = 0; x < 3; x++)
                for (ptrdiff_t row = 0; row < m; row++)
                    change += along[x]
                              * (by.normal[(3 * i + x) * m + row] * moved[nu + row]
                                 + friction->normal[(3 * i + x) * m + row] * answer[nu + row]);
            here->way.certainty[i] -= by.coefficient[i] * size + friction->coefficient[i] * change;
        }
    }
    return status;
}

/* Where the force of a unit of friction j across line i, with this weight, changes as the motion by that
 * unit does (nu + m): changes of the weights of what elements say, and weights (m) of its multipliers. */
static void force_along(const cardan_place *here, const shares *change, ptrdiff_t i, ptrdiff_t j,
                        real weight, real d_weight, const real *d_moved, const shares *by,
                        real *weights, real *d_weights)
{
    const cardan_mesh *mesh = here->mesh;
    const cardan_mesh_friction *friction = &here->friction;
    const ptrdiff_t m = mesh->m, nu = mesh->nu;
    const real *lam = friction->moved + j * (nu + m) + nu, *d_lam = d_moved + nu;
    const real c = friction->coefficient[i];
    real along[3], d_force[3], d_size = 0;
    const real size = force_of(mesh, friction, i, j, along);

    for (ptrdiff_t x = 0; x < 3; x++) {
        const ptrdiff_t line = (3 * i + x) * m;
        d_force[x] = cardan_dot(change->normal + line, lam, m)
                     + cardan_dot(friction->normal + line, d_lam, m);
        d_size += along[x] * d_force[x];
    }
    by->coefficient[i] += d_weight * size + weight * d_size;
    /* a force that is rounding has no direction */
    if (along[0] == 0 && along[1] == 0 && along[2] == 0)
        return;
    for (ptrdiff_t x = 0; x < 3; x++) {
        const real turn = (d_force[x] - along[x] * d_size) / size;
        const real share = weight * c * along[x];
        const real d_share =
            (d_weight * c + weight * change->coefficient[i]) * along[x] + weight * c * turn;
        for (ptrdiff_t row = 0; row < m; row++) {
            const ptrdiff_t at = (3 * i + x) * m + row;
            by->normal[at] += d_share * lam[row] + share * d_lam[row];
            weights[row] -= share * friction->normal[at];
            d_weights[row] -= d_share * friction->normal[at] + share * change->normal[at];
        }
    }
}

/* The change of the gradient, where `change` has what elements say of their friction changes by. */
int cardan_mesh_pull_certainty_along(const cardan_place *here, cardan_place *change, cardan_place *along)
{
    const cardan_mesh *mesh = here->mesh;
    const ptrdiff_t k = mesh->frictions, nu = mesh->nu, m = mesh->m;
    shares weight = lay(mesh, here->event.shares), d = lay(mesh, change->event.shares);
    shares by = lay(mesh, along->event.shares);
    const cardan_gift first = {give_friction, 0, NULL, &weight}, more = {give_friction, 0, NULL, &by};
    cardan_place gradient = *along;
    real *weights = along->event.moved, *d_weights = change->event.moved, *answer = along->event.answer;
    const real *by_motion = along->event.by_motion;
    int status = 0;

    gradient.product = here->product;
    memset(by.coefficient, 0, (size_t)(k * (1 + nu + 3 * m)) * sizeof(real));
    for (ptrdiff_t j = 0; j < k && status == 0; j++) {
        const real *moved = here->friction.moved + j * (nu + m);
        real *d_moved = change->event.answer;

        status = cardan_mesh_push_motion(change, &change->system, moved, d.along + j * nu, d_moved);
        memset(weights, 0, (size_t)m * sizeof(real));
        memset(d_weights, 0, (size_t)m * sizeof(real));
        for (ptrdiff_t i = 0; i < k; i++)
            force_along(here, &d, i, j, -here->by.certainty[i], -along->by.certainty[i], d_moved, &by,
                        weights, d_weights);
        /* mu and -kappa as they are, and how the equations that they weigh change */
        if (status == 0)
            status = cardan_mesh_motion_of(mesh, &along->system, NULL, weights, answer);
        for (ptrdiff_t i = 0; i < nu; i++)
            answer[i] = -answer[i];
        if (status == 0)
            status = cardan_mesh_pull_impulse(along, moved, answer, d_moved);
        /* so that they change themselves */
        for (ptrdiff_t row = 0; row < m; row++)
            d_weights[row] -= by_motion[nu + row];
        if (status == 0)
            status = cardan_mesh_motion_of(mesh, &along->system, by_motion, d_weights, answer);
        for (ptrdiff_t i = 0; i < nu; i++) {
            by.along[j * nu + i] = answer[i];
            answer[i] = -answer[i];
        }
        if (status == 0)
            status = cardan_mesh_pull_impulse(&gradient, moved, answer, NULL);
    }
    /* friction is told without multipliers */
    gradient.at.udot = gradient.at.lam = gradient.at.certainty = NULL;
    if (status == 0)
        status = cardan_mesh_pull_with(&gradient, gradient.product->friction, &more, 0);
    gradient.product = along->product;
    return status != 0 ? status
                       : cardan_mesh_pull_with(&gradient, gradient.product->friction, &first, 1);
}
