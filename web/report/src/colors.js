// The same colours as in the program's window (src/viewer/palette.cpp, scene_view.cpp).

function ofHue(hue, saturation, value) {
  const channel = (shift) => {
    const wave = Math.abs(((hue + shift) % 1) * 6 - 3) - 1;
    return value * (1 - saturation * (1 - Math.min(Math.max(wave, 0), 1)));
  };
  return [channel(0), channel(2 / 3), channel(1 / 3)];
}

/** Of a level: the coarsest, 1, red, the finest green. */
export function levelColor(level, levels) {
  const share = levels > 1 ? Math.min(Math.max((level - 1) / (levels - 1), 0), 1) : 1;
  return ofHue(0.36 * share, 0.75, 0.95);
}

const KINDS = [
  [0.55, 0.66, 0.8], [0.86, 0.58, 0.36], [0.58, 0.55, 0.52], [0.62, 0.74, 0.52],
  [0.78, 0.7, 0.45], [0.7, 0.55, 0.7], [0.5, 0.7, 0.7], [0.8, 0.8, 0.8],
];

export const STATIC_COLOR = [0.4, 0.43, 0.48];

/** A colour for each body, by its name without numbers. */
export function kindColors(bodies) {
  const kinds = new Map();
  return bodies.map(({ name, isStatic }) => {
    if (isStatic) return STATIC_COLOR;
    const stem = name.replace(/[-_ 0-9]+$/, '');
    if (!kinds.has(stem)) kinds.set(stem, KINDS[kinds.size % KINDS.length]);
    return kinds.get(stem);
  });
}

export function paler([r, g, b]) {
  const grey = 0.62;
  return [r + 0.6 * (grey - r), g + 0.6 * (grey - g), b + 0.6 * (grey - b)];
}

export const css = ([r, g, b]) => `rgb(${[r, g, b].map((part) => Math.round(255 * part)).join(' ')})`;
