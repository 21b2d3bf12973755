#include "practice/experiment/report_page_parts.hpp"

#include "search/text/markup.hpp"

namespace praxis::practice {
namespace {

constexpr const char* kStyle = R"(
body{font:14px/1.45 system-ui,sans-serif;margin:1.5em;color:#1d2733;background:#fff}
h1{font-size:1.3em;margin:0 0 .2em}h2{font-size:1.1em;margin:1.6em 0 .4em}
p{margin:.3em 0}.quiet{color:#66737f}svg{max-width:100%;height:auto;display:block}
section{overflow-x:auto}table{border-collapse:collapse;margin:.6em 0}
th{text-align:left;vertical-align:bottom;font-weight:600;max-width:14em}
td,th{padding:.15em .9em .15em 0;border-bottom:1px solid #e4e9ee}
td{font-variant-numeric:tabular-nums}.figures td{white-space:nowrap;vertical-align:top}
.figures th{min-width:4em}.figures .quiet{display:block}section .title{display:none}
nav{display:flex;gap:.6em;align-items:center;margin:.6em 0}nav input{flex:1;max-width:40em}
code{font:12px ui-monospace,monospace}tr.chosen{background:#fff2cc}
#list{max-height:16em;overflow:auto}#list li{cursor:pointer}#list li.now{background:#dcebfa}
@media(prefers-color-scheme:dark){body{background:#14191f;color:#d9e1e8}.quiet{color:#93a1ad}
td,th{border-color:#2a343f}tr.chosen{background:#4a3d12}#list li.now{background:#1e3a56}}
)";

constexpr const char* kBody = R"(
<section id="choices"><h2>What was practised, and why</h2>
<noscript><p>This part of the page needs JavaScript.</p></noscript>
<p><label>run <select id="run"></select></label> <span id="left" class="quiet"></span></p>
<nav><button id="back" aria-label="cycle back">&#9664;</button>
<input id="slider" type="range" min="0" value="0" aria-label="cycle"/>
<button id="on" aria-label="cycle on">&#9654;</button><span id="where"></span></nav>
<p>first choice: <code id="chosen"></code></p>
<table><thead><tr><th>skill</th><th>score</th><th>competence now</th><th>predicted</th>
<th>expected plan cost</th><th>tries</th><th>successes</th></tr></thead><tbody id="rows"></tbody></table>
<p id="more" class="quiet"></p>
<details><summary>all cycles</summary><ol id="list"></ol></details></section>
)";

constexpr const char* kScript = R"(
'use strict';
const data = JSON.parse(document.getElementById('data').textContent);
const get = id => document.getElementById(id);
const kRandom = 'none could be reached: a random skill';
let run = null, current = 0;
function element(name, text, kind) {
  const e = document.createElement(name);
  if (text !== undefined) e.textContent = text;
  if (kind) e.className = kind;
  return e;
}
function show(index) {
  current = Math.max(0, Math.min(run.choices.length - 1, index));
  const choice = run.choices[current];
  get('slider').value = current;
  if (!choice) {
    get('where').textContent = 'no choices';
    get('chosen').textContent = get('more').textContent = '';
    get('rows').replaceChildren();
    return;
  }
  get('where').textContent = 'cycle ' + choice.cycle + ', after ' + choice.transitions.toLocaleString('en') +
      ' transitions, ' + Math.round(1000 * choice.solved) / 10 + ' % solved';
  get('chosen').textContent = choice.chosen || kRandom;
  get('rows').replaceChildren(...choice.rows.map(([skill, score, now, predicted, cost, tries, successes]) => {
    const name = run.skills[skill];
    const row = element('tr', undefined, name === choice.chosen ? 'chosen' : '');
    const cell = element('td');
    cell.append(element('code', name));
    row.append(cell, ...[score, now, predicted, cost, tries, successes].map(v => element('td', v)));
    return row;
  }));
  get('more').textContent = choice.left ? 'and ' + choice.left + ' more candidates' : '';
  [...get('list').children].forEach((e, i) => e.classList.toggle('now', i === current));
}
function open(index) {
  run = data.runs[index];
  get('slider').max = Math.max(0, run.choices.length - 1);
  get('list').replaceChildren(...run.choices.map((choice, i) => {
    const e = element('li');
    e.value = choice.cycle;
    e.append(element('code', choice.chosen || kRandom));
    e.addEventListener('click', () => show(i));
    return e;
  }));
  const cycles = run.choices.length === run.cycles ? '' : run.choices.length + ' of ' + run.cycles + ' cycles; ';
  get('left').textContent = cycles + (data.left ? data.left + ' other runs are not in this page' : '');
  show(0);
}
if (data.runs.length) {
  get('run').replaceChildren(...data.runs.map((r, i) => {
    const e = element('option', r.name);
    e.value = i;
    return e;
  }));
  get('run').addEventListener('change', () => open(Number(get('run').value)));
  get('slider').addEventListener('input', () => show(Number(get('slider').value)));
  get('back').addEventListener('click', () => show(current - 1));
  get('on').addEventListener('click', () => show(current + 1));
  document.addEventListener('keydown', event => {
    if (['slider', 'run'].includes(event.target.id)) return;
    const to = {ArrowRight: current + 1, ArrowLeft: current - 1}[event.key];
    if (to === undefined) return;
    event.preventDefault();
    show(to);
  });
  open(0);
} else {
  get('choices').hidden = true;
}
)";

}  // namespace

std::string report_page_html(const std::string& title, const std::string& summary,
                             const std::string& sections, const std::string& data) {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/><title>" +
           escape_markup(title) + "</title><style>" + kStyle + "</style></head><body>\n<h1>" +
           escape_markup(title) + "</h1>\n<p class=\"quiet\">" + escape_markup(summary) + "</p>\n" +
           sections + kBody + "<script type=\"application/json\" id=\"data\">" + data +
           "</script>\n<script>" + kScript + "</script></body></html>\n";
}

}  // namespace praxis::practice
