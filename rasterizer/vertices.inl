// Vertices side by side: transform, outcode, divide, viewport, snap.

constexpr int vertex_lanes = 16;

struct VertexLanes {
    alignas(64) float p_world[3][vertex_lanes];
    alignas(64) double x_clip[vertex_lanes], y_clip[vertex_lanes], w[vertex_lanes], depth[vertex_lanes];
    alignas(64) std::int32_t code[vertex_lanes], in_guard_band[vertex_lanes];
    alignas(64) std::int32_t x[vertex_lanes], y[vertex_lanes];
    alignas(64) double inverse_depth[vertex_lanes];

    void load(const glm::vec3* position_world);
    void transform(const ClipTransform& clip_from_world);
    void find_outcodes(const ClipVolume& volume);
    void land(const ViewSetup& setup);
    void store(SnappedVertex* snapped, std::uint8_t* to_outcode) const;

    ClipVertex clip_vertex(int i) const { return {x_clip[i], y_clip[i], w[i], depth[i]}; }
};

void VertexLanes::load(const glm::vec3* position_world) {
    for (int i = 0; i < vertex_lanes; ++i) {
        p_world[0][i] = position_world[i].x;
        p_world[1][i] = position_world[i].y;
        p_world[2][i] = position_world[i].z;
    }
}

void VertexLanes::transform(const ClipTransform& clip_from_world) {
    const ClipTransform transform = clip_from_world;
    for (int i = 0; i < vertex_lanes; ++i) {
        const ClipVertex v = transform.at(p_world[0][i], p_world[1][i], p_world[2][i]);
        x_clip[i] = v.x;
        y_clip[i] = v.y;
        w[i] = v.w;
        depth[i] = v.depth;
    }
}

void VertexLanes::find_outcodes(const ClipVolume& of_view) {
    const ClipVolume volume = of_view;
    for (int i = 0; i < vertex_lanes; ++i) code[i] = outcode_of(clip_vertex(i), volume);
}

void VertexLanes::land(const ViewSetup& of_view) {
    const ViewSetup setup = of_view;
    for (int i = 0; i < vertex_lanes; ++i) {
        const ViewSetup::GuardedVertex guarded = setup.land(clip_vertex(i));
        in_guard_band[i] = guarded.in_guard_band;
        x[i] = guarded.vertex.p.x;
        y[i] = guarded.vertex.p.y;
        inverse_depth[i] = guarded.vertex.inverse_depth;
    }
}

void VertexLanes::store(SnappedVertex* snapped, std::uint8_t* to_outcode) const {
    put_one_by_one(x, y, inverse_depth, snapped);
    for (int i = 0; i < vertex_lanes; ++i) {
        const bool is_lost = ((code[i] & outcode::needs_clip) == 0) & (in_guard_band[i] == 0);
        to_outcode[i] = std::uint8_t(is_lost ? outcode::not_finite : code[i]);
    }
}

/// Projects as many vertices as there are lanes.
void project_lanes(const ViewSetup& setup, const glm::vec3* position_world, SnappedVertex* snapped,
                   std::uint8_t* outcode) {
    VertexLanes lanes;
    lanes.load(position_world);
    lanes.transform(setup.clip_from_world);
    lanes.find_outcodes(setup.volume);
    lanes.land(setup);
    lanes.store(snapped, outcode);
}

void project(const VertexWork& work) noexcept {
    std::size_t first = 0;
    for (; first + vertex_lanes <= work.count; first += vertex_lanes)
        project_lanes(work.setup, work.position_world + first, work.snapped + first, work.outcode + first);
    if (first == work.count) return;
    glm::vec3 position_world[vertex_lanes] = {};
    SnappedVertex snapped[vertex_lanes];
    std::uint8_t outcode[vertex_lanes];
    for (std::size_t i = first; i < work.count; ++i) position_world[i - first] = work.position_world[i];
    project_lanes(work.setup, position_world, snapped, outcode);
    for (std::size_t i = first; i < work.count; ++i) {
        work.snapped[i] = snapped[i - first];
        work.outcode[i] = outcode[i - first];
    }
}
