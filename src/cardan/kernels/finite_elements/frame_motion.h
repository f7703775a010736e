/*
 * frame_motion.h: small vectors and matrices, and the motion of a frame that is fixed to a node.
 *
 * Generated files include it where states may stand side by side: `real` is one number or several.
 */
#ifndef CARDAN_FRAME_MOTION_H
#define CARDAN_FRAME_MOTION_H

#include "cardan.h"

/* Small vectors and matrices (3, 3), row by row. */

CARDAN_INLINE void cardan_3_cross(const real *a, const real *b, real *out)
{
    const real x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2];

    out[2] = a[0] * b[1] - a[1] * b[0];
    out[0] = x;
    out[1] = y;
}

/* out += a x b */
CARDAN_INLINE void cardan_3_add_cross(const real *a, const real *b, real *out)
{
    real c[3];

    cardan_3_cross(a, b, c);
    for (int k = 0; k < 3; ++k) out[k] += c[k];
}

CARDAN_INLINE void cardan_3_skew(const real *a, double scale, real *out)
{
    const real zero = CARDAN_REAL(0.0);

    out[0] = out[4] = out[8] = zero;
    out[1] = a[2] * -scale;
    out[2] = a[1] * scale;
    out[3] = a[2] * scale;
    out[5] = a[0] * -scale;
    out[6] = a[1] * -scale;
    out[7] = a[0] * scale;
}

/* out (3, columns) = A B, or A^T B */
CARDAN_INLINE void cardan_3_times(const real *A, int turned, const real *B, int columns, real *out)
{
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < columns; ++j) {
            real sum = CARDAN_REAL(0.0);

            for (int k = 0; k < 3; ++k)
                sum += (turned ? A[3 * k + i] : A[3 * i + k]) * B[k * columns + j];
            out[i * columns + j] = sum;
        }
}

/* Where the frame is, and how it moves: all in its axes but R0, x0 and x0'. */
typedef struct cardan_frame_motion {
    real node[9], local[9], R0[9];   /* node to ground, frame to node, frame to ground */
    real p[3], g[3], x0[3], x0_rate[3];
    real w[3], w_rate[3], alpha[3];  /* alpha: acceleration of the origin beyond g */
    real v[3], v_rate[3];            /* v' is seen in the frame */
    real pull[3];                    /* x'' of the node without g, in its axes */
} cardan_frame_motion;

/* on_node: 1 by a node, 0 fixed to the ground. udot is read where `moving` is 2, u where it is 1. */
CARDAN_INLINE void cardan_frame_motion_of(const cardan_in *in, int on_node, int moving,
                                          cardan_frame_motion *at)
{
    real arm[3], arm_rate[3], back[3];

    for (int k = 0; k < 9; ++k) at->local[k] = CARDAN_REAL(in->w[k]);
    for (int k = 0; k < 3; ++k) {
        at->p[k] = CARDAN_REAL(in->w[9 + k]);
        at->g[k] = CARDAN_REAL(in->w[12 + k]);
        at->w[k] = at->w_rate[k] = at->x0_rate[k] = CARDAN_REAL(0.0);
        at->v[k] = at->v_rate[k] = CARDAN_REAL(0.0);
        at->x0[k] = at->p[k];
        back[k] = -at->g[k];
    }
    if (!on_node) {
        for (int k = 0; k < 9; ++k) {
            at->node[k] = CARDAN_REAL(k % 4 == 0 ? 1.0 : 0.0);
            at->R0[k] = at->local[k];
        }
        cardan_3_times(at->R0, 1, back, 1, at->alpha);
        return;
    }
    /* axes and origin */
    const real a = in->q[0], b = in->q[1], c = in->q[2], d = in->q[3];

    at->node[0] = 1.0 - 2.0 * (c * c + d * d);
    at->node[1] = 2.0 * (b * c - a * d);
    at->node[2] = 2.0 * (b * d + a * c);
    at->node[3] = 2.0 * (b * c + a * d);
    at->node[4] = 1.0 - 2.0 * (b * b + d * d);
    at->node[5] = 2.0 * (c * d - a * b);
    at->node[6] = 2.0 * (b * d - a * c);
    at->node[7] = 2.0 * (c * d + a * b);
    at->node[8] = 1.0 - 2.0 * (b * b + c * c);
    cardan_3_times(at->node, 0, at->local, 3, at->R0);
    cardan_3_times(at->node, 0, at->p, 1, arm);
    for (int k = 0; k < 3; ++k) at->x0[k] = in->q[4 + k] + arm[k];
    if (moving == 0) return;
    /* velocities */
    cardan_3_cross(in->u, at->p, arm_rate);
    cardan_3_times(at->node, 0, arm_rate, 1, arm);
    for (int k = 0; k < 3; ++k) at->x0_rate[k] = in->u[3 + k] + arm[k];
    cardan_3_times(at->local, 1, in->u, 1, at->w);
    cardan_3_times(at->R0, 1, at->x0_rate, 1, at->v);
    if (moving == 1) return;
    /* accelerations: R^T (x'' - g + w' x p + w x (w x p)) in axes of the node */
    for (int k = 0; k < 3; ++k) back[k] += in->udot[3 + k];
    cardan_3_times(at->node, 1, back, 1, at->pull);
    for (int k = 0; k < 3; ++k) back[k] = at->pull[k];
    cardan_3_add_cross(in->udot, at->p, back);
    cardan_3_add_cross(in->u, arm_rate, back);
    cardan_3_times(at->local, 1, back, 1, at->alpha);
    cardan_3_times(at->local, 1, in->udot, 1, at->w_rate);
    /* v' = alpha + R0^T g - w x v */
    cardan_3_times(at->R0, 1, at->g, 1, at->v_rate);
    cardan_3_cross(at->v, at->w, arm);
    for (int k = 0; k < 3; ++k) at->v_rate[k] += at->alpha[k] + arm[k];
}

#endif
