// frames.mjs: how long a frame takes in the page: the median and the slowest of 120, in milliseconds, each with a step and a picture.
//   node tests/web/frames.mjs build/book/html WORLD.save WIDTH HEIGHT          prints: median,slowest,steps,bodies
// The world is put where the browser keeps it, and the key A fetches it. Counted is what the page's own thread does for a frame (step, drawing, handing
// the picture to the canvas); the screen is Chromium's, without a graphics card.
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { browser, html } from './browser.mjs';
const [save, width, height] = [readFileSync(process.argv[3]).toString('base64'), +process.argv[4], +process.argv[5]];
const page = await browser.newPage({ viewport: { width, height: height + 50 } });
await page.addInitScript(save => localStorage.setItem('weft/world.save', save), save);
await page.goto('file://' + join(html, 'testbed.html#scene=pyramid'));
await page.waitForFunction(() => { const c = document.getElementById('testbed'); return c.game && /^steps [1-9]/m.test(c.game.describe()); }, null, { timeout: 20000 });
// the canvas as large as the window of the other measurement
const bar = await page.evaluate(() => innerHeight - document.getElementById('testbed').getBoundingClientRect().height);
await page.setViewportSize({ width, height: Math.round(height + bar) });
const told = await page.evaluate(async () => {
  const { game } = document.getElementById('testbed'), next = () => new Promise(requestAnimationFrame), ms = [];
  await game.more();
  game.stop();
  game.key(97);
  for (let i = 0; i < 10; i++) { await next(); game.frame(1 / 60, 0); }
  const fact = label => game.describe().match(new RegExp(`^${label} (.*)$`, 'm'))[1], begin = +fact('steps');
  for (let i = 0; i < 180; i++) {
    await next();
    const before = performance.now();
    game.frame(1 / 60, 1);
    ms.push(performance.now() - before);
  }
  const last = ms.slice(-120).sort((a, b) => a - b), canvas = document.getElementById('testbed');
  return { median: last[60], worst: last[119], steps: fact('steps') - begin, bodies: +fact('bodies'), size: `${canvas.width} x ${canvas.height}` };
});
await browser.close();
if (told.steps !== 180 || told.size !== `${width} x ${height}`) { console.error(`frames: ${told.steps} steps in a canvas of ${told.size}`); process.exit(1); }
console.log(`${told.bodies},${told.median.toFixed(2)},${told.worst.toFixed(2)}`);
