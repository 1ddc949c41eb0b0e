// one_file.mjs PAGE KIND PROGRAM: opens the page of one file, and the folder's page, by file:, in a browser. KIND: chromium or firefox.
// Prints a JSON object of what they did.
import path from "node:path";
import {pathToFileURL} from "node:url";
import {Browser} from "./browser.mjs";
import {Firefox} from "./firefox.mjs";

const [page, kind, program] = process.argv.slice(2);
const address = pathToFileURL(path.resolve(page, "../twinlight.html")).href;
const browser = await {chromium: () => Browser.open(program, page), firefox: () => Firefox.open(program)}[kind]();
const EDITOR = `document.querySelector(".CodeMirror").CodeMirror`;
const text = (id) => browser.value(`document.getElementById("${id}").textContent`);
const sceneText = () => browser.value(`${EDITOR}.getValue()`);
const told = {};

async function until(expression, seconds = 60) {
    for (const end = Date.now() + 1000 * seconds; !(await browser.value(`Boolean(${expression})`));) {
        if (Date.now() > end) throw new Error(`never true: ${expression}; the page says: ${await text("verdict")} ${await text("messages")}`);
        await new Promise((resolve) => setTimeout(resolve, 20));
    }
}
// Opens a new page, not only another fragment.
async function opened(hash) {
    await browser.visit("about:blank");
    await browser.visit(address + hash);
    await until("document.body?.dataset.drawn");
}
async function typed(scene) {
    await browser.value(`(delete document.body.dataset.drawn, ${EDITOR}.setValue(${JSON.stringify(scene)}), 0)`);
    await until("document.body.dataset.drawn");
}

try {
    await opened("#scene=terms&step=3");
    told.verdict = await text("verdict");
    told.mesa = await browser.value(`(() => {
        const {data} = document.getElementById("mesa").getContext("2d").getImageData(0, 0, 640, 480), parts = [];
        for (let i = 0; i < data.length; i += 8192) parts.push(String.fromCharCode(...data.subarray(i, i + 8192)));
        return btoa(parts.join(""));
    })()`);
    told.messages = await text("messages");

    await opened("#lesson=shininess");
    await typed((await sceneText()).replace("GL_SHININESS, 10", "GL_SHININESS, 100"));
    await browser.value(`document.getElementById("check").click()`);
    await until(`document.getElementById("result").className`);
    told.solved = await text("result");

    // A link to a scene of your own.
    await typed("glColor3f(1, 0, 0);\nglRectf(-1, -1, 1, 1);\n");
    await browser.value(`document.getElementById("link").click()`);
    await until(`location.hash.startsWith("#text=")`);
    await opened(await browser.value("location.hash"));
    told.linked = [await sceneText(), await browser.value(`[...document.getElementById("reference").getContext("2d").getImageData(320, 240, 1, 1).data]`)];

    // Blobs of its workers are all that it loads.
    told.loads = await browser.value(`performance.getEntriesByType("resource").map(({name}) => name).filter((name) => !name.startsWith("blob:") && !name.startsWith("data:"))`);
    told.complaints = await browser.said();

    await browser.visit(pathToFileURL(path.resolve(page, "index.html")).href);
    await until(`document.getElementById("verdict")?.querySelector("a")`);
    told.folder = [await text("verdict"), await browser.value(`document.querySelector("#verdict a").href`), address,
        await browser.value(`document.querySelector("main .pictures canvas").checkVisibility()`)];
    console.log(JSON.stringify(told));
} finally {
    await browser.close();
}
