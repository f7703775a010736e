/* Functions of WebAssembly as functions of C.
 *
 * Part of cardan. Generated functions that wasmtime has compiled take addresses in a memory of their
 * own. What stands for one in C copies its blocks there, calls it, and copies the results back. C has
 * a function for each of a number of places, since one without data of its own cannot know more.
 */
#ifndef CARDAN_WASM_CALLS_H
#define CARDAN_WASM_CALLS_H

#include "cardan.h"
#include <stddef.h>

enum {
    CARDAN_WASM_PLACES = 512,
    CARDAN_WASM_BLOCKS = 17,
    CARDAN_TRAPPED = 1 << 17 /* status: the function was ended by wasmtime */
};

/* A value of WebAssembly, as wasmtime has it. */
typedef union cardan_wasm_value {
    int32_t i32;
    uint64_t wide[2];
} cardan_wasm_value;

/* wasmtime_func_call_unchecked, wasmtime_error_delete and wasm_trap_delete */
typedef void *cardan_wasm_call(void *store, const void *function, cardan_wasm_value *values, size_t count,
                               void **trap);
typedef void cardan_wasm_delete(void *thing);

/* A generated function and its `prepare_`. Addresses are those of its memory. */
typedef struct cardan_wasm_function {
    cardan_wasm_call *call;
    cardan_wasm_delete *delete_error, *delete_trap;
    void *store;
    const void *run, *prepare;  /* wasmtime_func_t */
    char *memory;
    char *lock;                 /* of the store, which serves one thread at a time */
    ptrdiff_t at_in, at_out, at_work, at_p, at_w;
    ptrdiff_t np, nw, size;     /* numbers of p, w and the results */
    const ptrdiff_t *at, *sizes; /* (CARDAN_WASM_BLOCKS) of the blocks: address, numbers */
} cardan_wasm_function;

/* Take a place for a function; returns its number, -1 if none is free. `run` and `prepare` become the
 * functions of C. Not to be called by two threads at once, as the next. */
int cardan_wasm_take(const cardan_wasm_function *function, cardan_function *run,
                     void (**prepare)(const wreal *p, wreal *w));
/* Give a place back. */
void cardan_wasm_give_back(int place);

#endif
