#ifdef DRAWING_QUADS
  REAL4 sphereMap = REAL4(rayMapHigh) + REAL4(rayMapLow);
  sphereShape = REAL4(sphereShapeVSOutput) + REAL4(sphereShapeLowVSOutput);
  sphereMiss = REAL2(sphereReferenceVSOutput.zw) + REAL2(sphereRestVSOutput.xy);
#else
  vec4 sphereMap = rayMapHigh;
  sphereShape = sphereShapeVSOutput;
  sphereMiss = sphereReferenceVSOutput.zw;
#endif
  sphereMiss += REAL2(gl_FragCoord.xy - sphereReferenceVSOutput.xy) * (sphereShape.x * sphereMap.xy);
  raySlope = parallelView ? REAL2(0.0) : REAL2(gl_FragCoord.xy) * sphereMap.xy + sphereMap.zw;
  REAL rayLength2 = REAL(1.0) + dot(raySlope, raySlope);
  REAL missAlong = dot(sphereMiss, raySlope);
  REAL missAcross = raySlope.x * sphereMiss.y - raySlope.y * sphereMiss.x;
  REAL discriminant = rayLength2 * sphereShape.y * sphereShape.y - dot(sphereMiss, sphereMiss) -
    missAcross * missAcross;
  if (!(discriminant >= REAL(0.0)))
  {
    discard;
  }
  REAL rootOfDiscriminant = sqrt(discriminant);
  REAL inverseLength2 = parallelView ? REAL(1.0) : REAL(1.0) / rayLength2;
  float sphereSide = 1.0;
  sphereMoveTo(-(missAlong + rootOfDiscriminant) * inverseLength2);
#ifdef DRAWING_QUADS
  REAL eyeToSurface2 = REAL(sphereRestVSOutput.z) + REAL(sphereRestVSOutput.w);
  if (eyeToSurface2 != REAL(0.0))
  {
    // The product of both roots is precise where their difference is not.
    REAL hitDepth =
      eyeToSurface2 / (sphereShape.x * rayLength2 - missAlong + rootOfDiscriminant);
    sphereAlong = hitDepth - sphereShape.x;
    sphereBehind = hitDepth - REAL(depthMap.x);
    sphereBefore = REAL(depthMap.y) - sphereBehind;
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
    sphereMoveTo((rootOfDiscriminant - missAlong) * inverseLength2);
    if (!sphereHitIsVisible())
    {
      discard;
    }
  }
#endif
  vec4 vertexVC = vec4(spherePosition(), 1.0);
  vertexVC.z -= depthMap.x;
