// The pixels of a PNG as twinlight writes it: 8 bits a channel, RGB, not interlaced.
import zlib from "node:zlib";

const CHANNELS = 3;

// The predictor of PNG's filter 4.
function paeth(left, up, corner) {
    const [a, b, c] = [Math.abs(up - corner), Math.abs(left - corner), Math.abs(left + up - 2 * corner)];
    return a <= b && a <= c ? left : b <= c ? up : corner;
}
const PREDICTORS = [() => 0, (left) => left, (left, up) => up, (left, up) => (left + up) >> 1, paeth];

// Red, green, blue and alpha of each pixel.
export function pixelsOfPng(png) {
    const [width, height] = [png.readUInt32BE(16), png.readUInt32BE(20)], packed = [];
    if (png.readUInt32BE(24) !== 0x08020000) throw new Error("this PNG has another form than 8-bit RGB");
    for (let at = 8; at < png.length; at += 12 + png.readUInt32BE(at))
        if (png.toString("latin1", at + 4, at + 8) === "IDAT") packed.push(png.subarray(at + 8, at + 8 + png.readUInt32BE(at)));
    const bytes = zlib.inflateSync(Buffer.concat(packed)), pixels = new Uint8ClampedArray(4 * width * height).fill(255);
    for (let y = 0, from = 0; y < height; ++y) {
        const predict = PREDICTORS[bytes[from++]];
        for (let i = 0; i < CHANNELS * width; ++i) {
            const x = Math.floor(i / CHANNELS), at = 4 * (y * width + x) + i % CHANNELS, up = at - 4 * width;
            const known = (index, isInside) => isInside ? pixels[index] : 0;
            pixels[at] = (bytes[from++] + predict(known(at - 4, x > 0), known(up, y > 0), known(up - 4, x > 0 && y > 0))) & 255;
        }
    }
    return pixels;
}
