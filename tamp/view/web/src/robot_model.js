// The robot as a tree of objects: `origin` stands in the parent link's `frame`, and `frame` moves in it.
import { Group, Object3D, Vector3 } from "three";
import { makeShapes, paint, place } from "./shapes.js";

export class RobotModel {
  /** `materialOf(index)` gives the material of a link. */
  constructor(robot, materialOf) {
    this.robot = robot;
    this.root = new Group();
    place(this.root, robot.base);
    this.frames = [];
    this.shapes = [];
    robot.links.forEach((link, index) => {
      const origin = new Group();
      const frame = new Group();
      const shapes = makeShapes(link.shapes, materialOf(index));
      place(origin, link.origin);
      origin.add(frame);
      frame.add(shapes);
      (link.parent < 0 ? this.root : this.frames[link.parent]).add(origin);
      this.frames.push(frame);
      this.shapes.push(shapes);
    });
    this.tools = (robot.tools ?? []).map((tool) => {
      const point = new Object3D();
      place(point, tool.pose);
      this.frames[tool.link].add(point);
      return point;
    });
    this.axes = robot.links.map((link) => new Vector3(...link.axis).normalize());
  }

  frame(name) {
    return this.frames[this.robot.links.findIndex((link) => link.name === name)];
  }

  move(configuration) {
    this.robot.links.forEach((link, index) => {
      const variable = link.variable < 0 ? 0 : link.multiplier * configuration[link.variable];
      const position = variable + link.offset;
      const frame = this.frames[index];
      if (link.type === "prismatic") frame.position.copy(this.axes[index]).multiplyScalar(position);
      else if (link.type !== "fixed") frame.quaternion.setFromAxisAngle(this.axes[index], position);
    });
  }

  /** Paints the links whose names are in the set. */
  paint(names, material) {
    this.robot.links.forEach((link, index) => {
      if (names.has(link.name)) paint(this.shapes[index], material);
    });
  }
}
