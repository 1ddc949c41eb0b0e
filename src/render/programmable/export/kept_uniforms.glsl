// The uniforms of shaders to keep: GL's state under the names of GLSL 1.20's built-in uniforms (its section 7.5), without
// the prefix gl_, which later versions reserve. A stage declares only those that it uses (shader_assembly.h).

uniform mat4 ModelViewProjectionMatrix;  // glMatrixMode: the product of the projection and the modelview matrix
uniform mat4 ModelViewMatrix;  // from object to eye coordinates
uniform mat3 NormalMatrix;  // the transposed inverse of the modelview matrix's upper 3x3 (section 2.11.3)
uniform float NormalScale;  // GL_RESCALE_NORMAL's factor (section 2.11.3)
uniform mat4 TextureMatrix[1];
// glTexGen (section 2.11.4)
uniform vec4 ObjectPlaneS[1];
uniform vec4 ObjectPlaneT[1];
uniform vec4 ObjectPlaneR[1];
uniform vec4 ObjectPlaneQ[1];
uniform vec4 EyePlaneS[1];
uniform vec4 EyePlaneT[1];
uniform vec4 EyePlaneR[1];
uniform vec4 EyePlaneQ[1];
uniform SAMPLER Texture0;  // of texture unit 0
uniform vec4 TextureEnvColor[1];  // GL_TEXTURE_ENV_COLOR
uniform float TextureLodBias;  // GL_TEXTURE_LOD_BIAS (section 3.8.8)
uniform vec3 TextureInside;  // the part of s, t and r within a rim of one texel, which has the border's colour (section 3.8.7)
uniform sampler2D Framebuffer;  // the picture before these primitives, for glLogicOp (section 4.1.10)
uniform vec4 Viewport;  // glViewport (section 2.11.1): x, y, width, height
uniform float LineWidth;  // glLineWidth (section 3.4.2.1), in whole pixels unless lines are smooth
uniform int LineStippleFactor;  // glLineStipple (section 3.4.2)
uniform int LineStipplePattern;
uniform uint PolygonStipple[32];  // glPolygonStipple (section 3.5.2): rows from the bottom, the leftmost pixel in the lowest bit
uniform vec4 ClipPlane[8];  // glClipPlane, in eye coordinates (section 2.12)
uniform float PointSize;  // glPointSize (section 3.3)
uniform vec3 PointAttenuation;  // GL_POINT_DISTANCE_ATTENUATION (section 3.3)
uniform vec3 PointSizes;  // glPointSize, GL_POINT_SIZE_MIN, GL_POINT_SIZE_MAX
uniform vec3 BlendSource;  // glBlendColor (section 4.1.8), where it is the source factor
uniform float AlphaRef;  // glAlphaFunc (section 4.1.4)

// glMaterial (section 2.14.2)
struct MaterialParameters {
    vec4 emission;  // e_cm
    vec4 ambient;  // a_cm
    vec4 diffuse;  // d_cm
    vec4 specular;  // s_cm
    float shininess;  // s_rm
};
uniform MaterialParameters FrontMaterial;
uniform MaterialParameters BackMaterial;

// glLight (section 2.14.2)
struct LightSourceParameters {
    vec4 ambient;  // a_cli
    vec4 diffuse;  // d_cli
    vec4 specular;  // s_cli
    vec4 position;  // P_pli, in eye coordinates: glLight multiplied it by the modelview matrix
    vec4 halfVector;  // of a directional light: the direction of VP_i + (0, 0, 1), of length 1
    vec3 spotDirection;  // s_dli, in eye coordinates
    float spotExponent;  // s_rli
    float spotCutoff;  // c_rli, in degrees
    float spotCosCutoff;  // its cosine
    float constantAttenuation;  // k_0i
    float linearAttenuation;  // k_1i
    float quadraticAttenuation;  // k_2i
};
uniform LightSourceParameters LightSource[LIGHT_COUNT];  // LIGHT_NAMES

// glLightModel (section 2.14.2)
struct LightModelParameters {
    vec4 ambient;  // a_cs
};
uniform LightModelParameters LightModel;

// glFog (section 3.10)
struct FogParameters {
    vec4 color;
    float density;
    float start;
    float end;
    float scale;  // 1 / (end - start)
};
uniform FogParameters Fog;
