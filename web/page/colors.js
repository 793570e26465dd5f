// Colours that people with any colour vision tell apart: viridis (S. van der Walt, N. Smith, 2015, CC0) for an amount,
// and the palette of M. Okabe and K. Ito (2008) for kinds. Dashes and widths say the same without colour.

const VIRIDIS = [
  [68, 1, 84],
  [72, 40, 120],
  [62, 74, 137],
  [49, 104, 142],
  [38, 130, 142],
  [31, 158, 137],
  [53, 183, 121],
  [109, 205, 89],
  [180, 222, 44],
  [253, 231, 37],
];

/** The colour of a share from 0 to 1, but for the end of the scale that does not show on a bright or a dark ground. */
export function tensionColor(share, dark) {
  const [from, to] = dark ? [0.32, 1] : [0.12, 0.82];
  const place = (from + (to - from) * Math.min(1, Math.max(0, share))) * (VIRIDIS.length - 1);
  const k = Math.min(VIRIDIS.length - 2, Math.floor(place));
  const mixed = VIRIDIS[k].map((value, i) => Math.round(value + (place - k) * (VIRIDIS[k + 1][i] - value)));
  return `rgb(${mixed.join(" ")})`;
}
