// Draws the reference's pictures, judges pictures by shaders, and checks answers to lessons. Messages: first {wasm}, the compiled module; then {files}, to keep
// ([name, bytes] each), or {id, scene, work, ...}.
// Answers: {id, result} or {id, error}. Scenes come from the page, which has opened them without an error.
import {loadTwinlight} from "./twinlight.js";

let loading = null, opened = "";

const WORK = {
    coarse: (twinlight, given) => twinlight.coarseReference(given),
    rows: (twinlight, given) => twinlight.referenceRows(given),
    judge: (twinlight, {shading, pixels, floats, subpixelBits}) => twinlight.judge(shading, pixels, floats, subpixelBits),
    check: (twinlight, given) => twinlight.checkAnswer(given),
};

addEventListener("message", async ({data: {wasm, files, id, scene, work, given}}) => {
    if (wasm) {
        loading = loadTwinlight({wasm});
        return;
    }
    try {
        const twinlight = await loading;
        if (files) {
            for (const [name, bytes] of files) twinlight.keepFile(name, bytes);
            opened = "";
            return;
        }
        const key = JSON.stringify(scene);
        if (scene && key !== opened) {
            opened = "";
            twinlight.open(scene);
            opened = key;
        }
        postMessage({id, result: WORK[work](twinlight, given)});
    } catch (error) {
        opened = "";
        postMessage({id, error: String(error.message ?? error)});
    }
});
