// bundle.mjs NODE_MODULES OUTPUT: bundles the page into a C++ source with its script, its style and the licences
// of what is in them.
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join } from 'node:path';
import { fileURLToPath } from 'node:url';

const [modules, output] = process.argv.slice(2);
const { buildSync } = createRequire(join(modules, 'x.js'))('esbuild');
const here = dirname(fileURLToPath(import.meta.url));

const { outputFiles, metafile } = buildSync({
  absWorkingDir: here,
  entryPoints: ['src/main.js'],
  bundle: true,
  minify: true,
  format: 'iife',
  target: ['chrome100', 'firefox110', 'safari16'],
  nodePaths: [modules],
  legalComments: 'eof',  // Of what packages have taken from others; their own licences stand in the page, whole.
  metafile: true,
  outdir: 'out',
  write: false,
});

function textOf(ending) {
  const file = outputFiles.find((one) => one.path.endsWith(ending));
  return file ? file.text : '';
}

// The packages that the bundle took anything from.
function packagesUsed() {
  const names = new Set();
  for (const input of Object.keys(metafile.inputs)) {
    const found = input.match(/node_modules\/((?:@[^/]+\/)?[^/]+)\//);
    if (found) names.add(found[1]);
  }
  return [...names].sort();
}

function licenceOf(name) {
  const folder = join(modules, name);
  const about = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const file = ['LICENSE', 'LICENSE.md', 'LICENSE.txt', 'LICENCE'].map((one) => join(folder, one)).find(existsSync);
  const text = file ? readFileSync(file, 'utf8').trim() : `${about.license}; ${about.author?.name ?? about.author ?? ''}`;
  return `${about.name} ${about.version} (${about.license})\n\n${text}\n`;
}

// Compilers need not take longer literals than these in one piece.
function literal(text) {
  const pieces = text.match(/[^]{1,16000}/g) ?? [];
  return pieces.map((piece) => `R"page~(${piece})page~"`).join('\n');
}

const carried = readFileSync(join(here, 'licences', 'zstd.txt'), 'utf8');
const licences = [...packagesUsed().map(licenceOf), carried].join('\n');
writeFileSync(output, `#include "lab/page/page_bundle.h"

namespace scatter::lab {

PageBundle pageBundle() {
  static constexpr char kScript[] = ${literal(textOf('.js'))};
  static constexpr char kStyle[] = ${literal(textOf('.css'))};
  static constexpr char kLicences[] = ${literal(licences)};
  return {{kScript, sizeof(kScript) - 1}, {kStyle, sizeof(kStyle) - 1}, {kLicences, sizeof(kLicences) - 1}};
}

}  // namespace scatter::lab
`);
