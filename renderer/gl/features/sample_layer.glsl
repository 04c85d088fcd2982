#if SLABS
    vec2 ends@ = vec2(found.entry, found.back) * valueOfEntry@.x + valueOfEntry@.y;
    float depth@ = meanExtinction(slabTable@, ends@) * stepRatio * found.part;
    opacity = -expm1(-depth@);
    if (opacity > 0.0) { // each layer where its own matter is seen
        float seen = seenPlace(slabTable@, ends@, depth@);
        Facts facts = measure(positionAt(ray, found.s + seen * found.part), ray.view, mix(found.entry, found.back, seen),
                              found.part);
        colour = colourByValue@(facts, mix(ends@.x, ends@.y, seen));
#if CUES
        colour.rgb = lightByCues(facts, colour.rgb);
#endif
    }
#else
    opacity = evaluate@(facts, colour);
#endif
    if (opacity > 0.0) {
#if IMPORTANCE
        composeLayer(pixel, facts, colour.rgb * dark, opacity, partOf@(facts), measures.sum, extinctionWeight0,
                     importanceOfLayer@);
#else
        composeLayer(pixel, colour.rgb, opacity);
#endif
    }
