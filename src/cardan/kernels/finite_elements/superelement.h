/*
 * superelement.h: forces and inertia of a reduced flexible body in a frame that moves far.
 *
 * Generated files include it where states may stand side by side: `real` is one number or several.
 *
 * The frame has the rotation R0 and the origin x0; in its axes the body moves by
 *
 *     v = R0^T x0',  alpha = v' + w x v - R0^T g,  w, w',
 *
 * and its coordinates z (n) deform it by U = Psi z. A node has the velocity v + w x (X + U) + U', so
 * that with constants of the record and k, l axes of the frame
 *
 *     s = s0 + P z,  H_k = H0_k + A_k^T z,  J_kl = J0_kl + 2 j_kl.z + z.S_kl z,
 *     T = m v.v / 2 + v.(w x s + P z') + w.J w / 2 + w.H z' + z'.M z' / 2,
 *     V = z.K z / 2 - g.(m x0 + R0 s).
 *
 * Force and moment on the frame and what acts along z are, whatever the velocity of the frame,
 *
 *     f = m alpha + w' x s + w x (w x s) + 2 w x P z' + P z''
 *     n = s x alpha + J w' + w x (J w + H z') + J' w + H z'' + z'.A z'
 *     b = P^T alpha + H^T w' + w_k (A_k^T - A_k) z' - w_k w_l (j_kl + S_kl z) + M z'' + D z' + K z
 *
 * Some kinds of inertia also have T_E = v.G w with G_rk = E_rk.z, which depends on the velocity of
 * the frame; then `drift` is not NULL. It is what M of beams misses of an exact one.
 *
 * The frame is fixed to a node, at p and turned by R in its axes, or to the ground. w[] holds R (9), p
 * (3) and g (3); q, u and udot begin with those of the node, if there is one: see mesh.h.
 *
 * Source: A. Zwoelfer, J. Gerstmayr, The nodal-based floating frame of reference formulation with
 * modal reduction, Acta Mechanica 232 (2021).
 */
#ifndef CARDAN_SUPERELEMENT_H
#define CARDAN_SUPERELEMENT_H

#include "frame_motion.h"
#include "rows.h"

/* pairs of axes: xx, yy, zz, yz, zx, xy */
static const int CARDAN_PAIR[3][3] = {{0, 5, 4}, {5, 1, 3}, {4, 3, 2}};

/* Constants of a record, one behind the other. */
typedef struct cardan_superelement {
    int n;                           /* coordinates */
    const double *mass;              /* m */
    const double *first;             /* s0 (3) */
    const double *second;            /* J0 by pairs (6) */
    const double *momentum;          /* P (3, n) */
    const double *angular;           /* H0 (3, n) */
    const double *bent;              /* j by pairs (6, n) */
    const double *modal, *stiffness, *damping; /* M, K, D (n, n), symmetric */
    const double *spin, *spin_back;  /* A_k, A_k^T (3, n, n) */
    const double *squares;           /* S by pairs (6, n, n), symmetric */
    const double *drift;             /* E (3, 3, n): by rows of v, then by axes of w; or NULL */
} cardan_superelement;

CARDAN_INLINE cardan_superelement cardan_superelement_of(int n, int drifts, const double *constants)
{
    cardan_superelement c;

    c.n = n;
    c.mass = constants;
    c.first = c.mass + 1;
    c.second = c.first + 3;
    c.momentum = c.second + 6;
    c.angular = c.momentum + 3 * n;
    c.bent = c.angular + 3 * n;
    c.modal = c.bent + 6 * n;
    c.stiffness = c.modal + n * n;
    c.damping = c.stiffness + n * n;
    c.spin = c.damping + n * n;
    c.spin_back = c.spin + 3 * n * n;
    c.squares = c.spin_back + 3 * n * n;
    c.drift = drifts ? c.squares + 6 * n * n : NULL;
    return c;
}

/* out (3) += J a, J by pairs */
CARDAN_INLINE void cardan_3_add_symmetric(const real *J, const real *a, real *out)
{
    for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) out[k] += J[CARDAN_PAIR[k][l]] * a[l];
}

/* What follows from z: s (3), H (3, n), J by pairs, j + S z by pairs (6, n). Where `back` is not
 * NULL it gets A_k^T z' (3, n), and `squared`, if that is not, S z' by pairs (6, n). */
CARDAN_INLINE void cardan_superelement_shape(const cardan_superelement *c, const real *z,
                                             const real *rate, real *s, real *H, real *J, real *bent,
                                             real *back, real *squared)
{
    const int n = c->n;
    real by_constants[6], by_bent[6];

    cardan_dots_constants(3, n, c->momentum, z, s);
    for (int k = 0; k < 3; ++k) {
        const double *const A = c->spin + k * n * n, *const H0 = c->angular + k * n;

        s[k] += c->first[k];
        if (back)
            cardan_set_products(n, n, H0, A, z, H + k * n, rate, back + k * n);
        else
            cardan_set_product(n, n, H0, A, z, H + k * n);
    }
    for (int k = 0; k < 6; ++k) {
        const double *const S = c->squares + k * n * n, *const j = c->bent + k * n;

        if (squared)
            cardan_set_products(n, n, j, S, z, bent + k * n, rate, squared + k * n);
        else
            cardan_set_product(n, n, j, S, z, bent + k * n);
    }
    cardan_dots_constants(6, n, c->bent, z, by_constants);
    cardan_dots(6, n, bent, z, by_bent);
    for (int k = 0; k < 6; ++k) J[k] = c->second[k] + by_constants[k] + by_bent[k];
}

/* out (3) += P x */
CARDAN_INLINE void cardan_superelement_flow(const cardan_superelement *c, const real *x, real *out)
{
    real flow[3];

    cardan_dots_constants(3, c->n, c->momentum, x, flow);
    for (int k = 0; k < 3; ++k) out[k] += flow[k];
}

/* G (3, 3) of z, or its rate of z'. */
CARDAN_INLINE void cardan_superelement_drift(const cardan_superelement *c, const real *z, real *G)
{
    cardan_dots_constants(9, c->n, c->drift, z, G);
}

/* out (n) += sum over r and k of v_r w_k E_rk */
CARDAN_INLINE void cardan_superelement_add_drift(const cardan_superelement *c, const real *v,
                                                 const real *w, double scale, real *out)
{
    real factors[9];

    for (int k = 0; k < 9; ++k) factors[k] = v[k / 3] * w[k % 3] * scale;
    cardan_add_product(9, c->n, c->drift, factors, out);
}

/* w_k w_l of every pair, counted as often as it is there. */
CARDAN_INLINE void cardan_pairs_of(const real *w, real *out)
{
    for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) out[CARDAN_PAIR[k][l]] = w[k] * w[l] * (k == l ? 1.0 : 2.0);
}

/* 2 w_l at the pairs (6) of an axis k with every axis l, 0 at other pairs. */
CARDAN_INLINE void cardan_pairs_with(int k, const real *w, real *out)
{
    for (int pair = 0; pair < 6; ++pair) out[pair] = CARDAN_REAL(0.0);
    for (int l = 0; l < 3; ++l) out[CARDAN_PAIR[k][l]] = 2.0 * w[l];
}

/* Work: 15 n numbers, of the tangent 37 n. */

CARDAN_INLINE int cardan_superelement_balance(int n, int on_node, int drifts, const double *constants,
                                              const cardan_in *in, real *CARDAN_RESTRICT out,
                                              real *CARDAN_RESTRICT work)
{
    const cardan_superelement c = cardan_superelement_of(n, drifts, constants);
    const real *const z = in->q + 7 * on_node, *const rate = in->u + 6 * on_node;
    const real *const second = in->udot + 6 * on_node;
    real *const b = out + 6 * on_node;
    cardan_frame_motion at;

    cardan_frame_motion_of(in, on_node, 2, &at);
    /* what acts without a rotation of the frame */
    cardan_set_product(3, n, NULL, c.momentum, at.alpha, b);
    cardan_add_product(n, n, c.modal, second, b);
    cardan_add_product(n, n, c.stiffness, z, b);
    cardan_add_product(n, n, c.damping, rate, b);
    if (!on_node) return CARDAN_OK;

    /* rows one behind the other; spun: A_k z' */
    real *const H = work, *const bent = work + 3 * n, *const back = work + 9 * n;
    real *const spun = work + 12 * n;
    real s[3], J[6], J_rate[6], h[3], f[3], moment[3], flow[3], spun_mass[3], along[15];

    cardan_superelement_shape(&c, z, rate, s, H, J, bent, back, NULL);
    for (int k = 0; k < 3; ++k)
        cardan_set_product(n, n, NULL, c.spin_back + k * n * n, rate, spun + k * n);
    /* forces of w', centrifugal and gyroscopic ones */
    cardan_pairs_of(at.w, along + 3);
    for (int k = 0; k < 6; ++k) along[3 + k] = -along[3 + k];
    for (int k = 0; k < 3; ++k) {
        along[k] = at.w_rate[k];
        along[9 + k] = at.w[k];
        along[12 + k] = -at.w[k];
    }
    cardan_rows(0, 15, n, work, along, b);
    cardan_dots(6, n, bent, rate, J_rate);
    for (int k = 0; k < 6; ++k) J_rate[k] *= 2.0;
    cardan_dots(3, n, H, rate, h);
    cardan_dots(3, n, H, second, moment);
    cardan_dots(3, n, spun, rate, flow);
    for (int k = 0; k < 3; ++k) moment[k] += flow[k];

    /* f = m alpha + w' x s + w x (w x s + 2 P z') + P z'' */
    cardan_clear(3, flow);
    cardan_superelement_flow(&c, rate, flow);
    cardan_3_cross(at.w, s, spun_mass);
    for (int k = 0; k < 3; ++k) {
        spun_mass[k] += 2.0 * flow[k];
        f[k] = c.mass[0] * at.alpha[k];
    }
    cardan_superelement_flow(&c, second, f);
    cardan_3_add_cross(at.w_rate, s, f);
    cardan_3_add_cross(at.w, spun_mass, f);
    /* n has H z'' + z'.A z' so far; h = J w + H z' */
    cardan_3_add_cross(s, at.alpha, moment);
    cardan_3_add_symmetric(J, at.w_rate, moment);
    cardan_3_add_symmetric(J_rate, at.w, moment);
    cardan_3_add_symmetric(J, at.w, h);
    cardan_3_add_cross(at.w, h, moment);

    if (c.drift) {
        real G[9], G_rate[9], Gw[3], Gv[3], more[3];

        /* f: G' w + G w' + w x G w; n: G'^T v + G^T v' + w x G^T v + v x G w; b: -v.E w */
        cardan_superelement_drift(&c, z, G);
        cardan_superelement_drift(&c, rate, G_rate);
        cardan_3_times(G, 0, at.w, 1, Gw);
        cardan_3_times(G, 1, at.v, 1, Gv);
        cardan_3_times(G_rate, 0, at.w, 1, more);
        for (int k = 0; k < 3; ++k) f[k] += more[k];
        cardan_3_times(G, 0, at.w_rate, 1, more);
        for (int k = 0; k < 3; ++k) f[k] += more[k];
        cardan_3_add_cross(at.w, Gw, f);
        cardan_3_times(G_rate, 1, at.v, 1, more);
        for (int k = 0; k < 3; ++k) moment[k] += more[k];
        cardan_3_times(G, 1, at.v_rate, 1, more);
        for (int k = 0; k < 3; ++k) moment[k] += more[k];
        cardan_3_add_cross(at.w, Gv, moment);
        cardan_3_add_cross(at.v, Gw, moment);
        cardan_superelement_add_drift(&c, at.v, at.w, -1.0, b);
    }

    /* at the node: the moment in its axes, the force in those of the ground */
    cardan_3_times(at.local, 0, f, 1, flow);
    cardan_3_times(at.local, 0, moment, 1, out);
    cardan_3_add_cross(at.p, flow, out);
    cardan_3_times(at.node, 0, flow, 1, out + 3);
    return CARDAN_OK;
}

/* Kinetic and potential energy. */
CARDAN_INLINE int cardan_superelement_energy(int n, int on_node, int drifts, const double *constants,
                                             const cardan_in *in, real *CARDAN_RESTRICT out,
                                             real *CARDAN_RESTRICT work)
{
    const cardan_superelement c = cardan_superelement_of(n, drifts, constants);
    const real *const z = in->q + 7 * on_node, *const rate = in->u + 6 * on_node;
    real *const H = work, *const bent = work + 3 * n, *const product = work + 9 * n;
    real s[3], J[6], v[3], p[3], m[3];
    cardan_frame_motion at;

    cardan_frame_motion_of(in, on_node, 1, &at);
    cardan_superelement_shape(&c, z, rate, s, H, J, bent, NULL, NULL);
    cardan_3_times(at.R0, 1, at.x0_rate, 1, v);
    cardan_set_product(n, n, NULL, c.modal, rate, product);
    cardan_dots(1, n, product, rate, out);
    out[0] *= 0.5;
    /* halves of v.p and w.m, with the products of v, w and z' counted once */
    cardan_3_cross(at.w, s, p);
    cardan_superelement_flow(&c, rate, p);
    cardan_dots(3, n, H, rate, m);
    for (int k = 0; k < 3; ++k) {
        p[k] += 0.5 * c.mass[0] * v[k];
        m[k] *= 2.0;
    }
    cardan_3_add_symmetric(J, at.w, m);
    for (int k = 0; k < 3; ++k) out[0] += p[k] * v[k] + 0.5 * m[k] * at.w[k];
    if (c.drift) {
        real G[9], Gw[3];

        cardan_superelement_drift(&c, z, G);
        cardan_3_times(G, 0, at.w, 1, Gw);
        for (int k = 0; k < 3; ++k) out[0] += v[k] * Gw[k];
    }
    cardan_set_product(n, n, NULL, c.stiffness, z, product);
    cardan_dots(1, n, product, z, out + 1);
    out[1] *= 0.5;
    /* weight falls where the center of mass does */
    cardan_3_times(at.R0, 0, s, 1, p);
    for (int k = 0; k < 3; ++k) out[1] -= (p[k] + c.mass[0] * at.x0[k]) * at.g[k];
    return CARDAN_OK;
}

/* Angular momentum about the origin of the ground, then momentum. */
CARDAN_INLINE int cardan_superelement_momentum(int n, int on_node, int drifts, const double *constants,
                                               const cardan_in *in, real *CARDAN_RESTRICT out,
                                               real *CARDAN_RESTRICT work)
{
    const cardan_superelement c = cardan_superelement_of(n, drifts, constants);
    const real *const z = in->q + 7 * on_node, *const rate = in->u + 6 * on_node;
    real *const H = work, *const bent = work + 3 * n;
    real s[3], J[6], v[3], p[3], m[3];
    cardan_frame_motion at;

    cardan_frame_motion_of(in, on_node, 1, &at);
    cardan_superelement_shape(&c, z, rate, s, H, J, bent, NULL, NULL);
    cardan_3_times(at.R0, 1, at.x0_rate, 1, v);
    cardan_dots(3, n, H, rate, m);
    for (int k = 0; k < 3; ++k) p[k] = c.mass[0] * v[k];
    cardan_superelement_flow(&c, rate, p);
    cardan_3_add_cross(at.w, s, p);
    cardan_3_add_cross(s, v, m);
    cardan_3_add_symmetric(J, at.w, m);
    if (c.drift) {
        real G[9], more[3];

        cardan_superelement_drift(&c, z, G);
        cardan_3_times(G, 0, at.w, 1, more);
        for (int k = 0; k < 3; ++k) p[k] += more[k];
        cardan_3_times(G, 1, v, 1, more);
        for (int k = 0; k < 3; ++k) m[k] += more[k];
    }
    cardan_3_times(at.R0, 0, p, 1, out + 3);
    cardan_3_times(at.R0, 0, m, 1, out);
    cardan_3_add_cross(at.x0, out + 3, out);
    return CARDAN_OK;
}

/* What damping gives to the motion. */
CARDAN_INLINE int cardan_superelement_power(int n, int on_node, int drifts, const double *constants,
                                            const cardan_in *in, real *CARDAN_RESTRICT out,
                                            real *CARDAN_RESTRICT work)
{
    const cardan_superelement c = cardan_superelement_of(n, drifts, constants);
    const real *const rate = in->u + 6 * on_node;

    cardan_set_product(n, n, NULL, c.damping, rate, work);
    cardan_dots(1, n, work, rate, out);
    out[0] = -out[0];
    return CARDAN_OK;
}

#endif
