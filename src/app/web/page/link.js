// A scene in a link: its name if it is built in, otherwise its text, compressed, in the URL's fragment. Servers never see that.

const streamed = (bytes, stream) => new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer();

// `size`: of the picture, if it is not the page's own.
export async function sceneInLink(text, builtIn, step, size) {
    const link = new URLSearchParams(), same = builtIn.find((scene) => scene.text === text);
    if (same) {
        link.set("scene", same.name);
    } else {
        const bytes = new Uint8Array(await streamed(text, new CompressionStream("deflate-raw")));
        const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
        link.set("text", btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", ""));
    }
    if (step) link.set("step", step);
    if (size) link.set("size", `${size.width}x${size.height}`);
    return link.toString();
}

// undefined if the link has none.
export function sizeInLink(link) {
    const found = /^([1-9]\d{0,3})x([1-9]\d{0,3})$/.exec(link.get("size"));
    return found ? {width: Number(found[1]), height: Number(found[2])} : undefined;
}

// Throws for what is no such text.
export async function textInLink(compressed) {
    const letters = atob(compressed.replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = await streamed(Uint8Array.from(letters, (letter) => letter.charCodeAt(0)), new DecompressionStream("deflate-raw"));
    return new TextDecoder("utf-8", {fatal: true}).decode(bytes);
}
