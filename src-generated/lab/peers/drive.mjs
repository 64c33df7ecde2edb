/* Weft: lab/peers/drive.mjs, tangled from chapters/engine/02-similar-systems.nw. Do not edit this
 * file: edit the chapter and type make. MIT licence. */
// The loop of the adapters in JavaScript. The same options and rows as drive.c.
import { readScene, refuse, fail } from './scene.mjs';

/* options in JavaScript */
function readOptions(argv) {
  const o = { steps: 0, every: 1, substeps: 0, iterations: 0, dt: 0 };
  for (let i = 0; i < argv.length; i++) {
    const key = argv[i].slice(2);
    if (!argv[i].startsWith('--')) o.file = o.file ? refuse(`option ${argv[i]}`) : argv[i];
    else if (key in o) {
      o[key] = Number(argv[++i]);
      if (!(o[key] >= 0)) fail(`--${key}: a number should follow`);
    } else if (key === 'fast' || key === 'sleep') o[key] = true;
    else if (key === 'spoil') o.spoil = argv[++i];
    else if (key === 'bodies') o.noBodies = argv[++i] === 'none';
    else refuse(`option ${argv[i]}`);
  }
  if (!o.file) fail('use: NAME SCENE.json --steps N [options]');
  return o;
}

function compareWith(e, s, o) {
  const no = what => refuse(`${e.name}: ${what}`);
  if (o.iterations > 0 && !e.canIterate) no('--iterations: it has no such number');
  if (o.fast && !e.canSweep) no('--fast: it does not sweep bodies');
  if (o.sleep && !e.canSleep) no('--sleep');
  if (!s.oneFriction && !(e.mixesFriction && s.geometricFriction))
    no('shapes of different friction, so mixed');
  if (!s.oneRestitution && !(e.mixesRestitution && s.greatestRestitution))
    no('shapes of different restitution, so mixed');
  s.joints.forEach((j, i) => e.joints.includes(j.kind) || no(`joints[${i}]: ${j.kind}`));
}

function spoil(s, o) {
  const [key, word] = o.spoil.split('='), b = s.bodies.at(-1), p = b.shapes.at(-1);
  const odd = { nan: NaN, inf: Infinity };
  const value = word in odd ? odd[word] : Number(word);
  const c = p.corners;
  if (key === 'position' || key === 'velocity') b[key][0] = value;
  else if (key === 'spin') b.spin = value;
  else if (key === 'gravity') s.gravity[1] = value;
  else if (key === 'step') o.badStep = value;
  else if (key in p && typeof p[key] === 'number') p[key] = value;
  else if (key === 'corners') p.doubtful = true;
  else refuse(`option --spoil ${o.spoil}`);
  if (word === 'two') p.corners = c.slice(0, 2);
  if (word === 'flat') p.corners = c.map(q => [q[0], 0]);
  if (word === 'turned') p.corners = c.slice().reverse();
  if (word === 'concave') p.corners = c.map((q, i) => i === 2 ? q.map(x => -x / 2) : q);
}

function orRefuse(o, call) {
  try { return call(); }
  catch (error) {
    if (o.spoil && error.constructor === Error) refuse(error.message);
    throw error;
  }
}

function kernel(least) {
  for (let k = 0; k < 10; k++) {
    const start = performance.now();
    let x = 0.3;
    for (let i = 0; i < 100000; i++) x = 3.9 * x * (1 - x);
    const time = performance.now() - start;
    if (x >= 0 && time < least) least = time;
  }
  return least;
}

function row(e, s, o, step) {
  const states = s.bodies.map((b, i) => e.read(i));
  const heights = states.filter((_, i) => s.bodies[i].type === 'dynamic').map(v => v[1]);
  const mean = heights.reduce((a, b) => a + b, 0) / (heights.length || 1);
  const top = heights.reduce((a, b) => b > a ? b : a, -Infinity);
  const [pairs, points] = e.count();
  const cells = [step, step * o.dt, pairs, points, mean, heights.length ? top : 0];
  if (!o.noBodies) states.forEach(v => cells.push(...v));
  return cells.join(',').replace(/NaN/g, 'nan').replace(/Infinity/g, 'inf');
}

/* play a scene in JavaScript */
export function main(e) {
  if (process.argv[2] === '--version') return console.log(`${e.name}, ${e.real}`);
  const o = readOptions(process.argv.slice(2)), s = readScene(o.file), times = [];
  const out = [];
  o.dt = o.dt || s.dt;
  o.every = Math.max(1, o.every);
  compareWith(e, s, o);
  const parts = o.substeps > 1 && !e.ownSubsteps ? o.substeps : 1;
  let best = kernel(Infinity);
  if (o.spoil) spoil(s, o);
  orRefuse(o, () => e.build(s, o));
  out.push(`# ${e.name}, ${e.real}; dt=${o.dt} substeps=${o.substeps} ` +
    `iterations=${o.iterations} (0: its default)`);
  out.push('step,time,pairs,points,mean,top' + (o.noBodies ? '' : s.bodies.map((_, i) =>
    `,x${i},y${i},a${i},vx${i},vy${i},w${i}`).join('')));
  out.push(row(e, s, o, 0));
  for (let i = 1; i <= o.steps; i++) {
    /* make a step and time it */
    const start = performance.now();
    for (let k = 0; k < parts; k++) orRefuse(o, () => e.step(o.dt / parts));
    times.push(performance.now() - start);
    if ('badStep' in o && i === o.steps >> 2) orRefuse(o, () => e.step(o.badStep));
    if (i % o.every === 0 || i === o.steps) out.push(row(e, s, o, i));
  }
  best = kernel(best);
  /* tell the times of all steps */
  const sorted = times.slice().sort((a, b) => a - b), n = times.length;
  const mean = times.reduce((a, b) => a + b, 0) / n;
  if (n) out.push(`# clock: median=${sorted[n >> 1]} mean=${mean} least=${sorted[0]} ` +
    `most=${sorted[n - 1]} kernel=${best} ms`);
  process.stdout.write(out.join('\n') + '\n');
}
