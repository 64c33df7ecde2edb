// For ears and for other hands: each widget of the testbed's canvas as a button with its name, and what happens as a line that is read out.
// Tab passes them by, since the canvas has keys for all of it; a reader of the screen finds them behind the canvas.
(() => {
  'use strict';
  const canvas = document.getElementById('testbed'), bar = document.createElement('div'), told = document.createElement('p');
  bar.setAttribute('role', 'toolbar'); bar.setAttribute('aria-label', 'controls of the testbed');
  told.setAttribute('role', 'status'); told.setAttribute('aria-live', 'polite');
  bar.className = told.className = 'spoken';
  canvas.after(bar, told);
  let names = '', at = {};
  const look = () => {
    if (document.hidden) return;
    const text = canvas.game.describe(), fact = label => (text.match(new RegExp(`^${label} (.*)$`, 'm')) || ['', ''])[1];
    at = {};
    for (const [, name, x, y] of text.matchAll(/^widget (.*) pixel (\S+) (\S+)$/mg)) at[name] = [+x, +y];
    const now = Object.keys(at).join('|');
    if (now !== names) {
      names = now;
      bar.replaceChildren(...Object.keys(at).map(name => {
        const b = document.createElement('button');
        b.type = 'button'; b.tabIndex = -1;
        b.textContent = name.replace(/([a-z])([A-Z])/g, (_, a, c) => a + ' ' + c.toLowerCase()).replace(/\.(?=[xy]$)/, ' ');
        b.onclick = () => { if (at[name]) canvas.game.click(...at[name]); };
        return b;
      }));
    }
    const news = `${fact('scene')}, ${fact('paused') === '1' ? 'paused' : 'running'}${fact('said') ? ': ' + fact('said') : ''}`;
    if (told.textContent !== news) told.textContent = news;
  };
  // soon after whoever is at the controls has done something, and four times a second. A line that is there when it is first seen is not read
  // out, so the first one comes a moment later.
  const soon = () => { for (const wait of [50, 150]) setTimeout(look, wait); };
  setTimeout(look, 100);
  for (const type of ['keydown', 'pointerup', 'click']) document.addEventListener(type, soon, true);
  setInterval(look, 250);
})();
