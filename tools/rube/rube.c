/* rube.c: turns a scene of R.U.B.E., an editor for Box2D, into a scene of Weft. Text is made of text: so all that is known
 * about making worlds stays in the reader of scenes, and one can look at the translation and correct it by hand. MIT licence. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "json/scene.h"     /* what the library weft-json shares among its files */
#include "rube.h"

/* ---- read their numbers ---- */

typedef struct Rube {
    wfText t;
    bool failed;                    /* an error is noted, or memory is short */
    const cJSON *bodies;
    wfWorld made;                   /* of the bodies alone, if a weld gives */
} Rube;

static void refuse(Rube *r, const cJSON *at, const char *why)
{
    if (!r->failed) wfTextFail(&r->t, at, WF_ERROR_TEXT, "%s", why);
    r->failed = true;
}

/* A number may be a number, or a string with the eight hexadecimal digits of a float. Infinite ones
 * are refused. */
static double number_of(Rube *r, const cJSON *item, double otherwise)
{
    if (item == NULL) return otherwise;
    if (cJSON_IsNumber(item) && item->valuedouble - item->valuedouble == 0)
        return item->valuedouble;
    const char *text = cJSON_IsString(item) ? item->valuestring : "";
    if (strlen(text) == 8 && strspn(text, "0123456789abcdefABCDEF") == 8) {
        union { uint32_t bits; float real; } u = { (uint32_t)strtoul(text, NULL, 16) };
        if (u.real - u.real == 0) return (double)u.real;
    }
    refuse(r, item, "must be a number, or 8 hexadecimal digits of a float");
    return otherwise;
}

static double get(Rube *r, const cJSON *object, const char *name, double otherwise)
{
    return number_of(r, wfChild(object, name), otherwise);
}

/* A flag that is there is true or false; a 1 is neither, and whoever wrote it may have meant something
 * else. */
static bool yes(Rube *r, const cJSON *object, const char *name, bool otherwise)
{
    const cJSON *item = wfChild(object, name);
    if (item == NULL) return otherwise;
    if (cJSON_IsBool(item)) return cJSON_IsTrue(item);
    refuse(r, item, "must be true or false");
    return otherwise;
}

/* A list that is not there is empty; something else in its place is not. */
static const cJSON *first_of(Rube *r, const cJSON *object, const char *name)
{
    const cJSON *list = wfChild(object, name);
    if (list == NULL) return NULL;
    if (!cJSON_IsArray(list)) refuse(r, list, "must be a list: [ ... ]");
    return r->failed ? NULL : list->child;
}

typedef struct Point { double x, y; } Point;

/* A vector may be a plain zero. */
static Point point_of(Rube *r, const cJSON *item)
{
    bool zero = cJSON_IsNumber(item) && item->valuedouble == 0;
    if (item == NULL || zero) return (Point){ 0, 0 };
    if (cJSON_IsObject(item)) return (Point){ get(r, item, "x", 0), get(r, item, "y", 0) };
    refuse(r, item, "must be a vector, { \"x\": 0, \"y\": 0 }, or 0");
    return (Point){ 0, 0 };
}

/* Only these fields, and those that say nothing about motion: a field that is on neither list may be new in
 * their next version, and nobody can say what it does. */
static void allow(Rube *r, const cJSON *object, const char *known)
{
    const char *idle = "name customProperties image collisionbitplanes awake bullet "
        "velocityIterations positionIterations subStepping warmStarting massData-center "
        "massData-I";
    if (!cJSON_IsObject(object)) refuse(r, object, "must be an object: { ... }");
    if (r->failed) return;
    for (const cJSON *c = object->child; c != NULL && !r->failed; c = c->next)
        if (!wfHasWord(known, c->string) && !wfHasWord(idle, c->string))
            refuse(r, c, "what this does to the motion is not known here");
}

/* A failure of what is written is noted, and told at the end. */
static void put(Rube *r, cJSON *in, const char *name, double x)
{
    if (cJSON_AddNumberToObject(in, name, x) == NULL) r->failed = true;
}

static void put_text(Rube *r, cJSON *in, const char *name, const char *text)
{
    if (cJSON_AddStringToObject(in, name, text) == NULL) r->failed = true;
}

static void put_flag(Rube *r, cJSON *in, const char *name, bool flag)
{
    if (flag && cJSON_AddTrueToObject(in, name) == NULL) r->failed = true;
}

static cJSON *pair_of(Rube *r, Point p)
{
    cJSON *item = cJSON_CreateDoubleArray((const double[2]){ p.x, p.y }, 2);
    if (item == NULL) r->failed = true;
    return item;
}

/* Points and objects are made first and then given away; whoever cannot give one away deletes it. */
static void put_point(Rube *r, cJSON *in, const char *name, Point p)
{
    cJSON *item = pair_of(r, p);
    if (item == NULL || cJSON_AddItemToObject(in, name, item)) return;
    cJSON_Delete(item);
    r->failed = true;
}

static cJSON *put_object(Rube *r, cJSON *list)
{
    cJSON *item = cJSON_CreateObject();
    if (item == NULL || !cJSON_AddItemToArray(list, item)) {
        cJSON_Delete(item);
        r->failed = true;
        return NULL;
    }
    return item;
}

/* ---- translate a body of theirs ---- */

/* What is given for a fixture that says nothing is Box2D's own: category 1, and a mask of sixteen ones. */
static void put_material(Rube *r, const cJSON *fixture, cJSON *shape)
{
    put(r, shape, "density", get(r, fixture, "density", 0));
    put(r, shape, "friction", get(r, fixture, "friction", 0));
    put(r, shape, "restitution", get(r, fixture, "restitution", 0));
    put_flag(r, shape, "sensor", yes(r, fixture, "sensor", false));
    put(r, shape, "category", get(r, fixture, "filter-categoryBits", 1));
    put(r, shape, "mask", get(r, fixture, "filter-maskBits", 65535));
    put(r, shape, "group", get(r, fixture, "filter-groupIndex", 0));
}

/* vertices: { "x": [...], "y": [...] } */
static int corner_count(Rube *r, const cJSON *form)
{
    const cJSON *v = wfChild(form, "vertices");
    const cJSON *x = v ? wfChild(v, "x") : NULL, *y = v ? wfChild(v, "y") : NULL;
    int n = cJSON_IsArray(x) ? cJSON_GetArraySize(x) : 0;
    bool good = n >= 2 && n <= WF_MAX_CORNERS && cJSON_IsArray(y)
             && cJSON_GetArraySize(y) == n;
    if (!good) refuse(r, form, "needs vertices: { \"x\": [ ... ], \"y\": [ ... ] }");
    return good ? n : 0;
}

static void put_polygon(Rube *r, const cJSON *form, cJSON *shape)
{
    int n = corner_count(r, form);
    cJSON *list = cJSON_AddArrayToObject(shape, "vertices");
    if (list == NULL) r->failed = true;
    if (n == 0 || r->failed) return;
    const cJSON *x = wfChild(wfChild(form, "vertices"), "x")->child;
    const cJSON *y = wfChild(wfChild(form, "vertices"), "y")->child;
    for (; x != NULL; x = x->next, y = y->next) {
        cJSON *p = pair_of(r, (Point){ number_of(r, x, 0), number_of(r, y, 0) });
        if (p != NULL && !cJSON_AddItemToArray(list, p)) cJSON_Delete(p);
    }
}

/* A chain of n points becomes n - 1 segments, each with the fixture's material. */
static void put_chain(Rube *r, const cJSON *fixture, const cJSON *form, cJSON *shapes)
{
    int n = corner_count(r, form);
    if (n == 0 || r->failed) return;
    const cJSON *x = wfChild(wfChild(form, "vertices"), "x")->child;
    const cJSON *y = wfChild(wfChild(form, "vertices"), "y")->child;
    for (; x->next != NULL && !r->failed; x = x->next, y = y->next) {
        cJSON *shape = put_object(r, shapes);
        put_text(r, shape, "kind", "segment");
        put_point(r, shape, "from", (Point){ number_of(r, x, 0), number_of(r, y, 0) });
        put_point(r, shape, "to",
                  (Point){ number_of(r, x->next, 0), number_of(r, y->next, 0) });
        put_material(r, fixture, shape);
    }
}

static void put_fixture(Rube *r, const cJSON *fixture, cJSON *shapes)
{
    allow(r, fixture, "density friction restitution sensor filter-categoryBits "
          "filter-maskBits filter-groupIndex circle polygon chain");
    const cJSON *circle = wfChild(fixture, "circle"), *chain = wfChild(fixture, "chain");
    const cJSON *polygon = wfChild(fixture, "polygon");
    if (r->failed) return;
    if (circle == NULL && polygon == NULL && chain == NULL)
        refuse(r, fixture, "has no circle, polygon or chain");
    if (chain != NULL) put_chain(r, fixture, chain, shapes);
    if (r->failed || (circle == NULL && polygon == NULL)) return;
    cJSON *shape = put_object(r, shapes);
    put_text(r, shape, "kind", circle ? "circle" : "polygon");
    if (circle != NULL) {
        put_point(r, shape, "centre", point_of(r, wfChild(circle, "center")));
        put(r, shape, "radius", get(r, circle, "radius", 0));
    } else
        put_polygon(r, polygon, shape);
    put_material(r, fixture, shape);
}

/* Their types are numbers, ours are words. A damping is the same factor. The mass is theirs; the inertia
 * is not taken over, but compared at the end. */
static void put_body(Rube *r, const cJSON *body, cJSON *list)
{
    static const char *const types[] = { "static", "kinematic", "dynamic" };
    allow(r, body, "active allowSleep angle angularDamping angularVelocity fixedRotation "
          "fixture gravityScale linearDamping linearVelocity massData-mass position type");
    double type = get(r, body, "type", 0);
    if (!(type == 0 || type == 1 || type == 2)) refuse(r, body, "its type is 0, 1 or 2");
    cJSON *out = r->failed ? NULL : put_object(r, list);
    if (r->failed) return;
    put_text(r, out, "type", types[(int)type]);
    put_point(r, out, "position", point_of(r, wfChild(body, "position")));
    put(r, out, "angle", get(r, body, "angle", 0));
    put_point(r, out, "velocity", point_of(r, wfChild(body, "linearVelocity")));
    bool fixed = yes(r, body, "fixedRotation", false);      /* here it has no spin, which would be refused */
    double spin = get(r, body, "angularVelocity", 0);
    put(r, out, "angularVelocity", fixed ? 0 : spin);
    put(r, out, "linearDamping", get(r, body, "linearDamping", 0));
    put(r, out, "angularDamping", get(r, body, "angularDamping", 0));
    put(r, out, "gravityScale", get(r, body, "gravityScale", 1));
    if (type == 2) put(r, out, "mass", get(r, body, "massData-mass", 0));
    put_flag(r, out, "fixedRotation", fixed);
    put_flag(r, out, "neverSleeps", !yes(r, body, "allowSleep", true));
    put_flag(r, out, "disabled", !yes(r, body, "active", true));
    cJSON *shapes = cJSON_AddArrayToObject(out, "shapes");
    if (shapes == NULL) r->failed = true;
    for (const cJSON *c = first_of(r, body, "fixture"); c && !r->failed; c = c->next)
        put_fixture(r, c, shapes);
}

/* ---- translate a joint of theirs ---- */

static const cJSON *body_of(Rube *r, const cJSON *joint, const char *name)
{
    const cJSON *item = wfChild(joint, name);
    double i = number_of(r, item, -1);
    if (!(i >= 0 && i < cJSON_GetArraySize(r->bodies))) {
        refuse(r, item ? item : joint, "is no body's number");
        return NULL;
    }
    return cJSON_GetArrayItem(r->bodies, (int)i);
}

/* Their anchors are in the frames of the bodies' origins, ours in the world. */
static Point placed(Rube *r, const cJSON *body, Point local, bool turnOnly)
{
    double angle = get(r, body, "angle", 0), c = cos(angle), s = sin(angle);
    Point p = turnOnly ? (Point){ 0, 0 } : point_of(r, wfChild(body, "position"));
    return (Point){ p.x + c * local.x - s * local.y, p.y + s * local.x + c * local.y };
}

static double inverse_mass(Rube *r, const cJSON *body)
{
    if (get(r, body, "type", 0) < 2) return 0;
    double mass = get(r, body, "massData-mass", 0);
    if (!(mass > 0)) refuse(r, body, "a spring with a frequency needs massData-mass");
    return mass > 0 ? 1 / mass : 0;
}

/* A joint's spring is given there by a frequency f and a damping ratio z for the mass m that it moves:
 * with w = 2 pi f the stiffness is m w w and the damping 2 m z w, and 1 / m = 1 / mA + 1 / mB. Without a
 * mass that is known it is refused. */
static void put_spring(Rube *r, const cJSON *j, cJSON *out, const char *frequency,
                       const char *damping)
{
    double f = get(r, j, frequency, 0), turn = 2 * 3.14159265358979323846 * f;
    if (!(f > 0)) return;
    double inverse = inverse_mass(r, body_of(r, j, "bodyA"))
                   + inverse_mass(r, body_of(r, j, "bodyB"));
    if (!(inverse > 0) || r->failed) return;
    put_flag(r, out, "spring", true);                        
    put(r, out, "stiffness", turn * turn / inverse);
    put(r, out, "damping", 2 * get(r, j, damping, 0) * turn / inverse);
}

/* A weld with a frequency gives there against turning alone, and the spring is that of the bodies' moments
 * of inertia. */
static void put_turn_spring(Rube *r, const cJSON *j, cJSON *out)
{
    double turn = 2 * 3.14159265358979323846 * get(r, j, "frequency", 0);
    int32_t a = (int32_t)get(r, j, "bodyA", 0), b = (int32_t)get(r, j, "bodyB", 0);
    if (!(turn > 0) || r->failed) return;
    double inverse = (double)wfTellExactBody(&r->made, a).invInertia
                   + (double)wfTellExactBody(&r->made, b).invInertia;
    if (!(inverse > 0)) return;                             /* neither turns */
    put_flag(r, out, "spring", true);
    put(r, out, "stiffness", turn * turn / inverse);
    put(r, out, "damping", 2 * get(r, j, "dampingRatio", 0) * turn / inverse);
}

static void put_limits(Rube *r, const cJSON *j, cJSON *out, double from)
{
    if (!yes(r, j, "enableLimit", false)) return;
    put_flag(r, out, "limits", true);
    put(r, out, "lower", get(r, j, "lowerLimit", 0) + from);
    put(r, out, "upper", get(r, j, "upperLimit", 0) + from);
}

static void put_motor(Rube *r, const cJSON *j, cJSON *out, const char *most)
{
    put_flag(r, out, "motor", yes(r, j, "enableMotor", false));
    put(r, out, "motorSpeed", get(r, j, "motorSpeed", 0));
    put(r, out, "motorForce", get(r, j, most, 0));
}

/* What the kinds of joint have of their own. Their angle between two bodies at rest, `refAngle', is the zero
 * of their limits; ours count from where both bodies have the angle zero, so it is added. A rope is a
 * distance with one stop. A friction joint has a torque of its own there; here it is a force at a lever. */
static void put_kind(Rube *r, const cJSON *j, const char *type, cJSON *out)
{
    double reference = get(r, j, "refAngle", 0), most = get(r, j, "maxForce", 0);
    if (strcmp(type, "revolute") == 0) {
        put_limits(r, j, out, reference);
        put_motor(r, j, out, "maxMotorTorque");
    } else if (strcmp(type, "prismatic") == 0) {
        put_limits(r, j, out, 0);
        put_motor(r, j, out, "maxMotorForce");
        put(r, out, "angle", reference);
        put(r, out, "rest", 0);
    } else if (strcmp(type, "wheel") == 0) {
        put_motor(r, j, out, "maxMotorTorque");
        put_spring(r, j, out, "springFrequency", "springDampingRatio");
    } else if (strcmp(type, "distance") == 0) {
        put(r, out, "rest", get(r, j, "length", 1));
        put_spring(r, j, out, "frequency", "dampingRatio");
    } else if (strcmp(type, "rope") == 0) {
        put_flag(r, out, "limits", true);
        put(r, out, "upper", get(r, j, "maxLength", 1));
    } else if (strcmp(type, "weld") == 0) {
        put(r, out, "rest", reference);
        put_turn_spring(r, j, out);
    } else if (strcmp(type, "friction") == 0) {
        put(r, out, "motorForce", most);
        if (most > 0) put(r, out, "ratio", get(r, j, "maxTorque", 0) / most);
    }
}

/* Everything that may be refused comes before the first thing is written. An axis is a direction: turned
 * with its body, but not moved. */
static void put_joint(Rube *r, const cJSON *j, cJSON *list)
{
    const char *types = "revolute prismatic wheel distance rope weld friction";
    allow(r, j, "anchorA anchorB bodyA bodyB collideConnected type enableLimit enableMotor "
          "jointSpeed lowerLimit upperLimit maxMotorTorque maxMotorForce motorSpeed "
          "refAngle localAxisA springFrequency springDampingRatio frequency dampingRatio "
          "length maxLength maxForce maxTorque");
    const cJSON *kind = r->failed ? NULL : wfChild(j, "type");
    if (!r->failed && (!cJSON_IsString(kind) || !wfHasWord(types, kind->valuestring)))
        refuse(r, kind ? kind : j, "joints of this type are not translated");
    const cJSON *a = r->failed ? NULL : body_of(r, j, "bodyA");
    const cJSON *b = r->failed ? NULL : body_of(r, j, "bodyB");
    cJSON *out = r->failed ? NULL : put_object(r, list);
    if (r->failed) return;
    bool rope = strcmp(kind->valuestring, "rope") == 0;
    put_text(r, out, "kind", rope ? "distance" : kind->valuestring);
    put(r, out, "a", get(r, j, "bodyA", 0));
    put(r, out, "b", get(r, j, "bodyB", 0));
    Point from = point_of(r, wfChild(j, "anchorA"));
    Point to = point_of(r, wfChild(j, "anchorB"));
    put_point(r, out, "anchorA", placed(r, a, from, false));
    put_point(r, out, "anchorB", placed(r, b, to, false));
    const cJSON *axis = wfChild(j, "localAxisA");
    if (axis != NULL)
        put_point(r, out, "axis", placed(r, a, point_of(r, axis), true));
    put_flag(r, out, "collide", yes(r, j, "collideConnected", false));
    put_kind(r, j, kind->valuestring, out);
}

/* ---- translate a scene of theirs ---- */

/* Reads the translation, the way anybody would: what is wrong with it is told now. */
static bool read_again(Rube *r, const char *text, wfWorld *world)
{
    wfTextError e;
    if (wfReadScene(text, strlen(text), NULL, world, NULL, &e) == WF_OK) return true;
    if (!r->failed)
        wfTextFail(&r->t, NULL, e.result, "in the translation: %.60s: %.90s", e.where, e.what);
    r->failed = true;
    return false;
}

/* A rate in place of a step, and a switch for whether pushes last. */
static void put_settings(Rube *r, cJSON *out)
{
    const cJSON *root = r->t.root;
    cJSON *settings = cJSON_AddObjectToObject(out, "settings");
    double rate = get(r, root, "stepsPerSecond", 60);
    if (settings == NULL) r->failed = true;
    if (!(rate > 0)) refuse(r, wfChild(root, "stepsPerSecond"), "must be > 0");
    if (!yes(r, root, "autoClearForces", true))
        refuse(r, wfChild(root, "autoClearForces"), "here a push lasts for one step");
    if (r->failed) return;
    put_point(r, settings, "gravity", point_of(r, wfChild(root, "gravity")));
    put(r, settings, "timeStep", 1 / rate);
    put_flag(r, settings, "sleep", yes(r, root, "allowSleep", true));
    if (!yes(r, root, "continuousPhysics", true)) put(r, settings, "maxImpacts", 0);
}

static bool has_soft_weld(Rube *r)
{
    for (const cJSON *j = first_of(r, r->t.root, "joint"); j && !r->failed; j = j->next) {
        const cJSON *type = wfChild(j, "type");
        bool weld = cJSON_IsString(type) && strcmp(type->valuestring, "weld") == 0;
        if (weld && get(r, j, "frequency", 0) > 0) return true;
    }
    return false;
}

/* Makes a world of the bodies alone, which knows what they weigh. */
static void weigh(Rube *r, const cJSON *out)
{
    char *text = r->failed ? NULL : wfPrettyText(out);
    if (text != NULL) read_again(r, text, &r->made);
    if (text == NULL) r->failed = true;
    wfFreeText(text);
}

/* Bodies keep their order, so the numbers by which joints name them stay right. */
static void put_lists(Rube *r, cJSON *out)
{
    cJSON *bodyList = cJSON_AddArrayToObject(out, "bodies");
    cJSON *jointList = cJSON_AddArrayToObject(out, "joints");
    if (bodyList == NULL || jointList == NULL) r->failed = true;
    for (const cJSON *c = r->bodies->child; c && !r->failed; c = c->next)
        put_body(r, c, bodyList);
    if (has_soft_weld(r)) weigh(r, out);
    for (const cJSON *c = first_of(r, r->t.root, "joint"); c && !r->failed; c = c->next)
        put_joint(r, c, jointList);
}

static bool is_like(double given, double made, double size)
{
    return fabs(given - made) <= 0.01 * size;
}

/* Its moment of inertia is about the body's origin, ours about the centre of mass; between them is
 * Steiner's m c c. */
static void check_mass(Rube *r, const cJSON *body, const wfWorld *world, int32_t i)
{
    const cJSON *centre = wfChild(body, "massData-center");
    double given = get(r, body, "massData-I", 0);
    wfExactBody made = wfTellExactBody(world, i);
    Point c = point_of(r, centre);
    double x = (double)made.localCentre.x, y = (double)made.localCentre.y;
    double mass = (double)made.mass, inertia = (double)made.inertia;
    double arm = inertia > 0 ? sqrt(inertia / mass) : 0;
    if (get(r, body, "type", 0) < 2 || r->failed) return;
    if (yes(r, body, "fixedRotation", false)) return;      /* all its points move alike */
    if (centre != NULL && !(is_like(c.x, x, arm) && is_like(c.y, y, arm)))
        refuse(r, centre, "the fixtures have their centre of mass elsewhere");
    double about = inertia + mass * (x * x + y * y);
    if (given > 0 && inertia > 0 && !is_like(given, about, about))
        refuse(r, wfChild(body, "massData-I"), "the fixtures have another one");
}

/* What the fixtures weigh is compared with what that editor says they weigh. */
static void check_masses(Rube *r, const char *text)
{
    wfWorld world;
    int32_t i = 0;
    if (!read_again(r, text, &world)) return;
    for (const cJSON *c = r->bodies->child; c != NULL && !r->failed; c = c->next)
        check_mass(r, c, &world, i++);
    wfDestroyWorld(&world);
}

/* If anything was refused, there is no text, not even half of one. */
static char *translate(Rube *r)
{
    r->bodies = wfChild(r->t.root, "body");
    if (wfChild(r->t.root, "metaworld") != NULL)
        refuse(r, wfChild(r->t.root, "metaworld"), "a project of the editor: export the scene as JSON there");
    if (r->failed) return NULL;
    if (!cJSON_IsArray(r->bodies)) {
        refuse(r, r->t.root, "a R.U.B.E. scene has a list `body'");
        return NULL;
    }
    allow(r, r->t.root, "allowSleep autoClearForces body continuousPhysics gravity joint "
          "stepsPerSecond");
    cJSON *out = cJSON_CreateObject();
    if (out == NULL) r->failed = true;
    put(r, out, "weft", WF_SCENE_VERSION);
    if (!r->failed) put_settings(r, out);
    if (!r->failed) put_lists(r, out);
    char *text = r->failed ? NULL : wfPrettyText(out);
    cJSON_Delete(out);
    wfDestroyWorld(&r->made);
    if (text != NULL) check_masses(r, text);
    if (!r->failed) return text;
    wfFreeText(text);
    return NULL;
}

wfResult wfTranslateRube(const char *text, size_t length, char **out, wfTextError *error)
{
    wfTextError own;
    Rube r = { .t = { .text = text, .length = length,
                      .error = error != NULL ? error : &own } };
    *r.t.error = (wfTextError){ .result = WF_OK };
    if (text == NULL || out == NULL) return r.t.error->result = WF_ERROR_NULL;
    char *made = wfTextParse(&r.t) ? translate(&r) : NULL;
    if (made == NULL && r.t.error->result == WF_OK)
        wfTextResult(&r.t, NULL, WF_ERROR_MEMORY);
    cJSON_Delete(r.t.root);
    if (made != NULL) *out = made;
    return r.t.error->result;
}
