// scene-pictures.mjs PROGRAM LECTURE: prints the list of scenes for the page as JSON: by the headings of LECTURE (docs/lecture.md), each scene
// where it first comes, with a small picture by the shaders of PROGRAM (twinlight).
import {execFile} from "node:child_process";
import fs from "node:fs";
import os from "node:os";
import {promisify} from "node:util";

const [program, lecture] = process.argv.slice(2);
const run = promisify(execFile), SIZE = "160x120";

const {scenes} = JSON.parse((await run(program, ["scenes", "--json"])).stdout);
const names = new Set(scenes.map(({name}) => name)), groups = [];
for (const section of fs.readFileSync(lecture, "utf8").split(/^##+ /m).slice(1)) {
    const found = [...section.matchAll(/build\/twinlight\S*(?: [a-z]+)? ([a-z-]+)/g)].map(([, name]) => name).filter((name) => names.delete(name));
    if (found.length > 0) groups.push({heading: section.slice(0, section.indexOf("\n")), scenes: found});
}
groups.push({heading: "More scenes", scenes: [...names]});

const pictures = {}, left = scenes.values();
await Promise.all(os.cpus().map(async () => {
    for (const {name} of left) {
        const {stdout} = await run(program, ["render", name, "--with", "programmable", "--size", SIZE, "-o", "-"], {encoding: "buffer", maxBuffer: 1 << 24});
        pictures[name] = `data:image/png;base64,${stdout.toString("base64")}`;
    }
}));
console.log(JSON.stringify({groups, pictures}));
