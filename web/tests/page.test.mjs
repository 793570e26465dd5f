// The page in Chromium: what is moved, shown, opened, saved and refused.
import assert from "node:assert/strict";
import { readFile, writeFile } from "node:fs/promises";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import {
  answer,
  caseText,
  count,
  here,
  looked,
  open,
  rested,
  saved,
  setUp,
  shots,
  slide,
  state,
  type,
} from "./browser.mjs";
import { differences } from "./native.mjs";

setUp();

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
  for (const question of asked) last = await state.program.ask(question, "sliders");
  const shown = await answer(page);
  const { largest, at } = differences(shown.result, last.result);
  console.log(`sliders: ${asked.length} questions, largest relative difference ${largest.toExponential(1)}`);
  assert.ok(largest <= 1e-9, at);
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
  assert.ok(state.requests.length > 10);
  assert.deepEqual(
    state.requests.filter((url) => !url.startsWith(state.site.url)),
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

  const file = await saved(page, "#save-case");
  assert.deepEqual(file, { name: "case.toml", text });
  const csv = await saved(page, "#save-csv");
  assert.match(csv.text, /^region,position,T \[N\]/);
  assert.ok(csv.text.split("\n").length > 300);
  const drawing = await saved(page, "#save-svg");
  await writeFile(new URL("drive.svg", shots), drawing.text);
  assert.match(drawing.text, /^<\?xml[^>]*>\n<svg [^>]*xmlns="http:\/\/www.w3.org\/2000\/svg"/);
  assert.ok(!/class=|style=|script/.test(drawing.text));
  const json = await saved(page, "#save-json");
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
    const context = await state.browser.newContext();
    state.contexts.push(context);
    const page = await context.newPage();
    page.on("pageerror", (error) => state.problems.push(String(error)));
    await page.goto(`${state.site.url}#case=${encodeURIComponent(text)}`);
    await page.waitForFunction(
      () => document.querySelector("#notice-message").textContent !== "" || document.documentElement.dataset.rested,
    );
    const after = await page.evaluate(() => ({
      taken: globalThis.taken,
      images: document.querySelectorAll("img, script:not([src]), iframe, object").length,
      message: document.querySelector("#notice-message").textContent,
    }));
    assert.equal(after.taken, undefined);
    assert.equal(after.images, 0);
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
    state.problems.length >= 2 && state.problems.every((text) => text.includes("Content Security Policy")),
    state.problems.join("\n"),
  );
  state.problems = [];
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
      await looked(page);
      for (const details of await page.locator("details").all())
        await details.evaluate((box, i) => (box.open = i < 4), 0);
      await page.reload();
      await rested(page, 0);
      await page.waitForTimeout(300);
      await page.screenshot({ path: new URL(`${width}-${colorScheme}.png`, shots).pathname });
      // Charts are drawn where they come into sight.
      for (const chart of await page.locator("#charts .chart").all()) await chart.scrollIntoViewIfNeeded();
      await page.evaluate(() => scrollTo(0, 0));
      await page.waitForTimeout(200);
      await page.screenshot({ path: new URL(`${width}-${colorScheme}-whole.png`, shots).pathname, fullPage: true });
    });
  }
}

test("the page that the program serves asks the program", async () => {
  const page = await open("", {}, state.program.url);
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
