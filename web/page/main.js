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
  /** Whether the solver has started: changes wait for it. */
  ready: false,
  /** Whether a case is shown. */
  known: false,
  /** What the address says, while it is no case that is shown: it is being opened, or is `damaged`. */
  kept: null,
  damaged: false,
  /** Changes not yet asked for, the oldest first, or null; and what is asked once there are none. */
  change: null,
  tasks: [],
  active: null,
  busy: null,
  answer: null,
  /** Whether nothing is left to ask of the case, and whether the case that holds has come to rest. */
  rested: false,
  settled: false,
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

/** Notes a change and sees to it that it is asked for, as soon as there is a solver. */
function changed(change, active = null) {
  page.change = joined(page.change, change);
  page.active = active;
  page.rested = false;
  page.sticky = false;
  if (page.damaged || change.whole !== undefined) [page.kept, page.damaged] = [null, false];
  if (!page.ready) return;
  if (page.busy && performance.now() - page.busy.since > PATIENCE[page.busy.kind]) end();
  wake();
  run();
}

/** The keys of which a change says something. */
const named = ({ set = [], unset = [] }) => [...set.map(([key]) => key), ...unset];

/**
 * Changes with one more behind them: it takes the place of those whose keys it names again, and another case of all.
 * The others stay apart, to be asked one after the other: what excludes what is the solver's to know.
 */
function joined(changes, change) {
  if (!changes || change.whole !== undefined) return [change];
  const keys = named(change);
  if (keys.length === 0) return changes;
  const replaced = (before) => before.whole === undefined && named(before).every((key) => keys.includes(key));
  return [...changes.filter((before) => !replaced(before)), change];
}

/** A change that was not completed, asked again before those that came after it. */
function again(change) {
  page.change = [change, ...(page.change ?? [])].reduce(joined, null);
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

/** Answers changes one after the other; then rests. */
async function run() {
  if (running) return;
  running = true;
  try {
    while (true) {
      const view = page.look === "belt" ? page.belt : page.whole;
      if (page.change) await guarded(moving(view));
      else if (!page.rested && (await pause(REST))) await guarded(() => view.rest());
      else if (page.rested && page.tasks.length > 0) await guarded(page.tasks.shift());
      else if (page.rested && !page.change) break;
    }
  } finally {
    running = false;
  }
}

/** The oldest change, asked once, whatever becomes of it. */
function moving(view) {
  const [change, ...later] = page.change;
  page.change = later.length > 0 ? later : null;
  return () => view.move(change);
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
    if (error.name !== "AbortError") {
      notice("error", "The solver stopped and was started again.", String(error.message ?? error));
      page.rested = true;
    }
    if (!page.change) back();
  }
}

/** The controls show what holds. */
function back() {
  page.active = null;
  if (page.answer) page.controls.show(page.answer, null);
}

/** Where this case is, in this view; while what the address says is not shown, the address as it is. */
function address(kept = page.kept) {
  const fragment = kept ?? (page.known ? toFragment(page.case, page.look) : location.hash);
  return `${location.pathname}${location.search}${fragment}`;
}

/** The solver has understood a case. */
function accepted(text) {
  page.case = text;
  page.known = true;
  page.settled = false;
  if (!page.damaged) page.kept = null;
}

/** Nothing is left to ask: the case goes into the address bar. */
function settled() {
  page.rested = true;
  page.settled = true;
  back();
  history.replaceState(null, "", address());
  document.documentElement.dataset.rested = String(Number(document.documentElement.dataset.rested ?? 0) + 1);
}

/** A case that is not understood: it stays out, the controls go back, and the case that holds comes to rest. */
function refused(failure, whole) {
  notice("error", failure.message, failure.hint);
  page.sticky = true;
  page.rested = page.settled;
  if (!page.change) back();
  if (page.kept !== null) page.damaged = true;
  if (whole && !page.answer && !page.change) instead();
}

/** What the address says is no case: the base case is shown, why stays to be read, and the address as it is. */
function instead() {
  const { kept, damaged } = page;
  changed({ whole: "" });
  Object.assign(page, { kept, damaged, sticky: true });
}

/** What the address says is opened, or said to be damaged. */
function follow(asked) {
  const { damaged } = asked;
  if (!damaged && asked.look !== page.look) look(asked.look);
  if (!damaged) changed({ whole: asked.text });
  page.kept = location.hash;
  if (!damaged) return;
  page.damaged = true;
  notice("error", damaged, "The address stays as it is until something is changed.");
  if (page.known) page.sticky = true;
  else instead();
}

/** What is counted in each view. */
const COUNTED = { belt: "drawings", drive: "curves" };

/** Drawings, or whole curves, in the last second; none where another view is looked at by now. */
function measured(at) {
  if (at !== page.look) return;
  const now = performance.now();
  page.frames = [...page.frames.filter((time) => now - time < 1000), now];
  const span = now - page.frames[0];
  if (page.frames.length > 3)
    say("frames", `${Math.round((1000 * (page.frames.length - 1)) / span)} ${COUNTED[at]} a second while moving`);
}

function open(text) {
  if (text.length > LONGEST) closed("The file is too long for a case.", "");
  else changed({ whole: text });
}

/** A file is not opened: the case stays, and so does the reason until something is changed. */
function closed(message, hint) {
  notice("error", message, hint);
  page.sticky = true;
}

async function openFile(file) {
  if (!file) return;
  if (file.size > LONGEST) return closed("The file is too long for a case.", "");
  let text;
  try {
    text = await file.text();
  } catch {
    const why = "It may be a folder, or it may have been moved or deleted, or not be yours to read.";
    return closed(`The file ${file.name} cannot be read.`, why);
  }
  open(text);
}

/**
 * What a button saves: of the solution that the case comes to rest at, and of no other. `file` gives a name, a type, a
 * text or null, and why there is none; it is asked for once nothing is left to be solved, and where it `asks` the
 * solver, once that is free. While it waits, the button says so. Of a search that was stopped a `result` is not whole.
 */
function saves(id, file, { known = () => page.answer, asks = () => false, result = true } = {}) {
  const button = byId(id);
  const waits = (is) => {
    button.classList.toggle("waits", is);
    button.setAttribute("aria-disabled", String(is));
  };
  const none = (why = "There is nothing to save yet.") => notice("note", why, "");
  const give = (name, type, text, why) => {
    if (text === null) return none(why);
    download(name, type, text);
    if (result && !page.settled)
      notice("note", `${name} is not complete.`, "It has what had been found when the search was stopped.");
  };
  button.addEventListener("click", () => {
    if (button.classList.contains("waits")) return;
    if (!known()) return none();
    const { look } = page;
    const save = async () => {
      try {
        if (page.look === look) give(...(await file()));
        else none("Nothing was saved: the other view was chosen before all was solved.");
      } finally {
        waits(false);
      }
    };
    if (page.rested && !asks()) return guarded(save);
    waits(true);
    if (!page.rested) say("spoken", "It is saved as soon as all is solved.");
    page.tasks.push(save);
    run();
  });
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
  say("spoken", "");
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
    const url = address(page.damaged ? null : page.kept);
    if (!page.damaged) history.replaceState(null, "", url);
    try {
      await navigator.clipboard.writeText(`${location.origin}${url}`);
      say("spoken", "The link to this case is on the clipboard.");
      say("share", "Link copied");
    } catch {
      history.replaceState(null, "", url);
      say("share", "Link is in the address bar");
    }
    setTimeout(() => say("share", "Copy link"), 2500);
  });
  const isWhole = () => page.look === "drive";
  const hasCurve = () => page.whole.view.points.length > 0;
  // The base case has no text, and is a case.
  saves("save-case", () => ["case.toml", "application/toml", page.case], { known: () => page.known, result: false });
  saves("save-svg", () => {
    const [name, view, unit, is] = isWhole()
      ? ["shift.svg", page.whole.view, "px", hasCurve()]
      : ["drive.svg", page.view, "mm", page.view.range];
    return [name, "image/svg+xml", is ? standalone(view.svg, unit) : null];
  });
  saves("save-json", () => {
    const { failure, result } = page.answer;
    const told = failure ? { failure } : isWhole() ? page.whole.view.told : result;
    const text = told ? `${JSON.stringify(told, null, 2)}\n` : null;
    return [isWhole() ? "shift.json" : "result.json", "application/json", text];
  });
  const profile = async () => {
    const { csv } = page.answer.result ? await ask("rest", { ask: "profile" }) : {};
    const why = "There is no solution here whose profile could be saved.";
    return ["profile.csv", "text/csv", csv ?? null, why];
  };
  const curve = () => ["shift.csv", "text/csv", hasCurve() ? page.whole.view.csv : null];
  saves("save-csv", () => (isWhole() ? curve() : profile()), { asks: () => !isWhole() });
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
    if (!asked || !page.ready) return;
    if (asked.damaged || asked.text !== page.case || asked.look !== page.look || page.kept !== null) follow(asked);
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
  const tools = { ask, say, notice, accepted, refused, settled, again, measured, open, run };
  page.belt = new Belt(page, tools);
  page.whole = new Whole(page, tools);
  const asked = fromFragment(location.hash) ?? { text: "", look: "belt" };
  look(asked.look);
  for (const view of ["belt", "drive"]) byId(`view-${view}`).disabled = false;
  page.ready = true;
  const waited = page.change;
  page.change = null;
  // What was opened while the solver started takes the place of the address.
  if (!waited) follow(asked);
  for (const change of waited ?? []) changed(change);
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
