// Where questions are answered: natively, by the program that serves this page (`sheave live`).

/** A solver that can be asked one question at a time, interrupted and started again. */
export class Engine {
  #id = "";
  #controller = null;
  starts = 0;

  get name() {
    return "this computer, natively";
  }

  async start() {
    this.starts += 1;
    this.#id = crypto.randomUUID();
  }

  async ask(question) {
    if (this.#controller) throw new Error("one question at a time");
    const controller = new AbortController();
    this.#controller = controller;
    try {
      const response = await fetch(new URL(`ask/${this.#id}`, import.meta.url), {
        method: "POST",
        headers: { "content-type": "application/json" },
        body: JSON.stringify(question),
        signal: controller.signal,
      });
      if (!response.ok) throw new Error(`the solver answered with status ${response.status}`);
      return await response.json();
    } finally {
      if (this.#controller === controller) this.#controller = null;
    }
  }

  async interrupt() {
    const controller = this.#controller;
    this.#controller = null;
    await this.start();
    controller?.abort();
  }
}
