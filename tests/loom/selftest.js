// Runs within a page, from file://: search, theme, preview, a chunk opened in place. Writes SELFTEST ok, or what failed.
(async () => {
  const say = t => { const p = document.createElement('p'); p.textContent = 'SELFTEST ' + t; document.body.append(p); };
  const wait = ms => new Promise(f => setTimeout(f, ms));
  const $ = id => document.getElementById(id);
  const done = [];
  try {
    await wait(300);
    const theme = document.documentElement.dataset.theme;
    $('theme').click();
    if (document.documentElement.dataset.theme === theme) throw 'the theme button';
    $('theme').click();
    done.push('theme');
    $('q').value = 'wfPoolPush';
    $('q').dispatchEvent(new Event('input'));
    await wait(1500);
    const first = document.querySelector('#hits a');
    if (!first || !first.textContent.includes('wfPoolPush') || !first.getAttribute('href').includes('#d-wfPoolPush')) throw 'search for an identifier: ' + (first && first.outerHTML);
    $('q').value = 'momentum body';
    $('q').dispatchEvent(new Event('input'));
    await wait(300);
    if (document.querySelectorAll('#hits a').length < 3) throw 'search in the text';
    // a word: text before names that are no part of the interface; a name that can be nothing else is found all the same
    let both = 0;
    for (const word of ['ladder', 'tilt', 'rouse', 'spring']) {
      $('q').value = word;
      $('q').dispatchEvent(new Event('input'));
      await wait(300);
      const kinds = [...document.querySelectorAll('#hits a small')].map(x => x.textContent), at = kinds.indexOf('internal');
      if (at >= 0 && kinds.includes('text')) both++;
      if (at >= 0 && kinds.slice(at).some(k => k !== 'internal')) throw 'search: names of files before the text for ' + word + ': ' + kinds.join(' ');
    }
    if (!both) throw 'search: no word that is in the text and in an internal name';
    $('q').value = 'push_softly';
    $('q').dispatchEvent(new Event('input'));
    await wait(300);
    if (!document.querySelector('#hits a') || !document.querySelector('#hits a').textContent.includes('push_softly')) throw 'search for an internal name';
    done.push('search');
    // a chunk of this page and one of another page, opened in place
    for (const far of [false, true]) {
      const a = [...document.querySelectorAll('.chunk a.use, .chunk footer a.cref')].find(x => x.matches('a.use') && x.getAttribute('href').startsWith('#') !== far);
      if (!a) continue;
      a.dispatchEvent(new MouseEvent('click', { bubbles: true, cancelable: true, shiftKey: true }));
      await wait(900);
      if (!a.nextElementSibling || !a.nextElementSibling.matches('.inl') || !a.nextElementSibling.textContent.trim()) throw 'a chunk in place' + (far ? ' from another page' : '');
      a.dispatchEvent(new MouseEvent('click', { bubbles: true, cancelable: true, shiftKey: true }));
      if (a.nextElementSibling && a.nextElementSibling.matches('.inl')) throw 'closing a chunk';
      done.push(far ? 'chunk of another page' : 'chunk of this page');
    }
    // a chunk with several pieces, assembled and as it was
    const asm = [...document.querySelectorAll('.chunk a.asm')].find(x => x.closest('.chunk').querySelector('a.use'));
    if (asm) {
      const code = asm.closest('.chunk').querySelector('pre code'), was = code.innerHTML;
      asm.click();
      for (let i = 0; i < 40 && asm.textContent === 'assembled'; i++) await wait(100);
      if (!code.querySelector('.inl') || code.querySelector('a.use:not(.open)')) throw 'a chunk assembled';
      asm.click();
      if (code.innerHTML !== was) throw 'an assembled chunk as it was written';
      done.push('assembled');
    }
    const more = [...document.querySelectorAll('.chunk a.asm')].find(x => x.closest('.chunk').querySelector('.pl'));
    if (more) {
      more.click();
      for (let i = 0; i < 40 && more.textContent === 'assembled'; i++) await wait(100);
      if (more.closest('.chunk').querySelectorAll('a.piece').length < 2) throw 'all pieces of a chunk';
      more.click();
      done.push('all pieces');
    }
    const scripts = new Set([...document.querySelectorAll('main a.cref, main a.id')].map(x => x.getAttribute('href').split('#')[0]).filter(Boolean));
    const other = [...scripts].find(p => /^[a-z-]+\.html$/.test(p));
    if (other) {
      const a = document.querySelector('main a.id[href^="' + other + '"], main a.cref[href^="' + other + '"]');
      const matches = a.matches.bind(a);
      a.matches = s => s === ':hover' || matches(s);
      a.dispatchEvent(new MouseEvent('mouseover', { bubbles: true }));
      await wait(1500);
      if (!$('pop') || !$('pop').textContent.trim()) throw 'the preview of a chunk in ' + other;
      done.push('preview of another page');
    }
    say('ok: ' + done.join(', '));
  } catch (e) { say('failed: ' + e + ' (after ' + done.join(', ') + ')'); }
})();
