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
    real lever[18];                 /* (3, 6): moments at the node of forces and moments on the frame */
    real *H, *bent;                 /* bent: j + S z by pairs (6, n) */
    real *ahead, *back;             /* A_k z', A_k^T z' */
    real *spun_second;              /* A_k z'' */
    real *squared;                  /* S z' by pairs (6, n), behind bent */
    real *by_w;                     /* 2 w_l (j_kl + S_kl z) */
    real *force, *moment, *scratch; /* columns on the frame, the moment behind the force */
    real *columns;                  /* (n) */
} cardan_superelement_terms;

/* Rows of the node from columns (6, columns) of force and moment on the frame, or more of them. */
CARDAN_INLINE void cardan_node_rows(int set, const cardan_frame_motion *at,
                                    const cardan_superelement_terms *is, const real *load,
                                    int columns, int stride, real *out)
{
    for (int k = 0; k < 3; ++k) {
        cardan_rows(set, 6, columns, load, is->lever + 6 * k, out + k * stride);
        cardan_rows(set, 3, columns, load, at->R0 + 3 * k, out + (3 + k) * stride);
    }
}

CARDAN_INLINE void cardan_superelement_terms_of(const cardan_superelement *c, const cardan_in *in,
                                                const cardan_frame_motion *at, real *work,
                                                cardan_superelement_terms *is)
{
    const int n = c->n;
    real pairs[6], rates[6], flow[3], skew[9], arm[9];

    is->rate = in->u + 6;
    is->second = in->udot + 6;
    is->H = work;
    is->bent = work + 3 * n;
    is->squared = work + 9 * n;
    is->ahead = work + 15 * n;
    is->by_w = work + 18 * n;
    is->spun_second = work + 21 * n;
    is->back = work + 24 * n;
    is->force = work + 27 * n;
    is->moment = work + 30 * n;
    is->scratch = work + 33 * n;
    is->columns = work + 36 * n;
    cardan_superelement_shape(c, in->q + 7, is->rate, is->s, is->H, pairs, is->bent, is->back,
                              is->squared);
    cardan_dots(6, n, is->bent, is->rate, rates);
    for (int k = 0; k < 6; ++k) rates[k] *= 2.0;
    /* gyroscopic terms: products of z' and z'' with A_k, and of 2 w_l with j + S z */
    cardan_3_cross(at->w, is->s, is->spun);
    cardan_dots_constants(3, n, c->momentum, is->rate, flow);
    cardan_dots(3, n, is->H, is->rate, is->momentum);
    for (int k = 0; k < 3; ++k) {
        real twice[6];

        cardan_set_products(n, n, NULL, c->spin_back + k * n * n, is->rate, is->ahead + k * n,
                            is->second, is->spun_second + k * n);
        cardan_pairs_with(k, at->w, twice);
        cardan_rows(1, 6, n, is->bent, twice, is->by_w + k * n);
        for (int l = 0; l < 3; ++l) {
            is->J[3 * k + l] = pairs[CARDAN_PAIR[k][l]];
            is->J_rate[3 * k + l] = rates[CARDAN_PAIR[k][l]];
            is->to_frame[3 * k + l] = at->local[3 * l + k];
        }
        is->spun[k] += 2.0 * flow[k];
    }
    /* what the cross product with w takes of f and of the moment */
    cardan_3_add_symmetric(pairs, at->w, is->momentum);
    cardan_3_skew(at->w, 1.0, is->w_skew);
    cardan_3_skew(is->s, 1.0, is->s_skew);
    cardan_3_skew(at->p, 1.0, skew);
    cardan_3_times(skew, 0, at->local, 3, arm);
    for (int k = 0; k < 9; ++k) {
        is->lever[6 * (k / 3) + k % 3] = arm[k];
        is->lever[6 * (k / 3) + 3 + k % 3] = at->local[k];
    }
}

#endif
