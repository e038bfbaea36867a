// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Runs the engine beside the page, so that the page never waits. A message is {id, call, ...}; each has one answer,
// {id, text or bytes} or {id, error}, where the error is one line for people.

let module;
let engine;
let mesh; // the bytes of the mesh that is open, for an engine that starts again

function instantiate() {
  const imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) (imports[from] ??= {})[name] = () => 0;
  engine = new WebAssembly.Instance(module, imports).exports;
  engine._initialize();
}

function takeInput(bytes) {
  const place = engine.take_input(bytes.length);
  new Uint8Array(engine.memory.buffer, place, bytes.length).set(bytes);
}

// A copy: the engine's memory moves when it grows.
const output = () => new Uint8Array(engine.memory.buffer, engine.output_bytes(), engine.output_size()).slice();
const encode = (text) => new TextEncoder().encode(text);
const decode = (bytes) => new TextDecoder().decode(bytes);

function openMesh({ name, bytes }) {
  const head = encode(`${name}\0`);
  const input = new Uint8Array(head.length + bytes.length);
  input.set(head);
  input.set(bytes, head.length);
  takeInput(input);
  const isOpen = engine.open_mesh() !== 0;
  if (isOpen) mesh = { name, bytes };
  return isOpen;
}

function call(message) {
  if (message.call === 'open') return openMesh(message);
  if (message.call === 'save') {
    takeInput(encode(message.format));
    return engine.save_curves() !== 0;
  }
  takeInput(encode(`${message.kind}\0${message.line}`));
  return engine.compute_curve(message.mostPoints) !== 0;
}

// What an engine that has stopped in the middle leaves is of no use: a new one opens the mesh.
function recover(error) {
  instantiate();
  if (mesh) openMesh(mesh);
  return /memory|stack/i.test(error.message) ? 'this takes more memory than a page has; use the program' : `the engine stopped: ${error.message}`;
}

onmessage = ({ data }) => {
  if (data.call === 'start') {
    module = new WebAssembly.Module(data.code);
    instantiate();
    postMessage({ id: data.id, text: '' });
    return;
  }
  try {
    const isDone = call(data);
    const bytes = output();
    if (!isDone) postMessage({ id: data.id, error: decode(bytes) });
    else if (data.call === 'save') postMessage({ id: data.id, bytes }, [bytes.buffer]);
    else postMessage({ id: data.id, text: decode(bytes) });
  } catch (error) {
    postMessage({ id: data.id, error: recover(error) });
  }
};
