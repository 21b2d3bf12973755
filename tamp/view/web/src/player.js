// Time: whether it runs, how fast, and who is told.

export const speeds = [0.1, 0.25, 0.5, 1, 2, 4, 8];

export class Player {
  /** `onChange(player)` is called after every change of time, speed or playing. */
  constructor(duration, onChange) {
    this.duration = duration;
    this.onChange = onChange;
    this.time = 0;
    this.speed = 1;
    this.playing = false;
  }

  seek(time) {
    this.time = Math.min(this.duration, Math.max(0, time));
    this.onChange(this);
  }

  setSpeed(speed) {
    this.speed = speed;
    this.onChange(this);
  }

  /** To the next faster (+1) or slower (-1) speed. */
  changeSpeed(step) {
    const index = speeds.indexOf(this.speed) + step;
    this.setSpeed(speeds[Math.min(speeds.length - 1, Math.max(0, index))]);
  }

  play() {
    if (this.playing || this.duration === 0) return;
    if (this.time >= this.duration) this.time = 0;
    this.playing = true;
    let last = performance.now();
    const step = (now) => {
      if (!this.playing) return;
      const elapsed = Math.max(0, now - last) / 1000;
      last = now;
      if (this.time + elapsed * this.speed >= this.duration) this.playing = false;
      this.seek(this.time + elapsed * this.speed);
      requestAnimationFrame(step);
    };
    requestAnimationFrame(step);
    this.onChange(this);
  }

  pause() {
    this.playing = false;
    this.onChange(this);
  }

  toggle() {
    if (this.playing) this.pause();
    else this.play();
  }
}
