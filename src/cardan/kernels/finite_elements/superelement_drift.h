/*
 * superelement_drift.h: derivatives of what v.G w adds to the balance of a superelement.
 *
 * With v = R^T (R_node^T x' + w x p), w of the node there, and dv' = d(alpha + R0^T g) - d(w x v),
 *
 *     df = G' dw + G dw' + w x G dw - (G w) x dw
 *     dn = G'^T dv + G^T dv' + w x G^T dv - (G^T v) x dw + v x G dw - (G w) x dv
 *     db = -sum over r and k of (v_r dw_k + dv_r w_k) E_rk
 *
 * at a given z. The force f on the frame acts in ground axes and turns with the node.
 */
#ifndef CARDAN_SUPERELEMENT_DRIFT_H
#define CARDAN_SUPERELEMENT_DRIFT_H

#include "superelement_terms.h"

/* What is the same for all columns. */
typedef struct cardan_drift {
    real G[9], G_rate[9], Gw_skew[9], by_v[9], v_skew[9];
} cardan_drift;

/* Three columns: w changes by Y, w' by Y_rate, v by V, and v' by V_rate (3, 3); NULL: not at all. */
CARDAN_INLINE void cardan_drift_columns(const cardan_superelement *c, const cardan_frame_motion *at,
                                        const cardan_superelement_terms *is, const cardan_drift *d,
                                        const real *Y, const real *Y_rate, const real *V,
                                        const real *V_rate, int stride, real *out)
{
    const int n = c->n;
    real load[18], *const f = load, *const m = load + 9, product[9], more[9], back[9];

    for (int k = 0; k < 9; ++k) f[k] = m[k] = CARDAN_REAL(0.0);
    if (Y) {
        /* f: G' + w^ G - (G w)^; the moment: v^ G - (G^T v)^ */
        cardan_3_times(is->w_skew, 0, d->G, 3, product);
        for (int k = 0; k < 9; ++k) product[k] += d->G_rate[k] - d->Gw_skew[k];
        cardan_3_times(product, 0, Y, 3, f);
        cardan_3_times(d->v_skew, 0, d->G, 3, product);
        for (int k = 0; k < 9; ++k) product[k] -= d->by_v[k];
        cardan_3_times(product, 0, Y, 3, m);
    }
    if (Y_rate) {
        cardan_3_times(d->G, 0, Y_rate, 3, more);
        for (int k = 0; k < 9; ++k) f[k] += more[k];
    }
    if (V) {
        /* the moment: G'^T + w^ G^T - (G w)^ */
        for (int k = 0; k < 3; ++k)
            for (int l = 0; l < 3; ++l) back[3 * k + l] = d->G[3 * l + k];
        cardan_3_times(is->w_skew, 0, back, 3, product);
        for (int k = 0; k < 9; ++k)
            product[k] += d->G_rate[3 * (k % 3) + k / 3] - d->Gw_skew[k];
        cardan_3_times(product, 0, V, 3, more);
        for (int k = 0; k < 9; ++k) m[k] += more[k];
    }
    if (V_rate) {
        cardan_3_times(d->G, 1, V_rate, 3, more);
        for (int k = 0; k < 9; ++k) m[k] += more[k];
    }
    cardan_node_rows(0, at, is, load, 3, stride, out);
    for (int j = 0; j < 3; ++j) {
        real dv[3], dw[3];

        for (int k = 0; k < 3; ++k) {
            dv[k] = V ? V[3 * k + j] : CARDAN_REAL(0.0);
            dw[k] = Y ? Y[3 * k + j] : CARDAN_REAL(0.0);
        }
        cardan_clear(n, is->columns);
        if (Y) cardan_superelement_add_drift(c, at->v, dw, -1.0, is->columns);
        if (V) cardan_superelement_add_drift(c, dv, at->w, -1.0, is->columns);
        for (int i = 0; i < n; ++i) out[(6 + i) * stride + j] += is->columns[i];
    }
}

/* out (3, n) += sums over axes of w, by rows of v; or over rows of v, by axes of w */
CARDAN_INLINE void cardan_drift_rows(const cardan_superelement *c, const real *w, const real *v,
                                     real *out)
{
    const int n = c->n;

    for (int r = 0; r < 3; ++r)
        for (int k = 0; k < 3; ++k)
            cardan_add_product(1, n, c->drift + (3 * r + k) * n, w ? w + k : v + r,
                               out + (w ? r : k) * n);
}

CARDAN_INLINE void cardan_drift_tangent(const cardan_superelement *c, const cardan_in *in,
                                        const cardan_frame_motion *at,
                                        const cardan_superelement_terms *is, int stride, real *K,
                                        real *C, real *M)
{
    const int n = c->n;
    cardan_drift d;
    real Gw[3], Gv[3], f[3], more[3], V[9], V_rate[9], skew[9], product[9], back[9], arm[3];

    /* G w and G^T v, and the force on the frame */
    cardan_superelement_drift(c, in->q + 7, d.G);
    cardan_superelement_drift(c, is->rate, d.G_rate);
    cardan_3_times(d.G, 0, at->w, 1, Gw);
    cardan_3_times(d.G, 1, at->v, 1, Gv);
    cardan_3_skew(Gw, 1.0, d.Gw_skew);
    cardan_3_skew(Gv, 1.0, d.by_v);
    cardan_3_skew(at->v, 1.0, d.v_skew);
    cardan_3_times(d.G_rate, 0, at->w, 1, f);
    cardan_3_times(d.G, 0, at->w_rate, 1, more);
    for (int k = 0; k < 3; ++k) f[k] += more[k];
    cardan_3_add_cross(at->w, Gw, f);
    for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) back[3 * k + l] = at->R0[3 * l + k];

    /* M: w' of the node moves v' by -W p^, its acceleration by R0^T */
    cardan_3_skew(at->p, -1.0, skew);
    cardan_3_times(is->to_frame, 0, skew, 3, V);
    cardan_drift_columns(c, at, is, &d, NULL, is->to_frame, NULL, V, stride, M);
    cardan_drift_columns(c, at, is, &d, NULL, NULL, NULL, back, stride, M + 3);

    /* C: w of the node moves v by -W p^, v' by -W ((w x p)^ + w^ p^) + v^ W - w^ dv */
    cardan_3_skew(in->u, 1.0, product);
    cardan_3_times(product, 0, skew, 3, V_rate);
    cardan_3_cross(in->u, at->p, arm);
    cardan_3_skew(arm, -1.0, product);
    for (int k = 0; k < 9; ++k) V_rate[k] += product[k];
    cardan_3_times(is->to_frame, 0, V_rate, 3, product);
    cardan_3_times(d.v_skew, 0, is->to_frame, 3, V_rate);
    for (int k = 0; k < 9; ++k) V_rate[k] += product[k];
    cardan_3_times(is->w_skew, 0, V, 3, product);
    for (int k = 0; k < 9; ++k) V_rate[k] -= product[k];
    cardan_drift_columns(c, at, is, &d, is->to_frame, NULL, V, V_rate, stride, C);
    /* its velocity moves v by R0^T, v' by -w^ R0^T */
    cardan_3_times(is->w_skew, 0, back, 3, V_rate);
    for (int k = 0; k < 9; ++k) V_rate[k] = -V_rate[k];
    cardan_drift_columns(c, at, is, &d, NULL, NULL, back, V_rate, stride, C + 3);
    /* by z' */
    cardan_clear(3 * n, is->force);
    cardan_clear(3 * n, is->moment);
    cardan_drift_rows(c, at->w, NULL, is->force);
    cardan_drift_rows(c, NULL, at->v, is->moment);
    cardan_node_rows(0, at, is, is->force, n, stride, C + 6);

    /* K: rotations of the node turn its velocity and its acceleration in the frame */
    cardan_3_times(at->node, 1, in->u + 3, 1, arm);
    cardan_3_skew(arm, 1.0, skew);
    cardan_3_times(is->to_frame, 0, skew, 3, V);
    cardan_3_times(at->node, 1, in->udot + 3, 1, arm);
    cardan_3_skew(arm, 1.0, skew);
    cardan_3_times(is->to_frame, 0, skew, 3, V_rate);
    cardan_3_times(is->w_skew, 0, V, 3, product);
    for (int k = 0; k < 9; ++k) V_rate[k] -= product[k];
    cardan_drift_columns(c, at, is, &d, NULL, NULL, V, V_rate, stride, K);
    cardan_3_times(at->local, 0, f, 1, arm);
    cardan_3_skew(arm, -1.0, skew);
    cardan_3_times(at->node, 0, skew, 3, product);
    for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) K[(3 + k) * stride + l] += product[3 * k + l];
    /* by z: E w' + w x E w, v'.E + w x v.E + v x E w */
    cardan_clear(3 * n, is->scratch);
    cardan_drift_rows(c, at->w, NULL, is->scratch);
    cardan_clear(3 * n, is->force);
    cardan_drift_rows(c, at->w_rate, NULL, is->force);
    cardan_3_rows(0, n, is->w_skew, is->scratch, is->force);
    cardan_clear(3 * n, is->moment);
    cardan_drift_rows(c, NULL, at->v_rate, is->moment);
    cardan_3_rows(0, n, d.v_skew, is->scratch, is->moment);
    cardan_clear(3 * n, is->scratch);
    cardan_drift_rows(c, NULL, at->v, is->scratch);
    cardan_3_rows(0, n, is->w_skew, is->scratch, is->moment);
    cardan_node_rows(0, at, is, is->force, n, stride, K + 6);
}

#endif
