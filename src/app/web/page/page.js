// The page: a scene's text, its errors, and its pictures.
import {control, showKeys} from "./controls.js";
import {Editor} from "./editor.js";
import {sceneIn} from "./files.js";
import {startGallery} from "./gallery.js";
import {Renderer} from "./gl.js";
import {showLabels} from "./labels.js";
import {Lessons} from "./lessons.js";
import {sceneInLink, sizeInLink, textInLink} from "./link.js";
import {Numbers} from "./numbers.js";
import {file, workersOf} from "./own_files.js";
import {offerMesa, setSlider, show, showDifference, showMesa, showReference, startSlider} from "./pictures.js";
import {hideArrows, showProbe} from "./probe.js";
import {offer, save} from "./saves.js";
import {loadTwinlight} from "./twinlight.js";
import {startTheme} from "./theme.js";
import {Tutor} from "./tutor.js";
import {Workers} from "./workers.js";

const WINDOW = {width: 640, height: 480};
const LESSON = "lesson:", TUTOR = "tutor:";  // before names in the list of scenes
const PAUSE_MS = 150;  // after a key, before the text is read

const at = (id) => document.getElementById(id);
const wasm = await WebAssembly.compileStreaming(file("module.wasm")).catch((error) => {
    at("verdict").textContent = `The page cannot load module.wasm: ${error.message}`;
    throw error;
});
const twinlight = await loadTwinlight({wasm});
const workers = new Workers(Math.min(Math.max(navigator.hardwareConcurrency || 2, 2), 8), await workersOf("worker.js"), wasm);
const builtIn = twinlight.builtIn(), tutors = twinlight.tutors();
const recorded = await (await file("mesa.json")).json();  // the names of Mesa's pictures
const language = navigator.language.startsWith("zh") ? "zh" : "en";
const editor = new Editor(at("text"), () => {
    clearTimeout(pause);
    pause = setTimeout(draw, PAUSE_MS);
});
let renderer = null, name = "scene", window_size = WINDOW, opened = null, revision = 0, pause = 0, keptFiles = 0, probe = null;

// ---- Messages: all texts of scenes become text, never markup ----

function message(kind, {line, column, text}) {
    const item = document.createElement("li"), button = document.createElement("button");
    button.type = "button";
    button.className = kind;
    button.textContent = (line > 0 ? `${line}:${column ?? 1}: ` : "") + `${kind}: ${text}`;
    if (line > 0) {
        button.addEventListener("click", () => editor.select(line, column ?? 1));
        editor.mark(kind, {line, column: column ?? 1, text});
    }
    item.append(button);
    at("messages").append(item);
}

// ---- Pictures ----

function verdict(result) {
    const {within, max, at: [x, y], beyond, interior, differing} = result;
    if (max === 0) return "Shaders and reference are equal away from edges.";
    const largest = `the largest difference away from edges is ${max}/255, at pixel ${x}, ${y}`;
    if (within) return `Shaders and reference agree: ${largest}` + (beyond < max ? "; that much is allowed there." : ".");
    return `Shaders and reference differ: ${largest}; ${differing} of ${interior} pixels are beyond what is allowed.`;
}

async function draw() {
    const mine = ++revision, wanted = () => mine === revision;
    clearTimeout(pause);
    pause = 0;
    performance.clearMarks();
    performance.mark("begin");
    workers.forget();
    const scene = {text: editor.text, name, step: at("steps").value, keptFiles, ...window_size};
    let answer;
    try {
        answer = twinlight.open(scene);
        // The text may have lost its steps.
        if (answer.errors.length > 0 && scene.step) answer = twinlight.open({...scene, step: ""});
    } catch (error) {
        answer = {errors: [{line: 0, message: error.message}]};
    }
    lessons.changed(scene.text);
    at("messages").replaceChildren();
    editor.clear();
    for (const {line, column, message: text} of answer.errors) message("error", {line, column, text});
    if (answer.note) message("note", {line: 0, text: answer.note});
    for (const canvas of document.querySelectorAll("figure canvas")) canvas.classList.add("stale");
    opened = answer.errors.length === 0 ? answer : null;
    if (!opened) {
        at("verdict").textContent = "The scene has errors; the pictures are the previous ones.";
        return;
    }
    setSteps(answer);
    hideArrows();
    at("caption").querySelectorAll("span").forEach((part, i) => part.textContent = answer.caption[i]);
    scene.step = at("steps").value;
    const shading = at("shading").value, size = {width: answer.width, height: answer.height};
    let pixels = null;
    at("verdict").textContent = "The reference is drawing ...";
    try {
        const frame = twinlight.webglFrame(shading);
        for (const canvas of document.querySelectorAll("figure canvas")) showLabels(canvas, frame.header.labels ?? [], size);
        renderer ??= new Renderer();
        pixels = renderer.draw(frame);
        show("shaders", pixels, size);
        for (const {line, column, message: text} of frame.header.missing)
            message("note", {line, column, text: "the shaders' picture lacks a part, because WebGL lacks it: " + text});
    } catch (error) {
        message("error", {line: 0, text: error.message});
    }
    try {
        if (tutor.isShown) {
            tutor.show(size);
            if (probe) explain(...probe);
            document.body.dataset.drawn = mine;
            return;
        }
        const right = showReference("reference", workers, scene, size, {shading}, wanted);
        const floats = showReference("floats", workers, scene, size, {shading: "scene", asFloats: true}, wanted);
        floats.catch(() => {});  // an error before it is awaited
        const recording = pictureByMesa(scene);
        offerMesa(recording !== null);
        offer(twinlight.forms(shading));
        numbers.show(twinlight.numbers());
        if (probe) explain(...probe);
        for (const warning of twinlight.warnings())
            message("warning", {...warning, text: `${warning.message}; ${warning.fix}`});
        const whole = await right;
        if (!wanted()) return;
        if (pixels) {
            const given = {shading, pixels: new Uint8Array(pixels), floats: whole.floats, subpixelBits: renderer.subpixelBits};
            const result = await workers.do({scene, work: "judge", given}, {soon: true});
            if (!wanted()) return;
            at("factor").textContent = `(${showDifference(pixels, whole.pixels, result.max, size)} times)`;
            at("verdict").textContent = verdict(result);
        }
        const {pixels: drawnWithFloats} = await floats;
        if (recording) await showMesa(recording, drawnWithFloats, size, wanted);
    } catch (error) {
        if (wanted()) message("error", {line: 0, text: error.message});
    }
    if (wanted()) document.body.dataset.drawn = mine;
}

// The name of Mesa's picture of this text and step; null unless the text is that of a built-in scene.
function pictureByMesa({text, step}) {
    const picture = step ? `${name}-${step}` : name;
    const isBuiltIn = builtIn.some((one) => one.name === name && one.text === text);
    return isBuiltIn && recorded.includes(picture) ? picture : null;
}

// ---- Controls ----

function setSteps({steps, step}) {
    at("step-label").hidden = steps.length === 0;
    const given = [...at("steps").options].map((option) => option.textContent).join("\n");
    const options = steps.map((title, i) => new Option(`${i + 1}: ${title}`, String(i + 1)));
    if (options.map((option) => option.textContent).join("\n") !== given) at("steps").replaceChildren(...options);
    at("steps").value = step > 0 ? String(step) : "";
}

function load(scene_name, text, {step = "", size = WINDOW, isTutor = false} = {}) {
    setTutor(isTutor);
    name = scene_name;
    window_size = size;
    forgetProbe();
    at("said").textContent = "";
    editor.open(text);
    setStep(step);
    return draw();
}

// The step is chosen when the text is read.
function setStep(step) {
    at("steps").replaceChildren(...(step ? [new Option(step, step)] : []));
}

function openBuiltIn(wanted, step) {
    const scene = builtIn.find((one) => one.name === wanted) ?? builtIn.find((one) => one.name === "report");
    lessons.hide();
    at("scenes").value = scene.name;
    return load(scene.name, scene.text, {step});
}

function openLesson(lesson) {
    at("scenes").value = LESSON + lesson.name;
    lessons.show(lesson);
    return load(lesson.name, lesson.scene);
}

function openTutor({name, text}) {
    lessons.hide();
    at("scenes").value = TUTOR + name;
    return load("tutor-" + name, text, {isTutor: true});
}

// The tutor's view, or the whole page.
function setTutor(isTutor) {
    document.body.classList.toggle("tutor", isTutor);
    if (!isTutor) editor.refresh();
    setSlider();
}

function openMenu(value) {
    if (value.startsWith(TUTOR)) return openTutor(tutors.find(({name}) => TUTOR + name === value));
    return value.startsWith(LESSON) ? openLesson(lessons.find(value.slice(LESSON.length))) : openBuiltIn(value);
}

async function openLink() {
    const link = new URLSearchParams(location.hash.slice(1));
    const lesson = lessons.find(link.get("lesson"));
    if (lesson) return openLesson(lesson);
    const wanted = tutors.find(({name}) => name === link.get("tutor"));
    if (wanted) return openTutor(wanted);
    try {
        if (link.has("text")) {
            const text = await textInLink(link.get("text"));
            lessons.hide();
            at("scenes").value = "";  // none of the list
            return await load("scene", text, {step: link.get("step") ?? "", size: sizeInLink(link)});
        }
    } catch {
        message("error", {line: 0, text: "this link holds no scene; copy it again"});
    }
    return openBuiltIn(link.get("scene"), link.get("step") ?? "");
}

// The option of a list so many places away; the first follows the last.
function neighbour(select, away) {
    const options = [...select.options], from = select.selectedIndex < 0 && away < 0 ? 0 : select.selectedIndex;
    return options.length > 0 ? options[(from + away + options.length) % options.length].value : "";
}

// What a key or a move of the mouse asks for.
function controlled({text, shown, message: said, scene, step, exports, keys, isMoving}) {
    at("said").textContent = said;
    if (keys) at("keys").open = !at("keys").open;
    if (exports) save("c", name, twinlight, editor.text);
    if (scene) return openMenu(neighbour(at("scenes"), scene));
    if (step && at("steps").options.length > 0) {
        at("steps").value = neighbour(at("steps"), step);
        return draw();
    }
    if (text === editor.text) return null;
    editor.set(text, {joins: isMoving});
    setStep(shown > 0 ? String(shown) : "");
    return draw();
}

// Whether a scene is open; first reads what was typed.
function ready() {
    if (pause) draw();
    return opened !== null;
}

function forgetProbe() {
    probe = null;
    hideArrows();
    for (const id of ["terms", "explanation"]) at(id).replaceChildren();
}

function explain(x, y) {
    if (!opened || !(x >= 0 && y >= 0 && x < opened.width && y < opened.height)) return;
    probe = [x, y];
    [at("x").value, at("y").value] = probe;
    showProbe(twinlight.probe(at("shading").value, x, y), opened);
    at("explanation").textContent = twinlight.explain(at("shading").value, x, y);
}

function setNumber(number, value) {
    if (ready()) controlled({...twinlight.setArgument(number, value), isMoving: true});
}
const numbers = new Numbers(at("numbers"), setNumber);
const tutor = new Tutor(twinlight, {ready, done: controlled, changed: setNumber});

const lessons = new Lessons(twinlight.lessons(language), {
    open: (text) => load(name, text),
    text: () => editor.text,
    check: (lesson, text) => workers.do({work: "check", given: {lesson: lesson.name, language, text, own: lesson.own}}, {soon: true, keep: true}),
    next: openLesson,
});

function group(label, options) {
    const made = document.createElement("optgroup");
    made.label = label;
    made.append(...options);
    return made;
}
at("scenes").append(group("Scenes", builtIn.map((scene) => new Option(scene.name))),
                    group("Tutors: one idea at a time", tutors.map(({name}) => new Option(name, TUTOR + name))),
                    group("Lessons", lessons.lessons.map(({name, title}) => new Option(title, LESSON + name))));
at("scenes").addEventListener("change", () => openMenu(at("scenes").value));
startGallery(at("all-scenes"), at("gallery"), builtIn, openBuiltIn);
at("steps").addEventListener("change", draw);
at("shading").addEventListener("change", draw);
at("link").addEventListener("click", async () => {
    history.replaceState(null, "", "#" + await sceneInLink(editor.text, builtIn, at("steps").value, window_size === WINDOW ? null : window_size));
    try {
        await navigator.clipboard.writeText(location.href);
    } catch {
        // The address bar has the link, too.
    }
});
at("save").addEventListener("click", () => save(at("form").value, name, twinlight, editor.text));
at("probe").addEventListener("submit", (event) => {
    event.preventDefault();
    explain(at("x").valueAsNumber, at("y").valueAsNumber);
});
at("undo").addEventListener("click", () => ready() && controlled(twinlight.press("z".charCodeAt(0))));
at("next-tutor").addEventListener("click", () => openTutor(tutors[(tutors.findIndex(({name}) => TUTOR + name === at("scenes").value) + 1) % tutors.length]));
at("whole-page").addEventListener("click", () => {
    setTutor(false);
    draw();
});
for (const canvas of document.querySelectorAll("figure canvas")) control(canvas, twinlight, {ready, done: controlled, click: explain});
showKeys(at("keys").querySelector("table"), twinlight.keys());
startSlider();
startTheme(at("theme"));
addEventListener("dragover", (event) => event.preventDefault());
addEventListener("drop", async (event) => {
    event.preventDefault();
    const files = [...event.dataTransfer.files];
    if (files.length === 0) return;
    try {
        // A teacher's own lesson.
        const page = files.find(({name}) => name.endsWith(".md"));
        if (page) {
            const own = await page.text();
            await openLesson({...twinlight.ownLesson(page.name.slice(0, -3), language, own), own});
            return;
        }
        const {name, text, size, beside} = await sceneIn(files, twinlight);
        for (const [file, bytes] of beside) twinlight.keepFile(file, bytes);
        if (beside.length > 0) {
            workers.keep(beside);
            ++keptFiles;
        }
        if (text === null) {
            await draw();
            at("said").textContent = `A scene can use ${beside.map(([file]) => file).join(", ")} now. For a picture: #pragma twinlight texture("${beside[0][0]}")`;
            return;
        }
        lessons.hide();
        at("scenes").value = "";
        await load(name, text, {size});
    } catch (error) {
        message("error", {line: 0, text: error.message});
    }
});
addEventListener("hashchange", openLink);

await openLink();
at("driver").textContent = renderer ? renderer.description() : "";
