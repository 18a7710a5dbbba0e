#include "viewer/drawing/shading.h"

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "viewer/drawing/projection.h"

namespace scatter::viewer {

LightInView lightOf(const View& view) {
  const glm::mat4 toCamera = viewMatrix(view.camera);
  const glm::mat3 turn(toCamera);
  Crowd crowd = view.scenery.crowd;
  crowd.center = Vec3(toCamera * glm::vec4(crowd.center, 1.0F));
  return {turn * glm::normalize(view.scenery.toLight), turn[1], crowd};
}

ShadowsInView shadowsOf(const View& view, const ShadowMap& map) {
  return {map.fromWorld() * glm::inverse(viewMatrix(view.camera)), map.lift()};
}

std::string shadowed(const char* shader) {
  return "#define SHADOWED\n#define SIZE " + std::to_string(ShadowMap::kSize) + ".0\n" + shader;
}

const char* const kItemVertexShader = R"(
#ifdef SHADOWED
uniform mat4 toShadow;
uniform float lift;
varying vec3 shadowPlace;
varying vec3 keyLight;
#endif
uniform vec3 toLight;
uniform vec3 worldUp;
uniform vec4 crowd;
uniform float crowdShade;
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
  vec3 place = (toCamera * gl_Vertex).xyz;
  vec3 normal = normalize(turnNormal(gl_Normal));
  vec3 toEye = normalize(-place);
  float facing = dot(normal, toEye);
  if (itemLook.z > 0.5 && facing < 0.0) {
    normal = -normal;
    facing = -facing;
  }
  float inside = 1.0 - smoothstep(0.3, 0.95, distance(place, crowd.xyz) / crowd.w);
  float lightLeft = 1.0 - crowdShade * inside;
  float open = (0.2 + 0.8 * gl_Color.a * gl_Color.a) * lightLeft;
  float above = 0.5 + 0.5 * dot(normal, worldUp);
  vec3 ambient = mix(vec3(0.13, 0.13, 0.16), vec3(0.36, 0.41, 0.50), above) * open;
  vec3 key = vec3(1.0, 0.94, 0.83) * max(dot(normal, toLight), 0.0) * (0.35 + 0.65 * gl_Color.a) * lightLeft;
  float shine = pow(max(dot(normal, normalize(toLight + toEye)), 0.0), 28.0) * 0.22 * open;
  float rim = 1.0 - clamp(facing, 0.0, 1.0);
  vec3 color = itemColor.rgb * gl_Color.rgb;
  vec3 dim = color * ambient + vec3(0.08, 0.11, 0.16) * rim * rim * rim * open;
  vec3 lit = color * key + vec3(shine);
#ifdef SHADOWED
  shadowPlace = (toShadow * vec4(place + lift * normal, 1.0)).xyz;
  keyLight = lit * (1.0 - itemLook.x);
#else
  dim += lit;
#endif
  gl_FrontColor = vec4(mix(dim, color, itemLook.x), itemColor.a);
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
#ifdef SHADOWED
uniform sampler2D shadowMap;
varying vec3 shadowPlace;
varying vec3 keyLight;

float lightAt(vec2 texel) {
  vec3 depth = texture2D(shadowMap, (texel + 0.5) / SIZE).rgb;
  return step(min(shadowPlace.z, 0.999), dot(depth, vec3(16711680.0, 65280.0, 255.0) / 16777215.0));
}

void main() {
  vec2 place = shadowPlace.xy * SIZE - 0.5;
  vec2 texel = floor(place);
  vec2 share = place - texel;
  float low = mix(lightAt(texel), lightAt(texel + vec2(1.0, 0.0)), share.x);
  float high = mix(lightAt(texel + vec2(0.0, 1.0)), lightAt(texel + vec2(1.0, 1.0)), share.x);
  gl_FragColor = vec4(gl_Color.rgb + keyLight * mix(low, high, share.y), gl_Color.a);
}
#else
void main() {
  gl_FragColor = gl_Color;
}
#endif
)";

}  // namespace scatter::viewer
