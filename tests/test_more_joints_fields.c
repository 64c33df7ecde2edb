/* What the table of the kinds in joint.h says that each reads of a wfJoint is what it reads: a field that is changed changes its rows, in
 * some of many places of the bodies, if and only if it is named there; and appendix B says the same. */
#include "testing.h"
#include "weft/joint.h"

typedef struct Field { const char *name; size_t at; int letter; } Field;       /* letter: of the table, which stands for it */
#define F(name, letter) { #name, offsetof(wfJoint, name), letter }
static const Field fields[] = {
    F(localA, 0), F(localB, 0), F(axis, 0), F(groundA, 0), F(groundB, 0), F(rest, 0), F(angle, 0), F(ratio, 0),
    F(stiffness, 'S'), F(damping, 'S'), F(springForce, 'S'), F(motorSpeed, 'M'), F(motorForce, 'M'), F(lower, 'L'), F(upper, 'L'),
};

static const char *text_of(const char *path)
{
    static char text[1 << 17];
    FILE *f = fopen(path, "rb");
    if (f == NULL) fail_msg("no %s: tests run in the root of the project", path);
    text[fread(text, 1, sizeof text - 1, f)] = 0;
    fclose(f);
    return text;
}

static bool has(const char *list, const char *word)
{
    size_t n = strlen(word);
    for (const char *at = list; (at = strstr(at, word)) != NULL; at += n)
        if ((at == list || at[-1] == ' ') && (at[n] == ' ' || at[n] == 0)) return true;
    return false;
}

/* The list of a kind in the header, and that it is the appendix's as well. */
static const char *list_of(const char *kind)
{
    static char list[200];
    char row[300], start[40];
    snprintf(start, sizeof start, "\n     %-10s ", kind);
    const char *at = strstr(text_of("src-generated/include/weft/joint.h"), start);
    if (at == NULL) fail_msg("joint.h does not say what %s reads", kind);
    at += strlen(start);
    size_t n = strcspn(at, "\n*");
    while (n > 0 && at[n - 1] == ' ') n--;
    snprintf(list, sizeof list, "%.*s", (int)n, at);
    snprintf(row, sizeof row, "| `%s` | %s |", kind, list);
    if (strstr(text_of("chapters/engine/B-api.nw"), row) == NULL) fail_msg("appendix B has no row that begins with %s", row);
    return list;
}

static wfReal some(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (wfReal)(*seed >> 40) / (1 << 23) - 1;
}

static wfBodyState state_of(uint64_t *seed)
{
    return (wfBodyState){ .p = wfV2(3 * some(seed), 3 * some(seed)), .angle = 3 * some(seed), .invMass = 1, .invInertia = 1 };
}

/* The rows of a joint after its turns were counted, as they are in force: what is off is cleared. */
static void rows_of(wfJoint j, const wfBodyState *a, const wfBodyState *b, wfJointRow *rows)
{
    memset(rows, 0, WF_JOINT_ROWS * sizeof *rows);
    wfTrackJoint(&j, a, b);
    int32_t n = wfBuildJoint(&j, a, b, rows);
    for (int32_t i = 0; i < WF_JOINT_ROWS; i++)
        if (i >= n || rows[i].law == WF_ROW_OFF) memset(&rows[i], 0, sizeof rows[i]);
}

static bool reads(int kind, const Field *f)
{
    uint64_t seed = 7;
    for (int round = 0; round < 400; round++) {
        wfBodyState a = state_of(&seed), b = state_of(&seed);
        wfJointRow one[WF_JOINT_ROWS], two[WF_JOINT_ROWS];
        wfJoint j = { .kind = kind, .a = 0, .b = 1, .flags = round % 2 ? WF_JOINT_SPRING | WF_JOINT_MOTOR | WF_JOINT_LIMITS : 0,
            .localA = wfV2(some(&seed), 1), .localB = wfV2(some(&seed), 1), .axis = wfV2(1, 0), .groundA = wfV2(1, 0), .groundB = wfV2(0, 1),
            .rest = 2, .angle = 1, .ratio = WF_R(0.25), .lower = -1, .upper = 1, .stiffness = 5, .damping = 1, .springForce = 9,
            .motorSpeed = 1, .motorForce = 4, .turnA = a.angle, .turnB = b.angle + 2 * some(&seed) };
        wfJoint other = j;
        wfReal *x = (wfReal *)(void *)((char *)&other + f->at);
        *x += WF_R(0.0625);
        rows_of(j, &a, &b, one);
        rows_of(other, &a, &b, two);
        if (memcmp(one, two, sizeof one) != 0) return true;
    }
    return false;
}

TEST(the_table_says_what_is_read)
{
    for (int kind = 0; kind < wfJointKinds; kind++) {
        const char *list = list_of(wfJointTable[kind].name);
        for (size_t i = 0; i < sizeof fields / sizeof *fields; i++) {
            char letter[2] = { (char)fields[i].letter, 0 };
            bool named = has(list, fields[i].name) || (fields[i].letter && has(list, letter)), read = reads(kind, &fields[i]);
            if (named != read) fail_msg("%s %s %s, and the table says that it %s", wfJointTable[kind].name, read ? "reads" : "does not read", fields[i].name, named ? "does" : "does not");
        }
    }
}
