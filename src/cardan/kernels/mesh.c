/* Loops over the elements of a mesh.
 *
 * Part of cardan. Caller owns all memory.
 */
#include "mesh.h"
#include <stdint.h>

/* numbers, as many as fit side by side into the vectors of the lanes */
static ptrdiff_t whole(ptrdiff_t n)
{
    return (n + 7) / 8 * 8;
}

ptrdiff_t cardan_mesh_room(const cardan_mesh *mesh)
{
    return whole(mesh->lanes * (mesh->local + mesh->work + mesh->nr + 1)) + 8;
}

/* Vectors begin at multiples of their length. */
static real *aligned(real *room)
{
    return room + (8 - ((uintptr_t)room / sizeof(real)) % 8) % 8;
}

/* Numbers from `from` on into every stride-th entry of `to`. */
static real *put(const real *from, ptrdiff_t n, real *to, ptrdiff_t stride)
{
    for (ptrdiff_t i = 0; i < n; i++)
        to[i * stride] = from ? from[i] : 0;
    return to + n * stride;
}

/* The same of numbers that are picked from a block. */
static real *pick(const real *from, const ptrdiff_t *which, ptrdiff_t n, real *to,
                  ptrdiff_t stride)
{
    for (ptrdiff_t i = 0; i < n; i++)
        to[i * stride] = from ? from[which[i]] : 0;
    return to + n * stride;
}

/* Numbers of every place of an element. */
static real *put_places(const ptrdiff_t *starts, const ptrdiff_t *place, ptrdiff_t places,
                        const real *from, real *to, ptrdiff_t stride)
{
    for (ptrdiff_t k = 0; k < places; k++) {
        const ptrdiff_t start = starts[place[k]], n = starts[place[k] + 1] - start;
        to = put(from ? from + start : NULL, n, to, stride);
    }
    return to;
}

/* What one element reads, into lane 0 of `local`. Returns where the next block begins. */
static real *gather(const cardan_mesh *mesh, const cardan_group *g, ptrdiff_t element,
                    const cardan_state *at, real *local, ptrdiff_t stride)
{
    const ptrdiff_t *place = g->place + element * g->places, *rows = g->rows + 2 * element;

    local = put_places(mesh->q, place, g->places, at->q, local, stride);
    local = put_places(mesh->u, place, g->places, at->u, local, stride);
    local = put_places(mesh->u, place, g->places, at->udot, local, stride);
    local = put(at->lam ? at->lam + rows[0] : NULL, g->mp, local, stride);
    local = put(at->lam ? at->lam + rows[1] : NULL, g->m - g->mp, local, stride);
    local = pick(at->z, g->z ? g->z + element * g->nz : NULL, g->nz, local, stride);
    local = pick(at->s, g->s ? g->s + element * g->ns : NULL, g->ns, local, stride);
    if (!at->inner)
        return local;
    local = put_places(mesh->u, place, g->places, at->du, local, stride);
    return put(at->inner + g->inner_start + element * g->inner, g->inner, local, stride);
}

/* The blocks of `local` as functions read them. */
static cardan_in blocks(const cardan_group *g, const real *t, const real *r, const real *local,
                        ptrdiff_t stride)
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
    /* kinds with unknowns of their own have no internal states */
    if (g->inner > 0)
        in.z = in.du + g->nu * stride;
    return in;
}

/* The elements of a group, `stride` at a time. */
static int each(const cardan_mesh *mesh, const cardan_group *g, const cardan_state *at, int form,
                ptrdiff_t stride, cardan_taker *take, void *to, real *room)
{
    const cardan_form *f = &g->forms[form];
    real *t = room, *r = t + stride, *local = r + mesh->nr * stride, *out;
    int status = 0;

    for (ptrdiff_t lane = 0; lane < stride; lane++) {
        t[lane] = at->t;
        put(at->r, mesh->nr, r + lane, stride);
    }
    for (ptrdiff_t first = 0; first < g->count && status == 0; first += stride) {
        const ptrdiff_t left = g->count - first, filled = left < stride ? left : stride;
        cardan_in in = blocks(g, t, r, local, stride);

        out = local;
        /* lanes that are left over repeat the last element */
        for (ptrdiff_t lane = 0; lane < stride; lane++)
            out = gather(mesh, g, first + (lane < filled ? lane : filled - 1), at, local + lane,
                         stride) - lane;
        in.w = stride > 1 ? f->w_lanes + first * f->nw : f->w + first * f->nw;
        status = (stride > 1 ? f->lanes : f->one)(&in, out, out + f->size * stride);
        for (ptrdiff_t lane = 0; lane < filled && status == 0; lane++)
            take(mesh, g, first + lane, out + lane, stride, to);
    }
    return status;
}

/* A function of all elements that have it. */
int cardan_mesh_each(const cardan_mesh *mesh, const cardan_state *at, int form,
                     cardan_taker *take, void *to, real *room)
{
    int status = 0;

    room = aligned(room);
    for (ptrdiff_t k = 0; k < mesh->group_count && status == 0; k++) {
        const cardan_group *g = &mesh->groups[k];
        const cardan_form *f = &g->forms[form];
        const ptrdiff_t stride = f->lanes && g->count > 1 ? mesh->lanes : 1;

        if (f->one)
            status = each(mesh, g, at, form, stride, take, to, room);
    }
    return status;
}

/* Add numbers of an element to those of its places. */
static const real *add_places(const cardan_mesh *mesh, const cardan_group *g, ptrdiff_t element,
                              const real *out, ptrdiff_t stride, real *to)
{
    const ptrdiff_t *place = g->place + element * g->places;

    for (ptrdiff_t k = 0; k < g->places; k++)
        for (ptrdiff_t i = mesh->u[place[k]]; i < mesh->u[place[k] + 1]; i++, out += stride)
            to[i] += *out;
    return out;
}

/* Set the rows of an element: those of positions, then the others. */
static void set_rows(const cardan_group *g, ptrdiff_t element, const real *out, ptrdiff_t stride,
                     real *to)
{
    const ptrdiff_t *rows = g->rows + 2 * element;

    for (ptrdiff_t k = 0; k < g->m; k++)
        to[k < g->mp ? rows[0] + k : rows[1] + k - g->mp] = out[k * stride];
}

static void take_balance(const cardan_mesh *mesh, const cardan_group *g, ptrdiff_t element,
                         const real *out, ptrdiff_t stride, void *to)
{
    real *sum = to, *gaps = sum + mesh->nu, *rates = gaps + mesh->mp;
    const ptrdiff_t *rows = g->rows + 2 * element;

    out = add_places(mesh, g, element, out, stride, sum);
    for (ptrdiff_t k = 0; k < g->mp; k++, out += stride)
        gaps[rows[0] + k] = *out;
    set_rows(g, element, out, stride, rates);
}

int cardan_mesh_balance(const cardan_mesh *mesh, const cardan_state *at, real *out, real *room)
{
    for (ptrdiff_t i = 0; i < mesh->nu + mesh->mp + mesh->m; i++)
        out[i] = 0;
    return cardan_mesh_each(mesh, at, CARDAN_BALANCE, take_balance, out, room);
}

static void take_rows(const cardan_mesh *mesh, const cardan_group *g, ptrdiff_t element,
                      const real *out, ptrdiff_t stride, void *to)
{
    (void)mesh;
    set_rows(g, element, out, stride, to);
}

int cardan_mesh_gamma(const cardan_mesh *mesh, const cardan_state *at, real *gamma, real *room)
{
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        gamma[k] = 0;
    return cardan_mesh_each(mesh, at, CARDAN_GAMMA, take_rows, gamma, room);
}

typedef struct sum {
    real *out;
    ptrdiff_t size;
} sum;

static void take_sum(const cardan_mesh *mesh, const cardan_group *g, ptrdiff_t element,
                     const real *out, ptrdiff_t stride, void *to)
{
    const sum *total = to;

    (void)mesh, (void)g, (void)element;
    for (ptrdiff_t i = 0; i < total->size; i++)
        total->out[i] += out[i * stride];
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

static void take_result(const cardan_mesh *mesh, const cardan_group *g, ptrdiff_t element,
                        const real *out, ptrdiff_t stride, void *to)
{
    const stored *all = to;
    const ptrdiff_t size = g->forms[all->form].size;
    real *own = all->out;

    /* behind the results of the groups before */
    for (const cardan_group *other = mesh->groups; other != g; other++)
        if (other->forms[all->form].one)
            own += other->count * other->forms[all->form].size;
    for (ptrdiff_t i = 0; i < size; i++)
        own[element * size + i] = out[i * stride];
}

int cardan_mesh_results(const cardan_mesh *mesh, const cardan_state *at, int form, real *out,
                        real *room)
{
    stored all = {out, form};

    return cardan_mesh_each(mesh, at, form, take_result, &all, room);
}
