  vec2 missPerPixel = sphereShapeVSOutput.x * rayMap.xy;
  sphereMiss = sphereReferenceVSOutput.zw +
    (gl_FragCoord.xy - sphereReferenceVSOutput.xy) * missPerPixel;
  raySlope = parallelView ? vec2(0.0) : gl_FragCoord.xy * rayMap.xy + rayMap.zw;
  float rayLength2 = 1.0 + dot(raySlope, raySlope);
  float missAlong = dot(sphereMiss, raySlope);
  float missAcross = raySlope.x * sphereMiss.y - raySlope.y * sphereMiss.x;
  float sphereRadius = sphereShapeVSOutput.y;
  float discriminant = rayLength2 * sphereRadius * sphereRadius - dot(sphereMiss, sphereMiss) -
    missAcross * missAcross;
  if (!(discriminant >= 0.0))
  {
    discard;
  }
  float rootOfDiscriminant = sqrt(discriminant);
  float inverseLength2 = parallelView ? 1.0 : 1.0 / rayLength2;
  float sphereSide = 1.0;
  sphereAlong = -(missAlong + rootOfDiscriminant) * inverseLength2;
  sphereBehind = sphereShapeVSOutput.z + sphereAlong;
#ifdef SPHERES_MAY_BE_NEAR
  if (sphereShapeVSOutput.w != 0.0)
  {
    // The product of both roots is precise where their difference is not.
    float hitDepth = sphereShapeVSOutput.w /
      (sphereShapeVSOutput.x * rayLength2 - missAlong + rootOfDiscriminant);
    sphereAlong = hitDepth - sphereShapeVSOutput.x;
    sphereBehind = hitDepth - depthMap.x;
  }
#endif
#ifdef SPHERES_MAY_BE_CUT
  if (hitMode == 2 || !sphereHitIsVisible())
  {
    if (hitMode == 1)
    {
      discard;
    }
    sphereSide = -1.0;
    sphereAlong = (rootOfDiscriminant - missAlong) * inverseLength2;
    sphereBehind = sphereShapeVSOutput.z + sphereAlong;
    if (!sphereHitIsVisible())
    {
      discard;
    }
  }
#endif
  vec4 vertexVC = vec4(spherePosition(), 1.0);
  vertexVC.z -= depthMap.x;
