import './page.css';
import { openData, readPage } from './data.js';
import { h, whenNear } from './dom.js';
import { Shapes } from './geometry.js';
import { makeNow } from './now.js';
import { Player } from './player.js';
import { makePlots } from './plots.js';
import { listenToKeys, makeStage } from './stage.js';
import { makeTrial } from './trial.js';

async function start() {
  await Promise.all([openData(), Shapes.ready()]);
  const page = readPage();
  const player = new Player(page.frames, page.stepSeconds);
  const shapes = new Shapes(page.look);
  const stage = document.getElementById('stage');
  const views = makeStage(stage, page, player, shapes);
  const now = h('section');
  stage.after(now);
  makeNow(now, page, player);
  const axis = makePlots(page, player, stage);
  const place = document.getElementById('trial');
  const trial = place && makeTrial(place, page, shapes, player, views);
  listenToKeys(player);
  player.tell();
  // Who looks for how the page works, or tests it, finds its parts here.
  window.scatter = { page, player, views, axis, trial };
  playOnce(stage, player, views);
}

// The picture plays by itself, unless the reader's system asks for rest.
function playOnce(stage, player, views) {
  if (!views || window.matchMedia('(prefers-reduced-motion: reduce)').matches) return;
  let isFirst = true;
  whenNear(stage, 0, (near) => {
    if (near && isFirst) player.play();
    isFirst = false;
  });
}

start().catch((error) => {
  console.error(error);
  document.getElementById('stage').append(
    h('p', {}, `The moving picture and the plots could not be shown: ${error.message}. The text, the table and the files beside this page are whole.`));
});
