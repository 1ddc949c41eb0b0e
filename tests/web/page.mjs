// page.mjs CHROMIUM PAGE JOBS: opens the page in Chromium and prints a JSON object: what the page did ("page"), and how the pictures of
// JOBS by its shaders compare with the reference ("pictures").
import fs from "node:fs";
import {Browser} from "./browser.mjs";

const [program, page, jobs] = process.argv.slice(2);
const browser = await Browser.open(program, page);
const text = (id) => browser.value(`document.getElementById("${id}").textContent`);
const EDITOR = `document.querySelector(".CodeMirror").CodeMirror`;
const sceneText = () => browser.value(`${EDITOR}.getValue()`);

// Does this, then waits for the pictures or the errors.
async function drawn(action) {
    await browser.value(`delete document.body.dataset.drawn, document.getElementById("messages").replaceChildren(), 0`);
    await action();
    await browser.until(`document.body.dataset.drawn || document.querySelector("#messages .error")`);
}
const typed = (scene) => drawn(() => browser.value(`${EDITOR}.setValue(${JSON.stringify(scene)})`));
async function opened(hash) {
    await browser.visit("package.json");
    await browser.visit(hash);
    await browser.until("document.body?.dataset.drawn", 60);
}
const pixel = (id, x, y) =>
    browser.value(`[...document.getElementById("${id}").getContext("2d").getImageData(${x}, ${y}, 1, 1).data]`);
// From the beginning of a drawing to the reference's first picture, in milliseconds.
const firstPicture = () => browser.value(`performance.getEntriesByName("first reference")[0].startTime - performance.getEntriesByName("begin")[0].startTime`);

// The lines of b that a has not, and the other way round.
function changed(a, b) {
    const [before, after] = [a.split("\n"), b.split("\n")];
    return [before.filter((line) => !after.includes(line)), after.filter((line) => !before.includes(line))];
}

const told = {};
const checks = {
    async opens() {
        await browser.size(360, 800, true);
        await browser.visit("#scene=spotlight");
        await browser.until("document.body?.dataset.drawn", 60);
        told.verdict = await text("verdict");
        told.tooWide = await browser.value("document.documentElement.scrollWidth - document.documentElement.clientWidth");
        await browser.value(`document.getElementById("probe").requestSubmit()`);
        told.explanation = await text("explanation");
        told.loaded = await browser.value(`performance.getEntriesByName("first reference")[0].startTime`);
    },

    async takesKeysAndDrags() {
        const before = await sceneText();
        const after = async (action) => {
            const from = await sceneText();
            await drawn(action);
            return changed(from, await sceneText());
        };
        await browser.value(`document.getElementById("reference").focus()`);
        told.light = await after(() => browser.key("8"));
        told.said = await text("said");
        await drawn(() => browser.key("z"));
        told.undone = await sceneText() === before;
        told.flat = await after(() => browser.key("f"));
        told.arrow = await after(() => browser.key("ArrowLeft"));
        told.drag = await after(() => browser.drag("shaders", 40, 0));
        told.wheel = await after(() => browser.wheel("shaders", -100));
        await browser.key("?");
        told.keys = await browser.value(`[document.getElementById("keys").open, document.querySelector("#keys table").innerText]`);
        await browser.value(`document.getElementById("x").value = 1`);
        await browser.drag("reference");
        told.clicked = await browser.value(`document.getElementById("x").valueAsNumber`);
        // In the editor, keys are letters.
        await browser.value(`${EDITOR}.focus(), ${EDITOR}.setCursor(0, 0)`);
        const typing = await sceneText();
        await drawn(() => browser.key("1"));
        told.letter = await sceneText() === "1" + typing;
        await drawn(() => browser.value(`${EDITOR}.undo()`));
        // A drag is one step of undo, and Tab leaves the editor.
        await drawn(() => browser.drag("shaders", 40, 0));
        const dragged = await sceneText() !== typing;
        await drawn(() => browser.value(`${EDITOR}.undo()`));
        told.undoneInEditor = dragged && await sceneText() === typing;
        await browser.value(`${EDITOR}.focus()`);
        await browser.key("Tab");
        told.leaves = await browser.value(`!document.activeElement.closest(".CodeMirror")`) && await sceneText() === typing;
    },

    // A dump of a real program with its blobs, and files that are none.
    async opensDumps() {
        const before = await browser.value("location.hash"), folder = "tests/traces/blinkbox/";
        const dropped = (files) => drawn(() => browser.value(`(() => {
            const transfer = new DataTransfer();
            for (const [name, bytes] of ${JSON.stringify(files)})
                transfer.items.add(new File([Uint8Array.from(atob(bytes), (letter) => letter.charCodeAt(0))], name));
            dispatchEvent(new DragEvent("drop", {dataTransfer: transfer, cancelable: true}));
        })()`));
        const recording = fs.readdirSync(folder).map((name) => [name, fs.readFileSync(folder + name, "base64")]);
        told.dumpErrors = [];
        for (const files of [recording.filter(([name]) => name === "dump.txt"), [["cage.trace", btoa("\x06\x01")]]]) {
            await dropped(files);
            told.dumpErrors.push(await text("messages"));
        }
        await dropped(recording);
        told.dump = [await sceneText(), await text("verdict"), await browser.value(`document.getElementById("shaders").width`)];
        await browser.value(`document.getElementById("link").click()`);
        await browser.until(`location.hash.includes("size=")`);
        told.dumpLink = await browser.value(`new URLSearchParams(location.hash.slice(1)).get("size")`);
        await opened(before);
    },

    async showsErrors() {
        await typed("glClear(GL_COLOR_BUFFER_BIT);\nglRectf(0, 0, 1, 1);\nglFoo(<img src=x>);\n");
        told.error = await text("messages");
        told.markup = await browser.value(`document.querySelectorAll("#messages img").length`);
        told.marks = await browser.value(`[[...document.querySelectorAll(".mark")].map(({className}) => className), [...document.querySelectorAll(".marked")].map(({textContent}) => textContent).join("")]`);
        await typed("glColor3f(1, 0, 0);\nglRectf(-1, -1, 1, 1);\n");
        told.mended = await pixel("shaders", 320, 240);
        told.first = await firstPicture();
    },

    // A browser that grants no more memory, a scene beyond the page's limit, and a window beyond it.
    async survivesLackOfMemory() {
        told.memory = [];
        const tried = async (scene) => {
            await typed(scene);
            told.memory.push(await text("messages"));
        };
        // First, because memory that has grown stays.
        await browser.value(`(globalThis.grow = WebAssembly.Memory.prototype.grow, WebAssembly.Memory.prototype.grow = () => { throw new RangeError(); }, 0)`);
        await tried("glutSolidSphere(1, 700, 600);\n");
        await browser.value(`(WebAssembly.Memory.prototype.grow = grow, 0)`);
        await tried("glColor3f(1, 1, 1);\nglutSolidSphere(1, 2000, 1000);\n");
        await tried(`void display(void) { glRectf(-1, -1, 1, 1); }
int main(int argc, char** argv) { glutInit(&argc, argv); glutInitWindowSize(8000, 8000); glutCreateWindow("a"); glutDisplayFunc(display); glutMainLoop(); }\n`);
        await typed("glColor3f(1, 0, 0);\nglRectf(-1, -1, 1, 1);\n");
        told.afterMemory = await text("verdict");
    },

    async saves() {
        told.forms = await browser.value(`[...document.getElementById("form").options].map(({value}) => value)`);
        told.files = {};
        for (const form of told.forms)
            told.files[form] = await browser.value(`new Promise((resolve) => {
                URL.createObjectURL = (blob) => (blob.type === "image/png" ? resolve(blob.type) : blob.text().then(resolve), "data:,");
                document.getElementById("form").value = "${form}";
                document.getElementById("save").click();
            })`);
        told.link = await browser.value(`(document.getElementById("link").click(), new Promise((resolve) => setTimeout(() => resolve(location.hash), 500)))`);
    },

    async showsMesaAndTheSlider() {
        const isMesaHidden = () => browser.value(`document.getElementById("mesa").parentElement.hidden`);
        told.mesa = [await isMesaHidden()];
        await opened("#scene=spectral");
        told.mesa.push(await isMesaHidden(), await pixel("mesa", 320, 240), await pixel("floats", 320, 240));
        await browser.value(`document.getElementById("view").value = "slider", document.getElementById("left").value = "mesa",
            document.getElementById("line").value = 30, document.getElementById("view").dispatchEvent(new Event("input")), 0`);
        told.slider = await browser.value(`[...document.querySelectorAll("figure")].filter((figure) => getComputedStyle(figure).display !== "none")
            .map((figure) => [figure.querySelector("canvas").id, getComputedStyle(figure).clipPath])`);
    },

    async teaches() {
        await opened("#lesson=shininess");
        const grade = async () => {
            await browser.value(`document.getElementById("check").click()`);
            await browser.until(`document.getElementById("result").className`);
            return text("result");
        };
        told.lesson = await text("lesson");
        told.wrong = await grade();
        await typed((await sceneText()).replace("GL_SHININESS, 10", "GL_SHININESS, 100"));
        told.outdated = await text("result");
        told.solved = await grade();
        await browser.value(`document.querySelector(".choices button").click()`);
        told.prediction = await text("seen");
    },
};

try {
    browser.complaints = [];
    browser.requests = [];
    for (const check of Object.values(checks)) await check();
    told.requests = browser.requests.filter((url) => !url.startsWith("chrome:"));
    // Chromium notes that reading a picture back is slow.
    told.complaints = browser.complaints.filter((text) => !text.includes("GPU stall due to ReadPixels"));

    // In a page without the editor, so that the pictures are the only work.
    await browser.visit("package.json");
    const pictures = await browser.value(`(async () => {
        const [{loadTwinlight}, {Renderer}, {Workers}] = await Promise.all([import("/twinlight.js"), import("/gl.js"), import("/workers.js")]);
        const twinlight = await loadTwinlight(), renderer = new Renderer(), workers = new Workers(2), pictures = [], judging = [];
        for (const {shadings, ...scene} of ${fs.readFileSync(jobs, "utf8")}) {
            const {errors, width, height} = twinlight.open(scene);
            if (errors.length > 0) continue;
            for (const shading of shadings) {
                const picture = {name: scene.name, step: scene.step, shading}, failed = (error) => picture.error = String(error);
                pictures.push(picture);
                try {
                    const frame = twinlight.webglFrame(shading);
                    picture.missing = frame.header.missing.map(({message}) => message);
                    const {floats} = twinlight.referenceRows({shading, y0: 0, y1: height, width});
                    const given = {shading, pixels: renderer.draw(frame), floats, subpixelBits: renderer.subpixelBits};
                    judging.push(workers.do({scene, work: "judge", given}).then((judged) => picture.judged = judged, failed));
                } catch (error) {
                    failed(error);
                }
            }
        }
        await Promise.all(judging);
        return pictures;
    })()`);

    // After a texture that could not be loaded, the same frame is drawn in full.
    told.afterFailedUpload = await browser.value(`(async () => {
        const [{loadTwinlight}, {Renderer}] = await Promise.all([import("/twinlight.js"), import("/gl.js")]);
        const twinlight = await loadTwinlight(), renderer = new Renderer(), {gl} = renderer, upload = gl.texImage2D;
        const {text} = twinlight.builtIn().find(({name}) => name === "texture-units");
        twinlight.open({text, name: "upload", width: 64, height: 48});
        const frame = twinlight.webglFrame("scene"), said = [];
        const right = renderer.draw(frame).join(), without = {header: {...frame.header}, words: frame.words.slice(0)};
        gl.texImage2D = () => { throw new Error("no texture"); };
        try { renderer.draw(without); } catch ({message}) { said.push(message); }
        gl.texImage2D = upload;
        return [...said, renderer.draw(without).join() === right];
    })()`);

    // A hundred edits leave nothing behind.
    told.leaks = await browser.value(`(async () => {
        const [{loadTwinlight}, {Renderer}] = await Promise.all([import("/twinlight.js"), import("/gl.js")]);
        const twinlight = await loadTwinlight(), renderer = new Renderer(), {gl} = renderer, alive = {};
        for (const kind of ["Buffer", "Framebuffer", "Program", "Renderbuffer", "Shader", "Texture"]) {
            alive[kind] = 0;
            const [create, remove] = ["create" + kind, "delete" + kind].map((name) => gl[name].bind(gl));
            gl["create" + kind] = (...given) => (++alive[kind], create(...given));
            gl["delete" + kind] = (object) => (object && --alive[kind], remove(object));
        }
        const {text} = twinlight.builtIn().find(({name}) => name === "texture-units"), after = [];
        for (let edit = 0; edit < 100; ++edit) {
            twinlight.open({text: text + "glRotatef(" + edit + ", 0, 1, 0);", name: "edit", width: 64, height: 48});
            const pixels = renderer.draw(twinlight.webglFrame(edit % 2 ? "phong" : "scene"));
            const {floats} = twinlight.referenceRows({shading: "scene", y0: 0, y1: 48, width: 64});
            twinlight.judge("scene", pixels, floats, renderer.subpixelBits);
            twinlight.press("8".charCodeAt(0));
            if (edit === 19 || edit === 99) after.push({...alive, bytes: twinlight.memoryBytes()});
        }
        return after;
    })()`);
    console.log(JSON.stringify({page: told, pictures}));
} finally {
    await browser.close();
}
