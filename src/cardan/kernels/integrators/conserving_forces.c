/* Forces of elements in a step of the energy-momentum method: a discrete derivative of what each
 * stores, along the part of the step that changes it.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Half way an element gives the force f = L_x of its own places, with L = V - lam . g. Its work f . x
 * over the increment x differs from L' - L by terms of the third order in the step. They are made up
 * for along c = W P x,
 *
 *     f + c (L' - L - f . x) / (c . x),
 *
 * where P takes the motions of all places together off x that leave V and g as they are: all rigid ones
 * if the element knows nothing of the ground (6), translations across gravity and rotations about it
 * if it is heavy (3). So c is a force in equilibrium, as f is half way: nothing is taken from momenta.
 * Where nothing but such a motion happens, L' = L and f . x = 0 by themselves. At a solution g = 0 at
 * both ends: constraints do no work.
 * Source: O. Gonzalez, J. Nonlinear Sci. 6 (1996) 449-467 (discrete derivatives of invariants).
 */
#include "conserving.h"
#include <float.h>
#include <math.h>

/* parts of an increment, squared, that are rounding; of energies, what sums of some terms leave */
static const real ROUNDING = 1e-28, NOISE = 4 * DBL_EPSILON;
/* corrections change by no larger part to take back what roundings added */
static const real MOST = 0.01;
enum { RIGID = 6, HEAVY = 3 };

/* The number of an element in the order of the tables. */
static ptrdiff_t number_of(const cardan_mesh *mesh, const cardan_group *g, ptrdiff_t element)
{
    for (const cardan_group *other = mesh->groups; other != g; other++)
        element += other->count;
    return element;
}

static void take_potential(const cardan_mesh *mesh, const cardan_group *g,
                           const cardan_element_lanes *some, real *out, void *to)
{
    for (ptrdiff_t lane = 0; lane < some->filled; lane++)
        ((real *)to)[number_of(mesh, g, some->element[lane])] = out[some->lanes + lane];
}

/* What every element stores at q. */
int cardan_conserving_potentials(const cardan_run *run, const cardan_conserving *v, real t,
                                 const real *q, real *potentials)
{
    const cardan_state at = cardan_conserving_state(run, t, q);

    for (ptrdiff_t i = 0; i < v->elements; i++)
        potentials[i] = 0;
    return cardan_mesh_each(v->mesh, &at, CARDAN_ENERGY, take_potential, potentials,
                            v->system.work);
}

/* Total energy at t. */
int cardan_conserving_energy(const cardan_run *run, const cardan_conserving *v, real *energy)
{
    cardan_state at = cardan_conserving_state(run, run->t, run->y);
    real both[2];
    int status;

    at.u = run->y + v->nq;
    status = cardan_mesh_sum(v->mesh, &at, CARDAN_ENERGY, 2, both, v->system.work);
    *energy = both[0] + both[1];
    return status;
}

/* What constraints and their rates are open by at y (n), into `gaps`. */
int cardan_conserving_gaps(const cardan_run *run, const cardan_conserving *v, real t,
                           const real *y)
{
    cardan_state at = cardan_conserving_state(run, t, y);

    at.u = y + v->nq;
    return v->m > 0 ? cardan_mesh_balance(v->mesh, &at, v->gaps, v->system.work) : 0;
}

/* The nodes of an element half way: their middle, and the size of the element squared. */
static ptrdiff_t middle_of(const cardan_conserving *v, const cardan_group *g,
                           const ptrdiff_t *place, real *middle, real *square)
{
    ptrdiff_t nodes = 0;
    real sum = 0;

    for (int i = 0; i < 3; i++)
        middle[i] = 0;
    for (ptrdiff_t k = 0; k < g->places; k++)
        if (v->pose[place[k]] != 0) {
            nodes++;
            for (int i = 0; i < 3; i++)
                middle[i] += v->half[v->mesh->q[place[k]] + 4 + i];
        }
    for (int i = 0; i < 3 && nodes > 0; i++)
        middle[i] /= (real)nodes;
    for (ptrdiff_t k = 0; k < g->places; k++)
        if (v->pose[place[k]] != 0)
            for (int i = 0; i < 3; i++)
                sum += pow(v->half[v->mesh->q[place[k]] + 4 + i] - middle[i], 2);
    *square = sum > 0 ? sum / (real)nodes : 1;
    return nodes;
}

static real dot(const real *a, const real *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* The rotation w that moments (3) make against the symmetric resistance A (3, 3). */
static void resisted(const real *A, const real *moment, real *w)
{
    real columns[3][3];

    cardan_cross(A + 3, A + 6, columns[0]);
    cardan_cross(A + 6, A, columns[1]);
    cardan_cross(A, A + 3, columns[2]);
    for (int i = 0; i < 3; i++)
        w[i] = (columns[0][i] * moment[0] + columns[1][i] * moment[1] + columns[2][i] * moment[2])
               / dot(A, columns[0]);
}

/* Of increments x, rotations along the ground, the motion of all nodes together that is nearest:
 * v of their middle and w. */
static void rigid_part(const cardan_conserving *c, const cardan_group *g, const ptrdiff_t *place,
                     const real *x, const real *middle, real square, ptrdiff_t nodes, real *v,
                     real *w)
{
    const real symmetry = c->symmetry[g - c->mesh->groups];
    real A[9] = {0}, moment[3] = {0}, arm[3], lever[3], along;

    for (int i = 0; i < 3; i++)
        v[i] = w[i] = 0;
    if (symmetry == 0 || nodes == 0)
        return;
    for (ptrdiff_t k = 0; k < g->places; k++) {
        const ptrdiff_t to = c->mesh->u[place[k]], n = c->mesh->u[place[k] + 1] - to;
        for (int i = 0; i < 3 && c->pose[place[k]] != 0; i++)
            arm[i] = c->half[c->mesh->q[place[k]] + 4 + i] - middle[i];
        if (c->pose[place[k]] != 0) {
            cardan_cross(arm, x + 3, lever);
            for (int i = 0; i < 3; i++) {
                v[i] += x[3 + i] / (real)nodes;
                moment[i] += x[i] + lever[i] / square;
                A[4 * i] += 1 + dot(arm, arm) / square;
                for (int j = 0; j < 3; j++)
                    A[3 * i + j] -= arm[i] * arm[j] / square;
            }
        }
        x += n;
    }
    if (symmetry == (real)RIGID) {
        resisted(A, moment, w);
        return;
    }
    /* what is heavy: not down, and about the vertical alone */
    along = dot(v, c->down);
    for (int i = 0; i < 3; i++)
        v[i] -= along * c->down[i];
    for (int i = 0; i < 3; i++)
        lever[i] = dot(A + 3 * i, c->down);
    along = dot(moment, c->down) / dot(lever, c->down);
    for (int i = 0; i < 3; i++)
        w[i] = along * c->down[i];
}

/* The force c of unit size along the part of an increment x (nu) that changes an element; x with
 * rotations along the axes of the nodes. Returns c . x. */
static real changing(const cardan_conserving *c, const cardan_group *g, const ptrdiff_t *place,
                     real *x, real *along)
{
    real middle[3], v[3], w[3], square, size = 0, product = 0;
    const ptrdiff_t nodes = middle_of(c, g, place, middle, &square);
    real *local = along;

    for (ptrdiff_t i = 0; i < g->nu; i++)
        along[i] = x[i];
    for (ptrdiff_t k = 0; k < g->places; k++) {
        const ptrdiff_t at = c->mesh->q[place[k]];
        real R[9];
        if (c->pose[place[k]] != 0) {
            cardan_rotation(c->half + at, R);
            for (int i = 0; i < 3; i++)
                local[i] = dot(R + 3 * i, x + (local - along));
        }
        local += c->mesh->u[place[k] + 1] - c->mesh->u[place[k]];
    }
    rigid_part(c, g, place, along, middle, square, nodes, v, w);
    local = along;
    for (ptrdiff_t k = 0; k < g->places; k++) {
        const ptrdiff_t at = c->mesh->q[place[k]], n = c->mesh->u[place[k] + 1] - c->mesh->u[place[k]];
        real R[9], arm[3], lever[3], rotated[3];
        if (c->pose[place[k]] != 0) {
            for (int i = 0; i < 3; i++) {
                arm[i] = c->half[at + 4 + i] - middle[i];
                rotated[i] = local[i] - w[i];
            }
            cardan_cross(w, arm, lever);
            cardan_rotation(c->half + at, R);
            for (int i = 0; i < 3; i++) {
                local[i] = R[i] * rotated[0] + R[3 + i] * rotated[1] + R[6 + i] * rotated[2];
                local[3 + i] = (local[3 + i] - v[i] - lever[i]) / square;
            }
        }
        local += n;
    }
    for (ptrdiff_t i = 0; i < g->nu; i++) {
        product += along[i] * x[i];
        size += x[i] * x[i];
    }
    return product > ROUNDING * size ? product : 0;
}

/* By how much V - lam . g of an element grows over a step beyond the work of its forces; nothing
 * where that is rounding, which counts for much over small increments. */
static real unmet(const cardan_conserving *v, const cardan_group *g, ptrdiff_t element,
                  const real *force, ptrdiff_t stride, const real *x)
{
    const ptrdiff_t *place = g->place + element * g->places, row = g->rows[2 * element];
    const ptrdiff_t n = number_of(v->mesh, g, element);
    real sum = v->after[n] - v->before[n], energy = fabs(v->after[n]) + fabs(v->before[n]);
    real forces = 0, largest = 0;

    for (ptrdiff_t k = row; k < row + g->mp; k++) {
        sum -= v->lam_new[k] * (v->gaps[v->nu + k] - v->open[k]);
        forces += fabs(v->lam_new[k]);
    }
    for (ptrdiff_t i = 0; i < g->nu; i++) {
        sum -= force[i * stride] * x[i];
        forces += fabs(force[i * stride]);
    }
    for (ptrdiff_t k = 0; k < g->places; k++)
        for (ptrdiff_t i = v->mesh->q[place[k]]; i < v->mesh->q[place[k] + 1]; i++)
            largest = fmax(largest, fabs(v->half[i]));
    return fabs(sum) > NOISE * (energy + largest * forces) ? sum : 0;
}

static void add_force(const cardan_conserving *v, const cardan_group *g, ptrdiff_t element,
                      const real *out, ptrdiff_t stride)
{
    const cardan_mesh *mesh = v->mesh;
    const ptrdiff_t *place = g->place + element * g->places;
    real *x = v->element, *along = x + g->nu, part, product = 0;

    for (ptrdiff_t k = 0, j = 0; k < g->places; k++)
        for (ptrdiff_t i = mesh->u[place[k]]; i < mesh->u[place[k] + 1]; i++, j++)
            x[j] = v->eta[i];
    part = unmet(v, g, element, out, stride, x);
    v->now[CONSERVING_UNMET] += fabs(part);
    part += v->now[CONSERVING_SHARE] * fabs(part);
    if (part != 0)
        product = changing(v, g, place, x, along);
    part = product > 0 ? part / product : 0;
    for (ptrdiff_t k = 0, j = 0; k < g->places; k++)
        for (ptrdiff_t i = mesh->u[place[k]]; i < mesh->u[place[k] + 1]; i++, j++)
            v->missing[i] += out[j * stride] + (part != 0 ? part * along[j] : 0);
}

static void take_force(const cardan_mesh *mesh, const cardan_group *g, const cardan_element_lanes *some,
                       real *out, void *to)
{
    (void)mesh;
    for (ptrdiff_t lane = 0; lane < some->filled; lane++)
        add_force(to, g, some->element[lane], out + lane, some->lanes);
}

/* Forces of all elements over a step, into what is missing in the balance. */
int cardan_conserving_forces(const cardan_run *run, const cardan_conserving *v, real t)
{
    cardan_state at = cardan_conserving_state(run, t, v->half);
    cardan_conserving local = *v;
    const real share = v->now[CONSERVING_EXCESS] / v->now[CONSERVING_UNMET];

    /* little of what there is to share, or nothing */
    v->now[CONSERVING_SHARE] = fabs(share) < MOST ? share : 0;
    v->now[CONSERVING_UNMET] = 0;
    at.lam = v->lam_new;
    for (ptrdiff_t i = 0; i < v->nu; i++)
        v->missing[i] = 0;
    return cardan_mesh_each(v->mesh, &at, CARDAN_BALANCE, take_force, &local, v->system.work);
}
