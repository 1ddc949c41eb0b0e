// GL's old state as uniforms of the kind in use, by WebGL 2; the functions of scene.c and loader.c.
const canvas = document.getElementById("picture");
// Without antialiasing and alpha, as a window of GL; the picture is kept so that it can be saved and read back.
const gl = canvas.getContext("webgl2", {antialias: false, alpha: false, stencil: true, preserveDrawingBuffer: true});
const kinds = [], textures = [];
let kind, data, camera;
let turn_deg = 0, tilt_deg = 0, shading = "scene";
const light_is_off = [];

function fail(what) {
    document.getElementById("error").textContent += what + "\n";
    throw new Error(what);
}

// ---- Programs and textures ----

function compiled(type, text, name) {
    const shader = gl.createShader(type);
    gl.shaderSource(shader, text);
    gl.compileShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) fail(name + ": " + gl.getShaderInfoLog(shader));
    return shader;
}

// The same shader with flat or smooth colours: section 2.14.7.
function with_shading(text) {
    if (shading === "smooth") return text.replace(/^flat (in|out) /gm, "$1 ");
    if (shading === "flat") return text.replace(/^(in|out) (vec[34] v_(front|back)_(primary|secondary);)/gm, "flat $1 $2");
    return text;
}

function load_kind(number, count, attributes) {
    const text = (ending) => with_shading(document.getElementById("kind" + number + ending).textContent.trim() + "\n");
    const program = gl.createProgram();
    gl.attachShader(program, compiled(gl.VERTEX_SHADER, text(".vert"), "kind" + number + ".vert"));
    gl.attachShader(program, compiled(gl.FRAGMENT_SHADER, text(".frag"), "kind" + number + ".frag"));
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) fail("kind" + number + ": " + gl.getProgramInfoLog(program));
    kinds[number] = {program, attributes, places: new Map()};
}

function load_texture(number, t) {
    textures[number] = gl.createTexture();
    gl.bindTexture(t.target, textures[number]);
    gl.texParameteri(t.target, gl.TEXTURE_MIN_FILTER, t.min_filter);
    gl.texParameteri(t.target, gl.TEXTURE_MAG_FILTER, t.mag_filter);
    gl.texParameteri(t.target, gl.TEXTURE_WRAP_S, t.wrap_s);
    gl.texParameteri(t.target, gl.TEXTURE_WRAP_T, t.wrap_t);
    gl.texParameteri(t.target, gl.TEXTURE_WRAP_R, t.wrap_r);
    gl.texParameteri(t.target, gl.TEXTURE_MAX_LEVEL, t.level_count - 1);
    if (t.compare_func) {
        gl.texParameteri(t.target, gl.TEXTURE_COMPARE_MODE, gl.COMPARE_REF_TO_TEXTURE);
        gl.texParameteri(t.target, gl.TEXTURE_COMPARE_FUNC, t.compare_func);
    }
    t.levels.forEach(([width, height, depth, first], level) => {
        const texels = data.subarray(4 * first, 4 * (first + width * height * depth));
        if (t.target === gl.TEXTURE_3D)
            gl.texImage3D(t.target, level, gl.RGBA8, width, height, depth, 0, gl.RGBA, gl.UNSIGNED_BYTE, texels);
        else if (t.has_depths)
            gl.texImage2D(t.target, level, gl.DEPTH_COMPONENT24, width, height, 0, gl.DEPTH_COMPONENT, gl.UNSIGNED_INT,
                new Uint32Array(texels.slice().buffer));
        else
            gl.texImage2D(t.target, level, gl.RGBA8, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, texels);
    });
}

// ---- Matrices, column by column ----

function product(a, b) {
    return Array.from({length: 16}, (_, i) => {
        let sum = 0;
        for (let k = 0; k < 4; ++k) sum += a[4 * k + i % 4] * b[4 * (i >> 2) + k];
        return sum;
    });
}
const length_of = (v) => Math.hypot(v[0], v[1], v[2]);
// The camera's matrix times (x, y, z, w).
const moved = (x, y, z, w) => [0, 1, 2].map((row) => camera[row] * x + camera[4 + row] * y + camera[8 + row] * z + camera[12 + row] * w);

// Turns around the scene's middle: by turn_deg around the vertical axis, then by tilt_deg around the horizontal one.
function set_camera() {
    const s = Math.sin(turn_deg * Math.PI / 180), c = Math.cos(turn_deg * Math.PI / 180);
    const sx = Math.sin(tilt_deg * Math.PI / 180), cx = Math.cos(tilt_deg * Math.PI / 180);
    camera = [c, sx * s, -cx * s, 0, 0, cx, sx, 0, s, -sx * c, cx * c, 0, 0, 0, 0, 1];
    const middle = moved(...scene_middle, 0);
    for (let row = 0; row < 3; ++row) camera[12 + row] = scene_middle[row] - middle[row];
}

// ---- Uniforms of the kind in use ----

function at(name) {
    if (!kind.places.has(name)) kind.places.set(name, gl.getUniformLocation(kind.program, name));
    return kind.places.get(name);
}
function use_kind(number) {
    kind = kinds[number];
    gl.useProgram(kind.program);
}
function number(uniform, value) { gl.uniform1f(at(uniform), value); }

function matrices(model_view, projection) {
    const m = product(camera, model_view);
    gl.uniformMatrix4fv(at("ModelViewMatrix"), false, m);
    gl.uniformMatrix4fv(at("ModelViewProjectionMatrix"), false, product(projection, m));
    // The transposed inverse: cross products of two columns, divided by the determinant. A singular matrix gives 0.
    const normal = [];
    for (let column = 0; column < 3; ++column) {
        const a = 4 * ((column + 1) % 3), b = 4 * ((column + 2) % 3);
        for (let i = 0; i < 3; ++i)
            normal.push(m[a + (i + 1) % 3] * m[b + (i + 2) % 3] - m[a + (i + 2) % 3] * m[b + (i + 1) % 3]);
    }
    const determinant = m[0] * normal[0] + m[1] * normal[1] + m[2] * normal[2];
    const inverse = normal.map((x) => determinant === 0 ? 0 : x / determinant);
    gl.uniformMatrix3fv(at("NormalMatrix"), false, inverse);
    number("NormalScale", 1 / (length_of(inverse.slice(6)) || 1));
}

function set_material(face, m) {
    for (const color of ["emission", "ambient", "diffuse", "specular"]) gl.uniform4fv(at(face + "." + color), m[color]);
    number(face + ".shininess", m.shininess);
}
function front_material(m) { set_material("FrontMaterial", m); }
function back_material(m) { set_material("BackMaterial", m); }
function light_model_ambient(color) { gl.uniform4fv(at("LightModel.ambient"), color); }

function light(i, l) {
    const source = "LightSource[" + i + "].", w = l.position[3];
    const position = moved(...l.position);
    const colors = light_is_off[i] ? [0, 0, 0, 0] : null;
    for (const color of ["ambient", "diffuse", "specular"]) gl.uniform4fv(at(source + color), colors ?? l[color]);
    gl.uniform4fv(at(source + "position"), [...position, w]);
    gl.uniform3fv(at(source + "spotDirection"), moved(...l.spot_direction, 0));
    number(source + "spotExponent", l.spot_exponent);
    number(source + "spotCutoff", l.spot_cutoff);
    number(source + "spotCosCutoff", Math.cos(l.spot_cutoff * Math.PI / 180));
    number(source + "constantAttenuation", l.attenuation[0]);
    number(source + "linearAttenuation", l.attenuation[1]);
    number(source + "quadraticAttenuation", l.attenuation[2]);
    // Halfway between the light's direction and the viewer at infinity, (0, 0, 1).
    const half = [position[0], position[1], position[2] + length_of(position)], size = length_of(half) || 1;
    gl.uniform4fv(at(source + "halfVector"), [half[0] / size, half[1] / size, half[2] / size, 0]);
}

function fog(color, density, start, end) {
    gl.uniform4fv(at("Fog.color"), color);
    number("Fog.density", density);
    number("Fog.start", start);
    number("Fog.end", end);
    number("Fog.scale", end === start ? 1e30 : 1 / (end - start));
}

// A plane is a row: it is multiplied by the inverse of the camera's matrix, which only turns and moves.
function eye_plane(uniform, plane) {
    const normal = moved(plane[0], plane[1], plane[2], 0);
    const w = plane[3] - normal[0] * camera[12] - normal[1] * camera[13] - normal[2] * camera[14];
    gl.uniform4fv(at(uniform), [...normal, w]);
}
function clip_plane(i, plane) { eye_plane("ClipPlane[" + i + "]", plane); }
function object_plane(uniform, plane) { gl.uniform4fv(at(uniform), plane); }

function use_texture(target, texture) { gl.bindTexture(target, textures[texture]); }
function texture_matrix(matrix) { gl.uniformMatrix4fv(at("TextureMatrix[0]"), false, matrix); }
function texture_env_color(color) { gl.uniform4fv(at("TextureEnvColor[0]"), color); }

function draw(mode, first_vertex, first_index, index_count) {
    const stride = kind.attributes.reduce((sum, [, floats]) => sum + 4 * floats, 0);
    let offset = 4 * first_vertex;
    for (let i = 0; i < 16; ++i) gl.disableVertexAttribArray(i);
    kind.attributes.forEach(([, floats], i) => {
        gl.enableVertexAttribArray(i);
        gl.vertexAttribPointer(i, floats, gl.FLOAT, false, stride, offset);
        offset += 4 * floats;
    });
    gl.drawElements(mode, index_count, gl.UNSIGNED_INT, 4 * first_index);
}

// ---- The page ----

function display() {
    set_camera();
    draw_scene();
    const off = [...light_is_off.keys()].filter((i) => light_is_off[i]).map((i) => "GL_LIGHT" + i);
    document.getElementById("state").textContent =
        (off.length ? "Off: " + off.join(", ") + ". " : "") + (shading === "scene" ? "" : "Shading: " + shading + ".");
    const error = gl.getError();
    if (error !== gl.NO_ERROR) fail("WebGL error 0x" + error.toString(16));
}

function start() {
    if (!gl) fail("This browser has no WebGL 2.");
    data = Uint8Array.from(atob(scene_data), (c) => c.charCodeAt(0));
    // WebGL keeps vertices and indices apart.
    for (const target of [gl.ARRAY_BUFFER, gl.ELEMENT_ARRAY_BUFFER]) {
        gl.bindBuffer(target, gl.createBuffer());
        gl.bufferData(target, data, gl.STATIC_DRAW);
    }
    gl.disable(gl.DITHER);
    load_scene();
    display();

    canvas.addEventListener("pointerdown", (event) => canvas.setPointerCapture(event.pointerId));
    canvas.addEventListener("pointermove", (event) => {
        if (!(event.buttons & 1)) return;
        turn_deg += 0.5 * event.movementX;
        tilt_deg += 0.5 * event.movementY;
        display();
    });
    document.addEventListener("keydown", (event) => {
        if (event.ctrlKey || event.altKey || event.metaKey) return;
        if (event.key >= "1" && event.key <= "8" && event.key.length === 1) {
            light_is_off[event.key - 1] = !light_is_off[event.key - 1];
        } else if (event.key === "f") {
            shading = shading === "flat" ? "smooth" : "flat";
            load_scene();
        } else {
            return;
        }
        display();
    });
}
