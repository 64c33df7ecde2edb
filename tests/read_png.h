/* read_png.h: pictures and films read by another program's reader (stb_image), for tests of what the chapters drawing and scenes write.
   Where that is not installed, HAS_READER is 0 and only the numbers of a file can be looked at. */
#ifndef WEFT_TESTS_READ_PNG_H
#define WEFT_TESTS_READ_PNG_H
#include "testing.h"
#if defined(__has_include)
#if __has_include(<stb/stb_image.h>)
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wundef"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop
#define HAS_READER 1
#endif
#endif
#ifndef HAS_READER
#define HAS_READER 0
#endif
#include "testbed/png.h"

static inline uint32_t get4(const uint8_t *p) { return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | (uint32_t)p[2] << 8 | p[3]; }

/* Nothing, where there is no reader. */
static inline void check_pixels(const uint8_t *file, size_t size, const frame_buffer *b, int x, int y, int w, int h)
{
#if HAS_READER
    int gw, gh, n;
    uint8_t *got = stbi_load_from_memory(file, (int)size, &gw, &gh, &n, 4);
    if (!got) fail_msg("%d x %d: %s", w, h, stbi_failure_reason());
    assert_true(gw == w && gh == h && n == 4);
    for (int k = 0; k < h; k++) assert_memory_equal(got + 4 * w * k, b->pixels + (y + k) * b->pitch + x, 4 * (size_t)w);
    stbi_image_free(got);
#else
    (void)file, (void)size, (void)b, (void)x, (void)y, (void)w, (void)h;
#endif
}

#if HAS_READER
/* PNG specification, 9.2: what is predicted from the left (a), above (b) and above left (c) is added. */
static inline void unfilter(uint8_t *row, const uint8_t *above, int n)
{
    for (int i = 0; i < n; i++) {
        int a = i >= 4 ? row[1 + i - 4] : 0, b = above ? above[1 + i] : 0, c = above && i >= 4 ? above[1 + i - 4] : 0;
        int p = a + b - c, pa = abs(p - a), pb = abs(p - b), pc = abs(p - c);
        int paeth = pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
        int guess[5] = { 0, a, b, (a + b) / 2, paeth };
        row[1 + i] = (uint8_t)(row[1 + i] + guess[row[0]]);
    }
}

/* What a picture of a film says, unpacked and unfiltered, over what was there; the film is as wide as `pitch'. */
static inline void lay_over(uint32_t *seen, int pitch, const uint8_t *packed, int length, int w, int h)
{
    int got = 0;
    uint8_t *raw = (uint8_t *)stbi_zlib_decode_malloc((const char *)packed, length, &got);
    assert_non_null(raw);
    assert_int_equal(got, (4 * w + 1) * h);
    for (int y = 0; y < h; y++) {
        uint8_t *row = raw + y * (4 * w + 1);
        assert_true(row[0] <= 4);
        unfilter(row, y ? row - (4 * w + 1) : NULL, 4 * w);
        for (int x = 0; x < w; x++) {
            const uint8_t *p = row + 1 + 4 * x;
            assert_true(p[3] == 0 || p[3] == 255);
            if (p[3]) memcpy(&seen[y * pitch + x], p, 4);
        }
    }
    stbi_image_free(raw);
}
#endif
#endif
