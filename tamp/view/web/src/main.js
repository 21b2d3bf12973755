// The page: reads the document that stands in it and joins its parts.
//
// The part of the address behind # chooses what is shown first: t (seconds), attempt (from 0), speed, play=1,
// theme (light, dark); "#t=1.5&theme=dark". `window.praxis` has `player`, `showAttempt` and `replay` for scripts.
import { byId, tinter } from "./dom.js";
import { Panel } from "./panel.js";
import { Player } from "./player.js";
import { Replay } from "./replay.js";
import { Timeline } from "./timeline.js";
import { View3d } from "./view3d.js";

const trajectory = JSON.parse(byId("document").textContent);
const replay = new Replay(trajectory);
const tint = tinter();
const player = new Player(replay.duration, showTime);
const timeline = new Timeline(trajectory.plan, trajectory.segments, player, tint);
const panel = new Panel(trajectory, tint, goToAction, showAttempt);
const view = makeView();
let shownAttempt = -1;

function makeView() {
  try {
    return new View3d(byId("scene"), trajectory, replay);
  } catch (error) {
    byId("notice").textContent = `The scene cannot be drawn: ${error.message}. The plan and its times are shown all the same.`;
    byId("notice").hidden = false;
    return undefined;
  }
}

function showTime() {
  const { time } = player;
  const action = replay.actionAt(time);
  const held = [...replay.placesAt(time)].filter(([, place]) => place.link !== undefined).map(([body]) => body);
  timeline.show(action);
  panel.showTime(action, replay.motionsAt(time), held, replay.configurationAt(time));
  if (shownAttempt >= 0) {
    shownAttempt = -1;
    panel.showAttempt(-1);
  }
  view?.showTime(time);
}

function showAttempt(index) {
  if (!trajectory.attempts[index] || index === shownAttempt) return leaveAttempt();
  player.pause();
  shownAttempt = index;
  panel.showAttempt(index, leaveAttempt);
  view?.showAttempt(trajectory.attempts[index]);
}

function leaveAttempt() {
  player.seek(player.time);
}

function goToAction(index) {
  if (trajectory.plan[index]) player.seek(trajectory.plan[index].start);
}

function setTheme(name) {
  document.documentElement.dataset.theme = name;
  view?.setTheme(name);
}

function toggleTheme() {
  setTheme(document.documentElement.dataset.theme === "dark" ? "light" : "dark");
}

function togglePaths() {
  byId("path").setAttribute("aria-pressed", String(view?.togglePaths() ?? false));
}

function toggleKeys() {
  byId("keys").hidden = !byId("keys").hidden;
  byId("help").setAttribute("aria-expanded", String(!byId("keys").hidden));
}

const keys = {
  " ": () => player.toggle(),
  ArrowLeft: (event) => player.seek(player.time - (event.shiftKey ? 1 : 0.1)),
  ArrowRight: (event) => player.seek(player.time + (event.shiftKey ? 1 : 0.1)),
  ArrowUp: () => goToAction(replay.actionAt(player.time) - 1),
  ArrowDown: () => goToAction(replay.actionAt(player.time) + 1),
  Home: () => player.seek(0),
  End: () => player.seek(replay.duration),
  "-": () => player.changeSpeed(-1),
  "+": () => player.changeSpeed(1),
  f: () => view?.fit(),
  p: togglePaths,
  t: toggleTheme,
  "?": toggleKeys,
  Escape: leaveAttempt,
};

document.addEventListener("keydown", (event) => {
  if (event.ctrlKey || event.altKey || event.metaKey || event.target.tagName === "SELECT") return;
  if (event.key === " " && event.target.tagName === "BUTTON") event.target.blur();
  const act = keys[event.key] ?? keys[event.key.toLowerCase()];
  if (!act) return;
  event.preventDefault();
  act(event);
});

function followAddress() {
  const wanted = new URLSearchParams(location.hash.slice(1));
  const number = (name, otherwise) => {
    const value = Number.parseFloat(wanted.get(name));
    return Number.isFinite(value) ? value : otherwise;
  };
  if (["light", "dark"].includes(wanted.get("theme"))) setTheme(wanted.get("theme"));
  player.speed = number("speed", 1) > 0 ? number("speed", 1) : 1;
  player.seek(number("t", 0));
  if (wanted.has("attempt")) showAttempt(number("attempt", -1));
  if (wanted.get("play") === "1") player.play();
}

function summary() {
  const count = (number, noun) => `${number} ${noun}${number === 1 ? "" : "s"}`;
  const failed = trajectory.attempts.reduce((sum, attempt) => sum + attempt.count, 0);
  const parts = [count(trajectory.plan.length, "action"), `${replay.duration.toFixed(2)} s`];
  if (failed > 0) parts.push(count(failed, "failed attempt"));
  return parts.join(" · ");
}

byId("name").textContent = trajectory.robot.name;
byId("summary").textContent = summary();
byId("fit").addEventListener("click", () => view?.fit());
byId("path").addEventListener("click", togglePaths);
byId("theme").addEventListener("click", toggleTheme);
byId("help").addEventListener("click", toggleKeys);
window.addEventListener("hashchange", followAddress);
window.praxis = { player, replay, showAttempt };
setTheme(window.matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
followAddress();
