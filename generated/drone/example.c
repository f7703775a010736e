/* Try it:  cc -std=c99 -O2 -fno-math-errno -ffp-contract=on -DCARDAN_EXAMPLE -o example *.c -lm && ./example */
#include "functions.h"
#include <stdio.h>

/* so that *.c of this folder links with a main of yours */
#ifdef CARDAN_EXAMPLE

int main(void)
{
    static real zero[6], out[forward_dynamics_out_size + 1];
    static real work[forward_dynamics_work_size + 1], w[forward_dynamics_w_size + 1];
    const cardan_in in = {.q = cardan_default_q, .r = cardan_default_r, .tau = zero, .w = w};

    prepare_forward_dynamics(cardan_default_p, w);
    int status = forward_dynamics(&in, out, work);
    for (int k = 0; k < forward_dynamics_out_size; k++)
        printf("forward_dynamics[%d] = %.17g\n", k, out[k]);
    return status;
}

#endif
