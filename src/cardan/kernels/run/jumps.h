/* Times at which an exported model jumps.
 *
 * Part of cardan. A model with comparisons of t has a function time_jumps: each of its results
 * passes zero where one of them changes.
 */
#ifndef CARDAN_JUMPS_H
#define CARDAN_JUMPS_H

#include "export.h"

/* The most times there can be in a span, and numbers of work memory to find them. */
size_t cardan_jumps_capacity(const cardan_export *model);
size_t cardan_jumps_work_length(const cardan_export *model);
/* The times after the start and before the end of a span, in its direction. Returns a status. */
int cardan_time_jumps(const cardan_export *model, const void *prepared, real start, real end,
                      real *jumps, ptrdiff_t *count, real *work);

#endif
