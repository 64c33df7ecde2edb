// Weft's pages: theme, contents on narrow screens, search, previews, chunks opened in place. Works from file://.
(() => {
  'use strict';
  const root = document.documentElement, $ = id => document.getElementById(id);
  const here = decodeURIComponent(location.pathname.split('/').pop()) || 'index.html';
  const escape = s => s.replace(/[&<>"]/g, c => ({ '&': '&amp;', '<': '&lt;', '>': '&gt;', '"': '&quot;' }[c]));

  // -- light and dark: the system's choice until the reader makes one
  const dark = matchMedia('(prefers-color-scheme: dark)');
  let chosen = null;
  try { chosen = localStorage.getItem('weft-theme'); } catch (e) { /* no storage: the choice lasts for this page */ }
  const show = () => { root.dataset.theme = chosen || (dark.matches ? 'dark' : 'light'); };
  dark.addEventListener('change', show);
  show();
  $('theme').onclick = () => {
    chosen = root.dataset.theme === 'dark' ? 'light' : 'dark';
    try { localStorage.setItem('weft-theme', chosen); } catch (e) { /* as above */ }
    show();
  };

  // -- a formula that is a little wider than its column is set smaller; what is still wider than the page can be scrolled by keys, too
  document.fonts.ready.then(() => {
    const wide = [...document.querySelectorAll('.eqm math')].map(m => [m, m.clientWidth / m.scrollWidth]).filter(x => x[1] < 1);
    for (const [m, share] of wide) m.style.fontSize = 1.03 * Math.max(0.82, 0.99 * share) + 'em';
    for (const e of document.querySelectorAll('.eqm, .eqm math, main math[display="block"], .tbl, pre')) if (e.scrollWidth > e.clientWidth + 1) e.tabIndex = 0;
  });

  // -- contents
  const drawer = open => $('menu').setAttribute('aria-expanded', document.body.classList.toggle('menu', open));
  $('menu').onclick = () => drawer();
  document.addEventListener('click', e => {             // what lies beside the open drawer is covered: a tap there closes it
    if (document.body.matches('.menu') && (e.target.closest('#toc a') || !e.target.closest('#toc, #menu'))) drawer(false);
  });
  const current = document.querySelector('#toc .here');
  if (current) $('toc').scrollTop = Math.max(0, current.offsetTop - 120);
  const links = new Map([...document.querySelectorAll('#toc .here ol a')].map(a => [a.hash.slice(1), a]));
  if (links.size && 'IntersectionObserver' in window) {
    const seen = new IntersectionObserver(list => {
      for (const x of list) if (x.isIntersecting) {
        links.forEach(a => a.classList.remove('on'));
        const a = links.get(x.target.id);
        if (a) a.classList.add('on');
      }
    }, { rootMargin: '-60px 0px -70% 0px' });
    document.querySelectorAll('main h2[id]').forEach(h => seen.observe(h));
  }

  // -- scripts of data, loaded when first needed (fetch does not work from file://)
  const pages = {}, waiting = {};
  let pieces = {};
  let index = null;
  const load = (src, key) => waiting[key] || (waiting[key] = new Promise(done => {
    const s = document.createElement('script');
    s.src = src;
    s.onload = s.onerror = () => done();
    document.head.append(s);
  }));
  window.WEFT = {
    add(page, chunks) { pages[page] = chunks; },
    pieces(all) { pieces = all; },
    index(names, rows) { index = { names, rows, titles: new Map(rows.filter(r => r[0] === 'sec').map(r => [r[2] + '#' + r[3], r[1]])), lower: rows.map(r => (r[1] + ' ' + (r[4] || '')).toLowerCase()) }; },
  };

  // -- search: every word must occur; titles count more than text, beginnings more than middles, a whole title (less its number) most.
  // Names that are no part of the interface come behind the text, unless what is looked for can only be a name.
  const weight = { ident: 9, sec: 8, gloss: 7, chunk: 6, eq: 6, fig: 5, ex: 4, file: 6, text: 1, private: 0 };
  const kinds = { ident: 'identifier', private: 'internal', sec: 'section', gloss: 'glossary', chunk: 'chunk', eq: 'equation', fig: 'figure', ex: 'exercise', file: 'file', text: 'text' };
  const find = query => {
    const words = query.toLowerCase().split(/\s+/).filter(Boolean), found = [];
    if (!index || !words.length) return found;
    const name = /_|[a-z][A-Z]/.test(query);
    index.rows.forEach((r, i) => {
      const all = index.lower[i], full = r[1].toLowerCase(), title = r[0] === 'sec' ? full.replace(/^\S* /, '') : full;
      let score = name ? weight[r[0]] : r[0] === 'private' ? -100 : r[0] === 'ident' ? 4 : weight[r[0]];
      for (const w of words) {
        if (!all.includes(w)) return;
        const at = full.startsWith(w) ? 0 : title.indexOf(w);
        score += title === w || title === 'wf' + w ? 30 : at === 0 ? 12 : at > 0 && /[^a-z0-9]/.test(title[at - 1]) ? 9 : at > 0 ? 5 : 0;
        if (at < 0 && r[0] === 'text') score += Math.min(3, all.split(w).length - 1);
      }
      found.push([score - title.length / 200, r]);
    });
    return found.sort((a, b) => b[0] - a[0]).slice(0, 40).map(x => x[1]);
  };
  const mark = (s, words) => {
    let t = escape(s);
    for (const w of words) t = t.replace(new RegExp(w.replace(/[.*+?^${}()|[\]\\&<>"]/g, '\\$&') + '(?![^&;]{0,6};)(?![^<]*>)', 'gi'), '<mark>$&</mark>');
    return t;
  };
  const snippet = (text, words) => {
    const at = Math.max(0, text.toLowerCase().indexOf(words[0]) - 60);
    return (at ? '\u2026' : '') + mark(text.slice(at, at + 180), words) + (text.length > at + 180 ? '\u2026' : '');
  };
  const q = $('q'), hits = $('hits');
  let chosenHit = -1;
  const search = async () => {
    const query = q.value.trim();
    if (!query) { hits.hidden = true; return; }
    await load('data/search.js', 'search');
    const words = query.toLowerCase().split(/\s+/).filter(Boolean);
    const found = find(query);
    hits.innerHTML = found.map(r => {
      const page = index.names[r[2]];
      const url = page + (r[0] === 'text' ? '?hl=' + encodeURIComponent(query) : '') + (r[3] ? '#' + r[3] : '');
      const where = r[0] === 'text' ? index.titles.get(r[2] + '#' + r[3]) || page.replace('.html', '') : r[1];
      return `<a href="${escape(url)}"><small>${kinds[r[0]] || r[0]}</small>${r[0] === 'text' ? escape(where) : mark(where, words)}` +
        (r[4] ? `<p>${snippet(r[4], words)}</p>` : '') + '</a>';
    }).join('') || '<div class="none">Nothing found.</div>';
    hits.hidden = false;
    chosenHit = -1;
  };
  q.addEventListener('input', search);
  q.addEventListener('focus', () => { if (q.value) search(); });
  q.addEventListener('keydown', e => {
    const all = [...hits.querySelectorAll('a')];
    if (e.key === 'ArrowDown' || e.key === 'ArrowUp') {
      e.preventDefault();
      chosenHit = Math.max(0, Math.min(all.length - 1, chosenHit + (e.key === 'ArrowDown' ? 1 : -1)));
      all.forEach((a, i) => a.classList.toggle('on', i === chosenHit));
      if (all[chosenHit]) all[chosenHit].scrollIntoView({ block: 'nearest' });
    } else if (e.key === 'Enter') {
      const a = all[Math.max(0, chosenHit)];
      if (a) { hits.hidden = true; a.click(); }
    } else if (e.key === 'Escape') { hits.hidden = true; q.blur(); }
  });
  document.addEventListener('click', e => { if (!e.target.closest('.find')) hits.hidden = true; });
  hits.addEventListener('click', e => { if (e.target.closest('a')) hits.hidden = true; });
  document.addEventListener('keydown', e => {
    if (e.key === '/' && !/^(INPUT|TEXTAREA)$/.test(document.activeElement.tagName)) { e.preventDefault(); q.focus(); q.select(); }
  });

  // -- words that a search led here are marked
  const words = (new URLSearchParams(location.search).get('hl') || '').toLowerCase().split(/\s+/).filter(w => w.length > 1);
  if (words.length) {
    const section = location.hash ? document.getElementById(decodeURIComponent(location.hash.slice(1))) : null;
    const from = section || document.querySelector('main');
    let first = null;
    for (const p of document.querySelectorAll('main p, main li, main figcaption, main td')) {
      if (section && !(from.compareDocumentPosition(p) & Node.DOCUMENT_POSITION_FOLLOWING)) continue;
      const text = p.textContent.toLowerCase();
      if (!words.every(w => text.includes(w))) continue;
      const walk = document.createTreeWalker(p, NodeFilter.SHOW_TEXT), nodes = [];
      while (walk.nextNode()) nodes.push(walk.currentNode);
      for (const n of nodes) {
        const at = words.map(w => [n.data.toLowerCase().indexOf(w), w.length]).find(x => x[0] >= 0);
        if (!at || n.parentElement.closest('math')) continue;
        const m = document.createElement('mark'), rest = n.splitText(at[0]);
        rest.splitText(at[1]);
        rest.replaceWith(m);
        m.append(rest);
      }
      first = p;
      break;
    }
    if (first) addEventListener('load', () => first.scrollIntoView({ block: 'center' }));
  }

  // -- what a link points at: on this page, or in the other page's script
  const written = new WeakMap();                      // code that is shown assembled: as it is written
  const target = async href => {
    const cut = href.indexOf('#');
    if (cut < 0) return null;
    const page = href.slice(0, cut) || here, id = decodeURIComponent(href.slice(cut + 1));
    if (page === here) {
      let e = document.getElementById(id);
      if (e && e.tagName === 'DFN') e = e.closest('.chunk');
      if (!e) return null;
      if (e.matches('.chunk')) return { chunk: e.querySelector('pre code'), num: e.querySelector('.num').textContent, html: '<figure class="chunk">' + e.querySelector('figcaption').outerHTML + e.querySelector('pre').outerHTML + '</figure>' };
      if (e.matches('.eq')) return { html: e.outerHTML };
      if (e.matches('.fig, .tbl')) return { html: e.innerHTML };
      return null;
    }
    await load('data/' + page.replace('.html', '.js'), page);
    let html = pages[page] && pages[page][id];
    if (!html && pages[page] && id.startsWith('d-')) html = Object.values(pages[page]).find(h => h.includes('<dfn id="' + id + '"'));
    if (!html) return null;
    const box = document.createElement('div');
    box.innerHTML = html;
    box.querySelectorAll('a[href^="#"]').forEach(x => x.setAttribute('href', page + x.getAttribute('href')));
    box.querySelectorAll('[id]').forEach(x => x.removeAttribute('id'));
    const code = box.querySelector('pre code');
    return { chunk: code, num: code ? box.querySelector('.num').textContent : '', html: code ? '<figure class="chunk">' + box.innerHTML + '</figure>' : box.innerHTML };
  };

  // -- preview on rest
  let pop = null, timer = 0;
  const close = () => { clearTimeout(timer); if (pop) { pop.remove(); pop = null; } };
  document.addEventListener('mouseover', e => {
    const a = e.target.closest && e.target.closest('main a.use, main a.cref, main a.xref.eq, main a.xref.fig, main a.xref.tbl, main a.id, main a.co');
    if (pop && e.target.closest('#pop')) { clearTimeout(timer); return; }
    clearTimeout(timer);
    if (!a) { if (pop) timer = setTimeout(close, 250); return; }
    timer = setTimeout(async () => {
      const t = await target(a.getAttribute('href') || '');
      if (!t || !a.matches(':hover')) return;
      close();
      pop = document.createElement('div');
      pop.id = 'pop';
      pop.innerHTML = t.html;
      pop.querySelectorAll('[id]').forEach(x => x.removeAttribute('id'));
      document.body.append(pop);
      const r = a.getBoundingClientRect(), w = pop.offsetWidth, h = pop.offsetHeight;
      const below = r.bottom + h + 12 < innerHeight || r.top < h + 12;
      pop.style.left = Math.max(8, Math.min(r.left, innerWidth - w - 8)) + scrollX + 'px';
      pop.style.top = (below ? r.bottom + 6 : r.top - h - 6) + scrollY + 'px';
    }, 380);
  });
  document.addEventListener('keydown', e => { if (e.key === 'Escape') { close(); drawer(false); } });

  // -- the code of a chunk, all its pieces one below the other, whichever of them is shown opened just now
  const whole = async href => {
    const cut = href.indexOf('#'), id = decodeURIComponent(href.slice(cut + 1));
    await load('data/pieces.js', 'pieces');
    const list = pieces[id] || [href.slice(0, cut) || here], texts = [];
    for (let i = 0; i < list.length; i++) {
      const at = (list[i] === here ? '' : list[i]) + '#' + id + (i ? '-' + (i + 1) : ''), t = await target(at);
      if (!t || !t.chunk) continue;
      const box = document.createElement('div');
      box.innerHTML = written.get(t.chunk) || t.chunk.innerHTML;
      box.querySelectorAll('.inl').forEach(x => x.remove());
      box.querySelectorAll('.open').forEach(x => x.classList.remove('open'));
      box.querySelectorAll('[id]').forEach(x => x.removeAttribute('id'));
      texts.push((list.length > 1 ? `<a class="piece" href="${escape(at)}">${escape(t.num)}</a>\n` : '') + box.innerHTML.replace(/\n$/, ''));
    }
    return texts.join('\n');
  };
  const unfold = async (a, deep) => {
    const code = await whole(a.getAttribute('href'));
    if (!code) return false;
    const s = document.createElement('span');
    s.className = 'inl';
    s.innerHTML = code;
    a.classList.add('open');
    a.after(s);
    if (deep) for (const u of s.querySelectorAll('a.use')) await unfold(u, true);
    return true;
  };
  document.addEventListener('click', async e => {
    const a = e.target.closest && e.target.closest('a.use, a.asm');
    if (!a) return;
    if (a.matches('.asm')) {                            // a chunk assembled, and again as it is written
      e.preventDefault();
      const code = a.closest('.chunk').querySelector('pre code');
      if (a.dataset.busy) return;
      if (written.has(code)) { code.innerHTML = written.get(code); written.delete(code); a.textContent = 'assembled'; return; }
      a.dataset.busy = 1;
      const text = await whole(a.getAttribute('href'));
      written.set(code, code.innerHTML);
      code.innerHTML = text + '\n';
      for (const u of code.querySelectorAll('a.use')) await unfold(u, true);
      a.textContent = 'as written';
      delete a.dataset.busy;
      return;
    }
    if (!(e.shiftKey || e.altKey)) return;              // a chunk opened in place: Shift-click, or Alt-click, on its name; again to close
    e.preventDefault();
    close();
    if (a.classList.contains('open')) { a.classList.remove('open'); a.nextElementSibling.remove(); return; }
    if (!await unfold(a, false)) location.href = a.href;
  });
})();
