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

/* What several columns need. Rows are (3, n) but for `bent`. */
typedef struct cardan_superelement_terms {
    const real *rate, *second;      /* z', z'' */
    real s[3], spun[3];             /* w x s + 2 P z' */
    real momentum[3];               /* J w + H z' */
    real J[9], J_rate[9], to_frame[9], w_skew[9], s_skew[9];
    real *H, *bent;                 /* bent: j + S z by pairs (6, n) */
    real *ahead, *back;             /* A_k z', A_k^T z' */
    real *by_w;                     /* 2 w_l (j_kl + S_kl z) */
    real *force, *moment, *scratch; /* columns on the frame */
} cardan_superelement_terms;

/* Rows of the node from columns of force f and moment m (3, columns) on the frame. */
CARDAN_INLINE void cardan_node_rows(const cardan_frame_motion *at, const real *f, const real *m,
                                    int columns, int stride, real *out)
{
    for (int j = 0; j < columns; ++j) {
        const real force[3] = {f[j], f[columns + j], f[2 * columns + j]};
        const real moment[3] = {m[j], m[columns + j], m[2 * columns + j]};
        real there[3], rotated[3], in_ground[3];

        cardan_3_times(at->local, 0, force, 1, there);
        cardan_3_times(at->local, 0, moment, 1, rotated);
        cardan_3_add_cross(at->p, there, rotated);
        cardan_3_times(at->node, 0, there, 1, in_ground);
        for (int k = 0; k < 3; ++k) {
            out[k * stride + j] = rotated[k];
            out[(3 + k) * stride + j] = in_ground[k];
        }
    }
}

/* Three columns: alpha changes by X, w or w' by Y (3, 3) times the unknowns, which changes f by F Y,
 * the moment by N Y and what acts along z by B^T Y beside what alpha does. Y may be NULL. */
CARDAN_INLINE void cardan_superelement_columns(const cardan_superelement *c,
                                               const cardan_frame_motion *at,
                                               const cardan_superelement_terms *is, const real *X,
                                               const real *Y, const real *F, const real *N,
                                               const real *B, int stride, real *out)
{
    real f[9], m[9], more[9];

    cardan_3_times(is->s_skew, 0, X, 3, m);
    for (int k = 0; k < 9; ++k) f[k] = c->mass[0] * X[k];
    if (Y) {
        cardan_3_times(F, 0, Y, 3, more);
        for (int k = 0; k < 9; ++k) f[k] += more[k];
        cardan_3_times(N, 0, Y, 3, more);
        for (int k = 0; k < 9; ++k) m[k] += more[k];
    }
    cardan_node_rows(at, f, m, 3, stride, out);
    for (int i = 0; i < c->n; ++i)
        for (int j = 0; j < 3; ++j) {
            real sum = CARDAN_REAL(0.0);

            for (int k = 0; k < 3; ++k) sum += c->momentum[k * c->n + i] * X[3 * k + j];
            if (Y)
                for (int k = 0; k < 3; ++k) sum += B[k * c->n + i] * Y[3 * k + j];
            out[(6 + i) * stride + j] = sum;
        }
}

/* out (3, n) = Q P with P of constants */
CARDAN_INLINE void cardan_3_times_constants(const real *Q, const double *P, int n, real *out)
{
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < n; ++i)
            out[k * n + i] = Q[3 * k] * P[i] + Q[3 * k + 1] * P[n + i] + Q[3 * k + 2] * P[2 * n + i];
}

CARDAN_INLINE void cardan_superelement_terms_of(const cardan_superelement *c, const cardan_in *in,
                                                const cardan_frame_motion *at, real *work,
                                                cardan_superelement_terms *is)
{
    const int n = c->n;
    real pairs[6], rates[6];

    is->rate = in->u + 6;
    is->second = in->udot + 6;
    is->H = work;
    is->bent = work + 3 * n;
    is->ahead = work + 9 * n;
    is->back = work + 12 * n;
    is->by_w = work + 15 * n;
    is->force = work + 18 * n;
    is->moment = work + 21 * n;
    is->scratch = work + 24 * n;
    cardan_superelement_shape(c, in->q + 7, is->s, is->H, pairs, is->bent);
    for (int k = 0; k < 6; ++k) rates[k] = cardan_dot(n, is->bent + k * n, is->rate) * 2.0;
    cardan_3_cross(at->w, is->s, is->spun);
    for (int k = 0; k < 3; ++k) {
        const double *const A = c->spin + k * n * n, *const A_back = c->spin_back + k * n * n;

        for (int i = 0; i < n; ++i)
            is->ahead[k * n + i] = is->back[k * n + i] = is->by_w[k * n + i] = CARDAN_REAL(0.0);
        cardan_add_product(n, n, A_back, is->rate, is->ahead + k * n);
        cardan_add_product(n, n, A, is->rate, is->back + k * n);
        for (int l = 0; l < 3; ++l) {
            const int pair = CARDAN_PAIR[k][l];

            for (int i = 0; i < n; ++i)
                is->by_w[k * n + i] += 2.0 * at->w[l] * is->bent[pair * n + i];
            is->J[3 * k + l] = pairs[pair];
            is->J_rate[3 * k + l] = rates[pair];
            is->to_frame[3 * k + l] = at->local[3 * l + k];
        }
        is->momentum[k] = cardan_dot(n, is->H + k * n, is->rate);
        is->spun[k] += 2.0 * cardan_dot_constant(n, c->momentum + k * n, is->rate);
    }
    cardan_3_add_symmetric(pairs, at->w, is->momentum);
    cardan_3_skew(at->w, 1.0, is->w_skew);
    cardan_3_skew(is->s, 1.0, is->s_skew);
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
    for (int i = 0; i < 3 * n; ++i) is->force[i] = CARDAN_REAL(c->momentum[i]);
    cardan_node_rows(at, is->force, is->H, n, stride, M + 6);
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
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3, last = (k + 2) % 3;

        for (int i = 0; i < n; ++i)
            is->moment[k * n + i] = is->by_w[k * n + i] + is->ahead[k * n + i] + is->back[k * n + i]
                                    + at->w[next] * is->H[last * n + i]
                                    - at->w[last] * is->H[next * n + i];
    }
    for (int k = 0; k < 9; ++k) product[k] = 2.0 * is->w_skew[k];
    cardan_3_times_constants(product, c->momentum, n, is->force);
    cardan_node_rows(at, is->force, is->moment, n, stride, C + 6);
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
    for (int k = 0; k < 3; ++k)
        f[k] = c->mass[0] * at->alpha[k]
               + cardan_dot_constant(n, c->momentum + k * n, is->second);
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
    cardan_3_times_constants(product, c->momentum, n, is->force);
    /* moment by z: -alpha^ P + w^ (2 w_l (j + S z) + A z') */
    cardan_3_skew(at->alpha, -1.0, skew);
    cardan_3_times_constants(skew, c->momentum, n, is->moment);
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3, last = (k + 2) % 3;
        const real *const a = is->by_w + last * n, *const a_rate = is->ahead + last * n;
        const real *const b = is->by_w + next * n, *const b_rate = is->ahead + next * n;

        for (int i = 0; i < n; ++i)
            is->moment[k * n + i] += at->w[next] * (a[i] + a_rate[i])
                                     - at->w[last] * (b[i] + b_rate[i]);
    }
    /* + A z'' + 2 w'_l (j + S z) + 2 w_l S z' */
    for (int pair = 0; pair < 6; ++pair) {
        for (int i = 0; i < n; ++i) is->scratch[i] = CARDAN_REAL(0.0);
        cardan_add_product(n, n, c->squares + pair * n * n, is->rate, is->scratch);
        for (int k = 0; k < 3; ++k)
            for (int l = 0; l < 3; ++l)
                if (CARDAN_PAIR[k][l] == pair)
                    for (int i = 0; i < n; ++i)
                        is->moment[k * n + i] += 2.0 * (at->w_rate[l] * is->bent[pair * n + i]
                                                        + at->w[l] * is->scratch[i]);
    }
    for (int k = 0; k < 3; ++k)
        cardan_add_product(n, n, c->spin_back + k * n * n, is->second, is->moment + k * n);
    cardan_node_rows(at, is->force, is->moment, n, stride, K + 6);
}

/* K, C, M (N, N) one behind the other, N = n + 6 where a node has the frame. */
CARDAN_INLINE int cardan_superelement_tangent(int n, int on_node, const double *constants,
                                              const cardan_in *in, real *CARDAN_RESTRICT out,
                                              real *CARDAN_RESTRICT work)
{
    const cardan_superelement c = cardan_superelement_of(n, constants);
    const int first = 6 * on_node, N = n + first;
    real *const K = out, *const C = out + N * N, *const M = out + 2 * N * N;
    cardan_superelement_terms is;
    cardan_frame_motion at;
    real pairs[6];

    cardan_frame_motion_of(in, on_node, 2, &at);
    for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) pairs[CARDAN_PAIR[k][l]] = at.w[k] * at.w[l] * (k == l ? 1 : 2);
    /* along z: K + w'_k A_k^T - w_k w_l S_kl, D + w_k (A_k^T - A_k), M */
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const int to = (first + i) * N + first + j, from = i * n + j;
            real k = CARDAN_REAL(c.stiffness[from]), d = CARDAN_REAL(c.damping[from]);

            if (on_node) {
                for (int a = 0; a < 3; ++a) {
                    const double back = c.spin_back[a * n * n + from];

                    k += at.w_rate[a] * back;
                    d += at.w[a] * (back - c.spin[a * n * n + from]);
                }
                for (int a = 0; a < 6; ++a) k -= pairs[a] * c.squares[a * n * n + from];
            }
            K[to] = k;
            C[to] = d;
            M[to] = CARDAN_REAL(c.modal[from]);
        }
    if (!on_node) return CARDAN_OK;
    cardan_superelement_terms_of(&c, in, &at, work, &is);
    cardan_superelement_mass(&c, &at, &is, N, M);
    cardan_superelement_damping(&c, in, &at, &is, N, C);
    cardan_superelement_stiffness(&c, &at, &is, N, K);
    /* nothing depends on where the node is, nor on its velocity */
    for (int i = 0; i < N; ++i)
        for (int j = 3; j < 6; ++j) K[i * N + j] = C[i * N + j] = CARDAN_REAL(0.0);
    return CARDAN_OK;
}

#endif
