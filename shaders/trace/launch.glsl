// The pixel whose ray asks, for shaders that the pipeline calls on its way: the one that the other ways of tracing hash, by
// the window's offset and this launch; picking counts its rays.
uint launch_pixel() {
    return push.ray_count > 0u ? gl_LaunchIDEXT.x : pixel_index(push.offset + ivec2(gl_LaunchIDEXT.xy));
}
