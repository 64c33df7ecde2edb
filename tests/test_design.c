/* The display list, the figure table, the measurement table.
 * Everything here is exact: the list stores what it is given, so no tolerances are needed. */
#include "testing.h"
#include "weft/draw.h"
#include "lab/lab.h"

static _Alignas(8) unsigned char memory[4096];
static const float BOX[8] = { 0, 0, 2, 0, 2, 1, 0, 1 };

static wfDraw new_list(void)
{
    wfDraw d;
    memset(memory, 0xa5, sizeof memory);
    wfDrawInit(&d, memory, sizeof memory);
    return d;
}

static void assert_command(const wfDraw *d, int i, int kind, int line, int fill, float size, int count)
{
    assert_true(i < d->count);
    const wfDrawCommand *c = wfDrawAt(d, i);
    assert_int_equal(c->kind, kind);
    assert_int_equal(c->line, line);
    assert_int_equal(c->fill, fill);
    assert_true(c->size == size);
    assert_int_equal(c->count, count);
}

TEST(a_new_list_is_empty)
{
    wfDraw d = new_list();
    assert_int_equal(d.count, 0);
    assert_int_equal(d.overflow, 0);
    assert_int_equal(d.refused, 0);
    assert_int_equal(wfDrawBytes(&d), 0);
    assert_int_equal(d.size, sizeof memory);
    assert_true(d.view[0] == 0 && d.view[1] == 0 && d.view[2] == 1 && d.view[3] == 1);
}

TEST(each_call_stores_its_command)
{
    wfDraw d = new_list();
    wfDrawPoint(&d, 1, 2, 4, WF_INK_ACCENT);
    wfDrawLine(&d, 1, 2, 3, 4, 1.5f, WF_INK_LINE);
    wfDrawArrow(&d, 5, 6, 7, 8, 2, WF_INK_GOOD);
    wfDrawDashed(&d, 9, 10, 11, 12, 3, WF_INK_BAD);
    wfDrawCircle(&d, -1, -2, 0.5f, 1, WF_INK_BODY, WF_INK_NONE);
    wfDrawPolygon(&d, BOX, 4, 2, WF_INK_NONE, WF_INK_BODY2);
    wfDrawPolyline(&d, BOX, 3, 1, WF_INK_FAINT);
    wfDrawText(&d, 3, 4, 13, WF_INK_TEXT, 1, "abc");
    assert_int_equal(d.count, 8);
    assert_int_equal(d.refused + d.overflow, 0);
    assert_command(&d, 0, WF_DRAW_POINT, WF_INK_NONE, WF_INK_ACCENT, 4, 1);
    assert_command(&d, 1, WF_DRAW_LINE, WF_INK_LINE, WF_INK_NONE, 1.5f, 2);
    assert_command(&d, 2, WF_DRAW_ARROW, WF_INK_GOOD, WF_INK_NONE, 2, 2);
    assert_command(&d, 3, WF_DRAW_DASHED, WF_INK_BAD, WF_INK_NONE, 3, 2);
    assert_command(&d, 4, WF_DRAW_CIRCLE, WF_INK_BODY, WF_INK_NONE, 1, 1);
    assert_command(&d, 5, WF_DRAW_POLYGON, WF_INK_NONE, WF_INK_BODY2, 2, 4);
    assert_command(&d, 6, WF_DRAW_POLYLINE, WF_INK_FAINT, WF_INK_NONE, 1, 3);
    assert_command(&d, 7, WF_DRAW_TEXT, WF_INK_NONE, WF_INK_TEXT, 13, 1);
    assert_true(wfDrawAt(&d, 4)->radius == 0.5f);
    assert_int_equal(wfDrawAt(&d, 7)->anchor, 1);
    assert_int_equal(wfDrawAt(&d, 7)->length, 3);
    float line[4] = { 1, 2, 3, 4 }, arrow[4] = { 5, 6, 7, 8 }, dashed[4] = { 9, 10, 11, 12 };
    assert_memory_equal(wfDrawPoints(&d, wfDrawAt(&d, 1)), line, sizeof line);
    assert_memory_equal(wfDrawPoints(&d, wfDrawAt(&d, 2)), arrow, sizeof arrow);
    assert_memory_equal(wfDrawPoints(&d, wfDrawAt(&d, 3)), dashed, sizeof dashed);
    assert_true(wfDrawPoints(&d, wfDrawAt(&d, 4))[0] == -1 && wfDrawPoints(&d, wfDrawAt(&d, 4))[1] == -2);
    assert_memory_equal(wfDrawPoints(&d, wfDrawAt(&d, 5)), BOX, sizeof BOX);
    assert_memory_equal(wfDrawPoints(&d, wfDrawAt(&d, 6)), BOX, 6 * sizeof(float));
    assert_true(wfDrawPoints(&d, wfDrawAt(&d, 0))[0] == 1 && wfDrawPoints(&d, wfDrawAt(&d, 0))[1] == 2);
    assert_true(wfDrawPoints(&d, wfDrawAt(&d, 7))[0] == 3 && wfDrawPoints(&d, wfDrawAt(&d, 7))[1] == 4);
    assert_string_equal(wfDrawString(&d, wfDrawAt(&d, 7)), "abc");
    assert_string_equal(wfDrawString(&d, wfDrawAt(&d, 0)), "");
    assert_int_equal(wfDrawAt(&d, 0)->length, 0);
}

TEST(the_list_keeps_copies)
{
    wfDraw d = new_list();
    char text[8] = "before";
    float xy[6] = { 0, 0, 1, 0, 0, 1 };
    wfDrawText(&d, 0, 0, 13, WF_INK_TEXT, 0, text);
    wfDrawPolygon(&d, xy, 3, 1, WF_INK_LINE, WF_INK_NONE);
    strcpy(text, "after");
    xy[2] = 99;
    assert_string_equal(wfDrawString(&d, wfDrawAt(&d, 0)), "before");
    assert_true(wfDrawPoints(&d, wfDrawAt(&d, 1))[2] == 1);
}

TEST(text_is_formatted_and_cut)
{
    wfDraw d = new_list();
    wfDrawTextf(&d, 0, 0, 13, WF_INK_TEXT, -7, "h = %.2f s", 0.5);
    assert_string_equal(wfDrawString(&d, wfDrawAt(&d, 0)), "h = 0.50 s");
    assert_int_equal(wfDrawAt(&d, 0)->anchor, -1);
    wfDrawTextf(&d, 0, 0, 13, WF_INK_TEXT, 9, "%400d", 1);
    assert_int_equal(wfDrawAt(&d, 1)->length, 255);
    assert_int_equal(wfDrawAt(&d, 1)->anchor, 1);
    wfDrawText(&d, 0, 0, 13, WF_INK_TEXT, 0, "");
    assert_string_equal(wfDrawString(&d, wfDrawAt(&d, 2)), "");
    assert_int_equal(d.refused + d.overflow, 0);
}

/* A list is bytes without pointers: copied elsewhere, it says the same. */
TEST(a_list_can_be_moved)
{
    static _Alignas(8) unsigned char elsewhere[sizeof memory];
    wfDraw d = new_list();
    wfDrawText(&d, 1, 2, 13, WF_INK_TEXT, 0, "moved");
    wfDrawLine(&d, 1, 2, 3, 4, 1, WF_INK_LINE);
    memcpy(elsewhere, memory, sizeof memory);
    memset(memory, 0, sizeof memory);
    d.base = elsewhere;
    assert_string_equal(wfDrawString(&d, wfDrawAt(&d, 0)), "moved");
    assert_true(wfDrawPoints(&d, wfDrawAt(&d, 1))[3] == 4);
}

TEST(bytes_are_counted)
{
    wfDraw d = new_list();
    wfDrawLine(&d, 0, 0, 1, 1, 1, WF_INK_LINE);
    assert_int_equal(wfDrawBytes(&d), sizeof(wfDrawCommand) + 4 * sizeof(float));
    wfDrawText(&d, 0, 0, 13, WF_INK_TEXT, 0, "12345678");  /* 9 bytes with the NUL: 16 */
    assert_int_equal(wfDrawBytes(&d), 2 * sizeof(wfDrawCommand) + 4 * sizeof(float) + 2 * sizeof(float) + 16);
    wfDrawReset(&d);
    assert_int_equal(wfDrawBytes(&d), 0);
    assert_int_equal(d.count, 0);
}

TEST(reset_forgets_counts_and_view)
{
    wfDraw d = new_list();
    wfDrawView(&d, 1, 2, 3, 4);
    wfDrawView(&d, 1, 2, 1, 4);
    wfDrawPoint(&d, NAN, 0, 1, WF_INK_LINE);
    d.overflow = 3;
    wfDrawReset(&d);
    assert_int_equal(d.refused, 0);
    assert_int_equal(d.overflow, 0);
    assert_true(d.view[0] == 0 && d.view[1] == 0 && d.view[2] == 1 && d.view[3] == 1);
    assert_int_equal(d.size, sizeof memory);
}

TEST(overflow_is_counted_and_nothing_is_lost)
{
    static _Alignas(8) unsigned char small[4 * 40 + 16];  /* four lines of 40 bytes, and a rest */
    wfDraw d;
    wfDrawInit(&d, small, sizeof small);
    for (int i = 0; i < 4; i++) wfDrawLine(&d, (float)i, 0, 1, 1, 1, WF_INK_LINE);
    assert_int_equal(d.count, 4);
    assert_int_equal(d.overflow, 0);
    unsigned char before[sizeof small];
    memcpy(before, small, sizeof small);
    wfDrawLine(&d, 9, 9, 9, 9, 1, WF_INK_LINE);
    wfDrawPoint(&d, 9, 9, 1, WF_INK_LINE);
    wfDrawText(&d, 9, 9, 1, WF_INK_LINE, 0, "a long text that does not fit");
    assert_int_equal(d.count, 4);
    assert_int_equal(d.overflow, 3);
    assert_int_equal(d.refused, 0);
    assert_memory_equal(small, before, sizeof small);
    for (int i = 0; i < 4; i++) assert_true(wfDrawPoints(&d, wfDrawAt(&d, i))[0] == (float)i);
}

TEST(the_last_byte_can_be_used)
{
    static _Alignas(8) unsigned char small[40];
    wfDraw d;
    wfDrawInit(&d, small, sizeof small);
    wfDrawLine(&d, 1, 2, 3, 4, 1, WF_INK_LINE);
    assert_int_equal(d.count, 1);
    assert_int_equal(wfDrawBytes(&d), 40);
    assert_command(&d, 0, WF_DRAW_LINE, WF_INK_LINE, WF_INK_NONE, 1, 2);
    assert_true(wfDrawPoints(&d, wfDrawAt(&d, 0))[0] == 1);
}

TEST(a_small_command_may_follow_a_large_one)
{
    static _Alignas(8) unsigned char small[48];
    float many[40] = { 0 };
    wfDraw d;
    wfDrawInit(&d, small, sizeof small);
    wfDrawPolyline(&d, many, 20, 1, WF_INK_LINE);
    wfDrawLine(&d, 1, 2, 3, 4, 1, WF_INK_LINE);
    assert_int_equal(d.overflow, 1);
    assert_int_equal(d.count, 1);
}

TEST(any_memory_will_do)
{
    wfDraw d;
    wfDrawInit(&d, NULL, 100);
    assert_int_equal(d.size, 0);
    wfDrawLine(&d, 0, 0, 1, 1, 1, WF_INK_LINE);
    assert_int_equal(d.count, 0);
    assert_int_equal(d.overflow, 1);
    for (size_t skip = 0; skip < 9; skip++)
        for (size_t bytes = 0; bytes < 64; bytes++) {
            memset(memory, 0x5a, sizeof memory);
            wfDrawInit(&d, memory + skip, bytes);
            wfDrawLine(&d, 1, 2, 3, 4, 1, WF_INK_LINE);
            assert_int_equal(d.count + d.overflow, 1);
            assert_int_equal((uintptr_t)d.base % 8, 0);
            assert_int_equal(d.size % 8, 0);
            assert_true(d.size <= bytes && d.size + 14 >= bytes);  /* 7 to align, 7 to round */
            if (bytes >= 47) assert_int_equal(d.count, 1);  /* 40 and at most 7 to align */
            if (bytes < 40) assert_int_equal(d.overflow, 1);
            for (size_t i = 0; i < 128; i++)
                if (i < skip || i >= skip + bytes) assert_int_equal(memory[i], 0x5a);
        }
}

TEST(bad_numbers_are_refused)
{
    const float bad[5] = { NAN, INFINITY, -INFINITY, 1.001e9f, -1.001e9f };
    wfDraw d = new_list();
    int expected = 0;
    for (int k = 0; k < 5; k++) {
        float b = bad[k], xy[8];
        wfDrawPoint(&d, b, 0, 1, WF_INK_LINE);
        wfDrawPoint(&d, 0, b, 1, WF_INK_LINE);
        wfDrawPoint(&d, 0, 0, b, WF_INK_LINE);
        wfDrawLine(&d, 0, 0, b, 0, 1, WF_INK_LINE);
        wfDrawArrow(&d, 0, 0, 0, b, 1, WF_INK_LINE);
        wfDrawDashed(&d, b, 0, 0, 0, 1, WF_INK_LINE);
        wfDrawCircle(&d, 0, 0, b, 1, WF_INK_LINE, WF_INK_NONE);
        wfDrawText(&d, 0, 0, b, WF_INK_TEXT, 0, "x");
        wfDrawView(&d, 0, 0, b, 1);
        wfDrawView(&d, 0, b, 1, 1);
        expected += 10;
        for (int i = 0; i < 8; i++) {
            memcpy(xy, BOX, sizeof xy);
            xy[i] = b;
            wfDrawPolygon(&d, xy, 4, 1, WF_INK_LINE, WF_INK_NONE);
            wfDrawPolyline(&d, xy, 4, 1, WF_INK_LINE);
            expected += 2;
        }
        assert_int_equal(d.refused, expected);
    }
    assert_int_equal(d.count, 0);
    assert_int_equal(d.overflow, 0);
    assert_int_equal(wfDrawBytes(&d), 0);
    wfDrawLine(&d, -WF_DRAW_LIMIT, 0, WF_DRAW_LIMIT, 0, 1, WF_INK_LINE);
    assert_int_equal(d.count, 1);
}

TEST(bad_arguments_are_refused)
{
    wfDraw d = new_list();
    const int bad[6] = { -2, WF_INK_COUNT, 127, 255, 256, -1000000 };
    for (int k = 0; k < 6; k++) {
        wfDrawPoint(&d, 0, 0, 1, bad[k]);
        wfDrawLine(&d, 0, 0, 1, 1, 1, bad[k]);
        wfDrawCircle(&d, 0, 0, 1, 1, bad[k], WF_INK_NONE);
        wfDrawCircle(&d, 0, 0, 1, 1, WF_INK_LINE, bad[k]);
        wfDrawText(&d, 0, 0, 13, bad[k], 0, "x");
    }
    assert_int_equal(d.refused, 30);
    wfDrawCircle(&d, 0, 0, -1, 1, WF_INK_LINE, WF_INK_NONE);
    wfDrawLine(&d, 0, 0, 1, 1, -1, WF_INK_LINE);
    wfDrawPolygon(&d, BOX, 2, 1, WF_INK_LINE, WF_INK_NONE);
    wfDrawPolygon(&d, BOX, -4, 1, WF_INK_LINE, WF_INK_NONE);
    wfDrawPolygon(&d, NULL, 4, 1, WF_INK_LINE, WF_INK_NONE);
    wfDrawPolygon(&d, BOX, INT32_MAX, 1, WF_INK_LINE, WF_INK_NONE);
    wfDrawPolyline(&d, BOX, 1, 1, WF_INK_LINE);
    wfDrawText(&d, 0, 0, 13, WF_INK_TEXT, 0, NULL);
    assert_int_equal(d.refused, 38);
    assert_int_equal(d.count, 0);
    wfDrawPolygon(&d, BOX, 3, 0, WF_INK_LINE, WF_INK_NONE);
    wfDrawPolyline(&d, BOX, 2, 0, WF_INK_LINE);
    wfDrawCircle(&d, 0, 0, 0, 0, WF_INK_NONE, WF_INK_NONE);
    assert_int_equal(d.count, 3);
}

TEST(views_must_have_a_size)
{
    wfDraw d = new_list();
    wfDrawView(&d, -1, -2, 3, 4);
    wfDrawView(&d, 0, 0, 0, 1);
    wfDrawView(&d, 0, 0, 1, 0);
    wfDrawView(&d, 1, 0, 0, 1);
    wfDrawView(&d, 0, 1, 1, 0);
    wfDrawView(&d, 0, 0, 0.5e-6f, 1);
    wfDrawView(&d, 0, 0, 1, 0.5e-6f);
    wfDrawView(&d, NAN, 0, 1, 1);
    wfDrawView(&d, 0, NAN, 1, 1);
    assert_int_equal(d.refused, 8);
    assert_true(d.view[0] == -1 && d.view[1] == -2 && d.view[2] == 3 && d.view[3] == 4);
    wfDrawView(&d, 0, 0, WF_DRAW_SMALLEST, WF_DRAW_SMALLEST);
    assert_int_equal(d.refused, 8);
    assert_true(d.view[2] == WF_DRAW_SMALLEST && d.view[3] == WF_DRAW_SMALLEST);
}

TEST(roles_have_names)
{
    assert_string_equal(wfInkName(WF_INK_LINE), "line");
    assert_string_equal(wfInkName(WF_INK_BODY2), "body2");
    assert_string_equal(wfInkName(WF_INK_PAPER), "paper");
    assert_string_equal(wfInkName(WF_INK_NONE), "none");
    assert_string_equal(wfInkName(WF_INK_COUNT), "none");
    for (int a = 0; a < WF_INK_COUNT; a++)
        for (int b = 0; b < a; b++) assert_string_not_equal(wfInkName(a), wfInkName(b));
}

/* Every figure of the book, whichever chapter it is from. */
TEST(every_figure_can_be_drawn)
{
    static _Alignas(8) unsigned char large[1 << 22];
    wfDraw d;
    wfDrawInit(&d, large, sizeof large);
    const wfFigureRow *f;
    assert_non_null(wfFigureAt(0));
    assert_null(wfFigureAt(-1));
    for (int i = 0; (f = wfFigureAt(i)) != NULL; i++) {
        assert_int_equal(wfFindFigure(f->name), i);  /* so the name is unique, too */
        assert_true(f->width > 0 && f->height > 0);
        assert_true(f->handleCount >= 0 && f->handleCount <= WF_FIGURE_HANDLES);
        wfDrawFigure(f, NULL, &d);
        if (d.refused || d.overflow || d.count == 0)
            fail_msg("%s: %d refused, %d overflow, %d drawn", f->name, d.refused, d.overflow, d.count);
    }
    assert_int_equal(wfFindFigure("no such figure"), -1);
}

static float seen_time;
static int seen_handles;
static float seen_x;
static void look(wfDraw *d, const wfFigureInput *in)
{
    seen_time = in->time;
    seen_handles = in->handleCount;
    seen_x = in->handle[1][0];
    wfDrawPoint(d, 0, 0, 1, WF_INK_LINE);
}

TEST(a_figure_sees_its_handles)
{
    wfDraw d = new_list();
    wfFigureRow row = { "look", look, 6, 4, 2, { { 1, 2 }, { 3, 4 } } };
    wfDrawFigure(&row, NULL, &d);
    assert_true(seen_time == 0 && seen_handles == 2 && seen_x == 3);
    assert_true(d.view[0] == 0 && d.view[1] == 0 && d.view[2] == 6 && d.view[3] == 4);
    wfFigureInput in = { .time = 2, .handleCount = 2, .handle = { { 0, 0 }, { 5, 0 } } };
    wfDrawFigure(&row, &in, &d);
    assert_true(seen_time == 2 && seen_x == 5);
    assert_int_equal(d.count, 1);  /* the list was emptied first */
}

TEST(measurements_have_names)
{
    const wfMeasureRow *m;
    assert_non_null(wfMeasureAt(0));
    assert_null(wfMeasureAt(-1));
    for (int i = 0; (m = wfMeasureAt(i)) != NULL; i++) {
        assert_ptr_equal(wfFindMeasurement(m->name), m);  /* so the name is unique, too */
        assert_true(strlen(m->text) > 0);
    }
    assert_null(wfFindMeasurement("no such thing"));
    assert_true(wfMeasurementIsTimed("broad-time"));
    assert_false(wfMeasurementIsTimed("broad"));
    assert_false(wfMeasurementIsTimed("-time"));
    assert_false(wfMeasurementIsTimed("overtime"));
}

TEST(the_list_is_measured)
{
    char text[512] = "", want[512];
    FILE *out = tmpfile();
    assert_non_null(out);
    assert_int_equal(wfFindMeasurement("design-list")->run(out), 0);
    rewind(out);
    size_t n = fread(text, 1, sizeof text - 1, out);
    text[n] = 0;
    fclose(out);
    size_t c = sizeof(wfDrawCommand);
    snprintf(want, sizeof want, "command,bytes\npoint,%zu\nline,%zu\ncircle,%zu\npolygon of 4 corners,%zu\ntext of 10 letters,%zu\n",
             c + 8, c + 16, c + 8, c + 32, c + 8 + 16);
    assert_string_equal(text, want);
}
