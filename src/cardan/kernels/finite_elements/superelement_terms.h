/*
 * superelement_terms.h: what several parts of the tangent of a superelement need.
 */
#ifndef CARDAN_SUPERELEMENT_TERMS_H
#define CARDAN_SUPERELEMENT_TERMS_H

#include "superelement.h"

/* What several columns need. Rows are (3, n) but for `bent`. */
typedef struct cardan_superelement_terms {
    const real *rate, *second;      /* z', z'' */
    real s[3], spun[3];             /* w x s + 2 P z' */
    real momentum[3];               /* J w + H z' */
    real J[9], J_rate[9], to_frame[9], w_skew[9], s_skew[9];
    real arm[9];                    /* p^ R: moments at the node of forces on the frame */
    real *H, *bent;                 /* bent: j + S z by pairs (6, n) */
    real *ahead, *back;             /* A_k z', A_k^T z' */
    real *spun_second;              /* A_k z'' */
    real *squared;                  /* S z' by pairs (6, n) */
    real *by_w;                     /* 2 w_l (j_kl + S_kl z) */
    real *force, *moment, *scratch; /* columns on the frame */
    real *columns;                  /* (n) */
} cardan_superelement_terms;

/* Rows of the node, zero so far, from columns of force f and moment m (3, columns) on the frame. */
CARDAN_INLINE void cardan_node_rows(const cardan_frame_motion *at, const cardan_superelement_terms *is,
                                    const real *f, const real *m, int columns, int stride, real *out)
{
    cardan_add_3_rows(columns, at->local, m, stride, out);
    cardan_add_3_rows(columns, is->arm, f, stride, out);
    cardan_add_3_rows(columns, at->R0, f, stride, out + 3 * stride);
}

CARDAN_INLINE void cardan_superelement_terms_of(const cardan_superelement *c, const cardan_in *in,
                                                const cardan_frame_motion *at, real *work,
                                                cardan_superelement_terms *is)
{
    const int n = c->n;
    real pairs[6], rates[6], flow[3], skew[9];

    /* scratch, in the order in which it is cleared */
    is->rate = in->u + 6;
    is->second = in->udot + 6;
    is->H = work;
    is->bent = work + 3 * n;
    is->ahead = work + 9 * n;
    is->by_w = work + 12 * n;
    is->spun_second = work + 15 * n;
    is->back = work + 18 * n;
    is->squared = work + 21 * n;
    is->force = work + 27 * n;
    is->moment = work + 30 * n;
    is->scratch = work + 33 * n;
    is->columns = work + 36 * n;
    cardan_superelement_shape(c, in->q + 7, is->rate, is->s, is->H, pairs, is->bent, is->back,
                              is->squared);
    for (int k = 0; k < 6; ++k) {
        cardan_dot(n, is->bent + k * n, is->rate, rates + k);
        rates[k] *= 2.0;
    }
    /* gyroscopic terms: products of z' and z'' with A_k, and of 2 w_l with j + S z */
    cardan_3_cross(at->w, is->s, is->spun);
    cardan_clear(9 * n, is->ahead);
    cardan_clear(3, flow);
    cardan_superelement_flow(c, is->rate, flow);
    for (int k = 0; k < 3; ++k) {
        cardan_add_products(n, n, c->spin_back + k * n * n, is->rate, is->ahead + k * n, is->second,
                            is->spun_second + k * n);
        for (int l = 0; l < 3; ++l) {
            const int pair = CARDAN_PAIR[k][l];
            const real twice = 2.0 * at->w[l];

            cardan_add_scaled(n, &twice, is->bent + pair * n, is->by_w + k * n);
            is->J[3 * k + l] = pairs[pair];
            is->J_rate[3 * k + l] = rates[pair];
            is->to_frame[3 * k + l] = at->local[3 * l + k];
        }
        cardan_dot(n, is->H + k * n, is->rate, is->momentum + k);
        is->spun[k] += 2.0 * flow[k];
    }
    /* what the cross product with w takes of f and of the moment */
    cardan_3_add_symmetric(pairs, at->w, is->momentum);
    cardan_3_skew(at->w, 1.0, is->w_skew);
    cardan_3_skew(is->s, 1.0, is->s_skew);
    cardan_3_skew(at->p, 1.0, skew);
    cardan_3_times(skew, 0, at->local, 3, is->arm);
}

#endif
