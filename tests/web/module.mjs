// module.mjs: the testbed's module in node: every scene's words must be those of weft-headless, digit for digit, in one piece and in two.
//   node tests/web/module.mjs build/web build/bin/weft-headless [STEPS [SCENE ...]]      these scenes alone, and no visits
import { readFileSync, existsSync, mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { execFileSync } from 'node:child_process';
import { named, described, visits } from './visit.mjs';
const [dir, headless, steps = 100, ...only] = process.argv.slice(2);
const module = name => new WebAssembly.Module(readFileSync(join(dir, name)));
let bad = 0;
const fail = text => { bad++; console.log('module: ' + text); };
const whole = module('whole.wasm'), first = module('testbed.wasm');
const wants = m => WebAssembly.Module.imports(m);
if (wants(whole).length) fail(`it imports ${wants(whole).map(w => w.name).join(', ')} -- a page has none of these: find who calls them, see tangle/web.mk`);
const two = wants(first).length > 0, rest = two ? module('testbed-rest.wasm') : null;
if (wants(first).some(w => w.module !== 'placeholder')) fail('the first part imports more than the second');

// the first part alone serves a visit
const alone = () => {
  const placeholder = Object.fromEntries(wants(first).map(w => [w.name, () => { throw new Error('the second part is called'); }]));
  return new WebAssembly.Instance(first, { placeholder }).exports;
};
let visited = 0;
for (const [name, visit] of only.length ? [] : visits()) {
  try { visit(alone()); visited++; } catch (e) { fail(`${name}: ${e.message} -- tests/web/weight.sh makes the list of the first part anew`); }
}
const both = () => {
  const x = alone();
  if (two) new WebAssembly.Instance(rest, { primary: x });
  return x;
};

const list = execFileSync(headless, ['--record', '--steps', '1'], { encoding: 'utf8' });
const log = join(mkdtempSync(join(tmpdir(), 'weft-')), 'log');
const rows = list.trim().split('\n').filter(l => !l.startsWith('#')).slice(1).map(l => l.split(',')).filter(([scene]) => !only.length || only.includes(scene));
if (only.length && rows.length < only.length) fail(`weft-headless knows not all of ${only.join(', ')}`);
const hash = text => (text.match(/^hash ([0-9a-f]+)$/m) || [])[1];
const played = (x, scene, frame) => {
  if (!named(x, scene)) return fail(`it does not know the scene ${scene}`);
  x[frame](320, 200, 1, 0, 0);
  for (let i = 0; i < steps; i++) x[frame](320, 200, 1, 0, 1);
  const said = described(x);
  if (!said.split('\n').includes('scene ' + scene)) fail(`asked for ${scene}, it shows ${said.split('\n')[0]}`);
  return hash(said);
};
for (const [scene] of rows) {
  execFileSync(headless, ['--play', '--scene', scene, '--steps', String(steps), '--size', '320x200', '--log', log]);
  const want = hash(readFileSync(log, 'utf8'));
  const got = { 'in one piece': played(new WebAssembly.Instance(whole, {}).exports, scene, 'web_frame'), ...(two && { 'in two': played(both(), scene, 'web_frame') }),
    'with nobody watching': played(both(), scene, 'web_unseen') };
  for (const [how, is] of Object.entries(got)) if (!want || is !== want) fail(`${scene}, ${how}: hash ${is} after ${steps} steps, natively ${want}`);
}
console.log(`module: ${rows.length} scenes, in ${two ? 'one piece and in two' : 'one piece'}; ${visited} visits by the first part alone; ${bad} failures after ${steps} steps`);
process.exit(bad ? 1 : 0);
