// Files that are dropped on the page: a scene, a .trace of apitrace, or its dump with its blobs.

const FRONT_BYTES = 1 << 16;  // trace::kFrontBytes
const MOST_MIB = 256;         // of a recording and its blobs

const bytesOf = async (file) => new Uint8Array(await file.arrayBuffer());

// The scene in these files: {name, text}, and the size of its picture if they say one. Throws an Error for people.
export async function sceneIn(files, twinlight) {
    let recording = null;
    for (const file of files)
        if (twinlight.isRecording(file.name, await bytesOf(file.slice(0, FRONT_BYTES)))) recording ??= file;
    const file = recording ?? files[0], name = file.name.replace(/\.[^.]*$/, "");
    if (!recording) return {name, text: await file.text()};
    const mib = Math.ceil(files.reduce((sum, {size}) => sum + size, 0) / (1 << 20));
    if (mib > MOST_MIB) throw new Error(`${file.name}: this recording has ${mib} MiB; the limit of this page is ${MOST_MIB} MiB. The program twinlight can draw it.`);
    for (const one of files) twinlight.addFile(one.name, await bytesOf(one));
    const {text, width, height} = twinlight.sceneOfRecording(file.name);
    return {name, text, size: {width, height}};
}
