/* Exercise save-endian. Oracle: numbers written byte by byte in both orders. */
#include "course.h"
typedef struct ExField { size_t offset, size, count; } ExField;
bool exCovers(const ExField *f, int fields, size_t bytes, uint8_t *mark);
#define exCovers(f, fields, bytes, mark) asked(exCovers(f, fields, bytes, mark))
bool exTurn(uint8_t *image, size_t bytes, const ExField *f, int fields, uint8_t *mark);
#define exTurn(image, bytes, f, fields, mark) asked_and(exTurn(image, bytes, f, fields, mark), left_many(image, bytes))
static const ExField TABLE[4] = { { 24, 8, 2 }, { 0, 4, 3 }, { 12, 1, 4 }, { 16, 2, 4 } };
static void turns(void)
{
    uint8_t image[40], want[40], first[40], mark[40];
    wfRandom r = course_random(28);
    for (int i = 0; i < 40; i++) first[i] = image[i] = (uint8_t)wfRandomU32(&r);
    for (int i = 0; i < 4; i++)
        for (size_t k = 0; k < TABLE[i].count; k++)
            for (size_t b = 0; b < TABLE[i].size; b++)
                want[TABLE[i].offset + k * TABLE[i].size + b] = first[TABLE[i].offset + k * TABLE[i].size + TABLE[i].size - 1 - b];
    expect_true("a good table is accepted", exTurn(image, 40, TABLE, 4, mark));
    for (int i = 0; i < 40; i++) expect_int(say("byte %d of the turned image", i), image[i], want[i]);
    exTurn(image, 40, TABLE, 4, mark);
    expect_true("turned twice, it is as it was", memcmp(image, first, 40) == 0);
}
static void covers(void)
{
    uint8_t mark[40];
    ExField f[4];
    memcpy(f, TABLE, sizeof f);
    expect_true("a good table covers", exCovers(shown_many(f, 4), 4, 40, mark));
    expect_false("a table without its last line covers", exCovers(shown_many(f, 4), 3, 40, mark));
    f[2].count = 5;
    expect_false("a table that names a byte twice covers", exCovers(shown_many(f, 4), 4, 40, mark));
    memcpy(f, TABLE, sizeof f);
    f[2].size = 3;
    expect_false("a table with a number of 3 bytes covers", exCovers(shown_many(f, 4), 4, 40, mark));
}
static void hostile(void)
{
    static uint8_t mark[40];
    ExField over = { 0, 8, SIZE_MAX / 8 + 1 }, far = { SIZE_MAX - 3, 4, 1 }, none = { 0, 0, 40 };
    ExField both[2] = { { 0, 8, 1 }, over };
    expect_false("a count whose bytes run over is accepted", exCovers(shown_many(both, 2), 2, 8, mark));
    expect_false("an offset behind the end is accepted", exCovers(shown(&far), 1, 40, mark));
    expect_false("numbers of no bytes are accepted", exCovers(shown(&none), 1, 40, mark));
}
CRITERIA("endian",
    { "turns", 2, "endian: turn one number round", "numbers of all sizes are turned round, and back", turns, 0 },
    { "covers", 2, "endian: mark what the table names, and look", "a table must name every byte exactly once", covers, 0 },
    { "hostile", 1, "endian: mark what the table names, and look", "a table of absurd numbers is refused", hostile, 0 })
