    opacity = evaluate@(facts, colour);
    if (opacity > 0.0) {
#if IMPORTANCE
        composeLayer(pixel, facts, colour.rgb * dark, opacity, partOf@(facts), measures.sum, extinctionWeight0,
                     importanceOfLayer@);
#else
        composeLayer(pixel, colour.rgb, opacity);
#endif
    }
