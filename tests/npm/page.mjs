// The demo in Chromium, from file://: it runs, a body follows the mouse, and the scene has the hash of C.   node page.mjs DIRECTORY HASH
import { createRequire } from 'node:module';
import { play } from './scene.mjs';
const { chromium } = createRequire(new URL('../../build/node/', import.meta.url))('playwright-core');
const [dir, hash] = process.argv.slice(2);
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM || '/usr/bin/chromium', args: ['--no-sandbox'] });
const page = await browser.newPage({ viewport: { width: 780, height: 480 } }), told = [];
page.on('pageerror', e => told.push(e.message));
page.on('console', m => told.push(m.text()));
await page.goto(`file://${dir}/demo.html`);
await page.waitForFunction(() => +document.title.split(' ')[1] > 100, null, { timeout: 30000 });
const got = await page.evaluate(`(${play})(Weft).hash.toString()`);
const blank = await page.evaluate(() => { const c = document.querySelector('canvas'); return c.toDataURL() === Object.assign(document.createElement('canvas'), { width: c.width, height: c.height }).toDataURL(); });
await browser.close();
if (got !== hash || blank || told.length) { console.log(`page: hash ${got}, in C ${hash}; ${blank ? 'nothing is drawn; ' : ''}${told.join('; ')}`); process.exit(1); }
console.log('npm: the demo runs from file:// in Chromium, and the hash is that of C');
