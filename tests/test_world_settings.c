/* The table of settings: every field of wfWorldDef has one row, and the row is true. */
#include "testing.h"
#include "world.h"

static size_t bytes_of(const wfSetting *s)
{
    if (s->kind == WF_SETTING_VEC2) return sizeof(wfVec2);
    return s->kind == WF_SETTING_REAL ? sizeof(wfReal) : sizeof(int32_t);
}

/* Bytes that belong to no row can only be a hole before a field that is aligned to more than four bytes. */
TEST(every_byte_of_a_definition_has_a_row)
{
    unsigned char marks[sizeof(wfWorldDef)] = { 0 };
    for (int i = 0; i < wfSettingCount; i++)
        for (size_t k = 0; k < bytes_of(&wfSettingTable[i]); k++) marks[wfSettingTable[i].offset + k]++;
    for (size_t at = 0; at < offsetof(wfWorldDef, memory); at++) {
        size_t next = at;
        while (next < offsetof(wfWorldDef, memory) && marks[next] == 0) next++;
        size_t wide = next == offsetof(wfWorldDef, memory) ? _Alignof(wfMemory) : sizeof(wfReal);
        if (marks[at] == 0) assert_true(wide > 4 && at % 4 == 0 && next - at <= 4 && next % wide == 0);
        else assert_int_equal(marks[at], 1);
        if (marks[at] == 0) at = next - 1;
    }
    for (size_t at = offsetof(wfWorldDef, memory); at < sizeof marks; at++) assert_int_equal(marks[at], 0);
}

TEST(names_find_rows)
{
    for (int i = 0; i < wfSettingCount; i++) {
        const wfSetting *s = &wfSettingTable[i];
        assert_ptr_equal(wfFindSetting(s->name), s);      /* so names are unique, too */
        assert_true(s->text != NULL && s->text[0] != 0 && strlen(s->text) < 80);
        bool named = s->kind == WF_SETTING_ROW || s->kind == WF_SETTING_CHOICE || s->kind == WF_SETTING_SET;
        assert_true(named == (wfSettingRowName(s, 0) != NULL));
        for (int row = 0; named && row < *s->rowCount; row++)
            assert_int_equal(wfFindSettingRow(s, wfSettingRowName(s, row)), row);
        assert_null(wfSettingRowName(s, -1));
        assert_null(wfSettingRowName(s, named ? *s->rowCount : 0));
        assert_int_equal(wfFindSettingRow(s, "no such row"), -1);
    }
    assert_null(wfFindSetting("no such setting"));
    assert_null(wfFindSetting(NULL));
    assert_null(wfSettingRowName(NULL, 0));
    assert_int_equal(wfFindSettingRow(wfFindSetting("solver"), NULL), -1);
    const wfSetting *solver = wfFindSetting("solver");
    assert_int_equal(wfFindSettingRow(solver, "soft"), wfFindSolver("soft"));
    assert_string_equal(wfSettingRowName(wfFindSetting("narrowPhase"), wfFindNarrowPhase("gjk")), "gjk");
}

/* What is at the ends of a range: the numbers that must be taken. Capacities at their end need more memory than there is. */
static int good_values(const wfSetting *s, double out[3])
{
    int n = 0;
    if (s->kind == WF_SETTING_ROW || s->kind == WF_SETTING_CHOICE) {
        out[n++] = 0, out[n++] = *s->rowCount - 1;
        return n;
    }
    bool real = s->kind == WF_SETTING_REAL || s->kind == WF_SETTING_VEC2;
    if (!s->above) out[n++] = s->least;
    else out[n++] = s->least + 0.25;
    out[n++] = s->most < 1000 ? s->most : s->least > 0 ? s->least + 3 : 7;
    if (real) out[n++] = s->most < 1000 ? (s->least + s->most) / 2 : 1234.5;
    return n;
}

static int bad_values(const wfSetting *s, double out[4])
{
    int n = 0;
    if (s->kind == WF_SETTING_ROW || s->kind == WF_SETTING_CHOICE) {
        out[n++] = -1, out[n++] = *s->rowCount, out[n++] = 0.5;
        return n;
    }
    bool whole = s->kind == WF_SETTING_INT || s->kind == WF_SETTING_SWITCH;
    if (s->above) out[n++] = s->least;
    if (s->least > -1e30) out[n++] = s->least - 1;
    if (s->most < 1e30) out[n++] = s->most + 1;
    if (whole) out[n++] = s->least + 0.5;
    return n;
}

/* A definition that differs from the default in one setting is created, and says so when it is asked. */
TEST(every_good_value_is_kept)
{
    for (int i = 0; i < wfSettingCount; i++) {
        const wfSetting *s = &wfSettingTable[i];
        if (s->kind == WF_SETTING_SET) continue;                /* tests/test_modules.c */
        double good[3];
        int count = good_values(s, good);
        for (int k = 0; k < count; k++)
            for (int part = 0; part < (s->kind == WF_SETTING_VEC2 ? 2 : 1); part++) {
                wfWorldDef def = wfDefaultWorldDef(), got;
                if (s->kind == WF_SETTING_VEC2 && fabs(good[k]) > 1e30) continue;
                def.bodyCapacity = 20;
                assert_ok(wfPutSetting(&def, s, part, good[k]));
                assert_near(wfSettingValue(&def, s, part), (double)(wfReal)good[k], 0);
                wfWorld world = world_with(&def);
                assert_ok(wfGetWorldDef(&world, &got));
                bool chosen = good[k] == 0 && strstr(s->name, "Capacity") != NULL;
                if (!chosen) assert_near(wfSettingValue(&got, s, part), wfSettingValue(&def, s, part), 0);
                for (int n = 0; n < wfSettingCount; n++)       /* and nothing else has changed */
                    if (n != i && strstr(wfSettingTable[n].name, "Capacity") == NULL)
                        for (int p = 0; p < 2; p++)
                            assert_near(wfSettingValue(&got, &wfSettingTable[n], p), wfSettingValue(&def, &wfSettingTable[n], p), 0);
                wfDestroyWorld(&world);
            }
    }
}

TEST(every_bad_value_is_refused_by_name)
{
    const wfSetting *fault;
    for (int i = 0; i < wfSettingCount; i++) {
        const wfSetting *s = &wfSettingTable[i];
        if (s->kind == WF_SETTING_SET) continue;                /* tests/test_modules.c */
        bool real = s->kind == WF_SETTING_REAL || s->kind == WF_SETTING_VEC2;
        double bad[4];
        int count = bad_values(s, bad);
        for (int k = 0; k < count; k++) {
            wfWorldDef def = wfDefaultWorldDef(), before = def;
            bool part = bad[k] < 0.75 && bad[k] > 0.25 && !real;
            wfResult want = s->kind == WF_SETTING_ROW && !part ? WF_ERROR_UNKNOWN : WF_ERROR_RANGE;
            assert_result(want, wfPutSetting(&def, s, 0, bad[k]));
            assert_memory_equal(&def, &before, sizeof def);
            if (!real && bad[k] != floor(bad[k])) continue;
            wfReal number = (wfReal)bad[k];                    /* past the guard, into the field */
            int32_t whole = (int32_t)bad[k];
            if (real) memcpy((char *)&def + s->offset, &number, sizeof number);
            else memcpy((char *)&def + s->offset, &whole, sizeof whole);
            assert_result(want, wfCheckWorldDef(&def, &fault));
            assert_ptr_equal(fault, s);
            wfWorld world;
            assert_result(want, wfCreateWorld(&def, &world));
        }
        for (int k = 0; k < BAD_REAL_COUNT; k++) {
            wfWorldDef def = wfDefaultWorldDef();
            assert_result(WF_ERROR_NOT_FINITE, wfPutSetting(&def, s, 0, (double)BAD_REALS[k]));
            if (!real) continue;
            for (int part = 0; part < (s->kind == WF_SETTING_VEC2 ? 2 : 1); part++) {
                def = wfDefaultWorldDef();
                memcpy((char *)&def + s->offset + (size_t)part * sizeof(wfReal), &BAD_REALS[k], sizeof(wfReal));
                assert_result(WF_ERROR_NOT_FINITE, wfCheckWorldDef(&def, &fault));
                assert_ptr_equal(fault, s);
            }
        }
    }
}

TEST(what_cannot_be_asked_is_refused)
{
    wfWorldDef def = wfDefaultWorldDef();
    const wfSetting *fault = &wfSettingTable[0], *dt = wfFindSetting("timeStep");
    assert_result(WF_ERROR_NULL, wfCheckWorldDef(NULL, &fault));
    assert_null(fault);
    fault = dt;
    assert_ok(wfCheckWorldDef(&def, &fault));
    assert_null(fault);
    assert_ok(wfCheckWorldDef(&def, NULL));
    assert_result(WF_ERROR_NULL, wfPutSetting(NULL, dt, 0, 1));
    assert_result(WF_ERROR_NULL, wfPutSetting(&def, NULL, 0, 1));
    assert_result(WF_ERROR_UNKNOWN, wfPutSetting(&def, dt, 1, 1));
    assert_result(WF_ERROR_UNKNOWN, wfPutSetting(&def, dt, -1, 1));
    assert_near(wfSettingValue(&def, wfFindSetting("gravity"), 1), (double)WF_R(-9.81), 0);
    assert_near(wfSettingValue(NULL, dt, 0) + wfSettingValue(&def, NULL, 0) + wfSettingValue(&def, dt, 1), 0, 0);
    if (sizeof(wfReal) == 4) assert_result(WF_ERROR_RANGE, wfPutSetting(&def, dt, 0, 1e-60));     /* a float makes it 0 */
    if (sizeof(wfReal) == 4) assert_result(WF_ERROR_RANGE, wfPutSetting(&def, dt, 0, 1e60));
    assert_result(WF_ERROR_RANGE, wfPutSetting(&def, wfFindSetting("iterations"), 0, 1e10));
    assert_ok(wfCheckWorldDef(&def, NULL));
}

/* What is built in does not change, and who tries hears it; all else changes. */
TEST(settings_change_unless_they_are_built_in)
{
    for (int i = 0; i < wfSettingCount; i++) {
        const wfSetting *s = &wfSettingTable[i];
        if (s->kind == WF_SETTING_SET) continue;                /* tests/test_modules.c */
        wfWorldDef def = wfDefaultWorldDef(), is, got;
        def.bodyCapacity = 20;
        wfWorld world = world_with(&def);
        assert_ok(wfGetWorldDef(&world, &is));
        def = is;
        double good[3], was = wfSettingValue(&is, s, 0);
        int count = good_values(s, good);
        for (int k = 0; k < count; k++) {
            if (good[k] == was || (s->builtIn && good[k] == 0) || fabs(good[k]) > 1e30) continue;
            def = is;
            assert_ok(wfPutSetting(&def, s, 0, good[k]));
            wfResult result = wfSetWorldDef(&world, &def);
            bool room = strcmp(s->name, "solver") == 0 || strcmp(s->name, "directJoints") == 0;
            assert_ok(wfGetWorldDef(&world, &got));
            if (s->builtIn) assert_result(WF_ERROR_BUILT_IN, result);
            else if (!room || result != WF_ERROR_MEMORY) assert_result(WF_OK, result);
            assert_near(wfSettingValue(&got, s, 0), result == WF_OK ? wfSettingValue(&def, s, 0) : wfSettingValue(&is, s, 0), 0);
            assert_ok(wfSetWorldDef(&world, &is));
        }
        wfDestroyWorld(&world);
    }
}
