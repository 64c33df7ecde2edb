// A pyramid, an arm with a motor, a chain: the world of scene.c. Weft: the package, or the global of a page.
export function play({ World, Shape }, steps = 300) {
  const world = new World({ gravity: { x: 0, y: -10 } });
  const body = (type, x, y, form) => world.createBody({ type, position: [x, y], shapes: [form] });
  const ground = body('static', 0, 0, Shape.box(12, 0.5));
  for (let row = 0; row < 8; row++) for (let k = 0; k <= row; k++) body('dynamic', k - row / 2, 8 - row, Shape.box(0.45, 0.45));
  const arm = body('dynamic', -7, 5, Shape.box(2, 0.25));
  world.createJoint({ kind: 'revolute', anchor: [-7, 5], motorSpeed: 2, motorForce: 500 }, ground, arm);
  let last = ground;
  for (let k = 0; k < 10; k++) {
    const next = body('dynamic', 6 + k / 2, 9, Shape.circle(0.25));
    world.createJoint({ kind: 'revolute', anchor: [5.75 + k / 2, 9] }, last, next);
    last = next;
  }
  world.step(steps);
  return world;
}
