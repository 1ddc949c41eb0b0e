// A page in a Chromium without a window, driven by the protocol of its developer tools through a pipe, as Node alone can.
import {spawn} from "node:child_process";
import fs from "node:fs";
import http from "node:http";
import os from "node:os";
import path from "node:path";

const TYPES = {".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".wasm": "application/wasm", ".json": "application/json"};

// A static host for one folder, as any other.
function served(folder) {
    const server = http.createServer((request, response) => {
        const name = new URL(request.url, "http://localhost").pathname;
        const file = path.join(folder, name === "/" ? "index.html" : path.normalize(name));
        fs.readFile(file, (error, bytes) => {
            response.writeHead(error ? 404 : 200, {"Content-Type": TYPES[path.extname(file)] ?? "application/octet-stream"});
            response.end(error ? "" : bytes);
        });
    });
    return new Promise((resolve) => server.listen(0, "127.0.0.1", () => resolve(server)));
}

export class Browser {
    // `options`: more of Chromium's.
    static async open(program, folder, options = []) {
        const browser = new Browser();
        browser.server = await served(folder);
        browser.profile = fs.mkdtempSync(path.join(os.tmpdir(), "twinlight-"));
        browser.process = spawn(program, ["--headless", "--no-sandbox", "--no-first-run", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
            "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE 127.0.0.1", `--user-data-dir=${browser.profile}`, "--remote-debugging-pipe", "--js-flags=--expose-gc",
            ...options],
            {stdio: ["ignore", "ignore", "ignore", "pipe", "pipe"]});
        browser.waiting = new Map();
        browser.complaints = [];
        browser.requests = [];
        browser.next = 0;
        let rest = "";
        browser.process.stdio[4].setEncoding("utf8").on("data", (text) => {
            const parts = (rest + text).split("\0");
            rest = parts.pop();
            parts.forEach((part) => browser.receive(JSON.parse(part)));
        });
        const {targetInfos} = await browser.send("Target.getTargets");
        const {targetId} = targetInfos.find(({type}) => type === "page");
        browser.session = (await browser.send("Target.attachToTarget", {targetId, flatten: true})).sessionId;
        for (const domain of ["Runtime", "Log", "Page", "Network"]) await browser.send(domain + ".enable");
        return browser;
    }

    send(method, params = {}) {
        const id = this.next++;
        this.process.stdio[3].write(JSON.stringify({id, method, params, sessionId: this.session}) + "\0");
        return new Promise((resolve, reject) => this.waiting.set(id, {resolve, reject}));
    }
    receive({id, method, params, result, error}) {
        if (id !== undefined) {
            const {resolve, reject} = this.waiting.get(id);
            this.waiting.delete(id);
            return error ? reject(new Error(error.message)) : resolve(result);
        }
        if (method === "Runtime.exceptionThrown") this.complaints.push(params.exceptionDetails.exception?.description ?? params.exceptionDetails.text);
        if (method === "Runtime.consoleAPICalled") this.complaints.push(params.args.map((arg) => arg.value ?? arg.description).join(" "));
        if (method === "Log.entryAdded") this.complaints.push(params.entry.text);
        if (method === "Network.requestWillBeSent") this.requests.push(params.request.url);
    }

    // A place in the folder, or an address.
    async visit(place = "") {
        await this.send("Page.navigate", {url: new URL(place, `http://127.0.0.1:${this.server.address().port}/`).href});
    }
    // The value of an expression in the page, awaited.
    async value(expression) {
        const {result, exceptionDetails} = await this.send("Runtime.evaluate", {expression, awaitPromise: true, returnByValue: true});
        if (exceptionDetails) throw new Error(exceptionDetails.exception?.description ?? exceptionDetails.text);
        return result.value;
    }
    // What the page complained about.
    async said() {
        // Chromium notes that reading a picture back is slow, as tests do.
        return this.complaints.filter((text) => !text.includes("GPU stall due to ReadPixels") && !text.includes("willReadFrequently"));
    }
    // Waits until the expression is true.
    async until(expression, seconds = 30) {
        for (const end = Date.now() + 1000 * seconds; !(await this.value(`Boolean(${expression})`));) {
            if (Date.now() > end) throw new Error("never true: " + expression);
            await new Promise((resolve) => setTimeout(resolve, 20));
        }
    }
    // A key as a user presses it: "1", "ArrowLeft".
    async key(key) {
        const text = key.length === 1 ? {text: key} : key === "Tab" ? {windowsVirtualKeyCode: 9} : {};
        await this.send("Input.dispatchKeyEvent", {type: "keyDown", key, ...text});
        await this.send("Input.dispatchKeyEvent", {type: "keyUp", key});
    }
    // Drags from the middle of an element by so many pixels, or clicks there.
    async drag(id, dx = 0, dy = 0) {
        const [x, y] = await this.middle(id);
        const mouse = (type, x, y, buttons) => this.send("Input.dispatchMouseEvent", {type, x, y, button: "left", buttons, clickCount: 1});
        await mouse("mousePressed", x, y, 1);
        if (dx || dy) await mouse("mouseMoved", x + dx, y + dy, 1);
        if (dx || dy) await this.value("new Promise(requestAnimationFrame)");
        await mouse("mouseReleased", x + dx, y + dy, 0);
    }
    async wheel(id, deltaY) {
        const [x, y] = await this.middle(id);
        await this.send("Input.dispatchMouseEvent", {type: "mouseWheel", x, y, deltaX: 0, deltaY});
    }
    middle(id) {
        return this.value(`(() => {
            const element = document.getElementById(${JSON.stringify(id)});
            element.scrollIntoView({block: "center"});
            const box = element.getBoundingClientRect();
            return [Math.round(box.x + box.width / 2), Math.round(box.y + box.height / 2)];
        })()`);
    }

    async screenshot(file) {
        fs.writeFileSync(file, Buffer.from((await this.send("Page.captureScreenshot")).data, "base64"));
    }
    size(width, height, dark = false) {
        return Promise.all([
            this.send("Emulation.setDeviceMetricsOverride", {width, height, deviceScaleFactor: 1, mobile: false}),
            this.send("Emulation.setEmulatedMedia", {features: [{name: "prefers-color-scheme", value: dark ? "dark" : "light"}]}),
        ]);
    }

    async close() {
        const ended = new Promise((resolve) => this.process.on("exit", resolve));
        this.process.kill();
        await ended;
        this.server.closeAllConnections();
        this.server.close();
        // Chromium's other processes may still write there for a moment.
        await fs.promises.rm(this.profile, {recursive: true, force: true, maxRetries: 10, retryDelay: 100});
    }
}
