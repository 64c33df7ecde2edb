// The package as its users have it: node --test. HASH is what scene.c prints.
import { test } from 'node:test';
import assert from 'node:assert/strict';
import { World, Shape, WeftError, version } from 'weft-physics';
import { play } from './scene.mjs';

test('the same bits as in C', () => { assert.equal(String(play({ World, Shape }).hash), process.env.HASH); });
test('the version is that of the headers', () => { assert.equal(version(), process.env.VERSION); });

test('a fall: y = y0 - g t^2 / 2 within a step', () => {
  const world = new World({ gravity: [0, -10] }), ball = world.createBody({ position: [0, 100], shapes: [Shape.circle(0.5)] });
  world.step(60);
  const t = world.time, error = Math.abs(ball.position.y - (100 - 5 * t * t));
  assert.ok(error <= 10 * t / 60 / 2 + 1e-3, `off by ${error}`);         // half a step at the final speed, and rounding
  assert.ok(Math.abs(ball.mass - Math.PI / 4) < 1e-5);
});

test('states are the engine\'s own, also after memory has grown', () => {
  const world = play({ World, Shape }, 10), body = world.bodies[5], before = world.states.slice();
  const others = Array.from({ length: 20 }, () => new World());          // 80 MB: the buffer is another now
  assert.deepEqual(world.states, before);
  const at = 8 * body.index, { x, y } = body.centre;
  assert.deepEqual([...world.states.slice(at, at + 3)], [x, y, body.angle].map(Math.fround));
  others.forEach(w => w.destroy());
});

test('memory that is given back is used again', () => {
  const size = () => { const w = new World(); const n = w.states.buffer.byteLength; w.destroy(); return n; };
  const first = size();
  for (let k = 0; k < 50; k++) size();
  assert.equal(size(), first);
});

test('a snapshot takes the world back, bit for bit', () => {
  const world = play({ World, Shape }, 100), kept = world.snapshot(), at = world.hash;
  assert.ok(kept instanceof Uint8Array && kept.length < 200000);
  world.step(50);
  const then = world.hash;
  world.restore(kept);
  assert.equal(world.hash, at);
  world.step(50);
  assert.equal(world.hash, then);
  const twin = play({ World, Shape }, 0);
  twin.restore(kept);
  twin.step(50);
  assert.equal(twin.hash, then);
  for (const bad of [kept.slice(0, 5), kept.slice(0, -1), new Uint8Array(100)]) {
    assert.throws(() => world.restore(bad), { code: 'WF_ERROR_NOT_A_WORLD' });
    assert.equal(world.hash, then);
  }
  assert.throws(() => new World({ bodyCapacity: 10 }).restore(kept), WeftError);
});

test('what is refused says why, and changes nothing', () => {
  const world = play({ World, Shape }, 5), hash = world.hash;
  assert.throws(() => world.createBody({ position: [NaN, 0] }), { code: 'WF_ERROR_NOT_FINITE', message: /position\.x/ });
  assert.throws(() => world.createBody({ positon: [0, 0] }), { code: 'WF_ERROR_UNKNOWN', message: /"positon".*position/ });
  assert.throws(() => world.createBody({ shapes: [{ ...Shape.circle(1), friction: -1 }] }), { code: 'WF_ERROR_RANGE', message: /friction/ });
  assert.throws(() => Shape.circle(-1), { code: 'WF_ERROR_SIZE' });
  assert.throws(() => new World({ timeStep: 0 }), { code: 'WF_ERROR_RANGE', message: /timeStep/ });
  for (const many of [1.5, 2 ** 32 + 5, -(2 ** 31) - 1, NaN, 'five'])       // none is cut to fit
    assert.throws(() => new World({ bodyCapacity: many }), { code: 'WF_ERROR_RANGE', message: /bodyCapacity/ });
  assert.throws(() => new World({ modules: -1 }), { code: 'WF_ERROR_RANGE', message: /modules/ });
  assert.equal(world.hash, hash);
  const body = world.bodies[3];
  body.destroy();
  assert.equal(body.valid, false);
  assert.throws(() => body.position, { code: 'WF_ERROR_STALE_ID' });
  world.destroy();
  assert.throws(() => world.step(), { code: 'WF_ERROR_NULL' });
});

test('contacts, hits, sensors, rays, overlaps', () => {
  const world = new World(), ground = world.createBody({ type: 'static', shapes: [Shape.box(10, 1)] });
  const ball = world.createBody({ position: [0, 3], userData: 'ball', shapes: [{ ...Shape.circle(0.5), restitution: 0 }] });
  const gate = world.createBody({ type: 'static', position: [0, 2.2], shapes: [{ ...Shape.box(1, 0.1), sensor: 1 }] });
  let begun = 0, seen = 0, hits = 0;
  for (let k = 0; k < 60; k++) {
    world.step();
    for (const { a, b, impulse } of world.contacts('begin')) { begun++; assert.ok(new Set([a.body, b.body]).has(ground) && impulse > 0); }
    seen += world.contacts('sensorBegin').filter(e => e.a.body === gate && e.b.body.userData === 'ball').length;
    hits += world.hits.length;
  }
  assert.equal(begun, 1); assert.equal(seen, 1); assert.equal(hits, 1);
  const hit = world.castRay([5, 5], [0, -10], { mask: 1n });
  assert.ok(hit.shape.body === ground && Math.abs(hit.fraction - 0.4) < 1e-6 && hit.normal.y === 1);
  assert.equal(world.castRay([50, 5], [0, -10]), null);
  assert.deepEqual(world.overlapPoint(ball.position).map(s => s.body), [ball]);
  assert.equal(world.overlapArea([-20, -5], [20, 5]).length, 3);
});

test('joints: a limit holds, a motor turns, a load is a weight', () => {
  const world = new World({ gravity: [0, -10] }), wall = world.createBody({ type: 'static' });
  const wheel = world.createBody({ position: [3, 0], shapes: [Shape.circle(0.5)] });
  const hinge = world.createJoint({ kind: 'revolute', anchor: [3, 0], motorSpeed: 2, motorForce: 100 }, wall, wheel);
  world.step(60);
  assert.ok(Math.abs(hinge.speed - 2) < 1e-3 && Math.abs(wheel.angularVelocity - 2) < 1e-3);
  assert.ok(Math.abs(hinge.load.force.y - 10 * wheel.mass) < 1e-2);
  hinge.set({ motorSpeed: 0, lower: -0.5, upper: 0.5 });
  assert.equal(hinge.def.motorSpeed, 0);
  assert.throws(() => world.createJoint({ kind: 'revolut' }, wall, wheel), { code: 'WF_ERROR_UNKNOWN' });
  hinge.destroy();
  assert.equal(hinge.valid, false);
});

test('advance makes whole steps and no more than allowed', () => {
  const world = new World();
  const rest = world.advance(2.5 / 60);
  assert.equal(world.steps, 2n); assert.ok(Math.abs(rest - 0.5) < 1e-3);
  world.advance(100, 4);
  assert.equal(world.steps, 6n);
  world.advance(-0.005);                               // a page's first frame
  assert.equal(world.steps, 6n);
  for (const seconds of [NaN, 'a', undefined]) assert.throws(() => world.advance(seconds), { code: 'WF_ERROR_RANGE', message: /seconds/ });
  world.advance(1.5 / 60);
  assert.equal(world.steps, 7n);
});

test('steps and types that make no sense are refused', () => {
  const world = new World(), body = world.createBody({ shapes: [Shape.circle(0.5)] });
  for (const count of [-1, 1.5, 'a', NaN]) assert.throws(() => world.step(count), { code: 'WF_ERROR_RANGE', message: /count/ });
  const wrong = { code: 'WF_ERROR_UNKNOWN', message: /dynamical.*kinematic/ };
  assert.throws(() => world.createBody({ type: 'dynamical' }), wrong);
  assert.throws(() => { body.type = 'dynamical'; }, wrong);
  assert.equal(world.steps, 0n); assert.equal(body.type, 'dynamic');
});

test('a hand pulls, a kinematic body arrives, forms are cut', () => {
  const world = new World({ gravity: [0, 0] }), ball = world.createBody({ shapes: [Shape.circle(0.5)] });
  const hand = world.grab(ball, [0, 0]);
  hand.move([2, 0]); world.step(120);
  assert.ok(Math.abs(ball.position.x - 2) < 0.01);
  hand.release();
  const lift = world.createBody({ type: 'kinematic' });
  lift.setTarget([0, 1], 0, 1 / 60); world.step();
  assert.ok(Math.abs(lift.position.y - 1) < 1e-5);
  assert.equal(Shape.chain([[0, 0], [1, 0], [2, 1]]).length, 2);
  assert.equal(Shape.outline([[0, 0], [4, 0], [4, 4], [2, 1], [0, 4]]).length, 3);
});
