// The same questions, answered natively: `sheave live`, built by `cargo build --features live`.
import { spawn } from "node:child_process";
import { once } from "node:events";
import { createInterface } from "node:readline";

const program = process.env.SHEAVE ?? new URL("../../target/debug/sheave", import.meta.url).pathname;

export async function native() {
  const child = spawn(program, ["live", "--port", "0"], { stdio: ["ignore", "pipe", "inherit"] });
  const [line] = await Promise.race([
    once(createInterface(child.stdout), "line"),
    once(child, "error").then(([error]) => Promise.reject(error)),
    once(child, "exit").then(([code]) => Promise.reject(new Error(`${program} live ended with status ${code}`))),
  ]);
  const url = /http:\S+/.exec(line)[0];
  return {
    url,
    async ask(question, name = "test") {
      const headers = { "content-type": "application/json" };
      const response = await fetch(new URL(`ask/${name}`, url), {
        method: "POST",
        headers,
        body: JSON.stringify(question),
      });
      if (!response.ok) throw new Error(`${response.status}: ${await response.text()}`);
      return response.json();
    },
    pid: child.pid,
    close: () => child.kill(),
  };
}

/** Read off samples between which a mesh may lie: as accurate as the solution, not as the arithmetic. */
const SAMPLED = /sliding_speed|max_penetration|adhesion_fraction|utilization|slip_reserve|m(in|ax)_tension/;

/**
 * How far two results differ: what is solved for and what is integrated, and what is read off samples. Differences are
 * relative to the number; those of angles, whose zero is a convention, to a radian; those of tensions to the largest, those of torques and powers to what it alone would give, for they are
 * differences of two tensions; those of shares to 1, of places to 0.1 m.
 */
export function differences(a, b) {
  const found = { solved: { largest: 0, at: "" }, sampled: { largest: 0, at: "" } };
  const { primary, secondary } = a;
  const tension = Math.max(...[primary, secondary].flatMap((pulley) => [pulley.entry_tension, pulley.exit_tension]));
  const torque = tension * Math.max(primary.radius, secondary.radius);
  const power = tension * primary.radius * primary.speed;
  const share = Math.max(1, power / Math.max(Math.abs(a.energy.power_in), 1e-9));
  const scale = (path, size) => {
    if (/imbalance|closure|^\.efficiency/.test(path)) return share;
    if (/fraction$|utilization|reserve/.test(path)) return 1;
    if (/^\.(energy|losses|thermal)|friction_loss|power/.test(path)) return Math.max(size, power);
    if (/angle$/.test(path)) return Math.max(size, 1);
    if (/torque$/.test(path)) return Math.max(size, torque);
    if (/tension$/.test(path)) return Math.max(size, tension);
    if (/resultant|length_error/.test(path)) return 0.1;
    if (/min_sliding_speed/.test(path)) return Math.max(size, primary.max_sliding_speed, secondary.max_sliding_speed);
    return Math.max(size, 1e-3);
  };
  const walk = (x, y, path) => {
    // How it was solved is not what was solved.
    if (path.startsWith(".solver")) return;
    if (typeof x === "number" && typeof y === "number") {
      const kind = found[SAMPLED.test(path) ? "sampled" : "solved"];
      const difference = Math.abs(x - y) / scale(path, Math.max(Math.abs(x), Math.abs(y)));
      if (!(difference <= kind.largest)) Object.assign(kind, { largest: difference, at: `${path}: ${x} and ${y}` });
    } else if (x !== null && y !== null && typeof x === "object" && typeof y === "object") {
      for (const key of new Set([...Object.keys(x), ...Object.keys(y)])) walk(x[key], y[key], `${path}.${key}`);
    } else if (x !== y) {
      Object.assign(found.solved, { largest: Infinity, at: `${path}: ${x} and ${y}` });
    }
  };
  walk(a, b, "");
  return found;
}

/** Whether both were found on the same path: the smallest difference may change a step of a long search, and with it the meshes. */
export function sameWay(a, b) {
  const { newton_iterations: p, continuation_steps: q } = a.solver;
  return p === b.solver.newton_iterations && q === b.solver.continuation_steps;
}
