// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The panel: shows the curves, the points of the one that is edited and its results, and calls the page's actions.

import { plural, statusText, verdictText } from '../source/words.js';
import { levelOf, tools } from './curve_tools.js';
import { format, lengthText, unit } from './units.js';

const mostMembers = 500;
const namesOfOptions = { count: 'homotopy classes', angle: 'direction', spacing: 'spacing of isolines' }; // other than their own
const factorOf = (option) => (option === 'length' || option === 'spacing' ? unit.factor : 1); // by which its input is a multiple
export const at = (id) => document.getElementById(id);

// Gives a list as many rows as there are items. Rows stay, so that one that has the focus keeps it.
function setRows(list, items, make, fill) {
  while (list.children.length > items.length) list.lastChild.remove();
  while (list.children.length < items.length) list.append(make(list.children.length));
  items.forEach((item, i) => fill(list.children[i], item, i));
}

function fromTemplate(id, handlers) {
  const row = at(id).content.firstElementChild.cloneNode(true);
  for (const [selector, events] of Object.entries(handlers))
    for (const [event, action] of Object.entries(events)) row.querySelector(selector).addEventListener(event, action);
  return row;
}

// Sets a line of the results; one without a value is not shown.
function setResult(id, text) {
  at(id).textContent = text;
  at(id).hidden = at(id).previousElementSibling.hidden = text === '';
}

// A value that the user is about to type stays.
function setValue(input, value) {
  if (input !== document.activeElement) input.value = value;
}

export class Panel {
  constructor(page) {
    this.page = page;
    for (const input of document.querySelectorAll('[data-tool]')) input.addEventListener('change', () => page.chooseTool(input.dataset.tool));
    for (const input of document.querySelectorAll('[data-option]')) input.addEventListener('change', () => this.readOption(input));
    for (const button of document.querySelectorAll('[data-format]')) button.addEventListener('click', () => page.save(button.dataset.format));
    const clicks = {
      'new-curve': () => page.newCurve(), undo: () => page.undo(), redo: () => page.redo(), add: () => page.addInView(),
      clear: () => page.setPoints([], -1), cancel: () => page.cancel(), retry: () => page.retry(), play: () => page.player.play(),
      reset: () => page.stage.reset(), theme: () => page.switchTheme(),
    };
    for (const [id, action] of Object.entries(clicks)) at(id).addEventListener('click', action);
    const changes = {
      'show-intrinsic': () => page.update(), 'show-labels': () => page.draw(), colors: () => page.draw(),
      factor: () => this.readUnit(), unit: () => this.readUnit(),
      'show-mesh': () => page.stage.showMeshEdges(at('show-mesh').checked),
      'show-hidden': () => page.stage.setShowsHidden(at('show-hidden').checked),
      file: () => {
        page.openFile(at('file').files[0]);
        at('file').value = ''; // so that the same file can be opened again
      },
    };
    for (const [id, action] of Object.entries(changes)) at(id).addEventListener('change', action);
    at('place').addEventListener('submit', (event) => {
      event.preventDefault();
      page.addAt(event.target.elements.text.value);
    });
  }

  readOption(input) {
    const { option } = input.dataset;
    if (input.type === 'checkbox') return this.page.setOption(option, input.checked);
    const value = input.valueAsNumber;
    const isValid = Number.isFinite(value) && (option === 'angle' || value > 0) && (option !== 'count' || Number.isInteger(value));
    if (isValid) return this.page.setOption(option, Number((value / factorOf(option)).toPrecision(15)));
    input.value = this.optionText(option);
    return this.page.fail(`${namesOfOptions[option] ?? option}: enter a ${option === 'count' ? 'positive whole ' : option === 'angle' ? '' : 'positive '}number`);
  }

  optionText(option) {
    return format(this.page.list.active.options[option] * factorOf(option));
  }

  readUnit() {
    const factor = at('factor').valueAsNumber;
    const isValid = Number.isFinite(factor) && factor > 0;
    if (isValid) Object.assign(unit, { factor, name: at('unit').value.trim() });
    at('factor').value = unit.factor;
    this.page.render();
    if (!isValid) this.page.fail('unit: enter a positive number');
  }

  setMesh({ name, mesh }) {
    at('title').textContent = name;
    document.title = `${name} - geodesic curves`;
    at('facts').textContent = `${plural(mesh.vertices, 'vertex', 'vertices')}, ${plural(mesh.triangles, 'triangle')}`;
    const repairs = mesh.remarks.filter((line) => line.startsWith('repair: '));
    at('remarks').hidden = mesh.remarks.length === 0;
    at('remarks').open = repairs.length > 0;
    at('remarks').firstElementChild.textContent = repairs.length > 0 ? 'The mesh was repaired' : 'Remarks on the file';
    setRows(at('remarks').lastElementChild, mesh.remarks, () => document.createElement('li'), (row, line) => (row.textContent = line.replace(/^repair: /, '')));
  }

  // What a curve is called in a list of those that were computed together.
  member(curve) {
    return lengthText(levelOf(curve) || curve.length);
  }

  // One line on the answer to a curve's request.
  summary(answer) {
    if (!answer) return ['', ''];
    if (answer.error) return ['', answer.error];
    const { curves } = answer.results;
    const [first] = curves;
    if (curves.length !== 1) return [plural(curves.length, 'curve'), ''];
    return [lengthText(first.length), verdictText(first.certificate) || statusText(first.status)];
  }

  render() {
    const { page } = this;
    const { list } = page;
    for (const name of document.querySelectorAll('.unit')) name.textContent = unit.name;
    this.renderCurves(list);
    this.renderTool(list.active);
    this.renderPoints(page.pointsOf(list.active));
    this.renderAnswer(list.active, page.answerOf(list.active));
    at('undo').disabled = !list.canUndo;
    at('redo').disabled = !list.canRedo;
  }

  renderCurves({ curves, state }) {
    const { page } = this;
    const id = (i) => page.list.curves[i].id;
    const make = (i) =>
      fromTemplate('curve-row', {
        '.choose': { click: () => page.chooseCurve(id(i)) },
        '.remove': { click: () => page.removeCurve(id(i)) },
        '.name': { change: (event) => page.changeCurve(id(i), { name: event.target.value }), focus: () => page.chooseCurve(id(i)) },
        '.color': { change: (event) => page.changeCurve(id(i), { color: event.target.value }) },
      });
    setRows(at('curves'), curves, make, (row, curve) => {
      const [length, numbers] = this.summary(page.answerOf(curve));
      row.querySelector('.choose').setAttribute('aria-pressed', String(curve.id === state.active));
      setValue(row.querySelector('.name'), curve.name);
      setValue(row.querySelector('.color'), page.colorOf(curve));
      row.querySelector('.length').textContent = length;
      row.querySelector('.numbers').textContent = numbers || curve.tool;
    });
  }

  renderTool({ tool, options }) {
    for (const input of document.querySelectorAll('[data-tool]')) input.checked = input.dataset.tool === tool;
    for (const input of document.querySelectorAll('[data-option]')) {
      const { option } = input.dataset;
      input.parentElement.hidden = !tools[tool].options.includes(option);
      if (input.type === 'checkbox') input.checked = options[option];
      else setValue(input, this.optionText(option));
    }
    document.querySelector('[data-option=tree]').disabled = !this.page.canHaveTree;
    at('hint').textContent = tools[tool].hint;
  }

  renderPoints(points) {
    const { page } = this;
    const make = (i) =>
      fromTemplate('point-row', {
        '.choose': { click: () => page.choosePoint(i), focus: () => page.choosePoint(i) },
        '.insert': { click: () => page.insertBehind(i) },
        '.remove': { click: () => page.removePoint(i) },
      });
    setRows(at('points'), points, make, (row, point, i) => {
      row.querySelector('.choose').textContent = row.title = page.describe(point);
      row.querySelector('.choose').setAttribute('aria-pressed', String(i === page.selected));
    });
  }

  renderAnswer({ tool }, answer) {
    const { results, error, milliseconds } = answer ?? {};
    const curves = results?.curves ?? [];
    const [first] = curves;
    const isOne = curves.length === 1 && tool !== 'distances';
    setResult('length', isOne ? lengthText(first.length) : '');
    setResult('status', isOne ? statusText(first.status) : '');
    setResult('certificate', isOne ? verdictText(first.certificate) : '');
    setResult('flips', isOne ? first.flips.toLocaleString('en') : '');
    setResult('time', results ? `${milliseconds.toFixed(1)} ms` : '');
    const members = isOne ? [] : curves.filter((curve) => !curve.tree);
    at('members').hidden = members.length === 0;
    at('count').textContent = `${plural(curves.length, 'curve')}, ${tool === 'distances' ? 'at distances' : 'of lengths'}`;
    setRows(at('members').lastElementChild, members.slice(0, mostMembers), () => document.createElement('li'), (row, curve) => {
      row.textContent = [this.member(curve), verdictText(curve.certificate)].filter(Boolean).join(', ');
    });
    const note = (results?.remarks ?? []).join(' ').replace(/^ways +/, 'paths: ');
    at('note').textContent = note.replace(/(?<=at least )\S+(?= long)/, lengthText);
    at('retry').hidden = error === undefined;
    this.page.fail(error ?? '');
    const command = results ? this.page.command() : '';
    at('command').textContent = command && `flip_geodesics ${command}`;
  }
}
