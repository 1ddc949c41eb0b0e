// The module's functions for JavaScript. A page, a worker and Node use it alike.
import createModule from "./module.js";

export const SHADINGS = {scene: -1, flat: 0, gouraud: 1, phong: 2, exact: 3};

export async function loadTwinlight(options = {}) {
    const module = await createModule(options);

    // Calls a function with numbers and texts.
    function call(name, ...values) {
        const texts = [];
        try {
            const given = values.map((value) => {
                if (typeof value !== "string") return value;
                const bytes = new TextEncoder().encode(value);
                const place = module._allocate(bytes.length + 1);
                if (place === 0) throw new Error("this scene needs more memory than a page gets");
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

    return {
        builtIn: () => json("built_in").scenes,
        // Opens a scene; then the functions below are about it. Throws only if memory is short.
        open: ({text, name, step = "", width, height}) => json("open_scene", text, name, step, width, height),
        warnings: () => json("lint_scene").warnings,
        // A copy of the rows y0 to y1 of the reference's picture, `width` pixels each.
        referenceRows({shading, asFloats = false, y0, y1, width}) {
            const place = call("reference_rows", SHADINGS[shading], asFloats ? 1 : 0, y0, y1);
            return module.HEAPU8.slice(place, place + 4 * width * (y1 - y0));
        },
        // {header, words}: what gl.js draws.
        webglFrame(shading) {
            const header = json("webgl_header", SHADINGS[shading]);
            const place = module._webgl_words(), count = module._webgl_word_count();
            return {header, words: module.HEAPU8.slice(place, place + 4 * count).buffer};
        },
        // Compares a picture by shaders with the reference's. subpixelBits: gl.SUBPIXEL_BITS.
        judge(shading, pixels, subpixelBits) {
            const place = module._allocate(pixels.length);
            if (place === 0) throw new Error("this scene needs more memory than a page gets");
            try {
                module.HEAPU8.set(pixels, place);
                return json("judge_picture", SHADINGS[shading], place, pixels.length, subpixelBits);
            } finally {
                module._release(place);
            }
        },
        explain: (shading, x, y) => textAt(call("explain_pixel", SHADINGS[shading], x, y)),
    };
}
