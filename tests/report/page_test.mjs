// page_test.mjs NODE_MODULES SCATTER FOLDER: makes reports with the program, and reads them in a Chromium without network, with
// software for a graphics card. Times are printed, and decide nothing. Exit status 77: there is no Chromium.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, mkdirSync, statSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';

const [modules, scatter, folder] = process.argv.slice(2).map((path) => resolve(path));
const browserFile = [process.env.SCATTER_CHROMIUM, '/usr/bin/chromium', '/usr/bin/chromium-browser'].find((file) => file && existsSync(file));
if (!browserFile) {
  console.log('SKIPPED: there is no Chromium, so that nobody has looked at the report\'s page; install the package chromium');
  process.exit(77);
}
if (!existsSync(join(modules, 'playwright-core'))) {
  console.log('SKIPPED: npm could not get playwright-core when the program was built, so that nobody has looked at the report\'s page');
  process.exit(77);
}
const { chromium } = createRequire(join(modules, 'x.js'))('playwright-core');

const FRAMES = 420;

function makeReport(name, ...args) {
  const out = join(folder, name);
  mkdirSync(out, { recursive: true });
  execFileSync(scatter, ['compare', ...args, '--quiet', '--anew', '--out', out], { cwd: folder, stdio: 'pipe' });
  return join(out, 'report.html');
}

async function check(name, look) {
  await look();
  console.log(`ok: ${name}`);
}

const browser = await chromium.launch({ executablePath: browserFile, args: ['--no-sandbox', '--disable-gpu', '--enable-unsafe-swiftshader'] });

/** Opens a report as a double-click does; `close` fails if it has complained or asked for anything that is not in it. */
async function open(report, width, colorScheme = 'light') {
  const context = await browser.newContext({ viewport: { width, height: 900 }, colorScheme, offline: true, reducedMotion: 'reduce', hasTouch: width < 700 });
  const page = await context.newPage();
  const mistakes = [];
  page.on('console', (message) => message.type() === 'error' && mistakes.push(message.text()));
  page.on('pageerror', (error) => mistakes.push(error.stack));
  page.on('request', (request) => /^(data|blob):/.test(request.url()) || request.url() === `file://${report}` || mistakes.push(`asked for ${request.url()}`));
  const before = performance.now();
  await page.goto(`file://${report}`, { waitUntil: 'commit' });
  await page.waitForFunction(() => window.scatter?.views?.pictures > 0);
  console.log(`${width} pixels, ${(statSync(report).size / 1e6).toFixed(2)} MB: first picture after ${Math.round(performance.now() - before)} ms`);
  return {
    page,
    close: async () => {
      const [wide, seen] = await page.evaluate(() => [document.documentElement.scrollWidth, window.innerWidth]);
      assert.ok(wide <= seen, `the page is ${wide} pixels wide, and ${seen} are seen`);
      assert.deepEqual(mistakes, []);
      await context.close();
    },
  };
}

/** Draws a frame and says how many pixels of each pane are red, green, and neither the background nor blank, and a sum to compare. */
function pixelsAt(page, frame) {
  return page.evaluate((at) => {
    const { views, player } = window.scatter;
    player.pause();
    player.seek(at);
    views.drawNow(performance.now());
    const gl = views.renderer.getContext();
    const area = views.canvas.getBoundingClientRect();
    const ratio = views.renderer.getPixelRatio();
    return views.panes.map(({ element }) => {
      const box = element.getBoundingClientRect();
      const [width, height] = [Math.floor(box.width * ratio), Math.floor(box.height * ratio)];
      const pixels = new Uint8Array(4 * width * height);
      gl.readPixels(Math.round((box.left - area.left) * ratio), Math.round((area.bottom - box.bottom) * ratio), width, height, gl.RGBA, gl.UNSIGNED_BYTE, pixels);
      const found = { red: 0, green: 0, drawn: 0, colors: new Set(), sum: 0 };
      for (let i = 0; i < pixels.length; i += 4) {
        const [r, g, b] = [pixels[i], pixels[i + 1], pixels[i + 2]];
        if (r > 60 && r > 2 * g) ++found.red;
        if (g > 60 && g > 2 * r) ++found.green;
        if (r + g + b > 120) ++found.drawn;
        found.colors.add((r << 16) | (g << 8) | b);
        found.sum = (found.sum * 31 + r + 3 * g + 7 * b) % 1000000007;
      }
      return { ...found, colors: found.colors.size };
    });
  }, frame);
}

async function rateWhilePlaying(page, from) {
  return page.evaluate(async (start) => {
    const { views, player } = window.scatter;
    player.seek(start);
    player.play();
    await new Promise((done) => setTimeout(done, 500));
    const [pictures, time] = [views.pictures, performance.now()];
    await new Promise((done) => setTimeout(done, 1000));
    player.pause();
    return (1000 * (views.pictures - pictures)) / (performance.now() - time);
  }, from);
}

const stateOf = (page) => page.evaluate(() => {
  const { player, axis } = window.scatter;
  return {
    shown: player.shown, position: player.position, heading: document.getElementById('now').textContent,
    slider: Number(document.querySelector('.transport input').value),
    cursors: [...axis.plots].filter((plot) => plot.chart && plot.isNear).map((plot) => plot.chart.posToVal(plot.chart.cursor.left, 'x')),
    ranges: [...axis.plots].filter((plot) => plot.chart).map(({ chart }) => [chart.scales.x.min, chart.scales.x.max]),
  };
});

async function lookAtTwoWorlds(report, width, colorScheme) {
  const { page, close } = await open(report, width, colorScheme);
  console.log(`${width} pixels: ${(await rateWhilePlaying(page, 250)).toFixed(0)} pictures a second while it plays`);

  await check('the first line says what came out', async () => {
    assert.match(await page.textContent('h1'), /^convergence in 2 worlds: the physics of hybrid took [0-9.]+ of the processor time of standard$/);
  });

  await check('space plays, arrows step', async () => {
    await page.evaluate(() => window.scatter.player.seek(10));
    await page.keyboard.press('Space');
    await page.waitForFunction(() => window.scatter.player.position > 15);
    await page.keyboard.press('Space');
    const { position } = await stateOf(page);
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('Shift+ArrowRight');
    assert.equal((await stateOf(page)).position, Math.round(position) + 11);
  });

  await check('the picture is not blank, differs between frames, and has levels in colour', async () => {
    const [early, late] = [await pixelsAt(page, 30), await pixelsAt(page, FRAMES - 10)];
    for (const pane of [0, 1]) {
      assert.ok(late[pane].drawn > 500 && late[pane].colors > 30, JSON.stringify(late[pane]));
      assert.notEqual(early[pane].sum, late[pane].sum);
    }
    assert.ok(late[0].green > 100 && late[0].red === 0, 'all of the standard world is at its finest level');
    assert.ok(late[1].red > 100, 'the hybrid world has bodies at their coarsest level');
  });

  await check('a pointer on a plot moves everything, and lets go', async () => {
    await page.evaluate(() => window.scatter.player.seek(50));
    const plot = page.locator('#overview .u-over');
    await plot.scrollIntoViewIfNeeded();
    const box = await plot.boundingBox();
    await page.mouse.move(box.x + box.width * 0.3, box.y + 40);
    await page.mouse.move(box.x + box.width * 0.6, box.y + 50);
    const there = await stateOf(page);
    assert.ok(Math.abs(there.shown - 0.6 * FRAMES) < 4, JSON.stringify(there));
    assert.equal(there.position, 50);
    assert.equal(there.slider, there.shown);
    assert.equal(there.heading, `Frame ${there.shown}: what it cost`);
    assert.ok(there.cursors.length > 0);
    for (const cursor of there.cursors) assert.ok(Math.abs(cursor - there.shown) < 2, JSON.stringify(there));
    await page.mouse.move(box.x + box.width * 0.6, box.y - 60);
    assert.equal((await stateOf(page)).shown, 50);
    await page.mouse.click(box.x + box.width * 0.5, box.y + 40);
    await page.mouse.move(box.x, box.y - 60);
    assert.ok(Math.abs((await stateOf(page)).position - FRAMES / 2) < 4);
  });

  await check('a drag zooms all plots', async () => {
    const before = await stateOf(page);
    const box = await page.locator('#overview .u-over').boundingBox();
    await page.mouse.move(box.x + box.width * 0.25, box.y + 40);
    await page.mouse.down();
    await page.mouse.move(box.x + box.width * 0.5, box.y + 45, { steps: 4 });
    await page.mouse.up();
    await page.locator('#stages').scrollIntoViewIfNeeded();
    await page.waitForFunction(() => [...window.scatter.axis.plots].at(-1).chart);
    const { ranges, position } = await stateOf(page);
    assert.equal(position, before.position);
    assert.ok(ranges.length > 1);
    for (const range of ranges) {
      assert.deepEqual(range, ranges[0]);
      assert.ok(range[0] > 0.2 * FRAMES && range[1] < 0.55 * FRAMES, JSON.stringify(range));
    }
  });
  return { page, close };
}

async function answerTrial(page) {
  await page.getByRole('button', { name: 'Begin' }).click();
  const rounds = 8;
  for (let round = 0; round < rounds; ++round) {
    const [captions, isSwapped] = await page.evaluate(() => {
      const { view, trial } = window.scatter.trial;
      const isSecondLeft = view.views.panes[0].view === view.sides[1];
      return [view.views.panes.map((pane) => pane.element.textContent), isSecondLeft === trial.current.swapped && isSecondLeft];
    });
    assert.deepEqual(captions, ['A', 'B']);
    const isRight = round < 5;
    await page.getByRole('button', { name: isSwapped === isRight ? 'B is standard' : 'A is standard' }).click();
  }
  return page.textContent('.trial .result');
}

mkdirSync(folder, { recursive: true });
const two = makeReport('two', 'convergence', '--frames', String(FRAMES), '--worlds', 'standard,hybrid', '--budget-units', '60',
  '--record', join(folder, 'two.rec'), '--record-contacts');
const wide = await lookAtTwoWorlds(two, 1400, 'dark');
await check('the blind trial counts rightly', async () => {
  assert.equal(await answerTrial(wide.page), 'You were right 5 times of 8. Somebody who guesses is right 4 times of 8 on average, and 5 times or more in 36 % of all trials.');
});
await wide.close();
const narrow = await lookAtTwoWorlds(two, 600, 'light');
await check('a finger on a plot moves everything', async () => {
  const plot = narrow.page.locator('#overview .u-over');
  await plot.scrollIntoViewIfNeeded();
  const box = await plot.boundingBox();
  await narrow.page.touchscreen.tap(box.x + box.width * 0.5, box.y + 40);
  const { position, ranges } = await stateOf(narrow.page);
  assert.ok(Math.abs(position - (ranges[0][0] + ranges[0][1]) / 2) < 4, `${position} in ${ranges[0]}`);
});
await narrow.close();

// One world, with bodies that come and go.
const one = await open(makeReport('one', 'breakables', '--frames', '120', '--worlds', 'standard'), 600);
await check('one world alone is a page without a trial', async () => {
  assert.equal(await one.page.locator('#trial').count(), 0);
  const [pane] = await pixelsAt(one.page, 100);
  assert.ok(pane.drawn > 500, JSON.stringify(pane));
});
await one.close();
await browser.close();
