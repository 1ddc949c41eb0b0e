// mesa-pictures.mjs PROGRAM PAGE: draws the built-in scenes and their steps with the fixed function of PROGRAM (twinlight), and writes them
// as PAGE/mesa/NAME or PAGE/mesa/NAME-STEP, in the form of recorded.js. Prints a JSON list of these names.
import {execFile} from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import path from "node:path";
import {pathToFileURL} from "node:url";
import {promisify} from "node:util";
import {pixelsOfPng} from "./png.mjs";

const [program, page] = process.argv.slice(2);
const run = promisify(execFile), SIZE = {width: 640, height: 480};
const imported = (name) => import(pathToFileURL(path.resolve(page, name)).href);
const [{loadTwinlight}, {recordOf}] = await Promise.all(["twinlight.js", "recorded.js"].map(imported));
const twinlight = await loadTwinlight({wasmBinary: fs.readFileSync(`${page}/module.wasm`)});

const {scenes} = JSON.parse((await run(program, ["scenes", "--json"])).stdout);
const pictures = scenes.flatMap(({name, steps}) => steps.length === 0 ?
    [{name, scene: name, step: ""}] : steps.map((_, i) => ({name: `${name}-${i + 1}`, scene: name, step: String(i + 1)})));
const texts = new Map(twinlight.builtIn().map(({name, text}) => [name, text]));

// As the page draws it, byte for byte.
function floatsOf({scene, step}) {
    const {errors} = twinlight.open({text: texts.get(scene), name: scene, step, ...SIZE});
    if (errors.length > 0) throw new Error(`${scene}: ${errors[0].message}`);
    return twinlight.referenceRows({shading: "scene", asFloats: true, y0: 0, y1: SIZE.height, width: SIZE.width}).rows;
}

fs.rmSync(`${page}/mesa`, {recursive: true, force: true});
fs.mkdirSync(`${page}/mesa`, {recursive: true});
const left = pictures.values();
await Promise.all(os.cpus().map(async () => {
    for (const one of left) {
        const given = [one.scene, ...(one.step ? ["--step", one.step] : []), "--with", "fixed", "-o", "-"];
        const {stdout} = await run(program, ["render", ...given], {encoding: "buffer", maxBuffer: 1 << 24});
        fs.writeFileSync(`${page}/mesa/${one.name}`, await recordOf(pixelsOfPng(stdout), floatsOf(one)));
    }
}));
console.log(JSON.stringify(pictures.map(({name}) => name)));
