// The page in Chromium: what is moved, shown, opened, saved and refused.
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { after, afterEach, before, test } from "node:test";
import { gzipSync } from "node:zlib";
import { chromium } from "playwright-core";
import { differences, native } from "./native.mjs";
import { serve } from "./serve.mjs";

const shots = new URL("../shots/", import.meta.url);
const here = (path) => new URL(path, import.meta.url).pathname;
const executablePath = process.env.CHROMIUM ?? ["/usr/bin/chromium", "/usr/bin/google-chrome"].find(existsSync);
let browser;
let site;
let program;
/** Everything that went wrong in the pages of a test. */
let problems = [];
let requests = [];
const contexts = [];

before(async () => {
  await mkdir(shots, { recursive: true });
  site = await serve(here("../dist"));
  program = await native();
  browser = await chromium.launch({ executablePath, args: ["--no-sandbox"] });
});
after(async () => {
  await browser?.close();
  site?.close();
  program?.close();
});
afterEach(async () => {
  while (contexts.length) await contexts.pop().close();
  const found = problems;
  problems = [];
  requests = [];
  assert.deepEqual(found, []);
});

async function open(fragment = "", options = {}, url = site.url) {
  const context = await browser.newContext({
    viewport: { width: 1600, height: 1000 },
    reducedMotion: "no-preference",
    ...options,
  });
  contexts.push(context);
  const page = await context.newPage();
  page.on("console", (message) => ["error", "warning"].includes(message.type()) && problems.push(message.text()));
  page.on("pageerror", (error) => problems.push(String(error)));
  page.on("request", (request) => requests.push(request.url()));
  await page.goto(url + fragment);
  await rested(page, 0);
  return page;
}

const count = (page) => page.evaluate(() => Number(document.documentElement.dataset.rested ?? 0));

/** Waits until the page has come to rest more often than `before`. */
async function rested(page, before) {
  await page.waitForFunction((before) => Number(document.documentElement.dataset.rested ?? 0) > before, before, {
    timeout: 60_000,
  });
}

/** Moves a slider to a value and waits until the drive has followed. */
async function slide(page, key, value) {
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
async function type(page, key, value) {
  const before = await count(page);
  const field = page.locator(`input[data-field="${key}"]`);
  await field.fill(String(value));
  await field.press("Enter");
  await rested(page, before);
}

const answer = (page) => page.evaluate(() => globalThis.sheave.answer);
const caseText = (page) => page.evaluate(() => globalThis.sheave.case);

test("the module keeps to its budget of 2 MB compressed", async () => {
  const size = gzipSync(await readFile(here("../dist/sheave.wasm"))).length;
  console.log(`module: ${size} bytes compressed`);
  assert.ok(size <= 2 << 20, `${size} bytes`);
});

test("sliders give the native program's numbers", async () => {
  const page = await open();
  await page.evaluate(() => {
    const { engine } = globalThis.sheave;
    const original = engine.ask.bind(engine);
    globalThis.asked = [];
    engine.ask = (question) => {
      globalThis.asked.push(structuredClone(question));
      return original(question);
    };
  });
  // From nothing, so that the program can go the same way.
  await page.evaluate(() => globalThis.sheave.engine.interrupt());
  await slide(page, "operating_point.primary_torque", 30);
  await slide(page, "drive.ratio", 1.3);
  await slide(page, "operating_point.secondary_axial_force", 900);
  await slide(page, "sheave.friction_coefficient", 0.35);
  const asked = await page.evaluate(() => globalThis.asked);
  let last;
  for (const question of asked) last = await program.ask(question, "sliders");
  const shown = await answer(page);
  const { solved, sampled } = differences(shown.result, last.result);
  console.log(`sliders: ${asked.length} questions, largest relative difference ${solved.largest.toExponential(1)}`);
  assert.ok(solved.largest <= 1e-9, solved.at);
  assert.ok(sampled.largest <= 1e-6, sampled.at);
  assert.deepEqual(shown.given, [
    "sheave.friction_coefficient",
    "drive.ratio",
    "operating_point.primary_torque",
    "operating_point.secondary_axial_force",
  ]);
  const big = await page.locator("#axial").textContent();
  assert.ok(big.startsWith(`${Math.round(last.result.primary.axial_force)}`.slice(0, 3)), big);
});

test("everything comes from the page's own place, and works without a network", async () => {
  const page = await open();
  assert.ok(requests.length > 10);
  assert.deepEqual(
    requests.filter((url) => !url.startsWith(site.url)),
    [],
  );
  await page.evaluate(() => navigator.serviceWorker.ready);
  await page.waitForFunction(
    async () => (await caches.keys()).length === 1 && navigator.serviceWorker.controller !== null,
  );
  await page.context().setOffline(true);
  await page.reload();
  await rested(page, 0);
  await slide(page, "operating_point.primary_torque", 25);
  assert.equal((await answer(page)).failure, undefined);
});

test("where the belt slips, the limit is named and the last drive stays", async () => {
  const page = await open();
  await type(page, "operating_point.primary_axial_force", 900);
  await slide(page, "operating_point.primary_torque", 60);
  const message = await page.locator("#notice-message").textContent();
  assert.match(
    message,
    /The belt slips: a primary axial force of 900.* N carries at most 32\.1\d? N·m, and 60.* N·m are asked/,
  );
  assert.equal(await page.locator("#drawing").getAttribute("data-state"), "none");
  assert.ok(await page.locator(".drive.slips").count());
  await page.screenshot({ path: new URL("slips-1600.png", shots).pathname });
  await slide(page, "operating_point.primary_torque", 20);
  assert.equal(await page.locator("#notice").isHidden(), true);
  assert.equal(await page.locator("#drawing").getAttribute("data-state"), "solved");
});

test("a search can be stopped, and the solver goes on", async () => {
  const page = await open();
  const starts = await page.evaluate(() => globalThis.sheave.engine.starts);
  const ended = await page.evaluate(async () => {
    const { engine } = globalThis.sheave;
    const long = engine.ask({ ask: "smallest_clamps", case: "", tolerance: 1e-9 }).then(
      () => "answered",
      (error) => error.name,
    );
    await engine.interrupt();
    return long;
  });
  assert.equal(ended, "AbortError");
  assert.equal(await page.evaluate(() => globalThis.sheave.engine.starts), starts + 1);
  // What breaks the worker does not break the page.
  const broken = await page.evaluate(() => {
    return globalThis.sheave.engine.ask({ ask: "solve", case: "x".repeat(5e6) }).catch((error) => error.message);
  });
  assert.match(broken, /the solver stopped: .*too long/);
  assert.equal(await page.evaluate(() => globalThis.sheave.engine.starts), starts + 2);
  await slide(page, "operating_point.primary_torque", 22);
  assert.equal((await answer(page)).failure, undefined);
});

test("a case goes through URL, file and drop and comes back the same", async () => {
  const page = await open();
  await page.locator("select[data-key=edition]").selectOption("thesis");
  await slide(page, "drive.ratio", 0.8);
  await type(page, "operating_point.slack_tension", "30 lbf");
  const text = await caseText(page);
  assert.equal(text, 'edition = "thesis"\n\n[drive]\nratio = 0.8\n\n[operating_point]\nslack_tension = "30 lbf"\n');
  const url = page.url();
  const again = await open(new URL(url).hash);
  assert.equal(await caseText(again), text);
  const force = async (page) => (await answer(page)).result.primary.axial_force;
  assert.ok(Math.abs((await force(again)) / (await force(page)) - 1) < 1e-5);

  const saved = async (button) => {
    const [file] = await Promise.all([page.waitForEvent("download"), page.locator(button).click()]);
    return { name: file.suggestedFilename(), text: await readFile(await file.path(), "utf8") };
  };
  const file = await saved("#save-case");
  assert.deepEqual(file, { name: "case.toml", text });
  const csv = await saved("#save-csv");
  assert.match(csv.text, /^region,position,T \[N\]/);
  assert.ok(csv.text.split("\n").length > 300);
  const drawing = await saved("#save-svg");
  await writeFile(new URL("drive.svg", shots), drawing.text);
  assert.match(drawing.text, /^<\?xml[^>]*>\n<svg [^>]*xmlns="http:\/\/www.w3.org\/2000\/svg"/);
  assert.ok(!/class=|style=|script/.test(drawing.text));
  const json = await saved("#save-json");
  assert.equal(JSON.parse(json.text).edition, "thesis");

  const other = await open();
  let before = await count(other);
  await other.locator("#file").setInputFiles({ name: "mine.toml", mimeType: "text/plain", buffer: Buffer.from(text) });
  await rested(other, before);
  assert.equal(await caseText(other), text);
  before = await count(other);
  await other.evaluate((text) => {
    const data = new DataTransfer();
    data.items.add(new File([text], "dropped.toml"));
    document.body.dispatchEvent(new DragEvent("drop", { dataTransfer: data, bubbles: true, cancelable: true }));
  }, "[drive]\nratio = 1.1\n");
  await rested(other, before);
  assert.equal(await caseText(other), "[drive]\nratio = 1.1\n");
});

test("what a file or a URL says is text, never markup", async () => {
  const attack = '<img src=x onerror="globalThis.taken=1"><script>globalThis.taken=1</script>';
  const texts = [
    `${attack}`,
    `"${attack.replaceAll('"', '\\"')}" = 1`,
    `edition = '${attack}'`,
    `[belt]\nlength = '${attack}'`,
    `[belt]\n'${attack}' = 1`,
    `swap = ['${attack} for efficiency.overall = 0.9']`,
    `[drive]\nratio = "1.1 ${attack.replaceAll('"', "'")}"`,
  ];
  for (const text of texts) {
    const context = await browser.newContext();
    contexts.push(context);
    const page = await context.newPage();
    page.on("pageerror", (error) => problems.push(String(error)));
    await page.goto(`${site.url}#case=${encodeURIComponent(text)}`);
    await page.waitForFunction(
      () => document.querySelector("#notice-message").textContent !== "" || document.documentElement.dataset.rested,
    );
    const state = await page.evaluate(() => ({
      taken: globalThis.taken,
      images: document.querySelectorAll("img, script:not([src]), iframe, object").length,
      message: document.querySelector("#notice-message").textContent,
    }));
    assert.equal(state.taken, undefined);
    assert.equal(state.images, 0);
  }
  const page = await open();
  const refused = await page.evaluate(() => {
    const script = document.createElement("script");
    script.textContent = "globalThis.taken = 1";
    document.body.append(script);
    const styled = document.createElement("p");
    styled.setAttribute("style", "color: red");
    document.body.append(styled);
    return { taken: globalThis.taken, color: styled.style.color };
  });
  assert.deepEqual(refused, { taken: undefined, color: "" });
  // The browser said so, as it should.
  assert.ok(
    problems.length >= 2 && problems.every((text) => text.includes("Content Security Policy")),
    problems.join("\n"),
  );
  problems = [];
});

test("the keyboard moves everything", async () => {
  const page = await open();
  const slider = page.locator('input[type=range][data-key="operating_point.primary_torque"]');
  await slider.focus();
  const before = await count(page);
  for (let k = 0; k < 3; k += 1) await page.keyboard.press("ArrowRight");
  await rested(page, before);
  const { values } = await answer(page);
  assert.ok(values["operating_point.primary_torque"] > 18);
  assert.match(await slider.getAttribute("aria-valuetext"), /N·m$/);
  const out = page.locator('button[aria-label="Take primary torque out of the case"]');
  const then = await count(page);
  await out.focus();
  await page.keyboard.press("Enter");
  await rested(page, then);
  assert.equal(await caseText(page), "");
  assert.match(await page.locator("#spoken").textContent(), /Axial forces/);
});

for (const [width, height] of [
  [390, 844],
  [1600, 1000],
]) {
  for (const colorScheme of ["light", "dark"]) {
    test(`at ${width} px, ${colorScheme}: accessible, and nothing beyond the edge`, async () => {
      const page = await open("", { viewport: { width, height }, colorScheme });
      for (const details of await page.locator("details").all()) await details.evaluate((box) => (box.open = true));
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
      const wide = await page.evaluate(
        () => document.documentElement.scrollWidth - document.documentElement.clientWidth,
      );
      assert.equal(wide, 0);
      for (const details of await page.locator("details").all())
        await details.evaluate((box, i) => (box.open = i < 4), 0);
      await page.reload();
      await rested(page, 0);
      await page.waitForTimeout(300);
      await page.screenshot({ path: new URL(`${width}-${colorScheme}.png`, shots).pathname });
      await page.screenshot({ path: new URL(`${width}-${colorScheme}-whole.png`, shots).pathname, fullPage: true });
    });
  }
}

test("the page that the program serves asks the program", async () => {
  const page = await open("", {}, program.url);
  assert.match(await page.locator("#engine").textContent(), /natively/);
  await slide(page, "operating_point.primary_torque", 27);
  const shown = await answer(page);
  assert.ok(Math.abs(shown.result.primary.torque - 27) < 1e-3);
  console.log(`native: ${await frames(page)}`);
});

/** Drags a slider to and fro for three seconds, a change every picture, and counts the drawings. */
async function frames(page, key = "operating_point.primary_torque", from = 10, to = 40) {
  const drawn = await page.evaluate(
    async ([key, from, to]) => {
      const slider = document.querySelector(`input[type=range][data-key="${key}"]`);
      const [start, before] = [performance.now(), globalThis.sheave.drawn];
      while (performance.now() - start < 3000) {
        await new Promise(requestAnimationFrame);
        const phase = (performance.now() - start) / 3000;
        slider.value = String(from + (to - from) * (0.5 - 0.5 * Math.cos(2 * Math.PI * phase)));
        slider.dispatchEvent(new Event("input", { bubbles: true }));
      }
      return (1000 * (globalThis.sheave.drawn - before)) / (performance.now() - start);
    },
    [key, from, to],
  );
  return `${drawn.toFixed(1)} drawings a second while ${key} moves`;
}

test("frame rates, to be read", async () => {
  const page = await open();
  for (const [key, from, to] of [
    ["operating_point.primary_torque", 10, 40],
    ["drive.ratio", 0.8, 1.4],
    ["sheave.friction_coefficient", 0.3, 0.5],
  ]) {
    console.log(`module: ${await frames(page, key, from, to)}`);
  }
});
