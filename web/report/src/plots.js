// The plots, drawn by uPlot, all on one horizontal axis, with the player's frame as their cursor.
import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { h, readable, whenNear } from './dom.js';

const HEIGHT = 220;

const isDark = () => window.matchMedia('(prefers-color-scheme: dark)').matches;

// The figures' colours are made for white paper.
function seen(color) {
  if (!isDark() || !/^#[0-9a-f]{6}$/i.test(color)) return color;
  if (color === '#000000') return '#f0f0f0';
  const parts = [1, 3, 5].map((at) => parseInt(color.slice(at, at + 2), 16));
  return `rgb(${parts.map((part) => Math.round(part + 0.3 * (255 - part))).join(' ')})`;
}

const columnOf = (world, name) => world.columns.get(name)?.values ?? new Float32Array(world.frames);

function linesOf(page, name, title, unit = '') {
  const series = page.worlds.map((world, i) => ({
    label: world.label, color: world.color, width: i === 0 ? 2.2 : 1.3, values: columnOf(world, name), unit,
  }));
  return { title, series };
}

function overview(page) {
  const plot = linesOf(page, 'physics_cpu_ms', 'Processor time of the physics, milliseconds: lower is better', 'ms');
  for (const world of page.worlds) {
    if (world.governedMs > 0) {
      plot.series.push({
        label: `budget of ${world.label}`, color: world.color, width: 1.2, dash: [6, 4],
        values: new Float32Array(page.frames).fill(world.governedMs), unit: 'ms',
      });
    }
  }
  return [plot];
}

function hybridPairs(page) {
  return [linesOf(page, 'pairs_with_hybrid', 'Narrowphase pairs with a hybrid'),
    linesOf(page, 'pairs_without_hybrid', 'Narrowphase pairs without a hybrid')];
}

function switches(page) {
  const up = linesOf(page, 'switches_coarser', 'Switches in each frame: up to a coarser level, down to a finer one');
  const down = page.worlds.map((world) => ({
    label: `${world.label}, finer`, color: world.color, width: 1.3, values: columnOf(world, 'switches_finer').map((count) => -count),
  }));
  up.series.forEach((series) => {
    series.label += ', coarser';
  });
  return { ...up, series: [...up.series, ...down] };
}

// Areas on top of each other, the whole stack first: each hides the lower part of the one before it.
function stagesOf(page, world, top) {
  const own = page.stages.map(([column]) => columnOf(world, column));
  const sums = [];
  own.forEach((values, stage) => sums.push(values.map((ms, i) => ms + (stage > 0 ? sums[stage - 1][i] : 0))));
  const series = page.stages.map(([, name, color], stage) => ({
    label: name, color, fill: color, width: 0.5, values: sums[stage], said: own[stage], unit: 'ms',
  })).filter(({ said }) => said.some((ms) => ms > 0)).reverse();
  series.push({ label: 'total', color: '#000000', width: 1, values: columnOf(world, 'physics_ms'), unit: 'ms' });
  return { title: `${world.label}: stages of the physics, milliseconds by the wall`, series, top };
}

// A frame that other programs interrupted must not press all others flat.
function stages(page) {
  let top = 0;
  for (const world of page.worlds) for (const ms of columnOf(world, 'physics_cpu_ms')) top = Math.max(top, ms);
  return page.worlds.map((world) => stagesOf(page, world, 1.3 * top));
}

const PLOTS = {
  overview,
  manifolds_pairs: (page) => [linesOf(page, 'manifolds', 'Manifolds'), linesOf(page, 'narrowphase_pairs', 'Narrowphase pairs')],
  hybrid_pairs: hybridPairs,
  objects_contacts: (page) => [linesOf(page, 'contacts', 'Contact points'), linesOf(page, 'objects', 'Objects')],
  switching: (page) => [linesOf(page, 'finest_pairs', 'Pairs tested at the finest level'), linesOf(page, 'requests', 'Standing requests'), switches(page)],
  stages,
};

/** What all plots have in common: the frames that are seen, and the cursor. */
class Axis {
  constructor(page, player) {
    this.page = page;
    this.player = player;
    this.plots = new Set();
    this.whole = [1, Math.max(page.frames, 2)];
    this.range = this.whole;
    player.onChangeUnhurried(() => this.showCursor());
  }

  zoom(from, to) {
    const [first, last] = this.whole;
    const width = Math.min(Math.max(to - from, 8), last - first);
    const start = Math.min(Math.max(from, first), last - width);
    this.range = [start, start + width];
    for (const plot of this.plots) plot.zoomTo(...this.range);
    this.showCursor();
  }

  /** By a factor around the cursor. */
  zoomBy(factor) {
    const [from, to] = this.range;
    const at = Math.min(Math.max(this.player.row, from), to);
    this.zoom(at - (at - from) / factor, at + (to - at) / factor);
  }

  showCursor() {
    for (const plot of this.plots) if (plot.isNear) plot.showCursor(this.player.row);
  }
}

class Plot {
  constructor(axis, { title, series, top }) {
    this.axis = axis;
    this.definition = { title, series, top };
    this.isNear = false;
    this.isSettingCursor = false;
    this.element = h('div', { className: 'plot' }, h('h4', {}, title));
    whenNear(this.element, 400, (near) => {
      this.isNear = near;
      if (!near) return;
      if (!this.chart) this.make();
      this.showCursor(axis.player.row);
    });
    window.matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
      if (this.chart) this.make();
    });
    axis.plots.add(this);
  }

  make() {
    this.chart?.destroy();
    const { frames } = this.axis.page;
    const x = Float32Array.from({ length: frames }, (_, i) => i + 1);
    const padded = ({ values }) => Array.from({ length: frames }, (_, i) => (i < values.length && Number.isFinite(values[i]) ? values[i] : null));
    this.chart = new uPlot(this.options(), [x, ...this.definition.series.map(padded)], this.element);
    this.listen(this.chart.over);
    this.resizing ??= new ResizeObserver(() => this.chart.setSize({ width: this.element.clientWidth, height: HEIGHT }));
    this.resizing.observe(this.element);
  }

  options() {
    const text = isDark() ? '#c8ced6' : '#444';
    const grid = { stroke: isDark() ? '#333b45' : '#e4e4e4', width: 1 };
    const { series, top } = this.definition;
    const [min, max] = this.axis.range;
    return {
      width: this.element.clientWidth,
      height: HEIGHT,
      scales: {
        x: { time: false, min, max, range: (chart, from, to) => [from, to] },
        y: top ? { range: [0, Math.max(top, 1e-6)] } : {},
      },
      axes: [
        { stroke: text, grid, ticks: grid, values: (chart, splits) => splits.map((split) => String(Math.round(split * 10) / 10)) },
        { stroke: text, grid, ticks: grid, size: 62, values: (chart, splits) => splits.map((split) => (split === 0 ? '0' : Math.abs(split) >= 10000 ? `${split / 1000}k` : String(+split.toPrecision(6)))) },
      ],
      cursor: { drag: { x: true, y: false, setScale: false, dist: 6 }, points: { size: 6 } },
      legend: { live: true },
      series: [
        { label: 'frame', value: (chart, value) => (value == null ? '–' : String(Math.round(value))) },
        ...series.map(({ label, color, fill, width, dash, said, unit }) => ({
          label, stroke: seen(color), fill: fill && seen(fill), width, dash, points: { show: false },
          value: (chart, value, number, row) => {
            const shown = said && row != null ? said[row] : value;
            return shown == null ? '–' : readable(shown) + (unit ? ` ${unit}` : '');
          },
        })),
      ],
      hooks: { ready: [() => this.showCursor(this.axis.player.row)], setCursor: [(chart) => this.noteCursor(chart)], setSelect: [(chart) => this.noteSelection(chart)] },
    };
  }

  // A click sets the frame (uPlot keeps the one that ends a drag to itself), a drag zooms, and a finger, which has no hover, sets the frame wherever it goes.
  listen(over) {
    const { axis } = this;
    const seekTo = ({ clientX }) => axis.player.seek(Math.round(this.chart.posToVal(clientX - over.getBoundingClientRect().left, 'x')));
    over.addEventListener('click', seekTo);
    over.addEventListener('dblclick', () => axis.zoom(...axis.whole));
    over.addEventListener('mouseleave', () => axis.player.hover(null));
    over.style.touchAction = 'pan-y';
    over.addEventListener('pointermove', (event) => {
      if (event.pointerType === 'touch') seekTo(event);
    });
  }

  noteCursor(chart) {
    if (this.isSettingCursor || chart.cursor.left == null || chart.cursor.left < 0 || !chart.cursor.event) return;
    this.axis.player.hover(Math.round(chart.posToVal(chart.cursor.left, 'x')));
  }

  noteSelection(chart) {
    const { left, width } = chart.select;
    if (width <= 0) return;
    this.axis.zoom(chart.posToVal(left, 'x'), chart.posToVal(left + width, 'x'));
    chart.setSelect({ left: 0, width: 0, top: 0, height: 0 }, false);
  }

  zoomTo(min, max) {
    this.chart?.setScale('x', { min, max });
  }

  showCursor(row) {
    if (!this.chart) return;
    const left = this.chart.valToPos(row, 'x');
    const isSeen = left >= 0 && left <= this.chart.over.clientWidth;
    this.isSettingCursor = true;
    this.chart.setCursor({ left: isSeen ? left : -10, top: isSeen ? this.chart.over.clientHeight / 2 : -10 }, false);
    if (isSeen) this.chart.setLegend({ idx: row - 1 }, false);
    this.isSettingCursor = false;
  }
}

function zoomButtons(axis) {
  const { page } = axis;
  const around = (frame) => axis.zoom(frame - page.frames / 20 - 25, frame + page.frames / 20 + 25);
  const button = (text, onclick) => h('button', { type: 'button', onclick }, text);
  return h('div', { className: 'row zoom' }, button('Zoom in', () => axis.zoomBy(2)), button('Zoom out', () => axis.zoomBy(0.5)),
    button('Around the dearest frame', () => around(page.peakFrame)), button('All frames', () => axis.zoom(...axis.whole)));
}

/** Fills the figures that the page has; the first stands below the worlds in 3D. */
export function makePlots(page, player, stage) {
  const axis = new Axis(page, player);
  const first = document.getElementById('overview');
  if (first) stage.append(first);
  stage.append(h('p', { className: 'hint' }, 'Point at a plot to see that frame everywhere on the page, click to go there, drag to zoom all plots, double-click for all frames.'), zoomButtons(axis));
  for (const [name, make] of Object.entries(PLOTS)) {
    const figure = document.getElementById(name);
    if (!figure) continue;
    const plots = make(page).map((plot) => new Plot(axis, plot));
    figure.querySelector('figcaption').before(...plots.map((plot) => plot.element));
  }
  return axis;
}
