#include "viewer/drawing/shading.h"

#include <glm/geometric.hpp>

#include "viewer/drawing/projection.h"

namespace scatter::viewer {

LightInView lightOf(const View& view) {
  const glm::mat3 toView(viewMatrix(view.camera));
  return {toView * glm::normalize(view.scenery.toLight), toView[1]};
}

const char* const kItemVertexShader = R"(
uniform vec3 toLight;
uniform vec3 worldUp;
uniform vec4 itemColor;
uniform vec3 itemLook;

void main() {
  gl_Position = toClip * gl_Vertex;
  // What has been made flat has no normals.
  if (itemLook.y > 0.5) {
    gl_FrontColor = itemColor;
    gl_BackColor = itemColor;
    return;
  }
  vec3 normal = normalize(turnNormal(gl_Normal));
  vec3 toEye = normalize(-(toCamera * gl_Vertex).xyz);
  float facing = dot(normal, toEye);
  if (itemLook.z > 0.5 && facing < 0.0) {
    normal = -normal;
    facing = -facing;
  }
  float open = gl_Color.a * gl_Color.a;
  float above = 0.5 + 0.5 * dot(normal, worldUp);
  vec3 ambient = mix(vec3(0.16, 0.155, 0.17), vec3(0.40, 0.44, 0.52), above) * open;
  vec3 key = vec3(0.80, 0.76, 0.68) * max(dot(normal, toLight), 0.0) * (0.35 + 0.65 * gl_Color.a);
  float rim = 1.0 - clamp(facing, 0.0, 1.0);
  vec3 color = itemColor.rgb * gl_Color.rgb;
  vec3 lit = color * (ambient + key) + vec3(0.07, 0.09, 0.12) * rim * rim * rim * open;
  gl_FrontColor = vec4(mix(lit, color, itemLook.x), itemColor.a);
  gl_BackColor = gl_FrontColor;
}
)";

const char* const kPaintedVertexShader = R"(
void main() {
  gl_Position = toClip * gl_Vertex;
  gl_FrontColor = gl_Color;
  gl_BackColor = gl_Color;
}
)";

const char* const kPixelShader = R"(
void main() {
  gl_FragColor = gl_Color;
}
)";

}  // namespace scatter::viewer
