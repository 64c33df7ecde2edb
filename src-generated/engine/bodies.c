/* Weft: engine/bodies.c, tangled from chapters/engine/21-bodies-in-a-world.nw. Chapters that add to
 * it: step, looking, sensors-and-callbacks, joints-in-a-world, sleep-in-a-world. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
#include <string.h>
#include "engine/block.h"

/* the default body */
wfBodyDef wfDefaultBodyDef(void)
{
    return (wfBodyDef){
        .type = WF_DYNAMIC, .gravityScale = 1,
        /* more of the default body */
        .density = 1, .friction = WF_R(0.5),
    };
}
/* check a body's definition */
#define BODY(field, ...) WF_NUMBER(wfBodyDef, field, __VA_ARGS__)
static const wfNumber body_numbers[] = {
    WF_WHOLE(wfBodyDef, type, 0, WF_BODY_TYPES - 1), BODY(position.x, WF_ANY_REAL),
    BODY(position.y, WF_ANY_REAL), BODY(velocity.x, WF_ANY_REAL),
    BODY(velocity.y, WF_ANY_REAL), BODY(mass, WF_FROM_ZERO), BODY(gravityScale, WF_ANY_REAL),
    /* more numbers of a body */
    BODY(angle, -WF_MAX_ANGLE, WF_MAX_ANGLE),
    BODY(angularVelocity, WF_ANY_REAL), WF_WHOLE(wfBodyDef, fixedRotation, 0, 1),
    BODY(linearDamping, WF_FROM_ZERO), BODY(angularDamping, WF_FROM_ZERO),
    BODY(density, WF_FROM_ZERO), BODY(restitution, 0, 1), BODY(friction, WF_FROM_ZERO),
    WF_WHOLE(wfBodyDef, neverSleeps, 0, 1),
};

static wfResult check_body_def(const wfBlock *b, const wfBodyDef *d)
{
    if (d == NULL) return wfRefuse(b, WF_ERROR_NULL, "def", NULL);
    wfResult result = wfCheckFields(b, "def.", 0, d, body_numbers,
                                    sizeof body_numbers / sizeof *body_numbers);
    bool moves = d->velocity.x != 0 || d->velocity.y != 0;
    /* check what else a body is made from */
    moves = moves || d->angularVelocity != 0;
    if (result == WF_OK && d->shape.kind != WF_SHAPE_NONE)
        result = wfRefuse(b, wfCheckShape(&d->shape), "def.shape", NULL);
    if (result == WF_OK && d->type == WF_STATIC && moves)
        return wfRefuse(b, WF_ERROR_RANGE, "def.velocity",
                        "a static body has none: make it kinematic");
    return result;
}

/* what bodies need */
uint32_t wfModulesOfBody(const wfBodyDef *d)
{
    uint32_t modules = 0;
    if (d == NULL) return modules;
    (void)d;
    /* what a body's definition requires */
    if (d->angularVelocity != 0) modules |= WF_MODULE_ROTATION;
    if (d->linearDamping > 0 || d->angularDamping > 0) modules |= WF_MODULE_DAMPING;
    bool formed = d->shape.kind != WF_SHAPE_NONE;
    if (formed) modules |= WF_MODULE_SHAPES;
    if (formed && d->friction > 0) modules |= WF_MODULE_FRICTION;
    if (formed && d->restitution > 0) modules |= WF_MODULE_RESTITUTION;
    return modules;
}

/* make a body from its definition */
typedef struct newBody {
    wfBodyState state;
    wfBodyProps props;
} newBody;

static wfResult weigh(const wfBodyDef *d, wfMassData *out)
{
    *out = (wfMassData){ .mass = d->mass };
    /* weigh its shape, if it has one */
    bool formed = d->shape.kind != WF_SHAPE_NONE, dynamic = d->type == WF_DYNAMIC;
    wfResult weighed = WF_OK;
    wfShape stored = d->shape;
    if (d->type == WF_STATIC && formed) out->centre = wfShapeCentroid(&d->shape);
    if (!dynamic && formed) out->mass = 0;
    if (dynamic && formed)
        weighed = d->mass > 0 ? wfShapeMassOf(&d->shape, d->mass, out)
                              : wfShapeMass(&d->shape, d->density, out);
    wfShapeMove(&stored, wfNeg(out->centre));
    if (formed) return weighed == WF_OK ? wfCheckMovedShape(&stored, out->centre) : weighed;
    if (d->type == WF_DYNAMIC && d->mass == 0) out->mass = 1;
    return WF_OK;
}

static wfResult make_body(const wfBlock *b, const wfBodyDef *d, newBody *out)
{
    (void)b;
    wfMassData mass;
    wfResult result = weigh(d, &mass);
    if (result != WF_OK) return result;
    *out = (newBody){ .state = { .p = d->position, .v = d->velocity },
        .props = { .type = d->type, .shape = -1, .givenMass = d->mass,
                   .gravityScale = d->gravityScale, .localCentre = mass.centre,
                   .userData = d->userData } };
    /* give the body its angle and its damping */
    wfReal angle = wfWrapAngle(d->angle);
    wfTransform origin = wfMakeTransform(d->position, angle);
    out->state.p = wfApply(origin, mass.centre);            /* eq:world-origin */
    out->state.angle = angle;
    out->state.w = d->fixedRotation ? 0 : d->angularVelocity;
    bool still = d->fixedRotation || !wfHas(b->head, WF_MODULE_ROTATION);
    out->props.fixedRotation = still;
    if (still) mass.inertia = 0;
    out->props.linearDamping = d->linearDamping;
    out->props.angularDamping = d->angularDamping;
    if (d->type != WF_DYNAMIC) return WF_OK;
    return wfSetMass(&out->state, &out->props, mass.mass, mass.inertia);
}

/* add a body */
wfResult wfAddBodyToWorld(wfWorld *world, const wfBodyDef *def, wfBodyId *out)
{
    wfBlock b;
    newBody made;
    wfResult result = wfChangeBlock(world, &b);
    if (result == WF_OK) result = check_body_def(&b, def);
    if (result == WF_OK) result = wfRequireModules(&b, wfModulesOfBody(def));
    if (result == WF_OK) result = wfRefuse(&b, make_body(&b, def, &made), "def.mass", NULL);
    if (result == WF_OK && !wfBodyIsFinite(&made.state))
        result = wfRefuse(&b, WF_ERROR_NOT_FINITE, "def.position", NULL);
    if (result != WF_OK) return result;
    int32_t room = b.head->bodySlots.capacity;
    if (b.head->bodySlots.count == room)
        return wfRefuseFull(&b, "bodyCapacity", room, room + 1);
    /* look for room for its shape */
    bool formed = def->shape.kind != WF_SHAPE_NONE;
    if (wfFreeShapes(&b) < (formed ? 1 : 0)) return wfRefuseShapes(&b, 1);
    int32_t i = wfSlotTake(&b.head->bodySlots, b.bodySlots);
    b.state[i] = made.state;
    b.props[i] = made.props;
    b.alive[i] = 1;
    bool turns = made.state.invInertia > 0;
    wfUse(&b, wfModulesOfBody(def) | (turns ? WF_MODULE_ROTATION : 0));
    /* give body i the shape of its definition */
    wfShapeDef own = wfDefaultShapeDef();
    own.shape = def->shape;
    own.density = def->density;
    own.restitution = def->restitution;
    own.friction = def->friction;
    if (formed) wfHangShape(&b, i, &own);
    wfBeginRest(&b, i, def->neverSleeps);
    if (out != NULL) *out = wfIdOfBody(&b, i);
    return WF_OK;
}

/* remove a body */
static void clear_place(wfBlock *b, int32_t i)
{
    memset(&b->state[i], 0, sizeof b->state[i]);
    memset(&b->props[i], 0, sizeof b->props[i]);
    b->props[i].shape = -1;
    b->alive[i] = 0;
}

wfResult wfRemoveBodyFromWorld(wfWorld *world, wfBodyId id)
{
    wfBlock b;
    int32_t i;
    wfResult result = wfChangeBody(world, id, &b, &i);
    if (result != WF_OK) return result;
    /* remove what hangs on body i */
    if (wfHas(b.head, WF_MODULE_PUSHES)) memset(&b.applied[i], 0, sizeof b.applied[i]);
    wfForgetContacts(&b, i, -1);
    while (b.props[i].shape >= 0) wfDropShape(&b, b.props[i].shape);
    for (int32_t f = 0; f < b.head->forceSlots.high; f++) {
        bool live = b.forceSlots[f].next == WF_SLOT_LIVE;
        if (!live || (b.forces[f].a != i && b.forces[f].b != i)) continue;
        wfEndsChanged(&b, b.forces[f].a, b.forces[f].b);
        wfSlotGive(&b.head->forceSlots, b.forceSlots, f, b.forceSlots[f].generation);
        memset(&b.forces[f], 0, sizeof b.forces[f]);
        b.added[f] = 0;
    }
    if (wfResidualOf(&b) != NULL) memset(&b.fine[i], 0, sizeof b.fine[i]);
    wfDropJoints(&b, i);
    wfBeginRest(&b, i, 0);
    wfSlotGive(&b.head->bodySlots, b.bodySlots, i, id.generation);
    clear_place(&b, i);
    return WF_OK;
}

/* tell about a body */
static wfVec2 origin_of(const wfBodyState *s, const wfBodyProps *p)
{
    return wfApply(wfBodyTransform(s), wfNeg(p->localCentre));  /* eq:world-origin */
}

wfResult wfGetBody(const wfWorld *world, wfBodyId id, wfBodyInfo *out)
{
    wfBlock b;
    int32_t i;
    wfResult result = out == NULL ? WF_ERROR_NULL : wfOpenBody(world, id, &b, &i);
    if (result != WF_OK) return result;
    const wfBodyState *s = &b.state[i];
    const wfBodyProps *p = &b.props[i];
    *out = (wfBodyInfo){ .type = p->type, .position = s->p, .centre = s->p,
        .velocity = s->v, .mass = p->mass, .massGiven = p->givenMass > 0, .gravityScale = p->gravityScale,
        .userData = p->userData };
    /* tell the rest about the body */
    out->position = origin_of(s, p);
    out->angle = s->angle;
    out->angularVelocity = s->w;
    out->inertia = p->inertia;
    out->linearDamping = p->linearDamping;
    out->angularDamping = p->angularDamping;
    if (p->shape >= 0) out->restitution = b.materials[p->shape].restitution;
    if (p->shape >= 0) out->friction = b.materials[p->shape].friction;
    return WF_OK;
}

wfResult wfGetBodyShape(const wfWorld *world, wfBodyId id, wfShape *out)
{
    wfBlock b;
    int32_t i;
    wfResult result = out == NULL ? WF_ERROR_NULL : wfOpenBody(world, id, &b, &i);
    if (result != WF_OK) return result;
    *out = (wfShape){ .kind = WF_SHAPE_NONE };
    if (b.props[i].shape < 0) return WF_OK;
    *out = b.shapes[b.props[i].shape];
    wfShapeMove(out, b.props[i].localCentre);
    return WF_OK;
}

/* change a body */
wfResult wfSetBodyTransform(wfWorld *world, wfBodyId id, wfVec2 position, wfReal angle)
{
    wfBlock b;
    int32_t i;
    wfResult result = wfChangeBody(world, id, &b, &i);
    if (result == WF_OK) result = wfCheckVector(&b, "position.", position);
    if (result == WF_OK) result = wfCheckReal(&b, "angle", angle, -WF_MAX_ANGLE, WF_MAX_ANGLE);
    if (result != WF_OK) return result;
    wfVec2 centre = position;
    bool turns = false;
    /* turn the body to its angle */
    turns = true;
    angle = wfWrapAngle(angle);
    centre = wfApply(wfMakeTransform(position, angle), b.props[i].localCentre);
    if (!turns && angle != 0) return wfRefuse(&b, WF_ERROR_RANGE, "angle", NULL);
    if (!wfIsFinite2(centre)) return wfRefuse(&b, WF_ERROR_NOT_FINITE, "position", NULL);
    b.state[i].p = centre;
    b.state[i].angle = angle;
    /* what it means that body i was moved by hand */
    wfForgetContacts(&b, i, -1);
    wfBoundBody(&b, i);
    return WF_OK;
}

wfResult wfSetBodyVelocity(wfWorld *world, wfBodyId id, wfVec2 velocity,
                           wfReal angularVelocity)
{
    wfBlock b;
    int32_t i;
    wfResult result = wfChangeBody(world, id, &b, &i);
    if (result == WF_OK) result = wfCheckVector(&b, "velocity.", velocity);
    if (result == WF_OK)
        result = wfCheckReal(&b, "angularVelocity", angularVelocity, WF_ANY_REAL);
    if (result != WF_OK) return result;
    if (b.props[i].type == WF_STATIC)
        return wfRefuse(&b, WF_ERROR_RANGE, "velocity",
                        "a static body has none: make it kinematic by wfChangeBodyType");
    uint32_t modules = angularVelocity != 0 ? WF_MODULE_ROTATION : 0;
    result = wfRequireModules(&b, modules);
    if (result != WF_OK) return result;
    wfUse(&b, modules);
    wfBodyState *s = &b.state[i];
    if (b.props[i].fixedRotation) angularVelocity = 0;
    bool moved = s->v.x != 0 || s->v.y != 0 || s->w != 0;
    bool moves = velocity.x != 0 || velocity.y != 0 || angularVelocity != 0;
    s->v = velocity;
    s->w = angularVelocity;
    if (moved != moves || b.props[i].type == WF_DYNAMIC) wfBodyChanged(&b, i);
    return WF_OK;
}

wfResult wfSetBodyMass(wfWorld *world, wfBodyId id, wfReal mass)
{
    wfBlock b;
    int32_t i;
    wfResult result = wfChangeBody(world, id, &b, &i);
    if (result == WF_OK) result = wfCheckReal(&b, "mass", mass, WF_FROM_ZERO);
    if (result != WF_OK) return result;
    /* let the mass follow from the shapes */
    if (mass == 0 && b.props[i].type == WF_DYNAMIC) {
        wfBodyProps props = b.props[i];
        props.givenMass = 0;
        return wfRefuse(&b, wfReweighBody(&b, i, &props), "mass", NULL);
    }
    if (b.props[i].type != WF_DYNAMIC || mass == 0)
        return wfRefuse(&b, WF_ERROR_RANGE, "mass", "a dynamic body has one above 0");
    wfReal inertia = b.props[i].inertia * (mass / b.props[i].mass);
    result = wfSetMass(&b.state[i], &b.props[i], mass, inertia);
    if (result == WF_OK) b.props[i].givenMass = mass;
    if (result == WF_OK) wfBodyChanged(&b, i);
    return wfRefuse(&b, result, "mass", NULL);
}

wfResult wfChangeBodyType(wfWorld *world, wfBodyId id, int type)
{
    wfBlock b;
    int32_t i;
    wfBodyState state;
    wfBodyProps props;
    wfResult result = wfChangeBody(world, id, &b, &i);
    if (result != WF_OK) return result;
    if (type < 0 || type >= WF_BODY_TYPES)
        return wfRefuse(&b, WF_ERROR_RANGE, "type", "WF_STATIC, _KINEMATIC or _DYNAMIC");
    if (type == b.props[i].type) return WF_OK;
    result = wfRefuse(&b, wfWeighBody(&b, i, type, &state, &props), "id", NULL);
    if (result != WF_OK) return result;
    wfBodyChanged(&b, i);               /* who hangs on it, as long as it is a wall */
    wfCarryOut(&b, i, &state, &props);
    wfForgetContacts(&b, i, -1);
    return WF_OK;
}

wfResult wfSetBodyMaterial(wfWorld *world, wfBodyId id, wfReal restitution,
                           wfReal friction)
{
    wfBlock b;
    int32_t i;
    wfResult result = wfChangeBody(world, id, &b, &i);
    if (result == WF_OK) result = wfCheckReal(&b, "restitution", restitution, 0, 1);
    if (result == WF_OK) result = wfCheckReal(&b, "friction", friction, WF_FROM_ZERO);
    uint32_t modules = restitution > 0 ? WF_MODULE_RESTITUTION : 0;
    if (friction > 0) modules |= WF_MODULE_FRICTION;
    if (result == WF_OK) result = wfRequireModules(&b, modules);
    if (result != WF_OK) return result;
    wfUse(&b, modules);
    for (int32_t k = b.props[i].shape; k >= 0; k = b.next[k]) {
        b.materials[k].restitution = restitution;
        b.materials[k].friction = friction;
        b.materials[k].staticFriction = 0;
    }
    wfBodyChanged(&b, i);
    return WF_OK;
}

wfResult wfSetBodyDamping(wfWorld *world, wfBodyId id, wfReal linear, wfReal angular)
{
    wfBlock b;
    int32_t i;
    wfResult result = wfChangeBody(world, id, &b, &i);
    if (result == WF_OK) result = wfCheckReal(&b, "linear", linear, WF_FROM_ZERO);
    if (result == WF_OK) result = wfCheckReal(&b, "angular", angular, WF_FROM_ZERO);
    uint32_t modules = linear > 0 || angular > 0 ? WF_MODULE_DAMPING : 0;
    if (result == WF_OK) result = wfRequireModules(&b, modules);
    if (result != WF_OK) return result;
    wfUse(&b, modules);
    b.props[i].linearDamping = linear;
    b.props[i].angularDamping = angular;
    return WF_OK;
}

wfResult wfSetBodyGravityScale(wfWorld *world, wfBodyId id, wfReal scale)
{
    wfBlock b;
    int32_t i;
    wfResult result = wfChangeBody(world, id, &b, &i);
    if (result == WF_OK) result = wfCheckReal(&b, "scale", scale, WF_ANY_REAL);
    if (result != WF_OK) return result;
    b.props[i].gravityScale = scale;
    wfBodyChanged(&b, i);
    return WF_OK;
}

wfResult wfSetBodyUserData(wfWorld *world, wfBodyId id, uint64_t data)
{
    wfBlock b;
    int32_t i;
    wfResult result = wfChangeBody(world, id, &b, &i);
    if (result == WF_OK) b.props[i].userData = data;
    return result;
}

wfResult wfSetBodyFixedRotation(wfWorld *world, wfBodyId id, int32_t fixed)
{
    wfBlock b;
    int32_t i;
    wfResult result = wfChangeBody(world, id, &b, &i);
    if (result == WF_OK) result = wfRequireModules(&b, fixed ? 0 : WF_MODULE_ROTATION);
    if (result != WF_OK) return result;
    if (fixed != 0 && fixed != 1)
        return wfRefuse(&b, WF_ERROR_RANGE, "fixed", "must be 0 or 1");
    wfBodyProps props = b.props[i];
    props.fixedRotation = fixed;
    return wfRefuse(&b, wfReweighBody(&b, i, &props), "id", NULL);
}

wfResult wfSetBodyTarget(wfWorld *world, wfBodyId id, wfVec2 position, wfReal angle,
                         wfReal seconds)
{
    wfBlock b;
    int32_t i;
    wfResult result = wfChangeBody(world, id, &b, &i);
    if (result == WF_OK) result = wfCheckVector(&b, "position.", position);
    if (result == WF_OK)
        result = wfCheckReal(&b, "angle", angle, -WF_MAX_ANGLE, WF_MAX_ANGLE);
    if (result == WF_OK) result = wfCheckReal(&b, "seconds", seconds, WF_TINY, WF_HUGE);
    if (result != WF_OK) return result;
    if (b.props[i].type != WF_KINEMATIC)
        return wfRefuse(&b, WF_ERROR_RANGE, "id", "only a kinematic body goes where it is told");
    const wfBodyState *s = &b.state[i];
    wfVec2 to = wfApply(wfMakeTransform(position, angle), b.props[i].localCentre);
    wfReal turn = wfWrapAngle(angle - s->angle);
    return wfSetBodyVelocity(world, id, wfScale(1 / seconds, wfSub(to, s->p)), turn / seconds);
}

/* push a body in a world */
wfResult wfApplyForceToBody(wfWorld *world, wfBodyId id, wfVec2 force, wfVec2 point)
{
    wfBlock b;
    int32_t i;
    wfResult result = wfChangeBody(world, id, &b, &i);
    if (result == WF_OK) result = wfRequireModules(&b, WF_MODULE_PUSHES);
    if (result != WF_OK) return result;
    wfBodyForces sums = b.applied[i];
    wfApplyForce(&sums, &b.state[i], force, point);
    if (!wfIsFinite2(sums.force) || !wfIsFinite(sums.torque))
        return wfRefuse(&b, WF_ERROR_NOT_FINITE, "force", NULL);
    b.applied[i] = sums;
    wfUse(&b, WF_MODULE_PUSHES);
    if (force.x != 0 || force.y != 0) wfBodyChanged(&b, i);
    return WF_OK;
}

wfResult wfApplyTorqueToBody(wfWorld *world, wfBodyId id, wfReal torque)
{
    wfBlock b;
    int32_t i;
    wfResult result = wfChangeBody(world, id, &b, &i);
    uint32_t modules = WF_MODULE_PUSHES | (torque != 0 ? WF_MODULE_ROTATION : 0);
    if (result == WF_OK) result = wfRequireModules(&b, modules);
    if (result != WF_OK) return result;
    if (!wfIsFinite(b.applied[i].torque + torque))
        return wfRefuse(&b, WF_ERROR_NOT_FINITE, "torque", NULL);
    wfApplyTorque(&b.applied[i], torque);
    wfUse(&b, modules);
    if (torque != 0) wfBodyChanged(&b, i);
    return WF_OK;
}

static wfResult kick(const char *call, wfWorld *world, wfBodyId id, wfVec2 impulse,
                     const wfVec2 *point, wfReal spin)
{
    wfBlock b;
    int32_t i;
    wfResult result = wfChangeBodyAs(call, world, id, &b, &i);
    if (result == WF_OK) result = wfCheckVector(&b, "impulse.", impulse);
    if (result == WF_OK) result = wfCheckReal(&b, "impulse", spin, WF_ANY_REAL);
    if (result == WF_OK && point != NULL) result = wfCheckVector(&b, "point.", *point);
    if (result == WF_OK)
        result = wfRequireModules(&b, spin != 0 ? WF_MODULE_ROTATION : 0);
    if (result != WF_OK) return result;
    wfBodyState kicked = b.state[i];
    if (point != NULL) wfApplyImpulse(&kicked, impulse, *point);
    wfApplyAngularImpulse(&kicked, spin);
    if (!wfBodyIsFinite(&kicked)) return wfRefuse(&b, WF_ERROR_NOT_FINITE, "impulse", NULL);
    b.state[i] = kicked;
    if (spin != 0) wfUse(&b, WF_MODULE_ROTATION);
    if (impulse.x != 0 || impulse.y != 0 || spin != 0) wfBodyChanged(&b, i);
    return WF_OK;
}

wfResult wfApplyImpulseToBody(wfWorld *world, wfBodyId id, wfVec2 impulse, wfVec2 point)
{
    return kick(__func__, world, id, impulse, &point, 0);
}

wfResult wfApplyAngularImpulseToBody(wfWorld *world, wfBodyId id, wfReal impulse)
{
    return kick(__func__, world, id, wfV2(0, 0), NULL, impulse);
}
