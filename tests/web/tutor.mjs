// tutor.mjs CHROMIUM PAGE: opens a tutor on the page, and prints a JSON object of what it did.
import {Browser} from "./browser.mjs";

const [program, page] = process.argv.slice(2);
const browser = await Browser.open(program, page);
const text = (id) => browser.value(`document.getElementById("${id}").textContent`);
const sceneText = () => browser.value(`document.querySelector(".CodeMirror").CodeMirror.getValue()`);
const number = (i) => `document.querySelectorAll("#calls input")[${i}]`;
const wait = () => browser.value("new Promise(requestAnimationFrame)");
const told = {};

// The first line that differs from the scene as it was opened; null if none does.
let before = "";
const changed = async () => (await sceneText()).split("\n").find((line, i) => line !== before.split("\n")[i]) ?? null;
async function opened(place) {
    await browser.visit("package.json");
    await browser.visit(place);
    await browser.until("document.body?.dataset.drawn", 60);
    before = await sceneText();
}
const click = (id) => browser.value(`document.getElementById("${id}").click()`);
const visible = (choice) => browser.value(`[...document.querySelectorAll("${choice}")].filter((one) => one.checkVisibility()).map(({id}) => id)`);
// Where GL_LIGHT0 is in the scene from outside, in pixels of the window.
const lamp = () => browser.value(`(() => {
    const label = [...document.querySelectorAll("#outside .labels span")].find(({textContent}) => textContent === "GL_LIGHT0");
    const canvas = document.getElementById("world"), box = canvas.getBoundingClientRect();
    return [box.x + label.dataset.x * box.width, box.y + label.dataset.y * box.height + 20 * box.height / canvas.height];
})()`);

try {
    await browser.size(1280, 800);
    await opened("#tutor=light");
    told.calls = await browser.value(`[...document.querySelectorAll("#calls div")].map((call) => [...call.children].map((part) => part.value ?? part.textContent).join(""))`);
    told.visible = await visible("canvas, header :is(button, select), .CodeMirror, #probe, #numbers, #verdict");
    told.names = await browser.value(`[...document.querySelectorAll("#calls input")].slice(0, 5).map(({ariaLabel}) => ariaLabel)`);

    // By a drag, by keys, and typed; then everything undone.
    await browser.value(`${number(0)}.id = "first", 0`);
    await browser.drag("first", 50);
    told.dragged = await changed();
    await browser.value(`${number(0)}.focus()`);
    told.meanings = [await text("meaning")];
    for (const kind of ["enter", "leave"]) {
        await browser.value(`document.querySelector("#calls .name").dispatchEvent(new PointerEvent("pointer${kind}")), 0`);
        told.meanings.push(await text("meaning"));
    }
    await browser.key("ArrowUp");
    told.key = await changed();
    await browser.value(`${number(2)}.focus(), ${number(2)}.select()`);
    for (const key of "7.5") await browser.key(key);
    told.typed = [await changed(), await browser.value(`${number(2)}.value`)];
    await browser.value(`document.activeElement.blur()`);
    for (let i = 0; i < 6 && await changed() !== null; ++i) await click("undo");
    told.undone = [await changed(), await browser.value(`${number(0)}.value`)];

    // A light in the scene from outside, then its view.
    const mouse = (type, [x, y], buttons) => browser.send("Input.dispatchMouseEvent", {type, x, y, button: "left", buttons, clickCount: 1});
    const drag = async ([x, y]) => {
        await mouse("mousePressed", [x, y], 1);
        await mouse("mouseMoved", [x + 40, y - 20], 1);
        await wait();
        await mouse("mouseReleased", [x + 40, y - 20], 0);
    };
    const world = () => browser.value(`document.getElementById("world").toDataURL()`);
    const from = await lamp();
    await drag(from);
    const to = await lamp();
    told.light = [await changed(), to.map((place, i) => Math.round(place - from[i]))];
    await click("undo");
    const still = await world();
    await drag(await browser.value(`(({x, y}) => [x + 10, y + 10])(document.getElementById("world").getBoundingClientRect())`));
    const turned = await world();
    await browser.value(`document.getElementById("world").focus()`);
    await browser.key("ArrowLeft");
    told.view = [await changed(), turned !== still, await world() !== turned];

    // On a phone, and out of it.
    await browser.size(360, 800);
    told.tooWide = await browser.value("document.documentElement.scrollWidth - document.documentElement.clientWidth");
    // A finger drags a number sideways; up and down, it scrolls the page.
    await browser.send("Emulation.setTouchEmulationEnabled", {enabled: true});
    await browser.value(`${number(0)}.id = "first", 0`);
    const swipe = async (dx, dy) => {
        const [x, y] = await browser.middle("first"), scrolled = await browser.value("scrollY");
        for (const step of [0, 0.2, 0.4, 0.6, 0.8, 1])
            await browser.send("Input.dispatchTouchEvent", {type: step === 0 ? "touchStart" : "touchMove", touchPoints: [{x: x + dx * step, y: y + dy * step}]});
        await wait();
        await browser.send("Input.dispatchTouchEvent", {type: "touchEnd", touchPoints: []});
        return [await changed(), await browser.value("scrollY") - scrolled];
    };
    told.swipes = [await swipe(30, 0)];
    await click("undo");
    told.swipes.push(await swipe(0, -60));
    await browser.send("Emulation.setTouchEmulationEnabled", {enabled: false});
    told.all = [];
    for (let i = 0; i < 5; ++i) {
        await click("next-tutor");
        told.all.push([await browser.value(`document.getElementById("scenes").value`), await browser.value(`document.querySelectorAll("#calls div").length`)]);
    }
    await browser.value(`delete document.body.dataset.drawn, 0`);
    await click("whole-page");
    await browser.until("document.body.dataset.drawn", 60);
    told.whole = [await visible("#calls, .CodeMirror, #numbers"), await text("verdict")];
    await opened("#tutor=spot");
    await browser.value(`document.getElementById("scenes").value = "lesson:shininess", document.getElementById("scenes").dispatchEvent(new Event("change"))`);
    told.lesson = await visible("#calls, #lesson");
    told.complaints = await browser.said();
    console.log(JSON.stringify(told));
} finally {
    await browser.close();
}
