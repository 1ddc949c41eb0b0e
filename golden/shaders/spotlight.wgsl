// ==== kind1.wgsl
// Vertex shader: transforms positions to clip coordinates (GL 2.1, section 2.11) and lights vertices in eye coordinates
// (section 2.14).
// Fragment shader: computes the colour from interpolated values (GL 2.1, sections 3.8 to 3.10).

struct Matrices {
    ModelViewProjectionMatrix: mat4x4f,  // glMatrixMode: the product of the projection and the modelview matrix
    ModelViewMatrix: mat4x4f,  // from object to eye coordinates
    NormalMatrix: mat3x3f,  // the transposed inverse of the modelview matrix's upper 3x3 (section 2.11.3)
}
@group(0) @binding(0) var<uniform> matrices: Matrices;

// glMaterial (section 2.14.2)
struct MaterialParameters {
    emission: vec4f,  // e_cm
    ambient: vec4f,  // a_cm
    diffuse: vec4f,  // d_cm
}
@group(0) @binding(1) var<uniform> FrontMaterial: MaterialParameters;

// glLight (section 2.14.2)
struct LightSourceParameters {
    diffuse: vec4f,  // d_cli
    position: vec4f,  // P_pli, in eye coordinates: glLight multiplied it by the modelview matrix
    spotDirection: vec3f,  // s_dli, in eye coordinates
    spotExponent: f32,  // s_rli
    spotCosCutoff: f32,  // its cosine
}
@group(0) @binding(3) var<uniform> LightSource: array<LightSourceParameters, 2>;  // GL_LIGHT0, GL_LIGHT1

// glLightModel (section 2.14.2)
struct LightModelParameters {
    ambient: vec4f,  // a_cs
}
@group(0) @binding(4) var<uniform> LightModel: LightModelParameters;

struct VertexInput {
    @location(0) Vertex: vec4f,
    @location(1) Normal: vec3f,
}

struct Varyings {
    @builtin(position) @invariant position: vec4f,  // another program with the same positions gets the same depths
    @location(0) v_front_primary: vec4f,
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

// x^n for any n in [0, 128]. Only the fraction of n uses pow, which is exact enough there.
fn real_power(x: f32, n: f32) -> f32 {
    let fraction = fract(n);
    return whole_power(x, i32(n)) * select(1.0, pow(x, fraction), fraction > 0.0);
}

// max(a . b, 0): written as a dot in a circle in section 2.14.1.
fn positive_dot(a: vec3f, b: vec3f) -> f32 {
    return max(dot(a, b), 0.0);
}

// spot_i: the spotlight factor, 0 outside the cone and (PV . s_dli)^s_rli inside (section 2.14.1). The cone includes
// its border, so cos_cutoff is cos(c_rli) minus a margin for rounding.
fn spot(spot_dir: vec3f, cos_cutoff: f32, spot_exponent: f32, vp_dir: vec3f) -> f32 {
    let cos_angle = dot(-vp_dir, spot_dir);
    return select(0.0, real_power(max(cos_angle, 0.0), spot_exponent), cos_angle >= cos_cutoff);
}

// The lighting equation (GL 2.1, section 2.14.1), in eye coordinates:
//
//   c_pri = e_cm + a_cm a_cs + sum_i att_i spot_i [ a_cm a_cli + (n . VP_i) d_cm d_cli
//                                                   + f_i (n . h_i)^s_rm s_cm s_cli ]
//
// Only the lights that are on and the terms that are not 0 are here.
struct Surface {
    position_eye: vec3f,  // V
    normal_eye: vec3f,  // n
}

struct Lit {
    primary: vec4f,  // c_pri
}

// The colours of the front face (section 2.14.1).
fn light_front(surface: Surface) -> Lit {
    var lit: Lit;
    lit.primary = vec4f(
        FrontMaterial.emission.rgb + FrontMaterial.ambient.rgb * LightModel.ambient.rgb,  // e_cm + a_cm a_cs
        FrontMaterial.diffuse.a);
    let n = surface.normal_eye;
    {  // GL_LIGHT1
        let vp = LightSource[1].position.xyz / LightSource[1].position.w - surface.position_eye;
        let vp_dir = unit(vp);
        let n_dot_vp = positive_dot(n, vp_dir);
        let reach = spot(unit(LightSource[1].spotDirection), LightSource[1].spotCosCutoff - 4.8e-7, LightSource[1].spotExponent, vp_dir);
        lit.primary += vec4f(reach * n_dot_vp * FrontMaterial.diffuse.rgb * LightSource[1].diffuse.rgb, 0.0);
    }
    lit.primary = saturate(lit.primary);  // section 2.14.6
    return lit;
}

@vertex
fn vertex_main(vertex: VertexInput) -> Varyings {
    var out: Varyings;
    out.position = matrices.ModelViewProjectionMatrix * vertex.Vertex;
    let surface = Surface((matrices.ModelViewMatrix * vertex.Vertex).xyz, matrices.NormalMatrix * vertex.Normal);
    out.v_front_primary = light_front(surface).primary;
    out.position.z = 0.5 * (out.position.z + out.position.w);  // WebGPU clips z to [0, w], GL to [-w, w]
    return out;
}

@fragment
fn fragment_main(in: Varyings) -> @location(0) vec4f {
    return in.v_front_primary;
}
