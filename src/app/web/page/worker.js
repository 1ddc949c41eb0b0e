// Draws rows of the reference's pictures, and judges pictures by shaders. Messages: {id, scene, work, ...}; answers: {id, result} or
// {id, error}. Scenes come from the page, which has opened them without an error.
import {loadTwinlight} from "./twinlight.js";

const loading = loadTwinlight();
let opened = "";

addEventListener("message", async ({data: {id, scene, work, given}}) => {
    try {
        const twinlight = await loading;
        const key = JSON.stringify(scene);
        if (key !== opened) {
            opened = "";
            twinlight.open(scene);
            opened = key;
        }
        postMessage({id, result: work === "rows" ? twinlight.referenceRows(given) : twinlight.judge(given.shading, given.pixels, given.subpixelBits)});
    } catch (error) {
        opened = "";
        postMessage({id, error: String(error.message ?? error)});
    }
});
