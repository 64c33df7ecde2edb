// visit.mjs: what a reader's first minutes ask of the testbed's module: the testbed opens, on a desk and on a phone, light and dark, a body
// is dragged, the picture moved; and each scene that a chapter shows runs for five seconds. (first.mjs, module.mjs)
import { readFileSync } from 'node:fs';
import { execFileSync } from 'node:child_process';
const utf8 = new TextEncoder(), words = new TextDecoder();
export const shown = () => [...new Set(execFileSync('tangle/chapters', { encoding: 'utf8' }).trim().split('\n').flatMap(f =>
  [...readFileSync(f, 'utf8').matchAll(/scenes\/([a-zA-Z0-9-]+)-\d+\.svg/g)].map(m => m[1].replaceAll('-', ' '))))].sort();
export const named = (x, scene) => {
  const bytes = utf8.encode(scene);
  new Uint8Array(x.memory.buffer, x.web_name(), bytes.length).set(bytes);
  return x.web_open(bytes.length);
};
export const described = x => words.decode(new Uint8Array(x.memory.buffer, x.web_name(), x.web_describe()));
// scenes of chapters that are left to the second part, should the first grow too heavy; the chapter on platform layers would have to say so
const late = ['TC06 quad tree', 'integrators', 'round edges', 'crane', 'spring and orbit', 'ton joint by joint', 'gate', 'bungee', 'arch', 'hammers', 'ramp', 'pendulums', 'card house', 'buoyancy', 'probe', 'ragdolls', 'spring net', 'TC08 positional correction', 'bridge', 'clock', 'TC03 separating axis', 'TC04 contact points', 'TC05 colours', 'TC07 pairs', 'islands', 'bullet room', 'heavy on light', 'shapes', 'tumbler', 'support removed'];      // the overlay tree and all of the quad tree; what no other scene calls
const frames = (x, count, width = 1280, height = 800, scale = 1) => {
  for (let i = 0; i < count; i++) {
    x.web_frame(width, height, scale, i ? 1 / 60 : 0, -1);
    x.web_still(); x.web_cursor(); x.web_dark(); x.web_wanted(); x.web_file_name(); x.web_file_bytes(); x.web_file_size();
    if (x.web_wish()) x.web_grant(-1, 0);
  }
};
const hand = x => {
  const scene = named(x, 'stack of boxes');
  frames(x, 30);
  const at = described(x).match(/^body 6 x \S+ y \S+ pixel (\S+) (\S+)$/m).slice(1).map(Number);
  for (const button of [1, 4, 2]) {
    x.web_mouse(...at); frames(x, 2); x.web_button(button, 1);
    for (let i = 0; i < 20; i++) { x.web_mouse(at[0] + 5 * i, at[1] - 3 * i); frames(x, 2); }
    described(x); x.web_button(button, 0); frames(x, 20);
  }
  for (const notch of [1, -1]) { x.web_wheel(notch); frames(x, 2); }
  for (const key of 'por') { x.web_key(key.charCodeAt(0)); frames(x, 2); }
  described(x);
};
const fingers = x => {
  const scene = named(x, 'stack of boxes');
  x.web_looks(1, 0);
  frames(x, 30, 780, 1500, 2);
  const at = described(x).match(/^body 6 x \S+ y \S+ pixel (\S+) (\S+)$/m).slice(1).map(Number);
  for (const from of [at, [100, 900]]) {
    x.web_mouse(...from); x.web_button(1, 1); frames(x, 2, 780, 1500, 2);
    for (let i = 0; i < 9; i++) { x.web_mouse(from[0] + 9 * i, from[1] - 3 * i); frames(x, 2, 780, 1500, 2); }
    x.web_button(1, 0); frames(x, 3, 780, 1500, 2);
    x.web_pan(9, 4); x.web_wheel(0.3); frames(x, 2, 780, 1500, 2);
  }
  x.web_looks(1, 1); frames(x, 3, 700, 400, 2); x.web_letters();
};
// each: a name, and what is done to a fresh instance's exports
export const visits = () => [
  ['the testbed', x => { x.web_bring(); frames(x, 150); described(x); }],       // after that a body is fast enough for impacts: the second part
  ['a phone, by night', x => { frames(x, 30, 840, 1600, 2); x.web_key(100); frames(x, 30, 840, 1600, 2); described(x); }],
  ['a hand', hand],
  ['fingers', fingers],
  ...shown().filter(scene => !late.includes(scene)).map(scene => [scene, x => { named(x, scene); frames(x, 300, 640, 400); described(x); }])];
