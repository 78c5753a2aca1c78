// SPDX-License-Identifier: Apache-2.0
// Camera images of a log as pixels: raw planes of Y, Cr and Cb, JPEG pictures, or the packed colour
// classes (robot/core/types/PlaneFrame.h says the code). Broken ones are left as they are so far.
import names from "kelpie:names";
import { bytesAt } from "../reading/access";
import type { Structure } from "../reading/decoder";

export const WIDTH = names.numbers["kImageWidth"]!;
export const HEIGHT = names.numbers["kImageHeight"]!;
const PIXELS = WIDTH * HEIGHT;

export type PictureKind = "image" | "picture" | "classes";

export function pictureKind(input: Structure): PictureKind | undefined {
  if ((bytesAt(input, "image.y")?.length ?? 0) === PIXELS) return "image";
  if ((bytesAt(input, "jpeg")?.length ?? 0) > 0) return "picture";
  if ((bytesAt(input, "plane")?.length ?? 0) > 0) return "classes";
  return undefined;
}

export function fromYCrCb(
  y: Uint8Array,
  cr: Uint8Array,
  cb: Uint8Array,
  out: Uint8ClampedArray,
): void {
  for (let i = 0; i < PIXELS; ++i) {
    const light = y[i]!;
    const red = cr[i]! - 128;
    const blue = cb[i]! - 128;
    out[4 * i] = light + 1.402 * red;
    out[4 * i + 1] = light - 0.714 * red - 0.344 * blue;
    out[4 * i + 2] = light + 1.772 * blue;
    out[4 * i + 3] = 255;
  }
}

const SHORTEST_LONG_RUN = 16;

export function fromClasses(code: Uint8Array, out: Uint8ClampedArray): void {
  let done = 0;
  for (let at = 0; at < code.length; ++at) {
    const colour = names.palette[code[at]! >> 4] ?? [0, 0, 0];
    let pixels = (code[at]! & 15) + 1;
    if (pixels === SHORTEST_LONG_RUN) pixels += code[++at] ?? 0;
    for (const end = Math.min(PIXELS, done + pixels); done < end; ++done)
      out.set([colour[0]!, colour[1]!, colour[2]!, 255], 4 * done);
  }
}

// Something that can be drawn on a canvas.
export async function pictureOf(input: Structure): Promise<CanvasImageSource | undefined> {
  const kind = pictureKind(input);
  if (kind === undefined) return undefined;
  if (kind === "picture") {
    const bytes = bytesAt(input, "jpeg")!.slice();
    return createImageBitmap(new Blob([bytes], { type: "image/jpeg" })).catch(() => undefined);
  }
  const canvas = document.createElement("canvas");
  canvas.width = WIDTH;
  canvas.height = HEIGHT;
  const context = canvas.getContext("2d")!;
  const pixels = context.createImageData(WIDTH, HEIGHT);
  if (kind === "classes") fromClasses(bytesAt(input, "plane")!, pixels.data);
  else
    fromYCrCb(
      bytesAt(input, "image.y")!,
      bytesAt(input, "image.cr")!,
      bytesAt(input, "image.cb")!,
      pixels.data,
    );
  context.putImageData(pixels, 0, 0);
  return canvas;
}
