// Vertices side by side: transform, outcode, divide, viewport, snap.

constexpr int vertex_lanes = 16;

struct VertexLanes {
    alignas(64) float p_world[3][vertex_lanes];
    alignas(64) double x_clip[vertex_lanes], y_clip[vertex_lanes], w[vertex_lanes], depth[vertex_lanes];
    alignas(64) std::int32_t outcode[vertex_lanes], in_guard_band[vertex_lanes];
    alignas(64) std::int32_t x[vertex_lanes], y[vertex_lanes];
    alignas(64) double nearness[vertex_lanes];

    void load(const glm::vec3* position_world, int last);
    void transform(const ClipTransform& clip_from_world);
    void find_outcodes(const ClipVolume& volume);
    void land(const ViewSetup& setup);

    ClipVertex clip_vertex(int i) const { return {x_clip[i], y_clip[i], w[i], depth[i]}; }
};

/// Lanes are filled up with the last vertex.
void VertexLanes::load(const glm::vec3* position_world, int last) {
    for (int i = 0; i < vertex_lanes; ++i) {
        const glm::vec3& p = position_world[lesser(i, last)];
        p_world[0][i] = p.x;
        p_world[1][i] = p.y;
        p_world[2][i] = p.z;
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
    for (int i = 0; i < vertex_lanes; ++i) outcode[i] = outcode_of(clip_vertex(i), volume);
}

void VertexLanes::land(const ViewSetup& of_view) {
    const ViewSetup setup = of_view;
    for (int i = 0; i < vertex_lanes; ++i) {
        const ViewSetup::Landed landed = setup.land(clip_vertex(i));
        in_guard_band[i] = landed.in_guard_band;
        x[i] = landed.vertex.p.x;
        y[i] = landed.vertex.p.y;
        nearness[i] = landed.vertex.nearness;
    }
}

void project(const VertexWork& work) noexcept {
    VertexLanes lanes;
    for (std::size_t first = 0; first < work.count; first += vertex_lanes) {
        const int last = lesser(vertex_lanes, std::int32_t(work.count - first)) - 1;
        lanes.load(work.position_world + first, last);
        lanes.transform(work.setup.clip_from_world);
        lanes.find_outcodes(work.setup.volume);
        lanes.land(work.setup);
        for (int i = 0; i <= last; ++i) {
            const std::int32_t code = lanes.outcode[i];
            const bool is_lost = (code & outcode::needs_clip) == 0 && lanes.in_guard_band[i] == 0;
            work.snapped[first + std::size_t(i)] = {{lanes.x[i], lanes.y[i]}, lanes.nearness[i]};
            work.outcode[first + std::size_t(i)] = std::uint8_t(is_lost ? outcode::not_finite : code);
        }
    }
}
