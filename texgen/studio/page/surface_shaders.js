// SPDX-License-Identifier: Apache-2.0

// Shaders of the lit preview (surface.js).

export const kVertexShader = `#version 300 es
precision highp float;

in vec3 a_position;
in vec3 a_normal;
in vec3 a_tangent;
in vec2 a_uv;
in vec2 a_rise;  // x: factor on the displacement; y: 1 on the walls of the slab, 0 elsewhere

uniform mat3 u_turn;        // turns the shape
uniform mat4 u_projection;  // from turned positions to the clip space
uniform float u_repeat;     // tiles per unit of a_uv
uniform float u_origin;     // both texture coordinates of the middle of the shape's front, in tiles
uniform float u_tile_width; // in units of positions
uniform float u_height_scale;  // tile widths per unit of the height map
uniform float u_height_middle; // the height that is not displaced, in tile widths
uniform float u_height_lod;    // level of detail that the mesh can show without aliasing
uniform sampler2D u_height;

out vec3 v_position;
out vec3 v_normal;
out vec3 v_tangent;
out vec3 v_bitangent;
out vec2 v_uv;
out float v_wall;

void main() {
    v_uv = a_uv * u_repeat + u_origin;
    v_uv.y = -v_uv.y;  // the first row of an image is its top
    float height = textureLod(u_height, v_uv, u_height_lod).r * u_height_scale - u_height_middle;
    vec3 position = a_position + a_normal * (height * u_tile_width * a_rise.x);
    v_position = u_turn * position;
    v_normal = u_turn * a_normal;
    v_tangent = u_turn * a_tangent;
    v_bitangent = cross(v_normal, v_tangent);
    v_wall = a_rise.y;
    gl_Position = u_projection * vec4(v_position, 1.0);
}
`;

export const kFragmentShader = `#version 300 es
precision highp float;

in vec3 v_position;
in vec3 v_normal;
in vec3 v_tangent;
in vec3 v_bitangent;
in vec2 v_uv;
in float v_wall;

uniform vec3 u_camera;     // position
uniform vec3 u_light;      // direction to the light
uniform vec3 u_sky;        // direction to the middle of the sky
uniform float u_strength;  // a white surface that faces the light reflects this brightness
uniform float u_ambient;   // brightness of a white surface below the whole sky
uniform vec2 u_slopes;     // factors on the components x and y of the normals
uniform float u_height_top;  // the largest height, in tile widths
uniform float u_shadow_steps;  // largest number of steps that look for a shadow
uniform vec3 u_background;   // sRGB

uniform sampler2D u_base_color;
uniform sampler2D u_normal;
uniform sampler2D u_data;  // occlusion, roughness, metallic, and height divided by u_height_top
uniform sampler2D u_emission;

out vec4 o_color;

const float kPi = 3.14159265;

struct Material {
    vec3 diffuse;
    vec3 reflectance;  // at perpendicular incidence
    float roughness;
    float occlusion;
};

// The distribution of microfacets by Trowbridge and Reitz (GGX), and the visibility of Smith with correlated heights,
// in the approximation of Hammon, "PBR diffuse lighting for GGX+Smith microsurfaces", 2017.
float specular_lobe(float n_h, float n_v, float n_l, float alpha) {
    float squared = alpha * alpha;
    float width = n_h * n_h * (squared - 1.0) + 1.0;
    float distribution = squared / (kPi * width * width);
    float visibility = 0.5 / max(mix(2.0 * n_l * n_v, n_l + n_v, alpha), 1e-4);
    return distribution * visibility;
}

// The directional albedo of the specular lobe in a white surrounding (Karis, "Physically based shading on mobile",
// 2014).
vec3 specular_albedo(vec3 reflectance, float roughness, float n_v) {
    vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float grazing = min(r.x * r.x, exp2(-9.28 * n_v)) * r.x + r.y;
    vec2 factors = vec2(-1.04, 1.04) * grazing + r.zw;
    return reflectance * factors.x + factors.y;
}

const vec3 kZenith = vec3(0.95, 1.0, 1.06);
const vec3 kGround = vec3(0.36, 0.34, 0.32);

// The brightness of the surroundings in a direction, blurred as a surface of this roughness reflects them: a sky, a
// darker ground, a bright band above the horizon, and two large soft lamps.
vec3 surroundings(vec3 direction, float roughness) {
    float up = dot(direction, u_sky);
    float blur = 0.06 + roughness;
    vec3 color = mix(kGround, kZenith * 0.8, smoothstep(-blur, blur, up));
    color += 0.5 * exp(-abs(up - 0.15) / (0.15 + 0.6 * roughness)) * (1.0 - 0.7 * roughness);
    float sharpness = 24.0 / (1.0 + 24.0 * roughness * roughness);
    vec3 side = normalize(vec3(0.85, 0.25, 0.5));
    vec3 top = normalize(u_sky + vec3(-0.5, 0.2, 0.35));
    float size = 0.15 + 0.85 * sharpness / 24.0;
    color += size * 1.1 * exp(sharpness * (dot(direction, side) - 1.0));
    color += size * 1.6 * exp(sharpness * (dot(direction, top) - 1.0));
    return color;
}

// The fraction of the reflected surroundings that the relief does not hide (Lagarde and de Rousiers, "Moving Frostbite
// to physically based rendering", 2014).
float specular_occlusion(float n_v, float occlusion, float roughness) {
    return clamp(pow(n_v + occlusion, exp2(-16.0 * roughness - 1.0)) - 1.0 + occlusion, 0.0, 1.0);
}

vec3 direct_light(Material material, vec3 normal, vec3 view) {
    vec3 halfway = normalize(view + u_light);
    float n_l = max(dot(normal, u_light), 0.0);
    float n_v = max(dot(normal, view), 1e-3);
    float n_h = max(dot(normal, halfway), 0.0);
    float v_h = max(dot(view, halfway), 0.0);
    vec3 fresnel = material.reflectance + (1.0 - material.reflectance) * pow(1.0 - v_h, 5.0);
    float alpha = material.roughness * material.roughness;
    vec3 specular = fresnel * (specular_lobe(n_h, n_v, n_l, alpha) * kPi);
    return (material.diffuse * (1.0 - fresnel) + specular) * (n_l * u_strength);
}

vec3 ambient_light(Material material, vec3 normal, vec3 view) {
    float n_v = clamp(dot(normal, view), 0.0, 1.0);
    vec3 sky = mix(kGround, vec3(1.0), 0.5 + 0.5 * dot(normal, u_sky));
    vec3 albedo = specular_albedo(material.reflectance, material.roughness, n_v);
    vec3 diffuse = material.diffuse * (1.0 - albedo) * sky * material.occlusion;
    vec3 mirrored = surroundings(reflect(-view, normal), material.roughness);
    float visible = specular_occlusion(n_v, material.occlusion, material.roughness);
    return (diffuse + mirrored * albedo * visible) * u_ambient;
}

// The fraction of the light that the relief lets through. Marches through the height map from the surface toward the
// light, until the ray has risen to the largest height or by a quarter of a tile width. The penumbra grows with the
// distance to the blocker.
float visible_light(vec3 tangent, vec3 bitangent, vec3 normal, float start) {
    vec3 light = vec3(dot(u_light, tangent), dot(u_light, bitangent), dot(u_light, normal));
    float reach = min(u_height_top - start, 0.25);
    vec2 across = light.xy / max(light.z, 0.08);
    vec2 texels = vec2(textureSize(u_data, 0));
    float span = length(across * reach * texels);
    if (light.z <= 0.0 || span < 1.0 || u_shadow_steps < 1.0) {
        return 1.0;
    }
    float steps = clamp(ceil(span * 0.5), 1.0, u_shadow_steps);
    float lod = max(log2(span / steps) - 0.5, 0.0);
    float blocked = 0.0;
    for (float k = 1.0; k <= steps; ++k) {
        float rise = reach * (k - 0.5) / steps;
        vec2 uv = v_uv + vec2(across.x, -across.y) * rise;
        float above = textureLod(u_data, uv, lod).a * u_height_top - start - rise;
        blocked = max(blocked, above / (0.15 * rise + 0.02 * u_height_top));
    }
    return 1.0 - clamp(blocked, 0.0, 1.0);
}

// Nearly keeps colors up to 0.8 and compresses brighter ones toward white: "PBR Neutral" of the
// Khronos Group (2024). This function removes kVeil, the brightness that reflected surroundings add
// to every color. The original has 0.04 instead of kVeil, for brighter surroundings.
vec3 tone_mapped(vec3 color) {
    const float kVeil = 0.016;
    const float kStart = 0.8 - kVeil;
    const float kDesaturation = 0.15;
    float least = min(color.r, min(color.g, color.b));
    color -= least < 2.0 * kVeil ? least - least * least / (4.0 * kVeil) : kVeil;
    float peak = max(color.r, max(color.g, color.b));
    if (peak < kStart) {
        return color;
    }
    float room = 1.0 - kStart;
    float compressed = 1.0 - room * room / (peak + room - kStart);
    float white = 1.0 - 1.0 / (kDesaturation * (peak - compressed) + 1.0);
    return mix(color * (compressed / peak), vec3(compressed), white);
}

vec3 srgb(vec3 light) {
    vec3 clamped = clamp(light, 0.0, 1.0);
    return mix(1.055 * pow(clamped, vec3(1.0 / 2.4)) - 0.055, 12.92 * clamped,
               vec3(lessThan(clamped, vec3(0.0031308))));
}

void main() {
    vec3 face = normalize(v_normal);
    vec3 tangent = normalize(v_tangent - face * dot(face, v_tangent));
    vec3 bitangent = normalize(v_bitangent);
    vec3 view = normalize(u_camera - v_position);
    vec4 color = texture(u_base_color, v_uv);
    vec4 data = texture(u_data, v_uv);
    vec3 slopes = texture(u_normal, v_uv).xyz * 2.0 - 1.0;

    // A texel of a mip level is the mean of normals. The shorter this mean is, the more the normals
    // differ, and the rougher the surface looks from far away (Toksvig, "Mipmapping normal maps",
    // 2004).
    float size = clamp(length(slopes), 0.1, 1.0);
    float variance = clamp((1.0 - size) / size - 0.006, 0.0, 0.3);  // 0.006: rounding to 8 bits
    float alpha = max(data.g * data.g, 0.004);
    float roughness = pow(alpha * alpha + variance, 0.25);

    vec3 normal = normalize(tangent * slopes.x * u_slopes.x + bitangent * slopes.y * u_slopes.y + face * slopes.z);
    // The fraction of the direct light that reaches the point.
    float unshaded = smoothstep(-0.05, 0.2, dot(face, u_light));
    if (v_wall > 0.5) {
        face = normalize(cross(dFdx(v_position), dFdy(v_position)));
        normal = face;
        unshaded = step(0.0, dot(face, u_light));
    } else if (unshaded > 0.0) {
        unshaded *= visible_light(tangent, bitangent, face, data.a * u_height_top);
    }

    Material material = Material(color.rgb * (1.0 - data.b), mix(vec3(0.04), color.rgb, data.b), roughness, data.r);
    vec3 light = ambient_light(material, normal, view) + texture(u_emission, v_uv).rgb;
    if (unshaded > 0.0) {
        light += unshaded * direct_light(material, normal, view);
    }
    o_color = vec4(mix(u_background, srgb(tone_mapped(light)), color.a), 1.0);
}
`;
