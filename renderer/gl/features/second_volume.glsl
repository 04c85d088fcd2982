#if SECOND_VOLUME
uniform sampler3D secondVolume;
uniform vec2 storedSecond;
#endif
