// module.mjs: the testbed's module in node: every scene's words must be those of weft-headless, digit for digit.
//   node tests/web/module.mjs build/web/testbed.wasm build/bin/weft-headless [STEPS]
import { readFileSync, mkdtempSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { execFileSync } from 'node:child_process';
const [wasm, headless, steps = 100] = process.argv.slice(2);
const module = new WebAssembly.Module(readFileSync(wasm));
const wants = WebAssembly.Module.imports(module);
if (wants.length) { console.log('module: it imports ' + wants.map(w => w.name).join(', ') + ' -- a page has none of these: find who calls them, see tangle/web.mk'); process.exit(1); }
const list = execFileSync(headless, ['--record', '--steps', '1'], { encoding: 'utf8' });
const log = join(mkdtempSync(join(tmpdir(), 'weft-')), 'log');
const rows = list.trim().split('\n').filter(l => !l.startsWith('#')).slice(1).map(l => l.split(','));
const utf8 = new TextEncoder(), words = new TextDecoder();
let bad = 0;
for (const [scene, , hash] of rows) {
  const x = new WebAssembly.Instance(module, {}).exports;
  const bytes = utf8.encode(scene);
  new Uint8Array(x.memory.buffer, x.web_name(), bytes.length).set(bytes);
  if (!x.web_open(bytes.length)) { console.log(`module: it does not know the scene ${scene}`); bad++; continue; }
  x.web_frame(320, 200, 1, 0, 0);
  for (let i = 0; i < steps; i++) x.web_frame(320, 200, 1, 0, 1);
  const said = words.decode(new Uint8Array(x.memory.buffer, x.web_name(), x.web_describe()));
  const [, got] = said.match(/^hash ([0-9a-f]+)$/m) || [];
  if (!new RegExp(`^scene ${scene}$`, 'm').test(said)) { console.log(`module: asked for ${scene}, it shows ${said.split('\n')[0]}`); bad++; }
  execFileSync(headless, ['--play', '--scene', scene, '--steps', String(steps), '--size', '320x200', '--log', log]);
  const native = readFileSync(log, 'utf8');
  const [, want] = native.match(/^hash ([0-9a-f]+)$/m) || [];
  if (!want || got !== want) { console.log(`module: ${scene}: hash ${got} after ${steps} steps, natively ${want}`); bad++; }
}
console.log(`module: ${rows.length} scenes, ${bad} differ from the native program after ${steps} steps`);
process.exit(bad ? 1 : 0);
