/* ends.h: worlds whose settings are at the ends of their ranges, or next to them; no test framework. Used by test_save_and_replay_ends.c,
 * which steps them under the sanitizers, and by portability/ends.c, whose hashes are compared between platforms. */
#ifndef WEFT_TEST_ENDS_H
#define WEFT_TEST_ENDS_H
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "weft/weft.h"

enum { ENDS_VALUES = 16, ENDS_PAIRS = 600 };

/* Which values of a setting are tried; returns how many. Numbers of passes, and of places, are allowed beyond all time and memory: 300 here. */
static inline int ends_values(const wfSetting *s, double value[ENDS_VALUES])
{
    double most = s->kind == WF_SETTING_INT && s->most > 300 ? 300 : s->most;
    if (s->kind == WF_SETTING_SET) return 0;
    if (s->kind == WF_SETTING_ROW || s->kind == WF_SETTING_CHOICE) {
        int n = 0;
        while (n < ENDS_VALUES && wfSettingRowName(s, n) != NULL) value[n] = n, n++;
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

/* One world more of those that are tried, and what it is called; false: there are no more. `next` begins at { 0 }. First each setting
 * alone, then random pairs, the same in every run. */
typedef struct EndsNext { int setting, value, pair; wfRandom random; } EndsNext;
static inline bool ends_put(wfWorldDef *def, int setting, int i, char *name, size_t size)
{
    double value[ENDS_VALUES];
    const wfSetting *s = &wfSettingTable[setting];
    int n = ends_values(s, value);
    if (n == 0) return true;
    size_t used = strlen(name);
    snprintf(name + used, size - used, "%s%s = %.17g", used ? "; " : "", s->name, value[i % n]);
    return wfPutSetting(def, s, 0, value[i % n]) == WF_OK && (s->kind != WF_SETTING_VEC2 || wfPutSetting(def, s, 1, -value[i % n]) == WF_OK);
}
static inline bool ends_next(EndsNext *next, wfWorldDef *def, char *name, size_t size)
{
    double value[ENDS_VALUES];
    *def = wfDefaultWorldDef();
    name[0] = 0;
    while (next->setting < wfSettingCount && next->value >= ends_values(&wfSettingTable[next->setting], value)) next->setting++, next->value = 0;
    if (next->setting < wfSettingCount) return ends_put(def, next->setting, next->value++, name, size);
    if (next->pair == 0) wfRandomSeed(&next->random, 23);
    if (next->pair++ >= ENDS_PAIRS) return false;
    bool good = true;
    for (int k = 0; k < 2; k++) {
        int setting = (int)wfRandomBelow(&next->random, (uint32_t)wfSettingCount);
        good = good && ends_put(def, setting, (int)wfRandomBelow(&next->random, 1000), name, size);
    }
    return good;
}

static inline wfResult ends_add(wfWorld *w, wfBodyDef def, wfBodyType type, wfVec2 at, wfReal radius, wfBodyId *id)
{
    def.type = type, def.position = at;
    if (type == WF_STATIC) wfMakeBox(50, 1, &def.shape);
    else wfMakeCircle(wfV2(0, 0), radius, &def.shape);
    return wfAddBodyToWorld(w, &def, id);
}

/* A floor, a heap of two, a pendulum, a bullet and a wind. */
static inline wfResult ends_fill(wfWorld *w)
{
    wfBodyId ground, bob;
    wfBodyDef def = wfDefaultBodyDef(), bouncy = def, fast = def;
    bouncy.restitution = WF_R(0.5), fast.velocity = wfV2(900, -30);
    wfResult result = ends_add(w, def, WF_STATIC, wfV2(0, -1), 0, &ground);
    if (result == WF_OK) result = ends_add(w, bouncy, WF_DYNAMIC, wfV2(0, WF_R(0.49)), WF_R(0.5), NULL);
    if (result == WF_OK) result = ends_add(w, bouncy, WF_DYNAMIC, wfV2(0, WF_R(1.49)), WF_R(0.5), NULL);
    if (result == WF_OK) result = ends_add(w, def, WF_DYNAMIC, wfV2(5, 3), WF_R(0.2), &bob);
    wfJoint j;
    if (result == WF_OK) result = wfDefineJoint(w, "revolute", ground, bob, wfV2(4, 3), wfV2(4, 3), wfV2(1, 0), &j);
    if (result == WF_OK) result = wfAddJointToWorld(w, &j, NULL);
    if (result == WF_OK) result = ends_add(w, fast, WF_DYNAMIC, wfV2(-9, 2), WF_R(0.05), NULL);
    wfForce wind = wfWind(wfV2(3, 1), WF_R(0.1));
    return result == WF_OK ? wfAddForceToWorld(w, &wind, NULL) : result;
}
#endif
