/* Exercise save-delay. Oracle: a referee who knows every input in time. */
#include "course.h"
enum { EX_BACK = 16, EX_BYTES = 256 };
typedef void ExStepFn(void *state, const int32_t input[2]);
typedef struct ExMatch { ExStepFn *step; size_t size; int32_t now; _Alignas(16) uint8_t state[EX_BYTES]; _Alignas(16) uint8_t before[EX_BACK][EX_BYTES]; int32_t input[EX_BACK][2]; } ExMatch;
void exAdvance(ExMatch *m, int player, int32_t own);
#define exAdvance(m, player, own) done(exAdvance(m, player, own), none_left)
bool exArrive(ExMatch *m, int player, int32_t step, int32_t input);
#define exArrive(m, player, step, input) asked(exArrive(m, player, step, input))
static int steps_made;
typedef struct Toy { uint64_t mixed; int32_t x[2], v[2]; } Toy;
static void toy_step(void *state, const int32_t input[2])
{
    Toy *t = state;
    for (int i = 0; i < 2; i++) t->v[i] += input[i] - t->v[i] / 8, t->x[i] += t->v[i];
    if (abs(t->x[0] - t->x[1]) < 20) { int32_t v = t->v[0]; t->v[0] = t->v[1]; t->v[1] = v; }
    t->mixed = wfHashU64(t->mixed, (uint64_t)(uint32_t)t->x[0] << 32 | (uint32_t)t->x[1]);
    steps_made++;
}
static void begin(ExMatch *m) { memset(m, 0, sizeof *m); m->step = toy_step; m->size = sizeof(Toy); ((Toy *)(void *)m->state)->x[1] = 100; }
static void agree(void)
{
    static ExMatch m[2], referee;
    static int32_t input[400][2];
    for (int delay = 1; delay <= 8; delay++) {
        wfRandom r = course_random((uint64_t)delay);
        begin(&m[0]), begin(&m[1]), begin(&referee);
        for (int s = 0; s < 400; s++) {
            for (int p = 0; p < 2; p++) input[s][p] = s < 380 ? (int32_t)wfRandomBelow(&r, 7) - 3 : 0;
            int32_t k = referee.now++;
            (void)k;
            toy_step(referee.state, input[s]);
            for (int p = 0; p < 2; p++) {
                exAdvance(&m[p], p, input[s][p]);
                if (s >= delay) expect_true("an input within reach is taken", exArrive(&m[p], 1 - p, s - delay, input[s - delay][1 - p]));
            }
        }
        for (int p = 0; p < 2; p++) {
            done((void)0, left_many(m[p].state, sizeof(Toy)));
            expect_true(say("player %d's state is the referee's, delay %d", p, delay), memcmp(m[p].state, referee.state, sizeof(Toy)) == 0);
        }
    }
}
static void guess(void)
{
    static ExMatch m;
    begin(&m);
    for (int s = 0; s < 10; s++) exAdvance(&m, 0, 1);
    steps_made = 0;
    exArrive(&m, 1, 4, 0);
    done((void)0, left(steps_made));
    expect_int("steps made again for an input that was guessed rightly", steps_made, 0);
    exArrive(&m, 1, 4, 2);
    done((void)0, left(steps_made));
    expect_int("steps made again for step 4 of 10", steps_made, 6);
}
static void late(void)
{
    static ExMatch m, copy;
    begin(&m);
    for (int s = 0; s < 40; s++) exAdvance(&m, 0, s % 3);
    done((void)0, left(m));
    copy = m;
    expect_false("an input for step 20 of 40 is taken, of which 16 are kept", exArrive(&m, 1, 20, 5));
    done((void)0, left(m));
    expect_true("nothing has changed after it", memcmp(&copy, &m, sizeof m) == 0);
    expect_true("an input for step 24 is taken", exArrive(&m, 1, 24, 5));
}
CRITERIA("rollback",
    { "agree", 3, "rollback: put the input in its place and make the steps again", "both machines agree with the referee, for delays of 1 to 8", agree, 0 },
    { "guess", 1, "rollback: put the input in its place and make the steps again", "a right guess costs nothing", guess, 0 },
    { "late", 1, "rollback: put the input in its place and make the steps again", "what comes too late changes nothing", late, 0 })
