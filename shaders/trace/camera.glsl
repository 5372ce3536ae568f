// Rays of the camera and what a hit means to the layers.
vec3 camera_direction(vec2 px) {  // px: 0..size, centres at .5, row 0 at the top
    vec2 ndc = px / vec2(frame.size) * 2.0 - 1.0;
    return normalize(frame.forward + frame.right * ndc.x - frame.up * ndc.y);
}

const float kFar = 1e30;
