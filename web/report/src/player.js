// The one time cursor of the page. Frames count from 0, before the first step.

const UNHURRIED = 120;  // milliseconds

/** Plays, and tells its listeners which frame is shown. */
export class Player {
  constructor(frames, stepSeconds) {
    this.frames = frames;
    this.stepSeconds = stepSeconds;
    this.position = 0;
    this.hovered = null;
    this.speed = 1;
    this.isPlaying = false;
    this.listeners = [];
    this.tick = this.tick.bind(this);
  }

  /** The frame that everything shows: what the pointer is over in a plot, else where the player is. */
  get shown() {
    return this.hovered ?? this.position;
  }

  /** The shown frame as a row of the frame data has it, from 1. */
  get row() {
    return Math.min(Math.max(Math.round(this.shown), 1), this.frames);
  }

  /** `listener(player)` is called after every change. */
  onChange(listener) {
    this.listeners.push(listener);
  }

  /** The same for what is costly and need not follow each picture while it plays. */
  onChangeUnhurried(listener) {
    let calledAt = 0;
    this.onChange(() => {
      if (this.isPlaying && performance.now() - calledAt < UNHURRIED) return;
      listener(this);
      calledAt = performance.now();
    });
  }

  seek(frame) {
    this.position = Math.min(Math.max(frame, 0), this.frames);
    this.hovered = null;
    this.tell();
  }

  /** Steps over whole frames. */
  step(by) {
    this.pause();
    this.seek(Math.round(this.position) + by);
  }

  /** Shows another frame for as long as the pointer is there; null: no more. Not while it plays. */
  hover(frame) {
    if (this.isPlaying || frame === this.hovered) return;
    this.hovered = frame;
    this.tell();
  }

  setSpeed(speed) {
    this.speed = speed;
    this.tell();
  }

  toggle() {
    if (this.isPlaying) this.pause();
    else this.play();
  }

  play() {
    if (this.isPlaying) return;
    if (this.position >= this.frames) this.position = 0;
    this.hovered = null;
    this.isPlaying = true;
    this.before = null;
    requestAnimationFrame(this.tick);
    this.tell();
  }

  pause() {
    if (!this.isPlaying) return;
    this.isPlaying = false;
    this.tell();
  }

  tick(now) {
    if (!this.isPlaying) return;
    // A page that was hidden, or a picture that took long, does not make the film jump far.
    const seconds = this.before === null ? 0 : Math.min((now - this.before) / 1000, 0.25);
    this.before = now;
    this.position = Math.min(this.position + (seconds * this.speed) / this.stepSeconds, this.frames);
    if (this.position >= this.frames) this.isPlaying = false;
    this.tell();
    if (this.isPlaying) requestAnimationFrame(this.tick);
  }

  tell() {
    for (const listener of this.listeners) listener(this);
  }
}
