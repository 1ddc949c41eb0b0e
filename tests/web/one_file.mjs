// one_file.mjs PAGE KIND PROGRAM: opens the page of one file, and the folder's page, by file:, in a browser. KIND: chromium or firefox.
// Prints a JSON object of what they did.
import fs from "node:fs";
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

    await opened("#tutor=light");
    await browser.value(`(delete document.body.dataset.drawn, (([number]) => (number.value = 3, number.dispatchEvent(new Event("input"))))(document.querySelectorAll("#calls input")), 0)`);
    await until("document.body.dataset.drawn");
    told.tutor = [await browser.value(`document.querySelectorAll("#calls div").length`), (await sceneText()).includes("GL_POSITION, (GLfloat[]){3, 2, 2.2, 1}")];

    // A program and a scene with its picture, dropped.
    const dropped = async (files) => {
        await browser.value(`(() => {
            delete document.body.dataset.drawn;
            const transfer = new DataTransfer();
            for (const [name, bytes] of ${JSON.stringify(files)})
                transfer.items.add(new File([Uint8Array.from(atob(bytes), (letter) => letter.charCodeAt(0))], name));
            dispatchEvent(new DragEvent("drop", {dataTransfer: transfer, cancelable: true}));
        })()`);
        await until("document.body.dataset.drawn");
        return [await text("messages"), await browser.value(`[...document.getElementById("reference").getContext("2d").getImageData(40, 30, 1, 1).data]`)];
    };
    told.dropped = [await dropped([["main.c", btoa(`#include <GL/glut.h>
void display(void) { glColor3f(0, 1, 0); glRectf(-1, -1, 1, 1); glutSwapBuffers(); }
int main(int argc, char** argv) { glutInit(&argc, argv); glutInitWindowSize(80, 60); glutCreateWindow("a"); glutDisplayFunc(display); glutMainLoop(); }
`)]])];
    told.dropped.push(await dropped([
        ["mine.gl", btoa(`glEnable(GL_TEXTURE_2D);\n#pragma twinlight texture("mine.png")\nglTexCoord2f(0.5, 0.5);\nglRectf(-1, -1, 1, 1);\n`)],
        ["mine.png", fs.readFileSync("src/scene/scenes/crate.png", "base64")]]));
    told.scene = await sceneText();

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
