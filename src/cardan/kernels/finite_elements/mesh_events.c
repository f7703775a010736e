/* Events of the elements of a mesh: when they happen, and what they change.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Impulses P along velocities J u go through the whole mesh: M du = Jᵀ P + Gᵀ P', G du = 0,
 * J (u + du) as the events ask, without the rows that modes hold: elements say themselves what these
 * bear. With the columns of X = A⁻¹ Jᵀ, A of masses and constraints, J X P = -missing.
 * Source: F. Pfeiffer, Ch. Glocker, Multibody Dynamics with Unilateral Contacts (1996), chapter 8.
 */
#include "mesh_calls.h"
#include <math.h>
#include <string.h>

/* how often impulses that would pull are left out before the rest is taken as it is */
enum { PASSES = 3 };
/* kinds of rows; the last asks for a response, and pushes nothing */
enum { BILATERAL, UNILATERAL, SLOW_RELEASE, RESPONSE };
enum { KIND, ACTIVE, MISSING, RELEASE_SPEED, ROW };
/* what is left of the response of an impulse beside others where it follows from them */
static const real DEPENDENT = 1e-10;
/* response of a velocity that constraints hold, of that of its speeds one by one: rounding */
static const real IMMOBILE = 1e-12;

/* What a transition works with. */
typedef struct jumping {
    real *rows;      /* (jumps, ROW) */
    real *J, *X;     /* (jumps, nu) velocities, and speeds by an impulse along each */
    real *R, *left;  /* (jumps, jumps) J X, and as it is eliminated */
    real *P, *right; /* (jumps) impulses, missing speeds */
    real *behind;    /* (nu) */
    real *responses; /* of all elements that ask for some */
} jumping;

static ptrdiff_t lay(const cardan_mesh *mesh, real *block, jumping *to)
{
    const ptrdiff_t k = mesh->jumps;
    ptrdiff_t used = 0;

    to->rows = cardan_reserve(block, &used, ROW * k);
    to->J = cardan_reserve(block, &used, k * mesh->nu);
    to->X = cardan_reserve(block, &used, k * mesh->nu);
    to->R = cardan_reserve(block, &used, k * k);
    to->left = cardan_reserve(block, &used, k * k);
    to->P = cardan_reserve(block, &used, k);
    to->right = cardan_reserve(block, &used, k);
    to->behind = cardan_reserve(block, &used, mesh->nu);
    to->responses = cardan_reserve(block, &used, mesh->responses);
    return used;
}

ptrdiff_t cardan_mesh_jump_room(const cardan_mesh *mesh)
{
    jumping none;

    return mesh->ne > 0 ? lay(mesh, NULL, &none) : 0;
}

/* where values of events go, and whether some of them read accelerations or multipliers now */
typedef struct signs {
    real *values;
    int *solved;
} signs;

static void take_signs(const cardan_mesh *mesh, const cardan_group *g,
                       const cardan_element_lanes *some, real *out, void *to)
{
    const signs *all = to;

    (void)mesh;
    for (ptrdiff_t lane = 0; lane < some->filled; lane++) {
        for (ptrdiff_t i = 0; i < g->ne; i++)
            all->values[g->events[some->element[lane] * g->ne + i]] = out[i * some->lanes + lane];
        if (out[g->ne * some->lanes + lane] != 0)
            *all->solved = 1;
    }
}

/* Values (ne) of all events; accelerations and multipliers are those of the present modes, which are
 * solved for only where some value reads them in these modes. */
int cardan_mesh_call_events(const cardan_in *in, real *out, real *work)
{
    const cardan_mesh *mesh = cardan_mesh_of(in);
    real *solution = work + cardan_mesh_call_work(mesh) - mesh->nu - mesh->m;
    cardan_state at = cardan_state_of(in);
    int solved = 0, status;
    signs all = {out, &solved};

    at.udot = at.lam = NULL;
    status = cardan_mesh_each(mesh, &at, CARDAN_SIGNS, take_signs, &all, work);
    if (status != 0 || !solved)
        return status;
    status = cardan_mesh_accelerations(mesh, &at, NULL, solution, work);
    at.udot = solution;
    at.lam = solution + mesh->nu;
    at.certainty = mesh->frictions > 0 ? cardan_mesh_certainty(mesh, work) : NULL;
    return status != 0 ? status : cardan_mesh_each(mesh, &at, CARDAN_SIGNS, take_signs, &all, work);
}

static void take_jumps(const cardan_mesh *mesh, const cardan_group *g,
                       const cardan_element_lanes *some, real *out, void *to)
{
    const jumping *all = to;
    const ptrdiff_t lanes = some->lanes;
    ptrdiff_t first = 0;

    for (const cardan_group *other = mesh->groups; other != g; other++)
        first += other->count * other->jumps;
    for (ptrdiff_t lane = 0; lane < some->filled; lane++)
        for (ptrdiff_t j = 0; j < g->jumps; j++) {
            const ptrdiff_t number = first + some->element[lane] * g->jumps + j;
            const ptrdiff_t *place = g->place + some->element[lane] * g->places;
            const real *gradient = out + (ROW * g->jumps + j * g->nu) * lanes + lane;
            for (ptrdiff_t i = 0; i < ROW; i++)
                all->rows[ROW * number + i] = out[(ROW * j + i) * lanes + lane];
            for (ptrdiff_t k = 0; k < g->places; k++)
                for (ptrdiff_t i = mesh->u[place[k]]; i < mesh->u[place[k] + 1]; i++) {
                    all->J[number * mesh->nu + i] += *gradient;
                    gradient += lanes;
                }
        }
}

/* Masses and constraints at a state, factored; `released`: modes hold nothing. */
static int factored(const cardan_mesh *mesh, const cardan_state *at, int released,
                    cardan_mesh_system *system, real *work)
{
    const cardan_assembly parts = {{0, 0, 1}, 0, 0, NULL, released};
    real *missing = work + cardan_mesh_lay(mesh, work, system);
    cardan_state still = *at;
    int assembled, status;

    /* impulses make no friction */
    still.lam = NULL;
    status = cardan_mesh_balance(mesh, &still, missing, system->work);
    system->open = missing + mesh->nu;
    return status != 0 ? status : cardan_mesh_factor(mesh, &still, &parts, system, &assembled);
}

/* Speeds x (nu) by an impulse along a velocity. */
static int responds(const cardan_mesh *mesh, cardan_mesh_system *system, const real *velocity, real *x)
{
    int status;

    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        system->right[i] = velocity[i];
    for (ptrdiff_t k = 0; k < mesh->m; k++)
        system->right[mesh->unknown[k]] = 0;
    status = cardan_mesh_solve(mesh, system);
    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        x[i] = system->solution[i];
    return status;
}

/* What elements asked for: responses with all that modes hold. */
static int respond(const cardan_mesh *mesh, const cardan_state *at, const jumping *all, real *work)
{
    cardan_mesh_system system = {0};
    real *to = all->responses;
    int status = mesh->responses > 0 ? factored(mesh, at, 0, &system, work) : 0;

    /* as many as the tables have room for, whatever functions ask for */
    for (ptrdiff_t j = 0; j < mesh->jumps && status == 0 && to < all->responses + mesh->responses; j++) {
        const real *velocity = all->J + j * mesh->nu;
        if ((int)all->rows[ROW * j + KIND] != RESPONSE)
            continue;
        status = responds(mesh, &system, velocity, all->behind);
        *to++ = cardan_dot(velocity, all->behind, mesh->nu);
    }
    return status;
}

/* P (n) with R P = right among active rows, 0 of others and of those that follow from others. */
static void eliminate(const jumping *all, ptrdiff_t n)
{
    real *a = all->left;

    for (ptrdiff_t i = 0; i < n; i++) {
        all->P[i] = 0;
        all->right[i] = -all->rows[ROW * i + MISSING];
        for (ptrdiff_t j = 0; j < n; j++)
            a[i * n + j] = all->R[i * n + j];
    }
    /* R is symmetric and not negative: by its pivots, the largest of what it was first */
    for (ptrdiff_t step = 0; step < n; step++) {
        ptrdiff_t pivot = -1;
        real best = DEPENDENT;
        for (ptrdiff_t i = 0; i < n; i++) {
            const real share = a[i * n + i] / all->R[i * n + i];
            if (all->rows[ROW * i + ACTIVE] != 0 && all->P[i] == 0 && share > best)
                best = share, pivot = i;
        }
        if (pivot < 0)
            break;
        all->P[pivot] = 1; /* it is one of them */
        for (ptrdiff_t i = 0; i < n; i++) {
            const real factor = i == pivot ? 0 : a[i * n + pivot] / a[pivot * n + pivot];
            for (ptrdiff_t j = 0; j < n && factor != 0; j++)
                a[i * n + j] -= factor * a[pivot * n + j];
            all->right[i] -= factor * all->right[pivot];
        }
    }
    for (ptrdiff_t i = 0; i < n; i++)
        all->P[i] = all->P[i] != 0 ? all->right[i] / a[i * n + i] : 0;
}

/* Leave out impulses along velocities that constraints hold: nothing answers them. */
static void leave_immobile(const cardan_mesh *mesh, const cardan_mesh_system *system, const jumping *all)
{
    for (ptrdiff_t i = 0; i < mesh->jumps; i++) {
        real alone = 0;
        for (ptrdiff_t k = 0; k < mesh->nu; k++)
            alone += pow(all->J[i * mesh->nu + k] * system->units[k], 2);
        if (!(all->R[i * mesh->jumps + i] > IMMOBILE * alone))
            all->rows[ROW * i + ACTIVE] = 0;
    }
}

/* Leave out impulses that would pull where they can only push. */
static void leave_out(const jumping *all, ptrdiff_t n, ptrdiff_t unilateral)
{
    for (ptrdiff_t i = 0; i < n; i++) {
        real *row = all->rows + ROW * i, release = 0;
        const int kind = (int)row[KIND];
        if (row[ACTIVE] == 0 || (kind != UNILATERAL && kind != SLOW_RELEASE))
            continue;
        /* against the impulse that gives it that speed where nothing else holds it */
        if (kind == SLOW_RELEASE && unilateral > 1)
            release = row[RELEASE_SPEED] / all->R[i * n + i];
        if (!(-all->P[i] <= release))
            row[ACTIVE] = 0;
    }
}

/* Speeds behind all impulses. */
static int jump(const cardan_mesh *mesh, const cardan_state *at, const jumping *all, real *work)
{
    const ptrdiff_t n = mesh->jumps;
    cardan_mesh_system system = {0};
    ptrdiff_t active = 0, unilateral = 0;
    int status = 0;

    for (ptrdiff_t i = 0; i < n; i++) {
        const int kind = (int)all->rows[ROW * i + KIND];
        active += all->rows[ROW * i + ACTIVE] != 0;
        unilateral += kind == UNILATERAL || kind == SLOW_RELEASE;
    }
    for (ptrdiff_t i = 0; i < mesh->nu; i++)
        all->behind[i] = at->u[i];
    if (active == 0)
        return 0;
    status = factored(mesh, at, 1, &system, work);
    for (ptrdiff_t i = 0; i < n && status == 0; i++)
        status = responds(mesh, &system, all->J + i * mesh->nu, all->X + i * mesh->nu);
    for (ptrdiff_t i = 0; i < n; i++)
        for (ptrdiff_t j = 0; j < n; j++)
            all->R[i * n + j] = cardan_dot(all->J + i * mesh->nu, all->X + j * mesh->nu, mesh->nu);
    leave_immobile(mesh, &system, all);
    for (ptrdiff_t attempt = 0; attempt == 0 || (attempt <= PASSES && attempt < unilateral); attempt++) {
        if (attempt > 0)
            leave_out(all, n, unilateral);
        eliminate(all, n);
    }
    for (ptrdiff_t j = 0; j < n; j++)
        for (ptrdiff_t i = 0; i < mesh->nu; i++)
            all->behind[i] += all->P[j] * all->X[j * mesh->nu + i];
    return status;
}

/* where new states go */
typedef struct states {
    real *z, *s;
} states;

static void take_change(const cardan_mesh *mesh, const cardan_group *g,
                        const cardan_element_lanes *some, real *out, void *to)
{
    const states *all = to;

    (void)mesh;
    for (ptrdiff_t lane = 0; lane < some->filled; lane++) {
        const real *entries = out + lane;
        for (ptrdiff_t i = 0; i < g->z_states; i++, entries += some->lanes)
            all->z[g->z[some->element[lane] * g->nz + i]] = *entries;
        for (ptrdiff_t i = 0; i < g->s_states; i++, entries += some->lanes)
            all->s[g->s[some->element[lane] * g->ns + i]] = *entries;
    }
}

/* u (nu), z (nz) and s (ns) behind the events that happen. */
int cardan_mesh_call_transition(const cardan_in *in, real *out, real *work)
{
    const cardan_mesh *mesh = cardan_mesh_of(in);
    real *solution = work + cardan_mesh_call_work(mesh) - mesh->nu - mesh->m;
    real *room = solution - cardan_mesh_jump_room(mesh);
    cardan_state at = cardan_state_of(in);
    states behind = {out + mesh->nu, out + mesh->nu + mesh->nz};
    jumping all;
    int status;

    (void)lay(mesh, room, &all);
    at.udot = at.lam = NULL;
    status = cardan_mesh_accelerations(mesh, &at, NULL, solution, work);
    at.udot = solution;
    at.lam = solution + mesh->nu;
    at.e = in->e;
    at.behind = in->u;
    at.responses = all.responses;
    memset(room, 0, (size_t)cardan_mesh_jump_room(mesh) * sizeof(real));
    if (status == 0)
        status = cardan_mesh_each(mesh, &at, CARDAN_JUMPS, take_jumps, &all, work);
    if (status == 0)
        status = respond(mesh, &at, &all, work);
    if (status == 0)
        status = jump(mesh, &at, &all, work);
    if (status != 0)
        return status;
    at.behind = all.behind;
    memcpy(out, all.behind, (size_t)mesh->nu * sizeof(real));
    for (ptrdiff_t i = 0; i < mesh->nz; i++)
        behind.z[i] = in->z[i];
    for (ptrdiff_t i = 0; i < mesh->ns; i++)
        behind.s[i] = in->s[i];
    return cardan_mesh_each(mesh, &at, CARDAN_CHANGE, take_change, &behind, work);
}
