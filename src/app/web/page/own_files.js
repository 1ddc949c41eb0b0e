// The page's own files: from its host, or from inside the page of one file (tools/pack-page.mjs).

const inside = (name) => document.getElementById("file " + name);

// A Response, as fetch gives it.
export async function file(name) {
    const part = inside(name);
    if (!part) {
        const response = await fetch(name);
        if (!response.ok) throw new Error(`${name}: the server answers ${response.status}`);
        return response;
    }
    const packed = Uint8Array.from(atob(part.textContent), (letter) => letter.charCodeAt(0));
    const bytes = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
    return new Response(bytes, {headers: {"Content-Type": part.dataset.type}});
}

// Returns a function that starts a worker. Inside the page, its script is no module: Chromium loads a module from a blob of a page from
// the disk only now and then.
export async function workersOf(name) {
    if (!inside(name)) return () => new Worker(name, {type: "module"});
    const address = URL.createObjectURL(await (await file(name)).blob());
    return () => new Worker(address);
}
