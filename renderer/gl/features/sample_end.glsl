#if IMPORTANCE
    endWhereCertain(pixel, found.q);
#endif
}
