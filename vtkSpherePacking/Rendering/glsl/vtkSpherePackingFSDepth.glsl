  gl_FragDepth = max(
    sphereBehind * depthMap.z / (parallelView ? 1.0 : sphereBehind + depthMap.x) - depthShift, 0.0);
