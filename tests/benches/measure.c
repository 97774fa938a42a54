/* The one loop that times every peer: built as a shared library, called in a fresh process per measurement (measure.py).
 *
 * Ticks are those of the time stamp counter. A chain of dependent products, three core cycles each, tells how many core cycles a tick is.
 */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <x86intrin.h>

typedef void (*step_function)(void *in, void *out);

static inline uint64_t ticks_before(void) {
    _mm_lfence();
    uint64_t now = __rdtsc();
    _mm_lfence();
    return now;
}

static inline uint64_t ticks_after(void) {
    unsigned processor;
    uint64_t now = __rdtscp(&processor);
    _mm_lfence();
    return now;
}

/* The counter, for loops that are not in C. */
uint64_t ticks(void) { return ticks_after(); }

/* Core cycles per tick. */
double cycles_per_tick(void) {
    enum { PRODUCTS = 400000, LATENCY = 3 };
    double best = 0.0;
    for (int trial = 0; trial < 9; trial++) {
        uint64_t x = 3, start = ticks_before();
        for (int i = 0; i < PRODUCTS / 4; i++) __asm__ volatile("imul %0,%0\n imul %0,%0\n imul %0,%0\n imul %0,%0" : "+r"(x));
        double ratio = PRODUCTS * LATENCY / (double)(ticks_after() - start);
        best = ratio > best ? ratio : best;
    }
    return best;
}

#define PAIR(size, a, b) "vmulpd %%" size "12,%%" size "12,%%" size #a "\n vaddpd %%" size "12,%%" size "12,%%" size #b "\n"
#define PAIRS(size) PAIR(size, 0, 1) PAIR(size, 2, 3) PAIR(size, 4, 5) PAIR(size, 6, 7) PAIR(size, 8, 9) PAIR(size, 10, 11)
#define PRODUCTS_AND_SUMS(size) \
    __asm__ volatile(PAIRS(size)::: "xmm0", "xmm1", "xmm2", "xmm3", "xmm4", "xmm5", "xmm6", "xmm7", "xmm8", "xmm9", "xmm10", "xmm11")

/* Products and sums per core cycle, as many of each and none waiting for another, in registers of 2, 4 or 8 lanes of f64: the most
 * arithmetic that any code can do here. */
double peak(int lanes) {
    enum { ROUNDS = 40000, OPERATIONS = 12, TRIALS = 25 };
    double best = 0.0;
    for (int trial = 0; trial < TRIALS; trial++) {
        uint64_t start = ticks_before();
        for (int i = 0; i < ROUNDS; i++) {
            if (lanes == 8) PRODUCTS_AND_SUMS("zmm");
            else if (lanes == 4) PRODUCTS_AND_SUMS("ymm");
            else PRODUCTS_AND_SUMS("xmm");
        }
        double rate = ROUNDS * OPERATIONS / (double)(ticks_after() - start);
        best = rate > best ? rate : best;
    }
    return best / cycles_per_tick();
}

/* `count` inputs of `size` bytes at `in`, which a step may change, and as they are at first. */
struct inputs {
    char *in;
    const char *first;
    size_t size;
    int count;
};

static void restore(const struct inputs *of) { memcpy(of->in, of->first, of->size * of->count); }

/* Ticks per call of each of `batches` batches of `parts` times `calls` calls, in which the inputs are used in turn. Before each part all
 * inputs are as at first, since a step that works in place would else go on from them for ever with the same noise. */
void measure_warm(step_function step, const struct inputs *of, char *out, int calls, int parts, int batches, double *ticks) {
    struct inputs all = *of;
    for (int batch = -1; batch < batches; batch++) {
        uint64_t sum = 0;
        for (int part = 0; part < parts; part++) {
            restore(&all);
            uint64_t start = ticks_before();
            for (int i = 0, k = 0; i < calls; i++, k = k + 1 == all.count ? 0 : k + 1) step(all.in + all.size * k, out);
            sum += ticks_after() - start;
        }
        if (batch >= 0) ticks[batch] = (double)sum / (calls * parts);
    }
}

enum { LINE = 64, CODE = 1 << 18, DATA = 4 << 20 };
typedef void (*code)(void);

/* Runs through more code and data than the first two levels of cache hold, so that the step comes from the last one. */
static void evict(const char *returns, volatile char *data) {
    for (size_t at = 0; at < CODE; at += LINE) ((code)(uintptr_t)(returns + at))();
    for (size_t at = 0; at < DATA; at += LINE) data[at]++;
    for (size_t at = 0; at < CODE; at += LINE) ((code)(uintptr_t)(returns + at))();
}

/* Ticks of single calls on inputs as at first, each after an eviction; the cost of reading the counter is taken off. */
void measure_cold(step_function step, const struct inputs *of, char *out, int calls, double *ticks) {
    char *returns = mmap(0, CODE, PROT_READ | PROT_WRITE | PROT_EXEC, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    volatile char *data = calloc(DATA, 1);
    memset(returns, 0xc3, CODE);
    for (int i = 0; i < calls; i++) {
        restore(of);
        evict(returns, data);
        uint64_t start = ticks_before();
        uint64_t empty = ticks_after() - start;
        start = ticks_before();
        step(of->in + of->size * (i % of->count), out);
        ticks[i] = (double)(ticks_after() - start) - (double)empty;
    }
    munmap(returns, CODE);
    free((void *)data);
}
