// What the program has put into the page: a description in JSON, and blobs, which are unpacked when they are asked for.
import { ZSTDDecoder } from 'three/addons/libs/zstddec.module.js';

const unpacker = new ZSTDDecoder();

function bytesOfBase64(text) {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < bytes.length; ++i) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** Call before anything else here. */
export async function openData() {
  await unpacker.init();
}

/** The bytes of a blob, which is described as { blob, bytes }. */
export function unpack({ blob, bytes }) {
  if (bytes === 0) return new Uint8Array(0);
  return unpacker.decode(bytesOfBase64(document.getElementById(`blob-${blob}`).textContent), bytes);
}

function floatsOf(bytes) {
  const count = bytes.length / 4;
  const woven = new Uint8Array(bytes.length);
  for (let byte = 0; byte < 4; ++byte) {
    for (let i = 0; i < count; ++i) woven[4 * i + byte] = bytes[byte * count + i];
  }
  return new Float32Array(woven.buffer);
}

/** The frame data of a world: a column of numbers by its name, the first of frame 1. */
export function readColumns(world) {
  const numbers = floatsOf(unpack(world.data));
  const columns = new Map();
  world.data.columns.forEach(([name, unit, isWhole], i) => {
    const values = numbers.subarray(i * world.frames, (i + 1) * world.frames);
    columns.set(name, { name, unit, isWhole, values });
  });
  return columns;
}

/** The description, in which each world has its columns and a number. */
export function readPage() {
  const page = JSON.parse(document.getElementById('page-data').textContent);
  page.worlds.forEach((world, number) => {
    world.number = number;
    world.columns = readColumns(world);
  });
  page.frames = Math.max(...page.worlds.map((world) => world.frames));
  page.peakFrame = 1 + highest(page.worlds[0].columns.get('physics_cpu_ms').values);
  return page;
}

function highest(values) {
  let best = 0;
  for (let i = 1; i < values.length; ++i) if (values[i] > values[best]) best = i;
  return best;
}
