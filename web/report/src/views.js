// Worlds beside each other in 3D: one canvas, one camera, drawn when something has changed.
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { h, whenNear } from './dom.js';

// While it plays, a machine that cannot keep up draws fewer pixels and coarser bodies. Seconds between two pictures.
const TOO_SLOW = 1 / 34;
const FAST_ENOUGH = 1 / 50;
const LEAST_PIXELS = 0.5;
const LEAST_DETAIL = 0.15;

function isSoftware() {
  const gl = document.createElement('canvas').getContext('webgl2');
  const info = gl?.getExtension('WEBGL_debug_renderer_info');
  const name = info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : '';
  gl?.getExtension('WEBGL_lose_context')?.loseContext();
  return /swiftshader|llvmpipe|software|basic render/i.test(name);
}

/** Chooses how well is drawn, so that it plays smoothly; a picture that stands still is drawn as well as can be. */
class Quality {
  constructor() {
    this.best = Math.min(window.devicePixelRatio, 2);
    this.rest();
    this.playing = 1;
  }

  /** To be told of each picture while it plays. */
  note(now) {
    const seconds = this.last === null ? null : (now - this.last) / 1000;
    this.last = now;
    if (seconds !== null && seconds < 1) {
      this.mean = 0.85 * this.mean + 0.15 * seconds;
      const wanted = this.mean > TOO_SLOW ? 0.88 : this.mean < FAST_ENOUGH ? 1.04 : 1;
      this.playing = Math.min(Math.max(this.playing * wanted, LEAST_DETAIL), 1);
      if (wanted < 1) this.mean = 0.5 * (TOO_SLOW + FAST_ENOUGH);
    }
    this.pixelRatio = this.best * Math.max(LEAST_PIXELS, this.playing);
    this.detail = this.playing;
  }

  rest() {
    this.last = null;
    this.mean = 0.5 * (TOO_SLOW + FAST_ENOUGH);
    this.pixelRatio = this.best;
    this.detail = 1;
  }
}

export class Views {
  /** `panes`: { view, caption }, `view` a WorldView, null for a world that cannot be played, and `caption` an element. */
  constructor(panes, player, looks) {
    this.player = player;
    this.looks = looks;
    this.panes = panes.map(({ view, caption, note }) => ({
      view, isShown: true, element: h('div', { className: 'pane' }, caption, note ? h('p', { className: 'pane-note' }, note) : null),
    }));
    this.canvas = h('canvas', { ariaLabel: 'The worlds in 3D' });
    this.element = h('div', { className: 'views' }, this.canvas, ...this.panes.map((pane) => pane.element));
    const software = isSoftware();
    this.renderer = new THREE.WebGLRenderer({ canvas: this.canvas, antialias: !software, stencil: false, powerPreference: 'high-performance' });
    this.renderer.setScissorTest(true);
    this.quality = new Quality();
    this.camera = new THREE.PerspectiveCamera(45, 1, 0.1, 10000);
    this.controls = new OrbitControls(this.camera, this.element);
    this.controls.addEventListener('start', () => this.follow(false));
    this.controls.addEventListener('change', () => this.draw());
    // The wheel scrolls the page until somebody has turned to the picture.
    this.controls.enableZoom = false;
    this.element.addEventListener('pointerdown', () => {
      this.controls.enableZoom = true;
    });
    this.element.addEventListener('pointerleave', () => {
      this.controls.enableZoom = false;
    });
    this.element.style.touchAction = 'pan-y';  // A page that cannot be scrolled on a phone is a trap.
    this.follows = true;
    this.pictures = 0;
    this.isNear = true;
    this.placeCamera();
    whenNear(this.element, 0, (near) => {
      this.isNear = near;
      if (near) this.draw();
    });
    new ResizeObserver(() => this.draw()).observe(this.element);
    player.onChange(() => this.draw());
  }

  /** Gives the graphics memory back; nothing may be drawn afterwards. */
  dispose() {
    this.isNear = false;
    this.draw = () => {};
    this.renderer.dispose();
    this.renderer.forceContextLoss();
  }

  /** Whether the camera goes where something happens. */
  follow(follows) {
    if (follows === this.follows) return;
    this.follows = follows;
    this.onFollow?.(follows);
    if (follows) this.draw();
  }

  showPane(number, isShown) {
    this.panes[number].isShown = isShown;
    this.panes[number].element.hidden = !isShown;
    this.draw();
  }

  /** Soon, once for all that has changed. */
  draw() {
    if (this.isAsked) return;
    this.isAsked = true;
    requestAnimationFrame((now) => {
      this.isAsked = false;
      if (this.isNear) this.drawNow(now);
    });
  }

  drawNow(now) {
    if (this.player.isPlaying) this.quality.note(now);
    else this.quality.rest();
    if (this.follows) this.watchAction();
    const area = this.canvas.getBoundingClientRect();
    if (area.width === 0 || area.height === 0) return;
    this.renderer.setPixelRatio(this.quality.pixelRatio);
    this.renderer.setSize(area.width, area.height, false);
    this.camera.userData.target = this.controls.target;
    for (const pane of this.panes) if (pane.isShown && pane.view) this.drawPane(pane, area);
    ++this.pictures;
  }

  drawPane({ view, element }, area) {
    const box = element.getBoundingClientRect();
    const x = box.left - area.left;
    const y = area.bottom - box.bottom;
    this.camera.aspect = box.width / box.height;
    this.camera.updateProjectionMatrix();
    this.camera.updateMatrixWorld();
    this.renderer.setViewport(x, y, box.width, box.height);
    this.renderer.setScissor(x, y, box.width, box.height);
    view.show(this.player.shown, this.looks, this.camera, box.height * this.quality.pixelRatio * this.quality.detail);
    this.renderer.render(view.scene, this.camera);
  }

  aspect() {
    const shown = this.panes.find((pane) => pane.isShown);
    const box = shown?.element.getBoundingClientRect();
    return box && box.height > 0 ? box.width / box.height : 1.5;
  }

  placeCamera() {
    const direction = new THREE.Vector3(Math.sin(0.6) * Math.cos(0.3), Math.sin(0.3), Math.cos(0.6) * Math.cos(0.3));
    this.camera.position.copy(direction.multiplyScalar(20));
    this.controls.target.set(0, 0, 0);
    this.watchAction(1);
  }

  // Of all worlds alike: a camera that preferred one would tell which it is.
  watchAction(share = 0.08) {
    const seen = this.panes.filter((pane) => pane.view && pane.isShown).map(({ view }) => view);
    if (seen.length === 0) return;
    const actions = seen.map((view) => view.action(this.player.shown));
    const center = actions.reduce((sum, action) => sum.addScaledVector(action.center, 1 / actions.length), new THREE.Vector3());
    const radius = Math.max(...actions.map((action) => action.radius + 0.5 * action.center.distanceTo(center)));
    const jumped = Math.abs(this.player.shown - (this.watched ?? -1000)) > 15;
    this.watched = this.player.shown;
    const part = jumped ? 1 : share;
    const half = (this.camera.fov * Math.PI) / 360;
    const fit = radius / Math.sin(Math.min(half, Math.atan(Math.tan(half) * this.aspect())));
    const offset = this.camera.position.clone().sub(this.controls.target);
    const distance = offset.length() + part * (Math.max(fit, 2 * seen[0].typicalRadius()) - offset.length());
    // What is fast is not left behind.
    const lag = this.controls.target.clone().sub(center).multiplyScalar(1 - part).clampLength(0, 0.3 * radius);
    this.controls.target.copy(center).add(lag);
    this.camera.position.copy(this.controls.target).add(offset.setLength(distance));
    this.camera.near = distance / 100;
    this.camera.far = distance * 100;
    this.camera.lookAt(this.controls.target);
  }

  /** Looks along the same line, from this much nearer. */
  zoom(factor) {
    this.follow(false);
    this.camera.position.lerp(this.controls.target, 1 - 1 / factor);
    this.draw();
  }
}
