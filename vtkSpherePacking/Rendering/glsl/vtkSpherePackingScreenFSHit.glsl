  uvec4 sphereSurface = texelFetch(sphereSurfaces, ivec2(gl_FragCoord.xy - viewportOrigin), 0);
  float sphereDepthValue = abs(uintBitsToFloat(sphereSurface.x));
  if (sphereDepthValue >= 1.0)
  {
    discard;
  }
  vec2 sphereNormal = uintBitsToFloat(sphereSurface.zw);
  float sphereEyeDepth = eyeDepth(sphereDepthValue);
  vec4 vertexVC = vec4(gl_FragCoord.xy * rayMapHigh.xy + rayMapHigh.zw, -1.0, 1.0);
  vertexVC.xyz *= vec3(vec2(parallelView ? 1.0 : sphereEyeDepth), sphereEyeDepth);
