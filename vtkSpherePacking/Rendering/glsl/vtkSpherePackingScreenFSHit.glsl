  ivec2 sphereTexel = ivec2(gl_FragCoord.xy - viewportOrigin);
  float sphereDepthValue = texelFetch(sphereDepths, sphereTexel, 0).r;
  if (sphereDepthValue >= 1.0)
  {
    discard;
  }
  vec4 sphereSurface = texelFetch(sphereSurfaces, sphereTexel, 0);
  vec4 vertexVC = vec4(gl_FragCoord.xy * rayMapHigh.xy + rayMapHigh.zw, -1.0, 1.0);
  vertexVC.xyz *= vec3(vec2(parallelView ? 1.0 : sphereSurface.w + depthMap.x),
    sphereSurface.w + depthMap.x);
