// Makes slides of the lecture: one for each heading. On a slide stand the formula, the picture and the question; the commands, what to
// notice and the answer are the speaker's notes (key n). A scene that a browser can draw is live: drag it. Key v shows the pictures instead.
const live = new Set(document.body.dataset.live.split(" ").filter(Boolean));
const main = document.querySelector("main");

// The scene and the step that a slide's commands name: "build/twinlight-demo terms --step 2".
function scene_of(slide) {
    const command = /build\/twinlight(?:-demo| compare| render| explain| scenes)? ([a-z-]+)((?: [^`\n]*)?)/g;
    for (const [, name, rest] of slide.textContent.matchAll(command)) {
        const step = / --step (?:"([^"]+)"|(\d+))/.exec(rest);
        if (live.has(name)) return {name, step: step?.[1] ?? step?.[2] ?? "1"};
    }
}

const is_commands = (element) => element.matches("table") && /^(commands|run|命令|运行)/.test(element.querySelector("tbody td")?.textContent ?? "");
const is_run = (element) => /^(build\/twinlight|Run:|运行)/.test(element.textContent.trim());
const is_notice = (element) => /^(Notice|注意)/.test(element.textContent);

function slide_of(elements) {
    const slide = document.createElement("section"), notes = document.createElement("aside");
    slide.append(...elements);
    for (const element of [...slide.children]) {
        if (is_commands(element) || (element.matches("p, pre") && is_run(element)) || is_notice(element) || element.matches("details")) notes.append(element);
    }
    for (const answer of notes.querySelectorAll("details")) answer.open = true;
    // Links lead to pages that are not here.
    for (const link of [...slide.querySelectorAll("a[href]"), ...notes.querySelectorAll("a[href]")])
        if (!/^https?:/.test(link.getAttribute("href"))) link.replaceWith(...link.childNodes);
    const scene = scene_of(notes) ?? scene_of(slide), picture = [...slide.children].find((one) => one.querySelector("img"));
    if (scene && picture) {
        const frame = document.createElement("iframe");
        frame.title = scene.name;
        frame.dataset.source = `scenes/${scene.name}.html#bare&step=${scene.step}`;
        picture.classList.add("still");
        picture.after(frame);
        // Pictures side by side are a comparison: they stay until the speaker wants the scene.
        slide.classList.toggle("is-live", !picture.matches("table"));
    }
    if (notes.childNodes.length) slide.append(notes);
    return slide;
}

const groups = [];
for (const element of [...main.children]) {
    if (!groups.length || element.matches("h1, h2, h3")) groups.push([]);
    groups.at(-1).push(element);
}
const slides = groups.map(slide_of);
main.replaceChildren(...slides);

let now = 0;
function show(number) {
    now = Math.max(0, Math.min(slides.length - 1, number));
    slides.forEach((slide, i) => {
        slide.hidden = i !== now;
        // One live picture at a time: a browser has few contexts.
        const frame = slide.querySelector("iframe");
        if (frame && i === now && slide.classList.contains("is-live")) frame.src = frame.dataset.source;
        else frame?.removeAttribute("src");
    });
    fit();
    document.getElementById("live").hidden = !slides[now].querySelector("iframe");
    document.getElementById("place").textContent = `${now + 1} / ${slides.length}`;
    history.replaceState(null, "", "#" + (now + 1));
    document.getElementById("other").hash = now + 1;
}
// A slide with much on it is drawn smaller.
function fit() {
    const slide = slides[now], room = main.getBoundingClientRect().height;
    slide.style.zoom = 1;
    for (let zoom = 0.95; zoom > 0.3 && slide.scrollHeight * slide.style.zoom > room + 1; zoom -= 0.05) slide.style.zoom = zoom;
}
function show_live() {
    slides[now].classList.toggle("is-live");
    show(now);
}
function show_notes() {
    const is_on = document.body.classList.toggle("with-notes");
    document.getElementById("notes").ariaPressed = String(is_on);
    fit();
}
document.getElementById("back").addEventListener("click", () => show(now - 1));
document.getElementById("next").addEventListener("click", () => show(now + 1));
document.getElementById("notes").addEventListener("click", show_notes);
document.getElementById("live").addEventListener("click", show_live);
window.addEventListener("resize", fit);
for (const picture of document.images) picture.addEventListener("load", fit);
document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const keys = {ArrowRight: 1, PageDown: 1, " ": 1, ArrowLeft: -1, PageUp: -1};
    if (event.key in keys && !event.target.closest("button, a")) {
        event.preventDefault();
        show(now + keys[event.key]);
    } else if (event.key === "Home") show(0);
    else if (event.key === "End") show(slides.length - 1);
    else if (event.key === "n") show_notes();
    else if (event.key === "v") show_live();
});
window.addEventListener("hashchange", () => show(parseInt(location.hash.slice(1)) - 1 || 0));
// On paper, all slides with their notes.
window.addEventListener("beforeprint", () => slides.forEach((slide) => slide.hidden = false));
window.addEventListener("afterprint", () => show(now));
if (document.documentElement.lang === "zh") [document.getElementById("notes").textContent, document.getElementById("live").textContent] = ["讲稿", "场景"];
show(parseInt(location.hash.slice(1)) - 1 || 0);
