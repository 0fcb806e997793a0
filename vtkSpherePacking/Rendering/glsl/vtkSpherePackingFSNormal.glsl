  vec3 normalVCVSOutput = (sphereSide / float(sphereShape.y)) *
    (vec3(vec2(sphereMiss), 0.0) + float(sphereAlong) * vec3(vec2(raySlope), -1.0));
