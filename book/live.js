// Weft's live figures and simulations: the tangled code as WebAssembly. Works from file://; without it the frozen pictures stay.
// A figure is <figure data-live="NAME" data-code="HREF">, a simulation <figure data-scene="NAME" data-code="HREF">.
(() => {
  'use strict';
  const here = document.currentScript.src.replace(/[^/]*$/, '');
  const utf8 = new TextEncoder(), words = new TextDecoder();
  // LZMA (Pavlov), the format of `xz --format=lzma': a range decoder whose probabilities, p, learn as they go. Chapter 27.
  const unpack = (from, size) => {
    const lc = from[0] % 9, lp = (from[0] / 9 | 0) % 5, pb = from[0] / 45 | 0, to = new Uint8Array(size);
    let range = 0xffffffff, code = 0, at = 13;
    const model = n => new Uint16Array(n).fill(1024);
    const refill = () => { if (range < 0x1000000) { range = range * 256; code = (code * 256 + from[at++]) % 0x100000000; } };
    const bit = (p, i) => {
      const bound = (range >>> 11) * p[i];
      let b = 0;
      if (code < bound) { range = bound; p[i] += 2048 - p[i] >> 5; } else { range -= bound; code -= bound; p[i] -= p[i] >> 5; b = 1; }
      refill();
      return b;
    };
    const tree = (p, base, bits) => { let m = 1; for (let i = 0; i < bits; i++) m = m * 2 + bit(p, base + m); return m - (1 << bits); };
    const back = (p, base, bits) => { let m = 1, x = 0; for (let i = 0; i < bits; i++) { const b = bit(p, base + m); m = m * 2 + b; x |= b << i; } return x; };
    const direct = bits => { let x = 0; while (bits--) { range = Math.floor(range / 2); const b = code >= range ? 1 : 0; if (b) code -= range; refill(); x = x * 2 + b; } return x; };
    const lengths = () => ({ choice: model(2), low: model(128), mid: model(128), high: model(256) });
    const length = (l, k) => !bit(l.choice, 0) ? 2 + tree(l.low, 8 * k, 3) : !bit(l.choice, 1) ? 10 + tree(l.mid, 8 * k, 3) : 18 + tree(l.high, 0, 8);
    const literal = model(0x300 << lc + lp), isMatch = model(192), isRep = model(12), isRep0 = model(12), isRep1 = model(12), isRep2 = model(12), isLong = model(192);
    const slot = model(256), near = model(115), align = model(16), first = lengths(), again = lengths(), rep = [0, 0, 0, 0];
    for (let i = 0; i < 5; i++) code = (code * 256 + from[at++]) % 0x100000000;
    for (let n = 0, state = 0; n < size;) {
      const k = n & (1 << pb) - 1;
      if (!bit(isMatch, state * 16 + k)) {
        const base = 0x300 * (((n & (1 << lp) - 1) << lc) + ((n ? to[n - 1] : 0) >> 8 - lc));
        let m = 1, same = state >= 7, old = same ? to[n - rep[0] - 1] : 0;
        while (m < 256) {
          const want = old >> 7 & 1, b = bit(literal, base + (same ? 256 * (1 + want) : 0) + m);
          old <<= 1; m = m * 2 + b; same = same && want === b;
        }
        to[n++] = m; state = state < 4 ? 0 : state < 10 ? state - 3 : state - 6;
        continue;
      }
      let count;
      if (bit(isRep, state)) {
        if (!bit(isRep0, state)) {
          if (!bit(isLong, state * 16 + k)) { to[n] = to[n - rep[0] - 1]; n++; state = state < 7 ? 9 : 11; continue; }
        } else {
          const which = !bit(isRep1, state) ? 1 : 2 + bit(isRep2, state);
          rep.unshift(rep.splice(which, 1)[0]);
        }
        count = length(again, k); state = state < 7 ? 8 : 11;
      } else {
        count = length(first, k); state = state < 7 ? 7 : 10;
        const s = tree(slot, 64 * Math.min(count - 2, 3), 6), bits = (s >> 1) - 1;
        let d = s;
        if (s >= 4) {
          d = (2 | s & 1) << bits;
          d += s < 14 ? back(near, d - s, bits) : direct(bits - 4) * 16 + back(align, 0, 4);
        }
        rep.unshift(d); rep.pop();
        if (d >= n) break;                             // the mark of the end, or damage
      }
      for (; count-- > 0 && n < size; n++) to[n] = to[n - rep[0] - 1];
    }
    return to;
  };
  // A module (`testbed', or a page's figures) comes as a script of base64, packed, since a page from a disk may not fetch.
  const modules = {}, told = {};
  window.WEFT_LIVE = (name, size, text) => WebAssembly.compile(unpack(Uint8Array.from(atob(text), c => c.charCodeAt(0)), size)).then(...told[name]);
  const load = name => modules[name] || (modules[name] = new Promise((done, fail) => {
    const s = document.createElement('script');
    told[name] = [done, fail];
    s.src = here + 'live-' + name + '.js';
    s.onerror = () => { delete modules[name]; s.remove(); fail(new Error('live-' + name + '.js is missing')); };
    document.head.append(s);
  }));
  // A module may be the first part of two. Where it calls the second it calls a placeholder, which throws until that has come: join() brings it.
  class Missing extends Error {}
  const instance = async name => {
    const module = await load(name), wants = WebAssembly.Module.imports(module), imports = {};
    for (const w of wants) (imports[w.module] = imports[w.module] || {})[w.name] = () => { throw new Missing(name + ': the rest is not here yet'); };
    const x = (await WebAssembly.instantiate(module, imports)).exports;
    const join = async () => { await WebAssembly.instantiate(await load(name + '-rest'), { primary: x }); };
    return { x, join, whole: !wants.length };
  };
  const put = (x, at, text) => {
    const bytes = utf8.encode(text);
    new Uint8Array(x.memory.buffer, at, bytes.length + 1).set([...bytes, 0]);
    return bytes.length;
  };
  const button = (text, label, act) => {
    const b = document.createElement('button');
    b.type = 'button';
    b.say = (text, label) => { b.textContent = text; b.title = label; b.setAttribute('aria-label', text + ': ' + label); };
    b.say(text, label);
    b.onclick = act;
    return b;
  };
  const bar = (figure, ...things) => {
    const d = document.createElement('div');
    d.className = 'live-bar';
    d.append(...things);
    if (figure.dataset.code) {
      const a = document.createElement('a');
      a.href = figure.dataset.code; a.textContent = 'view the code';
      d.append(a);
    }
    figure.querySelector('.pic').after(d);
    return d;
  };

  // -- figures: handles to drag, a time to run; one instance serves them all, since it keeps nothing between two drawings
  const shared = {};
  const figureModule = name => shared[name] || (shared[name] = instance('figures-' + name).then(part => part.x));
  const ns = 'http://www.w3.org/2000/svg';
  const makeFigure = async figure => {
    const x = await figureModule(figure.dataset.of || window.WEFT_PAGE), name = figure.dataset.live, svg = figure.querySelector('.pic svg');
    put(x, x.live_text(), name);
    const row = x.live_find();
    if (row < 0 || !svg) return;
    const count = x.live_handles(), wide = x.live_width(row), high = x.live_height(row), unit = 480 / wide;
    const home = Array.from(new Float32Array(x.memory.buffer, x.live_handle(), 2 * count));
    let at = home.slice(), time = 0, playing = 0, seen = true;
    const ink = document.createElementNS(ns, 'g'), grips = document.createElementNS(ns, 'g');
    svg.replaceChildren(ink, grips);
    const draw = () => {
      put(x, x.live_text(), name);
      x.live_find();
      new Float32Array(x.memory.buffer, x.live_handle(), 2 * count).set(at);
      const length = x.live_draw(row, time);
      if (length) {
        const text = words.decode(new Uint8Array(x.memory.buffer, x.live_text(), length));
        ink.innerHTML = text.slice(text.indexOf('>') + 1, text.lastIndexOf('</svg>'));
      }
      [...grips.children].forEach((g, i) => {
        g.setAttribute('transform', `translate(${at[2 * i] * unit} ${(high - at[2 * i + 1]) * unit})`);
        g.setAttribute('aria-valuetext', at[2 * i].toFixed(2) + ', ' + at[2 * i + 1].toFixed(2));
      });
    };
    const move = (i, px, py) => {
      at[2 * i] = Math.min(wide, Math.max(0, px));
      at[2 * i + 1] = Math.min(high, Math.max(0, py));
      draw();
    };
    for (let i = 0; i < count; i++) {
      // a ring, and around it as much as a finger needs: 44 px, whatever the figure's size
      const g = document.createElementNS(ns, 'g'), ring = document.createElementNS(ns, 'circle'), room = document.createElementNS(ns, 'circle');
      ring.setAttribute('r', 9); room.setAttribute('class', 'room');
      g.append(room, ring);
      g.setAttribute('class', 'grip'); g.setAttribute('tabindex', 0);
      g.setAttribute('role', 'slider'); g.setAttribute('aria-valuemin', 0); g.setAttribute('aria-valuemax', 100); g.setAttribute('aria-valuenow', 50);
      g.setAttribute('aria-label', 'point ' + (i + 1) + ' of ' + count + ': drag it, or use the arrow keys');
      // a finger on a ring must not scroll the page: `touch-action' of a part of an SVG is not obeyed, a refused touchstart is
      g.addEventListener('touchstart', e => e.preventDefault(), { passive: false });
      g.addEventListener('pointerdown', e => { g.setPointerCapture(e.pointerId); e.preventDefault(); g.focus(); });
      g.addEventListener('pointermove', e => {
        if (!g.hasPointerCapture(e.pointerId)) return;
        const r = svg.getBoundingClientRect();
        move(i, (e.clientX - r.left) / r.width * wide, high - (e.clientY - r.top) / r.height * high);
      });
      g.addEventListener('keydown', e => {
        const step = (e.shiftKey ? 1 / 16 : 1 / 128) * wide;
        const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key];
        if (!way) return;
        e.preventDefault();
        move(i, at[2 * i] + way[0] * step, at[2 * i + 1] + way[1] * step);
      });
      grips.append(g);
    }
    const tools = [];
    if (figure.dataset.moves) {
      let last = 0;
      const tick = now => {
        if (playing && seen && !document.hidden) { if (last) time += Math.min(0.1, (now - last) / 1000); draw(); }
        last = now;
        if (playing) playing = requestAnimationFrame(tick);
      };
      const play = button('Play', 'let time run', () => {
        if (playing) { cancelAnimationFrame(playing); playing = 0; } else { last = 0; playing = requestAnimationFrame(tick); }
        playing ? play.say('Pause', 'time runs') : play.say('Play', 'let time run');
      });
      tools.push(play);
    }
    tools.push(button('Reset', 'as it was', () => { at = home.slice(); time = 0; draw(); }));
    const hint = document.createElement('span');
    hint.textContent = count ? 'drag the ring' + (count > 1 ? 's' : '') : '';
    bar(figure, ...tools, hint);
    figure.liveSeen = is => { seen = is; };
    figure.classList.add('live');
    const reach = () => {
      const scale = svg.getScreenCTM();
      grips.querySelectorAll('.room').forEach(c => c.setAttribute('r', Math.max(9, 22.1 / (scale && scale.a || 1))));
    };
    new ResizeObserver(reach).observe(svg);
    draw();
    reach();
  };

  // A scene in a file is read by a module of its own (chapter 27), and comes as a saved world and a record of what the file says of itself.
  const readScene = async (name, bytes) => {
    const { x } = await instance('json'), text = bytes || Uint8Array.from(atob(window.WEFT_FILES[name]), c => c.charCodeAt(0));
    if (text.length > x.json_room()) throw new Error('it is too large');
    new Uint8Array(x.memory.buffer, x.json_text(), text.length).set(text);
    const size = x.json_read(text.length), part = (at, n) => new Uint8Array(x.memory.buffer, at, n).slice();
    if (!size) throw new Error(words.decode(part(x.json_text(), 160)).replace(/\0[^]*/, ''));
    return [part(x.json_bytes(), size), part(x.json_info(), x.json_info_size())];
  };
  const brought = {}, bring = src => { if (!brought[src]) document.head.append(brought[src] = Object.assign(document.createElement('script'), { src: here + src })); };

  // -- simulations: the whole testbed on a canvas; each has a memory of its own, and few may run at once
  const running = [], MOST_TOLD = 3600;
  const keyOf = e => ({ Backspace: 8, Tab: 9, Enter: 13, Escape: 27, ' ': 32, Delete: 127, ArrowLeft: 128, ArrowRight: 129, ArrowUp: 130, ArrowDown: 131,
    Home: 132, End: 133, PageUp: 134, PageDown: 135 }[e.key] || (e.key.length === 1 && e.key.codePointAt(0) < 127 ? e.key.codePointAt(0) : 0));
  const makeGame = async (canvas, scene, options = {}) => {
    let part = await instance('testbed'), x = part.x, log = part.whole ? null : [], stuck = false, rest = null;
    const pen = canvas.getContext('2d');
    let last = 0, on = false, dark = null, touches = new Map(), pinch = null, finger = matchMedia('(pointer: coarse)').matches, looks = '', letters = null;
    // All that crosses into the module goes through act. Until the rest has come it is written down: a call that was broken off
    // by a function that is missing leaves a memory of no use, so the game is begun anew and the whole story told again, unseen.
    let idle = false, waits = false, inside = false, reading = false, frames = 0;
    const wakeUp = () => { idle = false; if (waits && on) { waits = false; last = 0; requestAnimationFrame(tick); } };
    const act = (f, unseen = f) => {
      if (!inside) wakeUp();
      if (log) log.push(unseen);
      if (stuck) return 0;
      try { return f(x); } catch (e) {
        if (!(e instanceof Missing)) throw e;
        stuck = true;
        more();
        return 0;
      }
    };
    const quietly = (f, unseen) => { inside = true; try { return act(f, unseen); } finally { inside = false; } };
    const complete = async () => {
      for (let anew = stuck; ; anew = stuck) {
        if (anew) part = await instance('testbed');
        await part.join();
        if (!anew && stuck) continue;                  // it was broken off meanwhile
        x = part.x;
        if (anew) for (const f of log) f(x);
        log = null; stuck = false;
        return;
      }
    };
    const more = () => rest || (rest = log ? complete() : Promise.resolve());
    const open = name => act(x => x.web_open(put(x, x.web_name(), name)));
    act(x => x.web_bring());
    if (scene) open(scene);
    // the game's card: 1 keep, 2 fetch, 3 hand to the reader; a simulation within a chapter is refused
    const keep = (name, bytes) => { let t = ''; bytes.forEach(b => { t += String.fromCharCode(b); }); localStorage.setItem(name, btoa(t)); };
    const fetched = (name, night) => {
      const kept = localStorage.getItem(name);
      if (kept === null) return null;
      let text = atob(kept);                           // light or dark is the page's choice, not the last visit's
      if (name === 'weft/settings.txt') text = text.replace(/^dark \d$/m, 'dark ' + (night ? 1 : 0));
      return Uint8Array.from(text, c => c.charCodeAt(0));
    };
    const handOut = (bytes, name) => {
      const a = document.createElement('a');
      a.href = URL.createObjectURL(new Blob([bytes])); a.download = name; a.click();
      setTimeout(() => URL.revokeObjectURL(a.href), 10000);
    };
    const grant = night => {
      const wish = stuck ? 0 : x.web_wish();
      if (!wish) return;
      const name = word(x.web_file_name());
      const bytes = new Uint8Array(x.memory.buffer, x.web_file_bytes(), x.web_file_size()).slice();
      let came = null;
      try {
        if (!options.whole) came = null;
        else if (game.own && (came = game.own(wish, name, bytes))) { /* address.js has it */ }
        else if (wish === 1) { keep('weft/' + name, bytes); came = bytes; }
        else if (wish === 2) came = fetched('weft/' + name, night);
        else { handOut(bytes, name); came = bytes; }
      } catch (e) { came = null; }                     // a full store, or one that is switched off
      act(x => {
        if (came && wish === 2) new Uint8Array(x.memory.buffer, x.web_file_bytes(), came.length).set(came);
        x.web_grant(came ? 1 : -1, came ? came.length : 0);
      });
    };
    const frame = (seconds, steps) => { inside = true; try { draw(seconds, steps); } finally { inside = false; } };
    const draw = (seconds, steps) => {
      // two pixels to a unit at most: the letters are baked for one and two, and a telephone has no time for three
      const scale = Math.max(1, Math.min(2, devicePixelRatio || 1)), box = canvas.getBoundingClientRect(), bare = !options.whole && (game.bare || box.width < 560);
      if (looks !== (looks = `${finger}${bare}`)) { const f = finger; act(x => x.web_looks(f ? 1 : 0, bare ? 1 : 0)); }
      const w = Math.max(64, Math.round(box.width * scale)), h = Math.max(64, Math.round(box.height * scale));
      const night = document.documentElement.dataset.theme === 'dark';
      if (night !== dark) { if (dark !== null || night) act(x => x.web_key(146)); dark = night; }
      if (log && log.length > MOST_TOLD) more();
      const at = act(x => x.web_frame(w, h, scale, seconds, steps), x => x.web_unseen(w, h, scale, seconds, steps));
      if (!at) return;
      if (canvas.width !== w || canvas.height !== h) { canvas.width = w; canvas.height = h; }
      frames++;
      idle = x.web_still();
      if (options.whole && dark !== !!x.web_dark()) {  // Dark was pressed in the picture: the page goes along
        dark = !dark;
        document.documentElement.dataset.theme = dark ? 'dark' : 'light';
      }
      const cursor = ['', 'pointer', 'grab', 'crosshair'][x.web_cursor()] || '';
      if (canvas.style.cursor !== cursor) canvas.style.cursor = cursor;
      pen.putImageData(new ImageData(new Uint8ClampedArray(x.memory.buffer, at, 4 * w * h), w, h), 0, 0);
      grant(night);
      const wanted = reading || stuck ? 0 : x.web_wanted();
      if (wanted) read(word(wanted));
    };
    const word = at => { const letters = new Uint8Array(x.memory.buffer, at, 40); return words.decode(letters.slice(0, letters.indexOf(0))); };
    const read = async name => {
      reading = true;
      const [world, info] = await readScene(name).catch(() => [[], []]);
      reading = false;
      if (word(x.web_wanted()) !== name || !take(world, info)) return;   // another one is wanted by now
      if (!game.describe().startsWith(`scene ${name}\n`)) open(name);   // its world is there if it was loaded
    };
    const take = (world, info) => act(x => {
      const fits = world.length <= x.web_came_room();
      if (fits) new Uint8Array(x.memory.buffer, x.web_came_bytes(), world.length).set(world);
      if (fits) new Uint8Array(x.memory.buffer, x.web_came_info(), info.length).set(info);
      return x.web_came(fits ? world.length : 0);
    });
    const tick = now => {
      if (!on) return;
      if (idle) { waits = true; return; }              // the picture stays as it is until something happens
      frame(last ? Math.min(0.25, (now - last) / 1000) : 0, -1);
      last = now;
      requestAnimationFrame(tick);
    };
    const place = e => {
      const r = canvas.getBoundingClientRect();
      const at = [(e.clientX - r.left) / r.width * canvas.width, (e.clientY - r.top) / r.height * canvas.height];
      act(x => x.web_mouse(...at));
    };
    const bit = e => e.button === 2 ? 4 : e.button === 1 ? 2 : 1;
    const apart = () => {
      const [a, b] = [...touches.values()];
      return { clientX: (a.clientX + b.clientX) / 2, clientY: (a.clientY + b.clientY) / 2, d: Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY) };
    };
    canvas.addEventListener('pointerdown', e => {
      finger = e.pointerType === 'touch';
      canvas.focus({ preventScroll: true }); canvas.setPointerCapture(e.pointerId); touches.set(e.pointerId, e);
      if (touches.size === 1) place(e);                // a second finger ends the first one's pull where that is
      if (options.whole) more();
      const [which, down] = touches.size === 1 ? [bit(e), 1] : [1, 0];
      act(x => x.web_button(which, down));
      pinch = touches.size === 2 ? apart() : null;
      e.preventDefault();
    });
    canvas.addEventListener('pointermove', e => {
      if (e.pointerType !== 'touch') finger = false;
      if (touches.has(e.pointerId)) touches.set(e.pointerId, e);
      if (touches.size < 2) { place(e); return; }
      // two fingers: what is between them moves with them, and grows as they part (1.15 for a notch)
      const k = canvas.width / canvas.getBoundingClientRect().width, now = apart(), was = pinch;
      pinch = now;
      if (!was || !was.d || !now.d) return;
      place(now);
      act(x => x.web_pan(k * (now.clientX - was.clientX), k * (now.clientY - was.clientY)));
      act(x => x.web_wheel(Math.log(now.d / was.d) / Math.log(1.15)));
    });
    // letters for a finger: a field that nobody sees, so that the keyboard comes up; it wants to be focused while the finger's event lasts
    const type = () => {
      frame(0, 0);
      const wanted = finger && !stuck && x.web_letters();
      if (wanted && !letters) {
        letters = document.createElement('input');
        letters.className = 'letters'; letters.autocapitalize = 'off'; letters.autocomplete = 'off'; letters.setAttribute('aria-label', 'letters for the testbed');
        letters.oninput = e => {
          if (e.inputType === 'deleteContentBackward') act(x => x.web_key(8));
          else for (const c of e.data || '') if (c >= ' ' && c < '\x7f') { const k = c.charCodeAt(0); act(x => x.web_key(k)); }
          letters.value = ' ';
        };
        letters.onkeydown = e => { const k = { Enter: 13, Escape: 27 }[e.key]; if (k) { e.preventDefault(); act(x => x.web_key(k)); setTimeout(type, 100); } };
        canvas.after(letters);
      }
      if (wanted) { letters.value = ' '; letters.focus({ preventScroll: true }); }
      else if (letters && document.activeElement === letters) canvas.focus({ preventScroll: true });
    };
    const up = e => {
      const which = bit(e);
      if (touches.size < 2 && e.type !== 'pointercancel') place(e);
      touches.delete(e.pointerId); pinch = null;
      act(x => x.web_button(which, 0));
      if (options.whole && finger) type();
    };
    canvas.addEventListener('pointerup', up);
    canvas.addEventListener('pointercancel', up);
    canvas.addEventListener('contextmenu', e => e.preventDefault());
    canvas.addEventListener('wheel', e => {
      if (!options.whole && document.activeElement !== canvas) return;   // the page scrolls until the picture was clicked
      e.preventDefault();
      // a touch pad pinches by a wheel with Ctrl, whose distance is a hundredth of the logarithm
      const notches = e.ctrlKey && !e.deltaMode && Math.abs(e.deltaY) < 50 ? -e.deltaY / 100 / Math.log(1.15) : -e.deltaY / (e.deltaMode ? 3 : 100);
      act(x => x.web_wheel(notches));
    }, { passive: false });
    canvas.addEventListener('keydown', e => {
      const k = e.altKey ? 0 : e.ctrlKey || e.metaKey ? { z: 136, Z: 137, y: 137, a: 138, c: 139, v: 140, d: 141, s: 142, o: 143 }[e.key] || 0 : keyOf(e);
      if (!k || k === 9) return;                       // Tab goes on to the next thing of the page
      if (k === 27 && !options.whole) { canvas.blur(); return; }
      e.preventDefault();
      more();
      act(x => x.web_key(k));
    });
    canvas.addEventListener('keyup', e => { const k = keyOf(e); if (k) act(x => x.web_key_up(k)); });
    canvas.addEventListener('blur', () => { if (!log) act(x => x.web_key_up(0)); });
    const game = {
      frame, open, more, act, handOut, put, word, take, readScene,
      json: () => instance('json'),
      parts: () => log ? 1 : 2,
      frames: () => frames,
      key: k => act(x => x.web_key(k)),
      click(px, py) {
        act(x => x.web_mouse(px, py));
        act(x => x.web_button(1, 1));
        act(x => x.web_button(1, 0));
      },
      say: what => quietly(x => words.decode(new Uint8Array(x.memory.buffer, x.web_name(), x[what]())), () => 0) || '',
      set: (name, value) => act(x => x.web_set(put(x, x.web_name(), name), value)),
      describe: () => game.say('web_describe'),
      run() { if (!on) { on = true; idle = waits = false; last = 0; requestAnimationFrame(tick); } },
      stop() { on = false; },
      running: () => on,
    };
    if (options.whole) addEventListener('beforeunload', e => { if (quietly(x => x.web_work(), () => 0)) e.preventDefault(); });
    new ResizeObserver(wakeUp).observe(canvas);
    new MutationObserver(wakeUp).observe(document.documentElement, { attributes: true, attributeFilter: ['data-theme'] });
    canvas.game = game;
    if (navigator.maxTouchPoints) bring('fingers.js');
    return game;
  };
  const makeScene = figure => {
    const pic = figure.querySelector('.pic'), frozen = pic.firstElementChild;
    let canvas = null, game = null, wanted = false;
    // The world stays as large as in the frozen picture, and where it is: what the bars around it take is added to the canvas.
    const measure = () => {
      game.frame(0, 0);
      const told = game.describe(), k = canvas.width / canvas.getBoundingClientRect().width;
      const [a, ...rest] = [...told.matchAll(/^body \d+ x (\S+) y (\S+) pixel (\S+) (\S+)$/mg)].map(m => m.slice(1).map(Number));
      const apart = (b, i) => Math.hypot(b[i] - a[i], b[i + 1] - a[i + 1]);
      const b = rest.reduce((far, b) => apart(b, 0) > apart(far, 0) ? b : far, a);
      return b !== a && { room: apart(b, 2) / apart(b, 0) / k * told.match(/^view \S+ \S+ (\S+)$/m)[1], top: a[3] / k };
    };
    const keepSize = async box => {
      game.bare = true;
      game.frame(0, 0);
      if (!game.describe()) await game.more();         // the scene is in the rest
      const was = measure();
      game.bare = false;
      let now = measure(), high = canvas.getBoundingClientRect().height;
      for (let i = 0; i < 2 && was && now && was.room > now.room + 1; i++, now = measure()) canvas.style.aspectRatio = box.width + '/' + (high += was.room - now.room);
      if (was && now) scrollBy({ top: now.top - was.top, behavior: 'instant' });
    };
    const start = async () => {
      if (!canvas) {
        const box = frozen.getBoundingClientRect();
        canvas = document.createElement('canvas');
        canvas.tabIndex = 0;
        canvas.setAttribute('role', 'application');
        canvas.setAttribute('aria-label', 'simulation ' + figure.dataset.scene + ': P pauses, O makes one step, R begins again, ? shows all keys, Escape leaves');
        canvas.style.aspectRatio = box.width + '/' + Math.max(box.height, 0.56 * box.width);
        frozen.hidden = true;
        frozen.style.display = 'none';
        pic.append(canvas);
        game = await makeGame(canvas, figure.dataset.scene);
        await keepSize(box);
        running.push(figure);
        if (running.length > 3) running.shift().liveEnd();
      }
      wanted = true;
      if (game) game.run();
    };
    const play = button('Run it', 'run this simulation here', () => {
      if (wanted) { wanted = false; if (game) game.stop(); } else start();
      wanted || !game ? play.say('Pause', 'it runs') : play.say('Go on', 'it stands');
    });
    const reset = button('Reset', 'begin again', () => { if (game) { game.open(figure.dataset.scene); game.key(104); game.frame(0, 0); } });   // H: the view, too
    figure.liveEnd = () => {
      wanted = false;
      if (game) game.stop();
      if (canvas) canvas.remove();
      canvas = game = null;
      frozen.hidden = false;
      frozen.style.display = '';
      play.say('Run it', 'run this simulation here');
    };
    figure.liveSeen = is => { if (game) { if (is && wanted) game.run(); else game.stop(); } };
    const whole = document.createElement('a');
    whole.href = 'testbed.html#' + encodeURIComponent(figure.dataset.scene);
    whole.textContent = 'open in the testbed';
    bar(figure, play, reset, whole);
    figure.classList.add('live');
  };

  // -- what is scrolled to wakes up, what is out of view rests
  const wake = figure => {
    if (figure.liveMade) return;
    figure.liveMade = true;
    if (figure.dataset.live) makeFigure(figure).catch(e => { figure.dataset.liveError = e.message; });
    else makeScene(figure);
  };
  const begin = () => {
    const all = document.querySelectorAll('figure[data-live], figure[data-scene]');
    if (!('WebAssembly' in window) || !('IntersectionObserver' in window)) return;
    const watch = new IntersectionObserver(list => {
      for (const e of list) {
        if (e.isIntersecting) wake(e.target);
        if (e.target.liveSeen) e.target.liveSeen(e.isIntersecting);
      }
    }, { rootMargin: '200px 0px' });
    all.forEach(f => watch.observe(f));
    const whole = document.getElementById('testbed');
    if (whole) {
      const hash = location.hash.slice(1);
      // an address that was cut in the middle of a letter is no reason for an empty page
      const plain = text => { try { return decodeURIComponent(text); } catch (e) { return text; } };
      makeGame(whole, plain(hash.replace(/^scene=/, '').replace(/&.*/, '')), { whole: true }).then(game => {
        game.plain = plain;
        if (matchMedia('(prefers-reduced-motion: reduce)').matches) game.key(112);      // it begins paused
        game.run();
        whole.focus();
        ['spoken.js', 'address.js'].forEach(bring);
      });
    }
  };
  if (document.readyState === 'loading') document.addEventListener('DOMContentLoaded', begin); else begin();
})();
