/* Loops over the elements of a mesh.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "mesh.h"
#include "mesh_lanes.h"
#include <stdint.h>

/* numbers, as many as fit side by side into the vectors of the lanes */
static ptrdiff_t round_up(ptrdiff_t n)
{
    return (n + 7) / 8 * 8;
}

ptrdiff_t cardan_mesh_room(const cardan_mesh *mesh)
{
    return round_up(mesh->lanes * (mesh->local + mesh->work + mesh->nr + 1)) + 8;
}

/* Vectors begin at multiples of their length. */
static real *aligned(real *room)
{
    return room + (8 - ((uintptr_t)room / sizeof(real)) % 8) % 8;
}

static real *zeros(ptrdiff_t n, real *to)
{
    for (ptrdiff_t i = 0; i < n; i++)
        to[i] = 0;
    return to + n;
}

/* Numbers of elements that are picked from a block of the scene. */
real *cardan_mesh_pick(const real *from, const ptrdiff_t *which, ptrdiff_t n, const ptrdiff_t *element,
                  ptrdiff_t lanes, real *to)
{
    for (ptrdiff_t i = 0; i < n; i++)
        for (ptrdiff_t lane = 0; lane < lanes; lane++)
            *to++ = from ? from[which[element[lane] * n + i]] : 0;
    return to;
}

/* Numbers of every place of an element by itself. */
static real *copy_places(const cardan_group *g, ptrdiff_t element, const ptrdiff_t *starts,
                         const real *from, real *to)
{
    const ptrdiff_t *place = g->place + element * g->places;

    for (ptrdiff_t k = 0; k < g->places; k++)
        for (ptrdiff_t i = starts[place[k]]; i < starts[place[k] + 1]; i++)
            *to++ = from[i];
    return to;
}

/* Numbers of every place of the elements, zeros where there are none. */
real *cardan_mesh_fetch_places(const cardan_group *g, const ptrdiff_t *element,
                          ptrdiff_t lanes, const ptrdiff_t *starts, const real *from, real *to)
{
    const real *rows[CARDAN_ELEMENT_LANES];

    if (lanes == 1 && from)
        return copy_places(g, element[0], starts, from, to);
    for (ptrdiff_t k = 0; k < g->places; k++) {
        const ptrdiff_t *entries = starts + g->place[element[0] * g->places + k], n = entries[1] - entries[0];

        for (ptrdiff_t lane = 0; lane < lanes && from; lane++)
            rows[lane] = from + starts[g->place[element[lane] * g->places + k]];
        to = from ? cardan_fetch(rows, n, to, lanes) : zeros(n * lanes, to);
    }
    return to;
}

/* Numbers of elements that stand one behind the other, those of the groups before them first. */
static real *follow(const real *from, ptrdiff_t first, ptrdiff_t n, const ptrdiff_t *element,
                    ptrdiff_t lanes, real *to)
{
    for (ptrdiff_t i = 0; i < n; i++)
        for (ptrdiff_t lane = 0; lane < lanes; lane++)
            *to++ = from ? from[first + element[lane] * n + i] : 0;
    return to;
}

/* Which of their events happen, how certain their friction is, and the responses they asked for. */
static real *gather_events(const cardan_mesh *mesh, const cardan_group *g, const ptrdiff_t *element,
                           ptrdiff_t lanes, const cardan_state *at, real *local)
{
    ptrdiff_t frictions = 0, responses = 0;

    for (const cardan_group *other = mesh->groups; other != g; other++) {
        frictions += other->count * other->frictions;
        responses += other->count * other->responses;
    }
    local = cardan_mesh_pick(at->e, g->events, g->ne, element, lanes, local);
    local = follow(at->certainty, frictions, g->frictions, element, lanes, local);
    return follow(at->responses, responses, g->responses, element, lanes, local);
}

/* Numbers of the rows of elements: the first `count` of m of a kind, those of positions first. */
real *cardan_mesh_pick_rows(const cardan_group *g, ptrdiff_t count, const ptrdiff_t *element,
                       ptrdiff_t lanes, const real *from, real *to)
{
    for (ptrdiff_t k = 0; k < count; k++)
        for (ptrdiff_t lane = 0; lane < lanes; lane++) {
            const ptrdiff_t *rows = g->rows + 2 * element[lane];
            *to++ = from ? from[k < g->mp ? rows[0] + k : rows[1] + k - g->mp] : 0;
        }
    return to;
}

/* What the elements read, side by side into `local`. Returns where the next block begins. */
static real *gather(const cardan_mesh *mesh, const cardan_group *g, const ptrdiff_t *element,
                    ptrdiff_t lanes, const cardan_state *at, real *local)
{
    local = cardan_mesh_fetch_places(g, element, lanes, mesh->q, at->q, local);
    local = cardan_mesh_fetch_places(g, element, lanes, mesh->u, at->u, local);
    local = cardan_mesh_fetch_places(g, element, lanes, mesh->u, at->udot, local);
    local = cardan_mesh_pick_rows(g, g->m, element, lanes, at->lam, local);
    local = cardan_mesh_pick(at->z, g->z, g->nz, element, lanes, local);
    local = cardan_mesh_pick(at->s, g->s, g->ns, element, lanes, local);
    if (at->inner || at->behind || at->certainty)
        local = cardan_mesh_fetch_places(g, element, lanes, mesh->u, at->behind ? at->behind : at->du,
                                         local);
    if (at->behind || at->certainty)
        local = gather_events(mesh, g, element, lanes, at, local);
    for (ptrdiff_t i = 0; at->inner && i < g->inner; i++)
        for (ptrdiff_t lane = 0; lane < lanes; lane++)
            *local++ = at->inner[g->inner_start + element[lane] * g->inner + i];
    return at->gift ? at->gift->give(mesh, g, element, lanes, at->gift, local) : local;
}

/* The blocks of `local` as functions read them. */
static cardan_in blocks(const cardan_group *g, const real *t, const real *r, const real *local,
                        ptrdiff_t stride, int events)
{
    cardan_in in = {0};

    in.t = t;
    in.r = r;
    in.q = local;
    in.u = in.q + g->nq * stride;
    in.udot = in.u + g->nu * stride;
    in.lam = in.udot + g->nu * stride;
    in.z = in.lam + g->m * stride;
    in.s = in.z + g->nz * stride;
    in.du = in.s + g->ns * stride;
    in.e = in.du + g->nu * stride;
    in.tau = in.e + g->ne * stride;
    /* derivatives read nothing else behind the states, but for those of events */
    in.v = events ? in.tau + (g->frictions + g->responses) * stride : in.du;
    /* kinds with unknowns of their own have no internal states */
    if (g->inner > 0)
        in.z = in.du + g->nu * stride;
    return in;
}

/* Time and inputs for elements side by side. Returns where what they read begins. */
static real *same_for_all(const cardan_mesh *mesh, const cardan_state *at, ptrdiff_t lanes, real *to)
{
    for (ptrdiff_t lane = 0; lane < lanes; lane++)
        *to++ = at->t;
    for (ptrdiff_t i = 0; i < mesh->nr; i++)
        for (ptrdiff_t lane = 0; lane < lanes; lane++)
            *to++ = at->r ? at->r[i] : 0;
    return to;
}

/* A function of the elements of a group, if they have it, in blocks of as many as it takes. */
int cardan_mesh_group(const cardan_mesh *mesh, const cardan_group *g, const cardan_form *f,
                      const cardan_state *at, cardan_taker *take, void *to, real *room)
{
    const ptrdiff_t lanes = f->lanes;
    int status = 0;

    if (!f->call)
        return 0;
    real *t = aligned(room), *local = same_for_all(mesh, at, lanes, t);
    cardan_in in = blocks(g, t, t + lanes, local, lanes, at->behind || at->certainty);

    for (ptrdiff_t first = 0; first < g->count && status == 0; first += lanes) {
        const ptrdiff_t left = g->count - first;
        cardan_element_lanes some = {lanes, left < lanes ? left : lanes, {0}};

        /* lanes that are left over repeat the last element */
        for (ptrdiff_t lane = 0; lane < lanes; lane++)
            some.element[lane] = first + (lane < some.filled ? lane : some.filled - 1);
        real *results = gather(mesh, g, some.element, lanes, at, local);
        in.w = f->w + first * f->nw;
        status = f->call(&in, results, results + f->size * lanes);
        if (status == 0)
            take(mesh, g, &some, results, to);
    }
    return status;
}

/* The same of all elements. */
int cardan_mesh_each(const cardan_mesh *mesh, const cardan_state *at, int form,
                     cardan_taker *take, void *to, real *room)
{
    int status = 0;

    for (ptrdiff_t k = 0; k < mesh->group_count && status == 0; k++)
        status = cardan_mesh_group(mesh, &mesh->groups[k], &mesh->groups[k].forms[form], at, take, to,
                                   room);
    return status;
}

/* Set the rows of elements: those of positions, then the others. */
static void set_rows(const cardan_group *g, const cardan_element_lanes *some, const real *out, real *to)
{
    for (ptrdiff_t k = 0; k < g->m; k++, out += some->lanes)
        for (ptrdiff_t lane = 0; lane < some->filled; lane++) {
            const ptrdiff_t *rows = g->rows + 2 * some->element[lane];
            to[k < g->mp ? rows[0] + k : rows[1] + k - g->mp] = out[lane];
        }
}

static void take_balance(const cardan_mesh *mesh, const cardan_group *g,
                         const cardan_element_lanes *some, real *out, void *to)
{
    real *sum = to, *gaps = sum + mesh->nu, *rates = gaps + mesh->mp, *rows[CARDAN_ELEMENT_LANES];

    for (ptrdiff_t k = 0; k < g->places; k++) {
        const ptrdiff_t *entries = mesh->u + g->place[some->element[0] * g->places + k];
        const ptrdiff_t n = entries[1] - entries[0];

        for (ptrdiff_t lane = 0; lane < some->filled; lane++)
            rows[lane] = sum + mesh->u[g->place[some->element[lane] * g->places + k]];
        cardan_spill(out, n, some->lanes, rows, some->filled);
        out += n * some->lanes;
    }
    for (ptrdiff_t k = 0; k < g->mp; k++, out += some->lanes)
        for (ptrdiff_t lane = 0; lane < some->filled; lane++)
            gaps[g->rows[2 * some->element[lane]] + k] = out[lane];
    set_rows(g, some, out, rates);
}

int cardan_mesh_balance(const cardan_mesh *mesh, const cardan_state *at, real *out, real *room)
{
    for (ptrdiff_t i = 0; i < mesh->nu + mesh->mp + mesh->m; i++)
        out[i] = 0;
    return cardan_mesh_each(mesh, at, CARDAN_BALANCE, take_balance, out, room);
}

int cardan_mesh_gaps(const cardan_mesh *mesh, const cardan_state *at, real *out, real *room)
{
    int status = 0;

    (void)zeros(mesh->nu + mesh->mp + mesh->m, out);
    for (ptrdiff_t k = 0; k < mesh->group_count && status == 0; k++) {
        const cardan_group *g = &mesh->groups[k];
        if (g->m > 0)
            status = cardan_mesh_group(mesh, g, &g->forms[CARDAN_BALANCE], at, take_balance, out,
                                       room);
    }
    return status;
}

static void take_rows(const cardan_mesh *mesh, const cardan_group *g, const cardan_element_lanes *some,
                      real *out, void *to)
{
    (void)mesh;
    set_rows(g, some, out, to);
}

int cardan_mesh_gamma(const cardan_mesh *mesh, const cardan_state *at, real *gamma, real *room)
{
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        gamma[k] = 0;
    return cardan_mesh_each(mesh, at, CARDAN_GAMMA, take_rows, gamma, room);
}

static void take_zdot(const cardan_mesh *mesh, const cardan_group *g, const cardan_element_lanes *some,
                      real *out, void *to)
{
    real *zdot = to;

    (void)mesh;
    for (ptrdiff_t lane = 0; lane < some->filled; lane++)
        for (ptrdiff_t i = 0; i < g->z_states; i++)
            zdot[g->z[some->element[lane] * g->nz + i]] = out[i * some->lanes + lane];
}

int cardan_mesh_zdot(const cardan_mesh *mesh, const cardan_state *at, real *zdot, real *room)
{
    (void)zeros(mesh->nz, zdot);
    return cardan_mesh_each(mesh, at, CARDAN_ZDOT, take_zdot, zdot, room);
}

const real *cardan_mesh_add_picked(const cardan_element_lanes *some, const ptrdiff_t *which, ptrdiff_t n,
                              const real *out, real *to)
{
    for (ptrdiff_t i = 0; i < n; i++, out += some->lanes)
        for (ptrdiff_t lane = 0; lane < some->filled; lane++)
            to[which[some->element[lane] * n + i]] += out[lane];
    return out;
}

const real *cardan_mesh_add_places(const cardan_group *g, const cardan_element_lanes *some,
                              const ptrdiff_t *starts, const real *out, real *to)
{
    for (ptrdiff_t k = 0; k < g->places; k++) {
        const ptrdiff_t *entries = starts + g->place[some->element[0] * g->places + k];
        for (ptrdiff_t i = 0, n = entries[1] - entries[0]; i < n; i++, out += some->lanes)
            for (ptrdiff_t lane = 0; lane < some->filled; lane++)
                to[starts[g->place[some->element[lane] * g->places + k]] + i] += out[lane];
    }
    return out;
}

const real *cardan_mesh_add_rows(const cardan_group *g, ptrdiff_t count,
                                 const cardan_element_lanes *some, const real *out, real *to)
{
    for (ptrdiff_t k = 0; k < count; k++, out += some->lanes)
        for (ptrdiff_t lane = 0; lane < some->filled; lane++) {
            const ptrdiff_t *rows = g->rows + 2 * some->element[lane];
            to[k < g->mp ? rows[0] + k : rows[1] + k - g->mp] += out[lane];
        }
    return out;
}

typedef struct sum {
    real *out;
    ptrdiff_t size;
} sum;

static void take_sum(const cardan_mesh *mesh, const cardan_group *g, const cardan_element_lanes *some,
                     real *out, void *to)
{
    const sum *total = to;

    (void)mesh, (void)g;
    for (ptrdiff_t lane = 0; lane < some->filled; lane++)
        for (ptrdiff_t i = 0; i < total->size; i++)
            total->out[i] += out[i * some->lanes + lane];
}

int cardan_mesh_sum(const cardan_mesh *mesh, const cardan_state *at, int form, ptrdiff_t size,
                    real *out, real *room)
{
    sum total = {out, size};

    for (ptrdiff_t i = 0; i < size; i++)
        out[i] = 0;
    return cardan_mesh_each(mesh, at, form, take_sum, &total, room);
}

typedef struct stored {
    real *out;
    int form;
} stored;

static void take_result(const cardan_mesh *mesh, const cardan_group *g, const cardan_element_lanes *some,
                        real *out, void *to)
{
    const stored *all = to;
    const ptrdiff_t size = g->forms[all->form].size;
    real *entries = all->out;

    /* behind the results of the groups before */
    for (const cardan_group *other = mesh->groups; other != g; other++)
        if (other->forms[all->form].call)
            entries += other->count * other->forms[all->form].size;
    for (ptrdiff_t lane = 0; lane < some->filled; lane++)
        for (ptrdiff_t i = 0; i < size; i++)
            entries[some->element[lane] * size + i] = out[i * some->lanes + lane];
}

int cardan_mesh_results(const cardan_mesh *mesh, const cardan_state *at, int form, real *out,
                        real *room)
{
    stored all = {out, form};

    return cardan_mesh_each(mesh, at, form, take_result, &all, room);
}
