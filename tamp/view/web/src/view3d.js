// The scene at a time, or at a failed attempt.
import { Color, Group, MeshStandardMaterial, Vector3 } from "three";
import { Line2 } from "three/addons/lines/Line2.js";
import { LineGeometry } from "three/addons/lines/LineGeometry.js";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { RobotModel } from "./robot_model.js";
import { makeShapes, paint, place } from "./shapes.js";
import { Stage } from "./stage.js";

const solid = (color) => new MeshStandardMaterial({ color, roughness: 0.55, metalness: 0.05 });
const linkMaterials = [solid(0xf2f3f5), solid(0x6b7688)];
const ghostMaterial = new MeshStandardMaterial({
  color: 0xe5484d, roughness: 0.6, transparent: true, opacity: 0.34, depthWrite: false,
});
const faultMaterial = new MeshStandardMaterial({ color: 0xe01f2d, emissive: 0x7a0d14, roughness: 0.5 });
const pathMaterial = new LineMaterial({ color: 0x2f6fed, linewidth: 1.2, transparent: true, opacity: 0.35 });
const actionPathMaterial = new LineMaterial({ color: 0x2f6fed, linewidth: 3, transparent: true, opacity: 0.9 });
const mostPathPoints = 4000;

/** Index of a link's material: another one behind each joint that moves. */
function materialIndices(links) {
  const indices = [];
  for (const { parent, variable } of links)
    indices.push(parent < 0 ? 0 : variable < 0 ? indices[parent] : 1 - indices[parent]);
  return indices;
}

function addLines(group, ways, material) {
  for (const way of ways) group.add(new Line2(new LineGeometry().setFromPoints(way), material));
}

export class View3d {
  constructor(canvas, document, replay) {
    this.replay = replay;
    this.stage = new Stage(canvas);
    this.materials = materialIndices(document.robot.links).map((index) => linkMaterials[index]);
    this.robot = new RobotModel(document.robot, (index) => this.materials[index]);
    this.ghost = new RobotModel(document.robot, () => ghostMaterial);
    this.ghost.root.visible = false;
    this.bodies = new Map();
    for (const body of document.bodies) {
      const material = solid(new Color().setRGB(...body.color, "srgb"));
      this.bodies.set(body.name, { body, material, object: makeShapes(body.shapes, material) });
    }
    this.paths = new Group();
    this.actionPaths = new Group();
    this.paths.add(this.actionPaths);
    this.stage.scene.add(this.robot.root, this.ghost.root, this.paths);
    const ways = this.toolWays(0, replay.duration, mostPathPoints);
    this.pathPoints = ways.flat();
    addLines(this.paths, ways, pathMaterial);
    this.showTime(0);
    this.fit();
  }

  /** The tools' ways through the world: a list of points for each. Moves the robot. */
  toolWays(start, end, mostPoints) {
    const count = Math.max(1, Math.min(mostPoints, Math.ceil((end - start) * 60)));
    const ways = this.robot.tools.map(() => []);
    for (let i = 0; i <= count; ++i) {
      this.robot.move(this.replay.configurationAt(start + (i / count) * (end - start)));
      this.robot.root.updateMatrixWorld(true);
      this.robot.tools.forEach((tool, k) => ways[k].push(new Vector3().setFromMatrixPosition(tool.matrixWorld)));
    }
    return ways;
  }

  /** Thick lines for the current action's part of the ways. */
  traceAction(index) {
    if (index === this.tracedAction) return;
    this.tracedAction = index;
    for (const line of this.actionPaths.children) line.geometry.dispose();
    this.actionPaths.clear();
    const action = this.replay.document.plan[index];
    if (action) addLines(this.actionPaths, this.toolWays(action.start, action.end, mostPathPoints), actionPathMaterial);
  }

  /** Looks at what moves, and at everything if nothing does. */
  fit() {
    this.stage.scene.updateMatrixWorld(true);
    const movable = [...this.bodies.values()].filter(({ body }) => body.movable).map(({ object }) => object);
    const all = [...this.bodies.values()].map(({ object }) => object);
    const robot = this.robot.robot.links.length > 0 ? [this.robot.root] : [];
    const shown = [...robot, ...movable];
    this.stage.fit(shown.length > 0 ? shown : all, this.pathPoints);
  }

  setTheme(name) {
    this.stage.setTheme(name);
  }

  togglePaths() {
    this.paths.visible = !this.paths.visible;
    this.stage.invalidate();
    return this.paths.visible;
  }

  showTime(time) {
    this.leaveAttempt();
    this.traceAction(this.replay.actionAt(time));
    this.robot.move(this.replay.configurationAt(time));
    this.placeBodies(this.replay.placesAt(time), this.robot);
    this.stage.invalidate();
  }

  /** The robot as a ghost where it failed; what touched is red. */
  showAttempt(attempt) {
    this.leaveAttempt();
    const places = this.replay.placesAt(0);
    for (const stand of attempt.elsewhere ?? []) places.set(stand.body, stand);
    if (attempt.held) places.set(attempt.held.body, attempt.held);
    const ghost = attempt.configuration !== undefined;
    const shown = ghost ? this.ghost : this.robot;
    shown.move(attempt.configuration ?? this.replay.document.start);
    this.ghost.root.visible = ghost;
    this.robot.root.visible = !ghost;
    this.placeBodies(places, shown);
    const fault = new Set((attempt.contacts ?? []).flat());
    shown.paint(fault, faultMaterial);
    for (const [name, { object }] of this.bodies) if (fault.has(name)) paint(object, faultMaterial);
    this.attempt = attempt;
    this.stage.invalidate();
  }

  leaveAttempt() {
    if (!this.attempt) return;
    this.attempt = undefined;
    this.ghost.shapes.forEach((shapes) => paint(shapes, ghostMaterial));
    this.robot.shapes.forEach((shapes, index) => paint(shapes, this.materials[index]));
    for (const { object, material } of this.bodies.values()) paint(object, material);
    this.ghost.root.visible = false;
    this.robot.root.visible = true;
  }

  placeBodies(places, robot) {
    for (const [name, { object }] of this.bodies) {
      const { link, pose } = places.get(name);
      const parent = link === undefined ? this.stage.scene : robot.frame(link);
      if (object.parent !== parent) parent.add(object);
      place(object, pose);
    }
  }
}
