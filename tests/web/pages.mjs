// pages.mjs: the book's live pages in a real browser, opened from the disk, used as a reader would.
//   node tests/web/pages.mjs build/book/html [PAGE ...]      needs playwright-core and axe-core (tests/web/run.sh brings them)
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { browser, check, end, fail, html, require } from './browser.mjs';
const axe = readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');
const only = process.argv.slice(3), url = page => 'file://' + join(html, page);
let figures = 0, scenes = 0;

const open = async (context, file) => {
  const page = await context.newPage(), name = file;
  page.on('console', m => { if (m.type() === 'error') fail(`${name}: the console says: ${m.text()}`); });
  page.on('pageerror', e => fail(`${name}: ${e.message}`));
  page.on('request', r => { if (!r.url().startsWith('file:') && !r.url().startsWith('data:')) fail(`${name}: it asks the network for ${r.url()}`); });
  await page.goto(url(file));
  return page;
};
const ink = figure => figure.locator('svg > g').first().evaluate(g => g.innerHTML);

const tryFigure = async (page, figure, name, where, frozen) => {
  await figure.scrollIntoViewIfNeeded();
  try { await page.waitForFunction(f => f.classList.contains('live') || f.dataset.liveError, await figure.elementHandle(), { timeout: 15000 }); }
  catch { return fail(`${where}: figure ${name} does not come alive`); }
  figures++;
  const home = await ink(figure);
  check(Math.abs(await figure.locator('svg > g').first().evaluate(g => g.querySelectorAll('*').length) - frozen) <= 1,
    `${where}: figure ${name} draws other things than the frozen one`);
  const grips = figure.locator('.grip'), count = await grips.count();
  for (let i = 0; i < count; i++) {
    const grip = grips.nth(i);
    await grip.scrollIntoViewIfNeeded();
    const b = await grip.boundingBox(), pic = await figure.locator('svg').first().boundingBox();
    const x = b.x + b.width / 2, y = b.y + b.height / 2;
    check(x - 7 >= pic.x && y - 7 >= pic.y && x + 7 <= pic.x + pic.width && y + 7 <= pic.y + pic.height, `${where}: handle ${i + 1} of ${name} stands in the figure's border`);
    const dx = x - pic.x > pic.width / 2 ? -100 : 100, dy = y - pic.y > pic.height / 2 ? -34 : 34;
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + dx, y + dy, { steps: 3 });
    await page.mouse.up();
    check(await ink(figure) !== home, `${where}: dragging handle ${i + 1} of ${name} changes nothing`);
    await figure.getByRole('button', { name: 'Reset' }).click();
    check(await ink(figure) === home, `${where}: ${name} is not as it was after Reset`);
  }
  if (count) {
    await grips.first().focus();
    for (let i = 0; i < 3; i++) await page.keyboard.press('Shift+ArrowLeft');
    for (let i = 0; i < 2; i++) await page.keyboard.press('Shift+ArrowUp');
    check(await ink(figure) !== home, `${where}: the arrow keys change nothing in ${name}`);
    await figure.getByRole('button', { name: 'Reset' }).click();
  }
  const named = await figure.locator('.live-bar button').evaluateAll(all => all.filter(b => b.hasAttribute('aria-label') && !b.getAttribute('aria-label').includes(b.textContent)).length);
  check(!named, `${where}: ${name} has buttons that are called by other words than those on them`);
  if (await figure.getAttribute('data-moves')) {
    await figure.getByRole('button', { name: 'Play' }).click();
    await page.waitForTimeout(400);
    check(await ink(figure) !== home, `${where}: time runs, and ${name} does not move`);
    await figure.getByRole('button', { name: /^Pause/ }).click();
  }
  const code = await figure.getAttribute('data-code');
  check(code && await page.evaluate(c => !c.startsWith('#') || !!document.getElementById(c.slice(1)), code), `${where}: ${name} has no link to its code`);
};

const steps = figure => figure.locator('canvas').evaluate(c => Number(c.game.describe().match(/^steps (\d+)$/m)[1]));
const tryScene = async (page, figure, name, where) => {
  await figure.scrollIntoViewIfNeeded();
  await figure.getByRole('button', { name: 'Run it' }).click();
  const canvas = figure.locator('canvas');
  try { await canvas.waitFor({ timeout: 15000 }); await page.waitForFunction(c => c.game && /^steps [1-9]/m.test(c.game.describe()), await canvas.elementHandle(), { timeout: 15000 }); }
  catch { return fail(`${where}: the simulation ${name} does not run`); }
  scenes++;
  check(await canvas.evaluate((c, n) => c.game.describe().startsWith('scene ' + n + '\n'), name), `${where}: another scene than ${name} runs`);
  const b = await canvas.boundingBox(), shot = async () => (await canvas.screenshot()).toString('base64');
  const before = await shot();
  await page.waitForTimeout(150);
  await page.mouse.move(b.x + b.width / 2, b.y + b.height / 2);
  await page.mouse.down({ button: 'right' });
  await page.mouse.move(b.x + b.width / 2 + 60, b.y + b.height / 2 + 20, { steps: 3 });
  await page.mouse.up({ button: 'right' });
  await page.waitForTimeout(100);
  check(await shot() !== before, `${where}: the simulation ${name} shows the same picture, running and dragged`);
  await page.evaluate(() => scrollTo(0, document.body.scrollHeight * (scrollY < document.body.scrollHeight / 2 ? 1 : 0)));
  await page.waitForTimeout(250);
  const away = await steps(figure);
  await page.waitForTimeout(300);
  check(await steps(figure) === away, `${where}: ${name} goes on when it is out of view`);
};

// Pages with something alive. In a check every fifth of them; ALL_PAGES=1: all, some three minutes.
const alive = readdirSync(html).filter(f => f.endsWith('.html') && /data-(live|scene)=/.test(readFileSync(join(html, f), 'utf8')));
const slides = /^slides-\d+\.html$/, book = alive.filter(f => !slides.test(f));
const pages = [...book.filter((f, i) => process.env.ALL_PAGES || i % 5 === 0), 'slides-7.html'];
if (only.length) pages.splice(0, pages.length, ...alive.filter(f => only.includes(f)));
const desk = await browser.newContext({ viewport: { width: 1100, height: 900 }, reducedMotion: 'no-preference' });
const plain = await browser.newContext({ javaScriptEnabled: false });      // here no figure comes alive: what each draws when it is frozen
for (const file of pages) {
  const quiet = await plain.newPage();
  await quiet.goto(url(file));
  const frozen = await quiet.locator('figure[data-live]').evaluateAll(all => all.map(f => f.querySelectorAll('.pic svg *:not(g)').length));
  await quiet.close();
  const page = await open(desk, file);
  const list = page.locator('figure[data-live]'), sims = page.locator('figure[data-scene]');
  for (let i = 0; i < await list.count(); i++) await tryFigure(page, list.nth(i), await list.nth(i).getAttribute('data-live'), file, frozen[i]);
  for (let i = 0; i < await sims.count(); i++) await tryScene(page, sims.nth(i), await sims.nth(i).getAttribute('data-scene'), file);
  check(await page.evaluate(() => [...document.querySelectorAll('math')].slice(0, 20).every(m => m.getBoundingClientRect().width > 0)), `${file}: formulas are not shown`);
  await page.close();
}

// the whole testbed: a key pauses it, a mouse moves a body, another size is another picture
const bed = await open(desk, 'testbed.html#stack of boxes');
const canvas = bed.locator('#testbed'), said = () => canvas.evaluate(c => c.game.describe());
await bed.waitForFunction(() => { const c = document.getElementById('testbed'); return c.game && /^steps [1-9]\d/m.test(c.game.describe()); }, { timeout: 20000 });
check((await said()).startsWith('scene stack of boxes'), 'testbed.html: the scene named in the address is not shown');
const pixel = (await said()).match(/^body 6 x (\S+) y (\S+) pixel (\S+) (\S+)$/m), area = await canvas.boundingBox();
if (check(pixel, 'testbed.html: the sixth body is not in view')) {
  await bed.mouse.move(area.x + +pixel[3], area.y + +pixel[4]);
  await bed.mouse.down();
  await bed.mouse.move(area.x + +pixel[3] + 120, area.y + +pixel[4] - 60, { steps: 10 });
  await bed.waitForTimeout(600);
  const moved = (await said()).match(/^body 6 x (\S+) y (\S+)/m);
  check(Math.abs(moved[1] - pixel[1]) > 0.5, `testbed.html: the body at x ${pixel[1]} m was pulled and is at ${moved[1]} m`);
  await bed.mouse.up();
}
await bed.keyboard.press('p');
await bed.waitForTimeout(200);
check(/^paused 1$/m.test(await said()), 'testbed.html: P does not pause');
await bed.setViewportSize({ width: 700, height: 500 });
await bed.waitForTimeout(300);
check(await canvas.evaluate(c => c.width === Math.round(c.getBoundingClientRect().width * devicePixelRatio)), 'testbed.html: the picture does not follow the window');
await bed.close();

// a finger
const phone = await browser.newContext({ viewport: { width: 420, height: 800 }, hasTouch: true, isMobile: true, deviceScaleFactor: 2 });
const touch = await open(phone, 'narrow-phase.html');
const fig = touch.locator('figure[data-live="narrow-shadows"]');
await fig.scrollIntoViewIfNeeded();
await touch.waitForSelector('figure[data-live="narrow-shadows"].live');
const was = await ink(fig), at = await fig.locator('.grip').first().boundingBox();
const cdp = await phone.newCDPSession(touch), p = [at.x + at.width / 2, at.y + at.height / 2];
await cdp.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: [{ x: p[0], y: p[1] }] });
for (let i = 1; i < 5; i++) await cdp.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: [{ x: p[0] - 10 * i, y: p[1] + 8 * i }] });
await cdp.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: [] });
check(await ink(fig) !== was, 'narrow-phase.html: a finger cannot drag a handle');
await touch.close();

// a finger in the testbed: it pulls a body; two of them zoom
const bed2 = await open(phone, 'testbed.html#stack of boxes');
const small = bed2.locator('#testbed'), tell = () => small.evaluate(c => c.game.describe());
await bed2.waitForFunction(() => { const c = document.getElementById('testbed'); return c.game && /^steps [1-9]\d/m.test(c.game.describe()); }, { timeout: 20000 });
const box = await small.boundingBox(), scale = await small.evaluate(c => c.width / c.getBoundingClientRect().width);
const top = (await tell()).match(/^body 6 x (\S+) y (\S+) pixel (\S+) (\S+)$/m);
if (check(top, 'testbed.html on a phone: the sixth body is not in view')) {
  const finger = await phone.newCDPSession(bed2), send = (type, touchPoints) => finger.send('Input.dispatchTouchEvent', { type, touchPoints });
  const x = box.x + top[3] / scale, y = box.y + top[4] / scale;
  await send('touchStart', [{ x, y }]);
  for (let i = 1; i < 9; i++) { await send('touchMove', [{ x: x + 9 * i, y: y - 4 * i }]); await bed2.waitForTimeout(40); }
  await bed2.waitForTimeout(400);
  const now = (await tell()).match(/^body 6 x (\S+) y (\S+)/m);
  check(Math.abs(now[1] - top[1]) > 0.3, `testbed.html on a phone: a finger pulled the body at x ${top[1]} m, and it is at ${now[1]} m`);
  await send('touchEnd', []);
  const view = async () => +(await tell()).match(/^view \S+ \S+ (\S+)$/m)[1], far = await view();
  await send('touchStart', [{ x: 150, y: 400, id: 0 }, { x: 250, y: 400, id: 1 }]);
  for (let i = 1; i < 9; i++) { await send('touchMove', [{ x: 150 - 10 * i, y: 400, id: 0 }, { x: 250 + 10 * i, y: 400, id: 1 }]); await bed2.waitForTimeout(40); }
  await send('touchEnd', []);
  check(await view() < far, 'testbed.html on a phone: two fingers do not zoom');
}
await bed2.close();

// without JavaScript the frozen figures are there
const still = await plain.newPage();
await still.goto(url('narrow-phase.html'));
check(await still.locator('figure[data-live] svg').count() > 3, 'narrow-phase.html: without JavaScript there is no figure');

// slides: what is on one fits on it, no formula is cut off, and a figure has room; in print each is a page
for (const file of readdirSync(html).filter(f => slides.test(f) && (!only.length || only.includes(f)))) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 720 } }), page = await open(context, file);
  await page.evaluate(() => document.fonts.ready);
  await page.waitForTimeout(300);
  const found = await page.locator('.slide').evaluateAll(all => all.map((s, i) => [
    s.scrollHeight > s.clientHeight + 1 && 'is too full',
    [...s.querySelectorAll('.pic')].some(p => p.clientHeight < 200) && 'has no room for its figure',
    [...s.querySelectorAll('.eqm')].some(e => e.scrollWidth > e.clientWidth + 1) && 'cuts off a formula',
  ].filter(Boolean).map(t => `slide ${i + 1} ${t}`)).flat());
  check(!found.length, `${file}: ${found.join('; ')}`);
  const printed = (await page.pdf({ preferCSSPageSize: true })).toString('latin1').match(/\/Type \/Page\b/g).length, count = await page.locator('.slide').count();
  check(printed === count, `${file}: ${count} slides are ${printed} pages in print`);
  await page.keyboard.press('PageDown');
  check(await page.evaluate(() => Math.round(scrollY / innerHeight)) === 1, `${file}: a key does not turn the slide`);
  await context.close();
}

// accessibility, by axe
for (const file of ['index.html', 'narrow-phase.html', 'testbed.html', 'gallery.html'].filter(f => !only.length || only.includes(f))) {
  const page = await open(desk, file);
  await page.evaluate(axe);
  const found = await page.evaluate(() => axe.run(document, { runOnly: ['wcag2a', 'wcag2aa'], preload: false }));
  for (const v of found.violations) fail(`${file}: ${v.id} (${v.impact}): ${v.help}, ${v.nodes.length} times, first: ${v.nodes[0].html.slice(0, 140)}`);
  check(true);
  await page.close();
}
check(only.length || figures > 5, `only ${figures} figures were tried on ${pages.length} pages: is the list of pages right?`);
await end(`${figures} figures and ${scenes} simulations came alive; `);
