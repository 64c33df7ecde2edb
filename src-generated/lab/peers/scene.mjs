/* Weft: lab/peers/scene.mjs, tangled from chapters/engine/02-similar-systems.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
// Reads a scene for the adapters in JavaScript. The same rules as scene.c.
import fs from 'node:fs';

/* refuse in JavaScript */
export function refuse(what) {
  process.stderr.write(`refused: ${what}\n`);
  process.exit(3);
}
export function fail(what) {
  process.stderr.write(`error: ${what}\n`);
  process.exit(1);
}

const words = text => new Set(text.split(' '));
const KEYS = {
  scene: ['weft settings bodies joints origin',
    'digits $schema name text view promises needs time steps',
    'forces pairMaterials', ''],
  body: ['name type position angle velocity angularVelocity fixedRotation shapes',
    'userData exact neverSleeps pivot',
    'mass linearDamping angularDamping push', 'gravityScale'],
  shape: ['kind centre radius halfWidth halfHeight angle vertices density restitution ' +
    'friction category mask', 'userData place exact material',
    'staticFriction rolling surfaceSpeed group sensor loop', ''],
  joint: ['kind a b anchor anchorA anchorB localA localB rest collide',
    'angle axis ratio lower upper stiffness damping springForce motorSpeed motorForce ' +
    'groundA groundB turnA turnB impulse given exact',
    'spring motor limits broken breakForce breakTorque', ''],
};
for (const k in KEYS) KEYS[k] = KEYS[k].map(words);

const neutral = (item, value) => typeof item === 'object' && item !== null
  ? Object.values(item).every(i => neutral(i, value)) : Number(item) === value;

function lookAtKeys(object, kind, where) {
  const [read, passed, zero, one] = KEYS[kind];
  for (const key of Object.keys(object))
    if (!(read.has(key) || passed.has(key) || zero.has(key) && neutral(object[key], 0) ||
          one.has(key) && neutral(object[key], 1)))
      refuse(`${where}${where ? '.' : ''}${key}`);
}

/* read shapes in JavaScript */
const turn = (x, y, angle, by) => {
  const c = Math.cos(angle), s = Math.sin(angle);
  return [by[0] + c * x - s * y, by[1] + s * x + c * y];
};

function bits(item, usual, limit) {
  if (item === undefined) return usual;
  const all = BigInt(item);
  if (limit && all > 0xffffn) refuse('category above 16 bits');
  return Number(all & 0xffffn);
}

function readShape(item, where) {
  lookAtKeys(item, 'shape', where);
  const s = { corners: [], centre: item.centre ?? [0, 0], radius: item.radius ?? 0,
    density: item.density ?? 1, friction: item.friction ?? 0.5,
    restitution: item.restitution ?? 0, category: bits(item.category, 1, true),
    mask: bits(item.mask, 0xffff, false) };
  if (item.kind === 'box')
    s.corners = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, y]) =>
      turn(x * item.halfWidth, y * item.halfHeight, item.angle ?? 0, s.centre));
  else if (item.kind === 'polygon') s.corners = item.vertices;
  else if (item.kind !== 'circle') refuse(`${where}: a ${item.kind}`);
  if (s.corners.length > 8) refuse(`${where}: more than 8 corners`);
  if (s.corners.length && s.radius !== 0) refuse(`${where}.radius: a rounded polygon`);
  return s;
}

function weigh(s, sum) {
  const add = (m, x, y) => { sum[0] += m; sum[1] += m * x; sum[2] += m * y; };
  const o = s.corners[0];
  if (!o) add(2 * s.density * Math.PI * s.radius * s.radius, s.centre[0], s.centre[1]);
  for (let i = 1; i + 1 < s.corners.length; i++) {
    const p = s.corners[i], q = s.corners[i + 1];
    const area = (p[0] - o[0]) * (q[1] - o[1]) - (p[1] - o[1]) * (q[0] - o[0]);
    add(s.density * area, (o[0] + p[0] + q[0]) / 3, (o[1] + p[1] + q[1]) / 3);
  }
}

/* read joints in JavaScript */
function readBody(item, where, origin) {
  lookAtKeys(item, 'body', where);
  const sum = [0, 0, 0];
  const position = (item.position ?? [0, 0]).map((p, i) => p + origin[i]);
  const b = { type: item.type ?? 'dynamic', position,
    angle: item.angle ?? 0, velocity: item.velocity ?? [0, 0],
    spin: item.angularVelocity ?? 0, fixedRotation: !!item.fixedRotation,
    centre: [0, 0], name: item.name };
  b.shapes = (item.shapes ?? []).map((s, i) => readShape(s, `${where}.shapes[${i}]`));
  b.shapes.forEach(s => weigh(s, sum));
  if (b.type === 'dynamic') {
    if (!(sum[0] > 0)) refuse(`${where}: it has no mass`);
    b.centre = [sum[1] / sum[0], sum[2] / sum[0]];
  }
  return b;
}

function readAnchor(item, global, local, origin, b) {
  if (item[local]) return [b.centre[0] + item[local][0], b.centre[1] + item[local][1]];
  const p = item[global] ?? item.anchor;
  if (!p) return b.centre;
  return turn(p[0] + origin[0] - b.position[0], p[1] + origin[1] - b.position[1], -b.angle,
    [0, 0]);
}

function readJoint(item, where, bodies, origin) {
  lookAtKeys(item, 'joint', where);
  if (!['revolute', 'distance', 'weld'].includes(item.kind))
    refuse(`${where}: a joint of kind ${item.kind}`);
  const find = w => typeof w === 'number' ? w : bodies.findIndex(b => b.name === w);
  const a = find(item.a), b = find(item.b);
  if (!bodies[a] || !bodies[b]) fail(`${where}: no such body`);
  const anchorA = readAnchor(item, 'anchorA', 'localA', origin, bodies[a]);
  const anchorB = readAnchor(item, 'anchorB', 'localB', origin, bodies[b]);
  const from = turn(...anchorA, bodies[a].angle, bodies[a].position);
  const to = turn(...anchorB, bodies[b].angle, bodies[b].position);
  return { kind: item.kind, a, b, anchorA, anchorB, collide: !!item.collide,
    rest: item.rest ?? Math.hypot(to[0] - from[0], to[1] - from[1]) };
}

/* read a scene in JavaScript */
export function readScene(file) {
  let root;
  try { root = JSON.parse(fs.readFileSync(file, 'utf8')); }
  catch (e) { fail(`${file}: ${e.message}`); }
  lookAtKeys(root, 'scene', '');
  const origin = root.origin ?? [0, 0];
  const bodies = (root.bodies ?? []).map((b, i) => readBody(b, `bodies[${i}]`, origin));
  const joints = (root.joints ?? []).map((j, i) =>
    readJoint(j, `joints[${i}]`, bodies, origin));
  const shapes = bodies.flatMap(b => b.shapes);
  const same = key => shapes.every(s => s[key] === shapes[0][key]);
  const set = root.settings ?? {};
  return { bodies, joints, gravity: set.gravity ?? [0, -9.81], dt: set.dt ?? 1 / 60,
    oneFriction: same('friction'), oneRestitution: same('restitution'),
    geometricFriction: (set.frictionMix ?? 'geometric-mean') === 'geometric-mean',
    greatestRestitution: (set.restitutionMix ?? 'maximum') === 'maximum' };
}
