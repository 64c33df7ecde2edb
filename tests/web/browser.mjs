// browser.mjs: the Chromium in which the pages are tested, and how a test counts. Needs playwright-core (tests/web/run.sh brings it); the
// first argument of every such test is the directory of the pages.
import { createRequire } from 'node:module';
import { basename, join, resolve } from 'node:path';
export const require = createRequire(join(process.cwd(), 'build/node/'));
export const html = resolve(process.argv[2]);
const args = '--no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking --disable-component-update --disable-sync'.split(' ');
export const browser = await require('playwright-core').chromium.launch({ executablePath: process.env.CHROMIUM || '/usr/bin/chromium', args });
const name = basename(process.argv[1], '.mjs');
let failed = 0, checks = 0;
export const check = (truth, text) => { checks++; if (!truth) { failed++; console.log(`${name}: ${text}`); } return truth; };
export const fail = text => check(false, text);
export const end = async (seen = '') => { await browser.close(); console.log(`${name}: ${seen}${checks} checks, ${failed} failed`); process.exit(failed ? 1 : 0); };
