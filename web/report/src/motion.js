// Where bodies are, from the blocks that src/lab/page/pose_block.h and contact_block.h describe.
import { unpack } from './data.js';

const KEPT_BLOCKS = 4;
const ABSENT = 0;
const ASLEEP = 128;

class Numbers {
  constructor(bytes, at = 0) {
    this.bytes = bytes;
    this.at = at;
  }

  unsigned() {
    const { bytes } = this;
    let value = 0;
    let shift = 0;
    for (;;) {
      const next = bytes[this.at++];
      value |= (next & 127) << shift;
      if (next < 128) return value >>> 0;
      shift += 7;
    }
  }

  signed() {
    const value = this.unsigned();
    return (value >>> 1) ^ -(value & 1);
  }
}

/** The states of all bodies in all frames, and their seven numbers, frame by frame. */
function decodePoses(bytes, frames, bodies, quantum) {
  const states = bytes.slice(0, frames * bodies);
  for (let i = bodies; i < states.length; ++i) states[i] ^= states[i - bodies];
  const poses = new Float32Array(7 * frames * bodies);
  const numbers = new Numbers(bytes, frames * bodies);
  for (let part = 0; part < 7; ++part) {
    const unit = part < 3 ? quantum : 1 / 8192;
    for (let body = 0; body < bodies; ++body) {
      let last = 0;
      let step = 0;
      let begun = false;
      for (let i = body; i < states.length; i += bodies) {
        if (states[i] === ABSENT) continue;
        const next = (step + numbers.signed()) | 0;
        last = (last + next) | 0;
        step = begun ? next : 0;
        begun = true;
        poses[7 * i + part] = last * unit;
      }
    }
  }
  return { states, poses };
}

function decodeContacts(bytes, frames, quantum) {
  const numbers = new Numbers(bytes);
  const all = [];
  for (let frame = 0; frame < frames; ++frame) {
    const count = numbers.unsigned();
    const points = new Float32Array(3 * count);
    const levels = new Uint8Array(count);
    const last = [0, 0, 0];
    for (let i = 0; i < count; ++i) {
      levels[i] = numbers.bytes[numbers.at++];
      for (let axis = 0; axis < 3; ++axis) {
        last[axis] += numbers.signed();
        points[3 * i + axis] = last[axis] * quantum;
      }
    }
    all.push({ count, points, levels });
  }
  return all;
}

/** A world's bodies at any frame. Blocks are unpacked when they are needed, and a few are kept. */
export class Motion {
  constructor(motion) {
    this.bodies = motion.bodies.map(([name, shape, levels, kind, scale]) => ({
      name, shape, levels, isStatic: kind === 0, scale,
    }));
    this.first = motion.first;
    this.last = motion.last;
    this.hasContacts = motion.hasContacts;
    this.step = motion.step;
    this.stopped = motion.stopped || motion.damage;
    this.description = motion;
    this.blocks = new Map();
  }

  /** The stored frame at or before this one: its states, poses and contacts as { block, index }. */
  at(frame) {
    const stored = Math.floor((Math.min(Math.max(frame, this.first), this.last) - this.first) / this.step);
    const each = this.description.blocks[0].frames;
    const number = Math.floor(stored / each);
    return { block: this.block(number), index: stored - number * each };
  }

  block(number) {
    const known = this.blocks.get(number);
    if (known) {
      // What was used last is given up last.
      this.blocks.delete(number);
      this.blocks.set(number, known);
      return known;
    }
    const { frames, contacts, ...poses } = this.description.blocks[number];
    const block = decodePoses(unpack(poses), frames, this.bodies.length, this.description.quantum);
    if (contacts) block.contacts = decodeContacts(unpack(contacts), frames, this.description.contactQuantum);
    this.blocks.set(number, block);
    if (this.blocks.size > KEPT_BLOCKS) this.blocks.delete(this.blocks.keys().next().value);
    return block;
  }

  /** Fills `out` with where all bodies are at a frame, which need not be whole, and returns it. */
  sample(frame, out = {}) {
    const count = this.bodies.length;
    out.states ??= new Uint8Array(count);
    out.poses ??= new Float32Array(7 * count);
    const time = Math.min(Math.max(frame, this.first), this.last);
    const share = ((time - this.first) / this.step) % 1;
    const from = this.at(time);
    const to = share > 0 ? this.at(time + this.step) : from;
    const a = from.index * count;
    const b = to.index * count;
    for (let i = 0; i < count; ++i) {
      const state = from.block.states[a + i];
      out.states[i] = state;
      if (state === ABSENT) continue;
      const later = to.block.states[b + i] === ABSENT ? from : to;
      mix(from.block.poses, 7 * (a + i), later.block.poses, 7 * (later.index * count + i), share, out.poses, 7 * i);
    }
    out.contacts = this.hasContacts ? from.block.contacts[from.index] : null;
    return out;
  }
}

export const isPresent = (state) => state !== ABSENT;
export const isAsleep = (state) => state >= ASLEEP;
export const levelOf = (state) => state & 127;

// Between two frames a body turns little: its quaternion's numbers may be mixed as they are.
function mix(a, i, b, j, share, out, k) {
  for (let part = 0; part < 3; ++part) out[k + part] = a[i + part] + share * (b[j + part] - a[i + part]);
  let dot = 0;
  for (let part = 3; part < 7; ++part) dot += a[i + part] * b[j + part];
  const sign = dot < 0 ? -1 : 1;
  let length = 0;
  for (let part = 3; part < 7; ++part) {
    const value = (1 - share) * a[i + part] + share * sign * b[j + part];
    out[k + part] = value;
    length += value * value;
  }
  length = Math.sqrt(length) || 1;
  for (let part = 3; part < 7; ++part) out[k + part] /= length;
}
