// A scene in a link: its name if it is built in, otherwise its text, compressed, in the URL's fragment. Servers never see that.

const streamed = (bytes, stream) => new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer();

export async function sceneInLink(text, builtIn, step) {
    const link = new URLSearchParams(), same = builtIn.find((scene) => scene.text === text);
    if (same) {
        link.set("scene", same.name);
    } else {
        const bytes = new Uint8Array(await streamed(text, new CompressionStream("deflate-raw")));
        const letters = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
        link.set("text", btoa(letters).replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", ""));
    }
    if (step) link.set("step", step);
    return link.toString();
}

// Throws for what is no such text.
export async function textInLink(compressed) {
    const letters = atob(compressed.replaceAll("-", "+").replaceAll("_", "/"));
    const bytes = await streamed(Uint8Array.from(letters, (letter) => letter.charCodeAt(0)), new DecompressionStream("deflate-raw"));
    return new TextDecoder("utf-8", {fatal: true}).decode(bytes);
}
