// The module against the native program: 100 random cases, each from nothing, and a drive that is followed.
import assert from "node:assert/strict";
import { mkdir, writeFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { load } from "./module.mjs";
import { differences, native } from "./native.mjs";

const CASES = 100;
/** Largest relative difference of any number of a result. */
const SAME = 1e-9;
/** Tolerance of the solutions themselves. */
const TOLERANCE = 1e-6;
let wasm;
let program;

before(async () => {
  wasm = await load(new URL("../dist/sheave.wasm", import.meta.url));
  program = await native();
});
after(() => program?.close());

/** Numbers from 0 to 1, the same in every run (G. Marsaglia, Xorshift RNGs, 2003). */
function random(seed) {
  let state = BigInt(seed);
  return () => {
    state ^= (state << 13n) & 0xffff_ffff_ffff_ffffn;
    state ^= state >> 7n;
    state ^= (state << 17n) & 0xffff_ffff_ffff_ffffn;
    return Number(state >> 11n) / 2 ** 53;
  };
}

function drawn(next) {
  const between = (low, high) => low + (high - low) * next();
  const editions = ["consistent", "consistent", "consistent", "thesis", "thesis", "published", "published", "string"];
  const edition = editions[Math.floor(next() * editions.length)];
  const set = [
    ["edition", edition],
    // A string needs a larger one.
    ["sheave.slip_threshold", edition === "string" ? "5 mm/s" : "0.1 mm/s"],
    ["drive.ratio", between(0.65, 1.8).toFixed(4)],
    ["operating_point.primary_speed", `${between(600, 7000).toFixed(1)} rpm`],
    ["operating_point.primary_torque", `${between(-10, 60).toFixed(3)} N*m`],
    ["sheave.friction_coefficient", between(0.25, 0.6).toFixed(3)],
    ["sheave.half_angle", `${between(10, 16).toFixed(2)} deg`],
    ["belt.bending_stiffness", `${between(0.08, 0.5).toFixed(4)} N*m^2`],
    ["belt.radial_stiffness", `${between(10, 35).toFixed(2)} MPa`],
  ];
  const clamps = [
    ["slack_tension", 60, 300],
    ["slack_tension", 60, 300],
    ["primary_axial_force", 800, 2500],
    ["secondary_axial_force", 700, 2500],
  ];
  const [clamp, low, high] = clamps[Math.floor(next() * clamps.length)];
  return [...set, [`operating_point.${clamp}`, `${between(low, high).toFixed(2)} N`]];
}

test("the module asks for nothing from outside", () => assert.deepEqual(wasm.imports, []));

test(`${CASES} random cases have the same results to ${SAME}`, async () => {
  const next = random(20260101);
  const rows = [
    "| case | edition | ratio | torque N·m | clamp | axial force, primary, N: module | native | iterations: module | native | difference |",
    "|---|---|---|---|---|---|---|---|---|---|",
  ];
  const count = { solved: 0, exact: 0, largest: 0 };
  const wrong = [];
  for (let k = 1; k <= CASES; k += 1) {
    const set = drawn(next);
    const question = { ask: "solve", set, tolerance: TOLERANCE, work_limit: 600_000, from_nothing: true, scene: false };
    const [mine, theirs] = [wasm.ask(question), await program.ask(question)];
    const at = Object.fromEntries(set);
    const [clamp, force] = set.at(-1);
    const torque = parseFloat(at["operating_point.primary_torque"]);
    const start = `| ${k} | ${at.edition} | ${at["drive.ratio"]} | ${torque} | ${clamp.split(".")[1]} ${force} |`;
    if (mine.failure || theirs.failure) {
      rows.push(`${start} ${mine.failure?.kind ?? "solved"} | ${theirs.failure?.kind ?? "solved"} | | | |`);
      if (mine.failure?.kind !== theirs.failure?.kind) wrong.push(`case ${k}: one has a solution, the other has none`);
      continue;
    }
    const { largest, at: place } = differences(mine.result, theirs.result);
    count.solved += 1;
    count.exact += Number(largest === 0);
    count.largest = Math.max(count.largest, largest);
    if (largest > SAME) wrong.push(`case ${k}: ${place}`);
    const both = [mine, theirs].map(({ result }) => result);
    const forces = both.map(({ primary }) => primary.axial_force).join(" | ");
    const iterations = both.map(({ solver }) => solver.newton_iterations).join(" | ");
    rows.push(`${start} ${forces} | ${iterations} | ${largest.toExponential(1)} |`);
  }
  const summary =
    `${count.solved} of ${CASES} cases have a solution in both, ${count.exact} of them with the same bits in every number ` +
    `of the result; the largest relative difference is ${count.largest.toExponential(1)}.`;
  await mkdir(new URL("../shots/", import.meta.url), { recursive: true });
  await writeFile(new URL("../shots/cases.md", import.meta.url), `${summary}\n\n${rows.join("\n")}\n`);
  console.log(summary);
  assert.deepEqual(wrong, []);
  assert.ok(count.solved > 80, summary);
});

test("a drive that is followed has the same results", async () => {
  let text = "";
  for (let k = 0; k < 12; k += 1) {
    const set = [["operating_point.primary_torque", `${18 + 2 * k} N*m`]];
    const question = { ask: "solve", case: text, set, tolerance: 1e-3, follow: true };
    const [mine, theirs] = [wasm.ask(question), await program.ask(question, "followed")];
    const { largest, at } = differences(mine.result, theirs.result);
    assert.ok(largest <= SAME, at);
    text = mine.case;
  }
});
