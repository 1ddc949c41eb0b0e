// Files that are dropped on the page: a scene or a program, with the pictures and meshes that it names; a .trace of apitrace, or its dump
// with its blobs.

const FRONT_BYTES = 1 << 16;  // trace::kFrontBytes
const MOST_MIB = 256;         // of a recording and its blobs
const MOST_KEPT_MIB = 64;     // of pictures and meshes; each worker has them
const BESIDE = /\.(png|obj|mtl)$/i;

const bare = (name) => name.replace(/\.[^.]*$/, "");
const bytesOf = async (file) => new Uint8Array(await file.arrayBuffer());

// A scene that shows a mesh from the front.
function sceneOfMesh(name, text) {
    const low = [Infinity, Infinity, Infinity], high = low.map((value) => -value);
    for (const [, ...position] of text.matchAll(/^\s*v\s+(\S+)\s+(\S+)\s+(\S+)/gm))
        position.map(Number).forEach((value, i) => [low[i], high[i]] = [Math.min(low[i], value), Math.max(high[i], value)]);
    const middle = low.map((value, i) => (value + high[i]) / 2), radius = Math.hypot(...low.map((value, i) => high[i] - value)) / 2;
    if (!(radius > 0 && Number.isFinite(radius))) return `#pragma twinlight mesh("${name}")\n`;
    const number = (value) => String(Number(value.toPrecision(4))), [x, y, z] = middle;
    return `// ${name}
glEnable(GL_DEPTH_TEST);
glClearColor(0.28, 0.31, 0.37, 1);
glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
glMatrixMode(GL_PROJECTION);
gluPerspective(40, 4.0 / 3.0, ${number(radius)}, ${number(5 * radius)});
glMatrixMode(GL_MODELVIEW);
glLightfv(GL_LIGHT0, GL_POSITION, (GLfloat[]){1, 2, 3, 0});
gluLookAt(${[x, y, z + 3 * radius, x, y, z].map(number).join(", ")}, 0, 1, 0);
glEnable(GL_LIGHTING);
glEnable(GL_LIGHT0);
glEnable(GL_NORMALIZE);
#pragma twinlight mesh("${name}")
`;
}

// The scene in these files: {name, text}, and the size of its picture if they say one; text is null if they have no scene. `beside`: the
// files that a scene may name, [name, bytes] each. Throws an Error for people.
export async function sceneIn(files, twinlight) {
    let recording = null;
    for (const file of files)
        if (twinlight.isRecording(file.name, await bytesOf(file.slice(0, FRONT_BYTES)))) recording ??= file;
    const mib = Math.ceil(files.reduce((sum, {size}) => sum + size, 0) / (1 << 20));
    if (recording) {
        if (mib > MOST_MIB)
            throw new Error(`${recording.name}: this recording has ${mib} MiB; the limit of this page is ${MOST_MIB} MiB. The program twinlight can draw it.`);
        for (const one of files) twinlight.addFile(one.name, await bytesOf(one));
        const {text, width, height} = twinlight.sceneOfRecording(recording.name);
        return {name: bare(recording.name), text, size: {width, height}, beside: []};
    }
    const found = files.filter(({name}) => BESIDE.test(name)), scene = files.find(({name}) => !BESIDE.test(name));
    if (found.length > 0 && mib > MOST_KEPT_MIB)
        throw new Error(`${found[0].name}: these files have ${mib} MiB; the limit of this page is ${MOST_KEPT_MIB} MiB. The program twinlight can draw them.`);
    const beside = await Promise.all(found.map(async (file) => [file.name, await bytesOf(file)]));
    if (scene) return {name: bare(scene.name), text: await scene.text(), beside};
    const mesh = found.find(({name}) => /\.obj$/i.test(name));
    return {name: bare((mesh ?? found[0]).name), text: mesh ? sceneOfMesh(mesh.name, await mesh.text()) : null, beside};
}
