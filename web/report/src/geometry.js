// What bodies look like: geometries with coarser versions of each for bodies that are small in the picture.
import { MeshoptSimplifier } from 'meshoptimizer/simplifier';
import * as THREE from 'three';
import { unpack } from './data.js';

// A body gets the first version whose limit its radius, in pixels, is above.
const DETAILS = [
  { pixels: 60, triangles: Infinity },
  { pixels: 12, triangles: 160 },
  { pixels: 0, triangles: 40 },
];

export function detailFor(pixels, details) {
  for (let i = 0; i < details; ++i) if (pixels > DETAILS[i].pixels) return i;
  return details - 1;
}

function simplified(positions, indices, triangles) {
  const target = 3 * triangles;
  if (indices.length <= 1.3 * target) return indices;
  const [careful] = MeshoptSimplifier.simplify(indices, positions, 3, target, 0.1, ['Prune']);
  if (careful.length <= 1.5 * target && careful.length > 0) return careful;
  const [sloppy] = MeshoptSimplifier.simplifySloppy(indices, positions, 3, null, target, 0.3);
  return sloppy.length > 0 ? sloppy : indices;
}

function geometryOf(positions, indices) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(positions, 3));
  geometry.setIndex(new THREE.BufferAttribute(indices, 1));
  return geometry;
}

function withDetails(positions, indices) {
  const details = [];
  for (const { triangles } of DETAILS) {
    const chosen = simplified(positions, indices, triangles);
    if (details.length === 0 || chosen.length < 0.8 * details.at(-1).index.count) {
      details.push(compacted(positions, chosen));
    }
  }
  return details;
}

// Without the vertices that no triangle has any more.
function compacted(positions, indices) {
  const [remap, count] = MeshoptSimplifier.compactMesh(indices.slice());
  const kept = new Float32Array(3 * count);
  remap.forEach((to, from) => {
    if (to < count) kept.set(positions.subarray(3 * from, 3 * from + 3), 3 * to);
  });
  return geometryOf(kept, indices.map((index) => remap[index]));
}

function radiusOf(positions) {
  let radius = 0;
  for (let i = 0; i < positions.length; i += 3) {
    radius = Math.max(radius, Math.hypot(positions[i], positions[i + 1], positions[i + 2]));
  }
  return radius;
}

/** The shapes of a page: `look` and one for each level, each { details, radius }. */
export class Shapes {
  /** To be awaited before a shape is asked for. */
  static ready() {
    return MeshoptSimplifier.ready;
  }

  constructor(look) {
    this.look = look;
    this.bytes = unpack(look);
    this.meshes = new Map();
    this.box = { details: [new THREE.BoxGeometry(2, 2, 2)], radius: Math.sqrt(3) };
    this.sphere = {
      details: [new THREE.IcosahedronGeometry(1, 3), new THREE.IcosahedronGeometry(1, 1), new THREE.IcosahedronGeometry(1, 0)],
      radius: 1,
    };
  }

  isPlane(shape) {
    return this.look.shapes[shape].is === 'plane';
  }

  isBox(shape) {
    return this.look.shapes[shape].is === 'box';
  }

  /** At a level, or as it is drawn (0). */
  of(shape, level) {
    const { is, look, levels } = this.look.shapes[shape];
    if (is === 'box') return this.box;
    if (is === 'sphere') return this.sphere;
    return this.mesh(level === 0 ? look : levels[Math.min(level, levels.length) - 1]);
  }

  mesh(number) {
    if (!this.meshes.has(number)) {
      const { at, vertices, triangles } = this.look.meshes[number];
      const data = this.bytes.slice(at, at + 12 * (vertices + triangles));
      const positions = new Float32Array(data.buffer, 0, 3 * vertices);
      const indices = new Uint32Array(data.buffer, 12 * vertices, 3 * triangles);
      this.meshes.set(number, { details: withDetails(positions, indices), radius: radiusOf(positions) });
    }
    return this.meshes.get(number);
  }
}
