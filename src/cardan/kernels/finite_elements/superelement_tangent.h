/*
 * superelement_tangent.h: derivatives K, C and M of the balance of a superelement.
 *
 * Columns of the node first. With W = R^T, from axes of the node to those of the frame, p the arm
 * of the frame and a^ the matrix of the cross product with a,
 *
 *     d w' = W dw'_node,  d alpha = -W p^ dw'_node + R0^T dx''
 *     d w = W dw_node,    d alpha = -W ((w x p)^ + w^ p^) dw_node, w of the node there
 *     d alpha = W (x'' - g)^ dtheta by a rotation of the node, in whose axes x'' - g is.
 *
 * The latter also turns the force f on the frame, which acts in ground axes.
 */
#ifndef CARDAN_SUPERELEMENT_TANGENT_H
#define CARDAN_SUPERELEMENT_TANGENT_H

#include "superelement.h"
#include "superelement_terms.h"
#include "superelement_drift.h"

/* Three columns: alpha changes by X, w or w' by Y (3, 3) times the unknowns, which changes f by F Y,
 * the moment by N Y and what acts along z by B^T Y beside what alpha does. Y may be NULL. */
CARDAN_INLINE void cardan_superelement_columns(const cardan_superelement *c,
                                               const cardan_frame_motion *at,
                                               const cardan_superelement_terms *is, const real *X,
                                               const real *Y, const real *F, const real *N,
                                               const real *B, int stride, real *out)
{
    const int n = c->n;
    real load[18], *const f = load, *const m = load + 9, more[9];

    cardan_3_times(is->s_skew, 0, X, 3, m);
    for (int k = 0; k < 9; ++k) f[k] = c->mass[0] * X[k];
    if (Y) {
        cardan_3_times(F, 0, Y, 3, more);
        for (int k = 0; k < 9; ++k) f[k] += more[k];
        cardan_3_times(N, 0, Y, 3, more);
        for (int k = 0; k < 9; ++k) m[k] += more[k];
    }
    cardan_node_rows(1, at, is, load, 3, stride, out);
    /* what acts along z, a row of work for each column */
    for (int j = 0; j < 3; ++j) {
        real *const row = is->columns;

        const real by_alpha[3] = {X[j], X[3 + j], X[6 + j]};

        cardan_set_product(3, n, NULL, c->momentum, by_alpha, row);
        if (Y) {
            const real by_w[3] = {Y[j], Y[3 + j], Y[6 + j]};

            cardan_rows(0, 3, n, B, by_w, row);
        }
        for (int i = 0; i < n; ++i) out[(6 + i) * stride + j] = row[i];
    }
}

CARDAN_INLINE void cardan_superelement_mass(const cardan_superelement *c,
                                            const cardan_frame_motion *at,
                                            const cardan_superelement_terms *is, int stride, real *M)
{
    const int n = c->n;
    real X[9], F[9], skew[9];

    /* w' of the node */
    cardan_3_skew(at->p, -1.0, skew);
    cardan_3_times(is->to_frame, 0, skew, 3, X);
    cardan_3_skew(is->s, -1.0, F);
    cardan_superelement_columns(c, at, is, X, is->to_frame, F, is->J, is->H, stride, M);
    /* x'' */
    for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) X[3 * k + l] = at->R0[3 * l + k];
    cardan_superelement_columns(c, at, is, X, NULL, NULL, NULL, NULL, stride, M + 3);
    /* z'' */
    for (int i = 0; i < 3 * n; ++i) {
        is->force[i] = CARDAN_REAL(c->momentum[i]);
        is->moment[i] = is->H[i];
    }
    cardan_node_rows(1, at, is, is->force, n, stride, M + 6);
}

CARDAN_INLINE void cardan_superelement_damping(const cardan_superelement *c, const cardan_in *in,
                                               const cardan_frame_motion *at,
                                               const cardan_superelement_terms *is, int stride,
                                               real *C)
{
    const int n = c->n;
    real X[9], F[9], N[9], skew[9], product[9], arm[3];

    /* alpha by w of the node */
    cardan_3_skew(in->u, 1.0, product);
    cardan_3_skew(at->p, -1.0, skew);
    cardan_3_times(product, 0, skew, 3, F);
    cardan_3_cross(in->u, at->p, arm);
    cardan_3_skew(arm, -1.0, skew);
    for (int k = 0; k < 9; ++k) F[k] += skew[k];
    cardan_3_times(is->to_frame, 0, F, 3, X);
    /* f by w: -(w x s + 2 P z')^ - w^ s^ */
    cardan_3_times(is->w_skew, 0, is->s_skew, 3, product);
    cardan_3_skew(is->spun, -1.0, F);
    for (int k = 0; k < 9; ++k) F[k] -= product[k];
    /* moment by w: w^ J - (J w + H z')^ + J' */
    cardan_3_times(is->w_skew, 0, is->J, 3, N);
    cardan_3_skew(is->momentum, -1.0, skew);
    for (int k = 0; k < 9; ++k) N[k] += skew[k] + is->J_rate[k];
    for (int i = 0; i < 3 * n; ++i) is->scratch[i] = is->back[i] - is->ahead[i] - is->by_w[i];
    cardan_superelement_columns(c, at, is, X, is->to_frame, F, N, is->scratch, stride, C);

    /* f and moment by z': 2 w^ P; 2 w_l (j + S z) + (A + A^T) z' + w^ H */
    for (int i = 0; i < 3 * n; ++i) is->moment[i] = is->by_w[i] + is->ahead[i] + is->back[i];
    cardan_3_rows(0, n, is->w_skew, is->H, is->moment);
    for (int k = 0; k < 9; ++k) product[k] = 2.0 * is->w_skew[k];
    cardan_3_constants(n, product, c->momentum, is->force);
    cardan_node_rows(1, at, is, is->force, n, stride, C + 6);
}

CARDAN_INLINE void cardan_superelement_stiffness(const cardan_superelement *c,
                                                 const cardan_frame_motion *at,
                                                 const cardan_superelement_terms *is, int stride,
                                                 real *K)
{
    const int n = c->n;
    real X[9], skew[9], product[9], f[3], there[3];

    /* rotations of the node turn alpha */
    cardan_3_skew(at->pull, 1.0, skew);
    cardan_3_times(is->to_frame, 0, skew, 3, X);
    cardan_superelement_columns(c, at, is, X, NULL, NULL, NULL, NULL, stride, K);
    /* and the force, which acts in ground axes */
    for (int k = 0; k < 3; ++k) f[k] = c->mass[0] * at->alpha[k];
    cardan_superelement_flow(c, is->second, f);
    cardan_3_add_cross(at->w_rate, is->s, f);
    cardan_3_add_cross(at->w, is->spun, f);
    cardan_3_times(at->local, 0, f, 1, there);
    cardan_3_skew(there, -1.0, skew);
    cardan_3_times(at->node, 0, skew, 3, X);
    for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) K[(3 + k) * stride + l] += X[3 * k + l];

    /* f by z: (w'^ + w^ w^) P */
    cardan_3_times(is->w_skew, 0, is->w_skew, 3, product);
    cardan_3_skew(at->w_rate, 1.0, skew);
    for (int k = 0; k < 9; ++k) product[k] += skew[k];
    cardan_3_constants(n, product, c->momentum, is->force);
    /* moment by z: -alpha^ P + w^ (2 w_l (j + S z) + A z') */
    cardan_3_skew(at->alpha, -1.0, skew);
    cardan_3_constants(n, skew, c->momentum, is->moment);
    cardan_3_rows(0, n, is->w_skew, is->by_w, is->moment);
    cardan_3_rows(0, n, is->w_skew, is->ahead, is->moment);
    /* + A z'' + 2 w'_l (j + S z) + 2 w_l S z' */
    for (int i = 0; i < 3 * n; ++i) is->moment[i] += is->spun_second[i];
    for (int k = 0; k < 3; ++k) {
        real twice[12];

        cardan_pairs_with(k, at->w_rate, twice);
        cardan_pairs_with(k, at->w, twice + 6);
        cardan_rows(0, 12, n, is->bent, twice, is->moment + k * n);
    }
    cardan_node_rows(1, at, is, is->force, n, stride, K + 6);
}

/* K, C, M (N, N) one behind the other, N = n + 6 where a node has the frame. Nothing depends on
 * where the node is, nor on its velocity. */
CARDAN_INLINE int cardan_superelement_tangent(int n, int on_node, int drifts, const double *constants,
                                              const cardan_in *in, real *CARDAN_RESTRICT out,
                                              real *CARDAN_RESTRICT work)
{
    const cardan_superelement c = cardan_superelement_of(n, drifts, constants);
    const int first = 6 * on_node, N = n + first, along = first * N + first;
    real *const K = out, *const C = out + N * N, *const M = out + 2 * N * N;
    cardan_superelement_terms is;
    cardan_frame_motion at;
    real by_spin[9];

    cardan_frame_motion_of(in, on_node, 2, &at);
    /* along z: K + w'_k A_k^T - w_k w_l S_kl; the matrices follow each other */
    cardan_pairs_of(at.w, by_spin + 3);
    for (int k = 0; k < 6; ++k) by_spin[3 + k] = -by_spin[3 + k];
    for (int k = 0; k < 3; ++k) by_spin[k] = at.w_rate[k];
    cardan_set_matrix(on_node ? 9 : 0, n, c.stiffness, c.spin_back, by_spin, N, K + along);
    /* D + w_k (A_k^T - A_k) */
    for (int k = 0; k < 3; ++k) {
        by_spin[k] = -at.w[k];
        by_spin[3 + k] = at.w[k];
    }
    cardan_set_matrix(on_node ? 6 : 0, n, c.damping, c.spin, by_spin, N, C + along);
    cardan_set_matrix(0, n, c.modal, c.spin, by_spin, N, M + along);
    if (!on_node) return CARDAN_OK;
    /* nothing depends on where the node is, and without drift not on its velocity */
    for (int i = 0; i < N; ++i)
        for (int j = 3; j < 6; ++j) K[i * N + j] = C[i * N + j] = CARDAN_REAL(0.0);
    cardan_superelement_terms_of(&c, in, &at, work, &is);
    cardan_superelement_mass(&c, &at, &is, N, M);
    cardan_superelement_damping(&c, in, &at, &is, N, C);
    cardan_superelement_stiffness(&c, &at, &is, N, K);
    if (c.drift) cardan_drift_tangent(&c, in, &at, &is, N, K, C, M);
    return CARDAN_OK;
}

#endif
