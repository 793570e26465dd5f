// The view of the whole drive: what is asked for its shift curve, point by point.

import { ShiftView } from "./shift.js";
import { TuneForm } from "./tune.js";
import { html } from "./dom.js";

/** Tolerances and points while something moves, and once it rests. */
const MOVING = { tolerance: 1e-3, points: 9 };
const RESTING = { tolerance: 1e-4, points: 24 };
/** Milliseconds after which a curve that a change makes obsolete is left unfinished. */
const PATIENCE = 400;
/** Where a case begins that has everything. */
const EXAMPLE = "gx9.toml";
/** What makes shifting back another curve than shifting up. */
const FRICTION = [
  "primary.actuator.friction_angle",
  "primary.actuator.friction_loss",
  "secondary.actuator.friction_angle",
];

const byId = (id) => document.getElementById(id);

export class Whole {
  /** Of a page: its case, its changes, its controls; and how it asks, says and comes to rest. */
  constructor(page, { ask, say, notice, accepted, refused, settled, again, open, measured, run }) {
    this.page = page;
    Object.assign(this, { ask, say, notice, accepted, refused, settled, again, measured, run });
    this.view = new ShiftView({
      chart: byId("shift-chart"),
      charts: byId("shift-charts"),
      landmarks: byId("landmarks"),
      table: byId("points"),
      progress: byId("shift-progress"),
      state: byId("shift-state"),
    });
    this.form = new TuneForm({
      search: (question) => this.#search(question),
      open,
      said: (text) => say("spoken", text),
    });
    byId("example").addEventListener("click", async () => {
      const response = await fetch(new URL(EXAMPLE, import.meta.url));
      if (response.ok) open(await response.text());
    });
  }

  /** Begins a curve of what a change makes of the case, and computes all of it unless something changes. */
  async move(change) {
    const { page } = this;
    const { set = [], unset = [], whole } = change;
    // With more to come, there is no curve of this.
    const passing = page.change !== null;
    try {
      const question = { ask: "shift", case: whole ?? page.case, set, unset, direction: "up", ...MOVING };
      const begun = await this.ask("move", question);
      if (begun.case === undefined) {
        this.refused(begun.failure, whole !== undefined);
        return;
      }
      if (whole !== undefined) {
        this.view.forget();
        this.form.forget();
        page.controls.forget();
      }
      this.accepted(begun.case);
      this.#show(begun);
      if (!begun.failure && !passing && (await this.#follow("move", begun))) {
        page.drawn += 1;
        this.measured("drive");
      }
    } catch (error) {
      // What a newer change interrupted is asked again before it.
      if (error.name === "AbortError" && page.change) this.again(change);
      else this.#stopped(false);
      throw error;
    }
  }

  /** A search has ended before its curve was complete: what there is of it stays. */
  #stopped(same) {
    this.view.stop(same);
    this.view.settle();
    this.#remarks();
  }

  /** Computes both directions to the finer tolerance. */
  async rest() {
    try {
      await this.#rest();
    } catch (error) {
      if (!this.page.change) this.#stopped(true);
      throw error;
    }
  }

  async #rest() {
    const { page, view } = this;
    const directions = FRICTION.some((key) => page.answer?.values?.[key] > 0) ? ["up", "back"] : ["up"];
    view.only(directions);
    byId("shift-back").hidden = directions.length === 1;
    byId("shift-same").hidden = directions.length > 1;
    for (const direction of directions) {
      const begun = await this.ask("rest", { ask: "shift", case: page.case, direction, ...RESTING });
      if (page.change) return;
      this.#show(begun);
      if (begun.failure) break;
      if (!(await this.#follow("rest", begun))) return;
    }
    view.settle();
    this.#remarks();
    this.form.suggest(page.answer, (key) => page.controls.controls.get(key).key.unit, view.speed);
    this.say("shift-glance", view.glance);
    if (view.slips)
      this.notice("slips", "The belt slips on a part of the curve: the parts press with too little there.", "");
    this.say("spoken", byId("notice").hidden ? view.glance : byId("notice-message").textContent);
    this.settled();
  }

  /** Searches for a tune once nothing else is to be computed; a change ends the search. */
  #search(question) {
    return new Promise((resolve, reject) => {
      this.page.tasks.push(() => this.ask("tune", { ...question, case: this.page.case }).then(resolve, reject));
      this.run();
    });
  }

  /** Asks for point after point; whether the curve is complete. */
  async #follow(kind, begun) {
    const since = performance.now();
    const { direction } = begun;
    this.view.begin(begun);
    let { left } = begun;
    while (left > 0) {
      if (this.page.change && (kind === "rest" || performance.now() - since > PATIENCE)) return false;
      const answer = await this.ask(kind, { ask: "shift_next", direction });
      // The view may be another one by now.
      if (this.page.look !== "drive") return false;
      if (answer.failure) {
        this.notice("error", `${answer.failure.message}.`, answer.failure.hint);
        return true;
      }
      if (!answer.point) return true;
      left = answer.left;
      this.view.add(direction, answer);
    }
    return true;
  }

  /** The case's controls, and what it lacks to be a whole drive. */
  #show(answer) {
    const { page } = this;
    page.answer = answer;
    page.controls.show(answer, page.active);
    const { failure } = answer;
    const lacks = failure?.kind === "input";
    byId("no-drive").hidden = !lacks;
    byId("curve").hidden = lacks;
    if (lacks) {
      this.say(
        "no-drive-why",
        `A shift curve needs a whole drive. ${failure.message[0].toUpperCase()}${failure.message.slice(1)}.`,
      );
      this.view.forget();
      this.view.settle();
      this.#remarks();
    }
    if (failure && !lacks)
      this.notice("slips", `${failure.message[0].toUpperCase()}${failure.message.slice(1)}.`, failure.hint);
    else if (!page.sticky) this.notice("none", "");
  }

  #remarks() {
    for (const [name, notes] of [
      ["missing", this.view.missing],
      ["doubts", this.view.remarks],
    ]) {
      byId(name).replaceChildren(...notes.map((text) => html("li", { text })));
      byId(`${name}-box`).hidden = notes.length === 0;
    }
  }
}
