// drive.mjs: scenes that are driven on a telephone: two fingers on two buttons, one that holds a body beside one on a button, tilt; and what
// all of them show at first lies beside the buttons or above them, and nowhere under them.
//   node tests/web/drive.mjs build/book/html          needs playwright-core (tests/web/run.sh brings it)
import { join } from 'node:path';
import { browser, check, end, html } from './browser.mjs';
const same = (a, b, text) => check(a === b, `${text}: ${a}, and not ${b}`);
const LEFT = 1, RIGHT = 2, UP = 4, DOWN = 8;

for (const [name, width, height] of [['upright', 390, 844], ['lying', 844, 390]]) {
  const phone = await browser.newContext({ viewport: { width, height }, deviceScaleFactor: 3, isMobile: true, hasTouch: true });
  const open = async (scene, answer) => {
    const page = await phone.newPage();
    page.on('console', m => { if (m.type() === 'error') check(false, `${scene} ${name}: the console says: ${m.text()}`); });
    page.on('pageerror', e => check(false, `${scene} ${name}: ${e.message}`));
    if (answer) await page.addInitScript(answer => {
      let touched = false;                             // navigator.userActivation of a page may come from the page that was there before
      addEventListener('click', () => { touched = true; }, true);
      DeviceOrientationEvent.requestPermission = async () => { if (!touched) throw new DOMException('by a finger', 'NotAllowedError'); return answer; };
    }, answer);
    await page.goto('file://' + join(html, 'testbed.html#scene=' + scene.replace(/ /g, '-')));
    await page.waitForFunction(scene => { const c = document.getElementById('testbed'); return c.game && c.game.describe().startsWith('scene ' + scene + '\n'); }, scene, { timeout: 20000 });
    await page.waitForFunction(() => document.querySelector('script[src$="fingers.js"]'));
    const canvas = page.locator('#testbed'), b = await canvas.boundingBox(), k = await canvas.evaluate(c => c.width / c.getBoundingClientRect().width);
    page.tell = () => canvas.evaluate(c => c.game.describe());
    page.fact = async (label, n = 0) => ((await page.tell()).match(new RegExp(`^${label} (.*)$`, 'm')) || ['', ''])[1].split(' ')[n];
    page.spot = async label => { const m = (await page.tell()).match(new RegExp(`^${label} .*pixel (\\S+) (\\S+)$`, 'm')); return check(m, `${scene} ${name}: there is no ${label}`) ? [b.x + m[1] / k, b.y + m[2] / k] : [0, 0]; };
    page.held = async () => { await page.waitForTimeout(120); return +await page.fact('controls', 1); };
    const wire = await phone.newCDPSession(page), down = new Map();
    const points = () => [...down].map(([id, [x, y]]) => ({ x, y, id }));
    page.down = async (id, at) => { down.set(id, at); await wire.send('Input.dispatchTouchEvent', { type: 'touchStart', touchPoints: points() }); };
    page.move = async (id, at) => { down.set(id, at); await wire.send('Input.dispatchTouchEvent', { type: 'touchMove', touchPoints: points() }); };
    page.up = async id => {                            // the others stay down
      const [x, y] = down.get(id);
      down.delete(id);
      await wire.send('Input.dispatchTouchEvent', { type: 'touchEnd', touchPoints: down.size ? [{ x, y, id }] : [] });
    };
    page.lean = (beta, gamma) => wire.send('DeviceOrientation.setDeviceOrientationOverride', { alpha: 0, beta, gamma });
    return page;
  };

  // -- two fingers on two buttons; each lets go of its own; one slides on to the next; the view stays
  const race = await open('race car');
  const gas = await race.spot('widget gas'), left = await race.spot('widget left'), right = await race.spot('widget right');
  const view = await race.fact('view', 2);
  await race.down(1, gas);
  same(await race.held(), UP, `${name}: one finger on the gas`);
  await race.down(2, left);
  same(await race.held(), UP | LEFT, `${name}: gas and steering, each by a finger`);
  await race.move(2, right);
  same(await race.held(), UP | RIGHT, `${name}: the steering finger slides on`);
  await race.up(1);
  same(await race.held(), RIGHT, `${name}: the gas is let go`);
  await race.down(1, gas);
  same(await race.held(), UP | RIGHT, `${name}: and given again`);
  await race.up(2);
  same(await race.held(), UP, `${name}: the steering is let go`);
  await race.up(1);
  same(await race.held(), 0, `${name}: both are let go`);
  same(await race.fact('view', 2), view, `${name}: two fingers on buttons zoom`);
  await race.close();

  // -- one finger holds a body, another drives; the order does not matter, and the body stays held
  const hills = await open('hill car');
  const body = async () => hills.spot('body 0'), go = await hills.spot('widget gas');
  const pull = async () => { const [x, y] = await body(); await hills.down(1, [x, y]); await hills.move(1, [x, y - 30]); };
  await pull();
  await hills.waitForTimeout(100);
  same(await hills.fact('held'), '0', `${name}: a finger on the car`);
  await hills.down(2, go);
  same(await hills.held(), RIGHT, `${name}: a second finger on the gas`);
  await hills.waitForTimeout(800);                     // a finger that rests opens a menu, but not while another drives
  same(await hills.held(), RIGHT, `${name}: the gas after a second`);
  same(await hills.fact('held'), '0', `${name}: the car is still held`);
  same(await hills.fact('menu'), '0', `${name}: a menu that opens while somebody drives`);
  await hills.up(2);
  same(await hills.held(), 0, `${name}: the gas is let go, the car is not`);
  same(await hills.fact('held'), '0', `${name}: the car after that`);
  await hills.up(1);
  await hills.waitForTimeout(200);
  same(await hills.fact('held'), '-1', `${name}: the car is let go`);
  await hills.down(2, go);
  await hills.waitForTimeout(200);
  await pull();
  same(await hills.held(), RIGHT, `${name}: the gas first, and then the car`);
  same(await hills.fact('held'), '0', `${name}: the car, taken while driving`);
  await hills.up(1); await hills.up(2);
  await hills.close();

  // -- every driven scene is seen whole, with no button over it; where Settings or the list lie over it, there are no buttons
  const all = await open('race car'), pixels = await all.locator('#testbed').evaluate(c => c.width / c.getBoundingClientRect().width);
  let driven = 0;
  await all.evaluate(async () => { const { game } = document.getElementById('testbed'); game.stop(); await game.more(); });
  for (let scene = ''; scene !== 'race car'; ) {       // once around, by ]
    const told = await all.evaluate(() => { const { game } = document.getElementById('testbed'); game.key(93); for (let i = 0; i < 3; i++) game.frame(0, 0); return game.describe(); });
    scene = told.match(/^scene (.*)$/m)[1];
    if (scene === 'none') { await all.waitForTimeout(50); continue; }
    const row = told.match(/^controls ([1-9]\d*) \d+ pixel (\S+) (\S+) (\S+) (\S+) (\S+) apart (\d+) (\S+)$/m);
    if (!row) continue;
    driven++;
    const [bits, x, y, w, h, gap, near, apart] = row.slice(1).map(Number), n = [1, 2, 4, 8, 16].filter(b => bits & b).length;
    const buttons = [...Array(n).keys()].map(i => [x + i * (w + gap) + (i < near ? 0 : apart), y]);
    const canvas = await all.locator('#testbed').evaluate(c => [c.width, c.height]), head = Math.max(...['List', 'Settings'].map(label => +told.match(new RegExp(`^widget ${label} pixel \\S+ (\\S+)$`, 'm'))[1]));
    check(buttons[0][0] >= 0 && buttons[n - 1][0] + w <= canvas[0] && w >= 44 * pixels && h >= 44 * pixels, `${scene} ${name}: buttons of ${w / pixels} x ${h / pixels} px`);
    check(name === 'upright' ? apart === 0 : apart > 0 || near === n, `${scene} ${name}: the buttons are ${apart} apart`);
    for (const [, body, bx, by] of told.matchAll(/^body (\d+) .* pixel (\S+) (\S+)$/mg)) {
      const along = told.match(/^follow (.*)$/m)[1];    // whose scene is longer than any picture
      if (+along >= 0 && along !== body) continue;
      check(+bx > 0 && +bx < canvas[0] && +by > head && +by < y + h, `${scene} ${name}: body ${body} is at ${bx}, ${by} in a picture of ${canvas}`);
      check(!buttons.some(([left, top]) => +bx > left - 1 && +bx < left + w + 1 && +by > top - 1 && +by < top + h + 1), `${scene} ${name}: body ${body} is under a button`);
    }
  }
  check(driven > 12, `${driven} driven scenes`);
  await all.evaluate(() => { const { game } = document.getElementById('testbed'); game.open('race car'); for (let i = 0; i < 3; i++) game.frame(0, 0); });
  await all.down(1, await all.spot('widget Settings'));
  await all.up(1);
  await all.waitForTimeout(400);
  const under = await all.tell(), panel = under.includes('\nwidget World pixel');
  check(panel && /^widget gas /m.test(under), `${name}: the buttons with the panel open`);
  const at = label => under.match(new RegExp(`^widget ${label} pixel (\\S+) (\\S+)$`, 'm'))?.slice(1).map(Number) ?? [NaN, NaN], side = name === 'lying' ? 0 : 1;
  check(at('gas')[side] < at('World')[side] - (side ? 20 : 40), `${name}: gas lies over the panel`);
  await all.close();

  // -- tilt: no button before the sensor has spoken; beyond 12 degrees held, below 7 let go; both ways where there are words for both
  const tilted = await open('race car'), button = tilted.getByRole('button', { name: 'Tilt' });
  await tilted.waitForTimeout(1300);
  same(await button.count(), 0, `${name}: buttons for a sensor that is not there`);
  // angles of the screen: how far its right edge is down, how steeply it stands; as the sensor of a device that stands or lies tells them
  const angle = await tilted.evaluate(() => screen.orientation.angle);
  same(angle, name === 'upright' ? 0 : 90, `${name}: the screen's angle`);
  const lean = async (roll, pitch) => {
    const rad = Math.PI / 180, down = [Math.sin(roll * rad), -Math.cos(roll * rad) * Math.sin(pitch * rad), -Math.cos(roll * rad) * Math.cos(pitch * rad)];
    const [x, y, z] = angle === 90 ? [down[1], -down[0], down[2]] : down;
    await tilted.lean(Math.atan2(-y, Math.hypot(x, z)) / rad, Math.atan2(x, -z) / rad);
    return tilted.held();
  };
  const hand = await tilted.spot('widget gas');
  await tilted.down(1, hand); await tilted.held(); await tilted.up(1);       // from here on the demo does not drive
  await lean(0, 40);
  await button.waitFor({ timeout: 3000 }).catch(() => check(false, `${name}: no button for tilt`));
  const place = await button.boundingBox();
  check(place.width >= 44 && place.height >= 44 && place.x >= 0 && place.x + place.width <= width, `${name}: the button is at ${JSON.stringify(place)}`);
  same(await lean(30, 40), 0, `${name}: a tilt that nobody has switched on`);
  await lean(0, 40);
  await button.tap();
  await tilted.waitForTimeout(200);
  same(await button.getAttribute('aria-pressed'), 'true', `${name}: the button is pressed`);
  for (const [roll, pitch, want, what] of [[0, 40, 0, 'level'], [10, 40, 0, 'a little to the right'], [15, 40, RIGHT, 'to the right'], [9, 40, RIGHT, 'less, but not below the second angle'],
    [5, 40, 0, 'level again'], [-15, 40, LEFT, 'to the left'], [-15, 22, LEFT | UP, 'and away'], [0, 22, UP, 'away alone'], [0, 60, DOWN, 'towards the reader'], [0, 40, 0, 'level at the end']])
    same(await lean(roll, pitch), want, `${name}: ${what}`);

  // what tilt has done is on the tape: recorded, gone back, replayed, to the last bit
  const key = async k => { await tilted.evaluate(k => document.getElementById('testbed').game.key(k.charCodeAt(0)), k); await tilted.waitForTimeout(120); };
  await key('f');
  same(await tilted.fact('tape'), '2', `${name}: the tape runs`);
  await lean(-20, 20); await tilted.waitForTimeout(500); await lean(20, 20); await tilted.waitForTimeout(500); await lean(0, 60);
  await key('p');
  await key('f');
  const hash = await tilted.fact('hash'), steps = await tilted.fact('steps');
  await lean(20, 20);                                  // nothing of now may get into it
  await key('k');
  await tilted.waitForFunction(steps => +document.getElementById('testbed').game.describe().match(/^steps (.*)$/m)[1] >= steps, +steps, { timeout: 20000 });
  await tilted.waitForTimeout(300);
  same(await tilted.fact('tape'), '1', `${name}: the tape has ended`);
  same(await tilted.fact('steps'), steps, `${name}: the step at which the replay ends`);
  same(await tilted.fact('hash'), hash, `${name}: the replay`);
  await button.tap();
  await key('p');
  same(await lean(30, 40), 0, `${name}: a tilt that was switched off`);
  // a scene whose controls have no other end has no such button; nor has one that nobody drives
  for (const scene of ['trebuchet', 'pyramid']) {
    await tilted.evaluate(scene => document.getElementById('testbed').game.open(scene), scene);
    await tilted.waitForTimeout(1300);
    same(await button.isVisible(), false, `${name}: tilt in the scene ${scene}`);
  }
  await tilted.close();

  // a browser that wants to be asked by a finger is asked by one, and may say no
  for (const answer of ['granted', 'denied']) {
    const asked = await open('race car', answer), tilt = asked.getByRole('button', { name: 'Tilt' });
    await tilt.waitFor({ timeout: 20000 }).catch(() => check(false, `${name}: no button to ask by`));
    await tilt.tap();
    await asked.waitForTimeout(200);
    same(await tilt.getAttribute('aria-pressed'), String(answer === 'granted'), `${name}: tilt after ${answer}`);
    await asked.close();
  }
  await phone.close();
}
// -- a page that is dark when it opens a driven scene, where D drives
const night = await (await browser.newContext({ colorScheme: 'dark' })).newPage();
await night.goto('file://' + join(html, 'testbed.html#scene=pool'));
await night.waitForFunction(() => { const c = document.getElementById('testbed'); return c.game && /^steps [1-9]/m.test(c.game.describe()); }, null, { timeout: 20000 });
check(/^dark 1$/m.test(await night.evaluate(() => document.getElementById('testbed').game.describe())), 'pool: a light scene in a dark page');
await end();
