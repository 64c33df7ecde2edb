// newcomer.mjs: somebody who has never seen the book opens it, finds the testbed, chooses a scene, changes the solver and sees the
// difference: in less than a minute, at a human's pace (a pause before each action, a mouse that travels, keys one by one).
//   node tests/web/newcomer.mjs build/book/html
import { join } from 'node:path';
import { browser, check, end, html } from './browser.mjs';
const page = await (await browser.newContext({ viewport: { width: 1280, height: 800 } })).newPage();
let actions = 0;
page.on('console', m => check(m.type() !== 'error', 'the console says: ' + m.text()));
page.on('pageerror', e => check(false, e.message));
const think = ms => { actions++; return page.waitForTimeout(ms); };      // reads, decides
const begin = Date.now();
await page.goto('file://' + join(html, 'index.html'));
await think(3000);
await page.getByRole('link', { name: /testbed/i }).first().click();
const canvas = page.locator('#testbed');
await page.waitForFunction(() => { const c = document.getElementById('testbed'); return c && c.game && /^steps [1-9]/m.test(c.game.describe()); }, { timeout: 20000 });
const loaded = (Date.now() - begin) / 1000;
const said = () => canvas.evaluate(c => c.game.describe());
const area = await canvas.boundingBox(), ratio = await canvas.evaluate(c => c.width / c.getBoundingClientRect().width);
const click = async name => {                                   // sees the words, moves there, clicks
  await think(1000);
  const at = [...(await said()).matchAll(new RegExp('^widget ' + name.replace(/[()|\\/]/g, '\\$&') + ' pixel (\\S+) (\\S+)$', 'mg'))].pop();
  if (!at) { check(false, 'there is nothing called ' + name); return; }
  await page.mouse.move(area.x + at[1] / ratio, area.y + at[2] / ratio, { steps: 25 });
  await page.waitForTimeout(250);
  await page.mouse.down();
  await page.waitForTimeout(90);
  await page.mouse.up();
  await page.waitForTimeout(150);
};
const heights = async () => [...(await said()).matchAll(/^body \d+ x \S+ y (\S+)/mg)].map(m => +m[1]);
await click('find');
for (const k of 'tower') { await page.keyboard.press(k); await page.waitForTimeout(180); }
await page.keyboard.press('Enter');
await think(2500);
check(/^scene tower/m.test(await said()), 'the scene that was typed is not shown');
const stands = Math.max(...await heights());
const panel = () => said().then(s => /^panel 1$/m.test(s));
if (!await panel()) await click('Settings');
await click('solver');
await click('impulse');
await click('Reset');
await think(4000);
const falls = Math.max(...await heights());
check(falls < stands - 1, `no difference is seen: the top of the tower is at ${falls} m, and was at ${stands} m`);
const seconds = (Date.now() - begin) / 1000;
check(seconds < 60, `it took ${seconds.toFixed(0)} s, and a minute was promised`);
await end(`${seconds.toFixed(0)} s from the first page to the fallen tower (testbed open after ${loaded.toFixed(1)} s), ${actions} decisions, `);
