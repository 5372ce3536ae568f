// Rays of the camera and what a hit means to the layers.
vec3 camera_direction(vec2 px) {  // px: 0..size, centres at .5, row 0 at the top
    vec2 ndc = px / vec2(frame.size) * 2.0 - 1.0;
    return normalize(frame.forward + frame.right * ndc.x - frame.up * ndc.y);
}

const float kFar = 1e30;

// The pixel at a place of the window that is traced. False beyond the window or the image: then an invocation goes along
// without a ray of its own, and its pixel is another's.
bool window_pixel(ivec2 local, out ivec2 px) {
    px = min(push.offset + local, frame.size - 1);
    return all(lessThan(local, push.extent)) && all(lessThan(push.offset + local, frame.size));
}
