// Numbers as people read them.

/** With so many significant digits, no exponent between 1e-4 and 1e6, a true minus sign. */
export function number(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  let text;
  if (size < 1e-3 || size >= 1e6) text = value.toExponential(digits - 1);
  else text = Number(value.toPrecision(digits)).toFixed(Math.max(0, digits - 1 - Math.floor(Math.log10(size))));
  return text.replace("-", "−").replace(/e\+?/, "e").replace(/e−/, "e-");
}

/** With so many decimals. */
export function fixed(value, decimals) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  const text = value.toFixed(decimals);
  return (Number(text) === 0 ? text.replace("-", "") : text).replace("-", "−");
}

/** As it is typed into a field: no digit that is not needed. */
export function plain(value, digits = 6) {
  return Number.isFinite(value) ? String(Number(value.toPrecision(digits))) : "";
}

/** The number that a text is, written as in a case file and without a unit; NaN of any other text. */
export function decimal(text) {
  return /^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(text) ? Number(text) : NaN;
}

/** A step that divides a range into at least `parts`: 1, 2 or 5 times a power of ten. */
export function step(range, parts) {
  const raw = range / parts;
  const ten = 10 ** Math.floor(Math.log10(raw));
  const lead = raw / ten;
  return (lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * ten;
}

/** Round places of an axis. */
export function ticks(from, to, count) {
  // Not apart by more than the last digits of a number, they have nothing round between them.
  if (!(to - from > 1e-12 * Math.max(Math.abs(from), Math.abs(to)))) return [from];
  const size = step(to - from, count);
  const places = [];
  for (let k = Math.ceil(from / size - 1e-9); k * size <= to + 1e-9 * size; k += 1) {
    places.push(Number((k * size).toPrecision(12)));
  }
  return places;
}

/** A round place of an axis whose places are so far apart: all with the same decimals. */
export function tick(value, gap) {
  const decimals = Math.max(0, -Math.floor(Math.log10(gap) + 1e-9));
  return decimals > 5 ? number(value, 3) : fixed(value, decimals);
}

const RAISED = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };

/** A power of ten: 100, 1, 0.1, 10⁻². */
export function powerOfTen(power) {
  if (power >= -1 && power <= 2) return String(10 ** power);
  return `10${[...String(power)].map((digit) => RAISED[digit]).join("")}`;
}

/** Words of a key or an output: `primary_axial_force` as `primary axial force`. */
export function words(name) {
  return name.replaceAll("_", " ");
}
