// media.mjs: what the book's pages load, and when; what can be taken out of them (pictures, drawings, films); how they look by night.
//   node tests/web/media.mjs build/book/html          needs playwright-core and axe-core (tests/web/run.sh brings them)
import { existsSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { browser, check, end, fail, html, require } from './browser.mjs';
const axe = readFileSync(require.resolve('axe-core/axe.min.js'), 'utf8');
const open = async (context, file) => {
  const page = await context.newPage();
  page.on('console', m => { if (m.type() === 'error') fail(`${file}: the console says: ${m.text()}`); });
  page.on('pageerror', e => fail(`${file}: ${e.message}`));
  page.scripts = [];
  page.on('request', r => { const m = r.url().match(/live-(.*)\.js$/); if (m) page.scripts.push(m[1]); });
  await page.goto('file://' + join(html, file));
  return page;
};
const runs = page => page.waitForFunction(() => { const c = document.getElementById('testbed'); return c.game && /^steps [1-9]/m.test(c.game.describe()); }, null, { timeout: 20000 });
const desk = await browser.newContext({ viewport: { width: 1000, height: 640 }, acceptDownloads: true });
const two = existsSync(join(html, 'live-testbed-rest.js'));

// -- the first frame asks for the first part alone, a key brings the second
if (two) {
  const page = await open(desk, 'testbed.html#stack of boxes');
  await runs(page);
  await page.waitForTimeout(1000);
  check(page.scripts.join() === 'testbed', `testbed.html: for its first frames it loads ${page.scripts.join(', ')}`);
  check(await page.evaluate(() => document.getElementById('testbed').game.parts()) === 1, 'testbed.html: it says it has both parts');
  await page.keyboard.press('p');
  await page.waitForFunction(() => document.getElementById('testbed').game.parts() === 2, null, { timeout: 20000 });
  check(page.scripts.join() === 'testbed,testbed-rest', `testbed.html: after a key it has loaded ${page.scripts.join(', ')}`);
  await page.waitForFunction(() => /^paused 1$/m.test(document.getElementById('testbed').game.describe()), null, { timeout: 5000 })
    .catch(() => fail('testbed.html: the key that brought the second part is lost'));
  await page.close();
}
// -- a scene that the first part can't run: broken off, told again, and then the same bits
const walked = async (page, early) => {
  await runs(page);
  return page.evaluate(async early => {
    const { game } = document.getElementById('testbed');
    game.stop();
    if (early) await game.more();
    game.open('ragdolls');
    for (let i = 0; i < 150; i++) game.frame(0, 1);
    const parts = game.parts();
    for (let i = 0; i < 200 && !game.describe(); i++) await new Promise(done => setTimeout(done, 50));
    for (let i = 0; i < 150; i++) game.frame(0, 1);
    const said = game.describe();
    return { parts, scene: said.match(/^scene (.*)$/m)[1], steps: said.match(/^steps (.*)$/m)[1], hash: said.match(/^hash (.*)$/m)[1] };
  }, early);
};
if (two) {
  const late = await open(desk, 'testbed.html#stack of boxes'), soon = await open(desk, 'testbed.html#stack of boxes');
  const a = await walked(late, false), b = await walked(soon, true);
  check(a.parts === 1 && b.parts === 2, `the ragdolls: parts ${a.parts} and ${b.parts}: nothing was broken off -- name a scene that the first part can't run`);
  check(a.scene === 'ragdolls' && a.steps === '300' && b.steps === '300', `the ragdolls, told again: ${JSON.stringify(a)}`);
  check(a.hash === b.hash, `the ragdolls, told again, have the hash ${a.hash}, and with both parts ${b.hash}`);
  await late.close();
  await soon.close();
}

// -- pictures, drawings and films leave the page as files
const bed = await open(desk, 'testbed.html#dominoes');
await runs(bed);
const shelf = [];
bed.on('download', d => shelf.push(d));
const got = async (key, count, pattern) => {
  const from = shelf.length;
  await bed.keyboard.press(key);
  for (let i = 0; i < 200 && shelf.length < from + count; i++) await bed.waitForTimeout(50);
  const files = [];
  for (const d of shelf.slice(from, from + count)) files.push({ name: d.suggestedFilename(), bytes: readFileSync(await d.path()) });
  check(files.length === count && files.every(f => pattern.test(f.name)), `the key ${key} gives ${files.map(f => f.name).join(', ') || 'no file'}`);
  return files;
};
const chunks = png => {
  const list = [];
  for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at)) list.push([png.toString('latin1', at + 4, at + 8), png.subarray(at + 8, at + 8 + png.readUInt32BE(at))]);
  return list;
};
const decoded = bytes => bed.evaluate(async url => {
  const image = new Image(), c = document.createElement('canvas');
  image.src = url;
  await image.decode();
  c.width = image.naturalWidth; c.height = image.naturalHeight;
  const pen = c.getContext('2d'), colours = new Set();
  pen.drawImage(image, 0, 0);
  new Uint32Array(pen.getImageData(0, 0, c.width, c.height).data.buffer).forEach(n => colours.add(n));
  return { width: c.width, height: c.height, colours: colours.size };
}, 'data:image/png;base64,' + bytes.toString('base64'));
const size = await bed.locator('#testbed').evaluate(c => ({ width: c.width, height: c.height }));
const [picture] = await got('!', 1, /^picture-\d+\.png$/);
if (picture) {
  const seen = await decoded(picture.bytes);
  check(seen.width === size.width && seen.height === size.height, `${picture.name} is ${seen.width} x ${seen.height}, the canvas ${size.width} x ${size.height}`);
  check(seen.colours > 30, `${picture.name} has ${seen.colours} colours`);
}
const [drawing] = await got('#', 1, /^picture-\d+\.svg$/);
if (drawing) {
  const shapes = await bed.evaluate(text => {
    const svg = new DOMParser().parseFromString(text, 'image/svg+xml');
    return svg.querySelector('parsererror') ? -1 : svg.querySelectorAll('polygon, path, circle, line').length;
  }, drawing.bytes.toString());
  check(shapes > 10, `${drawing.name} has ${shapes} shapes (-1: it can't be read)`);
}
await bed.keyboard.press('%');
await bed.waitForTimeout(1500);
const [film] = await got('%', 1, /^film-\d+\.png$/);
if (film) {
  const list = chunks(film.bytes), told = list.find(c => c[0] === 'acTL'), frames = list.filter(c => c[0] === 'fcTL').length;
  check(told && told[1].readUInt32BE(0) === frames && frames > 5, `${film.name}: it has ${frames} pictures, and says ${told ? told[1].readUInt32BE(0) : 'nothing'}`);
  check((await decoded(film.bytes)).colours > 30, `${film.name} can't be decoded`);
}
const frames = await got('&', 4, /^frame-\d+\.png$/);
await bed.keyboard.press('&');
check(frames.map(f => f.name).join() === 'frame-1.png,frame-2.png,frame-3.png,frame-4.png', `frames come as ${frames.map(f => f.name).join()}`);
check(frames.length === 4 && !frames[0].bytes.equals(frames[3].bytes), 'the dominoes fall, and the first frame is the fourth');
for (const f of frames) check((await decoded(f.bytes)).colours > 10, `${f.name} is empty`);
await bed.close();

// -- the figure of a tower's sag: the formula and the tower agree, wherever the handle is
const soft = await open(desk, 'soft.html');
const sag = soft.locator('figure[data-live="soft-sag"]');
await sag.scrollIntoViewIfNeeded();
await soft.waitForSelector('figure[data-live="soft-sag"].live');
check(soft.scripts.join() === 'figures-soft', `soft.html loads ${soft.scripts.join(', ')}`);
const sunk = async () => (await sag.locator('svg').textContent()).match(/(\d+) substeps?.*?([\d.]+) mm.*?([\d.]+) mm/s).slice(1).map(Number);
const grip = sag.locator('.grip').first(), seen = [await sunk()];
for (const way of [60, 120, 180]) {
  const b = await grip.boundingBox();
  await soft.mouse.move(b.x + b.width / 2, b.y + b.height / 2);
  await soft.mouse.down();
  await soft.mouse.move(b.x + b.width / 2 + way, b.y + b.height / 2, { steps: 4 });
  await soft.mouse.up();
  seen.push(await sunk());
}
check(new Set(seen.map(s => s[0])).size > 1, `soft-sag: dragged, the substeps are ${seen.map(s => s[0]).join(', ')}`);
for (const [n, is, formula] of seen) check(Math.abs(is - formula) <= 0.05 * formula + 0.1, `soft-sag: with ${n} substeps the top sinks by ${is} mm, by the formula ${formula} mm`);
for (const [a, b] of seen.slice(1).map((s, i) => [seen[i], s])) if (b[0] !== a[0])
  check((b[0] > a[0]) === (b[2] < a[2]), `soft-sag: ${a[2]} mm with ${a[0]} substeps, and ${b[2]} mm with ${b[0]}`);
await soft.close();

// -- by night: page, figure and canvas are dark and readable; by day again they are light
const night = await browser.newContext({ viewport: { width: 1000, height: 800 }, colorScheme: 'dark' });
const light = rgb => { const [r, g, b] = rgb.map(v => (v /= 255) <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4); return 0.2126 * r + 0.7152 * g + 0.0722 * b; };
const paper = page => page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/[\d.]+/g).slice(0, 3).map(Number)).then(light);
const inks = figure => figure.locator('svg').evaluate(svg => [...svg.querySelectorAll('text')].map(t => getComputedStyle(t).fill.match(/[\d.]+/g).slice(0, 3).map(Number)));
const contrast = (a, b) => (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
// of the canvas: how light it is where nothing is (the commonest colour), and the best contrast with that
const canvas = async c => {
  const counts = await c.evaluate(c => {
    const n = new Map();
    new Uint32Array(c.getContext('2d').getImageData(0, 0, c.width, c.height).data.buffer).forEach(v => n.set(v, (n.get(v) || 0) + 1));
    return [...n].sort((a, b) => b[1] - a[1]).slice(0, 400).map(e => e[0]);
  });
  const all = counts.map(v => light([v & 255, v >> 8 & 255, v >> 16 & 255]));
  return { paper: all[0], contrast: Math.max(...all.map(l => contrast(l, all[0]))) };
};
const looks = async (page, what, dark) => {
  const is = await paper(page), right = l => dark ? l < 0.1 : l > 0.7, word = dark ? 'by night' : 'by day';
  check(right(is), `${what} ${word}: the page's paper has the luminance ${is.toFixed(2)}`);
  return { is, right, word };
};
const looked = async (page, figure, play, dark) => {
  const { is, right, word } = await looks(page, 'sequential.html', dark);
  const texts = await inks(figure);
  check(texts.length > 0 && texts.every(t => contrast(light(t), is) >= 4.5), `a figure ${word}: words with the contrast ${Math.min(...texts.map(t => contrast(light(t), is))).toFixed(1)}`);
  const c = await canvas(play);
  check(right(c.paper) && c.contrast > 4.5, `a simulation ${word}: paper ${c.paper.toFixed(2)}, contrast ${c.contrast.toFixed(1)}`);
};
const page = await open(night, 'sequential.html');
const figure = page.locator('figure[data-live]').first(), play = page.locator('figure[data-scene]').first();
await figure.scrollIntoViewIfNeeded();
await page.waitForSelector('figure[data-live].live');
await play.scrollIntoViewIfNeeded();
await play.getByRole('button', { name: 'Run it' }).click();
const field = play.locator('canvas');
await field.waitFor();
await page.waitForFunction(c => c.game && /^steps [1-9]/m.test(c.game.describe()), await field.elementHandle(), { timeout: 20000 });
if (two) check(page.scripts.sort().join() === 'figures-sequential,testbed', `sequential.html: a figure and a simulation load ${page.scripts.join(', ')}`);
for (const dark of [true, false, true]) {
  await page.emulateMedia({ colorScheme: dark ? 'dark' : 'light' });
  await page.waitForTimeout(400);
  await looked(page, figure, field, dark);
  if (!dark) continue;
  await page.evaluate(axe);
  const found = await page.evaluate(() => axe.run(document, { runOnly: ['color-contrast'], preload: false }));
  for (const v of found.violations) fail(`sequential.html by night: ${v.help}, ${v.nodes.length} times, first: ${v.nodes[0].html.slice(0, 140)}`);
}
await page.close();
const whole = await open(night, 'testbed.html#stack of boxes');
await runs(whole);
for (const dark of [true, false, true]) {
  await whole.emulateMedia({ colorScheme: dark ? 'dark' : 'light' });
  await whole.waitForTimeout(400);
  const { right, word } = await looks(whole, 'testbed.html', dark), c = await canvas(whole.locator('#testbed'));
  check(right(c.paper) && c.contrast > 4.5, `the testbed ${word}: paper ${c.paper.toFixed(2)}, contrast ${c.contrast.toFixed(1)}`);
}
await end();
