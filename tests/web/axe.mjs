// axe.mjs CHROMIUM AXE FOLDER: looks with axe-core for what keeps people from using the pages of FOLDER: page/ (the page for browsers),
// export.html and report/index.html, in both themes and in two sizes. Prints a JSON list of faults: [page, rule, element, what].
import fs from "node:fs";
import {Browser} from "./browser.mjs";

const [program, axe, folder] = process.argv.slice(2);
const browser = await Browser.open(program, folder);
const library = fs.readFileSync(axe, "utf8"), faults = [];

async function look(name) {
    await browser.value(library + "; 0");
    const {violations} = await browser.value(`axe.run({runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "best-practice"], resultTypes: ["violations"]})`);
    for (const {id, nodes} of violations)
        for (const {target, failureSummary} of nodes) faults.push([name, id, target.join(" "), failureSummary.split("\n").slice(1).join(" ").trim()]);
    // axe must have looked: a picture without a name is a fault.
    await browser.value(`(document.querySelector("dialog[open]") ?? document.body).prepend(new Image()), 0`);
    const {violations: planted} = await browser.value(`axe.run({runOnly: ["image-alt"]})`);
    if (planted.length !== 1) faults.push([name, "image-alt", "img", "axe does not find a picture without a name"]);
    await browser.value(`document.querySelector("img:not([alt])").remove()`);
}

for (const [width, height, dark] of [[1280, 800, true], [390, 844, false]]) {
    const where = `${dark ? "dark" : "light"}, ${width} pixels`;
    await browser.size(width, height, dark);
    await browser.visit("page/index.html#scene=terms");
    await browser.until("document.body?.dataset.drawn", 60);
    await browser.value(`document.getElementById("probe").requestSubmit(), document.getElementById("keys").open = true`);
    await look(`the page, ${where}`);
    await browser.value(`document.getElementById("all-scenes").click()`);
    await browser.until(`document.querySelector("#gallery img")?.complete`);
    await look(`the page's list of scenes, ${where}`);
    await browser.value(`document.getElementById("gallery").close(), delete document.body.dataset.drawn`);
    await browser.visit("page/index.html#lesson=shininess");
    await browser.until(`!document.getElementById("lesson").hidden && document.body.dataset.drawn`, 60);
    await look(`a lesson, ${where}`);
    await browser.visit("export.html");
    await browser.until(`document.readyState === "complete" && document.querySelector("#lights button")`, 60);
    await look(`an exported page, ${where}`);
    await browser.visit("report/index.html");
    await browser.until(`document.readyState === "complete" && document.querySelector("h1")`, 60);
    await look(`a report, ${where}`);
}
console.log(JSON.stringify(faults, null, 1));
await browser.close();
