// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Pointer and keyboard on the view. A press on a point drags it; elsewhere one that does not move adds a point. The stage
// turns by all other drags.

import { at } from './panel.js';

const reach = 12; // in pixels, of a press to a point
const fewestPixels = 4; // of a drag
const [step, fineStep] = [8, 1]; // in pixels, of a point that is moved by the arrow keys
const turn = 0.15; // in radians, of the view by the arrow keys
// Elements that use all keys themselves, and those that use the arrow keys.
const textTakers = 'select, input:not([type=checkbox], [type=radio], [type=range], [type=color])';
const arrowTakers = 'input[type=radio], input[type=range]';
const arrows = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

export class Canvas_input {
  constructor(page, canvas) {
    this.page = page;
    this.drag = null; // {from, point, isMoved}: where the press was, and the point that it drags
    this.under = document.createElement('p');
    this.under.id = 'under';
    canvas.after(this.under);
    canvas.addEventListener('pointerdown', (event) => this.press(event), { capture: true });
    canvas.addEventListener('pointermove', (event) => this.move(event));
    canvas.addEventListener('pointerup', (event) => this.release(event));
    canvas.addEventListener('pointercancel', () => this.endDrag());
    canvas.addEventListener('pointerleave', () => (this.under.textContent = ''));
    canvas.addEventListener('contextmenu', (event) => {
      event.preventDefault();
      const hit = this.pointAt(event.clientX, event.clientY);
      if (hit) page.removePoint(hit.i, hit.curve.id);
    });
    addEventListener('keydown', (event) => this.onKey(event));
  }

  get stage() {
    return this.page.stage;
  }

  // The point of a curve that is under the pointer: of the curve that is edited, if there are several.
  pointAt(x, y) {
    const { list } = this.page;
    let [nearest, least] = [null, reach];
    for (const curve of [list.active, ...list.curves.filter((c) => c !== list.active)])
      this.page.pointsOf(curve).forEach(({ position }, i) => {
        const [px, py] = this.stage.project(position);
        const distance = Math.hypot(px - x, py - y);
        if (distance < least && this.stage.isVisible(position)) [nearest, least] = [{ curve, i }, distance];
      });
    return nearest;
  }

  press(event) {
    if (event.button !== 0) return;
    const hit = event.shiftKey ? null : this.pointAt(event.clientX, event.clientY);
    this.drag = { from: [event.clientX, event.clientY], hit, isMoved: false };
    this.stage.controls.enabled = !hit;
    if (!hit) return;
    event.target.setPointerCapture?.(event.pointerId);
    if (hit.curve !== this.page.list.active) this.page.chooseCurve(hit.curve.id);
    this.page.choosePoint(hit.i);
    this.page.beginDrag();
  }

  move({ clientX, clientY, pointerType }) {
    if (this.drag && Math.hypot(clientX - this.drag.from[0], clientY - this.drag.from[1]) >= fewestPixels) this.drag.isMoved = true;
    if (this.drag?.hit && this.drag.isMoved) {
      const place = this.stage.pick(clientX, clientY);
      if (place) this.page.dragPoint(this.drag.hit.i, place, this.drag);
    } else if (!this.drag && pointerType !== 'touch') {
      this.showUnder(clientX, clientY);
    }
  }

  release(event) {
    const { drag } = this;
    this.endDrag();
    if (!drag || drag.hit || drag.isMoved) return;
    const place = this.stage.pick(event.clientX, event.clientY);
    if (place) this.page.addPoint(place, event.shiftKey);
  }

  endDrag() {
    if (this.drag?.hit) this.page.endDrag();
    this.drag = null;
    if (this.stage) this.stage.controls.enabled = true;
  }

  // The coordinates under the pointer and the nearest vertex, once per frame.
  showUnder(x, y) {
    cancelAnimationFrame(this.frame);
    this.frame = requestAnimationFrame(() => {
      const place = this.stage.pick(x, y);
      this.under.textContent = place ? `${this.page.coordinates(place.position, 6)}, nearest vertex ${this.stage.nearestVertex(place)}` : '';
    });
  }

  onKey(event) {
    const { key, target } = event;
    const isTaken = (key !== 'Escape' && target.matches?.(textTakers)) || (key in arrows && target.matches?.(arrowTakers));
    if (!this.stage || event.altKey || isTaken) return;
    const action = event.ctrlKey || event.metaKey ? this.commandOf(event) : this.actionOf(event);
    if (!action) return;
    event.preventDefault();
    action();
  }

  commandOf({ key, shiftKey }) {
    const name = key.toLowerCase();
    if (name === 'y' || (name === 'z' && shiftKey)) return () => this.page.redo();
    return name === 'z' ? () => this.page.undo() : undefined;
  }

  actionOf({ key, shiftKey }) {
    const { page } = this;
    const { selected } = page;
    const boxes = { e: 'show-intrinsic', m: 'show-mesh', h: 'show-hidden', l: 'show-labels' };
    const options = { c: 'closed', v: 'snap' };
    const buttons = { n: 'new-curve', a: 'add', r: 'reset', t: 'theme' };
    if (key in boxes) return () => at(boxes[key]).click();
    if (key in buttons) return () => at(buttons[key]).click();
    if (key in options) return () => page.toggleOption(options[key]);
    if (key in arrows) return () => this.onArrow(arrows[key], shiftKey);
    if (key === '+' || key === '-') return () => this.stage.zoom(key === '+' ? 0.8 : 1.25);
    if (key === 'Escape') return () => page.cancel() || page.choosePoint(-1);
    if (key === 'Backspace' || key === 'Delete') return () => page.removePoint(selected < 0 ? page.pointsOf(page.list.active).length - 1 : selected);
    if (key === 'Insert' && selected >= 0) return () => page.insertBehind(selected);
    return undefined;
  }

  // Moves the point that is chosen or turns its trace, or turns the view.
  onArrow([dx, dy], isShifted) {
    const { page, stage } = this;
    if (page.selected < 0) return stage.turn(-dx * turn, -dy * turn);
    if (page.isTrace) return page.turnTrace(-dx * (isShifted ? 10 : 1));
    const place = page.list.active.points[page.selected];
    if (!stage.isVisible(place.position)) stage.face(place);
    const [x, y] = stage.project(place.position);
    const size = isShifted ? fineStep : step;
    const moved = stage.pick(x + dx * size, y + dy * size);
    return moved && page.movePoint(page.selected, moved, `keys ${page.list.active.id} ${page.selected}`);
  }
}
