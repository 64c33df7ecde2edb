/* Settings at the ends of their ranges, and next to them: one by one, and in random pairs (ends.h). Whatever may be set, a small world of
   everything steps or says why not, and keeps its rules. The sanitizers look on (tests/run unit_sanitized), and make portability-ends
   compares the bits of these worlds between processors. */
#include "testing.h"
#include "ends.h"
#include "weft/save.h"

enum { STEPS = 12 };

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
    result = ends_fill(&w);
    for (int k = 0; k < STEPS && result == WF_OK; k++) result = wfStepWorld(&w);
    wfFault broken;
    if (wfCheckWorld(&w, &broken) != WF_OK) fail_msg("%s: %s[%d]: %s", what, broken.region, (int)broken.element, broken.rule);
    assert_ok(wfDestroyWorld(&w));
    return result == WF_OK;
}

TEST(settings_at_their_ends)
{
    wfWorldDef def;
    EndsNext next = { 0 };
    char what[200];
    int alone[2] = { 0 }, pairs[2] = { 0 };                 /* all, and those that were played to the end */
    while (ends_next(&next, &def, what, sizeof what)) {
        int *count = next.pair > 0 ? pairs : alone;
        count[0]++, count[1] += play(&def, what);
    }
    assert_int_equal(pairs[0], ENDS_PAIRS);                 /* every value could be put in its place */
    assert_true(alone[0] > 100 && alone[1] > alone[0] / 2 && pairs[1] > pairs[0] / 3);
}
