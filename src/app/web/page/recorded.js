// Mesa's pictures, recorded by tools/mesa-pictures.mjs. The page itself draws nearly the same picture, the reference with floats, so a
// record has only the difference, compressed: for each channel and pixel, modulo 256; then a checksum of Mesa's picture.

const CHANNELS = 3;
const streamed = async (bytes, stream) => new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());

// FNV-1a of the colours.
function checksum(pixels) {
    let sum = 0x811c9dc5;
    for (let i = 0; i < pixels.length; ++i) if (i % 4 < CHANNELS) sum = Math.imul(sum ^ pixels[i], 0x01000193);
    return sum >>> 0;
}

// Pictures are bytes: red, green, blue, alpha.
export async function recordOf(picture, floats) {
    const count = picture.length / 4, bytes = new Uint8Array(CHANNELS * count + 4);
    for (let i = 0; i < CHANNELS * count; ++i) {
        const from = 4 * (i % count) + Math.floor(i / count);
        bytes[i] = picture[from] - floats[from];
    }
    new DataView(bytes.buffer).setUint32(CHANNELS * count, checksum(picture));
    return streamed(bytes, new CompressionStream("deflate-raw"));
}

// Null if these are not the floats of recordOf, as after a change of a picture that the scene loads.
export async function pictureIn(record, floats) {
    const bytes = await streamed(record, new DecompressionStream("deflate-raw")), count = floats.length / 4;
    const picture = new Uint8ClampedArray(floats.length).fill(255);
    for (let i = 0; i < CHANNELS * count; ++i) {
        const at = 4 * (i % count) + Math.floor(i / count);
        picture[at] = (bytes[i] + floats[at]) & 255;
    }
    const is_right = bytes.length === CHANNELS * count + 4 && new DataView(bytes.buffer).getUint32(CHANNELS * count) === checksum(picture);
    return is_right ? picture : null;
}
