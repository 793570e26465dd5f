// The whole drive: its shift curve, drawn while it is computed.

import { Chart } from "./chart.js";
import { html } from "./dom.js";
import { fixed, number } from "./format.js";

const RPM = 30 / Math.PI;
const KMH = 3.6;
const WAYS = { up: "shifting up", back: "shifting back" };
const PLACES = {
  take_off: "the belt takes the drive off",
  shift_out: "it leaves the low stop",
  full_shift: "it arrives at the high stop",
};
const SHORT = { take_off: "take-off", shift_out: "shift-out", full_shift: "full shift" };

const percent = (share) => (share === null || share === undefined ? NaN : 100 * share);

/** One direction: the curve that is being computed, and the one before it. */
class Branch {
  landmarks = {};
  engagement = null;
  points = [];
  before = [];
  left = 0;
  missing = [];
  /** What there is to say of all points together. */
  remarks = [];

  begin(answer) {
    if (this.points.length > 0) this.before = this.shown();
    this.landmarks = Object.fromEntries(Object.keys(PLACES).map((name) => [name, answer[name]]));
    this.engagement = answer.engagement_speed;
    this.points = [];
    this.left = answer.left;
    this.missing = answer.missing;
    this.remarks = [];
  }

  add(point, left, remarks) {
    this.points.push(point);
    this.left = left;
    this.remarks = remarks ?? [];
    if (left === 0) this.before = [];
  }

  /** No more points come; those of the curve before stay behind the last where it is of the `same` drive. */
  stop(same) {
    this.left = 0;
    if (!same) this.before = [];
  }

  /** The points so far, and behind them those of the curve before. */
  shown() {
    const last = this.points.at(-1)?.secondary_speed ?? -Infinity;
    return [...this.points, ...this.before.filter((point) => point.secondary_speed > last)];
  }
}

/** What the charts show; `over` says how far a speed of the secondary carries the vehicle, m/s for 1 rad/s. */
function lines(of) {
  return ({ branches, over }) =>
    Object.entries(branches).map(([name, branch]) => {
      const points = branch.shown();
      return {
        name,
        x: points.map((point) => over(point.secondary_speed)),
        y: points.map((point) => of(point) ?? NaN),
      };
    });
}

/** Engine speed over what the axis shows, rpm, at low and at high ratio. */
function rates({ branches, over }) {
  const places = ["shift_out", "full_shift"].map(
    (name) => branches.up.landmarks[name] ?? branches.back.landmarks[name],
  );
  return places.filter(Boolean).map((place) => (place.primary_speed * RPM) / over(place.secondary_speed));
}

const PROFILES = [
  {
    id: "efficiency",
    title: "Overall efficiency",
    unit: "%",
    lines: lines((point) => percent(point.efficiency)),
  },
  {
    id: "reserve",
    title: "Friction in reserve",
    unit: "%",
    from: 0,
    lines: lines((point) => percent(point.slip_reserve)),
  },
  {
    id: "ratio",
    title: "Ratio, secondary over primary radius",
    unit: "",
    lines: lines((point) => point.ratio),
  },
  {
    id: "primary-force",
    title: "Axial force on the primary",
    unit: "N",
    lines: lines((point) => point.primary_axial_force),
  },
  {
    id: "secondary-force",
    title: "Axial force on the secondary",
    unit: "N",
    lines: lines((point) => point.secondary_axial_force),
  },
  {
    id: "power",
    title: "Power out of the secondary",
    unit: "kW",
    from: 0,
    lines: lines((point) => (point.power_out === undefined ? NaN : 1e-3 * point.power_out)),
  },
];

/** The columns of the table: key, name, value as text. */
const COLUMNS = [
  ["direction", "direction", (point) => point.direction],
  ["secondary_speed", "secondary (rpm)", (point) => number(point.secondary_speed * RPM)],
  [
    "vehicle_speed",
    "road (km/h)",
    (point) => number(point.vehicle_speed === null ? NaN : point.vehicle_speed * KMH, 3),
  ],
  ["primary_speed", "engine (rpm)", (point) => number(point.primary_speed * RPM)],
  ["ratio", "ratio", (point) => number(point.ratio, 3)],
  ["phase", "phase", (point) => point.phase],
  ["primary_axial_force", "primary (N)", (point) => number(point.primary_axial_force)],
  ["secondary_axial_force", "secondary (N)", (point) => number(point.secondary_axial_force)],
  ["slip_reserve", "reserve (%)", (point) => fixed(percent(point.slip_reserve), 1)],
  ["efficiency", "efficiency (%)", (point) => fixed(percent(point.efficiency), 2)],
  ["doubt", "doubt", (point) => (point.slipping ? "slips" : (point.doubt ?? ""))],
];

/** A field of CSV. */
const field = (value) => {
  const text = String(value ?? "");
  return /[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
};

export class ShiftView {
  branches = { up: new Branch(), back: new Branch() };
  #road = null;
  #scheduled = false;
  /** Whether the curve was left before all its points were there. */
  #stopped = false;

  /** Draws into the elements: the large chart, the small ones, the landmarks and the table of all points. */
  constructor({ chart, charts, landmarks, table, progress, state }) {
    this.parts = { landmarks, table, progress, state };
    const over = { label: "", unit: "" };
    this.over = over;
    this.main = new Chart({
      id: "shift",
      title: "Engine speed",
      unit: "rpm",
      over,
      tall: true,
      lines: lines((point) => point.primary_speed * RPM),
      rays: rates,
      places: (scene) => this.#places(scene),
    });
    this.charts = PROFILES.map((profile) => new Chart({ ...profile, id: `shift-${profile.id}`, over }));
    chart.append(this.main.figure);
    charts.append(...this.charts.map(({ figure }) => figure));
  }

  get svg() {
    return this.main.svg;
  }

  /** A curve begins, in place of the one before in its direction. */
  begin(answer) {
    this.#stopped = false;
    this.branches[answer.direction].begin(answer);
    this.#road = answer.travel_per_radian;
    this.draw();
  }

  /** A point is found; with the last come remarks about all of them. */
  add(direction, { point, left, remarks }) {
    this.branches[direction].add({ ...point, direction }, left, remarks);
    this.draw();
  }

  /** No more points come. */
  stop(same) {
    this.#stopped = Object.values(this.branches).some(({ left }) => left > 0);
    for (const branch of Object.values(this.branches)) branch.stop(same);
    this.draw();
  }

  /** Only these directions are computed; nothing of the others is shown. */
  only(directions) {
    for (const name of Object.keys(this.branches)) if (!directions.includes(name)) this.branches[name] = new Branch();
  }

  /** Another drive: nothing of the one before is shown. */
  forget() {
    this.branches = { up: new Branch(), back: new Branch() };
    this.#stopped = false;
    this.draw();
  }

  /** Draws with the next picture. */
  draw() {
    if (this.#scheduled) return;
    this.#scheduled = true;
    requestAnimationFrame(() => {
      this.#scheduled = false;
      this.#draw();
    });
  }

  #draw() {
    const onRoad = this.#road !== null;
    this.over.label = onRoad ? "road speed (km/h)" : "speed of the secondary (rpm)";
    this.over.unit = onRoad ? " km/h" : " rpm";
    const scene = {
      branches: this.branches,
      over: (speed) => speed * (onRoad ? this.#road * KMH : RPM),
    };
    for (const chart of [this.main, ...this.charts]) chart.show(scene);
    this.#progress();
  }

  #progress() {
    const { progress, state } = this.parts;
    const all = Object.values(this.branches);
    const done = all.reduce((sum, branch) => sum + branch.points.length, 0);
    const left = all.reduce((sum, branch) => sum + branch.left, 0);
    progress.hidden = left === 0;
    progress.max = Math.max(1, done + left);
    progress.value = done;
    state.textContent =
      left > 0 ? `${done} of ${done + left} points` : this.#stopped ? `stopped at ${done} points` : "";
  }

  /** The ends of the phases, with the names of those of the first curve. */
  #places({ over }) {
    return Object.entries(this.branches).flatMap(([name, branch]) =>
      Object.entries(branch.shown().length > 0 ? branch.landmarks : {})
        .filter(([, place]) => place)
        .map(([kind, place]) => ({
          name,
          x: over(place.secondary_speed),
          y: place.primary_speed * RPM,
          text: name === "up" ? SHORT[kind] : "",
          // Clear of the curve, and of each other.
          side: kind === "shift_out" ? "start" : "end",
        })),
    );
  }

  /** Once all is computed: the landmarks, the table, and what is missing. */
  settle() {
    const road = (speed) => (speed === null || this.#road === null ? "" : number(speed * this.#road * KMH, 3));
    const header = ["", "engine (rpm)", "secondary (rpm)", "road (km/h)", "ratio"];
    const cells = ([text, engine, secondary, ratio]) => [
      text,
      number(engine * RPM),
      secondary === null ? "" : number(secondary * RPM),
      road(secondary),
      ratio === null ? "" : number(ratio, 3),
    ];
    const groups = Object.entries(this.branches).map(([name, branch]) => {
      const rows = branch.engagement ? [["flyweights overcome their spring", branch.engagement, null, null]] : [];
      for (const [kind, text] of Object.entries(PLACES)) {
        const place = branch.landmarks[kind];
        if (place) rows.push([text, place.primary_speed, place.secondary_speed, place.ratio]);
      }
      return [WAYS[name], rows.map(cells)];
    });
    this.parts.landmarks.replaceChildren(...grouped(header, groups));
    const all = this.points.map((point) =>
      COLUMNS.map(([key, , text]) =>
        point.failure && !["direction", "secondary_speed"].includes(key) ? "–" : text(point),
      ),
    );
    this.parts.table.replaceChildren(
      ...table(
        COLUMNS.map(([, name]) => name),
        all,
      ),
    );
  }

  /** All points, direction by direction. */
  get points() {
    return Object.values(this.branches).flatMap((branch) => branch.points);
  }

  /** What there is to say of the curves, of each by itself where there are two. */
  get remarks() {
    const shown = Object.entries(this.branches).filter(([, branch]) => branch.points.length > 0);
    const of = (name) => (shown.length > 1 ? `${WAYS[name][0].toUpperCase()}${WAYS[name].slice(1)}: ` : "");
    return shown.flatMap(([name, branch]) => branch.remarks.map((text) => `${of(name)}${text}`));
  }

  /** Why something is missing. */
  get missing() {
    const failed = this.points.filter((point) => point.failure);
    const missing = Object.values(this.branches).flatMap((branch) => branch.missing);
    return [...new Set([...missing, ...failed.map((point) => point.failure)])];
  }

  /** One line: how well the engine is held while the drive shifts up. */
  get glance() {
    const shifting = this.branches.up.points.filter((point) => point.phase === "shift");
    if (shifting.length === 0) return "";
    const speeds = shifting.map((point) => point.primary_speed * RPM);
    const reserve = Math.min(...this.points.filter((point) => !point.failure).map((point) => point.slip_reserve));
    const [low, high] = [Math.min(...speeds), Math.max(...speeds)];
    const left = `${fixed(percent(reserve), 1)} % of the friction is left at the least`;
    return `The engine runs at ${number(low)} to ${number(high)} rpm while the drive shifts up; ${left}.`;
  }

  /** The engine's mean speed while the drive shifts up, rad/s. */
  get speed() {
    const shifting = this.branches.up.points.filter((point) => point.phase === "shift");
    return shifting.reduce((sum, point) => sum + point.primary_speed, 0) / shifting.length;
  }

  /** Whether the belt slips somewhere on the curves. */
  get slips() {
    return this.points.some((point) => point.slipping);
  }

  /** All points in SI units. */
  get csv() {
    const keys = [...new Set(["direction", "secondary_speed", ...this.points.flatMap(Object.keys)])];
    const rows = this.points.map((point) => keys.map((key) => field(point[key])).join(","));
    return `${keys.join(",")}\n${rows.map((row) => `${row}\n`).join("")}`;
  }

  /** The same, with the landmarks. */
  get told() {
    if (this.points.length === 0) return null;
    const told = ([direction, { landmarks, engagement, points, missing }]) => ({
      direction,
      engagement_speed: engagement,
      ...landmarks,
      remarks: missing,
      points,
    });
    return Object.entries(this.branches).map(told);
  }
}

/** The head of a table. */
function head(header) {
  const cells = header.map((text) => html(text ? "th" : "td", { text, scope: text ? "col" : null }));
  return html("thead", {}, html("tr", {}, ...cells));
}

/** Head and body of a table of texts. */
function table(header, rows) {
  const line = (cells) => html("tr", {}, ...cells.map((text) => html("td", { text })));
  return [head(header), html("tbody", {}, ...rows.map(line))];
}

/** Head and bodies of a table of texts in groups, each with a name; the first text of a row is the row's name. */
function grouped(header, groups) {
  const line = ([name, ...cells]) =>
    html("tr", {}, html("th", { scope: "row", text: name }), ...cells.map((text) => html("td", { text })));
  const body = ([name, rows]) =>
    html(
      "tbody",
      {},
      html("tr", {}, html("th", { scope: "rowgroup", colspan: header.length, text: name })),
      ...rows.map(line),
    );
  return [head(header), ...groups.filter(([, rows]) => rows.length > 0).map(body)];
}
