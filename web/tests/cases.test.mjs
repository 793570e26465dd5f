// The module against the native program: 100 random cases, each from nothing, and a drive that is followed.
import assert from "node:assert/strict";
import { mkdir, writeFile } from "node:fs/promises";
import { after, before, test } from "node:test";
import { load } from "./module.mjs";
import { differences, native, sameWay } from "./native.mjs";

const CASES = 100;
/** On what is solved for, where both took the same steps; on what is read off samples; and where their steps differ. */
const SOLVED = 1e-9;
const SAMPLES = 1e-6;
const OTHER_WAY = 1e-5;
/** So many neighbours of a number, each a unit in the last place farther, are tried. */
const LAST_DIGITS = 8;
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

/** Whether the program itself goes another way if one number of a case differs in its last digits. */
async function wavers(question, { solver }) {
  for (let k = 1; k <= LAST_DIGITS; k += 1) {
    const set = question.set.map(([key, value]) =>
      key === "sheave.friction_coefficient" ? [key, String(Number(value) * (1 + k * Number.EPSILON))] : [key, value],
    );
    const other = await program.ask({ ...question, set });
    if (!other.result || !sameWay(other.result, { solver })) return true;
  }
  return false;
}

test("the module asks for nothing from outside", () => assert.deepEqual(wasm.imports, []));

test(`${CASES} random cases have the same results to ${SOLVED}`, async () => {
  const next = random(20260101);
  const rows = [
    "| case | edition | ratio | torque N·m | clamp | axial force, primary, N: module | native | steps | solved | sampled |",
    "|---|---|---|---|---|---|---|---|---|---|",
  ];
  const count = { solved: 0, same: 0, wavering: 0 };
  const worst = { same: 0, sampled: 0, other: 0 };
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
    const { solved, sampled } = differences(mine.result, theirs.result);
    const same = sameWay(mine.result, theirs.result);
    count.solved += 1;
    count.same += Number(same);
    if (!same) count.wavering += Number(await wavers(question, theirs.result));
    const kind = same ? "same" : "other";
    worst[kind] = Math.max(worst[kind], solved.largest);
    if (same) worst.sampled = Math.max(worst.sampled, sampled.largest);
    if (solved.largest > (same ? SOLVED : OTHER_WAY)) wrong.push(`case ${k}: ${solved.at}`);
    if (same && sampled.largest > SAMPLES) wrong.push(`case ${k}: ${sampled.at}`);
    const forces = [mine, theirs].map(({ result }) => result.primary.axial_force).join(" | ");
    const errors = [solved, sampled].map(({ largest }) => largest.toExponential(1)).join(" | ");
    rows.push(`${start} ${forces} | ${same ? "same" : "differ"} | ${errors} |`);
  }
  const summary =
    `${count.solved} of ${CASES} cases have a solution, ${count.same} of them found by the same steps: what is solved for differs by at most ` +
    `${worst.same.toExponential(1)}, what is read off samples by ${worst.sampled.toExponential(1)}. Where the steps differ, solutions ` +
    `to ${TOLERANCE} differ by at most ${worst.other.toExponential(1)}; in ${count.wavering} of these ${count.solved - count.same} cases the native ` +
    `program itself takes other steps if the friction coefficient differs by at most ${LAST_DIGITS} units in its last place.`;
  await mkdir(new URL("../shots/", import.meta.url), { recursive: true });
  await writeFile(new URL("../shots/cases.md", import.meta.url), `${summary}\n\n${rows.join("\n")}\n`);
  console.log(summary);
  assert.deepEqual(wrong, []);
  assert.ok(count.solved > 80 && count.same > 0.85 * count.solved, summary);
});

test("a drive that is followed has the same results", async () => {
  let text = "";
  for (let k = 0; k < 12; k += 1) {
    const set = [["operating_point.primary_torque", `${18 + 2 * k} N*m`]];
    const question = { ask: "solve", case: text, set, tolerance: 1e-3, follow: true };
    const [mine, theirs] = [wasm.ask(question), await program.ask(question, "followed")];
    const { solved, sampled } = differences(mine.result, theirs.result);
    assert.ok(solved.largest <= SOLVED, solved.at);
    assert.ok(sampled.largest <= SAMPLES, sampled.at);
    text = mine.case;
  }
});
