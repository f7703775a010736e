/* How coordinates of a mesh move along the speeds.
 *
 * Part of cardan. Caller owns all memory.
 * Source: M. Géradin, A. Cardona, Flexible Multibody Dynamics (2001), chapter 4 (rotations by their
 * vector, tangent operator).
 */
#include "mesh.h"
#include "mesh_lanes.h"
#include <math.h>

/* squares of angles up to which series serve: what they leave out is below rounding */
static const real SMALL = 0.25;

/* sin(x) / x, (1 - cos x) / x^2, (x - sin x) / x^3 by s = x^2; of numbers and of vectors of them */
#define SERIES(s, a, b, c, d, e, f, g)                                                             \
    (1 / a - (s) * (1 / b - (s) * (1 / c - (s) * (1 / d                                               \
     - (s) * (1 / e - (s) * (1 / f - (s) * (1 / g)))))))
#define SERIES_0(s) SERIES(s, 1., 6., 120., 5040., 362880., 39916800., 6227020800.)
#define SERIES_1(s) SERIES(s, 2., 24., 720., 40320., 3628800., 479001600., 87178291200.)
#define SERIES_2(s) SERIES(s, 6., 120., 5040., 362880., 39916800., 6227020800., 1307674368000.)

static void ratios(real square, real *c)
{
    if (square > SMALL) {
        const real x = sqrt(square), half = sin(0.5 * x);
        c[0] = sin(x) / x;
        c[1] = 2 * half * half / square;
        c[2] = (1 - c[0]) / square;
        return;
    }
    c[0] = SERIES_0(square);
    c[1] = SERIES_1(square);
    c[2] = SERIES_2(square);
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

#if CARDAN_SQUARES
/* The same of eight nodes whose angles are small. Returns whether they are. */
static int move_small(const cardan_mesh *mesh, const ptrdiff_t *node, const real *q,
                      const real *du, real *moved, real *tangent_maps)
{
    const real *from[CARDAN_ELEMENT_LANES], *along[CARDAN_ELEMENT_LANES];
    real *to[CARDAN_ELEMENT_LANES], *tangents[CARDAN_ELEMENT_LANES];
    cardan_eight p[7], d[6], T[9], square, half, w, c, r[3];
    int small = 1;

    for (int k = 0; k < CARDAN_ELEMENT_LANES; k++) {
        from[k] = q + mesh->q[node[k]];
        along[k] = du + mesh->u[node[k]];
        to[k] = moved + mesh->q[node[k]];
        tangents[k] = tangent_maps ? tangent_maps + 9 * node[k] : NULL;
    }
    (void)cardan_fetch(along, 6, (real *)d, CARDAN_ELEMENT_LANES);
    square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    for (int k = 0; k < CARDAN_ELEMENT_LANES; k++)
        small = small && square[k] <= SMALL;
    if (!small)
        return 0;
    (void)cardan_fetch(from, 7, (real *)p, CARDAN_ELEMENT_LANES);
    half = 0.25 * square;
    w = 1 - half * SERIES_1(half);
    c = 0.5 * SERIES_0(half);
    for (int i = 0; i < 3; i++) {
        r[i] = c * d[i];
        p[4 + i] += d[3 + i];
    }
    T[0] = p[0] * w - p[1] * r[0] - p[2] * r[1] - p[3] * r[2];
    T[1] = p[0] * r[0] + p[1] * w + p[2] * r[2] - p[3] * r[1];
    T[2] = p[0] * r[1] - p[1] * r[2] + p[2] * w + p[3] * r[0];
    T[3] = p[0] * r[2] + p[1] * r[1] - p[2] * r[0] + p[3] * w;
    for (int i = 0; i < 4; i++)
        p[i] = T[i];
    cardan_write((const real *)p, 7, CARDAN_ELEMENT_LANES, to, CARDAN_ELEMENT_LANES);
    if (!tangent_maps)
        return 1;
    c = SERIES_2(square);
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            T[3 * i + j] = c * d[i] * d[j] + (i == j ? 1 - c * square : 0 * c);
    w = SERIES_1(square);
    T[1] += w * d[2];
    T[2] -= w * d[1];
    T[3] -= w * d[2];
    T[5] += w * d[0];
    T[6] += w * d[1];
    T[7] -= w * d[0];
    cardan_write((const real *)T, 9, CARDAN_ELEMENT_LANES, tangents, CARDAN_ELEMENT_LANES);
    return 1;
}
#endif

/* All poses. */
static void move_poses(const cardan_mesh *mesh, const real *q, const real *du, real *moved,
                       real *tangent_maps)
{
    for (ptrdiff_t k = 0; k < mesh->nodes; k++) {
        const ptrdiff_t place = mesh->node[k];

#if CARDAN_SQUARES
        if (k + CARDAN_ELEMENT_LANES <= mesh->nodes
            && move_small(mesh, mesh->node + k, q, du, moved, tangent_maps)) {
            k += CARDAN_ELEMENT_LANES - 1;
            continue;
        }
#endif
        move_pose(q + mesh->q[place], du + mesh->u[place], moved + mesh->q[place]);
        if (tangent_maps)
            tangent(du + mesh->u[place], tangent_maps + 9 * place);
    }
}

int cardan_mesh_move(const cardan_mesh *mesh, const real *q, const real *du, real *moved,
                     real *tangent_maps, real *room)
{
    int status = 0;

    move_poses(mesh, q, du, moved, tangent_maps);
    for (ptrdiff_t n = 0; n < mesh->mover_count; n++) {
        const cardan_movers *movers = &mesh->movers[n];
        for (ptrdiff_t k = 0; k < movers->count && status == 0; k++) {
            const ptrdiff_t place = movers->place[k];
            cardan_in in = {0};
            if (!movers->move) {
                for (ptrdiff_t i = 0; i < movers->nq; i++)
                    moved[mesh->q[place] + i] = q[mesh->q[place] + i] + du[mesh->u[place] + i];
                if (tangent_maps)
                    for (ptrdiff_t i = 0; i < 9; i++)
                        tangent_maps[9 * place + i] = i % 4 == 0;
                continue;
            }
            in.q = q + mesh->q[place];
            in.du = du + mesh->u[place];
            in.w = movers->w_move;
            /* q and T, whose rotation is that of a free joint or all there is */
            status = movers->move(&in, room, room + movers->nq + movers->nu * movers->nu);
            for (ptrdiff_t i = 0; i < movers->nq; i++)
                moved[mesh->q[place] + i] = room[i];
            if (tangent_maps && movers->nu >= 3)
                for (ptrdiff_t i = 0; i < 3; i++)
                    for (ptrdiff_t j = 0; j < 3; j++)
                        tangent_maps[9 * place + 3 * i + j] = room[movers->nq + movers->nu * i + j];
        }
    }
    return status;
}
