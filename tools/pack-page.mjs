// pack-page.mjs PAGE OUT: writes the page of the folder PAGE as one file, which a browser opens without a server: scripts and styles are
// inside, and each other file, compressed and in base64, is a <script> that own_files.js reads.
import {execFileSync} from "node:child_process";
import crypto from "node:crypto";
import fs from "node:fs";
import zlib from "node:zlib";

const [page, out] = process.argv.slice(2);
const TYPES = {".wasm": "application/wasm", ".js": "text/javascript", ".json": "application/json"};

function fail(message) {
    console.error(`tools/pack-page.mjs: ${message}`);
    process.exit(1);
}
const read = (name) => fs.readFileSync(`${page}/${name}`, "utf8");

// A module with all that it imports, as a module or as a script.
function bundled(name, form) {
    try {
        return execFileSync("esbuild", [`${page}/${name}`, "--bundle", '--define:import.meta.url=""', `--format=${form}`, "--target=es2022", "--log-level=warning"],
            {encoding: "utf8", stdio: ["ignore", "pipe", "inherit"], maxBuffer: 1 << 26});
    } catch (error) {
        return fail(error.code === "ENOENT" ? "esbuild is not installed (Debian's package esbuild)" : `esbuild cannot bundle ${name}`);
    }
}
const part = (name, bytes) => `<script type="text/plain" id="file ${name}" data-type="${TYPES[/\.\w+$/.exec(name)?.[0]] ?? "application/octet-stream"}">` +
    `${zlib.deflateRawSync(bytes, {level: 9}).toString("base64")}</script>\n`;

let html = read("index.html");
// Replaces each place of this form, which must exist.
function replace(form, what, made) {
    if (!form.test(html)) fail(`index.html has no ${what}`);
    html = html.replace(form, (...found) => made(...found));
}
const hashes = {script: [], style: []};
function inline(kind, attributes, text) {
    if (new RegExp(`</${kind}`, "i").test(text)) fail(`a ${kind} of index.html has </${kind}`);
    hashes[kind].push(`'sha256-${crypto.createHash("sha256").update(text).digest("base64")}'`);
    return `<${kind}${attributes}>${text}</${kind}>`;
}

replace(/<link rel="stylesheet" href="([^"]+)">/g, "style sheet", (_, name) => inline("style", "", read(name)));
replace(/<script type="module" src="([^"]+)"><\/script>/g, "module", (_, name) => inline("script", ' type="module"', bundled(name, "esm")));
replace(/<script src="([^"]+)"><\/script>/g, "script", (_, name) => inline("script", "", read(name)));

const inside = [part("module.wasm", fs.readFileSync(`${page}/module.wasm`)), part("worker.js", bundled("worker.js", "iife")), ...["mesa.json", "scenes.json"].map((name) => part(name, read(name)))];
for (const name of JSON.parse(read("mesa.json"))) inside.push(part("mesa/" + name, fs.readFileSync(`${page}/mesa/${name}`)));
// Before start.js, which looks for them.
replace(/<\/main>/, "</main>", (found) => found + "\n" + inside.join(""));

// Only what is inside may run.
replace(/(http-equiv="Content-Security-Policy" content=")[^"]*"/, "Content-Security-Policy", (_, front) => front +
    `default-src 'none'; script-src ${hashes.script.join(" ")} 'wasm-unsafe-eval'; style-src ${hashes.style.join(" ")}; worker-src blob:; ` +
    `img-src data:; base-uri 'none'; form-action 'none'"`);
replace(/<title>/, "title", (found) => `<!-- Twinlight's page as one file, by tools/pack-page.mjs. It contains CodeMirror:\n${read("codemirror/copyright").replaceAll("--", "- -")}-->\n` + found);
fs.writeFileSync(out, html);
