// Triangles side by side: which way they face, and which tiles they may cover samples of.

/// Places triangles of both windings, or only the counter-clockwise (setup.facing). Where the snapped area is
/// 0, or no sample of the image is in the bounding box, no sample is covered. Areas are whole numbers <= 2^51
/// (see guard_band_px).
PlacedLanes place(const ViewSetup& setup, const CornerLanes& corners) noexcept {
    const SubpixelGrid grid = setup.grid;
    const std::int32_t width = setup.size.width, height = setup.size.height;
    const double px_per_doubled_area = 0.5 / double(std::int64_t{1} << 2 * grid.bits);
    const std::int32_t only_front = setup.facing == Facing::front ? 1 : 0;
    const auto& [a, b, c] = corners.corner;
    PlacedLanes placed;
    alignas(64) std::int32_t cover_px[CornerLanes::count];
    std::int32_t differ = 0;
    std::int64_t all_cover_px = 0;
    for (int i = 0; i < CornerLanes::count; ++i) {
        const double doubled_area = double(b[i].x - a[i].x) * double(c[i].y - a[i].y) -
                                    double(b[i].y - a[i].y) * double(c[i].x - a[i].x);
        const std::int32_t left = min(min(a[i].x, b[i].x), c[i].x);
        const std::int32_t right = max(max(a[i].x, b[i].x), c[i].x);
        const std::int32_t top = min(min(a[i].y, b[i].y), c[i].y);
        const std::int32_t bottom = max(max(a[i].y, b[i].y), c[i].y);
        const std::int32_t x0 = max(0, grid.first_pixel_from(left));
        const std::int32_t y0 = max(0, grid.first_pixel_from(top));
        const std::int32_t x1 = min(width - 1, grid.last_pixel_until(right));
        const std::int32_t y1 = min(height - 1, grid.last_pixel_until(bottom));
        const std::int32_t may_cover = (doubled_area != 0) & (x0 <= x1) & (y0 <= y1);
        const std::int32_t faces_away = may_cover & only_front & (doubled_area > 0);
        const bool is_drawn = may_cover & ~faces_away;
        placed.column0[i] = is_drawn ? x0 / tile_size : 1;
        placed.column1[i] = is_drawn ? x1 / tile_size : 0;
        placed.row0[i] = y0 / tile_size;
        placed.row1[i] = y1 / tile_size;
        placed.turn[i] = doubled_area < 0 ? turned : 0;
        placed.faces_away[i] = faces_away;
        const std::int32_t box_px = is_drawn ? (x1 - x0 + 1) * (y1 - y0 + 1) : 0;  // at most 2^30
        const double area_px = px_per_doubled_area * (doubled_area < 0 ? -doubled_area : doubled_area);
        cover_px[i] = std::int32_t(min(area_px, double(box_px)));
    }
    for (int i = 0; i < CornerLanes::count; ++i)
        differ |= (placed.column0[i] ^ placed.column1[i]) | (placed.row0[i] ^ placed.row1[i]) |
                  (placed.column0[i] ^ placed.column0[0]) | (placed.row0[i] ^ placed.row0[0]);
    for (int i = 0; i < CornerLanes::count; ++i) all_cover_px += cover_px[i];
    placed.in_one_tile = differ == 0;
    placed.cover_px = std::uint64_t(all_cover_px);
    return placed;
}
