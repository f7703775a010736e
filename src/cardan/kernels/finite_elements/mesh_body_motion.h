/* The motion of the body that carries a frame, and its derivatives: see mesh_frame_products.c.
 *
 * Part of cardan. Caller owns all memory.
 */
#ifndef CARDAN_MESH_BODY_MOTION_H
#define CARDAN_MESH_BODY_MOTION_H

#include "frame_motion.h"
#include "mesh_pull.h"

/* where the rotation, the position, angular velocity, velocity and their rates begin in a motion */
enum { BODY_R = 0, BODY_P = 9, BODY_W = 12, BODY_V = 15, BODY_W_RATE = 18, BODY_V_RATE = 21 };
/* numbers of a pose as a matrix, and of a velocity */
enum { CARDAN_TRANSFORM = 16, CARDAN_TWIST = 6 };

/* The motion of a body, where the frame is from its origin, and of a node what it follows from. */
typedef struct cardan_body_motion {
    real of[CARDAN_MOTION], arm[3];
    real pose[7], speeds[6], rates[6];
} cardan_body_motion;

/* matrix (3, 3) += a b^T */
static inline void cardan_add_outer(const real *a, const real *b, real *matrix)
{
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            matrix[3 * i + j] += a[i] * b[j];
}

/* Unit quaternion of a node of a plane at an angle, or its slope by the angle. */
void cardan_planar_quaternion(const cardan_frame *frame, real angle, int slope, real *q);
/* The pose of a node in space, or its change along d. */
void cardan_node_pose(const cardan_frame *frame, const real *q, const real *d, real *out);
/* Speeds of a node in space (6), zeros without any. */
void cardan_node_speeds(const cardan_frame *frame, const real *u, real *out);
/* Rotation matrix (9) of a quaternion a = b, times a scale; else what is linear in both. */
void cardan_rotation_of(const real *a, const real *b, real scale, real *out);
/* Derivatives (4) by a quaternion, of derivatives by the rotation matrix that it makes with another one. */
void cardan_by_quaternion(const real *other, const real *by_R, real *by);
/* mesh_frame_products.c: weights of the motion of the body and of the frame's place on it (12), of results
 * with weights v. */
void cardan_frame_weights(ptrdiff_t function, const real *local, const cardan_body_motion *body,
                          const real *v, real *by_body, real *by_local);

/* The motion of what carries the frame, at the state. */
int cardan_mesh_body_motion(cardan_place *here, cardan_body_motion *body);
/* Its change (CARDAN_MOTION) along the direction. */
int cardan_mesh_push_body(cardan_place *here, const cardan_body_motion *body, real *change);
/* Add derivatives by all that it reads, of a sum with weights `by_body` (CARDAN_MOTION), which are spoiled. */
int cardan_mesh_pull_body(cardan_place *here, const cardan_body_motion *body, real *by_body);

#endif
