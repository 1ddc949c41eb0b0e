// The tutor: the scene from outside, the picture, and the calls that matter. Numbers are dragged or typed, and what is under the pointer is
// explained below.
import {ARROWS, control} from "./controls.js";
import {Renderer} from "./gl.js";
import {showLabels} from "./labels.js";
import {show} from "./pictures.js";

const HINT = "Drag a number, or click it to type. Drag a light in the scene from outside. Click the picture to see why a pixel has its colour.";
const DRAG_PIXELS = 3;   // a drag that is shorter is a click
const KEY_STEPS = 5;     // of a key, in pixels of a drag
const TURN_PIXELS = 20;  // of an arrow key in the scene from outside, in pixels of a drag
const UP = {ArrowUp: 1, ArrowDown: -1, PageUp: 10, PageDown: -10};

const at = (id) => document.getElementById(id);
const shown = (value) => String(Number(value.toPrecision(6)));

export class Tutor {
    // ready(), done(answer): as for control(); changed(number, value): after each change of a number.
    constructor(twinlight, {ready, done, changed}) {
        Object.assign(this, {twinlight, changed, form: "", fields: [], renderer: null});
        const turned = (right, down) => {
            twinlight.pressWorld(-1, -1);  // beside all lights
            return twinlight.dragWorld(TURN_PIXELS * right, TURN_PIXELS * down);
        };
        control(at("world"), {
            press: (code) => ARROWS.has(code) ? turned(...ARROWS.get(code)) : twinlight.press(code),
            startDrag: (_, place) => twinlight.pressWorld(...place),
            drag: (_, dx, dy) => twinlight.dragWorld(dx, dy),
            endDrag: twinlight.endDrag,
            zoom: twinlight.zoomWorld,
        }, {ready, done: (answer) => done(answer) ?? this.showWorld(), click: () => {}});
        this.explain();
    }

    get isShown() { return document.body.classList.contains("tutor"); }

    // Shows the open scene; its picture has this size.
    show(size) {
        this.size = size;
        const calls = this.twinlight.calls(), numbers = calls.flat().filter(({number}) => number);
        const form = JSON.stringify(calls.map((parts) => parts.map(({text, number}) => number?.name ?? text)));
        if (form !== this.form) {
            this.form = form;
            this.fields = [];
            at("calls").replaceChildren(...calls.map((parts) => this.madeCall(parts)));
        }
        numbers.forEach(({number}, i) => this.fields[i].show(number));
        for (const swatch of at("calls").querySelectorAll(".swatch")) {
            const color = [0, 1, 2].map((i) => numbers[Number(swatch.dataset.first) + i].number.value);
            swatch.style.background = `rgb(${color.map((value) => 255 * value)})`;
        }
        this.showWorld();
    }

    showWorld() {
        const frame = this.twinlight.worldFrame();
        this.renderer ??= new Renderer();
        show("world", this.renderer.draw(frame), this.size);
        showLabels(at("world"), frame.header.labels ?? [], this.size);
    }

    // Without `help`, that of the number with the focus.
    explain(help = document.activeElement?.dataset.help ?? HINT) { at("meaning").textContent = help; }

    madeCall(parts) {
        const made = document.createElement("div");
        let was_color = false;
        for (const {text, help, number, is_color} of parts) {
            const part = document.createElement(number ? "input" : "span");
            if (number) {
                if (is_color && !was_color) made.append(this.swatch());
                was_color = is_color;
                this.fields.push(new Field(part, this.changed, () => this.twinlight.endDrag()));
            } else {
                part.textContent = text;
                part.className = help ? "name" : made.childElementCount === 0 ? "call" : "";
            }
            if (help) {
                part.dataset.help = help;
                part.addEventListener("pointerenter", () => this.explain(help));
                part.addEventListener("focus", () => this.explain(help));
                for (const left of ["pointerleave", "blur"]) part.addEventListener(left, () => this.explain());
            }
            made.append(part);
        }
        return made;
    }

    swatch() {
        const made = document.createElement("span");
        made.className = "swatch";
        made.dataset.first = this.fields.length;
        return made;
    }
}

// A number in a call.
class Field {
    // changed(number, value): after each move; ended(): after the last one of a drag.
    constructor(input, changed, ended) {
        Object.assign(this, {input, changed, drag: null});
        input.type = "number";
        input.step = "any";
        input.setAttribute("aria-describedby", "meaning");
        input.addEventListener("input", () => Number.isFinite(input.valueAsNumber) && changed(this.number, input.valueAsNumber));
        input.addEventListener("change", () => {
            ended();
            this.show(this.number, true);
        });
        input.addEventListener("keydown", (event) => this.key(event));
        input.addEventListener("mousedown", (event) => event.preventDefault());  // a drag selects nothing
        input.addEventListener("pointerdown", (event) => {
            this.drag = {from: event.clientX, value: this.number.value, to: null, isWaiting: false};
            input.setPointerCapture(event.pointerId);
        });
        input.addEventListener("pointermove", ({clientX}) => {
            const {drag} = this;
            if (!drag || (drag.to === null && Math.abs(clientX - drag.from) < DRAG_PIXELS)) return;
            drag.to = clientX;
            if (drag.isWaiting) return;
            drag.isWaiting = true;  // one picture for a frame of the screen
            requestAnimationFrame(() => {
                drag.isWaiting = false;
                this.set(drag.value + (drag.to - drag.from) * this.number.step);
            });
        });
        for (const end of ["pointerup", "pointercancel"])
            input.addEventListener(end, ({type}) => {
                if (type === "pointerup" && this.drag?.to === null) {
                    input.focus();
                    input.select();
                }
                this.drag = null;
                ended();
            });
    }

    key(event) {
        if (!(event.key in UP) || event.ctrlKey || event.altKey || event.metaKey) return;
        event.preventDefault();
        this.set(this.number.value + UP[event.key] * KEY_STEPS * this.number.step);
    }

    // To a multiple of the step.
    set(value) {
        const {step, smallest, largest} = this.number;
        this.changed(this.number, Math.min(Math.max(Math.round(value / step) * step, smallest ?? -Infinity), largest ?? Infinity));
        this.show(this.number, true);
    }

    // What is being typed stays.
    show(number, replaces = false) {
        const {input} = this;
        this.number = number;
        input.ariaLabel = number.name;
        [input.min, input.max] = [number.smallest ?? "", number.largest ?? ""];
        if (replaces || document.activeElement !== input || this.drag) input.value = shown(number.value);
        input.style.width = `${input.value.length}ch`;
    }
}
