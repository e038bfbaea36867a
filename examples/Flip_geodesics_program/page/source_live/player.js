// SPDX-License-Identifier: LGPL-3.0-or-later

import { Playback } from '../source/playback.js';
import { plural } from '../source/words.js';
import { at } from './panel.js';

// Plays the flips of the curve that is edited, if they were recorded.
export class Player {
  // draw: is called after each step
  constructor(draw) {
    this.draw = draw;
    at('step').addEventListener('input', () => {
      this.pause();
      this.goTo(Number(at('step').value));
    });
  }

  show(run, stage) {
    if (run === this.run) return;
    this.pause();
    this.run = run;
    this.playback = run && run.edges.length > 0 ? new Playback(run) : null;
    at('player').hidden = !this.playback || this.playback.length === 0;
    if (!this.playback) return;
    stage.setQuietEdges(run);
    at('step').max = this.playback.length;
    this.playback.goTo(this.playback.length);
    this.describe();
  }

  get isInTheMiddle() {
    return Boolean(this.playback) && this.playback.step < this.playback.length;
  }

  // All intrinsic edges, and those that the last step has made.
  edges() {
    return [this.playback.edges, this.playback.fresh].map((edges) => this.playback.piecesOf(edges));
  }

  describe() {
    const { step, length, flips } = this.playback;
    at('step').value = step;
    at('step-text').textContent = `step ${step} of ${length}, ${plural(flips, 'flip')}`;
  }

  goTo(step) {
    this.playback.goTo(Math.max(0, Math.min(step, this.playback.length)));
    this.describe();
    this.draw();
  }

  play() {
    if (this.timer) return this.pause();
    if (!this.isInTheMiddle) this.goTo(0);
    at('play').textContent = '|| Pause';
    const stride = Math.max(1, Math.ceil(this.playback.length / 300));
    const period = Math.max(16, Math.min(300, 6000 / this.playback.length));
    this.timer = setInterval(() => {
      this.goTo(this.playback.step + stride);
      if (!this.isInTheMiddle) this.pause();
    }, period);
    return undefined;
  }

  pause() {
    clearInterval(this.timer);
    this.timer = undefined;
    at('play').textContent = '\u25B6 Play the flips';
  }
}
