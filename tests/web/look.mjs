// look.mjs: what an eye would find on the book's pages, found by a script: nothing is cut off or too faint to read.
//   node tests/web/look.mjs build/book/html [PAGE ...]
// On a desk: no page, formula or table is wider than its column; the letters of a figure stand inside it and have a contrast of 4.5 in light and
// dark. On a telephone: no page is wider than the screen.
import { readdirSync } from 'node:fs';
import { join } from 'node:path';
import { browser, check, end, html } from './browser.mjs';
const only = process.argv.slice(3);
const files = readdirSync(html).filter(f => f.endsWith('.html') && !/^(slides-\d+|source-.*|testbed|identifiers|chunks)\.html$/.test(f) && (!only.length || only.includes(f)))
  .filter((f, i) => only.length || process.env.ALL_PAGES || i % 3 === 0);      // in a check every third; ALL_PAGES=1: all, some two minutes
const context = await browser.newContext({ viewport: { width: 1366, height: 844 }, colorScheme: 'light' });
await context.route(/live[^/]*\.js$/, r => r.abort());                     // figures as they are frozen

const look = () => {
  const told = [], name = e => (e.closest('[id]') || e).id, words = e => e.textContent.trim().replace(/\s+/g, ' ').slice(0, 40);
  const numbers = c => { const v = (c.match(/[\d.]+/g) || []).map(Number); return v.length > 3 ? v : [...v, 1]; };
  const light = c => [0.2126, 0.7152, 0.0722].reduce((s, k, i) => s + k * (c[i] <= 10 ? c[i] / 3294.6 : ((c[i] / 255 + 0.055) / 1.055) ** 2.4), 0);
  const over = (top, under) => [0, 1, 2].map(i => top[i] * top[3] + under[i] * (1 - top[3]));
  if (document.documentElement.scrollWidth > innerWidth) told.push('the page is wider than the window');
  for (const e of document.querySelectorAll('main .eqm math, main .tbl'))
    if (e.scrollWidth > e.clientWidth + 1) told.push(`${name(e)} is ${e.scrollWidth} px wide, and its column ${e.clientWidth}`);
  const paper = numbers(getComputedStyle(document.body).backgroundColor);
  for (const svg of document.querySelectorAll('main .fig svg')) {
    const all = svg.getBoundingClientRect(), shapes = [...svg.querySelectorAll('rect,path,circle,polygon')];
    for (const t of svg.querySelectorAll('text')) {
      const r = t.getBoundingClientRect(), out = [all.left - r.left, r.right - all.right, all.top - r.top, r.bottom - all.bottom];
      if (!words(t) || !r.width || name(svg) === 'fig:scenes-tree') continue;                             // a quarter of a scene
      if (Math.max(...out) > 3) told.push(`${name(svg)} cuts off "${words(t)}"`);
      let under = paper;
      for (const s of shapes) {
        const style = getComputedStyle(s);
        if (style.fill === 'none' || t.compareDocumentPosition(s) & Node.DOCUMENT_POSITION_FOLLOWING) continue;
        const at = new DOMPoint((r.left + r.right) / 2, (r.top + r.bottom) / 2).matrixTransform(s.getScreenCTM().inverse());
        if (!s.isPointInFill(at)) continue;
        const c = numbers(style.fill);
        under = over([...c.slice(0, 3), c[3] * style.fillOpacity * style.opacity], under);
      }
      const a = light(numbers(getComputedStyle(t).fill)) + 0.05, b = light(under) + 0.05, contrast = Math.max(a, b) / Math.min(a, b);
      if (contrast < 4.5) told.push(`${name(svg)}: "${words(t)}" has a contrast of ${contrast.toFixed(2)}`);
    }
  }
  return told;
};

for (const file of files) {
  const page = await context.newPage();
  await page.goto('file://' + join(html, file));
  await page.evaluate(() => document.fonts.ready);
  const told = await page.evaluate(look);
  await page.evaluate(() => { document.documentElement.dataset.theme = 'dark'; });
  told.push(...(await page.evaluate(look)).filter(t => !told.includes(t)).map(t => 'in the dark ' + t));
  await page.setViewportSize({ width: 390, height: 844 });
  if (await page.evaluate(() => document.documentElement.scrollWidth > innerWidth)) told.push('on a telephone the page is wider than the screen');
  check(!told.length, `${file}: ${told.slice(0, 5).join('; ')}${told.length > 5 ? `; ... (${told.length})` : ''}`);
  await page.close();
}
check(only.length || files.length > 40, `only ${files.length} pages were looked at`);
await end(`${files.length} pages looked at; `);
