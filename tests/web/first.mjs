// first.mjs: the functions that a visit (visit.mjs) calls: what the first part of the testbed's module keeps, tangle/web.first.
//   node tests/web/first.mjs build/web/whole.wasm > tangle/web.first       needs binaryen's wasm-split
import { readFileSync, mkdtempSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { execFileSync } from 'node:child_process';
import { visits } from './visit.mjs';
const whole = process.argv[2], room = mkdtempSync(join(tmpdir(), 'weft-')), noted = join(room, 'noted.wasm');
execFileSync('wasm-split', ['--instrument', '--all-features', whole, '-o', noted], { stdio: ['ignore', 'ignore', 'inherit'] });
const module = new WebAssembly.Module(readFileSync(noted));
rmSync(room, { recursive: true });
// the functions' names, in order, from the section that the linker left
const names = (() => {
  const bytes = Buffer.from(WebAssembly.Module.customSections(new WebAssembly.Module(readFileSync(whole)), 'name')[0]), list = [];
  let at = 0;
  const number = () => { let n = 0, shift = 0, b; do { b = bytes[at++]; n |= (b & 127) << shift; shift += 7; } while (b & 128); return n >>> 0; };
  while (at < bytes.length) {
    const kind = bytes[at++], end = number() + at;
    if (kind === 1) for (let left = number(); left--;) { const i = number(), size = number(); list[i] = bytes.toString('utf8', at, at + size); at += size; }
    at = end;
  }
  return list;
})();
const first = new Set();
for (const [, visit] of visits()) {
  const x = new WebAssembly.Instance(module, {}).exports;
  visit(x);
  // a hash of eight bytes, then for each function the moment of its first call, or 0
  const size = x.__write_profile(0, 1 << 20), told = Buffer.from(x.memory.buffer, 0, size);
  for (let i = 0; 8 + 4 * i < size; i++) if (told.readUInt32LE(8 + 4 * i)) first.add(names[i].replace(/\.\d+$/, ''));
}
console.log('# made by: node tests/web/first.mjs build/web/whole.wasm\n' + [...first].sort().join('\n'));
