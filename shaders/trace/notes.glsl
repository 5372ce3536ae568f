// What a ray costs and does: counts a pixel, or a log of one ray. Nothing of it is left where kNotes is kNotesNone.
layout(set = 0, binding = kBindRayCounts, scalar) buffer RayCountBlock { uvec4 ray_counts[]; };
layout(set = 0, binding = kBindNotes, scalar) buffer NoteBlock { uint note_count; uint note_spare[3]; Note notes[]; };

uvec4 counted = uvec4(0u);    // boxes, steps, fetches, cells since the last flush
uint asked_primitive = 0u;     // the triangle whose method is running,
uint asked_box = 0u;           // and its box that was met

void count_fetch() { if (kNotes == kNotesCounts) ++counted.z; }

// `texel` relative to the primitive's base; `extent` as in Note.
void note(uint kind, float t, vec2 texel, float height, float extent) {
    if (kNotes == kNotesCounts) {
        if (kind == kNoteBox) ++counted.x;
        if (kind == kNoteStep) ++counted.y;
        if (kind == kNoteCell) ++counted.w;
    } else if (kNotes == kNotesLog) {
        uint i = atomicAdd(note_count, 1u);
        if (i >= kMaxNotes) return;
        notes[i] = Note(kind, asked_primitive, t, height, texel + primitive_base(primitives[asked_primitive]), extent, 0.0);
    }
}

void begin_notes(uint primitive, uint box) {
    asked_primitive = primitive;
    asked_box = box;
    note(kNoteBox, 0.0, vec2(0.0), 0.0, 0.0);
}

// Shaders of the pipeline share no variables: what one box cost is added where the pixel keeps it.
void flush_counts(uint pixel) {
    if (kNotes != kNotesCounts) return;
    atomicAdd(ray_counts[pixel].x, counted.x);
    atomicAdd(ray_counts[pixel].y, counted.y);
    atomicAdd(ray_counts[pixel].z, counted.z);
    atomicAdd(ray_counts[pixel].w, counted.w);
    counted = uvec4(0u);
}
