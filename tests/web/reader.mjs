// reader.mjs: the book's pages as a reader handles them: search, the drawer of the contents, a simulation that begins, slides.
//   node tests/web/reader.mjs build/book/html        needs playwright-core (tests/web/run.sh brings it)
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { browser, check, end, html } from './browser.mjs';
const open = async (file, options) => {
  const page = await (await browser.newContext(options)).newPage();
  page.on('pageerror', e => check(false, `${file}: ${e.message}`));
  await page.goto('file://' + join(html, file));
  return page;
};
const desk = { viewport: { width: 1366, height: 768 } }, phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };

// -- search: Enter leads to the first hit, and that is in sight
const page = await open('index.html', desk);
const first = async word => {
  await page.keyboard.press('/');
  await page.keyboard.type(word);
  await page.waitForFunction(w => [...document.querySelectorAll('#hits a')].some(a => a.textContent.toLowerCase().includes(w)), word, { timeout: 20000 });
  return page.evaluate(() => { const a = document.querySelector('#hits a'); return [a.querySelector('small').textContent, a.getAttribute('href')]; });
};
let [kind, href] = await first('slop');
check(kind === 'glossary' && href === 'glossary.html#g-slop', `"slop" finds first ${kind} ${href}`);
await page.keyboard.press('Enter');
await page.waitForURL(/glossary\.html/);
const mark = await page.evaluate(() => { const e = document.querySelector(':target'), b = e && e.getBoundingClientRect(); return b && [e.textContent, b.top, b.bottom, getComputedStyle(e).backgroundColor, innerHeight]; });
check(mark && mark[0] === 'slop' && mark[1] > 50 && mark[2] < mark[4], `the entry "slop" is not in sight: ${mark}`);
check(mark && mark[3] !== 'rgba(0, 0, 0, 0)', 'the entry "slop" is not marked');
for (const [word, want] of [['friction', 'friction.html#sec:friction'], ['impulses', 'impulses.html#sec:impulses'], ['coursework', 'coursework.html#sec:coursework']]) {
  await page.reload();
  [kind, href] = await first(word);
  check(href === want, `"${word}" finds first ${kind} ${href}, and not the chapter of that title`);
}
await page.context().close();

// -- the drawer: a tap beside it closes it, and does nothing else
const narrow = await open('classics.html', phone), menu = () => narrow.locator('#menu').getAttribute('aria-expanded');
const link = narrow.locator('main a.cref:visible').first();
await link.evaluate(a => { scrollTo({ top: scrollY + a.getBoundingClientRect().top - 400, behavior: 'instant' }); a.style.cssText = 'position:fixed;left:355px;top:400px;z-index:1'; });
await narrow.locator('#menu').tap();
check(await menu() === 'true' && await narrow.locator('#toc').isVisible(), 'the contents do not open');
await narrow.locator('#toc summary:visible').first().tap();
check(await menu() === 'true', 'a tap on a heading within the contents closes them');
await narrow.touchscreen.tap(365, 408);
await narrow.waitForTimeout(700);
check(await menu() === 'false' && !await narrow.locator('#toc').isVisible(), 'a tap beside the contents does not close them');
check(narrow.url().endsWith('classics.html') && !await narrow.locator('#pop').count(), 'a tap beside the contents acts on what lies behind them');
await narrow.context().close();

// -- a simulation that begins has its world as large as the frozen picture, and where that was
for (const width of [1366, 900, 390]) {
  const live = await open('classics.html', { viewport: { width, height: 768 } }), figure = live.locator('figure[data-scene]').first();
  await figure.scrollIntoViewIfNeeded();
  await live.waitForSelector('figure[data-scene].live');
  const stones = await figure.locator('.pic svg polygon').evaluateAll(all => all.map(p => p.getBoundingClientRect()).filter(b => b.width < 80).map(b => [b.x + b.width / 2, b.y + b.height / 2]));
  const wide = Math.max(...stones.map(s => s[0])) - Math.min(...stones.map(s => s[0])), top = Math.min(...stones.map(s => s[1]));
  await figure.getByRole('button', { name: 'Run it' }).click();
  await live.waitForFunction(() => { const c = document.querySelector('figure canvas'); return c && c.game && /^steps [1-9]/m.test(c.game.describe()); }, null, { timeout: 20000 });
  const now = await figure.locator('canvas').evaluate(c => { const b = c.getBoundingClientRect(); return [...c.game.describe().matchAll(/^body .* pixel (\S+) (\S+)$/mg)].map(m => [b.x + m[1] * b.width / c.width, b.y + m[2] * b.height / c.height]); });
  const share = (Math.max(...now.map(s => s[0])) - Math.min(...now.map(s => s[0]))) / wide, moved = Math.min(...now.map(s => s[1])) - top;
  check(share > 0.95 && share < 1.02, `at ${width} units the arch that runs has ${share.toFixed(2)} of the frozen one's size`);
  check(Math.abs(moved) < 6, `at ${width} units the arch moves by ${moved.toFixed(0)} as it begins to run`);
  await live.context().close();
}

// -- slides: a click, a button, a key and a finger turn them
if (check(existsSync(join(html, 'slides-1.html')), 'there are no slides (make slides)')) {
  const slides = await open('slides-1.html', phone), at = () => slides.evaluate(() => Math.round(scrollY / innerHeight));
  const turn = async (what, act, want) => { await act(); await slides.waitForTimeout(150); check(await at() === want, `slides: ${what} leads to slide ${await at() + 1}, not to ${want + 1}`); };
  const swipe = async (from, to) => {
    const cdp = await slides.context().newCDPSession(slides), send = (type, touchPoints) => cdp.send('Input.dispatchTouchEvent', { type, touchPoints });
    await send('touchStart', [{ x: from, y: 60 }]);
    for (let i = 1; i < 6; i++) await send('touchMove', [{ x: from + (to - from) * i / 5, y: 60 + i }]);
    await send('touchEnd', []);
  };
  await turn('a tap', () => slides.touchscreen.tap(200, 820), 1);
  await turn('the button on', () => slides.getByRole('button', { name: 'the next slide' }).click(), 2);
  await turn('a key after it', () => slides.keyboard.press('ArrowRight'), 3);
  await turn('a finger to the left', () => swipe(320, 80), 4);
  await turn('a finger to the right', () => swipe(80, 320), 3);
  await turn('the button back', () => slides.getByRole('button', { name: 'the slide before' }).click(), 2);
  check((await slides.locator('#turn span').textContent()).startsWith('3 / '), `slides: the third calls itself ${await slides.locator('#turn span').textContent()}`);
  check(await slides.locator('.slide').first().evaluate(s => getComputedStyle(s, '::after').content) === 'none', 'slides: two numbers stand on one');
  await slides.locator('.slide a').first().evaluate(a => { a.onclick = e => e.preventDefault(); a.click(); });
  check(await at() === 2, 'slides: a click on a link turns them, too');
  await slides.context().close();
}
await end();
