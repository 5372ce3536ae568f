// Light on the hit surface: a sun, point lights and a sky; diffuse (Lambert) and glossy (GGX, Walter and others 2007;
// Smith masking of Heitz 2014; Schlick's Fresnel) reflection. Angles and areas in world space, radiance linear.
const float kPi = 3.14159265;

vec3 sky_radiance(vec3 d) {
    float h = dot(d, frame.sky_up);
    return h >= 0.0 ? mix(frame.horizon, frame.zenith, sqrt(h)) : mix(frame.horizon, frame.ground, sqrt(min(1.0, -4.0 * h)));
}

// Irradiance / pi of the whole, unshadowed sky over a normal: the gradient's average, cheap and smooth.
vec3 sky_ambient(vec3 n) {
    vec3 upper = mix(frame.horizon, frame.zenith, 0.6), lower = mix(frame.horizon, frame.ground, 0.85);
    return mix(lower, upper, 0.5 + 0.5 * dot(n, frame.sky_up));
}

void orthonormal(vec3 n, out vec3 t, out vec3 b) {  // Duff and others 2017
    float s = n.z >= 0.0 ? 1.0 : -1.0;
    float a = -1.0 / (s + n.z), c = n.x * n.y * a;
    t = vec3(1.0 + s * n.x * n.x * a, s * c, -s * n.x);
    b = vec3(c, s + n.y * n.y * a, -n.y);
}

struct Shading {
    vec3 point, offset_point;  // offset_point: where secondary rays start
    vec3 ng, ns, view;         // geometric and shading normal towards the viewer, direction to the viewer
    vec3 base_ng, base_ns;     // of the surface without relief, outwards: geometric, and blended from the vertices'
    vec3 bulge;                // from there to the curved surface that base_ns tells of; 0 seen from inside
    ObjectData ob;
};

// Materials that reflect nothing straight on (specular 0) reflect nothing at grazing angles either: f90 follows f0.
float schlick(float f0, float limit, float cosine) {
    float f90 = min(limit, 50.0 * f0);
    return f0 + max(f90 - f0, 0.0) * pow(1.0 - cosine, 5.0);
}

float ggx_specular(Shading s, vec3 light) {
    vec3 h = normalize(light + s.view);
    float nh = max(dot(s.ns, h), 0.0), nl = max(dot(s.ns, light), 0.0), nv = max(dot(s.ns, s.view), 1e-3);
    float a = s.ob.roughness * s.ob.roughness, a2 = a * a;
    float d = nh * nh * (a2 - 1.0) + 1.0;
    float lambda = nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2);
    float fresnel = schlick(s.ob.specular, 1.0, max(dot(light, h), 0.0));
    return a2 / (kPi * d * d) * 0.5 / max(lambda, 1e-6) * fresnel;
}

vec3 reflected(Shading s, vec3 light, vec3 irradiance) {
    float cosine = max(dot(s.ns, light), 0.0);
    vec3 f = s.ob.albedo * (1.0 / kPi);
    if (kGloss) f += vec3(ggx_specular(s, light));
    return f * irradiance * cosine;
}

// Light that a source of the list sends to the point; `light` is the direction to it, `reach` the way to it.
vec3 light_irradiance(LightData l, vec3 point, vec2 u, out vec3 light, out float reach) {
    float r = sqrt(u.x), phi = 2.0 * kPi * u.y;
    vec3 t, b;
    if (l.is_point == 0u) {
        orthonormal(l.position, t, b);
        light = normalize(l.position + (t * cos(phi) + b * sin(phi)) * (r * l.size));
        reach = 1e30;
        return l.radiance;
    }
    vec3 to = l.position - point;
    orthonormal(normalize(to), t, b);
    to += (t * cos(phi) + b * sin(phi)) * (r * l.size);
    float d2 = max(dot(to, to), 1e-12);
    reach = sqrt(d2);
    light = to / reach;
    return l.radiance / d2;
}

// Rays from the surface towards lights and sky, and what each brings where nothing is in its way.
struct SecondaryRay {
    vec3 origin, direction;
    float reach;
    vec3 radiance;  // reflected to the viewer
};

// Else its diffuse light is taken from all around, unshadowed.
bool sky_is_traced(bool preview) { return kSky && kShadows && !preview; }

uint secondary_rays(bool preview) { return frame.light_count + (sky_is_traced(preview) ? 1u : 0u); }

// The sky's diffuse light by one cosine-distributed direction a sample.
bool sky_ray(Shading s, uint pixel, out SecondaryRay ray) {
    float u = random_at(pixel, push.sample_index, 0x52000000u), v = random_at(pixel, push.sample_index, 0x52000001u);
    float r = sqrt(u), phi = 2.0 * kPi * v;
    vec3 t, b;
    orthonormal(s.ns, t, b);
    ray.origin = s.offset_point;
    ray.direction = normalize(t * (r * cos(phi)) + b * (r * sin(phi)) + s.ns * sqrt(max(0.0, 1.0 - u)));
    ray.reach = 1e30;
    ray.radiance = s.ob.albedo * sky_radiance(ray.direction);
    return dot(ray.direction, s.ng) > 0.0;
}

// Whether the base triangle turns away from light that still grazes the curved surface it stands for. Its own shadow would
// show the triangles of a coarse mesh as teeth: there, and only there, shadow rays start from the curved surface (Hanika
// 2021), so that relief keeps its shadows on all triangles that the light reaches.
bool beyond_terminator(Shading s, vec3 light) {
    return dot(s.base_ng, light) <= 0.0 && dot(s.base_ns, light) > 0.0 && s.bulge != vec3(0.0);
}

// False where the i-th ray brings nothing.
bool secondary_ray(Shading s, uint i, uint pixel, bool preview, out SecondaryRay ray) {
    if (i >= frame.light_count) return sky_ray(s, pixel, ray);
    vec2 u = preview ? vec2(0.0) : vec2(random_at(pixel, push.sample_index, 0x51000000u + 2u * i),
                                        random_at(pixel, push.sample_index, 0x51000001u + 2u * i));
    vec3 irradiance = light_irradiance(frame.lights[i], s.point, u, ray.direction, ray.reach);
    ray.radiance = reflected(s, ray.direction, irradiance);
    bool lifted = beyond_terminator(s, ray.direction);
    ray.origin = s.offset_point + (lifted ? s.bulge : vec3(0.0));
    return (lifted || dot(s.ng, ray.direction) > 0.0) && dot(s.ns, ray.direction) > 0.0;
}

// Light of the sky that no ray asks for: its mirror image, and where shadows are not wanted or only hard ones its diffuse light.
vec3 unshadowed_sky(Shading s, bool preview) {
    vec3 sum = vec3(0.0);
    if (!kSky) return sum;
    if (!sky_is_traced(preview)) sum += s.ob.albedo * sky_ambient(s.ns) * (preview ? 0.8 : 1.0);
    if (kGloss) {
        float fresnel = schlick(s.ob.specular, 1.0 - s.ob.roughness, max(dot(s.ns, s.view), 0.0));
        sum += fresnel * mix(sky_radiance(reflect(-s.view, s.ns)), sky_ambient(s.ns), s.ob.roughness);
    }
    return sum;
}
