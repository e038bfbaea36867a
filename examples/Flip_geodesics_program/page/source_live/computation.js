// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Computes the curves that are wanted, one at a time, and keeps the last answers, which undoing needs again. An answer is
// {results, milliseconds} or {error}.

import { readResults } from '../source/data.js';

const mostAnswers = 60;
const keyOf = ({ option, line, mostPoints }) => `${option} ${mostPoints} ${line}`;

export class Computation {
  // wanted: returns the requests, {option, line, mostPoints}, the most urgent first
  // onAnswer, onIdle: are called when one is answered, and when all are
  constructor(engine, { wanted, onAnswer, onIdle }) {
    Object.assign(this, { engine, wanted, onAnswer, onIdle });
    this.forget();
  }

  // For another mesh.
  forget() {
    this.answers = new Map();
  }

  answer(request) {
    return this.answers.get(keyOf(request));
  }

  // A canceled request is computed only when this is called.
  retry(request) {
    this.answers.delete(keyOf(request));
  }

  async run() {
    if (this.isRunning) return;
    this.isRunning = true;
    try {
      for (let request; (request = this.wanted().find((r) => !this.answer(r))); ) await this.compute(request);
    } finally {
      this.isRunning = false;
    }
    this.onIdle();
  }

  async compute(request) {
    const { answers } = this;
    this.started = performance.now();
    let answer;
    try {
      const text = await this.engine.compute(request);
      answer = { results: readResults(text), milliseconds: performance.now() - this.started };
    } catch (error) {
      answer = { error: error.message.replace(/^points line 1: /, '') };
    }
    answers.set(keyOf(request), answer);
    this.evict();
    if (answers === this.answers) this.onAnswer(request, answer);
  }

  // What is not wanted now: failures, which may be canceled computations, and the oldest of too many answers.
  evict() {
    const wanted = new Set(this.wanted().map(keyOf));
    const unwanted = [...this.answers].filter(([key]) => !wanted.has(key));
    const failures = unwanted.filter(([, answer]) => answer.error);
    for (const [key] of failures) this.answers.delete(key);
    if (this.answers.size > mostAnswers && unwanted.length > 0) this.answers.delete(unwanted[0][0]);
  }
}
