// The drive in its plane, to scale: sheaves, belt, contacts, rotation. x to the right and y up, in mm.

import { fixed, number } from "./format.js";
import { set, svg } from "./dom.js";
import { tensionColor } from "./colors.js";

/** Rotations are shown this many times slower than they are. */
export const SLOWER = 100;

const CONTACT_PIECES = 48;
const SPAN_PIECES = 24;
const SPOKES = 6;
/** Room that a name of a span takes besides its distance, px, and how often it is made to fit at most. */
const LETTERS = 12;
const ROUNDS = 4;
/** Marks on the belt. */
const MARKS = 28;
/** Milliseconds after a drawing in which the next one is waited for: rotation goes on with it, not beside it. */
const FOLLOWED = 120;
const REGIONS = ["primary", "slack_span", "secondary", "tight_span"];

const mm = (metres) => 1000 * metres;

/** The loop as points with their tension, and whether the belt adheres there. */
function loop(scene) {
  const points = [];
  for (const region of REGIONS) {
    const part = scene[region];
    for (let i = 0; i < part.x.length; i += 1) {
      const adheres = part.sliding_speed ? part.sliding_speed[i] < scene.slip_threshold : null;
      points.push({ x: mm(part.x[i]), y: mm(part.y[i]), tension: part.tension[i], adheres, region, i });
    }
  }
  return points;
}

function line(points) {
  return points.map(({ x, y }, i) => `${i ? "L" : "M"}${x.toFixed(3)} ${(-y).toFixed(3)}`).join("");
}

/** Runs of a region's points, about `count` of them, each a little into the next, so that no seam shows. */
function pieces(points, count) {
  const runs = [];
  for (let k = 0; k < count; k += 1) {
    const from = Math.floor((k * (points.length - 1)) / count);
    const to = Math.floor(((k + 1) * (points.length - 1)) / count);
    runs.push(points.slice(from, to + 2));
  }
  return runs;
}

/** Where the belt adheres and where it slides, as runs of wrap angle: [{ from, to, adheres }]. */
export function runs(pulley, threshold) {
  const found = [];
  const { angle, sliding_speed: speed } = pulley;
  for (let i = 0; i + 1 < angle.length; i += 1) {
    const [a, b] = [speed[i] - threshold, speed[i + 1] - threshold];
    const cut = a < 0 === b < 0 ? null : angle[i] + ((angle[i + 1] - angle[i]) * a) / (a - b);
    const parts =
      cut === null
        ? [[angle[i], angle[i + 1], a < 0]]
        : [
            [angle[i], cut, a < 0],
            [cut, angle[i + 1], b < 0],
          ];
    for (const [from, to, adheres] of parts) {
      const last = found.at(-1);
      if (last && last.adheres === adheres) last.to = to;
      else if (to > from) found.push({ from, to, adheres });
    }
  }
  return found;
}

/** Where the name of a span stands: at its middle, so many pixels away from it, outside of the belt. */
function place(span) {
  const middle = Math.floor(span.x.length / 2);
  const up = span.y[middle] > 0;
  const [dx, dy] = [span.x.at(-1) - span.x[0], span.y.at(-1) - span.y[0]];
  // Clear of a belt that rises under the text.
  const slope = 55 * Math.abs(dy / dx);
  return { x: mm(span.x[middle]), y: mm(span.y[middle]), up, away: (up ? 13 : 22) + slope };
}

function arc(center, radius, from, to) {
  const at = (angle) => `${(center + radius * Math.cos(angle)).toFixed(3)} ${(-radius * Math.sin(angle)).toFixed(3)}`;
  const large = to - from > Math.PI ? 1 : 0;
  return `M${at(from)}A${radius.toFixed(3)} ${radius.toFixed(3)} 0 ${large} 0 ${at(to)}`;
}

export class DriveView {
  #scene = null;
  #turned = { primary: 0, secondary: 0, belt: 0 };
  #last = 0;
  #shown = 0;
  #slips = false;
  #scale = 1;
  /** Of the drawing on the page, in pixels, as it was told last. */
  #size = { width: 200, height: 120 };
  #room = { left: 0, right: 0, above: 0, below: 0 };
  /** Whether it moves, and whether it is looked at. */
  moves = true;
  seen = true;

  constructor(host) {
    this.svg = svg("svg", {
      class: "drive",
      role: "img",
      "aria-labelledby": "drive-title",
      xmlns: "http://www.w3.org/2000/svg",
    });
    this.title = svg("title", { id: "drive-title" });
    const layer = (name) => svg("g", { class: name });
    this.layers = { back: layer("back"), contact: layer("contact"), belt: layer("belt"), front: layer("front") };
    this.svg.append(this.title, ...Object.values(this.layers));
    host.append(this.svg);
    const many = (count, parent, attributes) =>
      Array.from({ length: count }, () => {
        const path = svg("path", attributes);
        parent.append(path);
        return path;
      });
    this.pulleys = {};
    for (const name of ["primary", "secondary"]) {
      const part = {
        disc: svg("circle", { class: "disc" }),
        nominal: svg("circle", { class: "nominal" }),
        spokes: svg("g", { class: "spokes" }),
        hub: svg("circle", { class: "hub" }),
        arrow: svg("path", { class: "turning" }),
        head: svg("path", { class: "head" }),
        label: svg("text", { class: "label", "text-anchor": "middle" }),
        value: svg("text", { class: "value", "text-anchor": "middle" }),
      };
      part.lines = many(SPOKES, part.spokes, { class: "spoke" });
      this.layers.back.append(part.disc, part.nominal, part.spokes, part.hub);
      this.layers.front.append(part.arrow, part.head, part.label, part.value);
      part.arcs = [];
      this.pulleys[name] = part;
    }
    this.belt = {};
    for (const region of REGIONS) {
      const count = region.endsWith("span") ? SPAN_PIECES : CONTACT_PIECES;
      this.belt[region] = many(count, this.layers.belt, { class: "piece" });
    }
    this.marks = svg("path", { class: "marks", pathLength: 1000 });
    this.layers.belt.append(this.marks);
    this.spans = {
      tight_span: svg("text", { class: "label", "text-anchor": "middle" }),
      slack_span: svg("text", { class: "label", "text-anchor": "middle" }),
    };
    this.layers.front.append(...Object.values(this.spans));
    new ResizeObserver((entries) => {
      this.#size = entries.at(-1).contentRect;
      if (this.#scene) this.show(this.#scene, this.#slips);
    }).observe(this.svg);
    const frame = (now) => {
      if (now - this.#shown > FOLLOWED) this.#move(now);
      requestAnimationFrame(frame);
    };
    requestAnimationFrame(frame);
  }

  /** Draws a solution; `slips` where it is the last one before the belt slips. */
  show(scene, slips) {
    this.#scene = scene;
    this.#slips = slips;
    this.#shown = performance.now();
    const points = loop(scene);
    this.#frame(scene, points);
    this.svg.classList.toggle("slips", slips);
    for (const name of ["primary", "secondary"]) this.#pulley(name, scene[name], scene);
    const tensions = points.map((point) => point.tension);
    const [low, high] = [Math.min(...tensions), Math.max(...tensions)];
    this.range = [low, high];
    const dark = matchMedia("(prefers-color-scheme: dark)").matches;
    const top = Math.max(high, 1e-9);
    for (const region of REGIONS) {
      const own = points.filter((point) => point.region === region);
      pieces(own, this.belt[region].length).forEach((run, k) => {
        const mean = run.reduce((sum, point) => sum + point.tension, 0) / run.length;
        const share = high > low ? (mean - low) / (high - low) : 0.5;
        const width = this.#scale * (2.5 + (8.5 * Math.max(0, mean)) / top);
        set(this.belt[region][k], {
          d: line(run),
          stroke: tensionColor(share, dark),
          "stroke-width": width.toFixed(3),
        });
      });
    }
    set(this.marks, { d: `${line(points)}Z`, "stroke-width": (1.6 * this.#scale).toFixed(3) });
    this.#spanLabels(scene);
    this.length = points.reduce((sum, point, i) => {
      const before = points.at(i - 1);
      return sum + Math.hypot(point.x - before.x, point.y - before.y);
    }, 0);
    this.#describe(scene, slips);
    this.#move(this.#shown);
  }

  /** The window on the plane: it changes in steps, so that nothing else moves while a radius does. */
  #frame(scene, points) {
    const [p, s] = [mm(scene.primary.radius), mm(scene.secondary.radius)];
    const center = mm(scene.center_distance);
    const rim = Math.max(1.06 * Math.max(p, s), Math.min(1.1 * Math.max(p, s), 0.485 * center));
    this.rim = rim;
    const stepped = (before, least) =>
      before >= least && before < least + 25 ? before : 10 * Math.ceil((least + 3) / 10);
    const across = points.map((point) => point.x);
    const up = points.map((point) => point.y);
    this.#room = {
      left: stepped(this.#room.left, Math.max(rim, -Math.min(...across))),
      right: stepped(this.#room.right, Math.max(rim, Math.max(...across) - center)),
      above: stepped(this.#room.above, Math.max(rim, Math.max(...up))),
      below: stepped(this.#room.below, Math.max(rim, -Math.min(...up))),
    };
    const { left, right, above, below } = this.#room;
    const width = left + center + right;
    // Room for the names of the spans, which are as large as on any drawing: the more room, the smaller its scale.
    const scale = (labels) => {
      const height = above + below + 2 * labels;
      return Math.max(width / Math.max(this.#size.width, 200), height / Math.max(this.#size.height, 120));
    };
    let labels = 0.055 * width;
    for (let k = 0; k < ROUNDS; k += 1) {
      const beyond = Object.keys(this.spans).map((region) => {
        const { up, y, away } = place(scene[region]);
        return (up ? y - above : -y - below) + (away + LETTERS) * scale(labels);
      });
      const needed = Math.max(...beyond);
      if (needed <= labels) break;
      // In steps, as the window.
      labels = 10 * Math.ceil(needed / 10);
    }
    const height = above + below + 2 * labels;
    set(this.svg, { viewBox: `${-left} ${-above - labels} ${width} ${height}` });
    this.#scale = scale(labels);
    this.svg.style.setProperty("--px", String(this.#scale));
    this.svg.style.aspectRatio = `${width} / ${height}`;
  }

  #pulley(name, pulley, scene) {
    const part = this.pulleys[name];
    const [radius, center] = [mm(pulley.radius), mm(pulley.center)];
    const px = this.#scale;
    set(part.disc, { cx: center, cy: 0, r: Math.max(this.rim * 0.985, radius * 1.04) });
    set(part.nominal, { cx: center, cy: 0, r: radius, "stroke-dasharray": `${3 * px} ${3 * px}`, "stroke-width": px });
    const hub = 0.13 * radius;
    set(part.hub, { cx: center, cy: 0, r: hub, "stroke-width": 1.5 * px });
    part.lines.forEach((spoke, k) => {
      const angle = (k * 2 * Math.PI) / SPOKES;
      const at = (r) => `${(r * Math.cos(angle)).toFixed(3)} ${(r * Math.sin(angle)).toFixed(3)}`;
      set(spoke, { d: `M${at(hub)}L${at(this.rim * 0.985)}`, "stroke-width": px });
    });
    this.#turn(name);
    // Counter-clockwise, as the belt runs.
    const turn = 0.62 * radius;
    const head = 7 * px;
    const [from, to] = [Math.PI * 0.2, Math.PI * 0.8];
    set(part.arrow, { d: arc(center, turn, from, to), "stroke-width": 2.2 * px });
    const tip = [center + turn * Math.cos(to), turn * Math.sin(to)];
    const along = [-Math.sin(to), Math.cos(to)];
    const across = [Math.cos(to), Math.sin(to)];
    const corner = (a, b) => {
      const [x, y] = [0, 1].map((k) => tip[k] + head * (a * along[k] + b * across[k]));
      return `${x.toFixed(3)} ${-y.toFixed(3)}`;
    };
    set(part.head, { d: `M${corner(1.1, 0)}L${corner(-0.4, 0.7)}L${corner(-0.4, -0.7)}Z` });
    part.label.textContent = name;
    part.value.textContent = `${number((pulley.speed * 30) / Math.PI)} rpm`;
    const below = hub + 15 * px;
    set(part.label, { x: center, y: below });
    set(part.value, { x: center, y: below + 16 * px });
    this.#contact(part, pulley, scene);
  }

  /** The contact: one arc for each run of adhesion or sliding, inside the belt. */
  #contact(part, pulley, scene) {
    const found = this.#slips ? [{ from: 0, to: pulley.wrap, adheres: false }] : runs(pulley, scene.slip_threshold);
    while (part.arcs.length < found.length) {
      const path = svg("path", {});
      this.layers.contact.append(path);
      part.arcs.push(path);
    }
    const px = this.#scale;
    part.arcs.forEach((path, k) => {
      const run = found[k];
      if (!run) {
        set(path, { d: "", class: "" });
        return;
      }
      const radius = mm(pulley.radius) - 11 * px;
      set(path, {
        d: arc(mm(pulley.center), radius, pulley.entry + run.from, pulley.entry + run.to),
        class: run.adheres ? "adheres" : "slides",
        "stroke-width": (run.adheres ? 6 : 5) * px,
        "stroke-dasharray": run.adheres ? "none" : `${3.5 * px} ${2 * px}`,
      });
    });
  }

  #spanLabels(scene) {
    for (const [region, text] of Object.entries(this.spans)) {
      const part = scene[region];
      const { x, y, up, away } = place(part);
      const mean = part.tension.reduce((sum, value) => sum + value, 0) / part.tension.length;
      text.textContent = `${region.replace("_", " ")}, ${number(mean, 3)} N`;
      set(text, { x: x.toFixed(2), y: (-y + (up ? -away : away) * this.#scale).toFixed(2) });
    }
  }

  #describe(scene, slips) {
    const adhesion = (name) => {
      const parts = runs(scene[name], scene.slip_threshold).filter((run) => run.adheres);
      return parts.reduce((sum, run) => sum + run.to - run.from, 0) / scene[name].wrap;
    };
    const pulley = (name) =>
      `the ${name} at radius ${fixed(mm(scene[name].radius), 1)} mm ` +
      `turns at ${number((scene[name].speed * 30) / Math.PI)} rpm, ` +
      `wrapped over ${fixed((scene[name].wrap * 180) / Math.PI, 0)} degrees, ` +
      `${fixed(100 * adhesion(name), 0)} % of it in adhesion`;
    const text = slips
      ? "The drive at the last solution before the belt slips."
      : `The drive to scale: ${pulley("primary")}; ${pulley("secondary")}; tractive tensions from ` +
        `${number(this.range[0], 3)} to ${number(this.range[1], 3)} newton.`;
    this.title.textContent = text;
  }

  #turn(name) {
    const degrees = (-this.#turned[name] * 180) / Math.PI;
    const center = this.#scene ? mm(this.#scene[name].center) : 0;
    set(this.pulleys[name].spokes, { transform: `translate(${center} 0) rotate(${degrees.toFixed(2)})` });
  }

  #move(now) {
    const seconds = Math.min(0.1, Math.max(0, (now - this.#last) / 1000));
    this.#last = now;
    const scene = this.#scene;
    if (!scene || !this.moves || !this.seen) return;
    const held = this.#slips ? 0 : 1;
    this.#turned.primary += (seconds * scene.primary.speed) / SLOWER;
    this.#turned.secondary += (held * seconds * scene.secondary.speed) / SLOWER;
    this.#turned.belt += (held * seconds * scene.primary.speed * mm(scene.primary.radius)) / SLOWER;
    for (const name of ["primary", "secondary"]) this.#turn(name);
    const gap = 1000 / MARKS;
    const share = this.length ? (1000 * this.#turned.belt) / this.length : 0;
    set(this.marks, {
      "stroke-dasharray": `3 ${(gap - 3).toFixed(3)}`,
      "stroke-dashoffset": (-(share % gap)).toFixed(3),
    });
  }
}
