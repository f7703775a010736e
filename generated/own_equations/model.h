/*
 * model.h: places of the entries of model 'own_equations'.
 *
 * Such as q[q_<coordinate>] or p[p_<parameter>]; units behind the names.
 */
#ifndef CARDAN_MODEL_H
#define CARDAN_MODEL_H

#include "cardan.h"

/* sizes */
enum {
    cardan_nq = 3,
    cardan_nu = 3,
    cardan_nr = 1,
    cardan_np = 4,
    cardan_nz = 0,
    cardan_ns = 0,
    cardan_nbodies = 1,
    cardan_nparts = 0
};

/* generalized coordinates */
enum {
    q_x = 0, /* x */
    q_q1 = 1, /* q1 */
    q_q2 = 2 /* q2 */
};

/* generalized speeds */
enum {
    u_v = 0, /* v */
    u_u1 = 1, /* u1 */
    u_u2 = 2 /* u2 */
};

/* inputs */
enum {
    r_F = 0 /* F */
};

/* parameters */
enum {
    p_g = 0, /* g */
    p_l = 1, /* l */
    p_m = 2, /* m */
    p_m_cart = 3 /* m_cart */
};

#endif
