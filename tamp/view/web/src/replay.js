// Where everything is at a time. Times between segments and knots are found by bisection.

/** Index of the last entry whose `key` is at most `time`; -1 if all are later. */
function lastAt(entries, time, key) {
  let low = 0;
  let high = entries.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (key(entries[middle]) <= time) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}

export class Replay {
  constructor(document) {
    this.document = document;
    this.duration = lastEnd([...document.plan, ...document.segments]);
    this.pieces = document.robot.variables.map(() => []);
    this.changes = new Map(document.bodies.map((body) => [body.name, [{ time: -Infinity, pose: body.pose }]]));
    for (const hold of document.held ?? []) this.changes.set(hold.body, [{ time: -Infinity, ...hold }]);
    for (const segment of document.segments) {
      if (segment.knots.length > 0)
        segment.variables.forEach((variable, column) => this.pieces[variable].push({ segment, column }));
      const change = segment.attach ?? segment.detach;
      if (change) this.changes.get(change.body).push({ time: segment.end, ...change });
    }
    for (const changes of this.changes.values()) changes.sort((a, b) => a.time - b.time);
  }

  /** One number a variable. */
  configurationAt(time) {
    return this.document.start.map((start, variable) => {
      const pieces = this.pieces[variable];
      const found = lastAt(pieces, time, (piece) => piece.segment.start);
      if (found < 0) return start;
      const { segment, column } = pieces[found];
      const knots = segment.knots;
      const knot = knots[Math.max(0, lastAt(knots, time, (k) => k.t))];
      const elapsed = Math.min(time, segment.end) - knot.t;
      return knot.q[column] + elapsed * (knot.v[column] + 0.5 * elapsed * knot.a[column]);
    });
  }

  /** By name of the body: its `pose`, and the `link` that this is in (none: in the world). */
  placesAt(time) {
    const places = new Map();
    for (const [body, changes] of this.changes)
      places.set(body, changes[lastAt(changes, Math.max(0, time), (change) => change.time)]);
    return places;
  }

  /** Index of the action that runs, or ran last; -1: there is no plan. */
  actionAt(time) {
    const found = lastAt(this.document.plan, time, (action) => action.start);
    return this.document.plan.length > 0 ? Math.max(0, found) : -1;
  }

  /** Kinds of the segments that run. */
  motionsAt(time) {
    return this.document.segments
      .filter((segment) => segment.start <= time && time < segment.end)
      .map((segment) => segment.kind);
  }
}

const lastEnd = (parts) => parts.reduce((end, part) => Math.max(end, part.end), 0);
