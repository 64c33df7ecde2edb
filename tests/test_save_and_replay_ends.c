/* Settings at the ends of their ranges, and next to them: one by one, and in random pairs. Whatever may be set, a small world of
   everything steps or says why not, and keeps its rules. The sanitizers look on (tests/run unit_sanitized). */
#include <math.h>
#include "testing.h"
#include "world.h"
#include "weft/save.h"
#include "weft/world.h"

enum { STEPS = 12, PAIRS = 600 };

/* Numbers of passes, and of places, are allowed beyond all time and memory; a test asks for fewer. */
static double most_of(const wfSetting *s)
{
    bool counts = s->kind == WF_SETTING_INT;
    return counts && s->most > 300 ? 300 : s->most;
}

static int values_of(const wfSetting *s, double *value)
{
    double most = most_of(s);
    if (s->kind == WF_SETTING_SET) return 0;
    if (s->kind == WF_SETTING_ROW || s->kind == WF_SETTING_CHOICE) {
        int n = 0;
        while (n < 16 && wfSettingRowName(s, n) != NULL) value[n] = n, n++;
        return n;
    }
    if (s->kind != WF_SETTING_REAL && s->kind != WF_SETTING_VEC2) {
        value[0] = s->least + s->above, value[1] = fmin(value[0] + 1, most), value[2] = fmax(most - 1, value[0]), value[3] = most;
        return 4;
    }
    wfReal least = (wfReal)s->least, greatest = (wfReal)most;
#ifdef WF_DOUBLE
    wfReal above = nextafter(least, greatest), below = nextafter(greatest, least);
#else
    wfReal above = nextafterf(least, greatest), below = nextafterf(greatest, least);
#endif
    value[0] = (double)(s->above ? above : least), value[1] = (double)above, value[2] = (double)below, value[3] = (double)greatest;
    return 4;
}

static void put(wfWorldDef *def, const wfSetting *s, double value)
{
    assert_ok(wfPutSetting(def, s, 0, value));
    if (s->kind == WF_SETTING_VEC2) assert_ok(wfPutSetting(def, s, 1, -value));
}

/* A floor, a heap of two, a pendulum, a bullet, a sleeper and a wind. */
static wfResult fill(wfWorld *w)
{
    wfBodyId ground, bob;
    wfBodyDef def = floor_def();
    wfResult result = wfAddBodyToWorld(w, &def, &ground);
    def = ball_def(0, 0.49, 0.5), def.restitution = WF_R(0.5);
    if (result == WF_OK) result = wfAddBodyToWorld(w, &def, NULL);
    def.position.y += 1;
    if (result == WF_OK) result = wfAddBodyToWorld(w, &def, NULL);
    def = ball_def(5, 3, 0.2);
    if (result == WF_OK) result = wfAddBodyToWorld(w, &def, &bob);
    wfJoint j;
    if (result == WF_OK) result = wfJoinBodies(w, "revolute", ground, bob, wfV2(4, 3), wfV2(4, 3), wfV2(1, 0), &j);
    if (result == WF_OK) result = wfAddJointToWorld(w, &j, NULL);
    def = ball_def(-9, 2, 0.05), def.velocity = wfV2(900, -30);
    return result == WF_OK ? wfAddBodyToWorld(w, &def, NULL) : result;
}

/* true: the world was made and has stepped to the end. */
static bool play(const wfWorldDef *def, const char *what)
{
    wfWorld w;
    const wfSetting *fault = NULL;
    wfResult result = wfCheckWorldDef(def, &fault);
    if (result != WF_OK) {
        if (fault == NULL) fail_msg("%s: refused (%s), and no setting is at fault", what, wfResultName(result));
        return false;
    }
    result = wfCreateWorld(def, &w);
    if (result != WF_OK) {
        assert_true(result == WF_ERROR_MEMORY || result == WF_ERROR_RANGE);
        return false;
    }
    result = fill(&w);
    for (int k = 0; k < STEPS && result == WF_OK; k++) result = wfStepWorld(&w);
    wfFault broken;
    if (wfCheckWorld(&w, &broken) != WF_OK) fail_msg("%s: %s[%d]: %s", what, broken.region, (int)broken.element, broken.rule);
    assert_ok(wfDestroyWorld(&w));
    return result == WF_OK;
}

static void every_setting_at_its_ends(void **state)
{
    (void)state;
    int played = 0, all = 0;
    for (int i = 0; i < wfSettingCount; i++) {
        double value[16];
        int n = values_of(&wfSettingTable[i], value);
        for (int k = 0; k < n; k++) {
            char what[100];
            wfWorldDef def = wfDefaultWorldDef();
            snprintf(what, sizeof what, "%s = %g", wfSettingTable[i].name, value[k]);
            put(&def, &wfSettingTable[i], value[k]);
            all++, played += play(&def, what);
        }
    }
    assert_true(all > 100 && played > all / 2);
}

static void random_pairs_of_settings_at_their_ends(void **state)
{
    (void)state;
    wfRandom r = random_stream(23);
    int played = 0;
    for (int round = 0; round < PAIRS; round++) {
        wfWorldDef def = wfDefaultWorldDef();
        char what[200] = "";
        for (int k = 0; k < 2; k++) {
            double value[16];
            const wfSetting *s = &wfSettingTable[(int)wfRandomReal(&r, 0, (wfReal)wfSettingCount - WF_R(0.01))];
            int n = values_of(s, value);
            if (n == 0) continue;
            double v = value[(int)wfRandomReal(&r, 0, (wfReal)n - WF_R(0.01))];
            put(&def, s, v);
            snprintf(what + strlen(what), sizeof what - strlen(what), "%s = %g; ", s->name, v);
        }
        played += play(&def, what);
    }
    assert_true(played > PAIRS / 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = { cmocka_unit_test(every_setting_at_its_ends), cmocka_unit_test(random_pairs_of_settings_at_their_ends) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
