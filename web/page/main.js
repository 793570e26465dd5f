// The page: what is moved, what is asked, what is shown.

import { Engine } from "./engine.js";
import { Controls } from "./controls.js";
import { DriveView, SLOWER } from "./drive.js";
import { Chart, PROFILES } from "./chart.js";
import { Belt } from "./belt.js";
import { Readouts } from "./readouts.js";
import { download, fromFragment, LONGEST, standalone, toFragment } from "./share.js";
import { Whole } from "./whole.js";
import { set } from "./dom.js";

/** Milliseconds without a change after which the drive is solved to the finer tolerance. */
const REST = 150;
/** Milliseconds after which a search that a change makes obsolete is ended, by what is searched. */
const PATIENCE = { limit: 0, tune: 0, rest: 1500, move: 8000 };
/** Milliseconds after which a button to stop is offered. */
const LONG = 1200;

const byId = (id) => document.getElementById(id);

const page = {
  engine: new Engine(),
  /** What is looked at: the belt at an operating point, or the drive and its shift curve. */
  look: "belt",
  /** The text of the case. */
  case: "",
  /** Changes not yet asked for, and what is asked once there are none. */
  change: null,
  task: null,
  active: null,
  busy: null,
  answer: null,
  /** Whether the last answer has a solution, to the finer tolerance. */
  rested: false,
  frames: [],
  /** How many answers have been shown. */
  drawn: 0,
  /** Whether a notice outlives the next solution. */
  sticky: false,
};

function say(id, text) {
  const element = byId(id);
  if (element.textContent !== text) element.textContent = text;
}

function notice(kind, message, hint) {
  const box = byId("notice");
  box.hidden = !message;
  box.dataset.kind = kind;
  say("notice-message", message ?? "");
  say("notice-hint", hint ?? "");
}

/** Asks one question; while it is long, it can be stopped. */
async function ask(kind, question) {
  page.busy = { kind, since: performance.now() };
  const long = setTimeout(() => stoppable(true), LONG);
  document.documentElement.dataset.busy = kind;
  try {
    return await page.engine.ask(question);
  } finally {
    clearTimeout(long);
    stoppable(false);
    delete document.documentElement.dataset.busy;
    page.busy = null;
  }
}

function stoppable(is) {
  for (const button of document.querySelectorAll(".stop")) button.hidden = !is;
}

/** Notes a change and sees to it that it is asked for. */
function changed(change, active = null) {
  page.change = page.change ? joined(page.change, change) : change;
  page.active = active;
  page.rested = false;
  page.sticky = false;
  if (page.busy && performance.now() - page.busy.since > PATIENCE[page.busy.kind]) end();
  wake();
  run();
}

/** Two changes as one: what the second says of a key holds, and another case replaces everything before it. */
function joined(first, second) {
  if (second.whole !== undefined) return second;
  const names = [...(second.set ?? []).map(([key]) => key), ...(second.unset ?? [])];
  return {
    whole: first.whole,
    set: [...(first.set ?? []).filter(([key]) => !names.includes(key)), ...(second.set ?? [])],
    unset: [...(first.unset ?? []), ...(second.unset ?? [])],
  };
}

/** Ends what is being computed, once. */
function end() {
  if (!page.busy || page.busy.ending) return;
  page.busy.ending = true;
  page.engine
    .interrupt()
    .catch((error) => notice("error", "The solver could not be started again.", String(error.message ?? error)));
}

let running = false;

/** Answers changes one after the other, the newest only; then rests. */
async function run() {
  if (running) return;
  running = true;
  try {
    while (true) {
      const view = page.look === "belt" ? page.belt : page.whole;
      if (page.change) await guarded(() => view.move());
      else if (!page.rested && (await pause(REST))) await guarded(() => view.rest());
      else if (page.rested && page.task) await guarded(taken());
      else if (page.rested && !page.change) break;
    }
  } finally {
    running = false;
  }
}

/** What else is to be asked, once. */
function taken() {
  const { task } = page;
  page.task = null;
  return task;
}

/** Ends a pause. */
let wake = () => {};

/** Whether so long nothing is changed. A change ends the pause at once: the next answer is waited for. */
async function pause(milliseconds) {
  if (page.change) return false;
  await new Promise((resolve) => {
    setTimeout(resolve, milliseconds);
    wake = resolve;
  });
  return !page.change;
}

async function guarded(task) {
  try {
    await task();
  } catch (error) {
    if (error.name === "AbortError") return;
    notice("error", "The solver stopped and was started again.", String(error.message ?? error));
    page.rested = true;
  }
}

/** Where this case is, in this view. */
function address() {
  return `${location.pathname}${location.search}${toFragment(page.case, page.look)}`;
}

/** Nothing is left to ask: the case goes into the address bar. */
function settled() {
  page.active = null;
  page.rested = true;
  history.replaceState(null, "", address());
  document.documentElement.dataset.rested = String(Number(document.documentElement.dataset.rested ?? 0) + 1);
}

/** A case that is not understood: it stays out, and the controls go back. */
function refused(failure, whole) {
  notice("error", failure.message, failure.hint);
  page.rested = true;
  if (page.answer) page.controls.show(page.answer, null);
  if (whole && !page.answer) {
    // What the address says is no case: the base case is shown, and why stays to be read.
    changed({ whole: "" });
    page.sticky = true;
  }
}

/** Drawings, or whole curves, in the last second. */
function measured(what = "drawings") {
  const now = performance.now();
  page.frames = [...page.frames.filter((time) => now - time < 1000), now];
  const span = now - page.frames[0];
  if (page.frames.length > 3)
    say("frames", `${Math.round((1000 * (page.frames.length - 1)) / span)} ${what} a second while moving`);
}

function open(text) {
  if (text.length > LONGEST) notice("error", "The file is too long for a case.", "");
  else changed({ whole: text });
}

async function openFile(file) {
  if (!file) return;
  if (file.size > LONGEST) notice("error", "The file is too long for a case.", "");
  else open(await file.text());
}

/** Looks at the belt, or at the whole drive. */
function look(at) {
  page.look = at;
  for (const element of document.querySelectorAll("[data-view]")) element.hidden = element.dataset.view !== at;
  for (const view of ["belt", "drive"]) {
    if (view === at) byId(`view-${view}`).setAttribute("aria-current", "page");
    else byId(`view-${view}`).removeAttribute("aria-current");
  }
  document.querySelector(`.stage[data-view="${at}"]`).prepend(byId("notice"));
  page.view.seen = at === "belt";
  page.controls.whole = at === "drive";
  page.frames = [];
  say("frames", "");
  notice("none", "");
}

function wire() {
  for (const button of document.querySelectorAll(".stop")) {
    button.addEventListener("click", () => {
      page.rested = true;
      end();
    });
  }
  for (const view of ["belt", "drive"]) {
    byId(`view-${view}`).addEventListener("click", () => {
      if (page.look === view) return;
      look(view);
      changed({});
    });
  }
  byId("pause").addEventListener("click", (event) => {
    page.view.moves = !page.view.moves;
    event.currentTarget.setAttribute("aria-pressed", String(!page.view.moves));
  });
  byId("base").addEventListener("click", () => open(""));
  byId("share").addEventListener("click", async () => {
    const url = `${location.origin}${address()}`;
    history.replaceState(null, "", address());
    try {
      await navigator.clipboard.writeText(url);
      say("spoken", "The link to this case is on the clipboard.");
      say("share", "Link copied");
    } catch {
      say("share", "Link is in the address bar");
    }
    setTimeout(() => say("share", "Copy link"), 2500);
  });
  byId("save-case").addEventListener("click", () => download("case.toml", "application/toml", page.case));
  const isWhole = () => page.look === "drive";
  byId("save-svg").addEventListener("click", () => {
    const [name, text] = isWhole()
      ? ["shift.svg", standalone(page.whole.view.svg, "px")]
      : ["drive.svg", standalone(page.view.svg, "mm")];
    download(name, "image/svg+xml", text);
  });
  byId("save-csv").addEventListener("click", async () => {
    if (isWhole()) return download("shift.csv", "text/csv", page.whole.view.csv);
    if (page.busy) return;
    const { csv } = await ask("rest", { ask: "profile" });
    download("profile.csv", "text/csv", csv);
  });
  byId("save-json").addEventListener("click", () => {
    if (isWhole()) return download("shift.json", "application/json", page.whole.view.json);
    download("result.json", "application/json", `${JSON.stringify(page.answer?.result ?? {}, null, 2)}\n`);
  });
  const input = byId("file");
  byId("open").addEventListener("click", () => input.click());
  input.addEventListener("change", () => {
    openFile(input.files[0]);
    input.value = "";
  });
  const over = (is) => (event) => {
    event.preventDefault();
    document.body.classList.toggle("over", is);
  };
  addEventListener("dragover", over(true));
  addEventListener("dragleave", (event) => event.relatedTarget ?? document.body.classList.remove("over"));
  addEventListener("drop", (event) => {
    over(false)(event);
    openFile(event.dataTransfer.files[0]);
  });
  addEventListener("hashchange", () => {
    const asked = fromFragment(location.hash);
    if (!asked || !page.whole || (asked.text === page.case && asked.look === page.look)) return;
    if (asked.look !== page.look) look(asked.look);
    open(asked.text);
  });
}

async function start() {
  wire();
  page.view = new DriveView(byId("drawing"));
  page.view.moves = !matchMedia("(prefers-reduced-motion: reduce)").matches;
  set(byId("pause"), { "aria-pressed": String(!page.view.moves) });
  say("slower", `Motion is shown ${SLOWER} times slower.`);
  page.readouts = new Readouts(byId("readouts"));
  page.charts = PROFILES.map((profile) => new Chart(profile));
  byId("charts").append(...page.charts.map((chart) => chart.figure));
  try {
    await page.engine.start();
  } catch (error) {
    notice("error", "The solver could not be started.", String(error.message ?? error));
    return;
  }
  say("engine", `Solved by ${page.engine.name}.`);
  const { keys } = await page.engine.ask({ ask: "keys" });
  page.controls = new Controls(byId("controls"), keys, moved);
  const tools = { ask, say, notice, refused, settled, joined, measured, open, run };
  page.belt = new Belt(page, tools);
  page.whole = new Whole(page, tools);
  const asked = fromFragment(location.hash);
  look(asked?.look ?? "belt");
  for (const view of ["belt", "drive"]) byId(`view-${view}`).disabled = false;
  changed({ whole: asked?.text ?? "" });
}

/** The least slip threshold of a belt without bending stiffness, mm/s: below, nothing is found (docs/string.md). */
const STRING_THRESHOLD = 5;

/** A change from the controls, with what has to change beside it. */
function moved(change, active) {
  const threshold = 1e3 * (page.answer?.values["sheave.slip_threshold"] ?? 0);
  const isString = change.set?.some(([key, value]) => key === "edition" && value === "string");
  if (isString && threshold < STRING_THRESHOLD) {
    const text = `${STRING_THRESHOLD} mm/s`;
    changed({ ...change, set: [...change.set, ["sheave.slip_threshold", text]] }, active);
    notice("note", `A belt without bending stiffness needs a larger slip threshold: it is set to ${text}.`, "");
    page.sticky = true;
  } else {
    thermal(change, active);
  }
}

/** Heat needs two keys: one alone brings the other's example with it. */
function thermal(change, active) {
  const ways = ["thermal.heat_transfer", "thermal.heat_transfer_per_area"];
  const pair = ["thermal.ambient", ...ways];
  const first = change.set?.map(([key]) => key).find((key) => pair.includes(key));
  const given = page.answer?.given ?? [];
  const other = ways.includes(first) ? "thermal.ambient" : ways[0];
  const has = other === ways[0] ? ways.some((key) => given.includes(key)) : given.includes(other);
  if (first && !has) {
    const { key } = page.controls.controls.get(other);
    changed({ ...change, set: [...change.set, [other, `${key.example} ${key.unit}`]] }, active);
  } else if (change.unset?.some((key) => pair.includes(key))) {
    changed({ ...change, unset: pair }, active);
  } else {
    changed(change, active);
  }
}

// For tests: what is shown, and how it is asked.
globalThis.sheave = page;
start();
