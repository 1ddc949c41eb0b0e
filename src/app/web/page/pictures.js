// The pictures on the page.
import {file} from "./own_files.js";
import {pictureIn} from "./recorded.js";

const ROWS = 48;       // of a worker's task
const ZERO_GREY = 64;  // where pictures are equal
const NARROW = 600;    // a window for one picture
const SIDES = ["left", "right"];  // of the slider

const at = (id) => document.getElementById(id);

function contextOf(id, {width, height}) {
    const canvas = at(id);
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    canvas.classList.remove("stale");
    at("pictures").style.setProperty("--aspect", width / height);
    return canvas.getContext("2d");
}
function opaqueImage(pixels, width) {
    const opaque = new Uint8ClampedArray(pixels);
    for (let i = 3; i < opaque.length; i += 4) opaque[i] = 255;
    return new ImageData(opaque, width);
}

export function show(id, pixels, size, y = 0) { contextOf(id, size).putImageData(opaqueImage(pixels, size.width), 0, y); }

async function showCoarse(id, {pixels, width}, size) {
    const bitmap = await createImageBitmap(opaqueImage(pixels, width));
    return () => contextOf(id, size).drawImage(bitmap, 0, 0, size.width, size.height);
}

// The reference's picture as the workers draw it: first a coarse one, then band by band. Returns its pixels, and the same as floats
// for the judge. wanted(): whether the picture is still to be shown.
export async function showReference(id, workers, scene, size, look, wanted) {
    const count = 4 * size.width * size.height, whole = {pixels: new Uint8ClampedArray(count), floats: null};
    if (!look.asFloats) whole.floats = new Float32Array(count);
    const coarse = workers.do({scene, work: "coarse", given: {...look, ...size}}, {soon: true}).then(async (picture) => {
        const draw = await showCoarse(id, picture, size);
        if (!wanted()) return;
        draw();
        performance.mark("first " + id);  // the tests measure it
    }).catch(() => {});  // the bands say what is wrong
    const bands = [];
    for (let y0 = 0; y0 < size.height; y0 += ROWS) {
        const y1 = Math.min(y0 + ROWS, size.height);
        bands.push(workers.do({scene, work: "rows", given: {...look, y0, y1, width: size.width}}).then(async ({rows, floats}) => {
            const first = 4 * size.width * y0;
            whole.pixels.set(rows, first);
            whole.floats?.set(floats, first);
            await coarse;
            if (wanted()) show(id, rows, size, y0);
        }));
    }
    await Promise.all(bands);
    return whole;
}

// Returns the factor by which the difference is amplified.
export function showDifference(a, b, largest, size) {
    let factor = 1;
    while (factor < 64 && 2 * factor * largest <= 255) factor *= 2;
    show("difference", a.map((value, i) => ZERO_GREY + factor * Math.abs(value - b[i])), size);
    return factor;
}

// Whether there is a picture by Mesa.
export function offerMesa(has_picture) {
    at("mesa").parentElement.hidden = !has_picture;
    for (const side of SIDES) {
        const option = [...at(side).options].find(({value}) => value === "mesa");
        option.hidden = option.disabled = !has_picture;
        if (option.selected && !has_picture) at(side).selectedIndex = 0;
    }
    setSlider();
}

// Mesa's picture of this name, from the reference's with floats.
export async function showMesa(name, floats, size, wanted) {
    const picture = await pictureIn(await (await file("mesa/" + name)).blob(), floats);
    if (!wanted()) return;
    if (picture) show("mesa", picture, size);
    else offerMesa(false);
}

// ---- The slider: two pictures, one on each side of a line ----

export function setSlider() {
    const is_tutor = document.body.classList.contains("tutor"), is_slider = !is_tutor && at("view").value === "slider";
    at("pictures").className = is_tutor ? "one" : is_slider ? "slider" : "grid";
    at("slider").hidden = !is_slider;
    for (const figure of at("pictures").querySelectorAll("figure")) figure.classList.remove(...SIDES);
    if (!is_slider) return;
    for (const side of SIDES) at(at(side).value).parentElement.classList.add(side);
    at("pictures").style.setProperty("--line", at("line").value + "%");
}

export function startSlider() {
    for (const side of SIDES)
        for (const figure of at("pictures").querySelectorAll("figure"))
            at(side).append(new Option(figure.querySelector("figcaption span").textContent, figure.querySelector("canvas").id));
    at("right").value = "reference";
    if (innerWidth < NARROW) at("view").value = "slider";
    for (const id of ["view", "line", ...SIDES]) at(id).addEventListener("input", setSlider);
    setSlider();
}
