  vec3 normalVCVSOutput = (sphereSide / sphereRadius) *
    (vec3(sphereMiss, 0.0) + sphereAlong * vec3(raySlope, -1.0));
