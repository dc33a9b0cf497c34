// Blocks of any reads, for Colour of the file that includes it after taps.inl:
//   Colour   four doubles: from a lookup's sum, add(texel, weight), to the sum

/// Fills the last lanes, so that they have something to read.
void fill_up(Block& block) {
    for (int i = block.count; i % lanes != 0; ++i) {
        block.x[i] = block.y[i] = block.weight[i] = 0;
        block.level[i] = 0;
    }
}

template <Wrap wrap_u, Wrap wrap_v>
void find_wrapped(const Chain& chain, Block& block) {
    for (int i = 0; i < block.count; i += lanes) {
        const Images images{chain.levels, [&](const double* of) { return gather(of, block.level + i); }};
        const Taps taps{images, load(block.weight + i), surrounding<wrap_u>(load(block.x + i), images.u),
                        surrounding<wrap_v>(load(block.y + i), images.v)};
        for (int tap = 0; tap < 4; ++tap) {
            store(block.offset[tap] + i, taps.offset[tap]);
            store(block.tap_weight[tap] + i, taps.weight[tap]);
        }
    }
}

void find_taps(const Chain& chain, Block& block) noexcept {
    fill_up(block);
    by_wrap(chain, [&]<Wrap u, Wrap v>() { find_wrapped<u, v>(chain, block); });
}

/// The reads of a block with their taps known.
struct FoundReads {
    const Chain& chain;
    const Block& block;

    void add(int i, Colour& colour) const {
        for (int tap = 0; tap < 4; ++tap)
            colour.add(chain.texels + block.offset[tap][i], block.tap_weight[tap][i]);
    }
    void add(int from, int to, Colour& colour) const {
        for (int i = from; i < to; ++i) add(i, colour);
    }

    void add_lookup(int lookup) const {
        Colour colour{block.sum[lookup]};
        add(block.begin[lookup], block.begin[lookup + 1], colour);
        colour.to(block.sum[lookup]);
    }
    /// Two at once: each sum waits for its last addition, and there is time for the other's.
    void add_two_lookups(int lookup) const {
        const int from = block.begin[lookup], middle = block.begin[lookup + 1], to = block.begin[lookup + 2],
                  both = middle - from < to - middle ? middle - from : to - middle;
        Colour first{block.sum[lookup]}, second{block.sum[lookup + 1]};
        for (int i = 0; i < both; ++i) {
            add(from + i, first);
            add(middle + i, second);
        }
        add(from + both, middle, first);
        add(middle + both, to, second);
        first.to(block.sum[lookup]);
        second.to(block.sum[lookup + 1]);
    }
};

void add_up(const Chain& chain, const Block& block) noexcept {
    const FoundReads reads{chain, block};
    int lookup = 0;
    for (; lookup + 2 <= block.lookups; lookup += 2) reads.add_two_lookups(lookup);
    if (lookup < block.lookups) reads.add_lookup(lookup);
}
