// Two numbers at a time give the same bits as one, in WebAssembly as elsewhere.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";

test("all lanes give the same bits", async () => {
  const bytes = await readFile(new URL("../lanes/lanes.wasm", import.meta.url));
  const { exports } = (await WebAssembly.instantiate(bytes, {})).instance;
  assert.equal(exports.has_simd128(), 1);
  const compared = exports.lanes_agree();
  assert.ok(compared > 300, `${compared}`);
  const time = (wide) => {
    const start = performance.now();
    exports.work(20, wide);
    return performance.now() - start;
  };
  const best = { true: Infinity, false: Infinity };
  for (let round = 0; round < 12; round += 1)
    for (const wide of [true, false]) best[wide] = Math.min(best[wide], time(wide));
  console.log(
    `${compared} batches agree; two numbers at a time take ${(best.true / best.false).toFixed(2)} of the time of one`,
  );
});
