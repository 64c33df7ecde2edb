/* Weft: lab/peers/planck.mjs, tangled from chapters/engine/02-similar-systems.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
// planck plays a scene. Needs the package planck.
import * as planck from 'planck';
import fs from 'node:fs';
import { main } from './drive.mjs';

let world, bodies, velocityPasses = 8, positionPasses = 3;
const vec = p => new planck.Vec2(p[0], p[1]);

/* a scene in planck */
function addBody(b, bullet) {
  const body = world.createBody({ type: b.type, position: vec(b.position), angle: b.angle,
    fixedRotation: b.fixedRotation, bullet: bullet && b.type === 'dynamic' });
  for (const s of b.shapes)
    body.createFixture({ shape: s.corners.length ? new planck.Polygon(s.corners.map(vec))
      : new planck.Circle(vec(s.centre), s.radius), density: s.density,
      friction: s.friction, restitution: s.restitution, filterCategoryBits: s.category,
      filterMaskBits: s.mask });
  body.setLinearVelocity(vec(b.velocity));
  body.setAngularVelocity(b.spin);
  return body;
}

function addJoint(j) {
  const a = bodies[j.a], b = bodies[j.b];
  const def = { bodyA: a, bodyB: b, localAnchorA: vec(j.anchorA),
    localAnchorB: vec(j.anchorB), collideConnected: j.collide, length: j.rest,
    referenceAngle: b.getAngle() - a.getAngle() };
  const kinds = { revolute: planck.RevoluteJoint, distance: planck.DistanceJoint,
    weld: planck.WeldJoint };
  world.createJoint(new kinds[j.kind](def));
}

function build(scene, o) {
  world = new planck.World({ gravity: vec(scene.gravity), allowSleep: !!o.sleep });
  if (o.iterations) {
    velocityPasses = o.iterations;
    positionPasses = Math.ceil(3 * o.iterations / 8);
  }
  bodies = scene.bodies.map(b => addBody(b, !!o.fast));
  scene.joints.forEach(addJoint);
}

/* run planck */
function read(i) {
  const b = bodies[i], at = b.getWorldCenter(), v = b.getLinearVelocity();
  return [at.x, at.y, b.getAngle(), v.x, v.y, b.getAngularVelocity()];
}

function count() {
  let pairs = 0, points = 0;
  for (let c = world.getContactList(); c; c = c.getNext())
    if (c.isTouching()) {
      pairs++;
      points += c.getManifold().pointCount;
    }
  return [pairs, points];
}

const version = JSON.parse(fs.readFileSync(
  new URL('./node_modules/planck/package.json', import.meta.url))).version;
main({ name: `planck ${version}`, real: 'double', canIterate: true, canSweep: true,
  canSleep: true, mixesFriction: true, mixesRestitution: true,
  joints: ['revolute', 'distance', 'weld'], build, read, count,
  step: dt => world.step(dt, velocityPasses, positionPasses) });
