// page.mjs CHROMIUM PAGE JOBS: opens the page in Chromium and prints a JSON object: what the page did ("page"), and how the pictures of
// JOBS by its shaders compare with the reference ("pictures").
import fs from "node:fs";
import {Browser} from "./browser.mjs";

const [program, page, jobs] = process.argv.slice(2);
const browser = await Browser.open(program, page);
const text = (id) => browser.value(`document.getElementById("${id}").textContent`);
// Types into the editor, and waits for the pictures or the errors.
const typed = async (scene) => {
    await browser.value(`delete document.body.dataset.drawn, document.getElementById("messages").replaceChildren(), document.getElementById("text").value = ${JSON.stringify(scene)},
        document.getElementById("text").dispatchEvent(new Event("input")), 0`);
    await browser.until(`document.body.dataset.drawn || document.querySelector("#messages .error")`);
};
const told = {};
try {
    browser.complaints = [];
    browser.requests = [];
    await browser.size(360, 800, true);
    await browser.visit("#scene=spotlight");
    await browser.until("document.body?.dataset.drawn", 60);
    told.verdict = await text("verdict");
    told.tooWide = await browser.value("document.documentElement.scrollWidth - document.documentElement.clientWidth");
    await browser.value(`document.getElementById("probe").requestSubmit()`);
    told.explanation = await text("explanation");
    await typed("glClear(GL_COLOR_BUFFER_BIT);\nglRectf(0, 0, 1, 1);\nglFoo(<img src=x>);\n");
    told.error = await text("messages");
    told.markup = await browser.value(`document.querySelectorAll("#messages img").length`);
    await typed("glColor3f(1, 0, 0);\nglRectf(-1, -1, 1, 1);\n");
    told.mended = await browser.value(`[...document.getElementById("shaders").getContext("2d").getImageData(320, 240, 1, 1).data]`);
    told.link = await browser.value(`(document.getElementById("link").click(), new Promise((resolve) => setTimeout(() => resolve(location.hash), 500)))`);
    told.requests = browser.requests.filter((url) => !url.startsWith("chrome:"));
    // Chromium notes that reading a picture back is slow.
    told.complaints = browser.complaints.filter((text) => !text.includes("GPU stall due to ReadPixels"));

    // In a page without the editor, so that the pictures are the only work.
    await browser.visit("package.json");
    const pictures = await browser.value(`(async () => {
        const [{loadTwinlight}, {Renderer}] = await Promise.all([import("/twinlight.js"), import("/gl.js")]);
        const twinlight = await loadTwinlight(), renderer = new Renderer(), pictures = [];
        for (const job of ${fs.readFileSync(jobs, "utf8")}) {
            const answer = twinlight.open(job);
            if (answer.errors.length > 0) continue;
            for (const shading of job.shadings) {
                const picture = {name: job.name, step: job.step, shading};
                try {
                    const frame = twinlight.webglFrame(shading);
                    picture.missing = frame.header.missing.map(({message}) => message);
                    picture.judged = twinlight.judge(shading, renderer.draw(frame), renderer.subpixelBits);
                } catch (error) {
                    picture.error = String(error);
                }
                pictures.push(picture);
            }
        }
        return pictures;
    })()`);
    console.log(JSON.stringify({page: told, pictures}));
} finally {
    await browser.close();
}
