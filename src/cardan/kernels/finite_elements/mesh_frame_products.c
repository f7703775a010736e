/* Products with derivatives of the functions of a frame: see mesh_pull.h.
 *
 * Part of cardan. Caller owns all memory.
 *
 * A frame with the axes L and the origin e on a body that moves by R, p, velocity (w, v) and
 * acceleration (w', v'), all in ground axes, has with the arm a = R e
 *
 *     the pose R L, p + a, the velocity w, v + w x a,
 *     the acceleration w', v' + w' x a + w x (w x a).
 */
#include "mesh_body_motion.h"
#include <string.h>

/* out += a x (b x c) */
static void add_twice(const real *a, const real *b, const real *c, real *out)
{
    real across[3];

    cardan_3_cross(b, c, across);
    cardan_3_add_cross(a, across, out);
}

/* Change of a function of the frame, of its body's motion m by d and of its place on that. */
static void frame_change(ptrdiff_t function, const real *local, const cardan_body_motion *body, const real *d,
                         const real *d_local, real *out)
{
    const real *m = body->of, *arm = body->arm;
    const ptrdiff_t start = function == CARDAN_OF_ACCELERATION ? BODY_W_RATE : BODY_W;
    real change[3], more[9], axes[9];

    /* of the arm */
    cardan_3_times(d + BODY_R, 0, local + 9, 1, change);
    cardan_3_times(m + BODY_R, 0, d_local + 9, 1, more);
    for (int i = 0; i < 3; i++)
        change[i] += more[i];
    if (function == CARDAN_OF_POSE) {
        /* R L and p + a */
        cardan_3_times(d + BODY_R, 0, local, 3, axes);
        cardan_3_times(m + BODY_R, 0, d_local, 3, more);
        memset(out, 0, CARDAN_TRANSFORM * sizeof(real));
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++)
                out[4 * i + j] = axes[3 * i + j] + more[3 * i + j];
            out[4 * i + 3] = d[BODY_P + i] + change[i];
        }
        return;
    }
    /* w and v + w x a, or their rates */
    memcpy(out, d + start, CARDAN_TWIST * sizeof(real));
    cardan_3_add_cross(d + start, arm, out + 3);
    cardan_3_add_cross(m + start, change, out + 3);
    if (function != CARDAN_OF_ACCELERATION)
        return;
    /* what points to the center */
    add_twice(d + BODY_W, m + BODY_W, arm, out + 3);
    add_twice(m + BODY_W, d + BODY_W, arm, out + 3);
    add_twice(m + BODY_W, m + BODY_W, change, out + 3);
}

void cardan_frame_weights(ptrdiff_t function, const real *local, const cardan_body_motion *body,
                          const real *v, real *by_body, real *by_local)
{
    const real *m = body->of, *arm = body->arm, *y = v + 3;
    const ptrdiff_t start = function == CARDAN_OF_ACCELERATION ? BODY_W_RATE : BODY_W;
    real by_arm[3] = {0}, across[3], axes[9];

    memset(by_body, 0, CARDAN_MOTION * sizeof(real));
    memset(by_local, 0, 12 * sizeof(real));
    if (function == CARDAN_OF_POSE) {
        for (int i = 0; i < 3; i++) {
            by_arm[i] = by_body[BODY_P + i] = v[4 * i + 3];
            for (int j = 0; j < 3; j++) {
                axes[3 * i + j] = v[4 * i + j];
                by_body[BODY_R + 3 * i + j] = cardan_dot(v + 4 * i, local + 3 * j, 3);
            }
        }
        cardan_3_times(m + BODY_R, 1, axes, 3, by_local);
    } else {
        memcpy(by_body + start, v, CARDAN_TWIST * sizeof(real));
        cardan_3_add_cross(arm, y, by_body + start);
        cardan_3_add_cross(y, m + start, by_arm);
    }
    if (function == CARDAN_OF_ACCELERATION) {
        /* y.(w x (w x a)) by w and by a */
        cardan_3_cross(y, m + BODY_W, across);
        cardan_3_add_cross(across, m + BODY_W, by_arm);
        cardan_3_add_cross(arm, across, by_body + BODY_W);
        cardan_3_cross(m + BODY_W, arm, across);
        cardan_3_add_cross(across, y, by_body + BODY_W);
    }
    cardan_add_outer(by_arm, local + 9, by_body + BODY_R);
    cardan_3_times(m + BODY_R, 1, by_arm, 1, by_local + 9);
}

/* Add derivatives of a function of the frame with weights v, at the state. */
static int pull_function(cardan_place *here, ptrdiff_t function, const real *v)
{
    const cardan_frame *frame = here->product->frame;
    const cardan_element_lanes one = {1, 1, {0}};
    real by_body[CARDAN_MOTION], by_local[12];
    cardan_body_motion body;
    int status = cardan_mesh_body_motion(here, &body);

    cardan_frame_weights(function, frame->local, &body, v, by_body, by_local);
    if (frame->data)
        cardan_mesh_add_data(frame->data, &one, by_local, here->by.p, NULL);
    return status != 0 ? status : cardan_mesh_pull_body(here, &body, by_body);
}

/* Change of a function of the frame along the direction, at the state. */
static int push_function(cardan_place *here, ptrdiff_t function, real *out)
{
    const cardan_frame *frame = here->product->frame;
    const ptrdiff_t element = 0;
    real change[CARDAN_MOTION], d_local[12] = {0};
    cardan_body_motion body;
    int status = cardan_mesh_body_motion(here, &body);

    if (status == 0)
        status = cardan_mesh_push_body(here, &body, change);
    if (frame->data)
        (void)cardan_mesh_data_change(frame->data, here->way.p, &element, 1, d_local);
    frame_change(function, frame->local, &body, change, d_local, out);
    return status;
}

/* Without speeds, of which one at a time becomes 1: the velocity is J u, and what is prescribed. */
static void clear_probe(cardan_place *here)
{
    memset(here->probe, 0, (size_t)here->mesh->nu * sizeof(real));
    here->at.u = here->probe;
}

static int pull_jacobian(cardan_place *here, const real *v)
{
    const cardan_frame *frame = here->product->frame;
    const ptrdiff_t nu = here->mesh->nu;
    real weights[CARDAN_TWIST], back[CARDAN_TWIST] = {0};
    int status = 0;

    /* J e_k is the velocity at e_k less that at rest */
    clear_probe(here);
    for (ptrdiff_t n = 0; n < frame->speeds && status == 0; n++) {
        const ptrdiff_t j = frame->speed[n];
        for (int i = 0; i < CARDAN_TWIST; i++) {
            weights[i] = v[i * nu + j];
            back[i] -= weights[i];
        }
        here->probe[j] = 1;
        status = pull_function(here, CARDAN_OF_VELOCITY, weights);
        here->probe[j] = 0;
    }
    return status != 0 ? status : pull_function(here, CARDAN_OF_VELOCITY, back);
}

static int push_jacobian(cardan_place *here, real *out)
{
    const cardan_frame *frame = here->product->frame;
    const ptrdiff_t nu = here->mesh->nu;
    real still[CARDAN_TWIST], column[CARDAN_TWIST];
    int status;

    clear_probe(here);
    /* columns of speeds that do not move the frame are 0 */
    memset(out, 0, (size_t)(CARDAN_TWIST * nu) * sizeof(real));
    status = push_function(here, CARDAN_OF_VELOCITY, still);
    for (ptrdiff_t n = 0; n < frame->speeds && status == 0; n++) {
        const ptrdiff_t j = frame->speed[n];
        here->probe[j] = 1;
        status = push_function(here, CARDAN_OF_VELOCITY, column);
        here->probe[j] = 0;
        for (int i = 0; i < CARDAN_TWIST; i++)
            out[i * nu + j] = column[i] - still[i];
    }
    return status;
}

int cardan_mesh_pull_frame(cardan_place *here, const real *v)
{
    const ptrdiff_t function = here->product->function;

    return function == CARDAN_OF_FRAME_JACOBIAN ? pull_jacobian(here, v)
                                                : pull_function(here, function, v);
}

int cardan_mesh_push_frame(cardan_place *here, real *out)
{
    const ptrdiff_t function = here->product->function;

    return function == CARDAN_OF_FRAME_JACOBIAN ? push_jacobian(here, out)
                                                : push_function(here, function, out);
}
