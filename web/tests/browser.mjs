// Chromium with the page in it: how tests open it, move it and read it.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { mkdir, readFile } from "node:fs/promises";
import { after, afterEach, before } from "node:test";
import { chromium } from "playwright-core";
import { native } from "./native.mjs";
import { serve } from "./serve.mjs";

export const shots = new URL("../shots/", import.meta.url);
export const here = (path) => new URL(path, import.meta.url).pathname;
const executablePath = process.env.CHROMIUM ?? ["/usr/bin/chromium", "/usr/bin/google-chrome"].find(existsSync);

/** What the tests of a file share. */
export const state = {
  browser: null,
  /** Where the page is served, and the program that answers natively. */
  site: null,
  program: null,
  /** Everything that went wrong in the pages of a test, and what they asked for. */
  problems: [],
  requests: [],
  contexts: [],
};

/** Begins and ends what the tests of a file need; nothing may go wrong in their pages unseen. */
export function setUp() {
  before(async () => {
    await mkdir(shots, { recursive: true });
    state.site = await serve(here("../dist"));
    state.program = await native();
    state.browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
  });
  after(async () => {
    await state.browser?.close();
    state.site?.close();
    state.program?.close();
  });
  afterEach(async () => {
    while (state.contexts.length) await state.contexts.pop().close();
    const found = state.problems;
    state.problems = [];
    state.requests = [];
    assert.deepEqual(found, []);
  });
}

/** The page at an address, once it has come to rest. */
export async function open(fragment = "", options = {}, url = state.site.url) {
  const context = await state.browser.newContext({
    viewport: { width: 1600, height: 1000 },
    reducedMotion: "no-preference",
    ...options,
  });
  state.contexts.push(context);
  const page = await context.newPage();
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && state.problems.push(message.text()));
  page.on("pageerror", (error) => state.problems.push(String(error)));
  page.on("request", (request) => state.requests.push(request.url()));
  await page.goto(url + fragment);
  await rested(page, 0);
  return page;
}

/** How often the page has come to rest. */
export const count = (page) => page.evaluate(() => Number(document.documentElement.dataset.rested ?? 0));

/** Waits until the page has come to rest more often than `before`. */
export async function rested(page, before) {
  await page.waitForFunction((before) => Number(document.documentElement.dataset.rested ?? 0) > before, before, {
    timeout: 120_000,
  });
}

/** Moves a slider to a value and waits until the drive has followed. */
export async function slide(page, key, value) {
  const before = await count(page);
  await page.evaluate(
    ([key, value]) => {
      const slider = document.querySelector(`input[type=range][data-key="${key}"]`);
      slider.value = String(value);
      slider.dispatchEvent(new Event("input", { bubbles: true }));
    },
    [key, value],
  );
  await rested(page, before);
}

/** Types a value into the field of a key. */
export async function type(page, key, value) {
  const before = await count(page);
  const field = page.locator(`input[data-field="${key}"]`);
  await field.fill(String(value));
  await field.press("Enter");
  await rested(page, before);
}

export const answer = (page) => page.evaluate(() => globalThis.sheave.answer);
export const caseText = (page) => page.evaluate(() => globalThis.sheave.case);

/** What a button saves: its name and its text. */
export async function saved(page, button) {
  const [file] = await Promise.all([page.waitForEvent("download"), page.locator(button).click()]);
  return { name: file.suggestedFilename(), text: await readFile(await file.path(), "utf8") };
}

/** Accessible as far as axe-core sees, and nothing beyond the edge. */
export async function looked(page) {
  await page.evaluate(await readFile(here("../node_modules/axe-core/axe.min.js"), "utf8"));
  const found = await page.evaluate(() => globalThis.axe.run(document, { resultTypes: ["violations"] }));
  const said = found.violations.map(
    ({ id, nodes }) =>
      `${id}: ${nodes
        .slice(0, 3)
        .map((node) => node.html + node.failureSummary)
        .join("; ")}`,
  );
  assert.deepEqual(said, []);
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.equal(wide, 0);
}
