import { World, Shape, Body, Joint, type Hit, type ShapeDef } from 'weft-physics';
const world = new World({ gravity: { x: 0, y: -10 }, bodyCapacity: 100, slop: 0.01 });
const def: ShapeDef = { ...Shape.circle(0.5), density: 2, filter: { mask: 3n } };
const ball: Body = world.createBody({ type: 'dynamic', position: { x: 0, y: 1 }, shapes: [def] });
const joint: Joint = world.createJoint({ kind: 'distance', lower: 1 }, ball, world.createBody());
const hit: Hit | null = world.castRay({ x: 0, y: 5 }, { x: 0, y: -9 });
ball.velocity = { x: joint.speed, y: hit ? hit.fraction : 0 };
const states: Float32Array = world.states, bytes: Uint8Array = world.snapshot(), hash: bigint = world.hash;
export { states, bytes, hash };
// @ts-expect-error -- no such kind
world.createJoint({ kind: 'hinge' }, ball, ball);
// @ts-expect-error -- positions are read only: setTransform
ball.position = { x: 0, y: 0 };
