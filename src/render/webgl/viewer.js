// The exported page: draws its scene with Renderer (gl.js). The camera turns, lights can be switched off, and shading changes: all of
// this changes GL's state, which the scene's uniforms have under GL's names.

const at = (id) => document.getElementById(id);
const views = JSON.parse(at("scene").textContent);
const words = Uint8Array.from(atob(at("words").textContent), (c) => c.charCodeAt(0)).buffer;
const light_is_off = [];
const KEY_DEG = 5;
let scene = views[0], renderer, turn_deg = 0, tilt_deg = 0, shading = "scene", pixels;

// ---- Shading ----

// The same shader with flat or smooth colours: section 2.14.7.
function shaded(name) {
    const text = at(name).textContent.trim() + "\n";
    const colors = /^(?:flat )?(in|out) (vec[34] v_(front|back)_(primary|secondary);)/gm;
    if (shading === "smooth") return text.replace(colors, "$1 $2");
    if (shading === "flat") return text.replace(colors, "flat $1 $2");
    return text;
}

// ---- Matrices, column by column ----

function product(a, b) {
    return Array.from({length: 16}, (_, i) => {
        let sum = 0;
        for (let k = 0; k < 4; ++k) sum += a[4 * k + i % 4] * b[4 * (i >> 2) + k];
        return sum;
    });
}
// The upper three rows of the matrix times (x, y, z, w).
const moved = (matrix, [x, y, z, w]) =>
    [0, 1, 2].map((row) => matrix[row] * x + matrix[4 + row] * y + matrix[8 + row] * z + matrix[12 + row] * w);
const length_of = (v) => Math.hypot(v[0], v[1], v[2]);

// Turns around the scene's middle: by turn_deg around the vertical axis, then by tilt_deg around the horizontal one.
function camera() {
    const s = Math.sin(turn_deg * Math.PI / 180), c = Math.cos(turn_deg * Math.PI / 180);
    const sx = Math.sin(tilt_deg * Math.PI / 180), cx = Math.cos(tilt_deg * Math.PI / 180);
    const matrix = [c, sx * s, -cx * s, 0, 0, cx, sx, 0, s, -sx * c, cx * c, 0, 0, 0, 0, 1];
    const middle = moved(matrix, [...scene.middle, 0]);
    for (let row = 0; row < 3; ++row) matrix[12 + row] = scene.middle[row] - middle[row];
    return matrix;
}

// ---- Uniforms, as the camera sees them ----

function matrices(model_view, projection) {
    // The transposed inverse: cross products of two columns, divided by the determinant. A singular matrix gives 0.
    const m = model_view, normals = [];
    for (let column = 0; column < 3; ++column) {
        const a = 4 * ((column + 1) % 3), b = 4 * ((column + 2) % 3);
        for (let i = 0; i < 3; ++i)
            normals.push(m[a + (i + 1) % 3] * m[b + (i + 2) % 3] - m[a + (i + 2) % 3] * m[b + (i + 1) % 3]);
    }
    const determinant = m[0] * normals[0] + m[1] * normals[1] + m[2] * normals[2];
    const inverse = normals.map((x) => determinant === 0 ? 0 : x / determinant);
    return {
        ModelViewMatrix: m,
        ModelViewProjectionMatrix: product(projection, m),
        NormalMatrix: inverse,
        NormalScale: [1 / (length_of(inverse.slice(6)) || 1)],
    };
}

function light(source, property, values, eye) {
    switch (property) {
        case "position": {
            const position = moved(eye, values);
            // Halfway between the light's direction and the viewer at infinity, (0, 0, 1).
            const half = [position[0], position[1], position[2] + length_of(position)], size = length_of(half) || 1;
            return {[source + "position"]: [...position, values[3]], [source + "halfVector"]: [...half.map((x) => x / size), 0]};
        }
        case "spotDirection": return {[source + property]: moved(eye, [...values, 0])};
        default: return {};
    }
}

// Planes, four numbers each. A plane is a row: it is multiplied by the inverse of the camera's matrix, which only turns and moves.
function planes(values, eye) {
    const result = [];
    for (let i = 0; i < values.length; i += 4) {
        const normal = moved(eye, [...values.slice(i, i + 3), 0]);
        result.push(...normal, values[i + 3] - normal[0] * eye[12] - normal[1] * eye[13] - normal[2] * eye[14]);
    }
    return result;
}

function seen(uniforms, eye) {
    const result = {...uniforms};
    for (const [name, values] of Object.entries(uniforms)) {
        const [, source, number, property] = /^(LightSource\[(\d+)\]\.)(\w+)$/.exec(name) ?? [];
        if (name === "ModelViewMatrix") Object.assign(result, matrices(product(eye, values), uniforms.ProjectionMatrix));
        else if (name === "ClipPlane" || name.startsWith("EyePlane")) result[name] = planes(values, eye);
        else if (source && light_is_off[number] && ["ambient", "diffuse", "specular"].includes(property)) result[name] = [0, 0, 0, 0];
        else if (source) Object.assign(result, light(source, property, values, eye));
    }
    return result;
}

// ---- The terms of the lighting at a pixel (section 2.14.1) ----

// The term that is 0 if this colour is.
function term_of(name) {
    if (/^(Front|Back)Material\.emission$/.test(name)) return "emission";
    if (name === "LightModel.ambient") return "ambient light of the scene";
    const [, number, property] = /^LightSource\[(\d+)\]\.(ambient|diffuse|specular)$/.exec(name) ?? [];
    return number && `GL_LIGHT${number}: ${property}`;
}

// Each term is the difference of two drawings by the scene's own shaders: all other terms are 0 in one, and all terms in the other.
// `first`: the index of the pixel's red.
function terms_at(first) {
    const drawn_color = (change) => [...drawn(change).slice(first, first + 3)].map((code) => code / 255);
    const black = ([, , , alpha]) => [0, 0, 0, alpha], rest = drawn_color((_, color) => black(color));
    const most = new Map();  // the largest channel of each term's colours, at least 1: no term is clamped before the sum
    for (const [name, color] of scene.uniforms.flatMap(Object.entries))
        if (term_of(name)) most.set(term_of(name), Math.max(1, most.get(term_of(name)) ?? 1, ...color.slice(0, 3)));
    const names = [...most.keys()].sort((a, b) => a.localeCompare(b, "en", {numeric: true}));
    const rows = names.map((what) => {
        const only = (term, [red, green, blue, alpha]) =>
            term === what ? [...[red, green, blue].map((value) => value / most.get(what)), alpha] : black([red, green, blue, alpha]);
        return {what, color: drawn_color(only).map((value, i) => most.get(what) * (value - rest[i]))};
    }).filter(({color}) => color.some((value) => value !== 0));
    if (rows.length === 0) return [];
    if (rest.some((value) => value !== 0)) rows.push({what: "without light", how: "fog, texture, background", color: rest});
    const sum = [0, 1, 2].map((i) => rows.reduce((all, {color}) => all + color[i], 0));
    return [...rows.map((row, i) => ({...row, sign: i > 0 ? "+" : ""})), {sign: "=", what: "sum", color: sum, is_result: true},
            {sign: "", what: "the pixel", color: [0, 1, 2].map((i) => pixels[first + i] / 255), is_result: true}];
}

// ---- The page ----

const lights_of = ({uniforms}) => [...new Set(uniforms.flatMap(Object.keys).map((name) => /^LightSource\[(\d+)\]/.exec(name)?.[1]).filter(Boolean))].sort();

// change(term, color): the colour on which a term depends.
function drawn(change = (_, color) => color) {
    const eye = camera();
    const programs = scene.programs.map((one) => ({...one, vertex: shaded(one.vertex), fragment: shaded(one.fragment)}));
    const uniforms = scene.uniforms.map((one) => Object.fromEntries(
        Object.entries(seen(one, eye)).map(([name, values]) => [name, term_of(name) ? change(term_of(name), values) : values])));
    return renderer.draw({header: {...scene, programs, uniforms}, words});
}

function display() {
    pixels = drawn();
    at("terms").replaceChildren();
    for (let i = 3; i < pixels.length; i += 4) pixels[i] = 255;  // opaque, as a window
    at("picture").getContext("2d").putImageData(new ImageData(pixels, scene.width), 0, 0);
    const is_turned = turn_deg !== 0 || tilt_deg !== 0;
    showLabels(at("picture"), (!is_turned && scene.labels) || [], scene);  // their places are those of the first view
    at("lights").replaceChildren(...lights_of(scene).map((light) => {
        const button = document.createElement("button");
        button.type = "button";
        button.textContent = "GL_LIGHT" + light;
        button.ariaPressed = String(!light_is_off[light]);
        button.addEventListener("click", () => {
            switchLight(light);
            at("lights").querySelectorAll("button")[[...lights_of(scene)].indexOf(light)].focus();
        });
        return button;
    }));
    const off = [...light_is_off.keys()].filter((i) => light_is_off[i]).map((i) => "GL_LIGHT" + i);
    at("state").textContent =
        (off.length ? "Off: " + off.join(", ") + ". " : "") + (shading === "scene" ? "" : "Shading: " + shading + ".");
}

function show() {
    try {
        renderer ??= new Renderer();
        display();
    } catch (error) {
        at("error").textContent = error.message;
        throw error;
    }
}

function switchLight(number) {
    light_is_off[number] = !light_is_off[number];
    show();
}

function turn(right, down) {
    turn_deg += right;
    tilt_deg += down;
    show();
}

let seen_pixel;  // [x, y] from the top left

function showPixel(x, y) {
    seen_pixel = [x, y];
    const first = 4 * (y * scene.width + x);
    at("state").textContent = `Pixel ${x}, ${y}: red ${pixels[first]}, green ${pixels[first + 1]}, blue ${pixels[first + 2]} of 255.`;
    const rows = terms_at(first);
    at("terms").replaceChildren(...(rows.length > 0
        ? [termBars(rows), termTable(rows, 3), element("p", "Each term includes attenuation, the spotlight factor, textures and fog.", "aside")] : []));
}

let is_click = false;
at("picture").addEventListener("pointerdown", (event) => {
    is_click = true;
    event.target.setPointerCapture(event.pointerId);
});
at("picture").addEventListener("pointermove", (event) => {
    if (!(event.buttons & 1) || !(event.movementX || event.movementY)) return;
    is_click = false;
    turn(0.5 * event.movementX, 0.5 * event.movementY);
});
at("picture").addEventListener("pointerup", (event) => {
    const {width, height, clientWidth, clientHeight} = event.target;
    if (is_click) showPixel(Math.floor(event.offsetX * width / clientWidth), Math.floor(event.offsetY * height / clientHeight));
});
const ARROWS = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1]};
// Enter shows a pixel, the middle one at first. Shift and an arrow key go to the next, or to the eighth while the key is held.
at("picture").addEventListener("keydown", (event) => {
    if (!(event.key in ARROWS || event.key === "Enter") || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    const [right, down] = ARROWS[event.key] ?? [0, 0], step = event.repeat ? 8 : 1;
    if (event.key !== "Enter" && !event.shiftKey) return turn(KEY_DEG * right, KEY_DEG * down);
    const {width, height} = scene, [x, y] = seen_pixel ?? [width >> 1, height >> 1];
    showPixel(Math.min(Math.max(x + step * right, 0), width - 1), Math.min(Math.max(y + step * down, 0), height - 1));
});
document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || event.target instanceof HTMLSelectElement) return;
    if (/^[1-8]$/.test(event.key)) switchLight(event.key - 1);
    else if (event.key === "f") {
        shading = shading === "flat" ? "smooth" : "flat";
        show();
    }
});

// The choices of the lists, if there are several.
for (const property of ["step", "shading"]) {
    const select = at(property), values = [...new Set(views.map((view) => view[property] ?? ""))];
    select.append(...values.map((value) => new Option(value)));
    select.parentElement.hidden = values.length < 2;
    select.addEventListener("input", () => {
        const of_step = views.filter(({step}) => step === at("step").value);
        scene = of_step.find((view) => (view.shading ?? "") === at("shading").value) ?? of_step[0];
        show();
    });
}
// "#bare&step=2" or "#bare&step=The sum": only the picture, for a page that has it in a frame.
function open_hash() {
    const wanted = new URLSearchParams(location.hash.slice(1)), step = wanted.get("step"), select = at("step");
    document.body.classList.toggle("bare", wanted.has("bare"));
    const option = [...select.options].find(({value}, i) => step === value || Number(step) === i + 1);
    if (!option) return;
    select.value = option.value;
    select.dispatchEvent(new Event("input"));
}
startTheme(at("theme"));
show();
open_hash();
window.addEventListener("hashchange", open_hash);
