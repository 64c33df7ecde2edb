/* Words that were renamed, in scenes as text. Oracle: the same scene in the new words, read and written. */
#include "testing.h"
#include "world.h"
#include "weft/json.h"
#include "weft/weft.h"
#include <cjson/cJSON.h>
#include "json/scene.h"

static const char now[] =
    "{ \"weft\": 1, \"modules\": [\"shapes\", \"contacts\", \"friction\", \"restitution\", \"rolling\", \"rotation\", \"materials\","
    " \"events\", \"joints\", \"fast\", \"sleep\", \"substeps\", \"queries\"],"
    " \"settings\": { \"timeStep\": 0.02, \"restitutionThreshold\": 3, \"positionCorrection\": 0.3, \"reuseManifolds\": false,"
    " \"contactDampingRatio\": 4, \"contactPushSpeed\": 20, \"graphColouring\": false, \"enableSimd\": false, \"stackSolver\": 2,"
    " \"frictionRule\": \"maximum\", \"restitutionRule\": \"minimum\", \"rollingRule\": \"minimum\", \"hitThreshold\": 5,"
    " \"materialPairCapacity\": 7, \"compensatedSums\": true, \"directJoints\": \"CHOICE\", \"directJointCost\": 3, \"jointCompliance\": 0.5,"
    " \"maxImpacts\": 9, \"timeToSleep\": 0.25, \"sleepThreshold\": 0.125 },"
    " \"bodies\": [ { \"type\": \"dynamic\", \"shapes\": [ { \"kind\": \"circle\", \"radius\": 1, \"rollingResistance\": 0.5,"
    " \"tangentSpeed\": 2 } ] } ], \"pairMaterials\": [ { \"a\": 1, \"b\": 2, \"rollingResistance\": 0.25 } ] }";

/* `text` with every "word" of the one column written as that of the other; how many there were. */
static int exchanged(const char *text, const char *word, const char *by, char *out)
{
    int count = 0;
    size_t length = strlen(word);
    while (*text != 0) {
        if (*text == '"' && strncmp(text + 1, word, length) == 0 && text[1 + length] == '"') {
            out += sprintf(out, "\"%s\"", by);
            text += length + 2;
            count++;
        } else *out++ = *text++;
    }
    *out = 0;
    return count;
}

/* The text of the world that a text makes. */
static char *read_and_written(const char *text)
{
    wfWorld world;
    wfTextError e;
    char *out = NULL;
    if (wfReadScene(text, strlen(text), NULL, &world, NULL, &e) != WF_OK)
        fail_msg("%s, line %d: %s\n%s", e.where, (int)e.line, e.what, text);
    assert_ok(wfWriteScene(&world, NULL, &out));
    wfDestroyWorld(&world);
    return out;
}

TEST(old_words_are_read)
{
    static const char *const choices[] = { "iterative", "direct" };
    for (int c = 0; c < 2; c++) {
        char text[4000], old[4000];
        assert_int_equal(exchanged(now, "CHOICE", choices[c], text), 1);
        char *want = read_and_written(text);
        const char *was, *is;
        int words = 0;
        for (int i = 0; (was = wfOldWord(i, &is)) != NULL; i++) {
            int times = exchanged(text, is, was, old);
            bool other = strcmp(is, choices[1 - c]) == 0;
            assert_true(other ? times == 0 : times >= 1);              /* the scene has every word but one */
            words += times > 0;
            char *got = read_and_written(old);
            assert_string_equal(got, want);                            /* the new word is written */
            wfFreeText(got);
        }
        assert_int_equal(words, 25);
        wfFreeText(want);
    }
}

TEST(who_says_both_says_it_twice)
{
    static const char *const texts[] = { "{ \"weft\": 1, \"needs\": [], \"modules\": [] }",
                                         "{ \"weft\": 1, \"settings\": { \"dt\": 0.1, \"timeStep\": 0.1 } }",
                                         "{ \"weft\": 1, \"settings\": { \"timeStep\": 0.1, \"dt\": 0.1 } }",
                                         "{ \"weft\": 1, \"settings\": { \"dt\": 0.1, \"dt\": 0.1 } }" };
    for (size_t i = 0; i < sizeof texts / sizeof *texts; i++) {
        wfWorld world;
        wfTextError e;
        assert_int_equal(wfReadScene(texts[i], strlen(texts[i]), NULL, &world, NULL, &e), WF_ERROR_TEXT);
        assert_string_equal(e.what, "is there twice");
    }
}

TEST(room_for_materials_is_held_to)
{
    static const char *const words[] = { "materialPairCapacity", "pairMaterials" };
    for (int i = 0; i < 2; i++) {
        char text[400];
        snprintf(text, sizeof text, "{ \"weft\": 1, \"settings\": { \"%s\": 1 }, \"pairMaterials\": [ { \"a\": 1, \"b\": 2 }, { \"a\": 1, \"b\": 3 } ] }", words[i]);
        wfWorld world;
        wfTextError e;
        assert_int_equal(wfReadScene(text, strlen(text), NULL, &world, NULL, &e), WF_ERROR_FULL);
        assert_memory_equal(e.where, "settings.", 9);
        assert_string_equal(e.where + 9, words[i]);
    }
}

TEST(errors_name_the_word_that_was_said)
{
    const char *text = "{ \"weft\": 1, \"settings\": { \"dt\": 0 } }";
    wfWorld world;
    wfTextError e;
    assert_int_equal(wfReadScene(text, strlen(text), NULL, &world, NULL, &e), WF_ERROR_RANGE);
    assert_string_equal(e.where, "settings.dt");
}

TEST(a_body_that_is_taken_out_and_data_of_a_joint_are_kept)
{
    static const char text[] = "{ \"weft\": 1, \"bodies\": ["
        " { \"disabled\": true, \"velocity\": [3, 4], \"shapes\": [ { \"kind\": \"circle\", \"radius\": 1 } ] },"
        " { \"position\": [5, 0], \"shapes\": [ { \"kind\": \"circle\", \"radius\": 1 } ] } ],"
        " \"joints\": [ { \"kind\": \"distance\", \"a\": 0, \"b\": 1, \"userData\": 77 } ] }";
    wfWorld world;
    wfJoint j;
    char *first = read_and_written(text), *second = read_and_written(first);
    assert_string_equal(first, second);
    assert_ok(wfReadScene(first, strlen(first), NULL, &world, NULL, NULL));
    assert_false(wfBodyIsEnabled(&world, wfBodyAt(&world, 0)));
    assert_true(wfBodyIsEnabled(&world, wfBodyAt(&world, 1)));
    for (int i = 0; i < 30; i++) assert_ok(wfStepWorld(&world));
    assert_true(info(&world, wfBodyAt(&world, 0)).position.x == 0 && info(&world, wfBodyAt(&world, 0)).velocity.x == 3);
    assert_ok(wfGetJoint(&world, wfJointAt(&world, 0), &j));
    assert_int_equal(j.userData, 77);
    wfDestroyWorld(&world);
    wfFreeText(first);
    wfFreeText(second);
}
