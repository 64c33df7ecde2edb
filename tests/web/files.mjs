// files.mjs: scenes that are files, in the testbed's page: each is in the list, is opened by its name, and has the bits of the program without a window.
//   node tests/web/files.mjs build/book/html build/bin/weft-headless          needs playwright-core (tests/web/run.sh brings it)
import { readdirSync, readFileSync } from 'node:fs';
import { execFileSync } from 'node:child_process';
import { join } from 'node:path';
import { browser, check, end, html } from './browser.mjs';
const headless = process.argv[3], STEPS = 60;
const files = readdirSync('testbed/scenes').filter(f => f.endsWith('.json') && !f.endsWith('.schema.json')).map(f => 'testbed/scenes/' + f);
const same = (a, b, text) => check(a === b, `${text}: ${a}, and not ${b}`);
const open = async hash => {
  const page = await browser.newPage({ viewport: { width: 1100, height: 760 } });
  page.loaded = 0;
  page.on('request', r => { if (r.url().endsWith('live-json.js')) page.loaded++; });
  page.on('console', m => { if (m.type() === 'error') check(false, `${hash}: the console says: ${m.text()}`); });
  page.on('pageerror', e => check(false, `${hash}: ${e.message}`));
  await page.goto('file://' + join(html, 'testbed.html' + hash));
  return page;
};
const shows = (page, name) => page.waitForFunction(name => { const c = document.getElementById('testbed'); return c.game && c.game.describe().startsWith('scene ' + name + '\n'); }, name, { timeout: 20000 })
  .then(() => true, () => check(false, `${name} does not open`));
const fact = (page, label) => page.evaluate(label => (document.getElementById('testbed').game.describe().match(new RegExp(`^${label} (.*)$`, 'm')) || ['', ''])[1], label);

// by hand: in the list, opened, stepped
check(files.length > 5, `${files.length} files`);
const page = await open('#scene=pyramid');
await shows(page, 'pyramid');
await page.evaluate(() => document.getElementById('testbed').game.more());
await page.waitForTimeout(500);
same(page.loaded, 0, 'the reader, before anything is read');
for (const file of files) {
  const { name } = JSON.parse(readFileSync(file, 'utf8'));
  const at = await page.evaluate(async ([name, steps]) => {
    const { game } = document.getElementById('testbed'), fact = label => (game.describe().match(new RegExp(`^${label} (.*)$`, 'm')) || ['', ''])[1];
    game.stop();
    game.open(name);
    for (let i = 0; i < 200 && fact('scene') !== name; i++) { game.frame(0, 0); await new Promise(done => setTimeout(done, 50)); }
    game.frame(0, 0);
    game.frame(0, steps);
    return { scene: fact('scene'), steps: fact('steps'), hash: fact('hash'), listed: game.describe().includes(`\nwidget ${name} pixel`) };
  }, [name, STEPS]);
  same(at.scene, name, 'the scene');
  same(at.steps, String(STEPS), `${name}: steps`);
  check(at.listed, `${name} is not in the list`);
  same(at.hash, execFileSync(headless, ['--hash', file, '--steps', String(STEPS)], { encoding: 'utf8' }).trim().split(' ').pop(), `${name}: the hash after ${STEPS} steps`);
}
same(page.loaded, 1, 'the reader, after all');
await page.close();

// by an address, and with a setting; the address goes on saying so
const told = await open('#scene=seesaw');
await shows(told, 'seesaw');
await told.waitForTimeout(1500);
check(+await fact(told, 'steps') > 10, `seesaw makes ${await fact(told, 'steps')} steps`);
check((await told.evaluate(() => location.hash)).startsWith('#scene=seesaw'), `the address says ${await told.evaluate(() => location.hash)}`);

// the page writes no JSON, and says what else keeps the world
await told.evaluate(async () => { const g = document.getElementById('testbed').game; await g.more(); g.key(117); for (let i = 0; i < 4; i++) g.frame(0, 0); });
same(await fact(told, 'said'), 'this testbed was built without JSON: save the world instead', 'U in the page');
await told.close();
await end();
