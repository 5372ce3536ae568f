// Sums of single precision whose rounding is kept, so that what is left of large numbers is as true as if it had been computed
// exactly: Dekker 1971 (products of split factors), Knuth's two-sum. Nothing here may be contracted or reordered.

// The first 12 of 24 bits: a product of two such is exact.
FUNC float first_bits(float x) { return intBitsToFloat(floatBitsToInt(x) & -4096); }
FUNC float first_9_bits(float x) { return intBitsToFloat(floatBitsToInt(x) & -32768); }

// a - (o + d z), rounded as if it had been computed exactly: beside a far ray it is much smaller than either.
FUNC vec3 from_ray(vec3 a, vec3 o, vec3 d, float z) {
    vec3 apart = a - o, step = apart - a, lost = (a - (apart - step)) - (o + step);
    vec3 high = vec3(first_bits(d.x), first_bits(d.y), first_bits(d.z));
    return ((apart - high * z) - (d - high) * z) + lost;
}

// sum + x; what rounding takes goes to `lost` (Knuth's two-sum).
FUNC vec2 add_exactly(vec2 sum, vec2 x, INOUT(vec2) lost) {
    vec2 both = sum + x, added = both - sum;
    lost = lost + ((sum - (both - added)) + (x - added));
    return both;
}

// sum + x b, for b of at most 15 bits: a corner's place.
FUNC vec2 add_product_exactly(vec2 sum, vec2 x, float b, INOUT(vec2) lost) {
    vec2 high = vec2(first_9_bits(x.x), first_9_bits(x.y)), rest = x - high;
    vec2 middle = vec2(first_9_bits(rest.x), first_9_bits(rest.y));
    sum = add_exactly(sum, high * b, lost);
    sum = add_exactly(sum, middle * b, lost);
    return add_exactly(sum, (rest - middle) * b, lost);
}
