/* Pictures and films in files. The oracle is another program's reader, stb_image; checksums are computed anew, bit by bit,
   and the pictures of a film are unpacked one by one and laid over each other. */
#include "read_png.h"

enum { BYTES = 8 * 1024 * 1024 };
static uint32_t state32 = 1;
static uint32_t rnd(void) { return state32 = state32 * 1664525u + 1013904223u, state32 >> 8; }

/* The polynomial's remainder, a bit at a time: PNG specification, 5.5. */
static uint32_t slow_crc(const uint8_t *p, size_t n)
{
    uint32_t c = 0xffffffff;
    for (size_t i = 0; i < n; i++) {
        c ^= p[i];
        for (int k = 0; k < 8; k++) c = c & 1 ? c >> 1 ^ 0xedb88320 : c >> 1;
    }
    return ~c;
}

typedef struct chunk { char name[5]; const uint8_t *data; uint32_t length; } chunk;

/* All chunks of a file; each is whole, and its checksum is right. */
static int chunks_of(const uint8_t *file, size_t size, chunk *out, int most)
{
    static const uint8_t head[8] = { 0x89, 'P', 'N', 'G', 13, 10, 26, 10 };
    int count = 0;
    assert_true(size > 8 && memcmp(file, head, 8) == 0);
    for (size_t at = 8; at < size; count++) {
        assert_true(at + 12 <= size && count < most);
        uint32_t length = get4(file + at);
        assert_true(length <= size - at - 12);
        memcpy(out[count].name, file + at + 4, 4);
        out[count].name[4] = 0;
        out[count].data = file + at + 8;
        out[count].length = length;
        assert_int_equal(get4(file + at + 8 + length), slow_crc(file + at + 4, length + 4));
        at += 12 + length;
    }
    assert_string_equal(out[0].name, "IHDR");
    assert_string_equal(out[count - 1].name, "IEND");
    return count;
}

static void fill(uint32_t *pixels, int w, int h, int kind)
{
    for (int y = 0; y < h; y++)
        for (int x = 0; x < w; x++) {
            uint32_t p = 0x204060;
            if (kind == 1) p = rnd();                                           /* nothing to gain */
            if (kind == 2) p = (uint32_t)(x * 3 + y * 5);
            if (kind == 3) p = (x / 7 + y / 5) % 2 ? 0xffffff : 0x102030;
            if (kind == 4) p = rnd() % 40 == 0 ? rnd() : 0x777777;
            pixels[y * w + x] = (p & 0xffffff) | 0xff000000u;
        }
}

static size_t write_one(uint8_t *file, size_t room, const uint32_t *pixels, int w, int h, int pitch)
{
    frame_buffer b = { (uint32_t *)(uintptr_t)pixels, w, h, pitch, 1 };
    wfPng p = { .bytes = file, .size = room };
    wfPngBegin(&p, w, h, false);
    assert_true(wfPngPicture(&p, &b, NULL, 1));
    return wfPngEnd(&p);
}

TEST(a_picture_is_read_by_another_program)
{
    uint8_t *file = malloc(BYTES);
    uint32_t *pixels = calloc(700 * 500, 4);
    chunk c[16];
    static const int sizes[][2] = { { 1, 1 }, { 3, 2 }, { 64, 64 }, { 257, 131 }, { 700, 500 } };
    for (int s = 0; s < 5; s++)
        for (int kind = 0; kind < 5; kind++) {
            int w = sizes[s][0], h = sizes[s][1];
            fill(pixels, w, h, kind);
            size_t size = write_one(file, BYTES, pixels, w, h, w);
            assert_true(size > 0 && chunks_of(file, size, c, 16) == 3);
            if (kind == 0 && s == 4) assert_true(size < 4 * 700 * 500 / 60);    /* plain: hardly anything */
            frame_buffer b = { pixels, w, h, w, 1 };
            check_pixels(file, size, &b, 0, 0, w, h);
        }
    free(pixels);
    free(file);
}

/* Rows further apart than the picture is wide: it does not lean. */
TEST(a_part_of_a_buffer_is_written)
{
    static uint8_t file[1 << 18];
    static uint32_t whole[100 * 90];
    fill(whole, 100, 90, 1);
    size_t size = write_one(file, sizeof file, whole + 20 * 100 + 10, 40, 30, 100);
    assert_true(size > 0);
    frame_buffer b = { whole, 100, 90, 100, 1 };
    check_pixels(file, size, &b, 10, 20, 40, 30);
}

TEST(a_film_is_the_pictures_that_went_in)
{
    enum { W = 120, H = 80, N = 25 };
    static uint8_t file[1 << 21];
    static uint32_t film[N][W * H], before[W * H];
    static chunk c[4 * N];
    wfPng p = { .bytes = file, .size = sizeof file };
    wfPngBegin(&p, W, H, true);
    for (int k = 0; k < N; k++) {
        fill(film[k], W, H, 0);
        for (int i = 0; i < 400; i++) film[k][(10 + i / 20) * W + 3 * (k < N - 1 ? k : k - 1) + i % 20] = 0xff0000ffu;      /* a box on its way */
        frame_buffer b = { film[k], W, H, W, 1 };
        size_t used = p.used;
        assert_true(wfPngPicture(&p, &b, before, 30));
        if (k) assert_true(p.used - used < 2000);                                   /* only what changed */
    }
    size_t size = wfPngEnd(&p);
    assert_true(size > 0);
    int count = chunks_of(file, size, c, 4 * N), pictures = 0, at[4] = { 0 };
    uint32_t number = 0;
    static uint32_t seen[W * H];
    assert_string_equal(c[1].name, "acTL");
    assert_int_equal(get4(c[1].data), N);
    assert_int_equal(get4(c[1].data + 4), 0);
    for (int i = 2; i < count - 1; i++) {
        bool control = strcmp(c[i].name, "fcTL") == 0, more = strcmp(c[i].name, "fdAT") == 0;
        if (control || more) assert_int_equal(get4(c[i].data), number++);
        if (control) {
            assert_int_equal(c[i].length, 26);
            for (int k = 0; k < 4; k++) at[k] = (int)get4(c[i].data + 4 + 4 * k);      /* w, h, x, y */
            assert_true(at[0] > 0 && at[1] > 0 && at[2] >= 0 && at[3] >= 0 && at[0] + at[2] <= W && at[1] + at[3] <= H);
            if (!pictures) assert_true(at[0] == W && at[1] == H);
            if (pictures > 0 && pictures < N - 2) assert_true(at[0] == 23 && at[1] == 20 && at[3] == 10);   /* 20 + 3 columns */
            if (pictures == N - 1) assert_true(at[0] == 1 && at[1] == 1);                  /* nothing has changed */
            assert_true(c[i].data[20] == 0 && c[i].data[21] == 1 && c[i].data[22] == 0 && c[i].data[23] == 30);
            continue;
        }
        assert_string_equal(c[i].name, pictures ? "fdAT" : "IDAT");
#if HAS_READER
        lay_over(seen + at[3] * W + at[2], W, c[i].data + (more ? 4 : 0), (int)c[i].length - (more ? 4 : 0), at[0], at[1]);
        assert_memory_equal(seen, film[pictures], sizeof seen);
#endif
        pictures++;
    }
    assert_int_equal(pictures, N);
}

/* However little room there is: nothing beyond it is touched, and the answer is 0. */
TEST(too_little_room_is_noticed)
{
    static uint8_t file[60000];
    static uint32_t pixels[64 * 64];
    fill(pixels, 64, 64, 1);
    wfPng p = { 0 };
    frame_buffer b = { pixels, 64, 64, 64, 1 };
    wfPngBegin(&p, 64, 64, false);
    assert_true(wfPngPicture(&p, &b, NULL, 1));
    assert_int_equal(wfPngEnd(&p), 0);
    size_t need = p.used;
    assert_true(need < sizeof file);
    for (size_t room = 0; room < need; room += room < 200 ? 1 : 997) {
        memset(file, 0x5a, sizeof file);
        assert_int_equal(write_one(file, room, pixels, 64, 64, 64), 0);
        for (size_t i = room; i < sizeof file; i++) assert_int_equal(file[i], 0x5a);
    }
    assert_int_equal(write_one(file, need, pixels, 64, 64, 64), need);
}

TEST(a_file_on_disk)
{
    static uint32_t pixels[30 * 20];
    char name[] = "/tmp/weft-picture-XXXXXX";
    FILE *f = fopen(name, "wb");                    /* tests run one at a time in this folder */
    assert_non_null(f);
    fclose(f);
    fill(pixels, 30, 20, 1);
    frame_buffer b = { pixels, 30, 20, 30, 1 }, none = { NULL, 30, 20, 30, 1 };
    assert_true(write_png(name, &b));
    assert_false(write_png(name, &none));
    assert_false(write_png("/no/such/folder/a.png", &b));
#if HAS_READER
    int w, h, n;
    assert_true(write_png(name, &b));
    uint8_t *got = stbi_load(name, &w, &h, &n, 4);
    assert_non_null(got);
    assert_memory_equal(got, pixels, sizeof pixels);
    stbi_image_free(got);
#endif
    remove(name);
}
