// report_page.mjs NODE_MODULES REPORT: how large a report is, and at 600 and 1400 pixels how soon its first picture is there and how many
// it draws in a second while it plays, in a Chromium without a graphics card. NODE_MODULES: report_page/node_modules of a build.
import { existsSync, statSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join, resolve } from 'node:path';

const [modules, report] = process.argv.slice(2).map((path) => resolve(path));
const { chromium } = createRequire(join(modules, 'x.js'))('playwright-core');
const executablePath = [process.env.SCATTER_CHROMIUM, '/usr/bin/chromium'].find((file) => file && existsSync(file));
const SECONDS = 5;

async function measure(browser, width) {
  const context = await browser.newContext({ viewport: { width, height: 900 }, offline: true, reducedMotion: 'reduce' });
  const page = await context.newPage();
  const before = performance.now();
  await page.goto(`file://${report}`, { waitUntil: 'commit' });
  await page.waitForFunction(() => window.scatter?.views?.pictures > 0);
  const first = performance.now() - before;
  const starts = await page.evaluate(() => [0, window.scatter.page.peakFrame / 2, window.scatter.page.peakFrame].map((frame) => Math.max(0, Math.min(frame, window.scatter.player.frames - 400))));
  const rates = [];
  for (const start of starts) rates.push(await page.evaluate(rateFrom, [start, SECONDS]));
  console.log(`${width} pixels: first picture after ${Math.round(first)} ms; ` +
    rates.map((rate, i) => `${rate.toFixed(0)} pictures a second from frame ${Math.round(starts[i])} on`).join(', '));
  await context.close();
}

/** In the page: pictures a second, after a second in which it finds out how well it can draw. */
async function rateFrom([start, seconds]) {
  const { views, player } = window.scatter;
  const wait = (time) => new Promise((done) => setTimeout(done, 1000 * time));
  player.seek(start);
  player.play();
  await wait(1);
  const [pictures, time] = [views.pictures, performance.now()];
  await wait(seconds);
  player.pause();
  return (1000 * (views.pictures - pictures)) / (performance.now() - time);
}

const browser = await chromium.launch({ executablePath, args: ['--no-sandbox', '--disable-gpu', '--enable-unsafe-swiftshader'] });
console.log(`${browser.version()}, ${(statSync(report).size / 1e6).toFixed(1)} MB`);
for (const width of [600, 1400]) await measure(browser, width);
await browser.close();
