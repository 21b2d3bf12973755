// Small helpers for the page. Texts of the document become text nodes, never markup.

export const byId = (id) => document.getElementById(id);

/** An element with properties and children (elements or texts). */
export function element(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

export function fillTable(table, rows) {
  table.replaceChildren(...rows.map(([name, value]) =>
    element("tr", {}, element("td", {}, name), element("td", {}, value))));
}

/** At most four digits behind the point, and no zeros at the end. */
export const numberText = (number) => String(Number(number.toFixed(4)));

const tints = ["#3f7fe0", "#d9772b", "#2f9e6b", "#a95bc8", "#c94f6d", "#3aa3b5", "#8a8f2a", "#7a6fe0"];

/** A function from names to colours: the same name always gets the same one. */
export function tinter() {
  const known = new Map();
  return (name) => {
    if (!known.has(name)) known.set(name, tints[known.size % tints.length]);
    return known.get(name);
  };
}
