// The module's functions for JavaScript. A page, a worker and Node use it alike.
import createModule from "./module.js";

export const SHADINGS = {scene: -1, flat: 0, gouraud: 1, phong: 2, exact: 3};
const COARSE = 4;  // PageScene::kCoarse

// The module from a WebAssembly.Module, which the page compiles once for itself and its workers.
const created = (wasm) => new Promise((resolve, reject) => createModule({
    locateFile: (name) => name,
    instantiateWasm(imports, done) {
        WebAssembly.instantiate(wasm, imports).then((instance) => done(instance, wasm)).catch(reject);
        return {};
    },
}).then(resolve, reject));

// options: {wasm: a WebAssembly.Module}, or what Emscripten takes.
export async function loadTwinlight(options = {}) {
    const module = await (options.wasm ? created(options.wasm) : createModule(options));

    function allocated(bytes) {
        const place = module._allocate(bytes);
        if (place === 0) throw new Error("this scene needs more memory than a page gets");
        return place;
    }
    const copied = (place, bytes) => module.HEAPU8.slice(place, place + bytes);

    // Calls a function with numbers, texts and bytes.
    function call(name, ...values) {
        const texts = [];
        try {
            const given = values.map((value) => {
                if (typeof value === "number") return value;
                const bytes = typeof value === "string" ? new TextEncoder().encode(value) : value;
                const place = allocated(bytes.length + 1);
                texts.push(place);
                module.HEAPU8.set(bytes, place);
                module.HEAPU8[place + bytes.length] = 0;
                return place;
            });
            const result = module["_" + name](...given);
            if (result === 0) throw new Error(textAt(module._failure_text()));
            return result;
        } finally {
            texts.forEach((place) => module._release(place));
        }
    }
    function textAt(place) {
        const end = module.HEAPU8.indexOf(0, place);
        return new TextDecoder().decode(module.HEAPU8.subarray(place, end));
    }
    const json = (name, ...values) => JSON.parse(textAt(call(name, ...values)));

    function frame(name, ...values) {
        const header = json(name, ...values);
        const place = module._webgl_words(), count = module._webgl_word_count();
        return {header, words: copied(place, 4 * count).buffer};
    }

    return {
        builtIn: () => json("built_in").scenes,
        // Opens a scene; then the functions below are about it. Throws only if memory is short.
        open: ({text, name, step = "", width, height}) => json("open_scene", text, name, step, width, height),
        // What app/web/dropped_files.h does. Bytes: Uint8Array.
        isRecording: (name, front) => textAt(call("kind_of_file", name, front, front.length)) === "recording",
        addFile: (name, bytes) => { call("add_file", name, bytes, bytes.length); },
        sceneOfRecording: (name) => json("scene_of_recording", name),
        // A picture, mesh or material file for the scenes that are opened after this.
        keepFile: (name, bytes) => { call("keep_file", name, bytes, bytes.length); },
        warnings: () => json("lint_scene").warnings,
        // A copy of the rows y0 to y1 of the reference's picture, `width` pixels each: {rows: bytes, floats}.
        referenceRows({shading, asFloats = false, y0, y1, width}) {
            const count = 4 * width * (y1 - y0);
            const rows = copied(call("reference_rows", SHADINGS[shading], asFloats ? 1 : 0, y0, y1), count);
            return {rows, floats: asFloats ? null : new Float32Array(copied(call("reference_floats", y0, y1), 4 * count).buffer)};
        },
        // The whole picture, with fewer pixels: {pixels, width}.
        coarseReference({shading, asFloats = false, width, height}) {
            const less = (side) => Math.ceil(side / COARSE);
            const place = call("coarse_reference", SHADINGS[shading], asFloats ? 1 : 0);
            return {pixels: copied(place, 4 * less(width) * less(height)), width: less(width)};
        },
        // {header, words}: what gl.js draws.
        webglFrame: (shading) => frame("webgl_header", SHADINGS[shading]),
        // Compares a picture by shaders with the reference's floats. subpixelBits: gl.SUBPIXEL_BITS.
        judge(shading, pixels, floats, subpixelBits) {
            const place = allocated(5 * pixels.length), place_of_floats = place + pixels.length;
            try {
                module.HEAPU8.set(pixels, place);
                module.HEAPU8.set(new Uint8Array(floats.buffer, floats.byteOffset, floats.byteLength), place_of_floats);
                return json("judge_picture", SHADINGS[shading], place, place_of_floats, pixels.length, subpixelBits);
            } finally {
                module._release(place);
            }
        },
        // What page_probe.h describes.
        probe: (shading, x, y) => json("probe_pixel", SHADINGS[shading], x, y),
        explain: (shading, x, y) => textAt(call("explain_pixel", SHADINGS[shading], x, y)),

        // The window's keys and mouse. Answers: page_controls.h.
        keys: () => json("key_list"),
        press: (code) => json("press_key", code),
        startDrag: (may_go_under) => module._start_drag(may_go_under ? 1 : 0),
        drag: (looks, dx, dy) => json("drag", looks ? 1 : 0, dx, dy),
        endDrag: () => module._end_drag(),
        zoom: (steps) => json("zoom", steps),
        numbers: () => json("number_list"),
        setArgument: ({command, argument}, value) => json("set_argument", command, argument, value),

        // The tutors' scenes; the calls that a tutor shows; the scene from outside, as webglFrame(), and its mouse.
        tutors: () => json("tutor_list"),
        calls: () => json("call_list"),
        worldFrame: () => frame("world_header"),
        pressWorld: (x, y) => module._press_world(x, y),
        dragWorld: (dx, dy) => json("drag_world", dx, dy),
        zoomWorld: (steps) => json("zoom_world", steps),

        // Lessons, in the language "en" or "zh": page_lessons.h.
        lessons: (language) => json("lesson_list", language),
        ownLesson: (name, language, text) => json("read_own_lesson", name, language, text),
        // own: the text of a lesson that was dropped.
        checkAnswer: ({lesson, language, text, own = ""}) => json("check_answer", lesson, language, text, own),

        // What the scene can be exported as, and its text.
        forms: (shading) => json("forms", SHADINGS[shading]),
        exported: (form, shading) => textAt(call("export_scene", form, SHADINGS[shading])),

        memoryBytes: () => module.HEAPU8.length,
    };
}
