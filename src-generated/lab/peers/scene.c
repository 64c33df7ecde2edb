/* Weft: lab/peers/scene.c, tangled from chapters/engine/02-similar-systems.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* Reads a scene for the adapters in C. Needs cJSON. */
#include <cjson/cJSON.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "peer.h"

/* refuse by name */
void peerRefuse(const char *what, ...)
{
    va_list list;
    va_start(list, what);
    fputs("refused: ", stderr);
    vfprintf(stderr, what, list);
    fputc('\n', stderr);
    va_end(list);
    exit(3);
}

static void fail(const char *where, const char *what)
{
    fprintf(stderr, "error: %s: %s\n", where, what);
    exit(1);
}

/* the keys of a scene */
typedef struct Keys {
    const char *read, *passed, *zero, *one;     /* between blanks */
} Keys;
static const Keys sceneKeys = {
    " weft settings bodies joints origin ",
    " digits $schema name text view promises needs time steps ",
    " forces pairMaterials ", " " };
static const Keys bodyKeys = {
    " name type position angle velocity angularVelocity fixedRotation shapes ",
    " userData exact neverSleeps pivot ",
    " mass linearDamping angularDamping push ", " gravityScale " };
static const Keys shapeKeys = {
    " kind centre radius halfWidth halfHeight angle vertices density restitution friction "
    "category mask ",
    " userData place exact material ",
    " staticFriction rolling surfaceSpeed group sensor loop ", " " };
static const Keys jointKeys = {
    " kind a b anchor anchorA anchorB localA localB rest collide ",
    " angle axis ratio lower upper stiffness damping springForce motorSpeed motorForce "
    "groundA groundB turnA turnB impulse given exact ",
    " spring motor limits broken breakForce breakTorque ", " " };

/* look at keys */
static int listed(const char *list, const char *key)
{
    char word[64];
    snprintf(word, sizeof word, " %s ", key);
    return strstr(list, word) != NULL;
}

static int neutral(const cJSON *item, double value)
{
    if (cJSON_IsNumber(item)) return item->valuedouble == value;
    if (cJSON_IsBool(item)) return (double)cJSON_IsTrue(item) == value;
    const cJSON *child;
    cJSON_ArrayForEach(child, item)
        if (!neutral(child, value)) return 0;
    return cJSON_IsArray(item) || cJSON_IsObject(item);
}

static void look_at_keys(const cJSON *object, const Keys *keys, const char *where)
{
    const cJSON *item;
    cJSON_ArrayForEach(item, object) {
        const char *key = item->string;
        if (key == NULL) fail(where, "must be an object");
        if (listed(keys->read, key) || listed(keys->passed, key)) continue;
        if (listed(keys->zero, key) && neutral(item, 0)) continue;
        if (listed(keys->one, key) && neutral(item, 1)) continue;
        peerRefuse("%s%s%s", where, *where != '\0' ? "." : "", key);
    }
}

static double number(const cJSON *object, const char *key, double usual)
{
    const cJSON *item = cJSON_GetObjectItem(object, key);
    if (cJSON_IsBool(item)) return cJSON_IsTrue(item);
    if (item != NULL && !cJSON_IsNumber(item)) fail(key, "must be a number");
    return item != NULL ? item->valuedouble : usual;
}

static void pair(const cJSON *item, const char *key, double out[2])
{
    for (int i = 0; i < 2; i++) {
        const cJSON *x = cJSON_GetArrayItem(item, i);
        if (!cJSON_IsNumber(x) || cJSON_GetArraySize(item) != 2)
            fail(key, "must be [x, y]");
        out[i] = x->valuedouble;
    }
}

static int point(const cJSON *object, const char *key, double out[2])
{
    const cJSON *item = cJSON_GetObjectItem(object, key);
    out[0] = out[1] = 0;
    if (item != NULL) pair(item, key, out);
    return item != NULL;
}

static const char *word(const cJSON *object, const char *key, const char *usual)
{
    const char *text = cJSON_GetStringValue(cJSON_GetObjectItem(object, key));
    return text != NULL ? text : usual;
}

/* 16 bits; a greater number is written in hexadecimal, in quotes */
static unsigned bits(const cJSON *object, const char *key, unsigned usual)
{
    const cJSON *item = cJSON_GetObjectItem(object, key);
    if (item == NULL) return usual;
    unsigned long long all = cJSON_IsString(item) ? strtoull(item->valuestring, NULL, 16)
                                                  : (unsigned long long)item->valuedouble;
    if (all > 0xffff && strcmp(key, "category") == 0) peerRefuse("category above 16 bits");
    return (unsigned)(all & 0xffff);
}

/* read shapes of a scene */
static void turn(double x, double y, double angle, const double by[2], double out[2])
{
    double c = cos(angle), s = sin(angle);
    out[0] = by[0] + c * x - s * y;
    out[1] = by[1] + s * x + c * y;
}

static void read_corners(const cJSON *item, const char *where, peerShape *s)
{
    static const double sign[4][2] = { { -1, -1 }, { 1, -1 }, { 1, 1 }, { -1, 1 } };
    const cJSON *list = cJSON_GetObjectItem(item, "vertices");
    double w = number(item, "halfWidth", 0), h = number(item, "halfHeight", 0);
    double angle = number(item, "angle", 0);
    s->corners = list != NULL ? cJSON_GetArraySize(list) : 4;
    if (s->corners > 8) peerRefuse("%s: more than 8 corners", where);
    if (s->corners < 3) fail(where, "needs three corners");
    for (int i = 0; i < s->corners; i++)
        if (list == NULL)
            turn(sign[i][0] * w, sign[i][1] * h, angle, s->centre, s->corner[i]);
        else
            pair(cJSON_GetArrayItem(list, i), where, s->corner[i]);
    if (s->radius != 0) peerRefuse("%s.radius: a rounded polygon", where);
}

static void read_shape(const cJSON *item, const char *where, peerShape *s)
{
    const char *kind = word(item, "kind", "");
    look_at_keys(item, &shapeKeys, where);
    memset(s, 0, sizeof *s);
    point(item, "centre", s->centre);
    s->radius = number(item, "radius", 0);
    s->density = number(item, "density", 1);
    s->friction = number(item, "friction", 0.5);
    s->restitution = number(item, "restitution", 0);
    s->category = bits(item, "category", 1);
    s->mask = bits(item, "mask", 0xffff);
    if (strcmp(kind, "box") == 0 || strcmp(kind, "polygon") == 0)
        read_corners(item, where, s);
    else if (strcmp(kind, "circle") != 0)
        peerRefuse("%s: a %s", where, kind);
}

/* twice the mass and twice the first moments, added: eq:similar-centre */
static void weigh(const peerShape *s, double sum[3])
{
    const double *o = s->corner[0];
    if (s->corners == 0) {
        double m = 2 * s->density * 3.14159265358979323846 * s->radius * s->radius;
        for (int i = 0; i < 3; i++) sum[i] += m * (i == 0 ? 1 : s->centre[i - 1]);
    }
    for (int i = 1; i + 1 < s->corners; i++) {
        const double *p = s->corner[i], *q = s->corner[i + 1];
        double area = (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
        sum[0] += s->density * area;
        sum[1] += s->density * area * (o[0] + p[0] + q[0]) / 3;
        sum[2] += s->density * area * (o[1] + p[1] + q[1]) / 3;
    }
}

static void read_body(const cJSON *item, const char *where, peerScene *out, peerBody *b)
{
    const cJSON *list = cJSON_GetObjectItem(item, "shapes"), *shape;
    const char *type = word(item, "type", "dynamic");
    double sum[3] = { 0, 0, 0 };
    char place[96];
    look_at_keys(item, &bodyKeys, where);
    *b = (peerBody){ .firstShape = out->shapes, .angle = number(item, "angle", 0),
                     .spin = number(item, "angularVelocity", 0),
                     .fixedRotation = (int)number(item, "fixedRotation", 0) };
    b->type = type[0] == 's' ? PEER_STATIC : type[0] == 'k' ? PEER_KINEMATIC : PEER_DYNAMIC;
    point(item, "position", b->position);
    for (int i = 0; i < 2; i++) b->position[i] += out->origin[i];
    point(item, "velocity", b->velocity);
    cJSON_ArrayForEach(shape, list) {
        snprintf(place, sizeof place, "%s.shapes[%d]", where, b->shapes++);
        read_shape(shape, place, &out->shape[out->shapes]);
        weigh(&out->shape[out->shapes++], sum);
    }
    if (b->type == PEER_DYNAMIC && sum[0] <= 0) peerRefuse("%s: it has no mass", where);
    for (int i = 0; i < 2 && b->type == PEER_DYNAMIC; i++)
        b->centre[i] = sum[i + 1] / sum[0];
}

/* read joints of a scene */
static int which(const cJSON *root, const cJSON *joint, const char *key)
{
    const cJSON *item = cJSON_GetObjectItem(joint, key), *body;
    int i = 0;
    if (cJSON_IsNumber(item)) return item->valueint;
    cJSON_ArrayForEach(body, cJSON_GetObjectItem(root, "bodies")) {
        if (strcmp(word(body, "name", ""), word(joint, key, "?")) == 0) return i;
        i++;
    }
    fail("joints", "no such body");
    return 0;
}

static void read_anchor(const cJSON *item, const char *global, const char *local,
                        const double origin[2], const peerBody *b, double out[2])
{
    double p[2];
    static const double zero[2] = { 0, 0 };
    if (point(item, local, p)) {
        out[0] = b->centre[0] + p[0];
        out[1] = b->centre[1] + p[1];
    } else if (point(item, global, p) || point(item, "anchor", p)) {
        turn(p[0] + origin[0] - b->position[0], p[1] + origin[1] - b->position[1],
             -b->angle, zero, out);
    } else {
        out[0] = b->centre[0];
        out[1] = b->centre[1];
    }
}

static void read_joint(const cJSON *root, const cJSON *item, const char *where,
                       peerScene *out, peerJoint *j)
{
    static const char *const kinds[] = { "revolute", "distance", "weld" };
    double from[2], to[2];
    look_at_keys(item, &jointKeys, where);
    *j = (peerJoint){ .kind = -1, .a = which(root, item, "a"), .b = which(root, item, "b"),
                      .collide = (int)number(item, "collide", 0) };
    for (int i = 0; i < 3; i++)
        if (strcmp(word(item, "kind", ""), kinds[i]) == 0) j->kind = i;
    if (j->kind < 0) peerRefuse("%s: a joint of kind %s", where, word(item, "kind", "?"));
    if (j->a < 0 || j->b < 0 || j->a >= out->bodies || j->b >= out->bodies)
        fail(where, "no such body");
    const peerBody *a = &out->body[j->a], *b = &out->body[j->b];
    read_anchor(item, "anchorA", "localA", out->origin, a, j->anchorA);
    read_anchor(item, "anchorB", "localB", out->origin, b, j->anchorB);
    turn(j->anchorA[0], j->anchorA[1], a->angle, a->position, from);
    turn(j->anchorB[0], j->anchorB[1], b->angle, b->position, to);
    j->rest = number(item, "rest", hypot(to[0] - from[0], to[1] - from[1]));
}

/* read a scene for a peer */
static char *whole_file(const char *file)
{
    FILE *f = fopen(file, "rb");
    char *text;
    long size;
    if (f == NULL || fseek(f, 0, SEEK_END) != 0 || (size = ftell(f)) < 0)
        fail(file, "cannot be read");
    rewind(f);
    text = calloc((size_t)size + 1, 1);
    if (text == NULL || fread(text, 1, (size_t)size, f) != (size_t)size)
        fail(file, "cannot be read");
    fclose(f);
    return text;
}

static void read_settings(const cJSON *root, peerScene *out)
{
    const cJSON *s = cJSON_GetObjectItem(root, "settings");
    if (!point(s, "gravity", out->gravity)) out->gravity[1] = -9.81;
    out->dt = number(s, "dt", 1.0 / 60);
    out->geometricFriction = strcmp(word(s, "frictionMix", "geometric-mean"),
                                    "geometric-mean") == 0;
    out->greatestRestitution = strcmp(word(s, "restitutionMix", "maximum"), "maximum") == 0;
    out->oneFriction = out->oneRestitution = 1;
    for (int i = 1; i < out->shapes; i++) {
        if (out->shape[i].friction != out->shape[0].friction) out->oneFriction = 0;
        if (out->shape[i].restitution != out->shape[0].restitution) out->oneRestitution = 0;
    }
}

static size_t count_shapes(const cJSON *bodies)
{
    size_t count = 0;
    const cJSON *body;
    cJSON_ArrayForEach(body, bodies)
        count += (size_t)cJSON_GetArraySize(cJSON_GetObjectItem(body, "shapes"));
    return count;
}

void peerRead(const char *file, peerScene *out)
{
    char *text = whole_file(file), where[64];
    cJSON *root = cJSON_Parse(text);
    if (!cJSON_IsObject(root)) fail(file, "is not a scene in JSON");
    look_at_keys(root, &sceneKeys, "");
    const cJSON *bodies = cJSON_GetObjectItem(root, "bodies"), *item;
    const cJSON *joints = cJSON_GetObjectItem(root, "joints");
    int i = 0;
    *out = (peerScene){ .bodies = cJSON_GetArraySize(bodies), .file = file };
    point(root, "origin", out->origin);
    /* take room for bodies, shapes and joints */
    out->body = calloc((size_t)out->bodies + 1, sizeof *out->body);
    out->shape = calloc(count_shapes(bodies) + 1, sizeof *out->shape);
    out->joint = calloc((size_t)cJSON_GetArraySize(joints) + 1, sizeof *out->joint);
    if (out->body == NULL || out->shape == NULL || out->joint == NULL)
        fail(file, "no memory");
    cJSON_ArrayForEach(item, bodies) {
        snprintf(where, sizeof where, "bodies[%d]", i);
        read_body(item, where, out, &out->body[i++]);
    }
    cJSON_ArrayForEach(item, joints) {
        snprintf(where, sizeof where, "joints[%d]", out->joints);
        read_joint(root, item, where, out, &out->joint[out->joints++]);
    }
    read_settings(root, out);
    cJSON_Delete(root);
    free(text);
}
