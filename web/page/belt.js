// The view of the belt: what is asked while it moves and once it rests, and what is shown.

import { glance, spoken } from "./readouts.js";
import { number, words } from "./format.js";
import { html } from "./dom.js";

/** Tolerances while something moves, and once it rests. */
const MOVING = 1e-3;
const RESTING = 1e-6;
/** Work of a start from nothing, Newton iterations times mesh intervals: a few seconds. */
const WORK = 600_000;
/** Steps on the way to where a slider was put. */
const MOST_STEPS = 60;

const byId = (id) => document.getElementById(id);

export class Belt {
  /** The answer that waits for the next picture. */
  #waiting = null;
  #scheduled = false;

  /** Of a page: its case, its changes, its controls and drawings; and how it asks, says and comes to rest. */
  constructor(page, { ask, say, notice, accepted, refused, settled, again, measured }) {
    this.page = page;
    Object.assign(this, { ask, say, notice, accepted, refused, settled, again, measured });
  }

  /** Follows the drive to where a change moves it. */
  async move(change) {
    const { page } = this;
    const { set: keys = [], unset = [], whole } = change;
    const from = whole ?? page.case;
    const question = { ask: "solve", case: from, set: keys, unset, tolerance: MOVING, work_limit: WORK, follow: true };
    try {
      if (page.change) return await this.#pass(question, whole !== undefined);
      for (let steps = 0; steps < MOST_STEPS; steps += 1) {
        const answer = await this.ask("move", { ...question, ...(steps ? { case: page.case, unset: [] } : {}) });
        if (answer.case === undefined) {
          this.refused(answer.failure, whole !== undefined);
          return;
        }
        this.accepted(answer.case);
        this.#draw(answer);
        if (!answer.on_the_way || page.change) return;
      }
    } catch (error) {
      // What a newer change interrupted is asked again before it.
      if (error.name === "AbortError" && page.change) this.again(change);
      throw error;
    }
  }

  /** Changes the case by what others wait behind: no solution of it is needed. */
  async #pass(question, whole) {
    const answer = await this.ask("move", { ...question, work_limit: 1, follow: false, scene: false });
    if (answer.case === undefined) this.refused(answer.failure, whole);
    else this.accepted(answer.case);
  }

  /** Shows an answer with the next picture, while the next question is being answered. */
  #draw(answer) {
    const { page } = this;
    page.answer = answer;
    this.#waiting = answer;
    if (this.#scheduled) return;
    this.#scheduled = true;
    requestAnimationFrame(() => {
      this.#scheduled = false;
      this.#drawNow();
    });
  }

  /** Shows the answer that waits for a picture. */
  #drawNow() {
    const { page } = this;
    const waiting = this.#waiting;
    this.#waiting = null;
    if (waiting && page.look === "belt") this.#show(waiting);
  }

  /** Solves to the finer tolerance, or says what limits the drive. */
  async rest() {
    const { page } = this;
    this.#drawNow();
    if (page.answer?.failure) {
      // If the clamp does not carry the torque, no search from nothing is needed.
      if ((await this.#limit(page.answer)) || page.change) {
        if (!page.change) this.settled();
        return;
      }
    }
    const answer = await this.ask("rest", { ask: "solve", case: page.case, tolerance: RESTING, work_limit: WORK });
    if (page.change) return;
    if (answer.case === undefined) {
      this.refused(answer.failure);
      page.rested = true;
      return;
    }
    this.#show(answer);
    this.say("spoken", answer.failure ? byId("notice-message").textContent : spoken(answer));
    this.settled();
  }

  /** Names the torque that the clamp carries, and says whether it is less than what is asked. */
  async #limit(answer) {
    const { page } = this;
    const found = await this.ask("limit", { ask: "largest_torque", case: page.case, tolerance: MOVING });
    if (!found.torque || page.change) return false;
    const { value, words: meaning } = found.torque;
    const clamp =
      ["slack_tension", "tight_tension", "primary_axial_force", "secondary_axial_force"].find((name) =>
        answer.given.includes(`operating_point.${name}`),
      ) ?? "slack_tension";
    const at = page.controls.controls.get(`operating_point.${clamp}`);
    const asked = answer.values["operating_point.primary_torque"];
    const given = `${number(answer.values[`operating_point.${clamp}`])} ${at.key.printed_unit}`;
    const torque = `A ${words(clamp)} of ${given} carries at most ${number(value)} N·m`;
    const isTorque = !answer.given.some((key) => /secondary_torque|speed_ratio|secondary_speed/.test(key));
    if (isTorque && asked > value) {
      this.notice(
        "slips",
        `The belt slips: ${torque[0].toLowerCase()}${torque.slice(1)}, and ${number(asked)} N·m are asked.`,
        `${meaning} Less torque or more clamp brings it back.`,
      );
      page.readouts.stale("it slips");
      this.say("spoken", byId("notice-message").textContent);
      return true;
    }
    this.notice("slips", byId("notice-message").textContent, `${torque}. ${meaning}`);
    return false;
  }

  /** Shows an answer: the drawing, the read-outs, the charts. */
  #show(answer) {
    const { page } = this;
    const { failure } = answer;
    page.answer = answer;
    page.drawn += 1;
    page.controls.show(answer, page.active);
    if (answer.scene) {
      page.view.show(answer.scene, Boolean(failure));
      for (const chart of page.charts) chart.show(answer.scene);
    }
    byId("drawing").dataset.state = failure ? "none" : "solved";
    if (failure) {
      const message = failure.message[0].toUpperCase() + failure.message.slice(1);
      this.notice("slips", `${message}.`, failure.hint);
      page.readouts.stale("no solution");
      this.say("glance", "no solution");
    } else {
      if (!page.sticky) this.notice("none", "");
      page.readouts.show(answer);
      this.say("glance", glance(answer));
      const notes = [...answer.result.warnings, ...answer.remarks];
      byId("warnings").replaceChildren(...notes.map((text) => html("li", { text })));
      byId("warnings-box").hidden = notes.length === 0;
      const { solver } = answer.result;
      const intervals = Object.values(solver.mesh_intervals).reduce((sum, count) => sum + count, 0);
      this.say(
        "solved",
        `Residual ${solver.max_residual.toExponential(0)} of ${solver.tolerance.toExponential(0)}, ` +
          `${intervals} mesh intervals.`,
      );
    }
    if (answer.scene) {
      const [low, high] = page.view.range;
      this.say("tension-low", `${number(low, 3)} N`);
      this.say("tension-high", `${number(high, 3)} N`);
    }
    if (answer.result?.solver.tolerance === MOVING) this.measured("belt");
  }
}
