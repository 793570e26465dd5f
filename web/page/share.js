// The case in the URL and in files.

/** Longest case that is read from a URL or a file, characters. */
export const LONGEST = 200_000;

/** What a fragment begins with where it is for the belt, and for the whole drive. */
const VIEWS = { belt: "#case=", drive: "#shift=" };

/**
 * The case in a URL's fragment with what to look at, the base case where there is none; what is `damaged` of a fragment
 * that should be a case; null where it is a place of the page.
 */
export function fromFragment(fragment) {
  if (fragment === "" || fragment === "#") return { text: "", look: "belt" };
  const [look, start] = Object.entries(VIEWS).find(([, start]) => fragment.startsWith(start)) ?? ["belt", null];
  if (start === null) return fragment.includes("=") ? { look, damaged: "The address is no link to a case." } : null;
  try {
    const text = decodeURIComponent(fragment.slice(start.length));
    return text.length <= LONGEST ? { text, look } : { look, damaged: "The link is too long for a case." };
  } catch {
    return { look, damaged: "The link is damaged: its case cannot be read." };
  }
}

/** The fragment of a case; empty for the belt of the base case. */
export function toFragment(text, look) {
  return text === "" && look === "belt" ? "" : `${VIEWS[look]}${encodeURIComponent(text)}`;
}

/** Hands a text to the browser as a file. */
export function download(name, type, text) {
  const url = URL.createObjectURL(new Blob([text], { type }));
  const link = document.createElement("a");
  link.href = url;
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(url), 10_000);
}

const SHAPE = ["fill", "stroke", "stroke-width", "stroke-dasharray", "stroke-linecap", "stroke-linejoin", "opacity"];
const TEXT = ["fill", "font-family", "font-size", "font-weight", "text-anchor"];
const GROUP = ["opacity"];
const STYLED = { path: SHAPE, circle: SHAPE, text: TEXT, g: GROUP };

/** A drawing as a file of its own, its unit of length `unit`: what the page's style sheet says is written into it. */
export function standalone(drawing, unit) {
  const copy = drawing.cloneNode(true);
  const inline = (from, to) => {
    const style = getComputedStyle(from);
    for (const name of STYLED[from.tagName] ?? []) {
      const value = style.getPropertyValue(name);
      if (value !== "none" || name === "fill") to.setAttribute(name, value);
    }
    to.removeAttribute("class");
    Array.from(from.children).forEach((child, i) => inline(child, to.children[i]));
  };
  inline(drawing, copy);
  copy.removeAttribute("style");
  const [x, y, width, height] = copy.getAttribute("viewBox").split(" ");
  copy.setAttribute("width", `${width}${unit}`);
  copy.setAttribute("height", `${height}${unit}`);
  const ground = document.createElementNS("http://www.w3.org/2000/svg", "rect");
  const color = getComputedStyle(document.body).backgroundColor;
  for (const [name, value] of Object.entries({ x, y, width, height, fill: color })) ground.setAttribute(name, value);
  copy.prepend(ground);
  return `<?xml version="1.0" encoding="UTF-8"?>\n${new XMLSerializer().serializeToString(copy)}\n`;
}
