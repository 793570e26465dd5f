// What is typed, clicked and opened while the page is busy, in Chromium; and what it says where nothing can be done.
import assert from "node:assert/strict";
import { readFile, rm, writeFile } from "node:fs/promises";
import { test } from "node:test";
import { answer, caseText, count, open, rested, saved, setUp, shots, slide, state, type } from "./browser.mjs";

setUp();

const TORQUE = "operating_point.primary_torque";
const field = (page, key) => page.locator(`input[data-field="${key}"]`);
const range = (page, key) => page.locator(`input[type=range][data-key="${key}"]`);
const link = (text) => `#case=${encodeURIComponent(text)}`;
const twenty = '[operating_point]\nprimary_torque = "20 N*m"\n';
const message = (page) => page.locator("#notice-message").textContent();

/** Nothing is saved by a button, and a notice says why. */
async function unsaved(page, button, why) {
  let files = 0;
  page.on("download", () => (files += 1));
  await page.locator(button).click();
  await page.waitForFunction((why) => new RegExp(why).test(document.querySelector("#notice-message").textContent), why);
  assert.equal(files, 0);
}

/** The page with a module that does not come before `come` is called. */
async function loading(fragment) {
  const context = await state.browser.newContext({ serviceWorkers: "block" });
  state.contexts.push(context);
  const page = await context.newPage();
  page.on("pageerror", (error) => state.problems.push(String(error)));
  let come;
  const wait = new Promise((resolve) => (come = resolve));
  await page.route("**/sheave.wasm", (route) => wait.then(() => route.continue()));
  await page.goto(state.site.url + fragment);
  await page.waitForFunction(() => globalThis.sheave?.charts);
  return { page, come };
}

test("what is opened while the module loads is done once it is there", async () => {
  const { page, come } = await loading("");
  await page.locator("#base").click({ noWaitAfter: true });
  const file = { name: "mine.toml", mimeType: "text/plain", buffer: Buffer.from(twenty) };
  await page.locator("#file").setInputFiles(file);
  // Still alive: it answers.
  await page.waitForFunction(() => globalThis.sheave.change?.[0].whole);
  come();
  await rested(page, 0);
  assert.equal(await caseText(page), twenty);
  assert.equal(await page.evaluate(() => location.hash), link(twenty));
});

test("a link that loads is neither lost by copying it nor saved as an empty file", async () => {
  const { page, come } = await loading(link(twenty));
  await page.locator("#share").click();
  await page.waitForFunction(() => document.querySelector("#share").textContent.startsWith("Link"));
  assert.equal(await page.evaluate(() => location.hash), link(twenty));
  for (const button of ["#save-case", "#save-svg", "#save-csv", "#save-json"])
    await unsaved(page, button, "There is nothing to save yet");
  come();
  await rested(page, 0);
  assert.equal(await caseText(page), twenty);
});

test("a step that fails is not tried for ever", async () => {
  const page = await open();
  await page.evaluate(() => {
    const { belt } = globalThis.sheave;
    const move = belt.move;
    belt.move = () => {
      belt.move = move;
      throw new Error("made to fail");
    };
  });
  await range(page, TORQUE).press("ArrowRight");
  await page.waitForFunction(() => /made to fail/.test(document.querySelector("#notice-hint").textContent));
  await slide(page, TORQUE, 22);
  assert.equal((await answer(page)).values[TORQUE], 22);
});

test("what is typed while answers arrive is taken", async () => {
  const page = await open();
  await type(page, TORQUE, 22);
  const speed = field(page, "operating_point.primary_speed");
  await speed.fill("4000");
  let before = await count(page);
  await range(page, "drive.ratio").evaluate((slider) => {
    slider.value = "1.2";
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  });
  await rested(page, before);
  assert.equal(await speed.inputValue(), "4000");
  before = await count(page);
  await speed.press("Enter");
  await rested(page, before);
  assert.match(await caseText(page), /primary_speed = "4000 rpm"/);
  // Of a key without a value, too.
  const ambient = field(page, "thermal.ambient");
  await ambient.evaluate((element) => (element.closest("details").open = true));
  await ambient.fill("2");
  await slide(page, TORQUE, 23);
  assert.equal(await ambient.inputValue(), "2");
});

test("a field takes the numbers that a case file takes, and no others", async () => {
  const page = await open();
  const tension = field(page, "operating_point.slack_tension");
  for (const [typed, why] of [
    ["3,400", /3,400: `,` is unexpected \(decimals are written with a point\)/],
    ["3,400 N", /3,400 N: `,` is unexpected \(decimals are written with a point\)/],
    ["0x10", /0x10: `x10` is not a known unit|0x10: `x` is not a known unit/],
    ["Infinity", /not a finite number/],
  ]) {
    await tension.fill(typed);
    await tension.press("Enter");
    await page.waitForFunction(
      (typed) => document.querySelector("#notice-message").textContent.includes(`= ${typed}: `),
      typed,
    );
    assert.match(await message(page), why);
    assert.equal(await caseText(page), "");
  }
  await type(page, "operating_point.slack_tension", "1.2e2");
  assert.equal(await caseText(page), '[operating_point]\nslack_tension = "120 N"\n');
});

test("a file that cannot be read is named, and the case stays", async () => {
  const page = await open(link(twenty));
  const gone = new URL("gone.toml", shots).pathname;
  await writeFile(gone, twenty);
  // It is chosen, and deleted before the page reads it.
  await page.evaluate(() => {
    addEventListener("change", (event) => event.stopImmediatePropagation(), { capture: true, once: true });
  });
  await page.locator("#file").setInputFiles(gone);
  await rm(gone);
  await page.locator("#file").evaluate((input) => input.dispatchEvent(new Event("change")));
  await page.waitForFunction(() => !document.querySelector("#notice").hidden, null, { timeout: 10_000 });
  assert.match(await message(page), /^The file gone\.toml cannot be read\.$/);
  assert.match(await page.locator("#notice-hint").textContent(), /moved or deleted/);
  assert.equal(await caseText(page), twenty);
  await slide(page, TORQUE, 22);
  assert.equal(await page.locator("#notice").isHidden(), true);
});

test("a field that is left shows the value that holds", async () => {
  const page = await open();
  const torque = field(page, TORQUE);
  await torque.fill("abc");
  await torque.press("Enter");
  await page.waitForFunction(() => !document.querySelector("#notice").hidden);
  // Until then, it can be put right.
  assert.equal(await torque.inputValue(), "abc");
  await torque.press("Tab");
  assert.equal(await torque.inputValue(), "18");
  await slide(page, "drive.ratio", 1.2);
  assert.equal(await torque.inputValue(), "18");
  await torque.fill("");
  await torque.press("Tab");
  assert.equal(await torque.inputValue(), "18");
});

test("the slider follows what is typed into its field", async () => {
  const page = await open();
  await type(page, TORQUE, 40);
  assert.equal(await range(page, TORQUE).inputValue(), "40");
  assert.match(await range(page, TORQUE).getAttribute("aria-valuetext"), /^40 /);
  const before = await count(page);
  await range(page, TORQUE).press("ArrowRight");
  await rested(page, before);
  const moved = (await answer(page)).values[TORQUE];
  assert.ok(moved > 40 && moved < 42, `${moved}`);
  // Where it was typed in another unit, in that of its key.
  await type(page, "operating_point.slack_tension", "30 lbf");
  assert.match(await range(page, "operating_point.slack_tension").getAttribute("aria-valuetext"), /^133\.4 N/);
});

test("of two keys that exclude each other, changed in one go, the later holds", async () => {
  const page = await open();
  for (const [sent, given] of [
    [
      [
        ["operating_point.primary_speed", 4000],
        [TORQUE, 20],
        ["operating_point.speed_ratio", 0.99],
      ],
      ["operating_point.primary_speed", "operating_point.speed_ratio"],
    ],
    [
      [
        ["drive.primary_radius", 60],
        ["drive.ratio", 1.3],
      ],
      ["drive.ratio"],
    ],
  ]) {
    let before = await count(page);
    await page.locator("#base").click();
    await rested(page, before);
    before = await count(page);
    await page.evaluate((sent) => {
      for (const [key, value] of sent) {
        const slider = document.querySelector(`input[type=range][data-key="${key}"]`);
        slider.value = String(value);
        slider.dispatchEvent(new Event("input", { bubbles: true }));
      }
    }, sent);
    await rested(page, before);
    assert.equal(await page.locator("#notice").isHidden(), true);
    assert.deepEqual((await answer(page)).given.sort(), given.sort());
  }
});

test("a profile is saved without a change being lost, and only of this solution", async () => {
  const page = await open();
  const [file] = await Promise.all([
    page.waitForEvent("download"),
    page.evaluate((key) => {
      document.querySelector("#save-csv").click();
      const slider = document.querySelector(`input[type=range][data-key="${key}"]`);
      slider.value = "25";
      slider.dispatchEvent(new Event("input", { bubbles: true }));
    }, TORQUE),
  ]);
  assert.equal(file.suggestedFilename(), "profile.csv");
  await page.waitForFunction(() => location.hash.includes("primary_torque"));
  assert.equal(await page.locator("#notice").isHidden(), true);
  assert.equal((await answer(page)).values[TORQUE], 25);
  await type(page, "operating_point.primary_axial_force", 900);
  await slide(page, TORQUE, 60);
  assert.match(await message(page), /The belt slips/);
  const { failure, ...others } = JSON.parse((await saved(page, "#save-json")).text);
  assert.ok(failure.message);
  assert.deepEqual(others, {});
  await unsaved(page, "#save-csv", "no solution here");
});

test("what is saved while something moves is of the solution at rest", async () => {
  const page = await open();
  /** A button is pressed while a slider is being moved. */
  const pressed = async (button, value) => {
    const [file] = await Promise.all([
      page.waitForEvent("download"),
      page.evaluate(
        async ([key, value, button]) => {
          const slider = document.querySelector(`input[type=range][data-key="${key}"]`);
          slider.value = String(value);
          slider.dispatchEvent(new Event("input", { bubbles: true }));
          // The first answers are there, and are shown.
          const before = globalThis.sheave.drawn;
          while (globalThis.sheave.drawn === before) await new Promise(requestAnimationFrame);
          document.querySelector(button).click();
          globalThis.waited = document.querySelector(button).getAttribute("aria-disabled");
        },
        [TORQUE, value, button],
      ),
    ]);
    assert.equal(await page.evaluate(() => globalThis.waited), "true");
    assert.equal(await page.locator(button).getAttribute("aria-disabled"), "false");
    return readFile(await file.path(), "utf8");
  };
  const result = JSON.parse(await pressed("#save-json", 25));
  assert.equal(result.solver.tolerance, 1e-6);
  assert.equal(result.inputs.operating_point.primary_torque, 25);
  assert.match(await pressed("#save-case", 30), /primary_torque = "30 N\*m"/);
  assert.equal(await page.evaluate(() => document.documentElement.dataset.rested), "3");
  // Another view is another file.
  let files = 0;
  page.on("download", () => (files += 1));
  await page.evaluate((key) => {
    const slider = document.querySelector(`input[type=range][data-key="${key}"]`);
    slider.value = "20";
    slider.dispatchEvent(new Event("input", { bubbles: true }));
    document.querySelector("#save-svg").click();
    document.querySelector("#view-drive").click();
  }, TORQUE);
  await page.waitForFunction(() => /^Nothing was saved/.test(document.querySelector("#notice-message").textContent));
  assert.equal(files, 0);
});

test("the way back leads to the base case, a damaged link is named and stays in the address", async () => {
  const page = await open();
  let before = await count(page);
  await page.evaluate((hash) => (location.hash = hash), link(twenty));
  await rested(page, before);
  assert.equal(await field(page, TORQUE).inputValue(), "20");
  before = await count(page);
  await page.goBack();
  await rested(page, before);
  assert.equal(await caseText(page), "");
  assert.equal(await field(page, TORQUE).inputValue(), "18");
  await page.evaluate(() => (location.hash = "#case=%E0%A4%A"));
  await page.waitForFunction(() => !document.querySelector("#notice").hidden);
  assert.match(await message(page), /The link is damaged/);
  for (const [hash, why] of [
    ["#case=%E0%A4%A", /The link is damaged/],
    ["#case=[[[", /./],
    ["#Case=x", /no link to a case/],
  ]) {
    const broken = await open(hash);
    assert.match(await message(broken), why);
    assert.equal(await broken.locator("#notice").isHidden(), false);
    assert.equal(await broken.evaluate(() => location.hash), hash);
    await slide(broken, TORQUE, 20);
    assert.equal(await broken.evaluate(() => location.hash), link(twenty));
    assert.equal(await broken.locator("#notice").isHidden(), true);
  }
});

test("at 320 px, nothing is beyond the edge; examples fit their fields", async () => {
  const page = await open("", { viewport: { width: 320, height: 640 } });
  const wide = await page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);
  assert.equal(wide, 0);
  const clipped = await page.evaluate(() => {
    const pen = document.createElement("canvas").getContext("2d");
    for (const box of document.querySelectorAll("details")) box.open = true;
    return [...document.querySelectorAll("#controls input[type=text]")]
      .filter((field) => field.placeholder && field.clientWidth > 0)
      .filter((field) => {
        const style = getComputedStyle(field);
        pen.font = `${getComputedStyle(field, "::placeholder").fontSize} ${style.fontFamily}`;
        const room = field.clientWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight);
        return pen.measureText(field.placeholder).width > room;
      })
      .map((field) => `${field.dataset.field}: ${field.placeholder}`);
  });
  assert.deepEqual(clipped, []);
});

test("the names of the spans are within the drawing", async () => {
  const page = await open(link('[drive]\nratio = 2.5\ncenter_distance = "300 mm"\n'), {
    viewport: { width: 390, height: 844 },
  });
  await page.waitForTimeout(300);
  const outside = await page.evaluate(() => {
    const box = document.querySelector(".drive").getBoundingClientRect();
    return [...document.querySelectorAll(".drive text")]
      .filter((text) => {
        const { top, bottom, left, right } = text.getBoundingClientRect();
        return top < box.top || bottom > box.bottom || left < box.left || right > box.right;
      })
      .map((text) => text.textContent);
  });
  assert.deepEqual(outside, []);
});
