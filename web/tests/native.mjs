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
    close: () => child.kill(),
  };
}

/** Where two results differ by more than `tolerance`, relative to the number or to 1e-3 of its SI unit; the largest first. */
export function differences(a, b, tolerance) {
  const found = [];
  let largest = 0;
  const walk = (x, y, path) => {
    if (path.endsWith("wall_time") || path.startsWith(".solver.m")) return;
    if (typeof x === "number" && typeof y === "number") {
      const difference = Math.abs(x - y) / Math.max(Math.abs(x), Math.abs(y), 1e-3);
      largest = Math.max(largest, difference);
      if (!(difference <= tolerance)) found.push([difference, `${path}: ${x} and ${y}`]);
    } else if (x !== null && y !== null && typeof x === "object" && typeof y === "object") {
      for (const key of new Set([...Object.keys(x), ...Object.keys(y)])) walk(x[key], y[key], `${path}.${key}`);
    } else if (x !== y) {
      found.push([Infinity, `${path}: ${x} and ${y}`]);
    }
  };
  walk(a, b, "");
  found.sort(([p], [q]) => q - p);
  return { largest, found: found.map(([, text]) => text) };
}
