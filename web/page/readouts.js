// What the solution says, in words and numbers.

import { fixed, number } from "./format.js";
import { html } from "./dom.js";

const LIGHTS = { green: "✔", amber: "▲", red: "✖" };

/** Where the power goes: name, watts. */
function losses({ result }) {
  const rows = [
    ["friction, primary", result.primary.friction_loss],
    ["friction, secondary", result.secondary.friction_loss],
  ];
  const besides = result.losses;
  if (besides) {
    rows.push(["bending the belt", besides.bending], ["squeezing it in the grooves", besides.groove]);
    if (besides.cord) rows.push(["stretching its cord", besides.cord]);
    if (besides.drag) rows.push(["drag of bearings and seals", besides.drag]);
    if (besides.gears) rows.push(["gears", besides.gears]);
  }
  return rows;
}

const percent = (share, decimals = 2) =>
  share === null || share === undefined ? "–" : `${fixed(100 * share, decimals)} %`;

/** Whether a line of text can be written where an element stands. */
const fits = (line, element) => typeof line === "string" && element.tagName === "P";

/** A text that changed. */
function write(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

class Card {
  constructor(title, id) {
    this.big = html("p", { class: "big", id });
    this.small = html("div", { class: "small" });
    this.box = html("section", { class: "card" }, html("h3", { text: title }), this.big, this.small);
  }

  /** A large line and small ones, each a text or an element. What stands there already is kept. */
  show(big, ...lines) {
    write(this.big, big);
    const there = [...this.small.children];
    const kept = lines.length === there.length && lines.every((line, i) => line === there[i] || fits(line, there[i]));
    if (!kept) {
      this.small.replaceChildren(...lines.map((line) => (typeof line === "string" ? html("p", { text: line }) : line)));
      return;
    }
    lines.forEach((line, i) => line !== there[i] && write(there[i], line));
  }
}

/** Watts as bars, a row each. */
class Bars {
  constructor(names, rows) {
    this.names = names;
    this.rows = rows.map(([name]) => {
      const [watts, bar] = [html("td"), html("span", { class: "bar", "aria-hidden": "true" })];
      const row = html("tr", {}, html("th", { scope: "row", text: name }), watts, html("td", { class: "track" }, bar));
      return { row, watts, bar };
    });
    this.table = html("table", { class: "bars" }, ...this.rows.map(({ row }) => row));
  }

  show(rows) {
    const most = Math.max(...rows.map(([, watts]) => watts), 1e-9);
    rows.forEach(([, watts], i) => {
      write(this.rows[i].watts, `${number(watts, 3)} W`);
      const width = `${((100 * Math.max(0, watts)) / most).toFixed(1)}%`;
      if (this.rows[i].bar.style.width !== width) this.rows[i].bar.style.width = width;
    });
  }
}

export class Readouts {
  constructor(host) {
    this.host = host;
    this.cards = {
      slip: new Card("Slip", "slip"),
      clamp: new Card("Axial forces", "axial"),
      efficiency: new Card("Efficiency", "efficiency"),
      watts: new Card("Where the watts go", "watts"),
      motion: new Card("Torque and speed", "motion"),
      belt: new Card("Belt", "belt"),
    };
    host.append(...Object.values(this.cards).map((card) => card.box));
  }

  show(answer) {
    const { result, answers } = answer;
    const { primary, secondary, efficiency, belt, thermal } = result;
    this.host.classList.remove("stale");
    this.slip(answer.light, answers.find(([question]) => question.includes("slip"))?.[1] ?? "");
    this.cards.clamp.show(
      `${number(primary.axial_force)} N · ${number(secondary.axial_force)} N`,
      "primary · secondary",
      `tight tension ${number(primary.entry_tension)} N, slack ${number(primary.exit_tension)} N`,
    );
    const with_losses = efficiency.overall_with_losses;
    this.cards.efficiency.show(
      percent(with_losses ?? efficiency.overall),
      with_losses === undefined || with_losses === null
        ? efficiency.overall === null
          ? "none: neither pulley drives the other"
          : "of the power, friction taken off"
        : `all losses taken off; ${percent(efficiency.overall)} with friction alone`,
      `speed ${percent(efficiency.speed)} × torque ${percent(efficiency.torque)}`,
    );
    this.#watts(answer);
    const rpm = (pulley) => number((pulley.speed * 30) / Math.PI);
    this.cards.motion.show(
      `${number(secondary.torque)} N·m out`,
      `${number(primary.torque)} N·m in, ${rpm(primary)} rpm → ${rpm(secondary)} rpm`,
      `speed ratio ${number(secondary.speed / primary.speed)}, ` +
        `radius ratio ${number(secondary.radius / primary.radius)}`,
    );
    const length = belt.length_error * 1e3;
    this.cards.belt.show(
      belt.temperature === undefined || belt.temperature === null
        ? `${fixed(belt.unstretched_length * 1e3, 1)} mm`
        : `${fixed(belt.temperature - 273.15, 1)} °C`,
      thermal
        ? `${number(thermal.belt, 3)} W heat the belt, ${number(thermal.primary + thermal.secondary, 3)} W the sheaves`
        : "unstretched; its temperature follows once “Heat” is given",
      `${length < 0 ? "−" : "+"}${fixed(Math.abs(length), 2)} mm against the belt given`,
    );
  }

  slip(light, words) {
    const [state, ...rest] = words.split("; ");
    const name = state.replace(/^\w+: /, "");
    this.cards.slip.box.dataset.light = light;
    this.cards.slip.show(`${LIGHTS[light] ?? ""} ${name}`, ...rest);
  }

  /** The readings are those of an earlier solution. */
  stale(message) {
    this.host.classList.add("stale");
    this.slip("red", `red: ${message}`);
  }

  #watts(answer) {
    const rows = losses(answer);
    const total = rows.reduce((sum, [, watts]) => sum + watts, 0);
    const names = rows.map(([name]) => name).join();
    if (names !== this.bars?.names) this.bars = new Bars(names, rows);
    this.bars.show(rows);
    const { power_in, power_out } = answer.result.energy;
    this.cards.watts.show(
      `${number(total, 3)} W lost`,
      `of ${number(Math.max(power_in, -power_out))} W in`,
      this.bars.table,
    );
  }
}

/** One sentence for a screen reader, once the numbers have settled. */
export function spoken({ result, answers }) {
  const slip = answers.find(([question]) => question.includes("slip"))?.[1] ?? "";
  const efficiency = result.efficiency.overall_with_losses ?? result.efficiency.overall;
  const [primary, secondary] = [result.primary, result.secondary].map((pulley) => number(pulley.axial_force, 3));
  return `${slip}. Axial forces ${primary} and ${secondary} newton, efficiency ${percent(efficiency, 1)}.`;
}

/** What matters most, in one line. */
export function glance({ result }) {
  const { efficiency, primary, secondary } = result;
  const overall = percent(efficiency.overall_with_losses ?? efficiency.overall, 1);
  const forces = `${number(primary.axial_force, 3)} · ${number(secondary.axial_force, 3)} N`;
  return `${forces}, ${overall}, ${percent(result.slip_reserve, 0)} reserve`;
}
