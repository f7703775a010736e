/*
 * superelement_derivatives.h: gradients of weighted forces and energies of a superelement, and changes.
 * What an impulse is to it is M udot.
 *
 * Weights are in->v; results are derivatives by q as it is stored, u, udot, then nr inputs, the time and
 * the data. Those by how the frame is turned on its node are not known: NaN. Of a change in->v is a
 * direction of all this.
 */
#ifndef CARDAN_SUPERELEMENT_DERIVATIVES_H
#define CARDAN_SUPERELEMENT_DERIVATIVES_H

#include "superelement_momenta.h"
#include "superelement_tangent.h"

/* What rates along the speeds are by a unit quaternion, its length held, and what follows it. */
CARDAN_INLINE void cardan_by_coordinates(int n, int on_node, const real *q, const real *along,
                                         real *by_q)
{
    const int first = 6 * on_node;

    if (on_node) {
        by_q[0] = (q[1] * along[0] + q[2] * along[1] + q[3] * along[2]) * -2.0;
        by_q[1] = (q[0] * along[0] - q[3] * along[1] + q[2] * along[2]) * 2.0;
        by_q[2] = (q[0] * along[1] + q[3] * along[0] - q[1] * along[2]) * 2.0;
        by_q[3] = (q[0] * along[2] - q[2] * along[0] + q[1] * along[1]) * 2.0;
        for (int k = 0; k < 3; ++k) by_q[4 + k] = along[3 + k];
    }
    for (int i = 0; i < n; ++i) by_q[7 * on_node + i] = along[first + i];
}

/* v A (N) for a matrix A (N, N). */
CARDAN_INLINE void cardan_weighted_rows(int N, const real *v, const real *A, real *out)
{
    for (int j = 0; j < N; ++j) out[j] = CARDAN_REAL(0.0);
    for (int i = 0; i < N; ++i)
        for (int j = 0; j < N; ++j) out[j] += v[i] * A[i * N + j];
}

/* Inputs and time, on which nothing depends; the rotation of the frame. Returns where derivatives by
 * its place (3) and gravity (3) follow. */
CARDAN_INLINE real *cardan_superelement_remaining(int nr, real *out)
{
    for (int k = 0; k < nr + 1; ++k) *out++ = CARDAN_REAL(0.0);
    for (int k = 0; k < 9; ++k) *out++ = CARDAN_REAL((double)NAN);
    return out;
}

/* By the place of the frame on its node: its lever, and the motion of a point that turns with the node.
 * force: on the node, ground axes. by_rate, by_second: weights by the velocity and acceleration of the
 * node, ground axes; turn: weights of the moment, axes of the node. */
CARDAN_INLINE void cardan_by_place(const cardan_in *in, const cardan_frame_motion *at,
                                   const real *turn, const real *force, const real *by_rate,
                                   const real *by_second, real *by_p)
{
    real here[3], rate[3], second[3], spun[3];

    /* turn.(e x f) = e.(f x turn) */
    cardan_3_times(at->node, 1, force, 1, here);
    cardan_3_cross(here, turn, by_p);
    /* b.(w x e) = e.(b x w), a.(w' x e + w x (w x e)) = e.(a x w' + (a x w) x w) */
    cardan_3_times(at->node, 1, by_rate, 1, rate);
    cardan_3_add_cross(rate, in->u, by_p);
    cardan_3_times(at->node, 1, by_second, 1, second);
    cardan_3_add_cross(second, in->udot, by_p);
    cardan_3_cross(second, in->u, spun);
    cardan_3_add_cross(spun, in->u, by_p);
}

/* K, C and M of forces, or, where `inertial`, of M udot: at rest without gravity stiffness is left out. */
CARDAN_INLINE int cardan_superelement_slopes(int n, int on_node, int drifts, int inertial,
                                             const double *constants, const cardan_in *in, real *K,
                                             real *work)
{
    const cardan_superelement c = cardan_superelement_of(n, drifts, constants);
    const int first = 6 * on_node, N = n + first;
    const int status = cardan_superelement_tangent(n, on_node, drifts, constants, in, K, work);
    cardan_frame_motion at;

    if (!inertial) return status;
    cardan_frame_motion_of(in, on_node, 2, &at);
    /* w'_k A_k^T along z; nothing follows from speeds */
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            real sum = CARDAN_REAL(0.0);

            for (int k = 0; k < 3 * on_node; ++k)
                sum += at.w_rate[k] * c.spin_back[(k * n + i) * n + j];
            K[(first + i) * N + first + j] = sum;
        }
    for (int i = 0; i < N * N; ++i) K[N * N + i] = CARDAN_REAL(0.0);
    return status;
}

/* The same state without speeds and gravity; `still` (N) and `w` are kept there. */
CARDAN_INLINE cardan_in cardan_without_speeds(int N, const cardan_in *in, real *still, wreal *w)
{
    cardan_in there = *in;

    for (int i = 0; i < N; ++i) still[i] = CARDAN_REAL(0.0);
    for (int k = 0; k < 15; ++k) w[k] = in->w[k] * (k < 12 ? 1.0 : 0.0);
    there.u = still;
    there.w = w;
    return there;
}

/* Of forces (N), or of M udot where `inertial`, with weights v. */
CARDAN_INLINE int cardan_superelement_forces_gradient(int n, int on_node, int drifts, int nr,
                                                      int inertial, const double *constants,
                                                      const cardan_in *in, real *CARDAN_RESTRICT out,
                                                      real *CARDAN_RESTRICT work)
{
    const cardan_superelement c = cardan_superelement_of(n, drifts, constants);
    const int N = n + 6 * on_node, nq = N + on_node;
    real *const K = work, *const M = K + 2 * N * N, *const along = K + 3 * N * N;
    real *const scratch = along + N, *const by_u = out + nq, *const by_udot = by_u + N;
    real *const by_p = cardan_superelement_remaining(nr, by_udot + N), *const by_g = by_p + 3;
    cardan_frame_motion at;
    const int status =
        cardan_superelement_slopes(n, on_node, drifts, inertial, constants, in, K, scratch);

    /* rows of the tangent, with the weights of the forces */
    cardan_weighted_rows(N, in->v, K, along);
    cardan_by_coordinates(n, on_node, in->q, along, out);
    cardan_weighted_rows(N, in->v, K + N * N, by_u);
    cardan_weighted_rows(N, in->v, M, by_udot);
    cardan_frame_motion_of(in, on_node, 1, &at);
    for (int k = 0; k < 3; ++k) by_p[k] = by_g[k] = CARDAN_REAL(0.0);
    if (on_node) {
        (void)cardan_superelement_balance(n, on_node, drifts, constants, in, along, scratch);
        cardan_by_place(in, &at, in->v, along + 3, by_u + 3, by_udot + 3, by_p);
    }
    if (inertial) return status;
    if (on_node) {
        /* gravity pulls as an acceleration of the node pushes, but for what its velocity does */
        if (drifts) (void)cardan_superelement_tangent(n, 1, 0, constants, in, K, scratch);
        cardan_weighted_rows(N, in->v, M, along);
        for (int k = 0; k < 3; ++k) by_g[k] = -along[3 + k];
    } else {
        real flow[3];

        /* of what is fixed to the ground only coordinates feel gravity */
        cardan_dots_constants(3, n, c.momentum, in->v, flow);
        cardan_3_times(at.R0, 0, flow, 1, by_g);
        for (int k = 0; k < 3; ++k) by_g[k] = -by_g[k];
    }
    return status;
}

CARDAN_INLINE int cardan_superelement_dynamics_gradient(int n, int on_node, int drifts, int nr,
                                                        const double *constants, const cardan_in *in,
                                                        real *CARDAN_RESTRICT out,
                                                        real *CARDAN_RESTRICT work)
{
    return cardan_superelement_forces_gradient(n, on_node, drifts, nr, 0, constants, in, out, work);
}

CARDAN_INLINE int cardan_superelement_impulse_gradient(int n, int on_node, int drifts, int nr,
                                                        const double *constants, const cardan_in *in,
                                                        real *CARDAN_RESTRICT out,
                                                        real *CARDAN_RESTRICT work)
{
    const int N = n + 6 * on_node;
    wreal w[15];
    const cardan_in there = cardan_without_speeds(N, in, work, w);

    return cardan_superelement_forces_gradient(n, on_node, drifts, nr, 1, constants, &there, out,
                                               work + N);
}

/* Of the kinetic and the potential energy with two weights. */
CARDAN_INLINE int cardan_superelement_energy_gradient(int n, int on_node, int drifts, int nr,
                                                      const double *constants, const cardan_in *in,
                                                      real *CARDAN_RESTRICT out,
                                                      real *CARDAN_RESTRICT work)
{
    const cardan_superelement c = cardan_superelement_of(n, drifts, constants);
    const int first = 6 * on_node, N = n + first, nq = N + on_node;
    const real kinetic = in->v[0], potential = in->v[1];
    real *const momenta = work, *const slope = work + N, *const force = work + 2 * N;
    real *const still = work + 3 * N, *const scratch = work + 4 * N, *const by_u = out + nq;
    real *const by_p = cardan_superelement_remaining(nr, by_u + 2 * N), *const by_g = by_p + 3;
    real v[3], across[3], s[3];
    cardan_in there = *in;
    cardan_frame_motion at;

    /* momenta are dT/du, and half of the slope of u M u is dT/dz */
    there.udot = in->u;
    (void)cardan_superelement_generalized_momenta(n, on_node, drifts, constants, &there, momenta,
                                                  scratch);
    /* forces at rest are the slope of the potential */
    for (int i = 0; i < N; ++i) still[i] = CARDAN_REAL(0.0);
    there.u = there.udot = still;
    (void)cardan_superelement_balance(n, on_node, drifts, constants, &there, force, scratch);
    cardan_frame_motion_of(in, on_node, 1, &at);
    /* both energies along the speeds, and the kinetic one by them; nothing depends on accelerations */
    for (int i = 0; i < N; ++i) {
        slope[i] = slope[i] * kinetic + force[i] * potential;
        by_u[i] = momenta[i] * kinetic;
        by_u[N + i] = CARDAN_REAL(0.0);
    }
    if (on_node) {
        /* velocity is told in ground axes: a turn of the node changes that along its own */
        cardan_3_times(at.node, 1, in->u + 3, 1, v);
        cardan_3_cross(momenta + 3, v, across);
        for (int k = 0; k < 3; ++k) slope[k] += across[k] * kinetic;
        cardan_3_times(at.node, 0, momenta + 3, 1, v);
        for (int k = 0; k < 3; ++k) by_u[3 + k] = v[k] * kinetic;
    }
    /* a place further out has the velocity w x e, and falls with gravity */
    for (int k = 0; k < 3; ++k) by_p[k] = at.g[k] * (c.mass[0] * -1.0) * potential;
    if (on_node) {
        for (int k = 0; k < 3; ++k) s[k] = by_p[k];
        cardan_3_times(at.node, 1, s, 1, by_p);
        for (int k = 0; k < 3; ++k) v[k] = momenta[3 + k] * kinetic;
        cardan_3_add_cross(v, in->u, by_p);
    }
    cardan_by_coordinates(n, on_node, in->q, slope, out);
    /* V has -g.(m x0 + R0 s) */
    cardan_dots_constants(3, n, c.momentum, in->q + 7 * on_node, s);
    for (int k = 0; k < 3; ++k) s[k] += c.first[k];
    cardan_3_times(at.R0, 0, s, 1, v);
    for (int k = 0; k < 3; ++k) by_g[k] = (v[k] + c.mass[0] * at.x0[k]) * potential * -1.0;
    return CARDAN_OK;
}

/* out (N) += A d for a matrix A (N, N). */
CARDAN_INLINE void cardan_add_matrix(int N, const real *A, const real *d, real *out)
{
    for (int i = 0; i < N; ++i)
        for (int j = 0; j < N; ++j) out[i] += A[i * N + j] * d[j];
}

/* Of forces (N), or of M udot where `inertial`, along a direction. */
CARDAN_INLINE int cardan_superelement_forces_change(int n, int on_node, int drifts, int nr,
                                                    int inertial, const double *constants,
                                                    const cardan_in *in, real *CARDAN_RESTRICT out,
                                                    real *CARDAN_RESTRICT work)
{
    const cardan_superelement c = cardan_superelement_of(n, drifts, constants);
    const int first = 6 * on_node, N = n + first, nq = N + on_node;
    real *const K = work, *const C = K + N * N, *const M = C + N * N, *const along = M + N * N;
    real *const rate = along + N, *const second = rate + N, *const force = second + N;
    real *const scratch = force + N;
    const real *const d = in->v, *const d_u = d + nq, *const d_udot = d_u + N;
    const real *const d_p = d_udot + N + nr + 1 + 9, *const d_g = d_p + 3, *const q = in->q;
    const int status =
        cardan_superelement_slopes(n, on_node, drifts, inertial, constants, in, K, scratch);
    cardan_frame_motion at;
    real turned[3], spun[3];

    for (int i = 0; i < N; ++i) {
        out[i] = CARDAN_REAL(0.0);
        along[i] = d[on_node + i];
        rate[i] = d_u[i];
        second[i] = d_udot[i];
    }
    cardan_frame_motion_of(in, on_node, 1, &at);
    if (on_node) {
        /* a change of a quaternion as a rotation of the node */
        along[0] = (q[0] * d[1] - q[1] * d[0] + q[3] * d[2] - q[2] * d[3]) * 2.0;
        along[1] = (q[0] * d[2] - q[2] * d[0] + q[1] * d[3] - q[3] * d[1]) * 2.0;
        along[2] = (q[0] * d[3] - q[3] * d[0] + q[2] * d[1] - q[1] * d[2]) * 2.0;
        /* a place further out has the velocity w x e, the acceleration w' x e + w x (w x e) */
        cardan_3_cross(in->u, d_p, spun);
        cardan_3_times(at.node, 0, spun, 1, turned);
        for (int k = 0; k < 3; ++k) rate[3 + k] += turned[k];
        cardan_3_cross(in->u, spun, turned);
        cardan_3_add_cross(in->udot, d_p, turned);
        cardan_3_times(at.node, 0, turned, 1, spun);
        for (int k = 0; k < 3; ++k) second[3 + k] += spun[k];
        /* and a longer lever */
        (void)cardan_superelement_balance(n, on_node, drifts, constants, in, force, scratch);
        cardan_3_times(at.node, 1, force + 3, 1, turned);
        cardan_3_add_cross(d_p, turned, out);
    }
    cardan_add_matrix(N, K, along, out);
    cardan_add_matrix(N, C, rate, out);
    cardan_add_matrix(N, M, second, out);
    if (inertial) return status;
    for (int i = 0; i < N; ++i) second[i] = CARDAN_REAL(0.0);
    if (on_node) {
        /* gravity pulls as an acceleration of the node pushes, but for what its velocity does */
        if (drifts) (void)cardan_superelement_tangent(n, 1, 0, constants, in, K, scratch);
        for (int k = 0; k < 3; ++k) second[3 + k] = -d_g[k];
        cardan_add_matrix(N, M, second, out);
    } else {
        cardan_3_times(at.R0, 1, d_g, 1, turned);
        for (int k = 0; k < 3; ++k) turned[k] = -turned[k];
        cardan_add_product(3, n, c.momentum, turned, out);
    }
    return status;
}

CARDAN_INLINE int cardan_superelement_dynamics_change(int n, int on_node, int drifts, int nr,
                                                      const double *constants, const cardan_in *in,
                                                      real *CARDAN_RESTRICT out,
                                                      real *CARDAN_RESTRICT work)
{
    return cardan_superelement_forces_change(n, on_node, drifts, nr, 0, constants, in, out, work);
}

CARDAN_INLINE int cardan_superelement_impulse_change(int n, int on_node, int drifts, int nr,
                                                      const double *constants, const cardan_in *in,
                                                      real *CARDAN_RESTRICT out,
                                                      real *CARDAN_RESTRICT work)
{
    const int N = n + 6 * on_node;
    wreal w[15];
    const cardan_in there = cardan_without_speeds(N, in, work, w);

    return cardan_superelement_forces_change(n, on_node, drifts, nr, 1, constants, &there, out,
                                             work + N);
}

/* Slopes times a direction, where there are this many by states, inputs and time: those by the rotation
 * of the frame left out. */
CARDAN_INLINE real cardan_superelement_along(int states, const real *slopes, const real *direction)
{
    real sum = CARDAN_REAL(0.0);

    for (int i = 0; i < states + 15; ++i)
        if (i < states || i >= states + 9) sum += slopes[i] * direction[i];
    return sum;
}

/* Of the kinetic and the potential energy along a direction. */
CARDAN_INLINE int cardan_superelement_energy_change(int n, int on_node, int drifts, int nr,
                                                    const double *constants, const cardan_in *in,
                                                    real *CARDAN_RESTRICT out,
                                                    real *CARDAN_RESTRICT work)
{
    const int states = n + 7 * on_node + 2 * (n + 6 * on_node) + nr + 1;
    real weights[2];
    cardan_in there = *in;

    there.v = weights;
    for (int k = 0; k < 2; ++k) {
        weights[k] = CARDAN_REAL(1.0);
        weights[1 - k] = CARDAN_REAL(0.0);
        (void)cardan_superelement_energy_gradient(n, on_node, drifts, nr, constants, &there, work,
                                                  work + states + 15);
        out[k] = cardan_superelement_along(states, work, in->v);
    }
    return CARDAN_OK;
}

#endif
