// mesa-pictures.mjs PROGRAM FOLDER: draws the built-in scenes and their steps with the fixed function of PROGRAM (twinlight), as
// FOLDER/NAME.png or FOLDER/NAME-STEP.png. Prints a JSON list of these names.
import {execFile} from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import {promisify} from "node:util";

const [program, folder] = process.argv.slice(2);
const run = promisify(execFile);

const {scenes} = JSON.parse((await run(program, ["scenes", "--json"])).stdout);
const pictures = scenes.flatMap(({name, steps}) => steps.length === 0 ?
    [{name, given: [name]}] : steps.map((_, i) => ({name: `${name}-${i + 1}`, given: [name, "--step", String(i + 1)]})));

fs.rmSync(folder, {recursive: true, force: true});
fs.mkdirSync(folder, {recursive: true});
const left = pictures.values();
await Promise.all(os.cpus().map(async () => {
    for (const {name, given} of left) await run(program, ["render", ...given, "--with", "fixed", "-o", `${folder}/${name}.png`]);
}));
console.log(JSON.stringify(pictures.map(({name}) => name)));
