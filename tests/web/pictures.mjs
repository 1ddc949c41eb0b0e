// pictures.mjs PAGE JOBS OUT: opens each scene of JOBS with the module in the folder PAGE, and writes OUT/answers.json, what open()
// returned, and OUT/pictures, the reference's pixels one picture after the other. Each is drawn in two bands, as workers draw it.
import fs from "node:fs";
import {pathToFileURL} from "node:url";

const [page, jobs, out] = process.argv.slice(2);
const {loadTwinlight} = await import(pathToFileURL(`${page}/twinlight.js`).href);
const twinlight = await loadTwinlight({wasmBinary: fs.readFileSync(`${page}/module.wasm`)});
const answers = [], pictures = [];
for (const job of JSON.parse(fs.readFileSync(jobs))) {
    const answer = twinlight.open(job);
    answers.push(answer);
    if (answer.errors.length > 0) continue;
    const {width, height} = answer, middle = height >> 1;
    for (const look of job.looks)
        for (const [y0, y1] of [[0, middle], [middle, height]])
            pictures.push(twinlight.referenceRows({...look, y0, y1, width}).rows);
}
fs.writeFileSync(`${out}/answers.json`, JSON.stringify(answers));
fs.writeFileSync(`${out}/pictures`, Buffer.concat(pictures));
