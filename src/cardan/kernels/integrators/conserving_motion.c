/* How places move in a step of the energy-momentum method, and what their momenta gain.
 *
 * Part of cardan. Caller owns all memory.
 *
 * A node goes along one screw: H' = H exp(h xi) with the mean xi = (xi + xi') / 2 of the body twists
 * at both ends. As exp(h xi) leaves xi alone, momenta that are merely carried along it, Ad* PI' = PI,
 * give xi . (PI' - PI) = 0: and with masses that are constant along body axes that is the change of
 * the kinetic energy. Half way is half of the screw: what moves within a subgroup, such as about a
 * fixed point or a fixed axis, is there too.
 *
 * Elements whose inertia couples places are quadratic in the coordinates x of deformation that it
 * depends on: with their momenta P = M(x) V along body axes and half way x,
 *
 *     V.(P' - P) - (x' - x).(V.(dM/dx) V') / 2 = (V'.M' V' - V.M V) / 2, where V = mean of V and V',
 *
 * so that energy is kept if half of V.(dM/dx) V' acts along x besides.
 *
 * The increment of a node are the rotation theta along its axes, which are the same all along, and
 * d = h R v along those of the ground half way.
 * Source: J. C. Simo, K. K. Wong, Int. J. Numer. Meth. Eng. 31 (1991) 19-52; here for screws.
 */
#include "conserving.h"
#include <math.h>

/* angles below which series serve */
static const real SMALL = 1e-2;

void cardan_rotation(const real *q, real *R)
{
    const real w = q[0], x = q[1], y = q[2], z = q[3];

    R[0] = 1 - 2 * (y * y + z * z), R[1] = 2 * (x * y - w * z), R[2] = 2 * (x * z + w * y);
    R[3] = 2 * (x * y + w * z), R[4] = 1 - 2 * (x * x + z * z), R[5] = 2 * (y * z - w * x);
    R[6] = 2 * (x * z - w * y), R[7] = 2 * (y * z + w * x), R[8] = 1 - 2 * (x * x + y * y);
}

static void times(const real *R, const real *x, real *y)
{
    for (int i = 0; i < 3; i++)
        y[i] = R[3 * i] * x[0] + R[3 * i + 1] * x[1] + R[3 * i + 2] * x[2];
}

static void back(const real *R, const real *x, real *y)
{
    for (int i = 0; i < 3; i++)
        y[i] = R[i] * x[0] + R[3 + i] * x[1] + R[6 + i] * x[2];
}

/* What a rotation by w reaches on its way of a velocity d that turns with it, seen from half way:
 * the mean of exp(s w) d over s from -1/2 to 1/2. */
static void reach(const real *w, const real *d, real *out)
{
    const real square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2], x = 0.5 * sqrt(square);
    /* (1 - sin x / x) / (2 x)^2 */
    const real c = x > SMALL ? (1 - sin(x) / x) / square
                             : (1 - x * x / 20 * (1 - x * x / 42)) / 24;
    real once[3], twice[3];

    cardan_cross(w, d, once);
    cardan_cross(w, once, twice);
    for (int i = 0; i < 3; i++)
        out[i] = d[i] + c * twice[i];
}

/* exp(w) d */
static void turn(const real *w, const real *d, real *out)
{
    const real square = w[0] * w[0] + w[1] * w[1] + w[2] * w[2], x = sqrt(square);
    const real half = 0.5 * x, sine = half > SMALL ? sin(half) / half
                                                   : 1 - half * half / 6 * (1 - half * half / 20);
    const real c = sine * cos(half);
    real once[3], twice[3];

    cardan_cross(w, d, once);
    cardan_cross(w, once, twice);
    for (int i = 0; i < 3; i++)
        out[i] = d[i] + c * once[i] + 0.5 * sine * sine * twice[i];
}

/* Speeds at the end from the mean ones along body axes. */
static void speed_pose(const real *q, const real *half, const real *next, const real *u,
                       const real *mean, real *u_next)
{
    real R[9], v[3], v_mean[3];

    cardan_rotation(q, R);
    back(R, u + 3, v);
    cardan_rotation(half, R);
    back(R, mean + 3, v_mean);
    for (int i = 0; i < 3; i++) {
        u_next[i] = 2 * mean[i] - u[i];
        v[i] = 2 * v_mean[i] - v[i];
    }
    cardan_rotation(next, R);
    times(R, v, u_next + 3);
}

/* Half way and the end of the step with the increment eta: `half`, `mean` and the trial; `missing` is room. */
int cardan_conserving_move(cardan_run *run, const cardan_conserving *v, real h)
{
    const cardan_mesh *mesh = v->mesh;
    const real *q = run->y, *u = q + v->nq;
    real *next = run->trial, *u_next = next + v->nq;
    int status;

    for (ptrdiff_t i = 0; i < v->nu; i++) {
        v->mean[i] = v->eta[i] / h;
        v->missing[i] = 0.5 * v->eta[i];
        u_next[i] = 2 * v->mean[i] - u[i];
    }
    status = cardan_mesh_move(mesh, q, v->missing, v->half, NULL, v->system.work);
    if (status == 0)
        status = cardan_mesh_move(mesh, q, v->eta, next, NULL, v->system.work);
    for (ptrdiff_t k = 0; k < mesh->nodes && status == 0; k++) {
        const ptrdiff_t place = mesh->node[k], at = mesh->q[place], to = mesh->u[place];
        real R[9], w[3], part[3], back_w[3], rotation[3], first[3];
        cardan_rotation(q + at, R);
        times(R, v->eta + to, w);
        reach(w, v->eta + to + 3, rotation);
        for (int i = 0; i < 3; i++) {
            part[i] = 0.5 * w[i];
            back_w[i] = -0.25 * w[i];
        }
        reach(part, v->eta + to + 3, first);
        turn(back_w, first, part);
        for (int i = 0; i < 3; i++) {
            next[at + 4 + i] = q[at + 4 + i] + rotation[i];
            v->half[at + 4 + i] = q[at + 4 + i] + 0.5 * part[i];
        }
        speed_pose(q + at, v->half + at, next + at, u + to, v->mean + to, u_next + to);
    }
    return status;
}

/* Speeds u (nu) with the velocities of nodes, which are along axes of the ground, as they are at the
 * poses half way if bodies have them along their own axes. */
void cardan_conserving_turn(const cardan_conserving *v, const real *q, const real *u, real *out)
{
    for (ptrdiff_t i = 0; i < v->nu; i++)
        out[i] = u[i];
    for (ptrdiff_t k = 0; k < v->mesh->nodes; k++) {
        const ptrdiff_t place = v->mesh->node[k], at = v->mesh->q[place], to = v->mesh->u[place];
        real R[9], local[3];
        cardan_rotation(q + at, R);
        back(R, u + to + 3, local);
        cardan_rotation(v->half + at, R);
        times(R, local, out + to + 3);
    }
}

/* Momentum l and, about a point, angular momentum a of a node, along axes of the ground; `more` is
 * what elements give it besides its mass, NULL: nothing. */
static void momentum(const real *mass, ptrdiff_t widest, const real *more, const real *q,
                     const real *u, const real *point, real *both)
{
    real R[9], twist[6], body_momentum[6], arm[3], moment[3];

    cardan_rotation(q, R);
    for (int i = 0; i < 3; i++) {
        twist[i] = u[i];
        arm[i] = q[4 + i] - point[i];
    }
    back(R, u + 3, twist + 3);
    for (int i = 0; i < 6; i++) {
        body_momentum[i] = more ? more[i] : 0;
        for (int j = 0; j < 6; j++)
            body_momentum[i] += mass[widest * i + j] * twist[j];
    }
    times(R, body_momentum, both);
    times(R, body_momentum + 3, both + 3);
    cardan_cross(arm, both + 3, moment);
    for (int i = 0; i < 3; i++)
        both[i] += moment[i];
}

/* Add what momenta gain per time to what is missing in the balance. */
void cardan_conserving_momenta(const cardan_run *run, const cardan_conserving *v, real h)
{
    const cardan_mesh *mesh = v->mesh;
    const real *q = run->y, *u = q + v->nq, *next = run->trial, *u_next = next + v->nq;
    real sum = 0;

    for (ptrdiff_t place = 0; place < mesh->places; place++) {
        const ptrdiff_t to = mesh->u[place], n = mesh->u[place + 1] - to, at = mesh->q[place];
        const real *mass = v->mass + v->widest * to;
        const real *more = v->coupled ? v->momenta + to : NULL;
        const real *more_new = v->coupled ? v->momenta_new + to : NULL;
        real before[6], after[6], R[9], moment[3];

        if (v->pose[place] == 0) {
            for (ptrdiff_t i = 0; i < n; i++)
                for (ptrdiff_t j = 0; j < n; j++) {
                    v->missing[to + i] += mass[v->widest * i + j] * (u_next[to + j] - u[to + j]) / h;
                    sum += fabs(mass[v->widest * i + j] * u[to + j]);
                }
            for (ptrdiff_t i = 0; i < n && v->coupled; i++) {
                v->missing[to + i] += (more_new[i] - more[i]) / h - v->slopes[to + i];
                sum += fabs(more[i]);
            }
            continue;
        }
        momentum(mass, v->widest, more, q + at, u + to, v->half + at + 4, before);
        momentum(mass, v->widest, more_new, next + at, u_next + to, v->half + at + 4, after);
        for (int i = 0; i < 6; i++) {
            sum += fabs(before[i]);
            after[i] = (after[i] - before[i]) / h;
        }
        cardan_rotation(v->half + at, R);
        back(R, after, moment);
        for (int i = 0; i < 3; i++) {
            v->missing[to + i] += moment[i];
            v->missing[to + 3 + i] += after[3 + i];
        }
    }
    v->now[CONSERVING_RATES] = sum / h;
}
