// scene-pictures.mjs PROGRAM: prints the list of scenes for the page as JSON: by headings, as PROGRAM (twinlight) lists them, each scene with a
// small picture by its shaders.
import {execFile} from "node:child_process";
import os from "node:os";
import {promisify} from "node:util";

const [program] = process.argv.slice(2);
const run = promisify(execFile), SIZE = "160x120";

const {scenes} = JSON.parse((await run(program, ["scenes", "--json"])).stdout);
const groups = [];
for (const {heading, name} of scenes) {
    if (groups.at(-1)?.heading !== heading) groups.push({heading, scenes: []});
    groups.at(-1).scenes.push(name);
}

const pictures = {}, left = scenes.values();
await Promise.all(os.cpus().map(async () => {
    for (const {name} of left) {
        const {stdout} = await run(program, ["render", name, "--with", "shaders", "--size", SIZE, "-o", "-"], {encoding: "buffer", maxBuffer: 1 << 24});
        pictures[name] = `data:image/png;base64,${stdout.toString("base64")}`;
    }
}));
console.log(JSON.stringify({groups, pictures}));
