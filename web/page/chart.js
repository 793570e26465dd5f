// Profiles along the contacts, as small line charts.

import { number, powerOfTen, step, tick, ticks } from "./format.js";
import { html, set, svg } from "./dom.js";

const HEIGHT = 190;
/** Kinds of lines, each with its look in the style sheet, the topmost last. */
const KINDS = ["before", "guide", "primary", "secondary", "loop", "up", "back"];
/** Width of a letter of a name, about, px. */
const LETTER = 7;
const MARGIN = { left: 52, right: 10, top: 8, bottom: 34 };
const DEGREES = 180 / Math.PI;

/** Both contacts over their wrap angles. */
const wrapped = (of) => (scene) =>
  ["primary", "secondary"].map((name) => ({
    name,
    x: scene[name].angle.map((angle) => angle * DEGREES),
    y: of(scene[name]),
  }));

/** The tension along the whole belt, region after region, over the arc length in mm. */
function loop(scene) {
  let start = 0;
  const line = { name: "loop", x: [], y: [], marks: [] };
  for (const region of ["primary", "slack_span", "secondary", "tight_span"]) {
    const part = scene[region];
    line.marks.push([start, { primary: "P", secondary: "S" }[region] ?? region.replace("_span", "")]);
    let arc = 0;
    part.tension.forEach((tension, i) => {
      if (i > 0) arc += 1e3 * Math.hypot(part.x[i] - part.x[i - 1], part.y[i] - part.y[i - 1]);
      line.x.push(start + arc);
      line.y.push(tension);
    });
    start += arc;
  }
  return [line];
}

const WRAP = { label: "wrap angle from the entry", unit: "°" };

/** What is shown; `lines` reads a scene, in the units shown. */
export const PROFILES = [
  {
    id: "loop",
    title: "Tractive tension along the belt",
    unit: "N",
    over: { label: "arc length from the primary's entry (mm)", unit: " mm" },
    lines: loop,
  },
  { id: "tension", title: "Tractive tension", unit: "N", over: WRAP, lines: wrapped((pulley) => pulley.tension) },
  {
    id: "sliding",
    title: "Sliding speed",
    unit: "mm/s, dotted: threshold",
    over: WRAP,
    log: true,
    guide: (scene) => 1e3 * scene.slip_threshold,
    lines: wrapped((pulley) => pulley.sliding_speed.map((value) => 1e3 * value)),
  },
  {
    id: "direction",
    title: "Sliding direction",
    unit: "°, 0 out, 180 in",
    over: WRAP,
    lines: wrapped((pulley) => unjumped(pulley.sliding_angle.map((value) => value * DEGREES))),
  },
  {
    id: "penetration",
    title: "Penetration",
    unit: "mm",
    over: WRAP,
    lines: wrapped((pulley) => pulley.penetration.map((value) => 1e3 * value)),
  },
  {
    id: "inclination",
    title: "Inclination",
    unit: "°, positive unseats",
    over: WRAP,
    lines: wrapped((pulley) => pulley.inclination.map((value) => value * DEGREES)),
  },
  {
    id: "axial",
    title: "Axial force per length",
    unit: "N/mm",
    over: WRAP,
    lines: wrapped((pulley) => pulley.axial_force.map((value) => 1e-3 * value)),
  },
  {
    id: "loss",
    title: "Friction loss per length",
    unit: "W/m",
    over: WRAP,
    lines: wrapped((pulley) => pulley.friction_loss),
  },
];

/** Angles without jumps from 360° to 0°: they go on beyond. */
function unjumped(angles) {
  let turns = 0;
  return angles.map((angle, i) => {
    if (i > 0) turns -= 360 * Math.round((angle - angles[i - 1]) / 360);
    return angle + turns;
  });
}

export class Chart {
  /** Of a profile: what it is called, what its axes are, and how its lines are read from what is shown. */
  constructor(profile) {
    this.profile = profile;
    const id = `chart-${profile.id}`;
    this.caption = html("figcaption", { id });
    this.caption.append(profile.title);
    if (profile.unit) this.caption.append(html("span", { class: "unit", text: ` (${profile.unit})` }));
    this.svg = svg("svg", {
      class: profile.tall ? "chart tall" : "chart",
      role: "img",
      "aria-labelledby": id,
      xmlns: "http://www.w3.org/2000/svg",
    });
    this.grid = svg("g", { class: "grid" });
    this.paths = Object.fromEntries(
      KINDS.map((kind) => [kind, svg("path", { class: kind === "guide" ? kind : `line ${kind}` })]),
    );
    this.marks = svg("g", { class: "places" });
    this.cursor = svg("g", { class: "cursor", visibility: "hidden" }, svg("path", { class: "guide" }));
    this.svg.append(this.grid, ...Object.values(this.paths), this.marks, this.cursor);
    this.readout = html("p", { class: "readout" });
    this.figure = html("figure", {}, this.caption, this.svg, this.readout);
    this.svg.addEventListener("pointermove", (event) => this.#point(event));
    this.svg.addEventListener("pointerleave", () => this.#leave());
    // Told, not asked for: asking between two drawings would have the page laid out for each of them.
    new ResizeObserver((entries) => {
      this.size = entries.at(-1).contentRect;
      if (this.scene) this.show(this.scene);
    }).observe(this.svg);
    // Out of sight, nothing is drawn.
    this.seen = false;
    const sight = new IntersectionObserver(
      (entries) => {
        this.seen = entries.at(-1).isIntersecting;
        if (this.seen && this.scene && this.drawn !== this.scene) this.show(this.scene);
      },
      { rootMargin: "100px" },
    );
    sight.observe(this.svg);
    // On paper, all is in sight.
    addEventListener("beforeprint", () => {
      const { seen } = this;
      this.seen = true;
      if (this.scene) this.show(this.scene);
      this.seen = seen;
    });
  }

  show(scene) {
    this.scene = scene;
    if (!this.seen) return;
    this.drawn = scene;
    const { profile } = this;
    const width = Math.max(220, this.size?.width || 320);
    this.width = width;
    this.height = this.size?.height || HEIGHT;
    set(this.svg, { viewBox: `0 0 ${width} ${this.height}` });
    this.lines = profile.lines(scene);
    const guide = profile.guide?.(scene);
    const all = this.lines
      .flatMap((line) => line.y)
      .filter((value) => Number.isFinite(value) && (!profile.log || value > 0));
    let [low, high] = [Math.min(...all, ...(guide ? [guide] : [])), Math.max(...all, ...(guide ? [guide] : []))];
    const reach = Math.max(...this.lines.map((line) => line.x.at(-1) ?? 0));
    if (all.length === 0 || !(reach > 0)) return this.#empty();
    if (profile.log) {
      low = Math.max(low, high * 1e-7);
      [low, high] = [Math.floor(Math.log10(low)), Math.ceil(Math.log10(high))];
      if (low === high) high += 1;
    } else {
      const room = 0.05 * (high - low || Math.abs(high) || 1);
      [low, high] = [low >= 0 && low - room < 0 ? 0 : low - room, high + (this.lines[0].marks ? 4 * room : room)];
      if (profile.from !== undefined) low = Math.min(low, profile.from);
    }
    const inner = { width: width - MARGIN.left - MARGIN.right, height: this.height - MARGIN.top - MARGIN.bottom };
    this.x = (angle) => MARGIN.left + (angle / reach) * inner.width;
    const place = (value) => (profile.log ? Math.log10(Math.max(value, 1e-300)) : value);
    this.y = (value) => {
      const share = (place(value) - low) / (high - low);
      return MARGIN.top + inner.height * (1 - Math.min(1.02, Math.max(-0.02, share)));
    };
    this.reach = reach;
    this.#axes(reach, low, high, inner);
    for (const [kind, path] of Object.entries(this.paths)) {
      const line = this.lines.find(({ name }) => name === kind);
      set(path, { d: line ? this.#path(line) : "" });
    }
    this.#rays(profile.rays?.(scene) ?? [], low, high);
    this.#places(profile.places?.(scene) ?? []);
    if (guide) set(this.paths.guide, { d: `M${MARGIN.left} ${this.y(guide).toFixed(1)}H${width - MARGIN.right}` });
    this.#leave();
  }

  /** A line, broken where a number is missing. */
  #path({ x, y }) {
    let pen = "M";
    const at = (value, i) => {
      if (!Number.isFinite(value)) {
        pen = "M";
        return "";
      }
      const text = `${pen}${this.x(x[i]).toFixed(1)} ${this.y(value).toFixed(1)}`;
      pen = "L";
      return text;
    };
    return y.map(at).join("");
  }

  /** Lines through the origin, as far as they are in sight. */
  #rays(rates, low, high) {
    const ray = (rate) => {
      const at = (x) => `${this.x(x).toFixed(1)} ${this.y(rate * x).toFixed(1)}`;
      const end = Math.min(high / rate, this.reach);
      return rate * end > low ? `M${at(low / rate)}L${at(end)}` : "";
    };
    set(this.paths.guide, { d: rates.map(ray).join("") });
  }

  /**
   * Points that mean something by themselves, with their names: beside them where there is room, else above or below,
   * with a line to the circle that is meant.
   */
  #places(places) {
    const circles = places.map(({ x, y }) => ({ cx: this.x(x), cy: this.y(y) }));
    const taken = circles.map(({ cx, cy }) => ({ left: cx - 6, right: cx + 6, top: cy - 6, bottom: cy + 6 }));
    const names = places.map(({ text, side }, i) => {
      if (!text) return null;
      const width = LETTER * text.length;
      const { cx, cy } = circles[i];
      const box = (left, down) => ({ left, right: left + width, top: cy + down - 11, bottom: cy + down + 3 });
      const beside = box(side === "end" ? cx - 9 - width : cx + 9, -7);
      const within = Math.max(MARGIN.left + 4, Math.min(this.width - width - 2, beside.left));
      const further = [-26, 32, -44, 50].map((down) => box(within, down));
      return { text, side, beside, further };
    });
    // Names that have room beside their own circle first: the others make way for them.
    const put = (name, boxes) => {
      const box = boxes.find((box) => this.#isFree(box, taken));
      if (!box) return;
      name.box = box;
      taken.push(box);
    };
    const named = names.filter(Boolean);
    for (const name of named) put(name, [name.beside]);
    for (const name of named) if (!name.box) put(name, name.further);
    const children = places.flatMap(({ name: kind }, i) => {
      const { cx, cy } = circles[i];
      const circle = svg("circle", { class: `place ${kind}`, cx: cx.toFixed(1), cy: cy.toFixed(1), r: 4.5 });
      const name = names[i];
      if (!name) return [circle];
      const { text, side, beside, box = beside } = name;
      const isBeside = box === beside;
      const x = isBeside && side === "end" ? box.right : box.left;
      const anchor = isBeside ? side : "start";
      const word = svg("text", { x: x.toFixed(1), y: (box.bottom - 3).toFixed(1), "text-anchor": anchor, text });
      if (isBeside) return [circle, word];
      const above = box.bottom < cy;
      const foot = `${Math.max(box.left + 6, Math.min(box.right - 12, cx)).toFixed(1)} ${above ? box.bottom : box.top}`;
      const line = svg("path", { class: "leader", d: `M${cx.toFixed(1)} ${cy + (above ? -4.5 : 4.5)}L${foot}` });
      return [line, circle, word];
    });
    this.marks.replaceChildren(...children);
  }

  /** Whether a name runs neither over the numbers of the axis, nor over the edge, nor over another name. */
  #isFree({ left, right, top, bottom }, taken) {
    const inside = left > MARGIN.left && right < this.width && top >= 0 && bottom < this.height - MARGIN.bottom;
    return (
      inside &&
      taken.every((other) => left > other.right || right < other.left || top > other.bottom || bottom < other.top)
    );
  }

  /** Nothing is known. */
  #empty() {
    this.lines = null;
    for (const path of Object.values(this.paths)) set(path, { d: "" });
    this.grid.replaceChildren();
    this.marks.replaceChildren();
    this.readout.textContent = "";
    set(this.cursor, { visibility: "hidden" });
  }

  #axes(reach, low, high, inner) {
    const bottom = this.height - MARGIN.bottom;
    const right = MARGIN.left + inner.width;
    const children = [];
    const mark = (attributes) => children.push(svg("path", attributes));
    const write = (attributes) => children.push(svg("text", attributes));
    if (this.profile.log) {
      const gap = Math.max(1, Math.ceil((high - low) / 5));
      for (let power = low; power <= high; power += gap) this.#rung(children, 10 ** power, powerOfTen(power), inner);
    } else {
      const up = ticks(low, high, this.profile.tall && inner.height > 160 ? 6 : 4);
      for (const value of up) this.#rung(children, value, tick(value, up.length > 1 ? up[1] - up[0] : 1), inner);
    }
    const many = inner.width > 300;
    const gap = this.profile.over === WRAP ? (many ? 30 : 60) : step(reach, inner.width > 600 ? 9 : many ? 5 : 3);
    for (let place = 0; place <= reach; place += gap) {
      const x = this.x(place).toFixed(1);
      mark({ d: `M${x} ${bottom}v4` });
      write({ x, y: bottom + 16, "text-anchor": "middle", text: this.profile.over === WRAP ? `${place}°` : place });
    }
    (this.lines[0].marks ?? []).forEach(([place, name], k, marks) => {
      const middle = 0.5 * (place + (marks[k + 1]?.[0] ?? reach));
      if (place > 0) mark({ d: `M${this.x(place).toFixed(1)} ${MARGIN.top}V${bottom}` });
      write({ x: this.x(middle).toFixed(1), y: MARGIN.top + 11, "text-anchor": "middle", text: name });
    });
    mark({ class: "axis", d: `M${MARGIN.left} ${MARGIN.top}V${bottom}H${right}` });
    write({ class: "name", x: right, y: bottom + 31, "text-anchor": "end", text: this.profile.over.label });
    this.grid.replaceChildren(...children);
  }

  /** A horizontal line of the grid, and its value. */
  #rung(children, value, text, inner) {
    const y = this.y(value);
    children.push(svg("path", { d: `M${MARGIN.left} ${y.toFixed(1)}H${MARGIN.left + inner.width}` }));
    children.push(svg("text", { x: MARGIN.left - 6, y: (y + 4).toFixed(1), "text-anchor": "end", text }));
  }

  /** The values where the pointer is. */
  #point(event) {
    if (!this.lines) return;
    const box = this.svg.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * this.width;
    const place = ((x - MARGIN.left) / (this.width - MARGIN.left - MARGIN.right)) * this.reach;
    if (place < 0 || place > this.reach) return this.#leave();
    set(this.cursor, { visibility: "visible" });
    set(this.cursor.firstChild, { d: `M${x.toFixed(1)} ${MARGIN.top}V${this.height - MARGIN.bottom}` });
    const at = (line) => {
      const i = line.x.findIndex((value) => value >= place);
      return `${this.#name(line)}${i < 0 ? "–" : number(line.y[i], 3)}`;
    };
    const values = this.#named.map(at).join(", ");
    this.readout.textContent = `${Math.round(place)}${this.profile.over.unit}: ${values} ${this.#unit}`;
  }

  /** The lines that say something. */
  get #named() {
    return this.lines.filter(({ y }) => y.some(Number.isFinite));
  }

  #name(line) {
    return line.name === "loop" ? "" : `${line.text ?? line.name} `;
  }

  get #unit() {
    return this.profile.unit.split(",")[0];
  }

  #leave() {
    set(this.cursor, { visibility: "hidden" });
    if (!this.lines) return;
    const range = (line) => {
      const values = line.y.filter(Number.isFinite);
      return `${this.#name(line)}${number(Math.min(...values), 3)} to ${number(Math.max(...values), 3)}`;
    };
    this.readout.textContent = `${this.#named.map(range).join(", ")} ${this.#unit}`;
  }
}
