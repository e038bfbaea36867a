// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The curves that the user has set, and earlier states of them. A state is never changed, so that undoing is to go back
// to it. A curve is {id, name, color, tool, points, options}; its points are places of the surface.

import { tools } from './curve_tools.js';

const mostStates = 500;

export class Curve_list {
  // options: those of the first curve
  constructor(options) {
    this.states = [{ curves: [], active: 0, next: 1 }];
    this.at = 0;
    this.addCurve('path', options);
    this.forget();
  }

  // The state as it is becomes the first.
  forget() {
    this.states = [this.state];
    this.at = 0;
    this.step = undefined;
  }

  get state() {
    return this.states[this.at];
  }

  get curves() {
    return this.state.curves;
  }

  get active() {
    return this.curves.find((curve) => curve.id === this.state.active);
  }

  get canUndo() {
    return this.at > 0;
  }

  get canRedo() {
    return this.at + 1 < this.states.length;
  }

  undo() {
    if (this.canUndo) --this.at;
    this.step = undefined;
  }

  redo() {
    if (this.canRedo) ++this.at;
    this.step = undefined;
  }

  // A change that has the same `step` as the one before it, as those of a drag do, is undone together with it.
  change(changes, step) {
    const isSameStep = step !== undefined && step === this.step && this.canUndo;
    const kept = this.states.slice(isSameStep || this.at + 1 < mostStates ? 0 : 1, isSameStep ? this.at : this.at + 1);
    this.states = [...kept, { ...this.state, ...changes }];
    this.at = this.states.length - 1;
    this.step = step;
  }

  changeCurve(id, changes, step) {
    this.change({ curves: this.curves.map((curve) => (curve.id === id ? { ...curve, ...changes } : curve)) }, step);
  }

  addCurve(tool, options) {
    const { next, curves } = this.state;
    const curve = { id: next, name: `curve ${next}`, color: null, tool, points: [], options };
    this.change({ curves: [...curves, curve], active: next, next: next + 1 });
  }

  // The last one is replaced by an empty one.
  removeCurve(id) {
    const { tool, options } = this.active;
    const curves = this.curves.filter((curve) => curve.id !== id);
    const isActive = id === this.state.active && curves.length > 0;
    this.change({ curves, active: isActive ? curves.at(-1).id : this.state.active });
    if (curves.length > 0) return;
    this.addCurve(tool, options);
    this.states.splice(--this.at, 1); // the state without curves
  }

  // The choice of the edited curve is not a step of its own.
  choose(id) {
    this.states[this.at] = { ...this.state, active: id };
    this.step = undefined;
  }

  chooseTool(tool) {
    const { id, options, points } = this.active;
    const closed = tools[tool].isClosed ?? false;
    this.changeCurve(id, { tool, points, options: { ...options, closed } });
  }
}
