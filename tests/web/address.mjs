// address.mjs: the testbed's address in Chromium: it follows the scene and its settings, Back and Forward go there, an unknown scene is told,
// and a link holds a world that was changed.
//   node tests/web/address.mjs build/book/html          needs playwright-core (tests/web/run.sh brings it)
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { browser, check, end, html } from './browser.mjs';
const open = async (hash, reducedMotion = 'no-preference') => {
  const context = await browser.newContext({ viewport: { width: 1100, height: 720 }, reducedMotion }), page = await context.newPage();
  page.on('pageerror', e => check(false, e.message));
  page.on('dialog', d => d.dismiss());
  await page.goto('file://' + join(html, 'testbed.html' + hash));
  await page.waitForFunction(() => { const c = document.getElementById('testbed'); return c.game && c.game.own && /^widget /m.test(c.game.describe()); }, null, { timeout: 20000 });
  await page.evaluate(() => document.getElementById('testbed').game.more());
  page.tell = label => page.evaluate(label => (document.getElementById('testbed').game.describe().match(new RegExp(`^${label} (.*)$`, 'm')) || ['', ''])[1], label);
  page.until = (label, want) => page.waitForFunction(([label, want]) => (document.getElementById('testbed').game.describe().match(new RegExp(`^${label} (.*)$`, 'm')) || ['', ''])[1] === want,
    [label, want], { timeout: 10000 }).catch(async () => check(false, `${label} is ${await page.tell(label)}, and not ${want}`));
  page.hash = want => page.waitForFunction(want => location.hash === want, want, { timeout: 10000 }).catch(async () => check(false, `the address ends with ${await page.evaluate(() => location.hash)}, and not ${want}`));
  page.link = () => page.evaluate(() => document.getElementById('testbed').game.say('web_link'));
  page.click1 = name => page.evaluate(name => {
    const game = document.getElementById('testbed').game, at = game.describe().match(new RegExp(`^widget ${name} pixel (\\S+) (\\S+)$`, 'm'));
    if (!at) throw new Error('no widget ' + name);
    game.click(+at[1], +at[2]); game.frame(0, 0); game.frame(0, 0);
  }, name);
  return page;
};
const page = await open('#cradle');
await page.until('scene', 'cradle');
check(!/chapter|program/.test(await page.locator('header span').innerText()), 'the first line speaks of the book, and not of what can be done');
await page.evaluate(() => document.getElementById('testbed').game.open('bridge'));
await page.hash('#scene=bridge');
await page.evaluate(() => document.getElementById('testbed').game.open('dominoes'));
await page.hash('#scene=dominoes');
await page.goBack();
await page.until('scene', 'bridge');
await page.goForward();
await page.until('scene', 'dominoes');
await page.evaluate(() => { location.hash = '#scene=pyramid&gravity.y=-3'; });
await page.until('scene', 'pyramid');
await page.waitForFunction(() => /gravity\.y=-3$/.test(document.getElementById('testbed').game.say('web_link')), null, { timeout: 10000 }).catch(async () => check(false, `the link is ${await page.link()}`));
await page.evaluate(() => { location.hash = '#scene=nowhere'; });
await page.until('said', 'there is no scene nowhere');
check(await page.tell('scene') === 'pyramid', 'an unknown scene takes the other one away');
await page.hash('#scene=pyramid&gravity.x=0&gravity.y=-3');
for (const [hash, said] of [['scene=dominoes&gravity=abc&gravity.x=&foo=1', "the address asks for what can't be set: gravity=abc, gravity.x=, foo=1"], ['scene=Pyramid&gravity=-3', '']]) {
  await page.evaluate(hash => { location.hash = hash; }, hash);
  await page.until('scene', hash[6] === 'P' ? 'pyramid' : 'dominoes');
  await page.until('said', said);
}
const lost = await open('#nowhere');
await lost.until('said', 'there is no scene nowhere');
await lost.hash(`#scene=${(await lost.tell('scene')).replace(/ /g, '-')}`);
await lost.close();

// a challenge has an address of its own, and waits at its first step
await page.evaluate(() => { location.hash = '#challenge=wall'; });
await page.until('challenge', 'wall');
await page.until('paused', '1');
check(await page.tell('steps') === '0' && await page.link() === 'challenge=wall', `the challenge is at step ${await page.tell('steps')}, its link is ${await page.link()}`);
await page.click1('Start');
await page.until('paused', '0');
await page.evaluate(() => document.getElementById('testbed').game.open('dominoes'));
await page.hash('#scene=dominoes');
await page.goBack();
await page.until('challenge', 'wall');
await page.hash('#challenge=wall');
const bridge = await open('#challenge=bridge');
await bridge.until('challenge', 'bridge');
await bridge.until('scene', 'ten tonnes');

// a world that was changed, in a link
const made = await open('#scene=stack-of-boxes&gravity.y=-5');
await made.until('scene', 'stack of boxes');
await made.waitForTimeout(500);
await made.evaluate(async () => { const g = document.getElementById('testbed').game; await g.more(); g.key(112); g.frame(0, 0); g.key(110); g.key(127); g.frame(0, 0); });
const bodies = await made.tell('bodies'), hash = await made.tell('hash');
check(bodies === '6', `a box of seven bodies was removed: ${bodies}`);
await made.evaluate(() => { const g = document.getElementById('testbed').game; g.key(115); g.frame(0, 0); g.frame(0, 0); });
await made.click1('Files');
await made.click1('Copy link');
await made.waitForFunction(() => document.getElementById('testbed').game.copied, null, { timeout: 10000 }).catch(() => check(false, 'no link was made'));
const url = await made.evaluate(() => document.getElementById('testbed').game.copied || '');
check(url.length > 100 && url.length < 8500, `the link has ${url.length} letters`);
const came = await open(url.replace(/^[^#]*/, ''), 'reduce');       // it begins paused
await came.until('bodies', bodies);
await came.until('hash', hash);
const short = await open(url.replace(/^[^#]*/, '').slice(0, 300), 'reduce');
await short.until('said', "this link is damaged: its world can't be read");
await short.close();
// a saved world that is dropped on the page is loaded; what is no saved world is told, and nothing else happens
const drop = (page, name, letters) => page.evaluate(async ([name, letters]) => {
  const data = new DataTransfer(), bytes = Uint8Array.from(atob(letters), c => c.charCodeAt(0)), over = new DragEvent('dragover', { dataTransfer: data, bubbles: true, cancelable: true });
  data.items.add(new File([bytes], name));
  const taken = [!document.getElementById('testbed').dispatchEvent(over)];
  taken.push(!document.getElementById('testbed').dispatchEvent(new DragEvent('drop', { dataTransfer: data, bubbles: true, cancelable: true })));
  await new Promise(done => setTimeout(done, 300));
  return taken.every(t => t);
}, [name, letters]);
const world = await made.evaluate(async () => {
  const g = document.getElementById('testbed').game;
  for (const key of [0, 119, 0, 0]) { if (key) g.key(key); g.frame(0, 0); }
  return localStorage.getItem('weft/world.save');
});
check(world && world.length > 100, 'the world is not kept');
const kept = await made.tell('hash');
await page.evaluate(() => document.getElementById('testbed').game.open('dominoes'));
await page.until('scene', 'dominoes');
check(await drop(page, 'A friend’s world, in May.weft', world), 'the page does not take a file');
await page.until('scene', 'stack of boxes');
await page.until('bodies', bodies);
await page.evaluate(() => { const g = document.getElementById('testbed').game; g.open('dominoes'); g.frame(0, 0); g.key(112); g.frame(0, 0); });
const still = await page.tell('hash');
for (const [name, letters, said] of [['half.save', world.slice(0, 400), /bytes|save/], ['empty.save', '', /save/], ['a.json', btoa('{}'), /a.json: line 1/], ['a.rube', '', /export/], ['a.png', '', /neither/]]) {
  await drop(page, name, letters);
  check(said.test(await page.tell('said')), `${name}: ${await page.tell('said')}`);
  check(await page.tell('hash') === still, `${name}: the world is another`);
}

// an address that was cut in the middle of a letter opens the page, which goes on following its address
const cut = await open('#%E0%A4%A');
await cut.until('said', 'there is no scene %E0%A4%A');
await cut.evaluate(() => { location.hash = '#%E0'; });
await cut.until('said', 'there is no scene %E0');
await cut.evaluate(() => { location.hash = '#cradle'; });
await cut.until('scene', 'cradle');
// what was built is not left without a question
let asked = 0;
made.removeAllListeners('dialog');
made.on('dialog', d => { asked += d.type() === 'beforeunload'; d.accept(); });
await made.reload();
check(asked === 1, `a page with a changed world asked ${asked} times before it went`);
// and it is there again, says so, and is there after another one; a scene that nobody has changed begins as ever
const ready = page => page.waitForFunction(() => { const c = document.getElementById('testbed'); return c.game && c.game.own && /^widget /m.test(c.game.describe()); }, null, { timeout: 20000 });
const again = /here again, as it was before the reload; Reset begins anew/;
for (let i = 0; i < 2; i++) {
  await ready(made);
  await made.until('bodies', bodies);
  await made.until('hash', kept);
  await made.until('paused', '1');
  check(again.test(await made.tell('said')), `after reload ${i + 1}: ${await made.tell('said')}`);
  await made.reload();
}
await ready(made);
await made.until('hash', kept);
check(await made.evaluate(() => localStorage.getItem('weft/world.save') !== null && !Object.keys(sessionStorage).length), 'the kept world is not taken, or took the place of the saved one');
await made.evaluate(() => document.getElementById('testbed').game.open('dominoes'));
await made.until('scene', 'dominoes');
await made.hash('#scene=dominoes');
await made.reload();
await ready(made);
await made.waitForTimeout(600);
check(await made.tell('scene') === 'dominoes' && !again.test(await made.tell('said')), `a scene as it is: ${await made.tell('said')}`);
// each address keeps a world of its own: another scene in the same tab, and Back; an address that asks for other settings gets them
const tab = await open('#scene=stack-of-boxes'), to = async hash => { await tab.goto('about:blank'); await tab.goto('file://' + join(html, 'testbed.html' + hash)); await ready(tab); await tab.waitForTimeout(800); };
const change = async () => { await tab.evaluate(async () => { const g = document.getElementById('testbed').game; await g.more(); g.key(110); g.key(127); g.frame(0, 0); }); return tab.tell('bodies'); };
tab.removeAllListeners('dialog');
tab.on('dialog', d => d.accept());
const boxes = await change();
await to('#scene=dominoes');
const stones = await change();
await tab.goBack();
await tab.goBack();
await ready(tab);
await tab.until('bodies', boxes);
await to('#scene=dominoes');
await tab.until('bodies', stones);
await to('#scene=pyramid&gravity=-3');
check(!await tab.evaluate(() => document.getElementById('testbed').game.act(x => x.web_work())), 'a setting of the address counts as work');
await change();
await to('#scene=pyramid&gravity=-20');
check(/gravity\.y=-20$/.test(await tab.link()) && !again.test(await tab.tell('said')), `the address asks for -20: ${await tab.link()}, ${await tab.tell('said')}`);
// a world that only Undo can reach: the page asks, and the scene that is open begins as ever
await change();
await tab.evaluate(() => document.getElementById('testbed').game.open('dominoes'));
await tab.hash('#scene=dominoes');
let warned = 0;
tab.on('dialog', d => { warned += d.type() === 'beforeunload'; });
await tab.reload();
await ready(tab);
await tab.waitForTimeout(600);
check(warned === 1 && await tab.tell('scene') === 'dominoes' && !again.test(await tab.tell('said')), `with work that only Undo reaches the page asked ${warned} times, and says ${await tab.tell('said')}`);
// W says where the world is, and a file can be chosen though one is kept
await tab.evaluate(() => { const g = document.getElementById('testbed').game; g.key(119); for (let i = 0; i < 3; i++) g.frame(0, 0); });
check(/^kept in this browser: world.save, \d+ bytes/.test(await tab.tell('said')), `W says: ${await tab.tell('said')}`);
const [file] = await Promise.all([tab.waitForEvent('download', { timeout: 10000 }), tab.evaluate(() => { const g = document.getElementById('testbed').game; g.key(119); g.frame(0, 0); g.frame(0, 0); })]).catch(() => [null]);
check(file && file.suggestedFilename() === 'world.save' && readFileSync(await file.path()).toString('base64') === await tab.evaluate(() => localStorage.getItem('weft/world.save')), 'W twice makes no file');
const [chooser] = await Promise.all([tab.waitForEvent('filechooser', { timeout: 10000 }), tab.locator('#testbed').press('z')]).catch(() => [null]);
if (check(chooser, 'Read JSON asks for no file')) {
  await chooser.setFiles({ name: 'a friend.save', mimeType: '', buffer: Buffer.from(world, 'base64') });
  await tab.until('scene', 'stack of boxes');
}
await tab.close();
// where there is no storage, all goes on as without
const without = await (await browser.newContext({ viewport: { width: 1100, height: 720 } })).newPage();
without.on('pageerror', e => check(false, e.message));
without.on('dialog', d => d.accept());
await without.addInitScript(() => { for (const name of ['localStorage', 'sessionStorage']) Object.defineProperty(window, name, { get() { throw new DOMException('no', 'SecurityError'); } }); });
await without.goto('file://' + join(html, 'testbed.html#stack-of-boxes'));
await ready(without);
await without.evaluate(async () => { const g = document.getElementById('testbed').game; await g.more(); g.key(110); g.key(127); g.frame(0, 0); });
await without.reload();
await ready(without);
check(await without.evaluate(() => /^bodies 7$/m.test(document.getElementById('testbed').game.describe())), 'without storage the scene does not begin anew');
await end();
