// What ray queries and the pipeline share where the driver's structure holds triangles, and its own test meets them: for
// methods that define RELIEVO_TRIANGLES. Such a method defines triangle_hit() in primitive_of_box()'s company: a hit of the
// driver's as a hit of the surface.
//
// Of triangles that a ray meets equally near, the driver takes which it likes, and near is what its own arithmetic says.

// The driver finds the nearest triangle by itself, but where there are holes, or where what a ray meets is counted: then it
// asks about every one that it may take (vulkan/programs.cpp agrees).
const bool kAskedAbout = kOpacity || kNotes != kNotesNone;
const uint kTriangleFlags = kAskedAbout ? gl_RayFlagsNoneEXT : gl_RayFlagsOpaqueEXT;

// Whether the triangle is there, or a hole.
bool accept_triangle(uint triangle, vec3 origin, vec3 direction, float t_min, float t, vec2 corners) {
    uint id = primitive_of_box(triangle);
    Primitive p = primitives[id];
    SurfaceHit hit = triangle_hit(triangle, origin, direction, t_min, t, corners);
    begin_notes(id, triangle);
    note(kNoteStep, hit.t, texel_at(p, hit.b), 0.0, 0.0);
    if (!opaque_at(p, hit.b)) return false;
    note(kNoteRoot, hit.t, texel_at(p, hit.b), 0.0, 0.0);
    note_hit(p, hit);
    return true;
}

TraceHit nearest_triangle(uint triangle, vec3 origin, vec3 direction, float t_min, float t, vec2 corners) {
    SurfaceHit hit = triangle_hit(triangle, origin, direction, t_min, t, corners);
    return TraceHit(primitive_of_box(triangle), hit.t, hit.b);
}
