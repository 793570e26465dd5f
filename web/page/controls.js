// Sliders, fields and lists for every key of a case file, from the table that the solver tells.

import { decimal, plain, step, words } from "./format.js";
import { html, symbol } from "./dom.js";

const SECTIONS = {
  "": "Edition",
  operating_point: "Operating point",
  "primary.actuator": "Flyweights",
  "primary.spring": "Spring of the primary",
  "secondary.actuator": "Helix",
  "secondary.spring": "Spring of the secondary",
  engine: "Engine",
  vehicle: "Vehicle",
  primary: "Stops of the primary",
  secondary: "Stops of the secondary",
  drive: "Drive",
  sheave: "Sheaves",
  belt: "Belt",
  losses: "Losses besides friction",
  thermal: "Heat",
  model: "Finer choices of the model",
};
const OPEN = ["", "operating_point", "drive", "sheave"];
const OPEN_PARTS = ["primary.actuator", "primary.spring", "secondary.actuator", "secondary.spring"];
/** What stands around the belt, and shows only where a case gives it. */
const isPart = (section) => /^(primary|secondary|engine|vehicle)/.test(section);
/** What a whole drive finds by itself. */
const FOUND = ["drive.ratio", "drive.primary_radius", "drive.secondary_radius", "drive.free"];
/** Sliders whose ends are this many times apart go by factors. */
const LOGARITHMIC = 100;
const NOTES = {
  operating_point:
    "One key each for speed, load and clamp: what is moved takes the place of the other keys of its kind, which then " +
    "follow.",
  drive: "The ratio takes the place of both radii, which then follow from the belt's length.",
  thermal: "With ambient temperature and heat transfer, the belt's temperature is found.",
};

/** A key with a quantity: slider, field, and a button that takes it out of the case. */
class Quantity {
  constructor(key, changed) {
    this.key = key;
    this.changed = changed;
    const id = `key-${key.path.replaceAll(".", "-")}`;
    const unit = key.printed_unit;
    this.label = html("label", { for: id, title: key.doc });
    this.label.append(words(key.name));
    if (key.symbol) this.label.append(" ", symbol(html("span", { class: "symbol" }), key.symbol));
    this.range = html("input", { type: "range", id, "data-key": key.path, "aria-describedby": `${id}-doc` });
    this.field = html("input", {
      type: "text",
      inputmode: "decimal",
      autocomplete: "off",
      spellcheck: "false",
      "data-field": key.path,
      "aria-label": `${words(key.name)}${unit ? ` in ${unit}` : ""}`,
    });
    this.out = html("button", {
      type: "button",
      class: "out",
      title: `Take ${key.path} out of the case`,
      "aria-label": `Take ${words(key.name)} out of the case`,
      text: "×",
    });
    this.doc = html("span", { class: "doc", id: `${id}-doc`, text: key.doc });
    this.row = html(
      "div",
      { class: "row" },
      this.label,
      html("span", { class: "field" }, this.field, html("span", { class: "unit", text: unit })),
      this.out,
      this.range,
      this.doc,
    );
    if (key.slider) this.#reach(key.example);
    this.range.addEventListener("input", () => this.#slid());
    this.field.addEventListener("change", () => this.#typed());
    this.field.addEventListener("keydown", (event) => event.key === "Enter" && this.#typed());
    // What is left is what holds, once what was typed is answered.
    this.field.addEventListener("blur", () => this.asked || this.#write());
    this.out.addEventListener("click", () => changed({ unset: [key.path] }));
  }

  /** How far the slider goes: as the table says, farther where a value lies beyond; a part's, around its first. */
  #reach(value) {
    this.ends ??= this.key.slider ?? this.#around(value);
    let [from, to] = this.ends;
    if (value > to) to = this.#within(value * 1.25);
    if (value < from) from = this.#within(value > 0 ? value * 0.8 : value * 1.25);
    if (this.from === from && this.to === to) return;
    [this.from, this.to] = [from, to];
    this.log = from > 0 && to / from >= LOGARITHMIC;
    const [low, high] = this.log ? [Math.log10(from), Math.log10(to)] : [from, to];
    this.range.min = low;
    this.range.max = high;
    this.step = this.log ? 0.01 : step(high - low, 250);
    this.range.step = this.step;
  }

  #around(value) {
    const size = Math.abs(value) || Math.abs(this.key.example) || 1;
    const [from, to] = value === 0 ? [-size, size] : [value - 0.5 * size, value + 0.5 * size];
    const ends = [this.#within(from), this.#within(to)].map((end) => Number(end.toPrecision(3)));
    return ends[0] < ends[1] ? ends : [this.#within(value - 1), this.#within(value + 1)];
  }

  #within(value) {
    const { low, high } = this.key;
    if (high && value > high.value) return high.open ? high.value * 0.999 : high.value;
    if (low && value < low.value) return low.open ? low.value + 1e-6 : low.value;
    return value;
  }

  #slid() {
    this.told = "";
    const raw = Number(this.range.value);
    this.value = this.log ? Number((10 ** raw).toPrecision(3)) : Number(raw.toPrecision(9));
    this.field.value = plain(this.value);
    this.#tell();
    this.#say(`${this.field.value}`);
  }

  #typed() {
    this.told = "";
    const text = this.field.value.trim().replace("−", "-");
    if (text === "" || text === this.shown) return;
    const number = decimal(text);
    const isNumber = Number.isFinite(number);
    if (isNumber) this.#place(number);
    // A text with a unit of its own is the solver's to read; what is no number in a case file is its to refuse.
    this.#say(isNumber ? String(number) : text);
  }

  #say(text) {
    this.shown = this.field.value.trim().replace("−", "-");
    this.asked = true;
    const unit = this.key.unit && Number.isFinite(decimal(text)) ? ` ${this.key.unit}` : "";
    this.changed({ set: [[this.key.path, `${text}${unit}`]] }, this);
  }

  /** The slider at a value. */
  #place(value) {
    this.value = value;
    this.#reach(value);
    this.range.value = String(this.log ? Math.log10(value) : value);
    this.#tell();
  }

  /** The field with the value that holds. */
  #write() {
    const known = Number.isFinite(this.held);
    this.field.value = known ? plain(this.held, 5) : "";
    this.shown = this.field.value;
  }

  #tell() {
    this.range.setAttribute("aria-valuetext", `${plain(this.value, 4)} ${this.key.printed_unit}`.trim());
  }

  /** Shows a value; `active` is the control that is being moved and keeps its own. */
  show(value, given, active) {
    const told = `${value} ${given} ${active === this}`;
    // Most controls stay as they are while one moves.
    if (told === this.told && document.activeElement !== this.field) return;
    this.told = told;
    this.row.classList.toggle("given", given);
    this.out.hidden = !given;
    const known = Number.isFinite(value);
    this.held = value;
    this.row.classList.toggle("unknown", !known);
    if (active === this && known) return;
    this.asked = false;
    this.#place(known ? value : this.key.example);
    // What is being typed stays.
    const typed = document.activeElement === this.field && (known || this.field.value.trim() !== this.shown);
    if (!typed) this.#write();
    this.field.placeholder = known ? "" : `e.g. ${plain(this.key.example, 4)}`;
  }

  /** The ends of a part's slider are those of another drive. */
  forget() {
    this.told = "";
    if (!this.key.slider) this.ends = null;
  }
}

/** A key with a choice: a list. */
class List {
  constructor(key, changed) {
    this.key = key;
    const id = `key-${key.path.replaceAll(".", "-")}`;
    this.select = html("select", { id, "data-key": key.path, "aria-describedby": `${id}-doc` });
    if (key.default === null)
      this.select.append(
        html("option", { value: "", text: key.path === "drive.free" ? "neither" : "as the edition has it" }),
      );
    for (const choice of key.choices)
      this.select.append(html("option", { value: choice.name, text: choice.name, title: choice.doc }));
    this.doc = html("span", { class: "doc", id: `${id}-doc` });
    this.row = html(
      "div",
      { class: "row list" },
      html("label", { for: id, text: words(key.name), title: key.doc }),
      this.select,
      this.doc,
    );
    this.select.addEventListener("change", () => {
      this.told = "";
      changed(this.select.value === "" ? { unset: [key.path] } : { set: [[key.path, this.select.value]] });
    });
  }

  show(choice, given) {
    const told = `${choice} ${given}`;
    if (told === this.told) return;
    this.told = told;
    this.row.classList.toggle("given", given);
    this.select.value = given ? choice : (this.key.default ?? "");
    const chosen = this.key.choices.find((each) => each.name === choice);
    this.doc.textContent = chosen
      ? `${given || this.key.default ? "" : `${chosen.name}: `}${chosen.doc}`
      : this.key.doc;
  }
}

/** All controls, by sections. */
export class Controls {
  /** Whether the whole drive is looked at: its parts are shown then, in place of its operating point. */
  whole = false;

  constructor(host, keys, changed) {
    this.controls = new Map();
    this.boxes = new Map();
    for (const [section, title] of Object.entries(SECTIONS)) {
      // Lists, as those of an engine's curve, are for case files.
      const own = keys.filter((key) => key.section === section && (key.choices || key.unit !== undefined));
      if (own.length === 0) continue;
      const box = html(
        "details",
        { class: "section", open: [...OPEN, ...OPEN_PARTS].includes(section) },
        html("summary", {}, html("h3", { text: title })),
      );
      if (NOTES[section]) box.append(html("p", { class: "note", text: NOTES[section] }));
      for (const key of own) {
        const control = key.choices ? new List(key, changed) : new Quantity(key, changed);
        this.controls.set(key.path, control);
        box.append(control.row);
      }
      this.boxes.set(section, { box, own });
      host.append(box);
    }
  }

  /** Another drive is opened. */
  forget() {
    for (const control of this.controls.values()) control.forget?.();
  }

  /** Shows what the case gives and what the drive has. */
  show({ values, given, choices }, active) {
    const { whole } = this;
    for (const [path, control] of this.controls) {
      const is = given.includes(path);
      if (isPart(control.key.section) && !is) continue;
      if (control instanceof List) control.show(choices[path] ?? "", is);
      else control.show(values[path], is, active);
    }
    for (const [section, { box, own }] of this.boxes) {
      let any = false;
      for (const { path } of own) {
        const shown = whole ? !FOUND.includes(path) && (!isPart(section) || given.includes(path)) : !isPart(section);
        this.controls.get(path).row.hidden = !shown;
        any ||= shown;
      }
      box.hidden = !any || (whole && section === "operating_point");
    }
  }
}
