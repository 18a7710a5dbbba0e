// The worlds in 3D with what plays them, and what the shown frame has cost.
import { h, readable } from './dom.js';
import { Motion } from './motion.js';
import { Views } from './views.js';
import { levelCss, WorldView } from './world_view.js';

const SPEEDS = [[1 / 16, '1/16'], [1 / 8, '1/8'], [1 / 4, '1/4'], [1 / 2, '1/2'], [1, '1'], [2, '2'], [4, '4']];

function captionOf(world) {
  const cost = h('span', { className: 'pane-cost' });
  const swatch = h('span', { className: 'swatch', style: `background:${world.color}` });
  return { cost, element: h('div', { className: 'pane-caption' }, swatch, h('b', {}, world.label), ' ', cost) };
}

function endOf(world, motion) {
  if (motion.stopped) return `ended at frame ${motion.last}: ${motion.stopped}`;
  return `ended at frame ${world.frames}`;
}

export function motionsOf(page) {
  return page.worlds.map((world) => (world.motion ? new Motion(world.motion) : null));
}

function button(text, title, onclick, className = '') {
  return h('button', { type: 'button', title, className, onclick }, text);
}

function checkbox(text, isChecked, change) {
  const box = h('input', { type: 'checkbox', checked: isChecked, onchange: () => change(box.checked) });
  return h('label', { className: 'choice' }, box, text);
}

function choice(text, options, chosen, change) {
  const select = h('select', { onchange: () => change(options[select.selectedIndex][0]) },
    ...options.map(([value, name]) => h('option', { selected: value === chosen }, name)));
  return h('label', { className: 'choice' }, text, select);
}

/** Play, scrub, slow motion, and frames worth a jump. */
export function transport(player, jumps) {
  const play = button('▶ Play', 'Space', () => player.toggle(), 'play');
  const slider = h('input', {
    type: 'range', min: 0, max: player.frames, step: 1, ariaLabel: 'Frame', oninput: () => player.seek(Number(slider.value)),
  });
  const time = h('output', { className: 'time' });
  const speeds = choice('Speed ', SPEEDS, 1, (speed) => player.setSpeed(speed));
  player.onChangeUnhurried(() => {
    play.textContent = player.isPlaying ? '❚❚ Pause' : '▶ Play';
    slider.value = player.shown;
    time.textContent = `frame ${Math.round(player.shown)} of ${player.frames}, ${(player.shown * player.stepSeconds).toFixed(2)} s`;
  });
  return h('div', { className: 'transport' },
    h('div', { className: 'row' }, play, button('−1', 'A frame back: ←', () => player.step(-1)),
      button('+1', 'A frame on: →', () => player.step(1)), slider),
    h('div', { className: 'row' }, time, speeds, ...jumps.map(([name, frame]) => button(name, `Frame ${frame}`, () => player.seek(frame)))));
}

/** Space and arrows, as long as nothing else on the page wants them. */
export function listenToKeys(player) {
  const keys = {
    ' ': () => player.toggle(),
    ArrowLeft: (event) => player.step(event.shiftKey ? -10 : -1),
    ArrowRight: (event) => player.step(event.shiftKey ? 10 : 1),
    Home: () => player.seek(0),
    End: () => player.seek(player.frames),
  };
  document.addEventListener('keydown', (event) => {
    const wanted = event.target.closest('input:not([type=checkbox]):not([type=range]), select, textarea, button, summary, a');
    if (event.ctrlKey || event.altKey || event.metaKey || !keys[event.key] || (wanted && event.key === ' ') ||
      event.target.matches('input[type=range], select')) return;
    event.preventDefault();
    keys[event.key](event);
  });
}

function mostLevels(motions) {
  return Math.max(1, ...motions.flatMap((motion) => motion.bodies.map((body) => body.levels)));
}

function legend(motions) {
  const levels = mostLevels(motions);
  if (levels === 1) return h('p', { className: 'legend' }, 'No body in this scene has levels of detail; colours tell kinds apart. Bodies that sleep are paler.');
  const chips = [];
  for (let level = levels; level >= 1; --level) {
    const name = level === levels ? `level ${level}, full detail` : level === 1 ? 'level 1, the coarsest' : `level ${level}`;
    chips.push(h('span', { className: 'chip' }, h('span', { className: 'swatch', style: `background:${levelCss(level, levels)}` }), name));
  }
  return h('p', { className: 'legend' }, ...chips,
    h('span', { className: 'chip' }, 'paler: asleep'), h('span', { className: 'chip' }, 'other colours: bodies without levels'),
    'A body has the colour of the coarsest level at which it meets, or may soon meet, another one.');
}

// The first frame in which the most kinetic energy is on its way to be lost: the crash.
export function impactFrame(page) {
  const energy = page.worlds[0].columns.get('kinetic_energy').values;
  let best = 0;
  for (let i = 1; i < energy.length; ++i) if (energy[i] > energy[best]) best = i;
  return best + 1;
}

function makeViews(panes, player, looks) {
  try {
    return new Views(panes, player, looks);
  } catch {
    return null;
  }
}

/** Fills `place`; returns the Views, or null if there is nothing to be played. */
export function makeStage(place, page, player, shapes) {
  const motions = motionsOf(page);
  const jumps = [['Start', 0], ['Most energy', impactFrame(page)], ['Dearest frame', page.peakFrame], ['End', player.frames]];
  const playable = motions.filter(Boolean);
  if (playable.length === 0) {
    place.append(h('p', {}, page.worlds[0].noMotion), transport(player, jumps));
    return null;
  }
  const captions = page.worlds.map(captionOf);
  const looks = { byLevel: true, sleep: true, collisionShapes: false, contacts: true };
  const panes = page.worlds.map((world, i) => ({
    view: motions[i] ? new WorldView(shapes, motions[i]) : null, caption: captions[i].element, note: world.noMotion,
  }));
  const views = makeViews(panes, player, looks);
  if (!views) {
    place.append(h('p', {}, 'The worlds cannot be shown in 3D, as this browser has no WebGL; all else works without it.'), transport(player, jumps));
    return null;
  }
  const redraw = (name) => (value) => {
    looks[name] = value;
    views.draw();
  };
  const follow = button('Follow the action', 'The camera goes where something happens', () => views.follow(true));
  follow.disabled = true;
  views.onFollow = (follows) => {
    follow.disabled = follows;
  };
  player.onChangeUnhurried(() => {
    page.worlds.forEach((world, i) => {
      const ended = motions[i] && player.shown > motions[i].last;
      const ms = world.columns.get('physics_cpu_ms').values[player.row - 1];
      captions[i].cost.textContent = ended ? endOf(world, motions[i]) : player.shown < 1 || ms === undefined ? '' : `${readable(ms)} ms`;
    });
  });
  views.element.classList.add(page.worlds.length === 1 ? 'one' : page.worlds.length > 2 ? 'many' : 'two');
  place.append(views.element, transport(player, jumps), h('div', { className: 'row looks' },
    page.worlds.length > 1 ? page.worlds.map((world, i) => checkbox(world.label, true, (shown) => views.showPane(i, shown))) : [],
    mostLevels(playable) === 1 ? null : choice('Colours ', [[true, 'levels'], [false, 'kinds of bodies']], true, redraw('byLevel')),
    choice('Shapes ', [[false, 'as they look'], [true, 'as they collide']], false, redraw('collisionShapes')),
    playable.some((motion) => motion.hasContacts) ? checkbox('contacts', true, redraw('contacts')) : null,
    button('Nearer', 'Also, after a click into the picture: the wheel', () => views.zoom(1.4)), button('Farther', 'Also, after a click into the picture: the wheel', () => views.zoom(1 / 1.4)), follow),
  legend(playable), h('p', { className: 'hint' }, hintOf(page, playable)));
  return views;
}

function hintOf(page, motions) {
  const notes = ['Drag turns the camera, the right button moves sideways, after a click the wheel goes nearer. Keys: space plays and pauses, ← and → go a frame on or back, with shift ten. All views, plots and tables show the same frame.'];
  const step = Math.max(...motions.map((motion) => motion.step));
  if (step > 1) notes.push(`Of this long run one frame of ${step} is in the page; between them bodies move evenly.`);
  if (page.repeat > 1) {
    const clocked = page.worlds.filter((world) => world.byClock && world.typicalRepeat !== 1).map((world) => world.label);
    if (clocked.length > 0) {
      notes.push(`Seen is the first of ${page.repeat} repeats. Of ${clocked.join(' and ')}, which the clock governs, no two are the same, and the counts below are another repeat's.`);
    }
  }
  return notes.join(' ');
}
