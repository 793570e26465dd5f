// What of the page needs no browser: numbers, and addresses.
import assert from "node:assert/strict";
import { test } from "node:test";
import { decimal, ticks } from "../page/format.js";
import { fromFragment, LONGEST, toFragment } from "../page/share.js";

test("an axis has round places, and few of them however close its ends are", () => {
  assert.deepEqual(ticks(0, 10, 5), [0, 2, 4, 6, 8, 10]);
  assert.deepEqual(ticks(2.1, 2.1000000000000005, 4), [2.1]);
  for (const [from, to] of [
    [0, 1e-300],
    [1e300, 1.000001e300],
    [-1e308, 1e308],
    [0, Infinity],
    [5, 5],
    [3, NaN],
    [-1e-9, 1e9],
  ])
    assert.ok(ticks(from, to, 4).length <= 12, `${from} to ${to}`);
});

test("a number is what a case file takes for one", () => {
  const numbers = ["3400", "-5", "+.5e+1", "3.", "1e3", "2.5E-3"];
  assert.deepEqual(numbers.map(decimal), [3400, -5, 5, 3, 1000, 0.0025]);
  for (const text of ["", ".", "3,400", "3,5", "0x10", "0b1", "0o7", "Infinity", "NaN", "1_000", "3 400", "1e", "5 N"])
    assert.ok(Number.isNaN(decimal(text)), text);
});

test("an address is a case, the base case, damaged, or a place of the page", () => {
  const text = "[drive]\nratio = 1.1\n";
  for (const look of ["belt", "drive"]) assert.deepEqual(fromFragment(toFragment(text, look)), { text, look });
  assert.deepEqual(fromFragment(""), { text: "", look: "belt" });
  assert.equal(fromFragment("#controls"), null);
  assert.match(fromFragment("#case=%E0%A4%A").damaged, /damaged/);
  assert.match(fromFragment(`#shift=${"a".repeat(LONGEST + 1)}`).damaged, /too long/);
  assert.match(fromFragment("#Case=x").damaged, /no link/);
});
