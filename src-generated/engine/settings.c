/* Weft: engine/settings.c, tangled from chapters/engine/20-world.nw. Chapters that add to it:
 * bodies-in-a-world, step, joints-in-a-world, continuous-collision, sleep-in-a-world. Do not edit
 * this file: edit the chapter and type make. MIT licence. */
#include <stddef.h>
#include <string.h>
#include "engine/block.h"

/* How a row of the table is written. */
#define WF_SETTING(field) .name = #field, .offset = offsetof(wfWorldDef, field), \
    .kept = offsetof(wfHeader, field)
#define WF_COUNTED .kind = WF_SETTING_INT
#define WF_REAL .kind = WF_SETTING_REAL
#define WF_SWITCH .kind = WF_SETTING_SWITCH, .most = 1
#define WF_BETWEEN(a, b) .least = (a), .most = (b)
#define WF_FROM(a) .least = (a), .most = (double)WF_HUGE
#define WF_ABOVE(a) WF_FROM(a), .above = 1
#define WF_ANY WF_FROM(-(double)WF_HUGE)
#define WF_CAPACITY(a) WF_BETWEEN(a, WF_MAX_CAPACITY), .builtIn = 1
#define WF_ROW(what) .kind = WF_SETTING_ROW, .rows = wf##what##Table, \
    .rowSize = sizeof *wf##what##Table, .rowCount = &wf##what##Count
#define WF_CHOICE(names) .kind = WF_SETTING_CHOICE, .rows = names, \
    .rowSize = sizeof *names, .rowCount = &names##Count

/* names of choices */
static const char *const wfExactNames[] = { "one-by-one", "together", "auto" };
static const int wfExactNamesCount = 3;

const wfSetting wfSettingTable[] = {
    { WF_SETTING(gravity), .kind = WF_SETTING_VEC2, WF_ANY, .law = 1, .unit = "m/s^2",
      .text = "acceleration of everything that has mass" },
    { WF_SETTING(dt), WF_REAL, WF_ABOVE(0), .unit = "s", .text = "length of a step" },
    { WF_SETTING(bodyCapacity), WF_COUNTED, WF_CAPACITY(1), .text = "bodies at most" },
    { WF_SETTING(integrator), WF_ROW(Integrator), .method = 1,
      .text = "moves the bodies" },
    { WF_SETTING(needs), .kind = WF_SETTING_SET, .rows = wfNeedTable,
      .rowSize = sizeof *wfNeedTable, .rowCount = &wfNeedCount, .most = UINT32_MAX,
      .builtIn = 1, .text = "what the scene requires" },
    { WF_SETTING(forceCapacity), WF_COUNTED, WF_CAPACITY(0),
      .need = WF_NEED_FORCES,
      .text = "registered forces at most" },
    { WF_SETTING(shapeCapacity), WF_COUNTED, WF_CAPACITY(0),
      .need = WF_NEED_SHAPES,
      .text = "shapes at most; 0: as many as bodies" },
    { WF_SETTING(pairCapacity), WF_COUNTED, WF_CAPACITY(0),
      .need = WF_NEED_CONTACTS,
      .text = "pairs in one step; 0: 16 a shape, or all there can be" },
    { WF_SETTING(contactCapacity), WF_COUNTED, WF_CAPACITY(0),
      .need = WF_NEED_CONTACTS,
      .text = "contacts in one step; 0: as many as pairs" },
    { WF_SETTING(broadPhase), WF_ROW(BroadPhase), .method = 1,
      .need = WF_NEED_CONTACTS | WF_NEED_QUERIES,
      .text = "finds pairs" },
    { WF_SETTING(narrowPhase), WF_ROW(NarrowPhase), .need = WF_NEED_CONTACTS | WF_NEED_QUERIES,
      .text = "separates shapes" },
    { WF_SETTING(solver), WF_ROW(Solver), .law = 1, .method = 1,
      .need = WF_NEED_CONTACTS | WF_NEED_SUBSTEPS,
      .text = "mends contacts" },
    { WF_SETTING(iterations), WF_COUNTED, WF_FROM(0), .law = 1,
      .need = WF_NEED_CONTACTS | WF_NEED_SUBSTEPS,
      .text = "passes of the contact solver; 0: as many as it wants" },
    { WF_SETTING(substeps), WF_COUNTED, WF_FROM(1), .law = 1,
      .need = WF_NEED_CONTACTS | WF_NEED_SUBSTEPS,
      .text = "of solvers that step by themselves" },
    { WF_SETTING(restingSteps), WF_REAL, WF_FROM(0), .law = 1, .unit = "steps of gravity",
      .need = WF_NEED_CONTACTS,
      .text = "approaches slower than so many rest" },
    { WF_SETTING(positionShare), WF_REAL, WF_BETWEEN(0, 1), .law = 1, .unit = "of the overlap",
      .need = WF_NEED_CONTACTS,
      .text = "removed in a step" },
    { WF_SETTING(slop), WF_REAL, WF_FROM(0), .law = 1, .unit = "of the smaller reach",
      .need = WF_NEED_CONTACTS,
      .text = "overlap that is left alone" },
    { WF_SETTING(reuse), WF_SWITCH, .need = WF_NEED_CONTACTS,
      .text = "contacts of pairs that hardly moved are kept" },
    { WF_SETTING(contactPeriod), WF_REAL, WF_ABOVE(0), .law = 1, .unit = "substeps",
      .need = WF_NEED_CONTACTS,
      .text = "period of a contact's spring" },
    { WF_SETTING(contactDamping), WF_REAL, WF_ABOVE(0), .law = 1,
      .need = WF_NEED_CONTACTS,
      .text = "damping ratio of a contact's spring" },
    { WF_SETTING(recoverySteps), WF_REAL, WF_FROM(0), .law = 1, .unit = "steps of gravity",
      .need = WF_NEED_CONTACTS,
      .text = "overlap is left no faster than that; 0 or no gravity: no limit" },
    { WF_SETTING(colours), WF_SWITCH, .need = WF_NEED_CONTACTS,
      .text = "contacts are solved by colours" },
    { WF_SETTING(lanes), WF_SWITCH, .need = WF_NEED_CONTACTS,
      .text = "and several at once, to the same bits" },
    { WF_SETTING(columns), WF_COUNTED, WF_BETWEEN(0, 1 + WF_COLUMN_LOOPS), .law = 1,
      .need = WF_NEED_CONTACTS,
      .text = "1: towers are solved at once; 1 + n: with up to n loops" },
    { WF_SETTING(frictionMix), WF_ROW(Mix), .law = 1, .need = WF_NEED_FRICTION,
      .text = "of two shapes' friction" },
    { WF_SETTING(restitutionMix), WF_ROW(Mix), .law = 1, .need = WF_NEED_RESTITUTION,
      .text = "of their restitution" },
    { WF_SETTING(rollingMix), WF_ROW(Mix), .law = 1, .need = WF_NEED_ROLLING,
      .text = "of their rolling resistance" },
    { WF_SETTING(events), WF_SWITCH, .builtIn = 1, .need = WF_NEED_CONTACTS,
      .text = "touches are remembered; told, if needed" },
    { WF_SETTING(hitSteps), WF_REAL, WF_FROM(0), .unit = "steps of gravity",
      .need = WF_NEED_EVENTS,
      .text = "approaches faster than so many are hits" },
    { WF_SETTING(queries), WF_SWITCH, .need = WF_NEED_QUERIES,
      .text = "queries are quick after every step" },
    { WF_SETTING(pairMaterials), WF_COUNTED, WF_CAPACITY(0),
      .need = WF_NEED_MATERIALS,
      .text = "pairs of materials that may be known" },
    { WF_SETTING(exactWork), WF_COUNTED, WF_FROM(0), .law = 1,
      .text = "the solver exact: millions of multiplications in a step, at most; 0: no bound" },
    { WF_SETTING(fineSums), WF_SWITCH, .builtIn = 1, .law = 1,
      .text = "what states round away is kept, by the solver soft" },
    { WF_SETTING(jointCapacity), WF_COUNTED, WF_CAPACITY(0), .need = WF_NEED_JOINTS,
      .text = "joints at most" },
    { WF_SETTING(exactJoints), WF_CHOICE(wfExactNames), .need = WF_NEED_JOINTS,
      .text = "joints solved together" },
    { WF_SETTING(exactCost), WF_REAL, WF_FROM(0),
      .need = WF_NEED_JOINTS,
      .text = "AUTO: products of blocks a joint, at most" },
    { WF_SETTING(jointGive), WF_REAL, WF_FROM(0),
      .need = WF_NEED_JOINTS,
      .text = "how much joints solved together give" },
    { WF_SETTING(impacts), WF_COUNTED, WF_BETWEEN(0, WF_MAX_CAPACITY),
      .need = WF_NEED_FAST,
      .text = "impacts of a fast body in a step, at most; 0: none is looked for" },
    { WF_SETTING(sleep), WF_SWITCH, .need = WF_NEED_SLEEP,
      .text = "islands that rest are left out of the step" },
    { WF_SETTING(sleepTime), WF_REAL, WF_ABOVE(0), .unit = "s",
      .need = WF_NEED_SLEEP,
      .text = "for so long all of an island must have been still" },
    { WF_SETTING(sleepShare), WF_REAL, WF_FROM(0), .unit = "of the reach",
      .need = WF_NEED_SLEEP,
      .text = "still is who goes less of its reach in that time" },
};
const int wfSettingCount = (int)(sizeof wfSettingTable / sizeof *wfSettingTable);

/* check numbers */
bool wfAllFinite(const wfReal *number, size_t count)
{
    for (size_t i = 0; i < count; i++)
        if (!wfIsFinite(number[i])) return false;
    return true;
}

/* read and write a setting */
const wfSetting *wfFindSetting(const char *name)
{
    for (int i = 0; name != NULL && i < wfSettingCount; i++)
        if (strcmp(wfSettingTable[i].name, name) == 0) return &wfSettingTable[i];
    return NULL;
}

const char *wfSettingRowName(const wfSetting *s, int row)
{
    if (s == NULL || s->rows == NULL || row < 0 || row >= *s->rowCount) return NULL;
    const uint8_t *at = s->rows;
    const char *name;
    memcpy(&name, at + (size_t)row * s->rowSize, sizeof name);
    return name;
}

int wfFindSettingRow(const wfSetting *s, const char *name)
{
    const char *is;
    for (int row = 0; name && (is = wfSettingRowName(s, row)) != NULL; row++)
        if (strcmp(is, name) == 0) return row;
    return -1;
}

static bool is_real(const wfSetting *s)
{
    return s->kind == WF_SETTING_REAL || s->kind == WF_SETTING_VEC2;
}

int wfSettingParts(const wfSetting *s) { return s->kind == WF_SETTING_VEC2 ? 2 : 1; }

double wfSettingValue(const wfWorldDef *def, const wfSetting *s, int part)
{
    if (def == NULL || s == NULL || part < 0 || part >= wfSettingParts(s)) return 0;
    const uint8_t *at = (const uint8_t *)def + s->offset;
    wfReal real;
    int32_t number;
    uint32_t set;
    if (is_real(s)) {
        memcpy(&real, at + (size_t)part * sizeof real, sizeof real);
        return (double)real;
    }
    memcpy(&number, at, sizeof number);
    memcpy(&set, at, sizeof set);
    return s->kind == WF_SETTING_SET ? (double)set : (double)number;
}

/* check one setting */
wfResult wfCheckSetting(const wfSetting *s, double value)
{
    if (!(value - value == 0)) return WF_ERROR_NOT_FINITE;      /* NaN, or infinite */
    if (s->kind == WF_SETTING_ROW)
        return value >= 0 && value < *s->rowCount ? WF_OK : WF_ERROR_UNKNOWN;
    /* see that all of a set is known */
    bool set = s->kind == WF_SETTING_SET && value >= 0 && value <= UINT32_MAX;
    if (set && ((uint32_t)value & ~wfAllNeeds()) != 0) return WF_ERROR_UNKNOWN;
    double most = s->kind == WF_SETTING_CHOICE ? *s->rowCount - 1 : s->most;
    bool low = s->above ? !(value > s->least) : value < s->least;
    return low || value > most ? WF_ERROR_RANGE : WF_OK;
}

wfResult wfPutSetting(wfWorldDef *def, const wfSetting *s, int part, double value)
{
    if (def == NULL || s == NULL) return WF_ERROR_NULL;
    if (part < 0 || part >= wfSettingParts(s)) return WF_ERROR_UNKNOWN;
    wfResult result = wfCheckSetting(s, value);
    if (result != WF_OK) return result;
    uint8_t *at = (uint8_t *)def + s->offset;
    if (is_real(s)) {
        wfReal real = (wfReal)value;
        result = wfCheckSetting(s, (double)real);
        if (result == WF_OK) memcpy(at + (size_t)part * sizeof real, &real, sizeof real);
        return result;
    }
    if (value < INT32_MIN || value > UINT32_MAX) return WF_ERROR_RANGE;
    int64_t number = (int64_t)value;
    if ((double)number < value || (double)number > value) return WF_ERROR_RANGE;
    if (s->kind != WF_SETTING_SET && number > INT32_MAX) return WF_ERROR_RANGE;
    uint32_t bits = (uint32_t)number;
    memcpy(at, &bits, sizeof bits);
    return WF_OK;
}

/* keep the settings in the header */
static size_t bytes_of(const wfSetting *s)
{
    return is_real(s) ? (size_t)wfSettingParts(s) * sizeof(wfReal) : sizeof(int32_t);
}

void wfKeepSettings(const wfWorldDef *def, wfHeader *head)
{
    for (int i = 0; i < wfSettingCount; i++) {
        const wfSetting *s = &wfSettingTable[i];
        memcpy((uint8_t *)head + s->kept, (const uint8_t *)def + s->offset, bytes_of(s));
    }
}

wfWorldDef wfSettings(const wfHeader *head)
{
    wfWorldDef def = { .dt = 0 };
    for (int i = 0; i < wfSettingCount; i++) {
        const wfSetting *s = &wfSettingTable[i];
        memcpy((uint8_t *)&def + s->offset, (const uint8_t *)head + s->kept, bytes_of(s));
    }
    return def;
}
