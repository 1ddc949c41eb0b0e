// node tools/emscripten-cases.mjs FOLDER: runs build/cases.js of a folder of `check --write-cases`, compiled by Emscripten, in Chromium: a new
// page for each case. Prints the lines of the cases.
import fs from "node:fs";
import path from "node:path";
import {Browser} from "../tests/web/browser.mjs";

const SECONDS = 20; // for a case

const folder = process.argv[2];
const names = fs.readFileSync(path.join(folder, "cases.txt"), "utf8").trim().split("\n").map((line) => line.split("\t")[0]);
fs.writeFileSync(path.join(folder, "build/cases.html"), `<!doctype html>
<link rel="icon" href="data:,">
<canvas id="canvas" width="64" height="64"></canvas>
<script>
var lines = [], isOver = false; // seen from outside
const end = (line) => { if (line) lines.push(line); isOver = true; };
var Module = {
    canvas: document.getElementById("canvas"),
    arguments: [decodeURIComponent(location.hash.slice(1))],
    print: (line) => lines.push(line),
    printErr: (line) => { if (line.startsWith("missing function")) end("not run: this GL has no " + line.split(": ")[1]); },
    onAbort: (what) => end("not run: it aborts: " + what),
    onExit: () => end(),
};
window.onerror = (message) => end("not run: " + message);
</script>
<script src="cases.js"></script>
`);

const browser = await Browser.open(process.env.BROWSER_FOR_CASES ?? "chromium", path.join(folder, "build"));
let saysGl = true;
for (const name of names) {
    await browser.visit(`cases.html?${name}#${name}`);
    const last = Date.now() + 1000 * SECONDS;
    while (!(await browser.value(`location.search === "?${name}" && typeof isOver !== "undefined" && isOver`).catch(() => false))) {
        if (Date.now() > last) break;
        await new Promise((resolve) => setTimeout(resolve, 20));
    }
    const lines = await browser.value("lines");
    const gl = lines.find((line) => line.startsWith("GL: "));
    if (gl && saysGl) console.log(gl);
    saysGl &&= !gl;
    const result = lines.find((line) => line.startsWith(name + ": ")) ?? lines.find((line) => line.startsWith("not run: "));
    console.log(result ? (result.startsWith("not run: ") ? `${name}: ${result}` : result) : `${name}: crashed: it ended without a result`);
}
await browser.close();
process.exit(0);
