// The search for a tune: a box of parts, a speed, and the combinations that hold the engine there.

import { html } from "./dom.js";
import { fixed, number, plain } from "./format.js";

const RPM = 30 / Math.PI;
/** What a box of parts begins with where the case has it: names of kinds, their keys. */
const KINDS = [
  ["mass", "primary.actuator.mass"],
  ["primary preload", "primary.spring.preload"],
  ["helix", "secondary.actuator.helix_angle"],
  ["pretension", "secondary.spring.pretension"],
];
/** Parts of a kind, as shares of what the drive has. */
const SHARES = [0.85, 1, 1.15];

const byId = (id) => document.getElementById(id);

/** A box of parts around what a drive has, as the file that `sheave tune` reads. */
export function around(values, given, units) {
  const kinds = KINDS.filter(([, key]) => given.includes(key) && values[key] > 0);
  const lines = kinds.map(([name, key]) => {
    const parts = SHARES.map((share) => `"${plain(share * values[key], 4)} ${units(key)}"`);
    return `["${name}"]\n${key} = [${parts.join(", ")}]\n`;
  });
  return lines.join("\n");
}

export class TuneForm {
  /** `search` answers a question about the case that is shown; `open` opens another. */
  constructor({ search, open, said }) {
    Object.assign(this, { search, open, said });
    byId("tune-start").addEventListener("click", () => this.#start());
    byId("tune-box").addEventListener("input", () => (this.own = true));
    byId("tune-target").addEventListener("input", () => (this.aimed = true));
  }

  /** Another drive: what was found is not of it. What was typed stays. */
  forget() {
    if (!this.kept) byId("tunes").replaceChildren();
    this.kept = false;
  }

  /** Fills in what is not typed: parts around those of the drive, and the speed that it has now. */
  suggest({ values, given }, units, speed) {
    if (!this.own) byId("tune-box").value = around(values, given, units);
    if (!this.aimed && Number.isFinite(speed))
      byId("tune-target").value = `${Math.round((speed * RPM) / 100) * 100} rpm`;
  }

  async #start() {
    // What was searched stays to be read.
    this.own = true;
    this.aimed = true;
    const question = { ask: "tune", parts: byId("tune-box").value, target: byId("tune-target").value };
    byId("tune-start").disabled = true;
    this.#say("The belt is mapped, and every combination balanced against it …");
    try {
      this.#show(await this.search(question));
    } catch (error) {
      this.#say(error.name === "AbortError" ? "The search was ended." : String(error.message ?? error));
    } finally {
      byId("tune-start").disabled = false;
    }
  }

  #say(text) {
    byId("tune-state").textContent = text;
  }

  #show(answer) {
    const { failure, tunes = [], candidates, shifting, refused = [] } = answer;
    if (failure) {
      this.#say(`${failure.message[0].toUpperCase()}${failure.message.slice(1)}.`);
      return;
    }
    const why = refused.map(({ count, reason, example }) => `${count}: ${reason} (${example})`);
    this.#say(`${shifting} of ${candidates} combinations shift.${why.length ? ` Refused ${why.join("; ")}.` : ""}`);
    const kinds = Object.keys(tunes[0]?.parts ?? {});
    const header = [
      ...kinds,
      "rms deviation (rpm)",
      "by full solutions",
      "engine (rpm)",
      "reserve (%)",
      "efficiency (%)",
    ];
    const row = (tune) => {
      const use = html("button", {
        type: "button",
        text: "Use",
        "aria-label": `Use ${Object.values(tune.parts).join(", ")}`,
        onclick: () => {
          this.kept = true;
          this.open(tune.case);
        },
      });
      const cells = [
        ...kinds.map((kind) => tune.parts[kind]),
        fixed(tune.rms_deviation * RPM, 1),
        tune.confirmed?.rms_deviation === undefined ? "" : fixed(tune.confirmed.rms_deviation * RPM, 1),
        number(tune.mean_speed * RPM),
        fixed(100 * tune.smallest_slip_reserve, 1),
        `${fixed(100 * tune.mean_efficiency, 2)}${tune.pareto ? " *" : ""}`,
      ];
      return html("tr", {}, ...cells.map((text) => html("td", { text })), html("td", {}, use));
    };
    const head = html("tr", {}, ...header.map((text) => html("th", { scope: "col", text })), html("td"));
    byId("tunes").replaceChildren(
      ...(tunes.length ? [html("thead", {}, head), html("tbody", {}, ...tunes.map(row))] : []),
    );
    this.said(byId("tune-state").textContent);
  }
}
