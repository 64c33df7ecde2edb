// The controls of a scene that is driven, for more than one finger and for a device that is tilted. Both hold keys, as a keyboard does.
// A finger that comes down on a button holds its key, and may slide on to the next one; all other fingers are the testbed's.
(() => {
  'use strict';
  const KEYS = [[1, 128], [2, 129], [4, 130], [8, 131], [16, 13]], fingers = new Map(), hands = new Map();
  // where the buttons are: a line of the game's facts
  const rowOf = canvas => {
    const told = canvas.game.describe().match(/^controls (\d+) \d+ pixel (.*) apart (.*)$/m);
    if (!told) return null;
    const [x, y, w, h, gap, near, apart] = (told[2] + ' ' + told[3]).split(' ').map(Number);
    return { bits: KEYS.map(k => k[0]).filter(bit => told[1] & bit), x, y, w, h, gap, near, apart };
  };
  const density = canvas => canvas.width / canvas.getBoundingClientRect().width;
  const under = (canvas, row, e) => {
    const box = canvas.getBoundingClientRect(), k = density(canvas), x = k * (e.clientX - box.left) - row.x, y = k * (e.clientY - box.top) - row.y;
    const i = row.bits.findIndex((bit, i) => { const from = i * (row.w + row.gap) + (i < row.near ? 0 : row.apart); return x >= from && x < from + row.w; });
    return y >= 0 && y < row.h && row.bits[i] || 0;
  };
  // what fingers and tilt hold together, against what the game was told
  const hand = canvas => hands.get(canvas) || hands.set(canvas, { told: 0, tilt: 0, on: false, level: null, pairs: 0, button: null }).get(canvas);
  const tell = canvas => {
    const my = hand(canvas);
    let now = my.tilt;
    for (const f of fingers.values()) if (f.canvas === canvas) now |= f.bit;
    for (const [bit, key] of KEYS) {
      if (now & ~my.told & bit) canvas.game.key(key);
      if (~now & my.told & bit) canvas.game.act(x => x.web_key_up(key));
    }
    my.told = now;
  };
  const listen = (type, f) => document.addEventListener(type, f, true);
  listen('pointerdown', e => {
    const canvas = e.target;
    if (e.pointerType !== 'touch' || !canvas.game) return;
    const row = rowOf(canvas), bit = row && under(canvas, row, e);
    if (!bit) return;
    e.stopPropagation(); e.preventDefault();
    canvas.focus({ preventScroll: true }); canvas.setPointerCapture(e.pointerId);
    fingers.set(e.pointerId, { canvas, row, bit });
    tell(canvas);
  });
  listen('pointermove', e => {
    const f = fingers.get(e.pointerId);
    if (!f) return;
    e.stopPropagation();
    f.bit = under(f.canvas, f.row, e) || f.bit;
    tell(f.canvas);
  });
  const up = e => {
    const f = fingers.get(e.pointerId);
    if (!f) return;
    e.stopPropagation();
    fingers.delete(e.pointerId);
    tell(f.canvas);
  };
  listen('pointerup', up);
  listen('pointercancel', up);
  // a canvas that loses the keys has let them go (live.js)
  listen('blur', e => {
    if (!hands.has(e.target)) return;
    for (const [id, f] of fingers) if (f.canvas === e.target) fingers.delete(id);
    hand(e.target).told = 0;
  });

  // Within a page one finger on empty ground is the page's, which scrolls; on a body it is the simulation's, and so are two fingers.
  document.addEventListener('touchstart', e => {
    const canvas = e.target, game = canvas.game;
    if (!game || canvas.id === 'testbed') return;
    game.frame(0, 0);
    if (e.targetTouches.length === 1 && game.act(x => x.web_cursor()) === 2 && /^held -1$/m.test(game.describe())) game.act(x => x.web_button(1, 0));
    else e.preventDefault();
  }, { passive: false });
  // Names for who has fingers: no keys, and the field for letters is called as what is typed into it.
  const call = e => {
    const whole = document.getElementById('testbed'), name = text => e.setAttribute('aria-label', text);
    if (e.className === 'letters') {
      const field = (whole.game.describe().match(/^edits (.*)$/m) || [])[1];
      e.inputMode = field ? 'decimal' : 'text';
      name(field || 'find a scene');
    } else if (e.game && matchMedia('(pointer: coarse)').matches)
      name(e === whole ? 'The testbed. Drag bodies; two fingers move the view. Its buttons follow.' : e.getAttribute('aria-label').replace(/:.*/, ': drag bodies; two fingers move the view'));
  };
  listen('focusin', e => call(e.target));
  document.querySelectorAll('canvas').forEach(call);

  // -- tilt: left and right, and up and down, where the scene has words for both. Held beyond 12 degrees, let go below 7.
  const PAIRS = [1 | 2, 4 | 8], MOST = 12, LEAST = 7, ask = () => DeviceOrientationEvent.requestPermission ? DeviceOrientationEvent.requestPermission() : 'granted';
  let senses = false;                                  // the sensor has spoken, or its browser wants a finger to ask for it
  // how far the screen's right edge is below its left one, and how steeply it stands: degrees
  const leaning = e => {
    const rad = Math.PI / 180, b = e.beta * rad, g = e.gamma * rad, a = (screen.orientation ? screen.orientation.angle : window.orientation || 0) * rad;
    const x = Math.cos(b) * Math.sin(g), y = -Math.sin(b), z = -Math.cos(b) * Math.cos(g);       // which way is down, in the device's frame
    const right = x * Math.cos(a) - y * Math.sin(a), top = x * Math.sin(a) + y * Math.cos(a);
    return [Math.asin(Math.max(-1, Math.min(1, right))) / rad, Math.atan2(-top, -z) / rad];
  };
  const beyond = (held, bit, angle) => angle > MOST ? held | bit : angle < LEAST ? held & ~bit : held;
  const turned = e => {
    if (e.beta === null || e.gamma === null) return;
    if (!senses) { senses = true; look(); }
    const [roll, pitch] = leaning(e);
    for (const canvas of document.querySelectorAll('canvas')) {
      const my = hands.get(canvas);
      if (!my || !my.on) continue;
      if (my.level === null) my.level = pitch;         // as it is held now is level
      const away = (my.level - pitch + 540) % 360 - 180;
      my.tilt = [[2, roll], [1, -roll], [4, away], [8, -away]].reduce((held, [bit, angle]) => beyond(held, bit, angle), my.tilt) & my.pairs;
      tell(canvas);
    }
  };
  const press = async (canvas, my) => {
    if (!my.on && await ask() !== 'granted') return;
    my.on = !my.on; my.level = null; my.tilt = 0;
    my.button.setAttribute('aria-pressed', my.on);
    canvas.focus({ preventScroll: true });
    tell(canvas);
  };
  const look = () => {
    for (const [canvas, my] of hands) if (!canvas.isConnected) { if (my.button) my.button.remove(); hands.delete(canvas); }
    for (const canvas of document.querySelectorAll('canvas')) {
      if (!canvas.game || !senses || document.hidden) continue;
      const my = hand(canvas), row = rowOf(canvas), all = row ? row.bits.reduce((a, b) => a | b, 0) : 0;
      my.pairs = PAIRS.reduce((pairs, pair) => (all & pair) === pair ? pairs | pair : pairs, 0);
      if (my.button) my.button.hidden = !my.pairs;
      if (!my.pairs) { if (my.tilt) { my.tilt = 0; tell(canvas); } continue; }
      if (!my.button) {
        my.button = Object.assign(document.createElement('button'), { type: 'button', className: 'tilt', textContent: 'Tilt', title: 'drive by tilting the device' });
        my.button.setAttribute('aria-pressed', false);
        my.button.onclick = () => press(canvas, my);
        canvas.after(my.button);
      }
      const k = density(canvas);
      my.button.style.left = canvas.offsetLeft + canvas.clientWidth - my.button.offsetWidth - 8 + 'px';
      my.button.style.top = canvas.offsetTop + row.y / k - my.button.offsetHeight - 8 + 'px';
    }
  };
  addEventListener('deviceorientation', turned);
  if (!window.DeviceOrientationEvent) return;
  setInterval(look, 1000);
  (async () => ask())().catch(() => { senses = true; });
})();
