// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The engine as the page sees it: calls that return promises. It runs in a worker, which is replaced when a call is
// cancelled or has stopped the engine. A new one opens the mesh again, and nothing else is lost.

/* global ENGINE_WORKER */

async function inflate(base64) {
  const packed = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Response(stream).arrayBuffer();
}

const encode = (text) => new TextEncoder().encode(text);
const decode = (bytes) => new TextDecoder().decode(bytes);

export class Engine {
  static async load(base64) {
    return new Engine(await inflate(base64));
  }

  constructor(code) {
    this.code = code;
    this.script = URL.createObjectURL(new Blob([ENGINE_WORKER], { type: 'text/javascript' }));
    this.next = 0;
    this.start();
  }

  start() {
    this.waiting = new Map();
    this.worker = new Worker(this.script);
    this.worker.onmessage = ({ data }) => this.settle(data);
    this.worker.onerror = (event) => this.restart(event.message);
    this.worker.postMessage(this.code);
    if (this.mesh) this.call('open_mesh', this.mesh).catch(() => undefined); // it was opened before
  }

  // All calls that wait fail with this message.
  restart(message) {
    this.worker.terminate();
    const { waiting } = this;
    this.start();
    for (const { reject } of waiting.values()) reject(new Error(message));
  }

  settle({ id, bytes, error, isStopped }) {
    if (isStopped) return this.restart(error);
    const { resolve, reject } = this.waiting.get(id);
    this.waiting.delete(id);
    return error === undefined ? resolve(bytes) : reject(new Error(error));
  }

  call(name, input, argument = 0) {
    const id = this.next++;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.worker.postMessage({ id, call: name, input, argument });
    });
  }

  async open(name, bytes) {
    const head = encode(`${name}\0`);
    const input = new Uint8Array(head.length + bytes.length);
    input.set(head);
    input.set(bytes, head.length);
    const answer = await this.call('open_mesh', input);
    this.mesh = input;
    return decode(answer);
  }

  async compute({ option, line, mostPoints }) {
    return decode(await this.call('compute_curve', encode(`${option}\0${line}`), mostPoints));
  }

  save(format, requests) {
    return this.call('save_curves', encode([format, ...requests.flatMap(({ option, line }) => [option, line])].join('\0')));
  }
}
