// What bodies look like: geometries with coarser versions of each for bodies that are small in the picture.
import { MeshoptSimplifier } from 'meshoptimizer/simplifier';
import * as THREE from 'three';
import { ConvexGeometry } from 'three/addons/geometries/ConvexGeometry.js';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';
import { unpack } from './data.js';

// A body gets the first version whose limit its radius, in pixels, is above.
const DETAILS = [
  { pixels: 110, triangles: Infinity },
  { pixels: 30, triangles: 140 },
  { pixels: 9, triangles: 36 },
  { pixels: 0, triangles: 14 },
];

export function detailFor(pixels, details) {
  for (let i = 0; i < details; ++i) if (pixels > DETAILS[i].pixels) return i;
  return details - 1;
}

/** About so many triangles that look like these, as { positions, indices }. */
function simplified(positions, indices, triangles) {
  const target = 3 * triangles;
  if (indices.length <= 1.3 * target) return { positions, indices };
  const isFine = ([found]) => found.length > 0 && found.length <= 1.5 * target;
  const careful = MeshoptSimplifier.simplify(indices, positions, 3, target, 0.1, ['Prune']);
  if (isFine(careful)) return { positions, indices: careful[0] };
  const sloppy = MeshoptSimplifier.simplifySloppy(indices, positions, 3, null, target, 0.5);
  if (isFine(sloppy)) return { positions, indices: sloppy[0] };
  return hullOf(positions, triangles);
}

// Of parts that lie apart nothing can be merged: what is left is the hull of the points that are furthest out.
function hullOf(positions, triangles) {
  const outermost = new Set();
  const directions = triangles > 20 ? 20 : 8;
  for (let i = 0; i < directions; ++i) {
    // Evenly over the sphere, along a spiral.
    const y = 1 - (2 * i + 1) / directions;
    const side = Math.sqrt(1 - y * y);
    const [x, z] = [side * Math.cos(2.4 * i), side * Math.sin(2.4 * i)];
    let best = 0;
    let most = -Infinity;
    for (let vertex = 0; vertex < positions.length; vertex += 3) {
      const reach = x * positions[vertex] + y * positions[vertex + 1] + z * positions[vertex + 2];
      if (reach > most) [best, most] = [vertex, reach];
    }
    outermost.add(best);
  }
  const points = [...outermost].map((vertex) => new THREE.Vector3().fromArray(positions, vertex));
  const merged = mergedOf(new ConvexGeometry(points));
  return { positions: merged.attributes.position.array, indices: merged.index.array };
}

function withDetails(positions, indices) {
  const details = [];
  for (const { triangles } of DETAILS) {
    const chosen = simplified(positions, indices, triangles);
    if (details.length === 0 || chosen.indices.length < 0.8 * details.at(-1).indices.length) {
      details.push(faceted(chosen.positions, chosen.indices));
    }
  }
  return details;
}

function normalOf(positions, [a, b, c]) {
  const [p, q, r] = [a, b, c].map((vertex) => new THREE.Vector3().fromArray(positions, 3 * vertex));
  return q.sub(p).cross(r.sub(p)).normalize();
}

/**
 * Each triangle with a last vertex of its own, which holds the normal of the face: what OpenGL colours flat faces by. Vertices
 * that no triangle has are left out.
 */
function faceted(positions, indices) {
  const places = [];
  const normals = [];
  const owned = new Map();
  const result = new Uint32Array(indices.length);
  const add = (vertex, normal) => {
    places.push(positions[3 * vertex], positions[3 * vertex + 1], positions[3 * vertex + 2]);
    normals.push(...(normal?.toArray() ?? [0, 1, 0]));
    return places.length / 3 - 1;
  };
  const copyOf = (vertex) => {
    if (!owned.has(vertex)) owned.set(vertex, { place: add(vertex, null), isTaken: false });
    return owned.get(vertex);
  };
  for (let i = 0; i < indices.length; i += 3) {
    const triangle = indices.slice(i, i + 3);
    const normal = normalOf(positions, triangle);
    const copies = [...triangle].map(copyOf);
    const free = copies.findIndex((copy) => !copy.isTaken);
    const last = free < 0 ? 2 : free;
    if (free < 0) {
      copies[last] = { place: add(triangle[last], normal) };
    } else {
      copies[last].isTaken = true;
      normal.toArray(normals, 3 * copies[last].place);
    }
    for (let corner = 1; corner <= 3; ++corner) result[i + corner - 1] = copies[(last + corner) % 3].place;
  }
  return { positions: new Float32Array(places), normals: new Float32Array(normals), indices: result };
}

function mergedOf(geometry) {
  geometry.deleteAttribute('normal');
  geometry.deleteAttribute('uv');
  return mergeVertices(geometry);
}

function facetedOf(geometry) {
  const merged = mergedOf(geometry);
  return faceted(merged.attributes.position.array, merged.index.array);
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
    this.box = { details: [facetedOf(new THREE.BoxGeometry(2, 2, 2))], radius: Math.sqrt(3) };
    this.sphere = { details: [4, 2, 1, 0].map((detail) => facetedOf(new THREE.IcosahedronGeometry(1, detail))), radius: 1 };
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
