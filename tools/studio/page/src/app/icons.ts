// SPDX-License-Identifier: Apache-2.0
// Signs on buttons as drawings, so that they look the same whatever fonts there are.
const PATHS = {
  play: "M6 4l10 6-10 6z",
  pause: "M6 4h3v12H6zM11 4h3v12h-3z",
  first: "M4 4h2v12H4zM16 4v12l-9-6z",
  last: "M14 4h2v12h-2zM4 4v12l9-6z",
  back: "M10 4v12l-8-6zM18 4v12l-8-6z",
  on: "M2 4v12l8-6zM10 4v12l8-6z",
  frameBack: "M13 5v10l-8-5z",
  frameOn: "M7 5v10l8-5z",
  theme: "M10 2a8 8 0 1 0 0 16zM10 3.5a6.5 6.5 0 0 1 0 13z",
} as const;
export type Icon = keyof typeof PATHS;

export function icon(name: Icon): SVGSVGElement {
  const space = "http://www.w3.org/2000/svg";
  const svg = document.createElementNS(space, "svg");
  svg.setAttribute("viewBox", "0 0 20 20");
  svg.setAttribute("class", "icon");
  svg.setAttribute("aria-hidden", "true");
  const path = document.createElementNS(space, "path");
  path.setAttribute("d", PATHS[name]);
  path.setAttribute("fill", "currentColor");
  svg.append(path);
  return svg;
}
