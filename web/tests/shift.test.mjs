// The whole drive in Chromium: its shift curve, drawn while it is computed.
import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { test } from "node:test";
import { answer, caseText, count, here, looked, open, rested, saved, setUp, shots, slide, state } from "./browser.mjs";

setUp();

/** The example drive in the second view, with friction in its actuators, so that both directions differ. */
async function example(options = {}, url = undefined, friction = "2 deg") {
  const smooth = await readFile(here("../page/gx9.toml"), "utf8");
  const text = smooth.replace(/^type = "(arm|helix)"$/gm, `$&\nfriction_angle = "${friction}"`);
  return open(`#shift=${encodeURIComponent(text)}`, options, url);
}

/** The points of a branch as the page has them. */
const points = (page, direction) =>
  page.evaluate((direction) => globalThis.sheave.whole.view.branches[direction].points, direction);

/** The same question, answered natively, point by point. */
async function natively(question, name) {
  const begun = await state.program.ask(question, name);
  const found = [];
  for (let left = begun.left; left > 0;) {
    const next = await state.program.ask({ ask: "shift_next", direction: question.direction }, name);
    found.push(next.point);
    left = next.left;
  }
  return { begun, found };
}

test("a belt alone has no shift curve, and the example is one click away", async () => {
  const page = await open();
  const start = await count(page);
  await page.locator("#view-drive").click();
  await rested(page, start);
  assert.equal(await page.locator("#no-drive").isVisible(), true);
  assert.match(await page.locator("#no-drive-why").textContent(), /needs a whole drive. The case has no actuators/);
  const before = await count(page);
  await page.locator("#example").click();
  await rested(page, before);
  assert.equal(await page.locator("#no-drive").isHidden(), true);
  assert.match(await caseText(page), /\[primary\.actuator\]/);
  assert.match(page.url(), /#shift=/);
  assert.ok((await points(page, "up")).length > 20);
  // Its actuators have no friction: one curve is both.
  assert.equal((await points(page, "back")).length, 0);
  assert.match(await page.locator("#shift-same").innerText(), /no friction/);
  assert.match(await page.locator("#doubts").innerText(), /^At \d+ of \d+ points, .* the belt adheres on neither/);
  assert.match(await page.locator("#points").textContent(), /sliding/);
  // Back at the belt, it is the same case.
  const then = await count(page);
  await page.locator("#view-belt").click();
  await rested(page, then);
  assert.equal((await answer(page)).result.inputs.belt.length, 0.834);
});

test("the curve has the native program's numbers", async () => {
  const page = await example();
  const text = await caseText(page);
  for (const direction of ["up", "back"]) {
    const shown = await points(page, direction);
    const options = { points: 24, tolerance: 1e-4 };
    // As the page goes: upwards from its coarse curve.
    if (direction === "up")
      await natively({ ask: "shift", case: text, direction, points: 9, tolerance: 1e-3 }, "curve");
    const { found } = await natively({ ask: "shift", case: text, direction, ...options }, "curve");
    assert.equal(shown.length, found.length);
    // Where the engine gives no more torque an efficiency is a quotient of two small numbers: powers by the largest.
    const most = Math.max(...found.map((point) => point.power_in));
    let largest = 0;
    for (const [k, point] of shown.entries()) {
      for (const key of ["secondary_speed", "primary_speed", "ratio", "primary_axial_force", "secondary_axial_force"])
        largest = Math.max(largest, Math.abs(point[key] / found[k][key] - 1));
      for (const key of ["power_in", "power_out"])
        largest = Math.max(largest, Math.abs(point[key] - found[k][key]) / most);
    }
    console.log(`${direction}: ${shown.length} points, largest relative difference ${largest.toExponential(1)}`);
    // As accurate as the solutions: where the steps of one search differ, so do its ends, and with them all points.
    assert.ok(largest < options.tolerance, `${largest}`);
  }
});

test("a curve is drawn while it is computed, and a change begins another", async () => {
  const page = await example();
  const mass = (await answer(page)).values["primary.actuator.mass"];
  const speed = async () => (await points(page, "up")).find((point) => point.phase === "shift").primary_speed;
  const heavy = await speed();
  await page.evaluate(() => {
    const { view } = globalThis.sheave.whole;
    const add = view.add.bind(view);
    globalThis.drawn = [];
    view.add = (direction, answer) => {
      add(direction, answer);
      globalThis.drawn.push([direction, view.branches[direction].points.length, answer.left]);
    };
  });
  await slide(page, "primary.actuator.mass", 0.85 * mass);
  const drawn = await page.evaluate(() => globalThis.drawn);
  // Nine coarse points upwards and then all of both directions, one after the other.
  assert.ok(drawn.length > 50, `${drawn.length}`);
  for (const [k, [direction, done, left]] of drawn.entries()) {
    const [before, last] = [drawn[k - 1], done + left];
    const follows = before && before[0] === direction && before[1] + before[2] === last && before[2] > 0;
    assert.equal(done, follows ? before[1] + 1 : 1, `point ${k}: ${drawn[k]} behind ${before}`);
  }
  assert.ok((await speed()) > heavy, "lighter flyweights let the engine turn faster");
  // Many changes at once: the last one counts, whatever was under way.
  const before = await count(page);
  for (const share of [0.9, 0.95, 1.0, 1.05]) {
    await page.evaluate(
      ([value]) => {
        const slider = document.querySelector('input[type=range][data-key="primary.actuator.mass"]');
        slider.value = String(value);
        slider.dispatchEvent(new Event("input", { bubbles: true }));
      },
      [share * mass],
    );
    await page.waitForTimeout(30);
  }
  await rested(page, before);
  assert.ok(Math.abs((await answer(page)).values["primary.actuator.mass"] / (1.05 * mass) - 1) < 0.01);
  assert.ok((await speed()) < heavy);
});

test("the curve is saved as CSV, JSON and SVG", async () => {
  const page = await example();
  const csv = await saved(page, "#save-csv");
  const [header, ...rows] = csv.text.trim().split("\n");
  assert.match(header, /^direction,secondary_speed,primary_speed,/);
  assert.ok(rows.length > 40 && rows.some((row) => row.startsWith("back,")));
  const { text } = await saved(page, "#save-json");
  const [up, back] = JSON.parse(text);
  assert.ok(up.direction === "up" && back.direction === "back" && up.shift_out.ratio > up.full_shift.ratio);
  const drawing = await saved(page, "#save-svg");
  assert.equal(drawing.name, "shift.svg");
  assert.match(drawing.text, /^<\?xml[^>]*>\n<svg /);
  assert.ok(!/class=|style=|script/.test(drawing.text));
});

test("a curve is saved once it is complete", async () => {
  const page = await example();
  const whole = (await saved(page, "#save-csv")).text;
  const mass = 'input[type=range][data-key="primary.actuator.mass"]';
  const move = async (button, share) => {
    const [file] = await Promise.all([
      page.waitForEvent("download", { timeout: 60_000 }),
      page.evaluate(
        async ([mass, button, share]) => {
          const { view } = globalThis.sheave.whole;
          const slider = document.querySelector(mass);
          slider.value = String(share * Number(slider.value));
          slider.dispatchEvent(new Event("input", { bubbles: true }));
          // Some of the points are there.
          while (!(view.branches.up.points.length === 3)) await new Promise(requestAnimationFrame);
          document.querySelector(button).click();
          globalThis.left = view.branches.up.left;
        },
        [mass, button, share],
      ),
    ]);
    assert.ok((await page.evaluate(() => globalThis.left)) > 0);
    return readFile(await file.path(), "utf8");
  };
  assert.equal((await move("#save-csv", 1.05)).split("\n").length, whole.split("\n").length);
  const told = JSON.parse(await move("#save-json", 0.95));
  assert.deepEqual(
    told.map(({ points }) => points.length),
    [25, 25],
  );
  // What a search had found that was stopped is saved, with a word.
  await page.evaluate((mass) => {
    const slider = document.querySelector(mass);
    slider.value = String(1.05 * Number(slider.value));
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  }, mass);
  await page.waitForFunction(() => globalThis.sheave.busy && globalThis.sheave.whole.view.branches.up.left > 2);
  const [part] = await Promise.all([
    page.waitForEvent("download"),
    page.evaluate(() => {
      document.querySelector("#save-csv").click();
      document.querySelector(".stop").click();
    }),
  ]);
  assert.ok((await readFile(await part.path(), "utf8")).split("\n").length < whole.split("\n").length);
  assert.equal(await page.locator("#notice-message").textContent(), "shift.csv is not complete.");
});

test("each view has its own words only", async () => {
  const page = await open();
  const footer = async () => (await page.locator("footer").innerText()).replace(/\s+/g, " ");
  assert.match(await footer(), /Residual .* mesh intervals\. Motion is shown/);
  await slide(page, "operating_point.primary_torque", 20);
  const start = await count(page);
  assert.match(await page.locator("#spoken").textContent(), /Axial forces/);
  const spoken = await page.evaluate(() => {
    document.querySelector("#view-drive").click();
    return document.querySelector("#spoken").textContent;
  });
  assert.equal(spoken, "");
  await rested(page, start);
  assert.doesNotMatch(await footer(), /Residual|mesh intervals|Motion|drawings/);
  // What is measured of one view as it is left is not told of the other.
  await page.evaluate(() => {
    for (let k = 0; k < 9; k += 1) globalThis.sheave.belt.measured("belt");
  });
  assert.doesNotMatch(await footer(), /drawings/);
  const then = await count(page);
  await page.locator("#view-belt").click();
  await rested(page, then);
  assert.match(await footer(), /Residual .* mesh intervals\. Motion is shown/);
  assert.doesNotMatch(await footer(), /curves/);
});

test("a file that is no case leaves the curve, and its table, of the case that stays", async () => {
  const page = await example();
  const shown = () =>
    page.evaluate(() => [
      globalThis.sheave.whole.view.points.length,
      document.querySelector("#shift-chart .line.up").getAttribute("d").length,
      document.querySelectorAll("#landmarks tr").length,
    ]);
  const before = await shown();
  const buffer = Buffer.from('[belt]\nlength = "twelve"\n');
  await page.locator("#file").setInputFiles({ name: "bad.toml", mimeType: "text/plain", buffer });
  await page.waitForFunction(() => !document.querySelector("#notice").hidden);
  await page.waitForTimeout(100);
  assert.ok(before[0] > 40);
  assert.deepEqual(await shown(), before);
});

test("a curve that is stopped says so; without a curve there is nothing to save", async () => {
  const page = await example();
  const before = await count(page);
  await page.evaluate(() => {
    const slider = document.querySelector('input[type=range][data-key="primary.actuator.mass"]');
    slider.value = String(1.05 * Number(slider.value));
    slider.dispatchEvent(new Event("input", { bubbles: true }));
  });
  await page.waitForFunction(
    () => globalThis.sheave.busy && globalThis.sheave.whole.view.branches.up.left > 2 && !globalThis.sheave.change,
  );
  await page.evaluate(() => document.querySelector(".stop").click());
  await page.waitForFunction(() => document.querySelector("#shift-state").textContent.startsWith("stopped at"));
  assert.equal(await page.locator("#shift-progress").isHidden(), true);
  assert.equal(await count(page), before);
  const other = await open("#shift=");
  let files = 0;
  other.on("download", () => (files += 1));
  for (const button of ["#save-csv", "#save-svg"]) {
    await other.locator(button).click();
    assert.match(await other.locator("#notice-message").textContent(), /nothing to save yet/);
  }
  assert.equal(files, 0);
  assert.match(JSON.parse((await saved(other, "#save-json")).text).failure.message, /no actuators/);
});

test("a tune is found, confirmed and used", async () => {
  const page = await example({}, undefined, "0 deg");
  const box = page.locator("#tune-box");
  assert.match(await box.inputValue(), /^\["mass"\]\nprimary\.actuator\.mass = \["113\.9 g", "134 g", "154\.1 g"\]\n/);
  assert.match(await page.locator("#tune-target").inputValue(), /^3\d00 rpm$/);
  const search = async (parts, target) => {
    await box.fill(parts);
    await page.locator("#tune-target").fill(target);
    await page.locator("#tune-start").click();
    await page.waitForFunction(() => !document.querySelector("#tune-start").disabled, null, { timeout: 120_000 });
    return page.locator("#tune-state").textContent();
  };
  const attack = '<img src=x onerror="globalThis.taken=1">';
  assert.match(await search(`["${attack.replaceAll('"', "'")}"]`, "3200 rpm"), /has no parts/);
  assert.match(await search("[mass]", "3200 kg"), /expected a speed/);
  const parts =
    '[mass]\nprimary.actuator.mass = ["134 g", "160 g"]\n[helix]\nsecondary.actuator.helix_angle = ["31 deg", "34 deg"]\n';
  assert.match(await search(parts, "3200 rpm"), /^\d of 4 combinations shift/);
  const rows = page.locator("#tunes tbody tr");
  assert.ok((await rows.count()) > 0);
  const cells = await rows.first().locator("td").allTextContents();
  assert.ok(Number(cells[2]) > 0 && Number(cells[3]) > 0, cells.join(" | "));
  await page.screenshot({ path: new URL("tune-1600.png", shots).pathname, fullPage: true });
  const before = await count(page);
  await rows.first().locator("button").click();
  await rested(page, before);
  const { values } = await answer(page);
  assert.equal(values["secondary.actuator.helix_angle"], Number.parseFloat(cells[0]));
  assert.ok((await rows.count()) > 0, "the others can still be tried");
  // A change ends a search.
  await page.locator("#tune-start").click();
  await page.waitForFunction(() => document.documentElement.dataset.busy === "tune");
  await slide(page, "secondary.actuator.helix_angle", 33);
  assert.equal(await page.locator("#tune-state").textContent(), "The search was ended.");
  assert.equal((await answer(page)).values["secondary.actuator.helix_angle"], 33);
});

test("a keyboard reaches the curve and what is read of it", async () => {
  const page = await example();
  await page.locator("#view-belt").focus();
  await page.keyboard.press("Tab");
  assert.equal(await page.evaluate(() => document.activeElement.id), "view-drive");
  assert.equal(await page.locator("#view-drive").getAttribute("aria-current"), "page");
  const slider = page.locator('input[type=range][data-key="secondary.actuator.helix_angle"]');
  await slider.focus();
  const before = await count(page);
  await page.keyboard.press("ArrowRight");
  await rested(page, before);
  assert.ok((await answer(page)).values["secondary.actuator.helix_angle"] > 38);
  assert.match(await page.locator("#spoken").textContent(), /The engine runs at .* rpm while the drive shifts up/);
  const rows = await page.locator("#landmarks tbody tr:has(td)").count();
  assert.ok(rows >= 6, `${rows} landmarks`);
  assert.ok((await page.locator("#points tbody tr").count()) > 40);
});

for (const [width, height] of [
  [390, 844],
  [1600, 1000],
]) {
  for (const colorScheme of ["light", "dark"]) {
    test(`the curve at ${width} px, ${colorScheme}: accessible, and nothing beyond the edge`, async () => {
      const page = await example({ viewport: { width, height }, colorScheme });
      await page.screenshot({ path: new URL(`shift-${width}-${colorScheme}.png`, shots).pathname });
      await page.screenshot({
        path: new URL(`shift-${width}-${colorScheme}-whole.png`, shots).pathname,
        fullPage: true,
      });
      const over = await page.evaluate(() => {
        const boxes = [...document.querySelectorAll("#shift-chart .places text")].map((text) =>
          text.getBoundingClientRect(),
        );
        const apart = (a, b) => a.left > b.right || b.left > a.right || a.top > b.bottom || b.top > a.bottom;
        return boxes.flatMap((a, i) => boxes.slice(i + 1).filter((b) => !apart(a, b))).length;
      });
      assert.equal(over, 0, "names of places are printed over each other");
      for (const details of await page.locator("details").all()) await details.evaluate((box) => (box.open = true));
      await looked(page);
    });
  }
}

for (const width of [390, 320]) {
  test(`at ${width} px the landmarks' numbers are in sight, and names stand at their own circles`, async () => {
    const page = await example({ viewport: { width, height: 844 } });
    const cells = await page
      .locator("#landmarks td")
      .evaluateAll((cells) =>
        cells.filter((cell) => cell.textContent).map((cell) => cell.getBoundingClientRect().right),
      );
    assert.ok(cells.length > 20, `${cells.length}`);
    assert.ok(Math.max(...cells) <= width, `${Math.max(...cells)}`);
    const names = await page.evaluate(() => {
      const center = (circle) => ["cx", "cy"].map((name) => Number(circle.getAttribute(name)));
      const far = ([x, y], { left, right, top, bottom }) =>
        Math.hypot(Math.max(left - x, 0, x - right), Math.max(top - y, 0, y - bottom));
      const circles = [...document.querySelectorAll("#shift-chart .place")];
      return [...document.querySelectorAll("#shift-chart .places text")].map((text) => {
        const own = text.previousElementSibling;
        const leader = own.previousElementSibling;
        const { x, y, width, height } = text.getBBox();
        let box = { left: x, right: x + width, top: y, bottom: y + height };
        if (leader?.matches(".leader")) {
          const { x, y } = leader.getPointAtLength(0);
          box = { left: x, right: x, top: y, bottom: y };
        }
        const nearest = circles.toSorted((a, b) => far(center(a), box) - far(center(b), box))[0];
        return [text.textContent, nearest === own];
      });
    });
    assert.deepEqual(names, [
      ["take-off", true],
      ["shift-out", true],
      ["full shift", true],
    ]);
    const stage = await page.locator("#shift-chart").evaluate((chart) => chart.closest(".stage").offsetHeight);
    assert.ok(stage <= 0.4 * 844, `the curve takes ${stage} px of the screen`);
  });
}

test("curve rates, to be read", async () => {
  for (const [name, url] of [
    ["module", undefined],
    ["native", state.program.url],
  ]) {
    const page = await example({}, url);
    const drawn = await page.evaluate(async () => {
      const slider = document.querySelector('input[type=range][data-key="primary.actuator.mass"]');
      const value = Number(slider.value);
      const [start, before] = [performance.now(), globalThis.sheave.drawn];
      while (performance.now() - start < 4000) {
        await new Promise(requestAnimationFrame);
        slider.value = String(value * (1 + 0.15 * Math.sin((performance.now() - start) / 640)));
        slider.dispatchEvent(new Event("input", { bubbles: true }));
      }
      return (1000 * (globalThis.sheave.drawn - before)) / (performance.now() - start);
    });
    console.log(`${name}: ${drawn.toFixed(1)} curves of nine points a second while the flyweights' mass moves`);
  }
});
