#if IMPORTANCE
    endWhereCertain(pixel, facts.q);
#endif
}
