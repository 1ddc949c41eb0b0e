// ==== kind1.wgsl
// Vertex shader: transforms positions to clip coordinates (GL 2.1, section 2.11) and lights vertices in eye coordinates
// (section 2.14).
// Fragment shader: computes the colour from interpolated values (GL 2.1, sections 3.8 to 3.10).

struct Matrices {
    ModelViewProjectionMatrix: mat4x4f,  // glMatrixMode: the product of the projection and the modelview matrix
    NormalMatrix: mat3x3f,  // the transposed inverse of the modelview matrix's upper 3x3 (section 2.11.3)
}
@group(0) @binding(0) var<uniform> matrices: Matrices;

// glMaterial (section 2.14.2)
struct MaterialParameters {
    emission: vec4f,  // e_cm
    ambient: vec4f,  // a_cm
    diffuse: vec4f,  // d_cm
    specular: vec4f,  // s_cm
    shininess: f32,  // s_rm
}
@group(0) @binding(1) var<uniform> FrontMaterial: MaterialParameters;

// glLight (section 2.14.2)
struct LightSourceParameters {
    diffuse: vec4f,  // d_cli
    specular: vec4f,  // s_cli
    position: vec4f,  // P_pli, in eye coordinates: glLight multiplied it by the modelview matrix
    halfVector: vec4f,  // of a directional light: the direction of VP_i + (0, 0, 1), of length 1
}
@group(0) @binding(3) var<uniform> LightSource: array<LightSourceParameters, 1>;  // GL_LIGHT0

// glLightModel (section 2.14.2)
struct LightModelParameters {
    ambient: vec4f,  // a_cs
}
@group(0) @binding(4) var<uniform> LightModel: LightModelParameters;

@group(0) @binding(7) var Texture0: texture_2d<f32>;  // of texture unit 0
@group(0) @binding(8) var Texture0Sampler: sampler;

struct VertexInput {
    @location(0) Vertex: vec4f,
    @location(1) Normal: vec3f,
    @location(2) MultiTexCoord0: vec4f,
}

struct Varyings {
    @builtin(position) @invariant position: vec4f,  // another program with the same positions gets the same depths
    @location(0) v_front_primary: vec4f,
    @location(1) v_front_secondary: vec3f,
    @location(2) v_tex_coord: vec2f,
}

// v scaled to length 1; the zero vector stays 0.
fn unit(v: vec3f) -> vec3f {
    return v / max(length(v), 1e-18);
}

// x^n for an integer n in [0, 128], by repeated squaring: faster and more exact than pow. 0^0 is 1 (section 2.1.1).
fn whole_power(x_given: f32, n: i32) -> f32 {
    var x = x_given;  // a parameter cannot change in WGSL
    var result = 1.0;
    for (var bit = 0; bit < 8; bit++) {
        result *= select(1.0, x, ((n >> u32(bit)) & 1) != 0);
        x *= x;
    }
    return result;
}

// max(a . b, 0): written as a dot in a circle in section 2.14.1.
fn positive_dot(a: vec3f, b: vec3f) -> f32 {
    return max(dot(a, b), 0.0);
}

// f_i (n . h_i)^s_rm: the specular highlight (section 2.14.1). n_dot_h must not be negative.
fn highlight(n_dot_vp: f32, n_dot_h: f32, shininess: i32) -> f32 {
    return select(0.0, whole_power(n_dot_h, shininess), n_dot_vp > 0.0);
}

// x, but never infinite: the power of a long normal may overflow, and infinity times 0 is not a number.
fn bounded(x: f32) -> f32 {
    return min(x, 1e30);
}

// The lighting equation (GL 2.1, section 2.14.1), in eye coordinates:
//
//   c_pri = e_cm + a_cm a_cs + sum_i att_i spot_i [ a_cm a_cli + (n . VP_i) d_cm d_cli
//                                                   + f_i (n . h_i)^s_rm s_cm s_cli ]
//
// Only the lights that are on and the terms that are not 0 are here.
struct Surface {
    normal_eye: vec3f,  // n
}

struct Lit {
    primary: vec4f,  // c_pri
    secondary: vec3f,  // c_sec
}

// The colours of the front face (section 2.14.1).
fn light_front(surface: Surface) -> Lit {
    var lit: Lit;
    lit.primary = vec4f(
        FrontMaterial.emission.rgb + FrontMaterial.ambient.rgb * LightModel.ambient.rgb,  // e_cm + a_cm a_cs
        FrontMaterial.diffuse.a);
    lit.secondary = vec3f(0.0);
    let n = surface.normal_eye;
    {  // GL_LIGHT0
        let vp_dir = unit(LightSource[0].position.xyz);
        let n_dot_vp = positive_dot(n, vp_dir);
        lit.primary += vec4f(n_dot_vp * FrontMaterial.diffuse.rgb * LightSource[0].diffuse.rgb, 0.0);
        lit.secondary += bounded(highlight(n_dot_vp, positive_dot(n, LightSource[0].halfVector.xyz), i32(FrontMaterial.shininess))) *
            FrontMaterial.specular.rgb * LightSource[0].specular.rgb;
    }
    lit.primary = saturate(lit.primary);  // section 2.14.6
    lit.secondary = saturate(lit.secondary);
    return lit;
}

@vertex
fn vertex_main(vertex: VertexInput) -> Varyings {
    var out: Varyings;
    out.position = matrices.ModelViewProjectionMatrix * vertex.Vertex;
    let surface = Surface(matrices.NormalMatrix * vertex.Normal);
    let front = light_front(surface);
    out.v_front_primary = front.primary;
    out.v_front_secondary = front.secondary;
    out.v_tex_coord = vertex.MultiTexCoord0.xy;
    out.position.z = 0.5 * (out.position.z + out.position.w);  // WebGPU clips z to [0, w], GL to [-w, w]
    return out;
}

@fragment
fn fragment_main(in: Varyings) -> @location(0) vec4f {
    let texel = textureSample(Texture0, Texture0Sampler, in.v_tex_coord);
    var color = in.v_front_primary;  // then GL_MODULATE (section 3.8.13)
    color *= vec4f(texel.rgb, 1.0);
    color = vec4f(min(color.rgb + in.v_front_secondary, vec3f(1.0)), color.a);  // the colour sum (section 3.9)
    return color;
}
