/* How coordinates of a mesh move along the speeds.
 *
 * Part of cardan. Caller owns all memory.
 * Source: M. Géradin, A. Cardona, Flexible Multibody Dynamics (2001), chapter 4 (rotations by their
 * vector, tangent operator).
 */
#include "mesh.h"
#include <math.h>

/* angles below which series serve; what they leave out is below rounding */
static const real SMALL = 1e-2;

/* sin(x) / x, (1 - cos x) / x^2, (x - sin x) / x^3 by x^2 */
static void ratios(real square, real *c)
{
    const real x = sqrt(square);

    if (x > SMALL) {
        const real half = sin(0.5 * x);
        c[0] = sin(x) / x;
        c[1] = 2 * half * half / square;
        c[2] = (1 - c[0]) / square;
        return;
    }
    c[0] = 1 - square / 6 * (1 - square / 20 * (1 - square / 42));
    c[1] = 0.5 * (1 - square / 12 * (1 - square / 30 * (1 - square / 56)));
    c[2] = (1 - square / 20 * (1 - square / 42 * (1 - square / 72))) / 6;
}

/* The tangent of a rotation by a vector d: along body axes after it, (3, 3). */
static void tangent(const real *d, real *T)
{
    const real square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    real c[3];

    ratios(square, c);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            T[3 * i + j] = c[2] * d[i] * d[j] + (i == j ? 1 - c[2] * square : 0);
    T[1] += c[1] * d[2];
    T[2] -= c[1] * d[1];
    T[3] -= c[1] * d[2];
    T[5] += c[1] * d[0];
    T[6] += c[1] * d[1];
    T[7] -= c[1] * d[0];
}

/* A pose turned by d in its own axes and moved by d + 3 in those of the ground. */
static void move_pose(const real *q, const real *d, real *moved)
{
    const real square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    real c[3], w, x, y, z;

    /* half the angle: sin(x / 2) / x is half of sin(y) / y */
    ratios(0.25 * square, c);
    w = 1 - 0.25 * square * c[1];
    x = 0.5 * c[0] * d[0];
    y = 0.5 * c[0] * d[1];
    z = 0.5 * c[0] * d[2];
    moved[0] = q[0] * w - q[1] * x - q[2] * y - q[3] * z;
    moved[1] = q[0] * x + q[1] * w + q[2] * z - q[3] * y;
    moved[2] = q[0] * y - q[1] * z + q[2] * w + q[3] * x;
    moved[3] = q[0] * z + q[1] * y - q[2] * x + q[3] * w;
    for (int i = 0; i < 3; i++)
        moved[4 + i] = q[4 + i] + d[3 + i];
}

static void rate_pose(const real *q, const real *u, real *rate)
{
    rate[0] = -0.5 * (q[1] * u[0] + q[2] * u[1] + q[3] * u[2]);
    rate[1] = 0.5 * (q[0] * u[0] + q[2] * u[2] - q[3] * u[1]);
    rate[2] = 0.5 * (q[0] * u[1] + q[3] * u[0] - q[1] * u[2]);
    rate[3] = 0.5 * (q[0] * u[2] + q[1] * u[1] - q[2] * u[0]);
    for (int i = 0; i < 3; i++)
        rate[4 + i] = u[3 + i];
}

int cardan_mesh_rates(const cardan_mesh *mesh, const real *q, const real *u, real *qdot,
                      real *room)
{
    int status = 0;

    for (ptrdiff_t k = 0; k < mesh->nodes; k++) {
        const ptrdiff_t place = mesh->node[k];
        rate_pose(q + mesh->q[place], u + mesh->u[place], qdot + mesh->q[place]);
    }
    for (ptrdiff_t n = 0; n < mesh->mover_count; n++) {
        const cardan_movers *movers = &mesh->movers[n];
        for (ptrdiff_t k = 0; k < movers->count && status == 0; k++) {
            const ptrdiff_t place = movers->place[k];
            cardan_in in = {0};
            if (!movers->rates) {
                for (ptrdiff_t i = 0; i < movers->nq; i++)
                    qdot[mesh->q[place] + i] = u[mesh->u[place] + i];
                continue;
            }
            in.q = q + mesh->q[place];
            in.u = u + mesh->u[place];
            in.w = movers->w_rates;
            status = movers->rates(&in, qdot + mesh->q[place], room);
        }
    }
    return status;
}

int cardan_mesh_move(const cardan_mesh *mesh, const real *q, const real *du, real *moved,
                     real *turned, real *room)
{
    int status = 0;

    for (ptrdiff_t k = 0; k < mesh->nodes; k++) {
        const ptrdiff_t place = mesh->node[k];
        move_pose(q + mesh->q[place], du + mesh->u[place], moved + mesh->q[place]);
        if (turned)
            tangent(du + mesh->u[place], turned + 9 * place);
    }
    for (ptrdiff_t n = 0; n < mesh->mover_count; n++) {
        const cardan_movers *movers = &mesh->movers[n];
        for (ptrdiff_t k = 0; k < movers->count && status == 0; k++) {
            const ptrdiff_t place = movers->place[k];
            cardan_in in = {0};
            if (!movers->move) {
                for (ptrdiff_t i = 0; i < movers->nq; i++)
                    moved[mesh->q[place] + i] = q[mesh->q[place] + i] + du[mesh->u[place] + i];
                if (turned && movers->nu == 6)
                    for (ptrdiff_t i = 0; i < 9; i++)
                        turned[9 * place + i] = i % 4 == 0;
                continue;
            }
            in.q = q + mesh->q[place];
            in.du = du + mesh->u[place];
            in.w = movers->w_move;
            /* q and T, which is wanted of free joints only: the matrices of others turn little */
            status = movers->move(&in, room, room + movers->nq + movers->nu * movers->nu);
            for (ptrdiff_t i = 0; i < movers->nq; i++)
                moved[mesh->q[place] + i] = room[i];
            if (turned && movers->nu == 6)
                for (ptrdiff_t i = 0; i < 3; i++)
                    for (ptrdiff_t j = 0; j < 3; j++)
                        turned[9 * place + 3 * i + j] = room[movers->nq + 6 * i + j];
        }
    }
    return status;
}
