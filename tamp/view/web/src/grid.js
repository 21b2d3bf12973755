// A floor of lines, 10 cm and 50 cm apart, that fades away from its middle. Drawn by a shader, so that lines stay
// fine at every distance.
import { Color, Mesh, PlaneGeometry, ShaderMaterial, Vector2 } from "three";

const vertexShader = `
  varying vec2 ground;
  void main() {
    vec4 point = modelMatrix * vec4(position, 1.0);
    ground = point.xy;
    gl_Position = projectionMatrix * viewMatrix * point;
  }`;

const fragmentShader = `
  varying vec2 ground;
  uniform vec3 color;
  uniform vec2 middle;
  uniform float reach;
  float lines(float gap) {
    vec2 cell = ground / gap;
    vec2 width = fwidth(cell);
    vec2 away = abs(fract(cell - 0.5) - 0.5) / width;
    float crowded = 1.0 - smoothstep(0.1, 0.5, max(width.x, width.y));
    return (1.0 - min(min(away.x, away.y), 1.0)) * crowded;
  }
  void main() {
    float fade = 1.0 - smoothstep(0.2 * reach, reach, distance(ground, middle));
    gl_FragColor = vec4(color, fade * max(0.35 * lines(0.1), lines(0.5)));
    #include <colorspace_fragment>
  }`;

export class Grid extends Mesh {
  constructor() {
    const uniforms = { color: { value: new Color() }, middle: { value: new Vector2() }, reach: { value: 4 } };
    super(new PlaneGeometry(200, 200),
      new ShaderMaterial({ vertexShader, fragmentShader, uniforms, transparent: true, depthWrite: false }));
    this.position.z = -0.001;
    this.renderOrder = -1;
  }

  setColor(color) {
    this.material.uniforms.color.value.set(color);
  }

  /** Visible within `reach` metres of a point. */
  focus(point, reach) {
    this.material.uniforms.middle.value.set(point.x, point.y);
    this.material.uniforms.reach.value = reach;
  }
}
