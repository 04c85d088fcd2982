// Pre-integration: what slabs between two samples show (core/optics/preintegration.h), by tables of eight numbers an
// entry: extinction there and just before the next entry; then the integral of extinction up to the entry, and those of
// extinction times the place and its square, each as a multiple of a quantum and a rest.

const int kSlabRow = 8;

/// Mean extinction between two entries of a table.
float meanExtinction(int table, vec2 ends) {
    ivec2 row = table + kSlabRow * ivec2(ends);
    vec2 share = ends - floor(ends);
    vec2 low = vec2(numberAt(row.x), numberAt(row.y));
    vec2 high = vec2(numberAt(row.x + 1), numberAt(row.y + 1));
    vec2 inside = share * (low + 0.5 * share * (high - low));
    precise float whole = numberAt(row.y + 2) - numberAt(row.x + 2); // exact
    float rest = (numberAt(row.y + 3) - numberAt(row.x + 3)) + (inside.y - inside.x);
    float way = ends.y - ends.x;
    vec2 here = mix(low, high, share);
    bool same = abs(way) <= 0.0625; // a sixteenth of an entry: one value
    return max(same ? 0.5 * (here.x + here.y) : (whole + rest) / way, 0.0);
}

/// Integrals of extinction and of its first two moments up to an entry.
dvec3 slabIntegrals(int table, float entry) {
    int whole = int(entry);
    int row = table + kSlabRow * whole;
    double k = double(whole);
    double f = double(entry) - k;
    double low = double(numberAt(row));
    double rise = (double(numberAt(row + 1)) - low) * f;
    double depth = f * (low + rise / 2.0lf);
    double first = f * f * (low / 2.0lf + rise / 3.0lf);
    double second = f * f * f * (low / 3.0lf + rise / 4.0lf);
    dvec3 sums = dvec3(double(numberAt(row + 2)) + double(numberAt(row + 3)),
                       double(numberAt(row + 4)) + double(numberAt(row + 5)),
                       double(numberAt(row + 6)) + double(numberAt(row + 7)));
    return sums + dvec3(depth, first + k * depth, second + k * (2.0lf * first + k * depth));
}

/// Mean place of what is seen of an even medium: 0 its front, 1 its back.
float evenSeenPlace(float depth) {
    return depth < 0.1 ? 0.5 - depth / 12.0 + depth * depth * depth / 720.0 : 1.0 / depth - 1.0 / expm1(depth);
}

/// Where a slab is seen on average: its matter as an even block of the same mean and variance.
float seenPlace(int table, vec2 ends, float depth) {
    float mean = 0.5;
    float width = 1.0;
    double way = double(ends.y) - double(ends.x);
    dvec3 between = slabIntegrals(table, ends.y) - slabIntegrals(table, ends.x);
    if (abs(ends.y - ends.x) > 0.0625 && abs(between.x) > 0.0lf) {
        double place = between.y / between.x;
        double variance = between.z / between.x - place * place;
        mean = clampedToUnit(float((place - double(ends.x)) / way));
        width = sqrt(12.0 * clamp(float(variance / (way * way)), 0.0, 0.25));
    }
    return clampedToUnit(mean + width * (evenSeenPlace(depth) - 0.5));
}
