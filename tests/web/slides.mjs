// slides.mjs FOLDER CHROMIUM: gives the lecture, by file:. Prints a JSON object of what it showed.
import path from "node:path";
import {pathToFileURL} from "node:url";
import {Browser} from "./browser.mjs";

const [folder, program] = process.argv.slice(2);
const browser = await Browser.open(program, folder);
const told = {};
const key = (name) => browser.value(`document.body.dispatchEvent(new KeyboardEvent("keydown", {key: "${name}", bubbles: true, cancelable: true})), 0`);
const shown = (selector) => browser.value(`[...document.querySelectorAll("${selector}")].filter((one) => one.checkVisibility()).map((one) => one.textContent.trim())`);
// file: pages cannot look into each other, so the scene's page is opened by itself.
async function lit_pixels(address) {
    await browser.visit(address);
    for (const end = Date.now() + 60000; !(await browser.value(`document.querySelector("canvas")?.width > 0 && document.readyState === "complete"`));) {
        if (Date.now() > end) throw new Error("the scene's page does not load");
        await new Promise((resolve) => setTimeout(resolve, 20));
    }
    return browser.value(`(() => {
        const canvas = document.querySelector("canvas"), {data} = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
        const colors = new Set();
        for (let i = 0; i < data.length; i += 4) colors.add(data[i] << 16 | data[i + 1] << 8 | data[i + 2]);
        return [colors.size, [...document.querySelectorAll("header, #lights, .aside")].some((one) => one.checkVisibility()), document.getElementById("step").value];
    })()`);
}

try {
    const opened = async (page, hash = "") => {
        await browser.visit("about:blank");
        await browser.visit(pathToFileURL(path.resolve(folder, page)).href + hash);
        for (const end = Date.now() + 60000; !(await browser.value(`document.getElementById("place")?.textContent`));) {
            if (Date.now() > end) throw new Error("no slide is shown");
            await new Promise((resolve) => setTimeout(resolve, 20));
        }
    };
    for (const page of ["index.html", "zh.html"]) {
        await opened(page);
        const titles = [], crowded = [];
        const count = await browser.value(`document.querySelectorAll("section").length`);
        for (let i = 0; i < count; ++i) {
            titles.push((await shown("h1, h2, h3")).join("|"));
            const [height, room] = await browser.value(`(() => {
                const slide = [...document.querySelectorAll("section")].find((one) => !one.hidden);
                return [slide.scrollHeight * slide.style.zoom, document.querySelector("main").clientHeight];
            })()`);
            if (height > room + 2) crowded.push(titles.at(-1));
            await key("ArrowRight");
        }
        told[page] = {titles, crowded, place: (await shown("#place"))[0]};
    }
    await opened("index.html", "#4");
    told.before = [(await shown("h3"))[0], (await shown("aside")).length, (await shown("iframe")).length, (await shown("img")).length];
    const source = await browser.value(`document.querySelector("section:not([hidden]) iframe").src`);
    await key("n");
    told.notes = (await shown("aside")).join(" ");
    await key("v");
    told.pictures = [(await shown("iframe")).length, (await shown("img")).length];
    told.complaints = await browser.said();
    told.scene = await lit_pixels(source.replace("step=1", "step=3"));
    console.log(JSON.stringify(told));
} finally {
    await browser.close();
}
