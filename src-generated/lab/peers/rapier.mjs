/* Weft: lab/peers/rapier.mjs, tangled from chapters/engine/02-similar-systems.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
// Rapier plays a scene. Needs the package @dimforge/rapier2d-compat, or, if
// this file's name has "simd" in it, @dimforge/rapier2d-simd-compat.
import { main } from './drive.mjs';
import { refuse } from './scene.mjs';

const simd = /simd/.test(process.argv[1] ?? '');
const RAPIER = (await import(simd ? '@dimforge/rapier2d-simd-compat'
  : '@dimforge/rapier2d-compat')).default;
const log = console.warn;
console.warn = () => {};            // it warns of its own start
await RAPIER.init();
console.warn = log;
let world, bodies, dynamic;

/* a scene in Rapier */
const vec = p => ({ x: p[0], y: p[1] });

function addShape(s, body) {
  const corners = new Float32Array(s.corners.flat());
  const desc = s.doubtful ? RAPIER.ColliderDesc.convexHull(corners)
    : s.corners.length ? RAPIER.ColliderDesc.convexPolyline(corners)
    : RAPIER.ColliderDesc.ball(s.radius).setTranslation(s.centre[0], s.centre[1]);
  if (desc === null) refuse('rapier: these corners have no hull');
  desc.setDensity(s.density).setFriction(Math.sqrt(s.friction))
    .setRestitution(s.restitution)
    .setCollisionGroups(s.category * 65536 + s.mask);
  desc.setFrictionCombineRule(RAPIER.CoefficientCombineRule.Multiply);
  desc.setRestitutionCombineRule(RAPIER.CoefficientCombineRule.Max);
  world.createCollider(desc, body);
}

function addBody(b, o) {
  const kinds = { static: 'fixed', kinematic: 'kinematicVelocityBased',
    dynamic: 'dynamic' };
  const desc = RAPIER.RigidBodyDesc[kinds[b.type]]();
  desc.setTranslation(b.position[0], b.position[1]).setRotation(b.angle)
    .setCanSleep(!!o.sleep).setCcdEnabled(!!o.fast && b.type === 'dynamic');
  if (b.fixedRotation) desc.lockRotations();
  const body = world.createRigidBody(desc);
  b.shapes.forEach(s => addShape(s, body));
  if (b.type === 'static') return body;
  body.setLinvel(vec(b.velocity), true);
  body.setAngvel(b.spin, true);
  return body;
}

function addJoint(j) {
  const a = bodies[j.a], b = bodies[j.b], p = vec(j.anchorA), q = vec(j.anchorB);
  const turned = b.rotation() - a.rotation();
  const data = j.kind === 'revolute' ? RAPIER.JointData.revolute(p, q)
    : RAPIER.JointData.fixed(p, turned, q, 0);
  world.createImpulseJoint(data, a, b, true).setContactsEnabled(j.collide);
}

/* run Rapier */
function build(scene, o) {
  world = new RAPIER.World(vec(scene.gravity));
  if (o.iterations) world.numSolverIterations = o.iterations;
  dynamic = scene.bodies.map(b => b.type === 'dynamic');
  bodies = scene.bodies.map(b => addBody(b, o));
  scene.joints.forEach(addJoint);
}

function step(dt) {
  world.timestep = dt;
  world.step();
}

function read(i) {
  const b = bodies[i], at = b.worldCom(), v = b.linvel();
  return [at.x, at.y, b.rotation(), v.x, v.y, b.angvel()];
}

function count() {
  const seen = new Set();
  let points = 0;
  world.colliders.forEach(c => world.contactPairsWith(c, d => {
    const key = Math.min(c.handle, d.handle) + ' ' + Math.max(c.handle, d.handle);
    if (seen.has(key)) return;
    let n = 0;
    world.contactPair(c, d, m => { n += m.numSolverContacts(); });
    if (n > 0) seen.add(key);
    points += n;
  }));
  return [seen.size, points];
}

main({ name: `Rapier ${RAPIER.version()}${simd ? ' wide' : ''}`, real: 'float',
  canIterate: true, canSweep: true, canSleep: true, mixesFriction: true,
  mixesRestitution: true, joints: ['revolute', 'weld'], build, read, count, step });
