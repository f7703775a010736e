/* Matrices of a step of the Radau IIA method that turn along with the nodes.
 *
 * Part of cardan. Caller owns all memory.
 *
 * Velocities of nodes have the axes of the ground. There the stiff directions of a beam turn with it,
 * and one matrix cannot serve stages at which they differ: an angle theta of a stiffness k counts as
 * k theta^2 across. With Q_i, the rotation of every node from the start of the step to a stage, the
 * matrices of the stage are Q_i A Q_iᵀ as far as they turn along with the nodes. So residuals are
 * taken back by Q_iᵀ before the matrices of the start take them, and updates forward by Q_i.
 * Angular velocities have the axes of their nodes already.
 */
#include "radau_elements.h"
#include <math.h>

/* The rotation matrix of q conj(p), quaternions of length 1. */
static void rotation_matrix(const real *p, const real *q, real *R)
{
    const real w = q[0] * p[0] + q[1] * p[1] + q[2] * p[2] + q[3] * p[3];
    const real x = -q[0] * p[1] + q[1] * p[0] - q[2] * p[3] + q[3] * p[2];
    const real y = -q[0] * p[2] + q[1] * p[3] + q[2] * p[0] - q[3] * p[1];
    const real z = -q[0] * p[3] - q[1] * p[2] + q[2] * p[1] + q[3] * p[0];

    R[0] = 1 - 2 * (y * y + z * z), R[1] = 2 * (x * y - w * z), R[2] = 2 * (x * z + w * y);
    R[3] = 2 * (x * y + w * z), R[4] = 1 - 2 * (x * x + z * z), R[5] = 2 * (y * z - w * x);
    R[6] = 2 * (x * z - w * y), R[7] = 2 * (y * z + w * x), R[8] = 1 - 2 * (x * x + y * y);
}

/* The rotations of all nodes of a stage. */
void cardan_radau_turns(const cardan_run *run, const cardan_radau_stages *v, int stage)
{
    const cardan_mesh *mesh = v->mesh;
    const real *q0 = run->y, *q = v->states + stage * run->nx;
    real *turns = v->turns + 9 * stage * mesh->places;

    for (ptrdiff_t k = 0; k < mesh->nodes; k++) {
        const ptrdiff_t place = mesh->node[k];
        rotation_matrix(q0 + mesh->q[place], q + mesh->q[place], turns + 9 * place);
    }
    for (ptrdiff_t k = 0; k < mesh->flats; k++) {
        const ptrdiff_t place = mesh->flat[k];
        const real angle = q[mesh->q[place] + 2] - q0[mesh->q[place] + 2];
        turns[9 * place] = cos(angle);
        turns[9 * place + 1] = sin(angle);
    }
}

/* Velocities x (nu) of all nodes turned, forward or, with sign -1, backward. */
static void turn(const cardan_radau_stages *v, int stage, real sign, real *x)
{
    const cardan_mesh *mesh = v->mesh;
    const real *turns = v->turns + 9 * stage * mesh->places;

    for (ptrdiff_t k = 0; k < mesh->nodes; k++) {
        const real *R = turns + 9 * mesh->node[k];
        real *a = x + mesh->u[mesh->node[k]] + 3;
        const real b[3] = {a[0], a[1], a[2]};
        for (int i = 0; i < 3; i++)
            a[i] = sign > 0 ? R[3 * i] * b[0] + R[3 * i + 1] * b[1] + R[3 * i + 2] * b[2]
                            : R[i] * b[0] + R[3 + i] * b[1] + R[6 + i] * b[2];
    }
    for (ptrdiff_t k = 0; k < mesh->flats; k++) {
        const real c = turns[9 * mesh->flat[k]], s = sign * turns[9 * mesh->flat[k] + 1];
        real *a = x + mesh->u[mesh->flat[k]];
        const real b[2] = {a[0], a[1]};
        a[0] = c * b[0] - s * b[1];
        a[1] = s * b[0] + c * b[1];
    }
}

void cardan_radau_forward(const cardan_radau_stages *v, int stage, real *x)
{
    turn(v, stage, 1, x);
}

void cardan_radau_backward(const cardan_radau_stages *v, int stage, real *x)
{
    turn(v, stage, -1, x);
}
