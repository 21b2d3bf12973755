// node bundle.js NODE_MODULES OUT.cpp: the page around a document, as a C++ source that defines
// `praxis::tamp::page_template()`.
import { createRequire } from "node:module";
import { readFileSync, writeFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const [modules, output] = process.argv.slice(2);
const source = join(dirname(fileURLToPath(import.meta.url)), "src");
const { buildSync } = createRequire(resolve(modules, "index.js"))("esbuild");

function bundle(entry) {
  const result = buildSync({
    entryPoints: [join(source, entry)],
    bundle: true,
    minify: true,
    format: "iife",
    target: "es2021",
    legalComments: "inline",
    nodePaths: [resolve(modules)],
    write: false,
  });
  return result.outputFiles[0].text.trim();
}

const page = readFileSync(join(source, "template.html"), "utf8")
  .replace("{{style}}", () => bundle("style.css"))
  .replace("{{script}}", () => bundle("main.js"));
const parts = page.split(/\{\{(?:title|document)\}\}/);
if (parts.length !== 3) throw new Error("the page must have one place for the title and one for the document");

const delimiter = "PRAXIS_PAGE";
const longestLiteral = 16000; // characters; compilers need not take more than 65536 bytes

function literals(text) {
  if (text.includes(`)${delimiter}"`)) throw new Error(`the page contains the delimiter ${delimiter}`);
  const pieces = [];
  for (let i = 0; i < text.length; ) {
    let end = Math.min(text.length, i + longestLiteral);
    if (end < text.length && /[\uD800-\uDBFF]/.test(text[end - 1])) --end;
    pieces.push(`    R"${delimiter}(${text.slice(i, end)})${delimiter}"sv,`);
    i = end;
  }
  return pieces.join("\n");
}

const names = ["kBeforeTitle", "kBeforeDocument", "kAfterDocument"];
const arrays = parts.map((text, i) => `constexpr std::string_view ${names[i]}[] = {\n${literals(text)}\n};\n`);
writeFileSync(output, `// Made by bundle.js.
#include "tamp/view/page_template.hpp"

namespace praxis::tamp {

namespace {

using namespace std::string_view_literals;

${arrays.join("\n")}
}  // namespace

const PageTemplate* page_template() {
    static constexpr PageTemplate page = {${names.join(", ")}};
    return &page;
}

}  // namespace praxis::tamp
`);
