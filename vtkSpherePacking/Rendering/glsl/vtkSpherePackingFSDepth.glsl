  gl_FragDepth = max(sphereDepth() - depthShift, 0.0);
