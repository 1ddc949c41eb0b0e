// Draws a frame of webgl_frame.h with WebGL 2, into a framebuffer of its own: 8 bits a channel, 24 of depth, 8 of stencil, as
// Twinlight's windows have. No antialiasing, no dithering.

// Enumerants that WebGL lacks.
const ACCUMULATE = {ACCUM: 0x0100, LOAD: 0x0101, RETURN: 0x0102, MULT: 0x0103, ADD: 0x0104};

// The texture unit of the picture's copy. WebGL 2 has at least 16, and OpenGL's scenes use at most 8.
const COPY_UNIT = 15;

export class Renderer {
    constructor(canvas = document.createElement("canvas")) {
        const gl = canvas.getContext("webgl2", {antialias: false, depth: false});
        if (!gl) throw new Error("This browser has no WebGL 2, so there are no shaders' pictures.");
        this.gl = gl;
        gl.getExtension("OES_texture_float_linear");
        this.anisotropy = gl.getExtension("EXT_texture_filter_anisotropic");
        gl.disable(gl.DITHER);
        gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
        this.subpixelBits = gl.getParameter(gl.SUBPIXEL_BITS);
        this.attributeCount = gl.getParameter(gl.MAX_VERTEX_ATTRIBS);
        this.programs = new Map();  // by both texts
        this.loaded = null;  // the words, buffers and textures of the last frame
        this.width = this.height = 0;
        this.framebuffer = gl.createFramebuffer();
        gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    }

    // "ANGLE (...), 4 bits of subpixels": the driver, as far as the browser says.
    description() {
        const gl = this.gl, info = gl.getExtension("WEBGL_debug_renderer_info");
        const name = info ? gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : gl.getParameter(gl.RENDERER);
        return `${name}, ${this.subpixelBits} bits of subpixels`;
    }

    // Red, green, blue and alpha of each pixel, the top row first.
    draw({header, words}) {
        const gl = this.gl;
        if (gl.isContextLost()) throw new Error("The browser took WebGL away from this page; reload it.");
        this.resize(header.width, header.height);
        if (this.loaded?.words !== words || this.loaded.of !== header.textures) this.load(header.textures, words);
        this.used = new Set();
        try {
            this.accumulation = null;
            this.clear({color: [0, 0, 0, 0], depth: 1, stencil: [0, 0xFF], colorMask: [true, true, true, true]});
            for (const item of header.items) {
                if (item.clear) this.clear(item);
                else if (item.accumulate) this.accumulate(item);
                else this.drawItem(item, header);
            }
            const error = gl.getError();
            if (error !== gl.NO_ERROR) throw new Error("WebGL error 0x" + error.toString(16));
            return this.pixels();
        } finally {
            for (const [text, {program}] of this.programs)
                if (!this.used.has(text)) {
                    gl.deleteProgram(program);
                    this.programs.delete(text);
                }
        }
    }

    // Buffers and textures stay until others come: the frames of a turning camera have the same ones.
    load(textures, words) {
        const gl = this.gl;
        this.unload();
        const buffers = [gl.ARRAY_BUFFER, gl.ELEMENT_ARRAY_BUFFER].map((target) => {
            const buffer = gl.createBuffer();
            gl.bindBuffer(target, buffer);
            gl.bufferData(target, words, gl.STATIC_DRAW);
            return buffer;
        });
        this.loaded = {words, of: textures, buffers, textures: []};
        try {
            for (const one of textures) {
                this.loaded.textures.push(gl.createTexture());
                this.fill(this.loaded.textures.at(-1), one, words);
            }
        } catch (error) {
            this.unload();  // or the next drawing would take them for loaded
            throw error;
        }
    }
    unload() {
        const gl = this.gl;
        this.loaded?.buffers.forEach((buffer) => gl.deleteBuffer(buffer));
        this.loaded?.textures.forEach((texture) => gl.deleteTexture(texture));
        this.loaded = null;
    }

    resize(width, height) {
        if (width === this.width && height === this.height) return;
        const gl = this.gl;
        [this.width, this.height] = [width, height];
        gl.deleteTexture(this.copy ?? null);
        this.copy = null;
        this.renderbuffers?.forEach((buffer) => gl.deleteRenderbuffer(buffer));
        this.renderbuffers = [[gl.COLOR_ATTACHMENT0, gl.RGBA8], [gl.DEPTH_STENCIL_ATTACHMENT, gl.DEPTH24_STENCIL8]].map(([place, format]) => {
            const buffer = gl.createRenderbuffer();
            gl.bindRenderbuffer(gl.RENDERBUFFER, buffer);
            gl.renderbufferStorage(gl.RENDERBUFFER, format, width, height);
            gl.framebufferRenderbuffer(gl.FRAMEBUFFER, place, gl.RENDERBUFFER, buffer);
            return buffer;
        });
        if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE)
            throw new Error(`WebGL cannot draw a picture of ${width} x ${height} pixels`);
    }

    pixels() {
        const gl = this.gl, row = 4 * this.width;
        const upward = new Uint8Array(row * this.height), pixels = new Uint8ClampedArray(upward.length);
        gl.readPixels(0, 0, this.width, this.height, gl.RGBA, gl.UNSIGNED_BYTE, upward);
        for (let y = 0; y < this.height; ++y)
            pixels.set(upward.subarray(row * y, row * (y + 1)), row * (this.height - 1 - y));
        return pixels;
    }

    // ---- Programs ----

    program({vertex, fragment}) {
        const text = vertex + fragment;
        this.used.add(text);
        if (!this.programs.has(text)) this.programs.set(text, this.linked(vertex, fragment));
        return this.programs.get(text);
    }

    linked(vertex, fragment) {
        const gl = this.gl, program = gl.createProgram();
        const shaders = [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]].map(([type, text]) => {
            const shader = gl.createShader(type);
            gl.shaderSource(shader, text);
            gl.compileShader(shader);
            gl.attachShader(program, shader);
            return shader;
        });
        gl.linkProgram(program);
        const is_linked = gl.getProgramParameter(program, gl.LINK_STATUS);
        const log = is_linked ? "" : [...shaders.map((shader) => gl.getShaderInfoLog(shader)), gl.getProgramInfoLog(program)].join("\n");
        shaders.forEach((shader) => gl.deleteShader(shader));
        if (!is_linked) {
            gl.deleteProgram(program);
            throw new Error(`The browser refuses a shader:\n${log}\n${vertex}\n${fragment}`);
        }
        const uniforms = new Map();
        for (let i = 0; i < gl.getProgramParameter(program, gl.ACTIVE_UNIFORMS); ++i) {
            const {name, type} = gl.getActiveUniform(program, i);
            uniforms.set(name.replace(/\[0\]$/, ""), {place: gl.getUniformLocation(program, name), type});
        }
        return {program, uniforms};
    }

    setUniform(uniform, values) {
        const gl = this.gl, {place, type} = uniform;
        uniform.values = values;  // the program keeps them
        switch (type) {
            case gl.FLOAT: return gl.uniform1fv(place, values);
            case gl.FLOAT_VEC2: return gl.uniform2fv(place, values);
            case gl.FLOAT_VEC3: return gl.uniform3fv(place, values);
            case gl.FLOAT_VEC4: return gl.uniform4fv(place, values);
            case gl.FLOAT_MAT3: return gl.uniformMatrix3fv(place, false, values);
            case gl.FLOAT_MAT4: return gl.uniformMatrix4fv(place, false, values);
            case gl.INT: return gl.uniform1iv(place, values);
            case gl.UNSIGNED_INT: return gl.uniform1uiv(place, values);
            default: throw new Error("a uniform of the type 0x" + type.toString(16));
        }
    }

    // ---- Textures ----

    fill(texture, {target, format, images, levels, anisotropy, parameters}, words) {
        const gl = this.gl;
        const [internal, external, type, size] = {
            rgba8: [gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, 1],
            rgba32f: [gl.RGBA32F, gl.RGBA, gl.FLOAT, 4],
            depth: [gl.DEPTH_COMPONENT24, gl.DEPTH_COMPONENT, gl.UNSIGNED_INT, 1],  // r is clamped, as GL 2.1 does
        }[format];
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(target, texture);
        for (const [face, level, width, height, depth, first] of images) {
            const count = size * width * height * depth;
            const texels = type === gl.UNSIGNED_BYTE ? new Uint8Array(words, 4 * first, 4 * count)
                                                     : new (type === gl.FLOAT ? Float32Array : Uint32Array)(words, 4 * first, count);
            if (target === gl.TEXTURE_3D)
                gl.texImage3D(target, level, internal, width, height, depth, 0, external, type, texels);
            else
                gl.texImage2D(target === gl.TEXTURE_CUBE_MAP ? gl.TEXTURE_CUBE_MAP_POSITIVE_X + face : target, level, internal,
                              width, height, 0, external, type, texels);
        }
        for (const [name, value] of parameters)
            (Number.isInteger(value) ? gl.texParameteri : gl.texParameterf).call(gl, target, name, value);
        if (this.anisotropy && anisotropy > 1) gl.texParameterf(target, this.anisotropy.TEXTURE_MAX_ANISOTROPY_EXT, anisotropy);
    }

    // ---- Items ----

    enable(capability, enabled) { (enabled ? this.gl.enable : this.gl.disable).call(this.gl, capability); }

    setMask({scissor, colorMask}) {
        const gl = this.gl;
        this.enable(gl.SCISSOR_TEST, scissor !== undefined);
        if (scissor) gl.scissor(...scissor);
        gl.colorMask(...colorMask);
    }

    clear(item) {
        const gl = this.gl;
        this.setMask(item);
        gl.depthMask(true);
        let buffers = 0;
        if (item.color) {
            gl.clearColor(...item.color);
            buffers |= gl.COLOR_BUFFER_BIT;
        }
        if (item.depth !== undefined) {
            gl.clearDepth(item.depth);
            buffers |= gl.DEPTH_BUFFER_BIT;
        }
        if (item.stencil) {
            gl.clearStencil(item.stencil[0]);
            gl.stencilMaskSeparate(gl.FRONT, item.stencil[1]);
            buffers |= gl.STENCIL_BUFFER_BIT;
        }
        gl.clear(buffers);
        if (item.accumulation) this.forEachAccumulated(item, (channels, i) => channels[i] = item.accumulation[i % 4]);
    }

    drawItem(item, header) {
        const gl = this.gl, {attributes} = header.programs[item.program], {program, uniforms} = this.program(header.programs[item.program]);
        gl.useProgram(program);
        this.setRaster(item);
        this.setFragments(item);
        for (const [unit, sampler, number] of item.textures) {
            gl.activeTexture(gl.TEXTURE0 + unit);
            gl.bindTexture(header.textures[number].target, this.loaded.textures[number]);
            if (uniforms.has(sampler)) gl.uniform1i(uniforms.get(sampler).place, unit);
        }
        const stride = 4 * attributes.reduce((sum, floats) => sum + floats, 0);
        let offset = 4 * item.vertices[0];
        for (let i = attributes.length; i < this.attributeCount; ++i) gl.disableVertexAttribArray(i);
        attributes.forEach((floats, i) => {
            gl.enableVertexAttribArray(i);
            gl.vertexAttribPointer(i, floats, gl.FLOAT, false, stride, offset);
            offset += 4 * floats;
        });
        for (const pass of item.passes) {
            for (const number of pass)
                for (const [name, values] of Object.entries(header.uniforms[number])) {
                    const uniform = uniforms.get(name);
                    if (uniform && uniform.values !== values) this.setUniform(uniform, values);
                }
            for (const [mode, first, count] of item.parts) {
                if (item.framebuffer) this.copyPicture(uniforms.get(item.framebuffer).place);
                const draw = () => gl.drawElements(mode, count, gl.UNSIGNED_INT, 4 * first);
                if (item.sides) this.forEachSide(item, draw);
                else draw();
            }
        }
    }

    // Both faces must have the same stencil reference and masks: here those of the one that is not culled.
    forEachSide(item, draw) {
        const gl = this.gl;
        gl.enable(gl.CULL_FACE);
        [gl.BACK, gl.FRONT].forEach((culled, i) => {
            gl.cullFace(culled);
            this.setStencil(item.stencil[i], item.stencil[i]);
            draw();
        });
    }

    // For shaders that read the picture, which they cannot while they draw into it.
    copyPicture(sampler) {
        const gl = this.gl;
        gl.activeTexture(gl.TEXTURE0 + COPY_UNIT);
        if (!this.copy) {
            this.copy = gl.createTexture();
            gl.bindTexture(gl.TEXTURE_2D, this.copy);
            gl.texStorage2D(gl.TEXTURE_2D, 1, gl.RGBA8, this.width, this.height);
            gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
            gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
        }
        gl.bindTexture(gl.TEXTURE_2D, this.copy);
        gl.copyTexSubImage2D(gl.TEXTURE_2D, 0, 0, 0, 0, 0, this.width, this.height);
        gl.uniform1i(sampler, COPY_UNIT);
    }

    setRaster(item) {
        const gl = this.gl;
        gl.viewport(...item.viewport);
        gl.depthRange(...item.depthRange);
        gl.frontFace(item.frontFace);
        this.enable(gl.CULL_FACE, item.cull !== undefined);
        if (item.cull) gl.cullFace(item.cull);
        this.enable(gl.POLYGON_OFFSET_FILL, item.offset !== undefined);
        if (item.offset) gl.polygonOffset(...item.offset);
        this.enable(gl.DEPTH_TEST, item.depthFunc !== undefined);
        if (item.depthFunc) gl.depthFunc(item.depthFunc);
        gl.depthMask(item.depthMask);
    }

    setFragments(item) {
        const gl = this.gl;
        this.setMask(item);
        this.enable(gl.STENCIL_TEST, item.stencil !== undefined);
        if (item.stencil) this.setStencil(...item.stencil);
        this.enable(gl.BLEND, item.blend !== undefined);
        if (item.blend) {
            gl.blendFuncSeparate(...item.blend.factors);
            gl.blendEquationSeparate(...item.blend.equations);
            gl.blendColor(...item.blend.color);
        }
    }

    setStencil(front, back) {
        const gl = this.gl, [, ref, mask, , , , write_mask] = front;
        for (const [face, [func, , , fail, depth_fail, depth_pass]] of [[gl.FRONT, front], [gl.BACK, back]]) {
            gl.stencilFuncSeparate(face, func, ref, mask);
            gl.stencilOpSeparate(face, fail, depth_fail, depth_pass);
            gl.stencilMaskSeparate(face, write_mask);
        }
    }

    // ---- The accumulation buffer (GL 2.1, section 4.2.4), which OpenGL ES lacks ----

    // change(channels, i, j): the channel i of the accumulation buffer, and j of a picture of the scissor's box.
    forEachAccumulated({scissor}, change) {
        const channels = this.accumulation ??= new Float32Array(4 * this.width * this.height);
        const [x0, y0, width, height] = this.boxOf(scissor);
        for (let y = 0, j = 0; y < height; ++y)
            for (let i = 4 * ((y0 + y) * this.width + x0), end = i + 4 * width; i < end; ++i, ++j) change(channels, i, j);
    }
    boxOf(scissor) {
        const [x, y, width, height] = scissor ?? [0, 0, this.width, this.height];
        const within = (value, end) => Math.min(Math.max(value, 0), end);
        const x0 = within(x, this.width), y0 = within(y, this.height);
        return [x0, y0, within(x + width, this.width) - x0, within(y + height, this.height) - y0];
    }

    accumulate(item) {
        const gl = this.gl, {accumulate: op, value} = item, box = this.boxOf(item.scissor);
        if (box[2] <= 0 || box[3] <= 0) return;
        const limited = (x) => Math.min(Math.max(x, -1), 1);
        const colors = new Uint8Array(4 * box[2] * box[3]);
        if (op === ACCUMULATE.ACCUM || op === ACCUMULATE.LOAD) gl.readPixels(...box, gl.RGBA, gl.UNSIGNED_BYTE, colors);
        switch (op) {
            case ACCUMULATE.ACCUM: return this.forEachAccumulated(item, (to, i, j) => to[i] = limited(to[i] + colors[j] / 255 * value));
            case ACCUMULATE.LOAD: return this.forEachAccumulated(item, (to, i, j) => to[i] = limited(colors[j] / 255 * value));
            case ACCUMULATE.ADD: return this.forEachAccumulated(item, (to, i) => to[i] = limited(to[i] + value));
            case ACCUMULATE.MULT: return this.forEachAccumulated(item, (to, i) => to[i] = limited(to[i] * value));
        }
        this.forEachAccumulated(item, (from, i, j) => colors[j] = Math.round(255 * Math.min(Math.max(from[i] * value, 0), 1)));
        this.drawColors(colors, box, item.colorMask);
    }

    // Draws pixels as they are, through the colour mask.
    drawColors(colors, [x, y, width, height], mask) {
        const gl = this.gl, {program, uniforms} = this.program({
            vertex: "#version 300 es\nvoid main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }",
            fragment: "#version 300 es\nprecision highp float;\nprecision highp sampler2D;\nuniform sampler2D colors;\nuniform vec2 corner;\n" +
                "out vec4 color;\nvoid main() { color = texelFetch(colors, ivec2(gl_FragCoord.xy - corner), 0); }",
        });
        const texture = gl.createTexture();
        gl.activeTexture(gl.TEXTURE0);
        gl.bindTexture(gl.TEXTURE_2D, texture);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, width, height, 0, gl.RGBA, gl.UNSIGNED_BYTE, colors);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
        for (const capability of [gl.BLEND, gl.DEPTH_TEST, gl.STENCIL_TEST, gl.CULL_FACE]) gl.disable(capability);
        this.setMask({scissor: [x, y, width, height], colorMask: mask});
        gl.viewport(0, 0, this.width, this.height);
        gl.useProgram(program);
        this.setUniform(uniforms.get("corner"), [x, y]);
        gl.uniform1i(uniforms.get("colors").place, 0);
        for (let i = 0; i < this.attributeCount; ++i) gl.disableVertexAttribArray(i);
        gl.drawArrays(gl.TRIANGLES, 0, 3);
        gl.deleteTexture(texture);
    }
}
