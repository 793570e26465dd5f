// The solver in its own thread: a WebAssembly module that answers JSON with JSON (src/live in the library).

/** @type {any} */
let module;

/** @param {string} question */
function answer(question) {
  const bytes = new TextEncoder().encode(question);
  const at = module.room(bytes.length);
  if (at === 0) throw new Error("the question is too long");
  new Uint8Array(module.memory.buffer, at, bytes.length).set(bytes);
  const length = module.answer();
  return new TextDecoder().decode(new Uint8Array(module.memory.buffer, module.text(), length));
}

self.onmessage = async (event) => {
  const { compiled, id, question } = event.data;
  try {
    if (compiled) {
      module = (await WebAssembly.instantiate(compiled, {})).exports;
      self.postMessage({ ready: true });
      return;
    }
    self.postMessage({ id, answer: answer(question) });
  } catch (error) {
    // A trap leaves the module in no state to go on from: the page starts another.
    self.postMessage({ id, broken: String(error) });
  }
};
