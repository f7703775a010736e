/* Functions of WebAssembly as functions of C; see wasm_calls.h.
 *
 * Part of cardan. Caller owns all memory but the list of places.
 */
#include "wasm_calls.h"

/* the functions in their places; every place is taken and given back by its owner alone */
static const cardan_wasm_function *places[CARDAN_WASM_PLACES];

/* One thread at a time. */
static void enter(char *lock)
{
#ifdef __GNUC__
    while (__atomic_test_and_set(lock, __ATOMIC_ACQUIRE))
        while (__atomic_load_n(lock, __ATOMIC_RELAXED)) continue;
#else
    *lock = 1;
#endif
}

static void leave(char *lock)
{
#ifdef __GNUC__
    __atomic_clear(lock, __ATOMIC_RELEASE);
#else
    *lock = 0;
#endif
}

/* Call a function of WebAssembly: its result becomes the first value. Returns 1 if it was ended. */
static int ended(const cardan_wasm_function *f, const void *function, cardan_wasm_value *values, size_t count)
{
    void *trap = NULL, *const error = f->call(f->store, function, values, count, &trap);

    if (error) f->delete_error(error);
    if (trap) f->delete_trap(trap);
    return error || trap;
}

static int run(int place, const cardan_in *in, real *out)
{
    const cardan_wasm_function *const f = places[place];
    const real *const blocks[CARDAN_WASM_BLOCKS] = {in->t,   in->q,    in->u,    in->z,      in->s,  in->r,
                                                    in->p,   in->w,    in->udot, in->zdot,   in->lam, in->tau,
                                                    in->wrench, in->du, in->q0,  in->e,     in->v};
    cardan_wasm_value values[3] = {{(int32_t)f->at_in}, {(int32_t)f->at_out}, {(int32_t)f->at_work}};
    int status;

    enter(f->lock);
    for (int k = 0; k < CARDAN_WASM_BLOCKS; k++)
        if (f->sizes[k] > 0) memcpy(f->memory + f->at[k], blocks[k], (size_t)f->sizes[k] * sizeof(real));
    status = ended(f, f->run, values, 3) ? CARDAN_TRAPPED : values[0].i32;
    memcpy(out, f->memory + f->at_out, (size_t)f->size * sizeof(real));
    leave(f->lock);
    return status;
}

static void prepare(int place, const wreal *p, wreal *w)
{
    const cardan_wasm_function *const f = places[place];
    cardan_wasm_value values[2] = {{(int32_t)f->at_p}, {(int32_t)f->at_w}};

    enter(f->lock);
    memcpy(f->memory + f->at_p, p, (size_t)f->np * sizeof(wreal));
    /* what was ended has no numbers */
    if (ended(f, f->prepare, values, 2))
        for (ptrdiff_t k = 0; k < f->nw; k++) w[k] = (wreal)NAN;
    else
        memcpy(w, f->memory + f->at_w, (size_t)f->nw * sizeof(wreal));
    leave(f->lock);
}

/* the functions of all places: X(0) X(1) ... */
#define TIMES_4(X, k) X(k##0) X(k##1) X(k##2) X(k##3)
#define TIMES_8(X, k) TIMES_4(X, k) X(k##4) X(k##5) X(k##6) X(k##7)
#define TIMES_64(X, k)                                                                             \
    TIMES_8(X, k##0) TIMES_8(X, k##1) TIMES_8(X, k##2) TIMES_8(X, k##3)                            \
    TIMES_8(X, k##4) TIMES_8(X, k##5) TIMES_8(X, k##6) TIMES_8(X, k##7)
/* octal numbers of three digits */
#define ALL(X)                                                                                     \
    TIMES_64(X, 00) TIMES_64(X, 01) TIMES_64(X, 02) TIMES_64(X, 03)                                \
    TIMES_64(X, 04) TIMES_64(X, 05) TIMES_64(X, 06) TIMES_64(X, 07)

#define DEFINE(k)                                                                                  \
    static int run_##k(const cardan_in *in, real *out, real *work)                                 \
    {                                                                                              \
        (void)work;                                                                                \
        return run(k, in, out);                                                                    \
    }                                                                                              \
    static void prepare_##k(const wreal *p, wreal *w)                                              \
    {                                                                                              \
        prepare(k, p, w);                                                                          \
    }
ALL(DEFINE)

#define RUN(k) run_##k,
#define PREPARE(k) prepare_##k,
static const cardan_function runs[] = {ALL(RUN)};
static void (*const prepares[])(const wreal *p, wreal *w) = {ALL(PREPARE)};

int cardan_wasm_take(const cardan_wasm_function *function, cardan_function *run_of,
                     void (**prepare_of)(const wreal *p, wreal *w))
{
    for (int k = 0; k < CARDAN_WASM_PLACES; k++)
        if (!places[k]) {
            places[k] = function;
            *run_of = runs[k];
            *prepare_of = prepares[k];
            return k;
        }
    return -1;
}

void cardan_wasm_give_back(int place)
{
    places[place] = NULL;
}
