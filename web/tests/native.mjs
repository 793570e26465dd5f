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

/**
 * How far two results differ, with how they were found: relative to each number, whatever its size, for both programs
 * compute with the same operations in the same order and should have the same bits. How long it took is no result.
 */
export function differences(a, b) {
  const found = { largest: 0, at: "" };
  const walk = (x, y, path) => {
    if (path === ".solver.wall_time") return;
    if (typeof x === "number" && typeof y === "number") {
      const difference = x === y ? 0 : Math.abs(x - y) / Math.max(Math.abs(x), Math.abs(y));
      if (!(difference <= found.largest)) Object.assign(found, { largest: difference, at: `${path}: ${x} and ${y}` });
    } else if (x !== null && y !== null && typeof x === "object" && typeof y === "object") {
      for (const key of new Set([...Object.keys(x), ...Object.keys(y)])) walk(x[key], y[key], `${path}.${key}`);
    } else if (x !== y) {
      Object.assign(found, { largest: Infinity, at: `${path}: ${x} and ${y}` });
    }
  };
  walk(a, b, "");
  return found;
}
