/* A ball that collects what it meets and loses it at the walls: Box2D's sample "Contact" of contact events.
 * Checked: what was made is free, or on the ball, or was lost at a wall; the ball weighs what its shapes weigh, and stays inside. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <weft/weft.h>

enum { DEBRIS = 20 };
static wfWorld world;
static wfBodyId debris[DEBRIS], player;
static void must(int ok, const char *what) { if (!ok) { printf("contacts: %s; %s\n", what, wfLastFault(&world)->text); exit(1); } }
static float random_from(float least, float most) { return least + (most - least) * (float)rand() / (float)RAND_MAX; }

static wfBodyInfo look(wfBodyId id)
{
    wfBodyInfo info;
    must(wfGetBody(&world, id, &info) == WF_OK, "a body");
    return info;
}

static void add_debris(int i)
{
    wfBodyDef def = wfDefaultBodyDef();
    def.position = wfV2(random_from(-38, 38), random_from(-38, 38));
    def.angle = random_from(-WF_PI, WF_PI);
    def.velocity = wfV2(random_from(-5, 5), random_from(-5, 5));
    def.angularVelocity = random_from(-1, 1);
    def.gravityScale = 0;
    def.restitution = 0.8f;
    def.userData = (uint64_t)i + 1;
    must((i % 3 == 2 ? wfMakeCircle(wfV2(0, 0), 0.5f, &def.shape)
          : i % 2 ? wfMakeCapsule(wfV2(0, -0.25f), wfV2(0, 0.25f), 0.25f, &def.shape)
          : wfMakeBox(0.4f, 0.6f, &def.shape)) == WF_OK, "a shape");
    must(wfAddBodyToWorld(&world, &def, &debris[i]) == WF_OK, "debris");
}

static void attach(wfBodyId id)      /* its shape changes over to the player, where it is */
{
    wfShapeDef shape;
    must(wfGetShape(&world, wfFirstShape(&world, id), &shape) == WF_OK, "its shape");
    wfBodyInfo from = look(id), to = look(player);
    wfTransform placed = wfMakeTransform(wfBodyLocalPoint(&world, player, from.position), from.angle - to.angle);
    wfShapePlace(&shape.shape, placed);
    must(wfAddShapeToBody(&world, player, &shape, NULL) == WF_OK && wfRemoveBodyFromWorld(&world, id) == WF_OK, "to attach it");
}

int main(void)
{
    wfWorldDef def = wfDefaultWorldDef();
    wfBodyDef ball = wfDefaultBodyDef();
    wfBodyId ground;
    wfShapeDef wall = wfDefaultShapeDef();
    static const wfVec2 corner[] = { WF_V2(-40, -40), WF_V2(-40, 40), WF_V2(40, 40), WF_V2(40, -40) };      /* clockwise: solid inwards */
    must(wfCreateWorld(&def, &world) == WF_OK, "the world");
    ball.type = WF_STATIC;
    must(wfAddBodyToWorld(&world, &ball, &ground) == WF_OK, "the ground");
    must(wfAddChainToBody(&world, ground, corner, 4, true, &wall, NULL) == WF_OK, "the walls");
    ball.type = WF_DYNAMIC;
    ball.gravityScale = 0;
    ball.linearDamping = ball.angularDamping = 0.5f;
    must(wfMakeCircle(wfV2(0, 0), 1, &ball.shape) == WF_OK && wfAddBodyToWorld(&world, &ball, &player) == WF_OK, "the player");
    wfShapeId core = wfFirstShape(&world, player);

    int made = 0, taken = 0, lost = 0, shapes = 0, free = 0;
    srand(1);
    for (int step = 0; step < 60 * 60; step++) {
        int i = 0, count, takes = 0, drops = 0;
        wfBodyId take[DEBRIS];
        wfShapeId drop[DEBRIS + 4];
        while (step % 30 == 0 && i < DEBRIS && wfBodyIsValid(&world, debris[i])) i++;
        if (step % 30 == 0 && i < DEBRIS) add_debris(i), made++;
        wfVec2 push = wfScale(step % 60 < 15 ? 200 : 0, wfRotate(wfRotation((float)step / 100), wfV2(1, 0)));      /* the keys */
        must(wfApplyForceToBody(&world, player, push, look(player).centre) == WF_OK && wfStepWorld(&world) == WF_OK, "a step");

        const wfContactEvent *event = wfWorldEvents(&world, WF_CONTACT_BEGIN, &count);
        for (int k = 0; k < count; k++) {
            wfBodyId a = wfShapeBody(&world, event[k].a), b = wfShapeBody(&world, event[k].b), other = WF_SAME(a, player) ? b : a;
            wfShapeId mine = WF_SAME(a, player) ? event[k].a : event[k].b;
            if (!WF_SAME(a, player) && !WF_SAME(b, player)) continue;
            if (!WF_SAME(other, ground)) take[takes++] = other;
            else if (!WF_SAME(mine, core)) drop[drops++] = mine;
        }
        for (int k = 0; k < takes; k++) if (wfBodyIsValid(&world, take[k])) attach(take[k]), taken++;
        for (int k = 0; k < drops; k++) lost += wfShapeIsValid(&world, drop[k]) && wfRemoveShapeFromWorld(&world, drop[k]) == WF_OK;
    }
    float mass = 0;
    for (int i = 0; i < DEBRIS; i++) free += wfBodyIsValid(&world, debris[i]);
    for (wfShapeId id = wfFirstShape(&world, player); id.index != 0; id = wfNextShape(&world, id)) {
        wfShapeDef shape;
        wfMassData data;
        must(wfGetShape(&world, id, &shape) == WF_OK && wfShapeMass(&shape.shape, shape.density, &data) == WF_OK, "a shape of the ball");
        mass += data.mass;
        shapes++;
    }
    printf("contacts: %d made, %d free, %d taken up: %d lost again and %d on the ball, which has %.3f kg\n",
           made, free, taken, lost, shapes - 1, look(player).mass);
    must(made == free + taken && taken == lost + shapes - 1 && lost > 0 && shapes > 1, "debris is lost");
    must(fabsf(look(player).mass / mass - 1) < 1e-5f, "the ball weighs something else than its shapes");
    must(fabsf(look(player).centre.x) < 40 && fabsf(look(player).centre.y) < 40, "the ball is out");
    return wfDestroyWorld(&world);
}
