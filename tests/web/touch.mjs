// touch.mjs: the book's pages under real fingers (touch events of Chromium), on a telephone upright and lying, by day and by night.
//   node tests/web/touch.mjs build/book/html          needs playwright-core (tests/web/run.sh brings it)
import { join } from 'node:path';
import { browser, check, end, html } from './browser.mjs';
const near = (a, b, most, text) => check(Math.abs(a - b) <= most, `${text}: ${a}, and not ${b}`);

for (const [name, width, height, colorScheme] of [['upright by day', 390, 844, 'light'], ['lying by night', 844, 390, 'dark']]) {
  const phone = await browser.newContext({ viewport: { width, height }, deviceScaleFactor: 3, isMobile: true, hasTouch: true, colorScheme });
  const open = async file => {
    const page = await phone.newPage();
    page.on('console', m => { if (m.type() === 'error') check(false, `${file} ${name}: the console says: ${m.text()}`); });
    page.on('pageerror', e => check(false, `${file} ${name}: ${e.message}`));
    await page.goto('file://' + join(html, file));
    const wire = await phone.newCDPSession(page);
    const send = async (type, ...points) => { await wire.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([x, y], id) => ({ x, y, id })) }); await page.waitForTimeout(40); };
    // fingers go from their places to others, in eight moves
    page.stroke = async (from, to) => {
      await send('touchStart', ...from);
      for (let i = 1; i <= 8; i++) await send('touchMove', ...from.map(([x, y], k) => [x + (to[k][0] - x) * i / 8, y + (to[k][1] - y) * i / 8]));
      await send('touchEnd');
      await page.waitForTimeout(150);
    };
    page.tap1 = async (x, y) => { await send('touchStart', [x, y]); await send('touchEnd'); await page.waitForTimeout(250); };
    return page;
  };

  // -- a figure's ring is as wide as a finger, is dragged, and the page stays where it is
  const chapter = await open('narrow-phase.html');
  const figure = chapter.locator('figure[data-live]').first();
  await figure.scrollIntoViewIfNeeded();
  await chapter.waitForSelector('figure[data-live].live');
  const grip = figure.locator('.grip').first();
  await grip.evaluate(g => g.scrollIntoView({ block: 'center' }));
  const box = await grip.boundingBox(), at = async () => (await grip.getAttribute('aria-valuetext')).split(', ').map(Number), scrolled = () => chapter.evaluate(() => scrollY);
  check(box.width >= 44 && box.height >= 44, `a ring ${name}: ${box.width.toFixed(0)} x ${box.height.toFixed(0)} px, a finger needs 44`);
  const was = await at(), place = await scrolled(), x = box.x + box.width / 2, y = box.y + box.height / 2;
  const wide = await figure.locator('svg').evaluate(s => s.getBoundingClientRect().width);
  await chapter.stroke([[x + 12, y + 12]], [[x + 12 + 0.1 * wide, y + 12 - 0.1 * wide]]);          // from beside the ring: its room is the finger's, too
  const now = await at();
  check(now[0] > was[0] && now[1] > was[1], `a ring ${name}: dragged by a finger from ${was} it is at ${now}`);
  near(await scrolled(), place, 0, `a ring ${name}: the page moved under the finger`);
  await chapter.close();

  // -- a simulation in a chapter has no bars of its own on a narrow page, and a finger drags in it
  const small = await open('platform.html');
  const play = small.locator('figure[data-scene]').first();
  await play.scrollIntoViewIfNeeded();
  await small.waitForSelector('figure[data-scene].live');
  await play.getByRole('button', { name: 'Run it' }).tap();
  const field = play.locator('canvas');
  await field.waitFor();
  await small.waitForFunction(c => c.game && /^steps [1-9]/m.test(c.game.describe()), await field.elementHandle(), { timeout: 20000 });
  const narrow = (await field.boundingBox()).width < 560, widgets = (await field.evaluate(c => c.game.describe())).match(/^widget /mg);
  check(narrow ? !widgets : widgets, `a simulation ${name}: ${widgets ? widgets.length : 'no'} widgets in ${narrow ? 'a narrow' : 'a wide'} canvas`);
  // one finger on empty ground scrolls the page and leaves the view; on a body it pulls that; two fingers pan, and Reset brings the view back
  await small.evaluate(() => { document.querySelector('figure canvas').scrollIntoView({ block: 'center', behavior: 'instant' }); });
  await small.waitForTimeout(300);
  const f = await field.boundingBox(), kf = await field.evaluate(c => c.width / c.getBoundingClientRect().width), view = async () => (await field.evaluate(c => c.game.describe())).match(/^view (.*)$/m)[1];
  const home = await view(), top = await small.evaluate(() => scrollY), ground = [f.x + 20, f.y + f.height * 0.3];
  await small.stroke([ground], [[ground[0], ground[1] - 80]]);
  check(await small.evaluate(() => scrollY) > top + 20, `a simulation ${name}: one finger on empty ground does not scroll the page`);
  check(await view() === home, `a simulation ${name}: one finger on empty ground moves the view from ${home} to ${await view()}`);
  await small.evaluate(y => scrollTo({ top: y, behavior: 'instant' }), top);
  await small.waitForTimeout(200);
  await small.stroke([ground, [ground[0] + 60, ground[1]]], [[ground[0] + 90, ground[1] + 40], [ground[0] + 150, ground[1] + 40]]);
  check(await view() !== home && await small.evaluate(() => scrollY) === top, `a simulation ${name}: two fingers leave the view, or scroll the page`);
  const button = n => play.getByRole('button', { name: n });
  check(await button(/^Pause: .*runs/).count() === 1 && await button(/^Reset/).count() === 1, `a simulation ${name}: its buttons' names lack the words that are seen`);
  await button(/^Reset/).tap();
  await small.waitForTimeout(300);
  check(await view() === home, `a simulation ${name}: after Reset the view is ${await view()}, and not ${home}`);
  const pulled = async () => { const m = (await field.evaluate(c => c.game.describe())).match(/^body 6 .*pixel (\S+) (\S+)$/m); const c = await field.boundingBox(); return [c.x + m[1] / kf, c.y + m[2] / kf]; };
  await field.evaluate(c => c.scrollIntoView({ block: 'center', behavior: 'instant' }));
  await small.waitForTimeout(200);
  const body = await pulled(), stands = await small.evaluate(() => scrollY);
  await small.stroke([body], [[body[0] + 20, body[1] - 60]]);
  near(await small.evaluate(() => scrollY), stands, 0, `a simulation ${name}: a finger on a body scrolls the page`);
  check(!/\bP\b|keys/.test(await field.getAttribute('aria-label')), `a simulation ${name}: its name speaks of keys: ${await field.getAttribute('aria-label')}`);
  await small.close();

  // -- the testbed
  const bed = await open('testbed.html#stack of boxes');
  const canvas = bed.locator('#testbed');
  const tell = () => canvas.evaluate(c => c.game.describe()), fact = async (label, n = 0) => +(await tell()).match(new RegExp(`^${label} (.*)$`, 'm'))[1].split(' ')[n];
  await bed.waitForFunction(() => { const c = document.getElementById('testbed'); return c.game && /^steps [1-9]\d/m.test(c.game.describe()); }, null, { timeout: 20000 });
  const b = await canvas.boundingBox(), k = await canvas.evaluate(c => c.width / c.getBoundingClientRect().width);
  const spot = async label => { const m = (await tell()).match(new RegExp(`^${label} .*pixel (\\S+) (\\S+)$`, 'm')); return m ? [b.x + m[1] / k, b.y + m[2] / k] : null; };
  const tap = async label => { if (!await spot(`widget ${label}`) && await spot('widget More')) await tap('More'); const p = await spot(`widget ${label}`); if (check(p, `${name}: there is no ${label}`)) await bed.tap1(...p); };
  await tap('Pause');
  near(await fact('paused'), 1, 0, `${name}: a tap on Pause`);
  await bed.waitForTimeout(400);
  const frames = () => canvas.evaluate(c => c.game.frames()), drawn = await frames();
  await bed.waitForTimeout(700);
  near(await frames(), drawn, 0, `${name}: frames that were drawn of a picture that stays`);
  const centre = [b.x + b.width / 2, b.y + b.height * 0.55], free = [b.x + b.width * 0.2, centre[1]];
  let from = await spot('body 6');
  await bed.stroke([free], [[free[0] + 40, free[1] + 24]]);
  let to = await spot('body 6');
  near(to[0] - from[0], 40, 1.5, `${name}: one finger on empty ground moves the view sideways`);
  near(to[1] - from[1], 24, 1.5, `${name}: and down`);
  from = to;
  const far = await fact('view', 2);
  await bed.stroke([[centre[0] - 40, centre[1]], [centre[0] + 40, centre[1]]], [[centre[0] - 80, centre[1] + 20], [centre[0] + 80, centre[1] + 20]]);
  near(far / await fact('view', 2), 2, 0.06, `${name}: two fingers that part to twice their distance show things twice as large`);
  await bed.stroke([[centre[0] - 80, centre[1]], [centre[0] + 80, centre[1]]], [[centre[0] - 40, centre[1]], [centre[0] + 40, centre[1]]]);
  near(far / await fact('view', 2), 1, 0.04, `${name}: and back`);
  from = await spot('body 6');
  await bed.stroke([[centre[0] - 40, centre[1]], [centre[0] + 40, centre[1]]], [[centre[0] - 10, centre[1] + 16], [centre[0] + 70, centre[1] + 16]]);
  to = await spot('body 6');
  near(to[0] - from[0], 30, 2, `${name}: two fingers that go together move the view sideways`);
  near(to[1] - from[1], 16, 2, `${name}: and down`);
  await tap('Home');
  await tap('Play');
  from = await spot('body 6');
  const x6 = await fact('body 6', 1);
  await bed.stroke([from], [[from[0] + 60, from[1] - 10]]);
  check(await fact('body 6', 1) > x6 + 0.3, `${name}: a finger pulled the sixth body from ${x6} m, and it is at ${await fact('body 6', 1)} m`);
  // a touch pad pinches by wheels with Ctrl: thirty small ones are one large one, and a plain notch is 1.15
  const mid = [b.x + b.width / 2, b.y + b.height * 0.5], spin = (deltaY, ctrlKey) => canvas.evaluate((c, [x, y, deltaY, ctrlKey]) =>
    c.dispatchEvent(new WheelEvent('wheel', { deltaY, ctrlKey, clientX: x, clientY: y, bubbles: true, cancelable: true })), [...mid, deltaY, ctrlKey]);
  const high = await fact('view', 2);
  for (let i = 0; i < 30; i++) await spin(-100 * Math.LN2 / 30, true);
  await bed.waitForTimeout(200);
  near(high / await fact('view', 2), 2, 0.02, `${name}: a pinch of a touch pad to twice the distance`);
  await spin(100 * Math.log(2) / Math.log(1.15), false);
  await bed.waitForTimeout(200);
  near(high / await fact('view', 2), 1, 0.01, `${name}: five notches of a wheel back`);
  // the list of scenes is a drawer; its field raises a keyboard, whose letters find a scene
  near(await fact('list'), 0, 0, `${name}: the list is open at first`);
  await tap('List');
  near(await fact('list'), 1, 0, `${name}: a tap on List`);
  await tap('find');
  check(await bed.evaluate(() => document.activeElement.className) === 'letters', `${name}: a tap on the field raises no keyboard`);
  await bed.keyboard.insertText('pyr');
  await bed.waitForTimeout(200);
  await tap('pyramid');
  check((await tell()).startsWith('scene pyramid\n'), `${name}: the letters found ${(await tell()).split('\n')[0]}`);
  near(await fact('list'), 0, 0, `${name}: the list after a choice`);
  check(await bed.evaluate(() => document.activeElement.id) === 'testbed', `${name}: the keyboard stays`);
  // a number is typed, too
  await tap('Settings');
  await tap('gravity.y');
  if (check(await bed.evaluate(() => document.activeElement.className) === 'letters', `${name}: a tap on a number raises no keyboard`)) {
    check(await bed.evaluate(() => document.activeElement.getAttribute('aria-label') + ', ' + document.activeElement.inputMode) === 'gravity y, decimal', `${name}: the field for a number calls itself ${await bed.evaluate(() => document.activeElement.outerHTML)}`);
    await bed.keyboard.insertText('-3');
    await bed.keyboard.press('Enter');
    await bed.waitForTimeout(300);
    await bed.evaluate(() => document.getElementById('testbed').game.more());
    check(/gravity\.y=-3(&|$)/.test(await canvas.evaluate(c => c.game.say('web_link'))), `${name}: -3 was typed for gravity: ${await canvas.evaluate(c => c.game.say('web_link'))}`);
  }
  await tap('Settings');
  // Dark and Light are the page's, too
  const theme = () => bed.evaluate(() => document.documentElement.dataset.theme), day = await theme();
  await tap(day === 'dark' ? 'Light' : 'Dark');
  await bed.waitForTimeout(200);
  check(await theme() !== day && await fact('dark') === (day === 'dark' ? 0 : 1), `${name}: the picture is ${await fact('dark') ? 'dark' : 'light'} and the page ${await theme()}`);
  await bed.close();
  const wrong = await open('testbed.html#stack of bixes');
  await wrong.waitForFunction(() => { const c = document.getElementById('testbed'); return c.game && /^said there is no scene stack of bixes$/m.test(c.game.describe()); }, null, { timeout: 20000 })
    .catch(() => check(false, `${name}: a wrong name in the address is passed over`));
  await wrong.close();
  await phone.close();
}
await end();
