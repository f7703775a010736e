/* Second derivatives of the functions of a frame: see mesh_frame_products.c, mesh_hessian.c.
 *
 * Part of cardan. Caller owns all memory.
 *
 * A function of the frame is one of the motion m of its body and of its place e, L on that. Its gradient by
 * these changes as they do; m has second derivatives by the coordinates that tell it, with weights that
 * this gradient is.
 */
#include "mesh_body_motion.h"
#include <string.h>

/* out (3) += A^T b */
static void add_back(const real *A, const real *b, real *out)
{
    real more[3];

    cardan_3_times(A, 1, b, 1, more);
    for (int i = 0; i < 3; i++)
        out[i] += more[i];
}

/* Change of the gradient of a pose with weights v: R L, p + R e. */
static void pose_weights_along(const real *v, const real *d, const real *d_local, real *by_body,
                               real *by_local)
{
    real axes[9], y[3];

    for (int i = 0; i < 3; i++) {
        y[i] = v[4 * i + 3];
        for (int j = 0; j < 3; j++) {
            axes[3 * i + j] = v[4 * i + j];
            by_body[BODY_R + 3 * i + j] = cardan_dot(v + 4 * i, d_local + 3 * j, 3);
        }
    }
    cardan_3_times(d + BODY_R, 1, axes, 3, by_local);
    cardan_add_outer(y, d_local + 9, by_body + BODY_R);
    add_back(d + BODY_R, y, by_local + 9);
}

/* Change of the gradient of a function of the frame with weights v, where the motion of its body changes
 * by d and its place by d_local: by the motion and by the place (12). */
static void frame_weights_along(ptrdiff_t function, const cardan_frame *frame,
                                const cardan_body_motion *body, const real *v, const real *d,
                                const real *d_local, real *by_body, real *by_local)
{
    const real *m = body->of, *arm = body->arm, *y = v + 3, *w = m + BODY_W, *d_w = d + BODY_W;
    const ptrdiff_t start = function == CARDAN_OF_ACCELERATION ? BODY_W_RATE : BODY_W;
    real d_arm[3], by_arm[3] = {0}, d_by_arm[3] = {0}, across[3], d_across[3];

    memset(by_body, 0, CARDAN_MOTION * sizeof(real));
    memset(by_local, 0, 12 * sizeof(real));
    if (function == CARDAN_OF_POSE) {
        pose_weights_along(v, d, d_local, by_body, by_local);
        return;
    }
    cardan_3_times(d + BODY_R, 0, frame->local + 9, 1, d_arm);
    cardan_3_times(m + BODY_R, 0, d_local + 9, 1, across);
    for (int i = 0; i < 3; i++)
        d_arm[i] += across[i];
    /* y.(w x a), of the angular velocity or its rate */
    cardan_3_add_cross(d_arm, y, by_body + start);
    cardan_3_add_cross(y, m + start, by_arm);
    cardan_3_add_cross(y, d + start, d_by_arm);
    if (function == CARDAN_OF_ACCELERATION) {
        /* y.(w x (w x a)) = (y x w).(w x a) */
        cardan_3_cross(y, w, across);
        cardan_3_cross(y, d_w, d_across);
        cardan_3_add_cross(across, w, by_arm);
        cardan_3_add_cross(d_across, w, d_by_arm);
        cardan_3_add_cross(across, d_w, d_by_arm);
        cardan_3_add_cross(d_arm, across, by_body + BODY_W);
        cardan_3_add_cross(arm, d_across, by_body + BODY_W);
        cardan_3_cross(d_w, arm, across);
        cardan_3_add_cross(w, d_arm, across);
        cardan_3_add_cross(across, y, by_body + BODY_W);
    }
    /* the arm is R e */
    cardan_add_outer(d_by_arm, frame->local + 9, by_body + BODY_R);
    cardan_add_outer(by_arm, d_local + 9, by_body + BODY_R);
    add_back(d + BODY_R, by_arm, by_local + 9);
    add_back(m + BODY_R, d_by_arm, by_local + 9);
}

/* Add the change of m.by_body, these weights fixed, by the coordinates and speeds of a node. */
static void node_along(cardan_place *here, const cardan_body_motion *body, const real *by_body)
{
    const cardan_frame *frame = here->product->frame;
    const cardan_slopes *way = &here->way;
    cardan_slopes *by = &here->by;
    real pose[7], speeds[6], rates[6], turn[9], by_R[9], d_by_R[9] = {0}, by_pose[4], more[4];
    real by_speeds[3], by_rates[3], slope[4], bend[4];

    cardan_node_pose(frame, here->at.q + frame->q, way->q + frame->q, pose);
    cardan_node_speeds(frame, way->u + frame->u, speeds);
    cardan_node_speeds(frame, way->udot + frame->u, rates);
    cardan_rotation_of(body->pose, pose, 2, turn);
    /* angular velocity and its rate are R times those in axes of the node */
    cardan_3_times(turn, 1, by_body + BODY_W, 1, by_speeds);
    cardan_3_times(turn, 1, by_body + BODY_W_RATE, 1, by_rates);
    memcpy(by_R, by_body + BODY_R, sizeof by_R);
    cardan_add_outer(by_body + BODY_W, body->speeds, by_R);
    cardan_add_outer(by_body + BODY_W_RATE, body->rates, by_R);
    cardan_add_outer(by_body + BODY_W, speeds, d_by_R);
    cardan_add_outer(by_body + BODY_W_RATE, rates, d_by_R);
    cardan_by_quaternion(pose, by_R, by_pose);
    cardan_by_quaternion(body->pose, d_by_R, more);
    for (int i = 0; i < 4; i++)
        by_pose[i] += more[i];
    if (!frame->to_space) {
        for (int i = 0; i < 4; i++)
            by->q[frame->q + i] += by_pose[i];
        for (int i = 0; i < 3; i++) {
            by->u[frame->u + i] += by_speeds[i];
            by->udot[frame->u + i] += by_rates[i];
        }
        return;
    }
    /* the quaternion of a node of a plane by its angle, whose second derivative is -1/4 of it */
    cardan_planar_quaternion(frame, here->at.q[frame->q + 2], 1, slope);
    cardan_by_quaternion(body->pose, by_R, more);
    for (int i = 0; i < 4; i++)
        bend[i] = -0.25 * body->pose[i];
    by->q[frame->q + 2] +=
        cardan_dot(slope, by_pose, 4) + cardan_dot(bend, more, 4) * way->q[frame->q + 2];
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++) {
            by->u[frame->u + k] += frame->to_space[3 * i + k] * by_speeds[i];
            by->udot[frame->u + k] += frame->to_space[3 * i + k] * by_rates[i];
        }
}

/* Add the change of the motion with weights by_body, which stay. */
static int body_along(cardan_place *along, const cardan_body_motion *body, const real *by_body)
{
    const cardan_mesh_product *curvature = along->product;

    if (curvature->frame->q >= 0) {
        node_along(along, body, by_body);
        return 0;
    }
    if (!curvature->direct)
        return 0;
    memcpy(along->sums, by_body, CARDAN_MOTION * sizeof(real));
    along->sums[CARDAN_MOTION] = 0;
    return cardan_mesh_pull_elements(along, curvature->direct, CARDAN_FORMS, along->sums, 1);
}

/* Add the change of the gradient of a function of the frame with weights v. */
static int function_along(const cardan_place *here, cardan_place *change, cardan_place *along,
                          ptrdiff_t function, const real *v)
{
    const cardan_frame *frame = here->product->frame;
    const cardan_element_lanes one = {1, 1, {0}};
    const ptrdiff_t element = 0;
    cardan_place gradient = *here;
    cardan_body_motion body;
    real by_body[CARDAN_MOTION], d_by_body[CARDAN_MOTION], by_local[12], d_by_local[12];
    real d[CARDAN_MOTION], d_local[12] = {0};
    int status = cardan_mesh_body_motion(&gradient, &body);

    if (status == 0)
        status = cardan_mesh_push_body(change, &body, d);
    if (status != 0)
        return status;
    if (frame->data)
        (void)cardan_mesh_data_change(frame->data, along->way.p, &element, 1, d_local);
    cardan_frame_weights(function, frame->local, &body, v, by_body, by_local);
    frame_weights_along(function, frame, &body, v, d, d_local, d_by_body, d_by_local);
    if (frame->data) {
        cardan_mesh_add_data(frame->data, &one, d_by_local, along->by.p, NULL);
        cardan_mesh_add_second(frame->data, by_local, along->way.p, along->by.p);
    }
    status = body_along(along, &body, by_body);
    /* what the gradient by the motion changes by */
    gradient.by = along->by;
    gradient.by_data = NULL;
    gradient.sums = along->sums;
    return status != 0 ? status : cardan_mesh_pull_body(&gradient, &body, d_by_body);
}

/* The same of a Jacobian, whose columns are velocities at unit speeds less that at rest. */
static int jacobian_along(cardan_place here, cardan_place change, cardan_place along, const real *v)
{
    const cardan_frame *frame = here.product->frame;
    const ptrdiff_t nu = here.mesh->nu;
    real weights[CARDAN_TWIST], back[CARDAN_TWIST] = {0};
    int status = 0;

    memset(here.probe, 0, (size_t)nu * sizeof(real));
    here.at.u = change.at.u = along.at.u = here.probe;
    for (ptrdiff_t n = 0; n < frame->speeds && status == 0; n++) {
        const ptrdiff_t j = frame->speed[n];
        for (int i = 0; i < CARDAN_TWIST; i++) {
            weights[i] = v[i * nu + j];
            back[i] -= weights[i];
        }
        here.probe[j] = 1;
        status = function_along(&here, &change, &along, CARDAN_OF_VELOCITY, weights);
        here.probe[j] = 0;
    }
    return status != 0 ? status : function_along(&here, &change, &along, CARDAN_OF_VELOCITY, back);
}

int cardan_mesh_pull_frame_along(const cardan_place *here, cardan_place *change, cardan_place *along,
                                 const real *v)
{
    const ptrdiff_t function = here->product->function;

    return function == CARDAN_OF_FRAME_JACOBIAN ? jacobian_along(*here, *change, *along, v)
                                                : function_along(here, change, along, function, v);
}
