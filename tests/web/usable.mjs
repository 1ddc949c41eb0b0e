// usable.mjs CHROMIUM FOLDER: looks for what keeps people from using the pages of FOLDER (views.mjs): text with little contrast, controls
// without a name, those that the keyboard does not reach or whose focus is not seen, and clicks that no key replaces. Prints a JSON
// object: the faults, [page, fault, element] each, and those that it finds where they were planted.
import {Browser} from "./browser.mjs";
import {forEachView} from "./views.mjs";

const [program, folder] = process.argv.slice(2);
const browser = await Browser.open(program, folder);

// In the page.
const LOOKS = `(() => {
    // Red, green, blue from 0 to 255, and alpha, of a CSS colour.
    const canvas = document.createElement("canvas").getContext("2d", {willReadFrequently: true});
    const channels = (color) => {
        canvas.clearRect(0, 0, 1, 1);
        canvas.fillStyle = color;
        canvas.fillRect(0, 0, 1, 1);
        const [red, green, blue, alpha] = canvas.getImageData(0, 0, 1, 1).data;
        return [red, green, blue, alpha / 255];
    };
    const over = ([...top], below) => [0, 1, 2].map((i) => top[3] * top[i] + (1 - top[3]) * below[i]);
    const background = (element) => element ? over(channels(getComputedStyle(element).backgroundColor), background(element.parentElement)) : [255, 255, 255];
    const luminance = (color) => color.map((value) => value / 255).map((value) => value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4)
        .reduce((sum, value, i) => sum + [0.2126, 0.7152, 0.0722][i] * value, 0);
    const contrast = (color, ground) => {
        const [low, high] = [luminance(over(channels(color), ground)), luminance(ground)].sort((a, b) => a - b);
        return (high + 0.05) / (low + 0.05);
    };
    const where = () => document.querySelector("dialog[open]") ?? document.body;
    const is_seen = (element) => element.checkVisibility({visibilityProperty: true}) && element.getClientRects().length > 0;
    const described = (element) => element.tagName.toLowerCase() + (element.id ? "#" + element.id : "") + " " + (element.innerText ?? "").trim().slice(0, 40);
    const shown = new Map();  // the rings of the controls without the focus
    const CONTROLS = "button:enabled, select:enabled, input:enabled, textarea:enabled, a[href], summary, [tabindex='0']";

    globalThis.looks = {
        // WCAG 2.1, 1.4.3.
        contrasts() {
            const faults = [], texts = document.createTreeWalker(where(), NodeFilter.SHOW_TEXT);
            while (texts.nextNode()) {
                const element = texts.currentNode.parentElement;
                if (!texts.currentNode.data.trim() || !is_seen(element) || element.closest("script, style, svg, .labels, option, :disabled")) continue;
                const style = getComputedStyle(element), pixels = parseFloat(style.fontSize);
                const least = pixels >= 24 || (pixels >= 18.6 && Number(style.fontWeight) >= 700) ? 3 : 4.5;
                const found = contrast(style.color, background(element));
                if (found < least) faults.push([\`contrast \${found.toFixed(2)}\`, described(element)]);
            }
            return faults;
        },
        // The controls in their order; the editor is one.
        controls() {
            const all = [...where().querySelectorAll(CONTROLS)].filter((element) => is_seen(element) && !element.closest(".CodeMirror") && element.tabIndex >= 0);
            document.activeElement?.blur();
            shown.clear();
            for (const element of all) shown.set(element, looks.ring(element));
            return all.map(described);
        },
        // So that the next Tab goes to the first of them.
        begin() {
            const start = document.createElement("span");
            start.tabIndex = -1;
            where().prepend(start);
            start.focus();
            start.remove();
        },
        ring(element) {
            const {outlineStyle, outlineWidth, outlineColor, boxShadow} = getComputedStyle(element);
            return JSON.stringify([outlineStyle !== "none" && outlineWidth, outlineColor, boxShadow]);
        },
        focused() {
            const element = document.activeElement;
            if (element === document.body || !element) return null;
            if (element.closest(".CodeMirror")) return {is_editor: true};
            const style = getComputedStyle(element), ground = background(element.parentElement);
            const is_ring = style.outlineStyle !== "none" && parseFloat(style.outlineWidth) >= 1 && contrast(style.outlineColor, ground) >= 3;
            const box = element.getBoundingClientRect();
            return {what: described(element), is_ring: is_ring && looks.ring(element) !== shown.get(element), is_inside: box.bottom > 0 && box.top < innerHeight};
        },
    };
})()`;

// Roles whose elements must have a name.
const NAMED = new Set(["button", "combobox", "listbox", "textbox", "spinbutton", "slider", "checkbox", "link", "image", "img", "dialog", "region", "DisclosureTriangle", "Canvas"]);

async function namelessControls() {
    const {nodes} = await browser.send("Accessibility.getFullAXTree");
    return nodes.filter(({ignored, role, name}) => !ignored && NAMED.has(role?.value) && !name?.value?.trim()).map(({role}) => ["without a name", role.value]);
}

// Elements with a click that are neither controls nor parts of one.
async function clicksWithoutKeys() {
    const {result: {objectId}} = await browser.send("Runtime.evaluate", {expression: "document.body"});
    const {listeners} = await browser.send("DOMDebugger.getEventListeners", {objectId, depth: -1});
    const faults = [];
    for (const {backendNodeId} of listeners.filter(({type}) => ["click", "mousedown", "pointerdown"].includes(type))) {
        const {object} = await browser.send("DOM.resolveNode", {backendNodeId});
        const {result} = await browser.send("Runtime.callFunctionOn", {objectId: object.objectId, returnByValue: true, functionDeclaration:
            `function () { return this.closest?.("button, select, input, a, summary, label, [tabindex='0'], .CodeMirror, dialog") ? null : this.tagName + "#" + this.id; }`});
        if (result.value) faults.push(["a click without a key", result.value]);
    }
    return faults;
}

// Presses Tab until the focus comes round.
async function tabs() {
    const wanted = await browser.value("looks.controls()"), found = [], faults = [];
    await browser.value("looks.begin()");
    for (let i = 0; i < 2 * wanted.length + 20 && found.length < wanted.length; ++i) {
        await browser.key("Tab");
        const focused = await browser.value("looks.focused()");
        if (!focused || focused.is_editor) continue;
        found.push(focused.what);
        if (!focused.is_ring) faults.push(["no focus is seen", focused.what]);
        if (!focused.is_inside) faults.push(["the focus is outside the window", focused.what]);
    }
    if (JSON.stringify(found) !== JSON.stringify(wanted)) faults.push(["Tab goes another way", found.find((one, i) => one !== wanted[i]) ?? wanted[found.length]]);
    return faults;
}

async function look() {
    await browser.value(LOOKS);
    return [...await browser.value("looks.contrasts()"), ...await namelessControls(), ...await clicksWithoutKeys(), ...await tabs()];
}

try {
    await browser.send("Accessibility.enable");
    await browser.send("DOM.enable");
    await browser.send("DOM.getDocument");
    const faults = [];
    await forEachView(browser, async (name) => faults.push(...(await look()).map((fault) => [name, ...fault])));
    // The last page with a fault of each kind.
    await browser.value(`document.body.insertAdjacentHTML("afterbegin", "<p style='color: #999; background: #fff'>grey</p><button></button>" +
        "<button tabindex=1>first</button><button style='outline: none'>dim</button><div id=clicked>click</div>"), document.getElementById("clicked").onclick = () => {}`);
    console.log(JSON.stringify({faults, planted: (await look()).map(([fault]) => fault)}, null, 1));
} finally {
    await browser.close();
}
