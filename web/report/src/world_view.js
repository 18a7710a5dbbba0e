// One world in 3D: its bodies at a frame.
import * as THREE from 'three';
import { css, kindColors, levelColor, paler } from './colors.js';
import { detailFor } from './geometry.js';
import { isAsleep, isPresent, levelOf } from './motion.js';

// The camera shows at most a ball of so many radii of a typical body, which would be a speck else.
const SPECKS = 18;
const MOST_WATCHED = 400;
const CONTACT_COLOR = [1, 0.85, 0.2];
const BACKGROUND = 0x10151d;

// A machine without a graphics card takes long for each instance, each triangle and each thing that is done for a pixel. So all
// bodies are one mesh, which is made anew for each picture, and each face has one colour, the light in it.
const VERTEX = `
  uniform mat4 modelViewMatrix;
  uniform mat4 projectionMatrix;
  in vec3 position;
  in vec4 color;
  flat out vec4 face;
  void main() {
    face = color;
    gl_Position = projectionMatrix * (modelViewMatrix * vec4(position, 1.0));
  }`;
const FRAGMENT = `
  precision mediump float;
  flat in vec4 face;
  out vec4 pixel;
  void main() {
    pixel = face;
  }`;

const TO_LIGHT = new THREE.Vector3(0.45, 0.8, 0.4).normalize();

/** Bodies as one mesh. */
class Batch {
  constructor(scene, side) {
    this.geometry = new THREE.BufferGeometry();
    this.mesh = new THREE.Mesh(this.geometry, new THREE.RawShaderMaterial({
      vertexShader: VERTEX, fragmentShader: FRAGMENT, glslVersion: THREE.GLSL3, side,
    }));
    this.mesh.frustumCulled = false;
    scene.add(this.mesh);
    this.grow(1024, 4096);
    this.clear();
  }

  clear() {
    this.vertices = 0;
    this.corners = 0;
  }

  grow(vertices, corners) {
    const { positions, colors, indices } = this;
    this.positions = new Float32Array(3 * vertices);
    this.colors = new Uint32Array(vertices);
    this.indices = new Uint32Array(corners);
    if (positions) {
      this.positions.set(positions);
      this.colors.set(colors);
      this.indices.set(indices);
    }
    this.geometry.dispose();
    const dynamic = (array, size, normalized) => new THREE.BufferAttribute(array, size, normalized).setUsage(THREE.DynamicDrawUsage);
    this.geometry.setAttribute('position', dynamic(this.positions, 3, false));
    this.geometry.setAttribute('color', dynamic(new Uint8Array(this.colors.buffer), 4, true));
    this.geometry.setIndex(dynamic(this.indices, 1, false));
  }

  /** A geometry of Shapes at a place; `turn` is its rotation alone. */
  add({ positions, normals, indices }, place, turn, [red, green, blue]) {
    const count = positions.length / 3;
    if (this.vertices + count > this.colors.length || this.corners + indices.length > this.indices.length) {
      this.grow(2 * (this.vertices + count), 2 * (this.corners + indices.length));
    }
    const [a, b, c, , d, e, f, , g, h, i, , x, y, z] = place;
    // The light on a face is what its normal has of these two directions, in the body's axes.
    const upX = turn[1], upY = turn[5], upZ = turn[9];
    const sunX = turn[0] * TO_LIGHT.x + turn[1] * TO_LIGHT.y + turn[2] * TO_LIGHT.z;
    const sunY = turn[4] * TO_LIGHT.x + turn[5] * TO_LIGHT.y + turn[6] * TO_LIGHT.z;
    const sunZ = turn[8] * TO_LIGHT.x + turn[9] * TO_LIGHT.y + turn[10] * TO_LIGHT.z;
    let at = 3 * this.vertices;
    for (let vertex = 0; vertex < count; ++vertex) {
      const px = positions[3 * vertex], py = positions[3 * vertex + 1], pz = positions[3 * vertex + 2];
      this.positions[at++] = a * px + d * py + g * pz + x;
      this.positions[at++] = b * px + e * py + h * pz + y;
      this.positions[at++] = c * px + f * py + i * pz + z;
      const nx = normals[3 * vertex], ny = normals[3 * vertex + 1], nz = normals[3 * vertex + 2];
      const sun = sunX * nx + sunY * ny + sunZ * nz;
      const light = 255 * (0.46 + 0.2 * (upX * nx + upY * ny + upZ * nz) + 0.34 * (sun > 0 ? sun : 0.3 * sun));
      this.colors[this.vertices + vertex] = (red * light) | ((green * light) << 8) | ((blue * light) << 16) | 0xff000000;
    }
    for (let corner = 0; corner < indices.length; ++corner) this.indices[this.corners + corner] = this.vertices + indices[corner];
    this.vertices += count;
    this.corners += indices.length;
  }

  finish() {
    this.mesh.visible = this.corners > 0;
    this.geometry.setDrawRange(0, this.corners);
    const { position, color } = this.geometry.attributes;
    for (const [attribute, length] of [[position, 3 * this.vertices], [color, 4 * this.vertices], [this.geometry.index, this.corners]]) {
      attribute.clearUpdateRanges();
      attribute.addUpdateRange(0, length);
      attribute.needsUpdate = true;
    }
  }
}

/** Points where bodies touch. */
class ContactPoints {
  constructor(scene) {
    this.geometry = new THREE.BufferGeometry();
    this.points = new THREE.Points(this.geometry, new THREE.PointsMaterial({
      size: 3, sizeAttenuation: false, vertexColors: true, depthTest: false,
    }));
    this.points.frustumCulled = false;
    this.capacity = 0;
    scene.add(this.points);
  }

  show(contacts, levels) {
    const count = contacts?.count ?? 0;
    this.points.visible = count > 0;
    if (count === 0) return;
    if (count > this.capacity) this.grow(2 * count);
    this.geometry.attributes.position.array.set(contacts.points);
    const colors = this.geometry.attributes.color.array;
    for (let i = 0; i < count; ++i) {
      const level = contacts.levels[i];
      colors.set(level > 0 && levels > 1 ? levelColor(level, levels) : CONTACT_COLOR, 3 * i);
    }
    this.geometry.attributes.position.needsUpdate = true;
    this.geometry.attributes.color.needsUpdate = true;
    this.geometry.setDrawRange(0, count);
  }

  grow(capacity) {
    this.capacity = capacity;
    this.geometry.dispose();
    for (const name of ['position', 'color']) {
      this.geometry.setAttribute(name, new THREE.BufferAttribute(new Float32Array(3 * capacity), 3));
    }
  }
}

export class WorldView {
  constructor(shapes, motion) {
    this.shapes = shapes;
    this.motion = motion;
    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color(BACKGROUND);
    this.moving = new Batch(this.scene, THREE.FrontSide);
    this.fixed = new Batch(this.scene, THREE.DoubleSide);
    this.contacts = new ContactPoints(this.scene);
    this.edges = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: 0x6b7684 }));
    this.edges.frustumCulled = false;
    this.scene.add(this.edges);
    this.kinds = kindColors(motion.bodies);
    this.levels = Math.max(...motion.bodies.map((body) => body.levels));
    this.sampled = {};
    const moving = motion.bodies.map((body, i) => (body.isStatic ? -1 : i)).filter((i) => i >= 0);
    const each = Math.ceil(moving.length / MOST_WATCHED);
    this.watched = moving.filter((_, place) => place % each === 0);
    this.colors = this.bodyColors();
  }

  // Of each body by its level, from 1, and by its kind, awake and asleep.
  bodyColors() {
    const known = new Map();
    return this.motion.bodies.map(({ levels }, i) => {
      const key = `${levels} ${this.kinds[i]}`;
      if (!known.has(key)) {
        const own = this.kinds[i];
        const byLevel = levels > 1 ? Array.from({ length: levels }, (_, level) => levelColor(level + 1, levels)) : [own];
        const both = (color) => [color, paler(color)];
        known.set(key, { kind: both(own), levels: byLevel.map(both) });
      }
      return known.get(key);
    });
  }

  /** Puts all bodies where they are. `looks`: { byLevel, sleep, collisionShapes, contacts }. */
  show(frame, looks, camera, height) {
    const { states, poses, contacts } = this.sample(frame);
    this.moving.clear();
    this.fixed.clear();
    frustum.setFromProjectionMatrix(matrix.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse));
    const pixelsAtOne = height / (2 * Math.tan((camera.fov * Math.PI) / 360));
    const hidden = [];
    this.motion.bodies.forEach((body, i) => {
      if (!isPresent(states[i])) return;
      const level = levelOf(states[i]);
      const shape = this.shapes.of(body.shape, looks.collisionShapes ? level : 0);
      const size = shape.radius * Math.max(...body.scale);
      ball.center.fromArray(poses, 7 * i);
      ball.radius = size;
      if (!frustum.intersectsSphere(ball)) return;
      rotation.fromArray(poses, 7 * i + 3);
      matrix.compose(ball.center, rotation, scale.fromArray(body.scale));
      if (body.isStatic && this.shapes.isBox(body.shape) && hides(matrix, camera)) {
        hidden.push(matrix.clone());
        return;
      }
      const pixels = (size * pixelsAtOne) / Math.max(ball.center.distanceTo(camera.position), size);
      const detail = body.isStatic ? 0 : detailFor(pixels, shape.details.length);
      const batch = body.isStatic ? this.fixed : this.moving;
      batch.add(shape.details[detail], matrix.elements, turn.makeRotationFromQuaternion(rotation).elements,
        this.colorOf(i, level, states[i], looks));
    });
    this.moving.finish();
    this.fixed.finish();
    this.contacts.show(looks.contacts ? contacts : null, this.levels);
    this.showEdges(hidden);
  }

  colorOf(i, level, state, { byLevel, sleep }) {
    const colors = this.colors[i];
    const pair = byLevel ? colors.levels[Math.min(level, colors.levels.length) - 1] : colors.kind;
    return pair[sleep && isAsleep(state) && !this.motion.bodies[i].isStatic ? 1 : 0];
  }

  // Of walls between the camera and what is looked at only the edges are drawn.
  showEdges(boxes) {
    this.edges.visible = boxes.length > 0;
    if (boxes.length === 0) return;
    const corners = [];
    for (const box of boxes) {
      for (const [a, b] of BOX_EDGES) {
        for (const corner of [a, b]) position.set(...corner).applyMatrix4(box).toArray(corners, corners.length);
      }
    }
    this.edges.geometry.dispose();
    this.edges.geometry.setAttribute('position', new THREE.Float32BufferAttribute(corners, 3));
  }

  sample(frame) {
    if (this.sampledFrame !== frame) this.motion.sample(frame, this.sampled);
    this.sampledFrame = frame;
    return this.sampled;
  }

  /** What is worth looking at: the middle of the bodies that move, and how far most are from it, as long as they can be seen from there. */
  action(frame) {
    const { states, poses } = this.sample(frame);
    const places = [];
    for (const i of this.watched) if (isPresent(states[i])) places.push(poses.subarray(7 * i, 7 * i + 3));
    if (places.length === 0) return { center: new THREE.Vector3(), radius: 5 };
    const middle = [0, 1, 2].map((axis) => ranked(places.map((place) => place[axis]), 0.5));
    const far = ranked(places.map(([x, y, z]) => Math.hypot(x - middle[0], y - middle[1], z - middle[2])), 0.8);
    const typical = this.typicalRadius();
    return { center: new THREE.Vector3(...middle), radius: Math.min(Math.max(far + typical, 2 * typical), SPECKS * typical) };
  }

  typicalRadius() {
    this.typical ??= ranked(this.motion.bodies.filter((body) => !body.isStatic)
      .map((body) => this.shapes.of(body.shape, 0).radius * Math.max(...body.scale)), 0.5);
    return this.typical;
  }
}

/** How a level is shown in a legend. */
export const levelCss = (level, levels) => css(levelColor(level, levels));

const position = new THREE.Vector3();
const rotation = new THREE.Quaternion();
const scale = new THREE.Vector3();
const matrix = new THREE.Matrix4();
const turn = new THREE.Matrix4();
const ball = new THREE.Sphere();
const frustum = new THREE.Frustum();
const inverse = new THREE.Matrix4();
const ray = new THREE.Ray();
const hit = new THREE.Vector3();
const target = new THREE.Vector3();
const UNIT_BOX = new THREE.Box3(new THREE.Vector3(-1, -1, -1), new THREE.Vector3(1, 1, 1));

const BOX_EDGES = [];
for (let from = 0; from < 8; ++from) {
  for (const axis of [1, 2, 4]) {
    const corner = (bits) => [bits & 1 ? 1 : -1, bits & 2 ? 1 : -1, bits & 4 ? 1 : -1];
    if (!(from & axis)) BOX_EDGES.push([corner(from), corner(from | axis)]);
  }
}

/** Whether a box stands between the camera and what it looks at. */
function hides(box, camera) {
  inverse.copy(box).invert();
  ray.origin.copy(camera.position).applyMatrix4(inverse);
  target.copy(camera.userData.target).applyMatrix4(inverse);
  ray.direction.subVectors(target, ray.origin);
  const length = ray.direction.length();
  ray.direction.normalize();
  if (UNIT_BOX.containsPoint(ray.origin)) return true;
  const found = ray.intersectBox(UNIT_BOX, hit);
  return found !== null && found.distanceTo(ray.origin) < 0.9 * length;
}

function ranked(values, share) {
  values.sort((a, b) => a - b);
  return values[Math.min(values.length - 1, Math.floor(share * values.length))] ?? 1;
}
