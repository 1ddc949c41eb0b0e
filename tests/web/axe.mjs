// axe.mjs CHROMIUM AXE FOLDER: looks with axe-core for what keeps people from using the pages of FOLDER (views.mjs). Prints a JSON list of
// faults: [page, rule, element, what].
import fs from "node:fs";
import {Browser} from "./browser.mjs";
import {forEachView} from "./views.mjs";

const [program, axe, folder] = process.argv.slice(2);
const browser = await Browser.open(program, folder);
const library = fs.readFileSync(axe, "utf8"), faults = [];

await forEachView(browser, async (name) => {
    await browser.value(library + "; 0");
    const {violations} = await browser.value(`axe.run({runOnly: ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "best-practice"], resultTypes: ["violations"]})`);
    for (const {id, nodes} of violations)
        for (const {target, failureSummary} of nodes) faults.push([name, id, target.join(" "), failureSummary.split("\n").slice(1).join(" ").trim()]);
    // axe must have looked: a picture without a name is a fault.
    await browser.value(`(document.querySelector("dialog[open]") ?? document.body).prepend(new Image()), 0`);
    const {violations: planted} = await browser.value(`axe.run({runOnly: ["image-alt"]})`);
    if (planted.length !== 1) faults.push([name, "image-alt", "img", "axe does not find a picture without a name"]);
    await browser.value(`document.querySelector("img:not([alt])").remove()`);
});
console.log(JSON.stringify(faults, null, 1));
await browser.close();
