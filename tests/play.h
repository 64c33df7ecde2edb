/* play.h: plays the testbed without a window, for tests: input scripts in, words and pixels out. */
#ifndef WEFT_TESTS_PLAY_H
#define WEFT_TESTS_PLAY_H
#include "testing.h"
#include "testbed/platform.h"

/* in: of the next frame, for those who give frames one by one and not by a script. sparing: of a long wait each eighth picture is drawn,
   and the last two, where a test is not about pictures. */
typedef struct play { game_memory memory; frame_buffer buffer; game_file file; game_input in; bool sparing; char text[32768]; } play;

static inline play play_open(int width, int height, float scale)
{
    play p = { .memory = { .permanent = calloc(1, GAME_PERMANENT_SIZE), .permanent_size = GAME_PERMANENT_SIZE,
                           .transient = calloc(1, GAME_TRANSIENT_SIZE), .transient_size = GAME_TRANSIENT_SIZE },
               .buffer = { calloc((size_t)(width * height), 4), width, height, width, scale } };
    assert_true(p.memory.permanent && p.memory.transient && p.buffer.pixels);
    return p;
}

static inline void play_end(play *p)
{
    free(p->memory.permanent);
    free(p->memory.transient);
    free(p->buffer.pixels);
    free(p->file.bytes);
}

static inline void play_run(play *p, const char *script)
{
    input_script s;
    game_input in;
    frame_buffer unseen = p->buffer;
    unseen.pixels = NULL;
    input_script_open(&s, script);
    int got;
    while ((got = input_script_next(&s, &in)) == 1)
        game_update_and_render(&p->memory, &in, p->sparing && s.waiting >= 2 && s.waiting % 8 != 0 ? &unseen : &p->buffer);
    if (got < 0) fail_msg("line %d of '%s': %s", (int)s.line, script, s.error);
    size_t n = game_describe(&p->memory, p->text, sizeof p->text);
    assert_true(n < sizeof p->text);
}

/* The line that begins with these words, or NULL. */
static inline const char *play_line(const play *p, const char *label)
{
    size_t length = strlen(label);
    for (const char *line = p->text; line; line = strchr(line, '\n') ? strchr(line, '\n') + 1 : NULL)
        if (strncmp(line, label, length) == 0 && (line[length] == ' ' || line[length] == '\n')) return line;
    return NULL;
}

/* The n-th number of that line. */
static inline double play_fact(const play *p, const char *label, int n)
{
    const char *at = play_line(p, label);
    if (!at) fail_msg("nothing is said of '%s' in\n%s", label, p->text);
    for (int k = 0, first = 1; ; k++, first = 0) {
        if (first) at += strlen(label);
        while (*at && *at != '\n' && !strchr("-0123456789", *at)) at++;
        if (!*at || *at == '\n') break;
        char *after;
        double x = strtod(at, &after);
        if (k == n) return x;
        at = after > at ? after : at + 1;
    }
    fail_msg("'%s' has no number %d in\n%s", label, n, p->text);
    return 0;
}

static inline void play_click(play *p, const char *widget)
{
    char label[128], script[200];
    snprintf(label, sizeof label, "widget %s pixel", widget);
    snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\nclick left\nframe\n", play_fact(p, label, 0), play_fact(p, label, 1));
    play_run(p, script);
}

/* A choice among names: opens its list and takes a row. */
static inline void play_choose(play *p, const char *choice, const char *row)
{
    play_click(p, choice);
    play_click(p, row);
}

/* Clicks a number, lets the mouse rest there, and types. */
static inline void play_type(play *p, const char *widget, const char *keys)
{
    char label[80], script[300];
    snprintf(label, sizeof label, "widget %s pixel", widget);
    snprintf(script, sizeof script, "steps 0\nmove %g %g\nframe\nclick left\nframe\nframe\n%s\nframe\nframe\n",
             play_fact(p, label, 0), play_fact(p, label, 1), keys);
    play_run(p, script);
}

/* Does a line say exactly this? */
static inline int play_says(const play *p, const char *line)
{
    char with[300];
    snprintf(with, sizeof with, "\n%s\n", line);
    return strstr(p->text, with) != NULL;
}
#endif
