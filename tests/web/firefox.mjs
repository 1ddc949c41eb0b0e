// A page in Firefox, driven by Marionette, its own protocol over TCP, as Node alone can. Its window is on an X server without a screen,
// because it has no WebGL with --headless.
import {spawn} from "node:child_process";
import fs from "node:fs";
import net from "node:net";
import os from "node:os";
import path from "node:path";

const PREFERENCES = `user_pref("marionette.port", 0);
user_pref("remote.prefs.recommended", false);  // they let a file: page read other files
user_pref("network.proxy.type", 1);  // nothing outside answers
user_pref("network.proxy.http", "127.0.0.1");
user_pref("network.proxy.http_port", 9);
user_pref("network.proxy.ssl", "127.0.0.1");
user_pref("network.proxy.ssl_port", 9);
user_pref("datareporting.policy.dataSubmissionEnabled", false);
user_pref("browser.shell.checkDefaultBrowser", false);
`;
const PORT_FILE = "MarionetteActivePort";

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

async function display() {
    const server = spawn("Xvfb", ["-displayfd", "3", "-nolisten", "tcp", "-screen", "0", "1400x1000x24"], {stdio: ["ignore", "ignore", "ignore", "pipe"]});
    return new Promise((resolve, reject) => {
        server.on("error", reject);
        server.stdio[3].setEncoding("utf8").once("data", (number) => resolve({server, name: ":" + number.trim()}));
    });
}

export class Firefox {
    static async open(program) {
        const browser = new Firefox();
        browser.profile = fs.mkdtempSync(path.join(os.tmpdir(), "twinlight-"));
        fs.writeFileSync(path.join(browser.profile, "user.js"), PREFERENCES);
        browser.display = await display();
        browser.process = spawn(program, ["--no-remote", "--marionette", "--remote-allow-system-access", "--profile", browser.profile],
            {stdio: "ignore", env: {...process.env, HOME: browser.profile, DISPLAY: browser.display.name}});
        const port_file = path.join(browser.profile, PORT_FILE);
        for (const end = Date.now() + 60000; !fs.existsSync(port_file) || !fs.readFileSync(port_file, "utf8");) {
            if (Date.now() > end) throw new Error("Firefox does not start");
            await pause(50);
        }
        browser.waiting = new Map();
        browser.next = 0;
        browser.socket = net.connect(Number(fs.readFileSync(port_file, "utf8")), "127.0.0.1");
        let rest = Buffer.alloc(0);
        browser.socket.on("data", (bytes) => {
            // LENGTH:JSON
            for (rest = Buffer.concat([rest, bytes]);;) {
                const colon = rest.indexOf(":"), end = colon + 1 + Number(rest.toString("latin1", 0, Math.max(colon, 0)));
                if (colon < 0 || rest.length < end) return;
                browser.receive(JSON.parse(rest.toString("utf8", colon + 1, end)));
                rest = rest.subarray(end);
            }
        });
        await browser.send("WebDriver:NewSession");
        return browser;
    }

    send(method, params = {}) {
        const id = this.next++, text = JSON.stringify([0, id, method, params]);
        this.socket.write(`${Buffer.byteLength(text)}:${text}`);
        return new Promise((resolve, reject) => this.waiting.set(id, {resolve, reject}));
    }
    receive(message) {
        if (!Array.isArray(message)) return;  // the greeting
        const [, id, error, result] = message, {resolve, reject} = this.waiting.get(id);
        this.waiting.delete(id);
        if (error) reject(new Error(error.message));
        else resolve(result);
    }

    async visit(address) {
        await this.send("WebDriver:Navigate", {url: address});
    }
    // The value of an expression in the page, awaited.
    async value(expression) {
        const script = `const done = arguments[arguments.length - 1];
            (async () => (${expression}))().then((value) => done({value}), (error) => done({error: String(error)}));`;
        const {value: {value, error}} = await this.send("WebDriver:ExecuteAsyncScript", {script, args: [], sandbox: null, scriptTimeout: 60000});
        if (error) throw new Error(error);
        return value;
    }
    // Errors and console messages of file: pages.
    async said() {
        await this.send("Marionette:SetContext", {value: "chrome"});
        const script = `const logged = Cc["@mozilla.org/consoleAPI-storage;1"].getService(Ci.nsIConsoleAPIStorage).getEvents();
            return [...Services.console.getMessageArray().filter(({sourceName}) => sourceName?.startsWith("file:")).map(({errorMessage}) => errorMessage),
                ...logged.filter(({filename}) => /^(file|blob):/.test(filename)).map((event) => event.arguments.join(" "))];`;
        const {value} = await this.send("WebDriver:ExecuteScript", {script, args: []});
        await this.send("Marionette:SetContext", {value: "content"});
        return value;
    }
    async screenshot(file) {
        fs.writeFileSync(file, Buffer.from((await this.send("WebDriver:TakeScreenshot", {full: false})).value, "base64"));
    }
    async close() {
        const ended = new Promise((resolve) => this.process.on("exit", resolve));
        this.socket.destroy();
        this.process.kill();
        await ended;
        this.display.server.kill();
        await fs.promises.rm(this.profile, {recursive: true, force: true, maxRetries: 10, retryDelay: 100});
    }
}
