// webgpu.mjs FOLDER CHROMIUM: opens index.html of each folder in FOLDER, which draws a scene with WebGPU, and gives the texts of
// FOLDER/texts.json to WebGPU's compiler. Prints a JSON object: {"pictures": {folder: toDataURL() or the error}, "refused": [message]}; without
// WebGPU only {"missing": why}.
import fs from "node:fs";
import path from "node:path";
import {Browser} from "./browser.mjs";

const [folder, program] = process.argv.slice(2);
const texts = JSON.parse(fs.readFileSync(path.join(folder, "texts.json"), "utf8"));
// SwiftShader is Chromium's Vulkan without a GPU.
const browser = await Browser.open(program, folder,
    ["--enable-unsafe-webgpu", "--use-webgpu-adapter=swiftshader", "--enable-features=Vulkan", "--use-vulkan=swiftshader"]);
const told = {pictures: {}, refused: []};

const REFUSED = (texts) => `(async () => {
    const device = await (await navigator.gpu.requestAdapter()).requestDevice();
    device.pushErrorScope("validation");
    const infos = await Promise.all(${JSON.stringify(texts)}.map((code) => device.createShaderModule({code}).getCompilationInfo()));
    await device.popErrorScope();
    return infos.flatMap(({messages}, text) => messages.map(({message, lineNum}) => "text " + text + ", line " + lineNum + ": " + message));
})()`;
const PICTURE = `(async () => {
    const draw = await loaded, error = document.getElementById("error");
    draw();
    const url = document.getElementById("picture").toDataURL();
    return error.textContent || url;
})()`;

try {
    const folders = fs.readdirSync(folder, {withFileTypes: true}).filter((one) => one.isDirectory()).map(({name}) => name);
    await browser.visit(folders[0] + "/index.html");
    if (!await browser.value(`navigator.gpu?.requestAdapter().then(Boolean) ?? false`)) {
        told.missing = "this Chromium has no WebGPU without a GPU";
    } else {
        told.refused = await browser.value(REFUSED(texts));
        for (const one of folders) {
            await browser.visit(one + "/index.html");
            await browser.until(`document.readyState === "complete"`);
            told.pictures[one] = await browser.value(PICTURE);
        }
    }
} catch (error) {
    told.error = String(error.stack);
}
await browser.close();
console.log(JSON.stringify(told));
