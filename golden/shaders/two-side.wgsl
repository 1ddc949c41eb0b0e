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
}
@group(0) @binding(1) var<uniform> FrontMaterial: MaterialParameters;
@group(0) @binding(2) var<uniform> BackMaterial: MaterialParameters;

// glLight (section 2.14.2)
struct LightSourceParameters {
    diffuse: vec4f,  // d_cli
    position: vec4f,  // P_pli, in eye coordinates: glLight multiplied it by the modelview matrix
}
@group(0) @binding(3) var<uniform> LightSource: array<LightSourceParameters, 1>;  // GL_LIGHT0

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
    @location(1) v_back_primary: vec4f,
}

// v scaled to length 1; the zero vector stays 0.
fn unit(v: vec3f) -> vec3f {
    return v / max(length(v), 1e-18);
}

// max(a . b, 0): written as a dot in a circle in section 2.14.1.
fn positive_dot(a: vec3f, b: vec3f) -> f32 {
    return max(dot(a, b), 0.0);
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
}

// The colours of the front face (section 2.14.1).
fn light_front(surface: Surface) -> Lit {
    var lit: Lit;
    lit.primary = vec4f(
        FrontMaterial.emission.rgb + FrontMaterial.ambient.rgb * LightModel.ambient.rgb,  // e_cm + a_cm a_cs
        FrontMaterial.diffuse.a);
    let n = surface.normal_eye;
    {  // GL_LIGHT0
        let vp_dir = unit(LightSource[0].position.xyz);
        let n_dot_vp = positive_dot(n, vp_dir);
        lit.primary += vec4f(n_dot_vp * FrontMaterial.diffuse.rgb * LightSource[0].diffuse.rgb, 0.0);
    }
    lit.primary = saturate(lit.primary);  // section 2.14.6
    return lit;
}

// The colours of the back face (section 2.14.1).
fn light_back(surface: Surface) -> Lit {
    var lit: Lit;
    lit.primary = vec4f(
        BackMaterial.emission.rgb + BackMaterial.ambient.rgb * LightModel.ambient.rgb,  // e_cm + a_cm a_cs
        BackMaterial.diffuse.a);
    let n = surface.normal_eye;
    {  // GL_LIGHT0
        let vp_dir = unit(LightSource[0].position.xyz);
        let n_dot_vp = positive_dot(n, vp_dir);
        lit.primary += vec4f(n_dot_vp * BackMaterial.diffuse.rgb * LightSource[0].diffuse.rgb, 0.0);
    }
    lit.primary = saturate(lit.primary);  // section 2.14.6
    return lit;
}

@vertex
fn vertex_main(vertex: VertexInput) -> Varyings {
    var out: Varyings;
    out.position = matrices.ModelViewProjectionMatrix * vertex.Vertex;
    var surface = Surface(matrices.NormalMatrix * vertex.Normal);
    let front = light_front(surface);
    // The back face has its own material and the opposite normal. The fragment shader picks the visible face.
    surface.normal_eye = -surface.normal_eye;
    let back = light_back(surface);
    out.v_front_primary = front.primary;
    out.v_back_primary = back.primary;
    out.position.z = 0.5 * (out.position.z + out.position.w);  // WebGPU clips z to [0, w], GL to [-w, w]
    return out;
}

@fragment
fn fragment_main(in: Varyings, @builtin(front_facing) front_facing: bool) -> @location(0) vec4f {
    return select(in.v_back_primary, in.v_front_primary, front_facing);
}
