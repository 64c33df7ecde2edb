// files.mjs: scenes that are files, in the testbed's page: each is in the list, is opened by its name, and has the bits of the program without a window.
//   node tests/web/files.mjs build/book/html build/bin/weft-headless          needs playwright-core (tests/web/run.sh brings it)
import { readdirSync, readFileSync } from 'node:fs';
import { execFileSync } from 'node:child_process';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { browser, check, end, html } from './browser.mjs';
const headless = process.argv[3], STEPS = 60;
const files = readdirSync('testbed/scenes').filter(f => f.endsWith('.json') && !f.endsWith('.schema.json')).map(f => 'testbed/scenes/' + f);
const same = (a, b, text) => check(a === b, `${text}: ${a}, and not ${b}`);
const visit = await browser.newContext({ viewport: { width: 1100, height: 760 } });
const open = async hash => {
  const page = await visit.newPage();
  page.loaded = 0;
  page.on('request', r => { if (r.url().endsWith('live-json.js')) page.loaded++; });
  page.on('console', m => { if (m.type() === 'error') check(false, `${hash}: the console says: ${m.text()}`); });
  page.on('pageerror', e => check(false, `${hash}: ${e.message}`));
  await page.goto('file://' + join(html, 'testbed.html' + hash));
  return page;
};
const shows = (page, name) => page.waitForFunction(name => { const c = document.getElementById('testbed'); return c.game && c.game.describe().startsWith('scene ' + name + '\n'); }, name, { timeout: 20000 })
  .then(() => true, async () => check(false, `${name} does not open, but ${await fact(page, 'scene')}`));
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

// a save of it is loaded again, also by a page in which its file was not read yet: at its step, and in its own scene
const until = (page, said) => page.waitForFunction(said => document.getElementById('testbed').game.describe().includes('\nsaid ' + said), said, { timeout: 20000 }).catch(async () => check(false, `it says: ${await fact(page, 'said')}, and not ${said}`));
const press = (page, key) => page.evaluate(async key => { const g = document.getElementById('testbed').game; await g.more(); g.key(key.charCodeAt(0)); }, key);
await press(told, 'p');
await told.waitForTimeout(200);
const hash = await fact(told, 'hash');
await press(told, 'w');
await until(told, 'kept in this browser: world.save');
for (const begun of ['#scene=seesaw', '#scene=pyramid']) {
  const later = await open(begun);
  await shows(later, begun.slice(7));
  await press(later, 'p');
  await press(later, 'a');
  await until(later, 'loaded: the world as it was');
  await later.waitForTimeout(1500);
  same(await fact(later, 'scene'), 'seesaw', `a save, loaded in ${begun}`);
  same(await fact(later, 'hash'), hash, `a save, loaded in ${begun}: the hash`);
  await later.close();
}

// the page writes a scene as text, which the program reads; and it reads one, by a file chooser and by a drop: the same world
const [sent] = await Promise.all([told.waitForEvent('download'), press(told, 'u')]);
same(sent.suggestedFilename(), 'scene.json', 'the name of the file');
const written = join(tmpdir(), `weft-${process.pid}.json`);
await sent.saveAs(written);
await until(told, 'kept: scene.json');
const text = readFileSync(written, 'utf8'), now = execFileSync(headless, ['--hash', written, '--steps', '9'], { encoding: 'utf8' }).trim().split(' ').pop();
same(JSON.parse(text).name, 'seesaw', 'the name in the file');
const nine = (page, what) => page.evaluate(() => { const { game } = document.getElementById('testbed'); game.stop(); if (/^paused 1$/m.test(game.describe())) game.key(112); game.key(114); game.frame(0, 0); game.frame(0, 9); return game.describe().match(/^hash (.*)$/m)[1]; }).then(h => same(h, now, `${what}: the hash after nine steps`));
const [chooser] = await Promise.all([told.waitForEvent('filechooser'), press(told, 'z')]);
await chooser.setFiles(written);
await shows(told, 'seesaw (file)');
await nine(told, 'chosen');
const drop = (page, name, text) => page.evaluate(([name, text]) => {
  const data = new DataTransfer();
  data.items.add(new File([text], name));
  dispatchEvent(new DragEvent('drop', { dataTransfer: data, cancelable: true }));
}, [name, text]);
const bare = await open('#scene=pyramid');
await shows(bare, 'pyramid');
await drop(bare, 'mine.json', text.replace('"seesaw"', '"my own"'));
await shows(bare, 'my own');
await nine(bare, 'dropped');
await drop(bare, 'other.json', text.replace('"seesaw"', '"my other"'));         // and the first one stays
await shows(bare, 'my other');
await bare.evaluate(() => { const g = document.getElementById('testbed').game; g.open('my own'); g.frame(0, 0); });
await shows(bare, 'my own');
await nine(bare, 'dropped, and then another');
await press(bare, 'w');
await bare.evaluate(() => document.getElementById('testbed').game.run());
await until(bare, 'kept in this browser: world.save');
await bare.evaluate(() => document.getElementById('testbed').game.open('pyramid'));
await shows(bare, 'pyramid');
await press(bare, 'p');
await press(bare, 'a');
await until(bare, 'loaded: the world as it was');
same(await fact(bare, 'scene'), 'my own', 'a save of what was dropped');
same(await fact(bare, 'hash'), now, 'a save of what was dropped: the hash');
await bare.close();
const anew = await open('#scene=pyramid');              // where its scene is not
await shows(anew, 'pyramid');
await press(anew, 'p');
await press(anew, 'a');
await until(anew, 'loaded, into this scene');
same(await fact(anew, 'hash'), now, 'a save whose scene is not here: the hash');
await drop(anew, 'bad.json', '{"name": 3,');
await until(anew, 'bad.json: line 1');
await drop(anew, 'empty.json', '');
await until(anew, 'empty.json: line');
await anew.close();
await told.close();
await end();
