/* superelements.wasm: what generated functions of superelements call.
 *
 * Part of cardan.
 */
#include "superelement.h"
#include "superelement_momenta.h"
#include "superelement_tangent.h"

#define OF_SUPERELEMENTS(F) F(balance) F(tangent) F(energy) F(momentum) F(power) F(generalized_momenta)
#define DEFINE(name)                                                                               \
    __attribute__((export_name("cardan_superelement_" #name)))                                     \
    int exported_superelement_##name(int n, int on_node, int drifts, const double *constants,      \
                                     const cardan_in *in, real *out, real *work)                   \
    {                                                                                              \
        return cardan_superelement_##name(n, on_node, drifts, constants, in, out, work);           \
    }
OF_SUPERELEMENTS(DEFINE)
