// The page: a scene's text, its errors, and its pictures.
import {Renderer} from "./gl.js";
import {sceneInLink, textInLink} from "./link.js";
import {loadTwinlight} from "./twinlight.js";
import {Workers} from "./workers.js";

const WIDTH = 640, HEIGHT = 480;
const ROWS = 48;          // of a worker's task
const PAUSE_MS = 150;     // after a key, before the text is read
const ZERO_GREY = 64;     // where pictures are equal

const at = (id) => document.getElementById(id);
const twinlight = await loadTwinlight();
const workers = new Workers(Math.min(Math.max(navigator.hardwareConcurrency || 2, 2), 8));
const builtIn = twinlight.builtIn();
let renderer = null, name = "scene", opened = null, revision = 0, pause = 0;

// ---- Messages: all texts of scenes become text, never markup ----

function message(kind, {line, column, text}) {
    const item = document.createElement("li"), button = document.createElement("button");
    button.type = "button";
    button.className = kind;
    button.textContent = (line > 0 ? `${line}:${column ?? 1}: ` : "") + `${kind}: ${text}`;
    if (line > 0) button.addEventListener("click", () => select(line, column ?? 1));
    item.append(button);
    at("messages").append(item);
}

function select(line, column) {
    const text = at("text"), lines = text.value.split("\n");
    const start = lines.slice(0, line - 1).reduce((sum, one) => sum + one.length + 1, 0);
    const end = start + (lines[line - 1] ?? "").length;
    text.focus();
    text.setSelectionRange(Math.min(start + column - 1, end), end);
    text.scrollTop = Math.max(0, (line - 5) * text.scrollHeight / lines.length);
}

// ---- Pictures ----

function canvasOf(id, {width, height}) {
    const canvas = at(id);
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    return canvas.getContext("2d");
}
function show(id, pixels, size, y = 0) {
    const opaque = new Uint8ClampedArray(pixels);
    for (let i = 3; i < opaque.length; i += 4) opaque[i] = 255;
    canvasOf(id, size).putImageData(new ImageData(opaque, size.width), 0, y);
    at(id).classList.remove("stale");
}

// The reference's picture, band by band as the workers draw it.
async function reference(id, scene, size, given, mine) {
    const whole = new Uint8ClampedArray(4 * size.width * size.height), bands = [];
    for (let y0 = 0; y0 < size.height; y0 += ROWS) {
        const y1 = Math.min(y0 + ROWS, size.height);
        bands.push(workers.do({scene, work: "rows", given: {...given, y0, y1, width: size.width}}).then((rows) => {
            if (mine !== revision) return;
            whole.set(rows, 4 * size.width * y0);
            show(id, rows, size, y0);
        }));
    }
    await Promise.all(bands);
    return whole;
}

function showDifference(a, b, largest, size) {
    let factor = 1;
    while (factor < 64 && 2 * factor * largest <= 255) factor *= 2;
    const pixels = a.map((value, i) => ZERO_GREY + factor * Math.abs(value - b[i]));
    show("difference", pixels, size);
    at("factor").textContent = `(${factor} times)`;
}

function verdict(result) {
    const {within, max, at: [x, y], beyond, interior, differing} = result;
    if (max === 0) return "Shaders and reference are equal away from edges.";
    const largest = `the largest difference away from edges is ${max}/255, at pixel ${x}, ${y}`;
    if (within) return `Shaders and reference agree: ${largest}` + (beyond < max ? "; that much is allowed there." : ".");
    return `Shaders and reference differ: ${largest}; ${differing} of ${interior} pixels are beyond what is allowed.`;
}

async function draw() {
    const mine = ++revision;
    workers.forget();
    const scene = {text: at("text").value, name, step: at("steps").value, width: WIDTH, height: HEIGHT};
    let answer = twinlight.open(scene);
    // The text may have lost its steps.
    if (answer.errors.length > 0 && scene.step) answer = twinlight.open({...scene, step: ""});
    at("messages").replaceChildren();
    for (const {line, column, message: text} of answer.errors) message("error", {line, column, text});
    if (answer.note) message("note", {line: 0, text: answer.note});
    for (const canvas of document.querySelectorAll("canvas")) canvas.classList.add("stale");
    opened = answer.errors.length === 0 ? answer : null;
    if (!opened) {
        at("verdict").textContent = "The scene has errors; the pictures are those before.";
        return;
    }
    setSteps(answer);
    scene.step = at("steps").value;
    const shading = at("shading").value;
    let pixels = null;
    at("verdict").textContent = "The reference is drawing ...";
    try {
        renderer ??= new Renderer();
        const frame = twinlight.webglFrame(shading);
        pixels = renderer.draw(frame);
        show("shaders", pixels, answer);
        for (const {line, column, message: text} of frame.header.missing)
            message("note", {line, column, text: "the shaders' picture lacks a part, because WebGL does: " + text});
    } catch (error) {
        message("error", {line: 0, text: error.message});
    }
    try {
        const right = reference("reference", scene, answer, {shading}, mine);
        const floats = reference("floats", scene, answer, {shading: "scene", asFloats: true}, mine);
        for (const warning of twinlight.warnings())
            message("warning", {...warning, text: `${warning.message}; ${warning.fix}`});
        const judged = pixels ? workers.do({scene, work: "judge", given: {shading, pixels: new Uint8Array(pixels), subpixelBits: renderer.subpixelBits}}) : null;
        const whole = await right;
        if (judged) {
            const result = await judged;
            if (mine !== revision) return;
            showDifference(pixels, whole, result.max, answer);
            at("verdict").textContent = verdict(result);
        }
        await floats;
    } catch (error) {
        if (mine === revision) message("error", {line: 0, text: error.message});
    }
    if (mine === revision) document.body.dataset.drawn = mine;
}

// ---- Controls ----

function setSteps({steps, step}) {
    at("step-label").hidden = steps.length === 0;
    const given = [...at("steps").options].map((option) => option.textContent).join("\n");
    const options = steps.map((title, i) => new Option(`${i + 1}: ${title}`, String(i + 1)));
    if (options.map((option) => option.textContent).join("\n") !== given) at("steps").replaceChildren(...options);
    at("steps").value = step > 0 ? String(step) : "";
}

function load(scene_name, text, step = "") {
    name = scene_name;
    at("text").value = text;
    at("steps").replaceChildren(...(step ? [new Option(step, step)] : []));
    return draw();
}

function openBuiltIn(wanted, step) {
    const scene = builtIn.find((one) => one.name === wanted) ?? builtIn.find((one) => one.name === "report");
    at("scenes").value = scene.name;
    return load(scene.name, scene.text, step);
}

async function openLink() {
    const link = new URLSearchParams(location.hash.slice(1));
    try {
        if (link.has("text")) return await load("scene", await textInLink(link.get("text")), link.get("step") ?? "");
    } catch {
        message("error", {line: 0, text: "this link holds no scene; copy it again"});
    }
    return openBuiltIn(link.get("scene"), link.get("step") ?? "");
}

function explain(x, y) {
    if (!opened || !(x >= 0 && y >= 0 && x < opened.width && y < opened.height)) return;
    [at("x").value, at("y").value] = [x, y];
    at("explanation").textContent = twinlight.explain(at("shading").value, x, y);
}

at("scenes").append(...builtIn.map((scene) => new Option(scene.name)));
at("scenes").addEventListener("change", () => openBuiltIn(at("scenes").value));
at("steps").addEventListener("change", draw);
at("shading").addEventListener("change", draw);
at("text").addEventListener("input", () => {
    clearTimeout(pause);
    pause = setTimeout(draw, PAUSE_MS);
});
at("link").addEventListener("click", async () => {
    history.replaceState(null, "", "#" + await sceneInLink(at("text").value, builtIn, at("steps").value));
    try {
        await navigator.clipboard.writeText(location.href);
    } catch {
        // The address bar has the link, too.
    }
});
at("save").addEventListener("click", () => {
    const link = document.createElement("a");
    link.href = URL.createObjectURL(new Blob([at("text").value], {type: "text/plain"}));
    link.download = name + ".gl";
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 1000);
});
at("probe").addEventListener("submit", (event) => {
    event.preventDefault();
    explain(at("x").valueAsNumber, at("y").valueAsNumber);
});
for (const canvas of document.querySelectorAll("canvas"))
    canvas.addEventListener("click", (event) => {
        const box = canvas.getBoundingClientRect();
        explain(Math.floor((event.clientX - box.left) * canvas.width / box.width),
                Math.floor((event.clientY - box.top) * canvas.height / box.height));
    });
addEventListener("dragover", (event) => event.preventDefault());
addEventListener("drop", async (event) => {
    event.preventDefault();
    const file = event.dataTransfer.files[0];
    if (file) await load(file.name.replace(/\.[^.]*$/, ""), await file.text());
});
addEventListener("hashchange", openLink);

await openLink();
at("driver").textContent = renderer ? renderer.description() : "";
