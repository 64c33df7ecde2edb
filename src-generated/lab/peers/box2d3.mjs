/* Weft: lab/peers/box2d3.mjs, tangled from chapters/engine/02-similar-systems.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
// Box2D 3 in WebAssembly plays a scene. Needs the package box2d3-wasm.
import box2d3 from 'box2d3-wasm';
import { main } from './drive.mjs';
import { refuse } from './scene.mjs';

const B = await box2d3();
let world, bodies, scene, substeps = 4;
const vec = p => new B.b2Vec2().Set(p[0], p[1]);

/* a scene in Box2D 3 for the web */
function addShape(body, s) {
  const def = B.b2DefaultShapeDef(), filter = def.filter, material = def.material;
  def.density = s.density;
  material.friction = s.friction;
  material.restitution = s.restitution;
  def.material = material;
  filter.categoryBits = s.category;
  filter.maskBits = s.mask;
  def.filter = filter;
  if (s.corners.length) {
    const hull = B.b2ComputeHull(s.corners.map(vec));
    if (hull.count === 0) refuse('box2d: these corners have no hull');
    return B.b2CreatePolygonShape(body, def, B.b2MakePolygon(hull, 0));
  }
  const circle = new B.b2Circle();
  circle.center = vec(s.centre);
  circle.radius = s.radius;
  return B.b2CreateCircleShape(body, def, circle);
}

function addBody(b, bullet) {
  const def = B.b2DefaultBodyDef(), locks = def.motionLocks;
  def.type = { static: B.b2BodyType.b2_staticBody, dynamic: B.b2BodyType.b2_dynamicBody,
    kinematic: B.b2BodyType.b2_kinematicBody }[b.type];
  def.position = vec(b.position);
  def.rotation = B.b2MakeRot(b.angle);
  locks.angularZ = b.fixedRotation;
  def.motionLocks = locks;
  def.isBullet = bullet && b.type === 'dynamic';
  const body = B.b2CreateBody(world, def);
  b.shapes.forEach(s => addShape(body, s));
  B.b2Body_SetLinearVelocity(body, vec(b.velocity));
  B.b2Body_SetAngularVelocity(body, b.spin);
  return body;
}

function addJoint(j) {
  const kind = { revolute: 'Revolute', distance: 'Distance', weld: 'Weld' }[j.kind];
  const def = B[`b2Default${kind}JointDef`](), base = def.base;
  const frameA = base.localFrameA, frameB = base.localFrameB;
  base.bodyIdA = bodies[j.a];
  base.bodyIdB = bodies[j.b];
  frameA.p = vec(j.anchorA);
  frameB.p = vec(j.anchorB);
  frameA.q = B.b2MakeRot(scene.bodies[j.b].angle - scene.bodies[j.a].angle);
  base.localFrameA = frameA;
  base.localFrameB = frameB;
  base.collideConnected = j.collide;
  def.base = base;
  if (j.kind === 'distance') def.length = j.rest;
  B[`b2Create${kind}Joint`](world, def);
}

function build(s, o) {
  const def = B.b2DefaultWorldDef();
  scene = s;
  def.gravity = vec(s.gravity);
  def.enableSleep = !!o.sleep;
  world = B.b2CreateWorld(def);
  substeps = o.substeps || substeps;
  const moves = b => b.velocity.concat(b.spin).some(v => v !== 0);
  bodies = s.bodies.map(b => addBody(b, o.fast && moves(b)));
  s.joints.forEach(addJoint);
}

/* run Box2D 3 for the web */
function read(i) {
  const b = bodies[i], at = B.b2Body_GetWorldCenterOfMass(b);
  const v = B.b2Body_GetLinearVelocity(b), q = B.b2Body_GetRotation(b);
  return [at.x, at.y, Math.atan2(q.s, q.c), v.x, v.y, B.b2Body_GetAngularVelocity(b)];
}

function count() {
  const seen = new Set();
  let points = 0;
  scene.bodies.forEach((b, i) => {
    const room = b.type === 'dynamic' ? B.b2Body_GetContactCapacity(bodies[i]) : 0;
    if (room === 0) return;
    for (const c of B.b2Body_GetContactData(bodies[i], room)) {
      const key = `${c.shapeIdA.index1} ${c.shapeIdB.index1}`;
      if (!seen.has(key)) points += c.manifold.pointCount;
      seen.add(key);
    }
  });
  return [seen.size, points];
}
const v = B.b2GetVersion ? B.b2GetVersion() : null;
main({ name: v ? `Box2D ${v.major}.${v.minor}.${v.revision} web` : 'Box2D 3 web',
  real: 'float', ownSubsteps: true, canSweep: true, canSleep: true, mixesFriction: true,
  mixesRestitution: true, joints: ['revolute', 'distance', 'weld'], build, read, count,
  step: dt => B.b2World_Step(world, dt, substeps) });
