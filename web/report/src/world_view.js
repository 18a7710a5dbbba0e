// One world in 3D: instances of its bodies' shapes at a frame.
import * as THREE from 'three';
import { css, kindColors, levelColor, paler } from './colors.js';
import { detailFor } from './geometry.js';
import { isAsleep, isPresent, levelOf } from './motion.js';

const CONTACT_COLOR = [1, 0.85, 0.2];
const BACKGROUND = 0x10151d;

function material(isStatic) {
  return new THREE.MeshLambertMaterial({ flatShading: true, side: isStatic ? THREE.DoubleSide : THREE.FrontSide });
}

/** Instances of one geometry in its details. */
class Crowd {
  constructor(scene, shape, capacity, isStatic) {
    this.shape = shape;
    this.isStatic = isStatic;
    this.meshes = shape.details.map((geometry) => {
      const mesh = new THREE.InstancedMesh(geometry, material(isStatic), capacity);
      mesh.instanceColor = new THREE.InstancedBufferAttribute(new Float32Array(3 * capacity), 3);
      mesh.instanceMatrix.setUsage(THREE.DynamicDrawUsage);
      mesh.frustumCulled = false;
      mesh.count = 0;
      scene.add(mesh);
      return mesh;
    });
  }

  clear() {
    for (const mesh of this.meshes) mesh.count = 0;
  }

  add(matrix, color, pixels) {
    const mesh = this.meshes[this.isStatic ? 0 : detailFor(pixels, this.meshes.length)];
    const i = mesh.count++;
    matrix.toArray(mesh.instanceMatrix.array, 16 * i);
    mesh.instanceColor.array.set(color, 3 * i);
  }

  finish() {
    for (const mesh of this.meshes) {
      mesh.visible = mesh.count > 0;
      mesh.instanceMatrix.needsUpdate = mesh.count > 0;
      mesh.instanceColor.needsUpdate = mesh.count > 0;
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

function lights() {
  const sun = new THREE.DirectionalLight(0xffffff, 2.2);
  sun.position.set(0.45, 0.8, 0.4);
  return [new THREE.HemisphereLight(0xdfe8ff, 0x555048, 1.5), sun];
}

export class WorldView {
  constructor(shapes, motion) {
    this.shapes = shapes;
    this.motion = motion;
    this.scene = new THREE.Scene();
    this.scene.background = new THREE.Color(BACKGROUND);
    this.scene.add(...lights());
    this.crowds = new Map();
    this.contacts = new ContactPoints(this.scene);
    this.edges = new THREE.LineSegments(new THREE.BufferGeometry(), new THREE.LineBasicMaterial({ color: 0x6b7684 }));
    this.edges.frustumCulled = false;
    this.scene.add(this.edges);
    this.kinds = kindColors(motion.bodies);
    this.levels = Math.max(...motion.bodies.map((body) => body.levels));
    this.sampled = {};
    this.capacities = this.countShapes();
    this.colors = this.bodyColors();
  }

  countShapes() {
    const counts = new Map();
    for (const { shape } of this.motion.bodies) counts.set(shape, (counts.get(shape) ?? 0) + 1);
    return counts;
  }

  // Of each body by its level, from 1, and by its kind, awake and asleep.
  bodyColors() {
    const known = new Map();
    return this.motion.bodies.map(({ levels }, i) => {
      const key = `${levels} ${this.kinds[i]}`;
      if (!known.has(key)) {
        const own = this.kinds[i];
        const byLevel = levels > 1 ? Array.from({ length: levels }, (_, level) => levelColor(level + 1, levels)) : [own];
        const linear = (color) => new THREE.Color().setRGB(...color, THREE.SRGBColorSpace).toArray();
        const both = (color) => [linear(color), linear(paler(color))];
        known.set(key, { kind: both(own), levels: byLevel.map(both) });
      }
      return known.get(key);
    });
  }

  crowd(shape, level, isStatic) {
    const key = `${shape} ${level} ${isStatic}`;
    if (!this.crowds.has(key)) {
      this.crowds.set(key, new Crowd(this.scene, this.shapes.of(shape, level), this.capacities.get(shape), isStatic));
    }
    return this.crowds.get(key);
  }

  /** Puts all bodies where they are. `looks`: { byLevel, sleep, collisionShapes, contacts }. */
  show(frame, looks, camera, height) {
    const { states, poses, contacts } = this.motion.sample(frame, this.sampled);
    for (const crowd of this.crowds.values()) crowd.clear();
    const pixelsAtOne = height / (2 * Math.tan((camera.fov * Math.PI) / 360));
    const hidden = [];
    this.motion.bodies.forEach((body, i) => {
      if (!isPresent(states[i])) return;
      position.fromArray(poses, 7 * i);
      rotation.fromArray(poses, 7 * i + 3);
      matrix.compose(position, rotation, scale.fromArray(body.scale));
      if (body.isStatic && this.shapes.isBox(body.shape) && hides(matrix, camera)) {
        hidden.push(matrix.clone());
        return;
      }
      const level = levelOf(states[i]);
      const crowd = this.crowd(body.shape, looks.collisionShapes ? level : 0, body.isStatic);
      const size = crowd.shape.radius * Math.max(...body.scale);
      const pixels = (size * pixelsAtOne) / Math.max(position.distanceTo(camera.position), size);
      crowd.add(matrix, this.colorOf(i, level, states[i], looks), pixels);
    });
    for (const crowd of this.crowds.values()) crowd.finish();
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

  /** What is worth looking at: the middle of the bodies that move, and how far most are from it. */
  action(frame) {
    const { states, poses } = this.motion.sample(frame, this.sampled);
    const places = [];
    this.motion.bodies.forEach((body, i) => {
      if (isPresent(states[i]) && !body.isStatic) places.push(poses.subarray(7 * i, 7 * i + 3));
    });
    if (places.length === 0) return { center: new THREE.Vector3(), radius: 5 };
    const middle = [0, 1, 2].map((axis) => ranked(places.map((place) => place[axis]), 0.5));
    const center = new THREE.Vector3(...middle);
    const far = ranked(places.map(([x, y, z]) => Math.hypot(x - middle[0], y - middle[1], z - middle[2])), 0.8);
    return { center, radius: far + this.typicalRadius() };
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
