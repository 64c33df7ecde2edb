/* Weft: testbed/case_scenes.c, tangled from chapters/testbed/12-report-scenes.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
/* The report's eight test cases. */
#include "testbed/maker.h"

#define TESTING .change = "Other body", .points = 2

/* Four boxes above each other; each weighs so much more than the one above it, kg. */
static wfResult build_column(wfWorld *world, wfReal first, wfReal more)
{
    Maker m = { world, WF_OK };
    for (int i = 0; i < 4; i++) {
        wfBodyDef b = box(&m, -5, WF_R(4.5) - WF_R(1.5) * (wfReal)i, WF_R(0.5), WF_R(0.5));
        b.mass = first + more * (wfReal)i;
        put_ink(&m, &b, i % 2 ? WF_INK_BODY : WF_INK_GOOD);
    }
    return m.result;
}

static wfResult build_forces(wfWorld *world) { return build_column(world, 1, 1); }
static wfResult build_rotation(wfWorld *world) { return build_column(world, 2, 0); }

/* Pulls to the right, with 1 N, for the first four seconds: body i at so much times i
   above its centre. */
static void pull_right(wfWorld *world, wfReal above)
{
    if (wfWorldTime(world) > 4) return;
    wfBodyView v = wfWorldBodies(world);
    for (int32_t i = 0; i < v.count; i++) {
        wfVec2 arm = wfRotate(wfRotation(v.state[i].angle), wfV2(0, above * (wfReal)i));
        wfVec2 point = wfAdd(v.state[i].p, above > 0 ? arm : wfV2(0, 0));
        wfApplyForceToBody(world, wfBodyAt(world, i), wfV2(1, 0), point);
    }
}

static void update_forces(wfWorld *world, const wfSceneInput *in)
{
    (void)in;
    pull_right(world, 0);
}

static void draw_forces(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfBodyView v = wfWorldBodies(world);
    for (int32_t i = 0; i < v.count; i++) {
        float x = (float)v.state[i].p.x, y = (float)v.state[i].p.y;
        wfDrawTextf(d, x, y - 0.12f, 13, WF_INK_TEXT, 0, "%d M", (int)i + 1);
        wfDrawDashed(d, -5, y, x - 0.5f, y, 1, WF_INK_FAINT);
        if (wfWorldTime(world) <= 4)
            wfDrawArrow(d, x + 0.5f, y, x + 1.5f, y, 2, WF_INK_ACCENT);
    }
}

static void update_rotation(wfWorld *world, const wfSceneInput *in)
{
    (void)in;
    pull_right(world, WF_R(0.15));
}

static void draw_arms(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    (void)in;
    wfBodyView v = wfWorldBodies(world);
    for (int32_t i = 0; i < v.count && wfWorldTime(world) <= 4; i++) {
        wfVec2 arm = wfRotate(wfRotation(v.state[i].angle),
                              wfV2(0, WF_R(0.15) * (wfReal)i));
        wfVec2 from = wfAdd(v.state[i].p, arm), to = wfAdd(from, wfV2(1, 0));
        wfDrawLine(d, WF_XY(v.state[i].p), WF_XY(from), 1.5f, WF_INK_LINE);
        wfDrawPoint(d, WF_XY(v.state[i].p), 6, WF_INK_LINE);
        wfDrawArrow(d, WF_XY(from), WF_XY(to), 2, WF_INK_ACCENT);
    }
}

enum { TESTING_BODIES = 5 };

static void put_testing_bodies(Maker *m)
{
    wfBodyDef shape[TESTING_BODIES] = {
        box(m, 0, 0, WF_R(0.9), WF_R(0.6)), ball(m, 0, 0, WF_R(0.8)),
        regular(m, 0, 0, 1, 3),
        regular(m, 0, 0, 1, 5), box(m, 0, 0, WF_R(1.4), WF_R(0.2))
    };
    for (int i = 0; i < TESTING_BODIES; i++) {
        shape[i].position = wfV2(1000 + 10 * (wfReal)i, 1000);
        put_ink(m, &shape[i], WF_INK_BODY2);
    }
}

/* Which body of the world is the testing body now. */
static int32_t testing_body(const wfSceneInput *in)
{
    return (int32_t)((uint32_t)in->choice % TESTING_BODIES);
}

static void place_testing_body(wfWorld *world, const wfSceneInput *in)
{
    for (int32_t i = 0; i < TESTING_BODIES; i++) {
        wfBodyId id = wfBodyAt(world, i);
        wfVec2 away = wfV2(1000 + 10 * (wfReal)i, 1000);
        bool chosen = i == testing_body(in);
        wfSetBodyTransform(world, id, chosen ? in->mouse : away, chosen ? in->turn : 0);
        wfSetBodyVelocity(world, id, wfV2(0, 0), 0);
    }
}

static wfResult build_gallery(wfWorld *world)
{
    Maker m = { world, WF_OK };
    put_testing_bodies(&m);
    wfBodyDef still[] = {
        box(&m, -4, 2, 1, WF_R(0.7)), regular(&m, 0, 2, WF_R(1.1), 5), ball(&m, 4, 2, 1),
        ball(&m, -4, -2, WF_R(0.7)), regular(&m, 0, -2, WF_R(1.2), 3),
        box(&m, 4, -2, WF_R(0.4), WF_R(1.3))
    };
    for (int i = 0; i < 6; i++) {
        still[i].type = WF_STATIC;
        still[i].angle = WF_R(0.3) * (wfReal)(i - 2);
        put(&m, &still[i]);
    }
    return m.result;
}

/* The standing body closest to the testing body, by the narrow phase; -1 for none. */
static int32_t closest_body(const wfBodyView *v, int32_t test, wfSeparation *best)
{
    int32_t found = -1;
    for (int32_t i = TESTING_BODIES; i < v->count; i++) {
        wfSeparation s;
        if (!v->alive[i] || wfSeparate(0, &v->shapes[v->props[test].shape],
                wfBodyTransform(&v->state[test]), &v->shapes[v->props[i].shape],
                wfBodyTransform(&v->state[i]), &s) != WF_OK)
            continue;
        if (found < 0 || s.distance < best->distance) *best = s, found = i;
    }
    return found;
}

/* The bar that a body covers on the axis through `origin', `lift' beside it. */
static void draw_projection(wfDraw *d, const wfBodyView *v, int32_t i, wfVec2 origin,
                            wfVec2 axis, wfReal lift, int role)
{
    wfProjection p = wfProject(&v->shapes[v->props[i].shape],
                               wfBodyTransform(&v->state[i]), axis);
    wfReal o = wfDot(origin, axis);
    wfVec2 base = wfAddScaled(origin, lift, wfPerpCCW(axis));
    wfVec2 from = wfAddScaled(base, p.min - o, axis);
    wfVec2 to = wfAddScaled(base, p.max - o, axis);
    wfDrawLine(d, WF_XY(from), WF_XY(to), 5, role);
}

static void draw_axis(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    wfBodyView v = wfWorldBodies(world);
    wfSeparation s = { 0 };
    int32_t test = testing_body(in), near = closest_body(&v, test, &s);
    if (near < 0) return;
    int role = s.distance < 0 ? WF_INK_BAD : WF_INK_GOOD;
    wfVec2 origin = wfLerp(v.state[test].p, v.state[near].p, WF_R(0.5));
    wfVec2 side = wfPerpCCW(s.normal);
    if (wfDot(side, origin) > 0)
        side = wfNeg(side);                 /* beside the bodies, towards the middle */
    wfVec2 aside = wfAddScaled(origin, 2, side);
    wfVec2 from = wfAddScaled(aside, -3, s.normal), to = wfAddScaled(aside, 3, s.normal);
    wfDrawLine(d, WF_XY(from), WF_XY(to), 1.5f, WF_INK_LINE);
    draw_projection(d, &v, test, aside, s.normal, WF_R(0.08), WF_INK_BODY2);
    draw_projection(d, &v, near, aside, s.normal, WF_R(-0.08), WF_INK_BODY);
    wfVec2 label = wfAddScaled(aside, WF_R(0.4), side), tip = wfAdd(origin, s.normal);
    wfDrawTextf(d, WF_XY(label), 13, role, side.x < 0 ? 1 : -1, "%s %.2f m",
                s.distance < 0 ? "overlap" : "gap", (double)wfAbs(s.distance));
    wfDrawArrow(d, WF_XY(origin), WF_XY(tip), 2, role);
}

static void rest_softly(wfWorldDef *def)
{
    def->gravity = wfV2(0, 0);
    def->advanced.positionCorrection = 0;
}

static void draw_clip(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    wfBodyView v = wfWorldBodies(world);
    int32_t test = testing_body(in);
    for (int32_t i = TESTING_BODIES; i < v.count; i++) {
        wfManifold m;
        wfTransform xa = wfBodyTransform(&v.state[test]), xb = wfBodyTransform(&v.state[i]);
        int count = wfCollide(&v.shapes[v.props[test].shape], xa,
                              &v.shapes[v.props[i].shape], xb, &m);
        for (int p = 0; p < count; p++) {
            wfVec2 at = m.points[p].point;
            wfVec2 to = wfAddScaled(at, m.points[p].depth, m.normal);
            wfDrawPoint(d, WF_XY(at), 9, WF_INK_ACCENT);
            wfDrawArrow(d, WF_XY(at), WF_XY(to), 2, WF_INK_BAD);
            wfDrawTextf(d, (float)at.x + 0.12f, (float)at.y + 0.12f, 13, WF_INK_TEXT, -1,
                        "%.2f m", (double)m.points[p].depth);
        }
    }
}

static wfResult build_drift(wfWorld *world)
{
    Maker m = { world, WF_OK };
    wfRandom r;
    wfRandomSeed(&r, 6);
    put_room(&m, 9, 5, 1);
    for (int i = 0; i < 60; i++) {
        wfReal x = WF_R(1.5) * (wfReal)(i % 10) - WF_R(6.75);
        wfReal y = 1 + WF_R(1.5) * (wfReal)(i / 10);
        wfReal size = wfRandomReal(&r, WF_R(0.12), WF_R(0.45));
        wfBodyDef b = i % 3 == 0 ? ball(&m, x, y, size)
                    : i % 3 == 1 ? box(&m, x, y, size, WF_R(0.6) * size)
                                 : regular(&m, x, y, size, 3 + i % 4);
        b.angle = wfRandomReal(&r, -3, 3);
        wfReal vx = wfRandomReal(&r, -2, 2);
        b.velocity = wfV2(vx, wfRandomReal(&r, -2, 2));
        b.restitution = 1;
        put(&m, &b);
    }
    return m.result;
}

static void mark_node(const wfWorld *world, wfDraw *d, const wfQuadTree *tree, int32_t node)
{
    wfBodyView v = wfWorldBodies(world);
    wfDrawRect(d, wfQuadTreeRect(tree, node), 4, WF_INK_ACCENT);
    for (int32_t i = 0; i < v.count; i++)
        if (v.props[i].shape >= 0 && wfQuadTreeNodeOf(tree, v.props[i].shape) == node)
            wfDrawPoint(d, WF_XY(v.state[i].p), 10, WF_INK_ACCENT);
}

/* Would words at this place cover those written before? */
static bool is_crowded(const wfVec2 *written, int count, wfVec2 at, wfReal near)
{
    for (int k = 0; k < count; k++) {
        wfVec2 by = wfAbs2(wfSub(written[k], at));
        if (by.x < near && by.y < near / 3) return true;
    }
    return false;
}

static void write_nodes(const wfWorld *world, wfDraw *d, const wfQuadTree *tree)
{
    static const char *const sector[] = { "BL", "BR", "TL", "TR" };
    wfBodyView v = wfWorldBodies(world);
    bool upright = d->view[3] - d->view[1] > d->view[2] - d->view[0];   /* a telephone */
    wfReal near = upright ? WF_R(1.6) : WF_R(0.8);
    enum { MOST = 100 };
    wfVec2 written[MOST];
    int count = 0;
    for (int32_t i = 0; i < v.count; i++) {
        int32_t path[WF_QUAD_MAX_DEPTH], shape = v.alive[i] ? v.props[i].shape : -1;
        int32_t node = shape >= 0 ? wfQuadTreeNodeOf(tree, shape) : -1;
        if (node < 0 || v.props[i].type == WF_STATIC ||
            is_crowded(written, count, v.state[i].p, near)) continue;
        if (count < MOST) written[count++] = v.state[i].p;
        int depth = wfQuadTreePath(tree, node, path);
        wfVec2 above = wfAdd(v.state[i].p, wfV2(0, WF_R(0.3)));
        wfDrawTextf(d, WF_XY(above), 11, WF_INK_TEXT, 0, "%s%s%s",
                    depth > 0 ? sector[path[0]] : "root", depth > 1 ? " " : "",
                    depth > 1 ? sector[path[1]] : "");
    }
}

static void draw_nodes(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    enum { BYTES = 256 * 1024 };
    _Alignas(WF_POOL_ALIGN) uint8_t bytes[BYTES];
    wfPool pool;
    wfProxies proxies;
    wfQuadTree tree;
    if (wfPoolInit(&pool, BYTES, bytes) != WF_OK ||
        wfWorldProxies(world, &proxies) != WF_OK ||
        wfQuadTreeBuild(&tree, &pool, &proxies) != WF_OK)
        return;
    int32_t best = -1;                  /* nodes are nested: the deepest is the smallest */
    for (int32_t n = 0; n < tree.nodeHigh; n++)
        if (wfQuadTreeUses(&tree, n) &&
            wfRectHasPoint(wfQuadTreeRect(&tree, n), in->mouse) &&
            (best < 0 || tree.nodes[n].depth > tree.nodes[best].depth))
            best = n;
    if (best >= 0) mark_node(world, d, &tree, best);
    write_nodes(world, d, &tree);
}

static void by_quad_tree(wfWorldDef *def)
{
    without_gravity(def);
    int row = wfFindBroadPhase("quad-tree");      /* -1: left out of this build */
    if (row >= 0) def->advanced.broadPhase = row;
}

static void push_out_at_once(wfWorldDef *def)
{
    integrated_freely(def);
    def->advanced.positionCorrection = 1;
    def->advanced.slop = WF_R(0.001);
}

static void draw_wish(const wfWorld *world, wfDraw *d, const wfSceneInput *in)
{
    wfBodyView v = wfWorldBodies(world);
    int32_t test = testing_body(in);
    wfTransform wish = wfMakeTransform(in->mouse, in->turn);
    const wfShape *s = &v.shapes[v.props[test].shape];
    wfVec2 rim[WF_RIM_POINTS];
    int n = wfShapeOutline(s, wish, rim);
    for (int i = 0; s->kind != WF_SHAPE_CIRCLE && i < n; i++) {
        wfVec2 a = rim[i], b = rim[(i + 1) % n];
        wfDrawDashed(d, WF_XY(a), WF_XY(b), 1.5f, WF_INK_ACCENT);
    }
    if (s->kind == WF_SHAPE_CIRCLE)
        wfDrawCircle(d, WF_XY(in->mouse), (float)s->radius, 1, WF_INK_ACCENT, WF_INK_NONE);
    wfDrawArrow(d, WF_XY(in->mouse), WF_XY(v.state[test].p), 2, WF_INK_BAD);
}

static const wfScene row[] = {
    { .category = "Test cases", .name = "TC01 masses", .chapter = "bodies",
      .text = "The same force on masses 1 to 4: distances are as 1, 1/2, 1/3, 1/4.",
      .define = without_gravity, .build = build_forces, .update = update_forces,
      .draw = draw_forces, VIEW(0.5, 2.2, 8), PROMISE(-1, -1) },
    { .category = "Test cases", .name = "TC02 arms", .chapter = "bodies",
      .text = "The same force, ever farther off the centre: all go as far, but spin.",
      .define = without_gravity, .build = build_rotation, .update = update_rotation,
      .draw = draw_arms, VIEW(0.5, 2.2, 8), PROMISE(-1, -1) },
    { .category = "Test cases", .name = "TC03 separating axis", .chapter = "narrow-phase",
      .text = "The axis on which the closest body overlaps least, or is farthest.",
      .define = rest_softly, .build = build_gallery, .update = place_testing_body,
      .draw = draw_axis, VIEW(0, 0, 9), SHAPE(1.2), TESTING, PROMISE(-1, -1) },
    { .category = "Test cases", .name = "TC04 contact points", .chapter = "contacts",
      .text = "Where the testing body touches the others, and how deep (red arrows).",
      .define = rest_softly, .build = build_gallery, .update = place_testing_body,
      .draw = draw_clip, VIEW(0, 0, 9), SHAPE(1.2), TESTING, PROMISE(-1, -1) },
    { .category = "Test cases", .name = "TC05 colours", .chapter = "narrow-phase",
      .text = "A body that touches another is red, else white.",
      .define = rest_softly, .build = build_gallery, .update = place_testing_body,
      VIEW(0, 0, 9), SHAPE(1.2), .show = WF_SHOW_TOUCHING, TESTING, PROMISE(-1, -1) },
    { .category = "Test cases", .name = "TC06 quad tree", .chapter = "broad-phase",
      .text = "Each body says which node holds it; the one that you point at is marked.",
      .define = by_quad_tree, .build = build_drift, .draw = draw_nodes, VIEW(0, 5, 12),
      .points = 1,
      .show = WF_SHOW_TREE, PROMISE(0.05, 0.2) },
    { .category = "Test cases", .name = "TC07 pairs", .chapter = "broad-phase",
      .text = "A red line joins each potential pair: boxes round the bodies that overlap.",
      .define = without_gravity, .build = build_drift, VIEW(0, 5, 12),
      .show = WF_SHOW_PAIRS | WF_SHOW_BOUNDS, PROMISE(0.05, 0.2) },
    { .category = "Test cases", .name = "TC08 positional correction", .chapter = "impulses",
      .text = "Press the body against another: it is moved out until the edges barely touch.",
      .define = push_out_at_once, .build = build_gallery, .update = place_testing_body,
      .draw = draw_wish, VIEW(0, 0, 9), SHAPE(1.2), TESTING, PROMISE(-1, -1) },
};
const wfSceneGroup wfCaseScenes = { row, sizeof row / sizeof *row };
