// The testbed's address: it follows scene and settings, leads to them, and may hold a whole world.
//   #ragdolls    #scene=ragdolls&gravity.y=-3    #scene=...&world=LETTERS    #challenge=bridge
(() => {
  'use strict';
  const game = document.getElementById('testbed').game, link = () => game.parts() > 1 ? game.say('web_link') : '', MOST = 8192;
  const through = async (bytes, stream) => new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
  const binary = bytes => { let t = ''; bytes.forEach(b => { t += String.fromCharCode(b); }); return t; };
  const letters = bytes => btoa(binary(bytes)).replace(/[+/=]/g, c => ({ '+': '-', '/': '_' }[c] || ''));
  const bytesOf = text => Uint8Array.from(atob(text.replace(/[-_]/g, c => ({ '-': '+', _: '/' }[c]))), c => c.charCodeAt(0));
  let linked = null;                                   // a world that came by the address, for the next load
  // what the game wants of files: the world of the address, and a world that goes into one; a larger one is a file
  game.own = (wish, name, bytes) => {
    if (wish === 3 && name === 'link.save') { copy(bytes); return bytes; }
    if (wish === 1 && name === 'world.save') { (keeping ? put : settle)(bytes); return bytes; }
    if (wish === 3 && name === 'scene.json') { write(bytes); return bytes; }
    if (wish === 2 && name === 'scene.json') return choose('.json,application/json,.save,.weft');
    if (wish !== 2 || name !== 'world.save') return null;
    if (!linked && localStorage.getItem('weft/world.save') === null) return choose('.save,.weft');
    const came = linked;
    if (!came) return null;
    linked = null;
    return came;
  };
  // scenes as text: the module that reads those of the list makes a saved world of one, and the text of a world
  const say = text => game.act(x => { game.put(x, x.web_name(), text.replace(/[^ -~]/g, '?').slice(0, 118)); x.web_news(); });
  let settled = -1e9;                                  // when a world was kept; the next is a file if it comes soon
  const settle = bytes => {
    const soon = performance.now() - settled < 10000;
    settled = soon ? -1e9 : performance.now();
    localStorage.setItem('weft/world.save', btoa(binary(bytes)));
    if (soon) game.handOut(bytes, 'world.save');
    say(soon ? 'handed out: world.save; Read JSON reads it, and so does a drop' : `kept in this browser: world.save, ${bytes.length} bytes; A loads it, W again makes a file of it`);
  };
  const write = async bytes => {
    const { x } = await game.json(), head = x.json_info_size(), put = (at, part) => new Uint8Array(x.memory.buffer, at, part.length).set(part);
    put(x.json_info(), bytes.subarray(0, head));
    put(x.json_bytes(), bytes.subarray(head, head + (1 << 21)));
    const size = x.json_write(bytes.length - head);
    if (size) game.handOut(new Uint8Array(x.memory.buffer, x.json_text(), size).slice(), 'scene.json');
    say(size ? `kept: scene.json, ${size} bytes` : 'this world is too large for a text: save it instead');
  };
  const read = async (bytes, name) => {
    try {
      const [world, info] = await game.readScene(name, bytes);
      await game.more();
      game.act(x => x.web_guest());
      const at = game.take(world, info);
      if (!at) throw new Error('its world is too large for a page');
      game.open(game.word(at));
      game.frame(0, 0);
      game.key(104);                                   // Home: another file may have stood there
    } catch (e) { say(`!${name}: ${e.message}`); }
  };
  const choose = accept => {
    const chooser = Object.assign(document.createElement('input'), { type: 'file', accept });
    chooser.onchange = () => take(chooser.files[0]);
    chooser.click();
    say('which file?');
    return new Uint8Array(0);
  };
  const copy = async bytes => {
    const packed = letters(await through(bytes, new CompressionStream('deflate-raw')));
    const fits = packed.length <= MOST;
    game.copied = location.href.replace(/#.*/, '') + '#' + link() + (fits ? '&world=' + packed : '');
    if (fits) say(`the link is copied: ${game.copied.length} letters`);
    else { game.handOut(bytes, 'world.save'); say('the link to the scene is copied; the world, too large for it, is handed out as world.save'); }
    try { await navigator.clipboard.writeText(game.copied); } catch (e) { window.prompt('the link', game.copied); }
  };
  // the scene of an address; the name of a challenge's says so
  const named = hash => {
    const told = new URLSearchParams(hash.includes('=') ? hash : ''), task = told.get('challenge');
    return task ? 'challenge=' + task : hash.includes('=') ? told.get('scene') : game.plain(hash);
  };
  const go = async hash => {
    const told = new URLSearchParams(hash.includes('=') ? hash : ''), scene = named(hash), world = told.get('world');
    told.delete('scene'); told.delete('challenge'); told.delete('world');
    if (scene) game.open(scene);
    await game.more();
    game.frame(0, 0);
    if (lost()) return;
    const bad = [...told].filter(([name, value]) => !value.trim() || isNaN(value) || !game.set(name, +value)).map(([name, value]) => `${name}=${value}`);
    if (bad.length) say(`!the address asks for what can't be set: ${bad.join(', ')}`);
    if (!world) return;
    try {
      load(await through(bytesOf(world), new DecompressionStream('deflate-raw')));
    } catch (e) { linked = null; say('!this link is damaged: its world can\'t be read'); }
  };
  const frames = () => { for (let i = 0; i < 4; i++) game.frame(0, 0); };
  const load = bytes => {
    frames();                                          // its settings may be on the card
    linked = bytes;
    game.key(143);                                     // Ctrl-O: load
    frames();
  };
  // Back and a reload bring the world back. As the page goes, a world that was changed is written into the tab's own storage, under its address;
  // the next page of this address loads it. In a challenge nothing is kept, for a try begins at its beginning; where there is no storage, or too
  // little, neither. The newest eight stay, as far as there is room.
  const KEPT = 'weft/tab ', here = () => KEPT + location.hash;
  const slots = () => Object.keys(sessionStorage).filter(name => name.startsWith(KEPT)).sort((a, b) => parseInt(sessionStorage[b], 10) - parseInt(sessionStorage[a], 10));
  let keeping = '';                                    // when, and whether time stands, while a world is being kept
  const put = bytes => {
    const text = keeping + binary(bytes), old = slots();
    keeping = '';
    old.splice(7).forEach(name => sessionStorage.removeItem(name));
    for (;;) {
      try { sessionStorage.setItem(here(), text); return; } catch (e) { if (!old.length) throw e; }
      sessionStorage.removeItem(old.pop());
    }
  };
  const keep = () => {
    try {
      follow(true);
      sessionStorage.removeItem(here());
      const now = going ? '' : link();
      if (!now || now.startsWith('challenge=') || game.act(x => x.web_work()) !== 1) return;
      if (game.act(x => x.web_letters())) game.key(27);
      frames();
      keeping = `${Date.now()}\n${/^paused 1$/m.test(game.describe()) ? 1 : 0}\n`;
      game.key(142);                                   // Ctrl-S: save
      frames();
      say('');
    } catch (e) { /* there is no storage: the browser has asked */ }
    keeping = '';
  };
  const restore = async () => {
    let kept = '';
    try { kept = sessionStorage.getItem(here()) || ''; sessionStorage.removeItem(here()); } catch (e) { return; }
    const [when, still] = kept.split('\n', 2);
    if (!kept) return;
    await game.more();
    load(Uint8Array.from(kept.slice(when.length + 3), c => c.charCodeAt(0)));
    if (/^paused 1$/m.test(game.describe()) !== (still === '1')) game.key(112);
    say('your world is here again, as it was before the reload; Reset begins anew');
    game.frame(0, 0);
  };
  // another scene is a step of the page's history; another setting is not, nor what stands for a scene that there is none of
  const sceneOf = text => text.replace(/&.*/, '');
  const begins = hash => { const scene = (named(hash) || 'tumbler').replace(/ /g, '-'); return (scene.startsWith('challenge=') ? '' : 'scene=') + scene; };
  let shown = begins(location.hash.slice(1)), going = false;
  const first = shown, lost = () => /^said there is no scene /m.test(game.describe());
  const follow = leaves => {
    const now = (document.hidden && !leaves) || going ? shown : link();
    if (!now || now === shown) return;
    history[sceneOf(now) === sceneOf(shown) ? 'replaceState' : 'pushState'](null, '', '#' + now);
    shown = now;
  };
  const arrive = () => {
    shown = link() || shown;
    if (lost()) history.replaceState(null, '', '#' + shown);
    going = false;
  };
  const came = async hash => { going = true; await go(hash); arrive(); };
  // a file that is chosen or dropped on the page goes to the game by its card; what it is, and what is wrong with it, the game says
  addEventListener('dragover', e => { if (e.dataTransfer.types.includes('Files')) e.preventDefault(); });
  addEventListener('drop', e => { if (e.dataTransfer.files[0]) e.preventDefault(); take(e.dataTransfer.files[0]); });
  const take = async file => {
    if (!file) return;
    const bytes = new Uint8Array(await file.slice(0, 1 << 24).arrayBuffer()), name = file.name.replace(/[^ -~]/g, '-').slice(-39);
    await game.more();
    if (/\.json$/i.test(name)) { read(bytes, name); return; }
    const give = x => {
      new Uint8Array(x.memory.buffer, x.web_name(), name.length).set(Uint8Array.from(name, c => c.charCodeAt(0)));
      if (!x.web_dropped(name.length, bytes.length)) return false;
      new Uint8Array(x.memory.buffer, x.web_file_bytes(), bytes.length).set(bytes);
      return true;
    };
    for (let i = 0; i < 9 && !game.act(give); i++) game.frame(0, 0);       // its settings may be on the card
    game.frame(0, 0);
  };
  (async () => {
    going = true;
    game.frame(0, 0);
    if (/[=&]/.test(location.hash)) await go(location.hash.slice(1));
    else if (lost()) await game.more();
    await restore();
    arrive();
  })();
  addEventListener('pagehide', keep);
  document.addEventListener('visibilitychange', () => { if (document.hidden) keep(); });
  setInterval(follow, 500, false);
  addEventListener('popstate', () => came(location.hash.slice(1) || first));
})();
