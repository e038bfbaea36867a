// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Runs the engine beside the page, so that the page never waits. The first message is the engine's code. Every other one
// is {id, call, input, argument} and has one answer: {id, bytes}, or {id, error} with a line for the user. The error of an
// engine that has stopped in the middle, and is of no use any more, comes with `isStopped`.

let engine;

function start(code) {
  const module = new WebAssembly.Module(code);
  const imports = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) (imports[from] ??= {})[name] = () => 0;
  engine = new WebAssembly.Instance(module, imports).exports;
  engine._initialize();
}

function run({ id, call, input, argument }) {
  const place = engine.take_input(input.length);
  new Uint8Array(engine.memory.buffer, place, input.length).set(input);
  const isDone = engine[call](argument) !== 0;
  const bytes = new Uint8Array(engine.memory.buffer, engine.output_bytes(), engine.output_size()).slice();
  return isDone ? { id, bytes } : { id, error: new TextDecoder().decode(bytes) };
}

function describe({ message }) {
  return /memory|stack/i.test(message) ? 'the computation requires more memory than a page can use; use the program' : `the computation failed: ${message}`;
}

onmessage = ({ data }) => {
  if (!engine) return start(data);
  try {
    const answer = run(data);
    postMessage(answer, answer.bytes ? [answer.bytes.buffer] : []);
  } catch (error) {
    postMessage({ id: data.id, error: describe(error), isStopped: true });
  }
  return undefined;
};
