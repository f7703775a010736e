/* The motion of the body that carries a frame, and its derivatives: see mesh_frame_products.c.
 *
 * Part of cardan. Caller owns all memory.
 *
 * A node tells it by its own coordinates, a rigid tree by those of its joints; the ground is at rest.
 */
#include "mesh_body_motion.h"
#include <math.h>
#include <string.h>

static void add_sums(const cardan_mesh *mesh, const cardan_group *g, const cardan_element_lanes *some,
                     real *out, void *to)
{
    const cardan_place *here = to;
    const cardan_summands *summands = here->product->summands + (g - mesh->groups);

    (void)cardan_mesh_add_picked(some, summands->which, summands->size, out, here->sums);
}

/* The motion of a body of a rigid tree. */
static int motion_of_tree(cardan_place *here, cardan_body_motion *body)
{
    const cardan_mesh *mesh = here->mesh;
    int status = 0;

    memset(here->sums, 0, (CARDAN_MOTION + 1) * sizeof(real));
    for (ptrdiff_t k = 0; k < mesh->group_count && status == 0; k++)
        if (here->product->direct[k].call)
            status = cardan_mesh_group(mesh, mesh->groups + k, mesh->groups[k].forms + CARDAN_BODIES,
                                       &here->at, add_sums, here, here->room);
    memcpy(body->of, here->sums, sizeof body->of);
    return status;
}

void cardan_planar_quaternion(const cardan_frame *frame, real angle, int slope, real *q)
{
    const real *h = frame->home;
    /* the axis of rotation: angular velocity at unit rate of the angle */
    const real n[3] = {frame->to_space[2], frame->to_space[5], frame->to_space[8]};
    const real c = slope ? -0.5 * sin(0.5 * angle) : cos(0.5 * angle);
    const real s = slope ? 0.5 * cos(0.5 * angle) : sin(0.5 * angle);
    real across[3];

    cardan_3_cross(h + 1, n, across);
    q[0] = c * h[0] - s * cardan_dot(n, h + 1, 3);
    for (int i = 0; i < 3; i++)
        q[1 + i] = c * h[1 + i] + s * (h[0] * n[i] + across[i]);
}

void cardan_node_pose(const cardan_frame *frame, const real *q, const real *d, real *out)
{
    const real *by = d ? d : q;

    if (!frame->to_space) {
        memcpy(out, by, 7 * sizeof(real));
        return;
    }
    cardan_planar_quaternion(frame, q[2], d != NULL, out);
    for (int i = 0; i < 4 && d; i++)
        out[i] *= d[2];
    for (int i = 0; i < 3; i++)
        out[4 + i] = cardan_dot(frame->to_space + 9 + 3 * i, by, 2);
}

void cardan_node_speeds(const cardan_frame *frame, const real *u, real *out)
{
    for (int i = 0; i < CARDAN_TWIST; i++)
        out[i] = !u ? 0 : frame->to_space ? cardan_dot(frame->to_space + 3 * i, u, 3) : u[i];
}

void cardan_rotation_of(const real *a, const real *b, real scale, real *out)
{
    const real ww = a[0] * b[0], xx = a[1] * b[1], yy = a[2] * b[2], zz = a[3] * b[3];
    const real wx = a[0] * b[1] + a[1] * b[0], wy = a[0] * b[2] + a[2] * b[0];
    const real wz = a[0] * b[3] + a[3] * b[0], xy = a[1] * b[2] + a[2] * b[1];
    const real xz = a[1] * b[3] + a[3] * b[1], yz = a[2] * b[3] + a[3] * b[2];
    const real rows[9] = {ww + xx - yy - zz, xy - wz, xz + wy, xy + wz, ww - xx + yy - zz,
                          yz - wx,           xz - wy, yz + wx, ww - xx - yy + zz};

    for (int i = 0; i < 9; i++)
        out[i] = scale * rows[i];
}

void cardan_by_quaternion(const real *other, const real *by_R, real *by)
{
    real unit[4], slope[9];

    for (int i = 0; i < 4; i++) {
        for (int k = 0; k < 4; k++)
            unit[k] = k == i;
        cardan_rotation_of(other, unit, 2, slope);
        by[i] = cardan_dot(slope, by_R, 9);
    }
}

/* Part of a block where numbers of a node begin; NULL where there are none. */
static const real *part(const real *block, ptrdiff_t start)
{
    return block ? block + start : NULL;
}

/* The motion of a body that has a node. */
static void motion_of_node(const cardan_place *here, const cardan_frame *frame, cardan_body_motion *body)
{
    real *m = body->of;

    /* pose and speeds of the node in space, then everything in axes of the ground */
    cardan_node_pose(frame, here->at.q + frame->q, NULL, body->pose);
    cardan_node_speeds(frame, part(here->at.u, frame->u), body->speeds);
    cardan_node_speeds(frame, part(here->at.udot, frame->u), body->rates);
    cardan_rotation_of(body->pose, body->pose, 1, m + BODY_R);
    memcpy(m + BODY_P, body->pose + 4, 3 * sizeof(real));
    cardan_3_times(m + BODY_R, 0, body->speeds, 1, m + BODY_W);
    memcpy(m + BODY_V, body->speeds + 3, 3 * sizeof(real));
    cardan_3_times(m + BODY_R, 0, body->rates, 1, m + BODY_W_RATE);
    memcpy(m + BODY_V_RATE, body->rates + 3, 3 * sizeof(real));
}

int cardan_mesh_body_motion(cardan_place *here, cardan_body_motion *body)
{
    const cardan_frame *frame = here->product->frame;
    int status = 0;

    memset(body, 0, sizeof *body);
    /* by a node, by a tree, or on the ground, which is at rest */
    if (frame->q >= 0)
        motion_of_node(here, frame, body);
    else if (here->product->direct)
        status = motion_of_tree(here, body);
    else
        body->of[0] = body->of[4] = body->of[8] = 1;
    cardan_3_times(body->of + BODY_R, 0, frame->local + 9, 1, body->arm);
    return status;
}

int cardan_mesh_push_body(cardan_place *here, const cardan_body_motion *body, real *change)
{
    const cardan_frame *frame = here->product->frame;
    const cardan_slopes *way = &here->way;
    real pose[7], speeds[6], rates[6], product[3];
    int status;

    memset(change, 0, CARDAN_MOTION * sizeof(real));
    if (frame->q < 0 && !here->product->direct)
        return 0;
    /* elements have changes of the motion of bodies of trees */
    if (frame->q < 0) {
        status = cardan_mesh_push_elements(here, here->product->direct, CARDAN_FORMS,
                                           CARDAN_MOTION + 1, here->sums);
        memcpy(change, here->sums, CARDAN_MOTION * sizeof(real));
        return status;
    }
    cardan_node_pose(frame, here->at.q + frame->q, way->q + frame->q, pose);
    cardan_node_speeds(frame, way->u + frame->u, speeds);
    cardan_node_speeds(frame, way->udot + frame->u, rates);
    cardan_rotation_of(body->pose, pose, 2, change + BODY_R);
    memcpy(change + BODY_P, pose + 4, 3 * sizeof(real));
    /* angular velocity and acceleration are in axes of the node */
    cardan_3_times(change + BODY_R, 0, body->speeds, 1, change + BODY_W);
    cardan_3_times(body->of + BODY_R, 0, speeds, 1, product);
    for (int i = 0; i < 3; i++)
        change[BODY_W + i] += product[i];
    cardan_3_times(change + BODY_R, 0, body->rates, 1, change + BODY_W_RATE);
    cardan_3_times(body->of + BODY_R, 0, rates, 1, product);
    for (int i = 0; i < 3; i++)
        change[BODY_W_RATE + i] += product[i];
    memcpy(change + BODY_V, speeds + 3, 3 * sizeof(real));
    memcpy(change + BODY_V_RATE, rates + 3, 3 * sizeof(real));
    return 0;
}

int cardan_mesh_pull_body(cardan_place *here, const cardan_body_motion *body, real *by_body)
{
    const cardan_frame *frame = here->product->frame;
    cardan_slopes *by = &here->by;
    const real *m = body->of;
    real speeds[6], rates[6], by_pose[4], slope[4];
    real *by_q, *by_u, *by_udot;

    if (frame->q < 0 && !here->product->direct)
        return 0;
    if (frame->q < 0) {
        memcpy(here->sums, by_body, CARDAN_MOTION * sizeof(real));
        here->sums[CARDAN_MOTION] = 0;
        return cardan_mesh_pull_elements(here, here->product->direct, CARDAN_FORMS, here->sums, 0);
    }
    by_q = by->q + frame->q;
    by_u = by->u + frame->u;
    by_udot = by->udot + frame->u;
    cardan_3_times(m + BODY_R, 1, by_body + BODY_W, 1, speeds);
    cardan_3_times(m + BODY_R, 1, by_body + BODY_W_RATE, 1, rates);
    memcpy(speeds + 3, by_body + BODY_V, 3 * sizeof(real));
    memcpy(rates + 3, by_body + BODY_V_RATE, 3 * sizeof(real));
    cardan_add_outer(by_body + BODY_W, body->speeds, by_body + BODY_R);
    cardan_add_outer(by_body + BODY_W_RATE, body->rates, by_body + BODY_R);
    /* by the quaternion, in whose entries the rotation is of second order */
    cardan_by_quaternion(body->pose, by_body + BODY_R, by_pose);
    /* a node in space has these coordinates and speeds itself */
    if (!frame->to_space) {
        for (int i = 0; i < 4; i++)
            by_q[i] += by_pose[i];
        for (int i = 0; i < 3; i++)
            by_q[4 + i] += by_body[BODY_P + i];
        for (int i = 0; i < CARDAN_TWIST; i++) {
            by_u[i] += speeds[i];
            by_udot[i] += rates[i];
        }
        return 0;
    }
    /* the same by x, y and angle */
    cardan_planar_quaternion(frame, here->at.q[frame->q + 2], 1, slope);
    by_q[2] += cardan_dot(slope, by_pose, 4);
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < CARDAN_TWIST; i++) {
            by_u[k] += frame->to_space[3 * i + k] * speeds[i];
            by_udot[k] += frame->to_space[3 * i + k] * rates[i];
            if (i >= 3 && k < 2)
                by_q[k] += frame->to_space[3 * i + k] * by_body[BODY_P + i - 3];
        }
    return 0;
}
