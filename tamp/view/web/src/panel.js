// The column at the right: what happens now, the plan, what failed, joints and statistics.
import { byId, element, fillTable, numberText } from "./dom.js";

const mostNumbers = 16;

function row(text, aside, color, choose) {
  const button = element("button", { onclick: choose },
    element("span", { className: "what" }, ...text), element("span", { className: "aside" }, aside));
  if (color) button.style.setProperty("--tint", color);
  return button;
}

function fillRows(list, rows) {
  list.className = "rows";
  list.replaceChildren(...rows.map((button) => element("li", {}, button)));
}

function mark(rows, index) {
  rows.forEach((button, i) => button.setAttribute("aria-current", String(i === index)));
  rows[index]?.scrollIntoView({ block: "nearest" });
}

function valueText({ kind, numbers }) {
  const shown = numbers.slice(0, mostNumbers).map(numberText).join(" ");
  return `${kind} ${shown}${numbers.length > mostNumbers ? " …" : ""}`;
}

export class Panel {
  /** `onAction(index)` and `onAttempt(index)` are called when one is chosen. */
  constructor(document, tint, onAction, onAttempt) {
    this.document = document;
    this.values = new Map(Object.entries(document.values));
    this.plan = document.plan.map((action, index) =>
      row([[action.name, ...action.arguments.filter((word) => !this.values.has(word))].join(" ")],
        `${action.start.toFixed(2)} s`, tint(action.name), () => onAction(index)));
    fillRows(byId("plan"), this.plan);
    this.attempts = document.attempts.map((attempt, index) =>
      row([element("span", { className: "reason" }, attempt.reason), ` ${attempt.action}`],
        attempt.count > 1 ? `${attempt.count}×` : "", undefined, () => onAttempt(index)));
    fillRows(byId("attempts"), this.attempts);
    byId("attempts-section").hidden = this.attempts.length === 0;
    fillTable(byId("statistics"), Object.entries(document.statistics).map(([name, value]) => [name, numberText(value)]));
    byId("statistics").parentElement.hidden = Object.keys(document.statistics).length === 0;
    this.joints = document.robot.variables.map(() => element("td"));
    byId("joints").replaceChildren(...document.robot.variables.map((name, index) =>
      element("tr", {}, element("td", {}, name), this.joints[index])));
  }

  showTime(action, motions, held, configuration) {
    configuration.forEach((position, index) => (this.joints[index].textContent = position.toFixed(3)));
    const motion = [...new Set(motions)].join(", ") || "at rest";
    const state = `${action}|${motion}|${held}`;
    if (state === this.state) return;
    this.state = state;
    byId("now").replaceChildren(...this.describe(this.document.plan[action], motion, held));
    mark(this.plan, action);
  }

  describe(action, motion, held) {
    if (!action) return [element("p", { className: "motion" }, "There is no plan.")];
    const { values } = this;
    const bound = [...new Set(action.arguments.filter((word) => values.has(word)))];
    return [
      element("h2", {}, "Now"),
      element("p", { className: "name" }, action.name),
      element("div", { className: "chips" }, ...action.arguments.map((word) =>
        element("span", { className: values.has(word) ? "chip value" : "chip" }, word))),
      element("p", { className: "motion" }, held.length > 0 ? `${motion}, holding ${held.join(", ")}` : motion),
      element("dl", { className: "values" }, ...bound.flatMap((word) =>
        [element("dt", {}, word), element("dd", {}, valueText(values.get(word)))])),
    ];
  }

  /** -1: none. */
  showAttempt(index, leave) {
    mark(this.attempts, index);
    const attempt = this.document.attempts[index];
    const banner = byId("failure");
    banner.hidden = !attempt;
    if (!attempt) return;
    const pairs = attempt.contacts.map((pair) => pair.join(" × ")).join(", ");
    banner.replaceChildren(
      element("div", {},
        element("strong", {}, `${attempt.action}: ${attempt.reason}`),
        element("span", {}, [attempt.stream, attempt.message].filter(Boolean).join(": ")),
        element("div", { className: "pair" }, pairs),
        attempt.configuration ? "" : element("div", {}, "No configuration was found, so there is none to show.")),
      element("button", { onclick: leave, title: "Back to the plan (Esc)" }, "Close"));
  }
}
