// PNG pictures of 8 bits a channel, RGB or RGBA, as [red, green, blue] by pixel.
import { inflateSync } from "node:zlib";

export function readPng(bytes) {
  const parts = [];
  let width = 0, height = 0, channels = 0;
  for (let at = 8; at < bytes.length; ) {
    const length = bytes.readUInt32BE(at), kind = bytes.toString("latin1", at + 4, at + 8);
    const data = bytes.subarray(at + 8, at + 8 + length);
    if (kind === "IHDR") {
      width = data.readUInt32BE(0);
      height = data.readUInt32BE(4);
      channels = { 2: 3, 6: 4 }[data[9]];
      if (data[8] !== 8 || !channels || data[12] !== 0) throw new Error("a PNG of another kind");
    }
    if (kind === "IDAT") parts.push(data);
    at += 12 + length;
  }
  const raw = inflateSync(Buffer.concat(parts)), line = width * channels;
  const pixels = new Uint8Array(line * height);
  const paeth = (a, b, c) => {
    const p = a + b - c, da = Math.abs(p - a), db = Math.abs(p - b), dc = Math.abs(p - c);
    return da <= db && da <= dc ? a : db <= dc ? b : c;
  };
  for (let y = 0; y < height; ++y) {
    const filter = raw[y * (line + 1)];
    for (let x = 0; x < line; ++x) {
      const left = x >= channels ? pixels[y * line + x - channels] : 0, up = y > 0 ? pixels[(y - 1) * line + x] : 0;
      const corner = x >= channels && y > 0 ? pixels[(y - 1) * line + x - channels] : 0;
      const by = [0, left, up, (left + up) >> 1, paeth(left, up, corner)][filter];
      pixels[y * line + x] = raw[y * (line + 1) + 1 + x] + by;
    }
  }
  return { width, height, channels, pixels };
}

// The share of pixels of which a channel is off by more than `by`; of those that are left of the last `without` columns.
export function shareOff(a, b, by, without = 0) {
  if (a.width !== b.width || a.height !== b.height) throw new Error(`${a.width}x${a.height} beside ${b.width}x${b.height}`);
  let off = 0;
  for (let i = 0; i < a.width * a.height; ++i) {
    if (i % a.width >= a.width - without) continue;
    const far = [0, 1, 2].some((k) => Math.abs(a.pixels[i * a.channels + k] - b.pixels[i * b.channels + k]) > by);
    if (far) ++off;
  }
  return off / ((a.width - without) * a.height);
}
