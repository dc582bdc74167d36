#version 330 core
// Many lamps on a bumpy surface, physically based: Lambert below, above it microfacets with the
// distribution of GGX, Smith's masking and Schlick's Fresnel term. Everything depends on world
// coordinates and the eye's place alone, never on derivatives or the view, so that views agree.

const int LAMPS_MAX = 64;
const float PI = 3.14159265;

uniform int lamp_count;
uniform vec3 lamp_places[LAMPS_MAX]; // world
uniform vec3 lamp_colors[LAMPS_MAX]; // the light at distance d is this / d^2
uniform float bump_size;             // width of the coarsest bumps, world units
uniform int octaves;                 // of bumps, 0 to 2
uniform float smoothest;             // the least roughness

// A number from 0 to 1 for every point of the lattice.
float lattice(ivec3 at)
{
    uint h = uint(at.x) * 0x9e3779b1u ^ uint(at.y) * 0x85ebca77u ^ uint(at.z) * 0xc2b2ae3du;
    h = (h ^ (h >> 15u)) * 0x2c1b3c6du;
    h = (h ^ (h >> 12u)) * 0x297a2d39u;
    return float((h ^ (h >> 15u)) >> 8u) / 16777216.0;
}

// The gradient (xyz) and value (w) of noise that is smooth between the points of the lattice.
vec4 noise(vec3 place)
{
    vec3 base = floor(place), f = place - base;
    vec3 u = f * f * f * (f * (f * 6.0 - 15.0) + 10.0);
    vec3 slope = 30.0 * f * f * (f * (f - 2.0) + 1.0);
    ivec3 at = ivec3(base);
    float a = lattice(at), b = lattice(at + ivec3(1, 0, 0));
    float c = lattice(at + ivec3(0, 1, 0)), d = lattice(at + ivec3(1, 1, 0));
    float e = lattice(at + ivec3(0, 0, 1)), g = lattice(at + ivec3(1, 0, 1));
    float h = lattice(at + ivec3(0, 1, 1)), k = lattice(at + ivec3(1, 1, 1));
    float x = b - a, y = c - a, z = e - a;
    float xy = a - b - c + d, yz = a - c - e + h, zx = a - b - e + g;
    float xyz = -a + b + c - d + e - g - h + k;
    vec3 gradient = vec3(x + xy * u.y + zx * u.z + xyz * u.y * u.z,
                         y + yz * u.z + xy * u.x + xyz * u.z * u.x,
                         z + zx * u.x + yz * u.y + xyz * u.x * u.y);
    float value = a + x * u.x + y * u.y + z * u.z + xy * u.x * u.y + yz * u.y * u.z +
                  zx * u.z * u.x + xyz * u.x * u.y * u.z;
    return vec4(slope * gradient, value);
}

// Octaves of bumps; each fades before it gets finer than a pixel or so. A loop, because rasterisers
// in software skip one that has nothing to do, but compute both sides of a condition.
vec4 bumps(vec3 place, float far_off)
{
    vec4 sum = vec4(0.0, 0.0, 0.0, octaves > 0 ? 0.0 : 0.5);
    for (int i = 0; i < octaves; i++) {
        float seen = bump_size / far_off;
        bool fine = i > 0;
        float fade = fine ? smoothstep(0.016, 0.08, seen) : smoothstep(0.006, 0.03, seen);
        sum += (fine ? 0.4 : 0.6) * fade * noise(place * ((fine ? 2.7 : 1.0) / bump_size));
    }
    return sum;
}

vec3 reflected(vec3 base, vec3 normal, vec3 to_eye, vec3 to_lamp, float roughness)
{
    vec3 halfway = normalize(to_eye + to_lamp);
    float lamp_cos = max(dot(normal, to_lamp), 0.0);
    float eye_cos = max(dot(normal, to_eye), 1e-3);
    float half_cos = max(dot(normal, halfway), 0.0);
    float squared = roughness * roughness * roughness * roughness;
    float lobe = half_cos * half_cos * (squared - 1.0) + 1.0;
    float distribution = squared / (PI * lobe * lobe);
    float masking = 0.5 / (lamp_cos * sqrt(eye_cos * eye_cos * (1.0 - squared) + squared) +
                           eye_cos * sqrt(lamp_cos * lamp_cos * (1.0 - squared) + squared));
    float grazing = 1.0 - max(dot(to_eye, halfway), 0.0);
    float fresnel = 0.04 + 0.96 * grazing * grazing * grazing * grazing * grazing;
    return ((1.0 - fresnel) / PI * base + distribution * masking * fresnel) * lamp_cos;
}

vec3 shaded(vec3 base, vec3 place, vec3 normal, vec3 eye)
{
    float far_off = distance(eye, place);
    vec3 to_eye = (eye - place) / max(far_off, 1e-6);
    normal = normalize(normal);
    vec4 bump = bumps(place, max(far_off, 1e-6));
    vec3 along = bump.xyz - normal * dot(normal, bump.xyz);
    normal = normalize(normal - 0.5 * along);
    float roughness = smoothest + 0.4 * (1.0 - bump.w);
    // Colours have a gamma of 2 here, light is linear.
    vec3 linear = base * base;
    vec3 light = linear * mix(vec3(0.08, 0.07, 0.06), vec3(0.22, 0.26, 0.31), 0.5 + 0.5 * normal.y);
    for (int i = 0; i < lamp_count; i++) {
        vec3 to_lamp = lamp_places[i] - place;
        float squared = dot(to_lamp, to_lamp);
        light += lamp_colors[i] / squared *
                 reflected(linear, normal, to_eye, to_lamp * inversesqrt(squared), roughness);
    }
    return sqrt(1.0 - exp(-light));
}
