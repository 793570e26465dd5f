// Profiles along the contacts, as small line charts.

import { number, ticks } from "./format.js";
import { html, set, svg } from "./dom.js";

const HEIGHT = 190;
const MARGIN = { left: 52, right: 10, top: 8, bottom: 34 };
const DEGREES = 180 / Math.PI;

/** What is shown; `of` reads a pulley's samples, in the unit shown. */
export const PROFILES = [
  { id: "tension", title: "Tractive tension", unit: "N", of: (pulley) => pulley.tension },
  { id: "sliding", title: "Sliding speed", unit: "mm/s", log: true, guide: (scene) => 1e3 * scene.slip_threshold,
    guideLabel: "threshold", of: (pulley) => pulley.sliding_speed.map((value) => 1e3 * value) },
  { id: "direction", title: "Sliding direction (0° outward, 180° inward)", unit: "°",
    of: (pulley) => unjumped(pulley.sliding_angle.map((value) => value * DEGREES)) },
  { id: "penetration", title: "Penetration into the groove", unit: "mm",
    of: (pulley) => pulley.penetration.map((value) => 1e3 * value) },
  { id: "inclination", title: "Inclination (negative seats, positive unseats)", unit: "°",
    of: (pulley) => pulley.inclination.map((value) => value * DEGREES) },
  { id: "axial", title: "Axial force per length", unit: "N/mm",
    of: (pulley) => pulley.axial_force.map((value) => 1e-3 * value) },
  { id: "loss", title: "Friction loss per length", unit: "W/m", of: (pulley) => pulley.friction_loss },
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
  constructor(profile) {
    this.profile = profile;
    const id = `chart-${profile.id}`;
    this.caption = html("figcaption", { id });
    this.caption.append(profile.title, html("span", { class: "unit", text: ` (${profile.unit})` }));
    this.svg = svg("svg", { class: "chart", role: "img", "aria-labelledby": id, xmlns: "http://www.w3.org/2000/svg" });
    this.grid = svg("g", { class: "grid" });
    this.lines = {
      guide: svg("path", { class: "guide" }),
      primary: svg("path", { class: "line primary" }),
      secondary: svg("path", { class: "line secondary" }),
    };
    this.cursor = svg("g", { class: "cursor", visibility: "hidden" }, svg("path", { class: "guide" }));
    this.svg.append(this.grid, ...Object.values(this.lines), this.cursor);
    this.readout = html("p", { class: "readout" });
    this.figure = html("figure", {}, this.caption, this.svg, this.readout);
    this.svg.addEventListener("pointermove", (event) => this.#point(event));
    this.svg.addEventListener("pointerleave", () => this.#leave());
    new ResizeObserver(() => this.scene && this.show(this.scene)).observe(this.svg);
  }

  show(scene) {
    this.scene = scene;
    const { profile } = this;
    const width = Math.max(220, this.svg.clientWidth || 320);
    this.width = width;
    set(this.svg, { viewBox: `0 0 ${width} ${HEIGHT}` });
    const values = { primary: profile.of(scene.primary), secondary: profile.of(scene.secondary) };
    const guide = profile.guide?.(scene);
    const all = [...values.primary, ...values.secondary].filter((value) => Number.isFinite(value) && (!profile.log || value > 0));
    let [low, high] = [Math.min(...all, ...(guide ? [guide] : [])), Math.max(...all, ...(guide ? [guide] : []))];
    this.values = values;
    const reach = Math.max(scene.primary.wrap, scene.secondary.wrap) * DEGREES;
    if (profile.log) {
      low = Math.max(low, high * 1e-7);
      [low, high] = [Math.floor(Math.log10(low)), Math.ceil(Math.log10(high))];
      if (low === high) high += 1;
    } else {
      const room = 0.05 * (high - low || Math.abs(high) || 1);
      [low, high] = [low >= 0 && low - room < 0 ? 0 : low - room, high + room];
    }
    const inner = { width: width - MARGIN.left - MARGIN.right, height: HEIGHT - MARGIN.top - MARGIN.bottom };
    this.x = (angle) => MARGIN.left + (angle / reach) * inner.width;
    const place = (value) => (profile.log ? Math.log10(Math.max(value, 1e-300)) : value);
    this.y = (value) => {
      const share = (place(value) - low) / (high - low);
      return MARGIN.top + inner.height * (1 - Math.min(1.02, Math.max(-0.02, share)));
    };
    this.reach = reach;
    this.#axes(reach, low, high, inner);
    for (const name of ["primary", "secondary"]) {
      const angles = scene[name].angle;
      const at = (value, i) => `${i ? "L" : "M"}${this.x(angles[i] * DEGREES).toFixed(1)} ${this.y(value).toFixed(1)}`;
      set(this.lines[name], { d: values[name].map(at).join("") });
    }
    if (guide) set(this.lines.guide, { d: `M${MARGIN.left} ${this.y(guide).toFixed(1)}H${width - MARGIN.right}` });
    this.#leave();
  }

  #axes(reach, low, high, inner) {
    const across = ticks(0, reach, Math.max(3, inner.width / 70)).filter((angle) => angle <= reach);
    const degrees = reach > 120 ? ticks(0, reach, 100).filter((angle) => angle % (inner.width > 300 ? 30 : 60) === 0) : across;
    const count = this.profile.log ? Math.max(1, Math.ceil((high - low) / 5)) : 0;
    const up = this.profile.log
      ? Array.from({ length: high - low + 1 }, (_, k) => low + k).filter((power) => (power - low) % count === 0)
      : ticks(low, high, 4);
    const children = [];
    const bottom = HEIGHT - MARGIN.bottom;
    for (const power of up) {
      const value = this.profile.log ? 10 ** power : power;
      const y = this.y(value).toFixed(1);
      children.push(svg("path", { d: `M${MARGIN.left} ${y}H${MARGIN.left + inner.width}` }));
      const text = this.profile.log && (power < -2 || power > 3) ? `1e${power}` : number(value, 3);
      children.push(svg("text", { x: MARGIN.left - 6, y: Number(y) + 4, "text-anchor": "end", text }));
    }
    for (const angle of degrees) {
      const x = this.x(angle).toFixed(1);
      children.push(svg("path", { d: `M${x} ${bottom}v4` }));
      children.push(svg("text", { x, y: bottom + 16, "text-anchor": "middle", text: `${angle}°` }));
    }
    children.push(svg("path", { class: "axis", d: `M${MARGIN.left} ${MARGIN.top}V${bottom}H${MARGIN.left + inner.width}` }));
    children.push(svg("text", { class: "name", x: MARGIN.left + inner.width, y: bottom + 30, "text-anchor": "end", text: "wrap angle from the entry" }));
    this.grid.replaceChildren(...children);
  }

  /** The values where the pointer is. */
  #point(event) {
    if (!this.scene) return;
    const box = this.svg.getBoundingClientRect();
    const x = ((event.clientX - box.left) / box.width) * this.width;
    const angle = ((x - MARGIN.left) / (this.width - MARGIN.left - MARGIN.right)) * this.reach;
    if (angle < 0 || angle > this.reach) return this.#leave();
    set(this.cursor, { visibility: "visible" });
    set(this.cursor.firstChild, { d: `M${x.toFixed(1)} ${MARGIN.top}V${HEIGHT - MARGIN.bottom}` });
    const at = (name) => {
      const angles = this.scene[name].angle;
      const i = angles.findIndex((value) => value * DEGREES >= angle);
      return i < 0 ? "–" : number(this.values[name][i], 3);
    };
    this.readout.textContent = `${Math.round(angle)}°: primary ${at("primary")}, secondary ${at("secondary")} ${this.profile.unit}`;
  }

  #leave() {
    set(this.cursor, { visibility: "hidden" });
    const range = (name) => {
      const values = this.values[name].filter(Number.isFinite);
      return `${name} ${number(Math.min(...values), 3)} to ${number(Math.max(...values), 3)}`;
    };
    this.readout.textContent = `${range("primary")}, ${range("secondary")} ${this.profile.unit}`;
  }
}
