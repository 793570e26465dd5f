// Where questions are answered: by the WebAssembly module in a worker. `sheave live` serves live-engine.js under this
// name.

/** A solver that can be asked one question at a time, interrupted and started again. */
export class Engine {
  #compiled;
  #worker = null;
  #waiting = null;
  #count = 0;
  /** How often the worker had to be started. */
  starts = 0;

  /** What answers, for people to read. */
  get name() {
    return "WebAssembly in this browser";
  }

  async start() {
    this.#compiled ??= await WebAssembly.compile(
      await (await fetch(new URL("sheave.wasm", import.meta.url))).arrayBuffer(),
    );
    await this.#begin();
    // Without a network the page is the one that was kept; where none can be kept, it is as it was.
    navigator.serviceWorker?.register(new URL("sw.js", import.meta.url)).catch(() => {});
  }

  #begin() {
    this.starts += 1;
    const worker = new Worker(new URL("worker.js", import.meta.url), { type: "module" });
    this.#worker = worker;
    return new Promise((resolve, reject) => {
      worker.onerror = (event) => reject(new Error(event.message || "the worker could not be started"));
      worker.onmessage = () => {
        worker.onmessage = (event) => this.#told(event.data);
        worker.onerror = (event) => this.#told({ id: this.#count, broken: event.message });
        resolve();
      };
      worker.postMessage({ compiled: this.#compiled });
    });
  }

  #told({ id, answer, broken }) {
    const waiting = this.#waiting;
    if (!waiting || waiting.id !== id) return;
    this.#waiting = null;
    if (broken === undefined) waiting.resolve(JSON.parse(answer));
    else this.#restart().then(() => waiting.reject(new Error(`the solver stopped: ${broken}`)), waiting.reject);
  }

  #restart() {
    this.#worker?.terminate();
    return this.#begin();
  }

  /** Answers one question; rejects with an `AbortError` if it is interrupted. */
  ask(question) {
    if (this.#waiting) return Promise.reject(new Error("one question at a time"));
    return new Promise((resolve, reject) => {
      this.#waiting = { id: ++this.#count, resolve, reject };
      this.#worker.postMessage({ id: this.#count, question: JSON.stringify(question) });
    });
  }

  /** Ends what is being computed; what was remembered for warm starts is gone. */
  async interrupt() {
    const waiting = this.#waiting;
    this.#waiting = null;
    await this.#restart();
    waiting?.reject(new DOMException("interrupted", "AbortError"));
  }
}
