/*
 * model.c: values of model 'own_equations' to start from.
 */
#include "functions.h"

/* generalized coordinates */
const double cardan_default_q[cardan_nq + (cardan_nq == 0)] = {
    0.0, /* x */
    0.0, /* q1 */
    0.0, /* q2 */
};

/* inputs */
const double cardan_default_r[cardan_nr + (cardan_nr == 0)] = {
    0.0, /* F */
};

/* parameters */
const double cardan_default_p[cardan_np + (cardan_np == 0)] = {
    9.81, /* g */
    0.8, /* l */
    0.5, /* m */
    2.0, /* m_cart */
};
