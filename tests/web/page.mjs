// page.mjs CHROMIUM PAGE JOBS: opens the page in Chromium and prints a JSON object: what the page did ("page"), and the pictures of each of
// JOBS by its shaders ("pictures").
import fs from "node:fs";
import zlib from "node:zlib";
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
// A link to a scene in a small window, which takes less time.
const small = (scene) => `#size=160x120&text=${zlib.deflateRawSync(scene).toString("base64url")}`;
const SPHERE = `glEnable(GL_DEPTH_TEST);
glMatrixMode(GL_PROJECTION);
gluPerspective(40, 4.0 / 3.0, 1, 100);
glMatrixMode(GL_MODELVIEW);
gluLookAt(0, 0, 4, 0, 0, 0, 0, 1, 0);
glEnable(GL_LIGHTING);
glEnable(GL_LIGHT0);
glutSolidSphere(1, 12, 8);
`;
const pixel = (id, x, y) =>
    browser.value(`[...document.getElementById("${id}").getContext("2d").getImageData(${x}, ${y}, 1, 1).data]`);
const choose = (id, value) => browser.value(`document.getElementById("${id}").value = "${value}",
    ["input", "change"].forEach((kind) => document.getElementById("${id}").dispatchEvent(new Event(kind)))`);
// By how many pixels the page is wider than its window.
const tooWide = () => browser.value("document.documentElement.scrollWidth - document.documentElement.clientWidth");
// Of each control that Tab reaches, from the beginning of the page.
async function tabOrder() {
    const order = [];
    await browser.value(`document.activeElement.blur(), scrollTo(0, 0)`);
    for (let i = 0; i < 60; ++i) {
        await browser.key("Tab");
        const id = await browser.value(`document.activeElement.closest(".CodeMirror") ? "editor" : document.activeElement.id || document.activeElement.tagName`);
        if (order.includes(id) && id === order[0]) break;
        order.push(id);
    }
    return order;
}
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
        await browser.send("Page.addScriptToEvaluateOnNewDocument", {source: `window.order = [];
            for (const name of ["drawImage", "putImageData"]) {
                const draw = CanvasRenderingContext2D.prototype[name];
                CanvasRenderingContext2D.prototype[name] = function (...given) {
                    if (this.canvas.id === "reference") order.push(name);
                    return draw.apply(this, given);
                };
            }`});
        await browser.visit("#scene=spotlight");
        await browser.until("document.body?.dataset.drawn", 60);
        told.verdict = await text("verdict");
        told.tooWide = [await tooWide()];
        told.policy = await browser.value(`document.querySelector("meta[http-equiv=Content-Security-Policy]").content`);
        // The coarse picture is scaled, bands of rows are not.
        told.order = await browser.value(`window.order`);
        await browser.value(`document.getElementById("probe").requestSubmit()`);
        told.explanation = await text("explanation");
        told.arrows = await browser.value(`[...document.querySelectorAll("#shaders ~ .arrows text")].map((text) => text.textContent)`);
        told.terms = await browser.value(`[document.querySelectorAll(".bars div").length, document.querySelector("#terms table .result").innerText]`);
        told.caption = await text("caption");
        told.labels = await browser.value(`[...document.querySelectorAll("#reference ~ .labels span")].map((text) => text.textContent)`);
        told.loaded = await browser.value(`performance.getEntriesByName("first reference")[0].startTime`);
    },

    // All controls in their order, without a mouse, in both colour schemes.
    async worksWithTheKeyboard() {
        told.narrow = await browser.value(`document.getElementById("view").value`);
        await choose("view", "grid");
        told.tabs = await tabOrder();
        await browser.size(360, 800, false);
        told.tooWide.push(await tooWide());
        const background = () => browser.value(`getComputedStyle(document.querySelector(".CodeMirror")).backgroundColor`);
        told.schemes = [await background()];
        await browser.size(360, 800, true);
        told.schemes.push(await background());
    },

    async showsEachLightingAndStep() {
        await opened(small(SPHERE));
        told.lightings = {};
        for (const shading of ["phong", "exact", "scene"]) {
            await drawn(() => choose("shading", shading));
            told.lightings[shading] = await pixel("reference", 80, 60);
        }
        await choose("x", 75), await choose("y", 50);
        await browser.value(`document.getElementById("probe").requestSubmit()`);
        told.explained = await text("explanation");
        await opened(small(fs.readFileSync("src/scene/scenes/lab.gl")));
        told.steps = await browser.value(`document.getElementById("steps").options.length`);
        await drawn(() => choose("steps", "2"));
        told.step = [await browser.value(`document.getElementById("steps").value`), await pixel("reference", 80, 60)];
        await opened(small(SPHERE));
    },

    async dragsNumbers() {
        await opened(small("glEnable(GL_LIGHTING);\nglEnable(GL_LIGHT0);\nGLfloat place[] = {1, 2, 3, 1};\nglLightfv(GL_LIGHT0, GL_POSITION, place);\n" +
            "glMaterialf(GL_FRONT, GL_SHININESS, 20);  // dull\nglutSolidSphere(0.8, 8, 6);\n"));
        told.numbers = [await browser.value(`document.getElementById("numbers").innerText`)];
        for (const [number, value] of [[0, -0.5], [2, 64]])
            await drawn(() => browser.value(`(([...inputs]) => (inputs[${number}].value = ${value}, inputs[${number}].dispatchEvent(new Event("input"))))(
                document.querySelectorAll("#numbers input"))`));
        told.numbers.push(await sceneText());
    },

    async listsScenesAsPictures() {
        await browser.value(`document.getElementById("all-scenes").click()`);
        await browser.until(`document.querySelector("#gallery img")?.complete`);
        told.gallery = await browser.value(`[...document.querySelectorAll("#gallery h3")].map((heading) => heading.textContent)`);
        told.cards = await browser.value(`[document.querySelectorAll("#gallery img").length, document.getElementById("scenes").querySelectorAll("optgroup:first-child option").length]`);
        await drawn(() => browser.value(`[...document.querySelectorAll("#gallery section button")].find((card) => card.textContent === "terms").click()`));
        told.chosen = await browser.value(`[document.getElementById("scenes").value, document.getElementById("gallery").open]`);
        await opened(small(SPHERE));
    },

    async takesKeysAndDrags() {
        const before = await sceneText();
        const after = async (action) => {
            const from = await sceneText();
            await drawn(action);
            return changed(from, await sceneText());
        };
        await browser.value(`document.getElementById("reference").focus()`);
        for (const key of "12345678f") await browser.key(key);
        told.keyed = [before, await sceneText()];
        for (let i = 0; i < 9; ++i) await browser.key("z");
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
        const folder = "tests/traces/blinkbox/";
        const dropped = (files) => drawn(() => browser.value(`(() => {
            const transfer = new DataTransfer();
            for (const [name, bytes] of ${JSON.stringify(files)})
                transfer.items.add(new File([Uint8Array.from(atob(bytes), (letter) => letter.charCodeAt(0))], name));
            dispatchEvent(new DragEvent("drop", {dataTransfer: transfer, cancelable: true}));
        })()`));
        const recording = fs.readdirSync(folder).map((name) => [name, fs.readFileSync(folder + name, "base64")]);
        told.dumpErrors = [];
        for (const files of [recording.filter(([name]) => name === "dump.txt"), [["old.trace", btoa("\x1f\x8b\x08")]]]) {
            await dropped(files);
            told.dumpErrors.push(await text("messages"));
        }
        // A lesson that a teacher wrote: one of ours under another name.
        const lesson = fs.readFileSync("docs/lessons/shininess.md", "utf8").replace(/^# .*/, "# Glass");
        await dropped([["glass.md", Buffer.from(lesson).toString("base64")]]);
        told.droppedLesson = [await browser.value(`document.querySelector("#lesson h2").textContent`)];
        await browser.value(`document.getElementById("check").click()`);
        await browser.until(`document.getElementById("result").className`);
        told.droppedLesson.push(await text("result"));
        await dropped([["mine.gl", btoa("// mine\nglRectf(0, 0, 1, 1);\n")]]);
        told.droppedScene = [await sceneText(), await browser.value(`document.getElementById("scenes").value`)];
        // The events of a .trace in one chunk.
        const events = fs.readFileSync("tests/fuzz/seeds/trace/frame"), literal = Buffer.from([61 << 2, (events.length - 1) & 255, (events.length - 1) >> 8]);
        const length = Buffer.from([events.length & 127 | 128, events.length >> 7]), size = Buffer.alloc(4);
        size.writeUInt32LE(length.length + literal.length + events.length);
        await dropped([["frame.trace", Buffer.concat([Buffer.from("at"), size, length, literal, events]).toString("base64")]]);
        told.droppedTrace = [await sceneText(), await text("messages")];
        // A mesh with its material file and picture, a program, and a picture alone.
        const triangle = "mtllib t.mtl\nusemtl red\nv 0 0 0\nv 2 0 0\nv 0 2 0\nvn 0 0 1\nf 1//1 2//1 3//1\n";
        await dropped([["t.obj", btoa(triangle)], ["t.mtl", btoa("newmtl red\nKa 0 0 0\nKd 1 0 0\n")]]);
        told.droppedMesh = [await sceneText(), await text("messages"), await pixel("reference", 300, 260), await pixel("shaders", 300, 260)];
        await dropped([["main.c", btoa(`#include <GL/glut.h>
void display(void) { glColor3f(0, 1, 0); glRectf(-1, -1, 1, 1); glutSwapBuffers(); }
int main(int argc, char** argv) { glutInit(&argc, argv); glutInitWindowSize(80, 60); glutCreateWindow("a"); glutDisplayFunc(display); glutMainLoop(); }
`)]]);
        told.droppedProgram = [await text("messages"), await browser.value(`document.getElementById("shaders").width`), await pixel("reference", 40, 30)];
        const textured = `glEnable(GL_TEXTURE_2D);\n#pragma twinlight texture("mine.png")\nglTexCoord2f(0.5, 0.5);\nglRectf(-1, -1, 1, 1);\n`;
        await typed(textured);
        told.droppedPicture = [await text("messages")];
        await drawn(async () => {
            await dropped([["mine.png", fs.readFileSync("src/scene/scenes/crate.png", "base64")]]);
        });
        told.droppedPicture.push(await text("said"), await text("messages"), await sceneText() === textured, await pixel("reference", 40, 30), await pixel("shaders", 40, 30));
        // A scene that loads another picture than Mesa did.
        await dropped([["floor.png", fs.readFileSync("src/scene/scenes/crate.png", "base64")]]);
        await drawn(() => choose("scenes", "report"));
        told.otherMesa = [await text("messages"), await browser.value(`document.getElementById("mesa").parentElement.hidden`)];
        await dropped(recording);
        told.dump = [await sceneText(), await text("verdict"), await browser.value(`document.getElementById("shaders").width`)];
        await browser.value(`document.getElementById("link").click()`);
        await browser.until(`location.hash.includes("size=300")`);
        told.dumpLink = await browser.value(`new URLSearchParams(location.hash.slice(1)).get("size")`);
        await opened("#scene=spotlight");
    },

    // A browser that does not load the workers.
    async saysThatAWorkerFailed() {
        const {identifier} = await browser.send("Page.addScriptToEvaluateOnNewDocument", {source: `window.Worker = class extends EventTarget {
            constructor() {
                super();
                setTimeout(() => this.dispatchEvent(new ErrorEvent("error", {message: "no worker"})), 100);
            }
            postMessage() {}
        };`});
        await browser.visit("package.json");
        await browser.visit(small(SPHERE));
        await browser.until(`document.querySelector("#messages .error")`);
        told.failedWorker = await text("messages");
        await browser.send("Page.removeScriptToEvaluateOnNewDocument", {identifier});
        await opened("#scene=spotlight");
    },

    // Dark and light, as the system or as the button says.
    async changesTheTheme() {
        const shown = () => browser.value(`[getComputedStyle(document.body).backgroundColor, document.getElementById("theme").textContent]`);
        const click = () => browser.value(`document.getElementById("theme").click()`);
        told.themes = [await shown()];
        await click();
        told.themes.push(await shown());
        await opened("#scene=spotlight");
        told.themes.push(await shown());
        await click();
        told.themes.push(await shown());
    },

    async showsErrors() {
        await typed("glClear(GL_COLOR_BUFFER_BIT);\nglRectf(0, 0, 1, 1);\nglFoo(<img src=x>);\n");
        told.error = await text("messages");
        told.markup = await browser.value(`document.querySelectorAll("#messages img").length`);
        told.marks = await browser.value(`[[...document.querySelectorAll(".mark")].map(({className}) => className), [...document.querySelectorAll(".marked")].map(({textContent}) => textContent).join("")]`);
        await typed("glColor3f(1, 0, 0);\nglRectf(-1, -1, 1, 1);\n");
        told.corrected = await pixel("shaders", 320, 240);
        told.first = await firstPicture();
    },

    // One pixel of the shaders' picture gets another red, as if a driver had drawn it.
    async showsTheLargestDifference() {
        await browser.value(`(() => {
            const read = WebGL2RenderingContext.prototype.readPixels;
            window.unpatch = () => WebGL2RenderingContext.prototype.readPixels = read;
            WebGL2RenderingContext.prototype.readPixels = function (x, y, width, height, format, type, pixels) {
                read.call(this, x, y, width, height, format, type, pixels);
                pixels[4 * (width * (height - 1 - 50) + 100)] -= 9;
            };
        })()`);
        await typed("glColor3f(1, 0, 0);\nglRectf(-1, -1, 1, 1);\n");
        told.differs = await text("verdict");
        told.factor = [await text("factor"), await pixel("difference", 100, 50), await pixel("difference", 101, 50)];
        await browser.value("unpatch(), 0");
        await typed("glEnable(GL_LIGHTING);\nglColor3f(1, 0, 0);\nglRectf(-1, -1, 1, 1);\n");
        told.warning = await browser.value(`[...document.querySelectorAll("#messages .warning")].map(({textContent}) => textContent)`);
        told.warningMarks = await browser.value(`[document.querySelectorAll(".mark.warning").length, document.querySelectorAll(".marked.warning").length]`);
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
        const before = await sceneText();
        await browser.value(`document.getElementById("link").click()`);
        await browser.until(`location.hash.startsWith("#text=")`);
        told.link = await browser.value("location.hash");
        await opened("#scene=spotlight");
        await opened(told.link);
        told.linked = [await sceneText() === before, await browser.value(`document.getElementById("scenes").value`)];
    },

    async showsMesaAndTheSlider() {
        const isMesaHidden = () => browser.value(`document.getElementById("mesa").parentElement.hidden`);
        told.mesa = {own: await isMesaHidden()};
        for (const [name, hash] of [["scene", "#scene=spectral"], ["step", "#scene=terms&step=3"]]) {
            await opened(hash);
            told.mesa[name] = [await isMesaHidden(), await pixel("mesa", 320, 240), await pixel("floats", 320, 240)];
        }
        await browser.value(`document.getElementById("view").value = "slider", document.getElementById("left").value = "mesa",
            document.getElementById("line").value = 30, document.getElementById("view").dispatchEvent(new Event("input")), 0`);
        told.tooWide.push(await tooWide());
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
        told.tooWide.push(await tooWide());
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
    told.complaints = await browser.said();

    // In a page without the editor, so that the pictures are the only work.
    await browser.visit("package.json");
    await browser.value(`(async () => {
        const [{loadTwinlight}, {Renderer}] = await Promise.all([import("/twinlight.js"), import("/gl.js")]);
        const twinlight = await loadTwinlight(), renderer = new Renderer();
        globalThis.subpixelBits = renderer.subpixelBits;
        globalThis.draw = ({shadings, judges, ...scene}) => {
            const {errors, width, height} = twinlight.open(scene);
            return errors.length > 0 ? [] : shadings.map((shading) => {
                try {
                    const frame = twinlight.webglFrame(shading), pixels = renderer.draw(frame);
                    const judged = () => twinlight.judge(shading, pixels, twinlight.referenceRows({shading, y0: 0, y1: height, width}).floats, renderer.subpixelBits);
                    const text = Array.from({length: Math.ceil(pixels.length / 8192)}, (_, i) => String.fromCharCode(...pixels.subarray(8192 * i, 8192 * (i + 1))));
                    return {shading, missing: frame.header.missing.map(({message}) => message), pixels: btoa(text.join("")), judged: judges ? judged() : null};
                } catch (error) {
                    return {shading, error: String(error)};
                }
            });
        };
    })()`);
    const pictures = [];
    for (const job of JSON.parse(fs.readFileSync(jobs, "utf8"))) pictures.push(await browser.value(`draw(${JSON.stringify(job)})`));
    told.subpixelBits = await browser.value("subpixelBits");
    // Why pictures differ by 1/255 where nothing is at an edge: a rasteriser rounds corners. On its grid the same mesh is equal.
    told.meshes = await browser.value(`(async () => {
        const [{loadTwinlight}, {Renderer}] = await Promise.all([import("/twinlight.js"), import("/gl.js")]);
        const twinlight = await loadTwinlight(), renderer = new Renderer(), size = {width: 320, height: 240}, step = 2 ** -renderer.subpixelBits;
        let seed = 1;
        const random = () => (seed = seed * 16807 % 2147483647) / 2147483647;
        const placed = [];
        for (let y = 0; y <= 240; y += 20)
            for (let x = 0; x <= 320; x += 20)
                placed.push([x + (x % 320 && 8 * random()), y + (y % 240 && 8 * random()), random(), random(), random()]);
        // The share of pixels that differ, and the most.
        const differing = (grid) => {
            const vertex = (i) => {
                const [x, y, ...color] = placed[i], rounded = [x, y].map((at) => grid ? Math.round(at / grid) * grid : at);
                return \`glColor3f(\${color}); glVertex2f(\${rounded});\`;
            };
            let text = "glMatrixMode(GL_PROJECTION); glOrtho(0, 320, 0, 240, -1, 1); glBegin(GL_TRIANGLES);";
            for (let i = 0; i + 18 < placed.length; ++i)
                if (i % 17 < 16) text += [i, i + 1, i + 18, i, i + 18, i + 17].map(vertex).join("");
            twinlight.open({...size, text: text + "glEnd();", name: "mesh"});
            const drawn = renderer.draw(twinlight.webglFrame("scene")), {rows} = twinlight.referenceRows({shading: "scene", y0: 0, y1: 240, width: 320});
            const differences = drawn.map((value, i) => Math.abs(value - rows[i]));
            return [differences.filter((one) => one > 0).length / differences.length, Math.max(...differences.filter((one) => one > 0), 0)];
        };
        return {step, onGrid: differing(step), offGrid: differing(0)};
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
