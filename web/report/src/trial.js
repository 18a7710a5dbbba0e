// The blind trial: two worlds without names, and the reader says which is which. Nothing is stored or sent.
import { h } from './dom.js';
import { impactFrame, motionsOf } from './stage.js';
import { Player } from './player.js';
import { Views } from './views.js';
import { WorldView } from './world_view.js';

const ROUNDS = 8;
const STRETCH = 240;  // frames

/** How likely somebody who guesses is right so often or more. */
export function chanceOfAtLeast(right, rounds) {
  let sum = 0;
  let ways = 1;
  for (let k = 0; k <= rounds; ++k) {
    if (k >= right) sum += ways;
    ways = (ways * (rounds - k)) / (k + 1);
  }
  return sum / 2 ** rounds;
}

/** What is asked and what was answered. `random` gives numbers from 0 to 1. */
export class Trial {
  constructor(page, random = Math.random) {
    const impact = impactFrame(page);
    const last = Math.max(0, Math.min(page.worlds[0].frames, page.worlds.at(-1).frames) - STRETCH);
    this.rounds = Array.from({ length: ROUNDS }, () => {
      const start = Math.round(impact - STRETCH / 2 + (random() - 0.3) * 2 * STRETCH);
      return { swapped: random() < 0.5, start: Math.min(Math.max(start, 0), last), answer: null };
    });
  }

  get current() {
    return this.rounds.find((round) => round.answer === null) ?? null;
  }

  get answered() {
    return this.rounds.filter((round) => round.answer !== null);
  }

  /** `side`: 0 if the reader takes the first world to be on the left, else 1. */
  answer(side) {
    this.current.answer = side;
  }

  get right() {
    return this.answered.filter(({ swapped, answer }) => (answer === 1) === swapped).length;
  }

  result() {
    const { right } = this;
    const rounds = this.answered.length;
    const percent = Math.round(100 * chanceOfAtLeast(right, rounds));
    return `You were right ${right} ${right === 1 ? 'time' : 'times'} of ${rounds}. Somebody who guesses is right ` +
      `${rounds / 2} times of ${rounds} on average, and ${right} times or more in ${percent} % of all trials.`;
  }
}

class TrialView {
  constructor(page, shapes, [first, second]) {
    this.names = [page.worlds[first].label, page.worlds[second].label];
    this.player = new Player(Math.min(page.worlds[first].frames, page.worlds[second].frames), page.stepSeconds);
    const motions = motionsOf(page);
    const caption = (name) => h('div', { className: 'pane-caption' }, h('b', {}, name));
    this.views = new Views([first, second].map((world, i) => ({
      view: new WorldView(shapes, motions[world]), caption: caption(i === 0 ? 'A' : 'B'),
    })), this.player, { byLevel: false, sleep: false, collisionShapes: false, contacts: false });
    this.sides = [...this.views.panes.map((pane) => pane.view)];
    this.player.onChange((player) => {
      // The stretch goes round and round.
      if (this.round && player.position >= Math.min(this.round.start + STRETCH, player.frames)) {
        player.position = this.round.start;
        player.play();
      }
    });
  }

  show(round) {
    this.round = round;
    this.views.panes.forEach((pane, i) => {
      pane.view = this.sides[round.swapped ? 1 - i : i];
    });
    this.player.seek(round.start);
    this.player.play();
  }

  end() {
    this.round = null;
    this.player.pause();
  }
}

/** Fills `place` with a trial of the first and the last world that can be played. */
export function makeTrial(place, page, shapes, mainPlayer, views) {
  const playable = views ? page.worlds.filter((world) => world.motion) : [];
  if (playable.length < 2) {
    place.append(h('p', {}, 'For this, two worlds are needed that can be played in 3D.'));
    return null;
  }
  const state = { trial: null };
  const pairs = playable.slice(1).map((world) => [playable[0].number, world.number]);
  const select = h('select', {}, ...pairs.map(([a, b], i) =>
    h('option', { selected: i === pairs.length - 1 }, `${page.worlds[a].label} and ${page.worlds[b].label}`)));
  const board = h('div', { className: 'trial' });
  const start = h('button', { type: 'button', className: 'play', onclick: () => begin() }, 'Begin');
  place.append(h('p', {}, `${ROUNDS} times you see the same seconds of two worlds, around the crash, without names or colours that tell, on random sides. Say which is which. What you answer stays in this page: nothing is stored or sent.`),
    h('div', { className: 'row' }, h('label', { className: 'choice' }, 'Worlds ', select), start), board);

  function begin() {
    mainPlayer.pause();
    state.view?.end();
    state.view?.views.dispose();
    state.trial = new Trial(page);
    state.view = new TrialView(page, shapes, pairs[select.selectedIndex]);
    state.view.views.element.classList.add('two');
    start.textContent = 'Begin again';
    ask();
  }

  function ask() {
    const { trial, view } = state;
    if (!trial.current) {
      finish();
      return;
    }
    const answer = (side) => h('button', {
      type: 'button', className: 'answer', onclick: () => {
        trial.answer(side);
        ask();
      },
    }, side === 0 ? `A is ${view.names[0]}` : `B is ${view.names[0]}`);
    board.replaceChildren(view.views.element,
      h('p', {}, `${trial.answered.length + 1} of ${ROUNDS}: one of these is ${view.names[0]}, the other ${view.names[1]}. Which is ${view.names[0]}?`),
      h('div', { className: 'row' }, answer(0), answer(1)));
    view.show(trial.current);
  }

  function finish() {
    const { trial, view } = state;
    view.end();
    const line = ({ swapped, answer }, i) => h('li', {}, `${i + 1}: ${view.names[0]} was ${swapped ? 'B' : 'A'}, you said ${answer === 1 ? 'B' : 'A'}`);
    board.replaceChildren(h('p', { className: 'result' }, trial.result()), h('ol', { className: 'answers' }, ...trial.rounds.map(line)));
  }
  return state;
}
