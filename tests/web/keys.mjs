// keys.mjs: the testbed's page without a mouse and without eyes: Tab leaves the canvas, every widget has a name and can be pressed, motion waits.
//   node tests/web/keys.mjs build/book/html          needs playwright-core (tests/web/run.sh brings it)
import { join } from 'node:path';
import { browser, check, end, html } from './browser.mjs';
const open = async (motion) => {
  const context = await browser.newContext({ viewport: { width: 1100, height: 720 }, reducedMotion: motion }), page = await context.newPage();
  page.on('pageerror', e => check(false, e.message));
  await page.goto('file://' + join(html, 'testbed.html#stack of boxes'));
  await page.waitForFunction(() => { const c = document.getElementById('testbed'); return c.game && /^widget /m.test(c.game.describe()); }, null, { timeout: 20000 });
  await page.waitForSelector('[role=toolbar] button', { state: 'attached', timeout: 20000 });
  await page.waitForTimeout(300);      // the first frames settle where the list stands
  page.tell = label => page.evaluate(label => (document.getElementById('testbed').game.describe().match(new RegExp(`^${label} (.*)$`, 'm')) || ['', ''])[1], label);
  return page;
};
const page = await open('no-preference'), focused = () => page.evaluate(() => document.activeElement.id || document.activeElement.textContent.trim() || document.activeElement.tagName);
check(await focused() === 'testbed', `the canvas has the keys at first, and not ${await focused()}`);
const list = await page.tell('list');
await page.keyboard.press('Shift+Tab');
check(await focused() === 'Gallery', `Shift-Tab goes back to the page's bar, and not to ${await focused()}`);
await page.keyboard.press('Tab');
check(await focused() === 'testbed', `Tab comes back to the canvas, and not to ${await focused()}`);
await page.keyboard.press('Tab');
check(await focused() !== 'testbed', 'Tab does not leave the canvas');
check(await page.tell('list') === list, 'Tab hides the list');
await page.locator('#testbed').focus();
await page.keyboard.press('\\');
await page.waitForTimeout(300);
check(await page.tell('list') !== list, 'the key \\ does not hide the list');
await page.keyboard.press('\\');
await page.waitForTimeout(1500);
const names = await page.locator('[role=toolbar] button').allTextContents();
const widgets = await page.evaluate(() => new Set([...document.getElementById('testbed').game.describe().matchAll(/^widget (.*) pixel/mg)].map(m => m[1])).size);
check(names.length === widgets && widgets > 40 && names.every(n => n.trim()), `${widgets} widgets, ${names.length} names`);
await page.getByRole('button', { name: 'Pause', exact: true }).evaluate(b => b.click());
await page.waitForTimeout(1500);
check(await page.tell('paused') === '1', 'the button Pause, pressed by its name, does nothing');
check((await page.getByRole('status').textContent()).includes('paused'), `the line that is read out says: ${await page.getByRole('status').textContent()}`);
// what happens is told soon, not in the next second, and the line is empty when it is put there, or it would not be read out
for (const [key, want] of [['p', 'running'], ['p', 'paused']]) {
  await page.locator('#testbed').focus();
  await page.waitForTimeout(300);
  await page.keyboard.press(key);
  await page.waitForFunction(want => document.querySelector('[role=status]').textContent.includes(want), want, { timeout: 400, polling: 20 })
    .then(() => check(true), () => check(false, `the line that is read out does not say ${want} within 0.4 s`));
}
check(await page.getByRole('status').getAttribute('aria-live') === 'polite', 'the line is not live');
// a wide window that becomes narrow closes what lies over the scene, and has it again when it is wide
await page.locator('#testbed').focus();
await page.keyboard.press('s');
const stands = async (width, list, panel) => {
  await page.setViewportSize({ width, height: 720 });
  await page.waitForTimeout(400);
  check(await page.tell('list') === list && await page.tell('panel') === panel, `${width} px: list ${await page.tell('list')}, panel ${await page.tell('panel')}`);
};
await stands(1100, '1', '1');
await stands(420, '0', '0');
await stands(1100, '1', '1');
await stands(400, '0', '0');
await page.evaluate(() => document.getElementById('testbed').game.key(92));
await page.waitForTimeout(300);
check(await page.tell('list') === '1', 'the list does not open in a narrow window');
await page.getByRole('button', { name: 'pyramid', exact: true }).evaluate(b => b.click());
await page.waitForTimeout(300);
check(await page.tell('list') === '0' && await page.tell('scene') === 'pyramid', 'the drawer stays after a choice');
// and so after a visit with a wide window, whose list was kept
await page.setViewportSize({ width: 1100, height: 720 });
await page.waitForTimeout(600);
await page.setViewportSize({ width: 400, height: 720 });
await page.reload();
await page.waitForFunction(() => { const c = document.getElementById('testbed'); return c.game && /^steps [1-9]\d/m.test(c.game.describe()); }, null, { timeout: 20000 });
check(await page.tell('list') === '0', 'a narrow window opens with the list over the scene, as a wide one had it');
const calm = await open('reduce');
check(await calm.tell('paused') === '1', 'with reduced motion it runs from the start');
check(+await calm.tell('steps') < 3, `with reduced motion it has made ${await calm.tell('steps')} steps`);
await end();
