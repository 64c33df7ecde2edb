/* operations.h: an operation for every function of the world's API. Included by abuse.c. */

/* ---- a world's life ---------------------------------------------------------------------------------------------------- */
static wfResult op_world_size(Session *s)
{
    wfWorldDef d = world_def(s);
    size_t permanent = 1, transient = 1;
    int32_t fault = 0; (void)fault;
    wfResult r = wfWorldSize(below(s, 20) ? &d : NULL, &permanent, &transient);
    MUST((int)r >= 0 && r < WF_RESULT_COUNT);
    if (r != WF_OK) MUST(permanent == 1 && transient == 1);
    return r;
}
enum { MOST_ARRAYS = 256 };
static wfResult op_regions(Session *s)
{
    static wfRegion list[MOST_ARRAYS];
    MUST(wfRegionCount <= MOST_ARRAYS);
    wfWorldDef d = world_def(s);
    return wfWorldRegions(below(s, 20) ? &d : NULL, below(s, 20) ? list : NULL);
}
static wfResult op_create(Session *s)           /* another world beside, with too little memory or enough, and away again */
{
    wfWorldDef d = world_def(s);
    wfWorld other = { .memory = { .owned = 0 } };
    size_t size[2];
    if (wfWorldSize(&d, &size[0], &size[1]) != WF_OK) { wfResult r = wfCreateWorld(&d, &other); MUST(r != WF_OK && !other.memory.permanent); return r; }
    if (size[0] > 1 << 22 || size[1] > 1 << 23) return WF_ERROR_MEMORY;
    uint8_t *a = aligned_alloc(16, size[0]), *b = aligned_alloc(16, size[1]);
    size_t less = below(s, 3) ? 0 : 1 + below(s, (uint32_t)size[0]), shift = below(s, 4) ? 0 : 8;
    d.memory = (wfMemory){ a + shift, size[0] - less, b, size[1], 0 };
    wfResult r = shift && !less ? WF_ERROR_MEMORY : wfCreateWorld(&d, below(s, 30) ? &other : NULL);
    if (less || shift) MUST(r != WF_OK);
    if (r == WF_OK && d.substeps < 99 && d.iterations < 99) MUST(wfStepWorld(&other) != WF_ERROR_NULL);
    if (below(s, 2)) wfDestroyWorld(&other);
    wfDestroyWorld(&other);
    wfDestroyWorld(NULL);
    free(a); free(b);
    return r;
}
static wfResult op_destroy(Session *s)          /* and once more; every call on it fails; then there is a new one */
{
    wfWorld old;
    if (s->inHook) return WF_OK;
    drop_world(s);
    old = s->world;
    wfDestroyWorld(&s->world);
    MUST(wfStepWorld(&old) == WF_ERROR_NULL && wfBodyCount(&old) == 0);
    make_world(s);
    return WF_OK;
}
static wfResult op_open(Session *s)             /* the block moves to another address; the old place is filled with rubbish */
{
    wfMemory m = s->world.memory;
    wfWorld moved;
    if (s->inHook || !s->given) return WF_ERROR_NULL;
    m.permanent = s->chunk[1 - s->side];
    memcpy(m.permanent, s->world.memory.permanent, s->size[0]);
    if (below(s, 16) == 0) {
        wfMemory bad = m;
        if (below(s, 2)) bad.permanentSize = below(s, (uint32_t)s->size[0]); else bad.transientSize = below(s, (uint32_t)s->size[1]);
        MUST(wfOpenWorld(&bad, &moved) != WF_OK && wfOpenWorld(NULL, &moved) != WF_OK && wfOpenWorld(&m, NULL) != WF_OK);
    }
    MUST(wfOpenWorld(&m, &moved) == WF_OK);
    memset(s->world.memory.permanent, 0xab, s->size[0]);
    s->world = moved;
    s->side = 1 - s->side;
    return WF_OK;
}

/* ---- bodies ------------------------------------------------------------------------------------------------------------- */
static wfResult op_add_body(Session *s)
{
    wfBodyDef d = wfDefaultBodyDef();
    wfBodyId id = { 0, 0 };
    d.type = chance(s, 180) ? WF_DYNAMIC : whole(s, 0, 2);
    d.position = vector(s, 5);
    d.angle = real(s, 3);
    d.velocity = d.type == WF_STATIC ? wfV2(0, 0) : vector(s, chance(s, 20) ? 500 : 5);
    d.angularVelocity = d.type == WF_STATIC ? 0 : real(s, 10);
    if (chance(s, 220)) d.shape = shape(s);
    d.density = WF_R(0.1) + more(s, 5);
    if (d.shape.kind == WF_SHAPE_NONE || chance(s, 40)) d.mass = WF_R(0.1) + more(s, 5);
    bool before = s->poisoned;
    d.restitution = more(s, 1); d.friction = more(s, 1);
    s->poisoned = s->poisoned || before;
    d.fixedRotation = chance(s, 20) ? yes(s) : 0;
    if (d.fixedRotation && !s->poisoned && chance(s, 180)) d.angularVelocity = 0;
    if (chance(s, 30)) { d.linearDamping = more(s, 2); d.angularDamping = more(s, 2); d.gravityScale = real(s, 2); }
    d.neverSleeps = chance(s, 20) ? yes(s) : 0;
    wfResult r = CALL(wfAddBodyToWorld(handle(s), &d, &id));
    if (r == WF_OK) { MUST(!s->inHook); learn(&s->bodies, id.index, id.generation, 0, 0, 0); }
    if (r == WF_OK) { wfShapeId h = wfFirstShape(&s->world, id); if (h.index) learn(&s->shapes, h.index, h.generation, 0, 0, id.index); }
    return r;
}
static wfResult op_remove_body(Session *s)
{
    if (s->bodies.alive > 1 && chance(s, 150)) return WF_ERROR_UNKNOWN;         /* let some of them live */
    wfBodyId id = pick_bodies(s);
    wfResult r = CALL(wfRemoveBodyFromWorld(handle(s), id));
    if (r != WF_OK) return r;
    MUST(!s->inHook);
    int32_t i = (int32_t)id.index - 1;
    forget(&s->bodies, find(&s->bodies, id.index, id.generation));
    for (int k = 0; k < s->shapes.count; k++) if (s->shapes.list[k].owner == id.index) forget(&s->shapes, k);
    for (int k = 0; k < s->forces.count; k++) if (s->forces.list[k].a == i || s->forces.list[k].b == i) forget(&s->forces, k);
    for (int k = 0; k < s->joints.count; k++) if (s->joints.list[k].a == i || s->joints.list[k].b == i) forget(&s->joints, k);
    MUST(wfRemoveBodyFromWorld(&s->world, id) == WF_ERROR_STALE_ID);
    return r;
}
static wfResult op_get_body(Session *s)
{
    wfBodyInfo info;
    return CALL(wfGetBody(handle(s), pick_bodies(s), below(s, 40) ? &info : NULL));
}
static wfResult op_get_body_shape(Session *s)
{
    wfShape out;
    return CALL(wfGetBodyShape(handle(s), pick_bodies(s), below(s, 40) ? &out : NULL));
}
static wfResult op_names(Session *s)            /* ids and indices, back and forth */
{
    const wfWorld *w = handle(s);
    wfBodyId b = pick_bodies(s);
    bool staleBody = stale;
    wfShapeId h = (stale = false, pick_shapes(s));
    bool staleShape = stale;
    bool bad = s->badHandle;
    MUST(wfBodyIsValid(w, b) == (!bad && !staleBody) && wfShapeIsValid(w, h) == (!bad && !staleShape));
    MUST((wfBodyIndex(w, b) >= 0) == (!bad && !staleBody) && (wfShapeIndex(w, h) >= 0) == (!bad && !staleShape));
    int32_t i = whole(s, -3, 40);
    if (bad) MUST(wfBodyAt(w, i).index == 0 && wfShapeAt(w, i).index == 0 && wfJointAt(w, i).index == 0 && wfForceAt(w, i).index == 0);
    wfBodyId at = wfBodyAt(w, i);
    if (at.index) MUST(wfBodyIsValid(w, at) && wfBodyIndex(w, at) == i);
    wfShapeId shapeAt = wfShapeAt(w, i);
    if (shapeAt.index) MUST(wfShapeIsValid(w, shapeAt) && wfShapeIndex(w, shapeAt) == i);
    if (bad || staleShape) MUST(wfShapeBody(w, h).index == 0 && wfNextShape(w, h).index == 0);
    if (bad || staleBody) MUST(wfFirstShape(w, b).index == 0);
    return WF_OK;
}

/* ---- shapes and materials ---------------------------------------------------------------------------------------------------- */
static wfShapeDef shape_def(Session *s)
{
    wfShapeDef d = wfDefaultShapeDef();
    d.shape = shape(s);
    if (d.shape.kind == WF_SHAPE_NONE) wfMakeCircle(wfV2(0, 0), WF_R(0.2), &d.shape);
    d.density = more(s, 3);
    d.restitution = more(s, 1); d.friction = more(s, 1);
    if (chance(s, 60)) { d.staticFriction = more(s, 1); d.rollingResistance = more(s, WF_R(0.1)); d.tangentSpeed = real(s, 3); }
    if (chance(s, 60)) d.filter = (wfFilter){ next(s), next(s), (int32_t)below(s, 5) - 2 };
    d.sensor = chance(s, 40) ? yes(s) : 0;
    d.material = chance(s, 60) ? whole(s, 0, 3) : 0;
    return d;
}
static wfResult op_add_shape(Session *s)
{
    wfShapeDef d = shape_def(s);
    wfShapeId id = { 0, 0 };
    wfBodyId body = pick_bodies(s);
    wfResult r = CALL(wfAddShapeToBody(handle(s), body, &d, &id));
    if (r == WF_OK) { MUST(!s->inHook); learn(&s->shapes, id.index, id.generation, 0, 0, body.index); }
    return r;
}
static wfResult op_add_shapes(Session *s)
{
    wfShapeDef list[4];
    wfShapeId ids[4] = { { 0, 0 } };
    int32_t n = chance(s, 8) ? whole(s, -1, 4) : (int32_t)below(s, 5);
    for (int i = 0; i < 4; i++) { bool p = s->poisoned; list[i] = shape_def(s); if (i >= n) s->poisoned = p; }
    if (n > 4) n = -1;
    wfBodyId body = pick_bodies(s);
    wfResult r = CALL(wfAddShapesToBody(handle(s), body, n > 0 || below(s, 2) ? list : NULL, n, ids));
    if (r == WF_OK) MUST(!s->inHook || n == 0);
    if (r == WF_OK) for (int i = 0; i < n; i++) learn(&s->shapes, ids[i].index, ids[i].generation, 0, 0, body.index);
    return r;
}
static wfResult op_add_chain(Session *s)
{
    wfVec2 p[4];
    wfShapeDef like = shape_def(s);
    wfShapeId ids[4] = { { 0, 0 } };
    int32_t n = (int32_t)below(s, 5);
    bool loop = below(s, 2);
    for (int i = 0; i < 4; i++) p[i] = vector(s, 5);
    wfBodyId body = pick_bodies(s);
    wfResult r = CALL_LOOSE(wfAddChainToBody(handle(s), body, below(s, 40) ? p : NULL, n, loop, below(s, 40) ? &like : NULL, ids));
    if (r == WF_OK) for (int i = 0; i < (loop ? n : n - 1); i++) learn(&s->shapes, ids[i].index, ids[i].generation, 0, 0, body.index);
    return r;
}
static wfResult op_remove_shape(Session *s)
{
    wfShapeId id = pick_shapes(s);
    wfResult r = CALL(wfRemoveShapeFromWorld(handle(s), id));
    if (r == WF_OK) { MUST(!s->inHook); forget(&s->shapes, find(&s->shapes, id.index, id.generation)); }
    if (r == WF_OK) MUST(wfRemoveShapeFromWorld(&s->world, id) == WF_ERROR_STALE_ID);
    return r;
}
static wfResult op_get_shape(Session *s)
{
    wfShapeDef d;
    return CALL(wfGetShape(handle(s), pick_shapes(s), below(s, 40) ? &d : NULL));
}
static wfResult op_set_shape(Session *s)
{
    wfShapeId id = pick_shapes(s);
    wfShapeDef d = shape_def(s), now;
    if (chance(s, 100) && wfGetShape(&s->world, id, &now) == WF_OK) { d = now; s->poisoned = false; d.friction = more(s, 1); }
    wfResult r = CALL(wfSetShape(handle(s), id, &d));
    if (s->inHook) MUST(r != WF_OK);
    return r;
}
static wfResult op_set_pair_material(Session *s)
{
    wfPairMaterial m = { more(s, 1), more(s, 1), more(s, 1), more(s, WF_R(0.1)) };
    int32_t a = whole(s, 1, 3), b = whole(s, 1, 3);
    bool none = below(s, 6) == 0;
    if (none) s->poisoned = false;
    return CALL(wfSetPairMaterial(handle(s), a, b, none ? NULL : &m));
}
static wfResult op_get_pair_material(Session *s)
{
    wfPairMaterial m;
    int32_t a = whole(s, 1, 3), b = whole(s, 1, 3);
    return CALL(wfGetPairMaterial(handle(s), a, b, below(s, 30) ? &m : NULL));
}

/* ---- pushing and changing bodies --------------------------------------------------------------------------------------------- */
static wfResult op_set_transform(Session *s)
{
    wfBodyId id = pick_bodies(s);
    wfVec2 p = vector(s, 5);
    wfReal angle = real(s, 4);
    wfResult r = CALL(wfSetBodyTransform(handle(s), id, p, angle));
    if (s->inHook) MUST(r != WF_OK);
    return r;
}
static wfResult op_set_velocity(Session *s)
{
    wfBodyId id = pick_bodies(s);
    wfVec2 v = vector(s, chance(s, 30) ? 1000 : 5);
    wfReal w = real(s, 10);
    return CALL(wfSetBodyVelocity(handle(s), id, v, w));
}
static wfResult op_set_mass(Session *s)
{
    wfBodyId id = pick_bodies(s);
    wfReal mass = chance(s, 20) ? tens(s, -30, 30) : more(s, 5);
    return CALL(wfSetBodyMass(handle(s), id, mass));
}
static wfResult op_change_type(Session *s)
{
    wfBodyId id = pick_bodies(s);
    int type = chance(s, 200) ? WF_DYNAMIC : whole(s, 0, 2);
    return CALL(wfChangeBodyType(handle(s), id, type));
}
static wfResult op_set_material(Session *s)
{
    wfBodyId id = pick_bodies(s);
    wfReal e = more(s, 1), mu = more(s, 1);
    return CALL(wfSetBodyMaterial(handle(s), id, e, mu));
}
static wfResult op_set_damping(Session *s)
{
    wfBodyId id = pick_bodies(s);
    wfReal a = more(s, 2), b = more(s, 2);
    return CALL(wfSetBodyDamping(handle(s), id, a, b));
}
static wfResult op_more_of_body(Session *s)
{
    wfBodyId id = pick_bodies(s);
    wfWorld *w = handle(s);
    wfMassData m = { 0 };
    int32_t fixed;
    switch (below(s, 4)) {
    case 0: { wfReal scale = real(s, 2); return CALL(wfSetBodyGravityScale(w, id, scale)); }
    case 1: m.mass = more(s, 5); m.inertia = more(s, 5); m.centre = vector(s, 1); return CALL(wfSetBodyMassData(w, id, &m));
    case 2: fixed = yes(s); return CALL(wfSetBodyFixedRotation(w, id, fixed));
    default: return CALL(wfSetBodyUserData(w, id, next(s)));
    }
}
static wfResult op_target(Session *s)
{
    wfBodyId id = pick_bodies(s);
    wfVec2 to = vector(s, 5);
    wfReal angle = real(s, 4), seconds = WF_R(0.01) + more(s, 1);
    return CALL(wfSetBodyTarget(handle(s), id, to, angle, seconds));
}
static wfResult op_shape_data(Session *s)
{
    wfShapeId id = pick_shapes(s);
    return CALL(wfSetShapeUserData(handle(s), id, next(s)));
}
static wfResult op_enable(Session *s)
{
    wfBodyId id = pick_bodies(s);
    int32_t enabled = yes(s);
    wfResult r = CALL(wfEnableBody(handle(s), id, enabled));
    if (r == WF_OK) MUST(wfBodyIsEnabled(&s->world, id) == (enabled == 1));
    return r;
}
static void see_shape(void *context, wfShapeId id, const wfVec2 *outline, int32_t count)
{
    (void)id;
    if (count < 2 || count > WF_OUTLINE_POINTS) *(bool *)context = false;
    for (int32_t i = 0; i < count; i++) if (!wfIsFinite2(outline[i])) *(bool *)context = false;
}
static wfResult op_draw(Session *s)
{
    bool good = true;
    wfDrawCallbacks draw = { .context = &good, .shape = see_shape };
    wfResult r = wfDrawWorld(handle(s), below(s, 20) ? &draw : NULL);
    MUST(good);
    return r;
}
static wfResult op_mover(Session *s)
{
    wfMover m = wfDefaultMover();
    m.position = vector(s, 5); m.velocity = vector(s, 20); m.oneWay = next(s);
    if (below(s, 2)) { const Thing *t = pick(s, &s->shapes); m.ground = (wfShapeId){ t->index, t->generation }; }
    stale = false;
    wfReal seconds = more(s, 1);
    wfResult r = wfMoveMover(handle(s), below(s, 20) ? &m : NULL, seconds);
    return r;
}
static wfResult op_push(Session *s)
{
    wfMover m = wfDefaultMover();
    m.position = vector(s, 5);
    wfVec2 velocity = vector(s, 20);
    return CALL(wfPushBodies(handle(s), below(s, 20) ? &m : NULL, velocity));
}
static wfResult op_advance(Session *s)
{
    double seconds = (double)more(s, 1) / 20;
    int32_t most = 1;           /* of several steps those before the one that fails are done: test_in_a_game */
    wfReal share = wfStepShare(&s->world);
    MUST(share >= 0 && share <= 1 && wfPoseBetween(wfTransformIdentity(), wfTransformIdentity(), share).p.x == 0);
    return CALL(wfAdvanceWorld(handle(s), seconds, most));
}
static wfResult op_joint_data(Session *s)
{
    wfJointId id = pick_joints(s);
    return CALL(wfSetJointUserData(handle(s), id, next(s)));
}
static wfResult op_points(Session *s)           /* there and back; all contacts of a body, and its joints, and no others */
{
    const wfWorld *w = handle(s);
    wfBodyId id = pick_bodies(s);
    wfVec2 p = wfV2(unit(s), unit(s)), v = wfBodyWorldVector(w, id, p);
    int32_t i = wfBodyIndex(w, id), n = 0, mine = 0, joints = 0;
    MUST(wfIsFinite2(v) && wfLengthSq(wfSub(wfBodyLocalVector(w, id, v), p)) <= 1000 * WF_EPSILON * WF_EPSILON);
    if (s->badHandle || stale) MUST(wfLengthSq(wfSub(wfBodyLocalPoint(w, id, wfBodyWorldPoint(w, id, p)), p)) == 0 && wfLengthSq(wfBodyVelocityAt(w, id, p)) == 0);
    const wfContact *all = wfWorldContacts(w, &n), *c = NULL;
    for (int32_t k = 0; k < n; k++) mine += i >= 0 && (all[k].a == i || all[k].b == i);
    while ((c = wfNextContact(w, id, c)) != NULL) { MUST(c->a == i || c->b == i); mine--; }
    for (wfJointId j = wfNextJoint(w, id, (wfJointId){ 0, 0 }); j.index != 0; j = wfNextJoint(w, id, j)) {
        wfReal at = 0, rate = 0;
        wfResult r = wfGetJointMotion(w, j, &at, &rate);
        MUST(r == WF_OK || r == WF_ERROR_UNKNOWN);
        joints++;
    }
    MUST(mine == 0 && joints <= wfJointCount(w));
    return WF_OK;
}
static wfResult op_apply_force(Session *s)
{
    wfBodyId id = pick_bodies(s);
    wfVec2 f = vector(s, 50), p = vector(s, 5);
    return CALL(wfApplyForceToBody(handle(s), id, f, p));
}
static wfResult op_apply_torque(Session *s)
{
    wfBodyId id = pick_bodies(s);
    wfReal t = real(s, 50);
    return CALL(wfApplyTorqueToBody(handle(s), id, t));
}
static wfResult op_apply_impulse(Session *s)
{
    wfBodyId id = pick_bodies(s);
    wfVec2 f = vector(s, 5), p = vector(s, 5);
    return CALL(wfApplyImpulseToBody(handle(s), id, f, p));
}
static wfResult op_apply_spin(Session *s)
{
    wfBodyId id = pick_bodies(s);
    wfReal j = real(s, 5);
    return CALL(wfApplyAngularImpulseToBody(handle(s), id, j));
}

/* ---- forces ------------------------------------------------------------------------------------------------------------------- */
static wfForce force(Session *s)
{
    wfForce f;
    memset(&f, 0, sizeof f);
    int32_t a = pick_index(s), b = pick_index(s);
    stale = false;                              /* a force names indices: whether they are empty is the engine's to say */
    switch (below(s, 9)) {
    case 0: f = wfGravity(vector(s, 5)); break;
    case 1: f = wfPointGravity(vector(s, 5), real(s, 20), more(s, 1)); break;
    case 2: f = wfDrag(more(s, 1), more(s, 1)); break;
    case 3: f = wfBuoyancy(real(s, 3), more(s, 3), more(s, 10), more(s, 3)); break;
    case 4: f = wfExplosion(vector(s, 3), real(s, 30), more(s, 5), real(s, 5), more(s, 2)); break;
    case 5: f = wfWind(vector(s, 9), more(s, 1)); break;
    case 6: f = wfSpring(a, vector(s, 1), b, vector(s, 1), more(s, 2), more(s, 100), more(s, 5)); break;
    case 7: f = wfBungee(a, vector(s, 1), b, vector(s, 1), more(s, 2), more(s, 100), more(s, 5)); break;
    default: f = wfSpringToPoint(a, vector(s, 1), vector(s, 4), more(s, 2), more(s, 100), more(s, 5)); break;
    }
    if (chance(s, 20)) f.a = a;
    if (chance(s, (uint32_t)s->wild)) f.kind = whole(s, -1, wfForceKinds);
    return f;
}
static wfResult op_add_force(Session *s)
{
    wfForce f = force(s);
    wfForceId id = { 0, 0 };
    wfResult r = CALL_LOOSE(wfAddForceToWorld(handle(s), below(s, 50) ? &f : NULL, &id));
    if (r == WF_OK) { MUST(!s->inHook); learn(&s->forces, id.index, id.generation, f.a, f.b, 0); }
    return r;
}
static wfResult op_remove_force(Session *s)
{
    wfForceId id = pick_forces(s);
    wfResult r = CALL(wfRemoveForceFromWorld(handle(s), id));
    if (r == WF_OK) { MUST(!s->inHook); forget(&s->forces, find(&s->forces, id.index, id.generation)); }
    return r;
}
static wfResult op_get_force(Session *s)
{
    wfForce f;
    return CALL(wfGetForce(handle(s), pick_forces(s), below(s, 40) ? &f : NULL));
}
static wfResult op_set_force(Session *s)
{
    wfForce f = force(s);
    wfForceId id = pick_forces(s);
    wfResult r = CALL_LOOSE(wfSetForce(handle(s), id, &f));
    if (r == WF_OK) { Thing *t = &s->forces.list[find(&s->forces, id.index, id.generation)]; t->a = f.a; t->b = f.b; }
    return r;
}
static wfResult op_gravity(Session *s)
{
    wfVec2 g = vector(s, 10);
    return CALL(wfSetGravity(handle(s), g));
}
static wfResult op_get_gravity(Session *s)
{
    wfVec2 g;
    wfResult r = CALL(wfGetGravity(handle(s), below(s, 40) ? &g : NULL));
    if (r == WF_OK) MUST(wfIsFinite2(g));
    return r;
}
static wfResult op_grab(Session *s)
{
    wfBodyId id = pick_bodies(s);
    wfVec2 p = vector(s, 5);
    wfForceId hand = { 0, 0 };
    wfResult r = CALL(wfAddMouseJoint(handle(s), id, p, &hand));
    if (r == WF_OK) { MUST(!s->inHook); learn(&s->forces, hand.index, hand.generation, (int32_t)id.index - 1, -1, 0); }
    return r;
}
static wfResult op_drag(Session *s)
{
    wfForceId id = pick_forces(s);
    wfVec2 p = vector(s, 5);
    return CALL(wfSetMouseTarget(handle(s), id, p));
}

/* ---- joints ------------------------------------------------------------------------------------------------------------------- */
static const char *joint_kind(Session *s) { return below(s, 40) ? wfJointTable[below(s, (uint32_t)wfJointKinds)].name : below(s, 2) ? "glue" : NULL; }
static wfResult join(Session *s, wfJoint *j)
{
    wfBodyId a = pick_bodies(s), b = pick_bodies(s);
    wfVec2 anchorA = vector(s, 3), anchorB = vector(s, 3), axis = vector(s, 1);
    wfResult r = CALL_LOOSE(wfDefineJoint(handle(s), joint_kind(s), a, b, anchorA, anchorB, axis, j));
    if (r != WF_OK) return r;
    j->flags = (int32_t)below(s, 32);
    if (chance(s, 200)) j->flags &= WF_JOINT_SPRING | WF_JOINT_MOTOR | WF_JOINT_LIMITS | WF_JOINT_COLLIDE;
    j->lower = real(s, 1) - 1; j->upper = j->lower + more(s, 2);
    j->stiffness = more(s, 100); j->damping = more(s, 5); j->springForce = more(s, 50);
    j->motorSpeed = real(s, 5); j->motorForce = more(s, 50);
    if (chance(s, 60)) { j->breakForce = more(s, 50); j->breakTorque = more(s, 50); }
    if (chance(s, (uint32_t)s->wild)) (&j->localA.x)[below(s, 12)] = wild(s);
    if (chance(s, (uint32_t)s->wild)) (&j->kind)[below(s, 4)] = whole(s, -2, 30);
    return r;
}
static wfResult op_join(Session *s)
{
    wfJoint j;
    return join(s, &j);
}
static wfResult op_tune(Session *s)
{
    wfJoint j;
    if (join(s, &j) != WF_OK) return WF_ERROR_NULL;
    wfReal frequency = more(s, 10), ratio = more(s, 1);
    return CALL_LOOSE(wfTuneJointSpring(handle(s), below(s, 20) ? &j : NULL, frequency, ratio));
}
static wfResult op_add_joint(Session *s)
{
    wfJoint j;
    wfJointId id = { 0, 0 };
    if (join(s, &j) != WF_OK) return WF_ERROR_UNKNOWN;
    stale = false;
    wfResult r = CALL_LOOSE(wfAddJointToWorld(handle(s), &j, &id));
    if (r == WF_OK) { MUST(!s->inHook); learn(&s->joints, id.index, id.generation, j.a, j.b, 0); }
    return r;
}
static wfResult op_remove_joint(Session *s)
{
    wfJointId id = pick_joints(s);
    wfResult r = CALL(wfRemoveJointFromWorld(handle(s), id));
    if (r == WF_OK) { MUST(!s->inHook); forget(&s->joints, find(&s->joints, id.index, id.generation)); }
    return r;
}
static wfResult op_get_joint(Session *s)
{
    wfJoint j;
    wfVec2 f;
    wfReal t;
    wfJointId id = pick_joints(s);
    wfResult r = CALL(wfGetJoint(handle(s), id, below(s, 40) ? &j : NULL));
    if (r == WF_OK) MUST(wfGetJointLoad(&s->world, id, below(s, 4) ? &f : NULL, below(s, 4) ? &t : NULL) == WF_OK);
    return r;
}
static wfResult op_joint_load(Session *s)
{
    wfVec2 f = wfV2(0, 0);
    wfReal t = 0;
    return CALL(wfGetJointLoad(handle(s), pick_joints(s), &f, &t));
}
static wfResult op_joint_peak(Session *s)
{
    wfReal f = 0, t = 0;
    return CALL(wfGetJointPeak(handle(s), pick_joints(s), &f, &t));
}
static wfResult op_set_joint(Session *s)
{
    wfJoint j;
    wfJointId id = pick_joints(s);
    stale = false;
    if (chance(s, 128) || wfGetJoint(&s->world, id, &j) != WF_OK) { if (join(s, &j) != WF_OK) return WF_ERROR_UNKNOWN; }
    else { j.motorSpeed = real(s, 5); j.flags &= ~WF_JOINT_BROKEN; }
    stale = find(&s->joints, id.index, id.generation) < 0;
    wfResult r = CALL_LOOSE(wfSetJoint(handle(s), id, &j));
    if (r == WF_OK) { Thing *t = &s->joints.list[find(&s->joints, id.index, id.generation)]; t->a = j.a; t->b = j.b; }
    return r;
}
static wfResult op_look_at_joints(Session *s)
{
    const wfWorld *w = handle(s);
    int32_t n = -1, places = wfWorldJointPlaces(w), seenJoints = 0;
    for (int32_t i = 0; i < places; i++) seenJoints += wfJointAt(w, i).index != 0;
    MUST(seenJoints == wfJointCount(w) && wfDirectJointCount(w) >= 0 && wfUnsolvedSubsteps(w) >= 0);
    (void)wfAllJointsDirect(w);
    const wfJointId *broken_ = wfBrokenJoints(w, &n);
    MUST(n >= 0 && (n == 0 || broken_ != NULL));
    return WF_OK;
}

static wfResult op_body_substeps(Session *s)
{
    wfWorld *w = handle(s);
    wfBodyId id = pick_bodies(s);
    int32_t few = whole(s, 0, 4);
    wfResult r = CALL(wfSetBodySubsteps(w, id, few));
    if (r == WF_OK) MUST(wfBodySubsteps(w, id) == few);
    return r;
}

/* ---- sleep -------------------------------------------------------------------------------------------------------------------- */
static wfResult op_wake(Session *s) { return CALL(wfWakeBody(handle(s), pick_bodies(s))); }
static wfResult op_put_to_sleep(Session *s) { return CALL(wfSetBodyAsleep(handle(s), pick_bodies(s))); }
static wfResult op_never_sleeps(Session *s)
{
    wfBodyId id = pick_bodies(s);
    int32_t never = yes(s);
    return CALL(wfDisableBodySleep(handle(s), id, never));
}
static wfResult op_look_at_sleep(Session *s)
{
    const wfWorld *w = handle(s);
    wfBodyId id = pick_bodies(s);
    wfSleepCounts c = wfGetSleepCounts(w);
    bool never = wfBodySleepDisabled(w, id);
    MUST(!never || (!s->badHandle && !stale));
    MUST(c.awake >= 0 && c.asleep >= 0 && c.islands >= 0 && c.awake + c.asleep <= s->bodies.alive);
    if (s->badHandle || stale) MUST(!wfBodyIsAwake(w, id) && wfBodyIsland(w, id) == -1);
    else MUST(wfBodyIsland(w, id) >= -1);
    return WF_OK;
}

/* ---- steps and settings --------------------------------------------------------------------------------------------------------- */
static Session *hooked;
static int hook_manners;                        /* 0: good; 1: says what it likes; 2: bad numbers; 3: meddles */
static void meddle(Session *s);
static bool filter_hook(void *context, const wfCallbackView *view, int32_t a, int32_t b)
{
    Session *s = context;
    MUST(a >= 0 && a < b && b < view->shapes.count);
    if (hook_manners == 3 && chance(s, 30)) meddle(s);
    return hook_manners == 1 ? below(s, 2) : (a + b) % 5 != 0;
}
static void contact_hook(void *context, const wfCallbackView *view, const wfContact *c, wfContactSettings *change)
{
    Session *s = context;
    MUST(c->a >= 0 && c->b < view->bodies.count && wfIsFinite2(c->manifold.normal));
    if (hook_manners == 3 && chance(s, 30)) meddle(s);
    if (hook_manners == 1) change->enabled = (int32_t)below(s, 2);
    if (hook_manners == 2) (&change->restitution)[below(s, 5)] = wild(s);
}
static wfResult op_step_with(Session *s)
{
    wfCallbacks hooks = { s, below(s, 3) ? filter_hook : NULL, below(s, 3) ? contact_hook : NULL };
    hook_manners = (int)below(s, 4);
    hooked = s;
    wfWorld *w = handle(s);
    bool bad = s->badHandle;
    wfResult r = wfStepWorldWithCallbacks(w, below(s, 10) ? &hooks : NULL);
    MUST((int)r >= 0 && r < WF_RESULT_COUNT && (!bad || r != WF_OK));
    if (s->inHook) MUST(r != WF_OK);
    if (r == WF_OK) tally->steps++;
    return r;
}
static double ticks(void *context) { return *(double *)context += 1; }
static wfResult step_timed(wfWorld *w)          /* each reading of the clock is a second later: what the stages took is whole and no less than 0 */
{
    double time = 0, seconds[64] = { 0 };
    MUST(wfStageCount <= 64);
    wfResult r = wfStepWorldTimed(w, &(wfStepClock){ ticks, &time, seconds });
    for (int i = 0; i < wfStageCount; i++) MUST(seconds[i] >= 0 && seconds[i] <= time);
    return r;
}
static wfResult op_step(Session *s)
{
    wfResult r = WF_OK;
    for (uint32_t n = 1 + below(s, 3); n > 0 && r == WF_OK; n--) {
        wfWorld *w = handle(s);
        r = tally->steps % 4 ? CALL(wfStepWorld(w)) : CALL(step_timed(w));
        if (s->inHook) MUST(r != WF_OK);
        if (r == WF_OK) tally->steps++;
        if (n > 1 && r == WF_OK && s->made) memcpy(s->shadow, s->world.memory.permanent, s->size[0]);
    }
    return r;
}
static wfResult op_time_step(Session *s)
{
    wfReal dt = chance(s, 200) ? WF_R(1.0) / 60 : more(s, WF_R(0.2));
    return CALL(wfSetTimeStep(handle(s), dt));
}
static wfResult op_methods(Session *s)
{
    int a = whole(s, -1, wfIntegratorCount - 1), b = whole(s, -1, wfBroadPhaseCount - 1), c = whole(s, -1, wfNarrowPhaseCount - 1);
    int d = chance(s, 100) ? whole(s, -1, wfSolverCount - 1) : wfFindSolver("soft");
    return CALL(wfSetMethods(handle(s), a, b, c, d));
}
static wfResult op_get_def(Session *s)
{
    wfWorldDef d;
    return CALL(wfGetWorldDef(handle(s), below(s, 40) ? &d : NULL));
}
static wfResult op_set_def(Session *s)
{
    wfWorldDef d = world_def(s), now;
    wfResult r = wfGetWorldDef(&s->world, &now);
    if (r == WF_OK && chance(s, 230)) {         /* what is built in stays */
        d.bodyCapacity = now.bodyCapacity; d.shapeCapacity = now.shapeCapacity; d.forceCapacity = now.forceCapacity;
        d.jointCapacity = now.jointCapacity; d.advanced.pairCapacity = now.advanced.pairCapacity; d.advanced.contactCapacity = now.advanced.contactCapacity;
        d.advanced.materialPairCapacity = now.advanced.materialPairCapacity; d.events = now.events; d.maxImpacts = now.maxImpacts; d.advanced.directJoints = now.advanced.directJoints;
    }
    if (d.substeps > 99) d.substeps = 99;       /* who asks for a million passes gets them, and we would wait for ever */
    if (d.iterations != 1) d.iterations = 2;
    return CALL(wfSetWorldDef(handle(s), &d));
}
static wfResult op_settings(Session *s)         /* the table of settings, by name */
{
    wfWorldDef d = wfDefaultWorldDef();
    const wfSetting *row = &wfSettingTable[below(s, (uint32_t)wfSettingCount)], *fault = NULL;
    MUST(wfFindSetting(row->name) == row && wfFindSetting("no such thing") == NULL && wfFindSetting(NULL) == NULL);
    int part = whole(s, 0, 1);
    double v = (double)wild(s);
    (void)wfSettingRowName(row, whole(s, -1, 9));
    (void)wfFindSettingRow(row, "soft");
    (void)wfSettingValue(&d, row, part);
    wfResult r = wfPutSetting(&d, row, part, v);
    MUST((int)r >= 0 && r < WF_RESULT_COUNT);
    if (s->poisoned) MUST(r != WF_OK);
    wfResult again = wfCheckWorldDef(&d, &fault);
    if (r == WF_OK && again != WF_OK) MUST(fault != NULL);
    return r;
}

/* ---- looking -------------------------------------------------------------------------------------------------------------------- */
static wfResult op_look(Session *s)
{
    const wfWorld *w = handle(s);
    int32_t n = -1;
    wfBodyId hit;
    wfVec2 p = vector(s, 5);
    bool poisoned = s->poisoned;
    (void)wfWorldBodies(w); (void)wfWorldShapes(w); (void)wfWorldPairs(w, &n); (void)wfWorldContacts(w, &n);
    (void)wfWorldTime(w); (void)wfWorldSteps(w); (void)wfHashWorld(w);
    MUST(wfBodyCount(w) >= 0 && wfShapeCount(w) >= 0 && wfForceCount(w) >= 0);
    if (wfBodyAtPoint(w, p, &hit)) MUST(!poisoned && !s->badHandle && wfBodyIsValid(w, hit));
    return WF_OK;
}
static wfResult op_events(Session *s)
{
    const wfWorld *w = handle(s);
    int32_t n = -1;
    (void)wfWorldEvents(w, whole(s, 0, WF_EVENT_KINDS - 1), &n);
    MUST(n >= 0);
    const wfContactHit *hits = wfWorldHits(w, &n);
    MUST(n >= 0);
    for (int32_t i = 0; i < n; i++) MUST(wfIsFinite(hits[i].speed) && wfIsFinite2(hits[i].point));
    return WF_OK;
}
static wfResult op_get_contact(Session *s)
{
    wfContact c;
    wfShapeId a = pick_shapes(s), b = pick_shapes(s);
    return CALL(wfGetContact(handle(s), a, b, below(s, 30) ? &c : NULL));
}
static wfResult op_energy(Session *s)
{
    double k, p;
    return CALL(wfWorldEnergy(handle(s), below(s, 9) ? &k : NULL, below(s, 9) ? &p : NULL));
}
static wfResult op_momentum(Session *s)
{
    double p[2], l;
    return CALL(wfWorldMomentum(handle(s), below(s, 9) ? p : NULL, below(s, 9) ? &l : NULL));
}
static wfResult op_proxies(Session *s)
{
    wfProxies p;
    wfResult r = CALL(wfWorldProxies(handle(s), below(s, 30) ? &p : NULL));
    if (r == WF_OK) for (int32_t i = 0; i < p.count; i++) MUST(!(p.flags[i] & WF_PROXY_LIVE) || !(p.bounds[i].min.x > p.bounds[i].max.x));
    return r;
}
static bool op_box(void *context, const wfIndexBox *box)
{
    int32_t *left = context;
    MUST(!(box->box.min.x > box->box.max.x) && !(box->box.min.y > box->box.max.y) && box->held >= 0 && box->depth >= -1);
    return --*left > 0;
}
static wfResult op_index_boxes(Session *s)
{
    static _Alignas(WF_POOL_ALIGN) uint8_t bytes[1 << 18];
    wfPool scratch;
    int32_t left = (int32_t)below(s, 400) + 1;
    (void)wfPoolInit(&scratch, below(s, 9) ? sizeof bytes : below(s, 5000), bytes);
    return CALL(wfWorldIndexBoxes(handle(s), below(s, 30) ? &scratch : NULL, below(s, 30) ? op_box : NULL, &left));
}
static wfResult op_reports(Session *s)
{
    wfSolveReport solve;
    wfContinuousReport fast;
    wfWorld *w = handle(s);
    wfResult r = CALL(wfGetSolveReport(w, below(s, 30) ? &solve : NULL)), q = wfGetContinuousReport(w, below(s, 30) ? &fast : NULL);
    MUST((int)q >= 0 && q < WF_RESULT_COUNT && (!s->badHandle || q != WF_OK));
    return r;
}

/* ---- far places ----------------------------------------------------------------------------------------------------------------- */
static wfGlobalPoint far_place(Session *s)
{
    static const double sizes[] = { 0, 1, 1e5, 1e12, 1e20, 1e300 };
    double size = sizes[below(s, 6)];
    wfGlobalPoint at = { size * (double)real(s, 1), size * (double)real(s, 1) };
    return at;
}
static wfResult op_far(Session *s)
{
    wfWorld *w = handle(s);
    wfGlobalPoint at, origin;
    wfVec2 local = vector(s, 5), back;
    wfBodyId id = pick_bodies(s);
    wfResult r = CALL_LOOSE(wfGetGlobalPosition(w, id, &at));
    stale = false;
    bool poisoned = s->poisoned;
    wfResult q = CALL_LOOSE(wfGetWorldOrigin(w, below(s, 9) ? &origin : NULL));
    (void)q;
    q = CALL_LOOSE(wfLocalToGlobal(w, local, &at));
    if (poisoned) MUST(q != WF_OK);
    if (q == WF_OK) (void)CALL_LOOSE(wfGlobalToLocal(w, at, &back));
    (void)CALL_LOOSE(wfGlobalToLocal(w, far_place(s), &back));
    return r;
}
static wfResult op_set_origin(Session *s)
{
    wfGlobalPoint at = far_place(s);
    return CALL(wfSetWorldOrigin(handle(s), at));
}
static wfResult op_move_origin(Session *s)
{
    wfVec2 by = vector(s, chance(s, 40) ? 1000 : 8);
    int32_t rounded = -1;
    wfResult r = CALL(wfShiftOrigin(handle(s), by, below(s, 4) ? &rounded : NULL));
    if (s->inHook) MUST(r != WF_OK);
    return r;
}
static wfResult op_centre(Session *s)
{
    wfVec2 at = vector(s, 50), by;
    wfReal limit = more(s, 60);
    return CALL(wfRecentreWorld(handle(s), at, limit, below(s, 4) ? &by : NULL));
}
static wfResult op_set_far(Session *s)
{
    wfBodyId id = pick_bodies(s);
    wfGlobalPoint at = { 0, 0 };
    wfReal angle = real(s, 3);
    bool bad = !s->made;
    if (!bad && chance(s, 200)) (void)wfGetGlobalPosition(&s->world, id, &at);
    else at = far_place(s);
    return CALL(wfSetGlobalPosition(handle(s), id, at, angle));
}

/* ---- saving ----------------------------------------------------------------------------------------------------------------------- */
static wfResult op_snapshot(Session *s)         /* there and back: the world is the same for all that is to come */
{
    wfWorld *w = handle(s);
    if (s->badHandle || s->inHook) { size_t n; uint8_t b[8]; return CALL(wfSnapshotWorld(w, b, sizeof b, &n)); }
    size_t room = wfSnapshotSize(w), size = 0;
    uint8_t *bytes = malloc(room + 1);
    uint64_t hash = wfHashWorld(w);
    MUST(room > 0 && wfSnapshotWorld(w, bytes, room - 1, &size) != WF_OK && wfSnapshotWorld(w, bytes, room, &size) == WF_OK && size <= room);
    wfWorld clone;
    MUST(wfCloneWorld(w, NULL, &clone) == WF_OK);
    MUST(wfCompareWorlds(w, &clone, NULL) == WF_OK && wfHashWorld(&clone) == hash);
    wfResult there = wfStepWorld(&clone);
    MUST(wfRestoreWorld(&clone, bytes, size) == WF_OK && wfCompareWorlds(w, &clone, NULL) == WF_OK);
    MUST(wfStepWorld(&clone) == there);
    wfDestroyWorld(&clone);
    MUST(CALL(wfRestoreWorld(w, bytes, below(s, (uint32_t)size))) != WF_OK);
    wfResult r = wfRestoreWorld(w, bytes, size);
    MUST(r == WF_OK && wfHashWorld(w) == hash);
    free(bytes);
    return r;
}
static wfResult op_save(Session *s)             /* whole it is loaded; with a bit turned round it is not */
{
    wfWorld *w = handle(s), other;
    if (s->badHandle) { size_t n; uint8_t b[8]; return CALL(wfSaveToBytes(w, b, sizeof b, &n)); }
    if (s->inHook) return WF_ERROR_BUSY;
    size_t room = wfSaveSize(w), size = 0;
    uint8_t *bytes = malloc(room);
    MUST(wfSaveToBytes(w, bytes, room, &size) == WF_OK);
    MUST(wfLoadFromBytes(bytes, size, NULL, &other) == WF_OK && wfHashWorld(&other) == wfHashWorld(w));
    wfDestroyWorld(&other);
    size_t at = ((size_t)next(s) << 8 | below(s, 256)) % size;
    bytes[at] ^= (uint8_t)(1 << below(s, 8));
    wfResult r = wfLoadFromBytes(bytes, size, NULL, &other);
    MUST(r != WF_OK);
    free(bytes);
    return WF_OK;
}
static wfResult op_grow(Session *s)             /* a world of its own memory gets more room */
{
    wfWorldDef d;
    wfWorld *w = handle(s);
    if (s->badHandle || s->inHook || s->given || s->def.bodyCapacity > 40) { wfResult r = wfGetWorldDef(w, &d); return r == WF_OK ? WF_ERROR_BUILT_IN : r; }
    MUST(wfGetWorldDef(w, &d) == WF_OK);
    d.bodyCapacity += (int32_t)below(s, 3); d.forceCapacity += (int32_t)below(s, 2);
    if (chance(s, 60)) d.bodyCapacity -= 2;
    wfWorldDef before = s->def;
    wfResult r = CALL(wfGrowWorld(w, &d));
    if (r != WF_OK) return r;
    s->def = before;
    s->def.bodyCapacity = d.bodyCapacity; s->def.forceCapacity = d.forceCapacity;
    for (int i = 0; i < 2; i++) { free(s->chunk[i]); s->size[i] = i ? w->memory.transientSize : w->memory.permanentSize; }
    for (int i = 0; i < 2; i++) s->chunk[i] = aligned_alloc(16, (s->size[0] + 15) / 16 * 16);
    free(s->shadow);
    s->shadow = calloc(1, s->size[0]);
    return r;
}
static wfResult op_rewind(Session *s)
{
    static _Alignas(16) uint8_t bytes[1 << 18];
    wfWorld *w = handle(s);
    wfRewind ring;
    uint64_t oldest, newest;
    MUST(wfRewindInit(&ring, bytes, sizeof bytes) == WF_OK && wfRewindReach(&ring, &oldest, &newest) == WF_ERROR_UNKNOWN);
    wfResult r = CALL(wfRewindKeep(&ring, w));
    if (r != WF_OK || s->inHook) return r == WF_OK ? WF_ERROR_BUSY : r;
    MUST(wfRewindReach(&ring, &oldest, &newest) == WF_OK && oldest == newest && newest == wfWorldSteps(w));
    MUST(newest == 0 || wfRewindTo(&ring, w, newest - 1) == WF_ERROR_UNKNOWN);
    return wfRewindTo(&ring, w, newest + below(s, 3));
}

/* ---- queries --------------------------------------------------------------------------------------------------------------------- */
static const wfFilter *filter(Session *s)
{
    static wfFilter f;
    f = (wfFilter){ next(s), next(s), (int32_t)below(s, 5) - 2 };
    return below(s, 3) ? NULL : &f;
}
static wfTransform pose(Session *s)
{
    wfVec2 p = vector(s, 5);
    wfReal angle = real(s, 3);
    return wfMakeTransform(p, angle);
}
static void hit_is_good(const Session *s, wfRayHit h)
{
    MUST(h.fraction >= 0 && h.fraction <= 1 && wfIsFinite2(h.point) && h.shape >= -1);
    if (h.shape >= 0) MUST(wfShapeAt(&s->world, h.shape).index != 0);
}
static wfResult op_cast_ray(Session *s)
{
    wfRay ray = { vector(s, 6), vector(s, 10) };
    wfRayHit hit, list[8];
    int32_t n = -1, room = whole(s, 0, 8);
    const wfFilter *f = filter(s);
    if (room > 8) room = -1;
    wfWorld *w = handle(s);
    wfResult r = CALL(wfWorldCastRay(w, ray, f, below(s, 30) ? &hit : NULL));
    if (r == WF_OK) hit_is_good(s, hit);
    wfResult all = CALL(wfWorldCastRayAll(w, ray, f, list, room, &n));
    if (all == WF_OK && r == WF_OK) MUST((n > 0) == (hit.shape >= 0) && (n == 0 || room < 1 || list[0].fraction == hit.fraction));
    return r;
}
static wfResult op_cast_shape(Session *s)
{
    wfShape moving = shape(s);
    wfTransform x = pose(s);
    wfVec2 by = vector(s, 10);
    wfRayHit hit, list[8];
    int32_t n = -1, room = (int32_t)below(s, 9);
    const wfFilter *f = filter(s);
    wfWorld *w = handle(s);
    wfResult r = CALL_LOOSE(wfWorldCastShape(w, &moving, x, by, f, &hit));
    if (r == WF_OK) hit_is_good(s, hit);
    (void)CALL_LOOSE(wfWorldCastShapeAll(w, &moving, x, by, f, list, room, &n));
    return r;
}
static wfResult op_overlap(Session *s)
{
    wfShape probe = shape(s);
    wfTransform x = pose(s);
    int32_t list[8], n = -1, room = whole(s, 0, 8);
    if (room > 8) room = -1;
    wfResult r = CALL_LOOSE(wfWorldOverlap(handle(s), &probe, x, filter(s), list, room, &n));
    if (r == WF_OK) for (int32_t i = 0; i < n && i < room; i++) MUST(wfShapeAt(&s->world, list[i]).index != 0);
    return r;
}
static wfResult op_overlap_area(Session *s)
{
    wfVec2 a = vector(s, 5), b = vector(s, 5);
    wfRect area = { .min = a, .max = b };
    int32_t list[8], n = -1;
    return CALL(wfWorldOverlapArea(handle(s), area, filter(s), list, 8, below(s, 30) ? &n : NULL));
}
static wfResult op_overlap_point(Session *s)
{
    wfVec2 p = vector(s, 5);
    int32_t list[8], n = -1;
    return CALL(wfWorldOverlapPoint(handle(s), p, filter(s), list, 8, &n));
}
static wfResult op_closest(Session *s)
{
    wfVec2 p = vector(s, 5);
    wfReal within = more(s, 10);
    wfClosest c;
    wfResult r = CALL(wfWorldClosest(handle(s), p, within, filter(s), &c));
    if (r == WF_OK) MUST(c.shape >= -1 && c.distance >= 0);
    return r;
}
static wfResult op_distance(Session *s)
{
    wfShape probe = shape(s);
    wfTransform x = pose(s);
    wfReal within = more(s, 10);
    wfClosest c;
    return CALL_LOOSE(wfWorldDistance(handle(s), &probe, x, within, filter(s), &c));
}
static wfResult op_index(Session *s) { return CALL(wfIndexWorld(handle(s))); }

static void say_nothing(void *context, const char *line) { (void)context, (void)line; }
static wfResult op_modules(Session *s)
{
    wfWorldDef d = wfDefaultWorldDef();
    wfWorld *w = handle(s);
    wfStageReport stage;
    uint32_t bits = 1u << below(s, 24);
    wfBodyDef b = wfDefaultBodyDefFor(w);
    wfShapeDef sd = wfDefaultShapeDefFor(w);
    wfSceneList list = { .bodies = &b, .bodyCount = 1 };
    MUST((wfCloseModules(bits) & bits) == bits && wfFindModule("rotation") >= 0);
    MUST((wfMissingModules(w, wfModulesOfBody(&b) | wfModulesOfShape(&sd)) & ~wfAllModules()) == 0);
    MUST(wfInferSceneModules(&list, 0, &d) == WF_OK);
    MUST(wfStepWorldTimed(NULL, NULL) == WF_ERROR_NULL);
    wfResult shown = wfExplainStage(w, (int)below(s, 40) - 4, &stage);
    MUST(wfExplainWorld(w, NULL, 0, say_nothing, NULL) == WF_OK || shown != WF_OK);
    return CALL(wfInferModules(w, bits, &d));
}

/* ---- what was done, again: journals and files; on clones, for what they add the session does not know -------------------------------- */
static wfInput input(Session *s)                /* a call as a value, on what is there, was there or never was */
{
    wfInput in;
    memset(&in, 0, sizeof in);
    in.kind = whole(s, 0, WF_INPUT_KINDS - 1);
    in.with.at = vector(s, 5); in.with.by = vector(s, 10); in.with.x = real(s, 5); in.with.y = more(s, 5); in.with.number = whole(s, 0, 2);
    const Thing *t = pick(s, &s->bodies);
    switch (in.kind) {
    case WF_INPUT_ADD_BODY: in.body = wfDefaultBodyDef(); in.body.type = WF_DYNAMIC; in.body.shape = shape(s); in.body.position = vector(s, 5); in.body.mass = more(s, 3); break;
    case WF_INPUT_ADD_SHAPE: in.shape = shape_def(s); break;
    case WF_INPUT_SET_SHAPE: case WF_INPUT_REMOVE_SHAPE: case WF_INPUT_SHAPE_DATA: t = pick(s, &s->shapes); if (in.kind == WF_INPUT_SET_SHAPE) in.shape = shape_def(s); break;
    case WF_INPUT_ADD_FORCE: in.force = force(s); break;
    case WF_INPUT_SET_FORCE: case WF_INPUT_REMOVE_FORCE: case WF_INPUT_DRAG: t = pick(s, &s->forces); if (in.kind == WF_INPUT_SET_FORCE) in.force = force(s); break;
    case WF_INPUT_SET_JOINT: case WF_INPUT_REMOVE_JOINT: case WF_INPUT_JOINT_DATA: t = pick(s, &s->joints); break;
    case WF_INPUT_SET_ORIGIN: in.global = far_place(s); break;
    default: break;
    }
    in.index = t->index; in.generation = t->generation;
    if (in.kind == WF_INPUT_PAIR || in.kind == WF_INPUT_FORGET_PAIR) { in.index = below(s, 4); in.generation = below(s, 4); }
    if (in.kind == WF_INPUT_SETTING) { in.index = below(s, 80); in.generation = below(s, 3); }
    return in;
}
/* a file, if there is a place for it: build/abuse/, where run.sh is started */
static const char *file_name(char *name, size_t room)
{
    snprintf(name, room, "build/abuse/%ld.weft", (long)getpid());
    FILE *f = fopen(name, "wb");
    if (f == NULL) return NULL;
    fclose(f);
    return name;
}
static wfResult op_record(Session *s)           /* played again it is the same; saved and loaded, too; with a bit turned round it is refused */
{
    static uint8_t room[1 << 16], other[1 << 16], saved[(1 << 16) + 64];
    wfWorld *w = handle(s), one, two;
    wfJournal j, back;
    wfInputId made;
    int32_t trail = yes(s), stepped = 1, steps = 0;
    wfResult r = wfJournalInit(&j, room, sizeof room, trail);
    MUST((r == WF_OK) == (trail == 0 || trail == 1) && wfJournalInit(NULL, room, sizeof room, 0) == WF_ERROR_NULL);
    if (r != WF_OK) MUST(wfJournalInit(&j, room, sizeof room, 1) == WF_OK);
    wfInput in = input(s);
    if (s->badHandle) { MUST(wfStepNoted(w, &j, NULL) != WF_OK && j.used == 0); s->poisoned = stale = false; return CALL(wfGiveInput(w, &j, &in, &made)); }
    stale = false;
    if (s->inHook) { MUST(wfStepNoted(w, &j, NULL) != WF_OK); return WF_ERROR_BUSY; }
    MUST(wfCloneWorld(w, NULL, &one) == WF_OK && wfCloneWorld(w, NULL, &two) == WF_OK);
    for (int n = 3 + (int)below(s, 12); n > 0; n--, in = input(s)) {
        uint64_t before = wfHashWorld(&one);
        size_t used = j.used;
        if (below(s, 4) == 0 && steps < 2) { r = wfStepNoted(&one, &j, NULL); steps++; }
        else r = wfGiveInput(&one, &j, &in, below(s, 2) ? &made : NULL);
        MUST((int)r >= 0 && r < WF_RESULT_COUNT);
        if (r != WF_OK) MUST(wfHashWorld(&one) == before && j.used == used);
    }
    stale = s->poisoned = false;
    MUST(wfCheckWorld(&one, NULL) == WF_OK);
    wfReplay again = { .journal = &j };
    do r = wfReplayStep(&again, &two, NULL, &stepped); while (r == WF_OK && stepped);
    MUST(r == WF_OK && wfCompareWorlds(&one, &two, NULL) == WF_OK);
    size_t need = wfJournalSaveSize(&j), size = 0;
    MUST(need > 0 && need <= sizeof saved && wfSaveJournalToBytes(&j, saved, need - 1, &size) != WF_OK && wfSaveJournalToBytes(&j, saved, need, &size) == WF_OK);
    MUST(wfLoadJournalFromBytes(saved, size, other, sizeof other, &back) == WF_OK && back.used == j.used && memcmp(room, other, j.used) == 0);
    wfSaveInfo info;
    MUST(wfReadSaveInfo(saved, size, &info) == WF_OK && info.holds == 2 && info.layout != 0 && wfLayoutHash() == wfLayoutHash());
    if (below(s, 4) == 0) {                     /* side by side they never part */
        wfReplay a = { .journal = &j }, b = { .journal = &back };
        wfDivergence d;
        MUST(wfRestoreWorld(&two, NULL, 0) != WF_OK);
        wfDestroyWorld(&one); wfDestroyWorld(&two);
        MUST(wfCloneWorld(w, NULL, &one) == WF_OK && wfCloneWorld(w, NULL, &two) == WF_OK);
        MUST(wfFindDivergence(&a, &one, &b, &two, NULL, &d) == WF_OK && d.what.region == NULL);
    }
    char name[64];
    if (below(s, 8) == 0 && file_name(name, sizeof name)) {
        wfWorld loaded;
        MUST(wfSaveJournalToFile(&j, name) == WF_OK && wfLoadJournalFromFile(name, other, sizeof other, &back) == WF_OK && back.used == j.used);
        MUST(wfLoadFromFile(name, &loaded) != WF_OK);
        MUST(wfSaveToFile(&one, name) == WF_OK && wfLoadFromFile(name, &loaded) == WF_OK && wfCompareWorlds(&one, &loaded, NULL) == WF_OK);
        wfDestroyWorld(&loaded);
        remove(name);
        MUST(wfReplaceFile(name, "x", 1) == WF_OK && wfLoadFromFileWithin(name, NULL, &loaded) == WF_ERROR_NOT_A_SAVE && remove(name) == 0);
        MUST(wfLoadFromFile(name, &loaded) == WF_ERROR_FILE && wfLoadFromFile(NULL, &loaded) == WF_ERROR_NULL);
    }
    size_t at = ((size_t)next(s) << 8 | below(s, 256)) % size;
    uint64_t sum = wfChecksum(saved, size);
    saved[at] ^= (uint8_t)(1 << below(s, 8));
    MUST(wfChecksum(saved, size) != sum && wfLoadJournalFromBytes(saved, size, other, sizeof other, &back) != WF_OK);
    wfDestroyWorld(&one); wfDestroyWorld(&two);
    return WF_OK;
}

/* ---- how accurate, and for how much: a curve, a choice, and a frame by it, on a clone ------------------------------------------------- */
static wfResult op_curve(Session *s)
{
    static wfAccuracy points[WF_CURVE_POINTS];
    wfWorld *w = handle(s), clone;
    wfCurveDef how = wfDefaultCurveDef();
    wfAccuracy chosen = { 0 };
    int32_t n = -1;
    how.frame = WF_R(0.001) + more(s, WF_R(0.02));
    how.frames = 1; how.finest = 2;
    if (!s->badHandle && (s->inHook || wfBodyCount(w) > 6)) return WF_ERROR_BUSY;       /* it would take long, and show no more */
    if (s->badHandle) { MUST(wfUseSettings(w, &chosen) != WF_OK && wfStepFrame(w, &chosen) != WF_OK && wfSetTolerance(w, how.frame, WF_R(0.01), &chosen) != WF_OK); }
    wfResult r = CALL(wfMeasureCurve(w, &how, points, WF_CURVE_POINTS, &n));
    if (r != WF_OK) return r;
    MUST(n >= 0 && n <= WF_CURVE_POINTS);
    if (n == 0) return r;                       /* the world has not the parts for any of the methods */
    for (int32_t i = 0; i < n; i++) MUST(points[i].failed || (wfIsFinite(points[i].error) && points[i].error >= 0 && points[i].cost >= 0));
    bool before = s->poisoned;
    wfReal tolerance = more(s, WF_R(0.1));
    double budget = (double)more(s, 100);
    s->poisoned = before;
    wfResult found = wfChooseForBudget(points, n, 1, budget, &chosen);
    if (found == WF_OK) MUST(!chosen.failed && chosen.cost <= budget);
    found = wfChooseSettings(points, n, tolerance, &chosen);
    if (found == WF_OK) MUST(!chosen.failed && chosen.error <= tolerance);
    else chosen = points[below(s, (uint32_t)n)];
    if (chance(s, (uint32_t)s->wild)) chosen.method = whole(s, 0, wfMethodCount);
    if (chance(s, (uint32_t)s->wild)) chosen.steps = whole(s, 0, 3);
    s->poisoned = before;
    MUST(wfCloneWorld(w, NULL, &clone) == WF_OK);
    uint64_t hash = wfHashWorld(&clone);
    found = wfUseSettings(&clone, &chosen);
    MUST((int)found >= 0 && found < WF_RESULT_COUNT);
    if (found != WF_OK) MUST(wfHashWorld(&clone) == hash);
    else if (chosen.steps <= 8) { found = wfStepFrame(&clone, &chosen); MUST((int)found >= 0 && found < WF_RESULT_COUNT && wfCheckWorld(&clone, NULL) == WF_OK); }
    hash = wfHashWorld(&clone);
    /* the real thing tries a second of every method, up to 128 steps in a frame: only with long frames, and with nothing that is hard to solve */
    if (wfBodyCount(w) > 1 || wfJointCount(w) > 0 || below(s, 4)) tolerance = -tolerance;
    found = wfSetTolerance(&clone, how.frame + WF_R(0.3), tolerance, &chosen);
    if (!(tolerance > 0)) MUST(found != WF_OK);
    if (found != WF_OK) MUST(wfHashWorld(&clone) == hash);
    wfDestroyWorld(&clone);
    return r;
}

#define OP(group, weight, kind, function, ...) { #function, group, weight, kind, __VA_ARGS__ }
const Operation operations[] = {
    OP("worlds", 6, READS, wfWorldSize, op_world_size, false),
    OP("worlds", 2, READS, wfWorldRegions, op_regions, false),
    OP("worlds", 2, READS, wfInferModules, op_modules, false),
    OP("worlds", 6, READS, wfCreateWorld, op_create, false),
    OP("worlds", 1, CHANGES, wfDestroyWorld, op_destroy, true),
    OP("worlds", 10, READS, wfOpenWorld, op_open, false),
    OP("bodies", 90, CHANGES, wfAddBodyToWorld, op_add_body, false),
    OP("bodies", 24, CHANGES, wfRemoveBodyFromWorld, op_remove_body, false),
    OP("bodies", 8, READS, wfGetBody, op_get_body, false),
    OP("bodies", 4, READS, wfGetBodyShape, op_get_body_shape, false),
    OP("bodies", 10, READS, wfBodyIsValid wfBodyIndex wfBodyAt wfShapeIsValid wfShapeIndex wfShapeAt wfShapeBody wfFirstShape wfNextShape, op_names, true),
    OP("shapes", 30, CHANGES, wfAddShapeToBody, op_add_shape, false),
    OP("shapes", 10, CHANGES, wfAddShapesToBody, op_add_shapes, false),
    OP("shapes", 4, CHANGES, wfAddChainToBody, op_add_chain, false),
    OP("shapes", 24, CHANGES, wfRemoveShapeFromWorld, op_remove_shape, false),
    OP("shapes", 6, READS, wfGetShape, op_get_shape, false),
    OP("shapes", 14, CHANGES, wfSetShape, op_set_shape, false),
    OP("shapes", 4, CHANGES, wfSetPairMaterial, op_set_pair_material, false),
    OP("shapes", 3, READS, wfGetPairMaterial, op_get_pair_material, false),
    OP("changes", 20, CHANGES, wfSetBodyTransform, op_set_transform, false),
    OP("changes", 20, CHANGES, wfSetBodyVelocity, op_set_velocity, false),
    OP("changes", 10, CHANGES, wfSetBodyMass, op_set_mass, false),
    OP("changes", 12, CHANGES, wfChangeBodyType, op_change_type, false),
    OP("changes", 6, CHANGES, wfSetBodyMaterial, op_set_material, false),
    OP("changes", 5, CHANGES, wfSetBodyDamping, op_set_damping, false),
    OP("changes", 8, CHANGES, wfSetBodyGravityScale wfSetBodyMassData wfSetBodyFixedRotation wfSetBodyUserData, op_more_of_body, false),
    OP("changes", 4, CHANGES, wfSetBodyTarget, op_target, false),
    OP("changes", 1, CHANGES, wfSetShapeUserData, op_shape_data, false),
    OP("changes", 8, CHANGES, wfEnableBody wfBodyIsEnabled, op_enable, false),
    OP("looking", 3, READS, wfDrawWorld, op_draw, false),
    OP("queries", 6, READS, wfMoveMover wfDefaultMover, op_mover, false),
    OP("changes", 3, CHANGES, wfPushBodies, op_push, false),
    OP("steps", 10, CHANGES, wfAdvanceWorld wfStepShare wfPoseBetween, op_advance, false),
    OP("changes", 1, CHANGES, wfSetJointUserData, op_joint_data, false),
    OP("looking", 6, READS, wfBodyWorldPoint wfBodyLocalPoint wfBodyWorldVector wfBodyLocalVector wfBodyVelocityAt wfNextContact wfNextJoint wfJointIsValid wfGetJointMotion, op_points, true),
    OP("pushes", 10, CHANGES, wfApplyForceToBody, op_apply_force, false),
    OP("pushes", 5, CHANGES, wfApplyTorqueToBody, op_apply_torque, false),
    OP("pushes", 10, CHANGES, wfApplyImpulseToBody, op_apply_impulse, false),
    OP("pushes", 5, CHANGES, wfApplyAngularImpulseToBody, op_apply_spin, false),
    OP("forces", 18, CHANGES, wfAddForceToWorld, op_add_force, false),
    OP("forces", 12, CHANGES, wfRemoveForceFromWorld, op_remove_force, false),
    OP("forces", 4, READS, wfGetForce wfForceIsValid, op_get_force, false),
    OP("forces", 6, CHANGES, wfSetForce, op_set_force, false),
    OP("forces", 4, CHANGES, wfSetGravity, op_gravity, false),
    OP("forces", 2, READS, wfGetGravity, op_get_gravity, false),
    OP("forces", 6, CHANGES, wfAddMouseJoint, op_grab, false),
    OP("forces", 5, CHANGES, wfSetMouseTarget, op_drag, false),
    OP("joints", 4, READS, wfDefineJoint, op_join, false),
    OP("joints", 3, READS, wfTuneJointSpring, op_tune, false),
    OP("joints", 40, CHANGES, wfAddJointToWorld, op_add_joint, false),
    OP("joints", 16, CHANGES, wfRemoveJointFromWorld, op_remove_joint, false),
    OP("joints", 6, READS, wfGetJoint, op_get_joint, false),
    OP("joints", 4, READS, wfGetJointLoad, op_joint_load, false),
    OP("joints", 4, READS, wfGetJointPeak, op_joint_peak, false),
    OP("joints", 14, CHANGES, wfSetJoint, op_set_joint, false),
    OP("joints", 4, READS, wfJointCount wfDirectJointCount wfAllJointsDirect wfUnsolvedSubsteps wfJointAt wfWorldJointPlaces wfBrokenJoints, op_look_at_joints, true),
    OP("sleep", 5, CHANGES, wfWakeBody, op_wake, false),
    OP("sleep", 14, CHANGES, wfSetBodyAsleep, op_put_to_sleep, false),
    OP("bodies", 6, CHANGES, wfSetBodySubsteps, op_body_substeps, false),
    OP("sleep", 4, CHANGES, wfDisableBodySleep, op_never_sleeps, false),
    OP("sleep", 5, READS, wfBodyIsAwake wfBodySleepDisabled wfBodyIsland wfGetSleepCounts, op_look_at_sleep, true),
    OP("steps", 100, CHANGES, wfStepWorld, op_step, false),
    OP("steps", 40, CHANGES, wfStepWorldWithCallbacks, op_step_with, false),
    OP("settings", 4, CHANGES, wfSetTimeStep, op_time_step, false),
    OP("settings", 8, CHANGES, wfSetMethods, op_methods, false),
    OP("settings", 3, READS, wfGetWorldDef, op_get_def, false),
    OP("settings", 8, CHANGES, wfSetWorldDef, op_set_def, false),
    OP("settings", 6, READS, wfPutSetting wfFindSetting wfSettingValue wfSettingRowName wfFindSettingRow wfCheckWorldDef, op_settings, false),
    OP("looking", 8, READS, wfWorldBodies wfWorldShapes wfWorldPairs wfWorldContacts wfBodyCount wfShapeCount wfForceCount wfForceAt wfWorldTime wfWorldSteps wfHashWorld wfBodyAtPoint, op_look, true),
    OP("looking", 6, READS, wfWorldEvents wfWorldHits, op_events, true),
    OP("looking", 5, READS, wfGetContact, op_get_contact, false),
    OP("looking", 3, READS, wfWorldEnergy, op_energy, false),
    OP("looking", 3, READS, wfWorldMomentum, op_momentum, false),
    OP("looking", 3, READS, wfWorldProxies, op_proxies, false),
    OP("looking", 3, READS, wfWorldIndexBoxes, op_index_boxes, false),
    OP("looking", 3, READS, wfGetSolveReport wfGetContinuousReport, op_reports, false),
    OP("looking", 5, READS, wfGetGlobalPosition wfGetWorldOrigin wfLocalToGlobal wfGlobalToLocal, op_far, false),
    OP("changes", 1, CHANGES, wfSetWorldOrigin, op_set_origin, false),
    OP("changes", 3, CHANGES, wfShiftOrigin, op_move_origin, false),
    OP("changes", 2, CHANGES, wfRecentreWorld, op_centre, false),
    OP("changes", 4, CHANGES, wfSetGlobalPosition, op_set_far, false),
    OP("saving", 3, CHANGES, wfSnapshotWorld wfRestoreWorld wfCloneWorld wfCompareWorlds, op_snapshot, false),
    OP("saving", 2, READS, wfSaveToBytes wfLoadFromBytes, op_save, false),
    OP("saving", 2, CHANGES, wfGrowWorld, op_grow, false),
    OP("saving", 3, CHANGES, wfRewindKeep wfRewindTo wfRewindReach, op_rewind, false),
    OP("queries", 12, READS, wfWorldCastRay wfWorldCastRayAll, op_cast_ray, false),
    OP("queries", 8, READS, wfWorldCastShape wfWorldCastShapeAll, op_cast_shape, false),
    OP("queries", 6, READS, wfWorldOverlap, op_overlap, false),
    OP("queries", 5, READS, wfWorldOverlapArea, op_overlap_area, false),
    OP("queries", 4, READS, wfWorldOverlapPoint, op_overlap_point, false),
    OP("queries", 6, READS, wfWorldClosest, op_closest, false),
    OP("queries", 5, READS, wfWorldDistance, op_distance, false),
    OP("queries", 6, CHANGES, wfIndexWorld, op_index, false),
    OP("saving", 2, READS, wfJournalInit wfGiveInput wfStepNoted wfReplayStep wfFindDivergence wfJournalSaveSize wfSaveJournalToBytes wfLoadJournalFromBytes wfSaveJournalToFile wfLoadJournalFromFile wfSaveToFile wfLoadFromFile wfLoadFromFileWithin wfLoadFromBytesWithin wfMostMemory wfReplaceFile wfReadSaveInfo wfChecksum wfLayoutHash, op_record, false),
    OP("accuracy", 2, READS, wfMeasureCurve wfChooseSettings wfChooseForBudget wfUseSettings wfStepFrame wfSetTolerance, op_curve, false),
};
const int operationCount = (int)(sizeof operations / sizeof *operations);

/* A hook that calls whatever it likes: what changes the world must be refused. */
static void meddle(Session *s)
{
    if (s->inHook) return;
    const Operation *op = &operations[below(s, (uint32_t)operationCount)];
    uint64_t random = s->random;
    bool oldStale = stale;
    s->inHook = true;
    wfResult r = run_operation(s, op);
    if (op->kind == CHANGES && !op->silent) MUST(r != WF_OK || op->run == op_add_shapes);
    s->inHook = false;
    stale = oldStale;
    s->random = random + 1;
}
