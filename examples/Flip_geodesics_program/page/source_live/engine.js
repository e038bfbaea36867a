// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The engine as the page sees it: calls that promise their answer.

/* global ENGINE_WORKER */

async function inflate(base64) {
  const packed = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Response(stream).arrayBuffer();
}

export class Engine {
  // From the text of the page; resolves when it is ready.
  static async start(base64) {
    const engine = new Engine();
    const code = await inflate(base64);
    await engine.call({ call: 'start', code }, [code]);
    return engine;
  }

  constructor() {
    this.waiting = new Map();
    this.next = 0;
    const script = URL.createObjectURL(new Blob([ENGINE_WORKER], { type: 'text/javascript' }));
    this.worker = new Worker(script);
    this.worker.onmessage = ({ data }) => this.settle(data);
    this.worker.onerror = (event) => {
      for (const id of [...this.waiting.keys()]) this.settle({ id, error: event.message });
    };
  }

  settle(answer) {
    const { resolve, reject } = this.waiting.get(answer.id);
    this.waiting.delete(answer.id);
    if (answer.error !== undefined) reject(new Error(answer.error));
    else resolve(answer.text ?? answer.bytes);
  }

  call(message, transfer = []) {
    const id = this.next++;
    return new Promise((resolve, reject) => {
      this.waiting.set(id, { resolve, reject });
      this.worker.postMessage({ id, ...message }, transfer);
    });
  }

  open(name, bytes) {
    return this.call({ call: 'open', name, bytes });
  }

  compute(kind, line, mostPoints) {
    return this.call({ call: 'compute', kind, line, mostPoints });
  }

  save(format) {
    return this.call({ call: 'save', format });
  }
}
