// Colours that people with any colour vision tell apart: viridis (S. van der Walt, N. Smith, 2015, CC0) for an amount, and
// the palette of M. Okabe and K. Ito (2008) for kinds. Dashes and widths say the same without colour.

const VIRIDIS = [
  [68, 1, 84], [72, 40, 120], [62, 74, 137], [49, 104, 142], [38, 130, 142], [31, 158, 137], [53, 183, 121], [109, 205, 89],
  [180, 222, 44], [253, 231, 37],
];

/** The colour of a share from 0 to 1; its darkest and brightest ends are left out, so that it shows on any ground. */
export function tensionColor(share) {
  const place = (0.16 + 0.66 * Math.min(1, Math.max(0, share))) * (VIRIDIS.length - 1);
  const k = Math.min(VIRIDIS.length - 2, Math.floor(place));
  const mixed = VIRIDIS[k].map((value, i) => Math.round(value + (place - k) * (VIRIDIS[k + 1][i] - value)));
  return `rgb(${mixed.join(" ")})`;
}
