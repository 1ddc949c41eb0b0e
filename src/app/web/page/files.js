// Files that are dropped on the page: a scene, or a dump by apitrace with its blobs.

const FRONT_BYTES = 1 << 16;  // trace::kFrontBytes
const MOST_MIB = 256;         // of a dump and its blobs

const bytesOf = async (file) => new Uint8Array(await file.arrayBuffer());

// The scene in these files: {name, text}, and the size of its picture if they say one. Throws an Error for people.
export async function sceneIn(files, twinlight) {
    let dump = null;
    for (const file of files)
        if (twinlight.isDump(file.name, await bytesOf(file.slice(0, FRONT_BYTES)))) dump ??= file;
    const file = dump ?? files[0], name = file.name.replace(/\.[^.]*$/, "");
    if (!dump) return {name, text: await file.text()};
    const mib = Math.ceil(files.reduce((sum, {size}) => sum + size, 0) / (1 << 20));
    if (mib > MOST_MIB) throw new Error(`${file.name}: this dump and its blobs have ${mib} MiB; the limit of this page is ${MOST_MIB} MiB. The program twinlight can draw it.`);
    for (const one of files) twinlight.addFile(one.name, await bytesOf(one));
    const {text, width, height} = twinlight.sceneOfDump(file.name);
    return {name, text, size: {width, height}};
}
