// What the shown frame was like: what each stage has cost, and the frame data.
import { h, readable } from './dom.js';

const FIRST = [
  'physics_cpu_ms', 'physics_ms', 'overlapping_pairs', 'narrowphase_pairs', 'manifolds', 'contacts', 'touching_pairs',
  'touching_finest_pairs', 'withheld_pairs', 'requests', 'switches_coarser', 'switches_finer', 'awake_bodies', 'kinetic_energy',
  'max_penetration',
];

function valueAt(world, column, row) {
  return world.columns.get(column)?.values[row - 1];
}

class StageBars {
  constructor(page) {
    this.page = page;
    this.bars = page.worlds.map((world) => ({
      world,
      total: h('span', { className: 'bar-total' }),
      parts: page.stages.map(([, name, color]) => h('span', { className: 'bar-part', title: name, style: `background:${color}` })),
    }));
    this.element = h('div', { className: 'bars' }, ...this.bars.map(({ world, parts, total }) =>
      h('div', { className: 'bar' }, h('span', { className: 'bar-name' }, world.label), h('div', { className: 'bar-body' }, ...parts), total)));
  }

  show(row) {
    const sums = this.bars.map(({ world }) => this.page.stages.reduce((sum, [column]) => sum + (valueAt(world, column, row) ?? 0), 0));
    const longest = Math.max(...sums, 1e-6);
    this.bars.forEach(({ world, parts, total }, i) => {
      this.page.stages.forEach(([column, name], stage) => {
        const ms = valueAt(world, column, row) ?? 0;
        parts[stage].style.width = `${(100 * ms) / longest}%`;
        parts[stage].title = `${name}: ${readable(ms)} ms`;
      });
      total.textContent = row > world.frames ? 'ended' : `${readable(sums[i])} ms`;
    });
  }
}

class ValueTable {
  constructor(page, rows, className) {
    this.page = page;
    this.cells = rows.map(({ column }) => ({ column, cells: page.worlds.map(() => h('td')) }));
    this.element = h('div', { className: 'table' }, h('table', { className },
      h('thead', {}, h('tr', {}, h('th', {}, ''), ...page.worlds.map((world) => h('th', {}, world.label)))),
      h('tbody', {}, ...rows.map(({ name, color }, i) => h('tr', {},
        h('td', {}, color ? h('span', { className: 'swatch', style: `background:${color}` }) : null, name), ...this.cells[i].cells)))));
  }

  show(row) {
    for (const { column, cells } of this.cells) {
      this.page.worlds.forEach((world, i) => {
        const found = world.columns.get(column);
        const value = found?.values[row - 1];
        cells[i].textContent = value === undefined || Number.isNaN(value) ? '–' : found.isWhole ? String(value) : readable(value);
      });
    }
  }
}

function rowsOf(page, wanted) {
  const columns = [...page.worlds[0].columns.values()].filter(({ name }) => wanted(name));
  return columns.map(({ name, unit }) => ({ column: name, name: name.replaceAll('_', ' ').replace(/ (cpu )?ms$/, (ms) => (ms.includes('cpu') ? ' (processor)' : '')) + (unit ? `, ${unit}` : '') }));
}

/** Fills `place` with what the player's frame has cost. */
export function makeNow(place, page, player) {
  const heading = h('h2', { id: 'now' });
  const bars = new StageBars(page);
  const stageColumns = page.stages.map(([column]) => column);
  const seen = page.stages.filter(([column]) => page.worlds.some((world) => world.columns.get(column)?.values.some((ms) => ms > 0)));
  const stages = new ValueTable(page, seen.map(([column, name, color]) => ({ column, name: `${name}, ms`, color })), 'stages');
  const first = new ValueTable(page, rowsOf(page, (name) => FIRST.includes(name)), 'values');
  const rest = new ValueTable(page, rowsOf(page, (name) =>
    !FIRST.includes(name) && !stageColumns.includes(name) && name !== 'frame'), 'values');
  const more = h('details', {}, h('summary', {}, 'All other values of this frame'), rest.element);
  place.append(heading, h('p', {}, 'What each stage of the physics took in the shown frame, wall time. The longest bar is the dearest world\'s.'),
    bars.element, h('div', { className: 'tables' }, stages.element, first.element), more);
  const parts = [bars, stages, first, rest];
  let shownRow = null;
  const show = () => {
    const { row } = player;
    if (row === shownRow) return;
    shownRow = row;
    heading.textContent = `Frame ${row}: what it cost`;
    for (const part of parts) if (part !== rest || more.open) part.show(row);
  };
  more.addEventListener('toggle', () => rest.show(player.row));
  player.onChangeUnhurried(show);
}
