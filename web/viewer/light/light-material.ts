/**
 * The room's shader. Light at a vertex = sum of weight x patch illuminance, fetched from the light texture; then
 *   realistic:    albedo x light, spread within its patches (contact/openness.ts, contact/shadows.ts), x its colour x
 *                 exposure, through the tone curve
 *   false colour: the place of light (or of exitance, from each patch's own reflectance) on the legend, through the
 *                 colour table
 * A measuring plane, which nobody could see, is a faint veil in the realistic picture; in the other it is opaque, for
 * it is what is measured there, and isolux lines are drawn on it alone.
 * One program family; what is common to all meshes lives in shared uniforms, so a change of light, exposure or
 * legend touches no mesh.
 */
import {
  Color,
  DoubleSide,
  FrontSide,
  ShaderMaterial,
  Vector2,
  Vector4,
  type Matrix3,
  type Texture,
} from 'three';
import { leastDarkening, mostBrightening } from './brightening.ts';
import { isoluxShader } from './isolux.ts';
import { overPlaneShader, planeUniforms } from './plane-footprints.ts';

const vertexShader = /* glsl */ `
attribute vec4 _patches;
attribute vec4 _weights;
attribute float _storey; // 0: the section cuts it; else it stands whole on this one, counted from 1
attribute vec4 _lattice; // openness and shadows of a triangle: their first value, cells along an edge, and where this corner is
uniform highp sampler2D lightTexture;
uniform highp sampler2D reflectanceTexture;
uniform highp sampler2D colorTexture; // red and blue at a luminance of 1
uniform highp sampler2D meanOpennessTexture;
uniform highp sampler2D meanShadowTexture;
uniform highp sampler2D arrivingTexture;
uniform float colored;    // how much of the light's colour, 0..1
uniform float contact;    // how much of the shadows near contacts, 0..1
uniform float shade;      // how much of those that luminaires cast, 0..1
uniform bool exitance;
uniform mat3 mapTransform;
varying float vLight;
varying float vQuantity;
varying vec3 vLightColor;
varying vec3 vMeans; // of the patches here: openness, light that their places are in the shadow of, and what arrives of it
flat varying vec2 vLattice;
varying vec2 vCorner;
varying vec2 vMapUv;
varying vec3 vPlace; // in the room, m
flat varying float vStorey;
#ifdef USE_COLOR
varying vec3 vTint;
#endif

ivec2 texelOf(float patchIndex) {
  int i = int(patchIndex + 0.5);
  return ivec2(i & 255, i >> 8);
}

vec4 atPatches(highp sampler2D values) {
  return vec4(texelFetch(values, texelOf(_patches.x), 0).r, texelFetch(values, texelOf(_patches.y), 0).r,
              texelFetch(values, texelOf(_patches.z), 0).r, texelFetch(values, texelOf(_patches.w), 0).r);
}

// Of light from the patches by their weights; luminance is 1.
vec3 lightColor(vec4 shares) {
  vec2 redBlue = shares.x * texelFetch(colorTexture, texelOf(_patches.x), 0).rg +
                 shares.y * texelFetch(colorTexture, texelOf(_patches.y), 0).rg +
                 shares.z * texelFetch(colorTexture, texelOf(_patches.z), 0).rg +
                 shares.w * texelFetch(colorTexture, texelOf(_patches.w), 0).rg;
  redBlue /= max(dot(shares, vec4(1.0)), 1e-12);
  return vec3(redBlue.x, (1.0 - 0.2126 * redBlue.x - 0.0722 * redBlue.y) / 0.7152, redBlue.y);
}

void main() {
  vec4 weights = _weights / max(dot(_weights, vec4(1.0)), 1e-6);
  vec4 light = atPatches(lightTexture);
  vLight = dot(weights, light);
  vQuantity = exitance ? dot(weights, light * atPatches(reflectanceTexture)) : vLight;
  vLightColor = colored > 0.0 && vLight > 0.0 ? mix(vec3(1.0), lightColor(weights * light), colored) : vec3(1.0);
  vMeans = vec3(contact > 0.0 ? dot(weights, atPatches(meanOpennessTexture)) : 1.0,
                shade > 0.0 ? dot(weights, atPatches(meanShadowTexture)) : 0.0,
                shade > 0.0 ? dot(weights, atPatches(arrivingTexture)) : 0.0);
  vStorey = _storey;
  vLattice = _lattice.xy;
  vCorner = _lattice.zw;
#ifdef MAP_UV
  vMapUv = (mapTransform * vec3(MAP_UV, 1.0)).xy;
#endif
#ifdef USE_COLOR
  vTint = color.rgb;
#endif
  vPlace = (modelMatrix * vec4(position, 1.0)).xyz;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}
`;

/** m: as high as no room is. */
export const noSection = 1e9;

export const darkShell = 0.02; // of the usual light
export const darkRoof = 0.15; // some light comes through its joints, and none that a room could be seen by
const unlit = [0.004, 0.03]; // to what no light comes: the inside of walls, the earth below a floor; from there on it counts
export const darkBack = 0.2; // light that comes into a hollow wall through its joints
export const levelShell = 0.5; // of a normal: steeper is a wall

const fragmentShader = /* glsl */ `
uniform sampler2D albedoMap;
uniform vec4 albedo;
uniform vec4 paint;       // an albedo where w is 1, else a factor on the material's own
uniform float alphaCut;
uniform sampler2D colorTable;
uniform bool falseColor;
uniform bool measuring;
uniform float exposure;
uniform vec2 legend;      // low, high; logarithms on a logarithmic scale
uniform bool logarithmic;
uniform float steps;
uniform bool isolux;
uniform bool planesShown;
uniform float reflectance;
uniform float pixelRatio;
uniform vec3 accent;
uniform float tint;       // how much of the accent, 0..1
uniform bool standing;    // furniture
uniform bool back;        // the other side of a sheet
uniform bool yields;      // to what is read on a plane below
uniform vec4 sides;       // of the room, m: low x, low z, high x, high z
uniform float section;    // m: what is higher is not drawn
uniform float storeys;    // whose floors are below it
uniform bool building;    // seen from outside
uniform float openFrom;   // m: backs that are higher are cut away
uniform float openTo;     // m: the middle of a room that is seen from outside and cut away
uniform float colored;
uniform float usualLight; // lx, what an eye is adapted to
uniform highp sampler2D opennessTexture;
uniform highp sampler2D shadowTexture;
uniform float contact;
uniform float shade;
const float veil = 0.16;  // how much a measuring plane hides of a realistic picture
varying float vLight;
varying float vQuantity;
varying vec3 vLightColor;
varying vec3 vMeans; // of the patches here: openness, light that their places are in the shadow of, and what arrives of it
flat varying vec2 vLattice;
varying vec2 vCorner;
varying vec2 vMapUv;
varying vec3 vPlace;
flat varying float vStorey;
#ifdef USE_COLOR
varying vec3 vTint;
#endif
${isoluxShader}
${overPlaneShader}

// Of the lattice: rows along the first edge, each one shorter than the one before.
int placeAt(ivec2 at) {
  return int(vLattice.x + 0.5) + at.y * (int(vLattice.y + 0.5) + 1) - at.y * (at.y - 1) / 2 + at.x;
}

// The three values about this place, and their shares.
void placesHere(int cells, out ivec3 places, out vec3 shares) {
  vec2 place = clamp(vCorner, 0.0, 1.0) * float(cells);
  ivec2 cell = min(ivec2(place), ivec2(cells - 1));
  cell.x = min(cell.x, cells - 1 - cell.y);
  vec2 part = clamp(place - vec2(cell), 0.0, 1.0);
  bool isNear = part.x + part.y <= 1.0 || cell.x + cell.y + 2 > cells;
  places = ivec3(placeAt(isNear ? cell : cell + ivec2(1, 1)), placeAt(cell + ivec2(1, 0)), placeAt(cell + ivec2(0, 1)));
  vec2 others = isNear ? part : 1.0 - part.yx;
  shares = vec3(1.0 - others.x - others.y, others);
}

float opennessAt(int place) {
  return texelFetch(opennessTexture, ivec2(place & 1023, place >> 10), 0).r;
}

float shadowAt(int place) {
  return texelFetch(shadowTexture, ivec2(place & 255, place >> 8), 0).r;
}

// The patches' light, spread within them.
float litHere() {
  const float least = ${leastDarkening.toFixed(2)}, most = ${mostBrightening.toFixed(1)};
  int cells = int(vLattice.y + 0.5);
  if (contact <= 0.0) return vLight;
  float openness = 1.0, shadow = vMeans.y;
  if (cells > 0) {
    ivec3 places;
    vec3 shares;
    placesHere(cells, places, shares);
    openness = dot(shares, vec3(opennessAt(places.x), opennessAt(places.y), opennessAt(places.z)));
    if (shade > 0.0) shadow = dot(shares, vec3(shadowAt(places.x), shadowAt(places.y), shadowAt(places.z)));
  }
  float spread = mix(1.0, min(most, openness / max(vMeans.x, 1e-3)), contact);
  float light = spread * vLight, reflected = spread * (vLight - vMeans.z);
  return clamp(light + shade * (vMeans.y - shadow), min(light, max(least * vLight, reflected)),
               max(light, most * vLight));
}

// Grey in daylight, a little darker to the sides, so that edges are seen.
vec3 outsideColor() {
  vec3 normal = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
  return vec3(0.30, 0.31, 0.33) * (0.85 + 0.3 * abs(normal.y) - 0.25 * abs(normal.x));
}

// The back of furniture is dark where it stands at a wall, and would look hollow where that wall is not drawn.
float drawnLight(float light) {
  if (!standing) return light;
  vec3 normal = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
  const float gap = 0.4, upright = 0.9;
  vec4 facing = vec4(-normal.xz, normal.xz), distance = vec4(vPlace.xz - sides.xy, sides.zw - vPlace.xz);
  vec4 isBack = step(upright, facing) * step(distance, vec4(gap));
  return max(light, 0.3 * usualLight * min(1.0, dot(isBack, vec4(1.0))));
}

// Of a building: dark and at its edge, and looking away from its rooms.
bool isOutside(float light) {
  const float edge = 0.295, dark = 0.002, inward = 0.5;
  if (!building || light > dark * usualLight) return false;
  vec3 normal = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
  vec4 facing = vec4(-normal.xz, normal.xz), distance = vec4(vPlace.xz - sides.xy, sides.zw - vPlace.xz);
  return dot(step(distance, vec4(edge)) * step(vec4(-inward), facing), vec4(1.0)) > 0.5;
}

// Of a room that is cut away: dark and looking away from its middle, such as the inside of a wall behind its outer face.
bool isShell(float light) {
  if (measuring || openTo >= ${noSection.toExponential()} || light > ${darkRoof} * usualLight) return false;
  vec3 normal = normalize(cross(dFdx(vPlace), dFdy(vPlace)));
  vec3 way = vPlace - vec3(0.5 * (sides.x + sides.z), openTo, 0.5 * (sides.y + sides.w));
  bool isLevel = abs(normal.y) > ${levelShell};
  if (light > (back ? ${darkBack} : ${darkShell}) * usualLight && (standing || !isLevel)) return false;
  if (isLevel) return normal.y > 0.0 && way.y > 0.0;
  return !standing && dot(normal.xz, way.xz) > 0.0;
}

// How much of what is left of such a shell, behind what is cut away, is drawn as an outside: no light comes there.
float withinShell(float light) {
  if (measuring || openTo >= ${noSection.toExponential()}) return 0.0;
  vec2 counts = back ? vec2(${unlit[1]}, ${darkBack}) : vec2(${unlit[0]}, ${unlit[1]});
  return 1.0 - smoothstep(counts.x, counts.y, light / max(usualLight, 1e-6));
}

vec3 colorOnLegend(float quantity) {
  float value = logarithmic ? log(max(quantity, 1e-12)) : quantity;
  float at = clamp((value - legend.x) / (legend.y - legend.x), 0.0, 1.0);
  if (steps > 0.5) at = (min(floor(at * steps), steps - 1.0) + 0.5) / steps;
  return texture2D(colorTable, vec2((at * 255.0 + 0.5) / 256.0, 0.5)).rgb;
}

// Straight up to a knee, then a rational shoulder that never reaches white. Half by the brightest channel (keeps the
// hue), half channel by channel (pales what is bright, as film and eyes do).
float shoulder(float value) {
  const float knee = 0.42;
  float over = max(0.0, value - knee) / (1.0 - knee);
  return min(value, knee) + (1.0 - knee) * over / (1.0 + over);
}

vec3 toneCurve(vec3 color) {
  float peak = max(max(color.r, max(color.g, color.b)), 1e-6);
  vec3 apart = vec3(shoulder(color.r), shoulder(color.g), shoulder(color.b));
  return mix(color * (shoulder(peak) / peak), apart, 0.5);
}

void main() {
  if (vStorey > 0.5 ? vStorey > storeys + 0.5 : vPlace.y > section) discard;
  if (yields && planesShown && isOverPlane(vPlace)) discard;
  vec4 surface = albedo;
#ifdef MAP_UV
  surface *= texture2D(albedoMap, vMapUv);
#endif
#ifdef USE_COLOR
  surface.rgb *= vTint;
#endif
  surface.rgb = paint.w > 0.5 ? paint.rgb : min(surface.rgb * paint.rgb, vec3(1.0));
  if (surface.a < alphaCut) discard;
  if (!gl_FrontFacing && !measuring) {
    if (vPlace.y > openFrom) discard;
    // The outside of a wall, where it is not cut away.
    gl_FragColor = linearToOutputTexel(vec4(building ? outsideColor() : vec3(0.035, 0.037, 0.042), 1.0));
    return;
  }
  // What is lit for the eye alone has no colour of light: that of the little which is there can be any.
  float light = litHere();
  if (isShell(light)) discard;
  float drawn = drawnLight(light);
  if (colored > 0.0) surface.rgb *= mix(vec3(1.0), vLightColor, min(1.0, light / max(drawn, 1e-6)));
  bool isOut = !measuring && isOutside(light);
  vec3 color = isOut ? outsideColor()
             : falseColor ? colorOnLegend(vQuantity)
             : measuring  ? mix(vec3(1.0), accent, 0.7)
                          : toneCurve(surface.rgb * drawn * exposure);
  if (!isOut) color = mix(color, 0.6 * outsideColor(), withinShell(light));
  float alpha = !measuring ? surface.a : falseColor ? 1.0 : veil + tint;
  if (isolux && (measuring || !planesShown)) { // one set of lines: the plane's, where there is one
    float line = isoluxLine(vQuantity, 0.7 * pixelRatio);
    // By the surface and not by its texture, so that a line does not flicker on a pattern.
    float bright = falseColor ? dot(color, vec3(0.2126, 0.7152, 0.0722)) : 0.8 * reflectance * vLight * exposure;
    color = mix(color, bright > 0.25 ? vec3(0.01) : vec3(0.95), (falseColor ? 0.75 : 0.6) * line);
    if (measuring) alpha = max(alpha, 0.8 * line);
  }
  color = mix(color, accent, tint);
  gl_FragColor = linearToOutputTexel(vec4(color, alpha));
}
`;

/** Uniforms that every mesh of the room shares; change a value and draw. */
export function sharedUniforms() {
  return {
    ...planeUniforms(),
    lightTexture: { value: null as Texture | null },
    reflectanceTexture: { value: null as Texture | null },
    colorTexture: { value: null as Texture | null },
    colored: { value: 0 },
    opennessTexture: { value: null as Texture | null },
    meanOpennessTexture: { value: null as Texture | null },
    contact: { value: 0 },
    shadowTexture: { value: null as Texture | null },
    meanShadowTexture: { value: null as Texture | null },
    arrivingTexture: { value: null as Texture | null },
    shade: { value: 0 },
    colorTable: { value: null as Texture | null },
    falseColor: { value: false },
    exposure: { value: 1 },
    legend: { value: new Vector2(0, 1) },
    logarithmic: { value: false },
    steps: { value: 0 },
    isolux: { value: false },
    planesShown: { value: false }, // measuring planes are drawn
    exitance: { value: false },
    pixelRatio: { value: 1 },
    accent: { value: new Color('#4f9dff') },
    sides: { value: new Vector4() },
    section: { value: noSection },
    storeys: { value: noSection },
    building: { value: false },
    openFrom: { value: noSection },
    openTo: { value: noSection },
    usualLight: { value: 0 },
  };
}

export type SharedUniforms = ReturnType<typeof sharedUniforms>;

/** What a mesh brings of its own glTF material. */
export interface Albedo {
  readonly color: Color; // linear
  readonly opacity: number;
  readonly map: Texture | null;
  readonly alphaCut: number; // 0 = none
  readonly vertexColors: boolean;
  readonly transparent: boolean;
}

export interface LightMaterialOptions {
  readonly albedo: Albedo;
  readonly measuring: boolean;
  readonly standing: boolean;
  readonly back: boolean; // the other side of a sheet
  readonly yields: boolean;
  readonly reflectance: number; // mean of its surface: how bright it looks behind an isolux line
}

export function createLightMaterial(shared: SharedUniforms, options: LightMaterialOptions): ShaderMaterial {
  const { albedo, measuring } = options;
  const mapTransform: Matrix3 | null = albedo.map?.matrix ?? null;
  albedo.map?.updateMatrix();
  return new ShaderMaterial({
    vertexShader,
    fragmentShader,
    uniforms: {
      ...shared,
      albedoMap: { value: albedo.map },
      mapTransform: { value: mapTransform },
      albedo: { value: new Vector4(albedo.color.r, albedo.color.g, albedo.color.b, albedo.opacity) },
      paint: { value: new Vector4(1, 1, 1, 0) },
      alphaCut: { value: albedo.alphaCut },
      measuring: { value: measuring },
      standing: { value: options.standing },
      back: { value: options.back },
      yields: { value: options.yields },
      reflectance: { value: options.reflectance },
      tint: { value: 0 },
    },
    defines: albedo.map ? { MAP_UV: albedo.map.channel === 1 ? 'uv1' : 'uv' } : {},
    vertexColors: albedo.vertexColors,
    side: measuring ? DoubleSide : FrontSide,
    transparent: measuring || albedo.transparent,
    depthWrite: !measuring,
    polygonOffset: measuring,
    polygonOffsetFactor: -1,
    polygonOffsetUnits: -1,
  });
}
