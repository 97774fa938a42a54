/* Runs of a closed loop by a step of flat arrays or of its own packing, with a fast generator of normal draws of its own:
 * xoshiro256++ (Blackman and Vigna) and the ziggurat of 128 layers (Marsaglia and Tsang, in the form of Doornik's ZIGNOR).
 */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

typedef void (*step_function)(void *in, void *out);
typedef void (*carry_function)(const void *out, void *in, double t, const double *dw);

/* Where the parts of the flat input lie: t, x and controller states, noise. */
struct layout {
    size_t inputs, results, states, carried, noise, channels;
    double dt, scale;
};

static uint64_t word[4];

static inline uint64_t rotate(uint64_t x, int k) { return x << k | x >> (64 - k); }

static inline uint64_t next_word(void) {
    uint64_t result = rotate(word[0] + word[3], 23) + word[0], shifted = word[1] << 17;
    word[2] ^= word[0], word[3] ^= word[1], word[1] ^= word[2], word[0] ^= word[3];
    word[2] ^= shifted, word[3] = rotate(word[3], 45);
    return result;
}

static void seed_words(uint64_t seed) {
    for (int i = 0; i < 4; i++) {
        uint64_t z = seed += 0x9e3779b97f4a7c15;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9, z = (z ^ z >> 27) * 0x94d049bb133111eb;
        word[i] = z ^ z >> 31;
    }
}

enum { LAYERS = 128 };
static const double TAIL = 3.442619855899, AREA = 9.91256303526217e-3;
static double edge[LAYERS + 1], ratio[LAYERS];

static void make_layers(void) {
    double f = exp(-0.5 * TAIL * TAIL);
    edge[0] = AREA / f, edge[1] = TAIL, edge[LAYERS] = 0.0;
    for (int i = 2; i < LAYERS; i++) {
        edge[i] = sqrt(-2.0 * log(AREA / edge[i - 1] + f));
        f = exp(-0.5 * edge[i] * edge[i]);
    }
    for (int i = 0; i < LAYERS; i++) ratio[i] = edge[i + 1] / edge[i];
}

static inline double unit(uint64_t bits) { return (double)(bits >> 11) * 0x1p-53; }

static double tail(int negative) {
    double x, y;
    do {
        x = log(unit(next_word()) + 0x1p-54) / TAIL;
        y = log(unit(next_word()) + 0x1p-54);
    } while (-2.0 * y < x * x);
    return negative ? x - TAIL : TAIL - x;
}

static inline double normal(void) {
    for (;;) {
        uint64_t bits = next_word();
        double u = 2.0 * unit(bits) - 1.0;
        int i = bits & (LAYERS - 1);
        if (fabs(u) < ratio[i]) return u * edge[i];
        if (i == 0) return tail(u < 0.0);
        double x = u * edge[i], x2 = x * x;
        double f0 = exp(-0.5 * (edge[i] * edge[i] - x2)), f1 = exp(-0.5 * (edge[i + 1] * edge[i + 1] - x2));
        if (f1 + unit(next_word()) * (f0 - f1) < 1.0) return x;
    }
}

/* Final plant states of all runs; `start` and `in` are the packed start and space for an input. */
void ensemble(step_function step, carry_function carry, const struct layout *at, const void *start, void *in, size_t in_size, void *out,
              void (*unpack)(const void *, const void *, double *), size_t runs, size_t steps, uint64_t seed, double *finals) {
    double dw[64], flat[4096];
    make_layers();
    seed_words(seed);
    for (size_t run = 0; run < runs; run++) {
        memcpy(in, start, in_size);
        for (size_t k = 0; k < steps; k++) {
            double t = (double)k * at->dt;
            for (size_t j = 0; j < at->channels; j++) dw[j] = at->scale * normal();
            if (carry) {
                carry(k ? out : 0, in, t, dw);
            } else {
                double *x = in;
                x[0] = t;
                if (k) memcpy(x + 1, out, at->carried * sizeof(double));
                memcpy(x + at->noise, dw, at->channels * sizeof(double));
            }
            step(in, out);
        }
        if (unpack) unpack(in, out, flat);
        memcpy(finals + run * at->states, unpack ? flat : out, at->states * sizeof(double));
    }
}
