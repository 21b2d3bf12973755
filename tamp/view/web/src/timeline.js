// The bar at the bottom: actions as blocks, motions below them, and the hand that marks the time.
import { byId, element } from "./dom.js";
import { speeds } from "./player.js";

const motionTints = {
  transit: "#8fa3bf", transfer: "#e08a3c", approach: "#55a868", retreat: "#55a868",
  gripper: "#c94f6d", base: "#7a6fe0", wait: "transparent",
};

export class Timeline {
  constructor(plan, segments, player, tint) {
    this.player = player;
    this.track = byId("track");
    const span = Math.max(player.duration, 1e-9);
    const percent = (time) => `${(100 * time) / span}%`;
    const put = (block, { start, end }, color) => {
      block.style.left = percent(start);
      block.style.width = percent(end - start);
      block.style.setProperty("--tint", color);
      return block;
    };
    this.blocks = plan.map((action) => {
      const text = [action.name, ...action.arguments].join(" ");
      return put(element("div", { className: "block", title: text }, text), action, tint(action.name));
    });
    byId("actions").replaceChildren(...this.blocks);
    byId("motions").replaceChildren(...segments.map((segment) =>
      put(element("div", { className: "motion-block", title: segment.kind }), segment, motionTints[segment.kind])));
    byId("speed").replaceChildren(...speeds.map((speed) => element("option", { value: speed }, `${speed}×`)));
    byId("play").addEventListener("click", () => player.toggle());
    byId("speed").addEventListener("change", (event) => player.setSpeed(Number(event.target.value)));
    this.track.setAttribute("aria-valuemax", player.duration);
    this.track.addEventListener("pointerdown", (event) => {
      this.track.setPointerCapture(event.pointerId);
      player.pause();
      this.scrub(event);
    });
    this.track.addEventListener("pointermove", (event) => {
      if (this.track.hasPointerCapture(event.pointerId)) this.scrub(event);
    });
    new ResizeObserver(() => this.hideTexts()).observe(this.track);
  }

  scrub(event) {
    const { left, width } = this.track.getBoundingClientRect();
    this.player.seek(((event.clientX - left) / width) * this.player.duration);
  }

  /** Narrow blocks show no text; where there are many, nothing parts them. */
  hideTexts() {
    const widths = this.blocks.map((block) => block.clientWidth);
    this.blocks.forEach((block, index) => block.classList.toggle("narrow", widths[index] < 36));
    this.track.classList.toggle("crowded", this.track.clientWidth < 12 * this.blocks.length);
  }

  show(action) {
    const { time, duration, playing, speed } = this.player;
    byId("head").style.left = `${duration > 0 ? (100 * time) / duration : 0}%`;
    byId("clock").replaceChildren(`${time.toFixed(2)} `, element("small", {}, `/ ${duration.toFixed(2)} s`));
    byId("play").setAttribute("aria-label", playing ? "Pause" : "Play");
    byId("speed").value = speed;
    this.track.setAttribute("aria-valuenow", time.toFixed(2));
    if (action === this.action) return;
    this.blocks[this.action]?.classList.remove("current");
    this.blocks[action]?.classList.add("current");
    this.action = action;
  }
}
