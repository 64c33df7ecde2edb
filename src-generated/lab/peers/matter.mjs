/* Weft: lab/peers/matter.mjs, tangled from chapters/engine/02-similar-systems.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
// Matter.js plays a scene. Needs the package matter-js.
import Matter from 'matter-js';
import { createRequire } from 'node:module';
import { main } from './drive.mjs';
import { refuse } from './scene.mjs';

const { Engine, Bodies, Body, Composite, Constraint, Detector } = Matter;
const UNITS = 100, BASE = 1 / 60;       // pixels a metre; s, of its velocities
let engine, bodies;

/* a scene in Matter */
const place = p => ({ x: UNITS * p[0], y: -UNITS * p[1] });

function addBody(b, i) {
  if (b.shapes.length !== 1) refuse(`matter: bodies[${i}]: other than one shape`);
  if (b.type === 'kinematic') refuse(`matter: bodies[${i}]: a kinematic body`);
  const s = b.shapes[0], options = { isStatic: b.type === 'static', friction: s.friction,
    density: s.density / (UNITS * UNITS), restitution: s.restitution, frictionAir: 0,
    collisionFilter: { group: 0, category: s.category, mask: s.mask, body: i } };
  if (s.corners.length === 0 && (s.centre[0] !== 0 || s.centre[1] !== 0))
    refuse(`matter: bodies[${i}]: a circle beside its body's origin`);
  const c = Math.cos(b.angle), n = Math.sin(b.angle), m = middle(s);
  const at = place([b.position[0] + c * m[0] - n * m[1],
    b.position[1] + n * m[0] + c * m[1]]);
  /* make a circle or a polygon for Matter */
  const body = s.corners.length === 0 ? Bodies.circle(at.x, at.y, UNITS * s.radius, options)
    : s.doubtful
      ? Bodies.fromVertices(at.x, at.y, [s.corners.map(place).reverse()], options)
    : Body.create({ ...options, position: at, vertices: s.corners.map(place).reverse() });
  Body.setAngle(body, -b.angle);
  if (b.fixedRotation) Body.setInertia(body, Infinity);
  if (b.type === 'dynamic') {
    Body.setVelocity(body, place(b.velocity.map(v => v * BASE)));
    Body.setAngularVelocity(body, -b.spin * BASE);
  }
  body.weftCentre = m;
  return body;
}

function middle(s) {
  if (s.corners.length === 0) return s.centre;
  let area = 0, x = 0, y = 0;
  s.corners.forEach((p, i) => {
    const q = s.corners[(i + 1) % s.corners.length], a = p[0] * q[1] - p[1] * q[0];
    area += 3 * a;
    x += a * (p[0] + q[0]);
    y += a * (p[1] + q[1]);
  });
  return area === 0 ? [0, 0] : [x / area, y / area];
}

const anchor = (body, p) => {
  const c = Math.cos(body.angle), s = Math.sin(body.angle);
  const at = place([p[0] - body.weftCentre[0], p[1] - body.weftCentre[1]]);
  return { x: c * at.x - s * at.y, y: s * at.x + c * at.y };
};

function addJoint(j) {
  const bodyA = bodies[j.a], bodyB = bodies[j.b];
  return Constraint.create({ bodyA, bodyB, pointA: anchor(bodyA, j.anchorA),
    pointB: anchor(bodyB, j.anchorB), stiffness: 1,
    length: j.kind === 'distance' ? UNITS * j.rest : 0 });
}

function build(scene, o) {
  engine = Engine.create({ enableSleeping: !!o.sleep });
  engine.gravity = { x: scene.gravity[0], y: -scene.gravity[1], scale: UNITS * 1e-6 };
  if (o.iterations) engine.positionIterations = engine.velocityIterations = o.iterations;
  bodies = scene.bodies.map(addBody);
  Composite.add(engine.world, bodies);
  Composite.add(engine.world, scene.joints.map(addJoint));
  const apart = new Set(scene.joints.filter(j => !j.collide)
    .flatMap(j => [`${j.a} ${j.b}`, `${j.b} ${j.a}`])), usual = Detector.canCollide;
  if (apart.size) Detector.canCollide = (a, b) =>
    !apart.has(`${a.body} ${b.body}`) && usual(a, b);
}

/* run Matter */
function read(i) {
  const b = bodies[i], v = b.isStatic ? { x: 0, y: 0 } : Body.getVelocity(b);
  return [b.position.x / UNITS, -b.position.y / UNITS, -b.angle, v.x / UNITS / BASE,
    -v.y / UNITS / BASE, b.isStatic ? 0 : -Body.getAngularVelocity(b) / BASE];
}

function count() {
  const touching = engine.pairs.list.filter(p => p.isActive);
  return [touching.length, touching.reduce((n, p) => n + (p.contactCount ?? 0), 0)];
}

const { version } = createRequire(import.meta.url)('matter-js/package.json');
main({ name: `Matter.js ${version}`, real: 'double', canIterate: true, canSleep: true,
  mixesRestitution: true, joints: ['revolute', 'distance'],
  build, read, count, step: dt => Engine.update(engine, 1000 * dt) });
